"""The same option for the same thing in every command, in help and in shells; old spellings still work."""

from __future__ import annotations

import re
from collections import defaultdict

import click
import pytest
from click.shell_completion import ShellComplete

from cli.command import Capture, run, run_json
from robodyn.dynamics.functions import FUNCTIONS
from robodyn.effects.catalogue import CATALOGUE
from robodyn.robot import bundled_names
from robodyn.targets import TARGETS, all_targets, compiled_targets, planned_targets
from robodyn_cli.choices import ROBOTS
from robodyn_cli.main import COMMANDS, cli

ALL = {name: command for name in COMMANDS if (command := cli.get_command(click.Context(cli), name))}
OLDER = {
    "--out": "--output", "--emit": "--output", "--function": "--functions", "--seconds": "--budget-seconds",
}  # fmt: skip


def options(command: click.Command) -> list[click.Option]:
    return [parameter for parameter in command.params if isinstance(parameter, click.Option)]


def test_one_thing_is_called_one_name() -> None:
    """Where results go, which functions, how long a search may take, the language."""
    for name, command in ALL.items():
        spellings = [each for option in options(command) for each in (*option.opts, *option.secondary_opts)]
        assert not {"--folder", "--dir", "--time"} & set(spellings), name
        for option in options(command):
            for spelling in set(option.opts) & set(OLDER):
                assert OLDER[spelling] in option.opts, (name, spelling)
        assert ("-o" in spellings) == ("--output" in spellings), name
        assert ("--lang" in spellings) == ("--language" in spellings), name
        if any(parameter.type is ROBOTS for parameter in command.params):
            assert [spellings.count(each) for each in ("--arg", "--model", "--massless")] == [1, 1, 1], name


def test_an_option_takes_the_same_everywhere() -> None:
    """The same spelling means the same: a flag here is a flag there, and a number a number."""
    kinds: dict[str, set[tuple[bool, str]]] = defaultdict(set)
    for command in ALL.values():
        for option in options(command):
            for spelling in option.opts:
                number = option.type.name.removesuffix(" range") in ("float", "integer", "numbers")
                kinds[spelling].add((option.is_flag, "number" if number else "word"))
    # -p of a sweep is a range, of a plan a number; joints are how many (new) or which (diagnose); what is
    # led to is a pose (simulate) or a format (export); a tolerance may have a percent sign (prove); a fleet
    # is how many units (hide) or a flag (schema)
    different = {spelling for spelling, several in kinds.items() if len(several) > 1}
    assert different <= {"-p", "--processors", "--cut", "--joints", "--to", "--tolerance", "--fleet"}


def test_each_help_text_stands_alone() -> None:
    for name, command in ALL.items():
        for option in options(command):
            _, text = option.get_help_record(click.Context(command, info_name=name)) or ("", "")
            assert text, (name, option.opts)
            assert text[:1].isupper() or not text[:1].isalpha(), (name, option.opts, text)
            assert text.rstrip().endswith((".", "]", ")")), (name, option.opts, text)
            assert not re.search(r"\b(the above|see above|ditto|as before)\b", text), (name, option.opts)


def test_the_help_lists_the_targets(capsys: Capture) -> None:
    for command, names in (
        ("gen", [target.name for target in compiled_targets()]),
        ("plan", [target.name for target in planned_targets()]),
        ("flops", list(TARGETS)),  # of --objective weighted:TARGET
    ):
        said = run(capsys, f"{command} --help")[0]
        assert not {"{compiled}", "{firmware}", "{planned}", "{all}"} & set(said.replace(",", " ").split())
        assert [name for name in names if name not in said] == []


def completed(line: str) -> list[str]:
    *before, begun = line.split(" ")
    return [item.value for item in ShellComplete(cli, {}, "robodyn", "_").get_completions(before, begun)]


@pytest.mark.parametrize(
    ("line", "offered"),
    [
        ("gen puma560 --functions grav", ["gravity", "gravity_with_wrench"]),
        ("gen puma560 --target cortex", ["cortex-m3", "cortex-m4f", "cortex-m7"]),
        ("gen puma560 --target cortex-m3,x", [f"cortex-m3,x86-64{end}" for end in ("", "-v3", "-v4")]),
        ("plan puma560 --target th", ["thesis-1990"]),
        ("flops puma560 --objective weighted:a", ["weighted:aarch64"]),
        ("hide puma560 --effect back", ["backlash"]),
        ("diagnose puma560 --only spring,back", ["spring,backlash"]),
        ("diagnose puma560 --except time_", ["time_delay"]),
        ("gen puma560 --optimize f", ["fast", "full"]),
        ("gen puma560 --trig b", ["builtin"]),
        ("tables 2.1", ["2.10"]),
    ],
)
def test_what_is_begun_is_completed(line: str, offered: list[str]) -> None:
    assert completed(line) == offered


def test_completion_offers_what_there_is() -> None:
    for command in ("gen", "flops", "simulate", "diagnose", "verify", "prove", "plan", "bench", "excite"):
        assert set(bundled_names()) <= set(completed(f"{command} ")), command
    assert set(completed("flops puma560 --functions ")) >= set(FUNCTIONS)
    assert "bias,gravity" in completed("verify puma560 --functions bias,gr")
    assert {target.name for target in all_targets()} >= set(completed("plan puma560 --target ")) > set()
    assert set(completed("effects ")) >= set(CATALOGUE)
    assert "newton_euler" in completed("gen puma560 --formulation newton")


def test_functions_may_be_repeated_or_listed(capsys: Capture) -> None:
    listed, repeated = (
        [entry["function"] for entry in run_json(capsys, f"flops stanford_3dof --functions gravity{more}")]
        for more in (",bias", " --functions bias")
    )
    assert listed == repeated == ["gravity", "bias"]
