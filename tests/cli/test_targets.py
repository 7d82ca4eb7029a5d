"""``robodyn gen --target``: what it chooses, what goes before it, where it is said."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from robodyn.errors import InputError
from robodyn.kernels.generate import Options
from robodyn.targets import TARGETS, compiled_targets
from robodyn_cli.main import main
from robodyn_testing import sampled

Capture = pytest.CaptureFixture[str]


def gen(capsys: Capture, folder: Path, *arguments: str) -> dict[str, Any]:
    assert main(["gen", "stanford_3dof", "-o", str(folder), "--json", *arguments]) == 0
    found: dict[str, Any] = json.loads(capsys.readouterr().out)
    return found


@pytest.mark.parametrize("name", sampled([target.name for target in compiled_targets()], every=3))
def test_a_target_chooses(name: str, tmp_path: Path, capsys: Capture) -> None:
    target = TARGETS[name]
    found = gen(capsys, tmp_path, "--target", name)
    for what in ("scalar", "trig", "order", "contraction", "objective"):
        assert found[what] == getattr(target, what)
    assert found["target"] == name
    source = (tmp_path / "stanford_3dof.c").read_text()
    head = " ".join(source.partition("*/")[0].replace("\n *", " ").split())
    assert f"Target: {name}" in head
    assert found["flags"] in head
    assert f"#pragma STDC FP_CONTRACT {target.contraction.upper()}" in source
    assert f"typedef {target.scalar} " in (tmp_path / "stanford_3dof.h").read_text()
    assert "math.h" not in source
    arguments = ["gen", "stanford_3dof", "-o", str(tmp_path), "--check", "--target", name]
    assert main(arguments) == 0
    assert main([*arguments, "--trig", "libm"]) == 1


def test_own_options_go_before_a_target(tmp_path: Path, capsys: Capture) -> None:
    chosen = {
        "scalar": "double", "trig": "libm", "order": "recursion", "contraction": "on", "objective": "total",
    }  # fmt: skip
    options = [text for what, value in chosen.items() for text in (f"--{what}", value)]
    found = gen(capsys, tmp_path, "--target", "cortex-m4f", *options)
    assert {what: found[what] for what in chosen} == chosen
    assert "-ffp-contract=fast" in found["flags"]


def test_no_target_chooses_nothing(tmp_path: Path, capsys: Capture) -> None:
    found = gen(capsys, tmp_path)
    assert found["target"] is None
    assert found["flags"] is None
    assert found["contraction"] is None


def test_the_older_name_of_a_target_is_the_same_target(tmp_path: Path, capsys: Capture) -> None:
    assert gen(capsys, tmp_path, "--target", "cortex-m4") == gen(capsys, tmp_path, "--target", "cortex-m4f")
    assert gen(capsys, tmp_path, "--objective", "weighted:cortex-m4")["objective"] == "weighted:cortex-m4f"
    assert main(["plan", "puma560_3dof", "--deadline", "1s", "--target", "cortex-m4", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["chosen"]["target"] == "cortex-m4f"


def test_the_library_does_as_the_command() -> None:
    options = Options.for_target("cortex-m7", scalar="float")
    assert (options.scalar, options.trig, options.objective) == ("float", "builtin", "weighted:cortex-m7")
    with pytest.raises(InputError, match="unknown target"):
        Options.for_target("pdp-11")


def test_verify_takes_built_in_sines() -> None:
    assert main(["verify", "stanford_3dof", "--states", "20", "--scalar", "float", "--trig", "builtin"]) == 0
