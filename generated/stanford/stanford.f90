! stanford: Stanford arm, six joints
! Numbers: the 1990 thesis, Tables 2.2 (corrected), 2.7, 2.8; Izz of link 3 assumed
! Written by robodyn; do not edit, generate again.
!
! Joints, base to tip: 1 revolute, 2 revolute, 3 prismatic, 4 revolute, 5 revolute, 6 revolute
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
!   inverse_dynamics: 131 multiplications, 98 additions = 229; 6 unary minus; 8 sine/cosine
!   gravity: 25 multiplications, 10 additions = 35; 0 unary minus; 6 sine/cosine
!   bias: 118 multiplications, 77 additions = 195; 6 unary minus; 8 sine/cosine
!   mass_matrix: 56 multiplications, 45 additions = 101; 3 unary minus; 6 sine/cosine
!   forward_dynamics: 260 multiplications, 189 additions, 6 divisions = 455; 15 unary minus; 8
!       sine/cosine
module stanford_dynamics
  use, intrinsic :: iso_c_binding, only: rk => c_double
  implicit none
  private

  public :: stanford_inverse_dynamics
  public :: stanford_gravity
  public :: stanford_bias
  public :: stanford_mass_matrix
  public :: stanford_forward_dynamics

contains

  ! torques that give the accelerations qdd
  ! 131 multiplications, 98 additions = 229; 6 unary minus; 8 sine/cosine
  pure subroutine stanford_inverse_dynamics(q, qd, qdd, tau) &
      bind(c, name="stanford_inverse_dynamics_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(in) :: qdd(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: c2, s2, c4, s4, c5, s5, c6, s6, ww1_zz, a2_z, t1, w2_x, w2_y, t2, a2_x, a2_y
    real(rk) :: ww2_yz, ww2_zx, alpha2_x, alpha2_y, ww2_xy, ww2_xx, ww2_zz, lam2_12, lam2_21
    real(rk) :: lam2_22, neg_lam2_31, lam2_32, t3, a3_x, a3_y, a3_z, w4_x, w4_y, a4_x, a4_y
    real(rk) :: alpha4_x, alpha4_y, alpha4_z, w4_z, ww4_yz, ww4_zx, ww4_xy, ww4_xx, ww4_yy, ww4_zz
    real(rk) :: lam4_12, lam4_13, neg_lam4_22, lam4_32, neg_lam4_33, w5_x, t4, w5_y, a5_x, alpha5_y
    real(rk) :: alpha5_z, w5_z, ww5_zx, ww5_xy, ww5_xx, ww5_zz, lam5_12, lam5_21, neg_lam5_22
    real(rk) :: neg_lam5_31, lam5_32, w6_x, w6_y, alpha6_z, w6_z, ww6_yz, ww6_zx, nc2_x, nc2_y
    real(rk) :: nc2_z, fc3_x, fc3_y, fc3_z, neg_nc3_x, nc3_y, neg_fc4_x, fc4_y, fc4_z, nc4_y
    real(rk) :: neg_nc4_x, nc4_z, fc5_x, fc5_y, neg_fc5_z, nc5_y, nc5_x, nc5_z, nc6_x, nc6_y, nc6_z
    real(rk) :: n06_x, n06_y, tau6, n5_x, n5_y, n5_z, f05_x, f05_y, n05_x, n05_y, tau5, n4_x, n4_y
    real(rk) :: n4_z, f4_x, f4_y, f4_z, f04_x, f04_y, n04_x, n04_y, tau4, n3_x, n3_y, f3_x, f3_y
    real(rk) :: f3_z, tau3, n2_x, n2_y, n2_z, neg_f02_x, tau2, tau1

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    c4 = cos(q(4))
    s4 = sin(q(4))
    c5 = cos(q(5))
    s5 = sin(q(5))
    c6 = cos(q(6))
    s6 = sin(q(6))
    ! link 1: products of the angular velocity [1/s^2]
    ww1_zz = qd(1)*qd(1)
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    a2_z = -0.1524_rk*ww1_zz
    t1 = -qd(1)
    ! link 2: angular velocity [rad/s]
    w2_x = t1*s2
    w2_y = t1*c2
    t2 = 0.1524_rk*qdd(1)
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    a2_x = -9.8_rk*s2 - c2*t2
    a2_y = s2*t2 - 9.8_rk*c2
    ! link 2: products of the angular velocity [1/s^2]
    ww2_yz = qd(2)*w2_y
    ww2_zx = qd(2)*w2_x
    ! link 2: angular acceleration [rad/s^2]
    alpha2_x = ww2_yz - qdd(1)*s2
    alpha2_y = -qdd(1)*c2 - ww2_zx
    ! link 2: products of the angular velocity [1/s^2]
    ww2_xy = w2_x*w2_y
    ww2_xx = w2_x*w2_x
    ww2_zz = qd(2)*qd(2)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    lam2_12 = ww2_xy - qdd(2)
    lam2_21 = qdd(2) + ww2_xy
    lam2_22 = -ww2_xx - ww2_zz
    neg_lam2_31 = alpha2_y - ww2_zx
    lam2_32 = ww2_yz + alpha2_x
    t3 = 2.0_rk*qd(3)
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_x = a2_x - q(3)*lam2_12 + qd(2)*t3
    a3_y = a2_z - q(3)*lam2_32 - w2_x*t3
    a3_z = qdd(3) - (a2_y - q(3)*lam2_22)
    ! link 4: angular velocity [rad/s]
    w4_x = c4*w2_x + qd(2)*s4
    w4_y = qd(2)*c4 - s4*w2_x
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_x = c4*a3_x + s4*a3_y
    a4_y = c4*a3_y - s4*a3_x
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = qd(4)*w4_y - (-qdd(2)*s4 - c4*alpha2_x)
    alpha4_y = qdd(2)*c4 - s4*alpha2_x - qd(4)*w4_x
    alpha4_z = qdd(4) - alpha2_y
    ! link 4: angular velocity [rad/s]
    w4_z = qd(4) - w2_y
    ! link 4: products of the angular velocity [1/s^2]
    ww4_yz = w4_y*w4_z
    ww4_zx = w4_x*w4_z
    ww4_xy = w4_x*w4_y
    ww4_xx = w4_x*w4_x
    ww4_yy = w4_y*w4_y
    ww4_zz = w4_z*w4_z
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_12 = ww4_xy - alpha4_z
    lam4_13 = alpha4_y + ww4_zx
    neg_lam4_22 = ww4_xx + ww4_zz
    lam4_32 = alpha4_x + ww4_yz
    neg_lam4_33 = ww4_xx + ww4_yy
    ! link 5: angular velocity [rad/s]
    w5_x = c5*w4_x - s5*w4_z
    t4 = -c5
    w5_y = t4*w4_z - s5*w4_x
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_x = c5*a4_x - s5*a3_z
    ! link 5: angular acceleration [rad/s^2]
    alpha5_y = t4*alpha4_z - s5*alpha4_x - qd(5)*w5_x
    alpha5_z = qdd(5) + alpha4_y
    ! link 5: angular velocity [rad/s]
    w5_z = qd(5) + w4_y
    ! link 5: products of the angular velocity [1/s^2]
    ww5_zx = w5_x*w5_z
    ww5_xy = w5_x*w5_y
    ww5_xx = w5_x*w5_x
    ww5_zz = w5_z*w5_z
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_12 = ww5_xy - alpha5_z
    lam5_21 = alpha5_z + ww5_xy
    neg_lam5_22 = ww5_xx + ww5_zz
    neg_lam5_31 = alpha5_y - ww5_zx
    lam5_32 = w5_y*(qd(5) + w5_z) - (s5*alpha4_z - c5*alpha4_x)
    ! link 6: angular velocity [rad/s]
    w6_x = c6*w5_x + s6*w5_z
    w6_y = c6*w5_z - s6*w5_x
    ! link 6: angular acceleration [rad/s^2]
    alpha6_z = qdd(6) - alpha5_y
    ! link 6: angular velocity [rad/s]
    w6_z = qd(6) - w5_y
    ! link 6: products of the angular velocity [1/s^2]
    ww6_yz = w6_y*w6_z
    ww6_zx = w6_x*w6_z
    ! link 2: moment that turns the link [N m]
    nc2_x = 4.2875532937_rk*lam2_32
    nc2_y = 0.008_rk*neg_lam2_31
    nc2_z = 0.008_rk*lam2_21 - 4.2875532937_rk*lam2_12
    ! link 3: force that moves the link [N]
    fc3_x = 6.47_rk*a3_x - 2.730039_rk*lam2_12
    fc3_y = 6.47_rk*a3_y - 2.730039_rk*lam2_32
    fc3_z = 6.47_rk*a3_z + 2.730039_rk*lam2_22
    ! link 3: moment that turns the link [N m]
    neg_nc3_x = 2.730039_rk*a3_y
    nc3_y = 2.730039_rk*a3_x
    ! link 4: force that moves the link [N]
    neg_fc4_x = 0.005832_rk*lam4_12
    fc4_y = 0.005832_rk*neg_lam4_22
    fc4_z = -0.005832_rk*lam4_32
    ! link 4: moment that turns the link [N m]
    nc4_y = 5.36544e-05_rk*lam4_12
    neg_nc4_x = -0.0012314928_rk*lam4_32 - 5.36544e-05_rk*(neg_lam4_22 - neg_lam4_33) + &
        0.005832_rk*a3_z
    nc4_z = -0.0012314928_rk*lam4_12 - 5.36544e-05_rk*lam4_13 + 0.005832_rk*a4_x
    ! link 5: force that moves the link [N]
    fc5_x = -0.114912_rk*lam5_12
    fc5_y = 0.114912_rk*neg_lam5_22
    neg_fc5_z = 0.114912_rk*lam5_32
    ! link 5: moment that turns the link [N m]
    nc5_y = 0.0002_rk*neg_lam5_31
    nc5_x = 0.0301343144_rk*lam5_32 - 0.114912_rk*a4_y
    nc5_z = 0.0002_rk*lam5_21 - 0.0301343144_rk*lam5_12 + 0.114912_rk*a5_x
    ! link 6: moment that turns the link [N m]
    nc6_x = 0.0003_rk*ww6_yz
    nc6_y = -0.0003_rk*ww6_zx
    nc6_z = 0.0003_rk*alpha6_z
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    n06_x = c6*nc6_x - s6*nc6_y
    n06_y = s6*nc6_x + c6*nc6_y
    ! link 6: joint torque [N m], at a prismatic joint force [N]
    tau6 = nc6_z + 0.02_rk*qdd(6)
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_x = nc5_x + n06_x
    n5_y = nc5_y - nc6_z
    n5_z = nc5_z + n06_y
    ! link 5: force through the joint, along the axes that its turn starts from [N]
    f05_x = c5*fc5_x - s5*fc5_y
    f05_y = s5*fc5_x + c5*fc5_y
    ! link 5: moment through the joint, along the axes that its turn starts from [N m]
    n05_x = c5*n5_x - s5*n5_y
    n05_y = s5*n5_x + c5*n5_y
    ! link 5: joint torque [N m], at a prismatic joint force [N]
    tau5 = n5_z + 0.097_rk*qdd(5)
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = n05_x - neg_nc4_x
    n4_y = nc4_y + n5_z
    n4_z = nc4_z - n05_y
    ! link 4: force through the joint [N]
    f4_x = f05_x - neg_fc4_x
    f4_y = fc4_y - neg_fc5_z
    f4_z = fc4_z - f05_y
    ! link 4: force through the joint, along the axes that its turn starts from [N]
    f04_x = c4*f4_x - s4*f4_y
    f04_y = s4*f4_x + c4*f4_y
    ! link 4: moment through the joint, along the axes that its turn starts from [N m]
    n04_x = c4*n4_x - s4*n4_y
    n04_y = s4*n4_x + c4*n4_y
    ! link 4: joint torque [N m], at a prismatic joint force [N]
    tau4 = n4_z + 0.106_rk*qdd(4)
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_x = n04_x - neg_nc3_x
    n3_y = nc3_y + n04_y
    ! link 3: force through the joint [N]
    f3_x = fc3_x + f04_x
    f3_y = fc3_y + f04_y
    f3_z = fc3_z + f4_z
    ! link 3: joint torque [N m], at a prismatic joint force [N]
    tau3 = f3_z + 0.782_rk*qdd(3)
    ! link 2: moment through the joint, about the frame's origin [N m]
    n2_x = n3_x + (nc2_x - q(3)*f3_y)
    n2_y = nc2_y - n4_z
    n2_z = n3_y + (nc2_z + q(3)*f3_x)
    ! link 2: force through the joint, along the axes that its turn starts from [N]
    neg_f02_x = -s2*f3_z - c2*f3_x
    ! link 2: joint torque [N m], at a prismatic joint force [N]
    tau2 = n2_z + 2.193_rk*qdd(2)
    ! link 1: joint torque [N m], at a prismatic joint force [N]
    tau1 = 0.1524_rk*neg_f02_x - (s2*n2_x + c2*n2_y) + 1.4431532925_rk*qdd(1)
    tau(1) = tau1
    tau(2) = tau2
    tau(3) = tau3
    tau(4) = tau4
    tau(5) = tau5
    tau(6) = tau6
  end subroutine

  ! torques that hold the arm at rest
  ! 25 multiplications, 10 additions = 35; 0 unary minus; 6 sine/cosine
  pure subroutine stanford_gravity(q, tau) &
      bind(c, name="stanford_gravity_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: c2, s2, c4, s4, c5, s5, a2_x, a2_y, a4_x, neg_a4_y, a5_x, fc3_x, fc3_z, neg_nc3_y
    real(rk) :: neg_nc4_x, nc4_z, nc5_x, nc5_z, n05_x, n05_y, n4_x, n4_z, n04_x, n04_y, n3_y, n2_z
    real(rk) :: f02_x, neg_n02_y, n1_z

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    c4 = cos(q(4))
    s4 = sin(q(4))
    c5 = cos(q(5))
    s5 = sin(q(5))
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    a2_x = -9.8_rk*s2
    a2_y = -9.8_rk*c2
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_x = c4*a2_x
    neg_a4_y = s4*a2_x
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_x = c5*a4_x + s5*a2_y
    ! link 3: force that moves the link [N]
    fc3_x = -63.406_rk*s2
    fc3_z = 63.406_rk*c2
    ! link 3: moment that turns the link [N m]
    neg_nc3_y = 26.7543822_rk*s2
    ! link 4: moment that turns the link [N m]
    neg_nc4_x = 0.0571536_rk*c2
    nc4_z = 0.005832_rk*a4_x
    ! link 5: moment that turns the link [N m]
    nc5_x = 0.114912_rk*neg_a4_y
    nc5_z = 0.114912_rk*a5_x
    ! link 5: moment through the joint, along the axes that its turn starts from [N m]
    n05_x = c5*nc5_x
    n05_y = s5*nc5_x
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = n05_x - neg_nc4_x
    n4_z = nc4_z - n05_y
    ! link 4: moment through the joint, along the axes that its turn starts from [N m]
    n04_x = c4*n4_x - s4*nc5_z
    n04_y = s4*n4_x + c4*nc5_z
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_y = n04_y - neg_nc3_y
    ! link 2: moment through the joint, about the frame's origin [N m]
    n2_z = n3_y + q(3)*fc3_x
    ! link 2: force through the joint, along the axes that its turn starts from [N]
    f02_x = c2*fc3_x + s2*fc3_z
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    neg_n02_y = c2*n4_z - s2*n04_x
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = neg_n02_y - 0.1524_rk*f02_x
    tau(1) = n1_z
    tau(2) = n2_z
    tau(3) = fc3_z
    tau(4) = n4_z
    tau(5) = nc5_z
    tau(6) = 0.0_rk
  end subroutine

  ! torques at zero acceleration: Coriolis, centrifugal, gravity, friction
  ! 118 multiplications, 77 additions = 195; 6 unary minus; 8 sine/cosine
  pure subroutine stanford_bias(q, qd, tau) &
      bind(c, name="stanford_bias_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: c2, s2, c4, s4, c5, s5, c6, s6, ww1_zz, a2_z, t1, w2_x, w2_y, neg_a2_x, neg_a2_y
    real(rk) :: alpha2_x, neg_alpha2_y, ww2_xy, ww2_xx, ww2_zz, lam2_22, lam2_32, a3_z, t2, a3_x
    real(rk) :: a3_y, w4_x, w4_y, a4_x, a4_y, alpha4_x, alpha4_y, w4_z, ww4_yz, ww4_zx, ww4_xy
    real(rk) :: ww4_xx, ww4_yy, ww4_zz, lam4_12, lam4_13, neg_lam4_22, lam4_32, neg_lam4_33, w5_x
    real(rk) :: w5_y, a5_x, alpha5_y, w5_z, ww5_zx, ww5_xy, ww5_xx, ww5_zz, lam5_12, lam5_21
    real(rk) :: neg_lam5_22, neg_lam5_31, lam5_32, w6_x, w6_y, w6_z, ww6_yz, ww6_zx, nc2_x, nc2_y
    real(rk) :: neg_nc2_z, fc3_x, fc3_y, fc3_z, neg_nc3_x, nc3_y, neg_fc4_x, fc4_y, fc4_z, nc4_y
    real(rk) :: neg_nc4_x, nc4_z, fc5_x, fc5_y, neg_fc5_z, nc5_y, nc5_x, nc5_z, nc6_x, nc6_y, nc6_z
    real(rk) :: n06_x, n06_y, n5_x, n5_y, n5_z, f05_x, f05_y, n05_x, n05_y, n4_x, n4_y, n4_z, f4_x
    real(rk) :: f4_y, f4_z, f04_x, f04_y, n04_x, n04_y, n3_x, n3_y, f3_x, f3_y, f3_z, n2_x, n2_y
    real(rk) :: n2_z, neg_f02_x, n02_y, n1_z

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    c4 = cos(q(4))
    s4 = sin(q(4))
    c5 = cos(q(5))
    s5 = sin(q(5))
    c6 = cos(q(6))
    s6 = sin(q(6))
    ! link 1: products of the angular velocity [1/s^2]
    ww1_zz = qd(1)*qd(1)
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    a2_z = -0.1524_rk*ww1_zz
    t1 = -qd(1)
    ! link 2: angular velocity [rad/s]
    w2_x = t1*s2
    w2_y = t1*c2
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a2_x = 9.8_rk*s2
    neg_a2_y = 9.8_rk*c2
    ! link 2: angular acceleration [rad/s^2]
    alpha2_x = qd(2)*w2_y
    neg_alpha2_y = qd(2)*w2_x
    ! link 2: products of the angular velocity [1/s^2]
    ww2_xy = w2_x*w2_y
    ww2_xx = w2_x*w2_x
    ww2_zz = qd(2)*qd(2)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    lam2_22 = -ww2_xx - ww2_zz
    lam2_32 = 2.0_rk*alpha2_x
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_z = neg_a2_y + q(3)*lam2_22
    t2 = 2.0_rk*qd(3)
    a3_x = qd(2)*t2 - (neg_a2_x + q(3)*ww2_xy)
    a3_y = a2_z - q(3)*lam2_32 - w2_x*t2
    ! link 4: angular velocity [rad/s]
    w4_x = c4*w2_x + qd(2)*s4
    w4_y = qd(2)*c4 - s4*w2_x
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_x = c4*a3_x + s4*a3_y
    a4_y = c4*a3_y - s4*a3_x
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = c4*alpha2_x + qd(4)*w4_y
    alpha4_y = -qd(4)*w4_x - s4*alpha2_x
    ! link 4: angular velocity [rad/s]
    w4_z = qd(4) - w2_y
    ! link 4: products of the angular velocity [1/s^2]
    ww4_yz = w4_y*w4_z
    ww4_zx = w4_x*w4_z
    ww4_xy = w4_x*w4_y
    ww4_xx = w4_x*w4_x
    ww4_yy = w4_y*w4_y
    ww4_zz = w4_z*w4_z
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_12 = ww4_xy - neg_alpha2_y
    lam4_13 = alpha4_y + ww4_zx
    neg_lam4_22 = ww4_xx + ww4_zz
    lam4_32 = alpha4_x + ww4_yz
    neg_lam4_33 = ww4_xx + ww4_yy
    ! link 5: angular velocity [rad/s]
    w5_x = c5*w4_x - s5*w4_z
    w5_y = -c5*w4_z - s5*w4_x
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_x = c5*a4_x - s5*a3_z
    ! link 5: angular acceleration [rad/s^2]
    alpha5_y = -s5*alpha4_x - c5*neg_alpha2_y - qd(5)*w5_x
    ! link 5: angular velocity [rad/s]
    w5_z = qd(5) + w4_y
    ! link 5: products of the angular velocity [1/s^2]
    ww5_zx = w5_x*w5_z
    ww5_xy = w5_x*w5_y
    ww5_xx = w5_x*w5_x
    ww5_zz = w5_z*w5_z
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_12 = ww5_xy - alpha4_y
    lam5_21 = alpha4_y + ww5_xy
    neg_lam5_22 = ww5_xx + ww5_zz
    neg_lam5_31 = alpha5_y - ww5_zx
    lam5_32 = w5_y*(qd(5) + w5_z) - (s5*neg_alpha2_y - c5*alpha4_x)
    ! link 6: angular velocity [rad/s]
    w6_x = c6*w5_x + s6*w5_z
    w6_y = c6*w5_z - s6*w5_x
    w6_z = qd(6) - w5_y
    ! link 6: products of the angular velocity [1/s^2]
    ww6_yz = w6_y*w6_z
    ww6_zx = w6_x*w6_z
    ! link 2: moment that turns the link [N m]
    nc2_x = 8.5751065874_rk*alpha2_x
    nc2_y = -0.016_rk*neg_alpha2_y
    neg_nc2_z = 4.2795532937_rk*ww2_xy
    ! link 3: force that moves the link [N]
    fc3_x = 6.47_rk*a3_x - 2.730039_rk*ww2_xy
    fc3_y = 6.47_rk*a3_y - 5.460078_rk*alpha2_x
    fc3_z = 6.47_rk*a3_z + 2.730039_rk*lam2_22
    ! link 3: moment that turns the link [N m]
    neg_nc3_x = 2.730039_rk*a3_y
    nc3_y = 2.730039_rk*a3_x
    ! link 4: force that moves the link [N]
    neg_fc4_x = 0.005832_rk*lam4_12
    fc4_y = 0.005832_rk*neg_lam4_22
    fc4_z = -0.005832_rk*lam4_32
    ! link 4: moment that turns the link [N m]
    nc4_y = 5.36544e-05_rk*lam4_12
    neg_nc4_x = -0.0012314928_rk*lam4_32 - 5.36544e-05_rk*(neg_lam4_22 - neg_lam4_33) + &
        0.005832_rk*a3_z
    nc4_z = 0.005832_rk*a4_x - (0.0012314928_rk*lam4_12 + 5.36544e-05_rk*lam4_13)
    ! link 5: force that moves the link [N]
    fc5_x = -0.114912_rk*lam5_12
    fc5_y = 0.114912_rk*neg_lam5_22
    neg_fc5_z = 0.114912_rk*lam5_32
    ! link 5: moment that turns the link [N m]
    nc5_y = 0.0002_rk*neg_lam5_31
    nc5_x = 0.0301343144_rk*lam5_32 - 0.114912_rk*a4_y
    nc5_z = 0.0002_rk*lam5_21 - 0.0301343144_rk*lam5_12 + 0.114912_rk*a5_x
    ! link 6: moment that turns the link [N m]
    nc6_x = 0.0003_rk*ww6_yz
    nc6_y = -0.0003_rk*ww6_zx
    nc6_z = -0.0003_rk*alpha5_y
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    n06_x = c6*nc6_x - s6*nc6_y
    n06_y = s6*nc6_x + c6*nc6_y
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_x = nc5_x + n06_x
    n5_y = nc5_y - nc6_z
    n5_z = nc5_z + n06_y
    ! link 5: force through the joint, along the axes that its turn starts from [N]
    f05_x = c5*fc5_x - s5*fc5_y
    f05_y = s5*fc5_x + c5*fc5_y
    ! link 5: moment through the joint, along the axes that its turn starts from [N m]
    n05_x = c5*n5_x - s5*n5_y
    n05_y = s5*n5_x + c5*n5_y
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = n05_x - neg_nc4_x
    n4_y = nc4_y + n5_z
    n4_z = nc4_z - n05_y
    ! link 4: force through the joint [N]
    f4_x = f05_x - neg_fc4_x
    f4_y = fc4_y - neg_fc5_z
    f4_z = fc4_z - f05_y
    ! link 4: force through the joint, along the axes that its turn starts from [N]
    f04_x = c4*f4_x - s4*f4_y
    f04_y = s4*f4_x + c4*f4_y
    ! link 4: moment through the joint, along the axes that its turn starts from [N m]
    n04_x = c4*n4_x - s4*n4_y
    n04_y = s4*n4_x + c4*n4_y
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_x = n04_x - neg_nc3_x
    n3_y = nc3_y + n04_y
    ! link 3: force through the joint [N]
    f3_x = fc3_x + f04_x
    f3_y = fc3_y + f04_y
    f3_z = fc3_z + f4_z
    ! link 2: moment through the joint, about the frame's origin [N m]
    n2_x = n3_x + (nc2_x - q(3)*f3_y)
    n2_y = nc2_y - n4_z
    n2_z = n3_y + (q(3)*f3_x - neg_nc2_z)
    ! link 2: force through the joint, along the axes that its turn starts from [N]
    neg_f02_x = -s2*f3_z - c2*f3_x
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_y = s2*n2_x + c2*n2_y
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = 0.1524_rk*neg_f02_x - n02_y
    tau(1) = n1_z
    tau(2) = n2_z
    tau(3) = f3_z
    tau(4) = n4_z
    tau(5) = n5_z
    tau(6) = nc6_z
  end subroutine

  ! mass matrix, rotor inertias on its diagonal
  ! 56 multiplications, 45 additions = 101; 3 unary minus; 6 sine/cosine
  pure subroutine stanford_mass_matrix(q, M) &
      bind(c, name="stanford_mass_matrix_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(out) :: M(36)
    real(rk) :: c2, s2, c4, s4, c5, s5, nu5_x, neg_nu5_y, nu4_x, nu4_y, neg_nu2_y, h5_x, neg_h5_y
    real(rk) :: t1, k5_xx, k5_yy, k5_xy, fu4_x, fu4_y, neg_nu4_x, nu4_y_2, m2_5, fu2_x, neg_nu2_y_2
    real(rk) :: m1_5, nu3_z, h4_x, neg_h4_y, t2, t3, k4_xx, k4_yy, k4_xy, k4_xz, k4_yz, m4_4, m2_4
    real(rk) :: fu2_x_2, t4, neg_nu2_y_3, m1_4, t5, k3_zz, h3_z, t6, t7, k3_xx, k3_yy, m1_3, t8
    real(rk) :: h2_y, t9, k2_xx, k2_yz, m2_2, m1_2, m1_1, t10, t11

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    c4 = cos(q(4))
    s4 = sin(q(4))
    c5 = cos(q(5))
    s5 = sin(q(5))
    ! link 5: moment for a unit acceleration of a joint further out
    nu5_x = 0.0003_rk*s5
    neg_nu5_y = 0.0003_rk*c5
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_x = c4*nu5_x
    nu4_y = s4*nu5_x
    ! link 2: moment for a unit acceleration of a joint further out
    neg_nu2_y = c2*neg_nu5_y - s2*nu4_x
    ! link 5: first moment of the composite body, about the frame's origin [kg m]
    h5_x = 0.114912_rk*s5
    neg_h5_y = 0.114912_rk*c5
    t1 = 0.0296343144_rk*(c5*c5)
    ! link 5: second moment of the composite body [kg m^2]
    k5_xx = 0.0299843144_rk - t1
    k5_yy = t1 + 0.00035_rk
    k5_xy = -0.0296343144_rk*(c5*s5)
    ! link 4: force for a unit acceleration of a joint further out
    fu4_x = c4*neg_h5_y
    fu4_y = s4*neg_h5_y
    ! link 4: moment for a unit acceleration of a joint further out
    neg_nu4_x = 0.0303343144_rk*s4
    nu4_y_2 = 0.0303343144_rk*c4
    ! link 2: mass matrix, its row of this joint
    m2_5 = nu4_y_2 + q(3)*fu4_x
    ! link 2: force for a unit acceleration of a joint further out
    fu2_x = c2*fu4_x - s2*h5_x
    ! link 2: moment for a unit acceleration of a joint further out
    neg_nu2_y_2 = s2*(neg_nu4_x + q(3)*fu4_y)
    ! link 1: mass matrix, its row of this joint
    m1_5 = neg_nu2_y_2 - 0.1524_rk*fu2_x
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_z = 0.0313658072_rk - t1
    ! link 4: first moment of the composite body, about the frame's origin [kg m]
    h4_x = c4*h5_x + 0.005832_rk*s4
    neg_h4_y = 0.005832_rk*c4 - s4*h5_x
    t2 = t1 - 0.0286028216_rk
    t3 = c4*c4*t2
    ! link 4: second moment of the composite body [kg m^2]
    k4_xx = 0.0013814928_rk - t3
    k4_yy = k5_xx + t3
    k4_xy = t2*(-c4*s4)
    k4_xz = -5.36544e-05_rk*s4 - c4*k5_xy
    k4_yz = 5.36544e-05_rk*c4 - s4*k5_xy
    ! link 4: mass matrix, its row of this joint
    m4_4 = 0.1373658072_rk - t1
    ! link 2: mass matrix, its row of this joint
    m2_4 = q(3)*neg_h4_y - k4_yz
    ! link 2: force for a unit acceleration of a joint further out
    fu2_x_2 = c2*neg_h4_y
    t4 = k4_xz + q(3)*h4_x
    ! link 2: moment for a unit acceleration of a joint further out
    neg_nu2_y_3 = s2*t4 + c2*nu3_z
    ! link 1: mass matrix, its row of this joint
    m1_4 = neg_nu2_y_3 - 0.1524_rk*fu2_x_2
    t5 = k5_yy - k4_yy
    ! link 3: second moment of the composite body [kg m^2]
    k3_zz = k4_yy + t5
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    h3_z = neg_h5_y + 2.730039_rk
    t6 = k5_yy - t5
    t7 = t6 - k4_xx
    ! link 3: second moment of the composite body [kg m^2]
    k3_xx = t6 - t7
    k3_yy = k4_xx + t7
    ! link 1: mass matrix, its row of this joint
    m1_3 = s2*(neg_h4_y - 0.986028_rk)
    t8 = 6.47_rk*q(3)
    ! link 2: first moment of the composite body, about the frame's origin [kg m]
    h2_y = s2*h4_x - c2*(h3_z + t8)
    t9 = k3_zz + q(3)*(t8 + 2.0_rk*h3_z)
    ! link 2: second moment of the composite body [kg m^2]
    k2_xx = t9 + 4.2875532937_rk + (c2*c2*(k3_xx - t9 - 4.2795532937_rk) + t4*(2.0_rk*(c2*s2)))
    k2_yz = s2*k4_xy + c2*m2_4
    ! link 2: mass matrix, its row of this joint
    m2_2 = k3_xx + t9 + 6.4885532937_rk
    ! link 1: mass matrix, its row of this joint
    m1_2 = k2_yz + 0.1524_rk*h2_y
    m1_1 = k2_xx + (k3_yy + 0.1524_rk*(0.986028_rk - 2.0_rk*neg_h4_y)) + 1.4431532925_rk
    t10 = -h4_x
    t11 = -h5_x
    M(1) = m1_1
    M(2) = m1_2
    M(3) = m1_3
    M(4) = m1_4
    M(5) = m1_5
    M(6) = neg_nu2_y
    M(7) = m1_2
    M(8) = m2_2
    M(9) = t10
    M(10) = m2_4
    M(11) = m2_5
    M(12) = nu4_y
    M(13) = m1_3
    M(14) = t10
    M(15) = 7.252_rk
    M(16) = 0.0_rk
    M(17) = t11
    M(18) = 0.0_rk
    M(19) = m1_4
    M(20) = m2_4
    M(21) = 0.0_rk
    M(22) = m4_4
    M(23) = 0.0_rk
    M(24) = neg_nu5_y
    M(25) = m1_5
    M(26) = m2_5
    M(27) = t11
    M(28) = 0.0_rk
    M(29) = 0.1273343144_rk
    M(30) = 0.0_rk
    M(31) = neg_nu2_y
    M(32) = nu4_y
    M(33) = 0.0_rk
    M(34) = neg_nu5_y
    M(35) = 0.0_rk
    M(36) = 0.0203_rk
  end subroutine

  ! accelerations that the torques tau give
  ! 260 multiplications, 189 additions, 6 divisions = 455; 15 unary minus; 8 sine/cosine
  pure subroutine stanford_forward_dynamics(q, qd, tau, qdd) &
      bind(c, name="stanford_forward_dynamics_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(in) :: tau(6)
    real(rk), intent(out) :: qdd(6)
    real(rk) :: c2, s2, c4, s4, c5, s5, c6, s6, nu5_x, nu5_y, nu4_x, nu4_y, nu2_y, h5_x, neg_h5_y
    real(rk) :: t1, k5_xx, k5_yy, k5_xy, fu4_x, fu4_y, neg_nu4_x, nu4_y_2, m2_5, fu2_x, neg_nu2_y
    real(rk) :: m1_5, nu3_z, h4_x, neg_h4_y, t2, t3, k4_xx, k4_yy, k4_xy, k4_xz, k4_yz, m4_4, m2_4
    real(rk) :: fu2_x_2, t4, neg_nu2_y_2, m1_4, t5, k3_zz, h3_z, t6, t7, k3_xx, k3_yy, m1_3, t8
    real(rk) :: h2_y, t9, k2_xx, k2_yz, m2_2, m1_2, m1_1, ww1_zz, a2_z, t10, w2_x, w2_y, neg_a2_x
    real(rk) :: neg_a2_y, alpha2_x, neg_alpha2_y, ww2_xy, ww2_xx, ww2_zz, lam2_22, lam2_32, a3_z
    real(rk) :: t11, a3_x, a3_y, w4_x, w4_y, a4_x, a4_y, alpha4_x, alpha4_y, w4_z, ww4_yz, ww4_zx
    real(rk) :: ww4_xy, ww4_xx, ww4_yy, ww4_zz, lam4_12, lam4_13, neg_lam4_22, lam4_32, neg_lam4_33
    real(rk) :: w5_x, w5_y, a5_x, alpha5_y, w5_z, ww5_zx, ww5_xy, ww5_xx, ww5_zz, lam5_12, lam5_21
    real(rk) :: neg_lam5_22, lam5_31, lam5_32, w6_x, w6_y, w6_z, ww6_yz, ww6_zx, nc2_x, nc2_y
    real(rk) :: neg_nc2_z, fc3_x, fc3_y, fc3_z, neg_nc3_x, nc3_y, neg_fc4_x, fc4_y, fc4_z, nc4_y
    real(rk) :: neg_nc4_x, nc4_z, fc5_x, fc5_y, neg_fc5_z, neg_nc5_y, nc5_x, nc5_z, nc6_x, nc6_y
    real(rk) :: neg_nc6_z, n06_x, n06_y, n5_x, n5_y, n5_z, f05_x, f05_y, n05_x, n05_y, n4_x, n4_y
    real(rk) :: n4_z, f4_x, f4_y, f4_z, f04_x, f04_y, n04_x, n04_y, n3_x, n3_y, f3_x, f3_y, f3_z
    real(rk) :: n2_x, n2_y, n2_z, neg_f02_x, n02_y, n1_z, y1, ipivot1, l2_1, l3_1, l4_1, l5_1, l6_1
    real(rk) :: pivot2, ipivot2, ld3_2, l3_2, ld4_2, l4_2, ld5_2, l5_2, ld6_2, l6_2, pivot3
    real(rk) :: ipivot3, t12, ld4_3, l4_3, ld5_3, l5_3, ld6_3, l6_3, pivot4, ipivot4, t13, ld5_4
    real(rk) :: l5_4, ld6_4, l6_4, pivot5, ipivot5, ld6_5, l6_5, pivot6, ipivot6, y2, y3, y4, y5
    real(rk) :: y6, qdd6, qdd5, qdd4, qdd3, qdd2, qdd1

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    c4 = cos(q(4))
    s4 = sin(q(4))
    c5 = cos(q(5))
    s5 = sin(q(5))
    c6 = cos(q(6))
    s6 = sin(q(6))
    ! link 5: moment for a unit acceleration of a joint further out
    nu5_x = 0.0003_rk*s5
    nu5_y = -0.0003_rk*c5
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_x = c4*nu5_x
    nu4_y = s4*nu5_x
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y = s2*nu4_x + c2*nu5_y
    ! link 5: first moment of the composite body, about the frame's origin [kg m]
    h5_x = 0.114912_rk*s5
    neg_h5_y = 0.114912_rk*c5
    t1 = 0.0296343144_rk*(c5*c5)
    ! link 5: second moment of the composite body [kg m^2]
    k5_xx = 0.0299843144_rk - t1
    k5_yy = t1 + 0.00035_rk
    k5_xy = -0.0296343144_rk*(c5*s5)
    ! link 4: force for a unit acceleration of a joint further out
    fu4_x = c4*neg_h5_y
    fu4_y = s4*neg_h5_y
    ! link 4: moment for a unit acceleration of a joint further out
    neg_nu4_x = 0.0303343144_rk*s4
    nu4_y_2 = 0.0303343144_rk*c4
    ! link 2: mass matrix, its row of this joint
    m2_5 = nu4_y_2 + q(3)*fu4_x
    ! link 2: force for a unit acceleration of a joint further out
    fu2_x = c2*fu4_x - s2*h5_x
    ! link 2: moment for a unit acceleration of a joint further out
    neg_nu2_y = s2*(neg_nu4_x + q(3)*fu4_y)
    ! link 1: mass matrix, its row of this joint
    m1_5 = neg_nu2_y - 0.1524_rk*fu2_x
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_z = 0.0313658072_rk - t1
    ! link 4: first moment of the composite body, about the frame's origin [kg m]
    h4_x = c4*h5_x + 0.005832_rk*s4
    neg_h4_y = 0.005832_rk*c4 - s4*h5_x
    t2 = t1 - 0.0286028216_rk
    t3 = c4*c4*t2
    ! link 4: second moment of the composite body [kg m^2]
    k4_xx = 0.0013814928_rk - t3
    k4_yy = k5_xx + t3
    k4_xy = t2*(-c4*s4)
    k4_xz = -5.36544e-05_rk*s4 - c4*k5_xy
    k4_yz = 5.36544e-05_rk*c4 - s4*k5_xy
    ! link 4: mass matrix, its row of this joint
    m4_4 = 0.1373658072_rk - t1
    ! link 2: mass matrix, its row of this joint
    m2_4 = q(3)*neg_h4_y - k4_yz
    ! link 2: force for a unit acceleration of a joint further out
    fu2_x_2 = c2*neg_h4_y
    t4 = k4_xz + q(3)*h4_x
    ! link 2: moment for a unit acceleration of a joint further out
    neg_nu2_y_2 = s2*t4 + c2*nu3_z
    ! link 1: mass matrix, its row of this joint
    m1_4 = neg_nu2_y_2 - 0.1524_rk*fu2_x_2
    t5 = k5_yy - k4_yy
    ! link 3: second moment of the composite body [kg m^2]
    k3_zz = k4_yy + t5
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    h3_z = neg_h5_y + 2.730039_rk
    t6 = k5_yy - t5
    t7 = t6 - k4_xx
    ! link 3: second moment of the composite body [kg m^2]
    k3_xx = t6 - t7
    k3_yy = k4_xx + t7
    ! link 1: mass matrix, its row of this joint
    m1_3 = s2*(neg_h4_y - 0.986028_rk)
    t8 = 6.47_rk*q(3)
    ! link 2: first moment of the composite body, about the frame's origin [kg m]
    h2_y = s2*h4_x - c2*(h3_z + t8)
    t9 = k3_zz + q(3)*(t8 + 2.0_rk*h3_z)
    ! link 2: second moment of the composite body [kg m^2]
    k2_xx = t9 + 4.2875532937_rk + (c2*c2*(k3_xx - t9 - 4.2795532937_rk) + t4*(2.0_rk*(c2*s2)))
    k2_yz = s2*k4_xy + c2*m2_4
    ! link 2: mass matrix, its row of this joint
    m2_2 = k3_xx + t9 + 6.4885532937_rk
    ! link 1: mass matrix, its row of this joint
    m1_2 = k2_yz + 0.1524_rk*h2_y
    m1_1 = k2_xx + (k3_yy + 0.1524_rk*(0.986028_rk - 2.0_rk*neg_h4_y)) + 1.4431532925_rk
    ! link 1: products of the angular velocity [1/s^2]
    ww1_zz = qd(1)*qd(1)
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    a2_z = -0.1524_rk*ww1_zz
    t10 = -qd(1)
    ! link 2: angular velocity [rad/s]
    w2_x = t10*s2
    w2_y = t10*c2
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a2_x = 9.8_rk*s2
    neg_a2_y = 9.8_rk*c2
    ! link 2: angular acceleration [rad/s^2]
    alpha2_x = qd(2)*w2_y
    neg_alpha2_y = qd(2)*w2_x
    ! link 2: products of the angular velocity [1/s^2]
    ww2_xy = w2_x*w2_y
    ww2_xx = w2_x*w2_x
    ww2_zz = qd(2)*qd(2)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    lam2_22 = -ww2_xx - ww2_zz
    lam2_32 = 2.0_rk*alpha2_x
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_z = neg_a2_y + q(3)*lam2_22
    t11 = 2.0_rk*qd(3)
    a3_x = qd(2)*t11 - (neg_a2_x + q(3)*ww2_xy)
    a3_y = a2_z - q(3)*lam2_32 - w2_x*t11
    ! link 4: angular velocity [rad/s]
    w4_x = c4*w2_x + qd(2)*s4
    w4_y = qd(2)*c4 - s4*w2_x
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_x = c4*a3_x + s4*a3_y
    a4_y = c4*a3_y - s4*a3_x
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = c4*alpha2_x + qd(4)*w4_y
    alpha4_y = -qd(4)*w4_x - s4*alpha2_x
    ! link 4: angular velocity [rad/s]
    w4_z = qd(4) - w2_y
    ! link 4: products of the angular velocity [1/s^2]
    ww4_yz = w4_y*w4_z
    ww4_zx = w4_x*w4_z
    ww4_xy = w4_x*w4_y
    ww4_xx = w4_x*w4_x
    ww4_yy = w4_y*w4_y
    ww4_zz = w4_z*w4_z
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_12 = ww4_xy - neg_alpha2_y
    lam4_13 = alpha4_y + ww4_zx
    neg_lam4_22 = ww4_xx + ww4_zz
    lam4_32 = alpha4_x + ww4_yz
    neg_lam4_33 = ww4_xx + ww4_yy
    ! link 5: angular velocity [rad/s]
    w5_x = c5*w4_x - s5*w4_z
    w5_y = -c5*w4_z - s5*w4_x
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_x = c5*a4_x - s5*a3_z
    ! link 5: angular acceleration [rad/s^2]
    alpha5_y = -s5*alpha4_x - c5*neg_alpha2_y - qd(5)*w5_x
    ! link 5: angular velocity [rad/s]
    w5_z = qd(5) + w4_y
    ! link 5: products of the angular velocity [1/s^2]
    ww5_zx = w5_x*w5_z
    ww5_xy = w5_x*w5_y
    ww5_xx = w5_x*w5_x
    ww5_zz = w5_z*w5_z
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_12 = ww5_xy - alpha4_y
    lam5_21 = alpha4_y + ww5_xy
    neg_lam5_22 = ww5_xx + ww5_zz
    lam5_31 = ww5_zx - alpha5_y
    lam5_32 = w5_y*(qd(5) + w5_z) - (s5*neg_alpha2_y - c5*alpha4_x)
    ! link 6: angular velocity [rad/s]
    w6_x = c6*w5_x + s6*w5_z
    w6_y = c6*w5_z - s6*w5_x
    w6_z = qd(6) - w5_y
    ! link 6: products of the angular velocity [1/s^2]
    ww6_yz = w6_y*w6_z
    ww6_zx = w6_x*w6_z
    ! link 2: moment that turns the link [N m]
    nc2_x = 8.5751065874_rk*alpha2_x
    nc2_y = -0.016_rk*neg_alpha2_y
    neg_nc2_z = 4.2795532937_rk*ww2_xy
    ! link 3: force that moves the link [N]
    fc3_x = 6.47_rk*a3_x - 2.730039_rk*ww2_xy
    fc3_y = 6.47_rk*a3_y - 5.460078_rk*alpha2_x
    fc3_z = 6.47_rk*a3_z + 2.730039_rk*lam2_22
    ! link 3: moment that turns the link [N m]
    neg_nc3_x = 2.730039_rk*a3_y
    nc3_y = 2.730039_rk*a3_x
    ! link 4: force that moves the link [N]
    neg_fc4_x = 0.005832_rk*lam4_12
    fc4_y = 0.005832_rk*neg_lam4_22
    fc4_z = -0.005832_rk*lam4_32
    ! link 4: moment that turns the link [N m]
    nc4_y = 5.36544e-05_rk*lam4_12
    neg_nc4_x = -0.0012314928_rk*lam4_32 - 5.36544e-05_rk*(neg_lam4_22 - neg_lam4_33) + &
        0.005832_rk*a3_z
    nc4_z = 0.005832_rk*a4_x - (0.0012314928_rk*lam4_12 + 5.36544e-05_rk*lam4_13)
    ! link 5: force that moves the link [N]
    fc5_x = -0.114912_rk*lam5_12
    fc5_y = 0.114912_rk*neg_lam5_22
    neg_fc5_z = 0.114912_rk*lam5_32
    ! link 5: moment that turns the link [N m]
    neg_nc5_y = 0.0002_rk*lam5_31
    nc5_x = 0.0301343144_rk*lam5_32 - 0.114912_rk*a4_y
    nc5_z = 0.0002_rk*lam5_21 - 0.0301343144_rk*lam5_12 + 0.114912_rk*a5_x
    ! link 6: moment that turns the link [N m]
    nc6_x = 0.0003_rk*ww6_yz
    nc6_y = -0.0003_rk*ww6_zx
    neg_nc6_z = 0.0003_rk*alpha5_y
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    n06_x = c6*nc6_x - s6*nc6_y
    n06_y = s6*nc6_x + c6*nc6_y
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_x = nc5_x + n06_x
    n5_y = neg_nc6_z - neg_nc5_y
    n5_z = nc5_z + n06_y
    ! link 5: force through the joint, along the axes that its turn starts from [N]
    f05_x = c5*fc5_x - s5*fc5_y
    f05_y = s5*fc5_x + c5*fc5_y
    ! link 5: moment through the joint, along the axes that its turn starts from [N m]
    n05_x = c5*n5_x - s5*n5_y
    n05_y = s5*n5_x + c5*n5_y
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = n05_x - neg_nc4_x
    n4_y = nc4_y + n5_z
    n4_z = nc4_z - n05_y
    ! link 4: force through the joint [N]
    f4_x = f05_x - neg_fc4_x
    f4_y = fc4_y - neg_fc5_z
    f4_z = fc4_z - f05_y
    ! link 4: force through the joint, along the axes that its turn starts from [N]
    f04_x = c4*f4_x - s4*f4_y
    f04_y = s4*f4_x + c4*f4_y
    ! link 4: moment through the joint, along the axes that its turn starts from [N m]
    n04_x = c4*n4_x - s4*n4_y
    n04_y = s4*n4_x + c4*n4_y
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_x = n04_x - neg_nc3_x
    n3_y = nc3_y + n04_y
    ! link 3: force through the joint [N]
    f3_x = fc3_x + f04_x
    f3_y = fc3_y + f04_y
    f3_z = fc3_z + f4_z
    ! link 2: moment through the joint, about the frame's origin [N m]
    n2_x = n3_x + (nc2_x - q(3)*f3_y)
    n2_y = nc2_y - n4_z
    n2_z = n3_y + (q(3)*f3_x - neg_nc2_z)
    ! link 2: force through the joint, along the axes that its turn starts from [N]
    neg_f02_x = -s2*f3_z - c2*f3_x
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_y = s2*n2_x + c2*n2_y
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = 0.1524_rk*neg_f02_x - n02_y
    ! link 1: forward substitution
    y1 = tau(1) - n1_z
    ! factorisation M = L D L^T
    ipivot1 = 1.0_rk / m1_1
    l2_1 = m1_2*ipivot1
    l3_1 = m1_3*ipivot1
    l4_1 = m1_4*ipivot1
    l5_1 = m1_5*ipivot1
    l6_1 = -nu2_y*ipivot1
    pivot2 = m2_2 - m1_2*l2_1
    ipivot2 = 1.0_rk / pivot2
    ld3_2 = -h4_x - m1_2*l3_1
    l3_2 = ipivot2*ld3_2
    ld4_2 = m2_4 - m1_2*l4_1
    l4_2 = ipivot2*ld4_2
    ld5_2 = m2_5 - m1_2*l5_1
    l5_2 = ipivot2*ld5_2
    ld6_2 = nu4_y - m1_2*l6_1
    l6_2 = ipivot2*ld6_2
    pivot3 = 7.252_rk - m1_3*l3_1 - ld3_2*l3_2
    ipivot3 = 1.0_rk / pivot3
    t12 = -ld3_2
    ld4_3 = t12*l4_2 - m1_3*l4_1
    l4_3 = ipivot3*ld4_3
    ld5_3 = -m1_3*l5_1 - h5_x - ld3_2*l5_2
    l5_3 = ipivot3*ld5_3
    ld6_3 = t12*l6_2 - m1_3*l6_1
    l6_3 = ipivot3*ld6_3
    pivot4 = -ld4_3*l4_3 - (ld4_2*l4_2 - (m4_4 - m1_4*l4_1))
    ipivot4 = 1.0_rk / pivot4
    t13 = -ld4_2
    ld5_4 = t13*l5_2 - m1_4*l5_1 - ld4_3*l5_3
    l5_4 = ipivot4*ld5_4
    ld6_4 = t13*l6_2 - (nu5_y + m1_4*l6_1) - ld4_3*l6_3
    l6_4 = ipivot4*ld6_4
    pivot5 = 0.1273343144_rk - m1_5*l5_1 - ld5_2*l5_2 - ld5_3*l5_3 - ld5_4*l5_4
    ipivot5 = 1.0_rk / pivot5
    ld6_5 = -(m1_5*l6_1 + ld5_2*l6_2 + ld5_3*l6_3) - ld5_4*l6_4
    l6_5 = ipivot5*ld6_5
    pivot6 = nu2_y*l6_1 + 0.0203_rk - ld6_2*l6_2 - ld6_3*l6_3 - ld6_4*l6_4 - ld6_5*l6_5
    ipivot6 = 1.0_rk / pivot6
    ! link 2: forward substitution
    y2 = tau(2) - n2_z - y1*l2_1
    ! link 3: forward substitution
    y3 = tau(3) - f3_z - y1*l3_1 - l3_2*y2
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
    qdd3 = ipivot3*y3 - l4_3*qdd4 - l5_3*qdd5 - l6_3*qdd6
    ! link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd2 = ipivot2*y2 - l3_2*qdd3 - l4_2*qdd4 - l5_2*qdd5 - l6_2*qdd6
    ! link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd1 = -l6_1*qdd6 - (l2_1*qdd2 - y1*ipivot1 + l3_1*qdd3 + l4_1*qdd4 + l5_1*qdd5)
    qdd(1) = qdd1
    qdd(2) = qdd2
    qdd(3) = qdd3
    qdd(4) = qdd4
    qdd(5) = qdd5
    qdd(6) = qdd6
  end subroutine
end module
