"""A reliability diagram as SVG: how many names are right, beside how sure they are said to be."""

from __future__ import annotations

import math
from collections.abc import Sequence

from benchmarks.gap.blind.grade import WIDE

_SIDE, _MARGIN = 360, 56
_HEAD = """\
<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {size} {size}" font-family="sans-serif" font-size="12">
<title>Share of names that are right, by the confidence that was said; bars: 95 % intervals</title>
<rect width="{size}" height="{size}" fill="white"/>
<g fill="none" stroke="#888"><path d="M{left} {top}V{bottom}H{right}"/>\
<path d="M{left} {bottom}L{right} {top}" stroke-dasharray="4 4"/></g>
<g text-anchor="middle" fill="#333"><text x="{middle}" y="{foot}">confidence that was said</text>
<text transform="translate(14 {middle}) rotate(-90)">share that is right</text></g>
"""


def diagram(steps: Sequence[Sequence[float]]) -> str:
    """The picture of :func:`~benchmarks.gap.blind.summary.reliability`: a point a step with its 95 % interval
    (Wilson 1927) and the number of names."""
    right, bottom = _MARGIN + _SIDE, _MARGIN + _SIDE
    text = [
        _HEAD.format(
            size=_SIDE + 2 * _MARGIN, left=_MARGIN, top=_MARGIN, right=right, bottom=bottom,
            middle=_MARGIN + _SIDE // 2, foot=bottom + 40,
        )
    ]  # fmt: skip
    for k in range(0, 11, 2):
        at = f"{_x(k / 10):.0f}", f"{_y(k / 10):.0f}"
        text.append(
            f'<text x="{at[0]}" y="{bottom + 18}" text-anchor="middle" fill="#333">{10 * k} %</text>'
            f'<text x="{_MARGIN - 6}" y="{at[1]}" dy="4" text-anchor="end" fill="#333">{10 * k} %</text>\n'
        )
    for _, _, count, said, hits in steps:
        low, high = wilson(int(hits), int(count))
        x, y = _x(said), _y(hits / count)
        text.append(
            f'<path d="M{x:.1f} {_y(low):.1f}V{_y(high):.1f}" stroke="#1f5fa8" stroke-width="2"/>'
            f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4" fill="#1f5fa8"/>'
            f'<text x="{x - 8:.1f}" y="{y:.1f}" text-anchor="end" fill="#1f5fa8">{count:.0f}</text>\n'
        )
    return "".join([*text, "</svg>\n"])


def wilson(hits: int, count: int) -> tuple[float, float]:
    """The 95 % interval of a share of which ``hits`` of ``count`` were seen (Wilson 1927)."""
    share, z2 = hits / count, WIDE**2 / count
    middle = (share + z2 / 2) / (1 + z2)
    half = WIDE * math.sqrt(share * (1 - share) / count + z2 / count / 4) / (1 + z2)
    return middle - half, middle + half


def _x(share: float) -> float:
    return _MARGIN + _SIDE * share


def _y(share: float) -> float:
    return _MARGIN + _SIDE * (1 - share)
