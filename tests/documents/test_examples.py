"""Every example of README, CONTRIBUTING and documents is carried out, and prints what is shown."""

from __future__ import annotations

import re
import shlex
from collections.abc import Iterator
from pathlib import Path

import click
import pytest

from documents.blocks import FENCE, PAGES, ROOT, TUTORIALS, Command, commands, read
from documents.running import Reader, checkout, program_folder
from robodyn.robot import read_text
from robodyn_cli.main import COMMANDS, HELP, cli
from robodyn_testing import representative, require_tool

EXAMPLES = {page: [block for block in read(page) if block.is_example] for page in PAGES}
#: test_tutorials.py follows the tutorials.
RUN = [
    page for page, found in EXAMPLES.items() if page not in TUTORIALS and any(block.is_run for block in found)
]


#: Pages whose examples take more than 10 s of CPU: ``make prove-all`` follows them.
LONG = {
    f"docs/{name}.md"
    for name in ("tour", "from-c-and-python", "fleet", "packages", "motions", "blind-tests", "thesis")
}
PAGES_IN_CI = representative([page for page in RUN if page not in LONG], "docs/kernels.md")


@pytest.mark.parametrize(
    "page", [*PAGES_IN_CI, *(pytest.param(page, marks=pytest.mark.slow) for page in RUN if page in LONG)]
)
def test_the_examples_print_what_is_shown(page: str, tmp_path: Path) -> None:
    for block in EXAMPLES[page]:
        if block.mark == "needs":
            for tool in block.detail.split(", "):
                require_tool(tool)
    require_tool("bash")  # here: a newcomer who follows a tutorial has no pytest
    reader = Reader(checkout(tmp_path / "checkout"), (program_folder(tmp_path / "bin"),))
    faults = [fault for block in read(page) for fault in reader.follow(block)]
    assert not faults, f"{page}\n" + "\n".join(faults)


def test_nothing_else_looks_like_an_example() -> None:
    """Shell commands stand in console blocks, where they are run."""
    for page in PAGES:
        languages = {block.language for block in read(page) if block.mark != "file"}
        assert not languages & {"sh", "bash", "shell", "pycon"}, page
        prose = FENCE.sub("", (ROOT / page).read_text(encoding="utf-8"))
        assert not re.findall(r"^    (?:\$|robodyn|make|python) .*$", prose, flags=re.MULTILINE), page


def test_what_is_not_run_has_a_reason_and_what_others_run_is_there() -> None:
    marked = [(page, block) for page, found in EXAMPLES.items() for block in found if not block.is_run]
    assert marked
    for page, block in marked:
        where = f"{page}, line {block.line}"
        if block.mark == "run by" and block.detail in EXAMPLES:
            run = {command.text.partition("  #")[0].strip() for command in run_in(block.detail)}
            shown = {command.text.partition("  #")[0].strip() for command in commands(block)}
            assert shown <= run, where
        elif block.mark == "run by":
            assert (ROOT / block.detail).is_file(), where
        else:
            assert len(block.detail.split()) > 2, where


def run_in(page: str) -> Iterator[Command]:
    """The commands that a document's own test runs."""
    for block in EXAMPLES[page]:
        if block.is_run and block.language == "console":
            yield from commands(block)


def robodyn_lines() -> list[tuple[str, list[str]]]:
    """Every ``robodyn ...`` of the documents: where it stands, and its words."""
    return [
        (f"{page}, line {command.line}", shlex.split(command.text, comments=True)[1:])
        for page, found in EXAMPLES.items()
        for block in found
        if block.language == "console"
        for command in commands(block)
        if command.text.startswith("robodyn ")
    ]


def test_every_command_shown_has_the_options_that_it_is_shown_with() -> None:
    """Also where it is not run."""
    lines = robodyn_lines()
    assert len(lines) > 50
    for where, (name, *words) in lines:
        assert name in COMMANDS, where
        command = cli.get_command(click.Context(cli), name)
        assert command is not None
        context = click.Context(command, **HELP)
        try:
            command.make_parser(context).parse_args(list(words))
        except click.UsageError as error:
            pytest.fail(f"{where}: {error.format_message()}")


def test_the_tour_visits_every_command() -> None:
    visited = {
        command.text.split()[1]
        for block in EXAMPLES["docs/tour.md"]
        for command in commands(block)
        if command.text.startswith("robodyn ")
    }
    assert visited == set(COMMANDS), "docs/tour.md shows every command once at least"


def test_descriptions_of_robots_are_robots() -> None:
    found = [
        block.text
        for page in PAGES
        for block in read(page)
        if block.language == "yaml" and block.text.startswith("name: ")
    ]
    assert found
    assert read_text(found[-1]).n > 0
    for text in found:
        assert read_text(text).n > 0


# --- the mechanism itself --------------------------------------------------------------------------------
