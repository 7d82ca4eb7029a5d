! iiwa7: KUKA LBR iiwa 7 R800
! Numbers: MJCF of robosuite 1.5.2 (MIT), turned into modified DH; the damping that it simulates
!   with is left out
! Origin of numbers: geometry, mass, centre of mass, inertia, limits: stated by the description
! Origin of numbers: rotor inertia, friction: absent, taken as 0
! Written by robodyn 0.1.0; do not edit, generate again.
! Description: 17d842b0070c2c20fc4a1a2bf9c43b77 (a hash of its numbers)
! Options: --optimize record --scalar double --trig libm
!
! Joints, base to tip, in modified Denavit-Hartenberg frames [rad, m]:
!   1  joint_1  revolute  alpha 0      a 0  d 0.34  theta q
!       limits: -2.96706 to 2.96706 rad, 176 N m
!   2  joint_2  revolute  alpha -pi/2  a 0  d 0     theta q
!       limits: -2.0944 to 2.0944 rad, 176 N m
!   3  joint_3  revolute  alpha pi/2   a 0  d 0.4   theta q
!       limits: -2.96706 to 2.96706 rad, 110 N m
!   4  joint_4  revolute  alpha pi/2   a 0  d 0     theta q
!       limits: -2.0944 to 2.0944 rad, 110 N m
!   5  joint_5  revolute  alpha -pi/2  a 0  d 0.4   theta q
!       limits: -2.96706 to 2.96706 rad, 110 N m
!   6  joint_6  revolute  alpha -pi/2  a 0  d 0     theta q
!       limits: -2.0944 to 2.0944 rad, 40 N m
!   7  joint_7  revolute  alpha pi/2   a 0  d 0     theta q
!       limits: -3.05433 to 3.05433 rad, 40 N m
! Gravity in the base frame: 0.0, 0.0, -9.81 m/s^2
! Tool frame in the last link: [0, 0, 0.125] m, roll, pitch, yaw 0, 0, pi rad
! Arguments, in SI units, joint 1 first:
!   q    joint positions [rad, prismatic m]
!   qd   joint velocities [rad/s, prismatic m/s]
!   qdd  joint accelerations [rad/s^2, prismatic m/s^2]
!   tau  joint torques [N m, prismatic N]
!   M    mass matrix, row by row [kg m^2, kg m, kg]
! Formulation: modified Newton-Euler (lambda matrix) in modified Denavit-Hartenberg frames, on
!   base parameters: fc and nc act at and about the frame's origin, and what of a link's mass
!   makes no difference is moved to its parent.
! Of mass_matrix, forward_dynamics the best program known for these parameters, equal to the
!   recursion without being written like it: robodyn --optimize full, seed 0.
!
! Operations (every binary * is a multiplication, every binary + or - an addition):
!   inverse_dynamics: 216 multiplications, 194 additions = 410; 9 unary minus; 12 sine/cosine
!   gravity: 30 multiplications, 18 additions = 48; 2 unary minus; 10 sine/cosine
!   bias: 209 multiplications, 177 additions = 386; 8 unary minus; 12 sine/cosine
!   mass_matrix: 103 multiplications, 94 additions = 197; 2 unary minus; 12 sine/cosine
!   forward_dynamics: 428 multiplications, 368 additions, 6 divisions = 802; 16 unary minus; 12
!       sine/cosine
module iiwa7_dynamics
  use, intrinsic :: iso_c_binding, only: rk => c_double
  implicit none
  private

  public :: iiwa7_inverse_dynamics
  public :: iiwa7_gravity
  public :: iiwa7_bias
  public :: iiwa7_mass_matrix
  public :: iiwa7_forward_dynamics

contains

  ! torques that give the accelerations qdd
  ! 216 multiplications, 194 additions = 410; 9 unary minus; 12 sine/cosine
  pure subroutine iiwa7_inverse_dynamics(q, qd, qdd, tau) &
      bind(c, name="iiwa7_inverse_dynamics_f")
    real(rk), intent(in) :: q(7)
    real(rk), intent(in) :: qd(7)
    real(rk), intent(in) :: qdd(7)
    real(rk), intent(out) :: tau(7)
    real(rk) :: c2, t1, w2_y, s2, w2_x, lam2_23, ww2_yz, alpha2_x, lam2_13, ww2_zx, alpha2_y
    real(rk) :: ww2_xy, ww2_xx, ww2_zz, ww2_yy, lam2_12, lam2_32, neg_lam2_22, lam2_21, neg_lam2_11
    real(rk) :: neg_lam2_33, lam2_31, s3, c3, w3_y, w3_x, w3_z, alpha3_x, alpha3_z, alpha3_y
    real(rk) :: ww3_xy, ww3_zx, ww3_xx, ww3_zz, ww3_yz, lam3_21, lam3_12, lam3_13, lam3_32
    real(rk) :: neg_lam3_31, s4, c4, w4_y, w4_x, w4_z, alpha4_x, alpha4_z, alpha4_y, ww4_xy, ww4_yz
    real(rk) :: ww4_xx, ww4_zz, ww4_zx, lam4_12, lam4_32, neg_lam4_22, lam4_21, lam4_13
    real(rk) :: neg_lam4_33, lam4_31, s5, c5, w5_y, w5_x, w5_z, alpha5_x, alpha5_z, alpha5_y
    real(rk) :: ww5_xy, ww5_xx, t2, neg_ww5_zz, ww5_yy, ww5_yz, ww5_zx, lam5_21, lam5_12, lam5_22
    real(rk) :: lam5_11, lam5_23, lam5_13, lam5_32, lam5_31, c6, s6, w6_x, w6_z, w6_y, alpha6_y
    real(rk) :: alpha6_z, alpha6_x, ww6_xy, ww6_zx, ww6_yz, ww6_xx, ww6_zz, lam6_21, lam6_12
    real(rk) :: lam6_13, lam6_32, neg_lam6_22, lam6_31, c7, s7, w7_x, w7_y, w7_z, alpha7_z
    real(rk) :: alpha7_x, alpha7_y, ww7_xy, ww7_xx, ww7_yy, ww7_yz, ww7_zx, nc7_z, nc7_x, nc7_y
    real(rk) :: n07_y, n07_x, t3, t4, t5, t6, t7, t8, t9, t10, t11, nc6_z, t12, nc6_x, nc6_y, n6_z
    real(rk) :: n6_x, n6_y, n06_y, n06_x, t13, nc5_z, nc5_x, nc5_y, n5_z, n5_x, n5_y, n05_y, n05_x
    real(rk) :: nc4_z, nc4_x, nc4_y, t14, t15, t16, t17, t18, n4_z, t19, n4_x, n4_y, n04_y, nc3_z
    real(rk) :: nc3_y, n3_z, n3_y, nc2_y, t20, t21, t22, t23, n2_z, t24, n2_x, n2_y, n02_y, nc1_z
    real(rk) :: n1_z

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    t1 = -qd(1)
    ! link 2: angular velocity [rad/s]
    w2_y = t1*c2
    ! sines and cosines of the joint angles
    s2 = sin(q(2))
    ! link 2: angular velocity [rad/s]
    w2_x = t1*s2
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    lam2_23 = s2*qdd(1)
    ! link 2: products of the angular velocity [1/s^2]
    ww2_yz = w2_y*qd(2)
    ! link 2: angular acceleration [rad/s^2]
    alpha2_x = ww2_yz - lam2_23
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    lam2_13 = -c2*qdd(1)
    ! link 2: products of the angular velocity [1/s^2]
    ww2_zx = w2_x*qd(2)
    ! link 2: angular acceleration [rad/s^2]
    alpha2_y = lam2_13 - ww2_zx
    ! link 2: products of the angular velocity [1/s^2]
    ww2_xy = w2_y*w2_x
    ww2_xx = w2_x*w2_x
    ww2_zz = qd(2)*qd(2)
    ww2_yy = w2_y*w2_y
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    lam2_12 = ww2_xy - qdd(2)
    lam2_32 = ww2_yz + alpha2_x
    neg_lam2_22 = ww2_xx + ww2_zz
    lam2_21 = ww2_xy + qdd(2)
    neg_lam2_11 = ww2_zz + ww2_yy
    neg_lam2_33 = qd(1)*qd(1)
    lam2_31 = ww2_zx - alpha2_y
    ! sines and cosines of the joint angles
    s3 = sin(q(3))
    c3 = cos(q(3))
    ! link 3: angular velocity [rad/s]
    w3_y = qd(2)*c3 - w2_x*s3
    w3_x = w2_x*c3 + qd(2)*s3
    w3_z = qd(3) - w2_y
    ! link 3: angular acceleration [rad/s^2]
    alpha3_x = w3_y*qd(3) - (-qdd(2)*s3 - alpha2_x*c3)
    alpha3_z = qdd(3) - alpha2_y
    alpha3_y = qdd(2)*c3 - alpha2_x*s3 - w3_x*qd(3)
    ! link 3: products of the angular velocity [1/s^2]
    ww3_xy = w3_y*w3_x
    ww3_zx = w3_x*w3_z
    ww3_xx = w3_x*w3_x
    ww3_zz = w3_z*w3_z
    ww3_yz = w3_y*w3_z
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_21 = alpha3_z + ww3_xy
    lam3_12 = ww3_xy - alpha3_z
    lam3_13 = alpha3_y + ww3_zx
    lam3_32 = alpha3_x + ww3_yz
    neg_lam3_31 = alpha3_y - ww3_zx
    ! sines and cosines of the joint angles
    s4 = sin(q(4))
    c4 = cos(q(4))
    ! link 4: angular velocity [rad/s]
    w4_y = w3_z*c4 - w3_x*s4
    w4_x = w3_x*c4 + w3_z*s4
    w4_z = qd(4) - w3_y
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = w4_y*qd(4) - (-alpha3_z*s4 - alpha3_x*c4)
    alpha4_z = qdd(4) - alpha3_y
    alpha4_y = alpha3_z*c4 - alpha3_x*s4 - w4_x*qd(4)
    ! link 4: products of the angular velocity [1/s^2]
    ww4_xy = w4_y*w4_x
    ww4_yz = w4_y*w4_z
    ww4_xx = w4_x*w4_x
    ww4_zz = w4_z*w4_z
    ww4_zx = w4_x*w4_z
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_12 = ww4_xy - alpha4_z
    lam4_32 = alpha4_x + ww4_yz
    neg_lam4_22 = ww4_xx + ww4_zz
    lam4_21 = alpha4_z + ww4_xy
    lam4_13 = alpha4_y + ww4_zx
    neg_lam4_33 = ww3_xx + ww3_zz
    lam4_31 = ww4_zx - alpha4_y
    ! sines and cosines of the joint angles
    s5 = sin(q(5))
    c5 = cos(q(5))
    ! link 5: angular velocity [rad/s]
    w5_y = -w4_z*c5 - w4_x*s5
    w5_x = w4_x*c5 - w4_z*s5
    w5_z = w4_y + qd(5)
    ! link 5: angular acceleration [rad/s^2]
    alpha5_x = w5_y*qd(5) - (alpha4_z*s5 - alpha4_x*c5)
    alpha5_z = alpha4_y + qdd(5)
    alpha5_y = -alpha4_z*c5 - alpha4_x*s5 - w5_x*qd(5)
    ! link 5: products of the angular velocity [1/s^2]
    ww5_xy = w5_y*w5_x
    ww5_xx = w5_x*w5_x
    t2 = -w5_z
    neg_ww5_zz = t2*w5_z
    ww5_yy = w5_y*w5_y
    ww5_yz = w5_y*w5_z
    ww5_zx = w5_x*w5_z
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_21 = alpha5_z + ww5_xy
    lam5_12 = ww5_xy - alpha5_z
    lam5_22 = neg_ww5_zz - ww5_xx
    lam5_11 = neg_ww5_zz - ww5_yy
    lam5_23 = ww5_yz - alpha5_x
    lam5_13 = alpha5_y + ww5_zx
    lam5_32 = alpha5_x + ww5_yz
    lam5_31 = ww5_zx - alpha5_y
    ! sines and cosines of the joint angles
    c6 = cos(q(6))
    s6 = sin(q(6))
    ! link 6: angular velocity [rad/s]
    w6_x = w5_x*c6 - w5_z*s6
    w6_z = w5_y + qd(6)
    w6_y = t2*c6 - w5_x*s6
    ! link 6: angular acceleration [rad/s^2]
    alpha6_y = -alpha5_z*c6 - alpha5_x*s6 - w6_x*qd(6)
    alpha6_z = alpha5_y + qdd(6)
    alpha6_x = qd(6)*w6_y - (alpha5_z*s6 - alpha5_x*c6)
    ! link 6: products of the angular velocity [1/s^2]
    ww6_xy = w6_x*w6_y
    ww6_zx = w6_x*w6_z
    ww6_yz = w6_z*w6_y
    ww6_xx = w6_x*w6_x
    ww6_zz = w6_z*w6_z
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    lam6_21 = alpha6_z + ww6_xy
    lam6_12 = ww6_xy - alpha6_z
    lam6_13 = alpha6_y + ww6_zx
    lam6_32 = alpha6_x + ww6_yz
    neg_lam6_22 = ww6_xx + ww6_zz
    lam6_31 = ww6_zx - alpha6_y
    ! sines and cosines of the joint angles
    c7 = cos(q(7))
    s7 = sin(q(7))
    ! link 7: angular velocity [rad/s]
    w7_x = w6_x*c7 + w6_z*s7
    w7_y = w6_z*c7 - w6_x*s7
    w7_z = qd(7) - w6_y
    ! link 7: angular acceleration [rad/s^2]
    alpha7_z = qdd(7) - alpha6_y
    alpha7_x = w7_y*qd(7) - (-alpha6_z*s7 - alpha6_x*c7)
    alpha7_y = alpha6_z*c7 - alpha6_x*s7 - w7_x*qd(7)
    ! link 7: products of the angular velocity [1/s^2]
    ww7_xy = w7_x*w7_y
    ww7_xx = w7_x*w7_x
    ww7_yy = w7_y*w7_y
    ww7_yz = w7_y*w7_z
    ww7_zx = w7_x*w7_z
    ! link 7: moment that turns the link [N m]
    nc7_z = 0.0005911788535720988_rk*(ww7_xx - ww7_yy) - &
        0.002872_rk*(-0.0034821092676768804_rk*ww7_xy - alpha7_z)
    nc7_x = 0.002872_rk*ww7_yz - 1.0000617816768e-05_rk*alpha7_x + &
        0.0005911788535720988_rk*(alpha7_y - ww7_zx)
    nc7_y = 0.0005911788535720988_rk*(alpha7_x + ww7_yz) - 0.002882000617816768_rk*ww7_zx
    ! link 7: moment through the joint, along the axes that its turn starts from [N m]
    n07_y = s7*nc7_x + c7*nc7_y
    n07_x = c7*nc7_x - s7*nc7_y
    t3 = lam2_12 + 24.525_rk*s2
    t4 = c3*t3 + lam2_32*s3
    t5 = neg_lam2_22 - 24.525_rk*c2
    t6 = t4*c4 + t5*s4
    t7 = lam4_12 - t6
    t8 = s3*t3 - lam2_32*c3
    t9 = t8 - lam4_32
    t10 = c5*t7 + s5*t9
    t11 = neg_lam4_22 + (t5*c4 - t4*s4)
    ! link 6: moment that turns the link [N m]
    nc6_z = 0.0021385000000000006_rk*(lam6_21 - 22.893746966169505_rk*lam6_12) - &
        0.00040380860809999307_rk*lam6_13 + 0.126974784_rk*(t10*c6 + t11*s6)
    t12 = s5*t7 - c5*t9
    nc6_x = 0.126974784_rk*t12 - (-0.00040380860809999307_rk*(lam5_22 + neg_lam6_22) - &
        0.0489582778871535_rk*lam6_32)
    nc6_y = 0.00040380860809999307_rk*lam6_12 - 0.0021385000000000006_rk*lam6_31
    ! link 6: moment through the joint, about the frame's origin [N m]
    n6_z = n07_y + nc6_z
    n6_x = n07_x + nc6_x
    n6_y = nc6_y - nc7_z
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    n06_y = s6*n6_x + c6*n6_y
    n06_x = c6*n6_x - s6*n6_y
    t13 = 0.0019790216329999993_rk*(lam5_21 - 11.494554054627578_rk*lam5_12) - &
        4.54293e-06_rk*(lam5_11 - lam5_22) + (2.466162e-05_rk*lam5_23 - &
        0.001232947371581177_rk*lam5_13)
    ! link 5: moment that turns the link [N m]
    nc5_z = t13 + (8.6532e-05_rk*t12 + 0.074771712_rk*t10)
    nc5_x = 0.074771712_rk*t11 - (2.466162e-05_rk*lam5_21 - 4.54293e-06_rk*lam5_31 + &
        0.001232947371581177_rk*(neg_lam4_22 + lam5_22 - 18.45007472348394_rk*lam5_32))
    nc5_y = 2.466162e-05_rk*(neg_lam4_22 + lam5_11) - 0.0019790216329999993_rk*lam5_31 + &
        0.001232947371581177_rk*(lam5_12 - 0.0036846098257819226_rk*lam5_32) - 8.6532e-05_rk*t11
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_z = nc5_z - n06_y
    n5_x = n06_x + nc5_x
    n5_y = n6_z + nc5_y
    ! link 5: moment through the joint, along the axes that its turn starts from [N m]
    n05_y = s5*n5_x + c5*n5_y
    n05_x = c5*n5_x - s5*n5_y
    ! link 4: moment that turns the link [N m]
    nc4_z = 1.21690048_rk*(t6 - 0.009497438493991343_rk*(lam4_13 + &
        0.2922356284490603_rk*(318.82012208965233_rk*lam4_12 - lam4_21)))
    nc4_x = 1.21690048_rk*(0.009497438493991343_rk*(neg_lam4_22 - neg_lam4_33 + &
        93.1705987410757_rk*lam4_32) - t8)
    nc4_y = 0.011557437462108543_rk*(lam4_12 - 0.2922356284490603_rk*lam4_31)
    t14 = -0.126974784_rk*lam6_12
    t15 = 0.126974784_rk*neg_lam6_22
    t16 = c6*t14 - s6*t15 + (-8.6532e-05_rk*lam5_11 - 0.074771712_rk*lam5_12)
    t17 = 8.6532e-05_rk*lam5_21 + 0.074771712_rk*lam5_22 + 0.126974784_rk*lam6_32
    t18 = c5*t16 + s5*t17
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_z = nc4_z - (t18 + n05_y)
    t19 = s5*t16 - c5*t17
    n4_x = nc4_x - (t19 - n05_x)
    n4_y = n5_z + nc4_y
    ! link 4: moment through the joint, along the axes that its turn starts from [N m]
    n04_y = s4*n4_x + c4*n4_y
    ! link 3: moment that turns the link [N m]
    nc3_z = 0.00131684_rk*(t4 + 10.273228415812028_rk*(lam3_13 + 0.2993735727362736_rk*(lam3_21 - &
        12.695980561828286_rk*lam3_12)))
    nc3_y = 0.013528198107077912_rk*(0.2993735727362736_rk*neg_lam3_31 - lam3_12)
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_z = n04_y + nc3_z
    n3_y = nc3_y - n4_z
    ! link 2: moment that turns the link [N m]
    nc2_y = 0.003669880873643688_rk*(neg_lam2_11 - neg_lam2_33 - 1.201756801003488_rk*lam2_31 - &
        2.3512054197641956_rk*(lam2_12 + 0.007142857142857143_rk*lam2_32))
    t20 = s4*(s6*t14 + c6*t15 - (-8.6532e-05_rk*lam5_31 - 0.074771712_rk*lam5_32) + &
        1.21690048_rk*neg_lam4_22)
    t21 = c4*(t18 + 1.21690048_rk*lam4_12) + t20 + 0.00131684_rk*lam3_12 + n3_y
    t22 = 0.004410304298773924_rk*(lam2_21 - 514.5784139189633_rk*lam2_12) - &
        (0.003669880873643688_rk*(lam2_23 - 2.3512054197641956_rk*lam2_13) - 0.0102478203_rk*(c2 - &
        5775.2525774676205_rk*s2))
    t23 = c4*n4_x - (t19 - 1.21690048_rk*lam4_32) - s4*n4_y - 0.00131684_rk*(t5 - &
        10.273228415812028_rk*(neg_lam2_22 - neg_lam4_33 + 3.8008410601848155_rk*lam3_32) - &
        neg_lam4_33)
    ! link 2: moment through the joint, about the frame's origin [N m]
    n2_z = c3*t21 - (6.163317e-05_rk*(neg_lam2_22 - neg_lam2_11) - t22) + s3*t23
    t24 = s3*t21 - (0.003669880873643688_rk*lam2_21 - (0.0086286438_rk*(neg_lam2_22 - neg_lam2_33 &
        - 263.0132201033808_rk*lam2_32) - 6.163317e-05_rk*lam2_31))
    n2_x = c3*t23 - t24
    n2_y = nc2_y - n3_z
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_y = s2*n2_x + c2*n2_y
    ! link 1: moment that turns the link [N m]
    nc1_z = 0.047459659690009905_rk*qdd(1)
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = nc1_z - n02_y
    tau(1) = n1_z
    tau(2) = n2_z
    tau(3) = n3_z
    tau(4) = n4_z
    tau(5) = n5_z
    tau(6) = n6_z
    tau(7) = nc7_z
  end subroutine

  ! torques that hold the arm at rest
  ! 30 multiplications, 18 additions = 48; 2 unary minus; 10 sine/cosine
  pure subroutine iiwa7_gravity(q, tau) &
      bind(c, name="iiwa7_gravity_f")
    real(rk), intent(in) :: q(7)
    real(rk), intent(out) :: tau(7)
    real(rk) :: c6, hw6_y, c5, c4, s2, c3, c2, s4, s5, s3, s6, hw6_x, t1, t2, t3, tau6, t4, hw5_y
    real(rk) :: hw5_x, tau5, t5, hw4_y, hw4_x, tau4, t6, tau3, hw3_x, hw2_x, t7

    ! sines and cosines of the joint angles
    c6 = cos(q(6))
    ! link 6: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw6_y = -3.1140565776_rk*c6
    ! sines and cosines of the joint angles
    c5 = cos(q(5))
    c4 = cos(q(4))
    s2 = sin(q(2))
    c3 = cos(q(3))
    c2 = cos(q(2))
    s4 = sin(q(4))
    s5 = sin(q(5))
    s3 = sin(q(3))
    s6 = sin(q(6))
    ! link 6: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw6_x = 3.1140565776_rk*s6
    t1 = s2*c3
    t2 = c4*t1 - c2*s4
    t3 = s2*s3
    ! link 6: joint torque [N m], at a prismatic joint force [N]
    tau6 = hw6_y*(c5*t2 - s5*t3) + hw6_x*(-c4*c2 - t1*s4)
    t4 = hw6_x - 0.0021221973_rk
    ! link 5: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw5_y = s5*t4 - 1.8337762368_rk*c5
    hw5_x = c5*t4 + 1.8337762368_rk*s5
    ! link 5: joint torque [N m], at a prismatic joint force [N]
    tau5 = t2*hw5_y + t3*hw5_x
    t5 = 29.844484272_rk - hw6_y
    ! link 4: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw4_y = s4*hw5_x + c4*t5
    hw4_x = c4*hw5_x - s4*t5
    ! link 4: joint torque [N m], at a prismatic joint force [N]
    tau4 = t1*hw4_y + c2*hw4_x
    t6 = hw5_y + 0.032295501_rk
    ! link 3: joint torque [N m], at a prismatic joint force [N]
    tau3 = t1*t6 + t3*hw4_x
    ! link 3: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw3_x = c3*hw4_x - s3*t6
    ! link 2: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw2_x = c2*(hw3_x - 0.0102478203_rk) + s2*(hw4_y + 59.183750601_rk)
    t7 = -hw2_x
    tau(1) = 0.0_rk
    tau(2) = t7
    tau(3) = tau3
    tau(4) = tau4
    tau(5) = tau5
    tau(6) = tau6
    tau(7) = 0.0_rk
  end subroutine

  ! torques at zero acceleration: Coriolis, centrifugal, gravity, friction
  ! 209 multiplications, 177 additions = 386; 8 unary minus; 12 sine/cosine
  pure subroutine iiwa7_bias(q, qd, tau) &
      bind(c, name="iiwa7_bias_f")
    real(rk), intent(in) :: q(7)
    real(rk), intent(in) :: qd(7)
    real(rk), intent(out) :: tau(7)
    real(rk) :: c2, t1, w2_y, s2, w2_x, alpha2_x, neg_alpha2_y, ww2_xy, ww2_xx, ww2_zz, ww2_yy
    real(rk) :: neg_lam2_22, neg_lam2_11, neg_lam2_33, s3, c3, w3_y, w3_x, w3_z, alpha3_x, alpha3_y
    real(rk) :: ww3_xy, ww3_zx, ww3_xx, ww3_zz, ww3_yz, lam3_21, lam3_12, lam3_13, lam3_32
    real(rk) :: neg_lam3_31, s4, c4, w4_y, w4_x, w4_z, alpha4_x, alpha4_y, ww4_xy, ww4_yz, ww4_xx
    real(rk) :: ww4_zz, ww4_zx, lam4_12, lam4_32, neg_lam4_22, lam4_21, lam4_13, neg_lam4_33
    real(rk) :: lam4_31, s5, c5, w5_y, w5_x, w5_z, alpha5_x, alpha5_y, ww5_xy, ww5_xx, t2
    real(rk) :: neg_ww5_zz, ww5_yy, ww5_yz, ww5_zx, lam5_21, lam5_12, lam5_22, lam5_11, lam5_23
    real(rk) :: lam5_13, lam5_32, lam5_31, c6, s6, w6_x, w6_z, w6_y, alpha6_y, alpha6_x, ww6_xy
    real(rk) :: ww6_zx, ww6_yz, ww6_xx, ww6_zz, lam6_21, lam6_12, lam6_13, lam6_32, neg_lam6_22
    real(rk) :: lam6_31, c7, s7, w7_x, w7_y, w7_z, alpha7_x, alpha7_y, ww7_xy, ww7_xx, ww7_yy
    real(rk) :: ww7_yz, ww7_zx, nc7_z, nc7_x, nc7_y, n07_y, n07_x, t3, t4, t5, t6, t7, t8, t9, t10
    real(rk) :: t11, t12, nc6_z, t13, nc6_x, nc6_y, n6_z, n6_x, n6_y, n06_y, n06_x, t14, nc5_z
    real(rk) :: nc5_x, nc5_y, n5_z, n5_x, n5_y, n05_y, n05_x, nc4_z, nc4_x, nc4_y, t15, t16, t17
    real(rk) :: t18, t19, n4_z, t20, n4_x, n4_y, n04_y, nc3_z, nc3_y, n3_z, n3_y, neg_nc2_z, nc2_y
    real(rk) :: t21, t22, t23, n2_z, t24, n2_x, neg_n2_y, neg_n02_y

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    t1 = -qd(1)
    ! link 2: angular velocity [rad/s]
    w2_y = t1*c2
    ! sines and cosines of the joint angles
    s2 = sin(q(2))
    ! link 2: angular velocity [rad/s]
    w2_x = t1*s2
    ! link 2: angular acceleration [rad/s^2]
    alpha2_x = w2_y*qd(2)
    neg_alpha2_y = w2_x*qd(2)
    ! link 2: products of the angular velocity [1/s^2]
    ww2_xy = w2_y*w2_x
    ww2_xx = w2_x*w2_x
    ww2_zz = qd(2)*qd(2)
    ww2_yy = w2_y*w2_y
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_22 = ww2_xx + ww2_zz
    neg_lam2_11 = ww2_zz + ww2_yy
    neg_lam2_33 = qd(1)*qd(1)
    ! sines and cosines of the joint angles
    s3 = sin(q(3))
    c3 = cos(q(3))
    ! link 3: angular velocity [rad/s]
    w3_y = qd(2)*c3 - w2_x*s3
    w3_x = w2_x*c3 + qd(2)*s3
    w3_z = qd(3) - w2_y
    ! link 3: angular acceleration [rad/s^2]
    alpha3_x = alpha2_x*c3 + w3_y*qd(3)
    alpha3_y = -w3_x*qd(3) - alpha2_x*s3
    ! link 3: products of the angular velocity [1/s^2]
    ww3_xy = w3_y*w3_x
    ww3_zx = w3_x*w3_z
    ww3_xx = w3_x*w3_x
    ww3_zz = w3_z*w3_z
    ww3_yz = w3_y*w3_z
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_21 = neg_alpha2_y + ww3_xy
    lam3_12 = ww3_xy - neg_alpha2_y
    lam3_13 = alpha3_y + ww3_zx
    lam3_32 = alpha3_x + ww3_yz
    neg_lam3_31 = alpha3_y - ww3_zx
    ! sines and cosines of the joint angles
    s4 = sin(q(4))
    c4 = cos(q(4))
    ! link 4: angular velocity [rad/s]
    w4_y = w3_z*c4 - w3_x*s4
    w4_x = w3_x*c4 + w3_z*s4
    w4_z = qd(4) - w3_y
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = w4_y*qd(4) - (-alpha3_x*c4 - neg_alpha2_y*s4)
    alpha4_y = neg_alpha2_y*c4 - alpha3_x*s4 - w4_x*qd(4)
    ! link 4: products of the angular velocity [1/s^2]
    ww4_xy = w4_y*w4_x
    ww4_yz = w4_y*w4_z
    ww4_xx = w4_x*w4_x
    ww4_zz = w4_z*w4_z
    ww4_zx = w4_x*w4_z
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_12 = alpha3_y + ww4_xy
    lam4_32 = alpha4_x + ww4_yz
    neg_lam4_22 = ww4_xx + ww4_zz
    lam4_21 = ww4_xy - alpha3_y
    lam4_13 = alpha4_y + ww4_zx
    neg_lam4_33 = ww3_xx + ww3_zz
    lam4_31 = ww4_zx - alpha4_y
    ! sines and cosines of the joint angles
    s5 = sin(q(5))
    c5 = cos(q(5))
    ! link 5: angular velocity [rad/s]
    w5_y = -w4_z*c5 - w4_x*s5
    w5_x = w4_x*c5 - w4_z*s5
    w5_z = w4_y + qd(5)
    ! link 5: angular acceleration [rad/s^2]
    alpha5_x = w5_y*qd(5) - (-alpha3_y*s5 - alpha4_x*c5)
    alpha5_y = alpha3_y*c5 - alpha4_x*s5 - w5_x*qd(5)
    ! link 5: products of the angular velocity [1/s^2]
    ww5_xy = w5_y*w5_x
    ww5_xx = w5_x*w5_x
    t2 = -w5_z
    neg_ww5_zz = t2*w5_z
    ww5_yy = w5_y*w5_y
    ww5_yz = w5_y*w5_z
    ww5_zx = w5_x*w5_z
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_21 = alpha4_y + ww5_xy
    lam5_12 = ww5_xy - alpha4_y
    lam5_22 = neg_ww5_zz - ww5_xx
    lam5_11 = neg_ww5_zz - ww5_yy
    lam5_23 = ww5_yz - alpha5_x
    lam5_13 = alpha5_y + ww5_zx
    lam5_32 = alpha5_x + ww5_yz
    lam5_31 = ww5_zx - alpha5_y
    ! sines and cosines of the joint angles
    c6 = cos(q(6))
    s6 = sin(q(6))
    ! link 6: angular velocity [rad/s]
    w6_x = w5_x*c6 - w5_z*s6
    w6_z = w5_y + qd(6)
    w6_y = t2*c6 - w5_x*s6
    ! link 6: angular acceleration [rad/s^2]
    alpha6_y = -alpha4_y*c6 - alpha5_x*s6 - w6_x*qd(6)
    alpha6_x = qd(6)*w6_y - (alpha4_y*s6 - alpha5_x*c6)
    ! link 6: products of the angular velocity [1/s^2]
    ww6_xy = w6_x*w6_y
    ww6_zx = w6_x*w6_z
    ww6_yz = w6_z*w6_y
    ww6_xx = w6_x*w6_x
    ww6_zz = w6_z*w6_z
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    lam6_21 = alpha5_y + ww6_xy
    lam6_12 = ww6_xy - alpha5_y
    lam6_13 = alpha6_y + ww6_zx
    lam6_32 = alpha6_x + ww6_yz
    neg_lam6_22 = ww6_xx + ww6_zz
    lam6_31 = ww6_zx - alpha6_y
    ! sines and cosines of the joint angles
    c7 = cos(q(7))
    s7 = sin(q(7))
    ! link 7: angular velocity [rad/s]
    w7_x = w6_x*c7 + w6_z*s7
    w7_y = w6_z*c7 - w6_x*s7
    w7_z = qd(7) - w6_y
    ! link 7: angular acceleration [rad/s^2]
    alpha7_x = w7_y*qd(7) - (-alpha5_y*s7 - alpha6_x*c7)
    alpha7_y = alpha5_y*c7 - alpha6_x*s7 - w7_x*qd(7)
    ! link 7: products of the angular velocity [1/s^2]
    ww7_xy = w7_x*w7_y
    ww7_xx = w7_x*w7_x
    ww7_yy = w7_y*w7_y
    ww7_yz = w7_y*w7_z
    ww7_zx = w7_x*w7_z
    ! link 7: moment that turns the link [N m]
    nc7_z = 0.0005911788535720988_rk*(ww7_xx - ww7_yy) - 0.002872_rk*(alpha6_y - &
        0.0034821092676768804_rk*ww7_xy)
    nc7_x = 0.002872_rk*ww7_yz - 1.0000617816768e-05_rk*alpha7_x + &
        0.0005911788535720988_rk*(alpha7_y - ww7_zx)
    nc7_y = 0.0005911788535720988_rk*(alpha7_x + ww7_yz) - 0.002882000617816768_rk*ww7_zx
    ! link 7: moment through the joint, along the axes that its turn starts from [N m]
    n07_y = s7*nc7_x + c7*nc7_y
    n07_x = c7*nc7_x - s7*nc7_y
    t3 = ww2_xy + 24.525_rk*s2
    t4 = -2.0_rk*alpha2_x
    t5 = c3*t3 - s3*t4
    t6 = neg_lam2_22 - 24.525_rk*c2
    t7 = t5*c4 + t6*s4
    t8 = lam4_12 - t7
    t9 = s3*t3 + c3*t4
    t10 = t9 - lam4_32
    t11 = c5*t8 + s5*t10
    t12 = neg_lam4_22 + (t6*c4 - t5*s4)
    ! link 6: moment that turns the link [N m]
    nc6_z = 0.0021385000000000006_rk*(lam6_21 - 22.893746966169505_rk*lam6_12) - &
        0.00040380860809999307_rk*lam6_13 + 0.126974784_rk*(t11*c6 + t12*s6)
    t13 = s5*t8 - c5*t10
    nc6_x = 0.126974784_rk*t13 - (-0.00040380860809999307_rk*(lam5_22 + neg_lam6_22) - &
        0.0489582778871535_rk*lam6_32)
    nc6_y = 0.00040380860809999307_rk*lam6_12 - 0.0021385000000000006_rk*lam6_31
    ! link 6: moment through the joint, about the frame's origin [N m]
    n6_z = n07_y + nc6_z
    n6_x = n07_x + nc6_x
    n6_y = nc6_y - nc7_z
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    n06_y = s6*n6_x + c6*n6_y
    n06_x = c6*n6_x - s6*n6_y
    t14 = 0.0019790216329999993_rk*(lam5_21 - 11.494554054627578_rk*lam5_12) - &
        4.54293e-06_rk*(lam5_11 - lam5_22) + (2.466162e-05_rk*lam5_23 - &
        0.001232947371581177_rk*lam5_13)
    ! link 5: moment that turns the link [N m]
    nc5_z = t14 + (8.6532e-05_rk*t13 + 0.074771712_rk*t11)
    nc5_x = 0.074771712_rk*t12 - (2.466162e-05_rk*lam5_21 - 4.54293e-06_rk*lam5_31 + &
        0.001232947371581177_rk*(neg_lam4_22 + lam5_22 - 18.45007472348394_rk*lam5_32))
    nc5_y = 2.466162e-05_rk*(neg_lam4_22 + lam5_11) - 0.0019790216329999993_rk*lam5_31 + &
        0.001232947371581177_rk*(lam5_12 - 0.0036846098257819226_rk*lam5_32) - 8.6532e-05_rk*t12
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_z = nc5_z - n06_y
    n5_x = n06_x + nc5_x
    n5_y = n6_z + nc5_y
    ! link 5: moment through the joint, along the axes that its turn starts from [N m]
    n05_y = s5*n5_x + c5*n5_y
    n05_x = c5*n5_x - s5*n5_y
    ! link 4: moment that turns the link [N m]
    nc4_z = 1.21690048_rk*(t7 - 0.009497438493991343_rk*(lam4_13 + &
        0.2922356284490603_rk*(318.82012208965233_rk*lam4_12 - lam4_21)))
    nc4_x = 1.21690048_rk*(0.009497438493991343_rk*(neg_lam4_22 - neg_lam4_33 + &
        93.1705987410757_rk*lam4_32) - t9)
    nc4_y = 0.011557437462108543_rk*(lam4_12 - 0.2922356284490603_rk*lam4_31)
    t15 = -0.126974784_rk*lam6_12
    t16 = 0.126974784_rk*neg_lam6_22
    t17 = c6*t15 - s6*t16 + (-8.6532e-05_rk*lam5_11 - 0.074771712_rk*lam5_12)
    t18 = 8.6532e-05_rk*lam5_21 + 0.074771712_rk*lam5_22 + 0.126974784_rk*lam6_32
    t19 = c5*t17 + s5*t18
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_z = nc4_z - (t19 + n05_y)
    t20 = s5*t17 - c5*t18
    n4_x = nc4_x - (t20 - n05_x)
    n4_y = n5_z + nc4_y
    ! link 4: moment through the joint, along the axes that its turn starts from [N m]
    n04_y = s4*n4_x + c4*n4_y
    ! link 3: moment that turns the link [N m]
    nc3_z = 0.00131684_rk*(t5 + 10.273228415812028_rk*(lam3_13 - &
        0.2993735727362736_rk*(12.695980561828286_rk*lam3_12 - lam3_21)))
    nc3_y = 0.013528198107077912_rk*(0.2993735727362736_rk*neg_lam3_31 - lam3_12)
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_z = n04_y + nc3_z
    n3_y = nc3_y - n4_z
    ! link 2: moment that turns the link [N m]
    neg_nc2_z = 2.265037086664298_rk*(ww2_xy + 2.7210667040673794e-05_rk*(neg_lam2_22 - &
        neg_lam2_11) - 0.004524349892695083_rk*(c2 - 5775.2525774676205_rk*s2))
    nc2_y = 0.003669880873643688_rk*(neg_lam2_11 - neg_lam2_33 - 2.403513602006976_rk*neg_alpha2_y &
        - 2.3512054197641956_rk*(ww2_xy + 0.014285714285714285_rk*alpha2_x))
    t21 = s4*(s6*t15 + c6*t16 - (-8.6532e-05_rk*lam5_31 - 0.074771712_rk*lam5_32) + &
        1.21690048_rk*neg_lam4_22)
    t22 = c4*(t19 + 1.21690048_rk*lam4_12) + t21 + 0.00131684_rk*lam3_12 + n3_y
    t23 = c4*n4_x - (t20 - 1.21690048_rk*lam4_32) - s4*n4_y - 0.00131684_rk*(t6 - &
        10.273228415812028_rk*(neg_lam2_22 - neg_lam4_33 + 3.8008410601848155_rk*lam3_32) - &
        neg_lam4_33)
    ! link 2: moment through the joint, about the frame's origin [N m]
    n2_z = c3*t22 - neg_nc2_z + s3*t23
    t24 = s3*t22 - (0.003669880873643688_rk*ww2_xy - (0.0086286438_rk*(neg_lam2_22 - neg_lam2_33 - &
        526.0264402067615_rk*alpha2_x) - 0.00012326634_rk*neg_alpha2_y))
    n2_x = c3*t23 - t24
    neg_n2_y = n3_z - nc2_y
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    neg_n02_y = c2*neg_n2_y - s2*n2_x
    tau(1) = neg_n02_y
    tau(2) = n2_z
    tau(3) = n3_z
    tau(4) = n4_z
    tau(5) = n5_z
    tau(6) = n6_z
    tau(7) = nc7_z
  end subroutine

  ! mass matrix, rotor inertias on its diagonal
  ! 103 multiplications, 94 additions = 197; 2 unary minus; 12 sine/cosine
  pure subroutine iiwa7_mass_matrix(q, M) &
      bind(c, name="iiwa7_mass_matrix_f")
    real(rk), intent(in) :: q(7)
    real(rk), intent(out) :: M(49)
    real(rk) :: c2, s2, c3, s3, c4, s4, c5, s5, c6, s6, c7, s7, nu6_x, nu5_x, nu5_y, t1, t2, t3
    real(rk) :: neg_k7_xy, t4, k6_yz, m6_6, t5, t6, k6_xy, t7, t8, t9, t10, t11, t12, m4_5
    real(rk) :: neg_k6_xz, t13, t14, t15, t16, t17, k5_xy, t18, neg_k4_xz, m5_5, neg_k5_xz, t19
    real(rk) :: t20, nu4_y, t21, t22, t23, t24, m4_4, neg_k4_yz, t25, t26, t27, m3_3, t28, t29, t30
    real(rk) :: neg_nu2_y, t31, t32, t33, t34, t35, t36, t37, t38, m1_1, m2_3, t39, k2_yz, nu4_x
    real(rk) :: neg_nu6_y, t40, m4_6, t41, neg_nu3_x, m2_2, m2_4, t42, t43, m2_5, t44, t45, t46
    real(rk) :: t47, m2_6, nu3_y, t48, t49, t50, t51, t52, t53, t54

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
    c7 = cos(q(7))
    s7 = sin(q(7))
    ! link 6: moment for a unit acceleration of a joint further out
    nu6_x = 0.002872_rk*s6
    ! link 5: moment for a unit acceleration of a joint further out
    nu5_x = c5*nu6_x
    nu5_y = s5*nu6_x
    t1 = 1.0000617816768e-05_rk*c7
    t2 = c7*t1
    t3 = s7*t1
    ! link 7: second moment of the composite body [kg m^2]
    neg_k7_xy = 118.22846636152245_rk*t2 - (t3 + 0.0005911788535720988_rk)
    t4 = 0.00040380860809999307_rk*c6
    ! link 6: second moment of the composite body [kg m^2]
    k6_yz = t4 - s6*neg_k7_xy
    ! link 6: mass matrix, its row of this joint
    m6_6 = t2 + (118.22846636152245_rk*t3 + 0.05108677726933673_rk)
    t5 = m6_6 - 0.025779449502795836_rk
    t6 = c6*(t5 - 0.0692551056536944_rk)
    ! link 6: second moment of the composite body [kg m^2]
    k6_xy = s6*t6
    t7 = 0.001232947371581177_rk - k6_yz
    t8 = k6_xy - 2.466162e-05_rk
    t9 = 0.074771712_rk*c5
    t10 = 44.21127576601671_rk*nu6_x
    t11 = t10 - 8.6532e-05_rk
    t12 = t9 - s5*t11
    ! link 4: mass matrix, its row of this joint
    m4_5 = c5*t7 - (s5*t8 + t12)
    ! link 6: second moment of the composite body [kg m^2]
    neg_k6_xz = c6*neg_k7_xy + 0.0031802267771528013_rk*t10
    t13 = c5*s5
    t14 = c6*t6
    t15 = t5 + t14
    t16 = c5*c5
    t17 = neg_k6_xz + (neg_k6_xz - 9.08586e-06_rk)
    ! link 5: second moment of the composite body [kg m^2]
    k5_xy = t13*t15 - (t16 - 0.5_rk)*t17
    t18 = 0.011557437462108543_rk - m4_5
    ! link 4: second moment of the composite body [kg m^2]
    neg_k4_xz = s4*t18 + c4*k5_xy
    ! link 5: mass matrix, its row of this joint
    m5_5 = t14 - (t5 - 0.09899259842249024_rk)
    ! link 5: second moment of the composite body [kg m^2]
    neg_k5_xz = c5*t8 + s5*t7
    t19 = 0.074771712_rk*s5 + c5*t11
    t20 = neg_k5_xz - t19
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_y = c4*m5_5 + s4*t20
    t21 = 314.4429847532073_rk*t4
    t22 = t21 + 1.21690048_rk
    t23 = t21 + t22
    t24 = t14 + 0.10895114560701302_rk - t15*t16 - t13*t17
    ! link 4: mass matrix, its row of this joint
    m4_4 = t23 - t24
    ! link 4: second moment of the composite body [kg m^2]
    neg_k4_yz = s4*k5_xy - c4*t18
    t25 = t23 + (t24 - 0.12566468279153584_rk)
    t26 = 2.0_rk*nu4_y - c4*t25
    t27 = c4*t26 - (m5_5 - 0.05884601083569623_rk)
    ! link 3: mass matrix, its row of this joint
    m3_3 = t25 + t27
    t28 = s4*(t22 - t26) + (t20 - c4*t19)
    t29 = t12 - (neg_k4_yz - 0.012211358107077913_rk)
    t30 = s2*(c3*t28 - s3*t29)
    ! link 2: moment for a unit acceleration of a joint further out
    neg_nu2_y = c2*m3_3 - t30
    t31 = c4*t22 + s4*t19
    t32 = m4_4 + t31
    t33 = t31 + 2.3209570356530818_rk + t32
    t34 = s3*neg_k4_xz
    t35 = t27 + (m4_4 - 0.10959205167139245_rk)
    t36 = c3*t35 - t34
    t37 = c3*(t34 - t36)
    t38 = t33 + t37
    ! link 1: mass matrix, its row of this joint
    m1_1 = t38 - c2*(t30 + 0.00012326634_rk*s2 - (neg_nu2_y - c2*(t38 - 0.05186996398878383_rk)))
    ! link 2: mass matrix, its row of this joint
    m2_3 = s3*t28 + c3*t29
    t39 = c3*neg_k4_xz
    ! link 2: second moment of the composite body [kg m^2]
    k2_yz = c2*(m2_3 - 0.0086286438_rk) + s2*(c3*t39 - 0.003669880873643688_rk + s3*t36)
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_x = c4*t20 - s4*m5_5
    ! link 6: moment for a unit acceleration of a joint further out
    neg_nu6_y = 0.022618664190836506_rk*t21
    t40 = m6_6 + t21
    ! link 4: mass matrix, its row of this joint
    m4_6 = -c5*t40 - s5*neg_k6_xz
    t41 = c4*nu5_x - s4*neg_nu6_y
    ! link 3: moment for a unit acceleration of a joint further out
    neg_nu3_x = s3*nu5_y - c3*t41
    ! link 2: mass matrix, its row of this joint
    m2_2 = t33 - t35 - (t37 + 0.04304935539123598_rk)
    m2_4 = t34 - c3*t32
    t42 = c4*t12 - m4_5
    t43 = t19 - nu4_x
    m2_5 = c3*t42 - s3*t43
    t44 = c4*neg_nu6_y
    t45 = 591.2834490939129_rk*(t9*t44) + (s4*t10 - m4_6)
    t46 = c5*neg_k6_xz - s5*t40
    t47 = s4*k6_yz + (s5*t21 - c4*t46)
    m2_6 = c3*t45 - s3*t47
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_y = c3*nu5_y + s3*t41
    t48 = c2*neg_k4_yz - s2*(t39 + s3*t32)
    t49 = c2*nu4_y + s2*(s3*t42 + c3*t43)
    t50 = c4*k6_yz + s4*t46
    t51 = s2*(s3*t45 + c3*t47) + c2*t50
    t52 = t44 + s4*nu5_x
    t53 = c2*t52 + s2*neg_nu3_x
    t54 = -nu5_y
    M(1) = m1_1
    M(2) = k2_yz
    M(3) = neg_nu2_y
    M(4) = t48
    M(5) = t49
    M(6) = t51
    M(7) = t53
    M(8) = k2_yz
    M(9) = m2_2
    M(10) = m2_3
    M(11) = m2_4
    M(12) = m2_5
    M(13) = m2_6
    M(14) = nu3_y
    M(15) = neg_nu2_y
    M(16) = m2_3
    M(17) = m3_3
    M(18) = neg_k4_yz
    M(19) = nu4_y
    M(20) = t50
    M(21) = t52
    M(22) = t48
    M(23) = m2_4
    M(24) = neg_k4_yz
    M(25) = m4_4
    M(26) = m4_5
    M(27) = m4_6
    M(28) = t54
    M(29) = t49
    M(30) = m2_5
    M(31) = nu4_y
    M(32) = m4_5
    M(33) = m5_5
    M(34) = k6_yz
    M(35) = neg_nu6_y
    M(36) = t51
    M(37) = m2_6
    M(38) = t50
    M(39) = m4_6
    M(40) = k6_yz
    M(41) = m6_6
    M(42) = 0.0_rk
    M(43) = t53
    M(44) = nu3_y
    M(45) = t52
    M(46) = t54
    M(47) = neg_nu6_y
    M(48) = 0.0_rk
    M(49) = 0.002872_rk
  end subroutine

  ! accelerations that the torques tau give
  ! 428 multiplications, 368 additions, 6 divisions = 802; 16 unary minus; 12 sine/cosine
  pure subroutine iiwa7_forward_dynamics(q, qd, tau, qdd) &
      bind(c, name="iiwa7_forward_dynamics_f")
    real(rk), intent(in) :: q(7)
    real(rk), intent(in) :: qd(7)
    real(rk), intent(in) :: tau(7)
    real(rk), intent(out) :: qdd(7)
    real(rk) :: c2, w2_y, s2, w2_x, alpha2_x, alpha2_y, ww2_xy, ww2_xx, ww2_zz, ww2_yy, neg_lam2_22
    real(rk) :: neg_lam2_11, neg_lam2_33, s3, c3, w3_y, w3_x, w3_z, alpha3_x, alpha3_y, ww3_xy
    real(rk) :: ww3_zx, ww3_xx, ww3_zz, ww3_yz, lam3_21, lam3_12, lam3_13, lam3_32, neg_lam3_31, s4
    real(rk) :: c4, w4_y, w4_x, w4_z, alpha4_x, alpha4_y, ww4_xy, ww4_yz, ww4_xx, ww4_zz, ww4_zx
    real(rk) :: lam4_12, lam4_32, neg_lam4_22, lam4_21, lam4_13, neg_lam4_33, lam4_31, s5, c5, w5_y
    real(rk) :: w5_x, w5_z, alpha5_x, alpha5_y, ww5_xy, ww5_xx, t1, neg_ww5_zz, ww5_yy, ww5_yz
    real(rk) :: ww5_zx, lam5_21, lam5_12, lam5_22, lam5_11, lam5_23, lam5_13, lam5_32, lam5_31, c6
    real(rk) :: s6, w6_x, w6_z, w6_y, alpha6_y, alpha6_x, ww6_xy, ww6_zx, ww6_yz, ww6_xx, ww6_zz
    real(rk) :: lam6_21, lam6_12, lam6_13, lam6_32, neg_lam6_22, lam6_31, c7, s7, w7_x, w7_y, w7_z
    real(rk) :: alpha7_x, alpha7_y, ww7_xy, ww7_xx, ww7_yy, ww7_yz, ww7_zx, nc7_z, nc7_x, nc7_y
    real(rk) :: n07_y, n07_x, t2, t3, t4, t5, t6, t7, t8, t9, t10, t11, nc6_z, t12, nc6_x, nc6_y
    real(rk) :: n6_z, n6_x, n6_y, n06_y, n06_x, t13, nc5_z, nc5_x, nc5_y, n5_z, n5_x, n5_y, n05_y
    real(rk) :: n05_x, nc4_z, neg_nc4_x, nc4_y, t14, t15, t16, t17, t18, n4_z, t19, n4_x, n4_y
    real(rk) :: n04_y, nc3_z, nc3_y, n3_z, n3_y, neg_nc2_z, nc2_y, t20, t21, t22, neg_n2_z, t23
    real(rk) :: n2_x, n2_y, n02_y, nu6_x, nu5_x, nu5_y, t24, t25, t26, k7_xy, k6_yz, m6_6, t27
    real(rk) :: k6_xy, t28, t29, t30, t31, t32, t33, neg_m4_5, k6_xz, t34, t35, t36, t37, t38
    real(rk) :: k5_xy, t39, neg_k4_xz, m5_5, neg_k5_xz, t40, t41, nu4_y, t42, t43, t44, t45, m4_4
    real(rk) :: k4_yz, t46, t47, t48, m3_3, t49, t50, t51, nu2_y, t52, t53, t54, t55, t56, t57, t58
    real(rk) :: t59, m1_1, m2_3, t60, k2_yz, nu4_x, nu6_y, t61, m4_6, t62, nu3_x, m2_2, m2_4, t63
    real(rk) :: t64, m2_5, t65, t66, t67, t68, m2_6, nu3_y, ud3_6, ud1_6, ud3_7, ud1_7, y6, y7
    real(rk) :: u4_7, u3_7, u2_7, u1_7, ipivot6, u5_6, u4_6, u3_6, u2_6, u1_6, pivot5, ipivot5
    real(rk) :: ud4_5, u4_5, ud3_5, u3_5, ud2_5, u2_5, ud1_5, u1_5, pivot4, ipivot4, ud3_4, u3_4
    real(rk) :: ud2_4, u2_4, ud1_4, u1_4, pivot3, ipivot3, ud2_3, u2_3, ud1_3, u1_3, pivot2
    real(rk) :: ipivot2, ud1_2, u1_2, t69, pivot1, ipivot1, y5, y4, y3, y2, t70, y1, qdd1, qdd2
    real(rk) :: qdd3, qdd4, qdd5, qdd6, qdd7

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    ! link 2: angular velocity [rad/s]
    w2_y = -c2*qd(1)
    ! sines and cosines of the joint angles
    s2 = sin(q(2))
    ! link 2: angular velocity [rad/s]
    w2_x = -qd(1)*s2
    ! link 2: angular acceleration [rad/s^2]
    alpha2_x = w2_y*qd(2)
    alpha2_y = -w2_x*qd(2)
    ! link 2: products of the angular velocity [1/s^2]
    ww2_xy = w2_y*w2_x
    ww2_xx = w2_x*w2_x
    ww2_zz = qd(2)*qd(2)
    ww2_yy = w2_y*w2_y
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_22 = ww2_xx + ww2_zz
    neg_lam2_11 = ww2_zz + ww2_yy
    neg_lam2_33 = qd(1)*qd(1)
    ! sines and cosines of the joint angles
    s3 = sin(q(3))
    c3 = cos(q(3))
    ! link 3: angular velocity [rad/s]
    w3_y = qd(2)*c3 - w2_x*s3
    w3_x = w2_x*c3 + qd(2)*s3
    w3_z = qd(3) - w2_y
    ! link 3: angular acceleration [rad/s^2]
    alpha3_x = alpha2_x*c3 + w3_y*qd(3)
    alpha3_y = -alpha2_x*s3 - w3_x*qd(3)
    ! link 3: products of the angular velocity [1/s^2]
    ww3_xy = w3_y*w3_x
    ww3_zx = w3_x*w3_z
    ww3_xx = w3_x*w3_x
    ww3_zz = w3_z*w3_z
    ww3_yz = w3_y*w3_z
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_21 = ww3_xy - alpha2_y
    lam3_12 = alpha2_y + ww3_xy
    lam3_13 = alpha3_y + ww3_zx
    lam3_32 = alpha3_x + ww3_yz
    neg_lam3_31 = alpha3_y - ww3_zx
    ! sines and cosines of the joint angles
    s4 = sin(q(4))
    c4 = cos(q(4))
    ! link 4: angular velocity [rad/s]
    w4_y = w3_z*c4 - w3_x*s4
    w4_x = w3_x*c4 + w3_z*s4
    w4_z = qd(4) - w3_y
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = w4_y*qd(4) - (alpha2_y*s4 - alpha3_x*c4)
    alpha4_y = -(alpha2_y*c4 + alpha3_x*s4) - w4_x*qd(4)
    ! link 4: products of the angular velocity [1/s^2]
    ww4_xy = w4_y*w4_x
    ww4_yz = w4_y*w4_z
    ww4_xx = w4_x*w4_x
    ww4_zz = w4_z*w4_z
    ww4_zx = w4_x*w4_z
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_12 = alpha3_y + ww4_xy
    lam4_32 = alpha4_x + ww4_yz
    neg_lam4_22 = ww4_xx + ww4_zz
    lam4_21 = ww4_xy - alpha3_y
    lam4_13 = alpha4_y + ww4_zx
    neg_lam4_33 = ww3_xx + ww3_zz
    lam4_31 = ww4_zx - alpha4_y
    ! sines and cosines of the joint angles
    s5 = sin(q(5))
    c5 = cos(q(5))
    ! link 5: angular velocity [rad/s]
    w5_y = -w4_x*s5 - w4_z*c5
    w5_x = w4_x*c5 - w4_z*s5
    w5_z = w4_y + qd(5)
    ! link 5: angular acceleration [rad/s^2]
    alpha5_x = w5_y*qd(5) + (alpha3_y*s5 + alpha4_x*c5)
    alpha5_y = alpha3_y*c5 - alpha4_x*s5 - w5_x*qd(5)
    ! link 5: products of the angular velocity [1/s^2]
    ww5_xy = w5_y*w5_x
    ww5_xx = w5_x*w5_x
    t1 = -w5_z
    neg_ww5_zz = t1*w5_z
    ww5_yy = w5_y*w5_y
    ww5_yz = w5_y*w5_z
    ww5_zx = w5_x*w5_z
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_21 = alpha4_y + ww5_xy
    lam5_12 = ww5_xy - alpha4_y
    lam5_22 = neg_ww5_zz - ww5_xx
    lam5_11 = neg_ww5_zz - ww5_yy
    lam5_23 = ww5_yz - alpha5_x
    lam5_13 = alpha5_y + ww5_zx
    lam5_32 = alpha5_x + ww5_yz
    lam5_31 = ww5_zx - alpha5_y
    ! sines and cosines of the joint angles
    c6 = cos(q(6))
    s6 = sin(q(6))
    ! link 6: angular velocity [rad/s]
    w6_x = w5_x*c6 - w5_z*s6
    w6_z = w5_y + qd(6)
    w6_y = t1*c6 - w5_x*s6
    ! link 6: angular acceleration [rad/s^2]
    alpha6_y = -alpha5_x*s6 - alpha4_y*c6 - w6_x*qd(6)
    alpha6_x = qd(6)*w6_y + (alpha5_x*c6 - alpha4_y*s6)
    ! link 6: products of the angular velocity [1/s^2]
    ww6_xy = w6_x*w6_y
    ww6_zx = w6_x*w6_z
    ww6_yz = w6_z*w6_y
    ww6_xx = w6_x*w6_x
    ww6_zz = w6_z*w6_z
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    lam6_21 = alpha5_y + ww6_xy
    lam6_12 = ww6_xy - alpha5_y
    lam6_13 = alpha6_y + ww6_zx
    lam6_32 = alpha6_x + ww6_yz
    neg_lam6_22 = ww6_xx + ww6_zz
    lam6_31 = ww6_zx - alpha6_y
    ! sines and cosines of the joint angles
    c7 = cos(q(7))
    s7 = sin(q(7))
    ! link 7: angular velocity [rad/s]
    w7_x = w6_x*c7 + w6_z*s7
    w7_y = w6_z*c7 - w6_x*s7
    w7_z = qd(7) - w6_y
    ! link 7: angular acceleration [rad/s^2]
    alpha7_x = w7_y*qd(7) + (alpha5_y*s7 + alpha6_x*c7)
    alpha7_y = alpha5_y*c7 - alpha6_x*s7 - w7_x*qd(7)
    ! link 7: products of the angular velocity [1/s^2]
    ww7_xy = w7_x*w7_y
    ww7_xx = w7_x*w7_x
    ww7_yy = w7_y*w7_y
    ww7_yz = w7_y*w7_z
    ww7_zx = w7_x*w7_z
    ! link 7: moment that turns the link [N m]
    nc7_z = 0.0005911788535720988_rk*(ww7_xx - ww7_yy) - 0.002872_rk*(alpha6_y - &
        0.0034821092676768804_rk*ww7_xy)
    nc7_x = 0.002872_rk*ww7_yz - 1.0000617816768e-05_rk*alpha7_x + &
        0.0005911788535720988_rk*(alpha7_y - ww7_zx)
    nc7_y = 0.0005911788535720988_rk*(alpha7_x + ww7_yz) - 0.002882000617816768_rk*ww7_zx
    ! link 7: moment through the joint, along the axes that its turn starts from [N m]
    n07_y = s7*nc7_x + c7*nc7_y
    n07_x = c7*nc7_x - s7*nc7_y
    t2 = ww2_xy + 24.525_rk*s2
    t3 = -2.0_rk*alpha2_x
    t4 = c3*t2 - s3*t3
    t5 = neg_lam2_22 - 24.525_rk*c2
    t6 = c4*t4 + s4*t5
    t7 = lam4_12 - t6
    t8 = s3*t2 + c3*t3
    t9 = lam4_32 - t8
    t10 = c5*t7 - s5*t9
    t11 = neg_lam4_22 + (c4*t5 - s4*t4)
    ! link 6: moment that turns the link [N m]
    nc6_z = 0.0021385000000000006_rk*(lam6_21 - 22.893746966169505_rk*lam6_12) - &
        0.00040380860809999307_rk*lam6_13 + 0.126974784_rk*(c6*t10 + s6*t11)
    t12 = s5*t7 + c5*t9
    nc6_x = 0.126974784_rk*t12 - (-0.00040380860809999307_rk*(lam5_22 + neg_lam6_22) - &
        0.0489582778871535_rk*lam6_32)
    nc6_y = 0.00040380860809999307_rk*lam6_12 - 0.0021385000000000006_rk*lam6_31
    ! link 6: moment through the joint, about the frame's origin [N m]
    n6_z = n07_y + nc6_z
    n6_x = n07_x + nc6_x
    n6_y = nc6_y - nc7_z
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    n06_y = s6*n6_x + c6*n6_y
    n06_x = c6*n6_x - s6*n6_y
    t13 = 0.0019790216329999993_rk*(11.494554054627578_rk*lam5_12 - lam5_21) + &
        4.54293e-06_rk*(lam5_11 - lam5_22) + (0.001232947371581177_rk*lam5_13 - &
        2.466162e-05_rk*lam5_23)
    ! link 5: moment that turns the link [N m]
    nc5_z = 8.6532e-05_rk*t12 + 0.074771712_rk*t10 - t13
    nc5_x = 0.074771712_rk*t11 + (4.54293e-06_rk*lam5_31 - 2.466162e-05_rk*lam5_21 - &
        0.001232947371581177_rk*(neg_lam4_22 + lam5_22 - 18.45007472348394_rk*lam5_32))
    nc5_y = 2.466162e-05_rk*(neg_lam4_22 + lam5_11) - 0.0019790216329999993_rk*lam5_31 + &
        0.001232947371581177_rk*(lam5_12 - 0.0036846098257819226_rk*lam5_32) - 8.6532e-05_rk*t11
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_z = nc5_z - n06_y
    n5_x = n06_x + nc5_x
    n5_y = n6_z + nc5_y
    ! link 5: moment through the joint, along the axes that its turn starts from [N m]
    n05_y = s5*n5_x + c5*n5_y
    n05_x = c5*n5_x - s5*n5_y
    ! link 4: moment that turns the link [N m]
    nc4_z = 1.21690048_rk*(t6 - 0.009497438493991343_rk*(lam4_13 + &
        0.2922356284490603_rk*(318.82012208965233_rk*lam4_12 - lam4_21)))
    neg_nc4_x = 1.21690048_rk*(t8 - 0.009497438493991343_rk*(neg_lam4_22 - neg_lam4_33 + &
        93.1705987410757_rk*lam4_32))
    nc4_y = 0.011557437462108543_rk*(lam4_12 - 0.2922356284490603_rk*lam4_31)
    t14 = -0.126974784_rk*lam6_12
    t15 = 0.126974784_rk*neg_lam6_22
    t16 = c6*t14 - s6*t15 + (-8.6532e-05_rk*lam5_11 - 0.074771712_rk*lam5_12)
    t17 = -8.6532e-05_rk*lam5_21 - 0.074771712_rk*lam5_22 - 0.126974784_rk*lam6_32
    t18 = c5*t16 - s5*t17
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_z = nc4_z - (n05_y + t18)
    t19 = s5*t16 + c5*t17
    n4_x = n05_x - t19 - neg_nc4_x
    n4_y = n5_z + nc4_y
    ! link 4: moment through the joint, along the axes that its turn starts from [N m]
    n04_y = s4*n4_x + c4*n4_y
    ! link 3: moment that turns the link [N m]
    nc3_z = 0.00131684_rk*(t4 + 10.273228415812028_rk*(lam3_13 - &
        0.2993735727362736_rk*(12.695980561828286_rk*lam3_12 - lam3_21)))
    nc3_y = 0.013528198107077912_rk*(0.2993735727362736_rk*neg_lam3_31 - lam3_12)
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_z = n04_y + nc3_z
    n3_y = nc3_y - n4_z
    ! link 2: moment that turns the link [N m]
    neg_nc2_z = 2.265037086664298_rk*(ww2_xy + 2.7210667040673794e-05_rk*(neg_lam2_22 - &
        neg_lam2_11) - 0.004524349892695083_rk*(c2 - 5775.2525774676205_rk*s2))
    nc2_y = 0.003669880873643688_rk*(neg_lam2_11 - neg_lam2_33 + 2.403513602006976_rk*alpha2_y - &
        2.3512054197641956_rk*(ww2_xy + 0.014285714285714285_rk*alpha2_x))
    t20 = s4*(s6*t14 + c6*t15 - (-8.6532e-05_rk*lam5_31 - 0.074771712_rk*lam5_32) + &
        1.21690048_rk*neg_lam4_22)
    t21 = -0.00131684_rk*lam3_12 - (c4*(t18 + 1.21690048_rk*lam4_12) + t20) - n3_y
    t22 = t19 - 1.21690048_rk*lam4_32 - c4*n4_x + s4*n4_y + 0.00131684_rk*(t5 - &
        10.273228415812028_rk*(neg_lam2_22 - neg_lam4_33 + 3.8008410601848155_rk*lam3_32) - &
        neg_lam4_33)
    ! link 2: moment through the joint, about the frame's origin [N m]
    neg_n2_z = neg_nc2_z + c3*t21 + s3*t22
    t23 = s3*t21 + (0.003669880873643688_rk*ww2_xy - (0.0086286438_rk*(neg_lam2_22 - neg_lam2_33 - &
        526.0264402067615_rk*alpha2_x) + 0.00012326634_rk*alpha2_y))
    n2_x = t23 - c3*t22
    n2_y = nc2_y - n3_z
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_y = c2*n2_y + s2*n2_x
    ! link 6: moment for a unit acceleration of a joint further out
    nu6_x = 0.002872_rk*s6
    ! link 5: moment for a unit acceleration of a joint further out
    nu5_x = c5*nu6_x
    nu5_y = s5*nu6_x
    t24 = 1.0000617816768e-05_rk*c7
    t25 = s7*t24
    t26 = c7*t24
    ! link 7: second moment of the composite body [kg m^2]
    k7_xy = t25 + 0.0005911788535720988_rk - 118.22846636152245_rk*t26
    ! link 6: second moment of the composite body [kg m^2]
    k6_yz = 0.00040380860809999307_rk*c6 + s6*k7_xy
    ! link 6: mass matrix, its row of this joint
    m6_6 = t26 + (118.22846636152245_rk*t25 + 0.05108677726933673_rk)
    t27 = c6*(m6_6 - 0.09503455515649023_rk)
    ! link 6: second moment of the composite body [kg m^2]
    k6_xy = s6*t27
    t28 = k6_yz - 0.001232947371581177_rk
    t29 = k6_xy - 2.466162e-05_rk
    t30 = 0.074771712_rk*c5
    t31 = 0.126974784_rk*s6
    t32 = t31 - 8.6532e-05_rk
    t33 = t30 - s5*t32
    ! link 4: mass matrix, its row of this joint
    neg_m4_5 = c5*t28 + (s5*t29 + t33)
    ! link 6: second moment of the composite body [kg m^2]
    k6_xz = c6*k7_xy - 0.00040380860809999307_rk*s6
    t34 = s5*c5
    t35 = c6*t27
    t36 = m6_6 - 0.025779449502795836_rk + t35
    t37 = c5*c5
    t38 = -k6_xz - (k6_xz + 9.08586e-06_rk)
    ! link 5: second moment of the composite body [kg m^2]
    k5_xy = t34*t36 - (t37 - 0.5_rk)*t38
    t39 = neg_m4_5 + 0.011557437462108543_rk
    ! link 4: second moment of the composite body [kg m^2]
    neg_k4_xz = s4*t39 + c4*k5_xy
    ! link 5: mass matrix, its row of this joint
    m5_5 = t35 - (m6_6 - 0.12477204792528607_rk)
    ! link 5: second moment of the composite body [kg m^2]
    neg_k5_xz = c5*t29 - s5*t28
    t40 = 0.074771712_rk*s5 + c5*t32
    t41 = neg_k5_xz - t40
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_y = c4*m5_5 + s4*t41
    t42 = 0.126974784_rk*c6
    t43 = t42 + 1.21690048_rk
    t44 = t42 + t43
    t45 = t35 + 0.10895114560701302_rk - t36*t37 - t34*t38
    ! link 4: mass matrix, its row of this joint
    m4_4 = t44 - t45
    ! link 4: second moment of the composite body [kg m^2]
    k4_yz = c4*t39 - s4*k5_xy
    t46 = t44 + (t45 - 0.12566468279153584_rk)
    t47 = 2.0_rk*nu4_y - c4*t46
    t48 = c4*t47 - (m5_5 - 0.05884601083569623_rk)
    ! link 3: mass matrix, its row of this joint
    m3_3 = t46 + t48
    t49 = s4*(t43 - t47) + (t41 - c4*t40)
    t50 = t33 + (k4_yz + 0.012211358107077913_rk)
    t51 = s2*(c3*t49 - s3*t50)
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y = t51 - c2*m3_3
    t52 = c4*t43 + s4*t40
    t53 = m4_4 + t52
    t54 = t52 + 2.3209570356530818_rk + t53
    t55 = s3*neg_k4_xz
    t56 = t48 + (m4_4 - 0.10959205167139245_rk)
    t57 = c3*t56 - t55
    t58 = c3*(t55 - t57)
    t59 = t54 + t58
    ! link 1: mass matrix, its row of this joint
    m1_1 = t59 - c2*(t51 + 0.00012326634_rk*s2 + (nu2_y + c2*(t59 - 0.05186996398878383_rk)))
    ! link 2: mass matrix, its row of this joint
    m2_3 = s3*t49 + c3*t50
    t60 = -c3*neg_k4_xz
    ! link 2: second moment of the composite body [kg m^2]
    k2_yz = c2*(m2_3 - 0.0086286438_rk) + s2*(s3*t57 - (c3*t60 + 0.003669880873643688_rk))
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_x = c4*t41 - s4*m5_5
    ! link 6: moment for a unit acceleration of a joint further out
    nu6_y = -0.002872_rk*c6
    t61 = m6_6 + t42
    ! link 4: mass matrix, its row of this joint
    m4_6 = s5*k6_xz - c5*t61
    t62 = c4*nu5_x + s4*nu6_y
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_x = c3*t62 - s3*nu5_y
    ! link 2: mass matrix, its row of this joint
    m2_2 = t54 - t56 - (t58 + 0.04304935539123598_rk)
    m2_4 = t55 - c3*t53
    t63 = neg_m4_5 + c4*t33
    t64 = t40 - nu4_x
    m2_5 = c3*t63 - s3*t64
    t65 = c4*nu6_y
    t66 = s4*t31 - m4_6 - 591.2834490939129_rk*(t30*t65)
    t67 = -s5*t61 - c5*k6_xz
    t68 = s4*k6_yz + (s5*t42 - c4*t67)
    m2_6 = c3*t66 - s3*t68
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_y = c3*nu5_y + s3*t62
    ! factorisation M = U D U^T
    ud3_6 = c4*k6_yz + s4*t67
    ud1_6 = s2*(s3*t66 + c3*t68) + c2*ud3_6
    ud3_7 = s4*nu5_x - t65
    ud1_7 = c2*ud3_7 - s2*nu3_x
    ! link 6: forward substitution
    y6 = tau(6) - n6_z
    ! link 7: forward substitution
    y7 = tau(7) - nc7_z
    ! factorisation M = U D U^T
    u4_7 = -348.18941504178275_rk*nu5_y
    u3_7 = 348.18941504178275_rk*ud3_7
    u2_7 = 348.18941504178275_rk*nu3_y
    u1_7 = 348.18941504178275_rk*ud1_7
    ipivot6 = 1.0_rk / m6_6
    u5_6 = k6_yz*ipivot6
    u4_6 = m4_6*ipivot6
    u3_6 = ud3_6*ipivot6
    u2_6 = m2_6*ipivot6
    u1_6 = ud1_6*ipivot6
    pivot5 = m5_5 + c6*nu6_y - k6_yz*u5_6
    ipivot5 = 1.0_rk / pivot5
    ud4_5 = nu6_y*u4_7 - neg_m4_5 - k6_yz*u4_6
    u4_5 = ipivot5*ud4_5
    ud3_5 = nu4_y + nu6_y*u3_7 - k6_yz*u3_6
    u3_5 = ipivot5*ud3_5
    ud2_5 = m2_5 + nu6_y*u2_7 - k6_yz*u2_6
    u2_5 = ipivot5*ud2_5
    ud1_5 = c2*nu4_y + s2*(s3*t63 + c3*t64) + nu6_y*u1_7 - k6_yz*u1_6
    u1_5 = ipivot5*ud1_5
    pivot4 = m4_4 + nu5_y*u4_7 - m4_6*u4_6 - ud4_5*u4_5
    ipivot4 = 1.0_rk / pivot4
    ud3_4 = nu5_y*u3_7 - k4_yz - m4_6*u3_6 - ud4_5*u3_5
    u3_4 = ipivot4*ud3_4
    ud2_4 = m2_4 + nu5_y*u2_7 - m4_6*u2_6 - ud4_5*u2_5
    u2_4 = ipivot4*ud2_4
    ud1_4 = s2*(t60 - s3*t53) - c2*k4_yz + nu5_y*u1_7 - m4_6*u1_6 - ud4_5*u1_5
    u1_4 = ipivot4*ud1_4
    pivot3 = m3_3 - ud3_7*u3_7 - ud3_6*u3_6 - ud3_5*u3_5 - ud3_4*u3_4
    ipivot3 = 1.0_rk / pivot3
    ud2_3 = m2_3 - ud3_7*u2_7 - ud3_6*u2_6 - ud3_5*u2_5 - ud3_4*u2_4
    u2_3 = ipivot3*ud2_3
    ud1_3 = -ud3_6*u1_6 - (nu2_y + ud3_7*u1_7) - ud3_5*u1_5 - ud3_4*u1_4
    u1_3 = ipivot3*ud1_3
    pivot2 = m2_2 - nu3_y*u2_7 - m2_6*u2_6 - ud2_5*u2_5 - ud2_4*u2_4 - ud2_3*u2_3
    ipivot2 = 1.0_rk / pivot2
    ud1_2 = k2_yz - nu3_y*u1_7 - m2_6*u1_6 - ud2_5*u1_5 - ud2_4*u1_4 - ud2_3*u1_3
    u1_2 = ipivot2*ud1_2
    t69 = m1_1 - ud1_7*u1_7 - ud1_6*u1_6 - ud1_5*u1_5 - ud1_4*u1_4 - ud1_3*u1_3
    pivot1 = t69 - ud1_2*u1_2
    ipivot1 = 1.0_rk / pivot1
    ! link 5: forward substitution
    y5 = tau(5) - n5_z - c6*y7 - y6*u5_6
    ! link 4: forward substitution
    y4 = -y6*u4_6 - (n4_z - tau(4) + y7*u4_7) - u4_5*y5
    ! link 3: forward substitution
    y3 = tau(3) - n3_z - y7*u3_7 - y6*u3_6 - u3_5*y5 - u3_4*y4
    ! link 2: forward substitution
    y2 = neg_n2_z + tau(2) - y7*u2_7 - y6*u2_6 - u2_5*y5 - u2_4*y4 - u2_3*y3
    t70 = n02_y + tau(1) - y7*u1_7 - y6*u1_6 - u1_5*y5 - u1_4*y4 - u1_3*y3
    ! link 1: forward substitution
    y1 = t70 - u1_2*y2
    ! link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd1 = ipivot1*y1
    ! link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd2 = ipivot2*y2 - u1_2*qdd1
    ! link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd3 = ipivot3*y3 - u2_3*qdd2 - u1_3*qdd1
    ! link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd4 = -u1_4*qdd1 - (u3_4*qdd3 - ipivot4*y4 + u2_4*qdd2)
    ! link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd5 = ipivot5*y5 - u4_5*qdd4 - u3_5*qdd3 - u2_5*qdd2 - u1_5*qdd1
    ! link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd6 = -u1_6*qdd1 - (u5_6*qdd5 - y6*ipivot6 + u4_6*qdd4 + u3_6*qdd3 + u2_6*qdd2)
    ! link 7: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd7 = -u1_7*qdd1 - (c6*qdd5 - 348.18941504178275_rk*y7 + u4_7*qdd4 + u3_7*qdd3 + u2_7*qdd2)
    qdd(1) = qdd1
    qdd(2) = qdd2
    qdd(3) = qdd3
    qdd(4) = qdd4
    qdd(5) = qdd5
    qdd(6) = qdd6
    qdd(7) = qdd7
  end subroutine
end module
