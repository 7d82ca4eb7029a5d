"""``robodyn hide --score``: what a diagnosis, or an answer about a fleet, says beside what is hidden."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from robodyn_cli.common import echo_json, printable, talk

if TYPE_CHECKING:
    from robodyn.diagnose.blind.json_part import Part
    from robodyn.diagnose.blind.seal import Score
    from robodyn.fleet.planted.score import FleetScore

_ANSWER, _DIAGNOSED, _FLEET = "answer.sealed", "diagnosis.json", "fleet.json"
_SEALED, _RESULT = 1 << 24, 1 << 28  # bytes of an answer, of a diagnosis or an answer about a fleet, at most
#: Cases of a score that are printed one by one.
_SHOWN = 20


def _sealed(path: Path) -> Path:
    """The sealed answer at ``path``, which is the file or the folder of the test."""
    return path / _ANSWER if path.is_dir() else path


def _answer(path: Path) -> Part:
    from robodyn.diagnose.blind.seal import unsealed
    from robodyn.files import label, read_text

    path = _sealed(path)
    return unsealed(read_text(path, _SEALED, "the answer.sealed of robodyn hide"), label(path))


def opened(path: Path) -> dict[str, Any]:
    """The answer sealed at ``path``.

    Raises
    ------
    InputError: there is none.
    """
    from robodyn.diagnose.blind.seal import checked
    from robodyn.fleet.planted.score import is_fleet

    answer = _answer(path)
    return answer.object() if is_fleet(answer) else checked(answer)


def _read_json(file: Path, expected: str) -> Any:
    from robodyn.errors import InputError, Place
    from robodyn.files import label, parsed_json, read_text

    try:
        return parsed_json(read_text(file, _RESULT, expected))
    except ValueError as error:
        raise InputError(
            "this is not JSON", where=Place(label(file)), found=str(error), expected=expected
        ) from None


def scored(folder: Path, file: Path, *, as_json: bool) -> None:
    """Print how the result in ``file`` did at the test in ``folder``; exit with 1 if it is wrong, or missed
    what is hidden.

    Raises
    ------
    InputError: one of the two cannot be read.
    """
    from robodyn.diagnose.blind.seal import checked, score
    from robodyn.errors import InputError
    from robodyn.files import label
    from robodyn.fleet.planted.score import is_fleet

    if folder.suffix == ".json" and folder.is_file():
        raise InputError(
            "the first argument of --score is the folder of the test",
            found=printable(folder),
            remedy="swap the two arguments",
        )
    answer = _answer(folder)
    if is_fleet(answer):
        _fleet_scored(answer, file, as_json=as_json)
        return
    file = file / _DIAGNOSED if file.is_dir() else file
    diagnosis = _read_json(file, "the diagnosis.json of robodyn diagnose")
    result = score(checked(answer), diagnosis, label(file))
    if not result.same:
        talk("robodyn: warning: the diagnosis was made from other logs than those of this test")
    if as_json:
        echo_json(result.to_dict())
    else:
        for line in _lines(result, folder):
            click.echo(line)
    if result.result in ("wrong", "missed"):
        raise click.exceptions.Exit(1)


def _lines(score: Score, folder: Path) -> list[str]:
    lines = []
    for claim in score.claims:
        lines.append(f"{claim.name}: {claim.status}")
        for name, true in (claim.truth or {}).items():
            estimate = claim.parameters.get(name) or {}
            if isinstance(estimate.get("value"), (int, float)) and isinstance(true, (int, float)):
                band = f" +- {estimate['stderr']:.2g}" if estimate["stderr"] is not None else ""
                lines.append(
                    f"  {name}: {estimate['value']:.4g}{band} {estimate['unit']}, true value {true:.4g}"
                )
    if score.missed:
        lines.append(
            f"{score.missed} of {score.hidden} hidden missed "
            f"(robodyn hide --open {printable(_sealed(folder))} shows them)"
        )
    if score.closed is not None and score.hidden:
        lines.append(f"{score.closed:.0%} of the gap on the validation log is closed")
    empty = "right: nothing was hidden, and nothing is claimed"
    lines.append(empty if not score.hidden and score.result == "right" else f"overall: {score.result}")
    return lines


# --- a fleet ----------------------------------------------------------------------------------------------


def _fleet_scored(answer: Part, file: Path, *, as_json: bool) -> None:
    from robodyn.files import label
    from robodyn.fleet.planted.score import score_fleet

    file = file / _FLEET if file.is_dir() else file
    score = score_fleet(answer, _read_json(file, "the fleet.json of robodyn fleet"), label(file))
    if not score.same:
        talk("robodyn: warning: the answer is about another fleet than that of this test")
    if as_json:
        echo_json(score.to_dict())
    else:
        for line in _lines_of_fleet(score):
            click.echo(line)
    if score.result != "right":
        raise click.exceptions.Exit(1)


def _lines_of_fleet(score: FleetScore) -> list[str]:
    lines = [
        f"{name}: {kind.named} of {kind.planted} units are named, {kind.right} with effect and joint right"
        for name, kind in score.kinds.items()
    ]
    lines.append(f"{score.false} of {score.healthy} healthy units are named")
    if score.claims:
        lines.append(f"{score.right} of {score.claims} names are right")
    if score.days_off is not None and score.near is not None:
        text = f"dates are off by {score.days_off:.0f} days (median), {score.near:.0%} by 30 or less"
        holds = score.interval_holds
        lines.append(text + ("" if holds is None else f"; {holds:.0%} are in the stated interval"))
    bad = [case for case in score.cases if not case.right]
    for case in bad[:_SHOWN]:
        planted, named = case.planted or "nothing", ", ".join(case.named) or "nothing"
        lines.append(f"  {case.type} {case.unit}: {planted} is planted, {named} is named")
    if len(bad) > _SHOWN:
        lines.append(f"  and {len(bad) - _SHOWN} more (--json lists them)")
    return [*lines, f"overall: {score.result}"]
