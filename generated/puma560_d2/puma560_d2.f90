! puma560_d2: PUMA 560, the set of the thesis's program D.2
! Numbers: the 1990 thesis, program D.2 (reduce_puma6), with z4 = -0.019 as listing D.3.4 uses it
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
!   inverse_dynamics: 167 multiplications, 125 additions = 292; 4 unary minus; 10 sine/cosine
!   gravity: 19 multiplications, 8 additions = 27; 1 unary minus; 7 sine/cosine
!   bias: 154 multiplications, 100 additions = 254; 6 unary minus; 10 sine/cosine
!   mass_matrix: 101 multiplications, 79 additions = 180; 3 unary minus; 8 sine/cosine
!   forward_dynamics: 341 multiplications, 248 additions, 6 divisions = 595; 13 unary minus; 12
!       sine/cosine
module puma560_d2_dynamics
  use, intrinsic :: iso_c_binding, only: rk => c_double
  implicit none
  private

  public :: puma560_d2_inverse_dynamics
  public :: puma560_d2_gravity
  public :: puma560_d2_bias
  public :: puma560_d2_mass_matrix
  public :: puma560_d2_forward_dynamics

contains

  ! torques that give the accelerations qdd
  ! 167 multiplications, 125 additions = 292; 4 unary minus; 10 sine/cosine
  pure subroutine puma560_d2_inverse_dynamics(q, qd, qdd, tau) &
      bind(c, name="puma560_d2_inverse_dynamics_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(in) :: qdd(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: c2, s2, c4, s4, c5, s5, c6, s6
    real(rk) :: angle23, c23, s23, w3_z, alpha3_z, ww1_zz, a2_z, t1
    real(rk) :: w2_x, w2_y, t2, a2_y, ww2_yz, ww2_zx, alpha2_x, neg_alpha2_y
    real(rk) :: ww2_xy, ww2_xx, ww2_yy, ww2_zz, neg_lam2_11, lam2_12, lam2_21, lam2_23
    real(rk) :: lam2_31, lam2_32, neg_lam2_33, a3_z, w3_x, w3_y, t3, t4
    real(rk) :: t5, t6, neg_a3_x, a3_y, ww3_yz, ww3_zx, alpha3_x, neg_alpha3_y
    real(rk) :: ww3_xy, ww3_xx, ww3_yy, ww3_zz, neg_lam3_11, lam3_12, lam3_21, neg_lam3_22
    real(rk) :: lam3_31, lam3_32, a4_z, w4_x, w4_y, t7, t8, a4_x
    real(rk) :: a4_y, alpha4_x, alpha4_y, alpha4_z, w4_z, ww4_yz, ww4_zx, ww4_xy
    real(rk) :: w5_x, t9, w5_y, a5_x, alpha5_y, alpha5_z, w5_z, ww5_zx
    real(rk) :: ww5_xy, ww5_xx, ww5_zz, lam5_12, lam5_21, neg_lam5_22, lam5_31, lam5_32
    real(rk) :: w6_x, w6_y, alpha6_z, w6_z, ww6_yz, ww6_zx, nc1_z, fc2_x
    real(rk) :: fc2_y, neg_nc2_x, nc2_y, nc2_z, fc3_x, fc3_y, fc3_z, nc3_x
    real(rk) :: nc3_y, nc3_z, nc4_y, nc4_x, nc4_z, fc5_x, fc5_y, fc5_z
    real(rk) :: nc5_y, nc5_x, nc5_z, nc6_x, nc6_y, nc6_z, n06_x, n06_y
    real(rk) :: n5_x, n5_y, n5_z, f05_x, f05_y, n05_x, n05_y, n4_x
    real(rk) :: n4_y, n4_z, f04_x, f04_y, n04_x, n04_y, n3_x, n3_y
    real(rk) :: n3_z, f3_x, f3_y, f3_z, f03_x, f03_y, n03_y, t10
    real(rk) :: n02_y, n02_z, f02_x, n1_z

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
    lam2_21 = qdd(2) + ww2_xy
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
    ww3_zz = w3_z*w3_z
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_11 = ww3_yy + ww3_zz
    lam3_12 = ww3_xy - alpha3_z
    lam3_21 = alpha3_z + ww3_xy
    neg_lam3_22 = ww3_xx + ww3_zz
    lam3_31 = ww3_zx + neg_alpha3_y
    lam3_32 = ww3_yz + alpha3_x
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_z = 0.0203_rk*lam3_21 - 0.4331_rk*neg_lam3_22 - a3_y
    ! link 4: angular velocity [rad/s]
    w4_x = c4*w3_x + s4*w3_z
    w4_y = c4*w3_z - s4*w3_x
    t7 = neg_a3_x + (0.4331_rk*lam3_12 - 0.0203_rk*neg_lam3_11)
    t8 = 0.0203_rk*lam3_31 + 0.4331_rk*lam3_32 - a3_z
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_x = -(c4*t7) - s4*t8
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
    ! link 5: angular velocity [rad/s]
    w5_x = c5*w4_x - s5*w4_z
    t9 = -s5
    w5_y = t9*w4_x - c5*w4_z
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_x = c5*a4_x - s5*a4_z
    ! link 5: angular acceleration [rad/s^2]
    alpha5_y = t9*alpha4_x - c5*alpha4_z - qd(5)*w5_x
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
    lam5_31 = ww5_zx - alpha5_y
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
    ! link 1: moment that turns the link [N m]
    nc1_z = -0.0651082895_rk*qdd(1)
    ! link 2: force that moves the link [N]
    fc2_x = -1.42919_rk*neg_lam2_11
    fc2_y = 1.42919_rk*lam2_21
    ! link 2: moment that turns the link [N m]
    neg_nc2_x = -2.42815_rk*lam2_32 - 0.11051088_rk*lam2_21
    nc2_y = 0.11051088_rk*(neg_lam2_11 - neg_lam2_33) - 4.110437602_rk*lam2_31 + &
        0.214521419_rk*ww1_zz
    nc2_z = 4.110437602_rk*lam2_21 - 2.42815_rk*lam2_12 - 0.11051088_rk*lam2_23 + 1.42919_rk*a2_y
    ! link 3: force that moves the link [N]
    fc3_x = 0.025375_rk*neg_lam3_11 - 0.861795_rk*lam3_12
    fc3_y = 0.861795_rk*neg_lam3_22 - 0.025375_rk*lam3_21
    fc3_z = -0.025375_rk*lam3_31 - 0.861795_rk*lam3_32
    ! link 3: moment that turns the link [N m]
    nc3_x = -0.861795_rk*a3_z - (-0.7429401365_rk*lam3_32 - 0.0106736385_rk*lam3_31)
    nc3_y = -0.4439651125_rk*lam3_31 - 0.0106736385_rk*lam3_32 + 0.025375_rk*a3_z
    nc3_z = 0.4439651125_rk*lam3_21 - 0.7429401365_rk*lam3_12 + 0.0106736385_rk*(neg_lam3_11 - &
        neg_lam3_22) - (0.025375_rk*a3_y + 0.861795_rk*neg_a3_x)
    ! link 4: moment that turns the link [N m]
    nc4_y = -0.2013_rk*ww4_zx
    nc4_x = 0.1119_rk*ww4_yz - 0.0894_rk*alpha4_x
    nc4_z = 0.0894_rk*ww4_xy + 0.1119_rk*alpha4_z
    ! link 5: force that moves the link [N]
    fc5_x = -0.00288_rk*lam5_12
    fc5_y = 0.00288_rk*neg_lam5_22
    fc5_z = -0.00288_rk*lam5_32
    ! link 5: moment that turns the link [N m]
    nc5_y = -0.0897_rk*lam5_31
    nc5_x = 0.09003436_rk*lam5_32 - 0.00288_rk*a4_y
    nc5_z = 0.0897_rk*lam5_21 - 0.09003436_rk*lam5_12 + 0.00288_rk*a5_x
    ! link 6: moment that turns the link [N m]
    nc6_x = 0.193_rk*ww6_yz
    nc6_y = -0.193_rk*ww6_zx
    nc6_z = 0.193_rk*alpha6_z
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
    n4_x = nc4_x + n05_x
    n4_y = nc4_y + n5_z
    n4_z = nc4_z - n05_y
    ! link 4: force through the joint, along the axes that its turn starts from [N]
    f04_x = c4*f05_x - s4*fc5_z
    f04_y = s4*f05_x + c4*fc5_z
    ! link 4: moment through the joint, along the axes that its turn starts from [N m]
    n04_x = c4*n4_x - s4*n4_y
    n04_y = s4*n4_x + c4*n4_y
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_x = n04_x - (0.4331_rk*f04_y - nc3_x)
    n3_y = nc3_y + 0.0203_rk*f04_y - n4_z
    n3_z = n04_y + (nc3_z - (0.0203_rk*f05_y - 0.4331_rk*f04_x))
    ! link 3: force through the joint [N]
    f3_x = fc3_x + f04_x
    f3_y = fc3_y + f05_y
    f3_z = fc3_z + f04_y
    ! link 3: force through the joint, along the axes that its turn starts from [N]
    f03_x = c23*f3_x - s23*f3_y
    f03_y = s23*f3_x + c23*f3_y
    ! link 3: moment through the joint, along the axes that its turn starts from [N m]
    n03_y = s23*n3_x + c23*n3_y
    t10 = 0.4318_rk*c2
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_y = n03_y - (s2*neg_nc2_x - c2*nc2_y + f3_z*t10)
    n02_z = n3_z + (nc2_z + (f03_y*t10 - f03_x*(0.4318_rk*s2)))
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
  ! 19 multiplications, 8 additions = 27; 1 unary minus; 7 sine/cosine
  pure subroutine puma560_d2_gravity(q, tau) &
      bind(c, name="puma560_d2_gravity_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: c2, c4, s4, c5, s5, angle23, c23, s23
    real(rk) :: a3_x, a3_y, a4_x, neg_a4_y, a5_x, nc2_z, nc3_z, nc5_x
    real(rk) :: nc5_z, n05_x, n05_y, neg_n04_x, n04_y, n3_z, neg_n03_y, n02_z
    real(rk) :: t1

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    c4 = cos(q(4))
    s4 = sin(q(4))
    c5 = cos(q(5))
    s5 = sin(q(5))
    angle23 = q(2) + q(3)
    c23 = cos(angle23)
    s23 = sin(angle23)
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_x = -9.8_rk*s23
    a3_y = -9.8_rk*c23
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_x = c4*a3_x
    neg_a4_y = s4*a3_x
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_x = c5*a4_x + s5*a3_y
    ! link 2: moment that turns the link [N m]
    nc2_z = -14.006062_rk*c2
    ! link 3: moment that turns the link [N m]
    nc3_z = 0.248675_rk*c23 - 8.445591_rk*s23
    ! link 5: moment that turns the link [N m]
    nc5_x = 0.00288_rk*neg_a4_y
    nc5_z = 0.00288_rk*a5_x
    ! link 5: moment through the joint, along the axes that its turn starts from [N m]
    n05_x = c5*nc5_x
    n05_y = s5*nc5_x
    ! link 4: moment through the joint, along the axes that its turn starts from [N m]
    neg_n04_x = s4*nc5_z - c4*n05_x
    n04_y = s4*n05_x + c4*nc5_z
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_z = nc3_z + n04_y
    ! link 3: moment through the joint, along the axes that its turn starts from [N m]
    neg_n03_y = s23*neg_n04_x - c23*n05_y
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_z = nc2_z + n3_z
    t1 = -n05_y
    tau(1) = neg_n03_y
    tau(2) = n02_z
    tau(3) = n3_z
    tau(4) = t1
    tau(5) = nc5_z
    tau(6) = 0.0_rk
  end subroutine

  ! torques at zero acceleration: Coriolis, centrifugal, gravity, friction
  ! 154 multiplications, 100 additions = 254; 6 unary minus; 10 sine/cosine
  pure subroutine puma560_d2_bias(q, qd, tau) &
      bind(c, name="puma560_d2_bias_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: c2, s2, c4, s4, c5, s5, c6, s6
    real(rk) :: angle23, c23, s23, w3_z, ww1_zz, a2_z, neg_w2_x, neg_w2_y
    real(rk) :: neg_alpha2_x, alpha2_y, ww2_xy, ww2_xx, ww2_yy, ww2_zz, neg_lam2_11, neg_lam2_33
    real(rk) :: a3_z, t1, w3_x, w3_y, t2, t3, t4, t5
    real(rk) :: neg_a3_x, a3_y, alpha3_x, alpha3_y, ww3_xy, ww3_xx, ww3_yy, ww3_zz
    real(rk) :: neg_lam3_11, neg_lam3_22, a4_z, w4_x, w4_y, t6, t7, a4_x
    real(rk) :: a4_y, alpha4_x, alpha4_y, w4_z, ww4_yz, ww4_zx, ww4_xy, w5_x
    real(rk) :: w5_y, a5_x, alpha5_y, w5_z, ww5_zx, ww5_xy, ww5_xx, ww5_zz
    real(rk) :: lam5_12, lam5_21, neg_lam5_22, lam5_31, lam5_32, w6_x, w6_y, w6_z
    real(rk) :: ww6_yz, ww6_zx, fc2_x, fc2_y, neg_nc2_x, nc2_y, nc2_z, fc3_x
    real(rk) :: fc3_y, fc3_z, nc3_x, nc3_y, neg_nc3_z, nc4_y, nc4_x, nc4_z
    real(rk) :: fc5_x, fc5_y, fc5_z, nc5_y, nc5_x, nc5_z, nc6_x, nc6_y
    real(rk) :: nc6_z, n06_x, n06_y, n5_x, n5_y, n5_z, f05_x, f05_y
    real(rk) :: n05_x, n05_y, n4_x, n4_y, n4_z, f04_x, f04_y, n04_x
    real(rk) :: n04_y, n3_x, n3_y, n3_z, f3_x, f3_y, f3_z, f03_x
    real(rk) :: f03_y, n03_y, t8, n02_y, n02_z, f02_x, n1_z

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
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_z = 0.0203_rk*ww3_xy - 0.4331_rk*neg_lam3_22 - a3_y
    ! link 4: angular velocity [rad/s]
    w4_x = c4*w3_x + s4*w3_z
    w4_y = c4*w3_z - s4*w3_x
    t6 = neg_a3_x + (0.4331_rk*ww3_xy - 0.0203_rk*neg_lam3_11)
    t7 = 0.8662_rk*alpha3_x - 0.0406_rk*alpha3_y - a3_z
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_x = -(c4*t6) - s4*t7
    a4_y = s4*t6 - c4*t7
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = c4*alpha3_x + qd(4)*w4_y
    alpha4_y = -s4*alpha3_x - qd(4)*w4_x
    ! link 4: angular velocity [rad/s]
    w4_z = qd(4) - w3_y
    ! link 4: products of the angular velocity [1/s^2]
    ww4_yz = w4_y*w4_z
    ww4_zx = w4_x*w4_z
    ww4_xy = w4_x*w4_y
    ! link 5: angular velocity [rad/s]
    w5_x = c5*w4_x - s5*w4_z
    w5_y = -s5*w4_x - c5*w4_z
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_x = c5*a4_x - s5*a4_z
    ! link 5: angular acceleration [rad/s^2]
    alpha5_y = c5*alpha3_y - s5*alpha4_x - qd(5)*w5_x
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
    lam5_32 = w5_y*(qd(5) + w5_z) - (-c5*alpha4_x - s5*alpha3_y)
    ! link 6: angular velocity [rad/s]
    w6_x = c6*w5_x + s6*w5_z
    w6_y = c6*w5_z - s6*w5_x
    w6_z = qd(6) - w5_y
    ! link 6: products of the angular velocity [1/s^2]
    ww6_yz = w6_y*w6_z
    ww6_zx = w6_x*w6_z
    ! link 2: force that moves the link [N]
    fc2_x = -1.42919_rk*neg_lam2_11
    fc2_y = 1.42919_rk*ww2_xy
    ! link 2: moment that turns the link [N m]
    neg_nc2_x = 4.8563_rk*neg_alpha2_x - 0.11051088_rk*ww2_xy
    nc2_y = 8.220875204_rk*alpha2_y + 0.11051088_rk*(neg_lam2_11 - neg_lam2_33) + &
        0.214521419_rk*ww1_zz
    nc2_z = 1.682287602_rk*ww2_xy - 14.006062_rk*c2
    ! link 3: force that moves the link [N]
    fc3_x = 0.025375_rk*neg_lam3_11 - 0.861795_rk*ww3_xy
    fc3_y = 0.861795_rk*neg_lam3_22 - 0.025375_rk*ww3_xy
    fc3_z = 0.05075_rk*alpha3_y - 1.72359_rk*alpha3_x
    ! link 3: moment that turns the link [N m]
    nc3_x = -0.861795_rk*a3_z - (0.021347277_rk*alpha3_y - 1.485880273_rk*alpha3_x)
    nc3_y = 0.887930225_rk*alpha3_y - 0.021347277_rk*alpha3_x + 0.025375_rk*a3_z
    neg_nc3_z = 0.298975024_rk*ww3_xy - 0.0106736385_rk*(neg_lam3_11 - neg_lam3_22) + &
        (0.025375_rk*a3_y + 0.861795_rk*neg_a3_x)
    ! link 4: moment that turns the link [N m]
    nc4_y = -0.2013_rk*ww4_zx
    nc4_x = 0.1119_rk*ww4_yz - 0.0894_rk*alpha4_x
    nc4_z = 0.0894_rk*ww4_xy - 0.1119_rk*alpha3_y
    ! link 5: force that moves the link [N]
    fc5_x = -0.00288_rk*lam5_12
    fc5_y = 0.00288_rk*neg_lam5_22
    fc5_z = -0.00288_rk*lam5_32
    ! link 5: moment that turns the link [N m]
    nc5_y = -0.0897_rk*lam5_31
    nc5_x = 0.09003436_rk*lam5_32 - 0.00288_rk*a4_y
    nc5_z = 0.0897_rk*lam5_21 - 0.09003436_rk*lam5_12 + 0.00288_rk*a5_x
    ! link 6: moment that turns the link [N m]
    nc6_x = 0.193_rk*ww6_yz
    nc6_y = -0.193_rk*ww6_zx
    nc6_z = -0.193_rk*alpha5_y
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
    n4_x = nc4_x + n05_x
    n4_y = nc4_y + n5_z
    n4_z = nc4_z - n05_y
    ! link 4: force through the joint, along the axes that its turn starts from [N]
    f04_x = c4*f05_x - s4*fc5_z
    f04_y = s4*f05_x + c4*fc5_z
    ! link 4: moment through the joint, along the axes that its turn starts from [N m]
    n04_x = c4*n4_x - s4*n4_y
    n04_y = s4*n4_x + c4*n4_y
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_x = n04_x - (0.4331_rk*f04_y - nc3_x)
    n3_y = nc3_y + 0.0203_rk*f04_y - n4_z
    n3_z = n04_y - (neg_nc3_z + (0.0203_rk*f05_y - 0.4331_rk*f04_x))
    ! link 3: force through the joint [N]
    f3_x = fc3_x + f04_x
    f3_y = fc3_y + f05_y
    f3_z = fc3_z + f04_y
    ! link 3: force through the joint, along the axes that its turn starts from [N]
    f03_x = c23*f3_x - s23*f3_y
    f03_y = s23*f3_x + c23*f3_y
    ! link 3: moment through the joint, along the axes that its turn starts from [N m]
    n03_y = s23*n3_x + c23*n3_y
    t8 = 0.4318_rk*c2
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_y = n03_y - (s2*neg_nc2_x - c2*nc2_y + f3_z*t8)
    n02_z = n3_z + (nc2_z + (f03_y*t8 - f03_x*(0.4318_rk*s2)))
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
  ! 101 multiplications, 79 additions = 180; 3 unary minus; 8 sine/cosine
  pure subroutine puma560_d2_mass_matrix(q, M) &
      bind(c, name="puma560_d2_mass_matrix_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(out) :: M(36)
    real(rk) :: c2, s2, c3, s3, c4, s4, c5, s5
    real(rk) :: nu4_x, nu4_z, nu3_x, nu3_z, nu2_x, nu2_y, nu1_z, fu4_x
    real(rk) :: fu4_z, fu3_x, fu3_z, nu3_y, neg_nu3_x, nu3_z_2, fu2_x, fu2_y
    real(rk) :: neg_nu2_x, nu2_y_2, nu2_z, fu1_x, nu1_z_2, t1, k4_zz, k4_xz
    real(rk) :: k4_xx, m4_4, fu3_x_2, t2, fu3_z_2, t3, t4, nu3_x_2
    real(rk) :: nu3_y_2, nu3_z_3, fu2_x_2, fu2_y_2, nu2_x_2, nu2_y_3, nu2_z_2, fu1_x_2
    real(rk) :: nu1_z_3, t5, t6, k3_zz, k3_xz, h3_x, neg_h3_y, t7
    real(rk) :: k3_xx, t8, k3_yy, k3_xy, m3_3, fu2_x_3, fu2_y_3, neg_nu2_x_2
    real(rk) :: nu2_y_4, nu2_z_3, t9, fu1_x_3, t10, nu1_z_4, t11, t12
    real(rk) :: t13, t14, t15, t16, k2_zz, k2_xy, h2_x, t17
    real(rk) :: k2_yy, k2_xz, t18, m2_2, fu1_x_4, nu1_z_5, t19, m1_1

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    c3 = cos(q(3))
    s3 = sin(q(3))
    c4 = cos(q(4))
    s4 = sin(q(4))
    c5 = cos(q(5))
    s5 = sin(q(5))
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_x = 0.193_rk*s5
    nu4_z = 0.193_rk*c5
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_x = c4*nu4_x
    nu3_z = s4*nu4_x
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_x = c3*nu3_x + s3*nu4_z
    nu2_y = s3*nu3_x - c3*nu4_z
    ! link 1: moment for a unit acceleration of a joint further out
    nu1_z = -(s2*nu2_x) - c2*nu2_y
    ! link 4: force for a unit acceleration of a joint further out
    fu4_x = 0.00288_rk*c5
    fu4_z = -0.00288_rk*s5
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x = c4*fu4_x
    fu3_z = s4*fu4_x
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_y = 0.0203_rk*fu3_z
    neg_nu3_x = 0.17973436_rk*s4 + 0.4331_rk*fu3_z
    nu3_z_2 = 0.17973436_rk*c4 - (5.8464e-05_rk*s5 - 0.4331_rk*fu3_x)
    ! link 2: force for a unit acceleration of a joint further out
    fu2_x = c3*fu3_x + s3*fu4_z
    fu2_y = s3*fu3_x - c3*fu4_z
    ! link 2: moment for a unit acceleration of a joint further out
    neg_nu2_x = c3*neg_nu3_x + s3*nu3_y
    nu2_y_2 = -0.4318_rk*fu3_z - (s3*neg_nu3_x - c3*nu3_y)
    nu2_z = nu3_z_2 + 0.4318_rk*fu2_y
    ! link 1: force for a unit acceleration of a joint further out
    fu1_x = c2*fu2_x - s2*fu2_y
    ! link 1: moment for a unit acceleration of a joint further out
    nu1_z_2 = s2*neg_nu2_x - c2*nu2_y_2 - 0.1501_rk*fu1_x
    t1 = 0.19266564_rk*(c5*c5)
    ! link 4: second moment of the composite body [kg m^2]
    k4_zz = 0.1862_rk - t1
    k4_xz = -0.19266564_rk*(c5*s5)
    k4_xx = t1 + 0.09418436_rk
    ! link 4: mass matrix, its row of this joint
    m4_4 = t1 + 0.20193436_rk
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x_2 = s4*fu4_z
    t2 = -c4
    fu3_z_2 = t2*fu4_z
    t3 = t2*k4_xz
    t4 = 0.4331_rk*fu3_z_2
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_x_2 = t3 - t4
    nu3_y_2 = 0.0203_rk*fu3_z_2 - m4_4
    nu3_z_3 = 0.4331_rk*fu3_x_2 - s4*k4_xz
    ! link 2: force for a unit acceleration of a joint further out
    fu2_x_2 = c3*fu3_x_2
    fu2_y_2 = s3*fu3_x_2
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_x_2 = c3*nu3_x_2 - s3*nu3_y_2
    nu2_y_3 = s3*nu3_x_2 + c3*nu3_y_2 - 0.4318_rk*fu3_z_2
    nu2_z_2 = nu3_z_3 + 0.4318_rk*fu2_y_2
    ! link 1: force for a unit acceleration of a joint further out
    fu1_x_2 = c2*fu2_x_2 - s2*fu2_y_2
    ! link 1: moment for a unit acceleration of a joint further out
    nu1_z_3 = -0.1501_rk*fu1_x_2 - (s2*nu2_x_2 + c2*nu2_y_3)
    t5 = t1 - 0.01356564_rk
    t6 = c4*c4*t5
    ! link 3: second moment of the composite body [kg m^2]
    k3_zz = k4_xx - t6
    k3_xz = t5*(c4*s4) + 0.0203_rk*fu3_x_2
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    h3_x = fu3_z_2 - 0.025375_rk
    neg_h3_y = fu4_x + 0.861795_rk
    t7 = 0.10775_rk + t6 - 0.0406_rk*fu3_z_2
    ! link 3: second moment of the composite body [kg m^2]
    k3_xx = t7 + 0.4439651125_rk
    t8 = k4_zz + 0.002494656_rk*c5
    k3_yy = t8 + 0.6422901365_rk
    k3_xy = 0.0106736385_rk - (t4 - (t3 + 5.8464e-05_rk*c5))
    ! link 3: mass matrix, its row of this joint
    m3_3 = t7 + t8 + 1.086255249_rk
    ! link 2: force for a unit acceleration of a joint further out
    fu2_x_3 = c3*neg_h3_y - s3*h3_x
    fu2_y_3 = s3*neg_h3_y + c3*h3_x
    ! link 2: moment for a unit acceleration of a joint further out
    neg_nu2_x_2 = c3*k3_xz - s3*nu3_z_3
    nu2_y_4 = -(s3*k3_xz) - c3*nu3_z_3
    nu2_z_3 = m3_3 + 0.4318_rk*fu2_y_3
    t9 = c2*fu2_x_3
    ! link 1: force for a unit acceleration of a joint further out
    fu1_x_3 = t9 - s2*fu2_y_3
    t10 = c2*nu2_y_4
    ! link 1: moment for a unit acceleration of a joint further out
    nu1_z_4 = s2*neg_nu2_x_2 - t10 - 0.1501_rk*fu1_x_3
    t11 = c3*s3
    t12 = c3*c3
    t13 = t7 - t8 - 0.198325024_rk
    t14 = k3_xy*(2.0_rk*t11) - t12*t13
    t15 = k3_xx + t14
    t16 = k3_zz - t15
    ! link 2: second moment of the composite body [kg m^2]
    k2_zz = t15 + t16
    k2_xy = t13*t11 - k3_xy*(1.0_rk - 2.0_rk*t12) - 0.4318_rk*fu2_x_3
    ! link 2: first moment of the composite body, about the frame's origin [kg m]
    h2_x = fu2_y_3 + 1.42919_rk
    t17 = k3_zz - t16
    ! link 2: second moment of the composite body [kg m^2]
    k2_yy = t17 + 2.42815_rk
    k2_xz = neg_nu2_x_2 - 0.4318_rk*fu3_x_2 - 0.11051088_rk
    t18 = t14 - k3_yy - 0.8636_rk*fu2_y_3
    ! link 2: mass matrix, its row of this joint
    m2_2 = t17 - t18 + 6.538587602_rk
    ! link 1: force for a unit acceleration of a joint further out
    fu1_x_4 = t9 - s2*h2_x
    ! link 1: moment for a unit acceleration of a joint further out
    nu1_z_5 = s2*k2_xz - t10 - 0.1501_rk*fu1_x_4
    t19 = k2_yy - (c2*c2*(t17 + t18 - 1.682287602_rk) + k2_xy*(2.0_rk*(c2*s2))) + (k2_zz - &
        0.3002_rk*fu3_x_2)
    ! link 1: mass matrix, its row of this joint
    m1_1 = t19 - 0.0651082895_rk
    M(1) = m1_1
    M(2) = nu1_z_5
    M(3) = nu1_z_4
    M(4) = nu1_z_3
    M(5) = nu1_z_2
    M(6) = nu1_z
    M(7) = nu1_z_5
    M(8) = m2_2
    M(9) = nu2_z_3
    M(10) = nu2_z_2
    M(11) = nu2_z
    M(12) = nu3_z
    M(13) = nu1_z_4
    M(14) = nu2_z_3
    M(15) = m3_3
    M(16) = nu3_z_3
    M(17) = nu3_z_2
    M(18) = nu3_z
    M(19) = nu1_z_3
    M(20) = nu2_z_2
    M(21) = nu3_z_3
    M(22) = m4_4
    M(23) = 0.0_rk
    M(24) = nu4_z
    M(25) = nu1_z_2
    M(26) = nu2_z
    M(27) = nu3_z_2
    M(28) = 0.0_rk
    M(29) = 0.17973436_rk
    M(30) = 0.0_rk
    M(31) = nu1_z
    M(32) = nu3_z
    M(33) = nu3_z
    M(34) = nu4_z
    M(35) = 0.0_rk
    M(36) = 0.193_rk
  end subroutine

  ! accelerations that the torques tau give
  ! 341 multiplications, 248 additions, 6 divisions = 595; 13 unary minus; 12 sine/cosine
  pure subroutine puma560_d2_forward_dynamics(q, qd, tau, qdd) &
      bind(c, name="puma560_d2_forward_dynamics_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(in) :: tau(6)
    real(rk), intent(out) :: qdd(6)
    real(rk) :: c2, s2, c3, s3, c4, s4, c5, s5
    real(rk) :: c6, s6, nu4_x, nu4_z, nu3_x, nu3_z, nu2_x, nu2_y
    real(rk) :: nu1_z, fu4_x, fu4_z, fu3_x, fu3_z, nu3_y, neg_nu3_x, nu3_z_2
    real(rk) :: fu2_x, fu2_y, neg_nu2_x, nu2_y_2, nu2_z, fu1_x, nu1_z_2, t1
    real(rk) :: k4_zz, k4_xz, k4_xx, m4_4, fu3_x_2, t2, fu3_z_2, t3
    real(rk) :: t4, nu3_x_2, nu3_y_2, nu3_z_3, fu2_x_2, fu2_y_2, nu2_x_2, nu2_y_3
    real(rk) :: nu2_z_2, fu1_x_2, nu1_z_3, t5, t6, k3_zz, k3_xz, h3_x
    real(rk) :: neg_h3_y, t7, k3_xx, t8, k3_yy, k3_xy, m3_3, fu2_x_3
    real(rk) :: fu2_y_3, neg_nu2_x_2, nu2_y_4, nu2_z_3, t9, fu1_x_3, t10, nu1_z_4
    real(rk) :: t11, t12, t13, t14, t15, t16, k2_zz, k2_xy
    real(rk) :: h2_x, t17, k2_yy, k2_xz, t18, m2_2, fu1_x_4, nu1_z_5
    real(rk) :: t19, m1_1, angle23, c23, s23, w3_z, ww1_zz, a2_z
    real(rk) :: neg_w2_x, neg_w2_y, neg_alpha2_x, alpha2_y, ww2_xy, ww2_xx, ww2_yy, ww2_zz
    real(rk) :: neg_lam2_11, neg_lam2_33, a3_z, t20, w3_x, w3_y, t21, t22
    real(rk) :: t23, t24, neg_a3_x, a3_y, alpha3_x, alpha3_y, ww3_xy, ww3_xx
    real(rk) :: ww3_yy, ww3_zz, neg_lam3_11, neg_lam3_22, a4_z, w4_x, w4_y, t25
    real(rk) :: t26, a4_x, a4_y, alpha4_x, alpha4_y, w4_z, ww4_yz, ww4_zx
    real(rk) :: ww4_xy, w5_x, w5_y, a5_x, alpha5_y, w5_z, ww5_zx, ww5_xy
    real(rk) :: ww5_xx, ww5_zz, lam5_12, lam5_21, neg_lam5_22, lam5_31, lam5_32, w6_x
    real(rk) :: w6_y, w6_z, ww6_yz, ww6_zx, fc2_x, fc2_y, neg_nc2_x, nc2_y
    real(rk) :: nc2_z, fc3_x, fc3_y, fc3_z, nc3_x, nc3_y, neg_nc3_z, nc4_y
    real(rk) :: nc4_x, nc4_z, fc5_x, fc5_y, fc5_z, nc5_y, nc5_x, nc5_z
    real(rk) :: nc6_x, nc6_y, nc6_z, n06_x, n06_y, n5_x, n5_y, n5_z
    real(rk) :: f05_x, f05_y, n05_x, n05_y, n4_x, n4_y, n4_z, f04_x
    real(rk) :: f04_y, n04_x, n04_y, n3_x, n3_y, n3_z, f3_x, f3_y
    real(rk) :: f3_z, f03_x, f03_y, n03_y, t27, n02_y, n02_z, f02_x
    real(rk) :: neg_n1_z, y1, ipivot1, l2_1, l3_1, l4_1, l5_1, l6_1
    real(rk) :: pivot2, ipivot2, ld3_2, l3_2, ld4_2, l4_2, ld5_2, l5_2
    real(rk) :: ld6_2, l6_2, pivot3, ipivot3, ld4_3, l4_3, ld5_3, l5_3
    real(rk) :: ld6_3, l6_3, pivot4, ipivot4, ld5_4, l5_4, ld6_4, l6_4
    real(rk) :: pivot5, ipivot5, ld6_5, l6_5, pivot6, ipivot6, y2, y3
    real(rk) :: y4, y5, y6, qdd6, qdd5, qdd4, qdd3, qdd2
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
    nu4_x = 0.193_rk*s5
    nu4_z = 0.193_rk*c5
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_x = c4*nu4_x
    nu3_z = s4*nu4_x
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_x = c3*nu3_x + s3*nu4_z
    nu2_y = s3*nu3_x - c3*nu4_z
    ! link 1: moment for a unit acceleration of a joint further out
    nu1_z = -(s2*nu2_x) - c2*nu2_y
    ! link 4: force for a unit acceleration of a joint further out
    fu4_x = 0.00288_rk*c5
    fu4_z = -0.00288_rk*s5
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x = c4*fu4_x
    fu3_z = s4*fu4_x
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_y = 0.0203_rk*fu3_z
    neg_nu3_x = 0.17973436_rk*s4 + 0.4331_rk*fu3_z
    nu3_z_2 = 0.17973436_rk*c4 - (5.8464e-05_rk*s5 - 0.4331_rk*fu3_x)
    ! link 2: force for a unit acceleration of a joint further out
    fu2_x = c3*fu3_x + s3*fu4_z
    fu2_y = s3*fu3_x - c3*fu4_z
    ! link 2: moment for a unit acceleration of a joint further out
    neg_nu2_x = c3*neg_nu3_x + s3*nu3_y
    nu2_y_2 = -0.4318_rk*fu3_z - (s3*neg_nu3_x - c3*nu3_y)
    nu2_z = nu3_z_2 + 0.4318_rk*fu2_y
    ! link 1: force for a unit acceleration of a joint further out
    fu1_x = c2*fu2_x - s2*fu2_y
    ! link 1: moment for a unit acceleration of a joint further out
    nu1_z_2 = s2*neg_nu2_x - c2*nu2_y_2 - 0.1501_rk*fu1_x
    t1 = 0.19266564_rk*(c5*c5)
    ! link 4: second moment of the composite body [kg m^2]
    k4_zz = 0.1862_rk - t1
    k4_xz = -0.19266564_rk*(c5*s5)
    k4_xx = t1 + 0.09418436_rk
    ! link 4: mass matrix, its row of this joint
    m4_4 = t1 + 0.20193436_rk
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x_2 = s4*fu4_z
    t2 = -c4
    fu3_z_2 = t2*fu4_z
    t3 = t2*k4_xz
    t4 = 0.4331_rk*fu3_z_2
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_x_2 = t3 - t4
    nu3_y_2 = 0.0203_rk*fu3_z_2 - m4_4
    nu3_z_3 = 0.4331_rk*fu3_x_2 - s4*k4_xz
    ! link 2: force for a unit acceleration of a joint further out
    fu2_x_2 = c3*fu3_x_2
    fu2_y_2 = s3*fu3_x_2
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_x_2 = c3*nu3_x_2 - s3*nu3_y_2
    nu2_y_3 = s3*nu3_x_2 + c3*nu3_y_2 - 0.4318_rk*fu3_z_2
    nu2_z_2 = nu3_z_3 + 0.4318_rk*fu2_y_2
    ! link 1: force for a unit acceleration of a joint further out
    fu1_x_2 = c2*fu2_x_2 - s2*fu2_y_2
    ! link 1: moment for a unit acceleration of a joint further out
    nu1_z_3 = -0.1501_rk*fu1_x_2 - (s2*nu2_x_2 + c2*nu2_y_3)
    t5 = t1 - 0.01356564_rk
    t6 = c4*c4*t5
    ! link 3: second moment of the composite body [kg m^2]
    k3_zz = k4_xx - t6
    k3_xz = t5*(c4*s4) + 0.0203_rk*fu3_x_2
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    h3_x = fu3_z_2 - 0.025375_rk
    neg_h3_y = fu4_x + 0.861795_rk
    t7 = t6 + 0.10775_rk - 0.0406_rk*fu3_z_2
    ! link 3: second moment of the composite body [kg m^2]
    k3_xx = t7 + 0.4439651125_rk
    t8 = k4_zz + 0.002494656_rk*c5
    k3_yy = t8 + 0.6422901365_rk
    k3_xy = 0.0106736385_rk - (t4 - (t3 + 5.8464e-05_rk*c5))
    ! link 3: mass matrix, its row of this joint
    m3_3 = t7 + t8 + 1.086255249_rk
    ! link 2: force for a unit acceleration of a joint further out
    fu2_x_3 = c3*neg_h3_y - s3*h3_x
    fu2_y_3 = s3*neg_h3_y + c3*h3_x
    ! link 2: moment for a unit acceleration of a joint further out
    neg_nu2_x_2 = c3*k3_xz - s3*nu3_z_3
    nu2_y_4 = -(s3*k3_xz) - c3*nu3_z_3
    nu2_z_3 = m3_3 + 0.4318_rk*fu2_y_3
    t9 = c2*fu2_x_3
    ! link 1: force for a unit acceleration of a joint further out
    fu1_x_3 = t9 - s2*fu2_y_3
    t10 = c2*nu2_y_4
    ! link 1: moment for a unit acceleration of a joint further out
    nu1_z_4 = s2*neg_nu2_x_2 - t10 - 0.1501_rk*fu1_x_3
    t11 = c3*s3
    t12 = c3*c3
    t13 = t7 - t8 - 0.198325024_rk
    t14 = k3_xy*(2.0_rk*t11) - t12*t13
    t15 = k3_xx + t14
    t16 = k3_zz - t15
    ! link 2: second moment of the composite body [kg m^2]
    k2_zz = t15 + t16
    k2_xy = t13*t11 + k3_xy*(2.0_rk*t12 - 1.0_rk) - 0.4318_rk*fu2_x_3
    ! link 2: first moment of the composite body, about the frame's origin [kg m]
    h2_x = fu2_y_3 + 1.42919_rk
    t17 = k3_zz - t16
    ! link 2: second moment of the composite body [kg m^2]
    k2_yy = t17 + 2.42815_rk
    k2_xz = neg_nu2_x_2 - 0.4318_rk*fu3_x_2 - 0.11051088_rk
    t18 = t14 - k3_yy - 0.8636_rk*fu2_y_3
    ! link 2: mass matrix, its row of this joint
    m2_2 = t17 - t18 + 6.538587602_rk
    ! link 1: force for a unit acceleration of a joint further out
    fu1_x_4 = t9 - s2*h2_x
    ! link 1: moment for a unit acceleration of a joint further out
    nu1_z_5 = s2*k2_xz - t10 - 0.1501_rk*fu1_x_4
    t19 = k2_yy - (c2*c2*(t17 + t18 - 1.682287602_rk) + k2_xy*(2.0_rk*(c2*s2))) + (k2_zz - &
        0.3002_rk*fu3_x_2)
    ! link 1: mass matrix, its row of this joint
    m1_1 = t19 - 0.0651082895_rk
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
    neg_lam2_33 = ww2_xx + ww2_yy
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_z = a2_z - 0.8636_rk*alpha2_y
    t20 = -qd(1)
    ! link 3: angular velocity [rad/s]
    w3_x = t20*s23
    w3_y = t20*c23
    t21 = 0.4318_rk*neg_lam2_11
    t22 = 0.4318_rk*ww2_xy
    t23 = c2*t21 + s2*t22
    t24 = s2*t21 - c2*t22 + 9.8_rk
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a3_x = c23*t23 + s23*t24
    a3_y = s23*t23 - c23*t24
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
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_z = 0.0203_rk*ww3_xy - 0.4331_rk*neg_lam3_22 - a3_y
    ! link 4: angular velocity [rad/s]
    w4_x = c4*w3_x + s4*w3_z
    w4_y = c4*w3_z - s4*w3_x
    t25 = neg_a3_x + (0.4331_rk*ww3_xy - 0.0203_rk*neg_lam3_11)
    t26 = 0.8662_rk*alpha3_x - 0.0406_rk*alpha3_y - a3_z
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_x = -(c4*t25) - s4*t26
    a4_y = s4*t25 - c4*t26
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = c4*alpha3_x + qd(4)*w4_y
    alpha4_y = -s4*alpha3_x - qd(4)*w4_x
    ! link 4: angular velocity [rad/s]
    w4_z = qd(4) - w3_y
    ! link 4: products of the angular velocity [1/s^2]
    ww4_yz = w4_y*w4_z
    ww4_zx = w4_x*w4_z
    ww4_xy = w4_x*w4_y
    ! link 5: angular velocity [rad/s]
    w5_x = c5*w4_x - s5*w4_z
    w5_y = -s5*w4_x - c5*w4_z
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_x = c5*a4_x - s5*a4_z
    ! link 5: angular acceleration [rad/s^2]
    alpha5_y = c5*alpha3_y - s5*alpha4_x - qd(5)*w5_x
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
    lam5_32 = w5_y*(qd(5) + w5_z) - (-c5*alpha4_x - s5*alpha3_y)
    ! link 6: angular velocity [rad/s]
    w6_x = c6*w5_x + s6*w5_z
    w6_y = c6*w5_z - s6*w5_x
    w6_z = qd(6) - w5_y
    ! link 6: products of the angular velocity [1/s^2]
    ww6_yz = w6_y*w6_z
    ww6_zx = w6_x*w6_z
    ! link 2: force that moves the link [N]
    fc2_x = -1.42919_rk*neg_lam2_11
    fc2_y = 1.42919_rk*ww2_xy
    ! link 2: moment that turns the link [N m]
    neg_nc2_x = 4.8563_rk*neg_alpha2_x - 0.11051088_rk*ww2_xy
    nc2_y = 8.220875204_rk*alpha2_y + 0.11051088_rk*(neg_lam2_11 - neg_lam2_33) + &
        0.214521419_rk*ww1_zz
    nc2_z = 1.682287602_rk*ww2_xy - 14.006062_rk*c2
    ! link 3: force that moves the link [N]
    fc3_x = 0.025375_rk*neg_lam3_11 - 0.861795_rk*ww3_xy
    fc3_y = 0.861795_rk*neg_lam3_22 - 0.025375_rk*ww3_xy
    fc3_z = 0.05075_rk*alpha3_y - 1.72359_rk*alpha3_x
    ! link 3: moment that turns the link [N m]
    nc3_x = -0.861795_rk*a3_z - (0.021347277_rk*alpha3_y - 1.485880273_rk*alpha3_x)
    nc3_y = 0.887930225_rk*alpha3_y - 0.021347277_rk*alpha3_x + 0.025375_rk*a3_z
    neg_nc3_z = 0.298975024_rk*ww3_xy - 0.0106736385_rk*(neg_lam3_11 - neg_lam3_22) + &
        (0.025375_rk*a3_y + 0.861795_rk*neg_a3_x)
    ! link 4: moment that turns the link [N m]
    nc4_y = -0.2013_rk*ww4_zx
    nc4_x = 0.1119_rk*ww4_yz - 0.0894_rk*alpha4_x
    nc4_z = 0.0894_rk*ww4_xy - 0.1119_rk*alpha3_y
    ! link 5: force that moves the link [N]
    fc5_x = -0.00288_rk*lam5_12
    fc5_y = 0.00288_rk*neg_lam5_22
    fc5_z = -0.00288_rk*lam5_32
    ! link 5: moment that turns the link [N m]
    nc5_y = -0.0897_rk*lam5_31
    nc5_x = 0.09003436_rk*lam5_32 - 0.00288_rk*a4_y
    nc5_z = 0.0897_rk*lam5_21 - 0.09003436_rk*lam5_12 + 0.00288_rk*a5_x
    ! link 6: moment that turns the link [N m]
    nc6_x = 0.193_rk*ww6_yz
    nc6_y = -0.193_rk*ww6_zx
    nc6_z = -0.193_rk*alpha5_y
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
    n4_x = nc4_x + n05_x
    n4_y = nc4_y + n5_z
    n4_z = nc4_z - n05_y
    ! link 4: force through the joint, along the axes that its turn starts from [N]
    f04_x = c4*f05_x - s4*fc5_z
    f04_y = s4*f05_x + c4*fc5_z
    ! link 4: moment through the joint, along the axes that its turn starts from [N m]
    n04_x = c4*n4_x - s4*n4_y
    n04_y = s4*n4_x + c4*n4_y
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_x = n04_x - (0.4331_rk*f04_y - nc3_x)
    n3_y = nc3_y + 0.0203_rk*f04_y - n4_z
    n3_z = n04_y - (neg_nc3_z + (0.0203_rk*f05_y - 0.4331_rk*f04_x))
    ! link 3: force through the joint [N]
    f3_x = fc3_x + f04_x
    f3_y = fc3_y + f05_y
    f3_z = fc3_z + f04_y
    ! link 3: force through the joint, along the axes that its turn starts from [N]
    f03_x = c23*f3_x - s23*f3_y
    f03_y = s23*f3_x + c23*f3_y
    ! link 3: moment through the joint, along the axes that its turn starts from [N m]
    n03_y = s23*n3_x + c23*n3_y
    t27 = 0.4318_rk*c2
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_y = n03_y - (s2*neg_nc2_x - c2*nc2_y + f3_z*t27)
    n02_z = n3_z + (nc2_z + (f03_y*t27 - f03_x*(0.4318_rk*s2)))
    ! link 2: force through the joint, along the axes that its turn starts from [N]
    f02_x = f03_x - (s2*fc2_y - c2*fc2_x)
    ! link 1: moment through the joint, about the frame's origin [N m]
    neg_n1_z = n02_y + 0.1501_rk*f02_x
    ! link 1: forward substitution
    y1 = tau(1) + neg_n1_z
    ! factorisation M = L D L^T
    ipivot1 = 1.0_rk / m1_1
    l2_1 = nu1_z_5*ipivot1
    l3_1 = nu1_z_4*ipivot1
    l4_1 = nu1_z_3*ipivot1
    l5_1 = nu1_z_2*ipivot1
    l6_1 = nu1_z*ipivot1
    pivot2 = m2_2 - nu1_z_5*l2_1
    ipivot2 = 1.0_rk / pivot2
    ld3_2 = nu2_z_3 - nu1_z_5*l3_1
    l3_2 = ipivot2*ld3_2
    ld4_2 = nu2_z_2 - nu1_z_5*l4_1
    l4_2 = ipivot2*ld4_2
    ld5_2 = nu2_z - nu1_z_5*l5_1
    l5_2 = ipivot2*ld5_2
    ld6_2 = nu3_z - nu1_z_5*l6_1
    l6_2 = ipivot2*ld6_2
    pivot3 = m3_3 - nu1_z_4*l3_1 - ld3_2*l3_2
    ipivot3 = 1.0_rk / pivot3
    ld4_3 = nu3_z_3 - nu1_z_4*l4_1 - ld3_2*l4_2
    l4_3 = ipivot3*ld4_3
    ld5_3 = nu3_z_2 - nu1_z_4*l5_1 - ld3_2*l5_2
    l5_3 = ipivot3*ld5_3
    ld6_3 = nu3_z - nu1_z_4*l6_1 - ld3_2*l6_2
    l6_3 = ipivot3*ld6_3
    pivot4 = m4_4 - nu1_z_3*l4_1 - ld4_2*l4_2 - ld4_3*l4_3
    ipivot4 = 1.0_rk / pivot4
    ld5_4 = -nu1_z_3*l5_1 - ld4_2*l5_2 - ld4_3*l5_3
    l5_4 = ipivot4*ld5_4
    ld6_4 = nu4_z - nu1_z_3*l6_1 - ld4_2*l6_2 - ld4_3*l6_3
    l6_4 = ipivot4*ld6_4
    pivot5 = -(nu1_z_2*l5_1 - 0.17973436_rk + ld5_2*l5_2 + ld5_3*l5_3) - ld5_4*l5_4
    ipivot5 = 1.0_rk / pivot5
    ld6_5 = -nu1_z_2*l6_1 - ld5_2*l6_2 - ld5_3*l6_3 - ld5_4*l6_4
    l6_5 = ipivot5*ld6_5
    pivot6 = -ld6_5*l6_5 - (nu1_z*l6_1 - 0.193_rk + ld6_2*l6_2 + ld6_3*l6_3 + ld6_4*l6_4)
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
    y6 = tau(6) - nc6_z - y1*l6_1 - l6_2*y2 - l6_3*y3 - l6_4*y4 - l6_5*y5
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
    qdd1 = y1*ipivot1 - l2_1*qdd2 - l3_1*qdd3 - l4_1*qdd4 - l5_1*qdd5 - l6_1*qdd6
    qdd(1) = qdd1
    qdd(2) = qdd2
    qdd(3) = qdd3
    qdd(4) = qdd4
    qdd(5) = qdd5
    qdd(6) = qdd6
  end subroutine
end module
