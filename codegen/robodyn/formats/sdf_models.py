"""Which model of an SDF file is read, where it has several."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

from robodyn.formats.elements import Element
from robodyn.formats.limits import NAMES_SHOWN
from robodyn.formats.quantities import Quantities
from robodyn.formats.sdf_frames import INSIDE
from robodyn.formats.tree import names, near
from robodyn.robot.names import shown

_REMEDY: Final = "choose one with --model NAME (from Python: model=NAME)"


@dataclass(frozen=True, slots=True)
class ChosenModel:
    """A model, its name from the world, the ``<world>`` or ``<sdf>`` that it is in, and why it was chosen."""

    model: Element
    name: str
    around: Element
    remarks: tuple[str, ...] = ()


def choose_model(reader: Quantities, root: Element, name: str = "") -> ChosenModel:
    """The model of that name, which may be one in another, ``OUTER::INNER``; without a name the only one that
    there is, or else the only one that has joints that move: a floor is no arm.

    Raises
    ------
    InputError: there is none, or several of which any could be meant.
    """
    models = [
        ChosenModel(model, model.attributes.get("name", "?"), around)
        for around in (root, *root.all("world"))
        for model in around.all("model")
    ]
    if not models:
        raise reader.fail(root, "the file has no model", expected="<model>")
    if name:
        inside = [each for model in models for each in _with_models_inside(model)]
        matches = [each for each in inside if each.name == name]
        if len(matches) != 1:
            raise reader.fail(
                matches[1].model if matches else root,
                "two models have that name" if matches else "there is no model of that name",
                found=shown(name),
                expected=None if matches else near(name, (each.name for each in inside), "model"),
            )
        return matches[0]
    arms = [each for each in models if _has_joints_that_move(reader, each.model)]
    if len(models) > 1 and len(arms) != 1:
        raise reader.fail(
            models[1].model,
            "the file has several models",
            found=names((each.name for each in models), NAMES_SHOWN),
            expected="one, or one whose joints move",
            remedy=_REMEDY,
        )
    if len(models) == 1:
        return models[0]
    (arm,) = arms
    others = names((each.name for each in models if each is not arm), NAMES_SHOWN)
    remark = f"the model {shown(arm.name)} is read, the only one with joints that move; not read: {others}"
    return ChosenModel(arm.model, arm.name, arm.around, (remark,))


def _with_models_inside(chosen: ChosenModel) -> Iterator[ChosenModel]:
    yield chosen
    for model in chosen.model.all("model"):
        name = f"{chosen.name}{INSIDE}{model.attributes.get('name', '?')}"
        yield from _with_models_inside(ChosenModel(model, name, chosen.around))


def _has_joints_that_move(reader: Quantities, model: Element) -> bool:
    static = model.first("static")
    if static is not None and reader.truth(static.text, static):
        return False
    return any(each.tag == "joint" and each.attributes.get("type") != "fixed" for each in model.walk())
