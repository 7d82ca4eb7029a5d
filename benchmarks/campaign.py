"""Many blind tests of one arm: how often a diagnosis is right, effect by effect.

    python -m benchmarks.campaign ROBOT -o DIR [--trials N] [--seed S] [--effect ID[@JOINT][:K=V,...]]
                                  [--random N] [--on here|local:N|dask://HOST:PORT]

Hides effects as ``robodyn hide`` does, with N consecutive seeds from S on, diagnoses and scores.
campaign.json in DIR has every trial. What is done is kept in store.sqlite: a second run does what is new.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from robodyn.cluster import Done, open_cluster
from robodyn.diagnose.amend.amend import Amendment
from robodyn.diagnose.blind.hide import Setup, hide
from robodyn.diagnose.blind.seal import score
from robodyn.diagnose.run import diagnose
from robodyn.errors import RobodynError
from robodyn.fleet.store import key_of, open_store
from robodyn.formats.loading import text_of
from robodyn.robot.reader import read_text
from robodyn.toolchain.sources import own_key
from robodyn_cli.hide import amendment

_RESULTS = ("right", "in the declared set", "missed", "wrong")


def trial(text: str, spec: str, wanted: Sequence[Amendment], random: int, setup: Setup) -> bytes:
    """A blind test of the arm described by ``text`` (called ``spec``), its diagnosis and the score, as JSON:
    see :func:`robodyn.diagnose.blind.hide.hide` for what is hidden.

    Raises
    ------
    InputError: an effect does not fit the arm, or cannot be as large as is wanted.
    ToolError: no C compiler.
    """
    robot = read_text(text, spec, warn=lambda _: None)
    blind = hide(robot, wanted, random=random, setup=setup, text=text)
    diagnosis = diagnose(robot, [blind.train], blind.validate, text=text).to_dict()
    answer = blind.answer()
    result = score(answer, json.loads(json.dumps(diagnosis), parse_constant=lambda _: None))
    answered = {claim.answers: claim.status for claim in result.claims}
    hidden = [
        {"effect": one["effect"], "joint": one["joint"], "status": answered.get(k, "missed")}
        for k, one in enumerate(answer["effects"])
    ]
    wrong = [
        {"effect": claim.effect, "joint": claim.joint} for claim in result.claims if claim.status == "wrong"
    ]
    record = {
        "seed": setup.seed,
        "result": result.result,
        "verdict": result.verdict,
        "hidden": hidden,
        "wrong": wrong,
        "gap_closed": result.closed,
    }
    return json.dumps(record).encode()


@dataclass(frozen=True, slots=True)
class Tally:
    """Of an ``effect``, how often it was hidden and named ``right``, hidden and among what a claim could not
    be told from (``declared``), hidden and ``missed``; and how often it was named and not hidden
    (``wrong``)."""

    effect: str
    right: int = 0
    declared: int = 0
    missed: int = 0
    wrong: int = 0

    def to_dict(self) -> dict[str, Any]:
        """Ready for JSON."""
        return asdict(self)


def tallies(trials: Iterable[Mapping[str, Any]]) -> list[Tally]:
    """Of what :func:`trial` says of each trial, the tally of each effect, by their ids."""
    fields = {"right": "right", "in the declared set": "declared", "missed": "missed"}
    counts: dict[str, dict[str, int]] = {}

    def add(effect: str, field: str) -> None:
        own = counts.setdefault(effect, {})
        own[field] = own.get(field, 0) + 1

    for one in trials:
        for hidden in one["hidden"]:
            add(hidden["effect"], fields[hidden["status"]])
        for claim in one["wrong"]:
            add(claim["effect"], "wrong")
    return [Tally(effect, **own) for effect, own in sorted(counts.items())]


def main(arguments: Sequence[str] | None = None) -> int:
    """Carry out the trials that the folder lacks, print what all came to, and return the exit code."""
    options = _parser().parse_args(arguments)
    wanted = [amendment(text) for text in options.effect]
    random = options.random if options.random is not None else int(not wanted)
    try:
        results = _trials(options, wanted, random)
    except RobodynError as error:
        print(f"error: {error}", file=sys.stderr)
        return error.exit_code
    (Path(options.output) / "campaign.json").write_text(
        json.dumps(results, indent=2) + "\n", encoding="utf-8"
    )
    rows = tallies(results)
    width = max((len(row.effect) for row in rows), default=6)
    print(f"{'effect':{width}}  right  declared  missed  wrong")
    for row in rows:
        print(f"{row.effect:{width}}  {row.right:5}  {row.declared:8}  {row.missed:6}  {row.wrong:5}")
    counts = Counter(one["result"] for one in results)
    print(f"{len(results)} trials: " + ", ".join(f"{counts[result]} {result}" for result in _RESULTS))
    return 0


def _trials(options: argparse.Namespace, wanted: Sequence[Amendment], random: int) -> list[dict[str, Any]]:
    """What :func:`trial` says of each seed, where it could be carried out."""
    folder, text, results = Path(options.output), text_of(options.robot), []
    folder.mkdir(parents=True, exist_ok=True)
    setups = [Setup(seed=options.seed + k) for k in range(options.trials)]
    keys = [key_of("trial", own_key(), text, repr(wanted), str(random), repr(setup)) for setup in setups]
    with open_store(folder / "store.sqlite") as store, open_cluster(options.on) as cluster:
        tasks = (
            (k, (text, options.robot, wanted, random, setups[k]))
            for k, key in enumerate(keys)
            if not store.has(key)
        )
        for k, outcome in cluster.each(trial, tasks):
            if isinstance(outcome, Done):
                store.keep(keys[k], outcome.value)
            else:
                print(f"warning: seed {setups[k].seed}: {outcome.error}", file=sys.stderr)
        for key in keys:
            value = store.result(key)
            if isinstance(value, bytes):
                results.append(json.loads(value))
    return results


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks.campaign",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("robot", metavar="ROBOT")
    parser.add_argument("-o", "--output", required=True)
    parser.add_argument("--trials", type=int, default=100)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--effect", action="append", default=[])
    parser.add_argument("--random", type=int)
    parser.add_argument("--on", default="local")
    return parser


if __name__ == "__main__":
    sys.exit(main())
