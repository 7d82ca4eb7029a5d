"""HTML and SVG: whatever their templates print is escaped, and shows what cannot be seen."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING, Any

from robodyn.emit.render import environment
from robodyn.robot.names import is_unprintable

if TYPE_CHECKING:
    import jinja2


@cache
def markup_template(name: str) -> jinja2.Template:
    """The template ``report/name``, of HTML or SVG."""
    return environment().overlay(autoescape=True, finalize=_visible).get_template(f"report/{name}")


def _visible(value: Any) -> Any:
    """``value``; a text with a mark for each character that XML forbids or that nobody sees."""
    if not isinstance(value, str) or value.replace("\n", "").replace("\t", "").isprintable():
        return value
    return type(value)("".join("\ufffd" if is_unprintable(c) and c not in "\t\n" else c for c in value))
