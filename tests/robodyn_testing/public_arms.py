"""Where the arms of public packages lie: those that the extra ``arms`` of pyproject.toml brings."""

from __future__ import annotations

import importlib.metadata
from pathlib import Path
from typing import Final

from robodyn_testing.wanted import require_distribution

_ERD, _RTB = "example-robot-data", "rtb-data"
_FOLDERS: Final = {_ERD: "cmeel.prefix/share/example-robot-data/robots", _RTB: "rtbdata"}
_OF_ERD: Final = """
ur_description/urdf/ur3_robot.urdf ur_description/urdf/ur3_gripper.urdf ur_description/urdf/ur5_robot.urdf
ur_description/urdf/ur5_gripper.urdf ur_description/urdf/ur10_robot.urdf panda_description/urdf/panda.urdf
kinova_description/robots/kinova.urdf xarm_description/urdf/xarm7.urdf z1_description/urdf/z1.urdf
b1_description/urdf/b1-z1.urdf so_arm_description/urdf/so100.urdf so_arm_description/urdf/so101.urdf
talos_data/robots/talos_left_arm.urdf talos_data/robots/talos_reduced.urdf
tiago_description/robots/tiago.urdf tiago_description/robots/tiago_dual.urdf
tiago_pro_description/robots/tiago_pro.urdf baxter_description/urdf/baxter.urdf
pr2_description/urdf/pr2.urdf romeo_description/urdf/romeo.urdf centauro_description/urdf/centauro.urdf
anymal_b_simple_description/robots/anymal-kinova.urdf icub_description/robots/icub.urdf
human_description/robots/human.urdf g1_description/urdf/g1_29dof_with_hand_rev_1_0.urdf
alex_description/urdf/alex_sake_hands.urdf simple_humanoid_description/urdf/simple_humanoid.urdf
borinot_description/urdf/borinot_flying_arm_2.urdf hextilt_description/urdf/hextilt_flying_arm_5.urdf
allegro_hand_description/urdf/allegro_left_hand.urdf finger_edu_description/robots/finger_edu.urdf
double_pendulum_description/urdf/double_pendulum.urdf asr_twodof_description/urdf/TwoDofs.urdf
"""
_OF_RTB: Final = """
xacro/abb_irb140_description/urdf/irb140.urdf xacro/kuka_description/kuka_kr16/urdf/kr16_2.urdf
xacro/kuka_description/kuka_kr120/urdf/kr120r2500pro.urdf
xacro/kuka_description/kuka_kr210/urdf/kr210l150.urdf
xacro/kuka_description/kuka_lbr_iiwa/urdf/lbr_iiwa_14_r820.urdf
xacro/lynxmotion_al5d_description/urdf/al5d_robot.urdf
xacro/unimation_puma560_description/urdf/puma560_robot.urdf.xacro
xacro/qut_frankie_description/robots/panda_arm_hand.urdf.xacro
armer_xarm/data/xacro/robots/xarm6/xarm6.xacro xacro/trossen_descriptions/urdf/px100.urdf.xacro
xacro/trossen_descriptions/urdf/px150.urdf.xacro xacro/trossen_descriptions/urdf/rx150.urdf.xacro
xacro/trossen_descriptions/urdf/rx200.urdf.xacro xacro/trossen_descriptions/urdf/vx250.urdf.xacro
xacro/trossen_descriptions/urdf/vx300.urdf.xacro xacro/trossen_descriptions/urdf/vx300s.urdf.xacro
xacro/trossen_descriptions/urdf/wx200.urdf.xacro xacro/trossen_descriptions/urdf/wx250.urdf.xacro
xacro/trossen_descriptions/urdf/wx250s.urdf.xacro
"""
#: By package: files with arms, hands and legs of all kinds.
FILES: Final = {_ERD: _OF_ERD.split(), _RTB: _OF_RTB.split()}
#: All of them, as (package, file).
ARMS: Final = tuple((package, file) for package, files in FILES.items() for file in files)


def arm_file(package: str, file: str) -> Path:
    """The path of a file of :data:`ARMS`; without its package the test is skipped (fails in CI)."""
    require_distribution(package)
    return Path(str(importlib.metadata.distribution(package).locate_file(f"{_FOLDERS[package]}/{file}")))
