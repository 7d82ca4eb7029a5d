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
!   inverse_dynamics: 167 multiplications, 125 additions = 292; 5 unary minus; 10 sine/cosine
!   gravity: 19 multiplications, 8 additions = 27; 1 unary minus; 7 sine/cosine
!   bias: 154 multiplications, 100 additions = 254; 0 unary minus; 10 sine/cosine
!   mass_matrix: 80 multiplications, 65 additions = 145; 0 unary minus; 8 sine/cosine
!   forward_dynamics: 318 multiplications, 233 additions, 6 divisions = 557; 1 unary minus; 10
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
  ! 167 multiplications, 125 additions = 292; 5 unary minus; 10 sine/cosine
  pure subroutine puma560_d2_inverse_dynamics(q, qd, qdd, tau) &
      bind(c, name="puma560_d2_inverse_dynamics_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(in) :: qdd(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: c2, s2, c4, s4, c5, s5, c6, s6, angle23, c23, s23, w3_z, alpha3_z, ww1_zz, neg_a2_z
    real(rk) :: t1, w2_x, w2_y, t2, a2_y, ww2_yz, ww2_zx, alpha2_x, neg_alpha2_y, ww2_xy, ww2_xx
    real(rk) :: ww2_yy, ww2_zz, neg_lam2_11, lam2_12, lam2_21, lam2_23, lam2_31, lam2_32
    real(rk) :: neg_lam2_33, a3_z, w3_x, w3_y, t3, t4, t5, t6, neg_a3_x, a3_y, ww3_yz, ww3_zx
    real(rk) :: alpha3_x, alpha3_y, ww3_xy, ww3_xx, ww3_yy, ww3_zz, neg_lam3_11, lam3_12, lam3_21
    real(rk) :: neg_lam3_22, neg_lam3_31, lam3_32, a4_z, w4_x, w4_y, t7, t8, a4_x, a4_y, alpha4_x
    real(rk) :: alpha4_y, alpha4_z, w4_z, ww4_yz, ww4_zx, ww4_xy, w5_x, t9, w5_y, a5_x, alpha5_y
    real(rk) :: alpha5_z, w5_z, ww5_zx, ww5_xy, ww5_xx, ww5_zz, lam5_12, lam5_21, neg_lam5_22
    real(rk) :: neg_lam5_31, lam5_32, w6_x, w6_y, alpha6_z, w6_z, ww6_yz, ww6_zx, nc1_z, fc2_x
    real(rk) :: fc2_y, nc2_x, nc2_y, nc2_z, fc3_x, fc3_y, fc3_z, nc3_x, nc3_y, nc3_z, neg_nc4_y
    real(rk) :: nc4_x, nc4_z, fc5_x, fc5_y, fc5_z, nc5_y, nc5_x, nc5_z, nc6_x, nc6_y, nc6_z, n06_x
    real(rk) :: n06_y, n5_x, n5_y, n5_z, f05_x, f05_y, n05_x, n05_y, n4_x, n4_y, n4_z, f04_x, f04_y
    real(rk) :: n04_x, n04_y, n3_x, n3_y, n3_z, f3_x, f3_y, f3_z, f03_x, f03_y, n03_y, t10, n02_y
    real(rk) :: n02_z, f02_x, n1_z

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
    alpha3_y = -qdd(1)*c23 - ww3_zx
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
    neg_lam3_31 = alpha3_y - ww3_zx
    lam3_32 = ww3_yz + alpha3_x
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_z = 0.0203_rk*lam3_21 - 0.4331_rk*neg_lam3_22 - a3_y
    ! link 4: angular velocity [rad/s]
    w4_x = c4*w3_x + s4*w3_z
    w4_y = c4*w3_z - s4*w3_x
    t7 = a3_z + (0.0203_rk*neg_lam3_31 - 0.4331_rk*lam3_32)
    t8 = neg_a3_x + (0.4331_rk*lam3_12 - 0.0203_rk*neg_lam3_11)
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_x = s4*t7 - c4*t8
    a4_y = s4*t8 + c4*t7
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = qd(4)*w4_y - (-s4*alpha3_z - c4*alpha3_x)
    alpha4_y = c4*alpha3_z - s4*alpha3_x - qd(4)*w4_x
    alpha4_z = qdd(4) - alpha3_y
    ! link 4: angular velocity [rad/s]
    w4_z = qd(4) - w3_y
    ! link 4: products of the angular velocity [1/s^2]
    ww4_yz = w4_y*w4_z
    ww4_zx = w4_x*w4_z
    ww4_xy = w4_x*w4_y
    ! link 5: angular velocity [rad/s]
    w5_x = c5*w4_x - s5*w4_z
    t9 = -c5
    w5_y = t9*w4_z - s5*w4_x
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_x = c5*a4_x - s5*a4_z
    ! link 5: angular acceleration [rad/s^2]
    alpha5_y = t9*alpha4_z - s5*alpha4_x - qd(5)*w5_x
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
    ! link 1: moment that turns the link [N m]
    nc1_z = -0.0651082895_rk*qdd(1)
    ! link 2: force that moves the link [N]
    fc2_x = -1.42919_rk*neg_lam2_11
    fc2_y = 1.42919_rk*lam2_21
    ! link 2: moment that turns the link [N m]
    nc2_x = 2.42815_rk*lam2_32 + 0.11051088_rk*lam2_21
    nc2_y = 0.11051088_rk*(neg_lam2_11 - neg_lam2_33) - 4.110437602_rk*lam2_31 + &
        0.214521419_rk*ww1_zz
    nc2_z = 4.110437602_rk*lam2_21 - 2.42815_rk*lam2_12 - 0.11051088_rk*lam2_23 + 1.42919_rk*a2_y
    ! link 3: force that moves the link [N]
    fc3_x = 0.025375_rk*neg_lam3_11 - 0.861795_rk*lam3_12
    fc3_y = 0.861795_rk*neg_lam3_22 - 0.025375_rk*lam3_21
    fc3_z = 0.025375_rk*neg_lam3_31 - 0.861795_rk*lam3_32
    ! link 3: moment that turns the link [N m]
    nc3_x = -0.861795_rk*a3_z - (0.0106736385_rk*neg_lam3_31 - 0.7429401365_rk*lam3_32)
    nc3_y = 0.4439651125_rk*neg_lam3_31 - 0.0106736385_rk*lam3_32 + 0.025375_rk*a3_z
    nc3_z = 0.4439651125_rk*lam3_21 - 0.7429401365_rk*lam3_12 + 0.0106736385_rk*(neg_lam3_11 - &
        neg_lam3_22) - (0.025375_rk*a3_y + 0.861795_rk*neg_a3_x)
    ! link 4: moment that turns the link [N m]
    neg_nc4_y = 0.2013_rk*ww4_zx
    nc4_x = 0.1119_rk*ww4_yz - 0.0894_rk*alpha4_x
    nc4_z = 0.0894_rk*ww4_xy + 0.1119_rk*alpha4_z
    ! link 5: force that moves the link [N]
    fc5_x = -0.00288_rk*lam5_12
    fc5_y = 0.00288_rk*neg_lam5_22
    fc5_z = -0.00288_rk*lam5_32
    ! link 5: moment that turns the link [N m]
    nc5_y = 0.0897_rk*neg_lam5_31
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
    n4_y = n5_z - neg_nc4_y
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
    n02_y = n03_y - (-c2*nc2_y - s2*nc2_x + f3_z*t10)
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
    real(rk) :: c2, c4, s4, c5, s5, angle23, c23, s23, a3_x, a3_y, a4_x, neg_a4_y, a5_x, neg_nc2_z
    real(rk) :: nc3_z, nc5_x, nc5_z, n05_x, neg_n05_y, n04_x, n04_y, n3_z, neg_n03_y, n02_z

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
    neg_nc2_z = 14.006062_rk*c2
    ! link 3: moment that turns the link [N m]
    nc3_z = 0.248675_rk*c23 - 8.445591_rk*s23
    ! link 5: moment that turns the link [N m]
    nc5_x = 0.00288_rk*neg_a4_y
    nc5_z = 0.00288_rk*a5_x
    ! link 5: moment through the joint, along the axes that its turn starts from [N m]
    n05_x = c5*nc5_x
    neg_n05_y = -s5*nc5_x
    ! link 4: moment through the joint, along the axes that its turn starts from [N m]
    n04_x = c4*n05_x - s4*nc5_z
    n04_y = s4*n05_x + c4*nc5_z
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_z = nc3_z + n04_y
    ! link 3: moment through the joint, along the axes that its turn starts from [N m]
    neg_n03_y = c23*neg_n05_y - s23*n04_x
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_z = n3_z - neg_nc2_z
    tau(1) = neg_n03_y
    tau(2) = n02_z
    tau(3) = n3_z
    tau(4) = neg_n05_y
    tau(5) = nc5_z
    tau(6) = 0.0_rk
  end subroutine

  ! torques at zero acceleration: Coriolis, centrifugal, gravity, friction
  ! 154 multiplications, 100 additions = 254; 0 unary minus; 10 sine/cosine
  pure subroutine puma560_d2_bias(q, qd, tau) &
      bind(c, name="puma560_d2_bias_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: c2, s2, c4, s4, c5, s5, c6, s6, angle23, c23, s23, w3_z, ww1_zz, a2_z, neg_w2_x
    real(rk) :: neg_w2_y, neg_alpha2_x, alpha2_y, ww2_xy, ww2_xx, ww2_yy, ww2_zz, neg_lam2_11
    real(rk) :: neg_lam2_33, neg_a3_z, neg_w3_x, neg_w3_y, t1, t2, t3, t4, neg_a3_x, a3_y
    real(rk) :: neg_alpha3_x, alpha3_y, ww3_xy, ww3_xx, ww3_yy, ww3_zz, neg_lam3_11, neg_lam3_22
    real(rk) :: neg_a4_z, neg_w4_x, w4_y, t5, t6, neg_a4_x, a4_y, neg_alpha4_x, alpha4_y, w4_z
    real(rk) :: ww4_yz, neg_ww4_zx, neg_ww4_xy, neg_w5_x, w5_y, a5_x, alpha5_y, w5_z, neg_ww5_zx
    real(rk) :: neg_ww5_xy, ww5_xx, ww5_zz, neg_lam5_12, lam5_21, neg_lam5_22, neg_lam5_31
    real(rk) :: neg_lam5_32, neg_w6_x, w6_y, w6_z, ww6_yz, neg_ww6_zx, neg_fc2_x, fc2_y, neg_nc2_x
    real(rk) :: nc2_y, nc2_z, fc3_x, neg_fc3_y, fc3_z, nc3_x, nc3_y, neg_nc3_z, nc4_y, nc4_x
    real(rk) :: neg_nc4_z, fc5_x, fc5_y, fc5_z, nc5_y, neg_nc5_x, nc5_z, nc6_x, nc6_y, nc6_z, n06_x
    real(rk) :: n06_y, neg_n5_x, n5_y, n5_z, f05_x, f05_y, neg_n05_x, neg_n05_y, n4_x, n4_y, n4_z
    real(rk) :: f04_x, f04_y, n04_x, n04_y, n3_x, n3_y, n3_z, f3_x, neg_f3_y, f3_z, f03_x, f03_y
    real(rk) :: n03_y, t7, n02_y, n02_z, neg_f02_x, n1_z

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
    neg_a3_z = 0.8636_rk*alpha2_y - a2_z
    ! link 3: angular velocity [rad/s]
    neg_w3_x = qd(1)*s23
    neg_w3_y = qd(1)*c23
    t1 = 0.4318_rk*neg_lam2_11
    t2 = 0.4318_rk*ww2_xy
    t3 = c2*t1 + s2*t2
    t4 = s2*t1 - c2*t2 + 9.8_rk
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a3_x = c23*t3 + s23*t4
    a3_y = s23*t3 - c23*t4
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
    neg_lam3_22 = ww3_xx + ww3_zz
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a4_z = a3_y - (0.0203_rk*ww3_xy - 0.4331_rk*neg_lam3_22)
    ! link 4: angular velocity [rad/s]
    neg_w4_x = c4*neg_w3_x - s4*w3_z
    w4_y = s4*neg_w3_x + c4*w3_z
    t5 = neg_a3_x - (0.0203_rk*neg_lam3_11 - 0.4331_rk*ww3_xy)
    t6 = neg_a3_z - (0.0406_rk*alpha3_y + 0.8662_rk*neg_alpha3_x)
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a4_x = c4*t5 + s4*t6
    a4_y = s4*t5 - c4*t6
    ! link 4: angular acceleration [rad/s^2]
    neg_alpha4_x = c4*neg_alpha3_x - qd(4)*w4_y
    alpha4_y = s4*neg_alpha3_x + qd(4)*neg_w4_x
    ! link 4: angular velocity [rad/s]
    w4_z = qd(4) + neg_w3_y
    ! link 4: products of the angular velocity [1/s^2]
    ww4_yz = w4_y*w4_z
    neg_ww4_zx = neg_w4_x*w4_z
    neg_ww4_xy = neg_w4_x*w4_y
    ! link 5: angular velocity [rad/s]
    neg_w5_x = c5*neg_w4_x + s5*w4_z
    w5_y = s5*neg_w4_x - c5*w4_z
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_x = s5*neg_a4_z - c5*neg_a4_x
    ! link 5: angular acceleration [rad/s^2]
    alpha5_y = s5*neg_alpha4_x + c5*alpha3_y + qd(5)*neg_w5_x
    ! link 5: angular velocity [rad/s]
    w5_z = qd(5) + w4_y
    ! link 5: products of the angular velocity [1/s^2]
    neg_ww5_zx = neg_w5_x*w5_z
    neg_ww5_xy = neg_w5_x*w5_y
    ww5_xx = neg_w5_x*neg_w5_x
    ww5_zz = w5_z*w5_z
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_12 = alpha4_y + neg_ww5_xy
    lam5_21 = alpha4_y - neg_ww5_xy
    neg_lam5_22 = ww5_xx + ww5_zz
    neg_lam5_31 = alpha5_y + neg_ww5_zx
    neg_lam5_32 = c5*neg_alpha4_x - s5*alpha3_y - w5_y*(qd(5) + w5_z)
    ! link 6: angular velocity [rad/s]
    neg_w6_x = c6*neg_w5_x - s6*w5_z
    w6_y = s6*neg_w5_x + c6*w5_z
    w6_z = qd(6) - w5_y
    ! link 6: products of the angular velocity [1/s^2]
    ww6_yz = w6_y*w6_z
    neg_ww6_zx = neg_w6_x*w6_z
    ! link 2: force that moves the link [N]
    neg_fc2_x = 1.42919_rk*neg_lam2_11
    fc2_y = 1.42919_rk*ww2_xy
    ! link 2: moment that turns the link [N m]
    neg_nc2_x = 4.8563_rk*neg_alpha2_x - 0.11051088_rk*ww2_xy
    nc2_y = 8.220875204_rk*alpha2_y + 0.11051088_rk*(neg_lam2_11 - neg_lam2_33) + &
        0.214521419_rk*ww1_zz
    nc2_z = 1.682287602_rk*ww2_xy - 14.006062_rk*c2
    ! link 3: force that moves the link [N]
    fc3_x = 0.025375_rk*neg_lam3_11 - 0.861795_rk*ww3_xy
    neg_fc3_y = 0.025375_rk*ww3_xy - 0.861795_rk*neg_lam3_22
    fc3_z = 0.05075_rk*alpha3_y + 1.72359_rk*neg_alpha3_x
    ! link 3: moment that turns the link [N m]
    nc3_x = 0.861795_rk*neg_a3_z - (1.485880273_rk*neg_alpha3_x + 0.021347277_rk*alpha3_y)
    nc3_y = 0.887930225_rk*alpha3_y + 0.021347277_rk*neg_alpha3_x - 0.025375_rk*neg_a3_z
    neg_nc3_z = 0.298975024_rk*ww3_xy - 0.0106736385_rk*(neg_lam3_11 - neg_lam3_22) + &
        (0.025375_rk*a3_y + 0.861795_rk*neg_a3_x)
    ! link 4: moment that turns the link [N m]
    nc4_y = 0.2013_rk*neg_ww4_zx
    nc4_x = 0.1119_rk*ww4_yz + 0.0894_rk*neg_alpha4_x
    neg_nc4_z = 0.0894_rk*neg_ww4_xy + 0.1119_rk*alpha3_y
    ! link 5: force that moves the link [N]
    fc5_x = 0.00288_rk*neg_lam5_12
    fc5_y = 0.00288_rk*neg_lam5_22
    fc5_z = 0.00288_rk*neg_lam5_32
    ! link 5: moment that turns the link [N m]
    nc5_y = 0.0897_rk*neg_lam5_31
    neg_nc5_x = 0.09003436_rk*neg_lam5_32 + 0.00288_rk*a4_y
    nc5_z = 0.0897_rk*lam5_21 + 0.09003436_rk*neg_lam5_12 + 0.00288_rk*a5_x
    ! link 6: moment that turns the link [N m]
    nc6_x = 0.193_rk*ww6_yz
    nc6_y = 0.193_rk*neg_ww6_zx
    nc6_z = -0.193_rk*alpha5_y
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    n06_x = c6*nc6_x - s6*nc6_y
    n06_y = s6*nc6_x + c6*nc6_y
    ! link 5: moment through the joint, about the frame's origin [N m]
    neg_n5_x = neg_nc5_x - n06_x
    n5_y = nc5_y - nc6_z
    n5_z = nc5_z + n06_y
    ! link 5: force through the joint, along the axes that its turn starts from [N]
    f05_x = c5*fc5_x - s5*fc5_y
    f05_y = s5*fc5_x + c5*fc5_y
    ! link 5: moment through the joint, along the axes that its turn starts from [N m]
    neg_n05_x = c5*neg_n5_x + s5*n5_y
    neg_n05_y = s5*neg_n5_x - c5*n5_y
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = nc4_x - neg_n05_x
    n4_y = nc4_y + n5_z
    n4_z = neg_n05_y - neg_nc4_z
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
    neg_f3_y = neg_fc3_y - f05_y
    f3_z = fc3_z + f04_y
    ! link 3: force through the joint, along the axes that its turn starts from [N]
    f03_x = c23*f3_x + s23*neg_f3_y
    f03_y = s23*f3_x - c23*neg_f3_y
    ! link 3: moment through the joint, along the axes that its turn starts from [N m]
    n03_y = s23*n3_x + c23*n3_y
    t7 = 0.4318_rk*c2
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_y = n03_y - (s2*neg_nc2_x - c2*nc2_y + f3_z*t7)
    n02_z = n3_z + (nc2_z + (f03_y*t7 - f03_x*(0.4318_rk*s2)))
    ! link 2: force through the joint, along the axes that its turn starts from [N]
    neg_f02_x = c2*neg_fc2_x + s2*fc2_y - f03_x
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
  ! 80 multiplications, 65 additions = 145; 0 unary minus; 8 sine/cosine
  pure subroutine puma560_d2_mass_matrix(q, M) &
      bind(c, name="puma560_d2_mass_matrix_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(out) :: M(36)
    real(rk) :: c2, s2, c4, s4, c5, s5, angle23, c23, s23, nu5_x, neg_nu5_y, nu4_x, nu4_y
    real(rk) :: neg_nu3_y, h5_x, neg_h5_y, t1, k5_yy, k5_xy, fu4_x, fu4_y, neg_nu4_x, nu4_y_2, m3_5
    real(rk) :: fu3_x, fu3_y, nu3_y, t2, nu2_y, t3, m2_5, m1_5, m4_4, h4_x, h4_y, t4, t5, k4_xx
    real(rk) :: k4_yy, k4_xy, neg_k4_xz, neg_k4_yz, m3_4, neg_fu3_x, neg_fu3_y, t6, nu3_y_2
    real(rk) :: nu2_y_2, m2_4, m1_4, t7, t8, m3_3, t9, t10, h3_x, h3_y, t11, k3_xx, k3_yy, k3_yz
    real(rk) :: m2_3, m1_3, t12, k2_zz, t13, m2_2, h2_y, k2_xx, k2_yz, m1_2, m1_1

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    c4 = cos(q(4))
    s4 = sin(q(4))
    c5 = cos(q(5))
    s5 = sin(q(5))
    angle23 = q(2) + q(3)
    c23 = cos(angle23)
    s23 = sin(angle23)
    ! link 5: moment for a unit acceleration of a joint further out
    nu5_x = 0.193_rk*s5
    neg_nu5_y = 0.193_rk*c5
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_x = c4*nu5_x
    nu4_y = s4*nu5_x
    ! link 3: moment for a unit acceleration of a joint further out
    neg_nu3_y = c23*neg_nu5_y - s23*nu4_x
    ! link 5: first moment of the composite body, about the frame's origin [kg m]
    h5_x = 0.00288_rk*s5
    neg_h5_y = 0.00288_rk*c5
    t1 = 0.19266564_rk*(c5*c5)
    ! link 5: second moment of the composite body [kg m^2]
    k5_yy = 0.1862_rk - t1
    k5_xy = 0.19266564_rk*(c5*s5)
    ! link 4: force for a unit acceleration of a joint further out
    fu4_x = c4*neg_h5_y
    fu4_y = s4*neg_h5_y
    ! link 4: moment for a unit acceleration of a joint further out
    neg_nu4_x = 0.17973436_rk*s4
    nu4_y_2 = 0.17973436_rk*c4
    ! link 3: mass matrix, its row of this joint
    m3_5 = nu4_y_2 - (5.8464e-05_rk*s5 - 0.4331_rk*fu4_x)
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x = c23*fu4_x - s23*h5_x
    fu3_y = s23*fu4_x + c23*h5_x
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_y = c23*(0.0203_rk*fu4_y) - s23*(neg_nu4_x + 0.4331_rk*fu4_y)
    t2 = 0.4318_rk*c2
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y = nu3_y - t2*fu4_y
    t3 = 0.4318_rk*s2
    ! link 2: mass matrix, its row of this joint
    m2_5 = m3_5 + (t2*fu3_y - t3*fu3_x)
    ! link 1: mass matrix, its row of this joint
    m1_5 = -0.1501_rk*fu3_x - nu2_y
    ! link 4: mass matrix, its row of this joint
    m4_4 = t1 + 0.20193436_rk
    ! link 4: first moment of the composite body, about the frame's origin [kg m]
    h4_x = c4*h5_x
    h4_y = s4*h5_x
    t4 = t1 - 0.01356564_rk
    t5 = c4*c4*t4
    ! link 4: second moment of the composite body [kg m^2]
    k4_xx = 0.10775_rk + t5
    k4_yy = t1 + 0.09418436_rk - t5
    k4_xy = t4*(c4*s4)
    neg_k4_xz = c4*k5_xy
    neg_k4_yz = s4*k5_xy
    ! link 3: mass matrix, its row of this joint
    m3_4 = neg_k4_yz - 0.4331_rk*h4_y
    ! link 3: force for a unit acceleration of a joint further out
    neg_fu3_x = c23*h4_y
    neg_fu3_y = s23*h4_y
    t6 = 0.4331_rk*h4_x
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_y_2 = c23*(0.0203_rk*h4_x - m4_4) - s23*(t6 - neg_k4_xz)
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y_2 = nu3_y_2 - t2*h4_x
    ! link 2: mass matrix, its row of this joint
    m2_4 = m3_4 - (t2*neg_fu3_y - t3*neg_fu3_x)
    ! link 1: mass matrix, its row of this joint
    m1_4 = 0.1501_rk*neg_fu3_x - nu2_y_2
    t7 = k4_xx - 0.0406_rk*h4_x
    t8 = k5_yy + 0.002494656_rk*c5
    ! link 3: mass matrix, its row of this joint
    m3_3 = t7 + t8 + 1.086255249_rk
    t9 = h4_x - 0.025375_rk
    t10 = neg_h5_y + 0.861795_rk
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    h3_x = c23*t9 + s23*t10
    h3_y = s23*t9 - c23*t10
    t11 = c23*c23*(t7 - t8 - 0.198325024_rk) + (t6 - (neg_k4_xz + 5.8464e-05_rk*c5) - &
        0.0106736385_rk)*(2.0_rk*(c23*s23))
    ! link 3: second moment of the composite body [kg m^2]
    k3_xx = t8 + 0.6422901365_rk + t11
    k3_yy = t7 + 0.4439651125_rk - t11
    k3_yz = s23*(k4_xy - 0.0203_rk*h4_y) + c23*m3_4
    ! link 2: mass matrix, its row of this joint
    m2_3 = m3_3 + (t2*h3_x + t3*h3_y)
    ! link 1: mass matrix, its row of this joint
    m1_3 = k3_yz + 0.1501_rk*h3_y
    t12 = k4_yy - k3_yy
    ! link 2: second moment of the composite body [kg m^2]
    k2_zz = k3_yy + t12
    t13 = k3_xx + t2*(2.0_rk*h3_x)
    ! link 2: mass matrix, its row of this joint
    m2_2 = 6.538587602_rk - (t3*(-2.0_rk*h3_y) - (k4_yy - t12) - t13)
    ! link 2: first moment of the composite body, about the frame's origin [kg m]
    h2_y = h3_y + 1.42919_rk*s2
    ! link 2: second moment of the composite body [kg m^2]
    k2_xx = t13 + (1.682287602_rk*(c2*c2) + 2.42815_rk)
    k2_yz = k3_yz + t3*h4_y - 0.11051088_rk*s2
    ! link 1: mass matrix, its row of this joint
    m1_2 = k2_yz + 0.1501_rk*h2_y
    m1_1 = k2_xx + (k2_zz + 0.3002_rk*h4_y) - 0.0651082895_rk
    M(1) = m1_1
    M(2) = m1_2
    M(3) = m1_3
    M(4) = m1_4
    M(5) = m1_5
    M(6) = neg_nu3_y
    M(7) = m1_2
    M(8) = m2_2
    M(9) = m2_3
    M(10) = m2_4
    M(11) = m2_5
    M(12) = nu4_y
    M(13) = m1_3
    M(14) = m2_3
    M(15) = m3_3
    M(16) = m3_4
    M(17) = m3_5
    M(18) = nu4_y
    M(19) = m1_4
    M(20) = m2_4
    M(21) = m3_4
    M(22) = m4_4
    M(23) = 0.0_rk
    M(24) = neg_nu5_y
    M(25) = m1_5
    M(26) = m2_5
    M(27) = m3_5
    M(28) = 0.0_rk
    M(29) = 0.17973436_rk
    M(30) = 0.0_rk
    M(31) = neg_nu3_y
    M(32) = nu4_y
    M(33) = nu4_y
    M(34) = neg_nu5_y
    M(35) = 0.0_rk
    M(36) = 0.193_rk
  end subroutine

  ! accelerations that the torques tau give
  ! 318 multiplications, 233 additions, 6 divisions = 557; 1 unary minus; 10 sine/cosine
  pure subroutine puma560_d2_forward_dynamics(q, qd, tau, qdd) &
      bind(c, name="puma560_d2_forward_dynamics_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(in) :: tau(6)
    real(rk), intent(out) :: qdd(6)
    real(rk) :: c2, s2, c4, s4, c5, s5, c6, s6, angle23, c23, s23, nu5_x, neg_nu5_y, nu4_x, nu4_y
    real(rk) :: nu3_y, h5_x, neg_h5_y, t1, neg_k5_yy, k5_xy, fu4_x, fu4_y, nu4_x_2, nu4_y_2, m3_5
    real(rk) :: fu3_x, fu3_y, nu3_y_2, t2, neg_nu2_y, t3, m2_5, m1_5, m4_4, h4_x, h4_y, t4, t5
    real(rk) :: k4_xx, k4_yy, k4_xy, neg_k4_xz, neg_k4_yz, m3_4, neg_fu3_x, neg_fu3_y, t6, nu3_y_3
    real(rk) :: nu2_y, m2_4, neg_m1_4, t7, t8, m3_3, t9, t10, h3_x, h3_y, t11, neg_k3_xx, k3_yy
    real(rk) :: k3_yz, m2_3, m1_3, t12, k2_zz, t13, neg_m2_2, h2_y, neg_k2_xx, k2_yz, m1_2
    real(rk) :: neg_m1_1, w3_z, ww1_zz, a2_z, neg_w2_x, neg_w2_y, neg_alpha2_x, alpha2_y, ww2_xy
    real(rk) :: ww2_xx, ww2_yy, ww2_zz, neg_lam2_11, neg_lam2_33, neg_a3_z, neg_w3_x, neg_w3_y, t14
    real(rk) :: t15, t16, t17, neg_a3_x, a3_y, neg_alpha3_x, alpha3_y, ww3_xy, ww3_xx, ww3_yy
    real(rk) :: ww3_zz, neg_lam3_11, neg_lam3_22, neg_a4_z, neg_w4_x, w4_y, t18, t19, neg_a4_x
    real(rk) :: a4_y, neg_alpha4_x, alpha4_y, w4_z, ww4_yz, neg_ww4_zx, neg_ww4_xy, neg_w5_x, w5_y
    real(rk) :: a5_x, alpha5_y, w5_z, neg_ww5_zx, neg_ww5_xy, ww5_xx, ww5_zz, neg_lam5_12, lam5_21
    real(rk) :: neg_lam5_22, neg_lam5_31, neg_lam5_32, neg_w6_x, w6_y, w6_z, ww6_yz, neg_ww6_zx
    real(rk) :: neg_fc2_x, fc2_y, neg_nc2_x, nc2_y, nc2_z, fc3_x, neg_fc3_y, fc3_z, nc3_x, nc3_y
    real(rk) :: neg_nc3_z, nc4_y, nc4_x, neg_nc4_z, fc5_x, fc5_y, fc5_z, nc5_y, neg_nc5_x, nc5_z
    real(rk) :: nc6_x, nc6_y, nc6_z, n06_x, n06_y, neg_n5_x, n5_y, n5_z, f05_x, f05_y, neg_n05_x
    real(rk) :: neg_n05_y, n4_x, n4_y, n4_z, f04_x, f04_y, n04_x, n04_y, n3_x, n3_y, n3_z, f3_x
    real(rk) :: neg_f3_y, f3_z, f03_x, f03_y, n03_y, n02_y, n02_z, f02_x, neg_n1_z, y1, neg_ipivot1
    real(rk) :: neg_l2_1, neg_l3_1, l4_1, neg_l5_1, l6_1, neg_pivot2, neg_ipivot2, ld3_2, neg_l3_2
    real(rk) :: ld4_2, neg_l4_2, ld5_2, neg_l5_2, ld6_2, neg_l6_2, pivot3, ipivot3, ld4_3, l4_3
    real(rk) :: ld5_3, l5_3, ld6_3, l6_3, pivot4, ipivot4, neg_ld5_4, neg_l5_4, ld6_4, l6_4, pivot5
    real(rk) :: ipivot5, neg_ld6_5, neg_l6_5, pivot6, ipivot6, y2, y3, y4, y5, y6, qdd6, qdd5, qdd4
    real(rk) :: qdd3, qdd2, qdd1

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
    ! link 5: moment for a unit acceleration of a joint further out
    nu5_x = 0.193_rk*s5
    neg_nu5_y = 0.193_rk*c5
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_x = c4*nu5_x
    nu4_y = s4*nu5_x
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_y = s23*nu4_x - c23*neg_nu5_y
    ! link 5: first moment of the composite body, about the frame's origin [kg m]
    h5_x = 0.00288_rk*s5
    neg_h5_y = 0.00288_rk*c5
    t1 = 0.19266564_rk*(c5*c5)
    ! link 5: second moment of the composite body [kg m^2]
    neg_k5_yy = t1 - 0.1862_rk
    k5_xy = 0.19266564_rk*(c5*s5)
    ! link 4: force for a unit acceleration of a joint further out
    fu4_x = c4*neg_h5_y
    fu4_y = s4*neg_h5_y
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_x_2 = -0.17973436_rk*s4
    nu4_y_2 = 0.17973436_rk*c4
    ! link 3: mass matrix, its row of this joint
    m3_5 = nu4_y_2 - (5.8464e-05_rk*s5 - 0.4331_rk*fu4_x)
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x = c23*fu4_x - s23*h5_x
    fu3_y = s23*fu4_x + c23*h5_x
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_y_2 = c23*(0.0203_rk*fu4_y) - s23*(0.4331_rk*fu4_y - nu4_x_2)
    t2 = 0.4318_rk*c2
    ! link 2: moment for a unit acceleration of a joint further out
    neg_nu2_y = t2*fu4_y - nu3_y_2
    t3 = 0.4318_rk*s2
    ! link 2: mass matrix, its row of this joint
    m2_5 = m3_5 + (t2*fu3_y - t3*fu3_x)
    ! link 1: mass matrix, its row of this joint
    m1_5 = neg_nu2_y - 0.1501_rk*fu3_x
    ! link 4: mass matrix, its row of this joint
    m4_4 = t1 + 0.20193436_rk
    ! link 4: first moment of the composite body, about the frame's origin [kg m]
    h4_x = c4*h5_x
    h4_y = s4*h5_x
    t4 = t1 - 0.01356564_rk
    t5 = c4*c4*t4
    ! link 4: second moment of the composite body [kg m^2]
    k4_xx = t5 + 0.10775_rk
    k4_yy = t1 + 0.09418436_rk - t5
    k4_xy = t4*(c4*s4)
    neg_k4_xz = c4*k5_xy
    neg_k4_yz = s4*k5_xy
    ! link 3: mass matrix, its row of this joint
    m3_4 = neg_k4_yz - 0.4331_rk*h4_y
    ! link 3: force for a unit acceleration of a joint further out
    neg_fu3_x = c23*h4_y
    neg_fu3_y = s23*h4_y
    t6 = 0.4331_rk*h4_x
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_y_3 = s23*(neg_k4_xz - t6) - c23*(m4_4 - 0.0203_rk*h4_x)
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y = nu3_y_3 - t2*h4_x
    ! link 2: mass matrix, its row of this joint
    m2_4 = m3_4 - (t2*neg_fu3_y - t3*neg_fu3_x)
    ! link 1: mass matrix, its row of this joint
    neg_m1_4 = nu2_y - 0.1501_rk*neg_fu3_x
    t7 = k4_xx - 0.0406_rk*h4_x
    t8 = neg_k5_yy - 0.002494656_rk*c5
    ! link 3: mass matrix, its row of this joint
    m3_3 = t7 - t8 + 1.086255249_rk
    t9 = h4_x - 0.025375_rk
    t10 = neg_h5_y + 0.861795_rk
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    h3_x = c23*t9 + s23*t10
    h3_y = s23*t9 - c23*t10
    t11 = c23*c23*(t7 + t8 - 0.198325024_rk) + (t6 - (neg_k4_xz + 5.8464e-05_rk*c5) - &
        0.0106736385_rk)*(2.0_rk*(c23*s23))
    ! link 3: second moment of the composite body [kg m^2]
    neg_k3_xx = t8 - 0.6422901365_rk - t11
    k3_yy = t7 + 0.4439651125_rk - t11
    k3_yz = s23*(k4_xy - 0.0203_rk*h4_y) + c23*m3_4
    ! link 2: mass matrix, its row of this joint
    m2_3 = m3_3 + (t2*h3_x + t3*h3_y)
    ! link 1: mass matrix, its row of this joint
    m1_3 = k3_yz + 0.1501_rk*h3_y
    t12 = k4_yy - k3_yy
    ! link 2: second moment of the composite body [kg m^2]
    k2_zz = k3_yy + t12
    t13 = neg_k3_xx - t2*(2.0_rk*h3_x)
    ! link 2: mass matrix, its row of this joint
    neg_m2_2 = t13 - (k4_yy - t12 + t3*(2.0_rk*h3_y)) - 6.538587602_rk
    ! link 2: first moment of the composite body, about the frame's origin [kg m]
    h2_y = h3_y + 1.42919_rk*s2
    ! link 2: second moment of the composite body [kg m^2]
    neg_k2_xx = t13 - (1.682287602_rk*(c2*c2) + 2.42815_rk)
    k2_yz = k3_yz + t3*h4_y - 0.11051088_rk*s2
    ! link 1: mass matrix, its row of this joint
    m1_2 = k2_yz + 0.1501_rk*h2_y
    neg_m1_1 = neg_k2_xx - (k2_zz + 0.3002_rk*h4_y) + 0.0651082895_rk
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
    neg_a3_z = 0.8636_rk*alpha2_y - a2_z
    ! link 3: angular velocity [rad/s]
    neg_w3_x = qd(1)*s23
    neg_w3_y = qd(1)*c23
    t14 = 0.4318_rk*neg_lam2_11
    t15 = 0.4318_rk*ww2_xy
    t16 = c2*t14 + s2*t15
    t17 = s2*t14 - c2*t15 + 9.8_rk
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a3_x = c23*t16 + s23*t17
    a3_y = s23*t16 - c23*t17
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
    neg_lam3_22 = ww3_xx + ww3_zz
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a4_z = a3_y - (0.0203_rk*ww3_xy - 0.4331_rk*neg_lam3_22)
    ! link 4: angular velocity [rad/s]
    neg_w4_x = c4*neg_w3_x - s4*w3_z
    w4_y = s4*neg_w3_x + c4*w3_z
    t18 = neg_a3_x - (0.0203_rk*neg_lam3_11 - 0.4331_rk*ww3_xy)
    t19 = neg_a3_z - (0.0406_rk*alpha3_y + 0.8662_rk*neg_alpha3_x)
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a4_x = c4*t18 + s4*t19
    a4_y = s4*t18 - c4*t19
    ! link 4: angular acceleration [rad/s^2]
    neg_alpha4_x = c4*neg_alpha3_x - qd(4)*w4_y
    alpha4_y = s4*neg_alpha3_x + qd(4)*neg_w4_x
    ! link 4: angular velocity [rad/s]
    w4_z = qd(4) + neg_w3_y
    ! link 4: products of the angular velocity [1/s^2]
    ww4_yz = w4_y*w4_z
    neg_ww4_zx = neg_w4_x*w4_z
    neg_ww4_xy = neg_w4_x*w4_y
    ! link 5: angular velocity [rad/s]
    neg_w5_x = c5*neg_w4_x + s5*w4_z
    w5_y = s5*neg_w4_x - c5*w4_z
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_x = s5*neg_a4_z - c5*neg_a4_x
    ! link 5: angular acceleration [rad/s^2]
    alpha5_y = s5*neg_alpha4_x + c5*alpha3_y + qd(5)*neg_w5_x
    ! link 5: angular velocity [rad/s]
    w5_z = qd(5) + w4_y
    ! link 5: products of the angular velocity [1/s^2]
    neg_ww5_zx = neg_w5_x*w5_z
    neg_ww5_xy = neg_w5_x*w5_y
    ww5_xx = neg_w5_x*neg_w5_x
    ww5_zz = w5_z*w5_z
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_12 = alpha4_y + neg_ww5_xy
    lam5_21 = alpha4_y - neg_ww5_xy
    neg_lam5_22 = ww5_xx + ww5_zz
    neg_lam5_31 = alpha5_y + neg_ww5_zx
    neg_lam5_32 = c5*neg_alpha4_x - s5*alpha3_y - w5_y*(qd(5) + w5_z)
    ! link 6: angular velocity [rad/s]
    neg_w6_x = c6*neg_w5_x - s6*w5_z
    w6_y = s6*neg_w5_x + c6*w5_z
    w6_z = qd(6) - w5_y
    ! link 6: products of the angular velocity [1/s^2]
    ww6_yz = w6_y*w6_z
    neg_ww6_zx = neg_w6_x*w6_z
    ! link 2: force that moves the link [N]
    neg_fc2_x = 1.42919_rk*neg_lam2_11
    fc2_y = 1.42919_rk*ww2_xy
    ! link 2: moment that turns the link [N m]
    neg_nc2_x = 4.8563_rk*neg_alpha2_x - 0.11051088_rk*ww2_xy
    nc2_y = 8.220875204_rk*alpha2_y + 0.11051088_rk*(neg_lam2_11 - neg_lam2_33) + &
        0.214521419_rk*ww1_zz
    nc2_z = 1.682287602_rk*ww2_xy - 14.006062_rk*c2
    ! link 3: force that moves the link [N]
    fc3_x = 0.025375_rk*neg_lam3_11 - 0.861795_rk*ww3_xy
    neg_fc3_y = 0.025375_rk*ww3_xy - 0.861795_rk*neg_lam3_22
    fc3_z = 0.05075_rk*alpha3_y + 1.72359_rk*neg_alpha3_x
    ! link 3: moment that turns the link [N m]
    nc3_x = 0.861795_rk*neg_a3_z - (1.485880273_rk*neg_alpha3_x + 0.021347277_rk*alpha3_y)
    nc3_y = 0.887930225_rk*alpha3_y + 0.021347277_rk*neg_alpha3_x - 0.025375_rk*neg_a3_z
    neg_nc3_z = 0.298975024_rk*ww3_xy - 0.0106736385_rk*(neg_lam3_11 - neg_lam3_22) + &
        (0.025375_rk*a3_y + 0.861795_rk*neg_a3_x)
    ! link 4: moment that turns the link [N m]
    nc4_y = 0.2013_rk*neg_ww4_zx
    nc4_x = 0.1119_rk*ww4_yz + 0.0894_rk*neg_alpha4_x
    neg_nc4_z = 0.0894_rk*neg_ww4_xy + 0.1119_rk*alpha3_y
    ! link 5: force that moves the link [N]
    fc5_x = 0.00288_rk*neg_lam5_12
    fc5_y = 0.00288_rk*neg_lam5_22
    fc5_z = 0.00288_rk*neg_lam5_32
    ! link 5: moment that turns the link [N m]
    nc5_y = 0.0897_rk*neg_lam5_31
    neg_nc5_x = 0.09003436_rk*neg_lam5_32 + 0.00288_rk*a4_y
    nc5_z = 0.0897_rk*lam5_21 + 0.09003436_rk*neg_lam5_12 + 0.00288_rk*a5_x
    ! link 6: moment that turns the link [N m]
    nc6_x = 0.193_rk*ww6_yz
    nc6_y = 0.193_rk*neg_ww6_zx
    nc6_z = -0.193_rk*alpha5_y
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    n06_x = c6*nc6_x - s6*nc6_y
    n06_y = s6*nc6_x + c6*nc6_y
    ! link 5: moment through the joint, about the frame's origin [N m]
    neg_n5_x = neg_nc5_x - n06_x
    n5_y = nc5_y - nc6_z
    n5_z = nc5_z + n06_y
    ! link 5: force through the joint, along the axes that its turn starts from [N]
    f05_x = c5*fc5_x - s5*fc5_y
    f05_y = s5*fc5_x + c5*fc5_y
    ! link 5: moment through the joint, along the axes that its turn starts from [N m]
    neg_n05_x = c5*neg_n5_x + s5*n5_y
    neg_n05_y = s5*neg_n5_x - c5*n5_y
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = nc4_x - neg_n05_x
    n4_y = nc4_y + n5_z
    n4_z = neg_n05_y - neg_nc4_z
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
    neg_f3_y = neg_fc3_y - f05_y
    f3_z = fc3_z + f04_y
    ! link 3: force through the joint, along the axes that its turn starts from [N]
    f03_x = c23*f3_x + s23*neg_f3_y
    f03_y = s23*f3_x - c23*neg_f3_y
    ! link 3: moment through the joint, along the axes that its turn starts from [N m]
    n03_y = s23*n3_x + c23*n3_y
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_y = n03_y - (s2*neg_nc2_x - c2*nc2_y + t2*f3_z)
    n02_z = n3_z + (nc2_z + (t2*f03_y - t3*f03_x))
    ! link 2: force through the joint, along the axes that its turn starts from [N]
    f02_x = f03_x - (c2*neg_fc2_x + s2*fc2_y)
    ! link 1: moment through the joint, about the frame's origin [N m]
    neg_n1_z = n02_y + 0.1501_rk*f02_x
    ! link 1: forward substitution
    y1 = tau(1) + neg_n1_z
    ! factorisation M = L D L^T
    neg_ipivot1 = 1.0_rk / neg_m1_1
    neg_l2_1 = m1_2*neg_ipivot1
    neg_l3_1 = m1_3*neg_ipivot1
    l4_1 = neg_m1_4*neg_ipivot1
    neg_l5_1 = m1_5*neg_ipivot1
    l6_1 = nu3_y*neg_ipivot1
    neg_pivot2 = neg_m2_2 - m1_2*neg_l2_1
    neg_ipivot2 = 1.0_rk / neg_pivot2
    ld3_2 = m2_3 + m1_2*neg_l3_1
    neg_l3_2 = neg_ipivot2*ld3_2
    ld4_2 = m2_4 - m1_2*l4_1
    neg_l4_2 = neg_ipivot2*ld4_2
    ld5_2 = m2_5 + m1_2*neg_l5_1
    neg_l5_2 = neg_ipivot2*ld5_2
    ld6_2 = nu4_y - m1_2*l6_1
    neg_l6_2 = neg_ipivot2*ld6_2
    pivot3 = m3_3 + m1_3*neg_l3_1 + ld3_2*neg_l3_2
    ipivot3 = 1.0_rk / pivot3
    ld4_3 = m3_4 - m1_3*l4_1 + ld3_2*neg_l4_2
    l4_3 = ipivot3*ld4_3
    ld5_3 = m3_5 + m1_3*neg_l5_1 + ld3_2*neg_l5_2
    l5_3 = ipivot3*ld5_3
    ld6_3 = nu4_y - m1_3*l6_1 + ld3_2*neg_l6_2
    l6_3 = ipivot3*ld6_3
    pivot4 = m4_4 + neg_m1_4*l4_1 + ld4_2*neg_l4_2 - ld4_3*l4_3
    ipivot4 = 1.0_rk / pivot4
    neg_ld5_4 = neg_m1_4*neg_l5_1 - ld4_2*neg_l5_2 + ld4_3*l5_3
    neg_l5_4 = ipivot4*neg_ld5_4
    ld6_4 = neg_nu5_y + neg_m1_4*l6_1 + ld4_2*neg_l6_2 - ld4_3*l6_3
    l6_4 = ipivot4*ld6_4
    pivot5 = m1_5*neg_l5_1 + 0.17973436_rk + ld5_2*neg_l5_2 - ld5_3*l5_3 - neg_ld5_4*neg_l5_4
    ipivot5 = 1.0_rk / pivot5
    neg_ld6_5 = m1_5*l6_1 - ld5_2*neg_l6_2 + ld5_3*l6_3 - neg_ld5_4*l6_4
    neg_l6_5 = ipivot5*neg_ld6_5
    pivot6 = nu3_y*l6_1 + 0.193_rk + ld6_2*neg_l6_2 - ld6_3*l6_3 - ld6_4*l6_4 - neg_ld6_5*neg_l6_5
    ipivot6 = 1.0_rk / pivot6
    ! link 2: forward substitution
    y2 = tau(2) - n02_z + y1*neg_l2_1
    ! link 3: forward substitution
    y3 = tau(3) - n3_z + y1*neg_l3_1 + neg_l3_2*y2
    ! link 4: forward substitution
    y4 = tau(4) - n4_z - y1*l4_1 + neg_l4_2*y2 - l4_3*y3
    ! link 5: forward substitution
    y5 = tau(5) - n5_z + y1*neg_l5_1 + neg_l5_2*y2 - l5_3*y3 + neg_l5_4*y4
    ! link 6: forward substitution
    y6 = tau(6) - nc6_z - y1*l6_1 + neg_l6_2*y2 - l6_3*y3 - l6_4*y4 + neg_l6_5*y5
    ! link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd6 = ipivot6*y6
    ! link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd5 = ipivot5*y5 + neg_l6_5*qdd6
    ! link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd4 = ipivot4*y4 + neg_l5_4*qdd5 - l6_4*qdd6
    ! link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd3 = ipivot3*y3 - l4_3*qdd4 - l5_3*qdd5 - l6_3*qdd6
    ! link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd2 = neg_l6_2*qdd6 - (neg_ipivot2*y2 - neg_l3_2*qdd3 - neg_l4_2*qdd4 - neg_l5_2*qdd5)
    ! link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd1 = -l6_1*qdd6 - (y1*neg_ipivot1 - neg_l2_1*qdd2 - neg_l3_1*qdd3 + l4_1*qdd4 - &
        neg_l5_1*qdd5)
    qdd(1) = qdd1
    qdd(2) = qdd2
    qdd(3) = qdd3
    qdd(4) = qdd4
    qdd(5) = qdd5
    qdd(6) = qdd6
  end subroutine
end module
