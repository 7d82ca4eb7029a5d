"""What is said of public robot files: how each is judged, and that the committed table is of the figures."""

from __future__ import annotations

import json
import zipfile
from pathlib import Path

from benchmarks.public_files import RESULTS, measured, table

from robodyn_testing import require_module
from robodyn_testing.original_arms import MJCF, URDF
from robodyn_testing.urdf_text import GRIPPER, joint, link, robot

FIGURES = json.loads(RESULTS.read_text(encoding="utf-8"))
RECORDS = FIGURES["files"]


def judged(folder: Path, files: dict[str, str]) -> dict[str, str]:
    """The verdicts on ``files`` in a package, by name."""
    for name in ("mujoco", "pinocchio", "xacro"):
        require_module(name)
    with zipfile.ZipFile(folder / "arms-1.0-py3-none-any.whl", "w") as archive:
        for name, text in files.items():
            archive.writestr(name, text)
    records = list(measured(list(folder.glob("*.whl")), ""))
    assert {(record["package"], record["version"]) for record in records} == {("arms", "1.0")}
    table({"libraries": ["none"], "files": records})
    return {record["file"]: record["verdict"] for record in records}


def test_every_kind_of_verdict(tmp_path: Path) -> None:
    follower = joint("j", "l0", "l1", inside='<mimic joint="nobody"/>')
    files = {
        "a.urdf": URDF,
        "a.xml": MJCF,
        "gripper.urdf": GRIPPER,
        "follower.urdf": robot(link("l0"), link("l1"), follower),
        "air.xml": MJCF.replace("<option", '<option density="1.2"'),
        "thing.urdf": robot(link("cube"), link("lid"), joint("j", "cube", "lid", "fixed")),
        "stone.urdf": robot(link("stone")),  # without a joint it is not asked for
        "strange.xml": "<mujoco><worldbody><body><joint/><geom/></body></worldbody></mujoco>",
        "notes.xml": "<notes/>",
    }
    assert judged(tmp_path, files) == {
        "a.urdf": "right",
        "a.xml": "right",
        "gripper.urdf": "not compared",  # Pinocchio refuses limits without an effort
        "follower.urdf": "refused",
        "air.xml": "refused",
        "thing.urdf": "no arm",
        "strange.xml": "refused",
    }


def test_none_of_the_public_files_is_wrong() -> None:
    assert [record["file"] for record in RECORDS if record["verdict"] == "wrong"] == []
    for form, least in (("MJCF", 45), ("URDF", 200)):
        right = [record for record in RECORDS if (record["format"], record["verdict"]) == (form, "right")]
        assert len(right) >= least
    ur = [
        record for record in RECORDS if "/ur_description/" in record["file"] or "/arms/ur" in record["file"]
    ]
    assert {record["verdict"] for record in ur} == {"right"}


def test_the_table_is_that_of_the_figures() -> None:
    assert RESULTS.with_suffix(".md").read_text(encoding="utf-8") == table(FIGURES)
