"""MuJoCo as a library: without what it prints and the log that it leaves."""

from __future__ import annotations

import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any


@contextmanager
def quiet(mujoco: Any) -> Iterator[None]:
    """Without warnings of MuJoCo, nor the log that it writes of them to the current folder.

    They are of a mass matrix that is near to singular and of settings of models that are attached; a reader
    that hides them says itself what they are about.
    """
    before = mujoco.get_mju_user_warning()
    mujoco.set_mju_user_warning(lambda _: None)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            yield
    finally:
        mujoco.set_mju_user_warning(before)
