"""What a diagnosis adds to what is claimed of a unit."""

from __future__ import annotations

from robodyn.fleet.result import Claim, UnitResult
from robodyn.fleet.units import Diagnosed, completed


def claim(joint: int, *effects: str) -> Claim:
    """A claim about ``joint``."""
    return Claim(
        effects, joint, f"feature_{joint}", "drift", 1e9, (9e8, 1.1e9), None, 1.0, 0.1, "-", 1.7, 1e-6, 1e-5
    )


def unit(*claims: Claim) -> UnitResult:
    """A unit of which so much is claimed."""
    return UnitResult("arm", "one", 9, 0.0, 1e9, claims, {}, {}, {})


def test_what_nothing_explained_is_called_what_is_new_at_its_joint() -> None:
    diagnosis = Diagnosed("units/arm/one/report.html", (("payload", None), ("backlash", 3), ("spring", 3)))
    after = completed(unit(claim(3), claim(2), claim(1, "coulomb_friction")), diagnosis)
    assert [one.effects for one in after.claims] == [("backlash",), (), ("coulomb_friction",)]
    assert after.diagnosis == diagnosis.page


def test_a_unit_without_a_diagnosis_stays_as_it_is() -> None:
    assert completed(unit(claim(3)), None) == unit(claim(3))
