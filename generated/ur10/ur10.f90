! ur10: Universal Robots UR10
! Numbers: URDF of example-robot-data (ur_description, BSD), turned into modified DH; last link
!   carries the fixed tool
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
!   inverse_dynamics: 169 multiplications, 132 additions = 301; 7 unary minus; 10 sine/cosine
!   gravity: 11 multiplications, 5 additions = 16; 1 unary minus; 6 sine/cosine
!   bias: 155 multiplications, 105 additions = 260; 6 unary minus; 10 sine/cosine
!   mass_matrix: 93 multiplications, 84 additions = 177; 2 unary minus; 10 sine/cosine
!   forward_dynamics: 334 multiplications, 259 additions, 6 divisions = 599; 12 unary minus; 10
!       sine/cosine
module ur10_dynamics
  use, intrinsic :: iso_c_binding, only: rk => c_double
  implicit none
  private

  public :: ur10_inverse_dynamics
  public :: ur10_gravity
  public :: ur10_bias
  public :: ur10_mass_matrix
  public :: ur10_forward_dynamics

contains

  ! torques that give the accelerations qdd
  ! 169 multiplications, 132 additions = 301; 7 unary minus; 10 sine/cosine
  pure subroutine ur10_inverse_dynamics(q, qd, qdd, tau) &
      bind(c, name="ur10_inverse_dynamics_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(in) :: qdd(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: c2, s2, c3, s3, c4, s4, c5, s5
    real(rk) :: c6, s6, ww1_zz, t1, w2_x, w2_y, ww2_yz, ww2_zx
    real(rk) :: alpha2_x, alpha2_y, ww2_xy, ww2_xx, neg_ww2_yy, ww2_zz, lam2_11, lam2_12
    real(rk) :: lam2_13, lam2_21, lam2_23, lam2_31, lam2_32, lam2_33, a2_z, t2
    real(rk) :: neg_a2_x, a2_y, w3_x, w3_y, alpha3_x, alpha3_y, alpha3_z, w3_z
    real(rk) :: ww3_yz, ww3_zx, ww3_xy, ww3_xx, ww3_yy, ww3_zz, neg_lam3_11, lam3_12
    real(rk) :: lam3_13, lam3_21, lam3_23, lam3_31, lam3_32, neg_lam3_33, a3_z, t3
    real(rk) :: t4, a3_x, a3_y, t5, w4_x, w4_y, alpha4_x, neg_alpha4_y
    real(rk) :: alpha4_z, w4_z, ww4_yz, ww4_zx, ww4_xy, ww4_xx, ww4_zz, lam4_12
    real(rk) :: lam4_21, neg_lam4_22, lam4_31, lam4_32, a4_z, a4_x, w5_x, w5_y
    real(rk) :: neg_alpha5_x, alpha5_y, alpha5_z, w5_z, ww5_yz, ww5_zx, ww5_xy, w6_x
    real(rk) :: w6_y, alpha6_x, alpha6_z, w6_z, ww6_yz, ww6_zx, ww6_xy, nc1_z
    real(rk) :: fc2_x, fc2_y, nc2_x, nc2_y, nc2_z, fc3_x, fc3_y, fc3_z
    real(rk) :: nc3_x, nc3_y, nc3_z, fc4_x, fc4_y, fc4_z, nc4_y, nc4_x
    real(rk) :: nc4_z, nc5_y, nc5_x, nc5_z, nc6_y, nc6_x, nc6_z, n5_x
    real(rk) :: n5_y, n5_z, n4_x, n4_y, n4_z, t6, neg_n3_x, t7
    real(rk) :: n3_y, n3_z, f3_x, f3_y, f3_z, t8, neg_n2_x, t9
    real(rk) :: n2_y, n2_z, f2_x, f2_y, n1_z

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
    ! link 1: products of the angular velocity [1/s^2]
    ww1_zz = qd(1)*qd(1)
    t1 = -qd(1)
    ! link 2: angular velocity [rad/s]
    w2_x = t1*s2
    w2_y = t1*c2
    ! link 2: products of the angular velocity [1/s^2]
    ww2_yz = qd(2)*w2_y
    ww2_zx = qd(2)*w2_x
    ! link 2: angular acceleration [rad/s^2]
    alpha2_x = ww2_yz - qdd(1)*s2
    alpha2_y = -(qdd(1)*c2) - ww2_zx
    ! link 2: products of the angular velocity [1/s^2]
    ww2_xy = w2_x*w2_y
    ww2_xx = w2_x*w2_x
    neg_ww2_yy = -w2_y*w2_y
    ww2_zz = qd(2)*qd(2)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    lam2_11 = neg_ww2_yy - ww2_zz
    lam2_12 = ww2_xy - qdd(2)
    lam2_13 = ww2_zx + alpha2_y
    lam2_21 = qdd(2) + ww2_xy
    lam2_23 = ww2_yz - alpha2_x
    lam2_31 = ww2_zx - alpha2_y
    lam2_32 = ww2_yz + alpha2_x
    lam2_33 = neg_ww2_yy - ww2_xx
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    a2_z = -0.220941_rk*ww1_zz
    t2 = 0.220941_rk*qdd(1)
    neg_a2_x = c2*t2 + 9.81_rk*s2
    a2_y = s2*t2 - 9.81_rk*c2
    ! link 3: angular velocity [rad/s]
    w3_x = c3*w2_x + s3*w2_y
    w3_y = c3*w2_y - s3*w2_x
    ! link 3: angular acceleration [rad/s^2]
    alpha3_x = qd(3)*w3_y - (-c3*alpha2_x - s3*alpha2_y)
    alpha3_y = c3*alpha2_y - s3*alpha2_x - qd(3)*w3_x
    alpha3_z = qdd(2) + qdd(3)
    ! link 3: angular velocity [rad/s]
    w3_z = qd(2) + qd(3)
    ! link 3: products of the angular velocity [1/s^2]
    ww3_yz = w3_y*w3_z
    ww3_zx = w3_x*w3_z
    ww3_xy = w3_x*w3_y
    ww3_xx = w3_x*w3_x
    ww3_yy = w3_y*w3_y
    ww3_zz = w3_z*w3_z
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_11 = ww3_yy + ww3_zz
    lam3_12 = ww3_xy - alpha3_z
    lam3_13 = alpha3_y + ww3_zx
    lam3_21 = alpha3_z + ww3_xy
    lam3_23 = ww3_yz - alpha3_x
    lam3_31 = ww3_zx - alpha3_y
    lam3_32 = alpha3_x + ww3_yz
    neg_lam3_33 = ww3_xx + ww3_yy
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_z = a2_z - (0.1719_rk*lam2_33 - 0.612_rk*lam2_31)
    t3 = a2_y + (0.612_rk*lam2_21 - 0.1719_rk*lam2_23)
    t4 = neg_a2_x + (0.1719_rk*lam2_13 - 0.612_rk*lam2_11)
    a3_x = s3*t3 - c3*t4
    a3_y = s3*t4 + c3*t3
    t5 = -c4
    ! link 4: angular velocity [rad/s]
    w4_x = t5*w3_x - s4*w3_y
    w4_y = s4*w3_x - c4*w3_y
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = t5*alpha3_x - s4*alpha3_y + qd(4)*w4_y
    neg_alpha4_y = c4*alpha3_y - s4*alpha3_x + qd(4)*w4_x
    alpha4_z = qdd(4) + alpha3_z
    ! link 4: angular velocity [rad/s]
    w4_z = qd(4) + w3_z
    ! link 4: products of the angular velocity [1/s^2]
    ww4_yz = w4_y*w4_z
    ww4_zx = w4_x*w4_z
    ww4_xy = w4_x*w4_y
    ww4_xx = w4_x*w4_x
    ww4_zz = w4_z*w4_z
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_12 = ww4_xy - alpha4_z
    lam4_21 = alpha4_z + ww4_xy
    neg_lam4_22 = ww4_xx + ww4_zz
    lam4_31 = neg_alpha4_y + ww4_zx
    lam4_32 = alpha4_x + ww4_yz
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_z = a3_z - (0.1149_rk*neg_lam3_33 - 0.5723_rk*lam3_31)
    a4_x = c4*(0.5723_rk*neg_lam3_11 - 0.1149_rk*lam3_13 - a3_x) - s4*(a3_y + (0.5723_rk*lam3_21 + &
        0.1149_rk*lam3_23))
    ! link 5: angular velocity [rad/s]
    w5_x = -(c5*w4_x) - s5*w4_z
    w5_y = s5*w4_x - c5*w4_z
    ! link 5: angular acceleration [rad/s^2]
    neg_alpha5_x = c5*alpha4_x + s5*alpha4_z - qd(5)*w5_y
    alpha5_y = s5*alpha4_x - c5*alpha4_z - qd(5)*w5_x
    alpha5_z = qdd(5) + neg_alpha4_y
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
    alpha6_x = qd(6)*w6_y - (c6*neg_alpha5_x - s6*alpha5_z)
    alpha6_z = qdd(6) - alpha5_y
    ! link 6: angular velocity [rad/s]
    w6_z = qd(6) - w5_y
    ! link 6: products of the angular velocity [1/s^2]
    ww6_yz = w6_y*w6_z
    ww6_zx = w6_x*w6_z
    ww6_xy = w6_x*w6_y
    ! link 1: moment that turns the link [N m]
    nc1_z = 0.751562446711482_rk*qdd(1)
    ! link 2: force that moves the link [N]
    fc2_x = 8.847684_rk*lam2_11
    fc2_y = 8.847684_rk*lam2_21
    ! link 2: moment that turns the link [N m]
    nc2_x = 0.0181828125_rk*lam2_32 + 0.688751532_rk*lam2_21
    nc2_y = 0.688751532_rk*(lam2_33 - lam2_11) - 4.607640119298_rk*lam2_31 + &
        1.954816150644_rk*ww1_zz
    nc2_z = 4.607640119298_rk*lam2_21 - 0.0181828125_rk*lam2_12 - 0.688751532_rk*lam2_23 + &
        8.847684_rk*a2_y
    ! link 3: force that moves the link [N]
    fc3_x = -3.4664211_rk*neg_lam3_11
    fc3_y = 3.4664211_rk*lam3_21
    fc3_z = 3.4664211_rk*lam3_31
    ! link 3: moment that turns the link [N m]
    nc3_x = 0.0054421875_rk*lam3_32 - 0.14216721774_rk*lam3_21
    nc3_y = -1.7725776490519998_rk*lam3_31 - 0.14216721774_rk*(neg_lam3_11 - neg_lam3_33) - &
        3.4664211_rk*a3_z
    nc3_z = 1.7725776490519998_rk*lam3_21 - 0.0054421875_rk*lam3_12 + 0.14216721774_rk*lam3_23 + &
        3.4664211_rk*a3_y
    ! link 4: force that moves the link [N]
    fc4_x = -0.0233714_rk*lam4_12
    fc4_y = 0.0233714_rk*neg_lam4_22
    fc4_z = -0.0233714_rk*lam4_32
    ! link 4: moment that turns the link [N m]
    nc4_y = -0.00275625_rk*lam4_31
    nc4_x = 0.0101643168934_rk*lam4_32 - 0.0233714_rk*a4_z
    nc4_z = 0.00275625_rk*lam4_21 - 0.0101643168934_rk*lam4_12 + 0.0233714_rk*a4_x
    ! link 5: moment that turns the link [N m]
    nc5_y = -0.0055125_rk*ww5_zx
    nc5_x = 0.006080625_rk*ww5_yz - 0.000568125_rk*neg_alpha5_x
    nc5_z = 0.006080625_rk*alpha5_z - 0.000568125_rk*ww5_xy
    ! link 6: moment that turns the link [N m]
    nc6_y = -0.000568125_rk*ww6_zx
    nc6_x = 0.000526462289415_rk*ww6_yz - 4.1662710585e-05_rk*alpha6_x
    nc6_z = 4.1662710585e-05_rk*ww6_xy + 0.000526462289415_rk*alpha6_z
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_x = nc5_x + (c6*nc6_x - s6*nc6_y)
    n5_y = nc5_y - nc6_z
    n5_z = nc5_z + (s6*nc6_x + c6*nc6_y)
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = nc4_x - (c5*n5_x - s5*n5_y)
    n4_y = nc4_y - n5_z
    n4_z = nc4_z - (s5*n5_x + c5*n5_y)
    t6 = s4*fc4_x + c4*fc4_y
    ! link 3: moment through the joint, about the frame's origin [N m]
    neg_n3_x = c4*n4_x - s4*n4_y - (nc3_x + 0.1149_rk*t6)
    t7 = c4*fc4_x - s4*fc4_y
    n3_y = nc3_y - (0.1149_rk*t7 - 0.01337545222_rk*lam4_32) - (s4*n4_x + c4*n4_y)
    n3_z = n4_z + (nc3_z - 0.5723_rk*t6)
    ! link 3: force through the joint [N]
    f3_x = fc3_x - t7
    f3_y = fc3_y - t6
    f3_z = fc3_z + fc4_z
    t8 = -s3*f3_x - c3*f3_y
    ! link 2: moment through the joint, about the frame's origin [N m]
    neg_n2_x = c3*neg_n3_x + s3*n3_y + (0.1719_rk*t8 - nc2_x)
    t9 = s3*f3_y - c3*f3_x
    n2_y = nc2_y + (0.1719_rk*t9 - 0.612_rk*f3_z) - (s3*neg_n3_x - c3*n3_y)
    n2_z = n3_z + (nc2_z - 0.612_rk*t8)
    ! link 2: force through the joint [N]
    f2_x = fc2_x - t9
    f2_y = fc2_y - t8
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = s2*neg_n2_x - c2*n2_y + (nc1_z + 0.220941_rk*(s2*f2_y - c2*f2_x))
    tau(1) = n1_z
    tau(2) = n2_z
    tau(3) = n3_z
    tau(4) = n4_z
    tau(5) = n5_z
    tau(6) = nc6_z
  end subroutine

  ! torques that hold the arm at rest
  ! 11 multiplications, 5 additions = 16; 1 unary minus; 6 sine/cosine
  pure subroutine ur10_gravity(q, tau) &
      bind(c, name="ur10_gravity_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: c2, s2, c3, s3, c4, s4, a2_x, a2_y
    real(rk) :: neg_a3_x, a3_y, a4_x, nc2_z, nc3_z, nc4_z, n3_z, n2_z

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    c3 = cos(q(3))
    s3 = sin(q(3))
    c4 = cos(q(4))
    s4 = sin(q(4))
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    a2_x = -9.81_rk*s2
    a2_y = -9.81_rk*c2
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a3_x = -c3*a2_x - s3*a2_y
    a3_y = c3*a2_y - s3*a2_x
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_x = c4*neg_a3_x - s4*a3_y
    ! link 2: moment that turns the link [N m]
    nc2_z = -86.79578004_rk*c2
    ! link 3: moment that turns the link [N m]
    nc3_z = 3.4664211_rk*a3_y
    ! link 4: moment that turns the link [N m]
    nc4_z = 0.0233714_rk*a4_x
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_z = nc3_z + nc4_z
    ! link 2: moment through the joint, about the frame's origin [N m]
    n2_z = nc2_z + n3_z
    tau(1) = 0.0_rk
    tau(2) = n2_z
    tau(3) = n3_z
    tau(4) = nc4_z
    tau(5) = 0.0_rk
    tau(6) = 0.0_rk
  end subroutine

  ! torques at zero acceleration: Coriolis, centrifugal, gravity, friction
  ! 155 multiplications, 105 additions = 260; 6 unary minus; 10 sine/cosine
  pure subroutine ur10_bias(q, qd, tau) &
      bind(c, name="ur10_bias_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: c2, s2, c3, s3, c4, s4, c5, s5
    real(rk) :: c6, s6, ww1_zz, t1, w2_x, w2_y, alpha2_x, alpha2_y
    real(rk) :: ww2_xy, ww2_xx, ww2_yy, ww2_zz, neg_lam2_11, neg_lam2_33, a2_z, a2_x
    real(rk) :: a2_y, w3_x, w3_y, alpha3_x, alpha3_y, w3_z, ww3_yz, ww3_zx
    real(rk) :: ww3_xy, ww3_xx, ww3_yy, ww3_zz, neg_lam3_11, lam3_13, lam3_23, lam3_31
    real(rk) :: lam3_32, neg_lam3_33, a3_z, t2, t3, neg_a3_x, a3_y, t4
    real(rk) :: w4_x, w4_y, alpha4_x, alpha4_y, w4_z, ww4_yz, ww4_zx, ww4_xy
    real(rk) :: ww4_xx, ww4_zz, neg_lam4_22, lam4_31, lam4_32, a4_z, a4_x, w5_x
    real(rk) :: w5_y, alpha5_x, alpha5_y, w5_z, ww5_yz, ww5_zx, ww5_xy, w6_x
    real(rk) :: w6_y, alpha6_x, w6_z, ww6_yz, ww6_zx, ww6_xy, fc2_x, fc2_y
    real(rk) :: nc2_x, nc2_y, nc2_z, fc3_x, fc3_y, fc3_z, nc3_x, nc3_y
    real(rk) :: nc3_z, fc4_x, fc4_y, fc4_z, nc4_y, nc4_x, nc4_z, nc5_y
    real(rk) :: nc5_x, nc5_z, nc6_y, nc6_x, nc6_z, n5_x, n5_y, n5_z
    real(rk) :: n4_x, n4_y, n4_z, t5, neg_n3_x, t6, n3_y, n3_z
    real(rk) :: f3_x, f3_y, f3_z, t7, neg_n2_x, t8, n2_y, n2_z
    real(rk) :: f2_x, f2_y, f1_x, n1_z

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
    ! link 1: products of the angular velocity [1/s^2]
    ww1_zz = qd(1)*qd(1)
    t1 = -qd(1)
    ! link 2: angular velocity [rad/s]
    w2_x = t1*s2
    w2_y = t1*c2
    ! link 2: angular acceleration [rad/s^2]
    alpha2_x = qd(2)*w2_y
    alpha2_y = -qd(2)*w2_x
    ! link 2: products of the angular velocity [1/s^2]
    ww2_xy = w2_x*w2_y
    ww2_xx = w2_x*w2_x
    ww2_yy = w2_y*w2_y
    ww2_zz = qd(2)*qd(2)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_11 = ww2_yy + ww2_zz
    neg_lam2_33 = ww2_xx + ww2_yy
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    a2_z = -0.220941_rk*ww1_zz
    a2_x = -9.81_rk*s2
    a2_y = -9.81_rk*c2
    ! link 3: angular velocity [rad/s]
    w3_x = c3*w2_x + s3*w2_y
    w3_y = c3*w2_y - s3*w2_x
    ! link 3: angular acceleration [rad/s^2]
    alpha3_x = qd(3)*w3_y - (-c3*alpha2_x - s3*alpha2_y)
    alpha3_y = c3*alpha2_y - s3*alpha2_x - qd(3)*w3_x
    ! link 3: angular velocity [rad/s]
    w3_z = qd(2) + qd(3)
    ! link 3: products of the angular velocity [1/s^2]
    ww3_yz = w3_y*w3_z
    ww3_zx = w3_x*w3_z
    ww3_xy = w3_x*w3_y
    ww3_xx = w3_x*w3_x
    ww3_yy = w3_y*w3_y
    ww3_zz = w3_z*w3_z
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_11 = ww3_yy + ww3_zz
    lam3_13 = alpha3_y + ww3_zx
    lam3_23 = ww3_yz - alpha3_x
    lam3_31 = ww3_zx - alpha3_y
    lam3_32 = alpha3_x + ww3_yz
    neg_lam3_33 = ww3_xx + ww3_yy
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_z = a2_z - (1.224_rk*alpha2_y - 0.1719_rk*neg_lam2_33)
    t2 = 0.612_rk*neg_lam2_11 - a2_x
    t3 = -0.612_rk*ww2_xy - a2_y
    neg_a3_x = c3*t2 + s3*t3
    a3_y = s3*t2 - c3*t3
    t4 = -c4
    ! link 4: angular velocity [rad/s]
    w4_x = t4*w3_x - s4*w3_y
    w4_y = s4*w3_x - c4*w3_y
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = t4*alpha3_x - s4*alpha3_y + qd(4)*w4_y
    alpha4_y = s4*alpha3_x - c4*alpha3_y - qd(4)*w4_x
    ! link 4: angular velocity [rad/s]
    w4_z = qd(4) + w3_z
    ! link 4: products of the angular velocity [1/s^2]
    ww4_yz = w4_y*w4_z
    ww4_zx = w4_x*w4_z
    ww4_xy = w4_x*w4_y
    ww4_xx = w4_x*w4_x
    ww4_zz = w4_z*w4_z
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam4_22 = ww4_xx + ww4_zz
    lam4_31 = ww4_zx - alpha4_y
    lam4_32 = alpha4_x + ww4_yz
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_z = a3_z - (0.1149_rk*neg_lam3_33 - 0.5723_rk*lam3_31)
    a4_x = c4*(neg_a3_x + (0.5723_rk*neg_lam3_11 - 0.1149_rk*lam3_13)) - s4*(a3_y - &
        (-0.5723_rk*ww3_xy - 0.1149_rk*lam3_23))
    ! link 5: angular velocity [rad/s]
    w5_x = -(c5*w4_x) - s5*w4_z
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
    fc2_x = -8.847684_rk*neg_lam2_11
    fc2_y = 8.847684_rk*ww2_xy
    ! link 2: moment that turns the link [N m]
    nc2_x = 0.036365625_rk*alpha2_x + 0.688751532_rk*ww2_xy
    nc2_y = 9.215280238596_rk*alpha2_y + 0.688751532_rk*(neg_lam2_11 - neg_lam2_33) + &
        1.954816150644_rk*ww1_zz
    nc2_z = 4.589457306798_rk*ww2_xy - 86.79578004_rk*c2
    ! link 3: force that moves the link [N]
    fc3_x = -3.4664211_rk*neg_lam3_11
    fc3_y = 3.4664211_rk*ww3_xy
    fc3_z = 3.4664211_rk*lam3_31
    ! link 3: moment that turns the link [N m]
    nc3_x = 0.0054421875_rk*lam3_32 - 0.14216721774_rk*ww3_xy
    nc3_y = -1.7725776490519998_rk*lam3_31 - 0.14216721774_rk*(neg_lam3_11 - neg_lam3_33) - &
        3.4664211_rk*a3_z
    nc3_z = 3.4664211_rk*a3_y - (-1.7671354615519999_rk*ww3_xy - 0.14216721774_rk*lam3_23)
    ! link 4: force that moves the link [N]
    fc4_x = -0.0233714_rk*ww4_xy
    fc4_y = 0.0233714_rk*neg_lam4_22
    fc4_z = -0.0233714_rk*lam4_32
    ! link 4: moment that turns the link [N m]
    nc4_y = -0.00275625_rk*lam4_31
    nc4_x = 0.0101643168934_rk*lam4_32 - 0.0233714_rk*a4_z
    nc4_z = 0.0233714_rk*a4_x - 0.0074080668934_rk*ww4_xy
    ! link 5: moment that turns the link [N m]
    nc5_y = -0.0055125_rk*ww5_zx
    nc5_x = 0.006080625_rk*ww5_yz + 0.000568125_rk*alpha5_x
    nc5_z = -0.000568125_rk*ww5_xy - 0.006080625_rk*alpha4_y
    ! link 6: moment that turns the link [N m]
    nc6_y = -0.000568125_rk*ww6_zx
    nc6_x = 0.000526462289415_rk*ww6_yz - 4.1662710585e-05_rk*alpha6_x
    nc6_z = 4.1662710585e-05_rk*ww6_xy - 0.000526462289415_rk*alpha5_y
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_x = nc5_x + (c6*nc6_x - s6*nc6_y)
    n5_y = nc5_y - nc6_z
    n5_z = nc5_z + (s6*nc6_x + c6*nc6_y)
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = nc4_x - (c5*n5_x - s5*n5_y)
    n4_y = nc4_y - n5_z
    n4_z = nc4_z - (s5*n5_x + c5*n5_y)
    t5 = s4*fc4_x + c4*fc4_y
    ! link 3: moment through the joint, about the frame's origin [N m]
    neg_n3_x = c4*n4_x - s4*n4_y - (nc3_x + 0.1149_rk*t5)
    t6 = c4*fc4_x - s4*fc4_y
    n3_y = nc3_y - (0.1149_rk*t6 - 0.01337545222_rk*lam4_32) - (s4*n4_x + c4*n4_y)
    n3_z = n4_z - (0.5723_rk*t5 - nc3_z)
    ! link 3: force through the joint [N]
    f3_x = fc3_x - t6
    f3_y = fc3_y - t5
    f3_z = fc3_z + fc4_z
    t7 = -s3*f3_x - c3*f3_y
    ! link 2: moment through the joint, about the frame's origin [N m]
    neg_n2_x = c3*neg_n3_x + s3*n3_y + (0.1719_rk*t7 - nc2_x)
    t8 = s3*f3_y - c3*f3_x
    n2_y = nc2_y + (0.1719_rk*t8 - 0.612_rk*f3_z) - (s3*neg_n3_x - c3*n3_y)
    n2_z = n3_z + (nc2_z - 0.612_rk*t7)
    ! link 2: force through the joint [N]
    f2_x = fc2_x - t8
    f2_y = fc2_y - t7
    ! link 1: force through the joint [N]
    f1_x = s2*f2_y - c2*f2_x
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = s2*neg_n2_x - c2*n2_y + 0.220941_rk*f1_x
    tau(1) = n1_z
    tau(2) = n2_z
    tau(3) = n3_z
    tau(4) = n4_z
    tau(5) = n5_z
    tau(6) = nc6_z
  end subroutine

  ! mass matrix, rotor inertias on its diagonal
  ! 93 multiplications, 84 additions = 177; 2 unary minus; 10 sine/cosine
  pure subroutine ur10_mass_matrix(q, M) &
      bind(c, name="ur10_mass_matrix_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(out) :: M(36)
    real(rk) :: c2, s2, c3, s3, c4, s4, c5, s5
    real(rk) :: c6, s6, neg_nu4_x, nu4_z, nu3_x, nu3_y, nu2_x, nu2_y
    real(rk) :: nu1_z, k5_xz, t1, k5_xx, m5_5, nu4_x, nu4_z_2, nu3_x_2
    real(rk) :: nu3_y_2, neg_nu2_x, nu2_y_2, nu1_z_2, t2, t3, k4_zz, k4_xz
    real(rk) :: k4_xx, k4_yy, m4_4, fu3_x, fu3_y, t4, nu3_x_3, nu3_y_3
    real(rk) :: nu3_z, t5, fu2_x, t6, fu2_y, t7, nu2_x_2, t8
    real(rk) :: nu2_y_3, nu2_z, fu1_x, nu1_z_3, t9, t10, t11, t12
    real(rk) :: t13, t14, k3_zz, k3_xy, h3_x, t15, k3_xx, t16
    real(rk) :: k3_yy, k3_xz, m3_3, fu2_x_2, fu2_y_2, neg_nu2_x_2, nu2_y_4, nu2_z_2
    real(rk) :: t17, fu1_x_2, t18, nu1_z_4, t19, t20, t21, t22
    real(rk) :: t23, t24, k2_zz, k2_xy, h2_x, t25, k2_yy, k2_xz
    real(rk) :: t26, m2_2, fu1_x_3, nu1_z_5, t27, m1_1

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
    ! link 4: moment for a unit acceleration of a joint further out
    neg_nu4_x = 0.000526462289415_rk*s5
    nu4_z = 0.000526462289415_rk*c5
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_x = c4*neg_nu4_x
    nu3_y = s4*neg_nu4_x
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_x = c3*nu3_x - s3*nu3_y
    nu2_y = s3*nu3_x + c3*nu3_y
    ! link 1: moment for a unit acceleration of a joint further out
    nu1_z = -(s2*nu2_x) - c2*nu2_y
    ! link 5: second moment of the composite body [kg m^2]
    k5_xz = 4.1662710585e-05_rk*(c6*s6)
    t1 = 4.1662710585e-05_rk*(c6*c6)
    k5_xx = t1 + 0.002998649789415_rk
    ! link 5: mass matrix, its row of this joint
    m5_5 = t1 + 0.006038962289415_rk
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_x = c5*k5_xz
    nu4_z_2 = s5*k5_xz
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_x_2 = -(c4*nu4_x) - s4*m5_5
    nu3_y_2 = c4*m5_5 - s4*nu4_x
    ! link 2: moment for a unit acceleration of a joint further out
    neg_nu2_x = s3*nu3_y_2 - c3*nu3_x_2
    nu2_y_2 = s3*nu3_x_2 + c3*nu3_y_2
    ! link 1: moment for a unit acceleration of a joint further out
    nu1_z_2 = s2*neg_nu2_x - c2*nu2_y_2
    t2 = t1 - 4.1662710585e-05_rk
    t3 = c5*c5*t2
    ! link 4: second moment of the composite body [kg m^2]
    k4_zz = k5_xx - t3
    k4_xz = t2*(c5*s5)
    k4_xx = t3 + 0.0057965625_rk
    k4_yy = 0.0076921293934_rk - t1
    ! link 4: mass matrix, its row of this joint
    m4_4 = 0.0134886918934_rk - (t1 - t3)
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x = -0.0233714_rk*c4
    fu3_y = -0.0233714_rk*s4
    t4 = nu4_z_2 - 0.00268537386_rk
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_x_3 = c4*k4_xz - s4*t4
    nu3_y_3 = s4*k4_xz + c4*t4
    nu3_z = m4_4 - 0.01337545222_rk*s4
    t5 = c3*fu3_x
    ! link 2: force for a unit acceleration of a joint further out
    fu2_x = t5 - s3*fu3_y
    t6 = s3*fu3_x
    fu2_y = t6 + c3*fu3_y
    t7 = s3*nu3_y_3
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_x_2 = c3*nu3_x_3 - t7 + 0.1719_rk*fu2_y
    t8 = c3*nu3_y_3
    nu2_y_3 = s3*nu3_x_3 + t8 - 0.1719_rk*fu2_x
    nu2_z = nu3_z + 0.612_rk*fu2_y
    ! link 1: force for a unit acceleration of a joint further out
    fu1_x = s2*fu2_y - c2*fu2_x
    ! link 1: moment for a unit acceleration of a joint further out
    nu1_z_3 = 0.220941_rk*fu1_x - (s2*nu2_x_2 + c2*nu2_y_3)
    t9 = c4*c4
    t10 = t1 + t3 - 0.0018955668934_rk
    t11 = c4*s4
    t12 = t9*t10 - nu4_x*(2.0_rk*t11)
    t13 = k4_xx - t12
    t14 = k4_zz - t13
    ! link 3: second moment of the composite body [kg m^2]
    k3_zz = t13 + t14
    k3_xy = t10*t11 + nu4_x*(2.0_rk*t9 - 1.0_rk) + 0.01337545222_rk*c4
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    h3_x = fu3_y + 3.4664211_rk
    t15 = 0.02675090444_rk*s4 - (k4_yy + t12)
    ! link 3: second moment of the composite body [kg m^2]
    k3_xx = 1.7725776490519998_rk - t15
    t16 = k4_zz - t14
    k3_yy = t16 + 0.0054421875_rk
    k3_xz = 0.14216721774_rk - nu3_x_3
    ! link 3: mass matrix, its row of this joint
    m3_3 = t16 - t15 + 1.7780198365519997_rk
    ! link 2: force for a unit acceleration of a joint further out
    fu2_x_2 = t5 - s3*h3_x
    fu2_y_2 = t6 + c3*h3_x
    ! link 2: moment for a unit acceleration of a joint further out
    neg_nu2_x_2 = t7 + c3*k3_xz - 0.1719_rk*fu2_y_2
    nu2_y_4 = t8 - s3*k3_xz - 0.1719_rk*fu2_x_2
    nu2_z_2 = m3_3 + 0.612_rk*fu2_y_2
    t17 = c2*fu2_x_2
    ! link 1: force for a unit acceleration of a joint further out
    fu1_x_2 = s2*fu2_y_2 - t17
    t18 = c2*nu2_y_4
    ! link 1: moment for a unit acceleration of a joint further out
    nu1_z_4 = s2*neg_nu2_x_2 - t18 + 0.220941_rk*fu1_x_2
    t19 = c3*c3
    t20 = t16 + t15 - 1.7671354615519999_rk
    t21 = c3*s3
    t22 = t19*t20 + k3_xy*(2.0_rk*t21)
    t23 = k3_xx + t22
    t24 = k3_zz - t23
    ! link 2: second moment of the composite body [kg m^2]
    k2_zz = t23 + t24
    k2_xy = -0.612_rk*fu2_x_2 - (t20*t21 + k3_xy*(1.0_rk - 2.0_rk*t19))
    ! link 2: first moment of the composite body, about the frame's origin [kg m]
    h2_x = fu2_y_2 + 8.847684_rk
    t25 = k3_zz - t24
    ! link 2: second moment of the composite body [kg m^2]
    k2_yy = t25 + 0.0181828125_rk
    k2_xz = neg_nu2_x_2 - 0.688751532_rk
    t26 = k3_yy - t22 + 1.224_rk*fu2_y_2
    ! link 2: mass matrix, its row of this joint
    m2_2 = t25 + t26 + 4.625822931798_rk
    ! link 1: force for a unit acceleration of a joint further out
    fu1_x_3 = s2*h2_x - t17
    ! link 1: moment for a unit acceleration of a joint further out
    nu1_z_5 = 0.220941_rk*fu1_x_3 - (t18 - s2*k2_xz)
    t27 = k2_zz + (k2_yy - (c2*c2*(t25 - t26 - 4.589457306798_rk) + k2_xy*(2.0_rk*(c2*s2))))
    ! link 1: mass matrix, its row of this joint
    m1_1 = t27 + 0.751562446711482_rk
    M(1) = m1_1
    M(2) = nu1_z_5
    M(3) = nu1_z_4
    M(4) = nu1_z_3
    M(5) = nu1_z_2
    M(6) = nu1_z
    M(7) = nu1_z_5
    M(8) = m2_2
    M(9) = nu2_z_2
    M(10) = nu2_z
    M(11) = nu4_z_2
    M(12) = nu4_z
    M(13) = nu1_z_4
    M(14) = nu2_z_2
    M(15) = m3_3
    M(16) = nu3_z
    M(17) = nu4_z_2
    M(18) = nu4_z
    M(19) = nu1_z_3
    M(20) = nu2_z
    M(21) = nu3_z
    M(22) = m4_4
    M(23) = nu4_z_2
    M(24) = nu4_z
    M(25) = nu1_z_2
    M(26) = nu4_z_2
    M(27) = nu4_z_2
    M(28) = nu4_z_2
    M(29) = m5_5
    M(30) = 0.0_rk
    M(31) = nu1_z
    M(32) = nu4_z
    M(33) = nu4_z
    M(34) = nu4_z
    M(35) = 0.0_rk
    M(36) = 0.000526462289415_rk
  end subroutine

  ! accelerations that the torques tau give
  ! 334 multiplications, 259 additions, 6 divisions = 599; 12 unary minus; 10 sine/cosine
  pure subroutine ur10_forward_dynamics(q, qd, tau, qdd) &
      bind(c, name="ur10_forward_dynamics_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(in) :: tau(6)
    real(rk), intent(out) :: qdd(6)
    real(rk) :: c2, s2, c3, s3, c4, s4, c5, s5
    real(rk) :: c6, s6, neg_nu4_x, nu4_z, nu3_x, nu3_y, nu2_x, nu2_y
    real(rk) :: nu1_z, k5_xz, t1, k5_xx, m5_5, nu4_x, nu4_z_2, nu3_x_2
    real(rk) :: nu3_y_2, neg_nu2_x, nu2_y_2, nu1_z_2, t2, t3, k4_zz, k4_xz
    real(rk) :: k4_xx, k4_yy, m4_4, fu3_x, fu3_y, t4, nu3_x_3, nu3_y_3
    real(rk) :: nu3_z, t5, fu2_x, t6, fu2_y, t7, nu2_x_2, t8
    real(rk) :: nu2_y_3, nu2_z, fu1_x, nu1_z_3, t9, t10, t11, t12
    real(rk) :: t13, t14, k3_zz, k3_xy, h3_x, t15, k3_xx, t16
    real(rk) :: k3_yy, k3_xz, m3_3, fu2_x_2, fu2_y_2, neg_nu2_x_2, nu2_y_4, nu2_z_2
    real(rk) :: t17, fu1_x_2, t18, nu1_z_4, t19, t20, t21, t22
    real(rk) :: t23, t24, k2_zz, k2_xy, h2_x, t25, k2_yy, k2_xz
    real(rk) :: t26, m2_2, fu1_x_3, nu1_z_5, t27, m1_1, ww1_zz, t28
    real(rk) :: w2_x, w2_y, alpha2_x, alpha2_y, ww2_xy, ww2_xx, ww2_yy, ww2_zz
    real(rk) :: neg_lam2_11, neg_lam2_33, a2_z, a2_x, a2_y, w3_x, w3_y, alpha3_x
    real(rk) :: alpha3_y, w3_z, ww3_yz, ww3_zx, ww3_xy, ww3_xx, ww3_yy, ww3_zz
    real(rk) :: neg_lam3_11, lam3_13, lam3_23, lam3_31, lam3_32, neg_lam3_33, a3_z, t29
    real(rk) :: t30, neg_a3_x, a3_y, t31, w4_x, w4_y, alpha4_x, alpha4_y
    real(rk) :: w4_z, ww4_yz, ww4_zx, ww4_xy, ww4_xx, ww4_zz, neg_lam4_22, lam4_31
    real(rk) :: lam4_32, a4_z, a4_x, w5_x, w5_y, alpha5_x, alpha5_y, w5_z
    real(rk) :: ww5_yz, ww5_zx, ww5_xy, w6_x, w6_y, alpha6_x, w6_z, ww6_yz
    real(rk) :: ww6_zx, ww6_xy, fc2_x, fc2_y, nc2_x, nc2_y, nc2_z, fc3_x
    real(rk) :: fc3_y, fc3_z, nc3_x, nc3_y, nc3_z, fc4_x, fc4_y, fc4_z
    real(rk) :: nc4_y, nc4_x, nc4_z, nc5_y, nc5_x, nc5_z, nc6_y, nc6_x
    real(rk) :: nc6_z, n5_x, n5_y, n5_z, n4_x, n4_y, n4_z, t32
    real(rk) :: neg_n3_x, t33, n3_y, n3_z, f3_x, f3_y, f3_z, t34
    real(rk) :: neg_n2_x, t35, n2_y, n2_z, f2_x, f2_y, f1_x, n1_z
    real(rk) :: y1, ipivot1, l2_1, l3_1, l4_1, l5_1, l6_1, pivot2
    real(rk) :: ipivot2, ld3_2, l3_2, ld4_2, l4_2, ld5_2, l5_2, ld6_2
    real(rk) :: l6_2, pivot3, ipivot3, ld4_3, l4_3, ld5_3, l5_3, ld6_3
    real(rk) :: l6_3, pivot4, ipivot4, ld5_4, l5_4, ld6_4, l6_4, pivot5
    real(rk) :: ipivot5, ld6_5, l6_5, pivot6, ipivot6, y2, y3, y4
    real(rk) :: y5, y6, qdd6, qdd5, qdd4, qdd3, qdd2, t36
    real(rk) :: qdd1

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
    ! link 4: moment for a unit acceleration of a joint further out
    neg_nu4_x = 0.000526462289415_rk*s5
    nu4_z = 0.000526462289415_rk*c5
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_x = c4*neg_nu4_x
    nu3_y = s4*neg_nu4_x
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_x = c3*nu3_x - s3*nu3_y
    nu2_y = s3*nu3_x + c3*nu3_y
    ! link 1: moment for a unit acceleration of a joint further out
    nu1_z = -(s2*nu2_x) - c2*nu2_y
    ! link 5: second moment of the composite body [kg m^2]
    k5_xz = 4.1662710585e-05_rk*(c6*s6)
    t1 = 4.1662710585e-05_rk*(c6*c6)
    k5_xx = t1 + 0.002998649789415_rk
    ! link 5: mass matrix, its row of this joint
    m5_5 = t1 + 0.006038962289415_rk
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_x = c5*k5_xz
    nu4_z_2 = s5*k5_xz
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_x_2 = -(c4*nu4_x) - s4*m5_5
    nu3_y_2 = c4*m5_5 - s4*nu4_x
    ! link 2: moment for a unit acceleration of a joint further out
    neg_nu2_x = s3*nu3_y_2 - c3*nu3_x_2
    nu2_y_2 = s3*nu3_x_2 + c3*nu3_y_2
    ! link 1: moment for a unit acceleration of a joint further out
    nu1_z_2 = s2*neg_nu2_x - c2*nu2_y_2
    t2 = t1 - 4.1662710585e-05_rk
    t3 = c5*c5*t2
    ! link 4: second moment of the composite body [kg m^2]
    k4_zz = k5_xx - t3
    k4_xz = t2*(c5*s5)
    k4_xx = t3 + 0.0057965625_rk
    k4_yy = 0.0076921293934_rk - t1
    ! link 4: mass matrix, its row of this joint
    m4_4 = 0.0134886918934_rk - (t1 - t3)
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x = -0.0233714_rk*c4
    fu3_y = -0.0233714_rk*s4
    t4 = nu4_z_2 - 0.00268537386_rk
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_x_3 = c4*k4_xz - s4*t4
    nu3_y_3 = s4*k4_xz + c4*t4
    nu3_z = m4_4 - 0.01337545222_rk*s4
    t5 = c3*fu3_x
    ! link 2: force for a unit acceleration of a joint further out
    fu2_x = t5 - s3*fu3_y
    t6 = s3*fu3_x
    fu2_y = t6 + c3*fu3_y
    t7 = s3*nu3_y_3
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_x_2 = c3*nu3_x_3 - t7 + 0.1719_rk*fu2_y
    t8 = c3*nu3_y_3
    nu2_y_3 = s3*nu3_x_3 + t8 - 0.1719_rk*fu2_x
    nu2_z = nu3_z + 0.612_rk*fu2_y
    ! link 1: force for a unit acceleration of a joint further out
    fu1_x = s2*fu2_y - c2*fu2_x
    ! link 1: moment for a unit acceleration of a joint further out
    nu1_z_3 = 0.220941_rk*fu1_x - (s2*nu2_x_2 + c2*nu2_y_3)
    t9 = c4*c4
    t10 = t1 + t3 - 0.0018955668934_rk
    t11 = c4*s4
    t12 = t9*t10 - nu4_x*(2.0_rk*t11)
    t13 = k4_xx - t12
    t14 = k4_zz - t13
    ! link 3: second moment of the composite body [kg m^2]
    k3_zz = t13 + t14
    k3_xy = t10*t11 + nu4_x*(2.0_rk*t9 - 1.0_rk) + 0.01337545222_rk*c4
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    h3_x = fu3_y + 3.4664211_rk
    t15 = 0.02675090444_rk*s4 - (k4_yy + t12)
    ! link 3: second moment of the composite body [kg m^2]
    k3_xx = 1.7725776490519998_rk - t15
    t16 = k4_zz - t14
    k3_yy = t16 + 0.0054421875_rk
    k3_xz = 0.14216721774_rk - nu3_x_3
    ! link 3: mass matrix, its row of this joint
    m3_3 = t16 - t15 + 1.7780198365519997_rk
    ! link 2: force for a unit acceleration of a joint further out
    fu2_x_2 = t5 - s3*h3_x
    fu2_y_2 = t6 + c3*h3_x
    ! link 2: moment for a unit acceleration of a joint further out
    neg_nu2_x_2 = t7 + c3*k3_xz - 0.1719_rk*fu2_y_2
    nu2_y_4 = t8 - s3*k3_xz - 0.1719_rk*fu2_x_2
    nu2_z_2 = m3_3 + 0.612_rk*fu2_y_2
    t17 = c2*fu2_x_2
    ! link 1: force for a unit acceleration of a joint further out
    fu1_x_2 = s2*fu2_y_2 - t17
    t18 = c2*nu2_y_4
    ! link 1: moment for a unit acceleration of a joint further out
    nu1_z_4 = s2*neg_nu2_x_2 - t18 + 0.220941_rk*fu1_x_2
    t19 = c3*c3
    t20 = t16 + t15 - 1.7671354615519999_rk
    t21 = c3*s3
    t22 = t19*t20 + k3_xy*(2.0_rk*t21)
    t23 = k3_xx + t22
    t24 = k3_zz - t23
    ! link 2: second moment of the composite body [kg m^2]
    k2_zz = t23 + t24
    k2_xy = -0.612_rk*fu2_x_2 - (t20*t21 + k3_xy*(1.0_rk - 2.0_rk*t19))
    ! link 2: first moment of the composite body, about the frame's origin [kg m]
    h2_x = fu2_y_2 + 8.847684_rk
    t25 = k3_zz - t24
    ! link 2: second moment of the composite body [kg m^2]
    k2_yy = t25 + 0.0181828125_rk
    k2_xz = neg_nu2_x_2 - 0.688751532_rk
    t26 = k3_yy - t22 + 1.224_rk*fu2_y_2
    ! link 2: mass matrix, its row of this joint
    m2_2 = t25 + t26 + 4.625822931798_rk
    ! link 1: force for a unit acceleration of a joint further out
    fu1_x_3 = s2*h2_x - t17
    ! link 1: moment for a unit acceleration of a joint further out
    nu1_z_5 = 0.220941_rk*fu1_x_3 - (t18 - s2*k2_xz)
    t27 = k2_zz + (k2_yy - (c2*c2*(t25 - t26 - 4.589457306798_rk) + k2_xy*(2.0_rk*(c2*s2))))
    ! link 1: mass matrix, its row of this joint
    m1_1 = t27 + 0.751562446711482_rk
    ! link 1: products of the angular velocity [1/s^2]
    ww1_zz = qd(1)*qd(1)
    t28 = -qd(1)
    ! link 2: angular velocity [rad/s]
    w2_x = t28*s2
    w2_y = t28*c2
    ! link 2: angular acceleration [rad/s^2]
    alpha2_x = qd(2)*w2_y
    alpha2_y = -qd(2)*w2_x
    ! link 2: products of the angular velocity [1/s^2]
    ww2_xy = w2_x*w2_y
    ww2_xx = w2_x*w2_x
    ww2_yy = w2_y*w2_y
    ww2_zz = qd(2)*qd(2)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_11 = ww2_yy + ww2_zz
    neg_lam2_33 = ww2_xx + ww2_yy
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    a2_z = -0.220941_rk*ww1_zz
    a2_x = -9.81_rk*s2
    a2_y = -9.81_rk*c2
    ! link 3: angular velocity [rad/s]
    w3_x = c3*w2_x + s3*w2_y
    w3_y = c3*w2_y - s3*w2_x
    ! link 3: angular acceleration [rad/s^2]
    alpha3_x = qd(3)*w3_y - (-c3*alpha2_x - s3*alpha2_y)
    alpha3_y = c3*alpha2_y - s3*alpha2_x - qd(3)*w3_x
    ! link 3: angular velocity [rad/s]
    w3_z = qd(2) + qd(3)
    ! link 3: products of the angular velocity [1/s^2]
    ww3_yz = w3_y*w3_z
    ww3_zx = w3_x*w3_z
    ww3_xy = w3_x*w3_y
    ww3_xx = w3_x*w3_x
    ww3_yy = w3_y*w3_y
    ww3_zz = w3_z*w3_z
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_11 = ww3_yy + ww3_zz
    lam3_13 = alpha3_y + ww3_zx
    lam3_23 = ww3_yz - alpha3_x
    lam3_31 = ww3_zx - alpha3_y
    lam3_32 = alpha3_x + ww3_yz
    neg_lam3_33 = ww3_xx + ww3_yy
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_z = a2_z - (1.224_rk*alpha2_y - 0.1719_rk*neg_lam2_33)
    t29 = 0.612_rk*neg_lam2_11 - a2_x
    t30 = -0.612_rk*ww2_xy - a2_y
    neg_a3_x = c3*t29 + s3*t30
    a3_y = s3*t29 - c3*t30
    t31 = -c4
    ! link 4: angular velocity [rad/s]
    w4_x = t31*w3_x - s4*w3_y
    w4_y = s4*w3_x - c4*w3_y
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = t31*alpha3_x - s4*alpha3_y + qd(4)*w4_y
    alpha4_y = s4*alpha3_x - c4*alpha3_y - qd(4)*w4_x
    ! link 4: angular velocity [rad/s]
    w4_z = qd(4) + w3_z
    ! link 4: products of the angular velocity [1/s^2]
    ww4_yz = w4_y*w4_z
    ww4_zx = w4_x*w4_z
    ww4_xy = w4_x*w4_y
    ww4_xx = w4_x*w4_x
    ww4_zz = w4_z*w4_z
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam4_22 = ww4_xx + ww4_zz
    lam4_31 = ww4_zx - alpha4_y
    lam4_32 = alpha4_x + ww4_yz
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_z = a3_z - (0.1149_rk*neg_lam3_33 - 0.5723_rk*lam3_31)
    a4_x = c4*(neg_a3_x + (0.5723_rk*neg_lam3_11 - 0.1149_rk*lam3_13)) - s4*(a3_y - &
        (-0.5723_rk*ww3_xy - 0.1149_rk*lam3_23))
    ! link 5: angular velocity [rad/s]
    w5_x = -(c5*w4_x) - s5*w4_z
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
    fc2_x = -8.847684_rk*neg_lam2_11
    fc2_y = 8.847684_rk*ww2_xy
    ! link 2: moment that turns the link [N m]
    nc2_x = 0.036365625_rk*alpha2_x + 0.688751532_rk*ww2_xy
    nc2_y = 9.215280238596_rk*alpha2_y + 0.688751532_rk*(neg_lam2_11 - neg_lam2_33) + &
        1.954816150644_rk*ww1_zz
    nc2_z = 4.589457306798_rk*ww2_xy - 86.79578004_rk*c2
    ! link 3: force that moves the link [N]
    fc3_x = -3.4664211_rk*neg_lam3_11
    fc3_y = 3.4664211_rk*ww3_xy
    fc3_z = 3.4664211_rk*lam3_31
    ! link 3: moment that turns the link [N m]
    nc3_x = 0.0054421875_rk*lam3_32 - 0.14216721774_rk*ww3_xy
    nc3_y = -1.7725776490519998_rk*lam3_31 - 0.14216721774_rk*(neg_lam3_11 - neg_lam3_33) - &
        3.4664211_rk*a3_z
    nc3_z = 3.4664211_rk*a3_y - (-1.7671354615519999_rk*ww3_xy - 0.14216721774_rk*lam3_23)
    ! link 4: force that moves the link [N]
    fc4_x = -0.0233714_rk*ww4_xy
    fc4_y = 0.0233714_rk*neg_lam4_22
    fc4_z = -0.0233714_rk*lam4_32
    ! link 4: moment that turns the link [N m]
    nc4_y = -0.00275625_rk*lam4_31
    nc4_x = 0.0101643168934_rk*lam4_32 - 0.0233714_rk*a4_z
    nc4_z = 0.0233714_rk*a4_x - 0.0074080668934_rk*ww4_xy
    ! link 5: moment that turns the link [N m]
    nc5_y = -0.0055125_rk*ww5_zx
    nc5_x = 0.006080625_rk*ww5_yz + 0.000568125_rk*alpha5_x
    nc5_z = -0.000568125_rk*ww5_xy - 0.006080625_rk*alpha4_y
    ! link 6: moment that turns the link [N m]
    nc6_y = -0.000568125_rk*ww6_zx
    nc6_x = 0.000526462289415_rk*ww6_yz - 4.1662710585e-05_rk*alpha6_x
    nc6_z = 4.1662710585e-05_rk*ww6_xy - 0.000526462289415_rk*alpha5_y
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_x = nc5_x + (c6*nc6_x - s6*nc6_y)
    n5_y = nc5_y - nc6_z
    n5_z = nc5_z + (s6*nc6_x + c6*nc6_y)
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = nc4_x - (c5*n5_x - s5*n5_y)
    n4_y = nc4_y - n5_z
    n4_z = nc4_z - (s5*n5_x + c5*n5_y)
    t32 = s4*fc4_x + c4*fc4_y
    ! link 3: moment through the joint, about the frame's origin [N m]
    neg_n3_x = c4*n4_x - s4*n4_y - (nc3_x + 0.1149_rk*t32)
    t33 = c4*fc4_x - s4*fc4_y
    n3_y = nc3_y - (0.1149_rk*t33 - 0.01337545222_rk*lam4_32) - (s4*n4_x + c4*n4_y)
    n3_z = n4_z - (0.5723_rk*t32 - nc3_z)
    ! link 3: force through the joint [N]
    f3_x = fc3_x - t33
    f3_y = fc3_y - t32
    f3_z = fc3_z + fc4_z
    t34 = -s3*f3_x - c3*f3_y
    ! link 2: moment through the joint, about the frame's origin [N m]
    neg_n2_x = c3*neg_n3_x + s3*n3_y + (0.1719_rk*t34 - nc2_x)
    t35 = s3*f3_y - c3*f3_x
    n2_y = nc2_y + (0.1719_rk*t35 - 0.612_rk*f3_z) - (s3*neg_n3_x - c3*n3_y)
    n2_z = n3_z + (nc2_z - 0.612_rk*t34)
    ! link 2: force through the joint [N]
    f2_x = fc2_x - t35
    f2_y = fc2_y - t34
    ! link 1: force through the joint [N]
    f1_x = s2*f2_y - c2*f2_x
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = s2*neg_n2_x - c2*n2_y + 0.220941_rk*f1_x
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
    ld3_2 = nu2_z_2 - nu1_z_5*l3_1
    l3_2 = ipivot2*ld3_2
    ld4_2 = nu2_z - nu1_z_5*l4_1
    l4_2 = ipivot2*ld4_2
    ld5_2 = nu4_z_2 - nu1_z_5*l5_1
    l5_2 = ipivot2*ld5_2
    ld6_2 = nu4_z - nu1_z_5*l6_1
    l6_2 = ipivot2*ld6_2
    pivot3 = m3_3 - nu1_z_4*l3_1 - ld3_2*l3_2
    ipivot3 = 1.0_rk / pivot3
    ld4_3 = -ld3_2*l4_2 - (nu1_z_4*l4_1 - nu3_z)
    l4_3 = ipivot3*ld4_3
    ld5_3 = nu4_z_2 - nu1_z_4*l5_1 - ld3_2*l5_2
    l5_3 = ipivot3*ld5_3
    ld6_3 = nu4_z - nu1_z_4*l6_1 - ld3_2*l6_2
    l6_3 = ipivot3*ld6_3
    pivot4 = m4_4 - nu1_z_3*l4_1 - ld4_2*l4_2 - ld4_3*l4_3
    ipivot4 = 1.0_rk / pivot4
    ld5_4 = nu4_z_2 - nu1_z_3*l5_1 - ld4_2*l5_2 - ld4_3*l5_3
    l5_4 = ipivot4*ld5_4
    ld6_4 = nu4_z - nu1_z_3*l6_1 - ld4_2*l6_2 - ld4_3*l6_3
    l6_4 = ipivot4*ld6_4
    pivot5 = m5_5 - nu1_z_2*l5_1 - ld5_2*l5_2 - ld5_3*l5_3 - ld5_4*l5_4
    ipivot5 = 1.0_rk / pivot5
    ld6_5 = -ld5_4*l6_4 - (nu1_z_2*l6_1 + ld5_2*l6_2 + ld5_3*l6_3)
    l6_5 = ipivot5*ld6_5
    pivot6 = 0.000526462289415_rk - nu1_z*l6_1 - ld6_2*l6_2 - ld6_3*l6_3 - ld6_4*l6_4 - ld6_5*l6_5
    ipivot6 = 1.0_rk / pivot6
    ! link 2: forward substitution
    y2 = tau(2) - n2_z - y1*l2_1
    ! link 3: forward substitution
    y3 = tau(3) - n3_z - y1*l3_1 - l3_2*y2
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
    qdd3 = ipivot3*y3 - l4_3*qdd4 - l5_3*qdd5 - l6_3*qdd6
    ! link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd2 = ipivot2*y2 - l3_2*qdd3 - l4_2*qdd4 - l5_2*qdd5 - l6_2*qdd6
    t36 = -l5_1*qdd5 - (l2_1*qdd2 - y1*ipivot1 + l3_1*qdd3 + l4_1*qdd4)
    ! link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd1 = t36 - l6_1*qdd6
    qdd(1) = qdd1
    qdd(2) = qdd2
    qdd(3) = qdd3
    qdd(4) = qdd4
    qdd(5) = qdd5
    qdd(6) = qdd6
  end subroutine
end module
