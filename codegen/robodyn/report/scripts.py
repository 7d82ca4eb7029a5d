"""Scripts and data within pages: they stand in the HTML, and the page's own policy names the scripts by their
hashes, so that no browser runs anything else."""

from __future__ import annotations

import base64
import hashlib
import json
import re
from collections.abc import Sequence
from typing import Any, Final

from markupsafe import Markup

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
