"""HTML and SVG: whatever their templates print is escaped, and shows what cannot be seen."""

from __future__ import annotations

import base64
import hashlib
import json
import re
from collections.abc import Sequence
from functools import cache
from typing import TYPE_CHECKING, Any, Final

from markupsafe import Markup

from robodyn.emit.render import environment
from robodyn.robot.names import is_unprintable

if TYPE_CHECKING:
    import jinja2


@cache
def markup_template(name: str) -> jinja2.Template:
    """The template ``report/name``, of HTML or SVG."""
    return environment().overlay(autoescape=True, finalize=_visible).get_template(f"report/{name}")


def script_template(name: str) -> jinja2.Template:
    """The template ``report/name``, of a script, which is not escaped."""
    return environment().get_template(f"report/{name}")


def _visible(value: Any) -> Any:
    """``value``; a text with a mark for each character that XML forbids or that nobody sees."""
    if not isinstance(value, str) or value.replace("\n", "").replace("\t", "").isprintable():
        return value
    return type(value)("".join("\ufffd" if is_unprintable(c) and c not in "\t\n" else c for c in value))


#: What begins or ends an element of HTML within a script.
_MARKUP: Final = re.compile(r"<(?=/|!--|script)", re.IGNORECASE)


def json_text(value: Any) -> Markup:
    """``value`` as JSON that may stand in a ``script`` element: no sign in it ends or opens one."""
    text = json.dumps(value, ensure_ascii=True, allow_nan=False, separators=(",", ":"))
    for sign in "<>&":
        text = text.replace(sign, f"\\u{ord(sign):04x}")
    return Markup(text)


def script_text(text: str) -> Markup:
    """A script, whose comments may hold anything, for a ``script`` element."""
    return Markup(_MARKUP.sub(r"<\\", text))


def policy(scripts: Sequence[str]) -> str:
    """What a browser may do with the page: run these ``scripts``, and load nothing."""
    hashes = " ".join(
        f"'sha256-{base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()}'"
        for script in scripts
    )
    return f"default-src 'none'; script-src {hashes}; style-src 'unsafe-inline'; img-src data:"
