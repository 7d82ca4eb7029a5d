"""The slips in the thesis's equations and printed data.

In words, since the thesis itself is not part of robodyn; only figures are as printed. What cannot be computed
(a reference, a caption, a name) says why. Source: Dhanaraj 1990; the slips were found by robodyn's authors on
a scan of its text, so that a wrong letter may be the scan's where no figure decides.
"""

from __future__ import annotations

from typing import Final

from robodyn.thesis.slips.rows_of_appendices import APPENDICES
from robodyn.thesis.slips.rows_of_chapters import CHAPTERS
from robodyn.thesis.slips.slip import REFERENCE, Slip

SLIPS: Final = (
    *CHAPTERS,
    *APPENDICES,
    # references
    Slip(
        "section 2, references",
        "lambda in Table 2.2; Table 2.1; Denavit and Hartenberg in Appendix A; Table 2.3 called modified; "
        "chapter 3, twice",
        "Tables 2.4, 2.3, 2.2, 2.4; chapter 2",
        REFERENCE,
    ),
    Slip(
        "section 3, references",
        "Tables 2, 5, 6; Figures 3.13 to 3.15",
        "Tables 2.4, 3.1, 3.2; Figures 3.11 to 3.13",
        REFERENCE,
    ),
    Slip(
        "section 4 and C, references",
        "Tables 4.4, 4.7, 4.8, 4.9, 4.2",
        "Tables 4.3, 4.6, 4.7, 4.7, 4.1",
        REFERENCE,
    ),
)
