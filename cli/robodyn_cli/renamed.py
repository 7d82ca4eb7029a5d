"""Old spellings of options: they work for one more release, with a word on stderr."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from robodyn_cli.common import talk

#: By command: old spelling of an option -> the one that all commands share.
RENAMED: Final[Mapping[str, Mapping[str, str]]] = {
    "flops": {"--function": "--functions"},
    "plan": {"--function": "--functions"},
    "bench": {"--function": "--functions"},
    "schedule": {"--function": "--functions", "--seconds": "--budget-seconds", "--emit": "--output"},
    "prove": {"--seconds": "--budget-seconds"},
    "diagnose": {"--out": "--output"},
    "fleet": {"--out": "--output"},
    "report": {"--out": "--output"},
}


def renamed(command: str, arguments: list[str]) -> list[str]:
    """``arguments`` of ``command`` with today's spellings; each old one is named on stderr."""
    table = RENAMED.get(command, {})
    spelled = []
    options = True
    for argument in arguments:
        name, equals, value = argument.partition("=")
        options = options and argument != "--"
        if options and name in table:
            talk(f"robodyn: warning: {name} is now {table[name]}; the next release drops the old name")
            argument = table[name] + equals + value
        spelled.append(argument)
    return spelled
