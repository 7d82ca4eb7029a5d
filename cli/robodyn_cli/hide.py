"""``robodyn hide``: make and score blind tests of ``robodyn diagnose`` for your own arm."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from robodyn.errors import InputError, Place
from robodyn.outputs import write_files
from robodyn_cli import progress
from robodyn_cli.choices import EFFECTS, FILE, FOLDER, ROBOTS
from robodyn_cli.decorators import at_most_one, option
from robodyn_cli.log_files import spare_inputs
from robodyn_cli.output import echo_document, printable, show, talk
from robodyn_cli.output_files import output_folder
from robodyn_cli.robot_files import load_robot
from robodyn_cli.values import POSITIVE, SIZE

if TYPE_CHECKING:
    from robodyn.diagnose.amend.amend import Amendment
    from robodyn.diagnose.blind.hide import Blind, Setup
    from robodyn.diagnose.blind.json_part import Part
    from robodyn.diagnose.blind.seal import Score
    from robodyn.simulate.trajectories import Trajectory

_LARGEST = 50_000_000  # samples times joints, as of simulate
_OF_HIDING = ("robot", "effects", "random", "trajectories", "output")
_ANSWER, _DIAGNOSED = "answer.sealed", "diagnosis.json"
_LONGEST_ANSWER, _LONGEST_DIAGNOSIS = 1 << 24, 1 << 28  # bytes


@click.command()
@click.argument("robot", type=ROBOTS, metavar="[ROBOT]", required=False)
@option(
    "--effect=ID[@JOINT][:K=V,...] effects",
    "Effect to hide; missing parameters are random.",
    EFFECTS,
    multiple=True,
)
@option("--random=N", "Hide N more effects, chosen at random.  [default: 1]", click.IntRange(0, 20))
@option("--seed=S", "Random seed.", click.IntRange(0), default=0)
@option("--duration=S", "Duration of each log.", POSITIVE, default="10")
@option("--rate=HZ", "Sample rate of the logs.", POSITIVE, default="1000")
@option(
    "--trajectory=FILE.csv trajectories",
    "Motion of train.csv; if given twice, the second is that of validate.csv.",
    FILE,
    multiple=True,
)
@option("--noise=SHARE", "Torque noise as a share of the RMS torque.", POSITIVE, default="0.015")
@option("--ratio=R", "Size of random effects relative to the noise.", POSITIVE, default="4")
@option("--encoder-bits=B", "Encoder bits per turn; 0: exact.", SIZE, default="20")
@option("-o --output=DIR", "Output folder.", FOLDER)
@option(
    "--open=DIR opened", "Print the sealed answer of the test in DIR (or that file itself) and exit.", FILE
)
@option(
    "--score",
    "Compare a diagnosis.json (or the folder it is in) with the answer of the test in DIR (or that "
    "file itself).",
    FILE,
    metavar="DIR DIAGNOSIS",
    nargs=2,
)
def command(opened: str | None, score: tuple[str, str] | None, **options: Any) -> None:
    """Make a blind test: hide effects in simulated logs and seal the answer.

    The model is ROBOT; the simulated arm also has the effects of --effect and random ones. DIR gets
    given.yaml (the model), train.csv, validate.csv and answer.sealed. Run diagnose on these files, then score
    the result with --score. Effects with missing parameters are scaled so that their largest contribution is
    --ratio times the noise. --random 0 alone hides nothing and tests for false claims.
    """
    from robodyn.diagnose.blind.seal import checked

    hiding = [name for name in _OF_HIDING if options[name] not in (None, ())]
    at_most_one({"--open": opened, "--score": score, "hiding effects": bool(hiding)})
    if opened is not None:
        echo_document(json.dumps(checked(_answer(Path(opened))), indent=2, ensure_ascii=False))
    elif score is not None:
        _score(Path(score[0]), Path(score[1]))
    else:
        _hide(options)


# --- hiding -----------------------------------------------------------------------------------------------


def _hide(options: dict[str, Any]) -> None:
    """Write the files of a blind test, and print what was written without the answer."""
    if options["robot"] is None:
        raise InputError("no robot is named", remedy="use robodyn hide ROBOT -o DIR")
    if options["output"] is None:
        raise InputError("no output folder", remedy="add -o DIR")
    folder = output_folder(options["output"])
    spare_inputs([folder / name for name in ("train.csv", "validate.csv")], options["trajectories"])
    blind = _blind(options)
    files = blind.files()
    known, description = blind.model.covariance, blind.model.file
    if known and description:
        spare_inputs([folder / known.file], [str(description.with_name(known.file))])
    write_files(folder, files)
    count, robot, at = len(blind.effects), blind.model.name, printable(folder)
    what = "nothing is" if not count else "1 effect is" if count == 1 else f"{count} effects are"
    show(
        lambda: {
            "robot": robot, "folder": str(folder), "files": list(files), "hidden": count,
            "noise": blind.noise.tolist(),
        },
        lambda: (
            f"{robot}: {what} hidden in {at}: {', '.join(files)}",
            f"robodyn diagnose {at}/given.yaml {at}/train.csv --validate {at}/validate.csv -o {at}/found",
            f"robodyn hide --score {at} {at}/found/diagnosis.json",
        ),
    )  # fmt: skip
    if options["effects"] and blind.ratio < 1:
        talk(f"robodyn: note: the hidden effects are {blind.ratio:.2g} times the noise: too small to find")


def _blind(options: dict[str, Any]) -> Blind:
    from robodyn.diagnose.blind.hide import hide
    from robodyn.formats.loading import text_of

    robot = load_robot(options["robot"])
    wanted = [amendment(text) for text in options["effects"]]
    motions = _motions(options["trajectories"], robot.n)
    random = int(not wanted) if options["random"] is None else options["random"]
    setup = _setup(options, robot.n, max((motion.duration for motion in motions), default=0.0))
    with progress.line() as shown:
        return hide(
            robot, wanted, random=random, setup=setup, motions=motions, text=text_of(options["robot"]),
            progress=lambda what: shown.tell(f"robodyn: {robot.name}: {what}"),
        )  # fmt: skip


def _setup(options: dict[str, Any], n: int, longest: float) -> Setup:
    from robodyn.diagnose.blind.hide import Setup
    from robodyn_cli.simulate_options import whole

    longest = max(longest, options["duration"])
    if not 50 <= longest * options["rate"] * n <= _LARGEST:
        raise InputError(
            "the logs would be too long or too short",
            found=f"{longest:g} s at {options['rate']:g} Hz",
            expected=f"50 to {_LARGEST} values over all joints",
        )
    bits = whole(options["encoder_bits"])
    names = ("duration", "rate", "noise", "ratio", "seed")
    return Setup(encoder_bits=bits or None, **{name: options[name] for name in names})


def _motions(files: Sequence[str], n: int) -> list[Trajectory]:
    from robodyn.simulate.trajectories import from_file

    if len(files) > 2:
        raise InputError(
            "too many trajectories",
            found=str(len(files)),
            expected="one for train.csv and one for validate.csv",
        )
    return [from_file(file, n) for file in files]


def amendment(text: str) -> Amendment:
    """The effect ``ID[@JOINT][:key=value,...]``.

    Raises
    ------
    InputError: it is none.
    """
    from robodyn.diagnose.amend.amend import Amendment
    from robodyn.effects.catalogue import effect
    from robodyn.robot.numbers import parse_number

    place, _, rest = text.partition(":")
    id, joint = placed(place)
    known = effect(id)
    words = {p.name for p in known.parameters if p.kind in ("choice", "text")}
    values: dict[str, float | str] = {}
    for part in rest.split(",") if rest.strip() else []:
        name, equals, value = (piece.strip() for piece in part.partition("="))
        if not equals or not name or name in values:
            raise InputError(
                f"--effect {id}: {part.strip()!r} is not a new key=value", expected="for instance level=2.5"
            )
        values[name] = value if name in words else float(parse_number(value))
    return Amendment(id, joint, values)


def placed(text: str) -> tuple[str, int | None]:
    """``ID[@JOINT]``.

    Raises
    ------
    InputError: it is not.
    """
    id, at, joint = (part.strip() for part in text.partition("@"))
    if at and not (joint.isascii() and joint.isdecimal() and 0 < len(joint) < 9):
        raise InputError(f"{text!r} has no valid joint", expected="ID@JOINT, for instance coulomb_friction@2")
    return id, int(joint) if at else None


# --- opening and scoring ----------------------------------------------------------------------------------


def _sealed(path: Path) -> Path:
    """The sealed answer at ``path``, which is the file or the folder of the test."""
    return path / _ANSWER if path.is_dir() else path


def _answer(path: Path) -> Part:
    from robodyn.diagnose.blind.seal import unsealed
    from robodyn.files import label, read_text

    path = _sealed(path)
    return unsealed(read_text(path, _LONGEST_ANSWER, "the answer.sealed of robodyn hide"), label(path))


def _score(folder: Path, file: Path) -> None:
    """Print how the diagnosis in ``file`` did at the test in ``folder``; exit with 1 if it is wrong, or
    missed what is hidden."""
    from robodyn.diagnose.blind.seal import checked, score
    from robodyn.files import label, parsed_json, read_text

    if folder.suffix == ".json" and folder.is_file():
        raise InputError(
            "the first argument of --score is the folder of the test",
            found=printable(folder),
            remedy="swap the two arguments",
        )
    answer = checked(_answer(folder))
    file = file / _DIAGNOSED if file.is_dir() else file
    expected = "the diagnosis.json of robodyn diagnose"
    try:
        diagnosis = parsed_json(read_text(file, _LONGEST_DIAGNOSIS, expected))
    except ValueError as error:
        place = Place(label(file))
        raise InputError("this is not JSON", where=place, found=str(error), expected=expected) from None
    result = score(answer, diagnosis, label(file))
    if not result.same:
        talk("robodyn: warning: the diagnosis was made from other logs than those of this test")
    show(result.to_dict, lambda: _lines(result, folder))
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
