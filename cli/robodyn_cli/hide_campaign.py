"""``robodyn hide --campaign``: many blind tests at once, and how the diagnoses did."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any, Final

import click

from robodyn.outputs import write_files
from robodyn_cli import progress
from robodyn_cli.common import echo_document, output_folder, printable, talk

if TYPE_CHECKING:
    from robodyn.diagnose.amend.amend import Amendment
    from robodyn.diagnose.blind.hide import Setup

_DATA, _STORE = "campaign.json", "store.sqlite"
_RESULTS: Final = ("right", "in the declared set", "missed", "wrong")


def campaign(
    name: str, spec: str, wanted: Sequence[Amendment], random: int, setup: Setup, options: dict[str, Any],
    *, as_json: bool,
) -> None:  # fmt: skip
    """Carry out the trials that the folder does not have yet, with the seeds from that of ``setup`` on, and
    print what all came to.

    Raises
    ------
    InputError: no folder, an effect that does not fit, or another run holds the folder.
    OutputError: there is no room in the folder; what is done stays done.
    ToolError: no C compiler, or nothing to work with.
    """
    from robodyn.cluster import Done, open_cluster
    from robodyn.diagnose.blind.campaign import tallies, trial
    from robodyn.errors import InputError
    from robodyn.fleet.store import key_of, open_store
    from robodyn.formats.loading import text_of
    from robodyn.toolchain.sources import own_key

    if options["output"] is None:
        raise InputError("no output folder", remedy="add -o DIR")
    folder, count = output_folder(options["output"]), options["campaign"]
    text, trials = text_of(spec), list[dict[str, Any]]()
    setups = [replace(setup, seed=setup.seed + k) for k in range(count)]
    with open_store(folder / _STORE) as store, progress.line() as line:
        keys = [key_of("trial", own_key(), text, repr(wanted), str(random), repr(own)) for own in setups]
        new = [k for k, key in enumerate(keys) if not store.has(key)]
        tasks = ((k, (text, spec, wanted, random, setups[k])) for k in new)
        failures: list[tuple[int, Exception]] = []
        if new:
            with open_cluster(options["on"]) as cluster:
                for done, (k, outcome) in enumerate(cluster.each(trial, tasks)):
                    if isinstance(outcome, Done):
                        store.keep(keys[k], outcome.value)
                    else:
                        failures.append((k, outcome.error))
                    line.tell(f"robodyn: {name}: {done + 1} of {len(new)} trials", at_once=True)
        for key in keys:
            value = store.result(key)
            if isinstance(value, bytes):
                trials.append(json.loads(value))
    for k, error in sorted(failures, key=lambda failure: failure[0]):
        talk(f"robodyn: warning: seed {setups[k].seed}: {error}")
    if not trials:
        raise failures[0][1]
    results = Counter(one["result"] for one in trials)
    rows = tallies(trials)
    document = {
        "robot": name,
        "trials": len(trials),
        "failed": [setups[k].seed for k, _ in sorted(failures, key=lambda failure: failure[0])],
        "results": {result: results[result] for result in _RESULTS},
        "effects": [row.to_dict() for row in rows],
        "all": trials,
    }
    data = json.dumps(document, indent=2) + "\n"
    write_files(folder, {_DATA: data})
    if as_json:
        echo_document(data)
        return
    width = max([len(row.effect) for row in rows], default=6)
    if rows:
        click.echo(f"{'effect':{width}}  right  declared  missed  wrong")
    for row in rows:
        click.echo(f"{row.effect:{width}}  {row.right:5}  {row.declared:8}  {row.missed:6}  {row.wrong:5}")
    summary = ", ".join(f"{results[result]} {result}" for result in _RESULTS)
    click.echo(f"{name}: {len(trials)} trials: {summary}; {printable(folder / _DATA)}")
