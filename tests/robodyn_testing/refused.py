"""What changes torques and is not modelled is refused, and left out where it is named."""

from __future__ import annotations

from pathlib import Path

import pytest

from robodyn import InputError, load
from robodyn.formats.tree import PHYSICS


def check_is_refused(file: Path, name: str) -> None:
    """The ``file`` is refused by that name of what it states, with exit code 2, until it is left out."""
    with pytest.raises(InputError, match=f"not modelled: {name}: ") as raised:
        load(file)
    assert (raised.value.exit_code, raised.value.remedy) == (2, f"leave it out: --without {name}")
    remarks: list[str] = []
    load(file, without=[name], warn=remarks.append)
    words = f"left out, although it changes torques: {name}: {PHYSICS[name]}"
    assert any(words in remark for remark in remarks)
