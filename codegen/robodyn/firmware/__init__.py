"""A folder that drops into a firmware build: kernel, self-test, bare-metal image, and what they measure.

>>> made = generate(load("puma560"), firmware_options(Options(), ("cortex-m4f",)))       # doctest: +SKIP
>>> firmware(made, targets_named(["cortex-m4f"])).files          # {"puma560.c": ..., "link.ld": ...}
"""

from robodyn.firmware.files import Folder, firmware
from robodyn.firmware.measure import Figures, measure
from robodyn.firmware.options import check_firmware, firmware_options, targets_named

__all__ = [
    "Figures",
    "Folder",
    "check_firmware",
    "firmware",
    "firmware_options",
    "measure",
    "targets_named",
]
