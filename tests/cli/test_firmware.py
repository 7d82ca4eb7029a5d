"""``robodyn gen --firmware``: where the folder goes, what is said, what is refused."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from robodyn_cli.main import main
from robodyn_testing import require_tool

Capture = pytest.CaptureFixture[str]


@pytest.fixture(autouse=True)
def elsewhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


def gen(capsys: Capture, *arguments: str, code: int = 0) -> tuple[str, str]:
    """What is said on both streams."""
    assert main(["gen", "stanford_3dof", *arguments]) == code
    out, err = capsys.readouterr()
    assert "Traceback" not in err
    return out, err


def test_writes_a_folder_that_is_held_against_what_would_be_written(capsys: Capture, elsewhere: Path) -> None:
    for tool in ("arm-none-eabi-gcc", "qemu-system-arm"):
        require_tool(tool)
    out, _ = gen(capsys, "--firmware", "--target", "cortex-m4f")
    folder = elsewhere / "generated" / "stanford_3dof" / "firmware"
    assert out.startswith("stanford_3dof: wrote 16 files in generated/stanford_3dof/firmware\ncortex-m4f: ")
    assert "instructions a call, self-test passed in qemu" in out
    assert len(list(folder.iterdir())) == 16
    assert [path.name for path in folder.parent.iterdir()] == ["firmware"]
    assert "typedef float stanford_3dof_real;" in (folder / "stanford_3dof.h").read_text(encoding="utf-8")
    assert gen(capsys, "--firmware", "--target", "cortex-m4f", "--check")[0].endswith("are up to date\n")
    (folder / "README.md").write_text("mine", encoding="utf-8")
    gen(capsys, "--firmware", "--target", "cortex-m4f", "--check")
    (folder / "stanford_3dof_startup.c").unlink()
    _, err = gen(capsys, "--firmware", "--target", "cortex-m4f", "--check", code=1)
    assert "firmware/stanford_3dof_startup.c: not up to date" in err


def test_the_readme_shows_the_title_as_it_stands(
    capsys: Capture, elsewhere: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PATH", "")
    (elsewhere / "arm.yaml").write_text(
        "name: main\ntitle: '# Proven | `x` <b>[y](z)</b> *'\nlinks: [{joint: revolute, inertia: {zz: 1}}]\n",
        encoding="utf-8",
    )
    assert main(["gen", "arm.yaml", "--firmware", "--lang", "c"]) == 0
    folder = elsewhere / "generated" / "main" / "firmware"
    assert f"wrote {len(list(folder.iterdir()))} files in " in capsys.readouterr().out
    text = (folder / "README.md").read_text(encoding="utf-8")
    assert "of \\# Proven \\| \\`x\\` &lt;b&gt;\\[y\\](z)&lt;/b&gt; \\*, in float" in text
    assert "main_inverse_dynamics(" in (folder / "main.c").read_text(encoding="utf-8")


def test_without_tools_it_says_what_was_not_measured(
    capsys: Capture, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PATH", "")
    out, err = gen(capsys, "--firmware", "--json", "-o", "there", "--scalar", "double", "--lang", "c")
    said = json.loads(out)
    assert "there/firmware/README.md" in said["files"]
    assert not [file for file in said["files"] if file.endswith(".f90")]
    missing = {found["target"]: found["missing"].partition(" ")[0] for found in said["firmware"]}
    arm = dict.fromkeys(("cortex-m3", "cortex-m4f", "cortex-m7"), "arm-none-eabi-gcc")
    assert missing == {**arm, "rv32imafc": "riscv64-unknown-elf-gcc"}
    assert "note: not everything was measured: needs arm-none-eabi-gcc" in err
    assert "double" in Path("there/firmware/stanford_3dof.h").read_text(encoding="utf-8")
