"""The same option for the same thing in every command; old spellings work and say what replaces them."""

from __future__ import annotations

import json
import re
from collections import defaultdict

import click
import pytest
from click.shell_completion import ShellComplete

from robodyn.dynamics.functions import FUNCTIONS
from robodyn.effects.catalogue import CATALOGUE
from robodyn.robot import bundled_names
from robodyn.targets import all_targets
from robodyn_cli.main import COMMANDS, cli, main

ALL = {name: command for name in COMMANDS if (command := cli.get_command(click.Context(cli), name))}


def options(command: click.Command) -> list[click.Option]:
    return [parameter for parameter in command.params if isinstance(parameter, click.Option)]


def spellings(command: click.Command) -> set[str]:
    return {spelling for option in options(command) for spelling in (*option.opts, *option.secondary_opts)}


def test_one_thing_is_called_one_name() -> None:
    """Where results go, which functions, how long a search may take, the language."""
    older = {
        "--out": "--output",
        "--emit": "--output",
        "--function": "--functions",
        "--seconds": "--budget-seconds",
    }
    for name, command in ALL.items():
        assert not spellings(command) & {"--folder", "--dir", "--time"}, name
        for option in options(command):
            for spelling in set(option.opts) & set(older):
                assert older[spelling] in option.opts, (name, spelling)
        assert ("-o" in spellings(command)) == ("--output" in spellings(command)), name
        assert ("--lang" in spellings(command)) == ("--language" in spellings(command)), name


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


@pytest.mark.parametrize("name", COMMANDS)
def test_each_help_text_stands_alone(name: str) -> None:
    context = click.Context(ALL[name], info_name=name)
    for option in options(ALL[name]):
        _, text = option.get_help_record(context) or ("", "")
        assert text, (name, option.opts)
        assert text[:1].isupper() or not text[:1].isalpha(), (name, option.opts, text)
        assert text.rstrip().endswith((".", "]", ")")), (name, option.opts, text)
        assert not re.search(r"\b(the above|see above|ditto|as before)\b", text), (name, option.opts)


def completed(*arguments: str) -> list[str]:
    *before, begun = arguments
    return [
        item.value for item in ShellComplete(cli, {}, "robodyn", "_").get_completions(list(before), begun)
    ]


def test_completion_offers_what_there_is() -> None:
    for command in ("gen", "flops", "simulate", "diagnose", "verify", "prove", "plan", "bench", "excite"):
        assert set(bundled_names()) <= set(completed(command, "")), command
    assert completed("gen", "puma560", "--functions", "grav") == ["gravity", "gravity_with_wrench"]
    assert set(completed("flops", "puma560", "--functions", "")) >= set(FUNCTIONS)
    assert "bias,gravity" in completed("verify", "puma560", "--functions", "bias,gr")
    assert completed("gen", "puma560", "--target", "cortex-m4f") == ["cortex-m4f"]
    assert {target.name for target in all_targets()} >= set(completed("plan", "puma560", "--target", ""))
    assert completed("plan", "puma560", "--target", "")
    assert set(completed("effects", "")) >= set(CATALOGUE)
    assert completed("hide", "puma560", "--effect", "back") == ["backlash"]
    assert completed("diagnose", "puma560", "--only", "spring,back") == ["spring,backlash"]
    assert completed("diagnose", "puma560", "--except", "time_") == ["time_delay"]
    assert completed("gen", "puma560", "--optimize", "f") == ["fast", "full"]
    assert "newton_euler" in completed("gen", "puma560", "--formulation", "newton")
    assert completed("gen", "puma560", "--trig", "b") == ["builtin"]
    assert completed("tables", "2.1") == ["2.10"]


def test_functions_may_be_repeated_or_listed(capsys: pytest.CaptureFixture[str]) -> None:
    def names(*arguments: str) -> list[str]:
        assert main(["flops", "stanford_3dof", *arguments, "--json"]) == 0
        return [entry["function"] for entry in json.loads(capsys.readouterr().out)]

    assert names("--functions", "gravity,bias") == ["gravity", "bias"]
    assert names("--functions", "gravity", "--functions", "bias") == ["gravity", "bias"]
    assert main(["plan", "stanford_3dof", "--deadline", "1ms", "--functions", "gravity,bias"]) == 2
    assert "one function at a time" in capsys.readouterr().err
