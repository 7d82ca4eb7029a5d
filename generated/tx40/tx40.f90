! tx40: Staubli TX40 (CAD parameters; friction, rotor inertia and the wrist coupling are not in
!   it)
! Numbers: figaroh-plus examples/staubli_TX40, Apache-2.0
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
!   inverse_dynamics: 194 multiplications, 182 additions = 376; 4 unary minus; 8 sine/cosine
!   gravity: 30 multiplications, 17 additions = 47; 0 unary minus; 8 sine/cosine
!   bias: 179 multiplications, 152 additions = 331; 6 unary minus; 8 sine/cosine
!   mass_matrix: 88 multiplications, 80 additions = 168; 0 unary minus; 8 sine/cosine
module tx40_dynamics
  use, intrinsic :: iso_c_binding, only: rk => c_double
  implicit none
  private

  public :: tx40_inverse_dynamics
  public :: tx40_gravity
  public :: tx40_bias
  public :: tx40_mass_matrix

contains

  ! torques that give the accelerations qdd
  ! 194 multiplications, 182 additions = 376; 4 unary minus; 8 sine/cosine
  pure subroutine tx40_inverse_dynamics(q, qd, qdd, tau) &
      bind(c, name="tx40_inverse_dynamics_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(in) :: qdd(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: c2, s2, c4, s4, c5, s5, angle23, c23, s23, w3_z, alpha3_z, t1, w2_x, w2_y, ww2_yz
    real(rk) :: ww2_zx, alpha2_x, alpha2_y, ww2_xy, ww2_xx, ww2_yy, ww2_zz, neg_lam2_11, lam2_12
    real(rk) :: lam2_13, lam2_21, neg_lam2_22, lam2_23, neg_lam2_31, lam2_32, neg_lam2_33, a3_z
    real(rk) :: w3_x, w3_y, t2, t3, t4, t5, neg_a3_x, a3_y, ww3_yz, ww3_zx, alpha3_x, neg_alpha3_y
    real(rk) :: ww3_xy, ww3_xx, ww3_yy, ww3_zz, neg_lam3_11, lam3_12, lam3_13, lam3_21, neg_lam3_22
    real(rk) :: lam3_23, lam3_31, lam3_32, neg_lam3_33, neg_a4_z, w4_x, w4_y, t6, t7, a4_x, a4_y
    real(rk) :: alpha4_x, alpha4_y, alpha4_z, w4_z, ww4_yz, ww4_zx, ww4_xy, ww4_xx, ww4_yy, ww4_zz
    real(rk) :: neg_lam4_11, lam4_12, lam4_13, lam4_21, neg_lam4_22, lam4_23, neg_lam4_31, lam4_32
    real(rk) :: neg_lam4_33, w5_x, t8, w5_y, a5_x, a5_y, alpha5_x, alpha5_y, alpha5_z, w5_z, ww5_yz
    real(rk) :: ww5_zx, ww5_xy, ww5_xx, ww5_yy, ww5_zz, neg_lam5_11, lam5_12, lam5_13, lam5_21
    real(rk) :: neg_lam5_22, lam5_23, neg_lam5_31, lam5_32, neg_lam5_33, nc1_z, nc2_x, neg_nc2_y
    real(rk) :: t9, nc2_z, fc3_x, fc3_y, fc3_z, nc3_x, nc3_y, t10, nc3_z, fc4_x, fc4_y, fc4_z
    real(rk) :: nc4_x, nc4_y, t11, nc4_z, fc5_x, fc5_y, fc5_z, nc5_x, nc5_y, t12, nc5_z, f05_x
    real(rk) :: f05_y, n05_x, n05_y, n4_x, n4_y, n4_z, f4_x, f4_y, f4_z, f04_x, f04_y, n04_x, n04_y
    real(rk) :: n3_x, n3_y, n3_z, f3_x, f3_y, f3_z, f03_x, f03_y, n03_y, t13, n02_y, n02_z, n1_z

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
    ! link 3: angular velocity [rad/s]
    w3_z = qd(2) + qd(3)
    ! link 3: angular acceleration [rad/s^2]
    alpha3_z = qdd(2) + qdd(3)
    t1 = -qd(1)
    ! link 2: angular velocity [rad/s]
    w2_x = t1*s2
    w2_y = t1*c2
    ! link 2: products of the angular velocity [1/s^2]
    ww2_yz = qd(2)*w2_y
    ww2_zx = qd(2)*w2_x
    ! link 2: angular acceleration [rad/s^2]
    alpha2_x = ww2_yz - qdd(1)*s2
    alpha2_y = -qdd(1)*c2 - ww2_zx
    ! link 2: products of the angular velocity [1/s^2]
    ww2_xy = w2_x*w2_y
    ww2_xx = w2_x*w2_x
    ww2_yy = w2_y*w2_y
    ww2_zz = qd(2)*qd(2)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_11 = ww2_yy + ww2_zz
    lam2_12 = ww2_xy - qdd(2)
    lam2_13 = ww2_zx + alpha2_y
    lam2_21 = qdd(2) + ww2_xy
    neg_lam2_22 = ww2_xx + ww2_zz
    lam2_23 = ww2_yz - alpha2_x
    neg_lam2_31 = alpha2_y - ww2_zx
    lam2_32 = ww2_yz + alpha2_x
    neg_lam2_33 = ww2_xx + ww2_yy
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_z = -0.035_rk*neg_lam2_33 - 0.225_rk*neg_lam2_31
    ! link 3: angular velocity [rad/s]
    w3_x = t1*s23
    w3_y = t1*c23
    t2 = 0.225_rk*neg_lam2_11 - 0.035_rk*lam2_13
    t3 = 0.225_rk*lam2_21 + 0.035_rk*lam2_23
    t4 = c2*t2 + s2*t3
    t5 = s2*t2 - c2*t3 + 9.81_rk
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a3_x = c23*t4 + s23*t5
    a3_y = s23*t4 - c23*t5
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
    neg_a4_z = a3_y + 0.225_rk*neg_lam3_22
    ! link 4: angular velocity [rad/s]
    w4_x = c4*w3_x + s4*w3_z
    w4_y = c4*w3_z - s4*w3_x
    t6 = a3_z - 0.225_rk*lam3_32
    t7 = neg_a3_x + 0.225_rk*lam3_12
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_x = s4*t6 - c4*t7
    a4_y = s4*t7 + c4*t6
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
    neg_lam4_31 = alpha4_y - ww4_zx
    lam4_32 = alpha4_x + ww4_yz
    neg_lam4_33 = ww4_xx + ww4_yy
    ! link 5: angular velocity [rad/s]
    w5_x = c5*w4_x - s5*w4_z
    t8 = -c5
    w5_y = t8*w4_z - s5*w4_x
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_x = c5*a4_x + s5*neg_a4_z
    a5_y = c5*neg_a4_z - s5*a4_x
    ! link 5: angular acceleration [rad/s^2]
    alpha5_x = qd(5)*w5_y - (s5*alpha4_z - c5*alpha4_x)
    alpha5_y = t8*alpha4_z - s5*alpha4_x - qd(5)*w5_x
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
    ! link 1: moment that turns the link [N m]
    nc1_z = 0.14677892_rk*qdd(1)
    ! link 2: moment that turns the link [N m]
    nc2_x = 0.0007848_rk*neg_lam2_31 - 0.1602936_rk*lam2_21 - (-0.0345144_rk*lam2_32 - &
        0.0010352_rk*(neg_lam2_22 - neg_lam2_33))
    neg_nc2_y = -0.0010352_rk*lam2_12 - 0.0007848_rk*lam2_32 - (0.49934035_rk*neg_lam2_31 - &
        0.1602936_rk*(neg_lam2_11 - neg_lam2_33))
    t9 = 0.49934035_rk*lam2_21 - 0.0345144_rk*lam2_12 - 0.0007848_rk*(neg_lam2_11 - neg_lam2_22) - &
        (0.0010352_rk*lam2_13 - 0.1602936_rk*lam2_23)
    nc2_z = t9 - (23.5160415_rk*c2 + 0.070632_rk*s2)
    ! link 3: force that moves the link [N]
    fc3_x = -0.03256_rk*neg_lam3_11 - 0.67724_rk*lam3_12
    fc3_y = 0.03256_rk*lam3_21 + 0.67724_rk*neg_lam3_22
    fc3_z = 0.03256_rk*lam3_31 - 0.67724_rk*lam3_32
    ! link 3: moment that turns the link [N m]
    nc3_x = -0.67724_rk*a3_z - (-0.1258139_rk*lam3_32 - 0.00200122_rk*(neg_lam3_22 - neg_lam3_33) &
        + (0.00233496_rk*lam3_21 - 0.00019536_rk*lam3_31))
    nc3_y = -0.00226048_rk*lam3_31 - 0.00233496_rk*(neg_lam3_11 - neg_lam3_33) - &
        (0.00019536_rk*lam3_32 - 0.00200122_rk*lam3_12) - 0.03256_rk*a3_z
    t10 = 0.00226048_rk*lam3_21 - 0.1258139_rk*lam3_12 + 0.00019536_rk*(neg_lam3_11 - neg_lam3_22) &
        - (0.00200122_rk*lam3_13 - 0.00233496_rk*lam3_23)
    nc3_z = t10 + (0.03256_rk*a3_y - 0.67724_rk*neg_a3_x)
    ! link 4: force that moves the link [N]
    fc4_x = 0.01448_rk*neg_lam4_11 + 0.00622_rk*lam4_12
    fc4_y = -0.00622_rk*neg_lam4_22 - 0.01448_rk*lam4_21
    fc4_z = 0.01448_rk*neg_lam4_31 + 0.00622_rk*lam4_32
    ! link 4: moment that turns the link [N m]
    nc4_x = -0.00622_rk*neg_a4_z - (0.00077468_rk*(neg_lam4_22 - neg_lam4_33) - &
        0.0030155_rk*lam4_32 - (2.896e-05_rk*neg_lam4_31 - 0.00254936_rk*lam4_21))
    nc4_y = 0.00155792_rk*neg_lam4_31 - 0.00254936_rk*(neg_lam4_11 - neg_lam4_33) + &
        (2.896e-05_rk*lam4_32 - 0.00077468_rk*lam4_12) - 0.01448_rk*neg_a4_z
    t11 = 0.00155792_rk*lam4_21 - 0.0030155_rk*lam4_12 - 2.896e-05_rk*(neg_lam4_11 - neg_lam4_22) &
        + (0.00254936_rk*lam4_23 + 0.00077468_rk*lam4_13)
    nc4_z = t11 - (0.01448_rk*a4_y + 0.00622_rk*a4_x)
    ! link 5: force that moves the link [N]
    fc5_x = 0.00408_rk*neg_lam5_11 - 0.01146_rk*lam5_12
    fc5_y = 0.01146_rk*neg_lam5_22 - 0.00408_rk*lam5_21
    fc5_z = 0.00408_rk*neg_lam5_31 - 0.01146_rk*lam5_32
    ! link 5: moment that turns the link [N m]
    nc5_x = -0.01146_rk*a4_y - (-0.00086198_rk*lam5_32 - 3.06e-06_rk*(neg_lam5_22 - neg_lam5_33) + &
        (1.224e-05_rk*neg_lam5_31 + 4.08e-06_rk*lam5_21))
    nc5_y = 0.00051632_rk*neg_lam5_31 - 4.08e-06_rk*(neg_lam5_11 - neg_lam5_33) - &
        (1.224e-05_rk*lam5_32 - 3.06e-06_rk*lam5_12) + 0.00408_rk*a4_y
    t12 = 0.00051632_rk*lam5_21 - 0.00086198_rk*lam5_12 - 1.224e-05_rk*(neg_lam5_22 - neg_lam5_11) &
        + (4.08e-06_rk*lam5_23 - 3.06e-06_rk*lam5_13)
    nc5_z = t12 - (0.00408_rk*a5_y - 0.01146_rk*a5_x)
    ! link 5: force through the joint, along the axes that its turn starts from [N]
    f05_x = c5*fc5_x - s5*fc5_y
    f05_y = s5*fc5_x + c5*fc5_y
    ! link 5: moment through the joint, along the axes that its turn starts from [N m]
    n05_x = c5*nc5_x - s5*nc5_y
    n05_y = s5*nc5_x + c5*nc5_y
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = nc4_x + n05_x
    n4_y = nc4_y + nc5_z
    n4_z = nc4_z - n05_y
    ! link 4: force through the joint [N]
    f4_x = fc4_x + f05_x
    f4_y = fc4_y + fc5_z
    f4_z = fc4_z - f05_y
    ! link 4: force through the joint, along the axes that its turn starts from [N]
    f04_x = c4*f4_x - s4*f4_y
    f04_y = s4*f4_x + c4*f4_y
    ! link 4: moment through the joint, along the axes that its turn starts from [N m]
    n04_x = c4*n4_x - s4*n4_y
    n04_y = s4*n4_x + c4*n4_y
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_x = n04_x - (0.225_rk*f04_y - nc3_x)
    n3_y = nc3_y - n4_z
    n3_z = n04_y + (nc3_z + 0.225_rk*f04_x)
    ! link 3: force through the joint [N]
    f3_x = fc3_x + f04_x
    f3_y = fc3_y - f4_z
    f3_z = fc3_z + f04_y
    ! link 3: force through the joint, along the axes that its turn starts from [N]
    f03_x = c23*f3_x - s23*f3_y
    f03_y = s23*f3_x + c23*f3_y
    ! link 3: moment through the joint, along the axes that its turn starts from [N m]
    n03_y = s23*n3_x + c23*n3_y
    t13 = 0.225_rk*c2
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_y = n03_y - (c2*neg_nc2_y - s2*nc2_x + (f3_z*t13 - 0.035_rk*f03_x))
    n02_z = n3_z + (nc2_z - (f03_x*(0.225_rk*s2) - f03_y*t13))
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = nc1_z - n02_y
    tau(1) = n1_z
    tau(2) = n02_z
    tau(3) = n3_z
    tau(4) = n4_z
    tau(5) = nc5_z
    tau(6) = 0.0_rk
  end subroutine

  ! torques that hold the arm at rest
  ! 30 multiplications, 17 additions = 47; 0 unary minus; 8 sine/cosine
  pure subroutine tx40_gravity(q, tau) &
      bind(c, name="tx40_gravity_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: c2, s2, c4, s4, c5, s5, angle23, c23, s23, a3_x, a3_y, a4_x, neg_a4_y, a5_x, a5_y
    real(rk) :: neg_nc2_z, neg_nc3_z, nc4_x, nc4_y, nc4_z, nc5_x, nc5_y, nc5_z, n05_x, n05_y, n4_x
    real(rk) :: n4_y, n4_z, n04_x, n04_y, n3_z, neg_n03_y, n02_z

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
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_x = -9.81_rk*s23
    a3_y = -9.81_rk*c23
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_x = c4*a3_x
    neg_a4_y = s4*a3_x
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_x = c5*a4_x + s5*a3_y
    a5_y = c5*a3_y - s5*a4_x
    ! link 2: moment that turns the link [N m]
    neg_nc2_z = 23.5160415_rk*c2 + 0.070632_rk*s2
    ! link 3: moment that turns the link [N m]
    neg_nc3_z = 0.3194136_rk*c23 + 6.6437244_rk*s23
    ! link 4: moment that turns the link [N m]
    nc4_x = 0.0610182_rk*c23
    nc4_y = 0.1420488_rk*c23
    nc4_z = 0.01448_rk*neg_a4_y - 0.00622_rk*a4_x
    ! link 5: moment that turns the link [N m]
    nc5_x = 0.01146_rk*neg_a4_y
    nc5_y = -0.00408_rk*neg_a4_y
    nc5_z = 0.01146_rk*a5_x - 0.00408_rk*a5_y
    ! link 5: moment through the joint, along the axes that its turn starts from [N m]
    n05_x = c5*nc5_x - s5*nc5_y
    n05_y = s5*nc5_x + c5*nc5_y
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = nc4_x + n05_x
    n4_y = nc4_y + nc5_z
    n4_z = nc4_z - n05_y
    ! link 4: moment through the joint, along the axes that its turn starts from [N m]
    n04_x = c4*n4_x - s4*n4_y
    n04_y = s4*n4_x + c4*n4_y
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_z = n04_y - neg_nc3_z
    ! link 3: moment through the joint, along the axes that its turn starts from [N m]
    neg_n03_y = c23*n4_z - s23*n04_x
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_z = n3_z - neg_nc2_z
    tau(1) = neg_n03_y
    tau(2) = n02_z
    tau(3) = n3_z
    tau(4) = n4_z
    tau(5) = nc5_z
    tau(6) = 0.0_rk
  end subroutine

  ! torques at zero acceleration: Coriolis, centrifugal, gravity, friction
  ! 179 multiplications, 152 additions = 331; 6 unary minus; 8 sine/cosine
  pure subroutine tx40_bias(q, qd, tau) &
      bind(c, name="tx40_bias_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: c2, s2, c4, s4, c5, s5, angle23, c23, s23, w3_z, neg_w2_x, neg_w2_y, neg_alpha2_x
    real(rk) :: alpha2_y, ww2_xy, ww2_xx, ww2_yy, ww2_zz, neg_lam2_11, neg_lam2_22, neg_lam2_33
    real(rk) :: a3_z, t1, w3_x, w3_y, t2, t3, t4, t5, neg_a3_x, a3_y, alpha3_x, alpha3_y, ww3_xy
    real(rk) :: ww3_xx, ww3_yy, ww3_zz, neg_lam3_11, neg_lam3_22, neg_lam3_33, neg_a4_z, w4_x, w4_y
    real(rk) :: t6, t7, a4_x, a4_y, alpha4_x, alpha4_y, w4_z, ww4_yz, ww4_zx, ww4_xy, ww4_xx
    real(rk) :: ww4_yy, ww4_zz, neg_lam4_11, lam4_12, lam4_13, lam4_21, neg_lam4_22, lam4_23
    real(rk) :: neg_lam4_31, lam4_32, neg_lam4_33, w5_x, w5_y, a5_x, a5_y, alpha5_x, alpha5_y, w5_z
    real(rk) :: ww5_yz, ww5_zx, ww5_xy, ww5_xx, ww5_yy, ww5_zz, neg_lam5_11, lam5_12, lam5_13
    real(rk) :: lam5_21, neg_lam5_22, lam5_23, neg_lam5_31, lam5_32, neg_lam5_33, nc2_x, nc2_y
    real(rk) :: nc2_z, fc3_x, fc3_y, fc3_z, nc3_x, nc3_y, nc3_z, fc4_x, fc4_y, fc4_z, nc4_x, nc4_y
    real(rk) :: t8, nc4_z, fc5_x, fc5_y, fc5_z, nc5_x, nc5_y, t9, nc5_z, f05_x, f05_y, n05_x, n05_y
    real(rk) :: n4_x, n4_y, n4_z, f4_x, f4_y, f4_z, f04_x, f04_y, n04_x, n04_y, n3_x, n3_y, n3_z
    real(rk) :: f3_x, f3_y, f3_z, f03_x, f03_y, n03_y, t10, neg_n02_y, n02_z

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
    ! link 3: angular velocity [rad/s]
    w3_z = qd(2) + qd(3)
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
    a3_z = -0.035_rk*neg_lam2_33 - 0.45_rk*alpha2_y
    t1 = -qd(1)
    ! link 3: angular velocity [rad/s]
    w3_x = t1*s23
    w3_y = t1*c23
    t2 = 0.225_rk*neg_lam2_11
    t3 = 0.225_rk*ww2_xy
    t4 = c2*t2 + s2*t3
    t5 = s2*t2 - c2*t3 + 9.81_rk
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
    neg_a4_z = a3_y + 0.225_rk*neg_lam3_22
    ! link 4: angular velocity [rad/s]
    w4_x = c4*w3_x + s4*w3_z
    w4_y = c4*w3_z - s4*w3_x
    t6 = a3_z - 0.45_rk*alpha3_x
    t7 = neg_a3_x + 0.225_rk*ww3_xy
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
    neg_lam4_31 = alpha4_y - ww4_zx
    lam4_32 = alpha4_x + ww4_yz
    neg_lam4_33 = ww4_xx + ww4_yy
    ! link 5: angular velocity [rad/s]
    w5_x = c5*w4_x - s5*w4_z
    w5_y = -c5*w4_z - s5*w4_x
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_x = c5*a4_x + s5*neg_a4_z
    a5_y = c5*neg_a4_z - s5*a4_x
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
    ! link 2: moment that turns the link [N m]
    nc2_x = 0.0015696_rk*alpha2_y - 0.1602936_rk*ww2_xy - (0.0690288_rk*neg_alpha2_x - &
        0.0010352_rk*(neg_lam2_22 - neg_lam2_33))
    nc2_y = 0.9986807_rk*alpha2_y - 0.1602936_rk*(neg_lam2_11 - neg_lam2_33) + &
        (0.0010352_rk*ww2_xy - 0.0015696_rk*neg_alpha2_x)
    nc2_z = 0.46482595_rk*ww2_xy - 0.0007848_rk*(neg_lam2_11 - neg_lam2_22) - (23.5160415_rk*c2 + &
        0.070632_rk*s2)
    ! link 3: force that moves the link [N]
    fc3_x = -0.03256_rk*neg_lam3_11 - 0.67724_rk*ww3_xy
    fc3_y = 0.03256_rk*ww3_xy + 0.67724_rk*neg_lam3_22
    fc3_z = -1.35448_rk*alpha3_x - 0.06512_rk*alpha3_y
    ! link 3: moment that turns the link [N m]
    nc3_x = -0.67724_rk*a3_z - (-0.2516278_rk*alpha3_x - 0.00200122_rk*(neg_lam3_22 - neg_lam3_33) &
        + (0.00039072_rk*alpha3_y + 0.00233496_rk*ww3_xy))
    nc3_y = 0.00452096_rk*alpha3_y - 0.00233496_rk*(neg_lam3_11 - neg_lam3_33) + &
        (0.00200122_rk*ww3_xy - 0.00039072_rk*alpha3_x) - 0.03256_rk*a3_z
    nc3_z = 0.03256_rk*a3_y - 0.67724_rk*neg_a3_x - (0.12355342_rk*ww3_xy - &
        0.00019536_rk*(neg_lam3_11 - neg_lam3_22))
    ! link 4: force that moves the link [N]
    fc4_x = 0.01448_rk*neg_lam4_11 + 0.00622_rk*lam4_12
    fc4_y = -0.00622_rk*neg_lam4_22 - 0.01448_rk*lam4_21
    fc4_z = 0.01448_rk*neg_lam4_31 + 0.00622_rk*lam4_32
    ! link 4: moment that turns the link [N m]
    nc4_x = -0.00622_rk*neg_a4_z - (0.00077468_rk*(neg_lam4_22 - neg_lam4_33) - &
        0.0030155_rk*lam4_32 - (2.896e-05_rk*neg_lam4_31 - 0.00254936_rk*lam4_21))
    nc4_y = 0.00155792_rk*neg_lam4_31 - 0.00254936_rk*(neg_lam4_11 - neg_lam4_33) - &
        (0.00077468_rk*lam4_12 - 2.896e-05_rk*lam4_32) - 0.01448_rk*neg_a4_z
    t8 = 0.0030155_rk*lam4_12 - 0.00155792_rk*lam4_21 + 2.896e-05_rk*(neg_lam4_11 - neg_lam4_22) - &
        (0.00254936_rk*lam4_23 + 0.00077468_rk*lam4_13)
    nc4_z = -0.00622_rk*a4_x - 0.01448_rk*a4_y - t8
    ! link 5: force that moves the link [N]
    fc5_x = 0.00408_rk*neg_lam5_11 - 0.01146_rk*lam5_12
    fc5_y = 0.01146_rk*neg_lam5_22 - 0.00408_rk*lam5_21
    fc5_z = 0.00408_rk*neg_lam5_31 - 0.01146_rk*lam5_32
    ! link 5: moment that turns the link [N m]
    nc5_x = -0.01146_rk*a4_y - (-0.00086198_rk*lam5_32 - 3.06e-06_rk*(neg_lam5_22 - neg_lam5_33) + &
        (1.224e-05_rk*neg_lam5_31 + 4.08e-06_rk*lam5_21))
    nc5_y = 0.00051632_rk*neg_lam5_31 - 4.08e-06_rk*(neg_lam5_11 - neg_lam5_33) - &
        (1.224e-05_rk*lam5_32 - 3.06e-06_rk*lam5_12) + 0.00408_rk*a4_y
    t9 = 0.00051632_rk*lam5_21 - 0.00086198_rk*lam5_12 - 1.224e-05_rk*(neg_lam5_22 - neg_lam5_11) &
        + (4.08e-06_rk*lam5_23 - 3.06e-06_rk*lam5_13)
    nc5_z = t9 - (0.00408_rk*a5_y - 0.01146_rk*a5_x)
    ! link 5: force through the joint, along the axes that its turn starts from [N]
    f05_x = c5*fc5_x - s5*fc5_y
    f05_y = s5*fc5_x + c5*fc5_y
    ! link 5: moment through the joint, along the axes that its turn starts from [N m]
    n05_x = c5*nc5_x - s5*nc5_y
    n05_y = s5*nc5_x + c5*nc5_y
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = nc4_x + n05_x
    n4_y = nc4_y + nc5_z
    n4_z = nc4_z - n05_y
    ! link 4: force through the joint [N]
    f4_x = fc4_x + f05_x
    f4_y = fc4_y + fc5_z
    f4_z = fc4_z - f05_y
    ! link 4: force through the joint, along the axes that its turn starts from [N]
    f04_x = c4*f4_x - s4*f4_y
    f04_y = s4*f4_x + c4*f4_y
    ! link 4: moment through the joint, along the axes that its turn starts from [N m]
    n04_x = c4*n4_x - s4*n4_y
    n04_y = s4*n4_x + c4*n4_y
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_x = n04_x - (0.225_rk*f04_y - nc3_x)
    n3_y = nc3_y - n4_z
    n3_z = n04_y + (nc3_z + 0.225_rk*f04_x)
    ! link 3: force through the joint [N]
    f3_x = fc3_x + f04_x
    f3_y = fc3_y - f4_z
    f3_z = fc3_z + f04_y
    ! link 3: force through the joint, along the axes that its turn starts from [N]
    f03_x = c23*f3_x - s23*f3_y
    f03_y = s23*f3_x + c23*f3_y
    ! link 3: moment through the joint, along the axes that its turn starts from [N m]
    n03_y = s23*n3_x + c23*n3_y
    t10 = 0.225_rk*c2
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    neg_n02_y = -c2*nc2_y - s2*nc2_x + (f3_z*t10 - 0.035_rk*f03_x) - n03_y
    n02_z = n3_z + (nc2_z - (f03_x*(0.225_rk*s2) - f03_y*t10))
    tau(1) = neg_n02_y
    tau(2) = n02_z
    tau(3) = n3_z
    tau(4) = n4_z
    tau(5) = nc5_z
    tau(6) = 0.0_rk
  end subroutine

  ! mass matrix, rotor inertias on its diagonal
  ! 88 multiplications, 80 additions = 168; 0 unary minus; 8 sine/cosine
  pure subroutine tx40_mass_matrix(q, M) &
      bind(c, name="tx40_mass_matrix_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(out) :: M(36)
    real(rk) :: c2, s2, c4, s4, c5, s5, angle23, c23, s23, h5_x, neg_h5_y, t1, t2, t3, k5_yy
    real(rk) :: neg_k5_xy, k5_xz, k5_yz, fu4_x, fu4_y, neg_nu4_x, nu4_y, m3_5, fu3_x, fu3_y
    real(rk) :: neg_nu3_y, t4, neg_nu2_y, t5, m2_5, m4_4, t6, neg_h4_x, neg_h4_y, t7, t8, t9, t10
    real(rk) :: t11, k4_yy, neg_k4_xy, t12, t13, k4_xz, k4_yz, m3_4, fu3_x_2, fu3_y_2, t14
    real(rk) :: neg_nu3_y_2, neg_nu2_y_2, m2_4, t15, m3_3, t16, t17, h3_x, neg_h3_y, t18, k3_xx
    real(rk) :: k3_yy, k3_yz, t19, neg_nu2_y_3, m2_3, t20, k2_zz, t21, m2_2, k2_xx, k2_yz, m1_1

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
    ! link 5: first moment of the composite body, about the frame's origin [kg m]
    h5_x = 0.01146_rk*s5 - 0.00408_rk*c5
    neg_h5_y = 0.00408_rk*s5 + 0.01146_rk*c5
    t1 = c5*c5
    t2 = c5*s5
    t3 = 0.00034566_rk*t1 + 2.448e-05_rk*t2
    ! link 5: second moment of the composite body [kg m^2]
    k5_yy = t3 + 0.00051632_rk
    neg_k5_xy = 0.00034566_rk*t2 + 1.224e-05_rk*(1.0_rk - 2.0_rk*t1)
    k5_xz = 4.08e-06_rk*c5 - 3.06e-06_rk*s5
    k5_yz = 4.08e-06_rk*s5 + 3.06e-06_rk*c5
    ! link 4: force for a unit acceleration of a joint further out
    fu4_x = c4*neg_h5_y
    fu4_y = s4*neg_h5_y
    ! link 4: moment for a unit acceleration of a joint further out
    neg_nu4_x = c4*k5_xz + 0.0013783_rk*s4
    nu4_y = 0.0013783_rk*c4 - s4*k5_xz
    ! link 3: mass matrix, its row of this joint
    m3_5 = nu4_y + 0.225_rk*fu4_x
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x = c23*fu4_x - s23*h5_x
    fu3_y = s23*fu4_x + c23*h5_x
    ! link 3: moment for a unit acceleration of a joint further out
    neg_nu3_y = s23*(neg_nu4_x + 0.225_rk*fu4_y) + c23*k5_yz
    t4 = 0.225_rk*c2
    ! link 2: moment for a unit acceleration of a joint further out
    neg_nu2_y = neg_nu3_y + (t4*fu4_y - 0.035_rk*fu3_x)
    t5 = 0.225_rk*s2
    ! link 2: mass matrix, its row of this joint
    m2_5 = m3_5 + (t4*fu3_y - t5*fu3_x)
    ! link 4: mass matrix, its row of this joint
    m4_4 = 0.0054354_rk - t3
    t6 = 0.01448_rk - h5_x
    ! link 4: first moment of the composite body, about the frame's origin [kg m]
    neg_h4_x = c4*t6 + 0.00622_rk*s4
    neg_h4_y = s4*t6 - 0.00622_rk*c4
    t7 = c4*c4
    t8 = t3 + 0.0005956_rk
    t9 = k5_xz - 2.896e-05_rk
    t10 = c4*s4
    t11 = t7*t8 + t9*(2.0_rk*t10)
    ! link 4: second moment of the composite body [kg m^2]
    k4_yy = t11 - (t3 - 0.0024199_rk)
    neg_k4_xy = t8*t10 + t9*(1.0_rk - 2.0_rk*t7)
    t12 = neg_k5_xy + 0.00254936_rk
    t13 = k5_yz + 0.00077468_rk
    k4_xz = c4*t12 + s4*t13
    k4_yz = s4*t12 - c4*t13
    ! link 3: mass matrix, its row of this joint
    m3_4 = 0.225_rk*neg_h4_y - k4_yz
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x_2 = c23*neg_h4_y
    fu3_y_2 = s23*neg_h4_y
    t14 = k4_xz - 0.225_rk*neg_h4_x
    ! link 3: moment for a unit acceleration of a joint further out
    neg_nu3_y_2 = s23*t14 + c23*m4_4
    ! link 2: moment for a unit acceleration of a joint further out
    neg_nu2_y_2 = neg_nu3_y_2 + (-0.035_rk*fu3_x_2 - t4*neg_h4_x)
    ! link 2: mass matrix, its row of this joint
    m2_4 = m3_4 + (t4*fu3_y_2 - t5*fu3_x_2)
    t15 = k5_yy + 0.45_rk*neg_h5_y
    ! link 3: mass matrix, its row of this joint
    m3_3 = 0.13108988_rk - (t11 - t15)
    t16 = neg_h5_y + 0.67724_rk
    t17 = neg_h4_x - 0.03256_rk
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    h3_x = s23*t16 - c23*t17
    neg_h3_y = s23*t17 + c23*t16
    t18 = c23*c23*(t11 + t15 + 0.12053792_rk) - (t14 - 0.00019536_rk)*(2.0_rk*(c23*s23))
    ! link 3: second moment of the composite body [kg m^2]
    k3_xx = t15 + 0.1258139_rk - t18
    k3_yy = t18 - (t11 - 0.00527598_rk)
    k3_yz = s23*(0.00233496_rk - neg_k4_xy) + c23*(m3_4 + 0.00200122_rk)
    t19 = 0.035_rk*neg_h3_y
    ! link 2: moment for a unit acceleration of a joint further out
    neg_nu2_y_3 = k3_yz - t19
    ! link 2: mass matrix, its row of this joint
    m2_3 = m3_3 - (t5*neg_h3_y - t4*h3_x)
    t20 = k3_yy - k4_yy
    ! link 2: second moment of the composite body [kg m^2]
    k2_zz = -0.07_rk*neg_h4_y - (t20 - k3_yy)
    t21 = k3_xx - t4*(-2.0_rk*h3_x)
    ! link 2: mass matrix, its row of this joint
    m2_2 = t21 - (t5*(2.0_rk*neg_h3_y) - (k4_yy + t20)) + 0.53385475_rk
    ! link 2: second moment of the composite body [kg m^2]
    k2_xx = t21 + (0.46482595_rk*(c2*c2) + 0.0015696_rk*(c2*s2) + 0.0345144_rk)
    k2_yz = 0.1602936_rk*s2 + 0.0010352_rk*c2 - (t19 - (k3_yz - t5*neg_h4_y))
    ! link 1: mass matrix, its row of this joint
    m1_1 = k2_zz + k2_xx + 0.14677892_rk
    M(1) = m1_1
    M(2) = k2_yz
    M(3) = neg_nu2_y_3
    M(4) = neg_nu2_y_2
    M(5) = neg_nu2_y
    M(6) = 0.0_rk
    M(7) = k2_yz
    M(8) = m2_2
    M(9) = m2_3
    M(10) = m2_4
    M(11) = m2_5
    M(12) = 0.0_rk
    M(13) = neg_nu2_y_3
    M(14) = m2_3
    M(15) = m3_3
    M(16) = m3_4
    M(17) = m3_5
    M(18) = 0.0_rk
    M(19) = neg_nu2_y_2
    M(20) = m2_4
    M(21) = m3_4
    M(22) = m4_4
    M(23) = k5_yz
    M(24) = 0.0_rk
    M(25) = neg_nu2_y
    M(26) = m2_5
    M(27) = m3_5
    M(28) = k5_yz
    M(29) = 0.0013783_rk
    M(30) = 0.0_rk
    M(31) = 0.0_rk
    M(32) = 0.0_rk
    M(33) = 0.0_rk
    M(34) = 0.0_rk
    M(35) = 0.0_rk
    M(36) = 0.0_rk
  end subroutine
end module
