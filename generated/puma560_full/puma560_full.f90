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
!   inverse_dynamics: 262 multiplications, 243 additions = 505; 7 unary minus; 10 sine/cosine
!   gravity: 42 multiplications, 25 additions = 67; 1 unary minus; 10 sine/cosine
!   bias: 244 multiplications, 211 additions = 455; 7 unary minus; 10 sine/cosine
!   mass_matrix: 161 multiplications, 139 additions = 300; 6 unary minus; 10 sine/cosine
!   forward_dynamics: 491 multiplications, 421 additions, 6 divisions = 918; 14 unary minus; 12
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
  ! 262 multiplications, 243 additions = 505; 7 unary minus; 10 sine/cosine
  pure subroutine puma560_full_inverse_dynamics(q, qd, qdd, tau) &
      bind(c, name="puma560_full_inverse_dynamics_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(in) :: qdd(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: c2, s2, c4, s4, c5, s5, c6, s6
    real(rk) :: angle23, c23, s23, w3_z, alpha3_z, ww1_zz, a2_z, t1
    real(rk) :: w2_x, w2_y, t2, neg_a2_x, a2_y, ww2_yz, ww2_zx, alpha2_x
    real(rk) :: neg_alpha2_y, ww2_xy, ww2_xx, ww2_yy, ww2_zz, neg_lam2_11, lam2_12, lam2_13
    real(rk) :: lam2_21, neg_lam2_22, lam2_23, lam2_31, lam2_32, neg_lam2_33, a3_z, w3_x
    real(rk) :: w3_y, t3, t4, t5, t6, neg_a3_x, a3_y, ww3_yz
    real(rk) :: ww3_zx, alpha3_x, neg_alpha3_y, ww3_xy, ww3_xx, ww3_yy, neg_ww3_zz, lam3_11
    real(rk) :: lam3_12, lam3_13, lam3_21, lam3_22, lam3_23, lam3_31, lam3_32, lam3_33
    real(rk) :: a4_z, w4_x, w4_y, t7, t8, neg_a4_x, a4_y, alpha4_x
    real(rk) :: alpha4_y, alpha4_z, w4_z, ww4_yz, ww4_zx, ww4_xy, ww4_xx, ww4_yy
    real(rk) :: ww4_zz, neg_lam4_11, lam4_12, lam4_13, lam4_21, neg_lam4_22, lam4_23, lam4_31
    real(rk) :: lam4_32, neg_lam4_33, w5_x, t9, w5_y, a5_x, a5_y, alpha5_x
    real(rk) :: alpha5_y, alpha5_z, w5_z, ww5_yz, ww5_zx, ww5_xy, ww5_xx, ww5_yy
    real(rk) :: ww5_zz, neg_lam5_11, lam5_12, lam5_13, lam5_21, neg_lam5_22, lam5_23, lam5_31
    real(rk) :: lam5_32, neg_lam5_33, w6_x, w6_y, a6_x, a6_y, alpha6_x, alpha6_y
    real(rk) :: alpha6_z, w6_z, ww6_yz, ww6_zx, ww6_xy, ww6_xx, ww6_yy, ww6_zz
    real(rk) :: neg_lam6_11, lam6_12, lam6_13, lam6_21, neg_lam6_22, lam6_23, lam6_31, lam6_32
    real(rk) :: neg_lam6_33, nc1_z, fc2_x, fc2_y, neg_nc2_x, nc2_y, t10, nc2_z
    real(rk) :: fc3_x, fc3_y, fc3_z, nc3_x, nc3_y, t11, nc3_z, fc4_x
    real(rk) :: fc4_y, fc4_z, nc4_x, nc4_y, t12, nc4_z, fc5_x, fc5_y
    real(rk) :: fc5_z, neg_nc5_x, nc5_y, t13, nc5_z, fc6_x, fc6_y, fc6_z
    real(rk) :: nc6_x, nc6_y, t14, nc6_z, f06_x, f06_y, n06_x, n06_y
    real(rk) :: n5_x, n5_y, n5_z, f5_x, f5_y, f5_z, f05_x, f05_y
    real(rk) :: n05_x, n05_y, n4_x, n4_y, n4_z, f4_x, f4_y, f4_z
    real(rk) :: neg_f04_x, f04_y, n04_x, n04_y, n3_x, n3_y, n3_z, f3_x
    real(rk) :: f3_y, f3_z, f03_x, f03_y, n03_y, t15, n02_y, n02_z
    real(rk) :: f02_x, n1_z

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
    a2_z = -0.1501_rk*ww1_zz
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
    a3_z = a2_z + 0.4318_rk*lam2_31
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
    neg_ww3_zz = -w3_z*w3_z
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_11 = neg_ww3_zz - ww3_yy
    lam3_12 = ww3_xy - alpha3_z
    lam3_13 = ww3_zx - neg_alpha3_y
    lam3_21 = alpha3_z + ww3_xy
    lam3_22 = neg_ww3_zz - ww3_xx
    lam3_23 = ww3_yz - alpha3_x
    lam3_31 = ww3_zx + neg_alpha3_y
    lam3_32 = ww3_yz + alpha3_x
    lam3_33 = -ww3_xx - ww3_yy
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_z = 0.0203_rk*lam3_21 + 0.4331_rk*lam3_22 - a3_y
    ! link 4: angular velocity [rad/s]
    w4_x = c4*w3_x + s4*w3_z
    w4_y = c4*w3_z - s4*w3_x
    t7 = neg_a3_x + (0.0203_rk*lam3_11 + 0.4331_rk*lam3_12)
    t8 = 0.0203_rk*lam3_31 + 0.4331_rk*lam3_32 - a3_z
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a4_x = c4*t7 + s4*t8
    a4_y = s4*t7 - c4*t8
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = qd(4)*w4_y - (-c4*alpha3_x - s4*alpha3_z)
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
    t9 = -s5
    w5_y = t9*w4_x - c5*w4_z
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_x = -c5*neg_a4_x - s5*a4_z
    a5_y = s5*neg_a4_x - c5*a4_z
    ! link 5: angular acceleration [rad/s^2]
    alpha5_x = qd(5)*w5_y - (s5*alpha4_z - c5*alpha4_x)
    alpha5_y = t9*alpha4_x - c5*alpha4_z - qd(5)*w5_x
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
    lam5_31 = ww5_zx - alpha5_y
    lam5_32 = alpha5_x + ww5_yz
    neg_lam5_33 = ww5_xx + ww5_yy
    ! link 6: angular velocity [rad/s]
    w6_x = c6*w5_x + s6*w5_z
    w6_y = c6*w5_z - s6*w5_x
    ! link 6: acceleration of the frame's origin, gravity taken off [m/s^2]
    a6_x = c6*a5_x + s6*a4_y
    a6_y = c6*a4_y - s6*a5_x
    ! link 6: angular acceleration [rad/s^2]
    alpha6_x = qd(6)*w6_y - (-c6*alpha5_x - s6*alpha5_z)
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
    lam6_31 = ww6_zx - alpha6_y
    lam6_32 = alpha6_x + ww6_yz
    neg_lam6_33 = ww6_xx + ww6_yy
    ! link 1: moment that turns the link [N m]
    nc1_z = 2.629303206180387_rk*qdd(1)
    ! link 2: force that moves the link [N]
    fc2_x = 0.1606745919581151_rk*lam2_12 - 7.6631781603519995_rk*neg_lam2_11
    fc2_y = 7.6631781603519995_rk*lam2_21 - 0.1606745919581151_rk*neg_lam2_22
    ! link 2: moment that turns the link [N m]
    neg_nc2_x = -0.20730445403579364_rk*lam2_32 - 0.0507946745483177_rk*(neg_lam2_22 - &
        neg_lam2_33) + (0.017097472943757824_rk*lam2_21 - 0.1174059800416141_rk*lam2_31) + &
        0.024117256252913073_rk*ww1_zz
    nc2_y = -3.522577799201274_rk*lam2_31 - 0.017097472943757824_rk*(neg_lam2_11 - neg_lam2_33) - &
        (0.1174059800416141_rk*lam2_32 - 0.0507946745483177_rk*lam2_12) + &
        1.1502430418688352_rk*ww1_zz
    t10 = 3.522577799201274_rk*lam2_21 - 0.20730445403579364_rk*lam2_12 + &
        0.1174059800416141_rk*(neg_lam2_11 - neg_lam2_22) - (0.0507946745483177_rk*lam2_13 - &
        0.017097472943757824_rk*lam2_23)
    nc2_z = t10 + (7.6631781603519995_rk*a2_y + 0.1606745919581151_rk*neg_a2_x)
    ! link 3: force that moves the link [N]
    fc3_x = 1.046378600789203_rk*lam3_11 - 5.729293810689829_rk*lam3_12
    fc3_y = 1.046378600789203_rk*lam3_21 - 5.729293810689829_rk*lam3_22
    fc3_z = 1.046378600789203_rk*lam3_31 - 5.729293810689829_rk*lam3_32
    ! link 3: moment that turns the link [N m]
    nc3_x = -5.729293810689829_rk*a3_z - (-3.4805327967608957_rk*lam3_32 - &
        0.060845712710754084_rk*(lam3_33 - lam3_22) + (0.01894848286257894_rk*lam3_21 - &
        0.28615890025504537_rk*lam3_31))
    nc3_y = -0.47176417886368593_rk*lam3_31 - 0.01894848286257894_rk*(lam3_33 - lam3_11) - &
        (0.28615890025504537_rk*lam3_32 - 0.060845712710754084_rk*lam3_12) - &
        1.046378600789203_rk*a3_z
    t11 = 0.47176417886368593_rk*lam3_21 - 3.4805327967608957_rk*lam3_12 + &
        0.28615890025504537_rk*(lam3_22 - lam3_11) - (0.060845712710754084_rk*lam3_13 - &
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
    nc4_z = t12 + (0.7777930398944852_rk*a4_y + 0.8719880516308344_rk*neg_a4_x)
    ! link 5: force that moves the link [N]
    fc5_x = 0.47660058733283606_rk*neg_lam5_11 - 0.15165250821211493_rk*lam5_12
    fc5_y = 0.15165250821211493_rk*neg_lam5_22 - 0.47660058733283606_rk*lam5_21
    fc5_z = -0.47660058733283606_rk*lam5_31 - 0.15165250821211493_rk*lam5_32
    ! link 5: moment that turns the link [N m]
    neg_nc5_x = 0.18116108322165295_rk*(neg_lam5_22 - neg_lam5_33) - 0.3901127773977262_rk*lam5_32 &
        + (-0.08058935149735619_rk*lam5_31 - 0.1558184212675505_rk*lam5_21) + &
        0.15165250821211493_rk*a4_y
    nc5_y = 0.1558184212675505_rk*(neg_lam5_11 - neg_lam5_33) - 0.1513642331069161_rk*lam5_31 + &
        (-0.18116108322165295_rk*lam5_12 - 0.08058935149735619_rk*lam5_32) + &
        0.47660058733283606_rk*a4_y
    t13 = 0.1513642331069161_rk*lam5_21 - 0.3901127773977262_rk*lam5_12 + &
        0.08058935149735619_rk*(neg_lam5_11 - neg_lam5_22) - (0.1558184212675505_rk*lam5_23 - &
        0.18116108322165295_rk*lam5_13)
    nc5_z = t13 - (0.47660058733283606_rk*a5_y - 0.15165250821211493_rk*a5_x)
    ! link 6: force that moves the link [N]
    fc6_x = 1.1185374890947408_rk*neg_lam6_11 + 1.2975168001325401_rk*lam6_12
    fc6_y = -1.2975168001325401_rk*neg_lam6_22 - 1.1185374890947408_rk*lam6_21
    fc6_z = 1.2975168001325401_rk*lam6_32 - 1.1185374890947408_rk*lam6_31
    ! link 6: moment that turns the link [N m]
    nc6_x = -1.2975168001325401_rk*a5_y - (0.2519035474197792_rk*(neg_lam6_22 - neg_lam6_33) - &
        0.43637196239865417_rk*lam6_32 - (-0.4019452224328564_rk*lam6_31 - &
        0.1902613160848803_rk*lam6_21))
    nc6_y = -0.4714480390546099_rk*lam6_31 - 0.1902613160848803_rk*(neg_lam6_11 - neg_lam6_33) + &
        (0.4019452224328564_rk*lam6_32 - 0.2519035474197792_rk*lam6_12) - &
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
    neg_f04_x = s4*f4_y - c4*f4_x
    f04_y = s4*f4_x + c4*f4_y
    ! link 4: moment through the joint, along the axes that its turn starts from [N m]
    n04_x = c4*n4_x - s4*n4_y
    n04_y = s4*n4_x + c4*n4_y
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_x = n04_x + (nc3_x - 0.4331_rk*f04_y)
    n3_y = nc3_y + 0.0203_rk*f04_y - n4_z
    n3_z = n04_y + (nc3_z - (0.4331_rk*neg_f04_x - 0.0203_rk*f4_z))
    ! link 3: force through the joint [N]
    f3_x = fc3_x - neg_f04_x
    f3_y = fc3_y - f4_z
    f3_z = fc3_z + f04_y
    ! link 3: force through the joint, along the axes that its turn starts from [N]
    f03_x = c23*f3_x - s23*f3_y
    f03_y = s23*f3_x + c23*f3_y
    ! link 3: moment through the joint, along the axes that its turn starts from [N m]
    n03_y = s23*n3_x + c23*n3_y
    t15 = 0.4318_rk*c2
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_y = n03_y - (s2*neg_nc2_x - c2*nc2_y + f3_z*t15)
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
  ! 42 multiplications, 25 additions = 67; 1 unary minus; 10 sine/cosine
  pure subroutine puma560_full_gravity(q, tau) &
      bind(c, name="puma560_full_gravity_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: c2, s2, c4, s4, c5, s5, c6, s6
    real(rk) :: angle23, c23, s23, a3_x, a3_y, a4_x, a4_y, a5_x
    real(rk) :: a5_y, a6_x, a6_y, nc2_z, neg_nc3_z, nc4_x, nc4_y, nc4_z
    real(rk) :: nc5_x, nc5_y, nc5_z, nc6_x, nc6_y, nc6_z, n06_x, n06_y
    real(rk) :: n5_x, n5_y, n5_z, n05_x, n05_y, n4_x, n4_y, n4_z
    real(rk) :: n04_x, n04_y, n3_z, neg_n03_y, n02_z

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
    a3_x = -9.8_rk*s23
    a3_y = -9.8_rk*c23
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_x = c4*a3_x
    a4_y = -s4*a3_x
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_x = c5*a4_x + s5*a3_y
    a5_y = c5*a3_y - s5*a4_x
    ! link 6: acceleration of the frame's origin, gravity taken off [m/s^2]
    a6_x = c6*a5_x + s6*a4_y
    a6_y = c6*a4_y - s6*a5_x
    ! link 2: moment that turns the link [N m]
    nc2_z = 1.5746110011895278_rk*s2 - 75.09914597144959_rk*c2
    ! link 3: moment that turns the link [N m]
    neg_nc3_z = 10.254510287734192_rk*c23 + 56.14707934476033_rk*s23
    ! link 4: moment that turns the link [N m]
    nc4_x = 8.545482905982176_rk*c23
    nc4_y = -7.622371790965955_rk*c23
    nc4_z = 0.7777930398944852_rk*a4_y - 0.8719880516308344_rk*a4_x
    ! link 5: moment that turns the link [N m]
    nc5_x = -0.15165250821211493_rk*a4_y
    nc5_y = 0.47660058733283606_rk*a4_y
    nc5_z = 0.15165250821211493_rk*a5_x - 0.47660058733283606_rk*a5_y
    ! link 6: moment that turns the link [N m]
    nc6_x = -1.2975168001325401_rk*a5_y
    nc6_y = -1.1185374890947408_rk*a5_y
    nc6_z = -1.2975168001325401_rk*a6_x - 1.1185374890947408_rk*a6_y
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    n06_x = c6*nc6_x - s6*nc6_y
    n06_y = s6*nc6_x + c6*nc6_y
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_x = nc5_x + n06_x
    n5_y = nc5_y - nc6_z
    n5_z = nc5_z + n06_y
    ! link 5: moment through the joint, along the axes that its turn starts from [N m]
    n05_x = c5*n5_x - s5*n5_y
    n05_y = s5*n5_x + c5*n5_y
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = nc4_x + n05_x
    n4_y = nc4_y + n5_z
    n4_z = nc4_z - n05_y
    ! link 4: moment through the joint, along the axes that its turn starts from [N m]
    n04_x = c4*n4_x - s4*n4_y
    n04_y = s4*n4_x + c4*n4_y
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
  ! 244 multiplications, 211 additions = 455; 7 unary minus; 10 sine/cosine
  pure subroutine puma560_full_bias(q, qd, tau) &
      bind(c, name="puma560_full_bias_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: c2, s2, c4, s4, c5, s5, c6, s6
    real(rk) :: angle23, c23, s23, w3_z, ww1_zz, a2_z, neg_w2_x, neg_w2_y
    real(rk) :: neg_alpha2_x, alpha2_y, ww2_xy, ww2_xx, ww2_yy, ww2_zz, neg_lam2_11, neg_lam2_22
    real(rk) :: neg_lam2_33, a3_z, t1, w3_x, w3_y, t2, t3, t4
    real(rk) :: t5, neg_a3_x, a3_y, alpha3_x, t6, alpha3_y, ww3_xy, ww3_xx
    real(rk) :: ww3_yy, neg_ww3_zz, lam3_11, lam3_22, lam3_33, a4_z, w4_x, w4_y
    real(rk) :: t7, t8, neg_a4_x, a4_y, alpha4_x, alpha4_y, w4_z, ww4_yz
    real(rk) :: ww4_zx, ww4_xy, ww4_xx, ww4_yy, ww4_zz, neg_lam4_11, lam4_12, lam4_13
    real(rk) :: lam4_21, neg_lam4_22, lam4_23, lam4_31, lam4_32, neg_lam4_33, w5_x, w5_y
    real(rk) :: t9, a5_x, a5_y, alpha5_x, alpha5_y, w5_z, ww5_yz, ww5_zx
    real(rk) :: ww5_xy, ww5_xx, ww5_yy, ww5_zz, neg_lam5_11, lam5_12, lam5_13, lam5_21
    real(rk) :: neg_lam5_22, lam5_23, lam5_31, lam5_32, neg_lam5_33, w6_x, w6_y, a6_x
    real(rk) :: a6_y, alpha6_x, alpha6_y, w6_z, ww6_yz, ww6_zx, ww6_xy, ww6_xx
    real(rk) :: ww6_yy, ww6_zz, neg_lam6_11, lam6_12, lam6_13, lam6_21, neg_lam6_22, lam6_23
    real(rk) :: lam6_31, lam6_32, neg_lam6_33, fc2_x, fc2_y, neg_nc2_x, nc2_y, nc2_z
    real(rk) :: fc3_x, fc3_y, fc3_z, nc3_x, nc3_y, nc3_z, fc4_x, fc4_y
    real(rk) :: fc4_z, nc4_x, nc4_y, t10, nc4_z, fc5_x, fc5_y, fc5_z
    real(rk) :: neg_nc5_x, nc5_y, t11, nc5_z, fc6_x, fc6_y, fc6_z, nc6_x
    real(rk) :: nc6_y, t12, nc6_z, f06_x, f06_y, n06_x, n06_y, n5_x
    real(rk) :: n5_y, n5_z, f5_x, f5_y, f5_z, f05_x, f05_y, n05_x
    real(rk) :: n05_y, n4_x, n4_y, n4_z, f4_x, f4_y, f4_z, f04_x
    real(rk) :: f04_y, n04_x, n04_y, n3_x, n3_y, n3_z, f3_x, f3_y
    real(rk) :: f3_z, f03_x, f03_y, n03_y, t13, n02_y, n02_z, f02_x
    real(rk) :: n1_z

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
    t6 = -w3_z
    alpha3_y = t6*w3_x
    ! link 3: products of the angular velocity [1/s^2]
    ww3_xy = w3_x*w3_y
    ww3_xx = w3_x*w3_x
    ww3_yy = w3_y*w3_y
    neg_ww3_zz = t6*w3_z
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_11 = neg_ww3_zz - ww3_yy
    lam3_22 = neg_ww3_zz - ww3_xx
    lam3_33 = -ww3_xx - ww3_yy
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_z = 0.0203_rk*ww3_xy + 0.4331_rk*lam3_22 - a3_y
    ! link 4: angular velocity [rad/s]
    w4_x = c4*w3_x + s4*w3_z
    w4_y = c4*w3_z - s4*w3_x
    t7 = neg_a3_x + (0.0203_rk*lam3_11 + 0.4331_rk*ww3_xy)
    t8 = 0.8662_rk*alpha3_x - 0.0406_rk*alpha3_y - a3_z
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a4_x = c4*t7 + s4*t8
    a4_y = s4*t7 - c4*t8
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = c4*alpha3_x + qd(4)*w4_y
    alpha4_y = -s4*alpha3_x - qd(4)*w4_x
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
    w5_y = -s5*w4_x - c5*w4_z
    t9 = -c5
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_x = t9*neg_a4_x - s5*a4_z
    a5_y = s5*neg_a4_x - c5*a4_z
    ! link 5: angular acceleration [rad/s^2]
    alpha5_x = qd(5)*w5_y - (t9*alpha4_x - s5*alpha3_y)
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
    lam5_31 = ww5_zx - alpha5_y
    lam5_32 = alpha5_x + ww5_yz
    neg_lam5_33 = ww5_xx + ww5_yy
    ! link 6: angular velocity [rad/s]
    w6_x = c6*w5_x + s6*w5_z
    w6_y = c6*w5_z - s6*w5_x
    ! link 6: acceleration of the frame's origin, gravity taken off [m/s^2]
    a6_x = c6*a5_x + s6*a4_y
    a6_y = c6*a4_y - s6*a5_x
    ! link 6: angular acceleration [rad/s^2]
    alpha6_x = qd(6)*w6_y - (-c6*alpha5_x - s6*alpha4_y)
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
    lam6_31 = ww6_zx - alpha6_y
    lam6_32 = alpha6_x + ww6_yz
    neg_lam6_33 = ww6_xx + ww6_yy
    ! link 2: force that moves the link [N]
    fc2_x = 0.1606745919581151_rk*ww2_xy - 7.6631781603519995_rk*neg_lam2_11
    fc2_y = 7.6631781603519995_rk*ww2_xy - 0.1606745919581151_rk*neg_lam2_22
    ! link 2: moment that turns the link [N m]
    neg_nc2_x = 0.4146089080715873_rk*neg_alpha2_x - 0.0507946745483177_rk*(neg_lam2_22 - &
        neg_lam2_33) + (0.2348119600832282_rk*alpha2_y + 0.017097472943757824_rk*ww2_xy) + &
        0.024117256252913073_rk*ww1_zz
    nc2_y = 7.045155598402548_rk*alpha2_y - 0.017097472943757824_rk*(neg_lam2_11 - neg_lam2_33) + &
        (0.0507946745483177_rk*ww2_xy + 0.2348119600832282_rk*neg_alpha2_x) + &
        1.1502430418688352_rk*ww1_zz
    nc2_z = 3.31527334516548_rk*ww2_xy + 0.1174059800416141_rk*(neg_lam2_11 - neg_lam2_22) - &
        (75.09914597144959_rk*c2 - 1.5746110011895278_rk*s2)
    ! link 3: force that moves the link [N]
    fc3_x = 1.046378600789203_rk*lam3_11 - 5.729293810689829_rk*ww3_xy
    fc3_y = 1.046378600789203_rk*ww3_xy - 5.729293810689829_rk*lam3_22
    fc3_z = -11.458587621379658_rk*alpha3_x - 2.092757201578406_rk*alpha3_y
    ! link 3: moment that turns the link [N m]
    nc3_x = -5.729293810689829_rk*a3_z - (-6.961065593521791_rk*alpha3_x - &
        0.060845712710754084_rk*(lam3_33 - lam3_22) + (0.5723178005100907_rk*alpha3_y + &
        0.01894848286257894_rk*ww3_xy))
    nc3_y = 0.9435283577273719_rk*alpha3_y - 0.01894848286257894_rk*(lam3_33 - lam3_11) + &
        (0.060845712710754084_rk*ww3_xy - 0.5723178005100907_rk*alpha3_x) - &
        1.046378600789203_rk*a3_z
    nc3_z = 1.046378600789203_rk*a3_y - 5.729293810689829_rk*neg_a3_x - &
        (3.0087686178972097_rk*ww3_xy - 0.28615890025504537_rk*(lam3_22 - lam3_11))
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
    nc4_z = 0.7777930398944852_rk*a4_y + 0.8719880516308344_rk*neg_a4_x - t10
    ! link 5: force that moves the link [N]
    fc5_x = 0.47660058733283606_rk*neg_lam5_11 - 0.15165250821211493_rk*lam5_12
    fc5_y = 0.15165250821211493_rk*neg_lam5_22 - 0.47660058733283606_rk*lam5_21
    fc5_z = -0.47660058733283606_rk*lam5_31 - 0.15165250821211493_rk*lam5_32
    ! link 5: moment that turns the link [N m]
    neg_nc5_x = 0.18116108322165295_rk*(neg_lam5_22 - neg_lam5_33) - 0.3901127773977262_rk*lam5_32 &
        + (-0.08058935149735619_rk*lam5_31 - 0.1558184212675505_rk*lam5_21) + &
        0.15165250821211493_rk*a4_y
    nc5_y = 0.1558184212675505_rk*(neg_lam5_11 - neg_lam5_33) - 0.1513642331069161_rk*lam5_31 + &
        (-0.18116108322165295_rk*lam5_12 - 0.08058935149735619_rk*lam5_32) + &
        0.47660058733283606_rk*a4_y
    t11 = 0.1513642331069161_rk*lam5_21 - 0.3901127773977262_rk*lam5_12 + &
        0.08058935149735619_rk*(neg_lam5_11 - neg_lam5_22) - (0.1558184212675505_rk*lam5_23 - &
        0.18116108322165295_rk*lam5_13)
    nc5_z = t11 - (0.47660058733283606_rk*a5_y - 0.15165250821211493_rk*a5_x)
    ! link 6: force that moves the link [N]
    fc6_x = 1.1185374890947408_rk*neg_lam6_11 + 1.2975168001325401_rk*lam6_12
    fc6_y = -1.2975168001325401_rk*neg_lam6_22 - 1.1185374890947408_rk*lam6_21
    fc6_z = 1.2975168001325401_rk*lam6_32 - 1.1185374890947408_rk*lam6_31
    ! link 6: moment that turns the link [N m]
    nc6_x = -1.2975168001325401_rk*a5_y - (0.2519035474197792_rk*(neg_lam6_22 - neg_lam6_33) - &
        0.43637196239865417_rk*lam6_32 - (-0.4019452224328564_rk*lam6_31 - &
        0.1902613160848803_rk*lam6_21))
    nc6_y = -0.4714480390546099_rk*lam6_31 - 0.1902613160848803_rk*(neg_lam6_11 - neg_lam6_33) - &
        (0.2519035474197792_rk*lam6_12 - 0.4019452224328564_rk*lam6_32) - &
        1.1185374890947408_rk*a5_y
    t12 = 0.43637196239865417_rk*lam6_12 - 0.4714480390546099_rk*lam6_21 + &
        0.4019452224328564_rk*(neg_lam6_11 - neg_lam6_22) - (0.1902613160848803_rk*lam6_23 + &
        0.2519035474197792_rk*lam6_13)
    nc6_z = -1.2975168001325401_rk*a6_x - 1.1185374890947408_rk*a6_y - t12
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
    n3_z = n04_y - (-0.0203_rk*f4_z - 0.4331_rk*f04_x - nc3_z)
    ! link 3: force through the joint [N]
    f3_x = fc3_x + f04_x
    f3_y = fc3_y - f4_z
    f3_z = fc3_z + f04_y
    ! link 3: force through the joint, along the axes that its turn starts from [N]
    f03_x = c23*f3_x - s23*f3_y
    f03_y = s23*f3_x + c23*f3_y
    ! link 3: moment through the joint, along the axes that its turn starts from [N m]
    n03_y = s23*n3_x + c23*n3_y
    t13 = 0.4318_rk*c2
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_y = n03_y - (s2*neg_nc2_x - c2*nc2_y + f3_z*t13)
    n02_z = n3_z + (nc2_z - (f03_x*(0.4318_rk*s2) - f03_y*t13))
    ! link 2: force through the joint, along the axes that its turn starts from [N]
    f02_x = f03_x - (s2*fc2_y - c2*fc2_x)
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = -0.1501_rk*f02_x - n02_y
    tau(1) = n1_z
    tau(2) = n02_z
    tau(3) = n3_z
    tau(4) = n4_z
    tau(5) = n5_z
    tau(6) = nc6_z
  end subroutine

  ! mass matrix, rotor inertias on its diagonal
  ! 161 multiplications, 139 additions = 300; 6 unary minus; 10 sine/cosine
  pure subroutine puma560_full_mass_matrix(q, M) &
      bind(c, name="puma560_full_mass_matrix_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(out) :: M(36)
    real(rk) :: c2, s2, c3, s3, c4, s4, c5, s5
    real(rk) :: c6, s6, fu5_x, fu5_z, nu5_x, nu5_z, fu4_x, fu4_z
    real(rk) :: nu4_x, nu4_z, fu3_x, t1, neg_fu3_z, nu3_x, nu3_y, nu3_z
    real(rk) :: fu2_x, fu2_y, neg_nu2_x, nu2_y, nu2_z, fu1_x, nu1_z, h5_x
    real(rk) :: t2, t3, t4, k5_xx, k5_xy, k5_xz, k5_yz, m5_5
    real(rk) :: fu4_x_2, fu4_z_2, neg_nu4_x, nu4_z_2, fu3_x_2, fu3_z, neg_nu3_x, nu3_y_2
    real(rk) :: nu3_z_2, fu2_x_2, fu2_y_2, neg_nu2_x_2, nu2_y_2, nu2_z_2, fu1_x_2, nu1_z_2
    real(rk) :: t5, t6, t7, t8, k4_zz, h4_x, h4_y, k4_xx
    real(rk) :: k4_yy, k4_xy, k4_xz, k4_yz, m4_4, fu3_x_3, fu3_z_2, t9
    real(rk) :: t10, nu3_x_2, nu3_y_3, nu3_z_3, fu2_x_3, fu2_y_3, nu2_x, nu2_y_3
    real(rk) :: nu2_z_3, fu1_x_3, nu1_z_3, t11, t12, t13, t14, k3_zz
    real(rk) :: h3_x, neg_h3_y, t15, k3_xx, t16, k3_yy, k3_xy, k3_xz
    real(rk) :: k3_yz, m3_3, fu2_x_4, fu2_y_4, neg_nu2_x_3, nu2_y_4, nu2_z_4, fu1_x_4
    real(rk) :: nu1_z_4, t17, t18, t19, t20, t21, t22, k2_zz
    real(rk) :: h2_x, neg_h2_y, t23, k2_yy, k2_xy, k2_xz, k2_yz, t24
    real(rk) :: m2_2, fu1_x_5, nu1_z_5, t25, m1_1

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    c3 = cos(q(3))
    s3 = sin(q(3))
    c4 = cos(q(4))
    s4 = sin(q(4))
    c5 = cos(q(5))
    s5 = sin(q(5))
    c6 = cos(q(6))
    s6 = sin(q(6))
    ! link 5: force for a unit acceleration of a joint further out
    fu5_x = 1.1185374890947408_rk*s6 - 1.2975168001325401_rk*c6
    fu5_z = -1.1185374890947408_rk*c6 - 1.2975168001325401_rk*s6
    ! link 5: moment for a unit acceleration of a joint further out
    nu5_x = -0.2519035474197792_rk*s6 - 0.1902613160848803_rk*c6
    nu5_z = 0.2519035474197792_rk*c6 - 0.1902613160848803_rk*s6
    ! link 4: force for a unit acceleration of a joint further out
    fu4_x = c5*fu5_x
    fu4_z = -s5*fu5_x
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_x = c5*nu5_x + 0.907820001453264_rk*s5
    nu4_z = 0.907820001453264_rk*c5 - s5*nu5_x
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x = c4*fu4_x - s4*fu5_z
    t1 = -s4
    neg_fu3_z = t1*fu4_x - c4*fu5_z
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_x = 0.4331_rk*neg_fu3_z - (s4*nu5_z - c4*nu4_x)
    nu3_y = -0.0203_rk*neg_fu3_z - nu4_z
    nu3_z = 0.0203_rk*fu4_z + 0.4331_rk*fu3_x - (t1*nu4_x - c4*nu5_z)
    ! link 2: force for a unit acceleration of a joint further out
    fu2_x = c3*fu3_x + s3*fu4_z
    fu2_y = s3*fu3_x - c3*fu4_z
    ! link 2: moment for a unit acceleration of a joint further out
    neg_nu2_x = s3*nu3_y - c3*nu3_x
    nu2_y = 0.4318_rk*neg_fu3_z - (-s3*nu3_x - c3*nu3_y)
    nu2_z = nu3_z + 0.4318_rk*fu2_y
    ! link 1: force for a unit acceleration of a joint further out
    fu1_x = c2*fu2_x - s2*fu2_y
    ! link 1: moment for a unit acceleration of a joint further out
    nu1_z = s2*neg_nu2_x - c2*nu2_y - 0.1501_rk*fu1_x
    ! link 5: first moment of the composite body, about the frame's origin [kg m]
    h5_x = fu5_z - 0.47660058733283606_rk
    t2 = c6*c6
    t3 = c6*s6
    t4 = 0.03507607665595572_rk*t2 + 0.8038904448657128_rk*t3
    ! link 5: second moment of the composite body [kg m^2]
    k5_xx = t4 + 0.5877361955055702_rk
    k5_xy = nu5_x + 0.08058935149735619_rk
    k5_xz = 0.03507607665595572_rk*t3 - 0.4019452224328564_rk*(2.0_rk*t2 - 1.0_rk) - &
        0.1558184212675505_rk
    k5_yz = nu5_z - 0.18116108322165295_rk
    ! link 5: mass matrix, its row of this joint
    m5_5 = t4 + 0.9778489729032964_rk
    ! link 4: force for a unit acceleration of a joint further out
    fu4_x_2 = 0.15165250821211493_rk*c5 - s5*h5_x
    fu4_z_2 = -c5*h5_x - 0.15165250821211493_rk*s5
    ! link 4: moment for a unit acceleration of a joint further out
    neg_nu4_x = c5*k5_xz - s5*k5_yz
    nu4_z_2 = s5*k5_xz + c5*k5_yz
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x_2 = c4*fu4_x_2
    fu3_z = s4*fu4_x_2
    ! link 3: moment for a unit acceleration of a joint further out
    neg_nu3_x = c4*neg_nu4_x + s4*m5_5 + 0.4331_rk*fu3_z
    nu3_y_2 = 0.0203_rk*fu3_z - nu4_z_2
    nu3_z_2 = 0.0203_rk*fu4_z_2 + 0.4331_rk*fu3_x_2 - (s4*neg_nu4_x - c4*m5_5)
    ! link 2: force for a unit acceleration of a joint further out
    fu2_x_2 = c3*fu3_x_2 + s3*fu4_z_2
    fu2_y_2 = s3*fu3_x_2 - c3*fu4_z_2
    ! link 2: moment for a unit acceleration of a joint further out
    neg_nu2_x_2 = c3*neg_nu3_x + s3*nu3_y_2
    nu2_y_2 = -0.4318_rk*fu3_z - (s3*neg_nu3_x - c3*nu3_y_2)
    nu2_z_2 = nu3_z_2 + 0.4318_rk*fu2_y_2
    ! link 1: force for a unit acceleration of a joint further out
    fu1_x_2 = c2*fu2_x_2 - s2*fu2_y_2
    ! link 1: moment for a unit acceleration of a joint further out
    nu1_z_2 = s2*neg_nu2_x_2 - c2*nu2_y_2 - 0.1501_rk*fu1_x_2
    t5 = c5*c5
    t6 = t4 + 0.1976234181078441_rk
    t7 = c5*s5
    t8 = t5*t6 - k5_xy*(2.0_rk*t7)
    ! link 4: second moment of the composite body [kg m^2]
    k4_zz = k5_xx - t8
    ! link 4: first moment of the composite body, about the frame's origin [kg m]
    h4_x = 0.7777930398944852_rk - fu4_z_2
    h4_y = 0.8719880516308344_rk - fu5_x
    ! link 4: second moment of the composite body [kg m^2]
    k4_xx = t8 + 0.7374388019750071_rk
    k4_yy = 0.7502906175782786_rk - t4
    k4_xy = neg_nu4_x + 0.05337162017689789_rk
    k4_xz = 0.2837491060266096_rk - (t6*t7 - k5_xy*(1.0_rk - 2.0_rk*t5))
    k4_yz = 0.10734691974802549_rk - nu4_z_2
    ! link 4: mass matrix, its row of this joint
    m4_4 = 1.4877294195532857_rk - (t4 - t8)
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x_3 = -(c4*h4_y) - s4*h4_x
    fu3_z_2 = c4*h4_x - s4*h4_y
    t9 = s4*k4_yz - c4*k4_xz
    t10 = 0.4331_rk*fu3_z_2
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_x_2 = t9 - t10
    nu3_y_3 = 0.0203_rk*fu3_z_2 - m4_4
    nu3_z_3 = t1*k4_xz - c4*k4_yz + 0.4331_rk*fu3_x_3
    ! link 2: force for a unit acceleration of a joint further out
    fu2_x_3 = c3*fu3_x_3
    fu2_y_3 = s3*fu3_x_3
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_x = c3*nu3_x_2 - s3*nu3_y_3
    nu2_y_3 = s3*nu3_x_2 + c3*nu3_y_3 - 0.4318_rk*fu3_z_2
    nu2_z_3 = nu3_z_3 + 0.4318_rk*fu2_y_3
    ! link 1: force for a unit acceleration of a joint further out
    fu1_x_3 = c2*fu2_x_3 - s2*fu2_y_3
    ! link 1: moment for a unit acceleration of a joint further out
    nu1_z_3 = -0.1501_rk*fu1_x_3 - (s2*nu2_x + c2*nu2_y_3)
    t11 = c4*c4
    t12 = t4 + t8 - 0.012851815603271595_rk
    t13 = c4*s4
    t14 = t11*t12 - k4_xy*(2.0_rk*t13)
    ! link 3: second moment of the composite body [kg m^2]
    k3_zz = k4_xx - t14
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    h3_x = fu3_z_2 + 1.046378600789203_rk
    neg_h3_y = fu4_x_2 + 5.729293810689829_rk
    t15 = 0.0406_rk*fu3_z_2 - (k4_yy + t14)
    ! link 3: second moment of the composite body [kg m^2]
    k3_xx = 0.47176417886368593_rk - t15
    t16 = k4_zz + 0.8662_rk*fu4_x_2
    k3_yy = t16 + 3.4805327967608957_rk
    k3_xy = t9 + 0.0203_rk*fu4_x_2 - t10 + 0.28615890025504537_rk
    k3_xz = t12*t13 - k4_xy*(1.0_rk - 2.0_rk*t11) + 0.0203_rk*fu3_x_3 + 0.01894848286257894_rk
    k3_yz = nu3_z_3 + 0.060845712710754084_rk
    ! link 3: mass matrix, its row of this joint
    m3_3 = 3.9522969756245816_rk - (t15 - t16)
    ! link 2: force for a unit acceleration of a joint further out
    fu2_x_4 = c3*neg_h3_y - s3*h3_x
    fu2_y_4 = s3*neg_h3_y + c3*h3_x
    ! link 2: moment for a unit acceleration of a joint further out
    neg_nu2_x_3 = c3*k3_xz - s3*k3_yz
    nu2_y_4 = -(s3*k3_xz) - c3*k3_yz
    nu2_z_4 = m3_3 + 0.4318_rk*fu2_y_4
    ! link 1: force for a unit acceleration of a joint further out
    fu1_x_4 = c2*fu2_x_4 - s2*fu2_y_4
    ! link 1: moment for a unit acceleration of a joint further out
    nu1_z_4 = s2*neg_nu2_x_3 - c2*nu2_y_4 - 0.1501_rk*fu1_x_4
    t17 = c3*c3
    t18 = t15 + t16 + 3.0087686178972097_rk
    t19 = c3*s3
    t20 = t17*t18 + k3_xy*(2.0_rk*t19)
    t21 = k3_xx + t20
    t22 = k3_zz - t21
    ! link 2: second moment of the composite body [kg m^2]
    k2_zz = t21 + t22
    ! link 2: first moment of the composite body, about the frame's origin [kg m]
    h2_x = fu2_y_4 + 7.6631781603519995_rk
    neg_h2_y = fu2_x_4 - 0.1606745919581151_rk
    t23 = k3_zz - t22
    ! link 2: second moment of the composite body [kg m^2]
    k2_yy = t23 + 0.20730445403579364_rk
    k2_xy = 0.1174059800416141_rk - (t18*t19 + k3_xy*(1.0_rk - 2.0_rk*t17) + 0.4318_rk*fu2_x_4)
    k2_xz = neg_nu2_x_3 - 0.4318_rk*fu3_x_3 + 0.017097472943757824_rk
    k2_yz = 0.0507946745483177_rk - nu2_y_4
    t24 = k3_yy - t20 + 0.8636_rk*fu2_y_4
    ! link 2: mass matrix, its row of this joint
    m2_2 = t23 + t24 + 3.7298822532370677_rk
    ! link 1: force for a unit acceleration of a joint further out
    fu1_x_5 = c2*neg_h2_y - s2*h2_x
    ! link 1: moment for a unit acceleration of a joint further out
    nu1_z_5 = s2*k2_xz + c2*k2_yz - 0.1501_rk*fu1_x_5
    t25 = k2_yy - (c2*c2*(t23 - t24 - 3.31527334516548_rk) + k2_xy*(2.0_rk*(c2*s2))) + (k2_zz - &
        0.3002_rk*fu3_x_3)
    ! link 1: mass matrix, its row of this joint
    m1_1 = t25 + 2.629303206180387_rk
    M(1) = m1_1
    M(2) = nu1_z_5
    M(3) = nu1_z_4
    M(4) = nu1_z_3
    M(5) = nu1_z_2
    M(6) = nu1_z
    M(7) = nu1_z_5
    M(8) = m2_2
    M(9) = nu2_z_4
    M(10) = nu2_z_3
    M(11) = nu2_z_2
    M(12) = nu2_z
    M(13) = nu1_z_4
    M(14) = nu2_z_4
    M(15) = m3_3
    M(16) = nu3_z_3
    M(17) = nu3_z_2
    M(18) = nu3_z
    M(19) = nu1_z_3
    M(20) = nu2_z_3
    M(21) = nu3_z_3
    M(22) = m4_4
    M(23) = nu4_z_2
    M(24) = nu4_z
    M(25) = nu1_z_2
    M(26) = nu2_z_2
    M(27) = nu3_z_2
    M(28) = nu4_z_2
    M(29) = m5_5
    M(30) = nu5_z
    M(31) = nu1_z
    M(32) = nu2_z
    M(33) = nu3_z
    M(34) = nu4_z
    M(35) = nu5_z
    M(36) = 0.907820001453264_rk
  end subroutine

  ! accelerations that the torques tau give
  ! 491 multiplications, 421 additions, 6 divisions = 918; 14 unary minus; 12 sine/cosine
  pure subroutine puma560_full_forward_dynamics(q, qd, tau, qdd) &
      bind(c, name="puma560_full_forward_dynamics_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(in) :: tau(6)
    real(rk), intent(out) :: qdd(6)
    real(rk) :: c2, s2, c3, s3, c4, s4, c5, s5
    real(rk) :: c6, s6, fu5_x, fu5_z, nu5_x, nu5_z, fu4_x, t1
    real(rk) :: fu4_z, nu4_x, nu4_z, fu3_x, t2, neg_fu3_z, nu3_x, nu3_y
    real(rk) :: nu3_z, fu2_x, fu2_y, neg_nu2_x, nu2_y, nu2_z, fu1_x, nu1_z
    real(rk) :: h5_x, t3, t4, t5, k5_xx, k5_xy, k5_xz, k5_yz
    real(rk) :: m5_5, fu4_x_2, t6, fu4_z_2, neg_nu4_x, nu4_z_2, fu3_x_2, fu3_z
    real(rk) :: neg_nu3_x, nu3_y_2, nu3_z_2, fu2_x_2, fu2_y_2, neg_nu2_x_2, nu2_y_2, nu2_z_2
    real(rk) :: fu1_x_2, nu1_z_2, t7, t8, t9, t10, k4_zz, h4_x
    real(rk) :: h4_y, k4_xx, k4_yy, k4_xy, k4_xz, k4_yz, m4_4, fu3_x_3
    real(rk) :: fu3_z_2, t11, t12, nu3_x_2, nu3_y_3, nu3_z_3, fu2_x_3, fu2_y_3
    real(rk) :: nu2_x, nu2_y_3, nu2_z_3, fu1_x_3, nu1_z_3, t13, t14, t15
    real(rk) :: t16, k3_zz, h3_x, neg_h3_y, t17, k3_xx, t18, k3_yy
    real(rk) :: k3_xy, k3_xz, k3_yz, m3_3, fu2_x_4, fu2_y_4, neg_nu2_x_3, nu2_y_4
    real(rk) :: nu2_z_4, fu1_x_4, nu1_z_4, t19, t20, t21, t22, t23
    real(rk) :: t24, k2_zz, h2_x, neg_h2_y, t25, k2_yy, k2_xy, k2_xz
    real(rk) :: k2_yz, t26, m2_2, fu1_x_5, nu1_z_5, t27, m1_1, angle23
    real(rk) :: c23, s23, w3_z, ww1_zz, a2_z, neg_w2_x, neg_w2_y, neg_alpha2_x
    real(rk) :: alpha2_y, ww2_xy, ww2_xx, ww2_yy, ww2_zz, neg_lam2_11, neg_lam2_22, neg_lam2_33
    real(rk) :: a3_z, t28, w3_x, w3_y, t29, t30, t31, t32
    real(rk) :: neg_a3_x, a3_y, alpha3_x, t33, alpha3_y, ww3_xy, ww3_xx, ww3_yy
    real(rk) :: neg_ww3_zz, lam3_11, lam3_22, lam3_33, a4_z, w4_x, w4_y, t34
    real(rk) :: t35, neg_a4_x, a4_y, alpha4_x, alpha4_y, w4_z, ww4_yz, ww4_zx
    real(rk) :: ww4_xy, ww4_xx, ww4_yy, ww4_zz, neg_lam4_11, lam4_12, lam4_13, lam4_21
    real(rk) :: neg_lam4_22, lam4_23, lam4_31, lam4_32, neg_lam4_33, w5_x, w5_y, a5_x
    real(rk) :: a5_y, alpha5_x, alpha5_y, w5_z, ww5_yz, ww5_zx, ww5_xy, ww5_xx
    real(rk) :: ww5_yy, ww5_zz, neg_lam5_11, lam5_12, lam5_13, lam5_21, neg_lam5_22, lam5_23
    real(rk) :: lam5_31, lam5_32, neg_lam5_33, w6_x, w6_y, a6_x, a6_y, alpha6_x
    real(rk) :: alpha6_y, w6_z, ww6_yz, ww6_zx, ww6_xy, ww6_xx, ww6_yy, ww6_zz
    real(rk) :: neg_lam6_11, lam6_12, lam6_13, lam6_21, neg_lam6_22, lam6_23, lam6_31, lam6_32
    real(rk) :: neg_lam6_33, fc2_x, fc2_y, neg_nc2_x, nc2_y, nc2_z, fc3_x, fc3_y
    real(rk) :: fc3_z, nc3_x, nc3_y, nc3_z, fc4_x, fc4_y, fc4_z, nc4_x
    real(rk) :: nc4_y, t36, nc4_z, fc5_x, fc5_y, fc5_z, neg_nc5_x, nc5_y
    real(rk) :: t37, nc5_z, fc6_x, fc6_y, fc6_z, nc6_x, nc6_y, t38
    real(rk) :: neg_nc6_z, f06_x, f06_y, n06_x, n06_y, n5_x, n5_y, n5_z
    real(rk) :: f5_x, f5_y, f5_z, f05_x, f05_y, n05_x, n05_y, n4_x
    real(rk) :: n4_y, n4_z, f4_x, f4_y, f4_z, f04_x, f04_y, n04_x
    real(rk) :: n04_y, n3_x, n3_y, n3_z, f3_x, f3_y, f3_z, f03_x
    real(rk) :: f03_y, n03_y, t39, n02_y, n02_z, f02_x, n1_z, y1
    real(rk) :: ipivot1, l2_1, l3_1, l4_1, l5_1, l6_1, pivot2, ipivot2
    real(rk) :: ld3_2, l3_2, ld4_2, l4_2, ld5_2, l5_2, ld6_2, l6_2
    real(rk) :: pivot3, ipivot3, ld4_3, l4_3, ld5_3, l5_3, ld6_3, l6_3
    real(rk) :: pivot4, ipivot4, ld5_4, l5_4, ld6_4, l6_4, pivot5, ipivot5
    real(rk) :: ld6_5, l6_5, pivot6, ipivot6, y2, y3, y4, y5
    real(rk) :: y6, qdd6, qdd5, qdd4, qdd3, qdd2, qdd1

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    c3 = cos(q(3))
    s3 = sin(q(3))
    c4 = cos(q(4))
    s4 = sin(q(4))
    c5 = cos(q(5))
    s5 = sin(q(5))
    c6 = cos(q(6))
    s6 = sin(q(6))
    ! link 5: force for a unit acceleration of a joint further out
    fu5_x = 1.1185374890947408_rk*s6 - 1.2975168001325401_rk*c6
    fu5_z = -1.1185374890947408_rk*c6 - 1.2975168001325401_rk*s6
    ! link 5: moment for a unit acceleration of a joint further out
    nu5_x = -0.2519035474197792_rk*s6 - 0.1902613160848803_rk*c6
    nu5_z = 0.2519035474197792_rk*c6 - 0.1902613160848803_rk*s6
    ! link 4: force for a unit acceleration of a joint further out
    fu4_x = c5*fu5_x
    t1 = -s5
    fu4_z = t1*fu5_x
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_x = c5*nu5_x + 0.907820001453264_rk*s5
    nu4_z = 0.907820001453264_rk*c5 - s5*nu5_x
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x = c4*fu4_x - s4*fu5_z
    t2 = -s4
    neg_fu3_z = t2*fu4_x - c4*fu5_z
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_x = 0.4331_rk*neg_fu3_z - (s4*nu5_z - c4*nu4_x)
    nu3_y = -0.0203_rk*neg_fu3_z - nu4_z
    nu3_z = 0.0203_rk*fu4_z + 0.4331_rk*fu3_x - (t2*nu4_x - c4*nu5_z)
    ! link 2: force for a unit acceleration of a joint further out
    fu2_x = c3*fu3_x + s3*fu4_z
    fu2_y = s3*fu3_x - c3*fu4_z
    ! link 2: moment for a unit acceleration of a joint further out
    neg_nu2_x = s3*nu3_y - c3*nu3_x
    nu2_y = 0.4318_rk*neg_fu3_z - (-s3*nu3_x - c3*nu3_y)
    nu2_z = nu3_z + 0.4318_rk*fu2_y
    ! link 1: force for a unit acceleration of a joint further out
    fu1_x = c2*fu2_x - s2*fu2_y
    ! link 1: moment for a unit acceleration of a joint further out
    nu1_z = s2*neg_nu2_x - c2*nu2_y - 0.1501_rk*fu1_x
    ! link 5: first moment of the composite body, about the frame's origin [kg m]
    h5_x = fu5_z - 0.47660058733283606_rk
    t3 = c6*c6
    t4 = c6*s6
    t5 = 0.03507607665595572_rk*t3 + 0.8038904448657128_rk*t4
    ! link 5: second moment of the composite body [kg m^2]
    k5_xx = t5 + 0.5877361955055702_rk
    k5_xy = nu5_x + 0.08058935149735619_rk
    k5_xz = 0.03507607665595572_rk*t4 - 0.4019452224328564_rk*(2.0_rk*t3 - 1.0_rk) - &
        0.1558184212675505_rk
    k5_yz = nu5_z - 0.18116108322165295_rk
    ! link 5: mass matrix, its row of this joint
    m5_5 = t5 + 0.9778489729032964_rk
    ! link 4: force for a unit acceleration of a joint further out
    fu4_x_2 = 0.15165250821211493_rk*c5 - s5*h5_x
    t6 = -c5
    fu4_z_2 = t6*h5_x - 0.15165250821211493_rk*s5
    ! link 4: moment for a unit acceleration of a joint further out
    neg_nu4_x = c5*k5_xz - s5*k5_yz
    nu4_z_2 = s5*k5_xz + c5*k5_yz
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x_2 = c4*fu4_x_2
    fu3_z = s4*fu4_x_2
    ! link 3: moment for a unit acceleration of a joint further out
    neg_nu3_x = c4*neg_nu4_x + s4*m5_5 + 0.4331_rk*fu3_z
    nu3_y_2 = 0.0203_rk*fu3_z - nu4_z_2
    nu3_z_2 = 0.0203_rk*fu4_z_2 + 0.4331_rk*fu3_x_2 - (s4*neg_nu4_x - c4*m5_5)
    ! link 2: force for a unit acceleration of a joint further out
    fu2_x_2 = c3*fu3_x_2 + s3*fu4_z_2
    fu2_y_2 = s3*fu3_x_2 - c3*fu4_z_2
    ! link 2: moment for a unit acceleration of a joint further out
    neg_nu2_x_2 = c3*neg_nu3_x + s3*nu3_y_2
    nu2_y_2 = -0.4318_rk*fu3_z - (s3*neg_nu3_x - c3*nu3_y_2)
    nu2_z_2 = nu3_z_2 + 0.4318_rk*fu2_y_2
    ! link 1: force for a unit acceleration of a joint further out
    fu1_x_2 = c2*fu2_x_2 - s2*fu2_y_2
    ! link 1: moment for a unit acceleration of a joint further out
    nu1_z_2 = s2*neg_nu2_x_2 - c2*nu2_y_2 - 0.1501_rk*fu1_x_2
    t7 = c5*c5
    t8 = t5 + 0.1976234181078441_rk
    t9 = c5*s5
    t10 = t7*t8 - k5_xy*(2.0_rk*t9)
    ! link 4: second moment of the composite body [kg m^2]
    k4_zz = k5_xx - t10
    ! link 4: first moment of the composite body, about the frame's origin [kg m]
    h4_x = 0.7777930398944852_rk - fu4_z_2
    h4_y = 0.8719880516308344_rk - fu5_x
    ! link 4: second moment of the composite body [kg m^2]
    k4_xx = t10 + 0.7374388019750071_rk
    k4_yy = 0.7502906175782786_rk - t5
    k4_xy = neg_nu4_x + 0.05337162017689789_rk
    k4_xz = 0.2837491060266096_rk - (t8*t9 - k5_xy*(1.0_rk - 2.0_rk*t7))
    k4_yz = 0.10734691974802549_rk - nu4_z_2
    ! link 4: mass matrix, its row of this joint
    m4_4 = 1.4877294195532857_rk - (t5 - t10)
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x_3 = -(c4*h4_y) - s4*h4_x
    fu3_z_2 = c4*h4_x - s4*h4_y
    t11 = s4*k4_yz - c4*k4_xz
    t12 = 0.4331_rk*fu3_z_2
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_x_2 = t11 - t12
    nu3_y_3 = 0.0203_rk*fu3_z_2 - m4_4
    nu3_z_3 = t2*k4_xz - c4*k4_yz + 0.4331_rk*fu3_x_3
    ! link 2: force for a unit acceleration of a joint further out
    fu2_x_3 = c3*fu3_x_3
    fu2_y_3 = s3*fu3_x_3
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_x = c3*nu3_x_2 - s3*nu3_y_3
    nu2_y_3 = s3*nu3_x_2 + c3*nu3_y_3 - 0.4318_rk*fu3_z_2
    nu2_z_3 = nu3_z_3 + 0.4318_rk*fu2_y_3
    ! link 1: force for a unit acceleration of a joint further out
    fu1_x_3 = c2*fu2_x_3 - s2*fu2_y_3
    ! link 1: moment for a unit acceleration of a joint further out
    nu1_z_3 = -0.1501_rk*fu1_x_3 - (s2*nu2_x + c2*nu2_y_3)
    t13 = c4*c4
    t14 = t5 + t10 - 0.012851815603271595_rk
    t15 = c4*s4
    t16 = t13*t14 - k4_xy*(2.0_rk*t15)
    ! link 3: second moment of the composite body [kg m^2]
    k3_zz = k4_xx - t16
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    h3_x = fu3_z_2 + 1.046378600789203_rk
    neg_h3_y = fu4_x_2 + 5.729293810689829_rk
    t17 = 0.0406_rk*fu3_z_2 - (k4_yy + t16)
    ! link 3: second moment of the composite body [kg m^2]
    k3_xx = 0.47176417886368593_rk - t17
    t18 = k4_zz + 0.8662_rk*fu4_x_2
    k3_yy = t18 + 3.4805327967608957_rk
    k3_xy = t11 + 0.0203_rk*fu4_x_2 - t12 + 0.28615890025504537_rk
    k3_xz = t14*t15 - k4_xy*(1.0_rk - 2.0_rk*t13) + 0.0203_rk*fu3_x_3 + 0.01894848286257894_rk
    k3_yz = nu3_z_3 + 0.060845712710754084_rk
    ! link 3: mass matrix, its row of this joint
    m3_3 = 3.9522969756245816_rk - (t17 - t18)
    ! link 2: force for a unit acceleration of a joint further out
    fu2_x_4 = c3*neg_h3_y - s3*h3_x
    fu2_y_4 = s3*neg_h3_y + c3*h3_x
    ! link 2: moment for a unit acceleration of a joint further out
    neg_nu2_x_3 = c3*k3_xz - s3*k3_yz
    nu2_y_4 = -(s3*k3_xz) - c3*k3_yz
    nu2_z_4 = m3_3 + 0.4318_rk*fu2_y_4
    ! link 1: force for a unit acceleration of a joint further out
    fu1_x_4 = c2*fu2_x_4 - s2*fu2_y_4
    ! link 1: moment for a unit acceleration of a joint further out
    nu1_z_4 = s2*neg_nu2_x_3 - c2*nu2_y_4 - 0.1501_rk*fu1_x_4
    t19 = c3*c3
    t20 = t17 + t18 + 3.0087686178972097_rk
    t21 = c3*s3
    t22 = t19*t20 + k3_xy*(2.0_rk*t21)
    t23 = k3_xx + t22
    t24 = k3_zz - t23
    ! link 2: second moment of the composite body [kg m^2]
    k2_zz = t23 + t24
    ! link 2: first moment of the composite body, about the frame's origin [kg m]
    h2_x = fu2_y_4 + 7.6631781603519995_rk
    neg_h2_y = fu2_x_4 - 0.1606745919581151_rk
    t25 = k3_zz - t24
    ! link 2: second moment of the composite body [kg m^2]
    k2_yy = t25 + 0.20730445403579364_rk
    k2_xy = 0.1174059800416141_rk - (t20*t21 + k3_xy*(1.0_rk - 2.0_rk*t19) + 0.4318_rk*fu2_x_4)
    k2_xz = neg_nu2_x_3 - 0.4318_rk*fu3_x_3 + 0.017097472943757824_rk
    k2_yz = 0.0507946745483177_rk - nu2_y_4
    t26 = k3_yy - t22 + 0.8636_rk*fu2_y_4
    ! link 2: mass matrix, its row of this joint
    m2_2 = t25 + t26 + 3.7298822532370677_rk
    ! link 1: force for a unit acceleration of a joint further out
    fu1_x_5 = c2*neg_h2_y - s2*h2_x
    ! link 1: moment for a unit acceleration of a joint further out
    nu1_z_5 = s2*k2_xz + c2*k2_yz - 0.1501_rk*fu1_x_5
    t27 = k2_yy - (c2*c2*(t25 - t26 - 3.31527334516548_rk) + k2_xy*(2.0_rk*(c2*s2))) + (k2_zz - &
        0.3002_rk*fu3_x_3)
    ! link 1: mass matrix, its row of this joint
    m1_1 = t27 + 2.629303206180387_rk
    ! sines and cosines of the joint angles
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
    t28 = -qd(1)
    ! link 3: angular velocity [rad/s]
    w3_x = t28*s23
    w3_y = t28*c23
    t29 = 0.4318_rk*neg_lam2_11
    t30 = 0.4318_rk*ww2_xy
    t31 = c2*t29 + s2*t30
    t32 = s2*t29 - c2*t30 + 9.8_rk
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a3_x = c23*t31 + s23*t32
    a3_y = s23*t31 - c23*t32
    ! link 3: angular acceleration [rad/s^2]
    alpha3_x = w3_z*w3_y
    t33 = -w3_z
    alpha3_y = t33*w3_x
    ! link 3: products of the angular velocity [1/s^2]
    ww3_xy = w3_x*w3_y
    ww3_xx = w3_x*w3_x
    ww3_yy = w3_y*w3_y
    neg_ww3_zz = t33*w3_z
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_11 = neg_ww3_zz - ww3_yy
    lam3_22 = neg_ww3_zz - ww3_xx
    lam3_33 = -ww3_xx - ww3_yy
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_z = 0.0203_rk*ww3_xy + 0.4331_rk*lam3_22 - a3_y
    ! link 4: angular velocity [rad/s]
    w4_x = c4*w3_x + s4*w3_z
    w4_y = c4*w3_z - s4*w3_x
    t34 = neg_a3_x + (0.0203_rk*lam3_11 + 0.4331_rk*ww3_xy)
    t35 = 0.8662_rk*alpha3_x - 0.0406_rk*alpha3_y - a3_z
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a4_x = c4*t34 + s4*t35
    a4_y = s4*t34 - c4*t35
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = c4*alpha3_x + qd(4)*w4_y
    alpha4_y = t2*alpha3_x - qd(4)*w4_x
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
    w5_y = t1*w4_x - c5*w4_z
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_x = t6*neg_a4_x - s5*a4_z
    a5_y = s5*neg_a4_x - c5*a4_z
    ! link 5: angular acceleration [rad/s^2]
    alpha5_x = qd(5)*w5_y - (t6*alpha4_x - s5*alpha3_y)
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
    lam5_31 = ww5_zx - alpha5_y
    lam5_32 = alpha5_x + ww5_yz
    neg_lam5_33 = ww5_xx + ww5_yy
    ! link 6: angular velocity [rad/s]
    w6_x = c6*w5_x + s6*w5_z
    w6_y = c6*w5_z - s6*w5_x
    ! link 6: acceleration of the frame's origin, gravity taken off [m/s^2]
    a6_x = c6*a5_x + s6*a4_y
    a6_y = c6*a4_y - s6*a5_x
    ! link 6: angular acceleration [rad/s^2]
    alpha6_x = qd(6)*w6_y - (-c6*alpha5_x - s6*alpha4_y)
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
    lam6_31 = ww6_zx - alpha6_y
    lam6_32 = alpha6_x + ww6_yz
    neg_lam6_33 = ww6_xx + ww6_yy
    ! link 2: force that moves the link [N]
    fc2_x = 0.1606745919581151_rk*ww2_xy - 7.6631781603519995_rk*neg_lam2_11
    fc2_y = 7.6631781603519995_rk*ww2_xy - 0.1606745919581151_rk*neg_lam2_22
    ! link 2: moment that turns the link [N m]
    neg_nc2_x = 0.4146089080715873_rk*neg_alpha2_x - 0.0507946745483177_rk*(neg_lam2_22 - &
        neg_lam2_33) + (0.2348119600832282_rk*alpha2_y + 0.017097472943757824_rk*ww2_xy) + &
        0.024117256252913073_rk*ww1_zz
    nc2_y = 7.045155598402548_rk*alpha2_y - 0.017097472943757824_rk*(neg_lam2_11 - neg_lam2_33) + &
        (0.0507946745483177_rk*ww2_xy + 0.2348119600832282_rk*neg_alpha2_x) + &
        1.1502430418688352_rk*ww1_zz
    nc2_z = 3.31527334516548_rk*ww2_xy + 0.1174059800416141_rk*(neg_lam2_11 - neg_lam2_22) - &
        (75.09914597144959_rk*c2 - 1.5746110011895278_rk*s2)
    ! link 3: force that moves the link [N]
    fc3_x = 1.046378600789203_rk*lam3_11 - 5.729293810689829_rk*ww3_xy
    fc3_y = 1.046378600789203_rk*ww3_xy - 5.729293810689829_rk*lam3_22
    fc3_z = -11.458587621379658_rk*alpha3_x - 2.092757201578406_rk*alpha3_y
    ! link 3: moment that turns the link [N m]
    nc3_x = -5.729293810689829_rk*a3_z - (-6.961065593521791_rk*alpha3_x - &
        0.060845712710754084_rk*(lam3_33 - lam3_22) + (0.5723178005100907_rk*alpha3_y + &
        0.01894848286257894_rk*ww3_xy))
    nc3_y = 0.9435283577273719_rk*alpha3_y - 0.01894848286257894_rk*(lam3_33 - lam3_11) + &
        (0.060845712710754084_rk*ww3_xy - 0.5723178005100907_rk*alpha3_x) - &
        1.046378600789203_rk*a3_z
    nc3_z = 1.046378600789203_rk*a3_y - 5.729293810689829_rk*neg_a3_x - &
        (3.0087686178972097_rk*ww3_xy - 0.28615890025504537_rk*(lam3_22 - lam3_11))
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
    t36 = 0.2788425785236688_rk*lam4_12 - 0.3473260245772809_rk*lam4_21 - &
        0.05337162017689789_rk*(neg_lam4_11 - neg_lam4_22) - (0.2837491060266096_rk*lam4_23 - &
        0.10734691974802549_rk*lam4_13)
    nc4_z = 0.7777930398944852_rk*a4_y + 0.8719880516308344_rk*neg_a4_x - t36
    ! link 5: force that moves the link [N]
    fc5_x = 0.47660058733283606_rk*neg_lam5_11 - 0.15165250821211493_rk*lam5_12
    fc5_y = 0.15165250821211493_rk*neg_lam5_22 - 0.47660058733283606_rk*lam5_21
    fc5_z = -0.47660058733283606_rk*lam5_31 - 0.15165250821211493_rk*lam5_32
    ! link 5: moment that turns the link [N m]
    neg_nc5_x = 0.18116108322165295_rk*(neg_lam5_22 - neg_lam5_33) - 0.3901127773977262_rk*lam5_32 &
        + (-0.08058935149735619_rk*lam5_31 - 0.1558184212675505_rk*lam5_21) + &
        0.15165250821211493_rk*a4_y
    nc5_y = 0.1558184212675505_rk*(neg_lam5_11 - neg_lam5_33) - 0.1513642331069161_rk*lam5_31 + &
        (-0.18116108322165295_rk*lam5_12 - 0.08058935149735619_rk*lam5_32) + &
        0.47660058733283606_rk*a4_y
    t37 = 0.1513642331069161_rk*lam5_21 - 0.3901127773977262_rk*lam5_12 + &
        0.08058935149735619_rk*(neg_lam5_11 - neg_lam5_22) - (0.1558184212675505_rk*lam5_23 - &
        0.18116108322165295_rk*lam5_13)
    nc5_z = t37 - (0.47660058733283606_rk*a5_y - 0.15165250821211493_rk*a5_x)
    ! link 6: force that moves the link [N]
    fc6_x = 1.1185374890947408_rk*neg_lam6_11 + 1.2975168001325401_rk*lam6_12
    fc6_y = -1.2975168001325401_rk*neg_lam6_22 - 1.1185374890947408_rk*lam6_21
    fc6_z = 1.2975168001325401_rk*lam6_32 - 1.1185374890947408_rk*lam6_31
    ! link 6: moment that turns the link [N m]
    nc6_x = -1.2975168001325401_rk*a5_y - (0.2519035474197792_rk*(neg_lam6_22 - neg_lam6_33) - &
        0.43637196239865417_rk*lam6_32 - (-0.4019452224328564_rk*lam6_31 - &
        0.1902613160848803_rk*lam6_21))
    nc6_y = -0.4714480390546099_rk*lam6_31 - 0.1902613160848803_rk*(neg_lam6_11 - neg_lam6_33) - &
        (0.2519035474197792_rk*lam6_12 - 0.4019452224328564_rk*lam6_32) - &
        1.1185374890947408_rk*a5_y
    t38 = 0.43637196239865417_rk*lam6_12 - 0.4714480390546099_rk*lam6_21 + &
        0.4019452224328564_rk*(neg_lam6_11 - neg_lam6_22) - (0.1902613160848803_rk*lam6_23 + &
        0.2519035474197792_rk*lam6_13)
    neg_nc6_z = t38 + (1.1185374890947408_rk*a6_y + 1.2975168001325401_rk*a6_x)
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
    f04_y = s4*f4_x + c4*f4_y
    ! link 4: moment through the joint, along the axes that its turn starts from [N m]
    n04_x = c4*n4_x - s4*n4_y
    n04_y = s4*n4_x + c4*n4_y
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_x = n04_x + (nc3_x - 0.4331_rk*f04_y)
    n3_y = nc3_y + 0.0203_rk*f04_y - n4_z
    n3_z = n04_y - (-0.0203_rk*f4_z - 0.4331_rk*f04_x - nc3_z)
    ! link 3: force through the joint [N]
    f3_x = fc3_x + f04_x
    f3_y = fc3_y - f4_z
    f3_z = fc3_z + f04_y
    ! link 3: force through the joint, along the axes that its turn starts from [N]
    f03_x = c23*f3_x - s23*f3_y
    f03_y = s23*f3_x + c23*f3_y
    ! link 3: moment through the joint, along the axes that its turn starts from [N m]
    n03_y = s23*n3_x + c23*n3_y
    t39 = 0.4318_rk*c2
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_y = n03_y - (s2*neg_nc2_x - c2*nc2_y + f3_z*t39)
    n02_z = n3_z + (nc2_z - (f03_x*(0.4318_rk*s2) - f03_y*t39))
    ! link 2: force through the joint, along the axes that its turn starts from [N]
    f02_x = f03_x - (s2*fc2_y - c2*fc2_x)
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = -0.1501_rk*f02_x - n02_y
    ! link 1: forward substitution
    y1 = tau(1) - n1_z
    ! factorisation M = L D L^T
    ipivot1 = 1.0_rk / m1_1
    l2_1 = nu1_z_5*ipivot1
    l3_1 = nu1_z_4*ipivot1
    l4_1 = nu1_z_3*ipivot1
    l5_1 = nu1_z_2*ipivot1
    l6_1 = nu1_z*ipivot1
    pivot2 = m2_2 - nu1_z_5*l2_1
    ipivot2 = 1.0_rk / pivot2
    ld3_2 = nu2_z_4 - nu1_z_5*l3_1
    l3_2 = ipivot2*ld3_2
    ld4_2 = nu2_z_3 - nu1_z_5*l4_1
    l4_2 = ipivot2*ld4_2
    ld5_2 = nu2_z_2 - nu1_z_5*l5_1
    l5_2 = ipivot2*ld5_2
    ld6_2 = nu2_z - nu1_z_5*l6_1
    l6_2 = ipivot2*ld6_2
    pivot3 = m3_3 - nu1_z_4*l3_1 - ld3_2*l3_2
    ipivot3 = 1.0_rk / pivot3
    ld4_3 = nu3_z_3 - nu1_z_4*l4_1 - ld3_2*l4_2
    l4_3 = ipivot3*ld4_3
    ld5_3 = nu3_z_2 - nu1_z_4*l5_1 - ld3_2*l5_2
    l5_3 = ipivot3*ld5_3
    ld6_3 = nu3_z - nu1_z_4*l6_1 - ld3_2*l6_2
    l6_3 = ipivot3*ld6_3
    pivot4 = -ld4_3*l4_3 - (nu1_z_3*l4_1 - m4_4 + ld4_2*l4_2)
    ipivot4 = 1.0_rk / pivot4
    ld5_4 = nu4_z_2 - nu1_z_3*l5_1 - ld4_2*l5_2 - ld4_3*l5_3
    l5_4 = ipivot4*ld5_4
    ld6_4 = nu4_z - nu1_z_3*l6_1 - ld4_2*l6_2 - ld4_3*l6_3
    l6_4 = ipivot4*ld6_4
    pivot5 = m5_5 - nu1_z_2*l5_1 - ld5_2*l5_2 - ld5_3*l5_3 - ld5_4*l5_4
    ipivot5 = 1.0_rk / pivot5
    ld6_5 = -ld5_4*l6_4 - (nu1_z_2*l6_1 - nu5_z + ld5_2*l6_2 + ld5_3*l6_3)
    l6_5 = ipivot5*ld6_5
    pivot6 = -ld6_4*l6_4 - (nu1_z*l6_1 - 0.907820001453264_rk + ld6_2*l6_2 + ld6_3*l6_3) - &
        ld6_5*l6_5
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
    qdd4 = ipivot4*y4 - l5_4*qdd5 - l6_4*qdd6
    ! link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd3 = -l6_3*qdd6 - (l4_3*qdd4 - ipivot3*y3 + l5_3*qdd5)
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
