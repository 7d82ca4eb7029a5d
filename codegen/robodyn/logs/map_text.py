"""A map as the YAML text of a file, with what was thought in its comments."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction

from robodyn.logs.mapping import GROUPS, Channel, LogMap

_PLAIN = re.compile(r"[A-Za-z_/][A-Za-z0-9_./%:+-]*(?<!:)\Z")
_WORDS = {"null", "true", "false", "yes", "no", "on", "off", "y", "n"}


def map_text(
    mapping: LogMap, reasons: Mapping[str, str], missing: Sequence[str] = (), title: str = ""
) -> str:
    """The text of ``mapping``, ``reasons`` beside its groups; it reads back as the same map."""
    lines = [f"# {line}" for line in title.splitlines()]
    if mapping.topic:
        lines.append(f"topic: {quoted(mapping.topic)}")
    if mapping.joints:
        lines.append(
            f"joints: [{', '.join(map(quoted, mapping.joints))}]{_comment(reasons.get('joints', ''))}"
        )
    for group in GROUPS:
        if group in mapping.groups:
            lines.append(f"{group}: {_channel(mapping.groups[group])}{_comment(reasons.get(group, ''))}")
        elif group in missing:
            wanted = "{rate: 100}   # Hz: the file has no times" if group == "t" else "NAME_%d[UNIT]"
            lines.append(f"# {group}: {wanted}   <- write this")
        elif group in reasons:
            lines.append(f"# {group}: {reasons[group]}")
    if mapping.conditions:
        lines.append("conditions:")
        lines += [f"  {quoted(name)}: {_channel(channel)}" for name, channel in mapping.conditions.items()]
    return "\n".join(lines) + "\n"


def quoted(text: str) -> str:
    """``text`` as a word of YAML, in quotes where it needs them."""
    if _PLAIN.match(text) and text.lower() not in _WORDS:
        return text
    if text.isprintable():
        return "'" + text.replace("'", "''") + "'"
    return '"' + text.encode("unicode_escape").decode().replace('"', '\\"') + '"'


def _comment(text: str) -> str:
    return f"   # {text}" if text else ""


def _channel(channel: Channel) -> str:
    """A channel in flow style."""
    if channel.rate is not None:
        return f"{{rate: {_value(channel.rate)}}}"
    if len(channel.columns) == 1 and not channel.joints:
        columns = quoted(channel.columns[0])
    else:
        columns = f"[{', '.join(quoted(name) if name else 'null' for name in channel.columns)}]"
    parts = [f"columns: {columns}", *_more(channel)]
    return f"{{{', '.join(parts)}}}"


def _more(channel: Channel) -> Iterator[str]:
    if channel.unit:
        yield f"unit: {quoted(channel.unit)}"
    if channel.joints:
        yield f"joints: [{', '.join(map(str, channel.joints))}]"
    if channel.file:
        yield f"file: {quoted(channel.file)}"
    for key, values in channel.numbers.items():
        listed = ", ".join(map(_value, values))
        yield f"{key}: {listed}" if len(values) == 1 else f"{key}: [{listed}]"
    for key in sorted(channel.of_robot):
        yield f"{key}: robot"


def _value(value: Fraction) -> str:
    return str(value) if value.denominator == 1 else f"{value.numerator}/{value.denominator}"
