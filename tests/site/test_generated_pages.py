"""Pages that are made from the code say what the code says; the navigation has every page."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Iterable
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import click
import pytest
import yaml

import robodyn
from robodyn.dynamics.functions import FUNCTIONS
from robodyn.effects.catalogue import CATALOGUE
from robodyn.effects.effect import Effect
from robodyn.emit.languages import LANGUAGES
from robodyn.formats.elements_of import FORMATS, table_of
from robodyn.formats.tree import PHYSICS
from robodyn.robot import read_text
from robodyn.targets import TARGETS
from robodyn_cli.main import COMMANDS, cli
from robodyn_site import navigation, python
from robodyn_site.curves import entry, picture, usual_values
from robodyn_site.docstrings import markdown
from robodyn_site.equations import typeset
from robodyn_site.markdown import plain
from robodyn_site.pages import pages

LINK = "  - {joint: revolute, mass: 1, inertia: {xx: 1, yy: 1, zz: 1}, motor_inertia: 0.1}\n"
LAST = "  - joint: revolute\n    mass: 1\n    inertia: {xx: 1, yy: 1, zz: 1}\n    motor_inertia: 0.1\n"
ARM = f"name: arm\nlinks:\n{5 * LINK}{LAST}"
SHOWN = [effect for effect in CATALOGUE.values() if usual_values(effect)]


@pytest.mark.parametrize("name", COMMANDS)
def test_the_page_of_a_command_has_each_of_its_options(name: str) -> None:
    command = cli.get_command(click.Context(cli), name)
    assert command is not None
    options = [option for one in command.params if isinstance(one, click.Option) for option in one.opts]
    shown = re.findall(r"^`(-[^`]+)`$", pages()[f"commands/{name}.md"], flags=re.MULTILINE)
    assert options
    assert set(options) <= {word for line in shown for word in re.split(r"[ ,]+", line)}


@pytest.mark.parametrize("effect", SHOWN, ids=lambda effect: effect.id)
def test_the_example_of_an_effect_is_part_of_a_description(effect: Effect) -> None:
    values = usual_values(effect)
    listed = entry(effect, values)
    text = ARM + (listed if effect.level == "robot" else textwrap.indent(listed, "    "))
    robot = read_text(text, warn=lambda _: None)
    if effect.traits.fold is not None:  # numbers of the arm itself take it
        plain_arm = read_text(ARM)
        assert (robot.links, robot.gravity) != (plain_arm.links, plain_arm.gravity)
        return
    (read,) = robot.effects
    settings: dict[str, Any] = dict(read.settings)
    assert read.effect == effect.id
    assert {name: pytest.approx(x) for name, x in values.items()} == {
        name: settings[name] if isinstance(x, str) else float(settings[name]) for name, x in values.items()
    }


def test_most_effects_have_an_example_and_a_curve() -> None:
    assert len(SHOWN) >= 20
    assert sum(picture(effect, usual_values(effect)) is not None for effect in SHOWN) >= 16


@pytest.mark.parametrize(
    ("id", "values", "expected"),
    [
        ("viscous_friction", {"coefficient": 2.0}, {-1.5: -3.0, 0.0: 0.0, 1.5: 3.0}),
        ("coulomb_friction", {"level": 2.0}, {-1.5: -2.0, 1.5: 2.0}),
        ("joint_elasticity", {"stiffness": 1000.0, "damping": 1.0}, {-100.0: -0.1, 100.0: 0.1}),
    ],
)
def test_curves_are_those_of_the_equation(
    id: str, values: dict[str, float], expected: dict[float, float]
) -> None:
    drawn = picture(CATALOGUE[id], values)
    assert drawn is not None
    points = {round(x, 9): y for x, y in drawn.lines[0]}
    assert {x: pytest.approx(points[x]) for x in expected} == expected


def test_what_remembers_is_drawn_as_a_loop() -> None:
    drawn = picture(CATALOGUE["presliding_hysteresis"], {"level": 3.0, "stiffness": 300.0, "damping": 0.0})
    assert drawn is not None
    (points,) = drawn.lines
    near = [y for q, y in points[20:] if abs(q) < 0.01]
    assert min(near) < -1.5
    assert max(near) > 1.5


def test_every_public_name_has_its_place() -> None:
    names = [name for _, _, group in python.GROUPS.values() for name in group]
    assert {name for name in names if "." not in name} == set(robodyn.__all__)
    assert len(names) == len(set(names))


@pytest.mark.parametrize(
    ("docstring", "expected"),
    [
        ("One ``a_b`` [n] of :class:`~robodyn.x.Y`.", "One `a_b` &#91;n&#93; of `x.Y`."),
        ("A.\n\nRaises\n------\nE: no\n    such name.", "A.\n\n**Raises**\n\n`E`\n:   no such name."),
        ("Raises\n------\nE: no such\nname.\nF: b.", "**Raises**\n\n`E`\n:   no such name.\n\n`F`\n:   b."),
        ("So::\n\n    a = 1\n    b = 2", "So:\n\n```text\na = 1\nb = 2\n```"),
        (">>> f(1)\n2\n\nThen.", "```pycon\n>>> f(1)\n2\n```\n\nThen."),
        ("a < b\nand *c*", "a &lt; b and &#42;c&#42;"),
    ],
)  # fmt: skip
def test_docstrings_are_markdown(docstring: str, expected: str) -> None:
    assert markdown(docstring) == expected


def test_nothing_in_plain_text_is_markup() -> None:
    assert re.fullmatch(r"[\w &;#]*", plain("a*b_c[d]{e}<f>|g$h`i\\j~k^l"))


@pytest.mark.parametrize(
    ("marked", "expected"),
    [
        (r'<div class="arithmatex">\[a &lt; b\]</div>', '<div class="equation"><math display="block">'),
        (r'<p>so <span class="arithmatex">\(\tau\)</span>.</p>', "<p>so <math><mi>τ</mi></math>.</p>"),
    ],
)
def test_marked_equations_are_typeset(marked: str, expected: str) -> None:
    assert typeset(marked).startswith(expected)
    assert "arithmatex" not in typeset(marked)


@pytest.mark.parametrize("title", FORMATS)
def test_the_page_of_a_format_has_all_that_its_table_has(title: str) -> None:
    lines = [line for line in pages()[f"formats/{title.lower()}.md"].splitlines() if line.startswith("| `")]
    rows = {line.split("`")[1]: line.split(" | ")[1:] for line in lines}
    columns = {"used": 0, "torques": 1, "refused": 1, "none": 2, "silent": 2}
    assert len(rows) == len(table_of(title).rows)
    for path, row in table_of(title).rows.items():
        for name, kind in row.items():
            shown = rows["/".join(path)][columns[kind.kind]]
            assert f"`{name}`" + (f" (`{kind.physics}`)" if kind.physics else "") in shown


def test_the_page_of_formats_has_all_that_is_refused() -> None:
    index = pages()["formats/index.md"]
    assert [name for name in PHYSICS if f"| `{name}` |" not in index] == []


ROOT = Path(__file__).parents[2]
NAV = yaml.safe_load((ROOT / "mkdocs.yml").read_text(encoding="utf-8"))["nav"]


def test_every_page_is_in_the_navigation_once() -> None:
    there = {*navigation.documents(), *pages()}
    assert sorted(navigation.named(navigation.expanded(NAV, there))) == sorted(there)


@pytest.mark.parametrize(
    ("folder", "names"),
    [
        ("commands", COMMANDS),
        ("effects", CATALOGUE),
        ("functions", FUNCTIONS),
        ("targets", TARGETS),
        ("languages", LANGUAGES),
    ],
)
def test_each_has_a_page_that_says_what_it_is(folder: str, names: Iterable[str]) -> None:
    for name in names:
        title, _, text = pages()[f"{folder}/{name}.md"].partition("\n\n")
        assert title.startswith("# ")
        assert re.match(r"[^|#\s-].{20}", text), text[:80]


def test_links_elsewhere_are_whole() -> None:
    """They are not opened here: an address is https, of a host, and without what ends a sentence."""
    texts = [path.read_text(encoding="utf-8") for path in (ROOT / "docs").rglob("*.md")]
    links = re.findall(r"https?:[^\s)>\"'`]*", "\n".join([*texts, *pages().values()]))
    assert links
    for link in links:
        address = urlsplit(link)
        assert address.scheme == "https", link
        assert re.fullmatch(r"[a-z0-9-]+(\.[a-z0-9-]+)+", address.netloc), link
        assert link[-1] not in ".,;:", link


def test_links_work_in_a_checkout() -> None:
    """Pages that only the site has are linked from its first page alone, which is for the site."""
    documents = [*(ROOT / "docs").rglob("*.md"), ROOT / "README.md", ROOT / "CONTRIBUTING.md"]
    for document in documents:
        text = re.sub(
            r"^ *```.*?^ *```", "", document.read_text(encoding="utf-8"), flags=re.MULTILINE | re.DOTALL
        )
        for target in re.findall(r"\]\(([^)#:\s]+)", text):
            if document != ROOT / "docs" / "index.md":
                assert (document.parent / target).exists(), f"{document.relative_to(ROOT)}: {target}"
