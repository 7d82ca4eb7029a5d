"""How every picture looks: colours, type and lines, for SVG as for matplotlib.

The colours are those of Okabe and Ito, "Color Universal Design" (2008): people who confuse red and green tell
them apart. Text is never coloured, as most of them are too light for it; a stroke beside it says whose it is.
"""

from __future__ import annotations

import textwrap
from typing import Any, Final

BLUE, VERMILION, GREEN = "#0072b2", "#d55e00", "#009e73"
PURPLE, ORANGE, SKY = "#cc79a7", "#e69f00", "#56b4e9"
GREY: Final = "#8b949e"
#: Lines and bars of one panel, in this order.
SERIES: Final = (BLUE, VERMILION, GREEN, PURPLE, ORANGE, SKY, GREY)
#: What is ours, and what it is compared with.
OURS, OTHERS = BLUE, GREY
INK, SOFT, GRID, PAPER = "#1b1f24", "#59626d", "#e0e2e6", "#ffffff"

#: The widest first: what fits in it fits in the others.
FONT: Final = "DejaVu Sans, Verdana, Helvetica, Arial, sans-serif"
#: Sizes in px: text, titles of panels, titles of pictures; and the height of a line of text.
TEXT, TITLE, HEADING, LEADING = 12, 13, 15, 15
#: What is left of a picture's title, and right of it.
MARGIN: Final = 16
#: Widths of lines in px.
LINE, THIN = 2.0, 1.0
DASHES: Final = "6 4"
#: Width of a sign of :data:`FONT` in shares of its size, on average and with some room.
_SIGN: Final = 0.6
#: Inches of a px, and points: matplotlib counts in these.
PX, POINT = 1 / 96, 0.75


def pale(colour: str, share: float = 0.3) -> str:
    """``colour`` mixed with white until ``share`` of it is left: dark text stands out from it."""
    parts = (int(colour[k : k + 2], 16) for k in (1, 3, 5))
    return "#" + "".join(f"{round(255 - share * (255 - part)):02x}" for part in parts)


def text_width(text: str, size: float = TEXT) -> float:
    """About how wide ``text`` is, in px."""
    return _SIGN * size * len(text)


def head_width(title: str, note: str) -> int:
    """How wide a picture is at least, for its ``title`` and ``note``, in px."""
    return round(max(text_width(title, HEADING), text_width(note))) + 2 * MARGIN


def wrapped(text: str, width: float, size: float = TEXT) -> list[str]:
    """Lines of ``text`` of about ``width`` px at most."""
    return textwrap.wrap(text, max(8, int(width / (_SIGN * size)))) or [""]


def matplotlib_settings() -> dict[str, Any]:
    """The same for matplotlib: its ``rcParams``, to be used over its own defaults.

    Text becomes paths of matplotlib's own font, so that the same picture is the same bytes everywhere.
    """
    return {
        "svg.hashsalt": "robodyn", "svg.fonttype": "path",
        "font.family": "DejaVu Sans", "font.size": POINT * TEXT, "text.color": INK,
        "figure.facecolor": PAPER, "figure.titlesize": POINT * HEADING, "figure.titleweight": "bold",
        "axes.titlesize": POINT * TITLE, "axes.titleweight": "bold", "axes.titlelocation": "left",
        "axes.labelcolor": SOFT, "axes.edgecolor": GREY, "axes.linewidth": POINT * THIN,
        "axes.spines.top": False, "axes.spines.right": False,
        "axes.grid": True, "axes.axisbelow": True, "grid.color": GRID, "grid.linewidth": POINT * THIN,
        "xtick.color": GREY, "ytick.color": GREY, "xtick.labelcolor": SOFT, "ytick.labelcolor": SOFT,
        "xtick.labelsize": POINT * TEXT, "ytick.labelsize": POINT * TEXT,
        "lines.linewidth": POINT * LINE, "lines.solid_joinstyle": "round",
    }  # fmt: skip
