"""Table 4.4: which components of the Stanford arm's position vectors are zero."""

from __future__ import annotations

from robodyn.schedule.elimination import Sparsity, sparsity
from robodyn.thesis.printed_tasks import TABLE_4_4, TABLE_4_4_ZEROS
from robodyn.thesis.tables.table import Column, Row, Table, judged
from robodyn.thesis.tables.table_2_10 import Load, load_quietly

ROBOT = "stanford"


def table(load_robot: Load = load_quietly) -> Table:
    """Printed components beside those of the bundled robot."""
    sparse = sparsity(load_robot(ROBOT))
    rows = []
    for link, (printed, ours) in enumerate(zip(_vectors(TABLE_4_4), _vectors(sparse), strict=False), 1):
        wrong = [name for name in ("s", "p") if printed[name] != ours[name]]
        rows.append(
            Row(f"link {link}", printed, ours, judged(not wrong), _reason(link, wrong, printed, ours))
        )
    zeros, of = TABLE_4_4_ZEROS
    ours_zeros = {"zeros": sparse.zeros, "of": 6 * len(sparse.s)}
    reason = "the printed lists have as many" if TABLE_4_4.zeros == zeros else "not what the lists add up to"
    if sparse.zeros != zeros:
        reason += f"; ours has {abs(sparse.zeros - zeros)} {'more' if sparse.zeros > zeros else 'fewer'}"
        reason += ", of the rows that differ"
    same = ours_zeros == {"zeros": zeros, "of": of}
    rows.append(Row("zeros", {"zeros": zeros, "of": of}, ours_zeros, judged(same), reason))
    return Table(
        "4.4",
        "components of the Stanford arm's s and p that are not zero",
        (
            Column("printed s", "printed", "s"),
            Column("p", "printed", "p"),
            Column("zeros", "printed", "zeros"),
            Column("ours s", "ours", "s"),
            Column("p", "ours", "p"),
            Column("zeros", "ours", "zeros"),
        ),
        tuple(rows),
        (
            f"Ours: read off the bundled robot {ROBOT}; s is the centre of mass, p the origin of the next "
            "frame. p_2 holds q3, as physics has it: joint 3's displacement is in its own origin.",
        ),
    )


def _vectors(pattern: Sparsity) -> list[dict[str, list[str]]]:
    return [{"s": list(s), "p": list(p)} for s, p in zip(pattern.s, pattern.p, strict=True)]


def _reason(link: int, wrong: list[str], printed: dict[str, list[str]], ours: dict[str, list[str]]) -> str:
    if not wrong:
        return "the robot's numbers say the same"
    text = "; ".join(
        f"{name}_{link} is {' '.join(ours[name]) or 'zero'} by the robot's numbers, printed "
        f"{' '.join(printed[name]) or 'zero'}"
        for name in wrong
    )
    if (link, wrong, ours["s"]) == (5, ["s"], ["y"]):
        text += ": the thesis's own Table 2.7 has z = 0 there"
    return text
