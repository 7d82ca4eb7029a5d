"""Numbers that decide in inverse kinematics."""

from __future__ import annotations

from fractions import Fraction

#: Share of an arm's size (and of a unit vector) below which a number of its geometry is the rounding of its
#: description. What is neglected adds less than this to the error of a pose.
NEGLIGIBLE: Fraction = Fraction(1, 10**15)

#: Share of an arm's size [1], and angle [rad], up to which axes meet, or are parallel, for a class to apply.
#: What is neglected adds as much to the error of a pose.
TOLERANCE: float = 1e-12

#: Rounding units by which a square root's argument may be negative, as a share of what it would be where the
#: joint's two positions are a quarter turn from where they meet: such a pose is at the edge of reach and is
#: still reached. As much on the other side a branch is singular: its two positions are within some 5e-7 rad
#: of each other in doubles, 0.01 rad in floats.
EDGE: int = 1024

#: Rounding units, as a share of its largest value, below which a lever is nothing but rounding: what it would
#: turn is free, and takes its position from the reference.
LEVER: int = 64

#: Rounding units, as a share of the squared distance that two links span, up to which they are folded or
#: stretched: about what rounding leaves of that square. With more, an elbow near there is moved so far that
#: what follows may no longer reach the pose, in floats.
FOLD: int = 4

#: Share of an arm's size [1], and angle [rad], up to which axes nearly meet, or are nearly parallel, for the
#: branches of an arm whose axes do to be where those of this one begin.
ALMOST: float = 1e-3

#: Positions at which the redundant joint of an arm is looked at to tell whether the other joints are of a
#: class whatever it does [rad, and for a prismatic joint shares of the arm's size]: no multiples of each
#: other or of a quarter turn.
TRIED: tuple[float, ...] = (0.7371, -1.9083, 2.6119)

#: What is left at least of the Jacobian's last column, those before eliminated (lengths as shares of the
#: arm's size), in some configuration of an arm whose joints move the tool in all directions.
FULL_RANK: float = 1e-6

# --- one joint after another --------------------------------------------------------------------------------

#: At how many positions equations are looked at, drawn at random, and the share of these at which one may be
#: less sensitive than it is counted as. Choices: what counts in an equation does so at almost all positions,
#: so that one would do, and an equation that is little sensitive now and then has another instead.
SAMPLES: int = 12
FEW: float = 0.25

#: What of an equation changes at most where a joint does not count in it [1, and shares of the arm's size]:
#: rounding of some dozen turns is 1e-14, and axes that miss a class by 1e-12 are taken for of it.
BLIND: float = 1e-9

#: How sensitive an equation has to be to the joint that it gives. A choice: a double loses four of 16 digits
#: there, which a step of least squares brings back.
SENSITIVE: float = 1e-4

#: Below what lever [1, and shares of the arm's size] another equation is taken instead, where there is one. A
#: choice: as many digits are lost at most as that has, three.
SHORT: Fraction = Fraction(1, 1 << 10)

#: Rounding units that a pose may be missed by and is still reached, [rad, and shares of the arm's size]: what
#: a joint's position is off where the equation that gives it is little sensitive, others do not make up for.
#: A choice, twice the inverse of SHORT: 4.5e-13 in double.
FIT: int = 2048

# --- damped least squares -----------------------------------------------------------------------------------

#: Iterations at most. Of reachable poses that are reached at all nearly all take fewer than half.
ITERATIONS: int = 40

#: Iterations at most where they begin at a branch of a similar arm: 4 or 5, more near where branches meet.
REFINEMENTS: int = 20

#: The error (as a share of the size, and in rad) up to which such a branch is begun: where it is more it does
#: not exist, and steps would lead to another one.
BEGUN: Fraction = Fraction(1, 8)

#: How far aside of where two branches meet each begins [rad, and shares of the arm's size].
ASIDE: Fraction = Fraction(1, 40)

#: How far beside a pose's positions the reference is at most of which is claimed that steps lead to the pose
#: [rad or m], where joints hardly move the tool in a direction: by some micrometres, as axes miss.
WEAK_NEAR: Fraction = Fraction(1, 1 << 18)

#: From how many positions it begins where the reference does not lead to a pose and there is time.
STARTS: int = 24

#: The damping [1] by the squared error to begin with: half over its root is the longest step, in a norm in
#: which radians and shares of the arm's size weigh alike. What it is multiplied by after a step that lowers
#: the error, down to the least, and after one that does not.
DAMPED: Fraction = Fraction(1, 8)
EASED: Fraction = Fraction(1, 2)
LEAST_DAMPED: Fraction = Fraction(1, 64)
SHARPENED: Fraction = Fraction(4)

#: What of a step is tried next where it does not lower the error, and how often in a row until that is given
#: up.
SHORTENED: Fraction = Fraction(1, 2)
MOST_REFUSED: int = 12

#: Rounding units: the damping at least, for pivots to be positive; the error (as a share of the size, and in
#: rad) at which a pose is reached so well that no step can do better; and that at which a step that does
#: worse is rounding.
REGULAR: int = 64
SOLVED: int = 8
NEARLY: int = 64

#: The squared error before the first step: more than any.
FURTHEST: Fraction = Fraction(1 << 100)
