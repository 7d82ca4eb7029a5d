"""``robodyn hide``: make and score blind tests of ``robodyn diagnose`` for your own arm."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
from click.core import ParameterSource

from robodyn.outputs import write_files
from robodyn_cli import hide_campaign, hide_fleet, hide_score, progress
from robodyn_cli.choices import EFFECTS, FILE, FOLDER, ROBOTS
from robodyn_cli.common import (
    echo_document,
    echo_json,
    json_option,
    load_robot,
    output_folder,
    printable,
    talk,
)
from robodyn_cli.values import POSITIVE, SIZE

if TYPE_CHECKING:
    from robodyn.diagnose.amend.amend import Amendment
    from robodyn.diagnose.blind.hide import Blind, Setup
    from robodyn.simulate.trajectories import Trajectory

_LARGEST = 50_000_000  # samples times joints, as of simulate
_OF_HIDING = ("effects", "random", "trajectories", "output", "campaign")
_OF_FLEET = ("fleet", "recipe", "format", "on")
_NOT_OF_CAMPAIGN = ("recipe", "format", "trajectories")
_OF_ONE = ("effects", "random", "trajectories", "duration", "rate", "noise", "ratio", "encoder_bits")
#: How options are spelled whose names differ.
_OPTIONS = {"effects": "effect", "trajectories": "trajectory", "encoder_bits": "encoder-bits"}


@click.command()
@click.argument("robots", type=ROBOTS, metavar="[ROBOT]...", nargs=-1)
@click.option(
    "--effect",
    "effects",
    type=EFFECTS,
    multiple=True,
    metavar="ID[@JOINT][:K=V,...]",
    help="Effect to hide; missing parameters are random.",
)
@click.option(
    "--random",
    type=click.IntRange(0, 20),
    metavar="N",
    help="Hide N more effects, chosen at random.  [default: 1]",
)
@click.option(
    "--seed", type=click.IntRange(0), metavar="S", default=0, show_default=True, help="Random seed."
)
@click.option(
    "--duration", type=POSITIVE, default=10.0, metavar="S", help="Duration of each log.  [default: 10]"
)
@click.option(
    "--rate", type=POSITIVE, default=1000.0, metavar="HZ", help="Sample rate of the logs.  [default: 1000]"
)
@click.option(
    "--trajectory",
    "trajectories",
    multiple=True,
    type=FILE,
    metavar="FILE.csv",
    help="Motion of train.csv; if given twice, the second is that of validate.csv.",
)
@click.option(
    "--noise",
    type=POSITIVE,
    default=0.015,
    metavar="SHARE",
    help="Torque noise as a share of the RMS torque.  [default: 0.015]",
)
@click.option(
    "--ratio",
    type=POSITIVE,
    default=4.0,
    metavar="R",
    help="Size of random effects relative to the noise.  [default: 4]",
)
@click.option(
    "--encoder-bits",
    type=SIZE,
    default=20.0,
    metavar="B",
    help="Encoder bits per turn; 0: exact.  [default: 20]",
)
@click.option(
    "--fleet",
    type=click.IntRange(1),
    metavar="N",
    help="Simulate N units of the types ROBOT..., with logs over a year, as a test of robodyn fleet.",
)
@click.option(
    "--campaign",
    type=click.IntRange(1, 1_000_000),
    metavar="N",
    help="Make, diagnose and score N tests, with the seeds from --seed on; a second run does what is new.",
)
@click.option("--recipe", type=FILE, metavar="FILE.toml", help="What the fleet is made of (with --fleet).")
@click.option(
    "--format",
    type=click.Choice(["csv", "parquet"]),
    help="Format of the fleet's logs.  [default: parquet if pyarrow is installed]",
)
@click.option(
    "--on",
    default="local",
    metavar="here|local[:N]|dask://HOST:PORT",
    help="Where a fleet or a campaign is worked out: this process, N processes, a Dask scheduler.  "
    "[default: local]",
)
@click.option("-o", "--output", type=FOLDER, metavar="DIR", help="Output folder.")
@click.option(
    "--open",
    "opened",
    type=FOLDER,
    metavar="DIR",
    help="Print the sealed answer of the test in DIR (or that file itself) and exit.",
)
@click.option(
    "--score",
    nargs=2,
    type=FILE,
    metavar="DIR RESULT",
    help="Compare a diagnosis.json or fleet.json (or the folder it is in) with the answer of the test in DIR "
    "(or that file itself).",
)
@json_option
def command(
    robots: tuple[str, ...], opened: str | None, score: tuple[str, str] | None, as_json: bool, **options: Any
) -> None:
    """Make a blind test: hide effects in simulated logs and seal the answer.

    The model is ROBOT; the simulated arm also has the effects of --effect and random ones. DIR gets
    given.yaml (the model), train.csv, validate.csv and answer.sealed. Run diagnose on these files, then score
    the result with --score. Effects with missing parameters are scaled so that their largest contribution is
    --ratio times the noise. --random 0 alone hides nothing and tests for false claims. --campaign does all of
    it many times, and counts.

    With --fleet, units of several types scatter about their types, and in some friction grows, play grows or
    a payload is not entered. DIR gets logs/, types/ (data sheets), manifest.csv, fleet.toml and
    answer.sealed. Run fleet on it, then score fleet.json.
    """
    from robodyn.errors import InputError

    _one_of(robots, opened, score, options)
    if opened is not None:
        echo_document(json.dumps(hide_score.opened(Path(opened)), indent=2, ensure_ascii=False))
        return
    if score is not None:
        hide_score.scored(Path(score[0]), Path(score[1]), as_json=as_json)
        return
    if options["fleet"] is not None:
        hide_fleet.plant(robots, options, as_json=as_json)
        return
    (robot,) = robots
    if options["campaign"] is not None:
        _campaign(robot, options, as_json=as_json)
        return
    if options["output"] is None:
        raise InputError("no output folder", remedy="add -o DIR")
    folder = output_folder(options["output"])
    for file in options["trajectories"]:
        for name in ("train.csv", "validate.csv"):
            there = (folder / name).exists() and Path(file).exists()
            if there and (folder / name).samefile(file):
                raise InputError(
                    f"{printable(folder / name)} is an input and would be overwritten",
                    remedy="choose another folder with -o",
                )
    blind = _hidden(robot, options)
    files = blind.files()
    write_files(folder, files)
    _tell(blind, folder, list(files), [*options["effects"]], as_json=as_json)


def _one_of(robots: Sequence[str], opened: str | None, score: object, options: dict[str, Any]) -> None:
    """Refuse a mixture of hiding, opening and scoring, and of one arm and a fleet."""
    from robodyn.errors import InputError

    modes = [name for name, there in (("--open", opened), ("--score", score)) if there is not None]
    hiding = [name for name in (*_OF_HIDING, *_OF_FLEET[:3]) if options[name] not in (None, ())]
    if len(modes) == 2 or (modes and (robots or hiding)):
        other = modes[1] if len(modes) == 2 else "ROBOT" if robots else "options of hiding"
        raise InputError(
            f"{modes[0]} cannot be combined with other options", found=other, remedy="remove one of them"
        )
    if not modes and not robots:
        raise InputError("no robot is named", remedy="use robodyn hide ROBOT -o DIR")
    context = click.get_current_context()
    stated = [name for name in options if context.get_parameter_source(name) == ParameterSource.COMMANDLINE]
    fleet, campaign = (options[name] is not None for name in ("fleet", "campaign"))
    of_others = (*_OF_ONE, "campaign") if fleet else _NOT_OF_CAMPAIGN if campaign else _OF_FLEET
    foreign = [name for name in stated if name in of_others]
    if not modes and foreign:
        whose = "one arm" if fleet else "one test" if foreign[0] == "trajectories" else "a fleet"
        raise InputError(
            f"--{_OPTIONS.get(foreign[0], foreign[0])} is an option of {whose}",
            remedy="put it into the recipe" if fleet else "remove it" if campaign else "add --fleet N",
        )
    if len(robots) > 1 and not fleet:
        raise InputError(
            "a blind test has one robot", found=f"{len(robots)}", remedy="add --fleet N for a fleet"
        )


# --- hiding -----------------------------------------------------------------------------------------------


def _campaign(spec: str, options: dict[str, Any], *, as_json: bool) -> None:
    """Many tests of one arm."""
    robot = load_robot(spec)
    wanted, count = _wanted(options)
    setup = _setup(options, robot.n, 0.0)
    hide_campaign.campaign(robot.name, spec, wanted, count, setup, options, as_json=as_json)


def _wanted(options: dict[str, Any]) -> tuple[list[Amendment], int]:
    """The effects that are named, and how many are drawn beside them."""
    wanted = [_parsed(text) for text in options["effects"]]
    return wanted, options["random"] if options["random"] is not None else int(not wanted)


def _hidden(spec: str, options: dict[str, Any]) -> Blind:
    from robodyn.diagnose.blind.hide import hide
    from robodyn.formats.loading import text_of

    robot = load_robot(spec)
    wanted, count = _wanted(options)
    motions = _motions(options["trajectories"], robot.n)
    with progress.line() as shown:
        return hide(
            robot,
            wanted,
            random=count,
            setup=_setup(options, robot.n, max((motion.duration for motion in motions), default=0.0)),
            motions=motions,
            text=text_of(spec),
            progress=lambda what: shown.tell(f"robodyn: {robot.name}: {what}"),
        )


def _setup(options: dict[str, Any], n: int, longest: float) -> Setup:
    from robodyn.diagnose.blind.hide import Setup
    from robodyn.errors import InputError
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
    from robodyn.errors import InputError
    from robodyn.simulate.trajectories import from_file

    if len(files) > 2:
        raise InputError(
            "too many trajectories",
            found=str(len(files)),
            expected="one for train.csv and one for validate.csv",
        )
    return [from_file(file, n) for file in files]


def _parsed(text: str) -> Amendment:
    """``ID[@JOINT][:key=value,...]``."""
    from robodyn.diagnose.amend.amend import Amendment
    from robodyn.effects.catalogue import effect
    from robodyn.errors import InputError
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
    from robodyn.errors import InputError

    id, at, joint = (part.strip() for part in text.partition("@"))
    if at and not (joint.isascii() and joint.isdecimal() and 0 < len(joint) < 9):
        raise InputError(f"{text!r} has no valid joint", expected="ID@JOINT, for instance coulomb_friction@2")
    return id, int(joint) if at else None


def _tell(blind: Blind, folder: Path, files: list[str], named: list[str], *, as_json: bool) -> None:
    """Print what was written, without the answer."""
    if as_json:
        echo_json(
            {
                "robot": blind.model.name,
                "folder": str(folder),
                "files": files,
                "hidden": len(blind.effects),
                "noise": blind.noise.tolist(),
            }
        )
    else:
        at = printable(folder)
        count = len(blind.effects)
        what = "nothing is" if not count else "1 effect is" if count == 1 else f"{count} effects are"
        click.echo(f"{blind.model.name}: {what} hidden in {at}: {', '.join(files)}")
        click.echo(
            f"robodyn diagnose {at}/given.yaml {at}/train.csv --validate {at}/validate.csv -o {at}/found"
        )
        click.echo(f"robodyn hide --score {at} {at}/found/diagnosis.json")
    if named and blind.ratio < 1:
        talk(f"robodyn: note: the hidden effects are {blind.ratio:.2g} times the noise: too small to find")
