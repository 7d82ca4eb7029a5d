"""Friction as tasks of three operations: what a joint adds to its 43, and what each of them computes.

Friction comes after the dynamics: it needs force and moment at the joint, and gives nothing back to other
links. So its tasks follow the last ones of their own link, and no link waits for them. Tasks 44 to 49 are the
joint's friction, the last of them its torque with friction; 50 to 53 are the transmission.

Cut by us, as Table 4.1 is cut: three multiplications and additions a task at most, what depends on the model
alone formed beforehand (``h = d/2``, ``k = mu r/d``), square roots, absolute values, signs and the choice
between driving and braking free, a division by the efficiency counted as one operation. A revolute joint in
two journals with a transmission whose efficiency is a straight line has eight tasks, as many as the thesis's
24 operations fill.

Source: Dhanaraj 1990, chapter 3 (Eqs 3.3 to 3.6, Table 3.2) and section 4.5.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, Final, Literal

from robodyn.dynamics.vectors import Vector
from robodyn.effects.scalars import magnitude, root
from robodyn.robot.model import EffectEntry, Robot
from robodyn.schedule.tasks import Place, Task

Bearing = Literal["journal", "linear", "thrust", "radial", "torque"]
Efficiency = Literal["constant", "linear", "cubic"]


@dataclass(frozen=True, slots=True)
class Friction:
    """What of friction a joint has: the kind of its bearing, and how its transmission's efficiency depends on
    the load; None where it has none."""

    bearing: Bearing | None = None
    transmission: Efficiency | None = None

    @property
    def loaded(self) -> bool:
        """Whether it needs the force through the joint, not only the torque."""
        return self.bearing not in (None, "torque")


@dataclass(slots=True)
class Site:
    """Where friction tasks work: force ``f`` [N] and moment ``n`` [N m] through the joint, its ``torque``
    (``n_z``, or ``f_z``), the ``direction`` of motion, the model's ``constants``, and what is computed, by
    name; ``out`` is the torque with what has been added to it."""

    f: Vector
    n: Vector
    torque: Any
    direction: Any
    drives: bool
    constants: Mapping[str, Any]
    values: dict[str, Any] = field(default_factory=dict)

    @property
    def joint_torque(self) -> Any:
        """The joint's torque, with its friction if it has any."""
        return self.values.get("total", self.torque)


Step = Callable[[Site], None]


def _scaled(at: Site) -> None:
    h, v = at.constants["h"], at.values
    v["hx"], v["hy"], v["k"] = h * at.f[0], h * at.f[1], at.constants["k"] * at.direction


def _three_sums(at: Site) -> None:
    v = at.values
    v["a1"], v["a2"], v["b1"] = v["hx"] + at.n[1], v["hx"] - at.n[1], v["hy"] - at.n[0]


def _fourth_sum(at: Site) -> None:
    at.values["b2"] = at.values["hy"] + at.n[0]


def _square(a: str, b: str, into: str) -> Step:
    def step(at: Site) -> None:
        v = at.values
        v[into] = v[a] * v[a] + v[b] * v[b]

    return step


def _journals(at: Site) -> None:
    v = at.values
    v["total"] = at.torque + v["k"] * (root(v["one"]) + root(v["other"]))


def _slides(at: Site) -> None:
    v = at.values
    v["pressed"] = magnitude(v["a1"]) + magnitude(v["a2"]) + magnitude(v["b1"]) + magnitude(v["b2"])


def _sliding(at: Site) -> None:
    at.values["total"] = at.torque + at.values["k"] * at.values["pressed"]


def _radial_load(at: Site) -> None:
    at.values["one"] = at.f[0] * at.f[0] + at.f[1] * at.f[1]


def _pressed_by(load: Callable[[Site], Any]) -> Step:
    def step(at: Site) -> None:
        at.values["total"] = at.torque + at.constants["k"] * at.direction * load(at)

    return step


def _breakaway(at: Site) -> Any:
    return at.constants["breakaway"] * at.direction


def _straight(at: Site) -> None:
    e, x = at.constants["e"], magnitude(at.joint_torque)
    at.values["efficiency"], at.values["breakaway"] = e[0] + e[1] * x, _breakaway(at)


def _cubic_top(at: Site) -> None:
    e, x = at.constants["e"], magnitude(at.joint_torque)
    at.values["square"], at.values["top"] = x * x, e[2] + e[3] * x


def _cubic_bottom(at: Site) -> None:
    e, x = at.constants["e"], magnitude(at.joint_torque)
    at.values["bottom"], at.values["breakaway"] = e[0] + e[1] * x, _breakaway(at)


def _cubic(at: Site) -> None:
    v = at.values
    v["efficiency"] = v["bottom"] + v["square"] * v["top"]


def _passed(at: Site) -> None:
    efficiency = at.values["efficiency"]
    through = at.joint_torque / efficiency if at.drives else at.joint_torque * efficiency
    at.values["out"] = through + at.values["breakaway"]


def _passed_constant(at: Site) -> None:
    share = at.constants["inverse"] if at.drives else at.constants["efficiency"]
    at.values["out"] = share * at.joint_torque + _breakaway(at)


#: A task of friction: its number, layer, words, the numbers that it waits for (0: the joint's torque), and
#: what it does.
_Cut = tuple[int, int, str, tuple[int, ...], Step]

_BEARINGS: Final[dict[Bearing, tuple[_Cut, ...]]] = {
    "journal": (
        (44, 3, "h f_x, h f_y, k sgn qd", (32,), _scaled),
        (45, 4, "h f_x + n_y, h f_x - n_y, h f_y - n_x", (41, 42, 44), _three_sums),
        (46, 4, "h f_y + n_x", (41, 44), _fourth_sum),
        (47, 5, "square of the load of one journal", (45,), _square("a1", "b1", "one")),
        (48, 5, "square of the load of the other", (45, 46), _square("a2", "b2", "other")),
        (49, 6, "torque + k (sum of the roots)", (0, 44, 47, 48), _journals),
    ),
    "linear": (
        (44, 3, "h f_x, h f_y, k sgn qd", (32,), _scaled),
        (45, 4, "h f_x + n_y, h f_x - n_y, h f_y - n_x", (41, 42, 44), _three_sums),
        (46, 4, "h f_y + n_x", (41, 44), _fourth_sum),
        (47, 5, "sum of the four loads", (45, 46), _slides),
        (49, 6, "force + k (sum of the loads)", (0, 44, 47), _sliding),
    ),
    "thrust": ((49, 4, "torque + k sgn qd |f_z|", (0, 32), _pressed_by(lambda at: magnitude(at.f[2]))),),
    "radial": (
        (44, 3, "f_x^2 + f_y^2", (32,), _radial_load),
        (49, 4, "torque + k sgn qd (its root)", (0, 44), _pressed_by(lambda at: root(at.values["one"]))),
    ),
    "torque": ((49, 4, "torque + k sgn qd |torque|", (0,), _pressed_by(lambda at: magnitude(at.torque))),),
}  # fmt: skip

#: Layers are counted from that of the joint's torque.
_TRANSMISSIONS: Final[dict[Efficiency, tuple[_Cut, ...]]] = {
    "constant": ((53, 1, "torque/eta or torque eta, + breakaway sgn qd", (0,), _passed_constant),),
    "linear": (
        (50, 1, "eta = e_0 + e_1 |torque|, breakaway sgn qd", (0,), _straight),
        (53, 2, "torque/eta or torque eta, + breakaway sgn qd", (0, 50), _passed),
    ),
    "cubic": (
        (50, 1, "|torque|^2, e_2 + e_3 |torque|", (0,), _cubic_top),
        (51, 1, "e_0 + e_1 |torque|, breakaway sgn qd", (0,), _cubic_bottom),
        (52, 2, "eta, their sum", (50, 51), _cubic),
        (53, 3, "torque/eta or torque eta, + breakaway sgn qd", (0, 51, 52), _passed),
    ),
}  # fmt: skip

#: The tasks that give the torque of a revolute joint and the force of a prismatic one.
_TORQUE, _FORCE, _WITH_FRICTION = 43, 32, 49


def _cuts(friction: Friction) -> list[tuple[_Cut, bool]]:
    """The cuts of a joint, and whether each is of the transmission."""
    bearing = () if friction.bearing is None else _BEARINGS[friction.bearing]
    gear = () if friction.transmission is None else _TRANSMISSIONS[friction.transmission]
    return [*((cut, False) for cut in bearing), *((cut, True) for cut in gear)]


def friction_tasks(friction: Friction, *, revolute: bool = True) -> tuple[Task, ...]:
    """The tasks of a joint's friction, numbered on from Table 4.1."""
    own = _TORQUE if revolute else _FORCE
    last = 3 if revolute else 2
    if friction.bearing is not None:
        last = _BEARINGS[friction.bearing][-1][1]
    tasks = []
    for (row, layer, does, waits, _), of_gear in _cuts(friction):
        torque = _WITH_FRICTION if of_gear and friction.bearing is not None else own
        here: Place = 0
        after = tuple((here, torque if other == 0 else other) for other in waits)
        step = "transmission" if of_gear else "friction"
        tasks.append(Task(row, step, False, layer + last if of_gear else layer, does, after))
    return tuple(tasks)


def run_friction(friction: Friction, at: Site, order: tuple[int, ...] | None = None) -> Any:
    """The tasks of ``friction`` carried out at ``at``, one after another or in another ``order`` of their
    numbers; the torque or force that the drive must give [N m or N]."""
    steps = {row: step for (row, _, _, _, step), _ in _cuts(friction)}
    for row in order or tuple(steps):
        steps[row](at)
    return at.values["out"] if friction.transmission is not None else at.joint_torque


def is_friction(entry: EffectEntry) -> bool:
    """Whether an effect is friction under load, which there are tasks of."""
    return (
        entry.joint is not None
        and entry.definition.needs_load
        and entry.definition.place in ("bearing", "gear")
    )


def friction_of(robot: Robot) -> dict[int, Friction]:
    """What of friction under load the joints of ``robot`` have, by joint from 1; friction by speed alone is
    not among it."""
    by_joint: dict[int, Friction] = {}
    for entry in filter(is_friction, robot.effects):
        assert entry.joint is not None
        known = by_joint.get(entry.joint, Friction())
        if entry.definition.place == "bearing":
            kind: Bearing = (
                "radial" if entry["bearing"] == "journal" and "span" not in entry else entry["bearing"]
            )
            by_joint[entry.joint] = Friction(kind, known.transmission)
        else:
            curve = entry["efficiency"]
            how: Efficiency = entry["interpolation"] if isinstance(curve, tuple) else "constant"
            by_joint[entry.joint] = Friction(known.bearing, how)
    return by_joint


#: What can be asked of any arm: nothing, journals or sliding bearings in all joints, transmissions whose
#: efficiency is a straight line, both.
Choice = Literal["none", "joint", "transmission", "both"]


def chosen_friction(choice: Choice, *, revolute: bool = True) -> Friction | None:
    """The friction of a joint where ``choice`` is to be in all of them; None where that is nothing."""
    if choice == "none":
        return None
    bearing: Bearing = "journal" if revolute else "linear"
    return Friction(
        bearing if choice in ("joint", "both") else None,
        "linear" if choice in ("transmission", "both") else None,
    )
