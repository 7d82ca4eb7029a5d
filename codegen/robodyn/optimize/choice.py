"""How the recursion of an arm is written: a formulation, and what of it is chosen to save operations."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import Any

from robodyn.dynamics.lump import MomentForm
from robodyn.errors import InputError
from robodyn.optimize.variant import Variant

#: Formulations of the inverse dynamics, from the description as it stands.
FORMULATIONS = (
    "modified_newton_euler",
    "newton_euler",
    "newton_euler_base",
    "orin",
    "balafoutis",
    "kane",
    "lagrange_3x3",
    "lagrange_4x4",
    "lagrange",
)


@dataclass(frozen=True, slots=True)
class Choice:
    """How the recursion is written: the formulation, and whether base parameters are regrouped (in the
    modified Newton-Euler recursion); then ``chains`` says whether parallel joints turn as one, and
    ``forms`` picks the form of each link's moment (empty: the forms that suit the arm), unless ``variant``
    says everything."""

    formulation: str = "modified_newton_euler"
    regroup: bool = True
    chains: bool = True
    forms: tuple[MomentForm, ...] = ()
    variant: Variant | None = None

    def to_dict(self) -> dict[str, Any]:
        """As JSON has it: what is as usual is left out."""
        data: dict[str, Any] = {}
        for field in fields(self):
            value = getattr(self, field.name)
            if value != field.default:
                data[field.name] = list(value) if field.name == "forms" else value
        if self.variant is not None:
            data["variant"] = self.variant.to_dict()
        return data

    @staticmethod
    def from_dict(data: Any) -> Choice:
        """The choice of :meth:`to_dict`; :class:`InputError` where that is none."""
        return choice_from(data)


def choice_from(data: Any) -> Choice:
    """The choice that :meth:`Choice.to_dict` wrote; :class:`InputError` where that is none."""
    allowed = {field.name: field for field in fields(Choice)}
    if not isinstance(data, Mapping) or not set(data) <= set(allowed):
        raise InputError(
            "no choice of a formulation variant", found=repr(data), expected=f"some of {', '.join(allowed)}"
        )
    settings = dict(data)
    for name in ("regroup", "chains"):
        if not isinstance(settings.get(name, True), bool):
            raise InputError(f"{name} must be true or false", found=repr(settings[name]))
    if settings.get("formulation", FORMULATIONS[0]) not in FORMULATIONS:
        raise InputError(
            "unknown formulation",
            found=repr(settings["formulation"]),
            expected=f"one of {', '.join(FORMULATIONS)}",
        )
    forms = settings.get("forms", [])
    if not isinstance(forms, list) or not set(forms) <= {"inertia", "second_moment"}:
        raise InputError("forms of moments", found=repr(forms), expected="a list of inertia, second_moment")
    settings["forms"] = tuple(forms)
    if "variant" in settings:
        settings["variant"] = Variant.from_dict(settings["variant"])
    return Choice(**settings)
