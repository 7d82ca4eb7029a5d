"""The recipe "Add a target" of CONTRIBUTING.md: one file, and its kernels are run, planned and proved."""

from __future__ import annotations

import json

import pytest

from recipes.copies import Copy, source_in_recipe
from robodyn.targets import TARGETS
from robodyn_testing import require_tool

FILE = "codegen/robodyn/targets/processors/cortex_m33.py"
NAME = "cortex-m33"


@pytest.fixture(scope="module")
def copy(tmp_path_factory: pytest.TempPathFactory) -> Copy:
    assert NAME not in TARGETS
    return Copy(tmp_path_factory.mktemp("target"), {FILE: source_in_recipe("Add a target", FILE)})


def require_arm() -> None:
    for tool in ("gcc", "nm", "size"):
        require_tool(f"arm-none-eabi-{tool}")
    require_tool("qemu-system-arm")


def test_kernels_are_generated_for_it(copy: Copy) -> None:
    copy.robodyn("gen", "stanford_3dof", "--target", NAME, "-o", "kernels", "--lang", "c")
    head = (copy.work / "kernels" / "stanford_3dof.c").read_text(encoding="utf-8")
    assert f"Target: {NAME} (the bits are those of every other target)" in head
    assert "-mcpu=cortex-m33" in head


@pytest.mark.thorough
def test_its_image_runs_in_qemu_with_the_bits_of_the_others(copy: Copy) -> None:
    require_arm()
    said = copy.robodyn(
        "gen", "stanford_3dof", "--firmware", "--target", f"cortex-m4f,{NAME}", "-o", "out", "--json"
    )
    found = json.loads(said[said.index("{") :])["firmware"]
    (known,), (own,) = (figures["costs"] for figures in found)
    assert [figures["target"] for figures in found] == ["cortex-m4f", NAME]
    assert own["digest"] == known["digest"]
    # The same instruction set but for a few: counted by another clock, and yet as many.
    assert own["instructions"] == pytest.approx(known["instructions"], rel=0.1)
    assert own["stack"] >= own["stack_used"] > 0
    assert "ORIGIN = 0x38000000" in (copy.work / "out" / "firmware" / f"{NAME}.ld").read_text()


def test_it_is_planned_for(copy: Copy) -> None:
    said = copy.robodyn("plan", "stanford_3dof", "--deadline", "1ms", "--json")
    plans = {plan["target"]: plan for plan in json.loads(said[said.index("{") :])["plans"]}
    slower = 168 / 160  # the Cortex-M4F's clock over its own, at the same cycles
    assert plans[NAME]["time_ns"] == pytest.approx(slower * plans["cortex-m4f"]["time_ns"])


def test_objectives_and_hints_know_it(copy: Copy) -> None:
    copy.robodyn("flops", "stanford_3dof", "--objective", f"weighted:{NAME}")
    assert NAME in copy.robodyn("gen", "puma560", "--target", "cortex-m34", code=2)


@pytest.mark.thorough
def test_the_stack_is_proved_for_it(copy: Copy) -> None:
    require_tool("gcc")
    require_tool("arm-none-eabi-gcc")
    copy.robodyn("prove", "stanford_3dof", "--only", "stack", "-o", "proof")
    (proof,) = json.loads((copy.work / "proof" / "proof.json").read_text(encoding="utf-8"))["proofs"]
    rows = {row["machine"].partition(",")[0]: row for row in proof["stack"]}
    assert 0 < rows[NAME]["bytes"] < 200, rows[NAME]["reason"]
