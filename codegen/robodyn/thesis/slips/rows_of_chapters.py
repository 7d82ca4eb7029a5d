"""Slips of chapters 1 to 4, in the order of the text. Source: Dhanaraj 1990."""

from __future__ import annotations

from typing import Final

from robodyn.thesis.slips import frames, friction, printed_data, tasks
from robodyn.thesis.slips import recursion_slips as r
from robodyn.thesis.slips.slip import NAME, REFERENCE, Slip, puma, stanford

CHAPTERS: Final = (
    # chapter 1 and 2
    Slip("1.1", "20 times 5 to 10 Hz is 1 to 2 kHz", "100 to 200 Hz", printed_data.sampling),
    Slip(
        "Table 1.1",
        "Uicker and Kahn: 66,271 multiplications for six joints",
        "67,143",
        printed_data.polynomial,
    ),
    Slip(
        "Eqs 2.1, 2.2",
        "turns and shifts about X_i and Z_(i-1)",
        "about X_(i-1) and Z_i",
        frames.axes_of_the_moves,
    ),
    Slip(
        "Tables 2.1, 2.2, heads",
        "the column of joint angles has the index i-1",
        "theta_i",
        "the head of a column",
    ),
    Slip(
        "Table 2.2, link 3", "alpha 0, theta pi/2", "alpha pi/2, theta 0", stanford(r.TwistAndAngleExchanged)
    ),
    Slip("Table 2.2, link 4", "q3 is in row 4", "in row 3, the slide's own", stanford(r.SlideInNextRow)),
    Slip("Eq 2.4", "entry (1,4) is -a", "+a_(i-1)", frames.sign_of_a),
    Slip(
        "Eqs 2.7, 2.18",
        "upper and lower indices exchanged",
        "T_1^0 T_2^1 ...",
        "names of transforms, whose order is right",
    ),
    Slip(
        "Eqs 2.22, 2.24, Table 2.3, B.10 to B.15",
        "w x w x r without brackets, which is 0 from the left",
        "w x (w x r)",
        puma(r.Unbracketed),
    ),
    Slip("Eqs 2.25, 2.27, (3,1)", "begins with w_x w_x", "w_x w_z", puma(r.SquareIn31)),
    Slip("Eqs 2.25, 2.27, index", "OP", "PO", NAME),
    Slip("before Eq 2.29", "steps 5 and 6", "steps 3 and 4", REFERENCE),
    Slip("Eqs 2.29, 2.38, 2.39", "R lambda R^T", "R^T lambda R", stanford(r.CarriedForth)),
    Slip("Eqs 2.30, 2.31", "(2,1) has - alpha_z", "+ alpha_z", puma(r.MinusIn21)),
    Slip("Eq 2.36", "(2,1) has + alpha_2y", "- alpha_2y", frames.entry_of_36),
    Slip(
        "Eq 2.37",
        "-l13, l12, -l31, l21 at (1,2), (1,3), (2,1), (3,1)",
        "l13, -l12, l31, -l21",
        stanford(r.SignsOf37),
    ),
    Slip("Eq 2.38, (2,2)", "l33", "l22", stanford(r.MiddleOf38)),
    Slip("Eq 2.41", "I alpha + D k with products of inertia", "the same", frames.gyroscopic_moment),
    Slip("Table 2.3, step 9", "the torque is n_x", "n_z", puma(r.MomentAboutX)),
    Slip(
        "Table 2.3, boxes",
        "numbers of steps 3, 4 and 6; the text has box 6 in step 4",
        "those of the figure",
        "numbers of boxes in a drawing",
    ),
    Slip(
        "Table 2.4, step 2A, revolute",
        "lambda_21 = k_x + alpha_x",
        "lambda_21 = k_z + alpha_z",
        puma(r.XIn21),
    ),
    Slip("Table 2.4, step 2A, prismatic", "R lambda R^T", "R^T lambda R", stanford(r.CarriedForth)),
    Slip("Table 2.4, step 6", "D_x = Ixx - Iyy", "Izz - Iyy", puma(r.OtherDx)),
    Slip(
        "Table 2.4, step 8; Eq 4.15",
        "f_(i+1) along the axes of link i and along its own has one name",
        "a superscript i where it is along those of link i",
        puma(r.ForceAlongItsOwnAxes),
    ),
    Slip(
        "Table 2.4, step 9, prismatic",
        "n_z for every joint",
        "f_z for a prismatic one",
        stanford(r.MomentOfSlide),
    ),
    Slip(
        "Table 2.6, links 5, 6",
        "moments of 3e-3 3e-3 4e-3 and 1.5e-3 1.5e-3 4e-4 kg m^2",
        "a tenth of it",
        printed_data.tenfold_inertias,
    ),
    Slip(
        "Table 2.7, link 3", "z = 0.6447 m", "-0.6447, the programs' frame", printed_data.sign_of_z_of_link_3
    ),
    Slip("Table 2.9, revolute II", "123 additions", "113", printed_data.additions_of_a_joint),
    # chapter 3
    Slip("Eq 3.3", "n_x and n_y with equal signs in a root", "opposite signs", friction.journal_bearing),
    Slip("Eq 3.4", "a torque and the sign of an angle's rate, for a slide", "a force and sgn(qd)", NAME),
    Slip("Eq 3.5", "mu r |f_x|", "|f_z|, as Table 3.1 has it", friction.thrust_bearing),
    Slip("Eq 3.7", "subtracts a friction that has its sign", "Eq 3.6 always", friction.sign_rule),
    Slip(
        "Eq 3.11",
        "tau_out / eta without the ratio m of Eqs 3.8 and 3.10",
        "tau_out / (m eta), or all on the output side",
        friction.ratio,
    ),
    Slip(
        "Eqs 3.10, 3.11",
        "eta is the whole ratio of powers, and breakaway is added besides",
        "one of the two",
        friction.efficiency_and_breakaway,
    ),
    Slip("Table 3.3", "5 additions in Eq 3.3", "7", printed_data.additions_of_friction),
    # chapter 4
    Slip("Table 4.1, T4, T5", "after T_0 of the link before", "T6", tasks.before_alpha),
    Slip(
        "Table 4.1, T10",
        "x and z exchanged",
        "lambda_21 = k_z + alpha_z, lambda_32 = k_x + alpha_x",
        puma(r.ExchangedT10),
    ),
    Slip("Table 4.1, T20 to T22", "products of lambda and g", "lambda and s", puma(r.GravityAsCentre)),
    Slip("Table 4.1, T41 to T43", "after T40 to T40", "T33 to T40", tasks.moments_before_products),
    Slip("Eqs 4.3, 4.5", "R^T under the name of R", "R", puma(r.Transposed)),
    Slip("Eq 4.4", "R with its second column negated", "R^T", frames.sign_in_4_4),
    Slip("Eq 4.4, free component", "y of R^T u costs nothing", "z does", frames.free_component),
    Slip("Eq 4.19", "a rotation of determinant -1", "one sign turned", frames.determinant_in_4_19),
    Slip(
        "Table 4.4", "25 components are zero", "26, z of s_5 is zero", printed_data.zeros_of_the_stanford_arm
    ),
    Slip(
        "Table 4.5, caption", "tasks eliminated", "tasks still executed", printed_data.eliminated_or_executed
    ),
    Slip("Table 4.6, step 3", "judged by p_i", "by p_(i-1)", printed_data.origin_of_step_3),
    Slip("Table 4.6, link 2", "10 tasks", "12 are listed", printed_data.tasks_of_link_2),
)
