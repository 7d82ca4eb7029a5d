! puma560_full: PUMA 560 geometry, random full inertias
! Numbers: Table 2.1 geometry; masses, centres and inertias drawn at random: a test of generic
!   parameters
! Written by robodyn; do not edit, generate again.
!
! Joints, base to tip: 1 revolute, 2 revolute, 3 revolute, 4 revolute, 5 revolute, 6 revolute
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
!
! Operations (every binary * is a multiplication, every binary + or - an addition):
!   inverse_dynamics: 262 multiplications, 243 additions = 505; 5 unary minus; 10 sine/cosine
!   gravity: 42 multiplications, 25 additions = 67; 0 unary minus; 10 sine/cosine
!   bias: 244 multiplications, 211 additions = 455; 8 unary minus; 10 sine/cosine
!   mass_matrix: 141 multiplications, 125 additions = 266; 3 unary minus; 10 sine/cosine
!   forward_dynamics: 469 multiplications, 406 additions, 6 divisions = 881; 15 unary minus; 10
!       sine/cosine
module puma560_full_dynamics
  use, intrinsic :: iso_c_binding, only: rk => c_double
  implicit none
  private

  public :: puma560_full_inverse_dynamics
  public :: puma560_full_gravity
  public :: puma560_full_bias
  public :: puma560_full_mass_matrix
  public :: puma560_full_forward_dynamics

contains

  ! torques that give the accelerations qdd
  ! 262 multiplications, 243 additions = 505; 5 unary minus; 10 sine/cosine
  pure subroutine puma560_full_inverse_dynamics(q, qd, qdd, tau) &
      bind(c, name="puma560_full_inverse_dynamics_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(in) :: qdd(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: c2, s2, c4, s4, c5, s5, c6, s6, angle23, c23, s23, w3_z, alpha3_z, ww1_zz, neg_a2_z
    real(rk) :: t1, w2_x, w2_y, t2, neg_a2_x, a2_y, ww2_yz, ww2_zx, alpha2_x, neg_alpha2_y, ww2_xy
    real(rk) :: ww2_xx, ww2_yy, ww2_zz, neg_lam2_11, lam2_12, lam2_13, lam2_21, neg_lam2_22
    real(rk) :: lam2_23, lam2_31, lam2_32, neg_lam2_33, a3_z, w3_x, w3_y, t3, t4, t5, t6, neg_a3_x
    real(rk) :: a3_y, ww3_yz, ww3_zx, alpha3_x, neg_alpha3_y, ww3_xy, ww3_xx, ww3_yy, ww3_zz
    real(rk) :: neg_lam3_11, lam3_12, lam3_13, lam3_21, neg_lam3_22, lam3_23, lam3_31, lam3_32
    real(rk) :: neg_lam3_33, a4_z, w4_x, w4_y, t7, t8, a4_x, a4_y, alpha4_x, alpha4_y, alpha4_z
    real(rk) :: w4_z, ww4_yz, ww4_zx, ww4_xy, ww4_xx, ww4_yy, ww4_zz, neg_lam4_11, lam4_12, lam4_13
    real(rk) :: lam4_21, neg_lam4_22, lam4_23, lam4_31, lam4_32, neg_lam4_33, w5_x, t9, w5_y, a5_x
    real(rk) :: a5_y, alpha5_x, alpha5_y, alpha5_z, w5_z, ww5_yz, ww5_zx, ww5_xy, ww5_xx, ww5_yy
    real(rk) :: ww5_zz, neg_lam5_11, lam5_12, lam5_13, lam5_21, neg_lam5_22, lam5_23, neg_lam5_31
    real(rk) :: lam5_32, neg_lam5_33, w6_x, w6_y, a6_x, a6_y, alpha6_x, alpha6_y, alpha6_z, w6_z
    real(rk) :: ww6_yz, ww6_zx, ww6_xy, ww6_xx, ww6_yy, ww6_zz, neg_lam6_11, lam6_12, lam6_13
    real(rk) :: lam6_21, neg_lam6_22, lam6_23, neg_lam6_31, lam6_32, neg_lam6_33, nc1_z, fc2_x
    real(rk) :: fc2_y, nc2_x, nc2_y, t10, nc2_z, fc3_x, fc3_y, fc3_z, nc3_x, nc3_y, t11, nc3_z
    real(rk) :: fc4_x, fc4_y, fc4_z, nc4_x, nc4_y, t12, nc4_z, fc5_x, fc5_y, fc5_z, neg_nc5_x
    real(rk) :: nc5_y, t13, nc5_z, fc6_x, fc6_y, fc6_z, nc6_x, nc6_y, t14, nc6_z, f06_x, f06_y
    real(rk) :: n06_x, n06_y, n5_x, n5_y, n5_z, f5_x, f5_y, f5_z, f05_x, f05_y, n05_x, n05_y, n4_x
    real(rk) :: n4_y, n4_z, f4_x, f4_y, f4_z, f04_x, f04_y, n04_x, n04_y, n3_x, n3_y, n3_z, f3_x
    real(rk) :: f3_y, f3_z, f03_x, f03_y, n03_y, t15, n02_y, n02_z, f02_x, n1_z

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    c4 = cos(q(4))
    s4 = sin(q(4))
    c5 = cos(q(5))
    s5 = sin(q(5))
    c6 = cos(q(6))
    s6 = sin(q(6))
    angle23 = q(2) + q(3)
    c23 = cos(angle23)
    s23 = sin(angle23)
    ! link 3: angular velocity [rad/s]
    w3_z = qd(2) + qd(3)
    ! link 3: angular acceleration [rad/s^2]
    alpha3_z = qdd(2) + qdd(3)
    ! link 1: products of the angular velocity [1/s^2]
    ww1_zz = qd(1)*qd(1)
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a2_z = 0.1501_rk*ww1_zz
    t1 = -qd(1)
    ! link 2: angular velocity [rad/s]
    w2_x = t1*s2
    w2_y = t1*c2
    t2 = 0.1501_rk*qdd(1)
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a2_x = c2*t2 + 9.8_rk*s2
    a2_y = s2*t2 - 9.8_rk*c2
    ! link 2: products of the angular velocity [1/s^2]
    ww2_yz = qd(2)*w2_y
    ww2_zx = qd(2)*w2_x
    ! link 2: angular acceleration [rad/s^2]
    alpha2_x = ww2_yz - qdd(1)*s2
    neg_alpha2_y = qdd(1)*c2 + ww2_zx
    ! link 2: products of the angular velocity [1/s^2]
    ww2_xy = w2_x*w2_y
    ww2_xx = w2_x*w2_x
    ww2_yy = w2_y*w2_y
    ww2_zz = qd(2)*qd(2)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_11 = ww2_yy + ww2_zz
    lam2_12 = ww2_xy - qdd(2)
    lam2_13 = ww2_zx - neg_alpha2_y
    lam2_21 = qdd(2) + ww2_xy
    neg_lam2_22 = ww2_xx + ww2_zz
    lam2_23 = ww2_yz - alpha2_x
    lam2_31 = ww2_zx + neg_alpha2_y
    lam2_32 = ww2_yz + alpha2_x
    neg_lam2_33 = ww2_xx + ww2_yy
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_z = 0.4318_rk*lam2_31 - neg_a2_z
    ! link 3: angular velocity [rad/s]
    w3_x = t1*s23
    w3_y = t1*c23
    t3 = 0.4318_rk*neg_lam2_11
    t4 = 0.4318_rk*lam2_21
    t5 = t2 + (c2*t3 + s2*t4)
    t6 = s2*t3 - c2*t4 + 9.8_rk
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a3_x = c23*t5 + s23*t6
    a3_y = s23*t5 - c23*t6
    ! link 3: products of the angular velocity [1/s^2]
    ww3_yz = w3_z*w3_y
    ww3_zx = w3_z*w3_x
    ! link 3: angular acceleration [rad/s^2]
    alpha3_x = ww3_yz - qdd(1)*s23
    neg_alpha3_y = qdd(1)*c23 + ww3_zx
    ! link 3: products of the angular velocity [1/s^2]
    ww3_xy = w3_x*w3_y
    ww3_xx = w3_x*w3_x
    ww3_yy = w3_y*w3_y
    ww3_zz = w3_z*w3_z
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_11 = ww3_yy + ww3_zz
    lam3_12 = ww3_xy - alpha3_z
    lam3_13 = ww3_zx - neg_alpha3_y
    lam3_21 = alpha3_z + ww3_xy
    neg_lam3_22 = ww3_xx + ww3_zz
    lam3_23 = ww3_yz - alpha3_x
    lam3_31 = ww3_zx + neg_alpha3_y
    lam3_32 = ww3_yz + alpha3_x
    neg_lam3_33 = ww3_xx + ww3_yy
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_z = 0.0203_rk*lam3_21 - 0.4331_rk*neg_lam3_22 - a3_y
    ! link 4: angular velocity [rad/s]
    w4_x = c4*w3_x + s4*w3_z
    w4_y = c4*w3_z - s4*w3_x
    t7 = a3_z + (-0.0203_rk*lam3_31 - 0.4331_rk*lam3_32)
    t8 = neg_a3_x + (0.4331_rk*lam3_12 - 0.0203_rk*neg_lam3_11)
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_x = s4*t7 - c4*t8
    a4_y = s4*t8 + c4*t7
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = qd(4)*w4_y - (-s4*alpha3_z - c4*alpha3_x)
    alpha4_y = c4*alpha3_z - s4*alpha3_x - qd(4)*w4_x
    alpha4_z = qdd(4) + neg_alpha3_y
    ! link 4: angular velocity [rad/s]
    w4_z = qd(4) - w3_y
    ! link 4: products of the angular velocity [1/s^2]
    ww4_yz = w4_y*w4_z
    ww4_zx = w4_x*w4_z
    ww4_xy = w4_x*w4_y
    ww4_xx = w4_x*w4_x
    ww4_yy = w4_y*w4_y
    ww4_zz = w4_z*w4_z
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam4_11 = ww4_yy + ww4_zz
    lam4_12 = ww4_xy - alpha4_z
    lam4_13 = alpha4_y + ww4_zx
    lam4_21 = alpha4_z + ww4_xy
    neg_lam4_22 = ww4_xx + ww4_zz
    lam4_23 = ww4_yz - alpha4_x
    lam4_31 = ww4_zx - alpha4_y
    lam4_32 = alpha4_x + ww4_yz
    neg_lam4_33 = ww4_xx + ww4_yy
    ! link 5: angular velocity [rad/s]
    w5_x = c5*w4_x - s5*w4_z
    t9 = -c5
    w5_y = t9*w4_z - s5*w4_x
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_x = c5*a4_x - s5*a4_z
    a5_y = t9*a4_z - s5*a4_x
    ! link 5: angular acceleration [rad/s^2]
    alpha5_x = qd(5)*w5_y - (s5*alpha4_z - c5*alpha4_x)
    alpha5_y = t9*alpha4_z - s5*alpha4_x - qd(5)*w5_x
    alpha5_z = qdd(5) + alpha4_y
    ! link 5: angular velocity [rad/s]
    w5_z = qd(5) + w4_y
    ! link 5: products of the angular velocity [1/s^2]
    ww5_yz = w5_y*w5_z
    ww5_zx = w5_x*w5_z
    ww5_xy = w5_x*w5_y
    ww5_xx = w5_x*w5_x
    ww5_yy = w5_y*w5_y
    ww5_zz = w5_z*w5_z
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_11 = ww5_yy + ww5_zz
    lam5_12 = ww5_xy - alpha5_z
    lam5_13 = alpha5_y + ww5_zx
    lam5_21 = alpha5_z + ww5_xy
    neg_lam5_22 = ww5_xx + ww5_zz
    lam5_23 = ww5_yz - alpha5_x
    neg_lam5_31 = alpha5_y - ww5_zx
    lam5_32 = alpha5_x + ww5_yz
    neg_lam5_33 = ww5_xx + ww5_yy
    ! link 6: angular velocity [rad/s]
    w6_x = c6*w5_x + s6*w5_z
    w6_y = c6*w5_z - s6*w5_x
    ! link 6: acceleration of the frame's origin, gravity taken off [m/s^2]
    a6_x = c6*a5_x + s6*a4_y
    a6_y = c6*a4_y - s6*a5_x
    ! link 6: angular acceleration [rad/s^2]
    alpha6_x = qd(6)*w6_y - (-s6*alpha5_z - c6*alpha5_x)
    alpha6_y = c6*alpha5_z - s6*alpha5_x - qd(6)*w6_x
    alpha6_z = qdd(6) - alpha5_y
    ! link 6: angular velocity [rad/s]
    w6_z = qd(6) - w5_y
    ! link 6: products of the angular velocity [1/s^2]
    ww6_yz = w6_y*w6_z
    ww6_zx = w6_x*w6_z
    ww6_xy = w6_x*w6_y
    ww6_xx = w6_x*w6_x
    ww6_yy = w6_y*w6_y
    ww6_zz = w6_z*w6_z
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam6_11 = ww6_yy + ww6_zz
    lam6_12 = ww6_xy - alpha6_z
    lam6_13 = alpha6_y + ww6_zx
    lam6_21 = alpha6_z + ww6_xy
    neg_lam6_22 = ww6_xx + ww6_zz
    lam6_23 = ww6_yz - alpha6_x
    neg_lam6_31 = alpha6_y - ww6_zx
    lam6_32 = alpha6_x + ww6_yz
    neg_lam6_33 = ww6_xx + ww6_yy
    ! link 1: moment that turns the link [N m]
    nc1_z = 2.629303206180387_rk*qdd(1)
    ! link 2: force that moves the link [N]
    fc2_x = 0.1606745919581151_rk*lam2_12 - 7.6631781603519995_rk*neg_lam2_11
    fc2_y = 7.6631781603519995_rk*lam2_21 - 0.1606745919581151_rk*neg_lam2_22
    ! link 2: moment that turns the link [N m]
    nc2_x = -0.024117256252913073_rk*ww1_zz - (-0.20730445403579364_rk*lam2_32 - &
        0.0507946745483177_rk*(neg_lam2_22 - neg_lam2_33) + (0.017097472943757824_rk*lam2_21 - &
        0.1174059800416141_rk*lam2_31))
    nc2_y = -3.522577799201274_rk*lam2_31 - 0.017097472943757824_rk*(neg_lam2_11 - neg_lam2_33) - &
        (0.1174059800416141_rk*lam2_32 - 0.0507946745483177_rk*lam2_12) + &
        1.1502430418688352_rk*ww1_zz
    t10 = 3.522577799201274_rk*lam2_21 - 0.20730445403579364_rk*lam2_12 + &
        0.1174059800416141_rk*(neg_lam2_11 - neg_lam2_22) - (0.0507946745483177_rk*lam2_13 - &
        0.017097472943757824_rk*lam2_23)
    nc2_z = t10 + (7.6631781603519995_rk*a2_y + 0.1606745919581151_rk*neg_a2_x)
    ! link 3: force that moves the link [N]
    fc3_x = -1.046378600789203_rk*neg_lam3_11 - 5.729293810689829_rk*lam3_12
    fc3_y = 1.046378600789203_rk*lam3_21 + 5.729293810689829_rk*neg_lam3_22
    fc3_z = 1.046378600789203_rk*lam3_31 - 5.729293810689829_rk*lam3_32
    ! link 3: moment that turns the link [N m]
    nc3_x = -5.729293810689829_rk*a3_z - (-3.4805327967608957_rk*lam3_32 - &
        0.060845712710754084_rk*(neg_lam3_22 - neg_lam3_33) + (0.01894848286257894_rk*lam3_21 - &
        0.28615890025504537_rk*lam3_31))
    nc3_y = -0.47176417886368593_rk*lam3_31 - 0.01894848286257894_rk*(neg_lam3_11 - neg_lam3_33) - &
        (0.28615890025504537_rk*lam3_32 - 0.060845712710754084_rk*lam3_12) - &
        1.046378600789203_rk*a3_z
    t11 = 0.47176417886368593_rk*lam3_21 - 3.4805327967608957_rk*lam3_12 + &
        0.28615890025504537_rk*(neg_lam3_11 - neg_lam3_22) - (0.060845712710754084_rk*lam3_13 - &
        0.01894848286257894_rk*lam3_23)
    nc3_z = t11 + (1.046378600789203_rk*a3_y - 5.729293810689829_rk*neg_a3_x)
    ! link 4: force that moves the link [N]
    fc4_x = 0.8719880516308344_rk*lam4_12 - 0.7777930398944852_rk*neg_lam4_11
    fc4_y = 0.7777930398944852_rk*lam4_21 - 0.8719880516308344_rk*neg_lam4_22
    fc4_z = 0.7777930398944852_rk*lam4_31 + 0.8719880516308344_rk*lam4_32
    ! link 4: moment that turns the link [N m]
    nc4_x = 0.8719880516308344_rk*a4_z - (-0.2788425785236688_rk*lam4_32 - &
        0.10734691974802549_rk*(neg_lam4_22 - neg_lam4_33) + (0.2837491060266096_rk*lam4_21 - &
        0.05337162017689789_rk*lam4_31))
    nc4_y = -0.3473260245772809_rk*lam4_31 - 0.2837491060266096_rk*(neg_lam4_11 - neg_lam4_33) - &
        (0.05337162017689789_rk*lam4_32 - 0.10734691974802549_rk*lam4_12) - &
        0.7777930398944852_rk*a4_z
    t12 = 0.3473260245772809_rk*lam4_21 - 0.2788425785236688_rk*lam4_12 + &
        0.05337162017689789_rk*(neg_lam4_11 - neg_lam4_22) + (0.2837491060266096_rk*lam4_23 - &
        0.10734691974802549_rk*lam4_13)
    nc4_z = t12 + (0.7777930398944852_rk*a4_y - 0.8719880516308344_rk*a4_x)
    ! link 5: force that moves the link [N]
    fc5_x = 0.47660058733283606_rk*neg_lam5_11 - 0.15165250821211493_rk*lam5_12
    fc5_y = 0.15165250821211493_rk*neg_lam5_22 - 0.47660058733283606_rk*lam5_21
    fc5_z = 0.47660058733283606_rk*neg_lam5_31 - 0.15165250821211493_rk*lam5_32
    ! link 5: moment that turns the link [N m]
    neg_nc5_x = 0.18116108322165295_rk*(neg_lam5_22 - neg_lam5_33) - 0.3901127773977262_rk*lam5_32 &
        + (0.08058935149735619_rk*neg_lam5_31 - 0.1558184212675505_rk*lam5_21) + &
        0.15165250821211493_rk*a4_y
    nc5_y = 0.1513642331069161_rk*neg_lam5_31 + 0.1558184212675505_rk*(neg_lam5_11 - neg_lam5_33) &
        + (-0.18116108322165295_rk*lam5_12 - 0.08058935149735619_rk*lam5_32) + &
        0.47660058733283606_rk*a4_y
    t13 = 0.1513642331069161_rk*lam5_21 - 0.3901127773977262_rk*lam5_12 - &
        0.08058935149735619_rk*(neg_lam5_22 - neg_lam5_11) - (0.1558184212675505_rk*lam5_23 - &
        0.18116108322165295_rk*lam5_13)
    nc5_z = t13 - (0.47660058733283606_rk*a5_y - 0.15165250821211493_rk*a5_x)
    ! link 6: force that moves the link [N]
    fc6_x = 1.1185374890947408_rk*neg_lam6_11 + 1.2975168001325401_rk*lam6_12
    fc6_y = -1.2975168001325401_rk*neg_lam6_22 - 1.1185374890947408_rk*lam6_21
    fc6_z = 1.1185374890947408_rk*neg_lam6_31 + 1.2975168001325401_rk*lam6_32
    ! link 6: moment that turns the link [N m]
    nc6_x = -1.2975168001325401_rk*a5_y - (0.2519035474197792_rk*(neg_lam6_22 - neg_lam6_33) - &
        0.43637196239865417_rk*lam6_32 - (0.4019452224328564_rk*neg_lam6_31 - &
        0.1902613160848803_rk*lam6_21))
    nc6_y = 0.4714480390546099_rk*neg_lam6_31 - 0.1902613160848803_rk*(neg_lam6_11 - neg_lam6_33) &
        + (0.4019452224328564_rk*lam6_32 - 0.2519035474197792_rk*lam6_12) - &
        1.1185374890947408_rk*a5_y
    t14 = 0.4714480390546099_rk*lam6_21 - 0.43637196239865417_rk*lam6_12 - &
        0.4019452224328564_rk*(neg_lam6_11 - neg_lam6_22) + (0.1902613160848803_rk*lam6_23 + &
        0.2519035474197792_rk*lam6_13)
    nc6_z = t14 - (1.1185374890947408_rk*a6_y + 1.2975168001325401_rk*a6_x)
    ! link 6: force through the joint, along the axes that its turn starts from [N]
    f06_x = c6*fc6_x - s6*fc6_y
    f06_y = s6*fc6_x + c6*fc6_y
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    n06_x = c6*nc6_x - s6*nc6_y
    n06_y = s6*nc6_x + c6*nc6_y
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_x = n06_x - neg_nc5_x
    n5_y = nc5_y - nc6_z
    n5_z = nc5_z + n06_y
    ! link 5: force through the joint [N]
    f5_x = fc5_x + f06_x
    f5_y = fc5_y - fc6_z
    f5_z = fc5_z + f06_y
    ! link 5: force through the joint, along the axes that its turn starts from [N]
    f05_x = c5*f5_x - s5*f5_y
    f05_y = s5*f5_x + c5*f5_y
    ! link 5: moment through the joint, along the axes that its turn starts from [N m]
    n05_x = c5*n5_x - s5*n5_y
    n05_y = s5*n5_x + c5*n5_y
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = nc4_x + n05_x
    n4_y = nc4_y + n5_z
    n4_z = nc4_z - n05_y
    ! link 4: force through the joint [N]
    f4_x = fc4_x + f05_x
    f4_y = fc4_y + f5_z
    f4_z = fc4_z - f05_y
    ! link 4: force through the joint, along the axes that its turn starts from [N]
    f04_x = c4*f4_x - s4*f4_y
    f04_y = s4*f4_x + c4*f4_y
    ! link 4: moment through the joint, along the axes that its turn starts from [N m]
    n04_x = c4*n4_x - s4*n4_y
    n04_y = s4*n4_x + c4*n4_y
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_x = n04_x + (nc3_x - 0.4331_rk*f04_y)
    n3_y = nc3_y + 0.0203_rk*f04_y - n4_z
    n3_z = n04_y + (nc3_z - (-0.4331_rk*f04_x - 0.0203_rk*f4_z))
    ! link 3: force through the joint [N]
    f3_x = fc3_x + f04_x
    f3_y = fc3_y - f4_z
    f3_z = fc3_z + f04_y
    ! link 3: force through the joint, along the axes that its turn starts from [N]
    f03_x = c23*f3_x - s23*f3_y
    f03_y = s23*f3_x + c23*f3_y
    ! link 3: moment through the joint, along the axes that its turn starts from [N m]
    n03_y = s23*n3_x + c23*n3_y
    t15 = 0.4318_rk*c2
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_y = n03_y - (-c2*nc2_y - s2*nc2_x + f3_z*t15)
    n02_z = n3_z + (nc2_z - (f03_x*(0.4318_rk*s2) - f03_y*t15))
    ! link 2: force through the joint, along the axes that its turn starts from [N]
    f02_x = f03_x - (s2*fc2_y - c2*fc2_x)
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = nc1_z - 0.1501_rk*f02_x - n02_y
    tau(1) = n1_z
    tau(2) = n02_z
    tau(3) = n3_z
    tau(4) = n4_z
    tau(5) = n5_z
    tau(6) = nc6_z
  end subroutine

  ! torques that hold the arm at rest
  ! 42 multiplications, 25 additions = 67; 0 unary minus; 10 sine/cosine
  pure subroutine puma560_full_gravity(q, tau) &
      bind(c, name="puma560_full_gravity_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: c2, s2, c4, s4, c5, s5, c6, s6, angle23, c23, s23, neg_a3_x, neg_a3_y, neg_a4_x
    real(rk) :: a4_y, neg_a5_x, neg_a5_y, a6_x, a6_y, nc2_z, neg_nc3_z, nc4_x, neg_nc4_y, nc4_z
    real(rk) :: neg_nc5_x, nc5_y, nc5_z, nc6_x, nc6_y, nc6_z, n06_x, n06_y, neg_n5_x, n5_y, n5_z
    real(rk) :: neg_n05_x, n05_y, n4_x, neg_n4_y, n4_z, n04_x, n04_y, n3_z, neg_n03_y, n02_z

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    c4 = cos(q(4))
    s4 = sin(q(4))
    c5 = cos(q(5))
    s5 = sin(q(5))
    c6 = cos(q(6))
    s6 = sin(q(6))
    angle23 = q(2) + q(3)
    c23 = cos(angle23)
    s23 = sin(angle23)
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a3_x = 9.8_rk*s23
    neg_a3_y = 9.8_rk*c23
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a4_x = c4*neg_a3_x
    a4_y = s4*neg_a3_x
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a5_x = c5*neg_a4_x + s5*neg_a3_y
    neg_a5_y = c5*neg_a3_y - s5*neg_a4_x
    ! link 6: acceleration of the frame's origin, gravity taken off [m/s^2]
    a6_x = s6*a4_y - c6*neg_a5_x
    a6_y = s6*neg_a5_x + c6*a4_y
    ! link 2: moment that turns the link [N m]
    nc2_z = 1.5746110011895278_rk*s2 - 75.09914597144959_rk*c2
    ! link 3: moment that turns the link [N m]
    neg_nc3_z = 10.254510287734192_rk*c23 + 56.14707934476033_rk*s23
    ! link 4: moment that turns the link [N m]
    nc4_x = 8.545482905982176_rk*c23
    neg_nc4_y = 7.622371790965955_rk*c23
    nc4_z = 0.7777930398944852_rk*a4_y + 0.8719880516308344_rk*neg_a4_x
    ! link 5: moment that turns the link [N m]
    neg_nc5_x = 0.15165250821211493_rk*a4_y
    nc5_y = 0.47660058733283606_rk*a4_y
    nc5_z = 0.47660058733283606_rk*neg_a5_y - 0.15165250821211493_rk*neg_a5_x
    ! link 6: moment that turns the link [N m]
    nc6_x = 1.2975168001325401_rk*neg_a5_y
    nc6_y = 1.1185374890947408_rk*neg_a5_y
    nc6_z = -1.2975168001325401_rk*a6_x - 1.1185374890947408_rk*a6_y
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    n06_x = c6*nc6_x - s6*nc6_y
    n06_y = s6*nc6_x + c6*nc6_y
    ! link 5: moment through the joint, about the frame's origin [N m]
    neg_n5_x = neg_nc5_x - n06_x
    n5_y = nc5_y - nc6_z
    n5_z = nc5_z + n06_y
    ! link 5: moment through the joint, along the axes that its turn starts from [N m]
    neg_n05_x = c5*neg_n5_x + s5*n5_y
    n05_y = c5*n5_y - s5*neg_n5_x
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = nc4_x - neg_n05_x
    neg_n4_y = neg_nc4_y - n5_z
    n4_z = nc4_z - n05_y
    ! link 4: moment through the joint, along the axes that its turn starts from [N m]
    n04_x = c4*n4_x + s4*neg_n4_y
    n04_y = s4*n4_x - c4*neg_n4_y
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_z = n04_y - neg_nc3_z
    ! link 3: moment through the joint, along the axes that its turn starts from [N m]
    neg_n03_y = c23*n4_z - s23*n04_x
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_z = nc2_z + n3_z
    tau(1) = neg_n03_y
    tau(2) = n02_z
    tau(3) = n3_z
    tau(4) = n4_z
    tau(5) = n5_z
    tau(6) = nc6_z
  end subroutine

  ! torques at zero acceleration: Coriolis, centrifugal, gravity, friction
  ! 244 multiplications, 211 additions = 455; 8 unary minus; 10 sine/cosine
  pure subroutine puma560_full_bias(q, qd, tau) &
      bind(c, name="puma560_full_bias_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: c2, s2, c4, s4, c5, s5, c6, s6, angle23, c23, s23, w3_z, ww1_zz, a2_z, neg_w2_x
    real(rk) :: neg_w2_y, neg_alpha2_x, alpha2_y, ww2_xy, ww2_xx, ww2_yy, ww2_zz, neg_lam2_11
    real(rk) :: neg_lam2_22, neg_lam2_33, a3_z, t1, w3_x, w3_y, t2, t3, t4, t5, neg_a3_x, a3_y
    real(rk) :: alpha3_x, alpha3_y, ww3_xy, ww3_xx, ww3_yy, ww3_zz, neg_lam3_11, neg_lam3_22
    real(rk) :: neg_lam3_33, a4_z, w4_x, w4_y, t6, t7, a4_x, a4_y, alpha4_x, alpha4_y, w4_z, ww4_yz
    real(rk) :: ww4_zx, ww4_xy, ww4_xx, ww4_yy, ww4_zz, neg_lam4_11, lam4_12, lam4_13, lam4_21
    real(rk) :: neg_lam4_22, lam4_23, lam4_31, lam4_32, neg_lam4_33, w5_x, t8, w5_y, a5_x, a5_y
    real(rk) :: alpha5_x, alpha5_y, w5_z, ww5_yz, ww5_zx, ww5_xy, ww5_xx, ww5_yy, ww5_zz
    real(rk) :: neg_lam5_11, lam5_12, lam5_13, lam5_21, neg_lam5_22, lam5_23, neg_lam5_31, lam5_32
    real(rk) :: neg_lam5_33, w6_x, w6_y, t9, neg_a6_x, a6_y, alpha6_x, alpha6_y, w6_z, ww6_yz
    real(rk) :: ww6_zx, ww6_xy, ww6_xx, ww6_yy, ww6_zz, neg_lam6_11, lam6_12, lam6_13, lam6_21
    real(rk) :: neg_lam6_22, lam6_23, neg_lam6_31, lam6_32, neg_lam6_33, fc2_x, fc2_y, nc2_x, nc2_y
    real(rk) :: nc2_z, fc3_x, fc3_y, fc3_z, nc3_x, nc3_y, nc3_z, fc4_x, fc4_y, fc4_z, nc4_x, nc4_y
    real(rk) :: t10, nc4_z, fc5_x, fc5_y, fc5_z, neg_nc5_x, nc5_y, t11, nc5_z, fc6_x, fc6_y, fc6_z
    real(rk) :: nc6_x, nc6_y, t12, nc6_z, f06_x, f06_y, n06_x, n06_y, n5_x, n5_y, n5_z, f5_x, f5_y
    real(rk) :: f5_z, f05_x, f05_y, n05_x, n05_y, n4_x, n4_y, n4_z, f4_x, f4_y, f4_z, f04_x
    real(rk) :: neg_f04_y, n04_x, n04_y, n3_x, n3_y, n3_z, f3_x, f3_y, f3_z, f03_x, f03_y, n03_y
    real(rk) :: t13, n02_y, n02_z, neg_f02_x, n1_z

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    c4 = cos(q(4))
    s4 = sin(q(4))
    c5 = cos(q(5))
    s5 = sin(q(5))
    c6 = cos(q(6))
    s6 = sin(q(6))
    angle23 = q(2) + q(3)
    c23 = cos(angle23)
    s23 = sin(angle23)
    ! link 3: angular velocity [rad/s]
    w3_z = qd(2) + qd(3)
    ! link 1: products of the angular velocity [1/s^2]
    ww1_zz = qd(1)*qd(1)
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    a2_z = -0.1501_rk*ww1_zz
    ! link 2: angular velocity [rad/s]
    neg_w2_x = qd(1)*s2
    neg_w2_y = qd(1)*c2
    ! link 2: angular acceleration [rad/s^2]
    neg_alpha2_x = qd(2)*neg_w2_y
    alpha2_y = qd(2)*neg_w2_x
    ! link 2: products of the angular velocity [1/s^2]
    ww2_xy = neg_w2_x*neg_w2_y
    ww2_xx = neg_w2_x*neg_w2_x
    ww2_yy = neg_w2_y*neg_w2_y
    ww2_zz = qd(2)*qd(2)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_11 = ww2_yy + ww2_zz
    neg_lam2_22 = ww2_xx + ww2_zz
    neg_lam2_33 = ww2_xx + ww2_yy
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_z = a2_z - 0.8636_rk*alpha2_y
    t1 = -qd(1)
    ! link 3: angular velocity [rad/s]
    w3_x = t1*s23
    w3_y = t1*c23
    t2 = 0.4318_rk*neg_lam2_11
    t3 = 0.4318_rk*ww2_xy
    t4 = c2*t2 + s2*t3
    t5 = s2*t2 - c2*t3 + 9.8_rk
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a3_x = c23*t4 + s23*t5
    a3_y = s23*t4 - c23*t5
    ! link 3: angular acceleration [rad/s^2]
    alpha3_x = w3_z*w3_y
    alpha3_y = -w3_z*w3_x
    ! link 3: products of the angular velocity [1/s^2]
    ww3_xy = w3_x*w3_y
    ww3_xx = w3_x*w3_x
    ww3_yy = w3_y*w3_y
    ww3_zz = w3_z*w3_z
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_11 = ww3_yy + ww3_zz
    neg_lam3_22 = ww3_xx + ww3_zz
    neg_lam3_33 = ww3_xx + ww3_yy
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_z = 0.0203_rk*ww3_xy - 0.4331_rk*neg_lam3_22 - a3_y
    ! link 4: angular velocity [rad/s]
    w4_x = c4*w3_x + s4*w3_z
    w4_y = c4*w3_z - s4*w3_x
    t6 = a3_z + (0.0406_rk*alpha3_y - 0.8662_rk*alpha3_x)
    t7 = neg_a3_x + (0.4331_rk*ww3_xy - 0.0203_rk*neg_lam3_11)
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_x = s4*t6 - c4*t7
    a4_y = s4*t7 + c4*t6
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = c4*alpha3_x + qd(4)*w4_y
    alpha4_y = -qd(4)*w4_x - s4*alpha3_x
    ! link 4: angular velocity [rad/s]
    w4_z = qd(4) - w3_y
    ! link 4: products of the angular velocity [1/s^2]
    ww4_yz = w4_y*w4_z
    ww4_zx = w4_x*w4_z
    ww4_xy = w4_x*w4_y
    ww4_xx = w4_x*w4_x
    ww4_yy = w4_y*w4_y
    ww4_zz = w4_z*w4_z
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam4_11 = ww4_yy + ww4_zz
    lam4_12 = alpha3_y + ww4_xy
    lam4_13 = alpha4_y + ww4_zx
    lam4_21 = ww4_xy - alpha3_y
    neg_lam4_22 = ww4_xx + ww4_zz
    lam4_23 = ww4_yz - alpha4_x
    lam4_31 = ww4_zx - alpha4_y
    lam4_32 = alpha4_x + ww4_yz
    neg_lam4_33 = ww4_xx + ww4_yy
    ! link 5: angular velocity [rad/s]
    w5_x = c5*w4_x - s5*w4_z
    t8 = -c5
    w5_y = t8*w4_z - s5*w4_x
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_x = c5*a4_x - s5*a4_z
    a5_y = t8*a4_z - s5*a4_x
    ! link 5: angular acceleration [rad/s^2]
    alpha5_x = qd(5)*w5_y - (-s5*alpha3_y - c5*alpha4_x)
    alpha5_y = c5*alpha3_y - s5*alpha4_x - qd(5)*w5_x
    ! link 5: angular velocity [rad/s]
    w5_z = qd(5) + w4_y
    ! link 5: products of the angular velocity [1/s^2]
    ww5_yz = w5_y*w5_z
    ww5_zx = w5_x*w5_z
    ww5_xy = w5_x*w5_y
    ww5_xx = w5_x*w5_x
    ww5_yy = w5_y*w5_y
    ww5_zz = w5_z*w5_z
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_11 = ww5_yy + ww5_zz
    lam5_12 = ww5_xy - alpha4_y
    lam5_13 = alpha5_y + ww5_zx
    lam5_21 = alpha4_y + ww5_xy
    neg_lam5_22 = ww5_xx + ww5_zz
    lam5_23 = ww5_yz - alpha5_x
    neg_lam5_31 = alpha5_y - ww5_zx
    lam5_32 = alpha5_x + ww5_yz
    neg_lam5_33 = ww5_xx + ww5_yy
    ! link 6: angular velocity [rad/s]
    w6_x = c6*w5_x + s6*w5_z
    w6_y = c6*w5_z - s6*w5_x
    t9 = -s6
    ! link 6: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a6_x = t9*a4_y - c6*a5_x
    a6_y = c6*a4_y - s6*a5_x
    ! link 6: angular acceleration [rad/s^2]
    alpha6_x = qd(6)*w6_y - (t9*alpha4_y - c6*alpha5_x)
    alpha6_y = c6*alpha4_y - s6*alpha5_x - qd(6)*w6_x
    ! link 6: angular velocity [rad/s]
    w6_z = qd(6) - w5_y
    ! link 6: products of the angular velocity [1/s^2]
    ww6_yz = w6_y*w6_z
    ww6_zx = w6_x*w6_z
    ww6_xy = w6_x*w6_y
    ww6_xx = w6_x*w6_x
    ww6_yy = w6_y*w6_y
    ww6_zz = w6_z*w6_z
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam6_11 = ww6_yy + ww6_zz
    lam6_12 = alpha5_y + ww6_xy
    lam6_13 = alpha6_y + ww6_zx
    lam6_21 = ww6_xy - alpha5_y
    neg_lam6_22 = ww6_xx + ww6_zz
    lam6_23 = ww6_yz - alpha6_x
    neg_lam6_31 = alpha6_y - ww6_zx
    lam6_32 = alpha6_x + ww6_yz
    neg_lam6_33 = ww6_xx + ww6_yy
    ! link 2: force that moves the link [N]
    fc2_x = 0.1606745919581151_rk*ww2_xy - 7.6631781603519995_rk*neg_lam2_11
    fc2_y = 7.6631781603519995_rk*ww2_xy - 0.1606745919581151_rk*neg_lam2_22
    ! link 2: moment that turns the link [N m]
    nc2_x = -0.024117256252913073_rk*ww1_zz - (0.4146089080715873_rk*neg_alpha2_x - &
        0.0507946745483177_rk*(neg_lam2_22 - neg_lam2_33) + (0.2348119600832282_rk*alpha2_y + &
        0.017097472943757824_rk*ww2_xy))
    nc2_y = 7.045155598402548_rk*alpha2_y - 0.017097472943757824_rk*(neg_lam2_11 - neg_lam2_33) + &
        (0.0507946745483177_rk*ww2_xy + 0.2348119600832282_rk*neg_alpha2_x) + &
        1.1502430418688352_rk*ww1_zz
    nc2_z = 3.31527334516548_rk*ww2_xy + 0.1174059800416141_rk*(neg_lam2_11 - neg_lam2_22) - &
        (75.09914597144959_rk*c2 - 1.5746110011895278_rk*s2)
    ! link 3: force that moves the link [N]
    fc3_x = -1.046378600789203_rk*neg_lam3_11 - 5.729293810689829_rk*ww3_xy
    fc3_y = 1.046378600789203_rk*ww3_xy + 5.729293810689829_rk*neg_lam3_22
    fc3_z = -11.458587621379658_rk*alpha3_x - 2.092757201578406_rk*alpha3_y
    ! link 3: moment that turns the link [N m]
    nc3_x = -5.729293810689829_rk*a3_z - (-6.961065593521791_rk*alpha3_x - &
        0.060845712710754084_rk*(neg_lam3_22 - neg_lam3_33) + (0.5723178005100907_rk*alpha3_y + &
        0.01894848286257894_rk*ww3_xy))
    nc3_y = 0.9435283577273719_rk*alpha3_y - 0.01894848286257894_rk*(neg_lam3_11 - neg_lam3_33) + &
        (0.060845712710754084_rk*ww3_xy - 0.5723178005100907_rk*alpha3_x) - &
        1.046378600789203_rk*a3_z
    nc3_z = 1.046378600789203_rk*a3_y - 5.729293810689829_rk*neg_a3_x - &
        (3.0087686178972097_rk*ww3_xy - 0.28615890025504537_rk*(neg_lam3_11 - neg_lam3_22))
    ! link 4: force that moves the link [N]
    fc4_x = 0.8719880516308344_rk*lam4_12 - 0.7777930398944852_rk*neg_lam4_11
    fc4_y = 0.7777930398944852_rk*lam4_21 - 0.8719880516308344_rk*neg_lam4_22
    fc4_z = 0.7777930398944852_rk*lam4_31 + 0.8719880516308344_rk*lam4_32
    ! link 4: moment that turns the link [N m]
    nc4_x = 0.8719880516308344_rk*a4_z - (-0.2788425785236688_rk*lam4_32 - &
        0.10734691974802549_rk*(neg_lam4_22 - neg_lam4_33) + (0.2837491060266096_rk*lam4_21 - &
        0.05337162017689789_rk*lam4_31))
    nc4_y = -0.3473260245772809_rk*lam4_31 - 0.2837491060266096_rk*(neg_lam4_11 - neg_lam4_33) + &
        (0.10734691974802549_rk*lam4_12 - 0.05337162017689789_rk*lam4_32) - &
        0.7777930398944852_rk*a4_z
    t10 = 0.2788425785236688_rk*lam4_12 - 0.3473260245772809_rk*lam4_21 - &
        0.05337162017689789_rk*(neg_lam4_11 - neg_lam4_22) - (0.2837491060266096_rk*lam4_23 - &
        0.10734691974802549_rk*lam4_13)
    nc4_z = 0.7777930398944852_rk*a4_y - 0.8719880516308344_rk*a4_x - t10
    ! link 5: force that moves the link [N]
    fc5_x = 0.47660058733283606_rk*neg_lam5_11 - 0.15165250821211493_rk*lam5_12
    fc5_y = 0.15165250821211493_rk*neg_lam5_22 - 0.47660058733283606_rk*lam5_21
    fc5_z = 0.47660058733283606_rk*neg_lam5_31 - 0.15165250821211493_rk*lam5_32
    ! link 5: moment that turns the link [N m]
    neg_nc5_x = 0.18116108322165295_rk*(neg_lam5_22 - neg_lam5_33) - 0.3901127773977262_rk*lam5_32 &
        + (0.08058935149735619_rk*neg_lam5_31 - 0.1558184212675505_rk*lam5_21) + &
        0.15165250821211493_rk*a4_y
    nc5_y = 0.1513642331069161_rk*neg_lam5_31 + 0.1558184212675505_rk*(neg_lam5_11 - neg_lam5_33) &
        + (-0.18116108322165295_rk*lam5_12 - 0.08058935149735619_rk*lam5_32) + &
        0.47660058733283606_rk*a4_y
    t11 = 0.1513642331069161_rk*lam5_21 - 0.3901127773977262_rk*lam5_12 - &
        0.08058935149735619_rk*(neg_lam5_22 - neg_lam5_11) - (0.1558184212675505_rk*lam5_23 - &
        0.18116108322165295_rk*lam5_13)
    nc5_z = t11 - (0.47660058733283606_rk*a5_y - 0.15165250821211493_rk*a5_x)
    ! link 6: force that moves the link [N]
    fc6_x = 1.1185374890947408_rk*neg_lam6_11 + 1.2975168001325401_rk*lam6_12
    fc6_y = -1.2975168001325401_rk*neg_lam6_22 - 1.1185374890947408_rk*lam6_21
    fc6_z = 1.1185374890947408_rk*neg_lam6_31 + 1.2975168001325401_rk*lam6_32
    ! link 6: moment that turns the link [N m]
    nc6_x = -1.2975168001325401_rk*a5_y - (0.2519035474197792_rk*(neg_lam6_22 - neg_lam6_33) - &
        0.43637196239865417_rk*lam6_32 - (0.4019452224328564_rk*neg_lam6_31 - &
        0.1902613160848803_rk*lam6_21))
    nc6_y = 0.4714480390546099_rk*neg_lam6_31 - 0.1902613160848803_rk*(neg_lam6_11 - neg_lam6_33) &
        - (0.2519035474197792_rk*lam6_12 - 0.4019452224328564_rk*lam6_32) - &
        1.1185374890947408_rk*a5_y
    t12 = 0.43637196239865417_rk*lam6_12 - 0.4714480390546099_rk*lam6_21 + &
        0.4019452224328564_rk*(neg_lam6_11 - neg_lam6_22) - (0.1902613160848803_rk*lam6_23 + &
        0.2519035474197792_rk*lam6_13)
    nc6_z = 1.2975168001325401_rk*neg_a6_x - 1.1185374890947408_rk*a6_y - t12
    ! link 6: force through the joint, along the axes that its turn starts from [N]
    f06_x = c6*fc6_x - s6*fc6_y
    f06_y = s6*fc6_x + c6*fc6_y
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    n06_x = c6*nc6_x - s6*nc6_y
    n06_y = s6*nc6_x + c6*nc6_y
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_x = n06_x - neg_nc5_x
    n5_y = nc5_y - nc6_z
    n5_z = nc5_z + n06_y
    ! link 5: force through the joint [N]
    f5_x = fc5_x + f06_x
    f5_y = fc5_y - fc6_z
    f5_z = fc5_z + f06_y
    ! link 5: force through the joint, along the axes that its turn starts from [N]
    f05_x = c5*f5_x - s5*f5_y
    f05_y = s5*f5_x + c5*f5_y
    ! link 5: moment through the joint, along the axes that its turn starts from [N m]
    n05_x = c5*n5_x - s5*n5_y
    n05_y = s5*n5_x + c5*n5_y
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = nc4_x + n05_x
    n4_y = nc4_y + n5_z
    n4_z = nc4_z - n05_y
    ! link 4: force through the joint [N]
    f4_x = fc4_x + f05_x
    f4_y = fc4_y + f5_z
    f4_z = fc4_z - f05_y
    ! link 4: force through the joint, along the axes that its turn starts from [N]
    f04_x = c4*f4_x - s4*f4_y
    neg_f04_y = -c4*f4_y - s4*f4_x
    ! link 4: moment through the joint, along the axes that its turn starts from [N m]
    n04_x = c4*n4_x - s4*n4_y
    n04_y = s4*n4_x + c4*n4_y
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_x = n04_x + (nc3_x + 0.4331_rk*neg_f04_y)
    n3_y = nc3_y - 0.0203_rk*neg_f04_y - n4_z
    n3_z = n04_y - (-0.4331_rk*f04_x - 0.0203_rk*f4_z - nc3_z)
    ! link 3: force through the joint [N]
    f3_x = fc3_x + f04_x
    f3_y = fc3_y - f4_z
    f3_z = fc3_z - neg_f04_y
    ! link 3: force through the joint, along the axes that its turn starts from [N]
    f03_x = c23*f3_x - s23*f3_y
    f03_y = s23*f3_x + c23*f3_y
    ! link 3: moment through the joint, along the axes that its turn starts from [N m]
    n03_y = s23*n3_x + c23*n3_y
    t13 = 0.4318_rk*c2
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_y = n03_y - (-c2*nc2_y - s2*nc2_x + f3_z*t13)
    n02_z = n3_z + (nc2_z - (f03_x*(0.4318_rk*s2) - f03_y*t13))
    ! link 2: force through the joint, along the axes that its turn starts from [N]
    neg_f02_x = s2*fc2_y - c2*fc2_x - f03_x
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = 0.1501_rk*neg_f02_x - n02_y
    tau(1) = n1_z
    tau(2) = n02_z
    tau(3) = n3_z
    tau(4) = n4_z
    tau(5) = n5_z
    tau(6) = nc6_z
  end subroutine

  ! mass matrix, rotor inertias on its diagonal
  ! 141 multiplications, 125 additions = 266; 3 unary minus; 10 sine/cosine
  pure subroutine puma560_full_mass_matrix(q, M) &
      bind(c, name="puma560_full_mass_matrix_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(out) :: M(36)
    real(rk) :: c2, s2, c4, s4, c5, s5, c6, s6, angle23, c23, s23, h6_x, neg_h6_y, t1, t2, k6_xy
    real(rk) :: k6_xz, k6_yz, fu5_x, fu5_y, nu5_x, neg_nu5_y, fu4_x, fu4_y, nu4_x, nu4_y, m3_6
    real(rk) :: fu3_x, fu3_y, nu3_y, t3, nu2_y, t4, m2_6, m1_6, t5, m5_5, t6, h5_x, neg_h5_y, t7
    real(rk) :: t8, t9, t10, t11, k5_yy, k5_xy, t12, t13, k5_xz, k5_yz, fu4_x_2, fu4_y_2, neg_nu4_x
    real(rk) :: nu4_y_2, m3_5, fu3_x_2, fu3_y_2, nu3_y_2, nu2_y_2, m2_5, m1_5, m4_4, t14, t15, h4_x
    real(rk) :: h4_y, t16, t17, t18, t19, t20, k4_xx, k4_yy, k4_xy, t21, t22, k4_xz, neg_k4_yz
    real(rk) :: m3_4, neg_fu3_x, fu3_y_3, t23, nu3_y_3, nu2_y_3, m2_4, m1_4, t24, t25, m3_3, t26
    real(rk) :: t27, h3_x, neg_h3_y, t28, k3_xx, k3_yy, k3_yz, m2_3, m1_3, t29, k2_zz, t30, m2_2
    real(rk) :: h2_y, k2_xx, k2_yz, m1_2, m1_1, t31

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    c4 = cos(q(4))
    s4 = sin(q(4))
    c5 = cos(q(5))
    s5 = sin(q(5))
    c6 = cos(q(6))
    s6 = sin(q(6))
    angle23 = q(2) + q(3)
    c23 = cos(angle23)
    s23 = sin(angle23)
    ! link 6: first moment of the composite body, about the frame's origin [kg m]
    h6_x = -1.2975168001325401_rk*s6 - 1.1185374890947408_rk*c6
    neg_h6_y = 1.1185374890947408_rk*s6 - 1.2975168001325401_rk*c6
    t1 = c6*s6
    t2 = c6*c6
    ! link 6: second moment of the composite body [kg m^2]
    k6_xy = 0.03507607665595572_rk*t1 - 0.4019452224328564_rk*(2.0_rk*t2 - 1.0_rk)
    k6_xz = 0.1902613160848803_rk*c6 + 0.2519035474197792_rk*s6
    k6_yz = 0.1902613160848803_rk*s6 - 0.2519035474197792_rk*c6
    ! link 5: force for a unit acceleration of a joint further out
    fu5_x = c5*neg_h6_y
    fu5_y = s5*neg_h6_y
    ! link 5: moment for a unit acceleration of a joint further out
    nu5_x = 0.907820001453264_rk*s5 - c5*k6_xz
    neg_nu5_y = s5*k6_xz + 0.907820001453264_rk*c5
    ! link 4: force for a unit acceleration of a joint further out
    fu4_x = c4*fu5_x - s4*h6_x
    fu4_y = s4*fu5_x + c4*h6_x
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_x = c4*nu5_x + s4*k6_yz
    nu4_y = s4*nu5_x - c4*k6_yz
    ! link 3: mass matrix, its row of this joint
    m3_6 = nu4_y - (0.0203_rk*fu5_y - 0.4331_rk*fu4_x)
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x = c23*fu4_x - s23*fu5_y
    fu3_y = s23*fu4_x + c23*fu5_y
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_y = c23*(0.0203_rk*fu4_y - neg_nu5_y) - s23*(0.4331_rk*fu4_y - nu4_x)
    t3 = 0.4318_rk*c2
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y = nu3_y - t3*fu4_y
    t4 = 0.4318_rk*s2
    ! link 2: mass matrix, its row of this joint
    m2_6 = m3_6 + (t3*fu3_y - t4*fu3_x)
    ! link 1: mass matrix, its row of this joint
    m1_6 = -0.1501_rk*fu3_x - nu2_y
    t5 = 0.03507607665595572_rk*t2 + 0.8038904448657128_rk*t1
    ! link 5: mass matrix, its row of this joint
    m5_5 = t5 + 0.9778489729032964_rk
    t6 = 0.47660058733283606_rk - h6_x
    ! link 5: first moment of the composite body, about the frame's origin [kg m]
    h5_x = 0.15165250821211493_rk*s5 - c5*t6
    neg_h5_y = s5*t6 + 0.15165250821211493_rk*c5
    t7 = c5*c5
    t8 = t5 + 0.1976234181078441_rk
    t9 = k6_xz - 0.08058935149735619_rk
    t10 = c5*s5
    t11 = t7*t8 + t9*(2.0_rk*t10)
    ! link 5: second moment of the composite body [kg m^2]
    k5_yy = t5 + 0.5877361955055702_rk - t11
    k5_xy = t8*t10 + t9*(1.0_rk - 2.0_rk*t7)
    t12 = k6_xy - 0.1558184212675505_rk
    t13 = k6_yz + 0.18116108322165295_rk
    k5_xz = c5*t12 + s5*t13
    k5_yz = s5*t12 - c5*t13
    ! link 4: force for a unit acceleration of a joint further out
    fu4_x_2 = c4*neg_h5_y
    fu4_y_2 = s4*neg_h5_y
    ! link 4: moment for a unit acceleration of a joint further out
    neg_nu4_x = c4*k5_xz + s4*m5_5
    nu4_y_2 = c4*m5_5 - s4*k5_xz
    ! link 3: mass matrix, its row of this joint
    m3_5 = nu4_y_2 + (0.4331_rk*fu4_x_2 - 0.0203_rk*h5_x)
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x_2 = c23*fu4_x_2 - s23*h5_x
    fu3_y_2 = s23*fu4_x_2 + c23*h5_x
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_y_2 = c23*(0.0203_rk*fu4_y_2 - k5_yz) - s23*(neg_nu4_x + 0.4331_rk*fu4_y_2)
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y_2 = nu3_y_2 - t3*fu4_y_2
    ! link 2: mass matrix, its row of this joint
    m2_5 = m3_5 + (t3*fu3_y_2 - t4*fu3_x_2)
    ! link 1: mass matrix, its row of this joint
    m1_5 = -0.1501_rk*fu3_x_2 - nu2_y_2
    ! link 4: mass matrix, its row of this joint
    m4_4 = 1.4877294195532857_rk - (t5 - t11)
    t14 = h5_x + 0.7777930398944852_rk
    t15 = 0.8719880516308344_rk - neg_h6_y
    ! link 4: first moment of the composite body, about the frame's origin [kg m]
    h4_x = c4*t14 - s4*t15
    h4_y = s4*t14 + c4*t15
    t16 = c4*c4
    t17 = t5 + t11 - 0.012851815603271595_rk
    t18 = k5_xz + 0.05337162017689789_rk
    t19 = c4*s4
    t20 = t16*t17 - t18*(2.0_rk*t19)
    ! link 4: second moment of the composite body [kg m^2]
    k4_xx = t20 - (t5 - 0.7502906175782786_rk)
    k4_yy = t11 + 0.7374388019750071_rk - t20
    k4_xy = t17*t19 - t18*(1.0_rk - 2.0_rk*t16)
    t21 = k5_yz - 0.10734691974802549_rk
    t22 = k5_xy - 0.2837491060266096_rk
    k4_xz = s4*t21 - c4*t22
    neg_k4_yz = s4*t22 + c4*t21
    ! link 3: mass matrix, its row of this joint
    m3_4 = neg_k4_yz - 0.4331_rk*h4_y
    ! link 3: force for a unit acceleration of a joint further out
    neg_fu3_x = c23*h4_y
    fu3_y_3 = -s23*h4_y
    t23 = -0.4331_rk*h4_x
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_y_3 = s23*(t23 - k4_xz) - c23*(m4_4 - 0.0203_rk*h4_x)
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y_3 = nu3_y_3 - t3*h4_x
    ! link 2: mass matrix, its row of this joint
    m2_4 = m3_4 + (t3*fu3_y_3 + t4*neg_fu3_x)
    ! link 1: mass matrix, its row of this joint
    m1_4 = 0.1501_rk*neg_fu3_x - nu2_y_3
    t24 = 0.0406_rk*h4_x - k4_xx
    t25 = k5_yy + 0.8662_rk*neg_h5_y
    ! link 3: mass matrix, its row of this joint
    m3_3 = 3.9522969756245816_rk - (t24 - t25)
    t26 = neg_h5_y + 5.729293810689829_rk
    t27 = -h4_x - 1.046378600789203_rk
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    h3_x = s23*t26 - c23*t27
    neg_h3_y = s23*t27 + c23*t26
    t28 = c23*c23*(t24 + t25 + 3.0087686178972097_rk) + (t23 + (0.0203_rk*neg_h5_y - k4_xz) + &
        0.28615890025504537_rk)*(2.0_rk*(c23*s23))
    ! link 3: second moment of the composite body [kg m^2]
    k3_xx = t25 + 3.4805327967608957_rk - t28
    k3_yy = t28 - (t24 - 0.47176417886368593_rk)
    k3_yz = s23*(k4_xy - 0.0203_rk*h4_y + 0.01894848286257894_rk) + c23*(m3_4 + &
        0.060845712710754084_rk)
    ! link 2: mass matrix, its row of this joint
    m2_3 = m3_3 - (t4*neg_h3_y - t3*h3_x)
    ! link 1: mass matrix, its row of this joint
    m1_3 = k3_yz - 0.1501_rk*neg_h3_y
    t29 = k4_yy - k3_yy
    ! link 2: second moment of the composite body [kg m^2]
    k2_zz = k3_yy + t29
    t30 = k3_xx - t3*(-2.0_rk*h3_x)
    ! link 2: mass matrix, its row of this joint
    m2_2 = t30 + (k4_yy - t29 - t4*(2.0_rk*neg_h3_y)) + 3.7298822532370677_rk
    ! link 2: first moment of the composite body, about the frame's origin [kg m]
    h2_y = 7.6631781603519995_rk*s2 + 0.1606745919581151_rk*c2 - neg_h3_y
    ! link 2: second moment of the composite body [kg m^2]
    k2_xx = t30 + (3.31527334516548_rk*(c2*c2) - 0.2348119600832282_rk*(c2*s2) + &
        0.20730445403579364_rk)
    k2_yz = k3_yz + t4*h4_y + (0.017097472943757824_rk*s2 + 0.0507946745483177_rk*c2)
    ! link 1: mass matrix, its row of this joint
    m1_2 = k2_yz + 0.1501_rk*h2_y
    m1_1 = k2_xx - (-0.3002_rk*h4_y - k2_zz) + 2.629303206180387_rk
    t31 = -k6_yz
    M(1) = m1_1
    M(2) = m1_2
    M(3) = m1_3
    M(4) = m1_4
    M(5) = m1_5
    M(6) = m1_6
    M(7) = m1_2
    M(8) = m2_2
    M(9) = m2_3
    M(10) = m2_4
    M(11) = m2_5
    M(12) = m2_6
    M(13) = m1_3
    M(14) = m2_3
    M(15) = m3_3
    M(16) = m3_4
    M(17) = m3_5
    M(18) = m3_6
    M(19) = m1_4
    M(20) = m2_4
    M(21) = m3_4
    M(22) = m4_4
    M(23) = k5_yz
    M(24) = neg_nu5_y
    M(25) = m1_5
    M(26) = m2_5
    M(27) = m3_5
    M(28) = k5_yz
    M(29) = m5_5
    M(30) = t31
    M(31) = m1_6
    M(32) = m2_6
    M(33) = m3_6
    M(34) = neg_nu5_y
    M(35) = t31
    M(36) = 0.907820001453264_rk
  end subroutine

  ! accelerations that the torques tau give
  ! 469 multiplications, 406 additions, 6 divisions = 881; 15 unary minus; 10 sine/cosine
  pure subroutine puma560_full_forward_dynamics(q, qd, tau, qdd) &
      bind(c, name="puma560_full_forward_dynamics_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(in) :: tau(6)
    real(rk), intent(out) :: qdd(6)
    real(rk) :: c2, s2, c4, s4, c5, s5, c6, s6, angle23, c23, s23, h6_x, neg_h6_y, t1, t2, k6_xy
    real(rk) :: k6_xz, k6_yz, fu5_x, fu5_y, nu5_x, neg_nu5_y, fu4_x, fu4_y, nu4_x, nu4_y, m3_6
    real(rk) :: fu3_x, fu3_y, nu3_y, t3, nu2_y, t4, m2_6, m1_6, t5, m5_5, t6, h5_x, neg_h5_y, t7
    real(rk) :: t8, t9, t10, t11, k5_yy, k5_xy, t12, t13, k5_xz, k5_yz, fu4_x_2, fu4_y_2, neg_nu4_x
    real(rk) :: nu4_y_2, m3_5, fu3_x_2, fu3_y_2, nu3_y_2, nu2_y_2, m2_5, m1_5, m4_4, t14, t15, h4_x
    real(rk) :: h4_y, t16, t17, t18, t19, t20, k4_xx, k4_yy, k4_xy, t21, t22, k4_xz, neg_k4_yz
    real(rk) :: m3_4, neg_fu3_x, fu3_y_3, t23, nu3_y_3, nu2_y_3, m2_4, m1_4, t24, t25, m3_3, t26
    real(rk) :: t27, h3_x, neg_h3_y, t28, k3_xx, k3_yy, k3_yz, m2_3, m1_3, t29, k2_zz, t30, m2_2
    real(rk) :: h2_y, k2_xx, k2_yz, m1_2, m1_1, w3_z, ww1_zz, a2_z, neg_w2_x, neg_w2_y
    real(rk) :: neg_alpha2_x, alpha2_y, ww2_xy, ww2_xx, ww2_yy, ww2_zz, neg_lam2_11, neg_lam2_22
    real(rk) :: neg_lam2_33, a3_z, t31, w3_x, w3_y, t32, t33, t34, t35, neg_a3_x, a3_y, alpha3_x
    real(rk) :: alpha3_y, ww3_xy, ww3_xx, ww3_yy, ww3_zz, neg_lam3_11, neg_lam3_22, neg_lam3_33
    real(rk) :: a4_z, w4_x, w4_y, t36, t37, a4_x, a4_y, alpha4_x, alpha4_y, w4_z, ww4_yz, ww4_zx
    real(rk) :: ww4_xy, ww4_xx, ww4_yy, ww4_zz, neg_lam4_11, lam4_12, lam4_13, lam4_21, neg_lam4_22
    real(rk) :: lam4_23, lam4_31, lam4_32, neg_lam4_33, w5_x, t38, w5_y, a5_x, a5_y, alpha5_x
    real(rk) :: alpha5_y, w5_z, ww5_yz, ww5_zx, ww5_xy, ww5_xx, ww5_yy, ww5_zz, neg_lam5_11
    real(rk) :: lam5_12, lam5_13, lam5_21, neg_lam5_22, lam5_23, neg_lam5_31, lam5_32, neg_lam5_33
    real(rk) :: w6_x, w6_y, a6_x, a6_y, alpha6_x, alpha6_y, w6_z, ww6_yz, ww6_zx, ww6_xy, ww6_xx
    real(rk) :: ww6_yy, ww6_zz, neg_lam6_11, lam6_12, lam6_13, lam6_21, neg_lam6_22, lam6_23
    real(rk) :: neg_lam6_31, lam6_32, neg_lam6_33, fc2_x, fc2_y, nc2_x, nc2_y, nc2_z, fc3_x, fc3_y
    real(rk) :: fc3_z, nc3_x, nc3_y, nc3_z, fc4_x, fc4_y, fc4_z, nc4_x, nc4_y, t39, nc4_z, fc5_x
    real(rk) :: fc5_y, fc5_z, neg_nc5_x, nc5_y, t40, nc5_z, fc6_x, fc6_y, fc6_z, nc6_x, nc6_y, t41
    real(rk) :: neg_nc6_z, f06_x, f06_y, n06_x, n06_y, n5_x, n5_y, n5_z, f5_x, f5_y, f5_z, f05_x
    real(rk) :: f05_y, n05_x, n05_y, n4_x, n4_y, n4_z, f4_x, f4_y, f4_z, f04_x, neg_f04_y, n04_x
    real(rk) :: n04_y, n3_x, n3_y, n3_z, f3_x, f3_y, f3_z, f03_x, f03_y, n03_y, n02_y, n02_z
    real(rk) :: neg_f02_x, n1_z, y1, ipivot1, l2_1, l3_1, l4_1, l5_1, l6_1, pivot2, ipivot2
    real(rk) :: neg_ld3_2, l3_2, ld4_2, l4_2, ld5_2, l5_2, ld6_2, l6_2, pivot3, ipivot3, ld4_3
    real(rk) :: l4_3, ld5_3, l5_3, ld6_3, l6_3, t42, pivot4, ipivot4, ld5_4, l5_4, ld6_4, l6_4
    real(rk) :: pivot5, ipivot5, neg_ld6_5, l6_5, pivot6, ipivot6, y2, y3, y4, y5, y6, qdd6, qdd5
    real(rk) :: qdd4, qdd3, qdd2, qdd1

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    c4 = cos(q(4))
    s4 = sin(q(4))
    c5 = cos(q(5))
    s5 = sin(q(5))
    c6 = cos(q(6))
    s6 = sin(q(6))
    angle23 = q(2) + q(3)
    c23 = cos(angle23)
    s23 = sin(angle23)
    ! link 6: first moment of the composite body, about the frame's origin [kg m]
    h6_x = -1.2975168001325401_rk*s6 - 1.1185374890947408_rk*c6
    neg_h6_y = 1.1185374890947408_rk*s6 - 1.2975168001325401_rk*c6
    t1 = c6*s6
    t2 = c6*c6
    ! link 6: second moment of the composite body [kg m^2]
    k6_xy = 0.03507607665595572_rk*t1 - 0.4019452224328564_rk*(2.0_rk*t2 - 1.0_rk)
    k6_xz = 0.1902613160848803_rk*c6 + 0.2519035474197792_rk*s6
    k6_yz = 0.1902613160848803_rk*s6 - 0.2519035474197792_rk*c6
    ! link 5: force for a unit acceleration of a joint further out
    fu5_x = c5*neg_h6_y
    fu5_y = s5*neg_h6_y
    ! link 5: moment for a unit acceleration of a joint further out
    nu5_x = 0.907820001453264_rk*s5 - c5*k6_xz
    neg_nu5_y = s5*k6_xz + 0.907820001453264_rk*c5
    ! link 4: force for a unit acceleration of a joint further out
    fu4_x = c4*fu5_x - s4*h6_x
    fu4_y = s4*fu5_x + c4*h6_x
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_x = c4*nu5_x + s4*k6_yz
    nu4_y = s4*nu5_x - c4*k6_yz
    ! link 3: mass matrix, its row of this joint
    m3_6 = nu4_y - (0.0203_rk*fu5_y - 0.4331_rk*fu4_x)
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x = c23*fu4_x - s23*fu5_y
    fu3_y = s23*fu4_x + c23*fu5_y
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_y = c23*(0.0203_rk*fu4_y - neg_nu5_y) - s23*(0.4331_rk*fu4_y - nu4_x)
    t3 = 0.4318_rk*c2
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y = nu3_y - t3*fu4_y
    t4 = 0.4318_rk*s2
    ! link 2: mass matrix, its row of this joint
    m2_6 = m3_6 + (t3*fu3_y - t4*fu3_x)
    ! link 1: mass matrix, its row of this joint
    m1_6 = -0.1501_rk*fu3_x - nu2_y
    t5 = 0.03507607665595572_rk*t2 + 0.8038904448657128_rk*t1
    ! link 5: mass matrix, its row of this joint
    m5_5 = t5 + 0.9778489729032964_rk
    t6 = 0.47660058733283606_rk - h6_x
    ! link 5: first moment of the composite body, about the frame's origin [kg m]
    h5_x = 0.15165250821211493_rk*s5 - c5*t6
    neg_h5_y = s5*t6 + 0.15165250821211493_rk*c5
    t7 = c5*c5
    t8 = t5 + 0.1976234181078441_rk
    t9 = k6_xz - 0.08058935149735619_rk
    t10 = c5*s5
    t11 = t7*t8 + t9*(2.0_rk*t10)
    ! link 5: second moment of the composite body [kg m^2]
    k5_yy = t5 + 0.5877361955055702_rk - t11
    k5_xy = t8*t10 + t9*(1.0_rk - 2.0_rk*t7)
    t12 = k6_xy - 0.1558184212675505_rk
    t13 = k6_yz + 0.18116108322165295_rk
    k5_xz = c5*t12 + s5*t13
    k5_yz = s5*t12 - c5*t13
    ! link 4: force for a unit acceleration of a joint further out
    fu4_x_2 = c4*neg_h5_y
    fu4_y_2 = s4*neg_h5_y
    ! link 4: moment for a unit acceleration of a joint further out
    neg_nu4_x = c4*k5_xz + s4*m5_5
    nu4_y_2 = c4*m5_5 - s4*k5_xz
    ! link 3: mass matrix, its row of this joint
    m3_5 = nu4_y_2 + (0.4331_rk*fu4_x_2 - 0.0203_rk*h5_x)
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x_2 = c23*fu4_x_2 - s23*h5_x
    fu3_y_2 = s23*fu4_x_2 + c23*h5_x
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_y_2 = c23*(0.0203_rk*fu4_y_2 - k5_yz) - s23*(neg_nu4_x + 0.4331_rk*fu4_y_2)
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y_2 = nu3_y_2 - t3*fu4_y_2
    ! link 2: mass matrix, its row of this joint
    m2_5 = m3_5 + (t3*fu3_y_2 - t4*fu3_x_2)
    ! link 1: mass matrix, its row of this joint
    m1_5 = -0.1501_rk*fu3_x_2 - nu2_y_2
    ! link 4: mass matrix, its row of this joint
    m4_4 = 1.4877294195532857_rk - (t5 - t11)
    t14 = h5_x + 0.7777930398944852_rk
    t15 = 0.8719880516308344_rk - neg_h6_y
    ! link 4: first moment of the composite body, about the frame's origin [kg m]
    h4_x = c4*t14 - s4*t15
    h4_y = s4*t14 + c4*t15
    t16 = c4*c4
    t17 = t5 + t11 - 0.012851815603271595_rk
    t18 = k5_xz + 0.05337162017689789_rk
    t19 = c4*s4
    t20 = t16*t17 - t18*(2.0_rk*t19)
    ! link 4: second moment of the composite body [kg m^2]
    k4_xx = t20 - (t5 - 0.7502906175782786_rk)
    k4_yy = t11 + 0.7374388019750071_rk - t20
    k4_xy = t17*t19 - t18*(1.0_rk - 2.0_rk*t16)
    t21 = k5_yz - 0.10734691974802549_rk
    t22 = k5_xy - 0.2837491060266096_rk
    k4_xz = s4*t21 - c4*t22
    neg_k4_yz = s4*t22 + c4*t21
    ! link 3: mass matrix, its row of this joint
    m3_4 = neg_k4_yz - 0.4331_rk*h4_y
    ! link 3: force for a unit acceleration of a joint further out
    neg_fu3_x = c23*h4_y
    fu3_y_3 = -s23*h4_y
    t23 = -0.4331_rk*h4_x
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_y_3 = s23*(t23 - k4_xz) - c23*(m4_4 - 0.0203_rk*h4_x)
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y_3 = nu3_y_3 - t3*h4_x
    ! link 2: mass matrix, its row of this joint
    m2_4 = m3_4 + (t3*fu3_y_3 + t4*neg_fu3_x)
    ! link 1: mass matrix, its row of this joint
    m1_4 = 0.1501_rk*neg_fu3_x - nu2_y_3
    t24 = 0.0406_rk*h4_x - k4_xx
    t25 = k5_yy + 0.8662_rk*neg_h5_y
    ! link 3: mass matrix, its row of this joint
    m3_3 = 3.9522969756245816_rk - (t24 - t25)
    t26 = neg_h5_y + 5.729293810689829_rk
    t27 = -h4_x - 1.046378600789203_rk
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    h3_x = s23*t26 - c23*t27
    neg_h3_y = s23*t27 + c23*t26
    t28 = c23*c23*(t24 + t25 + 3.0087686178972097_rk) + (t23 + (0.0203_rk*neg_h5_y - k4_xz) + &
        0.28615890025504537_rk)*(2.0_rk*(c23*s23))
    ! link 3: second moment of the composite body [kg m^2]
    k3_xx = t25 + 3.4805327967608957_rk - t28
    k3_yy = t28 - (t24 - 0.47176417886368593_rk)
    k3_yz = s23*(k4_xy - 0.0203_rk*h4_y + 0.01894848286257894_rk) + c23*(m3_4 + &
        0.060845712710754084_rk)
    ! link 2: mass matrix, its row of this joint
    m2_3 = m3_3 - (t4*neg_h3_y - t3*h3_x)
    ! link 1: mass matrix, its row of this joint
    m1_3 = k3_yz - 0.1501_rk*neg_h3_y
    t29 = k4_yy - k3_yy
    ! link 2: second moment of the composite body [kg m^2]
    k2_zz = k3_yy + t29
    t30 = k3_xx - t3*(-2.0_rk*h3_x)
    ! link 2: mass matrix, its row of this joint
    m2_2 = t30 + (k4_yy - t29 - t4*(2.0_rk*neg_h3_y)) + 3.7298822532370677_rk
    ! link 2: first moment of the composite body, about the frame's origin [kg m]
    h2_y = 7.6631781603519995_rk*s2 + 0.1606745919581151_rk*c2 - neg_h3_y
    ! link 2: second moment of the composite body [kg m^2]
    k2_xx = t30 + (3.31527334516548_rk*(c2*c2) - 0.2348119600832282_rk*(c2*s2) + &
        0.20730445403579364_rk)
    k2_yz = k3_yz + t4*h4_y + (0.017097472943757824_rk*s2 + 0.0507946745483177_rk*c2)
    ! link 1: mass matrix, its row of this joint
    m1_2 = k2_yz + 0.1501_rk*h2_y
    m1_1 = k2_xx - (-0.3002_rk*h4_y - k2_zz) + 2.629303206180387_rk
    ! link 3: angular velocity [rad/s]
    w3_z = qd(2) + qd(3)
    ! link 1: products of the angular velocity [1/s^2]
    ww1_zz = qd(1)*qd(1)
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    a2_z = -0.1501_rk*ww1_zz
    ! link 2: angular velocity [rad/s]
    neg_w2_x = qd(1)*s2
    neg_w2_y = qd(1)*c2
    ! link 2: angular acceleration [rad/s^2]
    neg_alpha2_x = qd(2)*neg_w2_y
    alpha2_y = qd(2)*neg_w2_x
    ! link 2: products of the angular velocity [1/s^2]
    ww2_xy = neg_w2_x*neg_w2_y
    ww2_xx = neg_w2_x*neg_w2_x
    ww2_yy = neg_w2_y*neg_w2_y
    ww2_zz = qd(2)*qd(2)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_11 = ww2_yy + ww2_zz
    neg_lam2_22 = ww2_xx + ww2_zz
    neg_lam2_33 = ww2_xx + ww2_yy
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_z = a2_z - 0.8636_rk*alpha2_y
    t31 = -qd(1)
    ! link 3: angular velocity [rad/s]
    w3_x = t31*s23
    w3_y = t31*c23
    t32 = 0.4318_rk*neg_lam2_11
    t33 = 0.4318_rk*ww2_xy
    t34 = c2*t32 + s2*t33
    t35 = s2*t32 - c2*t33 + 9.8_rk
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a3_x = c23*t34 + s23*t35
    a3_y = s23*t34 - c23*t35
    ! link 3: angular acceleration [rad/s^2]
    alpha3_x = w3_z*w3_y
    alpha3_y = -w3_z*w3_x
    ! link 3: products of the angular velocity [1/s^2]
    ww3_xy = w3_x*w3_y
    ww3_xx = w3_x*w3_x
    ww3_yy = w3_y*w3_y
    ww3_zz = w3_z*w3_z
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_11 = ww3_yy + ww3_zz
    neg_lam3_22 = ww3_xx + ww3_zz
    neg_lam3_33 = ww3_xx + ww3_yy
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_z = 0.0203_rk*ww3_xy - 0.4331_rk*neg_lam3_22 - a3_y
    ! link 4: angular velocity [rad/s]
    w4_x = c4*w3_x + s4*w3_z
    w4_y = c4*w3_z - s4*w3_x
    t36 = a3_z + (0.0406_rk*alpha3_y - 0.8662_rk*alpha3_x)
    t37 = neg_a3_x + (0.4331_rk*ww3_xy - 0.0203_rk*neg_lam3_11)
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_x = s4*t36 - c4*t37
    a4_y = s4*t37 + c4*t36
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = c4*alpha3_x + qd(4)*w4_y
    alpha4_y = -qd(4)*w4_x - s4*alpha3_x
    ! link 4: angular velocity [rad/s]
    w4_z = qd(4) - w3_y
    ! link 4: products of the angular velocity [1/s^2]
    ww4_yz = w4_y*w4_z
    ww4_zx = w4_x*w4_z
    ww4_xy = w4_x*w4_y
    ww4_xx = w4_x*w4_x
    ww4_yy = w4_y*w4_y
    ww4_zz = w4_z*w4_z
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam4_11 = ww4_yy + ww4_zz
    lam4_12 = alpha3_y + ww4_xy
    lam4_13 = alpha4_y + ww4_zx
    lam4_21 = ww4_xy - alpha3_y
    neg_lam4_22 = ww4_xx + ww4_zz
    lam4_23 = ww4_yz - alpha4_x
    lam4_31 = ww4_zx - alpha4_y
    lam4_32 = alpha4_x + ww4_yz
    neg_lam4_33 = ww4_xx + ww4_yy
    ! link 5: angular velocity [rad/s]
    w5_x = c5*w4_x - s5*w4_z
    t38 = -c5
    w5_y = t38*w4_z - s5*w4_x
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_x = c5*a4_x - s5*a4_z
    a5_y = t38*a4_z - s5*a4_x
    ! link 5: angular acceleration [rad/s^2]
    alpha5_x = qd(5)*w5_y - (-s5*alpha3_y - c5*alpha4_x)
    alpha5_y = c5*alpha3_y - s5*alpha4_x - qd(5)*w5_x
    ! link 5: angular velocity [rad/s]
    w5_z = qd(5) + w4_y
    ! link 5: products of the angular velocity [1/s^2]
    ww5_yz = w5_y*w5_z
    ww5_zx = w5_x*w5_z
    ww5_xy = w5_x*w5_y
    ww5_xx = w5_x*w5_x
    ww5_yy = w5_y*w5_y
    ww5_zz = w5_z*w5_z
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_11 = ww5_yy + ww5_zz
    lam5_12 = ww5_xy - alpha4_y
    lam5_13 = alpha5_y + ww5_zx
    lam5_21 = alpha4_y + ww5_xy
    neg_lam5_22 = ww5_xx + ww5_zz
    lam5_23 = ww5_yz - alpha5_x
    neg_lam5_31 = alpha5_y - ww5_zx
    lam5_32 = alpha5_x + ww5_yz
    neg_lam5_33 = ww5_xx + ww5_yy
    ! link 6: angular velocity [rad/s]
    w6_x = c6*w5_x + s6*w5_z
    w6_y = c6*w5_z - s6*w5_x
    ! link 6: acceleration of the frame's origin, gravity taken off [m/s^2]
    a6_x = c6*a5_x + s6*a4_y
    a6_y = c6*a4_y - s6*a5_x
    ! link 6: angular acceleration [rad/s^2]
    alpha6_x = qd(6)*w6_y - (-s6*alpha4_y - c6*alpha5_x)
    alpha6_y = c6*alpha4_y - s6*alpha5_x - qd(6)*w6_x
    ! link 6: angular velocity [rad/s]
    w6_z = qd(6) - w5_y
    ! link 6: products of the angular velocity [1/s^2]
    ww6_yz = w6_y*w6_z
    ww6_zx = w6_x*w6_z
    ww6_xy = w6_x*w6_y
    ww6_xx = w6_x*w6_x
    ww6_yy = w6_y*w6_y
    ww6_zz = w6_z*w6_z
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam6_11 = ww6_yy + ww6_zz
    lam6_12 = alpha5_y + ww6_xy
    lam6_13 = alpha6_y + ww6_zx
    lam6_21 = ww6_xy - alpha5_y
    neg_lam6_22 = ww6_xx + ww6_zz
    lam6_23 = ww6_yz - alpha6_x
    neg_lam6_31 = alpha6_y - ww6_zx
    lam6_32 = alpha6_x + ww6_yz
    neg_lam6_33 = ww6_xx + ww6_yy
    ! link 2: force that moves the link [N]
    fc2_x = 0.1606745919581151_rk*ww2_xy - 7.6631781603519995_rk*neg_lam2_11
    fc2_y = 7.6631781603519995_rk*ww2_xy - 0.1606745919581151_rk*neg_lam2_22
    ! link 2: moment that turns the link [N m]
    nc2_x = -0.024117256252913073_rk*ww1_zz - (0.4146089080715873_rk*neg_alpha2_x - &
        0.0507946745483177_rk*(neg_lam2_22 - neg_lam2_33) + (0.2348119600832282_rk*alpha2_y + &
        0.017097472943757824_rk*ww2_xy))
    nc2_y = 7.045155598402548_rk*alpha2_y - 0.017097472943757824_rk*(neg_lam2_11 - neg_lam2_33) + &
        (0.0507946745483177_rk*ww2_xy + 0.2348119600832282_rk*neg_alpha2_x) + &
        1.1502430418688352_rk*ww1_zz
    nc2_z = 3.31527334516548_rk*ww2_xy + 0.1174059800416141_rk*(neg_lam2_11 - neg_lam2_22) - &
        (75.09914597144959_rk*c2 - 1.5746110011895278_rk*s2)
    ! link 3: force that moves the link [N]
    fc3_x = -1.046378600789203_rk*neg_lam3_11 - 5.729293810689829_rk*ww3_xy
    fc3_y = 1.046378600789203_rk*ww3_xy + 5.729293810689829_rk*neg_lam3_22
    fc3_z = -11.458587621379658_rk*alpha3_x - 2.092757201578406_rk*alpha3_y
    ! link 3: moment that turns the link [N m]
    nc3_x = -5.729293810689829_rk*a3_z - (-6.961065593521791_rk*alpha3_x - &
        0.060845712710754084_rk*(neg_lam3_22 - neg_lam3_33) + (0.5723178005100907_rk*alpha3_y + &
        0.01894848286257894_rk*ww3_xy))
    nc3_y = 0.9435283577273719_rk*alpha3_y - 0.01894848286257894_rk*(neg_lam3_11 - neg_lam3_33) + &
        (0.060845712710754084_rk*ww3_xy - 0.5723178005100907_rk*alpha3_x) - &
        1.046378600789203_rk*a3_z
    nc3_z = 1.046378600789203_rk*a3_y - 5.729293810689829_rk*neg_a3_x - &
        (3.0087686178972097_rk*ww3_xy - 0.28615890025504537_rk*(neg_lam3_11 - neg_lam3_22))
    ! link 4: force that moves the link [N]
    fc4_x = 0.8719880516308344_rk*lam4_12 - 0.7777930398944852_rk*neg_lam4_11
    fc4_y = 0.7777930398944852_rk*lam4_21 - 0.8719880516308344_rk*neg_lam4_22
    fc4_z = 0.7777930398944852_rk*lam4_31 + 0.8719880516308344_rk*lam4_32
    ! link 4: moment that turns the link [N m]
    nc4_x = 0.8719880516308344_rk*a4_z - (-0.2788425785236688_rk*lam4_32 - &
        0.10734691974802549_rk*(neg_lam4_22 - neg_lam4_33) + (0.2837491060266096_rk*lam4_21 - &
        0.05337162017689789_rk*lam4_31))
    nc4_y = -0.3473260245772809_rk*lam4_31 - 0.2837491060266096_rk*(neg_lam4_11 - neg_lam4_33) + &
        (0.10734691974802549_rk*lam4_12 - 0.05337162017689789_rk*lam4_32) - &
        0.7777930398944852_rk*a4_z
    t39 = 0.2788425785236688_rk*lam4_12 - 0.3473260245772809_rk*lam4_21 - &
        0.05337162017689789_rk*(neg_lam4_11 - neg_lam4_22) - (0.2837491060266096_rk*lam4_23 - &
        0.10734691974802549_rk*lam4_13)
    nc4_z = 0.7777930398944852_rk*a4_y - 0.8719880516308344_rk*a4_x - t39
    ! link 5: force that moves the link [N]
    fc5_x = 0.47660058733283606_rk*neg_lam5_11 - 0.15165250821211493_rk*lam5_12
    fc5_y = 0.15165250821211493_rk*neg_lam5_22 - 0.47660058733283606_rk*lam5_21
    fc5_z = 0.47660058733283606_rk*neg_lam5_31 - 0.15165250821211493_rk*lam5_32
    ! link 5: moment that turns the link [N m]
    neg_nc5_x = 0.18116108322165295_rk*(neg_lam5_22 - neg_lam5_33) - 0.3901127773977262_rk*lam5_32 &
        + (0.08058935149735619_rk*neg_lam5_31 - 0.1558184212675505_rk*lam5_21) + &
        0.15165250821211493_rk*a4_y
    nc5_y = 0.1513642331069161_rk*neg_lam5_31 + 0.1558184212675505_rk*(neg_lam5_11 - neg_lam5_33) &
        + (-0.18116108322165295_rk*lam5_12 - 0.08058935149735619_rk*lam5_32) + &
        0.47660058733283606_rk*a4_y
    t40 = 0.1513642331069161_rk*lam5_21 - 0.3901127773977262_rk*lam5_12 - &
        0.08058935149735619_rk*(neg_lam5_22 - neg_lam5_11) - (0.1558184212675505_rk*lam5_23 - &
        0.18116108322165295_rk*lam5_13)
    nc5_z = t40 - (0.47660058733283606_rk*a5_y - 0.15165250821211493_rk*a5_x)
    ! link 6: force that moves the link [N]
    fc6_x = 1.1185374890947408_rk*neg_lam6_11 + 1.2975168001325401_rk*lam6_12
    fc6_y = -1.2975168001325401_rk*neg_lam6_22 - 1.1185374890947408_rk*lam6_21
    fc6_z = 1.1185374890947408_rk*neg_lam6_31 + 1.2975168001325401_rk*lam6_32
    ! link 6: moment that turns the link [N m]
    nc6_x = -1.2975168001325401_rk*a5_y - (0.2519035474197792_rk*(neg_lam6_22 - neg_lam6_33) - &
        0.43637196239865417_rk*lam6_32 - (0.4019452224328564_rk*neg_lam6_31 - &
        0.1902613160848803_rk*lam6_21))
    nc6_y = 0.4714480390546099_rk*neg_lam6_31 - 0.1902613160848803_rk*(neg_lam6_11 - neg_lam6_33) &
        - (0.2519035474197792_rk*lam6_12 - 0.4019452224328564_rk*lam6_32) - &
        1.1185374890947408_rk*a5_y
    t41 = 0.43637196239865417_rk*lam6_12 - 0.4714480390546099_rk*lam6_21 + &
        0.4019452224328564_rk*(neg_lam6_11 - neg_lam6_22) - (0.1902613160848803_rk*lam6_23 + &
        0.2519035474197792_rk*lam6_13)
    neg_nc6_z = t41 + (1.1185374890947408_rk*a6_y + 1.2975168001325401_rk*a6_x)
    ! link 6: force through the joint, along the axes that its turn starts from [N]
    f06_x = c6*fc6_x - s6*fc6_y
    f06_y = s6*fc6_x + c6*fc6_y
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    n06_x = c6*nc6_x - s6*nc6_y
    n06_y = s6*nc6_x + c6*nc6_y
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_x = n06_x - neg_nc5_x
    n5_y = nc5_y + neg_nc6_z
    n5_z = nc5_z + n06_y
    ! link 5: force through the joint [N]
    f5_x = fc5_x + f06_x
    f5_y = fc5_y - fc6_z
    f5_z = fc5_z + f06_y
    ! link 5: force through the joint, along the axes that its turn starts from [N]
    f05_x = c5*f5_x - s5*f5_y
    f05_y = s5*f5_x + c5*f5_y
    ! link 5: moment through the joint, along the axes that its turn starts from [N m]
    n05_x = c5*n5_x - s5*n5_y
    n05_y = s5*n5_x + c5*n5_y
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = nc4_x + n05_x
    n4_y = nc4_y + n5_z
    n4_z = nc4_z - n05_y
    ! link 4: force through the joint [N]
    f4_x = fc4_x + f05_x
    f4_y = fc4_y + f5_z
    f4_z = fc4_z - f05_y
    ! link 4: force through the joint, along the axes that its turn starts from [N]
    f04_x = c4*f4_x - s4*f4_y
    neg_f04_y = -c4*f4_y - s4*f4_x
    ! link 4: moment through the joint, along the axes that its turn starts from [N m]
    n04_x = c4*n4_x - s4*n4_y
    n04_y = s4*n4_x + c4*n4_y
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_x = n04_x + (nc3_x + 0.4331_rk*neg_f04_y)
    n3_y = nc3_y - 0.0203_rk*neg_f04_y - n4_z
    n3_z = n04_y - (-0.4331_rk*f04_x - 0.0203_rk*f4_z - nc3_z)
    ! link 3: force through the joint [N]
    f3_x = fc3_x + f04_x
    f3_y = fc3_y - f4_z
    f3_z = fc3_z - neg_f04_y
    ! link 3: force through the joint, along the axes that its turn starts from [N]
    f03_x = c23*f3_x - s23*f3_y
    f03_y = s23*f3_x + c23*f3_y
    ! link 3: moment through the joint, along the axes that its turn starts from [N m]
    n03_y = s23*n3_x + c23*n3_y
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_y = n03_y - (-c2*nc2_y - s2*nc2_x + t3*f3_z)
    n02_z = n3_z + (nc2_z - (t4*f03_x - t3*f03_y))
    ! link 2: force through the joint, along the axes that its turn starts from [N]
    neg_f02_x = s2*fc2_y - c2*fc2_x - f03_x
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = 0.1501_rk*neg_f02_x - n02_y
    ! link 1: forward substitution
    y1 = tau(1) - n1_z
    ! factorisation M = L D L^T
    ipivot1 = 1.0_rk / m1_1
    l2_1 = m1_2*ipivot1
    l3_1 = m1_3*ipivot1
    l4_1 = m1_4*ipivot1
    l5_1 = m1_5*ipivot1
    l6_1 = m1_6*ipivot1
    pivot2 = m2_2 - m1_2*l2_1
    ipivot2 = 1.0_rk / pivot2
    neg_ld3_2 = m1_2*l3_1 - m2_3
    l3_2 = -ipivot2*neg_ld3_2
    ld4_2 = m2_4 - m1_2*l4_1
    l4_2 = ipivot2*ld4_2
    ld5_2 = m2_5 - m1_2*l5_1
    l5_2 = ipivot2*ld5_2
    ld6_2 = m2_6 - m1_2*l6_1
    l6_2 = ipivot2*ld6_2
    pivot3 = neg_ld3_2*l3_2 - (m1_3*l3_1 - m3_3)
    ipivot3 = 1.0_rk / pivot3
    ld4_3 = m3_4 - m1_3*l4_1 + neg_ld3_2*l4_2
    l4_3 = ipivot3*ld4_3
    ld5_3 = neg_ld3_2*l5_2 - (m1_3*l5_1 - m3_5)
    l5_3 = ipivot3*ld5_3
    ld6_3 = neg_ld3_2*l6_2 - (m1_3*l6_1 - m3_6)
    l6_3 = ipivot3*ld6_3
    t42 = -ld4_2
    pivot4 = t42*l4_2 - (m1_4*l4_1 - m4_4) - ld4_3*l4_3
    ipivot4 = 1.0_rk / pivot4
    ld5_4 = k5_yz - m1_4*l5_1 - ld4_2*l5_2 - ld4_3*l5_3
    l5_4 = ipivot4*ld5_4
    ld6_4 = t42*l6_2 - (m1_4*l6_1 - neg_nu5_y) - ld4_3*l6_3
    l6_4 = ipivot4*ld6_4
    pivot5 = m5_5 - m1_5*l5_1 - ld5_2*l5_2 - ld5_3*l5_3 - ld5_4*l5_4
    ipivot5 = 1.0_rk / pivot5
    neg_ld6_5 = k6_yz + m1_5*l6_1 + ld5_2*l6_2 + ld5_3*l6_3 + ld5_4*l6_4
    l6_5 = -ipivot5*neg_ld6_5
    pivot6 = neg_ld6_5*l6_5 - (m1_6*l6_1 - 0.907820001453264_rk + ld6_2*l6_2 + ld6_3*l6_3 + &
        ld6_4*l6_4)
    ipivot6 = 1.0_rk / pivot6
    ! link 2: forward substitution
    y2 = tau(2) - n02_z - y1*l2_1
    ! link 3: forward substitution
    y3 = tau(3) - n3_z - y1*l3_1 - l3_2*y2
    ! link 4: forward substitution
    y4 = tau(4) - n4_z - y1*l4_1 - l4_2*y2 - l4_3*y3
    ! link 5: forward substitution
    y5 = tau(5) - n5_z - y1*l5_1 - l5_2*y2 - l5_3*y3 - l5_4*y4
    ! link 6: forward substitution
    y6 = tau(6) + neg_nc6_z - y1*l6_1 - l6_2*y2 - l6_3*y3 - l6_4*y4 - l6_5*y5
    ! link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd6 = ipivot6*y6
    ! link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd5 = ipivot5*y5 - l6_5*qdd6
    ! link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd4 = -l6_4*qdd6 - (l5_4*qdd5 - ipivot4*y4)
    ! link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd3 = -l5_3*qdd5 - (l4_3*qdd4 - ipivot3*y3) - l6_3*qdd6
    ! link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd2 = ipivot2*y2 - l3_2*qdd3 - l4_2*qdd4 - l5_2*qdd5 - l6_2*qdd6
    ! link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd1 = y1*ipivot1 - l2_1*qdd2 - l3_1*qdd3 - l4_1*qdd4 - l5_1*qdd5 - l6_1*qdd6
    qdd(1) = qdd1
    qdd(2) = qdd2
    qdd(3) = qdd3
    qdd(4) = qdd4
    qdd(5) = qdd5
    qdd(6) = qdd6
  end subroutine
end module
