"""The page of an arm in a real browser: offline, quiet, right to the bits of the C, quick, usable by keys."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from report.test_arm_data import RUBBING
from robodyn import compile as compile_robot
from robodyn.compare.robots import compare
from robodyn.report.arm_data import arm_of
from robodyn.report.arm_page import page
from robodyn.robot import Robot, bundled_names, load, read_text
from robodyn_testing import representative, require_module, require_tool
from robodyn_testing.browser import Browser

pytestmark = pytest.mark.thorough

RUBBING_ARM = "rubbing"
NAMES = (*bundled_names(), RUBBING_ARM)
PAIR = ("puma560", "puma560_full")

#: Sets the sliders, and the rates, as a hand does, and hands back all torques once they are shown.
SET = """
const [q, qd, qdd] = arguments[0], done = arguments[arguments.length - 1];
const put = (selector, values) => document.querySelectorAll(selector).forEach((input, j) => {
    input.value = values[j];
    input.dispatchEvent(new Event("input", { bubbles: true }));
});
put("input[data-q]", q); put("input[data-qd]", qd); put("input[data-qdd]", qdd);
requestAnimationFrame(() => requestAnimationFrame(() => done(robodyn.arms.map(arm => ({
    state: robodyn.panel.read(), torque: [...arm.torque], gravity: [...arm.gravity], mass: [...arm.mass],
    jacobian: [...arm.jacobian],
    shown: [...document.querySelectorAll("[data-torque]")].map(e => e.textContent),
})))));
"""


def robot(name: str) -> Robot:
    if name == RUBBING_ARM:
        return read_text(RUBBING, warn=lambda _: None)
    return load(name, warn=lambda _: None)


class Pages(dict[str, Path]):
    """Pages by the arm's name, made when they are asked for; "two": a page of two arms."""

    def __init__(self, folder: Path) -> None:
        super().__init__()
        self.folder = folder

    def __missing__(self, name: str) -> Path:
        arms = [arm_of(robot(one)) for one in (PAIR if name == "two" else (name,))]
        comparison = compare(arms[0].robot, arms[1].robot).to_dict() if name == "two" else None
        self[name] = self.folder / f"{name}.html"
        self[name].write_text(page(arms, comparison), encoding="utf-8")
        return self[name]


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory) -> Pages:
    return Pages(tmp_path_factory.mktemp("arms"))


def moved(browser: Browser, *state: list[float]) -> list[dict[str, Any]]:
    arms: list[dict[str, Any]] = browser.driver.execute_async_script(SET, state)
    return arms


@pytest.mark.parametrize("name", representative(bundled_names(), "stanford", "panda", "tx40", rest="slow"))
def test_sliders_give_the_torques_of_the_c(browser: Browser, files: Pages, name: str) -> None:
    """Within 1e-12 of the largest; the same bits, in fact, with the same sine."""
    browser.open(files[name])
    arm = robot(name)
    kernel = compile_robot(
        arm, functions=["inverse_dynamics", "gravity", "mass_matrix", "jacobian"], trig="builtin",
        cc=require_tool("gcc"), mode="abi",
    )  # fmt: skip
    rng = np.random.default_rng(8)
    for _ in range(3):
        (seen,) = moved(browser, *(rng.uniform(-2, 2, arm.n).tolist() for _ in range(3)))
        q, qd, qdd = map(np.array, seen["state"])
        assert np.ptp(q) > 0
        expected = kernel.inverse_dynamics(q, qd, qdd)
        assert np.abs(np.array(seen["torque"]) - expected).max() <= 1e-12 * max(1.0, np.abs(expected).max())
        assert seen["torque"] == expected.tolist()
        assert seen["gravity"] == kernel.gravity(q).tolist()
        assert seen["mass"] == kernel.mass_matrix(q).ravel().tolist()
        assert seen["jacobian"] == kernel.jacobian(q).ravel().tolist()
        shown = [float(text.replace("−", "-")) for text in seen["shown"]]
        np.testing.assert_allclose(shown, expected, rtol=1e-2, atol=1e-2 * np.abs(expected).max())


def test_two_arms_are_moved_alike(browser: Browser, files: Pages) -> None:
    browser.open(files["two"])
    assert browser.run("return document.scripts.length") == 4
    q = [0.3, -0.4, 0.5, 0.1, -0.2, 0.6]
    for seen, name in zip(moved(browser, q, [0.0] * 6, [0.0] * 6), PAIR, strict=True):
        kernel = compile_robot(
            robot(name), functions=["gravity"], trig="builtin", cc=require_tool("gcc"), mode="abi"
        )
        assert seen["gravity"] == kernel.gravity(np.array(seen["state"][0])).tolist()
    assert len(browser.all("#differences ~ .scroll tbody tr")) > 5


def test_a_drag_turns_it_and_draws_once_a_frame(browser: Browser, files: Pages) -> None:
    """However many events come: benchmarks/pages.py measures what a frame takes."""
    browser.open(files["panda"])
    actions = require_module("selenium.webdriver").ActionChains(browser.driver)
    start = browser.run("return robodyn.scene.view.yaw")
    actions.click_and_hold(browser.one("canvas")).move_by_offset(60, 10).release().perform()
    assert browser.run("return robodyn.scene.view.yaw") == pytest.approx(start - 0.48, abs=0.02)
    frames = browser.driver.execute_async_script(
        "const done = arguments[0], before = robodyn.shares.frames;"
        "requestAnimationFrame(() => {"
        "  for (let k = 0; k < 50; ++k) robodyn.turn(0.01, 0);"
        "  requestAnimationFrame(() => requestAnimationFrame(() => done(robodyn.shares.frames - before)));"
        "});"
    )
    assert 1 <= frames <= 3


def test_the_motion_is_played(browser: Browser, files: Pages) -> None:
    """What remembers is carried from frame to frame; sliders, clock and curves follow."""
    browser.open(files[RUBBING_ARM])
    before = browser.run("return robodyn.panel.read()[0]")
    browser.one("[data-play]").click()
    browser.driver.execute_async_script(
        "const done = arguments[0];"
        "const wait = () => robodyn.motion.time > 0.3 ? done() : setTimeout(wait, 20); wait();"
    )
    assert browser.one("[data-play]").get_attribute("aria-pressed") == "true"
    browser.one("[data-play]").click()
    assert browser.one("[data-play]").text == "Play"
    assert browser.run("return robodyn.panel.read()[0]") != before
    assert browser.run("return Number(document.querySelector('input[data-time]').value)") > 0.3
    assert browser.run("return document.querySelectorAll('line.now[x1]').length") == 3
    browser.one("[data-home]").click()
    browser.driver.execute_async_script("requestAnimationFrame(() => requestAnimationFrame(arguments[0]))")
    assert browser.run("return robodyn.panel.read()[0]") == before


def test_it_is_used_by_keys(browser: Browser, files: Pages) -> None:
    """Tab comes to the drawing and to every control; arrows turn and move."""
    keys = require_module("selenium.webdriver.common.keys").Keys
    browser.open(files["puma560"])
    view = "return [robodyn.scene.view.yaw, robodyn.scene.view.pitch, robodyn.scene.view.zoom]"
    start = browser.run(view)
    canvas = browser.one("canvas")
    canvas.send_keys(keys.ARROW_LEFT, keys.ARROW_UP, "+")
    assert all(a != b for a, b in zip(browser.run(view), start, strict=True))
    canvas.send_keys("0")
    assert browser.run(view) == start
    slider = browser.one("#q1")
    slider.send_keys(keys.END)
    assert float(slider.get_attribute("value")) == pytest.approx(np.pi, abs=1e-3)
    assert slider.get_attribute("aria-valuetext") == "180.0 degrees"
    stops = set()
    browser.one("nav a").click()
    for _ in range(30):
        browser.driver.switch_to.active_element.send_keys(keys.TAB)
        stops.add(browser.run("const e = document.activeElement; return e.id || e.dataset.view || e.tagName"))
    assert {"q0", "q5", "reset", "nearer", "SUMMARY"} <= stops
