! ur5: Universal Robots UR5
! Numbers: URDF of example-robot-data (ur_description, BSD), turned into modified DH
! Written by robodyn; do not edit, generate again.
!
! Joints, base to tip: 1 revolute, 2 revolute, 3 revolute, 4 revolute, 5 revolute, 6 revolute
! Gravity in the base frame: 0.0, 0.0, -9.81 m/s^2
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
!   inverse_dynamics: 153 multiplications, 113 additions = 266; 0 unary minus; 10 sine/cosine
!   gravity: 3 multiplications, 4 additions = 7; 0 unary minus; 3 sine/cosine
!   bias: 136 multiplications, 79 additions = 215; 5 unary minus; 10 sine/cosine
!   mass_matrix: 54 multiplications, 53 additions = 107; 0 unary minus; 10 sine/cosine
!   forward_dynamics: 272 multiplications, 200 additions, 6 divisions = 478; 15 unary minus; 10
!       sine/cosine
module ur5_dynamics
  use, intrinsic :: iso_c_binding, only: rk => c_double
  implicit none
  private

  public :: ur5_inverse_dynamics
  public :: ur5_gravity
  public :: ur5_bias
  public :: ur5_mass_matrix
  public :: ur5_forward_dynamics

contains

  ! torques that give the accelerations qdd
  ! 153 multiplications, 113 additions = 266; 0 unary minus; 10 sine/cosine
  pure subroutine ur5_inverse_dynamics(q, qd, qdd, tau) &
      bind(c, name="ur5_inverse_dynamics_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(in) :: qdd(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: c2, s2, c5, s5, c6, s6, angle23, c23, s23, w3_z, alpha3_z, angle2to4, c2to4, s2to4
    real(rk) :: w4_z, alpha4_z, ww1_zz, a2_z, neg_w2_x, neg_w2_y, t1, a2_y, neg_ww2_yz, neg_ww2_zx
    real(rk) :: neg_alpha2_x, alpha2_y, ww2_xy, ww2_xx, ww2_yy, ww2_zz, neg_lam2_11, lam2_12
    real(rk) :: lam2_21, lam2_23, neg_lam2_31, neg_lam2_32, neg_lam2_33, a3_z, neg_w3_x, neg_w3_y
    real(rk) :: t2, t3, t4, t5, a3_y, neg_ww3_yz, neg_ww3_zx, neg_alpha3_x, neg_alpha3_y, ww3_xy
    real(rk) :: ww3_xx, ww3_yy, ww3_zz, neg_lam3_11, lam3_12, lam3_21, lam3_23, lam3_31
    real(rk) :: neg_lam3_32, neg_lam3_33, a4_z, w4_x, w4_y, t6, t7, a4_x, ww4_yz, ww4_zx, alpha4_x
    real(rk) :: alpha4_y, ww4_xy, ww4_xx, ww4_zz, neg_lam4_12, lam4_21, neg_lam4_22, neg_lam4_31
    real(rk) :: lam4_32, neg_w5_x, w5_y, neg_alpha5_x, alpha5_y, alpha5_z, w5_z, ww5_yz, neg_ww5_zx
    real(rk) :: neg_ww5_xy, neg_w6_x, w6_y, alpha6_x, alpha6_z, w6_z, ww6_yz, neg_ww6_zx
    real(rk) :: neg_ww6_xy, nc1_z, neg_fc2_x, fc2_y, neg_nc2_x, nc2_y, nc2_z, neg_fc3_x, fc3_y
    real(rk) :: fc3_z, neg_nc3_x, nc3_y, nc3_z, fc4_x, fc4_y, neg_fc4_z, nc4_y, nc4_x, nc4_z, nc5_y
    real(rk) :: nc5_x, nc5_z, nc6_y, nc6_x, nc6_z, n06_x, n06_y, n5_x, n5_y, n5_z, n05_x, neg_n05_y
    real(rk) :: n4_x, neg_n4_y, n4_z, f04_x, f04_y, n04_y, t8, n03_y, n03_z, f03_x, f03_y
    real(rk) :: neg_f03_z, t9, n02_y, n02_z, f02_x, n1_z

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
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
    ! sines and cosines of the joint angles
    angle2to4 = q(4) + angle23
    c2to4 = cos(angle2to4)
    s2to4 = sin(angle2to4)
    ! link 4: angular velocity [rad/s]
    w4_z = qd(4) + w3_z
    ! link 4: angular acceleration [rad/s^2]
    alpha4_z = qdd(4) + alpha3_z
    ! link 1: products of the angular velocity [1/s^2]
    ww1_zz = qd(1)*qd(1)
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    a2_z = -0.10915_rk*ww1_zz
    ! link 2: angular velocity [rad/s]
    neg_w2_x = qd(1)*s2
    neg_w2_y = qd(1)*c2
    t1 = 0.10915_rk*qdd(1)
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    a2_y = s2*t1 - 9.81_rk*c2
    ! link 2: products of the angular velocity [1/s^2]
    neg_ww2_yz = qd(2)*neg_w2_y
    neg_ww2_zx = qd(2)*neg_w2_x
    ! link 2: angular acceleration [rad/s^2]
    neg_alpha2_x = qdd(1)*s2 + neg_ww2_yz
    alpha2_y = neg_ww2_zx - qdd(1)*c2
    ! link 2: products of the angular velocity [1/s^2]
    ww2_xy = neg_w2_x*neg_w2_y
    ww2_xx = neg_w2_x*neg_w2_x
    ww2_yy = neg_w2_y*neg_w2_y
    ww2_zz = qd(2)*qd(2)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_11 = ww2_yy + ww2_zz
    lam2_12 = ww2_xy - qdd(2)
    lam2_21 = qdd(2) + ww2_xy
    lam2_23 = neg_alpha2_x - neg_ww2_yz
    neg_lam2_31 = neg_ww2_zx + alpha2_y
    neg_lam2_32 = neg_ww2_yz + neg_alpha2_x
    neg_lam2_33 = ww2_xx + ww2_yy
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_z = a2_z - 0.425_rk*neg_lam2_31
    ! link 3: angular velocity [rad/s]
    neg_w3_x = qd(1)*s23
    neg_w3_y = qd(1)*c23
    t2 = 0.425_rk*neg_lam2_11
    t3 = 0.425_rk*lam2_21
    t4 = t1 + (c2*t2 + s2*t3)
    t5 = s2*t2 - c2*t3 + 9.81_rk
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_y = s23*t4 - c23*t5
    ! link 3: products of the angular velocity [1/s^2]
    neg_ww3_yz = w3_z*neg_w3_y
    neg_ww3_zx = w3_z*neg_w3_x
    ! link 3: angular acceleration [rad/s^2]
    neg_alpha3_x = qdd(1)*s23 + neg_ww3_yz
    neg_alpha3_y = qdd(1)*c23 - neg_ww3_zx
    ! link 3: products of the angular velocity [1/s^2]
    ww3_xy = neg_w3_x*neg_w3_y
    ww3_xx = neg_w3_x*neg_w3_x
    ww3_yy = neg_w3_y*neg_w3_y
    ww3_zz = w3_z*w3_z
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_11 = ww3_yy + ww3_zz
    lam3_12 = ww3_xy - alpha3_z
    lam3_21 = alpha3_z + ww3_xy
    lam3_23 = neg_alpha3_x - neg_ww3_yz
    lam3_31 = neg_alpha3_y - neg_ww3_zx
    neg_lam3_32 = neg_ww3_yz + neg_alpha3_x
    neg_lam3_33 = ww3_xx + ww3_yy
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_z = a3_z + 0.39225_rk*lam3_31
    ! link 4: angular velocity [rad/s]
    w4_x = qd(1)*s2to4
    w4_y = qd(1)*c2to4
    t6 = 0.39225_rk*neg_lam3_11
    t7 = 0.39225_rk*lam3_21
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_x = c2to4*(t4 + (c23*t6 + s23*t7)) + s2to4*(t5 + (s23*t6 - c23*t7))
    ! link 4: products of the angular velocity [1/s^2]
    ww4_yz = w4_z*w4_y
    ww4_zx = w4_z*w4_x
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = qdd(1)*s2to4 + ww4_yz
    alpha4_y = qdd(1)*c2to4 - ww4_zx
    ! link 4: products of the angular velocity [1/s^2]
    ww4_xy = w4_x*w4_y
    ww4_xx = w4_x*w4_x
    ww4_zz = w4_z*w4_z
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam4_12 = alpha4_z - ww4_xy
    lam4_21 = alpha4_z + ww4_xy
    neg_lam4_22 = ww4_xx + ww4_zz
    neg_lam4_31 = alpha4_y - ww4_zx
    lam4_32 = ww4_yz + alpha4_x
    ! link 5: angular velocity [rad/s]
    neg_w5_x = c5*w4_x + s5*w4_z
    w5_y = s5*w4_x - c5*w4_z
    ! link 5: angular acceleration [rad/s^2]
    neg_alpha5_x = c5*alpha4_x + s5*alpha4_z - qd(5)*w5_y
    alpha5_y = s5*alpha4_x - c5*alpha4_z + qd(5)*neg_w5_x
    alpha5_z = qdd(5) - alpha4_y
    ! link 5: angular velocity [rad/s]
    w5_z = qd(5) - w4_y
    ! link 5: products of the angular velocity [1/s^2]
    ww5_yz = w5_y*w5_z
    neg_ww5_zx = neg_w5_x*w5_z
    neg_ww5_xy = neg_w5_x*w5_y
    ! link 6: angular velocity [rad/s]
    neg_w6_x = c6*neg_w5_x - s6*w5_z
    w6_y = s6*neg_w5_x + c6*w5_z
    ! link 6: angular acceleration [rad/s^2]
    alpha6_x = qd(6)*w6_y - (c6*neg_alpha5_x - s6*alpha5_z)
    alpha6_z = qdd(6) - alpha5_y
    ! link 6: angular velocity [rad/s]
    w6_z = qd(6) - w5_y
    ! link 6: products of the angular velocity [1/s^2]
    ww6_yz = w6_y*w6_z
    neg_ww6_zx = neg_w6_x*w6_z
    neg_ww6_xy = neg_w6_x*w6_y
    ! link 1: moment that turns the link [N m]
    nc1_z = 0.29853861244275_rk*qdd(1)
    ! link 2: force that moves the link [N]
    neg_fc2_x = 4.4329225_rk*neg_lam2_11
    fc2_y = 4.4329225_rk*lam2_21
    ! link 2: moment that turns the link [N m]
    neg_nc2_x = 0.0075537_rk*neg_lam2_32 - 0.075354282_rk*lam2_21
    nc2_y = 1.76257323841_rk*neg_lam2_31 + 0.075354282_rk*(neg_lam2_11 - neg_lam2_33) + &
        0.483853490875_rk*ww1_zz
    nc2_z = 1.76257323841_rk*lam2_21 - 0.0075537_rk*lam2_12 - 0.075354282_rk*lam2_23 + &
        4.4329225_rk*a2_y
    ! link 3: force that moves the link [N]
    neg_fc3_x = 1.598759275_rk*neg_lam3_11
    fc3_y = 1.598759275_rk*lam3_21
    fc3_z = 1.598759275_rk*lam3_31
    ! link 3: moment that turns the link [N m]
    neg_nc3_x = 0.0020475_rk*neg_lam3_32 - 0.09736195574999999_rk*lam3_21
    nc3_y = 0.09736195574999999_rk*(neg_lam3_11 - neg_lam3_33) - 0.59360445167475_rk*lam3_31 - &
        1.598759275_rk*a3_z
    nc3_z = 0.59360445167475_rk*lam3_21 - 0.0020475_rk*lam3_12 - 0.09736195574999999_rk*lam3_23 + &
        1.598759275_rk*a3_y
    ! link 4: force that moves the link [N]
    fc4_x = 0.017784735_rk*neg_lam4_12
    fc4_y = 0.017784735_rk*neg_lam4_22
    neg_fc4_z = 0.017784735_rk*lam4_32
    ! link 4: moment that turns the link [N m]
    nc4_y = 0.10971_rk*neg_lam4_31
    nc4_x = 0.11431883622975_rk*lam4_32 - 0.017784735_rk*a4_z
    nc4_z = 0.10971_rk*lam4_21 + 0.11431883622975_rk*neg_lam4_12 + 0.017784735_rk*a4_x
    ! link 5: moment that turns the link [N m]
    nc5_y = 0.21942_rk*neg_ww5_zx
    nc5_x = 0.253242_rk*ww5_yz - 0.033822_rk*neg_alpha5_x
    nc5_z = 0.033822_rk*neg_ww5_xy + 0.253242_rk*alpha5_z
    ! link 6: moment that turns the link [N m]
    nc6_y = 0.033822_rk*neg_ww6_zx
    nc6_x = 0.0171364731454_rk*ww6_yz - 0.0166855268546_rk*alpha6_x
    nc6_z = 0.0171364731454_rk*alpha6_z - 0.0166855268546_rk*neg_ww6_xy
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    n06_x = c6*nc6_x - s6*nc6_y
    n06_y = s6*nc6_x + c6*nc6_y
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_x = nc5_x + n06_x
    n5_y = nc5_y - nc6_z
    n5_z = nc5_z + n06_y
    ! link 5: moment through the joint, along the axes that its turn starts from [N m]
    n05_x = s5*n5_y - c5*n5_x
    neg_n05_y = s5*n5_x + c5*n5_y
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = nc4_x + n05_x
    neg_n4_y = n5_z - nc4_y
    n4_z = nc4_z - neg_n05_y
    ! link 4: force through the joint, along the axes that its turn starts from [N]
    f04_x = c2to4*fc4_x - s2to4*fc4_y
    f04_y = s2to4*fc4_x + c2to4*fc4_y
    ! link 4: moment through the joint, along the axes that its turn starts from [N m]
    n04_y = s2to4*n4_x - c2to4*neg_n4_y
    t8 = 0.39225_rk*c23
    ! link 3: moment through the joint, along the axes that its turn starts from [N m]
    n03_y = n04_y + (s23*neg_nc3_x - c23*nc3_y - neg_fc4_z*t8)
    n03_z = n4_z + (nc3_z - (f04_y*t8 - f04_x*(0.39225_rk*s23)))
    ! link 3: force through the joint, along the axes that its turn starts from [N]
    f03_x = f04_x + (c23*neg_fc3_x + s23*fc3_y)
    f03_y = f04_y + (s23*neg_fc3_x - c23*fc3_y)
    neg_f03_z = neg_fc4_z - fc3_z
    t9 = 0.425_rk*c2
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_y = n03_y + (s2*neg_nc2_x - c2*nc2_y - neg_f03_z*t9)
    n02_z = n03_z + (nc2_z - (f03_y*t9 - f03_x*(0.425_rk*s2)))
    ! link 2: force through the joint, along the axes that its turn starts from [N]
    f02_x = f03_x + (c2*neg_fc2_x + s2*fc2_y)
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = n02_y + (nc1_z + 0.10915_rk*f02_x)
    tau(1) = n1_z
    tau(2) = n02_z
    tau(3) = n03_z
    tau(4) = n4_z
    tau(5) = n5_z
    tau(6) = nc6_z
  end subroutine

  ! torques that hold the arm at rest
  ! 3 multiplications, 4 additions = 7; 0 unary minus; 3 sine/cosine
  pure subroutine ur5_gravity(q, tau) &
      bind(c, name="ur5_gravity_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: c2, angle23, c23, angle2to4, s2to4, neg_nc2_z, neg_nc3_z, nc4_z, n03_z, n02_z

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    angle23 = q(2) + q(3)
    c23 = cos(angle23)
    angle2to4 = q(4) + angle23
    s2to4 = sin(angle2to4)
    ! link 2: moment that turns the link [N m]
    neg_nc2_z = 43.486969725_rk*c2
    ! link 3: moment that turns the link [N m]
    neg_nc3_z = 15.683828487749999_rk*c23
    ! link 4: moment that turns the link [N m]
    nc4_z = 0.17446825035_rk*s2to4
    ! link 3: moment through the joint, along the axes that its turn starts from [N m]
    n03_z = nc4_z - neg_nc3_z
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_z = n03_z - neg_nc2_z
    tau(1) = 0.0_rk
    tau(2) = n02_z
    tau(3) = n03_z
    tau(4) = nc4_z
    tau(5) = 0.0_rk
    tau(6) = 0.0_rk
  end subroutine

  ! torques at zero acceleration: Coriolis, centrifugal, gravity, friction
  ! 136 multiplications, 79 additions = 215; 5 unary minus; 10 sine/cosine
  pure subroutine ur5_bias(q, qd, tau) &
      bind(c, name="ur5_bias_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: c2, s2, c5, s5, c6, s6, angle23, c23, s23, w3_z, angle2to4, c2to4, s2to4, w4_z
    real(rk) :: ww1_zz, neg_a2_z, t1, w2_x, w2_y, alpha2_x, neg_alpha2_y, ww2_xy, ww2_xx, ww2_yy
    real(rk) :: ww2_zz, neg_lam2_11, neg_lam2_33, a3_z, neg_w3_x, neg_w3_y, t2, t3, t4, t5, a3_y
    real(rk) :: neg_alpha3_x, alpha3_y, ww3_xy, ww3_xx, ww3_yy, ww3_zz, neg_lam3_11, neg_lam3_33
    real(rk) :: a4_z, w4_x, w4_y, t6, t7, a4_x, alpha4_x, alpha4_y, ww4_xy, ww4_xx, ww4_zz
    real(rk) :: neg_lam4_22, w5_x, w5_y, alpha5_x, alpha5_y, w5_z, ww5_yz, ww5_zx, ww5_xy, w6_x
    real(rk) :: w6_y, alpha6_x, w6_z, ww6_yz, ww6_zx, ww6_xy, fc2_x, fc2_y, nc2_x, nc2_y, nc2_z
    real(rk) :: fc3_x, fc3_y, neg_fc3_z, nc3_x, neg_nc3_y, nc3_z, fc4_x, fc4_y, fc4_z, nc4_y, nc4_x
    real(rk) :: nc4_z, nc5_y, nc5_x, nc5_z, nc6_y, nc6_x, nc6_z, n06_x, n06_y, n5_x, n5_y, n5_z
    real(rk) :: n05_x, neg_n05_y, n4_x, n4_y, n4_z, f04_x, f04_y, n04_y, t8, n03_y, n03_z, f03_x
    real(rk) :: f03_y, f03_z, t9, n02_y, n02_z, f02_x, n1_z

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    c5 = cos(q(5))
    s5 = sin(q(5))
    c6 = cos(q(6))
    s6 = sin(q(6))
    angle23 = q(2) + q(3)
    c23 = cos(angle23)
    s23 = sin(angle23)
    ! link 3: angular velocity [rad/s]
    w3_z = qd(2) + qd(3)
    ! sines and cosines of the joint angles
    angle2to4 = q(4) + angle23
    c2to4 = cos(angle2to4)
    s2to4 = sin(angle2to4)
    ! link 4: angular velocity [rad/s]
    w4_z = qd(4) + w3_z
    ! link 1: products of the angular velocity [1/s^2]
    ww1_zz = qd(1)*qd(1)
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a2_z = 0.10915_rk*ww1_zz
    t1 = -qd(1)
    ! link 2: angular velocity [rad/s]
    w2_x = t1*s2
    w2_y = t1*c2
    ! link 2: angular acceleration [rad/s^2]
    alpha2_x = qd(2)*w2_y
    neg_alpha2_y = qd(2)*w2_x
    ! link 2: products of the angular velocity [1/s^2]
    ww2_xy = w2_x*w2_y
    ww2_xx = w2_x*w2_x
    ww2_yy = w2_y*w2_y
    ww2_zz = qd(2)*qd(2)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_11 = ww2_yy + ww2_zz
    neg_lam2_33 = ww2_xx + ww2_yy
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_z = 0.85_rk*neg_alpha2_y - neg_a2_z
    ! link 3: angular velocity [rad/s]
    neg_w3_x = qd(1)*s23
    neg_w3_y = qd(1)*c23
    t2 = 0.425_rk*neg_lam2_11
    t3 = 0.425_rk*ww2_xy
    t4 = c2*t2 + s2*t3
    t5 = s2*t2 - c2*t3 + 9.81_rk
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_y = s23*t4 - c23*t5
    ! link 3: angular acceleration [rad/s^2]
    neg_alpha3_x = w3_z*neg_w3_y
    alpha3_y = w3_z*neg_w3_x
    ! link 3: products of the angular velocity [1/s^2]
    ww3_xy = neg_w3_x*neg_w3_y
    ww3_xx = neg_w3_x*neg_w3_x
    ww3_yy = neg_w3_y*neg_w3_y
    ww3_zz = w3_z*w3_z
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_11 = ww3_yy + ww3_zz
    neg_lam3_33 = ww3_xx + ww3_yy
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_z = a3_z - 0.7845_rk*alpha3_y
    ! link 4: angular velocity [rad/s]
    w4_x = qd(1)*s2to4
    w4_y = qd(1)*c2to4
    t6 = 0.39225_rk*neg_lam3_11
    t7 = 0.39225_rk*ww3_xy
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_x = c2to4*(t4 + (c23*t6 + s23*t7)) + s2to4*(t5 + (s23*t6 - c23*t7))
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = w4_z*w4_y
    alpha4_y = -w4_z*w4_x
    ! link 4: products of the angular velocity [1/s^2]
    ww4_xy = w4_x*w4_y
    ww4_xx = w4_x*w4_x
    ww4_zz = w4_z*w4_z
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam4_22 = ww4_xx + ww4_zz
    ! link 5: angular velocity [rad/s]
    w5_x = -s5*w4_z - c5*w4_x
    w5_y = s5*w4_x - c5*w4_z
    ! link 5: angular acceleration [rad/s^2]
    alpha5_x = qd(5)*w5_y - c5*alpha4_x
    alpha5_y = s5*alpha4_x - qd(5)*w5_x
    ! link 5: angular velocity [rad/s]
    w5_z = qd(5) - w4_y
    ! link 5: products of the angular velocity [1/s^2]
    ww5_yz = w5_y*w5_z
    ww5_zx = w5_x*w5_z
    ww5_xy = w5_x*w5_y
    ! link 6: angular velocity [rad/s]
    w6_x = c6*w5_x + s6*w5_z
    w6_y = c6*w5_z - s6*w5_x
    ! link 6: angular acceleration [rad/s^2]
    alpha6_x = qd(6)*w6_y - (s6*alpha4_y - c6*alpha5_x)
    ! link 6: angular velocity [rad/s]
    w6_z = qd(6) - w5_y
    ! link 6: products of the angular velocity [1/s^2]
    ww6_yz = w6_y*w6_z
    ww6_zx = w6_x*w6_z
    ww6_xy = w6_x*w6_y
    ! link 2: force that moves the link [N]
    fc2_x = -4.4329225_rk*neg_lam2_11
    fc2_y = 4.4329225_rk*ww2_xy
    ! link 2: moment that turns the link [N m]
    nc2_x = 0.0151074_rk*alpha2_x + 0.075354282_rk*ww2_xy
    nc2_y = 0.075354282_rk*(neg_lam2_11 - neg_lam2_33) - 3.52514647682_rk*neg_alpha2_y + &
        0.483853490875_rk*ww1_zz
    nc2_z = 1.75501953841_rk*ww2_xy - 43.486969725_rk*c2
    ! link 3: force that moves the link [N]
    fc3_x = -1.598759275_rk*neg_lam3_11
    fc3_y = 1.598759275_rk*ww3_xy
    neg_fc3_z = 3.19751855_rk*alpha3_y
    ! link 3: moment that turns the link [N m]
    nc3_x = 0.09736195574999999_rk*ww3_xy - 0.004095_rk*neg_alpha3_x
    neg_nc3_y = 1.598759275_rk*a3_z - (1.1872089033495_rk*alpha3_y + &
        0.09736195574999999_rk*(neg_lam3_11 - neg_lam3_33))
    nc3_z = 0.59155695167475_rk*ww3_xy + 1.598759275_rk*a3_y
    ! link 4: force that moves the link [N]
    fc4_x = -0.017784735_rk*ww4_xy
    fc4_y = 0.017784735_rk*neg_lam4_22
    fc4_z = -0.03556947_rk*alpha4_x
    ! link 4: moment that turns the link [N m]
    nc4_y = 0.21942_rk*alpha4_y
    nc4_x = 0.2286376724595_rk*alpha4_x - 0.017784735_rk*a4_z
    nc4_z = 0.017784735_rk*a4_x - 0.00460883622975_rk*ww4_xy
    ! link 5: moment that turns the link [N m]
    nc5_y = -0.21942_rk*ww5_zx
    nc5_x = 0.253242_rk*ww5_yz + 0.033822_rk*alpha5_x
    nc5_z = -0.033822_rk*ww5_xy - 0.253242_rk*alpha4_y
    ! link 6: moment that turns the link [N m]
    nc6_y = -0.033822_rk*ww6_zx
    nc6_x = 0.0171364731454_rk*ww6_yz - 0.0166855268546_rk*alpha6_x
    nc6_z = 0.0166855268546_rk*ww6_xy - 0.0171364731454_rk*alpha5_y
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    n06_x = c6*nc6_x - s6*nc6_y
    n06_y = s6*nc6_x + c6*nc6_y
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_x = nc5_x + n06_x
    n5_y = nc5_y - nc6_z
    n5_z = nc5_z + n06_y
    ! link 5: moment through the joint, along the axes that its turn starts from [N m]
    n05_x = s5*n5_y - c5*n5_x
    neg_n05_y = s5*n5_x + c5*n5_y
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = nc4_x + n05_x
    n4_y = nc4_y - n5_z
    n4_z = nc4_z - neg_n05_y
    ! link 4: force through the joint, along the axes that its turn starts from [N]
    f04_x = c2to4*fc4_x - s2to4*fc4_y
    f04_y = s2to4*fc4_x + c2to4*fc4_y
    ! link 4: moment through the joint, along the axes that its turn starts from [N m]
    n04_y = s2to4*n4_x + c2to4*n4_y
    t8 = 0.39225_rk*c23
    ! link 3: moment through the joint, along the axes that its turn starts from [N m]
    n03_y = n04_y + (c23*neg_nc3_y - s23*nc3_x + fc4_z*t8)
    n03_z = n4_z + (nc3_z + (f04_x*(0.39225_rk*s23) - f04_y*t8))
    ! link 3: force through the joint, along the axes that its turn starts from [N]
    f03_x = f04_x + (s23*fc3_y - c23*fc3_x)
    f03_y = f04_y + (-c23*fc3_y - s23*fc3_x)
    f03_z = fc4_z - neg_fc3_z
    t9 = 0.425_rk*c2
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_y = n03_y + (-c2*nc2_y - s2*nc2_x + f03_z*t9)
    n02_z = n03_z + (nc2_z + (f03_x*(0.425_rk*s2) - f03_y*t9))
    ! link 2: force through the joint, along the axes that its turn starts from [N]
    f02_x = f03_x + (s2*fc2_y - c2*fc2_x)
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = n02_y + 0.10915_rk*f02_x
    tau(1) = n1_z
    tau(2) = n02_z
    tau(3) = n03_z
    tau(4) = n4_z
    tau(5) = n5_z
    tau(6) = nc6_z
  end subroutine

  ! mass matrix, rotor inertias on its diagonal
  ! 54 multiplications, 53 additions = 107; 0 unary minus; 10 sine/cosine
  pure subroutine ur5_mass_matrix(q, M) &
      bind(c, name="ur5_mass_matrix_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(out) :: M(36)
    real(rk) :: c2, s2, c5, s5, c6, s6, angle23, c23, s23, angle2to4, c2to4, s2to4, k6_xy, nu5_x
    real(rk) :: nu5_y, nu4_y, t1, m5_5, t2, t3, k5_yy, k5_xy, neg_k5_xz, neg_k5_yz, nu4_y_2, m4_4
    real(rk) :: h4_x, neg_h4_y, t4, k4_xx, k4_yy, k4_yz, t5, t6, m3_4, t7, t8, m2_4, m1_4, t9
    real(rk) :: k3_zz, t10, t11, m3_3, h3_x, neg_h3_y, t12, k3_xx, k3_yy, k3_yz, m2_3, m1_3, t13
    real(rk) :: k2_zz, t14, m2_2, neg_h2_y, k2_xx, k2_yz, m1_2, m1_1

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    c5 = cos(q(5))
    s5 = sin(q(5))
    c6 = cos(q(6))
    s6 = sin(q(6))
    angle23 = q(2) + q(3)
    c23 = cos(angle23)
    s23 = sin(angle23)
    angle2to4 = q(4) + angle23
    c2to4 = cos(angle2to4)
    s2to4 = sin(angle2to4)
    ! link 6: second moment of the composite body [kg m^2]
    k6_xy = 0.0166855268546_rk*(c6*s6)
    ! link 5: moment for a unit acceleration of a joint further out
    nu5_x = -0.0171364731454_rk*s5
    nu5_y = 0.0171364731454_rk*c5
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_y = s2to4*nu5_x
    t1 = 0.0166855268546_rk*(c6*c6)
    ! link 5: mass matrix, its row of this joint
    m5_5 = t1 + 0.2365564731454_rk
    t2 = t1 - 0.0166855268546_rk
    t3 = c5*c5*t2
    ! link 5: second moment of the composite body [kg m^2]
    k5_yy = t1 + 0.1099354731454_rk - t3
    k5_xy = t2*(c5*s5)
    neg_k5_xz = c5*k6_xy
    neg_k5_yz = s5*k6_xy
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_y_2 = s2to4*neg_k5_xz - c2to4*m5_5
    ! link 4: mass matrix, its row of this joint
    m4_4 = 0.25785083622975_rk - (t1 - t3)
    ! link 4: first moment of the composite body, about the frame's origin [kg m]
    h4_x = 0.017784735_rk*s2to4
    neg_h4_y = 0.017784735_rk*c2to4
    t4 = c2to4*c2to4*(t1 + t3 + 0.21481116377025_rk) - neg_k5_xz*(2.0_rk*(c2to4*s2to4))
    ! link 4: second moment of the composite body [kg m^2]
    k4_xx = t4 - (t1 - 0.02151983622975_rk)
    k4_yy = t3 + 0.236331_rk - t4
    k4_yz = s2to4*k5_xy + c2to4*neg_k5_yz
    t5 = 0.39225_rk*s23
    t6 = 0.39225_rk*c23
    ! link 3: mass matrix, its row of this joint
    m3_4 = m4_4 + (t5*neg_h4_y - t6*h4_x)
    t7 = 0.425_rk*s2
    t8 = 0.425_rk*c2
    ! link 2: mass matrix, its row of this joint
    m2_4 = m3_4 + (t7*neg_h4_y - t8*h4_x)
    ! link 1: mass matrix, its row of this joint
    m1_4 = 0.00194120382525_rk*c2to4 - k4_yz
    t9 = k5_yy - k4_yy
    ! link 3: second moment of the composite body [kg m^2]
    k3_zz = k4_yy + t9
    t10 = t6*(0.03556947_rk*s2to4) - k4_xx
    t11 = k5_yy - t9 + t5*(0.03556947_rk*c2to4)
    ! link 3: mass matrix, its row of this joint
    m3_3 = 0.5956519516747499_rk - (t10 - t11)
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    h3_x = h4_x - 1.598759275_rk*c23
    neg_h3_y = neg_h4_y + 1.598759275_rk*s23
    t12 = 0.59155695167475_rk*(c23*c23)
    ! link 3: second moment of the composite body [kg m^2]
    k3_xx = t12 + 0.0020475_rk - t10
    k3_yy = t11 - (t12 - 0.59360445167475_rk)
    k3_yz = k4_yz + 0.09736195574999999_rk*s23
    ! link 2: mass matrix, its row of this joint
    m2_3 = m3_3 + (t7*neg_h3_y - t8*h3_x)
    ! link 1: mass matrix, its row of this joint
    m1_3 = 0.10915_rk*neg_h3_y - k3_yz
    t13 = k3_zz - k3_yy
    ! link 2: second moment of the composite body [kg m^2]
    k2_zz = k3_yy + t13
    t14 = t8*(2.0_rk*h3_x) - k3_xx
    ! link 2: mass matrix, its row of this joint
    m2_2 = 1.77012693841_rk - (t14 - (k3_zz - t13 + t7*(2.0_rk*neg_h3_y)))
    ! link 2: first moment of the composite body, about the frame's origin [kg m]
    neg_h2_y = neg_h3_y + 4.4329225_rk*s2
    ! link 2: second moment of the composite body [kg m^2]
    k2_xx = 1.75501953841_rk*(c2*c2) + 0.0075537_rk - t14
    k2_yz = k3_yz + 0.075354282_rk*s2
    ! link 1: mass matrix, its row of this joint
    m1_2 = 0.10915_rk*neg_h2_y - k2_yz
    m1_1 = k2_zz + k2_xx + 0.29853861244275_rk
    M(1) = m1_1
    M(2) = m1_2
    M(3) = m1_3
    M(4) = m1_4
    M(5) = nu4_y_2
    M(6) = nu4_y
    M(7) = m1_2
    M(8) = m2_2
    M(9) = m2_3
    M(10) = m2_4
    M(11) = neg_k5_yz
    M(12) = nu5_y
    M(13) = m1_3
    M(14) = m2_3
    M(15) = m3_3
    M(16) = m3_4
    M(17) = neg_k5_yz
    M(18) = nu5_y
    M(19) = m1_4
    M(20) = m2_4
    M(21) = m3_4
    M(22) = m4_4
    M(23) = neg_k5_yz
    M(24) = nu5_y
    M(25) = nu4_y_2
    M(26) = neg_k5_yz
    M(27) = neg_k5_yz
    M(28) = neg_k5_yz
    M(29) = m5_5
    M(30) = 0.0_rk
    M(31) = nu4_y
    M(32) = nu5_y
    M(33) = nu5_y
    M(34) = nu5_y
    M(35) = 0.0_rk
    M(36) = 0.0171364731454_rk
  end subroutine

  ! accelerations that the torques tau give
  ! 272 multiplications, 200 additions, 6 divisions = 478; 15 unary minus; 10 sine/cosine
  pure subroutine ur5_forward_dynamics(q, qd, tau, qdd) &
      bind(c, name="ur5_forward_dynamics_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(in) :: tau(6)
    real(rk), intent(out) :: qdd(6)
    real(rk) :: c2, s2, c5, s5, c6, s6, angle23, c23, s23, angle2to4, c2to4, s2to4, k6_xy, nu5_x
    real(rk) :: nu5_y, nu4_y, t1, m5_5, t2, t3, k5_yy, k5_xy, k5_xz, neg_k5_yz, nu4_y_2, m4_4, h4_x
    real(rk) :: h4_y, t4, k4_xx, k4_yy, k4_yz, t5, t6, m3_4, t7, t8, m2_4, m1_4, t9, k3_zz, t10
    real(rk) :: t11, m3_3, h3_x, h3_y, t12, k3_xx, k3_yy, k3_yz, m2_3, m1_3, t13, k2_zz, t14, m2_2
    real(rk) :: neg_h2_y, k2_xx, k2_yz, m1_2, m1_1, w3_z, w4_z, ww1_zz, neg_a2_z, t15, w2_x, w2_y
    real(rk) :: alpha2_x, neg_alpha2_y, ww2_xy, ww2_xx, ww2_yy, ww2_zz, neg_lam2_11, neg_lam2_33
    real(rk) :: a3_z, neg_w3_x, neg_w3_y, t16, t17, t18, t19, a3_y, neg_alpha3_x, alpha3_y, ww3_xy
    real(rk) :: ww3_xx, ww3_yy, ww3_zz, neg_lam3_11, neg_lam3_33, a4_z, w4_x, w4_y, t20, t21, a4_x
    real(rk) :: alpha4_x, alpha4_y, ww4_xy, ww4_xx, ww4_zz, neg_lam4_22, w5_x, w5_y, alpha5_x
    real(rk) :: alpha5_y, w5_z, ww5_yz, ww5_zx, ww5_xy, w6_x, w6_y, alpha6_x, w6_z, ww6_yz, ww6_zx
    real(rk) :: ww6_xy, fc2_x, fc2_y, nc2_x, nc2_y, nc2_z, fc3_x, fc3_y, neg_fc3_z, nc3_x
    real(rk) :: neg_nc3_y, nc3_z, fc4_x, fc4_y, fc4_z, nc4_y, nc4_x, nc4_z, nc5_y, nc5_x, nc5_z
    real(rk) :: nc6_y, nc6_x, nc6_z, n06_x, n06_y, n5_x, n5_y, n5_z, n05_x, neg_n05_y, n4_x, n4_y
    real(rk) :: n4_z, f04_x, f04_y, n04_y, n03_y, n03_z, f03_x, f03_y, f03_z, n02_y, n02_z, f02_x
    real(rk) :: n1_z, y1, ipivot1, l2_1, l3_1, l4_1, l5_1, l6_1, pivot2, ipivot2, ld3_2, l3_2
    real(rk) :: ld4_2, l4_2, ld5_2, l5_2, ld6_2, l6_2, pivot3, ipivot3, ld4_3, l4_3, ld5_3, l5_3
    real(rk) :: ld6_3, l6_3, pivot4, ipivot4, ld5_4, l5_4, ld6_4, l6_4, pivot5, ipivot5, ld6_5
    real(rk) :: l6_5, pivot6, ipivot6, y2, y3, y4, y5, y6, qdd6, qdd5, qdd4, qdd3, qdd2, qdd1

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    c5 = cos(q(5))
    s5 = sin(q(5))
    c6 = cos(q(6))
    s6 = sin(q(6))
    angle23 = q(2) + q(3)
    c23 = cos(angle23)
    s23 = sin(angle23)
    angle2to4 = q(4) + angle23
    c2to4 = cos(angle2to4)
    s2to4 = sin(angle2to4)
    ! link 6: second moment of the composite body [kg m^2]
    k6_xy = 0.0166855268546_rk*(c6*s6)
    ! link 5: moment for a unit acceleration of a joint further out
    nu5_x = -0.0171364731454_rk*s5
    nu5_y = 0.0171364731454_rk*c5
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_y = s2to4*nu5_x
    t1 = 0.0166855268546_rk*(c6*c6)
    ! link 5: mass matrix, its row of this joint
    m5_5 = t1 + 0.2365564731454_rk
    t2 = t1 - 0.0166855268546_rk
    t3 = c5*c5*t2
    ! link 5: second moment of the composite body [kg m^2]
    k5_yy = t1 + 0.1099354731454_rk - t3
    k5_xy = t2*(c5*s5)
    k5_xz = -c5*k6_xy
    neg_k5_yz = s5*k6_xy
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_y_2 = -c2to4*m5_5 - s2to4*k5_xz
    ! link 4: mass matrix, its row of this joint
    m4_4 = 0.25785083622975_rk - (t1 - t3)
    ! link 4: first moment of the composite body, about the frame's origin [kg m]
    h4_x = 0.017784735_rk*s2to4
    h4_y = -0.017784735_rk*c2to4
    t4 = c2to4*c2to4*(t1 + t3 + 0.21481116377025_rk) + k5_xz*(2.0_rk*(c2to4*s2to4))
    ! link 4: second moment of the composite body [kg m^2]
    k4_xx = t4 - (t1 - 0.02151983622975_rk)
    k4_yy = t3 + 0.236331_rk - t4
    k4_yz = s2to4*k5_xy + c2to4*neg_k5_yz
    t5 = 0.39225_rk*c23
    t6 = 0.39225_rk*s23
    ! link 3: mass matrix, its row of this joint
    m3_4 = m4_4 - (t5*h4_x + t6*h4_y)
    t7 = 0.425_rk*c2
    t8 = 0.425_rk*s2
    ! link 2: mass matrix, its row of this joint
    m2_4 = m3_4 - (t7*h4_x + t8*h4_y)
    ! link 1: mass matrix, its row of this joint
    m1_4 = 0.00194120382525_rk*c2to4 - k4_yz
    t9 = k5_yy - k4_yy
    ! link 3: second moment of the composite body [kg m^2]
    k3_zz = k4_yy + t9
    t10 = t5*(0.03556947_rk*s2to4) - k4_xx
    t11 = k5_yy - t9 + t6*(0.03556947_rk*c2to4)
    ! link 3: mass matrix, its row of this joint
    m3_3 = 0.5956519516747499_rk - (t10 - t11)
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    h3_x = h4_x - 1.598759275_rk*c23
    h3_y = h4_y - 1.598759275_rk*s23
    t12 = 0.59155695167475_rk*(c23*c23)
    ! link 3: second moment of the composite body [kg m^2]
    k3_xx = t12 + 0.0020475_rk - t10
    k3_yy = t11 - (t12 - 0.59360445167475_rk)
    k3_yz = k4_yz + 0.09736195574999999_rk*s23
    ! link 2: mass matrix, its row of this joint
    m2_3 = m3_3 - (t7*h3_x + t8*h3_y)
    ! link 1: mass matrix, its row of this joint
    m1_3 = -0.10915_rk*h3_y - k3_yz
    t13 = k3_zz - k3_yy
    ! link 2: second moment of the composite body [kg m^2]
    k2_zz = k3_yy + t13
    t14 = t7*(2.0_rk*h3_x) - k3_xx
    ! link 2: mass matrix, its row of this joint
    m2_2 = 1.77012693841_rk - (t14 - (k3_zz - t13 + t8*(-2.0_rk*h3_y)))
    ! link 2: first moment of the composite body, about the frame's origin [kg m]
    neg_h2_y = 4.4329225_rk*s2 - h3_y
    ! link 2: second moment of the composite body [kg m^2]
    k2_xx = 1.75501953841_rk*(c2*c2) + 0.0075537_rk - t14
    k2_yz = k3_yz + 0.075354282_rk*s2
    ! link 1: mass matrix, its row of this joint
    m1_2 = 0.10915_rk*neg_h2_y - k2_yz
    m1_1 = k2_zz + k2_xx + 0.29853861244275_rk
    ! link 3: angular velocity [rad/s]
    w3_z = qd(2) + qd(3)
    ! link 4: angular velocity [rad/s]
    w4_z = qd(4) + w3_z
    ! link 1: products of the angular velocity [1/s^2]
    ww1_zz = qd(1)*qd(1)
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a2_z = 0.10915_rk*ww1_zz
    t15 = -qd(1)
    ! link 2: angular velocity [rad/s]
    w2_x = t15*s2
    w2_y = t15*c2
    ! link 2: angular acceleration [rad/s^2]
    alpha2_x = qd(2)*w2_y
    neg_alpha2_y = qd(2)*w2_x
    ! link 2: products of the angular velocity [1/s^2]
    ww2_xy = w2_x*w2_y
    ww2_xx = w2_x*w2_x
    ww2_yy = w2_y*w2_y
    ww2_zz = qd(2)*qd(2)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_11 = ww2_yy + ww2_zz
    neg_lam2_33 = ww2_xx + ww2_yy
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_z = 0.85_rk*neg_alpha2_y - neg_a2_z
    ! link 3: angular velocity [rad/s]
    neg_w3_x = qd(1)*s23
    neg_w3_y = qd(1)*c23
    t16 = 0.425_rk*neg_lam2_11
    t17 = 0.425_rk*ww2_xy
    t18 = c2*t16 + s2*t17
    t19 = s2*t16 - c2*t17 + 9.81_rk
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_y = s23*t18 - c23*t19
    ! link 3: angular acceleration [rad/s^2]
    neg_alpha3_x = w3_z*neg_w3_y
    alpha3_y = w3_z*neg_w3_x
    ! link 3: products of the angular velocity [1/s^2]
    ww3_xy = neg_w3_x*neg_w3_y
    ww3_xx = neg_w3_x*neg_w3_x
    ww3_yy = neg_w3_y*neg_w3_y
    ww3_zz = w3_z*w3_z
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_11 = ww3_yy + ww3_zz
    neg_lam3_33 = ww3_xx + ww3_yy
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_z = a3_z - 0.7845_rk*alpha3_y
    ! link 4: angular velocity [rad/s]
    w4_x = qd(1)*s2to4
    w4_y = qd(1)*c2to4
    t20 = 0.39225_rk*neg_lam3_11
    t21 = 0.39225_rk*ww3_xy
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_x = c2to4*(t18 + (c23*t20 + s23*t21)) + s2to4*(t19 + (s23*t20 - c23*t21))
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = w4_z*w4_y
    alpha4_y = -w4_z*w4_x
    ! link 4: products of the angular velocity [1/s^2]
    ww4_xy = w4_x*w4_y
    ww4_xx = w4_x*w4_x
    ww4_zz = w4_z*w4_z
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam4_22 = ww4_xx + ww4_zz
    ! link 5: angular velocity [rad/s]
    w5_x = -s5*w4_z - c5*w4_x
    w5_y = s5*w4_x - c5*w4_z
    ! link 5: angular acceleration [rad/s^2]
    alpha5_x = qd(5)*w5_y - c5*alpha4_x
    alpha5_y = s5*alpha4_x - qd(5)*w5_x
    ! link 5: angular velocity [rad/s]
    w5_z = qd(5) - w4_y
    ! link 5: products of the angular velocity [1/s^2]
    ww5_yz = w5_y*w5_z
    ww5_zx = w5_x*w5_z
    ww5_xy = w5_x*w5_y
    ! link 6: angular velocity [rad/s]
    w6_x = c6*w5_x + s6*w5_z
    w6_y = c6*w5_z - s6*w5_x
    ! link 6: angular acceleration [rad/s^2]
    alpha6_x = qd(6)*w6_y - (s6*alpha4_y - c6*alpha5_x)
    ! link 6: angular velocity [rad/s]
    w6_z = qd(6) - w5_y
    ! link 6: products of the angular velocity [1/s^2]
    ww6_yz = w6_y*w6_z
    ww6_zx = w6_x*w6_z
    ww6_xy = w6_x*w6_y
    ! link 2: force that moves the link [N]
    fc2_x = -4.4329225_rk*neg_lam2_11
    fc2_y = 4.4329225_rk*ww2_xy
    ! link 2: moment that turns the link [N m]
    nc2_x = 0.0151074_rk*alpha2_x + 0.075354282_rk*ww2_xy
    nc2_y = 0.075354282_rk*(neg_lam2_11 - neg_lam2_33) - 3.52514647682_rk*neg_alpha2_y + &
        0.483853490875_rk*ww1_zz
    nc2_z = 1.75501953841_rk*ww2_xy - 43.486969725_rk*c2
    ! link 3: force that moves the link [N]
    fc3_x = -1.598759275_rk*neg_lam3_11
    fc3_y = 1.598759275_rk*ww3_xy
    neg_fc3_z = 3.19751855_rk*alpha3_y
    ! link 3: moment that turns the link [N m]
    nc3_x = 0.09736195574999999_rk*ww3_xy - 0.004095_rk*neg_alpha3_x
    neg_nc3_y = 1.598759275_rk*a3_z - (1.1872089033495_rk*alpha3_y + &
        0.09736195574999999_rk*(neg_lam3_11 - neg_lam3_33))
    nc3_z = 0.59155695167475_rk*ww3_xy + 1.598759275_rk*a3_y
    ! link 4: force that moves the link [N]
    fc4_x = -0.017784735_rk*ww4_xy
    fc4_y = 0.017784735_rk*neg_lam4_22
    fc4_z = -0.03556947_rk*alpha4_x
    ! link 4: moment that turns the link [N m]
    nc4_y = 0.21942_rk*alpha4_y
    nc4_x = 0.2286376724595_rk*alpha4_x - 0.017784735_rk*a4_z
    nc4_z = 0.017784735_rk*a4_x - 0.00460883622975_rk*ww4_xy
    ! link 5: moment that turns the link [N m]
    nc5_y = -0.21942_rk*ww5_zx
    nc5_x = 0.253242_rk*ww5_yz + 0.033822_rk*alpha5_x
    nc5_z = -0.033822_rk*ww5_xy - 0.253242_rk*alpha4_y
    ! link 6: moment that turns the link [N m]
    nc6_y = -0.033822_rk*ww6_zx
    nc6_x = 0.0171364731454_rk*ww6_yz - 0.0166855268546_rk*alpha6_x
    nc6_z = 0.0166855268546_rk*ww6_xy - 0.0171364731454_rk*alpha5_y
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    n06_x = c6*nc6_x - s6*nc6_y
    n06_y = s6*nc6_x + c6*nc6_y
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_x = nc5_x + n06_x
    n5_y = nc5_y - nc6_z
    n5_z = nc5_z + n06_y
    ! link 5: moment through the joint, along the axes that its turn starts from [N m]
    n05_x = s5*n5_y - c5*n5_x
    neg_n05_y = s5*n5_x + c5*n5_y
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = nc4_x + n05_x
    n4_y = nc4_y - n5_z
    n4_z = nc4_z - neg_n05_y
    ! link 4: force through the joint, along the axes that its turn starts from [N]
    f04_x = c2to4*fc4_x - s2to4*fc4_y
    f04_y = s2to4*fc4_x + c2to4*fc4_y
    ! link 4: moment through the joint, along the axes that its turn starts from [N m]
    n04_y = s2to4*n4_x + c2to4*n4_y
    ! link 3: moment through the joint, along the axes that its turn starts from [N m]
    n03_y = n04_y + (c23*neg_nc3_y - s23*nc3_x + t5*fc4_z)
    n03_z = n4_z + (nc3_z + (t6*f04_x - t5*f04_y))
    ! link 3: force through the joint, along the axes that its turn starts from [N]
    f03_x = f04_x + (s23*fc3_y - c23*fc3_x)
    f03_y = f04_y + (-c23*fc3_y - s23*fc3_x)
    f03_z = fc4_z - neg_fc3_z
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_y = n03_y + (-c2*nc2_y - s2*nc2_x + t7*f03_z)
    n02_z = n03_z + (nc2_z + (t8*f03_x - t7*f03_y))
    ! link 2: force through the joint, along the axes that its turn starts from [N]
    f02_x = f03_x + (s2*fc2_y - c2*fc2_x)
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = n02_y + 0.10915_rk*f02_x
    ! link 1: forward substitution
    y1 = tau(1) - n1_z
    ! factorisation M = L D L^T
    ipivot1 = 1.0_rk / m1_1
    l2_1 = m1_2*ipivot1
    l3_1 = m1_3*ipivot1
    l4_1 = m1_4*ipivot1
    l5_1 = nu4_y_2*ipivot1
    l6_1 = nu4_y*ipivot1
    pivot2 = m2_2 - m1_2*l2_1
    ipivot2 = 1.0_rk / pivot2
    ld3_2 = m2_3 - m1_2*l3_1
    l3_2 = ipivot2*ld3_2
    ld4_2 = m2_4 - m1_2*l4_1
    l4_2 = ipivot2*ld4_2
    ld5_2 = neg_k5_yz - m1_2*l5_1
    l5_2 = ipivot2*ld5_2
    ld6_2 = nu5_y - m1_2*l6_1
    l6_2 = ipivot2*ld6_2
    pivot3 = m3_3 - m1_3*l3_1 - ld3_2*l3_2
    ipivot3 = 1.0_rk / pivot3
    ld4_3 = m3_4 - m1_3*l4_1 - ld3_2*l4_2
    l4_3 = ipivot3*ld4_3
    ld5_3 = -ld3_2*l5_2 - (m1_3*l5_1 - neg_k5_yz)
    l5_3 = ipivot3*ld5_3
    ld6_3 = nu5_y - m1_3*l6_1 - ld3_2*l6_2
    l6_3 = ipivot3*ld6_3
    pivot4 = -(m1_4*l4_1 - m4_4 + ld4_2*l4_2) - ld4_3*l4_3
    ipivot4 = 1.0_rk / pivot4
    ld5_4 = -ld4_2*l5_2 - (m1_4*l5_1 - neg_k5_yz) - ld4_3*l5_3
    l5_4 = ipivot4*ld5_4
    ld6_4 = nu5_y - m1_4*l6_1 - ld4_2*l6_2 - ld4_3*l6_3
    l6_4 = ipivot4*ld6_4
    pivot5 = m5_5 - nu4_y_2*l5_1 - ld5_2*l5_2 - ld5_3*l5_3 - ld5_4*l5_4
    ipivot5 = 1.0_rk / pivot5
    ld6_5 = -ld5_2*l6_2 - nu4_y_2*l6_1 - ld5_3*l6_3 - ld5_4*l6_4
    l6_5 = ipivot5*ld6_5
    pivot6 = -ld6_5*l6_5 - (nu4_y*l6_1 - 0.0171364731454_rk + ld6_2*l6_2 + ld6_3*l6_3 + &
        ld6_4*l6_4)
    ipivot6 = 1.0_rk / pivot6
    ! link 2: forward substitution
    y2 = tau(2) - n02_z - y1*l2_1
    ! link 3: forward substitution
    y3 = tau(3) - n03_z - y1*l3_1 - l3_2*y2
    ! link 4: forward substitution
    y4 = tau(4) - n4_z - y1*l4_1 - l4_2*y2 - l4_3*y3
    ! link 5: forward substitution
    y5 = tau(5) - n5_z - y1*l5_1 - l5_2*y2 - l5_3*y3 - l5_4*y4
    ! link 6: forward substitution
    y6 = tau(6) - nc6_z - y1*l6_1 - l6_2*y2 - l6_3*y3 - l6_4*y4 - l6_5*y5
    ! link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd6 = ipivot6*y6
    ! link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd5 = ipivot5*y5 - l6_5*qdd6
    ! link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd4 = -l6_4*qdd6 - (l5_4*qdd5 - ipivot4*y4)
    ! link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd3 = -l6_3*qdd6 - (l4_3*qdd4 - ipivot3*y3 + l5_3*qdd5)
    ! link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd2 = -l6_2*qdd6 - (l3_2*qdd3 - ipivot2*y2 + l4_2*qdd4 + l5_2*qdd5)
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
