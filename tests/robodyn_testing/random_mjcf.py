"""Random mechanisms as MJCF text: defaults, angles in degrees, anchors, several joints a body, shapes."""

from __future__ import annotations

import random


def _three(draw: random.Random, size: float) -> str:
    return " ".join(repr(round(draw.uniform(-size, size), 3)) for _ in range(3))


def _turn(draw: random.Random) -> str:
    return draw.choice(
        [
            "",
            f'euler="{_three(draw, 180)}"',
            'euler="90 0 -90"',
            f'axisangle="{_three(draw, 1)} 30"',
            f'quat="0.5 {_three(draw, 1)}"',
        ]
    )


def _inertial(draw: random.Random) -> str:
    a, b, c = (draw.uniform(0.02, 0.3) ** 2 for _ in range(3))
    mass = round(draw.uniform(0.1, 8), 3)
    xx, yy, zz = (mass * s / 5 for s in (b + c, a + c, a + b))
    head = f'<inertial pos="{_three(draw, 0.3)}" mass="{mass}"'
    if draw.random() < 0.5:
        return f'{head} {_turn(draw)} diaginertia="{xx!r} {yy!r} {zz!r}"/>'
    small = 0.02 * mass * min(a, b, c)
    off = " ".join(repr(draw.uniform(-small, small)) for _ in range(3))
    return f'{head} fullinertia="{xx!r} {yy!r} {zz!r} {off}"/>'


def _joint(draw: random.Random, name: str) -> str:
    kind = draw.choice(["hinge", "hinge", "slide"])
    axis = draw.choice(["0 0 1", "-1 0 0", "0 2 0", f"0.5 {' '.join(_three(draw, 1).split()[:2])}"])
    extra = draw.choice(["", 'armature="0.25"', 'class="geared"', f'pos="{_three(draw, 0.2)}"'])
    ref = draw.choice(["", 'ref="20"'])
    return f'<joint name="{name}" type="{kind}" axis="{axis}" {extra} {ref}/>'


def random_mjcf(seed: int) -> str:
    """A chain of 2 to 8 bodies with branches of one; the last body of the chain is called ``tip``."""
    draw = random.Random(seed)
    bodies = draw.randrange(2, 9)
    lines = [
        f'<mujoco model="tree{seed}"><option gravity="1 2 -9.5"/>',
        '<default><joint damping="1"/><default class="geared">',
        '<joint armature="0.5" frictionloss="2"/></default></default><worldbody>',
    ]
    for i in range(bodies):
        last = i == bodies - 1
        lines.append(f'<body name="{"tip" if last else f"b{i}"}" pos="{_three(draw, 0.4)}" {_turn(draw)}>')
        if draw.random() < 0.7:
            lines.append(_inertial(draw))
        else:
            size = " ".join(repr(abs(x) + 0.05) for x in map(float, _three(draw, 0.1).split()))
            lines.append(f'<geom type="box" size="{size}" pos="{_three(draw, 0.1)}" {_turn(draw)}/>')
        count = draw.choice([1, 1, 1, 2, 0]) if not last else 1
        lines += [_joint(draw, f"j{i}_{k}") for k in range(count)]
        if draw.random() < 0.3:
            lines.append(
                f'<body name="side{i}" pos="0.1 0 0"><joint name="s{i}" axis="0 1 0" range="-30 90" '
                f'limited="true"/>{_inertial(draw)}</body>'
            )
    lines += ["</body>" * bodies, "</worldbody><actuator>", '<motor joint="j_tip" gear="50"/>', "</actuator>"]
    return "\n".join(lines).replace("j_tip", f"j{bodies - 1}_0") + "</mujoco>"
