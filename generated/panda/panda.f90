! panda: Franka Emika Panda, hand locked
! Numbers: URDF of example-robot-data (franka_description, Apache-2.0), turned into modified DH;
!   fingers locked at the neutral pose
! Written by robodyn; do not edit, generate again.
!
! Joints, base to tip: 1 revolute, 2 revolute, 3 revolute, 4 revolute, 5 revolute, 6 revolute, 7
!   revolute
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
!   inverse_dynamics: 308 multiplications, 292 additions = 600; 8 unary minus; 12 sine/cosine
!   gravity: 64 multiplications, 38 additions = 102; 1 unary minus; 12 sine/cosine
!   bias: 300 multiplications, 273 additions = 573; 8 unary minus; 12 sine/cosine
!   mass_matrix: 203 multiplications, 173 additions = 376; 7 unary minus; 12 sine/cosine
!   forward_dynamics: 629 multiplications, 551 additions, 7 divisions = 1187; 22 unary minus; 12
!       sine/cosine
module panda_dynamics
  use, intrinsic :: iso_c_binding, only: rk => c_double
  implicit none
  private

  public :: panda_inverse_dynamics
  public :: panda_gravity
  public :: panda_bias
  public :: panda_mass_matrix
  public :: panda_forward_dynamics

contains

  ! torques that give the accelerations qdd
  ! 308 multiplications, 292 additions = 600; 8 unary minus; 12 sine/cosine
  pure subroutine panda_inverse_dynamics(q, qd, qdd, tau) &
      bind(c, name="panda_inverse_dynamics_f")
    real(rk), intent(in) :: q(7)
    real(rk), intent(in) :: qd(7)
    real(rk), intent(in) :: qdd(7)
    real(rk), intent(out) :: tau(7)
    real(rk) :: c2, s2, c3, s3, c4, s4, c5, s5, c6, s6, c7, s7, t1, w2_x, w2_y, neg_a2_x, neg_a2_y
    real(rk) :: ww2_yz, ww2_zx, alpha2_x, neg_alpha2_y, ww2_xy, ww2_xx, ww2_yy, ww2_zz, neg_lam2_11
    real(rk) :: lam2_12, lam2_13, lam2_21, neg_lam2_22, lam2_23, lam2_31, lam2_32, neg_lam2_33
    real(rk) :: a3_z, w3_x, w3_y, t2, t3, a3_x, a3_y, alpha3_x, alpha3_y, alpha3_z, w3_z, ww3_yz
    real(rk) :: ww3_zx, ww3_xy, ww3_xx, ww3_yy, ww3_zz, neg_lam3_11, lam3_12, lam3_13, lam3_21
    real(rk) :: neg_lam3_22, lam3_23, lam3_31, lam3_32, neg_lam3_33, neg_a4_z, t4, w4_x, w4_y, t5
    real(rk) :: t6, a4_x, neg_a4_y, alpha4_x, neg_alpha4_y, alpha4_z, w4_z, ww4_yz, ww4_zx, ww4_xy
    real(rk) :: ww4_xx, ww4_yy, ww4_zz, neg_lam4_11, lam4_12, lam4_13, lam4_21, neg_lam4_22
    real(rk) :: neg_lam4_23, lam4_31, lam4_32, neg_lam4_33, a5_z, w5_x, w5_y, t7, t8, a5_x, a5_y
    real(rk) :: alpha5_x, alpha5_y, alpha5_z, w5_z, ww5_yz, ww5_zx, ww5_xy, ww5_xx, ww5_yy, ww5_zz
    real(rk) :: neg_lam5_11, lam5_12, lam5_13, lam5_21, neg_lam5_22, lam5_23, lam5_31, lam5_32
    real(rk) :: neg_lam5_33, w6_x, w6_y, a6_x, a6_y, alpha6_x, alpha6_y, alpha6_z, w6_z, ww6_yz
    real(rk) :: ww6_zx, ww6_xy, ww6_xx, ww6_yy, ww6_zz, neg_lam6_11, lam6_12, lam6_13, lam6_21
    real(rk) :: neg_lam6_22, lam6_23, lam6_31, lam6_32, neg_lam6_33, neg_a7_z, w7_x, w7_y, t9, t10
    real(rk) :: neg_a7_x, a7_y, alpha7_x, alpha7_y, alpha7_z, w7_z, ww7_yz, ww7_zx, ww7_xy, ww7_xx
    real(rk) :: ww7_yy, ww7_zz, neg_lam7_11, lam7_12, lam7_13, lam7_21, neg_lam7_22, lam7_23
    real(rk) :: neg_lam7_31, lam7_32, neg_lam7_33, nc1_z, nc2_x, nc2_y, t11, nc2_z, fc3_x, fc3_y
    real(rk) :: nc3_x, nc3_y, t12, nc3_z, fc4_x, fc4_y, fc4_z, nc4_x, nc4_y, t13, nc4_z, fc5_x
    real(rk) :: fc5_y, fc5_z, nc5_x, nc5_y, t14, nc5_z, fc6_x, fc6_y, fc6_z, nc6_x, nc6_y, t15
    real(rk) :: nc6_z, fc7_x, fc7_y, fc7_z, nc7_x, nc7_y, t16, nc7_z, f07_x, f07_y, n07_x, n07_y
    real(rk) :: n6_x, n6_y, n6_z, f6_x, f6_y, f6_z, f06_x, f06_y, n06_x, n06_y, n5_x, n5_y, n5_z
    real(rk) :: f5_x, f5_y, f5_z, f05_x, neg_f05_y, n05_x, n05_y, n4_x, n4_y, n4_z, f4_x, f4_y
    real(rk) :: f4_z, f04_x, f04_y, n04_x, neg_n04_y, n3_x, n3_y, n3_z, f3_x, f3_y, f03_x, f03_y
    real(rk) :: n03_x, n03_y, n2_x, neg_n2_y, n2_z, n02_y, n1_z

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
    t1 = -qd(1)
    ! link 2: angular velocity [rad/s]
    w2_x = t1*s2
    w2_y = t1*c2
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a2_x = 9.81_rk*s2
    neg_a2_y = 9.81_rk*c2
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
    a3_z = neg_a2_y - 0.316_rk*neg_lam2_22
    ! link 3: angular velocity [rad/s]
    w3_x = c3*w2_x + qd(2)*s3
    w3_y = qd(2)*c3 - s3*w2_x
    t2 = -0.316_rk*lam2_32
    t3 = neg_a2_x + 0.316_rk*lam2_12
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_x = s3*t2 - c3*t3
    a3_y = s3*t3 + c3*t2
    ! link 3: angular acceleration [rad/s^2]
    alpha3_x = qd(3)*w3_y - (-qdd(2)*s3 - c3*alpha2_x)
    alpha3_y = qdd(2)*c3 - s3*alpha2_x - qd(3)*w3_x
    alpha3_z = qdd(3) + neg_alpha2_y
    ! link 3: angular velocity [rad/s]
    w3_z = qd(3) - w2_y
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
    neg_lam3_22 = ww3_xx + ww3_zz
    lam3_23 = ww3_yz - alpha3_x
    lam3_31 = ww3_zx - alpha3_y
    lam3_32 = alpha3_x + ww3_yz
    neg_lam3_33 = ww3_xx + ww3_yy
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a4_z = a3_y + 0.0825_rk*lam3_21
    t4 = -s4
    ! link 4: angular velocity [rad/s]
    w4_x = t4*w3_z - c4*w3_x
    w4_y = s4*w3_x - c4*w3_z
    t5 = 0.0825_rk*neg_lam3_11 - a3_x
    t6 = a3_z + 0.0825_rk*lam3_31
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_x = c4*t5 - s4*t6
    neg_a4_y = s4*t5 + c4*t6
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = t4*alpha3_z - c4*alpha3_x + qd(4)*w4_y
    neg_alpha4_y = c4*alpha3_z - s4*alpha3_x + qd(4)*w4_x
    alpha4_z = qdd(4) - alpha3_y
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
    lam4_13 = ww4_zx - neg_alpha4_y
    lam4_21 = alpha4_z + ww4_xy
    neg_lam4_22 = ww4_xx + ww4_zz
    neg_lam4_23 = alpha4_x - ww4_yz
    lam4_31 = neg_alpha4_y + ww4_zx
    lam4_32 = alpha4_x + ww4_yz
    neg_lam4_33 = ww4_xx + ww4_yy
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_z = neg_a4_y + (-0.384_rk*neg_lam4_22 - 0.0825_rk*lam4_21)
    ! link 5: angular velocity [rad/s]
    w5_x = -s5*w4_z - c5*w4_x
    w5_y = s5*w4_x - c5*w4_z
    t7 = neg_a4_z + (0.384_rk*lam4_32 - 0.0825_rk*lam4_31)
    t8 = a4_x - (0.0825_rk*neg_lam4_11 + 0.384_rk*lam4_12)
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_x = s5*t7 - c5*t8
    a5_y = s5*t8 + c5*t7
    ! link 5: angular acceleration [rad/s^2]
    alpha5_x = qd(5)*w5_y - (c5*alpha4_x + s5*alpha4_z)
    alpha5_y = s5*alpha4_x - c5*alpha4_z - qd(5)*w5_x
    alpha5_z = qdd(5) + neg_alpha4_y
    ! link 5: angular velocity [rad/s]
    w5_z = qd(5) - w4_y
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
    a6_x = c6*a5_x + s6*a5_z
    a6_y = c6*a5_z - s6*a5_x
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
    lam6_31 = ww6_zx - alpha6_y
    lam6_32 = alpha6_x + ww6_yz
    neg_lam6_33 = ww6_xx + ww6_yy
    ! link 7: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a7_z = a6_y + 0.088_rk*lam6_21
    ! link 7: angular velocity [rad/s]
    w7_x = c7*w6_x + s7*w6_z
    w7_y = c7*w6_z - s7*w6_x
    t9 = 0.088_rk*neg_lam6_11 - a6_x
    t10 = a5_y - 0.088_rk*lam6_31
    ! link 7: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a7_x = c7*t9 + s7*t10
    a7_y = s7*t9 - c7*t10
    ! link 7: angular acceleration [rad/s^2]
    alpha7_x = qd(7)*w7_y - (-s7*alpha6_z - c7*alpha6_x)
    alpha7_y = c7*alpha6_z - s7*alpha6_x - qd(7)*w7_x
    alpha7_z = qdd(7) - alpha6_y
    ! link 7: angular velocity [rad/s]
    w7_z = qd(7) - w6_y
    ! link 7: products of the angular velocity [1/s^2]
    ww7_yz = w7_y*w7_z
    ww7_zx = w7_x*w7_z
    ww7_xy = w7_x*w7_y
    ww7_xx = w7_x*w7_x
    ww7_yy = w7_y*w7_y
    ww7_zz = w7_z*w7_z
    ! link 7: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam7_11 = ww7_yy + ww7_zz
    lam7_12 = ww7_xy - alpha7_z
    lam7_13 = alpha7_y + ww7_zx
    lam7_21 = alpha7_z + ww7_xy
    neg_lam7_22 = ww7_xx + ww7_zz
    lam7_23 = ww7_yz - alpha7_x
    neg_lam7_31 = alpha7_y - ww7_zx
    lam7_32 = alpha7_x + ww7_yz
    neg_lam7_33 = ww7_xx + ww7_yy
    ! link 1: moment that turns the link [N m]
    nc1_z = 0.014259565994474374_rk*qdd(1)
    ! link 2: moment that turns the link [N m]
    nc2_x = 0.003983358883935522_rk*lam2_31 + 0.010261101821008168_rk*lam2_21 - &
        (0.0007689361029464017_rk*(neg_lam2_22 - neg_lam2_33) - 1.0321620612318807_rk*lam2_32)
    nc2_y = 0.010261101821008168_rk*(neg_lam2_11 - neg_lam2_33) - 0.023077882494931805_rk*lam2_31 &
        + (-0.0007689361029464017_rk*lam2_12 - 0.003983358883935522_rk*lam2_32)
    t11 = 0.023077882494931805_rk*lam2_21 - 1.0321620612318807_rk*lam2_12 + &
        0.003983358883935522_rk*(neg_lam2_11 - neg_lam2_22) + (0.0007689361029464017_rk*lam2_13 - &
        0.010261101821008168_rk*lam2_23)
    nc2_z = t11 + (0.01993386669246_rk*c2 - 32.809545426852715_rk*s2)
    ! link 3: force that moves the link [N]
    fc3_x = 0.028227094877999827_rk*lam3_12 - 0.746857959872_rk*neg_lam3_11
    fc3_y = 0.746857959872_rk*lam3_21 - 0.028227094877999827_rk*neg_lam3_22
    ! link 3: moment that turns the link [N m]
    nc3_x = 0.028227094877999827_rk*a3_z - (-0.022178148964878252_rk*lam3_32 - &
        0.0043772571218395765_rk*(neg_lam3_22 - neg_lam3_33) + (0.005487648106562251_rk*lam3_21 - &
        0.0001219124209507298_rk*lam3_31))
    nc3_y = -0.061602421026527694_rk*lam3_31 - 0.005487648106562251_rk*(neg_lam3_11 - neg_lam3_33) &
        - (0.0001219124209507298_rk*lam3_32 - 0.0043772571218395765_rk*lam3_12) - &
        0.746857959872_rk*a3_z
    t12 = 0.061602421026527694_rk*lam3_21 - 0.022178148964878252_rk*lam3_12 + &
        0.0001219124209507298_rk*(neg_lam3_11 - neg_lam3_22) + (0.005487648106562251_rk*lam3_23 - &
        0.0043772571218395765_rk*lam3_13)
    nc3_z = t12 + (0.746857959872_rk*a3_y - 0.028227094877999827_rk*a3_x)
    ! link 4: force that moves the link [N]
    fc4_x = -0.5527802746499999_rk*neg_lam4_11 - 2.0125235536029997_rk*lam4_12
    fc4_y = 0.5527802746499999_rk*lam4_21 + 2.0125235536029997_rk*neg_lam4_22
    fc4_z = 0.5527802746499999_rk*lam4_31 - 2.0125235536029997_rk*lam4_32
    ! link 4: moment that turns the link [N m]
    nc4_x = 0.6972920750309717_rk*lam4_32 - 0.00164448757736928_rk*(neg_lam4_22 - neg_lam4_33) - &
        (0.16284087268546082_rk*lam4_31 + 0.0039053550262761055_rk*lam4_21) + &
        2.0125235536029997_rk*neg_a4_z
    nc4_y = 0.5527802746499999_rk*neg_a4_z - (0.05102013615681549_rk*lam4_31 + &
        0.0039053550262761055_rk*(neg_lam4_11 - neg_lam4_33) - (0.16284087268546082_rk*lam4_32 - &
        0.00164448757736928_rk*lam4_12))
    t13 = 0.05102013615681549_rk*lam4_21 - 0.6972920750309717_rk*lam4_12 - &
        0.16284087268546082_rk*(neg_lam4_11 - neg_lam4_22) - (0.0039053550262761055_rk*neg_lam4_23 &
        - 0.00164448757736928_rk*lam4_13)
    nc4_z = t13 - (0.5527802746499999_rk*neg_a4_y - 2.0125235536029997_rk*a4_x)
    ! link 5: force that moves the link [N]
    fc5_x = 0.014653732538_rk*neg_lam5_11 + 0.067870631425_rk*lam5_12
    fc5_y = -0.067870631425_rk*neg_lam5_22 - 0.014653732538_rk*lam5_21
    fc5_z = 0.067870631425_rk*lam5_32 - 0.014653732538_rk*lam5_31
    ! link 5: moment that turns the link [N m]
    nc5_x = 0.067870631425_rk*a5_z - (0.0021640520520981327_rk*(neg_lam5_22 - neg_lam5_33) - &
        0.010045187828321245_rk*lam5_32 + (0.004600245517563107_rk*lam5_21 - &
        0.00151524447332703_rk*lam5_31))
    nc5_y = -0.001451156065026714_rk*lam5_31 - 0.004600245517563107_rk*(neg_lam5_11 - neg_lam5_33) &
        + (-0.0021640520520981327_rk*lam5_12 - 0.00151524447332703_rk*lam5_32) + &
        0.014653732538_rk*a5_z
    t14 = 0.001451156065026714_rk*lam5_21 - 0.010045187828321245_rk*lam5_12 + &
        0.00151524447332703_rk*(neg_lam5_11 - neg_lam5_22) + (0.004600245517563107_rk*lam5_23 + &
        0.0021640520520981327_rk*lam5_13)
    nc5_z = t14 - (0.014653732538_rk*a5_y + 0.067870631425_rk*a5_x)
    ! link 6: force that moves the link [N]
    fc6_x = -0.231847552695_rk*neg_lam6_11 - 0.17380470556899996_rk*lam6_12
    fc6_y = 0.231847552695_rk*lam6_21 + 0.17380470556899996_rk*neg_lam6_22
    fc6_z = 0.231847552695_rk*lam6_31 - 0.17380470556899996_rk*lam6_32
    ! link 6: moment that turns the link [N m]
    nc6_x = 0.17380470556899996_rk*a5_y - (9.35690973146064e-05_rk*(neg_lam6_22 - neg_lam6_33) - &
        0.028934422545659907_rk*lam6_32 - (-0.014748570382675314_rk*lam6_31 - &
        0.0001037589172186853_rk*lam6_21))
    nc6_y = -0.021522255370587554_rk*lam6_31 - 0.0001037589172186853_rk*(neg_lam6_11 - &
        neg_lam6_33) + (0.014748570382675314_rk*lam6_32 - 9.35690973146064e-05_rk*lam6_12) + &
        0.231847552695_rk*a5_y
    t15 = 0.021522255370587554_rk*lam6_21 - 0.028934422545659907_rk*lam6_12 - &
        0.014748570382675314_rk*(neg_lam6_11 - neg_lam6_22) + (0.0001037589172186853_rk*lam6_23 + &
        9.35690973146064e-05_rk*lam6_13)
    nc6_z = t15 + (0.231847552695_rk*a6_y + 0.17380470556899996_rk*a6_x)
    ! link 7: force that moves the link [N]
    fc7_x = 0.0020344399586618637_rk*lam7_12 - 0.002573605371338201_rk*neg_lam7_11
    fc7_y = 0.002573605371338201_rk*lam7_21 - 0.0020344399586618637_rk*neg_lam7_22
    fc7_z = 0.0020344399586618637_rk*lam7_32 - 0.002573605371338201_rk*neg_lam7_31
    ! link 7: moment that turns the link [N m]
    nc7_x = -0.0020344399586618637_rk*neg_a7_z - (-0.004552547872941087_rk*lam7_32 - &
        0.0012555365982729084_rk*(neg_lam7_22 - neg_lam7_33) - &
        (0.0003913912816842475_rk*neg_lam7_31 - 0.0009653051699191118_rk*lam7_21))
    nc7_y = 0.00213160409441986_rk*neg_lam7_31 - 0.0009653051699191118_rk*(neg_lam7_11 - &
        neg_lam7_33) - (-0.0012555365982729084_rk*lam7_12 - 0.0003913912816842475_rk*lam7_32) + &
        0.002573605371338201_rk*neg_a7_z
    t16 = 0.00213160409441986_rk*lam7_21 - 0.004552547872941087_rk*lam7_12 - &
        0.0003913912816842475_rk*(neg_lam7_11 - neg_lam7_22) + (0.0009653051699191118_rk*lam7_23 - &
        0.0012555365982729084_rk*lam7_13)
    nc7_z = t16 + (0.002573605371338201_rk*a7_y + 0.0020344399586618637_rk*neg_a7_x)
    ! link 7: force through the joint, along the axes that its turn starts from [N]
    f07_x = c7*fc7_x - s7*fc7_y
    f07_y = s7*fc7_x + c7*fc7_y
    ! link 7: moment through the joint, along the axes that its turn starts from [N m]
    n07_x = c7*nc7_x - s7*nc7_y
    n07_y = s7*nc7_x + c7*nc7_y
    ! link 6: moment through the joint, about the frame's origin [N m]
    n6_x = nc6_x + n07_x
    n6_y = nc6_y - 0.088_rk*f07_y - nc7_z
    n6_z = n07_y + (nc6_z - 0.088_rk*fc7_z)
    ! link 6: force through the joint [N]
    f6_x = fc6_x + f07_x
    f6_y = fc6_y - fc7_z
    f6_z = fc6_z + f07_y
    ! link 6: force through the joint, along the axes that its turn starts from [N]
    f06_x = c6*f6_x - s6*f6_y
    f06_y = s6*f6_x + c6*f6_y
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    n06_x = c6*n6_x - s6*n6_y
    n06_y = s6*n6_x + c6*n6_y
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_x = nc5_x + n06_x
    n5_y = nc5_y - n6_z
    n5_z = nc5_z + n06_y
    ! link 5: force through the joint [N]
    f5_x = fc5_x + f06_x
    f5_y = fc5_y - f6_z
    f5_z = fc5_z + f06_y
    ! link 5: force through the joint, along the axes that its turn starts from [N]
    f05_x = s5*f5_y - c5*f5_x
    neg_f05_y = s5*f5_x + c5*f5_y
    ! link 5: moment through the joint, along the axes that its turn starts from [N m]
    n05_x = s5*n5_y - c5*n5_x
    n05_y = -c5*n5_y - s5*n5_x
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = n05_x + (nc4_x + 0.384_rk*neg_f05_y)
    n4_y = nc4_y + 0.0825_rk*neg_f05_y - n5_z
    n4_z = n05_y + (nc4_z - (0.0825_rk*f5_z - 0.384_rk*f05_x))
    ! link 4: force through the joint [N]
    f4_x = fc4_x + f05_x
    f4_y = fc4_y - f5_z
    f4_z = fc4_z - neg_f05_y
    ! link 4: force through the joint, along the axes that its turn starts from [N]
    f04_x = s4*f4_y - c4*f4_x
    f04_y = -c4*f4_y - s4*f4_x
    ! link 4: moment through the joint, along the axes that its turn starts from [N m]
    n04_x = s4*n4_y - c4*n4_x
    neg_n04_y = s4*n4_x + c4*n4_y
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_x = nc3_x + n04_x
    n3_y = nc3_y - 0.0825_rk*f04_y - n4_z
    n3_z = nc3_z - 0.0825_rk*f4_z - neg_n04_y
    ! link 3: force through the joint [N]
    f3_x = fc3_x + f04_x
    f3_y = fc3_y - f4_z
    ! link 3: force through the joint, along the axes that its turn starts from [N]
    f03_x = c3*f3_x - s3*f3_y
    f03_y = s3*f3_x + c3*f3_y
    ! link 3: moment through the joint, along the axes that its turn starts from [N m]
    n03_x = c3*n3_x - s3*n3_y
    n03_y = s3*n3_x + c3*n3_y
    ! link 2: moment through the joint, about the frame's origin [N m]
    n2_x = n03_x + (nc2_x - 0.316_rk*f03_y)
    neg_n2_y = n3_z - nc2_y
    n2_z = n03_y + (nc2_z + 0.316_rk*f03_x)
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_y = c2*neg_n2_y - s2*n2_x
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = nc1_z + n02_y
    tau(1) = n1_z
    tau(2) = n2_z
    tau(3) = n3_z
    tau(4) = n4_z
    tau(5) = n5_z
    tau(6) = n6_z
    tau(7) = nc7_z
  end subroutine

  ! torques that hold the arm at rest
  ! 64 multiplications, 38 additions = 102; 1 unary minus; 12 sine/cosine
  pure subroutine panda_gravity(q, tau) &
      bind(c, name="panda_gravity_f")
    real(rk), intent(in) :: q(7)
    real(rk), intent(out) :: tau(7)
    real(rk) :: c2, s2, c3, s3, c4, s4, c5, s5, c6, s6, c7, s7, neg_a2_x, neg_a2_y, neg_a3_x, a3_y
    real(rk) :: a4_x, neg_a4_y, a5_x, a5_y, a6_x, a6_y, a7_x, a7_y, nc2_z, nc3_x, nc3_y, nc3_z
    real(rk) :: nc4_x, nc4_y, nc4_z, nc5_x, nc5_y, nc5_z, nc6_x, nc6_y, nc6_z, nc7_x, nc7_y, nc7_z
    real(rk) :: n07_x, n07_y, n6_x, n6_y, n6_z, n06_x, n06_y, n5_x, n5_y, n5_z, n05_x, neg_n05_y
    real(rk) :: n4_x, n4_y, n4_z, n04_x, neg_n04_y, n3_x, n3_y, n3_z, n03_x, n03_y, n2_z, n02_y

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
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a2_x = 9.81_rk*s2
    neg_a2_y = 9.81_rk*c2
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a3_x = c3*neg_a2_x
    a3_y = s3*neg_a2_x
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_x = c4*neg_a3_x - s4*neg_a2_y
    neg_a4_y = s4*neg_a3_x + c4*neg_a2_y
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_x = s5*a3_y - c5*a4_x
    a5_y = s5*a4_x + c5*a3_y
    ! link 6: acceleration of the frame's origin, gravity taken off [m/s^2]
    a6_x = c6*a5_x + s6*neg_a4_y
    a6_y = c6*neg_a4_y - s6*a5_x
    ! link 7: acceleration of the frame's origin, gravity taken off [m/s^2]
    a7_x = c7*a6_x - s7*a5_y
    a7_y = -c7*a5_y - s7*a6_x
    ! link 2: moment that turns the link [N m]
    nc2_z = 0.01993386669246_rk*c2 - 32.809545426852715_rk*s2
    ! link 3: moment that turns the link [N m]
    nc3_x = 0.27690780075317833_rk*c2
    nc3_y = -7.32667658634432_rk*c2
    nc3_z = 0.746857959872_rk*a3_y + 0.028227094877999827_rk*neg_a3_x
    ! link 4: moment that turns the link [N m]
    nc4_x = 2.0125235536029997_rk*a3_y
    nc4_y = 0.5527802746499999_rk*a3_y
    nc4_z = 2.0125235536029997_rk*a4_x - 0.5527802746499999_rk*neg_a4_y
    ! link 5: moment that turns the link [N m]
    nc5_x = 0.067870631425_rk*neg_a4_y
    nc5_y = 0.014653732538_rk*neg_a4_y
    nc5_z = -0.067870631425_rk*a5_x - 0.014653732538_rk*a5_y
    ! link 6: moment that turns the link [N m]
    nc6_x = 0.17380470556899996_rk*a5_y
    nc6_y = 0.231847552695_rk*a5_y
    nc6_z = 0.231847552695_rk*a6_y + 0.17380470556899996_rk*a6_x
    ! link 7: moment that turns the link [N m]
    nc7_x = -0.0020344399586618637_rk*a6_y
    nc7_y = 0.002573605371338201_rk*a6_y
    nc7_z = 0.002573605371338201_rk*a7_y - 0.0020344399586618637_rk*a7_x
    ! link 7: moment through the joint, along the axes that its turn starts from [N m]
    n07_x = c7*nc7_x - s7*nc7_y
    n07_y = s7*nc7_x + c7*nc7_y
    ! link 6: moment through the joint, about the frame's origin [N m]
    n6_x = nc6_x + n07_x
    n6_y = nc6_y - nc7_z
    n6_z = nc6_z + n07_y
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    n06_x = c6*n6_x - s6*n6_y
    n06_y = s6*n6_x + c6*n6_y
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_x = nc5_x + n06_x
    n5_y = nc5_y - n6_z
    n5_z = nc5_z + n06_y
    ! link 5: moment through the joint, along the axes that its turn starts from [N m]
    n05_x = s5*n5_y - c5*n5_x
    neg_n05_y = s5*n5_x + c5*n5_y
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = nc4_x + n05_x
    n4_y = nc4_y - n5_z
    n4_z = nc4_z - neg_n05_y
    ! link 4: moment through the joint, along the axes that its turn starts from [N m]
    n04_x = s4*n4_y - c4*n4_x
    neg_n04_y = s4*n4_x + c4*n4_y
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_x = nc3_x + n04_x
    n3_y = nc3_y - n4_z
    n3_z = nc3_z - neg_n04_y
    ! link 3: moment through the joint, along the axes that its turn starts from [N m]
    n03_x = c3*n3_x - s3*n3_y
    n03_y = s3*n3_x + c3*n3_y
    ! link 2: moment through the joint, about the frame's origin [N m]
    n2_z = nc2_z + n03_y
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_y = c2*n3_z - s2*n03_x
    tau(1) = n02_y
    tau(2) = n2_z
    tau(3) = n3_z
    tau(4) = n4_z
    tau(5) = n5_z
    tau(6) = n6_z
    tau(7) = nc7_z
  end subroutine

  ! torques at zero acceleration: Coriolis, centrifugal, gravity, friction
  ! 300 multiplications, 273 additions = 573; 8 unary minus; 12 sine/cosine
  pure subroutine panda_bias(q, qd, tau) &
      bind(c, name="panda_bias_f")
    real(rk), intent(in) :: q(7)
    real(rk), intent(in) :: qd(7)
    real(rk), intent(out) :: tau(7)
    real(rk) :: c2, s2, c3, s3, c4, s4, c5, s5, c6, s6, c7, s7, t1, w2_x, w2_y, neg_a2_x, neg_a2_y
    real(rk) :: alpha2_x, neg_alpha2_y, ww2_xy, ww2_xx, ww2_yy, ww2_zz, neg_lam2_11, neg_lam2_22
    real(rk) :: neg_lam2_33, a3_z, w3_x, w3_y, t2, t3, a3_x, a3_y, alpha3_x, alpha3_y, w3_z, ww3_yz
    real(rk) :: ww3_zx, ww3_xy, ww3_xx, ww3_yy, ww3_zz, neg_lam3_11, lam3_12, lam3_13, lam3_21
    real(rk) :: neg_lam3_22, lam3_23, lam3_31, lam3_32, neg_lam3_33, a4_z, t4, w4_x, w4_y, t5, t6
    real(rk) :: a4_x, neg_a4_y, t7, alpha4_x, neg_alpha4_y, w4_z, ww4_yz, ww4_zx, ww4_xy, ww4_xx
    real(rk) :: ww4_yy, ww4_zz, neg_lam4_11, lam4_12, lam4_13, lam4_21, neg_lam4_22, neg_lam4_23
    real(rk) :: lam4_31, lam4_32, neg_lam4_33, a5_z, w5_x, w5_y, t8, t9, a5_x, a5_y, alpha5_x
    real(rk) :: alpha5_y, w5_z, ww5_yz, ww5_zx, ww5_xy, ww5_xx, ww5_yy, ww5_zz, neg_lam5_11
    real(rk) :: lam5_12, lam5_13, lam5_21, neg_lam5_22, lam5_23, lam5_31, lam5_32, neg_lam5_33
    real(rk) :: w6_x, w6_y, a6_x, a6_y, alpha6_x, alpha6_y, w6_z, ww6_yz, ww6_zx, ww6_xy, ww6_xx
    real(rk) :: ww6_yy, ww6_zz, neg_lam6_11, lam6_12, lam6_13, lam6_21, neg_lam6_22, lam6_23
    real(rk) :: lam6_31, lam6_32, neg_lam6_33, a7_z, w7_x, w7_y, t10, t11, neg_a7_x, a7_y, alpha7_x
    real(rk) :: alpha7_y, w7_z, ww7_yz, ww7_zx, ww7_xy, ww7_xx, ww7_yy, ww7_zz, neg_lam7_11
    real(rk) :: lam7_12, lam7_13, lam7_21, neg_lam7_22, lam7_23, neg_lam7_31, lam7_32, neg_lam7_33
    real(rk) :: nc2_x, nc2_y, nc2_z, fc3_x, fc3_y, nc3_x, nc3_y, t12, nc3_z, fc4_x, fc4_y, fc4_z
    real(rk) :: nc4_x, nc4_y, t13, neg_nc4_z, fc5_x, fc5_y, fc5_z, nc5_x, nc5_y, t14, nc5_z, fc6_x
    real(rk) :: fc6_y, fc6_z, nc6_x, nc6_y, t15, nc6_z, fc7_x, fc7_y, fc7_z, nc7_x, nc7_y, t16
    real(rk) :: nc7_z, f07_x, f07_y, n07_x, n07_y, n6_x, n6_y, n6_z, f6_x, f6_y, f6_z, f06_x, f06_y
    real(rk) :: n06_x, n06_y, n5_x, n5_y, n5_z, f5_x, f5_y, f5_z, f05_x, neg_f05_y, n05_x, n05_y
    real(rk) :: n4_x, n4_y, n4_z, f4_x, f4_y, f4_z, f04_x, f04_y, n04_x, n04_y, n3_x, n3_y, n3_z
    real(rk) :: f3_x, f3_y, neg_f03_x, f03_y, n03_x, n03_y, n2_x, neg_n2_y, n2_z, n02_y

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
    t1 = -qd(1)
    ! link 2: angular velocity [rad/s]
    w2_x = t1*s2
    w2_y = t1*c2
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a2_x = 9.81_rk*s2
    neg_a2_y = 9.81_rk*c2
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
    neg_lam2_22 = ww2_xx + ww2_zz
    neg_lam2_33 = ww2_xx + ww2_yy
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_z = neg_a2_y - 0.316_rk*neg_lam2_22
    ! link 3: angular velocity [rad/s]
    w3_x = c3*w2_x + qd(2)*s3
    w3_y = qd(2)*c3 - s3*w2_x
    t2 = -0.632_rk*alpha2_x
    t3 = neg_a2_x + 0.316_rk*ww2_xy
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_x = s3*t2 - c3*t3
    a3_y = s3*t3 + c3*t2
    ! link 3: angular acceleration [rad/s^2]
    alpha3_x = c3*alpha2_x + qd(3)*w3_y
    alpha3_y = -qd(3)*w3_x - s3*alpha2_x
    ! link 3: angular velocity [rad/s]
    w3_z = qd(3) - w2_y
    ! link 3: products of the angular velocity [1/s^2]
    ww3_yz = w3_y*w3_z
    ww3_zx = w3_x*w3_z
    ww3_xy = w3_x*w3_y
    ww3_xx = w3_x*w3_x
    ww3_yy = w3_y*w3_y
    ww3_zz = w3_z*w3_z
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_11 = ww3_yy + ww3_zz
    lam3_12 = ww3_xy - neg_alpha2_y
    lam3_13 = alpha3_y + ww3_zx
    lam3_21 = neg_alpha2_y + ww3_xy
    neg_lam3_22 = ww3_xx + ww3_zz
    lam3_23 = ww3_yz - alpha3_x
    lam3_31 = ww3_zx - alpha3_y
    lam3_32 = alpha3_x + ww3_yz
    neg_lam3_33 = ww3_xx + ww3_yy
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_z = -0.0825_rk*lam3_21 - a3_y
    t4 = -s4
    ! link 4: angular velocity [rad/s]
    w4_x = t4*w3_z - c4*w3_x
    w4_y = s4*w3_x - c4*w3_z
    t5 = 0.0825_rk*neg_lam3_11 - a3_x
    t6 = a3_z + 0.0825_rk*lam3_31
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_x = c4*t5 - s4*t6
    neg_a4_y = s4*t5 + c4*t6
    t7 = -c4
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = t7*alpha3_x - s4*neg_alpha2_y + qd(4)*w4_y
    neg_alpha4_y = c4*neg_alpha2_y - s4*alpha3_x + qd(4)*w4_x
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
    lam4_13 = ww4_zx - neg_alpha4_y
    lam4_21 = ww4_xy - alpha3_y
    neg_lam4_22 = ww4_xx + ww4_zz
    neg_lam4_23 = alpha4_x - ww4_yz
    lam4_31 = neg_alpha4_y + ww4_zx
    lam4_32 = alpha4_x + ww4_yz
    neg_lam4_33 = ww4_xx + ww4_yy
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_z = neg_a4_y + (-0.384_rk*neg_lam4_22 - 0.0825_rk*lam4_21)
    ! link 5: angular velocity [rad/s]
    w5_x = -s5*w4_z - c5*w4_x
    w5_y = s5*w4_x - c5*w4_z
    t8 = 0.384_rk*lam4_32 - 0.0825_rk*lam4_31 - a4_z
    t9 = a4_x - (0.0825_rk*neg_lam4_11 + 0.384_rk*lam4_12)
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_x = s5*t8 - c5*t9
    a5_y = s5*t9 + c5*t8
    ! link 5: angular acceleration [rad/s^2]
    alpha5_x = qd(5)*w5_y - (c5*alpha4_x - s5*alpha3_y)
    alpha5_y = s5*alpha4_x + c5*alpha3_y - qd(5)*w5_x
    ! link 5: angular velocity [rad/s]
    w5_z = qd(5) - w4_y
    ! link 5: products of the angular velocity [1/s^2]
    ww5_yz = w5_y*w5_z
    ww5_zx = w5_x*w5_z
    ww5_xy = w5_x*w5_y
    ww5_xx = w5_x*w5_x
    ww5_yy = w5_y*w5_y
    ww5_zz = w5_z*w5_z
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_11 = ww5_yy + ww5_zz
    lam5_12 = ww5_xy - neg_alpha4_y
    lam5_13 = alpha5_y + ww5_zx
    lam5_21 = neg_alpha4_y + ww5_xy
    neg_lam5_22 = ww5_xx + ww5_zz
    lam5_23 = ww5_yz - alpha5_x
    lam5_31 = ww5_zx - alpha5_y
    lam5_32 = alpha5_x + ww5_yz
    neg_lam5_33 = ww5_xx + ww5_yy
    ! link 6: angular velocity [rad/s]
    w6_x = c6*w5_x + s6*w5_z
    w6_y = c6*w5_z - s6*w5_x
    ! link 6: acceleration of the frame's origin, gravity taken off [m/s^2]
    a6_x = c6*a5_x + s6*a5_z
    a6_y = c6*a5_z - s6*a5_x
    ! link 6: angular acceleration [rad/s^2]
    alpha6_x = qd(6)*w6_y - (-c6*alpha5_x - s6*neg_alpha4_y)
    alpha6_y = c6*neg_alpha4_y - s6*alpha5_x - qd(6)*w6_x
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
    ! link 7: acceleration of the frame's origin, gravity taken off [m/s^2]
    a7_z = -0.088_rk*lam6_21 - a6_y
    ! link 7: angular velocity [rad/s]
    w7_x = c7*w6_x + s7*w6_z
    w7_y = c7*w6_z - s7*w6_x
    t10 = 0.088_rk*neg_lam6_11 - a6_x
    t11 = a5_y - 0.088_rk*lam6_31
    ! link 7: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a7_x = c7*t10 + s7*t11
    a7_y = s7*t10 - c7*t11
    ! link 7: angular acceleration [rad/s^2]
    alpha7_x = qd(7)*w7_y - (s7*alpha5_y - c7*alpha6_x)
    alpha7_y = -c7*alpha5_y - s7*alpha6_x - qd(7)*w7_x
    ! link 7: angular velocity [rad/s]
    w7_z = qd(7) - w6_y
    ! link 7: products of the angular velocity [1/s^2]
    ww7_yz = w7_y*w7_z
    ww7_zx = w7_x*w7_z
    ww7_xy = w7_x*w7_y
    ww7_xx = w7_x*w7_x
    ww7_yy = w7_y*w7_y
    ww7_zz = w7_z*w7_z
    ! link 7: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam7_11 = ww7_yy + ww7_zz
    lam7_12 = alpha6_y + ww7_xy
    lam7_13 = alpha7_y + ww7_zx
    lam7_21 = ww7_xy - alpha6_y
    neg_lam7_22 = ww7_xx + ww7_zz
    lam7_23 = ww7_yz - alpha7_x
    neg_lam7_31 = alpha7_y - ww7_zx
    lam7_32 = alpha7_x + ww7_yz
    neg_lam7_33 = ww7_xx + ww7_yy
    ! link 2: moment that turns the link [N m]
    nc2_x = 0.007966717767871044_rk*neg_alpha2_y + 0.010261101821008168_rk*ww2_xy - &
        (0.0007689361029464017_rk*(neg_lam2_22 - neg_lam2_33) - 2.0643241224637614_rk*alpha2_x)
    nc2_y = 0.010261101821008168_rk*(neg_lam2_11 - neg_lam2_33) - &
        0.04615576498986361_rk*neg_alpha2_y - (0.0007689361029464017_rk*ww2_xy + &
        0.007966717767871044_rk*alpha2_x)
    nc2_z = 0.01993386669246_rk*c2 - 32.809545426852715_rk*s2 - (1.009084178736949_rk*ww2_xy - &
        0.003983358883935522_rk*(neg_lam2_11 - neg_lam2_22))
    ! link 3: force that moves the link [N]
    fc3_x = 0.028227094877999827_rk*lam3_12 - 0.746857959872_rk*neg_lam3_11
    fc3_y = 0.746857959872_rk*lam3_21 - 0.028227094877999827_rk*neg_lam3_22
    ! link 3: moment that turns the link [N m]
    nc3_x = 0.028227094877999827_rk*a3_z - (-0.022178148964878252_rk*lam3_32 - &
        0.0043772571218395765_rk*(neg_lam3_22 - neg_lam3_33) + (0.005487648106562251_rk*lam3_21 - &
        0.0001219124209507298_rk*lam3_31))
    nc3_y = -0.061602421026527694_rk*lam3_31 - 0.005487648106562251_rk*(neg_lam3_11 - neg_lam3_33) &
        + (0.0043772571218395765_rk*lam3_12 - 0.0001219124209507298_rk*lam3_32) - &
        0.746857959872_rk*a3_z
    t12 = 0.022178148964878252_rk*lam3_12 - 0.061602421026527694_rk*lam3_21 - &
        0.0001219124209507298_rk*(neg_lam3_11 - neg_lam3_22) - (0.005487648106562251_rk*lam3_23 - &
        0.0043772571218395765_rk*lam3_13)
    nc3_z = 0.746857959872_rk*a3_y - 0.028227094877999827_rk*a3_x - t12
    ! link 4: force that moves the link [N]
    fc4_x = -0.5527802746499999_rk*neg_lam4_11 - 2.0125235536029997_rk*lam4_12
    fc4_y = 0.5527802746499999_rk*lam4_21 + 2.0125235536029997_rk*neg_lam4_22
    fc4_z = 0.5527802746499999_rk*lam4_31 - 2.0125235536029997_rk*lam4_32
    ! link 4: moment that turns the link [N m]
    nc4_x = 0.6972920750309717_rk*lam4_32 - 0.00164448757736928_rk*(neg_lam4_22 - neg_lam4_33) - &
        (0.16284087268546082_rk*lam4_31 + 0.0039053550262761055_rk*lam4_21) - &
        2.0125235536029997_rk*a4_z
    nc4_y = -0.5527802746499999_rk*a4_z - (0.05102013615681549_rk*lam4_31 + &
        0.0039053550262761055_rk*(neg_lam4_11 - neg_lam4_33) + (0.00164448757736928_rk*lam4_12 - &
        0.16284087268546082_rk*lam4_32))
    t13 = 0.6972920750309717_rk*lam4_12 - 0.05102013615681549_rk*lam4_21 + &
        0.16284087268546082_rk*(neg_lam4_11 - neg_lam4_22) + (0.0039053550262761055_rk*neg_lam4_23 &
        - 0.00164448757736928_rk*lam4_13)
    neg_nc4_z = t13 + (0.5527802746499999_rk*neg_a4_y - 2.0125235536029997_rk*a4_x)
    ! link 5: force that moves the link [N]
    fc5_x = 0.014653732538_rk*neg_lam5_11 + 0.067870631425_rk*lam5_12
    fc5_y = -0.067870631425_rk*neg_lam5_22 - 0.014653732538_rk*lam5_21
    fc5_z = 0.067870631425_rk*lam5_32 - 0.014653732538_rk*lam5_31
    ! link 5: moment that turns the link [N m]
    nc5_x = 0.067870631425_rk*a5_z - (0.0021640520520981327_rk*(neg_lam5_22 - neg_lam5_33) - &
        0.010045187828321245_rk*lam5_32 + (0.004600245517563107_rk*lam5_21 - &
        0.00151524447332703_rk*lam5_31))
    nc5_y = -0.001451156065026714_rk*lam5_31 - 0.004600245517563107_rk*(neg_lam5_11 - neg_lam5_33) &
        + (-0.0021640520520981327_rk*lam5_12 - 0.00151524447332703_rk*lam5_32) + &
        0.014653732538_rk*a5_z
    t14 = 0.001451156065026714_rk*lam5_21 - 0.010045187828321245_rk*lam5_12 + &
        0.00151524447332703_rk*(neg_lam5_11 - neg_lam5_22) + (0.004600245517563107_rk*lam5_23 + &
        0.0021640520520981327_rk*lam5_13)
    nc5_z = t14 - (0.014653732538_rk*a5_y + 0.067870631425_rk*a5_x)
    ! link 6: force that moves the link [N]
    fc6_x = -0.231847552695_rk*neg_lam6_11 - 0.17380470556899996_rk*lam6_12
    fc6_y = 0.231847552695_rk*lam6_21 + 0.17380470556899996_rk*neg_lam6_22
    fc6_z = 0.231847552695_rk*lam6_31 - 0.17380470556899996_rk*lam6_32
    ! link 6: moment that turns the link [N m]
    nc6_x = 0.17380470556899996_rk*a5_y - (9.35690973146064e-05_rk*(neg_lam6_22 - neg_lam6_33) - &
        0.028934422545659907_rk*lam6_32 - (-0.014748570382675314_rk*lam6_31 - &
        0.0001037589172186853_rk*lam6_21))
    nc6_y = -0.021522255370587554_rk*lam6_31 - 0.0001037589172186853_rk*(neg_lam6_11 - &
        neg_lam6_33) - (9.35690973146064e-05_rk*lam6_12 - 0.014748570382675314_rk*lam6_32) + &
        0.231847552695_rk*a5_y
    t15 = 0.028934422545659907_rk*lam6_12 - 0.021522255370587554_rk*lam6_21 + &
        0.014748570382675314_rk*(neg_lam6_11 - neg_lam6_22) - (0.0001037589172186853_rk*lam6_23 + &
        9.35690973146064e-05_rk*lam6_13)
    nc6_z = 0.231847552695_rk*a6_y + 0.17380470556899996_rk*a6_x - t15
    ! link 7: force that moves the link [N]
    fc7_x = 0.0020344399586618637_rk*lam7_12 - 0.002573605371338201_rk*neg_lam7_11
    fc7_y = 0.002573605371338201_rk*lam7_21 - 0.0020344399586618637_rk*neg_lam7_22
    fc7_z = 0.0020344399586618637_rk*lam7_32 - 0.002573605371338201_rk*neg_lam7_31
    ! link 7: moment that turns the link [N m]
    nc7_x = 0.0020344399586618637_rk*a7_z - (-0.004552547872941087_rk*lam7_32 - &
        0.0012555365982729084_rk*(neg_lam7_22 - neg_lam7_33) - &
        (0.0003913912816842475_rk*neg_lam7_31 - 0.0009653051699191118_rk*lam7_21))
    nc7_y = 0.00213160409441986_rk*neg_lam7_31 - 0.0009653051699191118_rk*(neg_lam7_11 - &
        neg_lam7_33) + (0.0012555365982729084_rk*lam7_12 + 0.0003913912816842475_rk*lam7_32) - &
        0.002573605371338201_rk*a7_z
    t16 = 0.004552547872941087_rk*lam7_12 - 0.00213160409441986_rk*lam7_21 + &
        0.0003913912816842475_rk*(neg_lam7_11 - neg_lam7_22) - (0.0009653051699191118_rk*lam7_23 - &
        0.0012555365982729084_rk*lam7_13)
    nc7_z = 0.002573605371338201_rk*a7_y + 0.0020344399586618637_rk*neg_a7_x - t16
    ! link 7: force through the joint, along the axes that its turn starts from [N]
    f07_x = c7*fc7_x - s7*fc7_y
    f07_y = s7*fc7_x + c7*fc7_y
    ! link 7: moment through the joint, along the axes that its turn starts from [N m]
    n07_x = c7*nc7_x - s7*nc7_y
    n07_y = s7*nc7_x + c7*nc7_y
    ! link 6: moment through the joint, about the frame's origin [N m]
    n6_x = nc6_x + n07_x
    n6_y = nc6_y - 0.088_rk*f07_y - nc7_z
    n6_z = n07_y + (nc6_z - 0.088_rk*fc7_z)
    ! link 6: force through the joint [N]
    f6_x = fc6_x + f07_x
    f6_y = fc6_y - fc7_z
    f6_z = fc6_z + f07_y
    ! link 6: force through the joint, along the axes that its turn starts from [N]
    f06_x = c6*f6_x - s6*f6_y
    f06_y = s6*f6_x + c6*f6_y
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    n06_x = c6*n6_x - s6*n6_y
    n06_y = s6*n6_x + c6*n6_y
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_x = nc5_x + n06_x
    n5_y = nc5_y - n6_z
    n5_z = nc5_z + n06_y
    ! link 5: force through the joint [N]
    f5_x = fc5_x + f06_x
    f5_y = fc5_y - f6_z
    f5_z = fc5_z + f06_y
    ! link 5: force through the joint, along the axes that its turn starts from [N]
    f05_x = s5*f5_y - c5*f5_x
    neg_f05_y = s5*f5_x + c5*f5_y
    ! link 5: moment through the joint, along the axes that its turn starts from [N m]
    n05_x = s5*n5_y - c5*n5_x
    n05_y = -c5*n5_y - s5*n5_x
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = n05_x + (nc4_x + 0.384_rk*neg_f05_y)
    n4_y = nc4_y + 0.0825_rk*neg_f05_y - n5_z
    n4_z = n05_y - (neg_nc4_z + (0.0825_rk*f5_z - 0.384_rk*f05_x))
    ! link 4: force through the joint [N]
    f4_x = fc4_x + f05_x
    f4_y = fc4_y - f5_z
    f4_z = fc4_z - neg_f05_y
    ! link 4: force through the joint, along the axes that its turn starts from [N]
    f04_x = s4*f4_y - c4*f4_x
    f04_y = t7*f4_y - s4*f4_x
    ! link 4: moment through the joint, along the axes that its turn starts from [N m]
    n04_x = s4*n4_y - c4*n4_x
    n04_y = t4*n4_x - c4*n4_y
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_x = nc3_x + n04_x
    n3_y = nc3_y - 0.0825_rk*f04_y - n4_z
    n3_z = n04_y - (0.0825_rk*f4_z - nc3_z)
    ! link 3: force through the joint [N]
    f3_x = fc3_x + f04_x
    f3_y = fc3_y - f4_z
    ! link 3: force through the joint, along the axes that its turn starts from [N]
    neg_f03_x = s3*f3_y - c3*f3_x
    f03_y = s3*f3_x + c3*f3_y
    ! link 3: moment through the joint, along the axes that its turn starts from [N m]
    n03_x = c3*n3_x - s3*n3_y
    n03_y = s3*n3_x + c3*n3_y
    ! link 2: moment through the joint, about the frame's origin [N m]
    n2_x = n03_x + (nc2_x - 0.316_rk*f03_y)
    neg_n2_y = n3_z - nc2_y
    n2_z = n03_y - (0.316_rk*neg_f03_x - nc2_z)
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_y = c2*neg_n2_y - s2*n2_x
    tau(1) = n02_y
    tau(2) = n2_z
    tau(3) = n3_z
    tau(4) = n4_z
    tau(5) = n5_z
    tau(6) = n6_z
    tau(7) = nc7_z
  end subroutine

  ! mass matrix, rotor inertias on its diagonal
  ! 203 multiplications, 173 additions = 376; 7 unary minus; 12 sine/cosine
  pure subroutine panda_mass_matrix(q, M) &
      bind(c, name="panda_mass_matrix_f")
    real(rk), intent(in) :: q(7)
    real(rk), intent(out) :: M(49)
    real(rk) :: c2, s2, c3, s3, c4, s4, c5, s5, c6, s6, c7, s7, h7_x, neg_h7_y, t1, t2, t3, k7_xx
    real(rk) :: neg_k7_xy, k7_xz, neg_k7_yz, fu6_x, fu6_y, t4, nu6_x, nu6_y, fu5_x, fu5_y, nu5_x
    real(rk) :: nu5_y, m4_7, fu4_x, fu4_y, t5, t6, t7, nu4_x, nu4_y, m3_7, fu3_x, fu3_y, t8, nu3_x
    real(rk) :: nu3_y, m2_7, nu2_y, t9, m6_6, t10, h6_x, h6_y, t11, t12, t13, t14, t15, k6_yy
    real(rk) :: neg_k6_xy, t16, t17, k6_xz, neg_k6_yz, fu5_x_2, fu5_y_2, nu5_x_2, nu5_y_2, m4_6
    real(rk) :: fu4_x_2, neg_fu4_y, t18, t19, t20, nu4_x_2, nu4_y_2, m3_6, fu3_x_2, fu3_y_2, t21
    real(rk) :: nu3_x_2, nu3_y_2, m2_6, nu2_y_2, m5_5, t22, t23, h5_x, h5_y, t24, t25, t26, t27
    real(rk) :: t28, k5_xx, k5_yy, neg_k5_xy, t29, t30, k5_xz, k5_yz, m4_5, fu4_x_3, fu4_y_2, t31
    real(rk) :: t32, t33, t34, nu4_x_3, nu4_y_3, m3_5, fu3_x_3, fu3_y_3, t35, nu3_x_3, nu3_y_3
    real(rk) :: m2_5, nu2_y_3, t36, t37, m4_4, t38, t39, h4_x, h4_y, t40, t41, t42, t43, t44, k4_xx
    real(rk) :: k4_yy, k4_xy, t45, t46, t47, k4_xz, neg_k4_yz, neg_fu3_x, neg_fu3_y, t48, nu3_x_4
    real(rk) :: neg_nu3_y, m2_4, nu2_y_4, t49, m3_3, t50, t51, h3_x, h3_y, t52, t53, t54, t55, t56
    real(rk) :: k3_xx, neg_k3_yy, k3_xy, t57, t58, k3_xz, k3_yz, m2_3, t59, nu2_y_5, t60, m2_2
    real(rk) :: k2_xx, neg_k2_yz, m1_1

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
    ! link 7: first moment of the composite body, about the frame's origin [kg m]
    h7_x = 0.002573605371338201_rk*c7 - 0.0020344399586618637_rk*s7
    neg_h7_y = -0.0020344399586618637_rk*c7 - 0.002573605371338201_rk*s7
    t1 = c7*c7
    t2 = c7*s7
    t3 = 0.002420943778521227_rk*t1 - 0.000782782563368495_rk*t2
    ! link 7: second moment of the composite body [kg m^2]
    k7_xx = 0.004552547872941087_rk - t3
    neg_k7_xy = 0.002420943778521227_rk*t2 + 0.0003913912816842475_rk*(2.0_rk*t1 - 1.0_rk)
    k7_xz = 0.0009653051699191118_rk*c7 - 0.0012555365982729084_rk*s7
    neg_k7_yz = -0.0012555365982729084_rk*c7 - 0.0009653051699191118_rk*s7
    ! link 6: force for a unit acceleration of a joint further out
    fu6_x = c6*neg_h7_y
    fu6_y = s6*neg_h7_y
    t4 = 0.088_rk*h7_x + 0.006684151967360947_rk
    ! link 6: moment for a unit acceleration of a joint further out
    nu6_x = s6*t4 - c6*k7_xz
    nu6_y = -c6*t4 - s6*k7_xz
    ! link 5: force for a unit acceleration of a joint further out
    fu5_x = -s5*h7_x - c5*fu6_x
    fu5_y = c5*h7_x - s5*fu6_x
    ! link 5: moment for a unit acceleration of a joint further out
    nu5_x = -c5*nu6_x - s5*neg_k7_yz
    nu5_y = c5*neg_k7_yz - s5*nu6_x
    ! link 4: mass matrix, its row of this joint
    m4_7 = nu5_y + (0.384_rk*fu5_x - 0.0825_rk*fu6_y)
    ! link 4: force for a unit acceleration of a joint further out
    fu4_x = -c4*fu5_x - s4*fu6_y
    fu4_y = c4*fu6_y - s4*fu5_x
    t5 = 0.384_rk*fu5_y - nu5_x
    t6 = 0.0825_rk*fu5_y
    t7 = nu6_y + t6
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_x = c4*t5 - s4*t7
    nu4_y = s4*t5 + c4*t7
    ! link 3: mass matrix, its row of this joint
    m3_7 = nu4_y - t6
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x = c3*fu4_x + s3*fu5_y
    fu3_y = s3*fu4_x - c3*fu5_y
    t8 = m4_7 + 0.0825_rk*fu4_y
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_x = c3*nu4_x + s3*t8
    nu3_y = s3*nu4_x - c3*t8
    ! link 2: mass matrix, its row of this joint
    m2_7 = nu3_y + 0.316_rk*fu3_x
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y = c2*m3_7 - s2*(nu3_x - 0.316_rk*fu3_y)
    t9 = k7_xx + 0.176_rk*h7_x
    ! link 6: mass matrix, its row of this joint
    m6_6 = t9 + 0.05045667791624746_rk
    t10 = h7_x + 0.231847552695_rk
    ! link 6: first moment of the composite body, about the frame's origin [kg m]
    h6_x = c6*t10 + 0.17380470556899996_rk*s6
    h6_y = s6*t10 - 0.17380470556899996_rk*c6
    t11 = c6*c6
    t12 = 0.007412167175072353_rk - t9
    t13 = k7_xz + 0.014748570382675314_rk
    t14 = c6*s6
    t15 = t11*t12 - t13*(2.0_rk*t14)
    ! link 6: second moment of the composite body [kg m^2]
    k6_yy = t9 + 0.021522255370587554_rk + t15
    neg_k6_xy = t12*t14 - t13*(1.0_rk - 2.0_rk*t11)
    t16 = 9.35690973146064e-05_rk - neg_k7_yz
    t17 = neg_k7_xy + 0.088_rk*neg_h7_y - 0.0001037589172186853_rk
    k6_xz = s6*t16 - c6*t17
    neg_k6_yz = s6*t17 + c6*t16
    ! link 5: force for a unit acceleration of a joint further out
    fu5_x_2 = c5*h6_y
    fu5_y_2 = s5*h6_y
    ! link 5: moment for a unit acceleration of a joint further out
    nu5_x_2 = c5*k6_xz - s5*m6_6
    nu5_y_2 = s5*k6_xz + c5*m6_6
    ! link 4: mass matrix, its row of this joint
    m4_6 = nu5_y_2 - (0.0825_rk*h6_x - 0.384_rk*fu5_x_2)
    ! link 4: force for a unit acceleration of a joint further out
    fu4_x_2 = -s4*h6_x - c4*fu5_x_2
    neg_fu4_y = s4*fu5_x_2 - c4*h6_x
    t18 = 0.384_rk*fu5_y_2 - nu5_x_2
    t19 = 0.0825_rk*fu5_y_2
    t20 = neg_k6_yz + t19
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_x_2 = c4*t18 - s4*t20
    nu4_y_2 = s4*t18 + c4*t20
    ! link 3: mass matrix, its row of this joint
    m3_6 = nu4_y_2 - t19
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x_2 = c3*fu4_x_2 + s3*fu5_y_2
    fu3_y_2 = s3*fu4_x_2 - c3*fu5_y_2
    t21 = 0.0825_rk*neg_fu4_y - m4_6
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_x_2 = c3*nu4_x_2 - s3*t21
    nu3_y_2 = s3*nu4_x_2 + c3*t21
    ! link 2: mass matrix, its row of this joint
    m2_6 = nu3_y_2 + 0.316_rk*fu3_x_2
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y_2 = c2*m3_6 - s2*(nu3_x_2 - 0.316_rk*fu3_y_2)
    ! link 5: mass matrix, its row of this joint
    m5_5 = t3 - t15 + 0.04256237053342773_rk
    t22 = 0.014653732538_rk - h6_x
    t23 = neg_h7_y + 0.067870631425_rk
    ! link 5: first moment of the composite body, about the frame's origin [kg m]
    h5_x = c5*t22 + s5*t23
    h5_y = s5*t22 - c5*t23
    t24 = c5*c5
    t25 = t3 + t15 - 0.018208786687945514_rk
    t26 = 0.00151524447332703_rk - k6_xz
    t27 = c5*s5
    t28 = t24*t25 + t26*(2.0_rk*t27)
    ! link 5: second moment of the composite body [kg m^2]
    k5_xx = t3 + 0.012176791922741105_rk - t28
    k5_yy = t28 - (t15 - 0.03038557861068662_rk)
    neg_k5_xy = t25*t27 + t26*(1.0_rk - 2.0_rk*t24)
    t29 = neg_k6_xy - 0.004600245517563107_rk
    t30 = neg_k6_yz - 0.0021640520520981327_rk
    k5_xz = c5*t29 + s5*t30
    k5_yz = s5*t29 - c5*t30
    ! link 4: mass matrix, its row of this joint
    m4_5 = -0.384_rk*h5_y - k5_yz
    ! link 4: force for a unit acceleration of a joint further out
    fu4_x_3 = c4*h5_y
    fu4_y_2 = s4*h5_y
    t31 = -0.384_rk*h5_x
    t32 = k5_xz - t31
    t33 = 0.0825_rk*h5_x
    t34 = m5_5 + t33
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_x_3 = c4*t32 - s4*t34
    nu4_y_3 = s4*t32 + c4*t34
    ! link 3: mass matrix, its row of this joint
    m3_5 = nu4_y_3 - t33
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x_3 = c3*fu4_x_3 + s3*h5_x
    fu3_y_3 = s3*fu4_x_3 - c3*h5_x
    t35 = -0.0825_rk*fu4_y_2 - m4_5
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_x_3 = c3*nu4_x_3 - s3*t35
    nu3_y_3 = s3*nu4_x_3 + c3*t35
    ! link 2: mass matrix, its row of this joint
    m2_5 = nu3_y_3 + 0.316_rk*fu3_x_3
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y_3 = c2*m3_5 - s2*(nu3_x_3 - 0.316_rk*fu3_y_3)
    t36 = k5_xx + 0.165_rk*h5_x
    t37 = k6_yy + 0.768_rk*h6_y
    ! link 4: mass matrix, its row of this joint
    m4_4 = t36 + t37 + 0.7483122111877871_rk
    t38 = -h5_x - 0.5527802746499999_rk
    t39 = h6_y + 2.0125235536029997_rk
    ! link 4: first moment of the composite body, about the frame's origin [kg m]
    h4_x = c4*t38 - s4*t39
    h4_y = s4*t38 + c4*t39
    t40 = c4*c4
    t41 = t36 - t37 - 0.6462719388741561_rk
    t42 = t31 - (k5_xz + 0.0825_rk*h6_y) - 0.16284087268546082_rk
    t43 = c4*s4
    t44 = t40*t41 - t42*(2.0_rk*t43)
    ! link 4: second moment of the composite body [kg m^2]
    k4_xx = t37 + 0.6972920750309717_rk + t44
    k4_yy = t36 + 0.05102013615681549_rk - t44
    k4_xy = t41*t43 - t42*(1.0_rk - 2.0_rk*t40)
    t45 = -0.0825_rk*h5_y
    t46 = neg_k5_xy + t45 - 0.0039053550262761055_rk
    t47 = m4_5 - 0.00164448757736928_rk
    k4_xz = c4*t46 + s4*t47
    neg_k4_yz = c4*t47 - s4*t46
    ! link 3: force for a unit acceleration of a joint further out
    neg_fu3_x = c3*h4_y
    neg_fu3_y = s3*h4_y
    t48 = m4_4 + 0.0825_rk*h4_x
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_x_4 = s3*t48 - c3*k4_xz
    neg_nu3_y = s3*k4_xz + c3*t48
    ! link 2: mass matrix, its row of this joint
    m2_4 = -0.316_rk*neg_fu3_x - neg_nu3_y
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y_4 = c2*neg_k4_yz - s2*(nu3_x_4 + 0.316_rk*neg_fu3_y)
    t49 = -0.165_rk*h4_x - k4_xx
    ! link 3: mass matrix, its row of this joint
    m3_3 = 0.08378056999140594_rk - (t49 - k5_yy)
    t50 = h4_x + 0.746857959872_rk
    t51 = 0.028227094877999827_rk - h5_y
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    h3_x = c3*t50 - s3*t51
    h3_y = s3*t50 + c3*t51
    t52 = c3*c3
    t53 = 0.039424272061649446_rk - (k5_yy + t49)
    t54 = t45 - k4_xz + 0.0001219124209507298_rk
    t55 = c3*s3
    t56 = t52*t53 - t54*(2.0_rk*t55)
    ! link 3: second moment of the composite body [kg m^2]
    k3_xx = k5_yy + 0.022178148964878252_rk + t56
    neg_k3_yy = t49 - 0.061602421026527694_rk + t56
    k3_xy = t53*t55 - t54*(1.0_rk - 2.0_rk*t52)
    t57 = k4_xy + 0.0825_rk*h4_y + 0.005487648106562251_rk
    t58 = -neg_k4_yz - 0.0043772571218395765_rk
    k3_xz = c3*t57 + s3*t58
    k3_yz = s3*t57 - c3*t58
    ! link 2: mass matrix, its row of this joint
    m2_3 = -0.316_rk*h3_y - k3_yz
    t59 = k3_xz + 0.316_rk*h3_x
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y_5 = s2*t59 + c2*m3_3
    t60 = k4_yy + 0.632_rk*h4_y
    ! link 2: mass matrix, its row of this joint
    m2_2 = k3_xx + t60 + 1.0552399437268125_rk
    ! link 2: second moment of the composite body [kg m^2]
    k2_xx = t60 + 1.0321620612318807_rk - (c2*c2*(t60 - k3_xx + 1.009084178736949_rk) - (t59 - &
        0.003983358883935522_rk)*(2.0_rk*(c2*s2)))
    neg_k2_yz = s2*(k3_xy - 0.010261101821008168_rk) - c2*(0.0007689361029464017_rk - m2_3)
    ! link 1: mass matrix, its row of this joint
    m1_1 = k2_xx - neg_k3_yy + 0.014259565994474374_rk
    M(1) = m1_1
    M(2) = neg_k2_yz
    M(3) = nu2_y_5
    M(4) = nu2_y_4
    M(5) = nu2_y_3
    M(6) = nu2_y_2
    M(7) = nu2_y
    M(8) = neg_k2_yz
    M(9) = m2_2
    M(10) = m2_3
    M(11) = m2_4
    M(12) = m2_5
    M(13) = m2_6
    M(14) = m2_7
    M(15) = nu2_y_5
    M(16) = m2_3
    M(17) = m3_3
    M(18) = neg_k4_yz
    M(19) = m3_5
    M(20) = m3_6
    M(21) = m3_7
    M(22) = nu2_y_4
    M(23) = m2_4
    M(24) = neg_k4_yz
    M(25) = m4_4
    M(26) = m4_5
    M(27) = m4_6
    M(28) = m4_7
    M(29) = nu2_y_3
    M(30) = m2_5
    M(31) = m3_5
    M(32) = m4_5
    M(33) = m5_5
    M(34) = neg_k6_yz
    M(35) = nu6_y
    M(36) = nu2_y_2
    M(37) = m2_6
    M(38) = m3_6
    M(39) = m4_6
    M(40) = neg_k6_yz
    M(41) = m6_6
    M(42) = neg_k7_yz
    M(43) = nu2_y
    M(44) = m2_7
    M(45) = m3_7
    M(46) = m4_7
    M(47) = nu6_y
    M(48) = neg_k7_yz
    M(49) = 0.006684151967360947_rk
  end subroutine

  ! accelerations that the torques tau give
  ! 629 multiplications, 551 additions, 7 divisions = 1187; 22 unary minus; 12 sine/cosine
  pure subroutine panda_forward_dynamics(q, qd, tau, qdd) &
      bind(c, name="panda_forward_dynamics_f")
    real(rk), intent(in) :: q(7)
    real(rk), intent(in) :: qd(7)
    real(rk), intent(in) :: tau(7)
    real(rk), intent(out) :: qdd(7)
    real(rk) :: c2, s2, c3, s3, c4, s4, c5, s5, c6, s6, c7, s7, h7_x, neg_h7_y, t1, t2, t3, k7_xx
    real(rk) :: neg_k7_xy, k7_xz, k7_yz, fu6_x, fu6_y, t4, nu6_x, neg_nu6_y, t5, fu5_x, fu5_y
    real(rk) :: nu5_x, t6, nu5_y, m4_7, t7, fu4_x, fu4_y, t8, t9, t10, nu4_x, nu4_y, m3_7, fu3_x
    real(rk) :: fu3_y, t11, nu3_x, nu3_y, m2_7, nu2_y, t12, m6_6, t13, h6_x, h6_y, t14, t15, t16
    real(rk) :: t17, t18, k6_yy, neg_k6_xy, t19, t20, k6_xz, neg_k6_yz, fu5_x_2, fu5_y_2, nu5_x_2
    real(rk) :: nu5_y_2, m4_6, t21, fu4_x_2, neg_fu4_y, t22, t23, t24, nu4_x_2, nu4_y_2, m3_6
    real(rk) :: fu3_x_2, fu3_y_2, t25, nu3_x_2, nu3_y_2, m2_6, nu2_y_2, m5_5, t26, t27, h5_x, h5_y
    real(rk) :: t28, t29, t30, t31, t32, k5_xx, k5_yy, neg_k5_xy, t33, t34, k5_xz, k5_yz, m4_5
    real(rk) :: fu4_x_3, fu4_y_2, t35, t36, t37, t38, nu4_x_3, nu4_y_3, m3_5, fu3_x_3, fu3_y_3, t39
    real(rk) :: nu3_x_3, nu3_y_3, m2_5, nu2_y_3, t40, t41, m4_4, t42, t43, h4_x, h4_y, t44, t45
    real(rk) :: t46, t47, t48, k4_xx, k4_yy, k4_xy, t49, t50, t51, k4_xz, k4_yz, neg_fu3_x
    real(rk) :: neg_fu3_y, t52, nu3_x_4, neg_nu3_y, m2_4, nu2_y_4, t53, m3_3, t54, t55, h3_x, h3_y
    real(rk) :: t56, t57, t58, t59, t60, k3_xx, neg_k3_yy, k3_xy, t61, t62, k3_xz, k3_yz, neg_m2_3
    real(rk) :: t63, nu2_y_5, t64, m2_2, k2_xx, k2_yz, m1_1, t65, w2_x, w2_y, neg_a2_x, neg_a2_y
    real(rk) :: alpha2_x, neg_alpha2_y, ww2_xy, ww2_xx, ww2_yy, ww2_zz, neg_lam2_11, neg_lam2_22
    real(rk) :: neg_lam2_33, a3_z, w3_x, w3_y, t66, t67, a3_x, a3_y, alpha3_x, alpha3_y, w3_z
    real(rk) :: ww3_yz, ww3_zx, ww3_xy, ww3_xx, ww3_yy, ww3_zz, neg_lam3_11, lam3_12, lam3_13
    real(rk) :: lam3_21, neg_lam3_22, lam3_23, lam3_31, lam3_32, neg_lam3_33, a4_z, w4_x, w4_y, t68
    real(rk) :: t69, a4_x, neg_a4_y, alpha4_x, neg_alpha4_y, w4_z, ww4_yz, ww4_zx, ww4_xy, ww4_xx
    real(rk) :: ww4_yy, ww4_zz, neg_lam4_11, lam4_12, lam4_13, lam4_21, neg_lam4_22, neg_lam4_23
    real(rk) :: lam4_31, lam4_32, neg_lam4_33, a5_z, w5_x, w5_y, t70, t71, a5_x, a5_y, alpha5_x
    real(rk) :: alpha5_y, w5_z, ww5_yz, ww5_zx, ww5_xy, ww5_xx, ww5_yy, ww5_zz, neg_lam5_11
    real(rk) :: lam5_12, lam5_13, lam5_21, neg_lam5_22, lam5_23, lam5_31, lam5_32, neg_lam5_33
    real(rk) :: w6_x, w6_y, a6_x, a6_y, alpha6_x, alpha6_y, w6_z, ww6_yz, ww6_zx, ww6_xy, ww6_xx
    real(rk) :: ww6_yy, ww6_zz, neg_lam6_11, lam6_12, lam6_13, lam6_21, neg_lam6_22, lam6_23
    real(rk) :: lam6_31, lam6_32, neg_lam6_33, a7_z, w7_x, w7_y, t72, t73, neg_a7_x, a7_y, alpha7_x
    real(rk) :: alpha7_y, w7_z, ww7_yz, ww7_zx, ww7_xy, ww7_xx, ww7_yy, ww7_zz, neg_lam7_11
    real(rk) :: lam7_12, lam7_13, lam7_21, neg_lam7_22, lam7_23, neg_lam7_31, lam7_32, neg_lam7_33
    real(rk) :: nc2_x, nc2_y, nc2_z, fc3_x, fc3_y, nc3_x, nc3_y, t74, nc3_z, fc4_x, fc4_y, fc4_z
    real(rk) :: nc4_x, nc4_y, t75, neg_nc4_z, fc5_x, fc5_y, fc5_z, nc5_x, nc5_y, t76, nc5_z, fc6_x
    real(rk) :: fc6_y, fc6_z, nc6_x, nc6_y, t77, nc6_z, fc7_x, fc7_y, fc7_z, nc7_x, nc7_y, t78
    real(rk) :: nc7_z, f07_x, f07_y, n07_x, n07_y, n6_x, n6_y, n6_z, f6_x, f6_y, f6_z, f06_x, f06_y
    real(rk) :: n06_x, n06_y, n5_x, n5_y, n5_z, f5_x, f5_y, f5_z, f05_x, neg_f05_y, n05_x, n05_y
    real(rk) :: n4_x, n4_y, n4_z, f4_x, f4_y, f4_z, f04_x, f04_y, n04_x, n04_y, n3_x, n3_y, n3_z
    real(rk) :: f3_x, f3_y, neg_f03_x, f03_y, n03_x, n03_y, n2_x, neg_n2_y, n2_z, n02_y, y1
    real(rk) :: ipivot1, l2_1, l3_1, l4_1, l5_1, l6_1, l7_1, pivot2, ipivot2, ld3_2, l3_2, ld4_2
    real(rk) :: l4_2, ld5_2, l5_2, ld6_2, l6_2, ld7_2, l7_2, pivot3, ipivot3, ld4_3, l4_3, ld5_3
    real(rk) :: l5_3, ld6_3, l6_3, ld7_3, l7_3, pivot4, ipivot4, ld5_4, l5_4, ld6_4, l6_4, ld7_4
    real(rk) :: l7_4, pivot5, ipivot5, ld6_5, l6_5, ld7_5, l7_5, pivot6, ipivot6, ld7_6, l7_6, t79
    real(rk) :: pivot7, ipivot7, y2, y3, y4, y5, y6, t80, y7, qdd7, qdd6, qdd5, qdd4, qdd3, qdd2
    real(rk) :: t81, qdd1

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
    ! link 7: first moment of the composite body, about the frame's origin [kg m]
    h7_x = 0.002573605371338201_rk*c7 - 0.0020344399586618637_rk*s7
    neg_h7_y = -0.0020344399586618637_rk*c7 - 0.002573605371338201_rk*s7
    t1 = c7*c7
    t2 = c7*s7
    t3 = 0.002420943778521227_rk*t1 - 0.000782782563368495_rk*t2
    ! link 7: second moment of the composite body [kg m^2]
    k7_xx = 0.004552547872941087_rk - t3
    neg_k7_xy = 0.002420943778521227_rk*t2 + 0.0003913912816842475_rk*(2.0_rk*t1 - 1.0_rk)
    k7_xz = 0.0009653051699191118_rk*c7 - 0.0012555365982729084_rk*s7
    k7_yz = 0.0009653051699191118_rk*s7 + 0.0012555365982729084_rk*c7
    ! link 6: force for a unit acceleration of a joint further out
    fu6_x = c6*neg_h7_y
    fu6_y = s6*neg_h7_y
    t4 = 0.088_rk*h7_x + 0.006684151967360947_rk
    ! link 6: moment for a unit acceleration of a joint further out
    nu6_x = s6*t4 - c6*k7_xz
    neg_nu6_y = s6*k7_xz + c6*t4
    t5 = -s5
    ! link 5: force for a unit acceleration of a joint further out
    fu5_x = t5*h7_x - c5*fu6_x
    fu5_y = c5*h7_x - s5*fu6_x
    ! link 5: moment for a unit acceleration of a joint further out
    nu5_x = s5*k7_yz - c5*nu6_x
    t6 = -c5
    nu5_y = t6*k7_yz - s5*nu6_x
    ! link 4: mass matrix, its row of this joint
    m4_7 = nu5_y + (0.384_rk*fu5_x - 0.0825_rk*fu6_y)
    t7 = -c4
    ! link 4: force for a unit acceleration of a joint further out
    fu4_x = t7*fu5_x - s4*fu6_y
    fu4_y = c4*fu6_y - s4*fu5_x
    t8 = 0.384_rk*fu5_y - nu5_x
    t9 = 0.0825_rk*fu5_y
    t10 = t9 - neg_nu6_y
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_x = c4*t8 - s4*t10
    nu4_y = s4*t8 + c4*t10
    ! link 3: mass matrix, its row of this joint
    m3_7 = nu4_y - t9
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x = c3*fu4_x + s3*fu5_y
    fu3_y = s3*fu4_x - c3*fu5_y
    t11 = m4_7 + 0.0825_rk*fu4_y
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_x = c3*nu4_x + s3*t11
    nu3_y = s3*nu4_x - c3*t11
    ! link 2: mass matrix, its row of this joint
    m2_7 = nu3_y + 0.316_rk*fu3_x
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y = c2*m3_7 - s2*(nu3_x - 0.316_rk*fu3_y)
    t12 = k7_xx + 0.176_rk*h7_x
    ! link 6: mass matrix, its row of this joint
    m6_6 = t12 + 0.05045667791624746_rk
    t13 = h7_x + 0.231847552695_rk
    ! link 6: first moment of the composite body, about the frame's origin [kg m]
    h6_x = c6*t13 + 0.17380470556899996_rk*s6
    h6_y = s6*t13 - 0.17380470556899996_rk*c6
    t14 = c6*c6
    t15 = 0.007412167175072353_rk - t12
    t16 = k7_xz + 0.014748570382675314_rk
    t17 = c6*s6
    t18 = t14*t15 - t16*(2.0_rk*t17)
    ! link 6: second moment of the composite body [kg m^2]
    k6_yy = t12 + 0.021522255370587554_rk + t18
    neg_k6_xy = t15*t17 - t16*(1.0_rk - 2.0_rk*t14)
    t19 = k7_yz + 9.35690973146064e-05_rk
    t20 = neg_k7_xy + 0.088_rk*neg_h7_y - 0.0001037589172186853_rk
    k6_xz = s6*t19 - c6*t20
    neg_k6_yz = s6*t20 + c6*t19
    ! link 5: force for a unit acceleration of a joint further out
    fu5_x_2 = c5*h6_y
    fu5_y_2 = s5*h6_y
    ! link 5: moment for a unit acceleration of a joint further out
    nu5_x_2 = c5*k6_xz - s5*m6_6
    nu5_y_2 = s5*k6_xz + c5*m6_6
    ! link 4: mass matrix, its row of this joint
    m4_6 = nu5_y_2 - (0.0825_rk*h6_x - 0.384_rk*fu5_x_2)
    t21 = -s4
    ! link 4: force for a unit acceleration of a joint further out
    fu4_x_2 = t21*h6_x - c4*fu5_x_2
    neg_fu4_y = s4*fu5_x_2 - c4*h6_x
    t22 = 0.384_rk*fu5_y_2 - nu5_x_2
    t23 = 0.0825_rk*fu5_y_2
    t24 = neg_k6_yz + t23
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_x_2 = c4*t22 - s4*t24
    nu4_y_2 = s4*t22 + c4*t24
    ! link 3: mass matrix, its row of this joint
    m3_6 = nu4_y_2 - t23
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x_2 = c3*fu4_x_2 + s3*fu5_y_2
    fu3_y_2 = s3*fu4_x_2 - c3*fu5_y_2
    t25 = 0.0825_rk*neg_fu4_y - m4_6
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_x_2 = c3*nu4_x_2 - s3*t25
    nu3_y_2 = s3*nu4_x_2 + c3*t25
    ! link 2: mass matrix, its row of this joint
    m2_6 = nu3_y_2 + 0.316_rk*fu3_x_2
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y_2 = c2*m3_6 - s2*(nu3_x_2 - 0.316_rk*fu3_y_2)
    ! link 5: mass matrix, its row of this joint
    m5_5 = t3 - t18 + 0.04256237053342773_rk
    t26 = 0.014653732538_rk - h6_x
    t27 = neg_h7_y + 0.067870631425_rk
    ! link 5: first moment of the composite body, about the frame's origin [kg m]
    h5_x = c5*t26 + s5*t27
    h5_y = s5*t26 - c5*t27
    t28 = c5*c5
    t29 = t3 + t18 - 0.018208786687945514_rk
    t30 = 0.00151524447332703_rk - k6_xz
    t31 = c5*s5
    t32 = t28*t29 + t30*(2.0_rk*t31)
    ! link 5: second moment of the composite body [kg m^2]
    k5_xx = t3 + 0.012176791922741105_rk - t32
    k5_yy = t32 - (t18 - 0.03038557861068662_rk)
    neg_k5_xy = t29*t31 + t30*(1.0_rk - 2.0_rk*t28)
    t33 = neg_k6_xy - 0.004600245517563107_rk
    t34 = neg_k6_yz - 0.0021640520520981327_rk
    k5_xz = c5*t33 + s5*t34
    k5_yz = s5*t33 - c5*t34
    ! link 4: mass matrix, its row of this joint
    m4_5 = -0.384_rk*h5_y - k5_yz
    ! link 4: force for a unit acceleration of a joint further out
    fu4_x_3 = c4*h5_y
    fu4_y_2 = s4*h5_y
    t35 = -0.384_rk*h5_x
    t36 = k5_xz - t35
    t37 = 0.0825_rk*h5_x
    t38 = m5_5 + t37
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_x_3 = c4*t36 - s4*t38
    nu4_y_3 = s4*t36 + c4*t38
    ! link 3: mass matrix, its row of this joint
    m3_5 = nu4_y_3 - t37
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x_3 = c3*fu4_x_3 + s3*h5_x
    fu3_y_3 = s3*fu4_x_3 - c3*h5_x
    t39 = -0.0825_rk*fu4_y_2 - m4_5
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_x_3 = c3*nu4_x_3 - s3*t39
    nu3_y_3 = s3*nu4_x_3 + c3*t39
    ! link 2: mass matrix, its row of this joint
    m2_5 = nu3_y_3 + 0.316_rk*fu3_x_3
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y_3 = c2*m3_5 - s2*(nu3_x_3 - 0.316_rk*fu3_y_3)
    t40 = k5_xx + 0.165_rk*h5_x
    t41 = k6_yy + 0.768_rk*h6_y
    ! link 4: mass matrix, its row of this joint
    m4_4 = t40 + t41 + 0.7483122111877871_rk
    t42 = -h5_x - 0.5527802746499999_rk
    t43 = h6_y + 2.0125235536029997_rk
    ! link 4: first moment of the composite body, about the frame's origin [kg m]
    h4_x = c4*t42 - s4*t43
    h4_y = s4*t42 + c4*t43
    t44 = c4*c4
    t45 = t40 - t41 - 0.6462719388741561_rk
    t46 = t35 - (k5_xz + 0.0825_rk*h6_y) - 0.16284087268546082_rk
    t47 = c4*s4
    t48 = t44*t45 - t46*(2.0_rk*t47)
    ! link 4: second moment of the composite body [kg m^2]
    k4_xx = t41 + 0.6972920750309717_rk + t48
    k4_yy = t40 + 0.05102013615681549_rk - t48
    k4_xy = t45*t47 - t46*(1.0_rk - 2.0_rk*t44)
    t49 = -0.0825_rk*h5_y
    t50 = neg_k5_xy + t49 - 0.0039053550262761055_rk
    t51 = 0.00164448757736928_rk - m4_5
    k4_xz = c4*t50 - s4*t51
    k4_yz = s4*t50 + c4*t51
    ! link 3: force for a unit acceleration of a joint further out
    neg_fu3_x = c3*h4_y
    neg_fu3_y = s3*h4_y
    t52 = m4_4 + 0.0825_rk*h4_x
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_x_4 = s3*t52 - c3*k4_xz
    neg_nu3_y = s3*k4_xz + c3*t52
    ! link 2: mass matrix, its row of this joint
    m2_4 = -0.316_rk*neg_fu3_x - neg_nu3_y
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y_4 = -c2*k4_yz - s2*(nu3_x_4 + 0.316_rk*neg_fu3_y)
    t53 = -0.165_rk*h4_x - k4_xx
    ! link 3: mass matrix, its row of this joint
    m3_3 = 0.08378056999140594_rk - (t53 - k5_yy)
    t54 = h4_x + 0.746857959872_rk
    t55 = 0.028227094877999827_rk - h5_y
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    h3_x = c3*t54 - s3*t55
    h3_y = s3*t54 + c3*t55
    t56 = c3*c3
    t57 = 0.039424272061649446_rk - (k5_yy + t53)
    t58 = t49 - k4_xz + 0.0001219124209507298_rk
    t59 = c3*s3
    t60 = t56*t57 - t58*(2.0_rk*t59)
    ! link 3: second moment of the composite body [kg m^2]
    k3_xx = k5_yy + 0.022178148964878252_rk + t60
    neg_k3_yy = t53 - 0.061602421026527694_rk + t60
    k3_xy = t57*t59 - t58*(1.0_rk - 2.0_rk*t56)
    t61 = k4_xy + 0.0825_rk*h4_y + 0.005487648106562251_rk
    t62 = k4_yz - 0.0043772571218395765_rk
    k3_xz = c3*t61 + s3*t62
    k3_yz = s3*t61 - c3*t62
    ! link 2: mass matrix, its row of this joint
    neg_m2_3 = k3_yz + 0.316_rk*h3_y
    t63 = k3_xz + 0.316_rk*h3_x
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y_5 = s2*t63 + c2*m3_3
    t64 = k4_yy + 0.632_rk*h4_y
    ! link 2: mass matrix, its row of this joint
    m2_2 = k3_xx + t64 + 1.0552399437268125_rk
    ! link 2: second moment of the composite body [kg m^2]
    k2_xx = t64 + 1.0321620612318807_rk - (c2*c2*(t64 - k3_xx + 1.009084178736949_rk) - (t63 - &
        0.003983358883935522_rk)*(2.0_rk*(c2*s2)))
    k2_yz = c2*(neg_m2_3 + 0.0007689361029464017_rk) - s2*(k3_xy - 0.010261101821008168_rk)
    ! link 1: mass matrix, its row of this joint
    m1_1 = k2_xx - neg_k3_yy + 0.014259565994474374_rk
    t65 = -qd(1)
    ! link 2: angular velocity [rad/s]
    w2_x = t65*s2
    w2_y = t65*c2
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a2_x = 9.81_rk*s2
    neg_a2_y = 9.81_rk*c2
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
    neg_lam2_22 = ww2_xx + ww2_zz
    neg_lam2_33 = ww2_xx + ww2_yy
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_z = neg_a2_y - 0.316_rk*neg_lam2_22
    ! link 3: angular velocity [rad/s]
    w3_x = c3*w2_x + qd(2)*s3
    w3_y = qd(2)*c3 - s3*w2_x
    t66 = -0.632_rk*alpha2_x
    t67 = neg_a2_x + 0.316_rk*ww2_xy
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_x = s3*t66 - c3*t67
    a3_y = s3*t67 + c3*t66
    ! link 3: angular acceleration [rad/s^2]
    alpha3_x = c3*alpha2_x + qd(3)*w3_y
    alpha3_y = -qd(3)*w3_x - s3*alpha2_x
    ! link 3: angular velocity [rad/s]
    w3_z = qd(3) - w2_y
    ! link 3: products of the angular velocity [1/s^2]
    ww3_yz = w3_y*w3_z
    ww3_zx = w3_x*w3_z
    ww3_xy = w3_x*w3_y
    ww3_xx = w3_x*w3_x
    ww3_yy = w3_y*w3_y
    ww3_zz = w3_z*w3_z
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_11 = ww3_yy + ww3_zz
    lam3_12 = ww3_xy - neg_alpha2_y
    lam3_13 = alpha3_y + ww3_zx
    lam3_21 = neg_alpha2_y + ww3_xy
    neg_lam3_22 = ww3_xx + ww3_zz
    lam3_23 = ww3_yz - alpha3_x
    lam3_31 = ww3_zx - alpha3_y
    lam3_32 = alpha3_x + ww3_yz
    neg_lam3_33 = ww3_xx + ww3_yy
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_z = -0.0825_rk*lam3_21 - a3_y
    ! link 4: angular velocity [rad/s]
    w4_x = t21*w3_z - c4*w3_x
    w4_y = s4*w3_x - c4*w3_z
    t68 = 0.0825_rk*neg_lam3_11 - a3_x
    t69 = a3_z + 0.0825_rk*lam3_31
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_x = c4*t68 - s4*t69
    neg_a4_y = s4*t68 + c4*t69
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = t7*alpha3_x - s4*neg_alpha2_y + qd(4)*w4_y
    neg_alpha4_y = c4*neg_alpha2_y - s4*alpha3_x + qd(4)*w4_x
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
    lam4_13 = ww4_zx - neg_alpha4_y
    lam4_21 = ww4_xy - alpha3_y
    neg_lam4_22 = ww4_xx + ww4_zz
    neg_lam4_23 = alpha4_x - ww4_yz
    lam4_31 = neg_alpha4_y + ww4_zx
    lam4_32 = alpha4_x + ww4_yz
    neg_lam4_33 = ww4_xx + ww4_yy
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_z = neg_a4_y + (-0.384_rk*neg_lam4_22 - 0.0825_rk*lam4_21)
    ! link 5: angular velocity [rad/s]
    w5_x = t5*w4_z - c5*w4_x
    w5_y = s5*w4_x - c5*w4_z
    t70 = 0.384_rk*lam4_32 - 0.0825_rk*lam4_31 - a4_z
    t71 = a4_x - (0.0825_rk*neg_lam4_11 + 0.384_rk*lam4_12)
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_x = s5*t70 - c5*t71
    a5_y = s5*t71 + c5*t70
    ! link 5: angular acceleration [rad/s^2]
    alpha5_x = qd(5)*w5_y - (c5*alpha4_x - s5*alpha3_y)
    alpha5_y = s5*alpha4_x + c5*alpha3_y - qd(5)*w5_x
    ! link 5: angular velocity [rad/s]
    w5_z = qd(5) - w4_y
    ! link 5: products of the angular velocity [1/s^2]
    ww5_yz = w5_y*w5_z
    ww5_zx = w5_x*w5_z
    ww5_xy = w5_x*w5_y
    ww5_xx = w5_x*w5_x
    ww5_yy = w5_y*w5_y
    ww5_zz = w5_z*w5_z
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_11 = ww5_yy + ww5_zz
    lam5_12 = ww5_xy - neg_alpha4_y
    lam5_13 = alpha5_y + ww5_zx
    lam5_21 = neg_alpha4_y + ww5_xy
    neg_lam5_22 = ww5_xx + ww5_zz
    lam5_23 = ww5_yz - alpha5_x
    lam5_31 = ww5_zx - alpha5_y
    lam5_32 = alpha5_x + ww5_yz
    neg_lam5_33 = ww5_xx + ww5_yy
    ! link 6: angular velocity [rad/s]
    w6_x = c6*w5_x + s6*w5_z
    w6_y = c6*w5_z - s6*w5_x
    ! link 6: acceleration of the frame's origin, gravity taken off [m/s^2]
    a6_x = c6*a5_x + s6*a5_z
    a6_y = c6*a5_z - s6*a5_x
    ! link 6: angular acceleration [rad/s^2]
    alpha6_x = qd(6)*w6_y - (-c6*alpha5_x - s6*neg_alpha4_y)
    alpha6_y = c6*neg_alpha4_y - s6*alpha5_x - qd(6)*w6_x
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
    ! link 7: acceleration of the frame's origin, gravity taken off [m/s^2]
    a7_z = -0.088_rk*lam6_21 - a6_y
    ! link 7: angular velocity [rad/s]
    w7_x = c7*w6_x + s7*w6_z
    w7_y = c7*w6_z - s7*w6_x
    t72 = 0.088_rk*neg_lam6_11 - a6_x
    t73 = a5_y - 0.088_rk*lam6_31
    ! link 7: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a7_x = c7*t72 + s7*t73
    a7_y = s7*t72 - c7*t73
    ! link 7: angular acceleration [rad/s^2]
    alpha7_x = qd(7)*w7_y - (s7*alpha5_y - c7*alpha6_x)
    alpha7_y = -c7*alpha5_y - s7*alpha6_x - qd(7)*w7_x
    ! link 7: angular velocity [rad/s]
    w7_z = qd(7) - w6_y
    ! link 7: products of the angular velocity [1/s^2]
    ww7_yz = w7_y*w7_z
    ww7_zx = w7_x*w7_z
    ww7_xy = w7_x*w7_y
    ww7_xx = w7_x*w7_x
    ww7_yy = w7_y*w7_y
    ww7_zz = w7_z*w7_z
    ! link 7: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam7_11 = ww7_yy + ww7_zz
    lam7_12 = alpha6_y + ww7_xy
    lam7_13 = alpha7_y + ww7_zx
    lam7_21 = ww7_xy - alpha6_y
    neg_lam7_22 = ww7_xx + ww7_zz
    lam7_23 = ww7_yz - alpha7_x
    neg_lam7_31 = alpha7_y - ww7_zx
    lam7_32 = alpha7_x + ww7_yz
    neg_lam7_33 = ww7_xx + ww7_yy
    ! link 2: moment that turns the link [N m]
    nc2_x = 0.007966717767871044_rk*neg_alpha2_y + 0.010261101821008168_rk*ww2_xy - &
        (0.0007689361029464017_rk*(neg_lam2_22 - neg_lam2_33) - 2.0643241224637614_rk*alpha2_x)
    nc2_y = 0.010261101821008168_rk*(neg_lam2_11 - neg_lam2_33) - &
        0.04615576498986361_rk*neg_alpha2_y - (0.0007689361029464017_rk*ww2_xy + &
        0.007966717767871044_rk*alpha2_x)
    nc2_z = 0.01993386669246_rk*c2 - 32.809545426852715_rk*s2 - (1.009084178736949_rk*ww2_xy - &
        0.003983358883935522_rk*(neg_lam2_11 - neg_lam2_22))
    ! link 3: force that moves the link [N]
    fc3_x = 0.028227094877999827_rk*lam3_12 - 0.746857959872_rk*neg_lam3_11
    fc3_y = 0.746857959872_rk*lam3_21 - 0.028227094877999827_rk*neg_lam3_22
    ! link 3: moment that turns the link [N m]
    nc3_x = 0.028227094877999827_rk*a3_z - (-0.022178148964878252_rk*lam3_32 - &
        0.0043772571218395765_rk*(neg_lam3_22 - neg_lam3_33) + (0.005487648106562251_rk*lam3_21 - &
        0.0001219124209507298_rk*lam3_31))
    nc3_y = -0.061602421026527694_rk*lam3_31 - 0.005487648106562251_rk*(neg_lam3_11 - neg_lam3_33) &
        + (0.0043772571218395765_rk*lam3_12 - 0.0001219124209507298_rk*lam3_32) - &
        0.746857959872_rk*a3_z
    t74 = 0.022178148964878252_rk*lam3_12 - 0.061602421026527694_rk*lam3_21 - &
        0.0001219124209507298_rk*(neg_lam3_11 - neg_lam3_22) - (0.005487648106562251_rk*lam3_23 - &
        0.0043772571218395765_rk*lam3_13)
    nc3_z = 0.746857959872_rk*a3_y - 0.028227094877999827_rk*a3_x - t74
    ! link 4: force that moves the link [N]
    fc4_x = -0.5527802746499999_rk*neg_lam4_11 - 2.0125235536029997_rk*lam4_12
    fc4_y = 0.5527802746499999_rk*lam4_21 + 2.0125235536029997_rk*neg_lam4_22
    fc4_z = 0.5527802746499999_rk*lam4_31 - 2.0125235536029997_rk*lam4_32
    ! link 4: moment that turns the link [N m]
    nc4_x = 0.6972920750309717_rk*lam4_32 - 0.00164448757736928_rk*(neg_lam4_22 - neg_lam4_33) - &
        (0.16284087268546082_rk*lam4_31 + 0.0039053550262761055_rk*lam4_21) - &
        2.0125235536029997_rk*a4_z
    nc4_y = -0.5527802746499999_rk*a4_z - (0.05102013615681549_rk*lam4_31 + &
        0.0039053550262761055_rk*(neg_lam4_11 - neg_lam4_33) + (0.00164448757736928_rk*lam4_12 - &
        0.16284087268546082_rk*lam4_32))
    t75 = 0.6972920750309717_rk*lam4_12 - 0.05102013615681549_rk*lam4_21 + &
        0.16284087268546082_rk*(neg_lam4_11 - neg_lam4_22) + (0.0039053550262761055_rk*neg_lam4_23 &
        - 0.00164448757736928_rk*lam4_13)
    neg_nc4_z = t75 + (0.5527802746499999_rk*neg_a4_y - 2.0125235536029997_rk*a4_x)
    ! link 5: force that moves the link [N]
    fc5_x = 0.014653732538_rk*neg_lam5_11 + 0.067870631425_rk*lam5_12
    fc5_y = -0.067870631425_rk*neg_lam5_22 - 0.014653732538_rk*lam5_21
    fc5_z = 0.067870631425_rk*lam5_32 - 0.014653732538_rk*lam5_31
    ! link 5: moment that turns the link [N m]
    nc5_x = 0.067870631425_rk*a5_z - (0.0021640520520981327_rk*(neg_lam5_22 - neg_lam5_33) - &
        0.010045187828321245_rk*lam5_32 + (0.004600245517563107_rk*lam5_21 - &
        0.00151524447332703_rk*lam5_31))
    nc5_y = -0.001451156065026714_rk*lam5_31 - 0.004600245517563107_rk*(neg_lam5_11 - neg_lam5_33) &
        + (-0.0021640520520981327_rk*lam5_12 - 0.00151524447332703_rk*lam5_32) + &
        0.014653732538_rk*a5_z
    t76 = 0.001451156065026714_rk*lam5_21 - 0.010045187828321245_rk*lam5_12 + &
        0.00151524447332703_rk*(neg_lam5_11 - neg_lam5_22) + (0.004600245517563107_rk*lam5_23 + &
        0.0021640520520981327_rk*lam5_13)
    nc5_z = t76 - (0.014653732538_rk*a5_y + 0.067870631425_rk*a5_x)
    ! link 6: force that moves the link [N]
    fc6_x = -0.231847552695_rk*neg_lam6_11 - 0.17380470556899996_rk*lam6_12
    fc6_y = 0.231847552695_rk*lam6_21 + 0.17380470556899996_rk*neg_lam6_22
    fc6_z = 0.231847552695_rk*lam6_31 - 0.17380470556899996_rk*lam6_32
    ! link 6: moment that turns the link [N m]
    nc6_x = 0.17380470556899996_rk*a5_y - (9.35690973146064e-05_rk*(neg_lam6_22 - neg_lam6_33) - &
        0.028934422545659907_rk*lam6_32 - (-0.014748570382675314_rk*lam6_31 - &
        0.0001037589172186853_rk*lam6_21))
    nc6_y = -0.021522255370587554_rk*lam6_31 - 0.0001037589172186853_rk*(neg_lam6_11 - &
        neg_lam6_33) - (9.35690973146064e-05_rk*lam6_12 - 0.014748570382675314_rk*lam6_32) + &
        0.231847552695_rk*a5_y
    t77 = 0.028934422545659907_rk*lam6_12 - 0.021522255370587554_rk*lam6_21 + &
        0.014748570382675314_rk*(neg_lam6_11 - neg_lam6_22) - (0.0001037589172186853_rk*lam6_23 + &
        9.35690973146064e-05_rk*lam6_13)
    nc6_z = 0.231847552695_rk*a6_y + 0.17380470556899996_rk*a6_x - t77
    ! link 7: force that moves the link [N]
    fc7_x = 0.0020344399586618637_rk*lam7_12 - 0.002573605371338201_rk*neg_lam7_11
    fc7_y = 0.002573605371338201_rk*lam7_21 - 0.0020344399586618637_rk*neg_lam7_22
    fc7_z = 0.0020344399586618637_rk*lam7_32 - 0.002573605371338201_rk*neg_lam7_31
    ! link 7: moment that turns the link [N m]
    nc7_x = 0.0020344399586618637_rk*a7_z - (-0.004552547872941087_rk*lam7_32 - &
        0.0012555365982729084_rk*(neg_lam7_22 - neg_lam7_33) - &
        (0.0003913912816842475_rk*neg_lam7_31 - 0.0009653051699191118_rk*lam7_21))
    nc7_y = 0.00213160409441986_rk*neg_lam7_31 - 0.0009653051699191118_rk*(neg_lam7_11 - &
        neg_lam7_33) + (0.0012555365982729084_rk*lam7_12 + 0.0003913912816842475_rk*lam7_32) - &
        0.002573605371338201_rk*a7_z
    t78 = 0.004552547872941087_rk*lam7_12 - 0.00213160409441986_rk*lam7_21 + &
        0.0003913912816842475_rk*(neg_lam7_11 - neg_lam7_22) - (0.0009653051699191118_rk*lam7_23 - &
        0.0012555365982729084_rk*lam7_13)
    nc7_z = 0.002573605371338201_rk*a7_y + 0.0020344399586618637_rk*neg_a7_x - t78
    ! link 7: force through the joint, along the axes that its turn starts from [N]
    f07_x = c7*fc7_x - s7*fc7_y
    f07_y = s7*fc7_x + c7*fc7_y
    ! link 7: moment through the joint, along the axes that its turn starts from [N m]
    n07_x = c7*nc7_x - s7*nc7_y
    n07_y = s7*nc7_x + c7*nc7_y
    ! link 6: moment through the joint, about the frame's origin [N m]
    n6_x = nc6_x + n07_x
    n6_y = nc6_y - 0.088_rk*f07_y - nc7_z
    n6_z = n07_y + (nc6_z - 0.088_rk*fc7_z)
    ! link 6: force through the joint [N]
    f6_x = fc6_x + f07_x
    f6_y = fc6_y - fc7_z
    f6_z = fc6_z + f07_y
    ! link 6: force through the joint, along the axes that its turn starts from [N]
    f06_x = c6*f6_x - s6*f6_y
    f06_y = s6*f6_x + c6*f6_y
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    n06_x = c6*n6_x - s6*n6_y
    n06_y = s6*n6_x + c6*n6_y
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_x = nc5_x + n06_x
    n5_y = nc5_y - n6_z
    n5_z = nc5_z + n06_y
    ! link 5: force through the joint [N]
    f5_x = fc5_x + f06_x
    f5_y = fc5_y - f6_z
    f5_z = fc5_z + f06_y
    ! link 5: force through the joint, along the axes that its turn starts from [N]
    f05_x = s5*f5_y - c5*f5_x
    neg_f05_y = s5*f5_x + c5*f5_y
    ! link 5: moment through the joint, along the axes that its turn starts from [N m]
    n05_x = s5*n5_y - c5*n5_x
    n05_y = t6*n5_y - s5*n5_x
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = n05_x + (nc4_x + 0.384_rk*neg_f05_y)
    n4_y = nc4_y + 0.0825_rk*neg_f05_y - n5_z
    n4_z = n05_y - (neg_nc4_z + (0.0825_rk*f5_z - 0.384_rk*f05_x))
    ! link 4: force through the joint [N]
    f4_x = fc4_x + f05_x
    f4_y = fc4_y - f5_z
    f4_z = fc4_z - neg_f05_y
    ! link 4: force through the joint, along the axes that its turn starts from [N]
    f04_x = s4*f4_y - c4*f4_x
    f04_y = t7*f4_y - s4*f4_x
    ! link 4: moment through the joint, along the axes that its turn starts from [N m]
    n04_x = s4*n4_y - c4*n4_x
    n04_y = t21*n4_x - c4*n4_y
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_x = nc3_x + n04_x
    n3_y = nc3_y - 0.0825_rk*f04_y - n4_z
    n3_z = n04_y - (0.0825_rk*f4_z - nc3_z)
    ! link 3: force through the joint [N]
    f3_x = fc3_x + f04_x
    f3_y = fc3_y - f4_z
    ! link 3: force through the joint, along the axes that its turn starts from [N]
    neg_f03_x = s3*f3_y - c3*f3_x
    f03_y = s3*f3_x + c3*f3_y
    ! link 3: moment through the joint, along the axes that its turn starts from [N m]
    n03_x = c3*n3_x - s3*n3_y
    n03_y = s3*n3_x + c3*n3_y
    ! link 2: moment through the joint, about the frame's origin [N m]
    n2_x = n03_x + (nc2_x - 0.316_rk*f03_y)
    neg_n2_y = n3_z - nc2_y
    n2_z = n03_y - (0.316_rk*neg_f03_x - nc2_z)
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_y = c2*neg_n2_y - s2*n2_x
    ! link 1: forward substitution
    y1 = tau(1) - n02_y
    ! factorisation M = L D L^T
    ipivot1 = 1.0_rk / m1_1
    l2_1 = -k2_yz*ipivot1
    l3_1 = nu2_y_5*ipivot1
    l4_1 = nu2_y_4*ipivot1
    l5_1 = nu2_y_3*ipivot1
    l6_1 = nu2_y_2*ipivot1
    l7_1 = nu2_y*ipivot1
    pivot2 = m2_2 + k2_yz*l2_1
    ipivot2 = 1.0_rk / pivot2
    ld3_2 = k2_yz*l3_1 - neg_m2_3
    l3_2 = ipivot2*ld3_2
    ld4_2 = m2_4 + k2_yz*l4_1
    l4_2 = ipivot2*ld4_2
    ld5_2 = m2_5 + k2_yz*l5_1
    l5_2 = ipivot2*ld5_2
    ld6_2 = m2_6 + k2_yz*l6_1
    l6_2 = ipivot2*ld6_2
    ld7_2 = m2_7 + k2_yz*l7_1
    l7_2 = ipivot2*ld7_2
    pivot3 = m3_3 - nu2_y_5*l3_1 - ld3_2*l3_2
    ipivot3 = 1.0_rk / pivot3
    ld4_3 = -(k4_yz + nu2_y_5*l4_1) - ld3_2*l4_2
    l4_3 = ipivot3*ld4_3
    ld5_3 = m3_5 - nu2_y_5*l5_1 - ld3_2*l5_2
    l5_3 = ipivot3*ld5_3
    ld6_3 = -ld3_2*l6_2 - (nu2_y_5*l6_1 - m3_6)
    l6_3 = ipivot3*ld6_3
    ld7_3 = m3_7 - nu2_y_5*l7_1 - ld3_2*l7_2
    l7_3 = ipivot3*ld7_3
    pivot4 = m4_4 - nu2_y_4*l4_1 - ld4_2*l4_2 - ld4_3*l4_3
    ipivot4 = 1.0_rk / pivot4
    ld5_4 = -ld4_3*l5_3 - (nu2_y_4*l5_1 - m4_5 + ld4_2*l5_2)
    l5_4 = ipivot4*ld5_4
    ld6_4 = -ld4_2*l6_2 - (nu2_y_4*l6_1 - m4_6) - ld4_3*l6_3
    l6_4 = ipivot4*ld6_4
    ld7_4 = m4_7 - nu2_y_4*l7_1 - ld4_2*l7_2 - ld4_3*l7_3
    l7_4 = ipivot4*ld7_4
    pivot5 = m5_5 - nu2_y_3*l5_1 - ld5_2*l5_2 - ld5_3*l5_3 - ld5_4*l5_4
    ipivot5 = 1.0_rk / pivot5
    ld6_5 = -ld5_2*l6_2 - (nu2_y_3*l6_1 - neg_k6_yz) - ld5_3*l6_3 - ld5_4*l6_4
    l6_5 = ipivot5*ld6_5
    ld7_5 = -ld5_3*l7_3 - (neg_nu6_y + nu2_y_3*l7_1 + ld5_2*l7_2) - ld5_4*l7_4
    l7_5 = ipivot5*ld7_5
    pivot6 = -ld6_5*l6_5 - (ld6_2*l6_2 - (m6_6 - nu2_y_2*l6_1) + ld6_3*l6_3 + ld6_4*l6_4)
    ipivot6 = 1.0_rk / pivot6
    ld7_6 = -(k7_yz + nu2_y_2*l7_1 + ld6_2*l7_2 + ld6_3*l7_3 + ld6_4*l7_4) - ld6_5*l7_5
    l7_6 = ipivot6*ld7_6
    t79 = 0.006684151967360947_rk - nu2_y*l7_1 - ld7_2*l7_2 - ld7_3*l7_3 - ld7_4*l7_4 - ld7_5*l7_5
    pivot7 = t79 - ld7_6*l7_6
    ipivot7 = 1.0_rk / pivot7
    ! link 2: forward substitution
    y2 = tau(2) - n2_z - y1*l2_1
    ! link 3: forward substitution
    y3 = tau(3) - n3_z - y1*l3_1 - l3_2*y2
    ! link 4: forward substitution
    y4 = tau(4) - n4_z - y1*l4_1 - l4_2*y2 - l4_3*y3
    ! link 5: forward substitution
    y5 = tau(5) - n5_z - y1*l5_1 - l5_2*y2 - l5_3*y3 - l5_4*y4
    ! link 6: forward substitution
    y6 = tau(6) - n6_z - y1*l6_1 - l6_2*y2 - l6_3*y3 - l6_4*y4 - l6_5*y5
    t80 = tau(7) - nc7_z - y1*l7_1 - l7_2*y2 - l7_3*y3 - l7_4*y4 - l7_5*y5
    ! link 7: forward substitution
    y7 = t80 - l7_6*y6
    ! link 7: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd7 = ipivot7*y7
    ! link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd6 = ipivot6*y6 - l7_6*qdd7
    ! link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd5 = ipivot5*y5 - l6_5*qdd6 - l7_5*qdd7
    ! link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd4 = ipivot4*y4 - l5_4*qdd5 - l6_4*qdd6 - l7_4*qdd7
    ! link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd3 = -l7_3*qdd7 - (l4_3*qdd4 - ipivot3*y3 + l5_3*qdd5 + l6_3*qdd6)
    ! link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd2 = -l7_2*qdd7 - (l3_2*qdd3 - ipivot2*y2 + l4_2*qdd4 + l5_2*qdd5 + l6_2*qdd6)
    t81 = l2_1*qdd2 - y1*ipivot1 + l3_1*qdd3 + l4_1*qdd4 + l5_1*qdd5 + l6_1*qdd6
    ! link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd1 = -t81 - l7_1*qdd7
    qdd(1) = qdd1
    qdd(2) = qdd2
    qdd(3) = qdd3
    qdd(4) = qdd4
    qdd(5) = qdd5
    qdd(6) = qdd6
    qdd(7) = qdd7
  end subroutine
end module
