"""Slips of appendices A, B and D. Source: Dhanaraj 1990."""

from __future__ import annotations

from functools import partial
from typing import Final

from robodyn.thesis.slips import frames, printed_data
from robodyn.thesis.slips import recursion_slips as r
from robodyn.thesis.slips.lagrangian import (
    ClosedForm,
    Recursive3x3,
    Recursive4x4,
    closed_form,
    recursive_3x3,
    recursive_4x4,
)
from robodyn.thesis.slips.recursion import of_recursion
from robodyn.thesis.slips.slip import NAME, Slip, puma, stanford

APPENDICES: Final = (
    # appendix A
    Slip(
        "A.1, first sum", "U_ij J_i U_ik^T", "U_jk J_j U_ji^T", partial(closed_form, ClosedForm(first=True))
    ),
    Slip("A.1, second sum", "J_i", "J_j", partial(closed_form, ClosedForm(second=True))),
    Slip(
        "A.1, gravity",
        "without the centre of mass (read as at the frame's origin)",
        "times r_j",
        partial(closed_form, ClosedForm(weight=True)),
    ),
    Slip(
        "A.2, pseudo-inertia",
        "+I_xy, which is an integral of x y here and a tensor's entry in Eqs 2.21 and 2.41",
        "-I_xy with the tensor's entries",
        partial(recursive_4x4, Recursive4x4(products=True)),
    ),
    Slip(
        "A.2, D_i",
        "the first derivative of T",
        "the second",
        partial(recursive_4x4, Recursive4x4(slower=True)),
    ),
    Slip(
        "A.2, T_(i+1)", "from frame 0", "from frame i", partial(recursive_4x4, Recursive4x4(from_base=True))
    ),
    Slip(
        "A.2, c_i",
        "m_i with T_i (read as m_i T_i r_i)",
        "m_i r_i",
        partial(recursive_4x4, Recursive4x4(turned=True)),
    ),
    Slip(
        "A.3, R_(i+1)", "from frame 0", "from frame i", partial(recursive_3x3, Recursive3x3(from_base=True))
    ),
    Slip("A.3, D_i", "s / m", "m s", partial(recursive_3x3, Recursive3x3(divided=True))),
    Slip("A.3, e_i", "e_(i+1) turned by R", "not turned", partial(recursive_3x3, Recursive3x3(turned=True))),
    Slip(
        "A.3, e_i, last term",
        "s / m r'' (read entry by entry)",
        "m (R'' s)^T",
        partial(recursive_3x3, Recursive3x3(last=True)),
    ),
    Slip(
        "A.3, c_i",
        "without the offset",
        "plus p_i times the mass beyond",
        partial(recursive_3x3, Recursive3x3(at_joint=True)),
    ),
    # appendix B
    Slip("B.3, B.4", "the left sides are omega and alpha", "v and a", NAME),
    Slip("B.5, B.7, words", 'terms "on the left"', "on the right", NAME),
    Slip("B.7, B.9", "alpha_i on the right", "alpha_(i-1)", frames.parent_of_alpha),
    Slip(
        "B.11, B.13",
        "z qdd and the Coriolis acceleration within R^T",
        "outside, along the slide's own axes",
        stanford(r.SlideInside),
    ),
    Slip("B.11, B.13, hats", "hats and dots exchanged", "z^ and d..", NAME),
    # appendix D
    Slip(
        "D.1",
        "programs D.1.1 and D.1.2 are of one arm",
        "each has inertias of its own",
        printed_data.inertia_sets_of_d_1,
    ),
    Slip("D.1.1", "a variable spelt with i for 1, the slip's or the scan's", "dr1", "a name in a program"),
    Slip(
        "D.1.3, comment", "f = 0.4521 m", "0.4318, as the formulas have it", printed_data.forearm_in_comment
    ),
    Slip(
        "D.1.3, offset",
        "0.1270 m",
        "0.1501, as D.1.2 has it, which gets the angles",
        printed_data.offset_of_the_shoulder,
    ),
    Slip("D.1.3, line", "x = 0.3 m", "0.4, by D.4's start", printed_data.x_of_the_line),
    Slip(
        "D.2, LAM1",
        "diag(0, 0, V1^2 - A1)",
        "rows (-V1^2, -A1, 0), (A1, -V1^2, 0), 0",
        puma(r.DiagonalLambda1),
    ),
    Slip(
        "D.2, inertias",
        "about the links' origins, in a recursion that moves them once more",
        "about the centres of mass",
        printed_data.parallel_axes_twice,
    ),
    Slip(
        "D.2, rotors",
        "within the links' Izz",
        "the joint's own acceleration only",
        printed_data.rotors_in_links,
    ),
    Slip("D.2, link 2", "x = -0.068 m", "0.068, as Table 2.5 has it", printed_data.sign_of_x_of_link_2),
    Slip(
        "D.2, links 2, 3",
        "y and z of the centres of mass are left out",
        "Table 2.5",
        printed_data.centres_without_y_and_z,
    ),
    Slip(
        "D.2, link 4",
        "the centre of mass is the origin",
        "z = -0.019, as listing D.3.4 and Table 2.5 have it",
        printed_data.centre_of_link_4,
    ),
    Slip(
        "D.2, names",
        "ALPA and ALPHA, R4 and RR4, PUMTOR and PUNTOR, free symbols",
        "one name each",
        "names in a program, which therefore does not run",
    ),
    Slip(
        "D.3, signs",
        "four signs of lambda_3 as R lambda R^T gives them",
        "as R^T lambda R does",
        stanford(r.CarriedForth),
    ),
    Slip("D.3.1, D.3.2, q3", "in p of the link beyond", "in the slide's own p", stanford(r.SlideInNextRow)),
    Slip(
        "D.3.1, link 3",
        "6.47 kg, the wrist's masses at its centre of mass, its own inertia",
        "the wrist where it is",
        printed_data.wrist_as_a_point,
    ),
    Slip("D.3.2, link 1", "left out", "9.29 kg at y = -0.1165 m", printed_data.link_1_left_out),
    Slip(
        "D.3.3, JF3",
        "the mass of link 3 on the centre's part only",
        "4.8 times the whole",
        partial(of_recursion, r.MassLostInLink3, "puma560_3dof_d3"),
    ),
    Slip("D.3.4, JM3Y", "JM3Z", "JM4Z", "a name that has no value yet where it is read"),
    Slip(
        "D.3, definitions",
        "AV3, KX3, KY3, RZ4, RSY4, RX2, RSZ2, RXM2, RYP2, RZP2 are missing",
        "as the other listings have them",
        "programs that do not run without",
    ),
    Slip(
        "D.4, link 3",
        "16.04 kg in the inertia matrix, 16.05 kg in the bias",
        "one mass, 16.05 by D.1",
        printed_data.masses_of_link_3,
    ),
    Slip(
        "D.4, inertia matrix",
        "rates zero and accelerations zero but one; gravity is not named",
        "gravity zero too, as the program has it",
        printed_data.gravity_in_columns,
    ),
    Slip(
        "D.4, solver",
        "Cholesky's",
        "a general solver; the other routine is Gauss and Jordan's",
        "the name of a method",
    ),
    Slip(
        "D.4, row of the torque",
        "time / 0.01 cut off, in single precision",
        "rounded",
        printed_data.rows_of_torques,
    ),
    Slip(
        "D.4, last step",
        "begins at 2.00 s and reads rows 202 and 203",
        "201 rows there are",
        printed_data.rows_beyond_the_table,
    ),
)
