"""How sure an identified arm's numbers are goes with it: to the file beside it, and into a diagnosis."""

from __future__ import annotations

import json
from dataclasses import replace
from fractions import Fraction
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from identify.exact import log_of
from robodyn.diagnose.blind.hide import Setup, hide
from robodyn.diagnose.run import diagnose
from robodyn.errors import InputError
from robodyn.fleet.sources.fleet import arm_type
from robodyn.formats.loading import load
from robodyn.identify.known import numbers, spread_of, with_covariance_of, with_covariance_read
from robodyn.identify.run import Identification, identify
from robodyn.robot import read_text
from robodyn.robot.model import EffectEntry, Robot

_NOISE = 0.05


@cache
def guessed() -> Robot:
    """A description with masses that are 20 % too large, known to 30 %."""
    arm = load("puma560_3dof")
    return replace(
        arm,
        links=tuple(
            replace(link, mass=link.mass * Fraction(6, 5), confidence=Fraction(3, 10)) for link in arm.links
        ),
    )


@cache
def outcome() -> Identification:
    return identify(guessed(), [log_of(load("puma560_3dof"), noise=_NOISE)])


def written(folder: Path) -> Robot:
    """The identified arm as it is read from the files that were written."""
    (folder / "arm.yaml").write_text(outcome().model_text)
    (folder / "identify.json").write_text(json.dumps(outcome().to_dict()))
    return load(folder / "arm.yaml")


def shares(robot: Robot) -> np.ndarray:
    return np.ones((robot.n, 10))


def test_the_covariance_is_in_the_file_beside_the_description(tmp_path: Path) -> None:
    arm = written(tmp_path)
    assert arm == outcome().model
    there, here = (spread_of(with_covariance_read(one), shares(arm)) for one in (arm, outcome().model))
    assert there is not None
    assert here is not None
    np.testing.assert_array_equal(there, here)


def test_numbers_are_as_sure_together_as_they_are_off() -> None:
    """Masses are open, what torques show is not: in units of the covariance the true numbers are near."""
    spread = spread_of(outcome().model, shares(guessed()))
    assert spread is not None
    off = numbers(load("puma560_3dof")) - numbers(outcome().model)
    mass = 10 * np.arange(3)
    assert np.abs(off[mass]).max() > 0.1
    far, *_ = np.linalg.lstsq(spread.T, off, rcond=None)
    assert np.sqrt((far**2).mean()) < 2
    assert np.abs(spread.T @ far - off).max() < 1e-3


def test_a_link_that_was_changed_since_is_as_sure_as_is_stated_of_it() -> None:
    arm = outcome().model
    other = replace(arm, links=(*arm.links[:2], replace(arm.links[2], mass=arm.links[2].mass + 1)))
    before, after = spread_of(arm, shares(arm)), spread_of(other, shares(arm))
    assert before is not None
    assert after is not None
    more = np.diag(after.T @ after) - np.diag(before.T @ before)
    np.testing.assert_allclose(more, [*np.zeros(20), *np.ones(10), *np.zeros(3)])


def test_an_arm_that_was_not_identified_has_none() -> None:
    assert spread_of(guessed(), shares(guessed())) is None


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (None, "cannot be read"),
        ("[]", "does not say how sure"),
        ('{"covariance": {"values": [1], "root": [[NaN]]}}', "does not say how sure"),
        ('{"covariance": {"values": [1], "root": [[1]]}}', "of another arm"),
        ("[" * 100_000, "does not say how sure"),
        (f'{{"covariance": {{"values": {[0] * 33}, "root": [{[1e300] * 33}]}}}}', "does not say how sure"),
        (f'{{"covariance": {{"values": [{"9" * 400}], "root": [[1]]}}}}', "does not say how sure"),
        (f'{{"covariance": {{"values": {[0] * 33}, "root": {[[0] * 33] * 34}}}}}', "of another arm"),
    ],
)
@pytest.mark.usefixtures("uncollected")
def test_a_file_that_does_not_say_it_is_refused(tmp_path: Path, text: str | None, words: str) -> None:
    arm = written(tmp_path)
    (tmp_path / "identify.json").unlink()
    if text is not None:
        (tmp_path / "identify.json").write_text(text)
    with pytest.raises(InputError, match=words) as caught:
        with_covariance_read(arm)
    assert caught.value.where is not None
    assert caught.value.where.file.endswith("identify.json")


def test_a_description_without_a_path_has_no_file_beside_it(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="stands in a file beside its description"):
        with_covariance_read(replace(written(tmp_path), file=None))


def test_a_blind_test_of_an_identified_arm_can_be_diagnosed(tmp_path: Path) -> None:
    setup = Setup(duration=2.0, rate=200.0)
    blind = hide(written(tmp_path), setup=setup, text=outcome().model_text)
    (tmp_path / "blind").mkdir()
    for name, content in blind.files().items():
        if not name.endswith(".csv"):
            data = content.encode() if isinstance(content, str) else content
            (tmp_path / "blind" / name).write_bytes(data)
    given = with_covariance_read(load(tmp_path / "blind/given.yaml"))
    np.testing.assert_array_equal(spread_of(given, shares(given)), spread_of(outcome().model, shares(given)))


def test_a_fleet_of_identified_arms_hands_their_covariance_on(tmp_path: Path) -> None:
    written(tmp_path)
    arm = arm_type("puma", str(tmp_path / "arm.yaml"), None)
    assert arm.covariance is not None
    (tmp_path / "identify.json").unlink()
    there = with_covariance_of(read_text(arm.text), arm.covariance, "puma")
    np.testing.assert_array_equal(spread_of(there, shares(there)), spread_of(outcome().model, shares(there)))


@pytest.mark.parametrize("name", ["../identify.json", "/etc/x.json", "identify.txt", "-.json"])
def test_the_file_lies_beside_the_description(tmp_path: Path, name: str) -> None:
    text = outcome().model_text.replace("covariance: identify.json", f"covariance: {name}")
    (tmp_path / "arm.yaml").write_text(text)
    with pytest.raises(InputError, match="no name of a file beside") as caught:
        load(tmp_path / "arm.yaml")
    assert caught.value.where is not None
    assert caught.value.where.line


@pytest.mark.thorough
def test_a_load_on_an_identified_arm_has_its_name() -> None:
    """Numbers that may be wrong by 30 % explain the load; those that were identified do not."""
    carrying = replace(
        load("puma560_3dof"),
        effects=(EffectEntry("payload", None, (("mass", Fraction(1)), ("com", (Fraction(0),) * 3))),),
    )
    logs = [log_of(carrying, noise=_NOISE, seed=seed) for seed in (5, 6)]
    known = diagnose(outcome().model, logs[:1], logs[1])
    assert [(f.effect, f.confidence > 0.5) for f in known.findings] == [("payload", True)]
    assert "covariance" not in known.model_text
    unknown = diagnose(replace(outcome().model, covariance=None), logs[:1], logs[1])
    assert not [f for f in unknown.findings if f.confidence > 0.5]
