"""Files by somebody who means harm, or by nobody: one line, exit code 2, nothing written, bounded memory."""

from __future__ import annotations

import random
import resource
import subprocess
import sys
from pathlib import Path

import pytest

from robodyn.errors import InputError
from robodyn.formats.arm import import_arm
from robodyn_cli.main import main
from robodyn_testing import commit_seeds, representative, require_module, seed_counts
from robodyn_testing.random_mjcf import random_mjcf
from robodyn_testing.random_trees import random_urdf
from robodyn_testing.urdf_text import joint, link, robot

PAIR = robot(link("a"), link("b"), joint("j", "a", "b"))
BOMB = (
    '<!DOCTYPE robot [<!ENTITY a "aaaaaaaaaa">'
    + "".join(f'<!ENTITY {chr(98 + i)} "{f"&{chr(97 + i)};" * 10}">' for i in range(9))
    + "]>"
)


def deep(tag: str, levels: int) -> str:
    return f"<{tag}>" * levels + f"</{tag}>" * levels


def changed(old: str, new: str) -> str:
    """The pair of links with one thing changed."""
    assert old in PAIR
    return PAIR.replace(old, new)


_LINE = [joint(f"j{i}", f"l{i}", f"l{i + 1}") for i in range(499)]
CASES: dict[str, tuple[bytes | str, str]] = {
    "entities": (BOMB + changed('"arm"', '"&j;"'), "the file has a document type"),
    "deep": (f"<robot>{deep('link', 100_000)}</robot>", "the elements are nested too deeply"),
    "many elements": ("<robot>" + "<link/>" * 110_000 + "</robot>", "the file has too many elements"),
    "many attributes": (
        f"<robot {' '.join(f'a{i}=%%' for i in range(999))}/>".replace("%", '"'),
        "too many attr",
    ),
    "large": (b"<robot>" + b" " * (17 << 20) + b"</robot>", "the file is too large; found more than 16 MiB"),
    "empty": ("", "the file is empty"),
    "binary": (bytes(range(256)) * 10, "the file is not UTF-8 text; found byte 0x80"),
    "comments": ("<robot>" + "<!--" * 400_000, "1:16: the file is not XML; found not well-formed"),
    "elf": (b"\x7fELF\x02\x01\x01\0", "1:1: the file is not XML"),
    "long number": (changed('value="1"', f'value="{"1" * 100_000}"'), "is too large; found '1111"),
    "long name": (changed('"j"', f'"{"j" * 100_000}"'), "has 100000 characters, 200 are allowed"),
    "many links": (robot(*(f'<link name="l{i}"/>' for i in range(6000))), "too many links or joints"),
    "long chain": (robot(*(link(f"l{i}") for i in range(500)), *_LINE), "found 499 moving joints"),
}


def contents(case: str) -> bytes:
    data, _ = CASES[case]
    return data.encode() if isinstance(data, str) else data


@pytest.mark.parametrize("case", CASES)
def test_what_is_no_arm_is_one_line(
    case: str, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    _, words = CASES[case]
    monkeypatch.chdir(tmp_path)
    Path("arm.urdf").write_bytes(contents(case))
    for command in (["import", "arm.urdf", "-o", "arm.yaml"], ["gen", "arm.urdf", "-o", "out"]):
        assert main(command) == 2
        out, err = capsys.readouterr()
        assert out == ""
        assert len(err.splitlines()) == 1
        assert len(err) < 1000
        assert err.startswith("robodyn: error: arm.urdf:")
        assert words in err
        assert err.rstrip("\n").isprintable()
    assert [path.name for path in tmp_path.iterdir()] == ["arm.urdf"]


@pytest.mark.parametrize("case", representative(("entities", "deep", "many elements", "large"), "entities"))
def test_memory_is_bounded(case: str, tmp_path: Path) -> None:
    """In a process that may have 400 MB in all; 100 MB of a file are never read."""
    path = tmp_path / "arm.urdf"
    path.write_bytes(contents(case))
    if case == "large":
        with path.open("ab") as file:
            file.truncate(100 << 20)

    def bound() -> None:
        resource.setrlimit(resource.RLIMIT_AS, (400 << 20, 400 << 20))

    done = subprocess.run(
        [sys.executable, "-m", "robodyn", "import", str(path)],
        preexec_fn=bound, capture_output=True, text=True, check=False, timeout=60,
    )  # fmt: skip
    assert done.returncode == 2, done.stderr
    assert len(done.stderr.splitlines()) == 1


def mutated(text: str, draw: random.Random) -> bytes:
    """``text`` with a few bytes, words or lines changed, doubled or gone."""
    data = bytearray(text.encode())
    for _ in range(draw.randrange(1, 5)):
        at, kind = draw.randrange(len(data)), draw.randrange(4)
        if kind == 0:
            data[at] = draw.randrange(256)
        elif kind == 1:
            del data[at : at + draw.randrange(1, 60)]
        elif kind == 2:
            data[at:at] = data[at : at + draw.randrange(1, 200)]
        else:
            data[at:at] = draw.choice(
                [b"-", b"1e9", b"nan", b"<", b'"', b"/>", b"0", b"9" * 30, b"<link/>", b"&#0;"]
            )
    return bytes(data)


@pytest.mark.parametrize("count", seed_counts(20, 600))
def test_broken_files_are_refused_or_read(count: int, tmp_path: Path) -> None:
    """Whatever is wrong with a file: an error of ours, or an arm."""
    for seed in commit_seeds(count):
        check_broken(seed, tmp_path)


def check_broken(seed: int, tmp_path: Path) -> None:
    mjcf = seed % 4 == 0
    if mjcf:
        require_module("mujoco")
    path = tmp_path / ("arm.xml" if mjcf else "arm.urdf")
    path.write_bytes(mutated(random_mjcf(seed) if mjcf else random_urdf(seed), random.Random(seed)))
    refusal = ""
    try:
        import_arm(path)
    except InputError as error:
        refusal = str(error)
    assert "\n" not in refusal
    assert [file.name for file in tmp_path.iterdir()] == [path.name]
    path.unlink()
