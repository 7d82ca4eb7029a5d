"""Table 2.6: inertias of the PUMA 560, beside what program D.2's tensors make of them."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import Final

from robodyn.thesis.printed_parameters import D_2, D_2_LAST_DIGIT, PUMA, PrintedLink
from robodyn.thesis.tables.table import Column, Row, Table, judged

_NAMES: Final = ("Ixx", "Iyy", "Izz")


def table() -> Table:
    """A row for each printed figure, and one for the tensor that no body has."""
    rows = [row for k in range(len(PUMA)) for row in _link(k)]
    return Table(
        "2.6",
        "moments and rotor inertias of the PUMA 560 [kg m^2]",
        (Column("printed", "printed", "value"), Column("ours", "ours", "value")),
        (*rows, *_triangles()),
        (
            "Ours: the tensors that program D.2 has about the links' origins, less what the offsets of Table "
            "2.5 add (m (y^2 + z^2) and so on) and less the rotor in Izz; they are printed to four decimals, "
            "and so far the two can agree. Of a rotor ours is Izz of D.2 less the printed moment, of links 5 "
            "and 6 a tenth of it.",
        ),
    )


def _link(k: int) -> Iterator[Row]:
    link, tensor = PUMA[k], D_2[k]
    shifts = _shifts(link)
    for axis, name in enumerate(_NAMES):
        moment, whole = link.moments[axis], tensor[axis]
        if moment is not None and whole is not None:
            yield _row(k, name, moment, whole - shifts[axis] - (link.motor if axis == 2 else 0), whole)
    izz, whole = link.moments[2], tensor[2]
    if izz is not None and whole is not None:
        moment = izz / 10 if _tenfold(k) else izz
        yield _row(k, "rotor", link.motor, whole - shifts[2] - moment, whole)


def _tenfold(k: int) -> bool:
    """Whether program D.2 has a tenth of the link's printed Iyy."""
    moment, whole = PUMA[k].moments[1], D_2[k][1]
    if moment is None or whole is None:
        return False
    return abs(whole - _shifts(PUMA[k])[1] - moment / 10) <= D_2_LAST_DIGIT / 2


def _shifts(link: PrintedLink) -> tuple[Fraction, Fraction, Fraction]:
    x, y, z = (u * u for u in link.com)
    return link.mass * (y + z), link.mass * (x + z), link.mass * (x + y)


def _row(k: int, name: str, printed: Fraction, ours: Fraction, whole: Fraction) -> Row:
    same = abs(ours - printed) <= D_2_LAST_DIGIT / 2
    reason = "program D.2 has it, moved to the link's origin"
    if not same:
        reason = "program D.2 has another one"
        if abs(ours - printed / 10) <= D_2_LAST_DIGIT / 2:
            reason = "ten times what program D.2 has"
        elif whole == printed:
            reason = "program D.2 has the printed one about the link's origin: it was not moved there"
    return Row(
        f"link {k + 1}, {name}", {"value": _plain(printed)}, {"value": _plain(round(ours, 6))}, judged(same),
        reason,
    )  # fmt: skip


def _triangles() -> Iterator[Row]:
    for k, link in enumerate(PUMA, 1):
        if None in link.moments:
            continue
        xx, yy, zz = (moment for moment in link.moments if moment is not None)
        spare = min(xx + yy - zz, yy + zz - xx, xx + zz - yy)
        allowed = spare >= 0
        yield Row(
            f"link {k}, triangle",
            {"value": f"{_plain(xx)} {_plain(yy)} {_plain(zz)}"},
            {"value": _plain(spare)},
            judged(allowed),
            "the least of the sums of two moments less the third, which no body has below 0"
            + ("" if allowed else ": these moments are no body's"),
        )


def _plain(x: Fraction) -> float:
    return float(x)
