! stanford_full: Stanford geometry, random full inertias
! Numbers: geometry of Table 2.2 (corrected); inertial parameters drawn at random
! Origin of numbers: geometry: stated by the description
! Origin of numbers: mass, centre of mass, inertia: synthetic (invented, not those of a real arm)
! Origin of numbers: rotor inertia, friction: absent, taken as 0
! Origin of numbers: limits: absent, so without bounds
! Written by robodyn 0.1.0; do not edit, generate again.
! Description: 84b51ffbe87f1ac4bb6e33f59e330781 (a hash of its numbers)
! Options: --optimize record --scalar double --trig libm
!
! Joints, base to tip, in modified Denavit-Hartenberg frames [rad, m]:
!   1  revolute   alpha 0      a 0  d 0       theta q
!   2  revolute   alpha -pi/2  a 0  d 0.1524  theta q
!   3  prismatic  alpha pi/2   a 0  d q       theta 0
!   4  revolute   alpha 0      a 0  d 0       theta q
!   5  revolute   alpha -pi/2  a 0  d 0       theta q
!   6  revolute   alpha pi/2   a 0  d 0       theta q
! Gravity in the base frame: 0.0, 0.0, -9.8 m/s^2
! Arguments, in SI units, joint 1 first:
!   q    joint positions [rad, prismatic m]
!   qd   joint velocities [rad/s, prismatic m/s]
!   qdd  joint accelerations [rad/s^2, prismatic m/s^2]
!   tau  joint torques [N m, prismatic N]
!   M    mass matrix, row by row [kg m^2, kg m, kg]
! Formulation: modified Newton-Euler (lambda matrix) in modified Denavit-Hartenberg frames, on
!   base parameters: fc and nc act at and about the frame's origin, and what of a link's mass
!   makes no difference is moved to its parent.
! Of inverse_dynamics, bias, mass_matrix, forward_dynamics the best program known for these
!   parameters, equal to the recursion without being written like it: robodyn --optimize full,
!   seed 1.
!
! Operations (every binary * is a multiplication, every binary + or - an addition):
!   inverse_dynamics: 200 multiplications, 188 additions = 388; 1 unary minus; 8 sine/cosine
!   gravity: 24 multiplications, 16 additions = 40; 1 unary minus; 8 sine/cosine
!   bias: 184 multiplications, 164 additions = 348; 0 unary minus; 8 sine/cosine
!   mass_matrix: 90 multiplications, 84 additions = 174; 3 unary minus; 8 sine/cosine
!   forward_dynamics: 358 multiplications, 316 additions, 5 divisions = 679; 2 unary minus; 8
!       sine/cosine
module stanford_full_dynamics
  use, intrinsic :: iso_c_binding, only: rk => c_double
  implicit none
  private

  public :: stanford_full_inverse_dynamics
  public :: stanford_full_gravity
  public :: stanford_full_bias
  public :: stanford_full_mass_matrix
  public :: stanford_full_forward_dynamics

contains

  ! torques that give the accelerations qdd
  ! 200 multiplications, 188 additions = 388; 1 unary minus; 8 sine/cosine
  pure subroutine stanford_full_inverse_dynamics(q, qd, qdd, tau) &
      bind(c, name="stanford_full_inverse_dynamics_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(in) :: qdd(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: s2, neg_w2_x, c2, neg_w2_y, lam2_23, neg_ww2_yz, neg_alpha2_x, neg_lam2_13
    real(rk) :: neg_ww3_xy, alpha2_y, ww2_xy, ww2_zz, ww2_yy, lam2_12, neg_lam2_32, ww1_zz
    real(rk) :: neg_lam2_11, neg_lam2_31, neg_lam3_31, c4, s4, neg_w4_x, w4_z, w4_y, alpha4_z
    real(rk) :: neg_ww4_xy, ww4_xx, ww4_zz, ww4_yz, neg_ww4_zx, lam4_21, neg_lam4_22, neg_lam4_12
    real(rk) :: c5, s5, neg_w5_x, w5_z, neg_w5_y, neg_ww5_zx, ww5_xx, ww5_zz, ww5_xy, neg_lam5_22
    real(rk) :: w6_z, c6, s6, neg_a2_z, t1, neg_a3_y, t2, neg_lam2_22, neg_a3_z, nc3_x, neg_a2_x
    real(rk) :: neg_a3_x, neg_a4_y, alpha4_x, alpha5_y, neg_lam5_31, alpha4_y, alpha5_z, lam5_12
    real(rk) :: neg_a4_x, neg_a5_x, lam4_32, lam5_23, t3, neg_lam5_32, neg_lam5_13, t4, t5, t6, t7
    real(rk) :: t8, t9, t10, t11, t12, t13, t14, t15, t16, t17, t18, t19, nc6_z, neg_lam4_31, a5_y
    real(rk) :: lam5_21, ww6_zz, t20, t21, t22, t23, t24, t25, t26, n4_x, lam5_11, t27, t28, t29
    real(rk) :: f3_z, t30, f4_y, t31, lam4_11, neg_f4_x, f3_y, t32, t33, neg_n5_z, n4_y, lam4_13
    real(rk) :: lam4_23, t34, n4_z, t35, neg_f3_x, t36, t37, t38, n1_z, t39, t40, n2_z, t41

    ! sines and cosines of the joint angles
    s2 = sin(q(2))
    ! link 2: angular velocity [rad/s]
    neg_w2_x = s2*qd(1)
    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    ! link 2: angular velocity [rad/s]
    neg_w2_y = qd(1)*c2
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    lam2_23 = s2*qdd(1)
    ! link 2: products of the angular velocity [1/s^2]
    neg_ww2_yz = neg_w2_y*qd(2)
    ! link 2: angular acceleration [rad/s^2]
    neg_alpha2_x = lam2_23 + neg_ww2_yz
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_13 = c2*qdd(1)
    ! link 3: products of the angular velocity [1/s^2]
    neg_ww3_xy = neg_w2_x*qd(2)
    ! link 2: angular acceleration [rad/s^2]
    alpha2_y = neg_ww3_xy - neg_lam2_13
    ! link 2: products of the angular velocity [1/s^2]
    ww2_xy = neg_w2_x*neg_w2_y
    ww2_zz = qd(2)*qd(2)
    ww2_yy = neg_w2_y*neg_w2_y
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    lam2_12 = ww2_xy - qdd(2)
    neg_lam2_32 = neg_ww2_yz + neg_alpha2_x
    ! link 1: products of the angular velocity [1/s^2]
    ww1_zz = qd(1)*qd(1)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_11 = ww2_zz + ww2_yy
    neg_lam2_31 = neg_ww3_xy + alpha2_y
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_31 = ww2_xy + qdd(2)
    ! sines and cosines of the joint angles
    c4 = cos(q(4))
    s4 = sin(q(4))
    ! link 4: angular velocity [rad/s]
    neg_w4_x = neg_w2_x*c4 - qd(2)*s4
    w4_z = neg_w2_y + qd(4)
    w4_y = qd(2)*c4 + neg_w2_x*s4
    ! link 4: angular acceleration [rad/s^2]
    alpha4_z = qdd(4) - alpha2_y
    ! link 4: products of the angular velocity [1/s^2]
    neg_ww4_xy = neg_w4_x*w4_y
    ww4_xx = neg_w4_x*neg_w4_x
    ww4_zz = w4_z*w4_z
    ww4_yz = w4_z*w4_y
    neg_ww4_zx = neg_w4_x*w4_z
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_21 = alpha4_z - neg_ww4_xy
    neg_lam4_22 = ww4_xx + ww4_zz
    neg_lam4_12 = alpha4_z + neg_ww4_xy
    ! sines and cosines of the joint angles
    c5 = cos(q(5))
    s5 = sin(q(5))
    ! link 5: angular velocity [rad/s]
    neg_w5_x = neg_w4_x*c5 + w4_z*s5
    w5_z = w4_y + qd(5)
    neg_w5_y = w4_z*c5 - neg_w4_x*s5
    ! link 5: products of the angular velocity [1/s^2]
    neg_ww5_zx = neg_w5_x*w5_z
    ww5_xx = neg_w5_x*neg_w5_x
    ww5_zz = w5_z*w5_z
    ww5_xy = neg_w5_x*neg_w5_y
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_22 = ww5_xx + ww5_zz
    ! link 6: angular velocity [rad/s]
    w6_z = neg_w5_y + qd(6)
    ! sines and cosines of the joint angles
    c6 = cos(q(6))
    s6 = sin(q(6))
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a2_z = 0.1524_rk*ww1_zz
    t1 = 2.0_rk*qd(3)
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a3_y = neg_a2_z - (neg_lam2_32*q(3) + neg_w2_x*t1)
    t2 = ww2_zz - ww2_yy
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_22 = ww1_zz + t2
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a3_z = 0.1524_rk*lam2_23 - (9.8_rk*c2 - q(3)*neg_lam2_22) - qdd(3)
    ! link 3: moment that turns the link [N m]
    nc3_x = 0.012168751997232599_rk*neg_a3_y - 0.4516316755890639_rk*neg_a3_z
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a2_x = 9.8_rk*s2 + 0.1524_rk*neg_lam2_13
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a3_x = neg_a2_x - (qd(2)*t1 - lam2_12*q(3))
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a4_y = c4*neg_a3_y - s4*neg_a3_x
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = qdd(2)*s4 + (qd(4)*w4_y - neg_alpha2_x*c4)
    ! link 5: angular acceleration [rad/s^2]
    alpha5_y = neg_w5_x*qd(5) - s5*alpha4_x - alpha4_z*c5
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_31 = neg_ww5_zx + alpha5_y
    ! link 4: angular acceleration [rad/s^2]
    alpha4_y = neg_alpha2_x*s4 + (qdd(2)*c4 + neg_w4_x*qd(4))
    ! link 5: angular acceleration [rad/s^2]
    alpha5_z = alpha4_y + qdd(5)
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_12 = ww5_xy - alpha5_z
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a4_x = c4*neg_a3_x + s4*neg_a3_y
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a5_x = c5*neg_a4_x - s5*neg_a3_z
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_32 = ww4_yz + alpha4_x
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_23 = neg_lam4_12*s5 - c5*lam4_32
    t3 = 2.0_rk*w5_z
    neg_lam5_32 = lam5_23 + neg_w5_y*t3
    neg_lam5_13 = neg_ww5_zx - alpha5_y
    t4 = ww5_xx - ww5_zz
    t5 = 0.0625396920897071_rk*c6
    t6 = 0.16255029097038232_rk*c6
    t7 = t5*t6 + 0.3409906449060338_rk
    t8 = 0.0625396920897071_rk*s6
    t9 = t6*t8
    t10 = 62.4559348502784_rk*t7 + (t9 - 21.61434818388583_rk)
    t11 = 0.06483323523282834_rk*s6
    t12 = 18.778467160320414_rk*(t11 + 0.06355169650371038_rk*c6)
    t13 = t7 - 62.4559348502784_rk*t9
    t14 = t13 - 0.6921471349584476_rk
    t15 = neg_lam5_31 - qdd(6)
    t16 = t5 - t11
    t17 = 1.193403445777575_rk*s6 - 1.2174687787169953_rk*c6
    t18 = t8 + 0.06483323523282834_rk*c6
    t19 = qdd(6) + neg_lam5_13
    ! link 6: moment that turns the link [N m]
    nc6_z = t4*t10 - (neg_a4_y*t12 - (t14*t15 + t16*lam5_12)) + (t17*neg_a5_x - t18*neg_lam5_32 + &
        t13*t19)
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam4_31 = neg_ww4_zx + alpha4_y
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_y = c5*neg_a3_z + s5*neg_a4_x
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_21 = ww5_xy + alpha5_z
    ! link 6: products of the angular velocity [1/s^2]
    ww6_zz = w6_z*w6_z
    t20 = 0.28054187970758354_rk*neg_a5_x + (1.1561689763413345_rk*neg_lam5_13 - &
        (0.20245111268601115_rk*neg_lam5_31 - (0.13660343902034475_rk*t4 + &
        0.5911078910549018_rk*neg_a4_y))) + 0.23560176217086468_rk*lam5_12
    t21 = nc6_z - (0.060693211657558095_rk*neg_lam5_32 - t20)
    t22 = 0.17535491873574263_rk*neg_lam5_32 + (t17 + 0.28054187970758354_rk)*a5_y - &
        (0.13660343902034475_rk*lam5_21 - (0.060693211657558095_rk*neg_lam5_31 + t15*t18))
    t23 = lam5_23 - qd(6)*t3
    t24 = ww5_xx - ww6_zz
    t25 = lam5_21 + neg_w5_x*(2.0_rk*qd(6))
    t26 = 0.23560176217086468_rk*(neg_lam4_22 - neg_lam5_22) + (0.6468331423588011_rk*neg_a4_y - &
        t22) - (t13*t23 + (1.1561689763413345_rk*lam5_23 - (t16*(t4 - t24) + t10*t25)))
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = s5*t21 + 0.06784076259315977_rk*neg_lam4_31 + (c5*t26 + &
        0.23523950726161555_rk*(neg_lam2_22 - (neg_lam4_22 - 0.011289042504553535_rk*lam4_21)))
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_11 = t4 - neg_lam4_22
    t27 = neg_lam5_22 - t24
    t28 = 0.28054187970758354_rk*neg_lam5_13 + (0.6468331423588011_rk*lam5_12 + t12*t27) + t17*t19 &
        + 0.5911078910549018_rk*lam5_11
    t29 = 0.6468331423588011_rk*neg_lam5_22 + (0.28054187970758354_rk*lam5_23 + t17*t23 + t12*t25 &
        - 0.5911078910549018_rk*lam5_21)
    ! link 3: force through the joint [N]
    f3_z = s5*t28 - c5*t29 - (0.4516316755890639_rk*lam2_23 + 19.732838668844984_rk*neg_a3_z) - &
        0.9022885982543313_rk*neg_lam4_31 - 0.22200183325724177_rk*(neg_lam3_31 + &
        0.05481374553845334_rk*neg_lam2_22)
    t30 = 0.9022885982543313_rk*lam4_21 - (0.28054187970758354_rk*neg_lam4_22 - &
        0.6468331423588011_rk*neg_lam5_32 - (0.5911078910549018_rk*neg_lam5_31 - t17*(t4 + t27)))
    ! link 4: force through the joint [N]
    f4_y = t30 - t12*t15
    t31 = ww4_xx - ww4_zz
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_11 = t31 - neg_lam2_22
    ! link 4: force through the joint [N]
    neg_f4_x = s5*t29 + c5*t28 - 0.9022885982543313_rk*lam4_11
    ! link 3: force through the joint [N]
    f3_y = 0.012168751997232599_rk*neg_lam2_32 + (c4*f4_y - 19.732838668844984_rk*neg_a3_y - &
        (0.22200183325724177_rk*neg_lam2_31 + (0.4516316755890639_rk*ww1_zz + s4*neg_f4_x)))
    t32 = 0.23560176217086468_rk*neg_lam5_13 + (t18*t24 + (t14*t25 - &
        (0.20245111268601115_rk*lam5_21 - 0.17535491873574263_rk*lam5_12 - t16*t19)))
    t33 = 0.13660343902034475_rk*lam5_23 + (t32 + (0.060693211657558095_rk*(neg_lam5_22 + lam5_11) &
        - a5_y*(t12 - 0.5911078910549018_rk))) + t10*t23
    ! link 5: moment through the joint, about the frame's origin [N m]
    neg_n5_z = 0.6468331423588011_rk*neg_a5_x + t33
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_y = 0.23523950726161555_rk*neg_lam4_12 - (0.002655628796226608_rk*t31 - &
        0.3448462092987837_rk*neg_lam4_31 - 0.06784076259315977_rk*lam4_32 + (neg_n5_z - &
        0.9022885982543313_rk*neg_a3_z))
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_13 = alpha4_y - neg_ww4_zx
    lam4_23 = ww4_yz - alpha4_x
    t34 = 0.06784076259315977_rk*(neg_lam4_22 + lam4_11) - s5*t26 + (0.3448462092987837_rk*lam4_21 &
        - (0.002655628796226608_rk*lam4_23 + 0.9022885982543313_rk*neg_a4_y))
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_z = c5*t21 + 0.23523950726161555_rk*lam4_13 + t34
    t35 = 0.012168751997232599_rk*lam2_12
    ! link 3: force through the joint [N]
    neg_f3_x = 0.22200183325724177_rk*neg_lam2_11 + (t35 + 0.4516316755890639_rk*neg_lam2_13 + &
        (c4*neg_f4_x + 19.732838668844984_rk*neg_a3_x)) + s4*f4_y
    t36 = 0.15279302557916313_rk*t2 + (0.49862309142001715_rk*neg_lam2_32 + &
        0.04911220265093226_rk*neg_lam2_31 + (0.248077550893258_rk*neg_alpha2_x - nc3_x)) - &
        c4*n4_x
    t37 = ww1_zz - neg_lam2_11
    t38 = 0.22200183325724177_rk*neg_a3_y - n4_z - 12.556178777734242_rk*(t35 + &
        0.0359688790342758_rk*neg_a3_x) + 0.07388986205514168_rk*t37 - 0.1524_rk*neg_f3_x
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = s2*(t36 + (0.1524_rk*(0.4848416145350504_rk*neg_lam3_31 - f3_z) + (q(3)*f3_y + &
        s4*n4_y))) + (0.9889371240787524_rk*qdd(1) + c2*(-0.248077550893258_rk*alpha2_y - &
        (0.04911220265093226_rk*neg_lam2_32 + t38)))
    t39 = q(3)*neg_f3_x + (5.4475438357201735_rk*s2 + (0.49862309142001715_rk*lam2_12 + &
        (0.04911220265093226_rk*(t2 + t37) - c4*n4_y)))
    t40 = 0.248077550893258_rk*qdd(2) - (t39 + 0.012168751997232599_rk*neg_a3_x - &
        (0.07388986205514168_rk*lam2_23 - 0.15279302557916313_rk*neg_lam2_13)) - &
        (1.4591749065920876_rk*c2 - s4*n4_x)
    ! link 2: moment through the joint, about the frame's origin [N m]
    n2_z = 0.22200183325724177_rk*neg_a3_z + t40
    t41 = -neg_n5_z
    tau(1) = n1_z
    tau(2) = n2_z
    tau(3) = f3_z
    tau(4) = n4_z
    tau(5) = t41
    tau(6) = nc6_z
  end subroutine

  ! torques that hold the arm at rest
  ! 24 multiplications, 16 additions = 40; 1 unary minus; 8 sine/cosine
  pure subroutine stanford_full_gravity(q, tau) &
      bind(c, name="stanford_full_gravity_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: s6, c6, hw6_y, c5, s2, c4, c2, s5, hw6_x, s4, t1, t2, tau6, t3, hw5_y, hw5_x, tau5
    real(rk) :: t4, t5, tau4, tau3, hw4_x, hw2_x, t6

    ! sines and cosines of the joint angles
    s6 = sin(q(6))
    c6 = cos(q(6))
    ! link 6: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw6_y = 11.695353768620235_rk*s6 - 11.931194031426555_rk*c6
    ! sines and cosines of the joint angles
    c5 = cos(q(5))
    s2 = sin(q(2))
    c4 = cos(q(4))
    c2 = cos(q(2))
    s5 = sin(q(5))
    ! link 6: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw6_x = 11.695353768620235_rk*c6 + 11.931194031426555_rk*s6
    ! sines and cosines of the joint angles
    s4 = sin(q(4))
    t1 = s2*c4
    t2 = s2*s4
    ! link 6: joint torque [N m], at a prismatic joint force [N]
    tau6 = hw6_y*(c5*t1 + c2*s5) + hw6_x*t2
    t3 = hw6_x - 5.792857332338038_rk
    ! link 5: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw5_y = s5*t3 - 6.33896479511625_rk*c5
    hw5_x = c5*t3 + 6.33896479511625_rk*s5
    ! link 5: joint torque [N m], at a prismatic joint force [N]
    tau5 = t1*hw5_y - c2*hw5_x
    t4 = hw6_y + 2.749310421134319_rk
    t5 = hw5_x + 8.842428262892447_rk
    ! link 4: joint torque [N m], at a prismatic joint force [N]
    tau4 = t1*t4 + t2*t5
    ! link 3: joint torque [N m], at a prismatic joint force [N]
    tau3 = 193.38181895468085_rk*c2
    ! link 4: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw4_x = c4*t5 - s4*t4
    ! link 2: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw2_x = c2*(hw4_x + 3.634792872513057_rk) + s2*(193.38181895468085_rk*q(3) - (hw5_y - &
        5.566797605293052_rk))
    t6 = -hw2_x
    tau(1) = 0.0_rk
    tau(2) = t6
    tau(3) = tau3
    tau(4) = tau4
    tau(5) = tau5
    tau(6) = tau6
  end subroutine

  ! torques at zero acceleration: Coriolis, centrifugal, gravity, friction
  ! 184 multiplications, 164 additions = 348; 0 unary minus; 8 sine/cosine
  pure subroutine stanford_full_bias(q, qd, tau) &
      bind(c, name="stanford_full_bias_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: s2, neg_w2_x, c2, neg_w2_y, neg_ww2_yz, neg_ww3_xy, ww2_xy, ww2_zz, ww2_yy
    real(rk) :: neg_lam2_32, ww1_zz, neg_lam2_11, neg_a2_x, c4, s4, neg_w4_x, w4_z, w4_y
    real(rk) :: neg_ww4_xy, ww4_xx, ww4_zz, ww4_yz, neg_ww4_zx, neg_lam4_21, neg_lam4_22, lam4_12
    real(rk) :: c5, s5, neg_w5_x, w5_z, neg_w5_y, neg_ww5_zx, ww5_xx, ww5_zz, ww5_xy, neg_lam5_22
    real(rk) :: w6_z, c6, s6, neg_a2_z, t1, neg_a3_y, t2, neg_lam2_22, a3_z, neg_a3_x, neg_a4_y
    real(rk) :: alpha4_x, alpha5_y, neg_lam5_31, alpha4_y, lam5_12, neg_a4_x, neg_a5_x, lam4_32
    real(rk) :: neg_lam5_23, t3, lam5_32, neg_lam5_13, t4, t5, t6, t7, t8, t9, t10, t11, t12, t13
    real(rk) :: t14, t15, t16, t17, nc6_z, neg_lam4_31, neg_a5_y, lam5_21, ww6_zz, t18, t19, t20
    real(rk) :: t21, t22, t23, t24, t25, n4_x, lam5_11, t26, t27, t28, f3_z, t29, neg_f4_y, t30
    real(rk) :: lam4_11, neg_f4_x, f3_y, t31, n5_z, neg_n4_y, lam4_13, lam4_23, t32, n4_z, t33
    real(rk) :: neg_f3_x, t34, t35, t36, n1_z, t37, n2_z

    ! sines and cosines of the joint angles
    s2 = sin(q(2))
    ! link 2: angular velocity [rad/s]
    neg_w2_x = s2*qd(1)
    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    ! link 2: angular velocity [rad/s]
    neg_w2_y = qd(1)*c2
    ! link 2: products of the angular velocity [1/s^2]
    neg_ww2_yz = neg_w2_y*qd(2)
    ! link 3: products of the angular velocity [1/s^2]
    neg_ww3_xy = neg_w2_x*qd(2)
    ! link 2: products of the angular velocity [1/s^2]
    ww2_xy = neg_w2_x*neg_w2_y
    ww2_zz = qd(2)*qd(2)
    ww2_yy = neg_w2_y*neg_w2_y
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_32 = 2.0_rk*neg_ww2_yz
    ! link 1: products of the angular velocity [1/s^2]
    ww1_zz = qd(1)*qd(1)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_11 = ww2_zz + ww2_yy
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a2_x = 9.8_rk*s2
    ! sines and cosines of the joint angles
    c4 = cos(q(4))
    s4 = sin(q(4))
    ! link 4: angular velocity [rad/s]
    neg_w4_x = neg_w2_x*c4 - qd(2)*s4
    w4_z = neg_w2_y + qd(4)
    w4_y = qd(2)*c4 + neg_w2_x*s4
    ! link 4: products of the angular velocity [1/s^2]
    neg_ww4_xy = neg_w4_x*w4_y
    ww4_xx = neg_w4_x*neg_w4_x
    ww4_zz = w4_z*w4_z
    ww4_yz = w4_z*w4_y
    neg_ww4_zx = neg_w4_x*w4_z
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam4_21 = neg_ww3_xy + neg_ww4_xy
    neg_lam4_22 = ww4_xx + ww4_zz
    lam4_12 = neg_ww3_xy - neg_ww4_xy
    ! sines and cosines of the joint angles
    c5 = cos(q(5))
    s5 = sin(q(5))
    ! link 5: angular velocity [rad/s]
    neg_w5_x = neg_w4_x*c5 + w4_z*s5
    w5_z = w4_y + qd(5)
    neg_w5_y = w4_z*c5 - neg_w4_x*s5
    ! link 5: products of the angular velocity [1/s^2]
    neg_ww5_zx = neg_w5_x*w5_z
    ww5_xx = neg_w5_x*neg_w5_x
    ww5_zz = w5_z*w5_z
    ww5_xy = neg_w5_x*neg_w5_y
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_22 = ww5_xx + ww5_zz
    ! link 6: angular velocity [rad/s]
    w6_z = neg_w5_y + qd(6)
    ! sines and cosines of the joint angles
    c6 = cos(q(6))
    s6 = sin(q(6))
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a2_z = 0.1524_rk*ww1_zz
    t1 = 2.0_rk*qd(3)
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a3_y = neg_a2_z - (neg_lam2_32*q(3) + neg_w2_x*t1)
    t2 = ww2_zz - ww2_yy
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_22 = ww1_zz + t2
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_z = 9.8_rk*c2 - q(3)*neg_lam2_22
    neg_a3_x = neg_a2_x - (qd(2)*t1 - ww2_xy*q(3))
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a4_y = c4*neg_a3_y - s4*neg_a3_x
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = qd(4)*w4_y - neg_ww2_yz*c4
    ! link 5: angular acceleration [rad/s^2]
    alpha5_y = neg_ww3_xy*c5 + (neg_w5_x*qd(5) - s5*alpha4_x)
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_31 = neg_ww5_zx + alpha5_y
    ! link 4: angular acceleration [rad/s^2]
    alpha4_y = neg_ww2_yz*s4 + neg_w4_x*qd(4)
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_12 = ww5_xy - alpha4_y
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a4_x = c4*neg_a3_x + s4*neg_a3_y
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a5_x = c5*neg_a4_x + s5*a3_z
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_32 = ww4_yz + alpha4_x
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_23 = lam4_12*s5 + c5*lam4_32
    t3 = 2.0_rk*w5_z
    lam5_32 = neg_lam5_23 - neg_w5_y*t3
    neg_lam5_13 = neg_ww5_zx - alpha5_y
    t4 = ww5_xx - ww5_zz
    t5 = 0.0625396920897071_rk*c6
    t6 = 0.16255029097038232_rk*c6
    t7 = t5*t6 + 0.3409906449060338_rk
    t8 = 0.0625396920897071_rk*s6
    t9 = t6*t8
    t10 = 62.4559348502784_rk*t7 + (t9 - 21.61434818388583_rk)
    t11 = 0.06483323523282834_rk*s6
    t12 = 18.778467160320414_rk*(t11 + 0.06355169650371038_rk*c6)
    t13 = t7 - 62.4559348502784_rk*t9
    t14 = t13 - 0.6921471349584476_rk
    t15 = t5 - t11
    t16 = 1.193403445777575_rk*s6 - 1.2174687787169953_rk*c6
    t17 = t8 + 0.06483323523282834_rk*c6
    ! link 6: moment that turns the link [N m]
    nc6_z = t4*t10 - (neg_a4_y*t12 - (t14*neg_lam5_31 + t15*lam5_12)) + (t16*neg_a5_x + &
        t17*lam5_32 + t13*neg_lam5_13)
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam4_31 = neg_ww4_zx + alpha4_y
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a5_y = c5*a3_z - s5*neg_a4_x
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_21 = ww5_xy + alpha4_y
    ! link 6: products of the angular velocity [1/s^2]
    ww6_zz = w6_z*w6_z
    t18 = 0.28054187970758354_rk*neg_a5_x + (1.1561689763413345_rk*neg_lam5_13 - &
        (0.20245111268601115_rk*neg_lam5_31 - (0.13660343902034475_rk*t4 + &
        0.5911078910549018_rk*neg_a4_y))) + 0.23560176217086468_rk*lam5_12
    t19 = nc6_z + (0.060693211657558095_rk*lam5_32 + t18)
    t20 = lam5_21 + neg_w5_x*(2.0_rk*qd(6))
    t21 = ww5_xx - ww6_zz
    t22 = neg_lam5_23 + qd(6)*t3
    t23 = t16 + 0.28054187970758354_rk
    t24 = 0.13660343902034475_rk*lam5_21 + (t23*neg_a5_y + (0.17535491873574263_rk*lam5_32 + &
        (0.23560176217086468_rk*(neg_lam4_22 - neg_lam5_22) + 0.6468331423588011_rk*neg_a4_y)))
    t25 = t10*t20 + (t15*(t4 - t21) + (1.1561689763413345_rk*neg_lam5_23 + (t13*t22 + t24))) - &
        neg_lam5_31*(t17 + 0.060693211657558095_rk)
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = s5*t19 + 0.06784076259315977_rk*neg_lam4_31 + (c5*t25 + &
        0.23523950726161555_rk*(neg_lam2_22 - (neg_lam4_22 + &
        0.011289042504553535_rk*neg_lam4_21)))
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_11 = t4 - neg_lam4_22
    t26 = neg_lam5_22 - t21
    t27 = -0.5911078910549018_rk*lam5_11 - (0.6468331423588011_rk*lam5_12 + t12*t26) - &
        neg_lam5_13*t23
    t28 = 0.6468331423588011_rk*neg_lam5_22 - (0.28054187970758354_rk*neg_lam5_23 + t16*t22 - &
        t12*t20 + 0.5911078910549018_rk*lam5_21)
    ! link 3: force through the joint [N]
    f3_z = -0.22200183325724177_rk*(ww2_xy + 0.05481374553845334_rk*neg_lam2_22) - (s5*t27 + &
        c5*t28 - 19.732838668844984_rk*a3_z + 0.9022885982543313_rk*neg_lam4_31)
    t29 = t12 - 0.5911078910549018_rk
    ! link 4: force through the joint [N]
    neg_f4_y = t16*(t4 + t26) + (0.6468331423588011_rk*lam5_32 + &
        (0.9022885982543313_rk*neg_lam4_21 + 0.28054187970758354_rk*neg_lam4_22)) + &
        neg_lam5_31*t29
    t30 = ww4_xx - ww4_zz
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_11 = t30 - neg_lam2_22
    ! link 4: force through the joint [N]
    neg_f4_x = s5*t28 - c5*t27 - 0.9022885982543313_rk*lam4_11
    ! link 3: force through the joint [N]
    f3_y = 0.024337503994465198_rk*neg_ww2_yz - (c4*neg_f4_y + 19.732838668844984_rk*neg_a3_y + &
        (0.44400366651448353_rk*neg_ww3_xy + (0.4516316755890639_rk*ww1_zz + s4*neg_f4_x)))
    t31 = 0.17535491873574263_rk*lam5_12 - (0.20245111268601115_rk*lam5_21 - (t14*t20 + (t17*t21 + &
        (0.6468331423588011_rk*neg_a5_x - 0.13660343902034475_rk*neg_lam5_23))))
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_z = t10*t22 - (neg_a5_y*t29 + (0.060693211657558095_rk*(neg_lam5_22 + lam5_11) + t31)) - &
        neg_lam5_13*(t15 + 0.23560176217086468_rk)
    ! link 4: moment through the joint, about the frame's origin [N m]
    neg_n4_y = 0.23523950726161555_rk*lam4_12 + (0.002655628796226608_rk*t30 - &
        0.3448462092987837_rk*neg_lam4_31 - 0.06784076259315977_rk*lam4_32 - (n5_z - &
        0.9022885982543313_rk*a3_z))
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_13 = alpha4_y - neg_ww4_zx
    lam4_23 = ww4_yz - alpha4_x
    t32 = 0.06784076259315977_rk*(neg_lam4_22 + lam4_11) - s5*t25 - &
        (0.3448462092987837_rk*neg_lam4_21 + (0.002655628796226608_rk*lam4_23 + &
        0.9022885982543313_rk*neg_a4_y))
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_z = c5*t19 + 0.23523950726161555_rk*lam4_13 + t32
    t33 = 0.012168751997232599_rk*ww2_xy
    ! link 3: force through the joint [N]
    neg_f3_x = 0.22200183325724177_rk*neg_lam2_11 + (t33 + (c4*neg_f4_x + &
        19.732838668844984_rk*neg_a3_x)) - s4*neg_f4_y
    t34 = ww1_zz - neg_lam2_11
    t35 = 0.1524_rk*neg_f3_x - (0.22200183325724177_rk*neg_a3_y - n4_z - &
        12.556178777734242_rk*(t33 + 0.0359688790342758_rk*neg_a3_x) + 0.07388986205514168_rk*t34)
    t36 = 0.1524_rk*(0.4848416145350504_rk*ww2_xy - f3_z) - (c4*n4_x + (0.4516316755890639_rk*a3_z &
        + (0.012168751997232599_rk*neg_a3_y - (0.15279302557916313_rk*t2 + &
        0.09822440530186452_rk*neg_ww3_xy))))
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = c2*(t35 - 0.09822440530186452_rk*neg_ww2_yz - 0.248077550893258_rk*neg_ww3_xy) - &
        s2*(s4*neg_n4_y - (q(3)*f3_y + t36) - 1.2453237337332923_rk*neg_ww2_yz)
    t37 = q(3)*neg_f3_x + (5.4475438357201735_rk*s2 + (0.49862309142001715_rk*ww2_xy + &
        (0.04911220265093226_rk*(t2 + t34) + c4*neg_n4_y)))
    ! link 2: moment through the joint, about the frame's origin [N m]
    n2_z = s4*n4_x - 1.4591749065920876_rk*c2 - (t37 + 0.012168751997232599_rk*neg_a3_x) - &
        0.22200183325724177_rk*a3_z
    tau(1) = n1_z
    tau(2) = n2_z
    tau(3) = f3_z
    tau(4) = n4_z
    tau(5) = n5_z
    tau(6) = nc6_z
  end subroutine

  ! mass matrix, rotor inertias on its diagonal
  ! 90 multiplications, 84 additions = 174; 3 unary minus; 8 sine/cosine
  pure subroutine stanford_full_mass_matrix(q, M) &
      bind(c, name="stanford_full_mass_matrix_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(out) :: M(36)
    real(rk) :: c2, s2, c4, s4, c5, s5, c6, s6, h6_x, t1, h5_x, h5_y, t2, t3, t4, m5_5, t5
    real(rk) :: neg_k6_xz, t6, t7, t8, t9, t10, t11, m4_4, t12, h6_y, t13, t14, h4_y, neg_k6_yz
    real(rk) :: t15, t16, neg_k5_xz, t17, neg_h3_x, k5_yz, t18, t19, t20, t21, t22, t23, t24, t25
    real(rk) :: t26, t27, t28, t29, t30, m1_1, h2_y, neg_k4_yz, m2_4, m1_2, m1_3, m1_4, neg_fu2_x
    real(rk) :: t31, nu2_y, m1_5, neg_fu5_x, neg_fu4_x, neg_fu5_y, neg_nu5_y, nu5_x, fu4_y, m1_6
    real(rk) :: m2_2, m2_5, m2_6, t32

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    c4 = cos(q(4))
    s4 = sin(q(4))
    c5 = cos(q(5))
    s5 = sin(q(5))
    c6 = cos(q(6))
    s6 = sin(q(6))
    ! link 6: first moment of the composite body, about the frame's origin [kg m]
    h6_x = 1.193403445777575_rk*c6 + 1.2174687787169953_rk*s6
    t1 = h6_x - 0.5911078910549018_rk
    ! link 5: first moment of the composite body, about the frame's origin [kg m]
    h5_x = c5*t1 + 0.6468331423588011_rk*s5
    h5_y = s5*t1 - 0.6468331423588011_rk*c5
    t2 = 0.6349173621603285_rk*c6
    t3 = s6*t2
    t4 = c6*t2 - 0.1808552420598195_rk
    ! link 5: mass matrix, its row of this joint
    m5_5 = t3 + 0.7260667959919797_rk - 0.01601128863729661_rk*t4
    t5 = 0.05432633487209812_rk*h6_x
    ! link 6: second moment of the composite body [kg m^2]
    neg_k6_xz = t5 - 0.003600924479196722_rk*s6
    t6 = c5*c5
    t7 = m5_5 - 0.35070983747148526_rk
    t8 = c5*s5
    t9 = neg_k6_xz + (neg_k6_xz + 0.12138642331511619_rk)
    t10 = t6*t7 - (t8*t9 - 3.589792571474863_rk)
    t11 = m5_5 + 0.8434693007188008_rk
    ! link 4: mass matrix, its row of this joint
    m4_4 = t10 - t11
    t12 = 0.1286340586837634_rk*c6
    ! link 6: first moment of the composite body, about the frame's origin [kg m]
    h6_y = 19.08233644747969_rk*(neg_k6_xz - t12)
    t13 = h5_x + 0.9022885982543313_rk
    t14 = h6_y + 0.28054187970758354_rk
    ! link 4: first moment of the composite body, about the frame's origin [kg m]
    h4_y = s4*t13 + c4*t14
    ! link 6: second moment of the composite body [kg m^2]
    neg_k6_yz = 0.9802333058883194_rk*(t5 - t12)
    t15 = neg_k6_yz - 0.23560176217086468_rk
    t16 = t4 + 0.01601128863729661_rk*t3
    ! link 5: second moment of the composite body [kg m^2]
    neg_k5_xz = s5*t15 + c5*t16
    t17 = c4*t13 - (s4*t14 - 0.3708972318890874_rk)
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    neg_h3_x = 0.14889539863184567_rk - t17
    ! link 5: second moment of the composite body [kg m^2]
    k5_yz = c5*t15 - s5*t16
    t18 = 0.1524_rk*h4_y
    t19 = m4_4 + t18
    t20 = 19.732838668844984_rk*q(3) - (h5_y - 0.5680405719686789_rk)
    t21 = h5_y*q(3)
    t22 = m4_4 - q(3)*(t20 - 0.5437030679742136_rk) + t21
    t23 = c4*c4
    t24 = t10 + (m5_5 - 5.295713586161873_rk)
    t25 = c4*s4
    t26 = neg_k5_xz + (neg_k5_xz + 0.13568152518631954_rk)
    t27 = t11 - t23*t24 - t25*t26
    t28 = t9*(t6 - 0.5_rk) + (t7*t8 + 0.002655628796226608_rk)
    t29 = -k5_yz - 0.23523950726161555_rk
    t30 = c4*t28 + q(3)*neg_h3_x + s4*t29
    ! link 1: mass matrix, its row of this joint
    m1_1 = t19 - (s2*(s2*(t22 - t27) + c2*(t30 + (t30 + 0.09822440530186452_rk))) - (t18 + &
        1.8329821847328702_rk))
    ! link 2: first moment of the composite body, about the frame's origin [kg m]
    h2_y = s2*t17 - c2*t20
    ! link 4: second moment of the composite body [kg m^2]
    neg_k4_yz = s4*t28 - c4*t29
    ! link 2: mass matrix, its row of this joint
    m2_4 = neg_k4_yz - h4_y*q(3)
    ! link 1: mass matrix, its row of this joint
    m1_2 = c2*(m2_4 - 0.06807816021551473_rk - 0.4516316755890639_rk*q(3)) - (s2*(t26*(t23 - &
        0.5_rk) - (t24*t25 + 0.0511982033036484_rk)) - 0.1524_rk*h2_y)
    m1_3 = s2*(-h4_y - 3.45891628872104_rk)
    m1_4 = c2*t19 - s2*(t30 + 0.22200183325724177_rk*q(3))
    ! link 2: force for a unit acceleration of a joint further out
    neg_fu2_x = s2*h5_x + h5_y*(c2*c4)
    t31 = m5_5 - t21
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y = s2*(c4*neg_k5_xz - s4*t31) - c2*k5_yz
    ! link 1: mass matrix, its row of this joint
    m1_5 = 0.1524_rk*neg_fu2_x - nu2_y
    ! link 5: force for a unit acceleration of a joint further out
    neg_fu5_x = c5*h6_y
    ! link 4: force for a unit acceleration of a joint further out
    neg_fu4_x = s4*h6_x + c4*neg_fu5_x
    ! link 5: force for a unit acceleration of a joint further out
    neg_fu5_y = s5*h6_y
    ! link 5: moment for a unit acceleration of a joint further out
    neg_nu5_y = 0.6921471349584476_rk*c5 - s5*neg_k6_xz
    nu5_x = 0.6921471349584476_rk*s5 + c5*neg_k6_xz
    ! link 4: force for a unit acceleration of a joint further out
    fu4_y = c4*h6_x - s4*neg_fu5_x
    ! link 1: mass matrix, its row of this joint
    m1_6 = 0.1524_rk*(c2*neg_fu4_x - s2*neg_fu5_y) + (c2*neg_nu5_y - s2*(c4*nu5_x - (s4*neg_k6_yz &
        + q(3)*fu4_y)))
    ! link 2: mass matrix, its row of this joint
    m2_2 = 6.387260437773931_rk - t27 - t22
    m2_5 = c4*t31 + s4*neg_k5_xz
    m2_6 = s4*nu5_x - q(3)*neg_fu4_x + c4*neg_k6_yz
    t32 = -h5_x
    M(1) = m1_1
    M(2) = m1_2
    M(3) = m1_3
    M(4) = m1_4
    M(5) = m1_5
    M(6) = m1_6
    M(7) = m1_2
    M(8) = m2_2
    M(9) = neg_h3_x
    M(10) = m2_4
    M(11) = m2_5
    M(12) = m2_6
    M(13) = m1_3
    M(14) = neg_h3_x
    M(15) = 19.732838668844984_rk
    M(16) = 0.0_rk
    M(17) = t32
    M(18) = neg_fu5_y
    M(19) = m1_4
    M(20) = m2_4
    M(21) = 0.0_rk
    M(22) = m4_4
    M(23) = k5_yz
    M(24) = neg_nu5_y
    M(25) = m1_5
    M(26) = m2_5
    M(27) = t32
    M(28) = k5_yz
    M(29) = m5_5
    M(30) = neg_k6_yz
    M(31) = m1_6
    M(32) = m2_6
    M(33) = neg_fu5_y
    M(34) = neg_nu5_y
    M(35) = neg_k6_yz
    M(36) = 0.6921471349584476_rk
  end subroutine

  ! accelerations that the torques tau give
  ! 358 multiplications, 316 additions, 5 divisions = 679; 2 unary minus; 8 sine/cosine
  pure subroutine stanford_full_forward_dynamics(q, qd, tau, qdd) &
      bind(c, name="stanford_full_forward_dynamics_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(in) :: tau(6)
    real(rk), intent(out) :: qdd(6)
    real(rk) :: s2, neg_w2_x, c2, neg_w2_y, neg_ww2_yz, neg_ww3_xy, ww2_xy, ww2_zz, ww2_yy, ww1_zz
    real(rk) :: neg_lam2_11, neg_a2_x, c4, s4, neg_w4_x, w4_z, w4_y, neg_ww4_xy, ww4_xx, ww4_zz
    real(rk) :: ww4_yz, neg_ww4_zx, neg_lam4_21, neg_lam4_22, lam4_12, c5, s5, neg_w5_x, w5_z
    real(rk) :: neg_w5_y, neg_ww5_zx, ww5_xx, ww5_zz, ww5_xy, neg_lam5_22, w6_z, c6, s6, neg_a2_z
    real(rk) :: t1, neg_a3_y, t2, neg_lam2_22, neg_a3_z, neg_a3_x, neg_a4_y, alpha4_x, alpha5_y
    real(rk) :: neg_lam5_31, alpha4_y, lam5_12, neg_a4_x, neg_a5_x, lam4_32, neg_lam5_23, t3
    real(rk) :: lam5_32, neg_lam5_13, h6_x, t4, t5, t6, t7, t8, t9, t10, t11, t12, t13, t14, t15
    real(rk) :: nc6_z, neg_lam4_31, a5_y, lam5_21, ww6_zz, t16, t17, t18, t19, t20, t21, t22, t23
    real(rk) :: n4_x, lam5_11, t24, t25, t26, f3_z, t27, neg_f4_y, t28, lam4_11, f4_x, neg_f3_y
    real(rk) :: t29, n5_z, n4_y, lam4_13, lam4_23, t30, n4_z, f3_x, t31, t32, t33, n1_z, t34, n2_z
    real(rk) :: h5_x, h5_y, t35, t36, t37, m5_5, t38, neg_k6_xz, t39, t40, t41, t42, t43, t44, m4_4
    real(rk) :: t45, h6_y, t46, t47, h4_y, t48, neg_k6_yz, t49, t50, k5_xz, t51, h3_x, neg_k5_yz
    real(rk) :: t52, t53, t54, t55, t56, t57, t58, t59, t60, t61, t62, t63, t64, m1_1, h2_y
    real(rk) :: neg_k4_yz, m2_4, m1_2, neg_m1_3, m1_4, neg_fu2_x, t65, nu2_y, m1_5, neg_fu5_x
    real(rk) :: neg_fu4_x, neg_fu5_y, nu5_y, nu5_x, fu4_y, neg_m1_6, neg_m2_2, m2_5, m2_6, neg_y6
    real(rk) :: u5_6, neg_u4_6, u3_6, u2_6, neg_u1_6, pivot5, ipivot5, neg_ud4_5, neg_u4_5
    real(rk) :: neg_ud3_5, neg_u3_5, ud2_5, u2_5, ud1_5, u1_5, pivot4, ipivot4, ud3_4, u3_4, ud2_4
    real(rk) :: u2_4, ud1_4, u1_4, neg_pivot3, neg_ipivot3, neg_ud2_3, u2_3, neg_ud1_3, u1_3
    real(rk) :: neg_pivot2, neg_ipivot2, ud1_2, neg_u1_2, pivot1, ipivot1, neg_y5, neg_y4, neg_y3
    real(rk) :: neg_y2, neg_y1, neg_qdd1, qdd2, qdd3, neg_qdd4, qdd5, qdd6, t66, t67

    ! sines and cosines of the joint angles
    s2 = sin(q(2))
    ! link 2: angular velocity [rad/s]
    neg_w2_x = s2*qd(1)
    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    ! link 2: angular velocity [rad/s]
    neg_w2_y = qd(1)*c2
    ! link 2: products of the angular velocity [1/s^2]
    neg_ww2_yz = neg_w2_y*qd(2)
    ! link 3: products of the angular velocity [1/s^2]
    neg_ww3_xy = neg_w2_x*qd(2)
    ! link 2: products of the angular velocity [1/s^2]
    ww2_xy = neg_w2_x*neg_w2_y
    ww2_zz = qd(2)*qd(2)
    ww2_yy = neg_w2_y*neg_w2_y
    ! link 1: products of the angular velocity [1/s^2]
    ww1_zz = qd(1)*qd(1)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_11 = ww2_zz + ww2_yy
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a2_x = 9.8_rk*s2
    ! sines and cosines of the joint angles
    c4 = cos(q(4))
    s4 = sin(q(4))
    ! link 4: angular velocity [rad/s]
    neg_w4_x = neg_w2_x*c4 - qd(2)*s4
    w4_z = neg_w2_y + qd(4)
    w4_y = qd(2)*c4 + neg_w2_x*s4
    ! link 4: products of the angular velocity [1/s^2]
    neg_ww4_xy = neg_w4_x*w4_y
    ww4_xx = neg_w4_x*neg_w4_x
    ww4_zz = w4_z*w4_z
    ww4_yz = w4_z*w4_y
    neg_ww4_zx = neg_w4_x*w4_z
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam4_21 = neg_ww3_xy + neg_ww4_xy
    neg_lam4_22 = ww4_xx + ww4_zz
    lam4_12 = neg_ww3_xy - neg_ww4_xy
    ! sines and cosines of the joint angles
    c5 = cos(q(5))
    s5 = sin(q(5))
    ! link 5: angular velocity [rad/s]
    neg_w5_x = neg_w4_x*c5 + w4_z*s5
    w5_z = w4_y + qd(5)
    neg_w5_y = w4_z*c5 - neg_w4_x*s5
    ! link 5: products of the angular velocity [1/s^2]
    neg_ww5_zx = neg_w5_x*w5_z
    ww5_xx = neg_w5_x*neg_w5_x
    ww5_zz = w5_z*w5_z
    ww5_xy = neg_w5_x*neg_w5_y
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_22 = ww5_xx + ww5_zz
    ! link 6: angular velocity [rad/s]
    w6_z = neg_w5_y + qd(6)
    ! sines and cosines of the joint angles
    c6 = cos(q(6))
    s6 = sin(q(6))
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a2_z = 0.1524_rk*ww1_zz
    t1 = 2.0_rk*qd(3)
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a3_y = neg_a2_z - (neg_w2_x*t1 + 2.0_rk*(neg_ww2_yz*q(3)))
    t2 = ww2_zz - ww2_yy
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_22 = ww1_zz + t2
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a3_z = q(3)*neg_lam2_22 - 9.8_rk*c2
    neg_a3_x = neg_a2_x - (qd(2)*t1 - ww2_xy*q(3))
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a4_y = c4*neg_a3_y - s4*neg_a3_x
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = qd(4)*w4_y - neg_ww2_yz*c4
    ! link 5: angular acceleration [rad/s^2]
    alpha5_y = neg_ww3_xy*c5 + (neg_w5_x*qd(5) - s5*alpha4_x)
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_31 = neg_ww5_zx + alpha5_y
    ! link 4: angular acceleration [rad/s^2]
    alpha4_y = neg_ww2_yz*s4 + neg_w4_x*qd(4)
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_12 = ww5_xy - alpha4_y
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a4_x = c4*neg_a3_x + s4*neg_a3_y
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a5_x = c5*neg_a4_x - s5*neg_a3_z
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_32 = ww4_yz + alpha4_x
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_23 = lam4_12*s5 + c5*lam4_32
    t3 = 2.0_rk*w5_z
    lam5_32 = neg_lam5_23 - neg_w5_y*t3
    neg_lam5_13 = neg_ww5_zx - alpha5_y
    ! link 6: first moment of the composite body, about the frame's origin [kg m]
    h6_x = 1.2174687787169953_rk*s6 + 1.193403445777575_rk*c6
    t4 = ww5_xx - ww5_zz
    t5 = 0.16255029097038232_rk*c6
    t6 = 0.0625396920897071_rk*s6
    t7 = t5*t6
    t8 = 0.0625396920897071_rk*c6
    t9 = t8*t5 + 0.3409906449060338_rk
    t10 = t7 - 21.61434818388583_rk + 62.4559348502784_rk*t9
    t11 = t9 - 62.4559348502784_rk*t7
    t12 = t11 - 0.6921471349584476_rk
    t13 = t8 - 0.06483323523282834_rk*s6
    t14 = 1.193403445777575_rk*s6 - 1.2174687787169953_rk*c6
    t15 = t6 + 0.06483323523282834_rk*c6
    ! link 6: moment that turns the link [N m]
    nc6_z = t4*t10 - (neg_a4_y*h6_x - (neg_lam5_31*t12 + lam5_12*t13)) + (neg_a5_x*t14 + &
        lam5_32*t15 + neg_lam5_13*t11)
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam4_31 = neg_ww4_zx + alpha4_y
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_y = c5*neg_a3_z + s5*neg_a4_x
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_21 = ww5_xy + alpha4_y
    ! link 6: products of the angular velocity [1/s^2]
    ww6_zz = w6_z*w6_z
    t16 = neg_a5_x + 0.486927082554413_rk*(t4 + 4.327181623640283_rk*neg_a4_y - &
        1.4820352557585283_rk*neg_lam5_31 + 8.463688649662348_rk*neg_lam5_13) + &
        0.8398095942624995_rk*lam5_12
    t17 = nc6_z + 0.28054187970758354_rk*(t16 + 0.21634278532966372_rk*lam5_32)
    t18 = lam5_21 + 2.0_rk*(neg_w5_x*qd(6))
    t19 = ww5_xx - ww6_zz
    t20 = neg_lam5_23 + qd(6)*t3
    t21 = t14 + 0.28054187970758354_rk
    t22 = a5_y*t21 - 0.6468331423588011_rk*(neg_a4_y + 0.3642388534880846_rk*(neg_lam4_22 - &
        neg_lam5_22) + 0.27109760964980445_rk*lam5_32) - 0.13660343902034475_rk*lam5_21
    t23 = t10*t18 + (t13*(t4 - t19) + (t11*t20 - t22 + 1.1561689763413345_rk*neg_lam5_23)) - &
        neg_lam5_31*(t15 + 0.060693211657558095_rk)
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = s5*t17 + 0.06784076259315977_rk*neg_lam4_31 + (c5*t23 + &
        0.23523950726161555_rk*(neg_lam2_22 - (neg_lam4_22 + &
        0.011289042504553535_rk*neg_lam4_21)))
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_11 = t4 - neg_lam4_22
    t24 = neg_lam5_22 - t19
    t25 = h6_x*t24 + 0.6468331423588011_rk*lam5_12 + 0.5911078910549018_rk*lam5_11 + &
        neg_lam5_13*t21
    t26 = t14*t20 + 0.28054187970758354_rk*neg_lam5_23 - h6_x*t18 + 0.5911078910549018_rk*lam5_21 &
        - 0.6468331423588011_rk*neg_lam5_22
    ! link 3: force through the joint [N]
    f3_z = s5*t25 + c5*t26 - 19.732838668844984_rk*neg_a3_z - 0.9022885982543313_rk*neg_lam4_31 - &
        0.012168751997232599_rk*(neg_lam2_22 + 18.243599122385692_rk*ww2_xy)
    t27 = h6_x - 0.5911078910549018_rk
    ! link 4: force through the joint [N]
    neg_f4_y = t14*(t4 + t24) + 0.6468331423588011_rk*(lam5_32 + 1.39493254004265_rk*(neg_lam4_21 &
        + 0.310922558758197_rk*neg_lam4_22)) + neg_lam5_31*t27
    t28 = ww4_xx - ww4_zz
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_11 = t28 - neg_lam2_22
    ! link 4: force through the joint [N]
    f4_x = s5*t26 - c5*t25 + 0.9022885982543313_rk*lam4_11
    ! link 3: force through the joint [N]
    neg_f3_y = c4*neg_f4_y + 19.732838668844984_rk*neg_a3_y - (s4*f4_x - &
        0.4516316755890639_rk*ww1_zz - 0.44400366651448353_rk*neg_ww3_xy) - &
        0.024337503994465198_rk*neg_ww2_yz
    t29 = t12*t18 + (t15*t19 + 0.6468331423588011_rk*(neg_a5_x - &
        0.2111880639297395_rk*neg_lam5_23)) - 0.20245111268601115_rk*lam5_21 + &
        0.17535491873574263_rk*lam5_12
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_z = t10*t20 + (a5_y*t27 - (t29 + 0.060693211657558095_rk*(neg_lam5_22 + lam5_11))) - &
        neg_lam5_13*(t13 + 0.23560176217086468_rk)
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_y = n5_z + 0.9022885982543313_rk*neg_a3_z + 0.06784076259315977_rk*(lam4_32 - &
        0.03914503161104455_rk*(t28 - 129.85482375728748_rk*neg_lam4_31)) - &
        0.23523950726161555_rk*lam4_12
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_13 = alpha4_y - neg_ww4_zx
    lam4_23 = ww4_yz - alpha4_x
    t30 = s5*t23 - 0.06784076259315977_rk*(neg_lam4_22 + lam4_11) + &
        0.9022885982543313_rk*(neg_a4_y + 0.002943214400984879_rk*lam4_23 + &
        0.38219058731980193_rk*neg_lam4_21)
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_z = c5*t17 + 0.23523950726161555_rk*lam4_13 - t30
    ! link 3: force through the joint [N]
    f3_x = c4*f4_x - 19.732838668844984_rk*neg_a3_x - 0.012168751997232599_rk*ww2_xy - &
        0.22200183325724177_rk*neg_lam2_11 + s4*neg_f4_y
    t31 = ww1_zz - neg_lam2_11
    t32 = n4_z - 0.22200183325724177_rk*neg_a3_y + 0.15279302557916313_rk*(ww2_xy + &
        2.955839599858374_rk*neg_a3_x) - 0.07388986205514168_rk*t31 - 0.1524_rk*f3_x
    t33 = c4*n4_x + 0.012168751997232599_rk*(neg_a3_y - 8.071855299886346_rk*(neg_ww3_xy + &
        1.5555505285025408_rk*t2) - 37.11405045412819_rk*neg_a3_z) - &
        0.07388986205514168_rk*(ww2_xy - 2.0625292260833925_rk*f3_z)
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = c2*(t32 - 0.09822440530186452_rk*neg_ww2_yz - 0.248077550893258_rk*neg_ww3_xy) + &
        s2*(s4*n4_y - (q(3)*neg_f3_y + t33) + 1.2453237337332923_rk*neg_ww2_yz)
    t34 = q(3)*f3_x + (c4*n4_y - 0.04911220265093226_rk*(t2 + t31) - 0.49862309142001715_rk*ww2_xy &
        - 5.4475438357201735_rk*s2)
    ! link 2: moment through the joint, about the frame's origin [N m]
    n2_z = s4*n4_x - 1.4591749065920876_rk*c2 + (t34 - 0.012168751997232599_rk*neg_a3_x) + &
        0.22200183325724177_rk*neg_a3_z
    ! link 5: first moment of the composite body, about the frame's origin [kg m]
    h5_x = c5*t27 + 0.6468331423588011_rk*s5
    h5_y = s5*t27 - 0.6468331423588011_rk*c5
    t35 = 0.6349173621603285_rk*c6
    t36 = s6*t35
    t37 = c6*t35 - 0.1808552420598195_rk
    ! link 5: mass matrix, its row of this joint
    m5_5 = t36 + 0.7260667959919797_rk - 0.01601128863729661_rk*t37
    t38 = 0.05432633487209812_rk*h6_x
    ! link 6: second moment of the composite body [kg m^2]
    neg_k6_xz = t38 - 0.003600924479196722_rk*s6
    t39 = c5*c5
    t40 = m5_5 - 0.35070983747148526_rk
    t41 = c5*s5
    t42 = neg_k6_xz + (neg_k6_xz + 0.12138642331511619_rk)
    t43 = t39*t40 - (t41*t42 - 3.589792571474863_rk)
    t44 = m5_5 + 0.8434693007188008_rk
    ! link 4: mass matrix, its row of this joint
    m4_4 = t43 - t44
    t45 = 0.1286340586837634_rk*c6
    ! link 6: first moment of the composite body, about the frame's origin [kg m]
    h6_y = 19.08233644747969_rk*(neg_k6_xz - t45)
    t46 = h5_x + 0.9022885982543313_rk
    t47 = 0.28054187970758354_rk + h6_y
    ! link 4: first moment of the composite body, about the frame's origin [kg m]
    h4_y = s4*t46 + c4*t47
    t48 = t38 - t45
    ! link 6: second moment of the composite body [kg m^2]
    neg_k6_yz = 0.9802333058883194_rk*t48
    t49 = 0.23560176217086468_rk - neg_k6_yz
    t50 = t37 + 0.01601128863729661_rk*t36
    ! link 5: second moment of the composite body [kg m^2]
    k5_xz = s5*t49 - c5*t50
    t51 = c4*t46 - (s4*t47 - 0.3708972318890874_rk)
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    h3_x = t51 - 0.14889539863184567_rk
    ! link 5: second moment of the composite body [kg m^2]
    neg_k5_yz = c5*t49 + s5*t50
    t52 = 0.1524_rk*h4_y
    t53 = m4_4 + t52
    t54 = h5_y - 0.5680405719686789_rk - 19.732838668844984_rk*q(3)
    t55 = q(3)*h5_y
    t56 = m4_4 + q(3)*(t54 + 0.5437030679742136_rk) + t55
    t57 = c4*c4
    t58 = t43 + (m5_5 - 5.295713586161873_rk)
    t59 = c4*s4
    t60 = k5_xz + (k5_xz - 0.13568152518631954_rk)
    t61 = t44 - t57*t58 + t59*t60
    t62 = t42*(t39 - 0.5_rk) + (t40*t41 + 0.002655628796226608_rk)
    t63 = neg_k5_yz - 0.23523950726161555_rk
    t64 = c4*t62 - q(3)*h3_x + s4*t63
    ! link 1: mass matrix, its row of this joint
    m1_1 = t53 - (s2*(s2*(t56 - t61) + c2*(t64 + (t64 + 0.09822440530186452_rk))) - (t52 + &
        1.8329821847328702_rk))
    ! link 2: first moment of the composite body, about the frame's origin [kg m]
    h2_y = s2*t51 + c2*t54
    ! link 4: second moment of the composite body [kg m^2]
    neg_k4_yz = s4*t62 - c4*t63
    ! link 2: mass matrix, its row of this joint
    m2_4 = neg_k4_yz - q(3)*h4_y
    ! link 1: mass matrix, its row of this joint
    m1_2 = c2*(m2_4 - 0.06807816021551473_rk - 0.4516316755890639_rk*q(3)) + (s2*(t60*(t57 - &
        0.5_rk) + (t58*t59 + 0.0511982033036484_rk)) + 0.1524_rk*h2_y)
    neg_m1_3 = s2*(h4_y + 3.45891628872104_rk)
    m1_4 = c2*t53 - s2*(t64 + 0.22200183325724177_rk*q(3))
    ! link 2: force for a unit acceleration of a joint further out
    neg_fu2_x = s2*h5_x + h5_y*(c2*c4)
    t65 = m5_5 - t55
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y = c2*neg_k5_yz - s2*(c4*k5_xz + s4*t65)
    ! link 1: mass matrix, its row of this joint
    m1_5 = 0.1524_rk*neg_fu2_x - nu2_y
    ! link 5: force for a unit acceleration of a joint further out
    neg_fu5_x = c5*h6_y
    ! link 4: force for a unit acceleration of a joint further out
    neg_fu4_x = s4*h6_x + c4*neg_fu5_x
    ! link 5: force for a unit acceleration of a joint further out
    neg_fu5_y = s5*h6_y
    ! link 5: moment for a unit acceleration of a joint further out
    nu5_y = s5*neg_k6_xz - 0.6921471349584476_rk*c5
    nu5_x = c5*neg_k6_xz + 0.6921471349584476_rk*s5
    ! link 4: force for a unit acceleration of a joint further out
    fu4_y = c4*h6_x - s4*neg_fu5_x
    ! link 1: mass matrix, its row of this joint
    neg_m1_6 = c2*nu5_y + s2*(c4*nu5_x - (s4*neg_k6_yz + q(3)*fu4_y)) - 0.1524_rk*(c2*neg_fu4_x - &
        s2*neg_fu5_y)
    ! link 2: mass matrix, its row of this joint
    neg_m2_2 = t56 + (t61 - 6.387260437773931_rk)
    m2_5 = c4*t65 - s4*k5_xz
    m2_6 = s4*nu5_x - q(3)*neg_fu4_x + c4*neg_k6_yz
    ! link 6: forward substitution
    neg_y6 = nc6_z - tau(6)
    ! factorisation M = U D U^T
    u5_6 = 1.4162209975010107_rk*t48
    neg_u4_6 = 1.4447795121770373_rk*nu5_y
    u3_6 = 1.4447795121770373_rk*neg_fu5_y
    u2_6 = 1.4447795121770373_rk*m2_6
    neg_u1_6 = 1.4447795121770373_rk*neg_m1_6
    pivot5 = m5_5 - neg_k6_yz*u5_6
    ipivot5 = 1.0_rk / pivot5
    neg_ud4_5 = neg_k5_yz - neg_k6_yz*neg_u4_6
    neg_u4_5 = ipivot5*neg_ud4_5
    neg_ud3_5 = h5_x + neg_k6_yz*u3_6
    neg_u3_5 = ipivot5*neg_ud3_5
    ud2_5 = m2_5 - neg_k6_yz*u2_6
    u2_5 = ipivot5*ud2_5
    ud1_5 = m1_5 + neg_k6_yz*neg_u1_6
    u1_5 = ipivot5*ud1_5
    pivot4 = m4_4 - nu5_y*neg_u4_6 - neg_ud4_5*neg_u4_5
    ipivot4 = 1.0_rk / pivot4
    ud3_4 = nu5_y*u3_6 - neg_ud4_5*neg_u3_5
    u3_4 = ipivot4*ud3_4
    ud2_4 = m2_4 + nu5_y*u2_6 + neg_ud4_5*u2_5
    u2_4 = ipivot4*ud2_4
    ud1_4 = m1_4 - nu5_y*neg_u1_6 + neg_ud4_5*u1_5
    u1_4 = ipivot4*ud1_4
    neg_pivot3 = neg_fu5_y*u3_6 - 19.732838668844984_rk + neg_ud3_5*neg_u3_5 + ud3_4*u3_4
    neg_ipivot3 = 1.0_rk / neg_pivot3
    neg_ud2_3 = h3_x + neg_fu5_y*u2_6 - neg_ud3_5*u2_5 + ud3_4*u2_4
    u2_3 = neg_ipivot3*neg_ud2_3
    neg_ud1_3 = neg_m1_3 - neg_fu5_y*neg_u1_6 - neg_ud3_5*u1_5 + ud3_4*u1_4
    u1_3 = neg_ipivot3*neg_ud1_3
    neg_pivot2 = neg_m2_2 + m2_6*u2_6 + ud2_5*u2_5 + ud2_4*u2_4 - neg_ud2_3*u2_3
    neg_ipivot2 = 1.0_rk / neg_pivot2
    ud1_2 = m1_2 + m2_6*neg_u1_6 - ud2_5*u1_5 - ud2_4*u1_4 + neg_ud2_3*u1_3
    neg_u1_2 = neg_ipivot2*ud1_2
    pivot1 = m1_1 - neg_m1_6*neg_u1_6 - ud1_5*u1_5 - ud1_4*u1_4 + neg_ud1_3*u1_3 + ud1_2*neg_u1_2
    ipivot1 = 1.0_rk / pivot1
    ! link 5: forward substitution
    neg_y5 = n5_z - tau(5) - neg_y6*u5_6
    ! link 4: forward substitution
    neg_y4 = n4_z - tau(4) + neg_y6*neg_u4_6 + neg_u4_5*neg_y5
    ! link 3: forward substitution
    neg_y3 = f3_z - tau(3) - neg_y6*u3_6 + neg_u3_5*neg_y5 - u3_4*neg_y4
    ! link 2: forward substitution
    neg_y2 = n2_z - tau(2) - neg_y6*u2_6 - u2_5*neg_y5 - u2_4*neg_y4 - u2_3*neg_y3
    ! link 1: forward substitution
    neg_y1 = n1_z - tau(1) + neg_y6*neg_u1_6 - u1_5*neg_y5 - u1_4*neg_y4 - u1_3*neg_y3 + &
        neg_u1_2*neg_y2
    ! link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    neg_qdd1 = ipivot1*neg_y1
    ! link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd2 = neg_ipivot2*neg_y2 - neg_u1_2*neg_qdd1
    ! link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd3 = neg_ipivot3*neg_y3 - u2_3*qdd2 + u1_3*neg_qdd1
    ! link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    neg_qdd4 = ipivot4*neg_y4 + u3_4*qdd3 + u2_4*qdd2 - u1_4*neg_qdd1
    ! link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd5 = u1_5*neg_qdd1 - (ipivot5*neg_y5 + neg_u4_5*neg_qdd4 - neg_u3_5*qdd3 + u2_5*qdd2)
    ! link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd6 = -1.4447795121770373_rk*neg_y6 - u5_6*qdd5 - neg_u4_6*neg_qdd4 - u3_6*qdd3 - u2_6*qdd2 - &
        neg_u1_6*neg_qdd1
    t66 = -neg_qdd1
    t67 = -neg_qdd4
    qdd(1) = t66
    qdd(2) = qdd2
    qdd(3) = qdd3
    qdd(4) = t67
    qdd(5) = qdd5
    qdd(6) = qdd6
  end subroutine
end module
