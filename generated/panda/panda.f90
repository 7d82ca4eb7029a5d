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
!   inverse_dynamics: 308 multiplications, 292 additions = 600; 11 unary minus; 12 sine/cosine
!   gravity: 64 multiplications, 38 additions = 102; 3 unary minus; 12 sine/cosine
!   bias: 300 multiplications, 273 additions = 573; 12 unary minus; 12 sine/cosine
!   mass_matrix: 203 multiplications, 173 additions = 376; 7 unary minus; 12 sine/cosine
!   forward_dynamics: 629 multiplications, 551 additions, 7 divisions = 1187; 21 unary minus; 12
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
  ! 308 multiplications, 292 additions = 600; 11 unary minus; 12 sine/cosine
  pure subroutine panda_inverse_dynamics(q, qd, qdd, tau) &
      bind(c, name="panda_inverse_dynamics_f")
    real(rk), intent(in) :: q(7)
    real(rk), intent(in) :: qd(7)
    real(rk), intent(in) :: qdd(7)
    real(rk), intent(out) :: tau(7)
    real(rk) :: c2, s2, c3, s3, c4, s4, c5, s5
    real(rk) :: c6, s6, c7, s7, t1, w2_x, w2_y, a2_x
    real(rk) :: a2_y, ww2_yz, ww2_zx, alpha2_x, neg_alpha2_y, ww2_xy, ww2_xx, ww2_yy
    real(rk) :: ww2_zz, neg_lam2_11, lam2_12, lam2_13, lam2_21, neg_lam2_22, lam2_23, lam2_31
    real(rk) :: lam2_32, neg_lam2_33, a3_z, w3_x, w3_y, t2, t3, a3_x
    real(rk) :: a3_y, alpha3_x, alpha3_y, alpha3_z, w3_z, ww3_yz, ww3_zx, ww3_xy
    real(rk) :: ww3_xx, ww3_yy, ww3_zz, neg_lam3_11, lam3_12, lam3_13, lam3_21, neg_lam3_22
    real(rk) :: lam3_23, lam3_31, lam3_32, neg_lam3_33, neg_a4_z, t4, w4_x, w4_y
    real(rk) :: t5, t6, a4_x, neg_a4_y, alpha4_x, neg_alpha4_y, alpha4_z, w4_z
    real(rk) :: ww4_yz, ww4_zx, ww4_xy, ww4_xx, ww4_yy, neg_ww4_zz, lam4_11, lam4_12
    real(rk) :: lam4_13, lam4_21, lam4_22, lam4_23, lam4_31, lam4_32, lam4_33, a5_z
    real(rk) :: w5_x, w5_y, t7, t8, a5_x, a5_y, alpha5_x, alpha5_y
    real(rk) :: alpha5_z, w5_z, ww5_yz, ww5_zx, ww5_xy, ww5_xx, ww5_yy, ww5_zz
    real(rk) :: neg_lam5_11, lam5_12, lam5_13, lam5_21, neg_lam5_22, lam5_23, lam5_31, lam5_32
    real(rk) :: neg_lam5_33, w6_x, w6_y, a6_x, a6_y, alpha6_x, alpha6_y, alpha6_z
    real(rk) :: w6_z, ww6_yz, ww6_zx, ww6_xy, ww6_xx, ww6_yy, ww6_zz, neg_lam6_11
    real(rk) :: lam6_12, lam6_13, lam6_21, neg_lam6_22, lam6_23, lam6_31, lam6_32, neg_lam6_33
    real(rk) :: a7_z, w7_x, w7_y, t9, t10, neg_a7_x, a7_y, alpha7_x
    real(rk) :: alpha7_y, alpha7_z, w7_z, ww7_yz, ww7_zx, ww7_xy, ww7_xx, ww7_yy
    real(rk) :: ww7_zz, neg_lam7_11, lam7_12, lam7_13, lam7_21, neg_lam7_22, lam7_23, neg_lam7_31
    real(rk) :: lam7_32, neg_lam7_33, nc1_z, neg_nc2_x, nc2_y, t11, nc2_z, fc3_x
    real(rk) :: fc3_y, nc3_x, nc3_y, t12, nc3_z, fc4_x, fc4_y, fc4_z
    real(rk) :: nc4_x, nc4_y, t13, nc4_z, fc5_x, fc5_y, fc5_z, nc5_x
    real(rk) :: nc5_y, t14, nc5_z, fc6_x, fc6_y, fc6_z, nc6_x, nc6_y
    real(rk) :: t15, nc6_z, fc7_x, fc7_y, neg_fc7_z, nc7_x, nc7_y, t16
    real(rk) :: nc7_z, f07_x, f07_y, n07_x, n07_y, n6_x, n6_y, n6_z
    real(rk) :: f6_x, f6_y, f6_z, f06_x, f06_y, n06_x, n06_y, n5_x
    real(rk) :: n5_y, n5_z, f5_x, f5_y, f5_z, neg_f05_x, f05_y, n05_x
    real(rk) :: n05_y, n4_x, n4_y, n4_z, f4_x, f4_y, f4_z, f04_x
    real(rk) :: f04_y, n04_x, n04_y, n3_x, n3_y, n3_z, f3_x, f3_y
    real(rk) :: neg_f03_x, f03_y, n03_x, n03_y, neg_n2_x, n2_y, n2_z, n02_y
    real(rk) :: n1_z

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
    a2_x = -9.81_rk*s2
    a2_y = -9.81_rk*c2
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
    a3_z = -0.316_rk*neg_lam2_22 - a2_y
    ! link 3: angular velocity [rad/s]
    w3_x = c3*w2_x + qd(2)*s3
    w3_y = qd(2)*c3 - s3*w2_x
    t2 = -0.316_rk*lam2_32
    t3 = 0.316_rk*lam2_12 - a2_x
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_x = s3*t2 - c3*t3
    a3_y = s3*t3 + c3*t2
    ! link 3: angular acceleration [rad/s^2]
    alpha3_x = qd(3)*w3_y - (-c3*alpha2_x - qdd(2)*s3)
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
    t4 = -c4
    ! link 4: angular velocity [rad/s]
    w4_x = t4*w3_x - s4*w3_z
    w4_y = s4*w3_x - c4*w3_z
    t5 = 0.0825_rk*neg_lam3_11 - a3_x
    t6 = a3_z + 0.0825_rk*lam3_31
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_x = c4*t5 - s4*t6
    neg_a4_y = s4*t5 + c4*t6
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = t4*alpha3_x - s4*alpha3_z + qd(4)*w4_y
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
    neg_ww4_zz = -w4_z*w4_z
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_11 = neg_ww4_zz - ww4_yy
    lam4_12 = ww4_xy - alpha4_z
    lam4_13 = ww4_zx - neg_alpha4_y
    lam4_21 = alpha4_z + ww4_xy
    lam4_22 = neg_ww4_zz - ww4_xx
    lam4_23 = ww4_yz - alpha4_x
    lam4_31 = neg_alpha4_y + ww4_zx
    lam4_32 = alpha4_x + ww4_yz
    lam4_33 = -ww4_xx - ww4_yy
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_z = neg_a4_y + (0.384_rk*lam4_22 - 0.0825_rk*lam4_21)
    ! link 5: angular velocity [rad/s]
    w5_x = -(c5*w4_x) - s5*w4_z
    w5_y = s5*w4_x - c5*w4_z
    t7 = neg_a4_z + (0.384_rk*lam4_32 - 0.0825_rk*lam4_31)
    t8 = a4_x - (0.384_rk*lam4_12 - 0.0825_rk*lam4_11)
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
    ! link 7: acceleration of the frame's origin, gravity taken off [m/s^2]
    a7_z = -0.088_rk*lam6_21 - a6_y
    ! link 7: angular velocity [rad/s]
    w7_x = c7*w6_x + s7*w6_z
    w7_y = c7*w6_z - s7*w6_x
    t9 = 0.088_rk*neg_lam6_11 - a6_x
    t10 = a5_y - 0.088_rk*lam6_31
    ! link 7: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a7_x = c7*t9 + s7*t10
    a7_y = s7*t9 - c7*t10
    ! link 7: angular acceleration [rad/s^2]
    alpha7_x = qd(7)*w7_y - (-c7*alpha6_x - s7*alpha6_z)
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
    neg_nc2_x = 0.0007689361029464017_rk*(neg_lam2_22 - neg_lam2_33) - &
        1.0321620612318807_rk*lam2_32 + (-0.003983358883935522_rk*lam2_31 - &
        0.010261101821008168_rk*lam2_21)
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
    fc4_x = 0.5527802746499999_rk*lam4_11 - 2.0125235536029997_rk*lam4_12
    fc4_y = 0.5527802746499999_rk*lam4_21 - 2.0125235536029997_rk*lam4_22
    fc4_z = 0.5527802746499999_rk*lam4_31 - 2.0125235536029997_rk*lam4_32
    ! link 4: moment that turns the link [N m]
    nc4_x = 0.6972920750309717_rk*lam4_32 - 0.00164448757736928_rk*(lam4_33 - lam4_22) - &
        (0.16284087268546082_rk*lam4_31 + 0.0039053550262761055_rk*lam4_21) + &
        2.0125235536029997_rk*neg_a4_z
    nc4_y = 0.5527802746499999_rk*neg_a4_z - (0.05102013615681549_rk*lam4_31 + &
        0.0039053550262761055_rk*(lam4_33 - lam4_11) - (0.16284087268546082_rk*lam4_32 - &
        0.00164448757736928_rk*lam4_12))
    t13 = 0.05102013615681549_rk*lam4_21 - 0.6972920750309717_rk*lam4_12 - &
        0.16284087268546082_rk*(lam4_22 - lam4_11) - (-0.0039053550262761055_rk*lam4_23 - &
        0.00164448757736928_rk*lam4_13)
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
    neg_fc7_z = 0.002573605371338201_rk*neg_lam7_31 - 0.0020344399586618637_rk*lam7_32
    ! link 7: moment that turns the link [N m]
    nc7_x = 0.0020344399586618637_rk*a7_z - (-0.004552547872941087_rk*lam7_32 - &
        0.0012555365982729084_rk*(neg_lam7_22 - neg_lam7_33) - &
        (0.0003913912816842475_rk*neg_lam7_31 - 0.0009653051699191118_rk*lam7_21))
    nc7_y = 0.00213160409441986_rk*neg_lam7_31 - 0.0009653051699191118_rk*(neg_lam7_11 - &
        neg_lam7_33) - (-0.0012555365982729084_rk*lam7_12 - 0.0003913912816842475_rk*lam7_32) - &
        0.002573605371338201_rk*a7_z
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
    n6_z = n07_y + (nc6_z + 0.088_rk*neg_fc7_z)
    ! link 6: force through the joint [N]
    f6_x = fc6_x + f07_x
    f6_y = fc6_y + neg_fc7_z
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
    neg_f05_x = c5*f5_x - s5*f5_y
    f05_y = -c5*f5_y - s5*f5_x
    ! link 5: moment through the joint, along the axes that its turn starts from [N m]
    n05_x = s5*n5_y - c5*n5_x
    n05_y = -s5*n5_x - c5*n5_y
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = n05_x + (nc4_x - 0.384_rk*f05_y)
    n4_y = nc4_y - 0.0825_rk*f05_y - n5_z
    n4_z = n05_y + (nc4_z - (0.0825_rk*f5_z + 0.384_rk*neg_f05_x))
    ! link 4: force through the joint [N]
    f4_x = fc4_x - neg_f05_x
    f4_y = fc4_y - f5_z
    f4_z = fc4_z + f05_y
    ! link 4: force through the joint, along the axes that its turn starts from [N]
    f04_x = s4*f4_y - c4*f4_x
    f04_y = -s4*f4_x - c4*f4_y
    ! link 4: moment through the joint, along the axes that its turn starts from [N m]
    n04_x = s4*n4_y - c4*n4_x
    n04_y = t4*n4_y - s4*n4_x
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_x = nc3_x + n04_x
    n3_y = nc3_y - 0.0825_rk*f04_y - n4_z
    n3_z = n04_y + (nc3_z - 0.0825_rk*f4_z)
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
    neg_n2_x = neg_nc2_x + 0.316_rk*f03_y - n03_x
    n2_y = nc2_y - n3_z
    n2_z = n03_y + (nc2_z - 0.316_rk*neg_f03_x)
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_y = s2*neg_n2_x - c2*n2_y
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
  ! 64 multiplications, 38 additions = 102; 3 unary minus; 12 sine/cosine
  pure subroutine panda_gravity(q, tau) &
      bind(c, name="panda_gravity_f")
    real(rk), intent(in) :: q(7)
    real(rk), intent(out) :: tau(7)
    real(rk) :: c2, s2, c3, s3, c4, s4, c5, s5
    real(rk) :: c6, s6, c7, s7, a2_x, a2_y, a3_x, a3_y
    real(rk) :: a4_x, a4_y, a5_x, a5_y, a6_x, a6_y, neg_a7_x, a7_y
    real(rk) :: nc2_z, nc3_x, nc3_y, nc3_z, nc4_x, nc4_y, nc4_z, nc5_x
    real(rk) :: nc5_y, nc5_z, nc6_x, nc6_y, nc6_z, nc7_x, nc7_y, nc7_z
    real(rk) :: n07_x, n07_y, n6_x, n6_y, n6_z, n06_x, n06_y, n5_x
    real(rk) :: n5_y, n5_z, n05_x, neg_n05_y, n4_x, n4_y, n4_z, n04_x
    real(rk) :: neg_n04_y, n3_x, n3_y, n3_z, n03_x, n03_y, n2_z, n02_y

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
    a2_x = -9.81_rk*s2
    a2_y = -9.81_rk*c2
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_x = c3*a2_x
    a3_y = -s3*a2_x
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_x = s4*a2_y - c4*a3_x
    a4_y = s4*a3_x + c4*a2_y
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_x = s5*a3_y - c5*a4_x
    a5_y = s5*a4_x + c5*a3_y
    ! link 6: acceleration of the frame's origin, gravity taken off [m/s^2]
    a6_x = c6*a5_x - s6*a4_y
    a6_y = -s6*a5_x - c6*a4_y
    ! link 7: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a7_x = s7*a5_y - c7*a6_x
    a7_y = -s7*a6_x - c7*a5_y
    ! link 2: moment that turns the link [N m]
    nc2_z = 0.01993386669246_rk*c2 - 32.809545426852715_rk*s2
    ! link 3: moment that turns the link [N m]
    nc3_x = 0.27690780075317833_rk*c2
    nc3_y = -7.32667658634432_rk*c2
    nc3_z = 0.746857959872_rk*a3_y - 0.028227094877999827_rk*a3_x
    ! link 4: moment that turns the link [N m]
    nc4_x = 2.0125235536029997_rk*a3_y
    nc4_y = 0.5527802746499999_rk*a3_y
    nc4_z = 0.5527802746499999_rk*a4_y + 2.0125235536029997_rk*a4_x
    ! link 5: moment that turns the link [N m]
    nc5_x = -0.067870631425_rk*a4_y
    nc5_y = -0.014653732538_rk*a4_y
    nc5_z = -0.067870631425_rk*a5_x - 0.014653732538_rk*a5_y
    ! link 6: moment that turns the link [N m]
    nc6_x = 0.17380470556899996_rk*a5_y
    nc6_y = 0.231847552695_rk*a5_y
    nc6_z = 0.231847552695_rk*a6_y + 0.17380470556899996_rk*a6_x
    ! link 7: moment that turns the link [N m]
    nc7_x = -0.0020344399586618637_rk*a6_y
    nc7_y = 0.002573605371338201_rk*a6_y
    nc7_z = 0.002573605371338201_rk*a7_y + 0.0020344399586618637_rk*neg_a7_x
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
  ! 300 multiplications, 273 additions = 573; 12 unary minus; 12 sine/cosine
  pure subroutine panda_bias(q, qd, tau) &
      bind(c, name="panda_bias_f")
    real(rk), intent(in) :: q(7)
    real(rk), intent(in) :: qd(7)
    real(rk), intent(out) :: tau(7)
    real(rk) :: c2, s2, c3, s3, c4, s4, c5, s5
    real(rk) :: c6, s6, c7, s7, t1, w2_x, w2_y, a2_x
    real(rk) :: a2_y, alpha2_x, alpha2_y, ww2_xy, ww2_xx, ww2_yy, ww2_zz, neg_lam2_11
    real(rk) :: neg_lam2_22, neg_lam2_33, a3_z, w3_x, w3_y, t2, t3, a3_x
    real(rk) :: a3_y, alpha3_x, alpha3_y, w3_z, ww3_yz, ww3_zx, ww3_xy, ww3_xx
    real(rk) :: ww3_yy, ww3_zz, neg_lam3_11, lam3_12, lam3_13, lam3_21, neg_lam3_22, lam3_23
    real(rk) :: lam3_31, lam3_32, neg_lam3_33, a4_z, t4, w4_x, w4_y, t5
    real(rk) :: t6, a4_x, neg_a4_y, alpha4_x, alpha4_y, w4_z, ww4_yz, ww4_zx
    real(rk) :: ww4_xy, ww4_xx, ww4_yy, neg_ww4_zz, lam4_11, lam4_12, lam4_13, lam4_21
    real(rk) :: lam4_22, lam4_23, lam4_31, lam4_32, lam4_33, a5_z, w5_x, w5_y
    real(rk) :: t7, t8, a5_x, a5_y, alpha5_x, alpha5_y, w5_z, ww5_yz
    real(rk) :: ww5_zx, ww5_xy, ww5_xx, ww5_yy, ww5_zz, neg_lam5_11, lam5_12, lam5_13
    real(rk) :: lam5_21, neg_lam5_22, lam5_23, lam5_31, lam5_32, neg_lam5_33, w6_x, w6_y
    real(rk) :: a6_x, a6_y, alpha6_x, alpha6_y, w6_z, ww6_yz, ww6_zx, ww6_xy
    real(rk) :: ww6_xx, ww6_yy, ww6_zz, neg_lam6_11, lam6_12, lam6_13, lam6_21, neg_lam6_22
    real(rk) :: lam6_23, lam6_31, lam6_32, neg_lam6_33, a7_z, w7_x, w7_y, t9
    real(rk) :: t10, neg_a7_x, a7_y, alpha7_x, t11, alpha7_y, w7_z, ww7_yz
    real(rk) :: ww7_zx, ww7_xy, ww7_xx, ww7_yy, ww7_zz, neg_lam7_11, lam7_12, lam7_13
    real(rk) :: lam7_21, neg_lam7_22, lam7_23, neg_lam7_31, lam7_32, neg_lam7_33, neg_nc2_x, nc2_y
    real(rk) :: nc2_z, fc3_x, fc3_y, nc3_x, nc3_y, t12, nc3_z, fc4_x
    real(rk) :: fc4_y, fc4_z, nc4_x, nc4_y, t13, neg_nc4_z, fc5_x, fc5_y
    real(rk) :: fc5_z, nc5_x, nc5_y, t14, nc5_z, fc6_x, fc6_y, fc6_z
    real(rk) :: nc6_x, nc6_y, t15, nc6_z, fc7_x, fc7_y, neg_fc7_z, nc7_x
    real(rk) :: nc7_y, t16, nc7_z, f07_x, neg_f07_y, n07_x, n07_y, n6_x
    real(rk) :: n6_y, n6_z, f6_x, f6_y, f6_z, f06_x, f06_y, n06_x
    real(rk) :: n06_y, n5_x, n5_y, n5_z, f5_x, f5_y, f5_z, neg_f05_x
    real(rk) :: f05_y, n05_x, n05_y, n4_x, n4_y, n4_z, f4_x, f4_y
    real(rk) :: f4_z, f04_x, f04_y, n04_x, n04_y, n3_x, n3_y, n3_z
    real(rk) :: f3_x, f3_y, f03_x, f03_y, n03_x, n03_y, neg_n2_x, n2_y
    real(rk) :: n2_z, n02_y

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
    a2_x = -9.81_rk*s2
    a2_y = -9.81_rk*c2
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
    neg_lam2_22 = ww2_xx + ww2_zz
    neg_lam2_33 = ww2_xx + ww2_yy
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_z = -0.316_rk*neg_lam2_22 - a2_y
    ! link 3: angular velocity [rad/s]
    w3_x = c3*w2_x + qd(2)*s3
    w3_y = qd(2)*c3 - s3*w2_x
    t2 = -0.632_rk*alpha2_x
    t3 = 0.316_rk*ww2_xy - a2_x
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_x = s3*t2 - c3*t3
    a3_y = s3*t3 + c3*t2
    ! link 3: angular acceleration [rad/s^2]
    alpha3_x = c3*alpha2_x + qd(3)*w3_y
    alpha3_y = -s3*alpha2_x - qd(3)*w3_x
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
    lam3_12 = alpha2_y + ww3_xy
    lam3_13 = alpha3_y + ww3_zx
    lam3_21 = ww3_xy - alpha2_y
    neg_lam3_22 = ww3_xx + ww3_zz
    lam3_23 = ww3_yz - alpha3_x
    lam3_31 = ww3_zx - alpha3_y
    lam3_32 = alpha3_x + ww3_yz
    neg_lam3_33 = ww3_xx + ww3_yy
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_z = -0.0825_rk*lam3_21 - a3_y
    t4 = -c4
    ! link 4: angular velocity [rad/s]
    w4_x = t4*w3_x - s4*w3_z
    w4_y = s4*w3_x - c4*w3_z
    t5 = 0.0825_rk*neg_lam3_11 - a3_x
    t6 = a3_z + 0.0825_rk*lam3_31
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_x = c4*t5 - s4*t6
    neg_a4_y = s4*t5 + c4*t6
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = s4*alpha2_y - c4*alpha3_x + qd(4)*w4_y
    alpha4_y = s4*alpha3_x + c4*alpha2_y - qd(4)*w4_x
    ! link 4: angular velocity [rad/s]
    w4_z = qd(4) - w3_y
    ! link 4: products of the angular velocity [1/s^2]
    ww4_yz = w4_y*w4_z
    ww4_zx = w4_x*w4_z
    ww4_xy = w4_x*w4_y
    ww4_xx = w4_x*w4_x
    ww4_yy = w4_y*w4_y
    neg_ww4_zz = -w4_z*w4_z
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_11 = neg_ww4_zz - ww4_yy
    lam4_12 = alpha3_y + ww4_xy
    lam4_13 = alpha4_y + ww4_zx
    lam4_21 = ww4_xy - alpha3_y
    lam4_22 = neg_ww4_zz - ww4_xx
    lam4_23 = ww4_yz - alpha4_x
    lam4_31 = ww4_zx - alpha4_y
    lam4_32 = alpha4_x + ww4_yz
    lam4_33 = -ww4_xx - ww4_yy
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_z = neg_a4_y + (0.384_rk*lam4_22 - 0.0825_rk*lam4_21)
    ! link 5: angular velocity [rad/s]
    w5_x = -(c5*w4_x) - s5*w4_z
    w5_y = s5*w4_x - c5*w4_z
    t7 = 0.384_rk*lam4_32 - 0.0825_rk*lam4_31 - a4_z
    t8 = a4_x - (0.384_rk*lam4_12 - 0.0825_rk*lam4_11)
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_x = s5*t7 - c5*t8
    a5_y = s5*t8 + c5*t7
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
    lam5_12 = alpha4_y + ww5_xy
    lam5_13 = alpha5_y + ww5_zx
    lam5_21 = ww5_xy - alpha4_y
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
    alpha6_x = qd(6)*w6_y - (s6*alpha4_y - c6*alpha5_x)
    alpha6_y = -s6*alpha5_x - c6*alpha4_y - qd(6)*w6_x
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
    t9 = 0.088_rk*neg_lam6_11 - a6_x
    t10 = a5_y - 0.088_rk*lam6_31
    ! link 7: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a7_x = c7*t9 + s7*t10
    a7_y = s7*t9 - c7*t10
    ! link 7: angular acceleration [rad/s^2]
    alpha7_x = qd(7)*w7_y - (s7*alpha5_y - c7*alpha6_x)
    t11 = -s7
    alpha7_y = t11*alpha6_x - c7*alpha5_y - qd(7)*w7_x
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
    neg_nc2_x = 0.0007689361029464017_rk*(neg_lam2_22 - neg_lam2_33) - &
        2.0643241224637614_rk*alpha2_x + (0.007966717767871044_rk*alpha2_y - &
        0.010261101821008168_rk*ww2_xy)
    nc2_y = 0.04615576498986361_rk*alpha2_y + 0.010261101821008168_rk*(neg_lam2_11 - neg_lam2_33) &
        - (0.0007689361029464017_rk*ww2_xy + 0.007966717767871044_rk*alpha2_x)
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
    fc4_x = 0.5527802746499999_rk*lam4_11 - 2.0125235536029997_rk*lam4_12
    fc4_y = 0.5527802746499999_rk*lam4_21 - 2.0125235536029997_rk*lam4_22
    fc4_z = 0.5527802746499999_rk*lam4_31 - 2.0125235536029997_rk*lam4_32
    ! link 4: moment that turns the link [N m]
    nc4_x = 0.6972920750309717_rk*lam4_32 - 0.00164448757736928_rk*(lam4_33 - lam4_22) - &
        (0.16284087268546082_rk*lam4_31 + 0.0039053550262761055_rk*lam4_21) - &
        2.0125235536029997_rk*a4_z
    nc4_y = -0.5527802746499999_rk*a4_z - (0.05102013615681549_rk*lam4_31 + &
        0.0039053550262761055_rk*(lam4_33 - lam4_11) + (0.00164448757736928_rk*lam4_12 - &
        0.16284087268546082_rk*lam4_32))
    t13 = 0.6972920750309717_rk*lam4_12 - 0.05102013615681549_rk*lam4_21 + &
        0.16284087268546082_rk*(lam4_22 - lam4_11) + (-0.0039053550262761055_rk*lam4_23 - &
        0.00164448757736928_rk*lam4_13)
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
    neg_fc7_z = 0.002573605371338201_rk*neg_lam7_31 - 0.0020344399586618637_rk*lam7_32
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
    neg_f07_y = t11*fc7_x - c7*fc7_y
    ! link 7: moment through the joint, along the axes that its turn starts from [N m]
    n07_x = c7*nc7_x - s7*nc7_y
    n07_y = s7*nc7_x + c7*nc7_y
    ! link 6: moment through the joint, about the frame's origin [N m]
    n6_x = nc6_x + n07_x
    n6_y = nc6_y + 0.088_rk*neg_f07_y - nc7_z
    n6_z = n07_y + (nc6_z + 0.088_rk*neg_fc7_z)
    ! link 6: force through the joint [N]
    f6_x = fc6_x + f07_x
    f6_y = fc6_y + neg_fc7_z
    f6_z = fc6_z - neg_f07_y
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
    neg_f05_x = c5*f5_x - s5*f5_y
    f05_y = -c5*f5_y - s5*f5_x
    ! link 5: moment through the joint, along the axes that its turn starts from [N m]
    n05_x = s5*n5_y - c5*n5_x
    n05_y = -s5*n5_x - c5*n5_y
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = n05_x + (nc4_x - 0.384_rk*f05_y)
    n4_y = nc4_y - 0.0825_rk*f05_y - n5_z
    n4_z = n05_y - (neg_nc4_z + (0.0825_rk*f5_z + 0.384_rk*neg_f05_x))
    ! link 4: force through the joint [N]
    f4_x = fc4_x - neg_f05_x
    f4_y = fc4_y - f5_z
    f4_z = fc4_z + f05_y
    ! link 4: force through the joint, along the axes that its turn starts from [N]
    f04_x = s4*f4_y - c4*f4_x
    f04_y = -s4*f4_x - c4*f4_y
    ! link 4: moment through the joint, along the axes that its turn starts from [N m]
    n04_x = s4*n4_y - c4*n4_x
    n04_y = t4*n4_y - s4*n4_x
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_x = nc3_x + n04_x
    n3_y = nc3_y - 0.0825_rk*f04_y - n4_z
    n3_z = n04_y - (0.0825_rk*f4_z - nc3_z)
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
    neg_n2_x = neg_nc2_x + 0.316_rk*f03_y - n03_x
    n2_y = nc2_y - n3_z
    n2_z = n03_y - (-0.316_rk*f03_x - nc2_z)
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_y = s2*neg_n2_x - c2*n2_y
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
    real(rk) :: c2, s2, c3, s3, c4, s4, c5, s5
    real(rk) :: c6, s6, c7, s7, fu6_x, fu6_z, nu6_x, nu6_z
    real(rk) :: nu6_y, fu5_x, fu5_z, neg_nu5_x, nu5_z, fu4_x, fu4_z, nu4_x
    real(rk) :: t1, nu4_y, nu4_z, t2, fu3_x, neg_fu3_z, nu3_x, nu3_y
    real(rk) :: nu3_z, fu2_x, neg_fu2_z, nu2_x, t3, nu2_z, nu1_z, h6_x
    real(rk) :: t4, t5, t6, t7, k6_xx, k6_xy, k6_xz, k6_yz
    real(rk) :: m6_6, fu5_x_2, fu5_z_2, nu5_x, nu5_z_2, neg_fu4_x, t8, fu4_z_2
    real(rk) :: nu4_x_2, t9, nu4_y_2, nu4_z_2, fu3_x_2, fu3_z, nu3_x_2, nu3_y_2
    real(rk) :: nu3_z_2, fu2_x_2, fu2_z, nu2_x_2, nu2_z_2, nu1_z_2, t10, t11
    real(rk) :: t12, t13, k5_zz, h5_x, h5_y, k5_xx, k5_yy, k5_xy
    real(rk) :: k5_xz, k5_yz, m5_5, fu4_x_2, fu4_z_3, t14, t15, nu4_x_3
    real(rk) :: t16, nu4_y_3, nu4_z_3, fu3_x_3, neg_fu3_z_2, nu3_x_3, nu3_y_3, nu3_z_3
    real(rk) :: fu2_x_3, fu2_z_2, nu2_x_3, nu2_z_3, nu1_z_3, t17, t18, t19
    real(rk) :: t20, k4_zz, h4_x, h4_y, t21, k4_xx, t22, k4_yy
    real(rk) :: k4_xy, t23, k4_xz, k4_yz, m4_4, fu3_x_4, fu3_z_2, nu3_x_4
    real(rk) :: nu3_z_4, nu3_y_4, fu2_x_4, fu2_z_3, nu2_x_4, nu2_z_4, nu1_z_4, t24
    real(rk) :: t25, t26, t27, k3_zz, h3_x, h3_y, t28, k3_xx
    real(rk) :: k3_yy, k3_xy, k3_xz, k3_yz, m3_3, fu2_x_5, fu2_z_4, nu2_x_5
    real(rk) :: nu2_z_5, nu1_z_5, t29, t30, t31, t32, k2_zz, t33
    real(rk) :: k2_yy, k2_xy, k2_xz, k2_yz, t34, m2_2, nu1_z_6, t35
    real(rk) :: m1_1

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
    ! link 6: force for a unit acceleration of a joint further out
    fu6_x = -0.002573605371338201_rk*s7 - 0.0020344399586618637_rk*c7
    fu6_z = 0.002573605371338201_rk*c7 - 0.0020344399586618637_rk*s7
    ! link 6: moment for a unit acceleration of a joint further out
    nu6_x = 0.0012555365982729084_rk*s7 - 0.0009653051699191118_rk*c7
    nu6_z = -0.0012555365982729084_rk*c7 - 0.0009653051699191118_rk*s7
    nu6_y = -0.088_rk*fu6_z - 0.006684151967360947_rk
    ! link 5: force for a unit acceleration of a joint further out
    fu5_x = c6*fu6_x
    fu5_z = s6*fu6_x
    ! link 5: moment for a unit acceleration of a joint further out
    neg_nu5_x = s6*nu6_y - c6*nu6_x
    nu5_z = s6*nu6_x + c6*nu6_y
    ! link 4: force for a unit acceleration of a joint further out
    fu4_x = -c5*fu5_x - s5*fu6_z
    fu4_z = c5*fu6_z - s5*fu5_x
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_x = c5*neg_nu5_x - s5*nu6_z - 0.384_rk*fu4_z
    t1 = -0.0825_rk*fu4_z
    nu4_y = t1 - nu5_z
    nu4_z = s5*neg_nu5_x + c5*nu6_z + (0.384_rk*fu4_x - 0.0825_rk*fu5_z)
    t2 = -s4
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x = t2*fu5_z - c4*fu4_x
    neg_fu3_z = s4*fu4_x - c4*fu5_z
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_x = s4*nu4_y - c4*nu4_x
    nu3_y = 0.0825_rk*neg_fu3_z - nu4_z
    nu3_z = t1 - (s4*nu4_x + c4*nu4_y)
    ! link 2: force for a unit acceleration of a joint further out
    fu2_x = c3*fu3_x + s3*fu4_z
    neg_fu2_z = c3*fu4_z - s3*fu3_x
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_x = 0.316_rk*neg_fu2_z - (s3*nu3_y - c3*nu3_x)
    t3 = -s3
    nu2_z = 0.316_rk*fu2_x - (t3*nu3_x - c3*nu3_y)
    ! link 1: moment for a unit acceleration of a joint further out
    nu1_z = c2*nu3_z - s2*nu2_x
    ! link 6: first moment of the composite body, about the frame's origin [kg m]
    h6_x = fu6_z + 0.231847552695_rk
    t4 = c7*c7
    t5 = c7*s7
    t6 = 0.002420943778521227_rk*t4 - 0.000782782563368495_rk*t5
    t7 = t6 - 0.004552547872941087_rk - 0.176_rk*fu6_z
    ! link 6: second moment of the composite body [kg m^2]
    k6_xx = 0.021522255370587554_rk - t7
    k6_xy = nu6_x - 0.014748570382675314_rk
    k6_xz = 0.0001037589172186853_rk - (0.002420943778521227_rk*t5 + &
        0.0003913912816842475_rk*(2.0_rk*t4 - 1.0_rk) + 0.088_rk*fu6_x)
    k6_yz = nu6_z - 9.35690973146064e-05_rk
    ! link 6: mass matrix, its row of this joint
    m6_6 = 0.05045667791624746_rk - t7
    ! link 5: force for a unit acceleration of a joint further out
    fu5_x_2 = 0.17380470556899996_rk*c6 - s6*h6_x
    fu5_z_2 = 0.17380470556899996_rk*s6 + c6*h6_x
    ! link 5: moment for a unit acceleration of a joint further out
    nu5_x = s6*k6_yz - c6*k6_xz
    nu5_z_2 = -s6*k6_xz - c6*k6_yz
    ! link 4: force for a unit acceleration of a joint further out
    neg_fu4_x = c5*fu5_x_2
    t8 = -s5
    fu4_z_2 = t8*fu5_x_2
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_x_2 = -0.384_rk*fu4_z_2 - (c5*nu5_x + s5*m6_6)
    t9 = -0.0825_rk*fu4_z_2
    nu4_y_2 = t9 - nu5_z_2
    nu4_z_2 = -0.384_rk*neg_fu4_x - 0.0825_rk*fu5_z_2 - (s5*nu5_x - c5*m6_6)
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x_2 = c4*neg_fu4_x - s4*fu5_z_2
    fu3_z = s4*neg_fu4_x + c4*fu5_z_2
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_x_2 = s4*nu4_y_2 - c4*nu4_x_2
    nu3_y_2 = -0.0825_rk*fu3_z - nu4_z_2
    nu3_z_2 = t9 + (t2*nu4_x_2 - c4*nu4_y_2)
    ! link 2: force for a unit acceleration of a joint further out
    fu2_x_2 = c3*fu3_x_2 + s3*fu4_z_2
    fu2_z = s3*fu3_x_2 - c3*fu4_z_2
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_x_2 = c3*nu3_x_2 - s3*nu3_y_2 - 0.316_rk*fu2_z
    nu2_z_2 = s3*nu3_x_2 + c3*nu3_y_2 + 0.316_rk*fu2_x_2
    ! link 1: moment for a unit acceleration of a joint further out
    nu1_z_2 = c2*nu3_z_2 - s2*nu2_x_2
    t10 = c6*c6
    t11 = t7 + 0.007412167175072353_rk
    t12 = c6*s6
    t13 = t10*t11 + k6_xy*(2.0_rk*t12)
    ! link 5: second moment of the composite body [kg m^2]
    k5_zz = k6_xx + t13
    ! link 5: first moment of the composite body, about the frame's origin [kg m]
    h5_x = fu5_z_2 - 0.014653732538_rk
    h5_y = fu6_x + 0.067870631425_rk
    ! link 5: second moment of the composite body [kg m^2]
    k5_xx = 0.03038557861068662_rk - t13
    k5_yy = t6 + 0.012176791922741105_rk
    k5_xy = nu5_x + 0.00151524447332703_rk
    k5_xz = 0.004600245517563107_rk - (t11*t12 + k6_xy*(1.0_rk - 2.0_rk*t10))
    k5_yz = nu5_z_2 - 0.0021640520520981327_rk
    ! link 5: mass matrix, its row of this joint
    m5_5 = t6 - t13 + 0.04256237053342773_rk
    ! link 4: force for a unit acceleration of a joint further out
    fu4_x_2 = c5*h5_y + s5*h5_x
    fu4_z_3 = s5*h5_y - c5*h5_x
    t14 = -0.384_rk*fu4_z_3
    t15 = s5*k5_yz - c5*k5_xz
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_x_3 = t14 - t15
    t16 = -0.0825_rk*fu4_z_3
    nu4_y_3 = t16 - m5_5
    nu4_z_3 = 0.384_rk*fu4_x_2 - (t8*k5_xz - c5*k5_yz)
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x_3 = -c4*fu4_x_2
    neg_fu3_z_2 = s4*fu4_x_2
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_x_3 = s4*nu4_y_3 - c4*nu4_x_3
    nu3_y_3 = 0.0825_rk*neg_fu3_z_2 - nu4_z_3
    nu3_z_3 = t16 + (t2*nu4_x_3 - c4*nu4_y_3)
    ! link 2: force for a unit acceleration of a joint further out
    fu2_x_3 = c3*fu3_x_3 + s3*fu4_z_3
    fu2_z_2 = s3*fu3_x_3 - c3*fu4_z_3
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_x_3 = c3*nu3_x_3 - s3*nu3_y_3 - 0.316_rk*fu2_z_2
    nu2_z_3 = s3*nu3_x_3 + c3*nu3_y_3 + 0.316_rk*fu2_x_3
    ! link 1: moment for a unit acceleration of a joint further out
    nu1_z_3 = c2*nu3_z_3 - s2*nu2_x_3
    t17 = c5*c5
    t18 = t6 + t13 - 0.018208786687945514_rk
    t19 = c5*s5
    t20 = t17*t18 + k5_xy*(2.0_rk*t19)
    ! link 4: second moment of the composite body [kg m^2]
    k4_zz = k5_xx + t20
    ! link 4: first moment of the composite body, about the frame's origin [kg m]
    h4_x = fu4_z_3 + 0.5527802746499999_rk
    h4_y = fu5_x_2 - 2.0125235536029997_rk
    t21 = k5_yy - t20 + 0.165_rk*fu4_z_3
    ! link 4: second moment of the composite body [kg m^2]
    k4_xx = t21 + 0.05102013615681549_rk
    t22 = 0.768_rk*fu5_x_2 - k5_zz
    k4_yy = 0.6972920750309717_rk - t22
    k4_xy = t14 - (t15 - 0.0825_rk*fu5_x_2) - 0.16284087268546082_rk
    t23 = -0.0825_rk*fu4_x_2
    k4_xz = 0.0039053550262761055_rk - (t18*t19 + k5_xy*(1.0_rk - 2.0_rk*t17) - t23)
    k4_yz = nu4_z_3 - 0.00164448757736928_rk
    ! link 4: mass matrix, its row of this joint
    m4_4 = t21 - t22 + 0.7483122111877871_rk
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x_4 = c4*h4_y + s4*h4_x
    fu3_z_2 = s4*h4_y - c4*h4_x
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_x_4 = c4*k4_xz - s4*k4_yz
    nu3_z_4 = s4*k4_xz + c4*k4_yz
    nu3_y_4 = -0.0825_rk*fu3_z_2 - m4_4
    ! link 2: force for a unit acceleration of a joint further out
    fu2_x_4 = c3*fu3_x_4
    fu2_z_3 = s3*fu3_x_4
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_x_4 = -0.316_rk*fu2_z_3 - (s3*nu3_y_4 - c3*nu3_x_4)
    nu2_z_4 = 0.316_rk*fu2_x_4 - (t3*nu3_x_4 - c3*nu3_y_4)
    ! link 1: moment for a unit acceleration of a joint further out
    nu1_z_4 = c2*nu3_z_4 - s2*nu2_x_4
    t24 = c4*s4
    t25 = c4*c4
    t26 = t21 + t22 - 0.6462719388741561_rk
    t27 = k4_xy*(2.0_rk*t24) - t25*t26
    ! link 3: second moment of the composite body [kg m^2]
    k3_zz = k4_xx + t27
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    h3_x = fu3_z_2 + 0.746857959872_rk
    h3_y = fu4_x_2 + 0.028227094877999827_rk
    t28 = t27 - k4_yy - 0.165_rk*fu3_z_2
    ! link 3: second moment of the composite body [kg m^2]
    k3_xx = 0.061602421026527694_rk - t28
    k3_yy = k4_zz + 0.022178148964878252_rk
    k3_xy = 0.0001219124209507298_rk - (t23 - nu3_x_4)
    k3_xz = t26*t24 - k4_xy*(1.0_rk - 2.0_rk*t25) - 0.0825_rk*fu3_x_4 + 0.005487648106562251_rk
    k3_yz = nu3_z_4 + 0.0043772571218395765_rk
    ! link 3: mass matrix, its row of this joint
    m3_3 = 0.08378056999140594_rk - (t28 - k4_zz)
    ! link 2: force for a unit acceleration of a joint further out
    fu2_x_5 = -c3*h3_y - s3*h3_x
    fu2_z_4 = c3*h3_x - s3*h3_y
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_x_5 = -0.316_rk*fu2_z_4 - (c3*k3_xz - s3*k3_yz)
    nu2_z_5 = 0.316_rk*fu2_x_5 - (s3*k3_xz + c3*k3_yz)
    ! link 1: moment for a unit acceleration of a joint further out
    nu1_z_5 = c2*m3_3 - s2*nu2_x_5
    t29 = c3*s3
    t30 = c3*c3
    t31 = 0.039424272061649446_rk - (k4_zz + t28)
    t32 = k3_xy*(2.0_rk*t29) - t30*t31
    ! link 2: second moment of the composite body [kg m^2]
    k2_zz = k3_xx + t32
    t33 = k3_zz - 0.632_rk*fu3_x_4
    k2_yy = t33 + 1.0321620612318807_rk
    k2_xy = nu2_x_5 + 0.003983358883935522_rk
    k2_xz = t31*t29 - k3_xy*(1.0_rk - 2.0_rk*t30) - 0.010261101821008168_rk
    k2_yz = nu2_z_5 - 0.0007689361029464017_rk
    t34 = t32 - k3_yy
    ! link 2: mass matrix, its row of this joint
    m2_2 = 1.0552399437268125_rk - (t34 - t33)
    ! link 1: moment for a unit acceleration of a joint further out
    nu1_z_6 = s2*k2_xz + c2*k2_yz
    t35 = k2_zz + (k2_yy - (c2*c2*(t34 + t33 + 1.009084178736949_rk) + k2_xy*(2.0_rk*(c2*s2))))
    ! link 1: mass matrix, its row of this joint
    m1_1 = t35 + 0.014259565994474374_rk
    M(1) = m1_1
    M(2) = nu1_z_6
    M(3) = nu1_z_5
    M(4) = nu1_z_4
    M(5) = nu1_z_3
    M(6) = nu1_z_2
    M(7) = nu1_z
    M(8) = nu1_z_6
    M(9) = m2_2
    M(10) = nu2_z_5
    M(11) = nu2_z_4
    M(12) = nu2_z_3
    M(13) = nu2_z_2
    M(14) = nu2_z
    M(15) = nu1_z_5
    M(16) = nu2_z_5
    M(17) = m3_3
    M(18) = nu3_z_4
    M(19) = nu3_z_3
    M(20) = nu3_z_2
    M(21) = nu3_z
    M(22) = nu1_z_4
    M(23) = nu2_z_4
    M(24) = nu3_z_4
    M(25) = m4_4
    M(26) = nu4_z_3
    M(27) = nu4_z_2
    M(28) = nu4_z
    M(29) = nu1_z_3
    M(30) = nu2_z_3
    M(31) = nu3_z_3
    M(32) = nu4_z_3
    M(33) = m5_5
    M(34) = nu5_z_2
    M(35) = nu5_z
    M(36) = nu1_z_2
    M(37) = nu2_z_2
    M(38) = nu3_z_2
    M(39) = nu4_z_2
    M(40) = nu5_z_2
    M(41) = m6_6
    M(42) = nu6_z
    M(43) = nu1_z
    M(44) = nu2_z
    M(45) = nu3_z
    M(46) = nu4_z
    M(47) = nu5_z
    M(48) = nu6_z
    M(49) = 0.006684151967360947_rk
  end subroutine

  ! accelerations that the torques tau give
  ! 629 multiplications, 551 additions, 7 divisions = 1187; 21 unary minus; 12 sine/cosine
  pure subroutine panda_forward_dynamics(q, qd, tau, qdd) &
      bind(c, name="panda_forward_dynamics_f")
    real(rk), intent(in) :: q(7)
    real(rk), intent(in) :: qd(7)
    real(rk), intent(in) :: tau(7)
    real(rk), intent(out) :: qdd(7)
    real(rk) :: c2, s2, c3, s3, c4, s4, c5, s5
    real(rk) :: c6, s6, c7, s7, fu6_x, fu6_z, nu6_x, nu6_z
    real(rk) :: nu6_y, fu5_x, fu5_z, neg_nu5_x, nu5_z, t1, fu4_x, fu4_z
    real(rk) :: nu4_x, t2, nu4_y, nu4_z, t3, fu3_x, neg_fu3_z, nu3_x
    real(rk) :: nu3_y, nu3_z, fu2_x, neg_fu2_z, nu2_x, t4, nu2_z, nu1_z
    real(rk) :: h6_x, t5, t6, t7, t8, k6_xx, k6_xy, k6_xz
    real(rk) :: k6_yz, m6_6, fu5_x_2, fu5_z_2, nu5_x, t9, nu5_z_2, neg_fu4_x
    real(rk) :: t10, fu4_z_2, nu4_x_2, t11, nu4_y_2, neg_nu4_z, fu3_x_2, fu3_z
    real(rk) :: nu3_x_2, nu3_y_2, nu3_z_2, fu2_x_2, fu2_z, nu2_x_2, nu2_z_2, nu1_z_2
    real(rk) :: t12, t13, t14, t15, k5_zz, h5_x, h5_y, k5_xx
    real(rk) :: k5_yy, k5_xy, k5_xz, k5_yz, m5_5, fu4_x_2, fu4_z_3, t16
    real(rk) :: t17, nu4_x_3, t18, nu4_y_3, nu4_z_2, t19, fu3_x_3, neg_fu3_z_2
    real(rk) :: nu3_x_3, nu3_y_3, nu3_z_3, fu2_x_3, fu2_z_2, nu2_x_3, nu2_z_3, nu1_z_3
    real(rk) :: t20, t21, t22, t23, k4_zz, h4_x, h4_y, t24
    real(rk) :: k4_xx, t25, k4_yy, k4_xy, t26, k4_xz, k4_yz, m4_4
    real(rk) :: fu3_x_4, fu3_z_2, nu3_x_4, nu3_z_4, nu3_y_4, fu2_x_4, fu2_z_3, nu2_x_4
    real(rk) :: nu2_z_4, nu1_z_4, t27, t28, t29, t30, k3_zz, h3_x
    real(rk) :: h3_y, t31, k3_xx, k3_yy, k3_xy, k3_xz, k3_yz, m3_3
    real(rk) :: fu2_x_5, fu2_z_4, nu2_x_5, nu2_z_5, nu1_z_5, t32, t33, t34
    real(rk) :: t35, k2_zz, t36, k2_yy, k2_xy, k2_xz, k2_yz, t37
    real(rk) :: m2_2, nu1_z_6, t38, m1_1, t39, w2_x, w2_y, a2_x
    real(rk) :: a2_y, alpha2_x, alpha2_y, ww2_xy, ww2_xx, ww2_yy, ww2_zz, neg_lam2_11
    real(rk) :: neg_lam2_22, neg_lam2_33, a3_z, w3_x, w3_y, t40, t41, a3_x
    real(rk) :: a3_y, alpha3_x, alpha3_y, w3_z, ww3_yz, ww3_zx, ww3_xy, ww3_xx
    real(rk) :: ww3_yy, ww3_zz, neg_lam3_11, lam3_12, lam3_13, lam3_21, neg_lam3_22, lam3_23
    real(rk) :: lam3_31, lam3_32, neg_lam3_33, a4_z, w4_x, w4_y, t42, t43
    real(rk) :: a4_x, neg_a4_y, alpha4_x, alpha4_y, w4_z, ww4_yz, ww4_zx, ww4_xy
    real(rk) :: ww4_xx, ww4_yy, neg_ww4_zz, lam4_11, lam4_12, lam4_13, lam4_21, lam4_22
    real(rk) :: lam4_23, lam4_31, lam4_32, lam4_33, a5_z, w5_x, w5_y, t44
    real(rk) :: t45, a5_x, a5_y, alpha5_x, alpha5_y, w5_z, ww5_yz, ww5_zx
    real(rk) :: ww5_xy, ww5_xx, ww5_yy, ww5_zz, neg_lam5_11, lam5_12, lam5_13, lam5_21
    real(rk) :: neg_lam5_22, lam5_23, lam5_31, lam5_32, neg_lam5_33, w6_x, w6_y, a6_x
    real(rk) :: a6_y, alpha6_x, alpha6_y, w6_z, ww6_yz, ww6_zx, ww6_xy, ww6_xx
    real(rk) :: ww6_yy, ww6_zz, neg_lam6_11, lam6_12, lam6_13, lam6_21, neg_lam6_22, lam6_23
    real(rk) :: lam6_31, lam6_32, neg_lam6_33, a7_z, w7_x, w7_y, t46, t47
    real(rk) :: neg_a7_x, a7_y, alpha7_x, t48, alpha7_y, w7_z, ww7_yz, ww7_zx
    real(rk) :: ww7_xy, ww7_xx, ww7_yy, ww7_zz, neg_lam7_11, lam7_12, lam7_13, lam7_21
    real(rk) :: neg_lam7_22, lam7_23, neg_lam7_31, lam7_32, neg_lam7_33, neg_nc2_x, nc2_y, nc2_z
    real(rk) :: fc3_x, fc3_y, nc3_x, nc3_y, t49, nc3_z, fc4_x, fc4_y
    real(rk) :: fc4_z, nc4_x, nc4_y, t50, neg_nc4_z, fc5_x, fc5_y, fc5_z
    real(rk) :: nc5_x, nc5_y, t51, nc5_z, fc6_x, fc6_y, fc6_z, nc6_x
    real(rk) :: nc6_y, t52, nc6_z, fc7_x, fc7_y, neg_fc7_z, nc7_x, nc7_y
    real(rk) :: t53, nc7_z, f07_x, neg_f07_y, n07_x, n07_y, n6_x, n6_y
    real(rk) :: n6_z, f6_x, f6_y, f6_z, f06_x, f06_y, n06_x, n06_y
    real(rk) :: n5_x, n5_y, n5_z, f5_x, f5_y, f5_z, neg_f05_x, f05_y
    real(rk) :: n05_x, n05_y, n4_x, n4_y, n4_z, f4_x, f4_y, f4_z
    real(rk) :: f04_x, f04_y, n04_x, n04_y, n3_x, n3_y, n3_z, f3_x
    real(rk) :: f3_y, f03_x, f03_y, n03_x, n03_y, neg_n2_x, n2_y, n2_z
    real(rk) :: n02_y, y1, ipivot1, l2_1, l3_1, l4_1, l5_1, l6_1
    real(rk) :: l7_1, pivot2, ipivot2, ld3_2, l3_2, ld4_2, l4_2, ld5_2
    real(rk) :: l5_2, ld6_2, l6_2, ld7_2, l7_2, pivot3, ipivot3, ld4_3
    real(rk) :: l4_3, ld5_3, l5_3, ld6_3, l6_3, ld7_3, l7_3, pivot4
    real(rk) :: ipivot4, ld5_4, l5_4, ld6_4, l6_4, ld7_4, l7_4, pivot5
    real(rk) :: ipivot5, ld6_5, l6_5, ld7_5, l7_5, pivot6, ipivot6, ld7_6
    real(rk) :: l7_6, t54, pivot7, ipivot7, y2, y3, y4, y5
    real(rk) :: y6, t55, y7, qdd7, qdd6, qdd5, qdd4, qdd3
    real(rk) :: t56, qdd2, t57, qdd1

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
    ! link 6: force for a unit acceleration of a joint further out
    fu6_x = -0.002573605371338201_rk*s7 - 0.0020344399586618637_rk*c7
    fu6_z = 0.002573605371338201_rk*c7 - 0.0020344399586618637_rk*s7
    ! link 6: moment for a unit acceleration of a joint further out
    nu6_x = 0.0012555365982729084_rk*s7 - 0.0009653051699191118_rk*c7
    nu6_z = -0.0012555365982729084_rk*c7 - 0.0009653051699191118_rk*s7
    nu6_y = -0.088_rk*fu6_z - 0.006684151967360947_rk
    ! link 5: force for a unit acceleration of a joint further out
    fu5_x = c6*fu6_x
    fu5_z = s6*fu6_x
    ! link 5: moment for a unit acceleration of a joint further out
    neg_nu5_x = s6*nu6_y - c6*nu6_x
    nu5_z = s6*nu6_x + c6*nu6_y
    t1 = -c5
    ! link 4: force for a unit acceleration of a joint further out
    fu4_x = t1*fu5_x - s5*fu6_z
    fu4_z = c5*fu6_z - s5*fu5_x
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_x = c5*neg_nu5_x - s5*nu6_z - 0.384_rk*fu4_z
    t2 = -0.0825_rk*fu4_z
    nu4_y = t2 - nu5_z
    nu4_z = s5*neg_nu5_x + c5*nu6_z + (0.384_rk*fu4_x - 0.0825_rk*fu5_z)
    t3 = -s4
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x = t3*fu5_z - c4*fu4_x
    neg_fu3_z = s4*fu4_x - c4*fu5_z
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_x = s4*nu4_y - c4*nu4_x
    nu3_y = 0.0825_rk*neg_fu3_z - nu4_z
    nu3_z = t2 - (s4*nu4_x + c4*nu4_y)
    ! link 2: force for a unit acceleration of a joint further out
    fu2_x = c3*fu3_x + s3*fu4_z
    neg_fu2_z = c3*fu4_z - s3*fu3_x
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_x = 0.316_rk*neg_fu2_z - (s3*nu3_y - c3*nu3_x)
    t4 = -s3
    nu2_z = 0.316_rk*fu2_x - (t4*nu3_x - c3*nu3_y)
    ! link 1: moment for a unit acceleration of a joint further out
    nu1_z = c2*nu3_z - s2*nu2_x
    ! link 6: first moment of the composite body, about the frame's origin [kg m]
    h6_x = fu6_z + 0.231847552695_rk
    t5 = c7*c7
    t6 = c7*s7
    t7 = 0.002420943778521227_rk*t5 - 0.000782782563368495_rk*t6
    t8 = t7 - 0.004552547872941087_rk - 0.176_rk*fu6_z
    ! link 6: second moment of the composite body [kg m^2]
    k6_xx = 0.021522255370587554_rk - t8
    k6_xy = nu6_x - 0.014748570382675314_rk
    k6_xz = 0.0001037589172186853_rk - (0.002420943778521227_rk*t6 + &
        0.0003913912816842475_rk*(2.0_rk*t5 - 1.0_rk) + 0.088_rk*fu6_x)
    k6_yz = nu6_z - 9.35690973146064e-05_rk
    ! link 6: mass matrix, its row of this joint
    m6_6 = 0.05045667791624746_rk - t8
    ! link 5: force for a unit acceleration of a joint further out
    fu5_x_2 = 0.17380470556899996_rk*c6 - s6*h6_x
    fu5_z_2 = 0.17380470556899996_rk*s6 + c6*h6_x
    ! link 5: moment for a unit acceleration of a joint further out
    nu5_x = s6*k6_yz - c6*k6_xz
    t9 = -s6
    nu5_z_2 = t9*k6_xz - c6*k6_yz
    ! link 4: force for a unit acceleration of a joint further out
    neg_fu4_x = c5*fu5_x_2
    t10 = -s5
    fu4_z_2 = t10*fu5_x_2
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_x_2 = -0.384_rk*fu4_z_2 - (c5*nu5_x + s5*m6_6)
    t11 = -0.0825_rk*fu4_z_2
    nu4_y_2 = t11 - nu5_z_2
    neg_nu4_z = s5*nu5_x - c5*m6_6 + (0.0825_rk*fu5_z_2 + 0.384_rk*neg_fu4_x)
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x_2 = c4*neg_fu4_x - s4*fu5_z_2
    fu3_z = s4*neg_fu4_x + c4*fu5_z_2
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_x_2 = s4*nu4_y_2 - c4*nu4_x_2
    nu3_y_2 = neg_nu4_z - 0.0825_rk*fu3_z
    nu3_z_2 = t11 + (t3*nu4_x_2 - c4*nu4_y_2)
    ! link 2: force for a unit acceleration of a joint further out
    fu2_x_2 = c3*fu3_x_2 + s3*fu4_z_2
    fu2_z = s3*fu3_x_2 - c3*fu4_z_2
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_x_2 = c3*nu3_x_2 - s3*nu3_y_2 - 0.316_rk*fu2_z
    nu2_z_2 = s3*nu3_x_2 + c3*nu3_y_2 + 0.316_rk*fu2_x_2
    ! link 1: moment for a unit acceleration of a joint further out
    nu1_z_2 = c2*nu3_z_2 - s2*nu2_x_2
    t12 = c6*c6
    t13 = t8 + 0.007412167175072353_rk
    t14 = c6*s6
    t15 = t12*t13 + k6_xy*(2.0_rk*t14)
    ! link 5: second moment of the composite body [kg m^2]
    k5_zz = k6_xx + t15
    ! link 5: first moment of the composite body, about the frame's origin [kg m]
    h5_x = fu5_z_2 - 0.014653732538_rk
    h5_y = fu6_x + 0.067870631425_rk
    ! link 5: second moment of the composite body [kg m^2]
    k5_xx = 0.03038557861068662_rk - t15
    k5_yy = t7 + 0.012176791922741105_rk
    k5_xy = nu5_x + 0.00151524447332703_rk
    k5_xz = 0.004600245517563107_rk - (t13*t14 + k6_xy*(1.0_rk - 2.0_rk*t12))
    k5_yz = nu5_z_2 - 0.0021640520520981327_rk
    ! link 5: mass matrix, its row of this joint
    m5_5 = t7 - t15 + 0.04256237053342773_rk
    ! link 4: force for a unit acceleration of a joint further out
    fu4_x_2 = c5*h5_y + s5*h5_x
    fu4_z_3 = s5*h5_y - c5*h5_x
    t16 = -0.384_rk*fu4_z_3
    t17 = s5*k5_yz - c5*k5_xz
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_x_3 = t16 - t17
    t18 = -0.0825_rk*fu4_z_3
    nu4_y_3 = t18 - m5_5
    nu4_z_2 = 0.384_rk*fu4_x_2 - (t10*k5_xz - c5*k5_yz)
    t19 = -c4
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x_3 = t19*fu4_x_2
    neg_fu3_z_2 = s4*fu4_x_2
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_x_3 = s4*nu4_y_3 - c4*nu4_x_3
    nu3_y_3 = 0.0825_rk*neg_fu3_z_2 - nu4_z_2
    nu3_z_3 = t18 + (t3*nu4_x_3 - c4*nu4_y_3)
    ! link 2: force for a unit acceleration of a joint further out
    fu2_x_3 = c3*fu3_x_3 + s3*fu4_z_3
    fu2_z_2 = s3*fu3_x_3 - c3*fu4_z_3
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_x_3 = c3*nu3_x_3 - s3*nu3_y_3 - 0.316_rk*fu2_z_2
    nu2_z_3 = s3*nu3_x_3 + c3*nu3_y_3 + 0.316_rk*fu2_x_3
    ! link 1: moment for a unit acceleration of a joint further out
    nu1_z_3 = c2*nu3_z_3 - s2*nu2_x_3
    t20 = c5*c5
    t21 = t7 + t15 - 0.018208786687945514_rk
    t22 = c5*s5
    t23 = t20*t21 + k5_xy*(2.0_rk*t22)
    ! link 4: second moment of the composite body [kg m^2]
    k4_zz = k5_xx + t23
    ! link 4: first moment of the composite body, about the frame's origin [kg m]
    h4_x = fu4_z_3 + 0.5527802746499999_rk
    h4_y = fu5_x_2 - 2.0125235536029997_rk
    t24 = k5_yy - t23 + 0.165_rk*fu4_z_3
    ! link 4: second moment of the composite body [kg m^2]
    k4_xx = t24 + 0.05102013615681549_rk
    t25 = 0.768_rk*fu5_x_2 - k5_zz
    k4_yy = 0.6972920750309717_rk - t25
    k4_xy = t16 - (t17 - 0.0825_rk*fu5_x_2) - 0.16284087268546082_rk
    t26 = -0.0825_rk*fu4_x_2
    k4_xz = 0.0039053550262761055_rk - (t21*t22 + k5_xy*(1.0_rk - 2.0_rk*t20) - t26)
    k4_yz = nu4_z_2 - 0.00164448757736928_rk
    ! link 4: mass matrix, its row of this joint
    m4_4 = t24 - t25 + 0.7483122111877871_rk
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x_4 = c4*h4_y + s4*h4_x
    fu3_z_2 = s4*h4_y - c4*h4_x
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_x_4 = c4*k4_xz - s4*k4_yz
    nu3_z_4 = s4*k4_xz + c4*k4_yz
    nu3_y_4 = -0.0825_rk*fu3_z_2 - m4_4
    ! link 2: force for a unit acceleration of a joint further out
    fu2_x_4 = c3*fu3_x_4
    fu2_z_3 = s3*fu3_x_4
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_x_4 = -0.316_rk*fu2_z_3 - (s3*nu3_y_4 - c3*nu3_x_4)
    nu2_z_4 = 0.316_rk*fu2_x_4 - (t4*nu3_x_4 - c3*nu3_y_4)
    ! link 1: moment for a unit acceleration of a joint further out
    nu1_z_4 = c2*nu3_z_4 - s2*nu2_x_4
    t27 = c4*s4
    t28 = c4*c4
    t29 = t24 + t25 - 0.6462719388741561_rk
    t30 = k4_xy*(2.0_rk*t27) - t28*t29
    ! link 3: second moment of the composite body [kg m^2]
    k3_zz = k4_xx + t30
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    h3_x = fu3_z_2 + 0.746857959872_rk
    h3_y = fu4_x_2 + 0.028227094877999827_rk
    t31 = t30 - k4_yy - 0.165_rk*fu3_z_2
    ! link 3: second moment of the composite body [kg m^2]
    k3_xx = 0.061602421026527694_rk - t31
    k3_yy = k4_zz + 0.022178148964878252_rk
    k3_xy = 0.0001219124209507298_rk - (t26 - nu3_x_4)
    k3_xz = t29*t27 - k4_xy*(1.0_rk - 2.0_rk*t28) - 0.0825_rk*fu3_x_4 + 0.005487648106562251_rk
    k3_yz = nu3_z_4 + 0.0043772571218395765_rk
    ! link 3: mass matrix, its row of this joint
    m3_3 = 0.08378056999140594_rk - (t31 - k4_zz)
    ! link 2: force for a unit acceleration of a joint further out
    fu2_x_5 = -c3*h3_y - s3*h3_x
    fu2_z_4 = c3*h3_x - s3*h3_y
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_x_5 = -0.316_rk*fu2_z_4 - (c3*k3_xz - s3*k3_yz)
    nu2_z_5 = 0.316_rk*fu2_x_5 - (s3*k3_xz + c3*k3_yz)
    ! link 1: moment for a unit acceleration of a joint further out
    nu1_z_5 = c2*m3_3 - s2*nu2_x_5
    t32 = c3*s3
    t33 = c3*c3
    t34 = 0.039424272061649446_rk - (k4_zz + t31)
    t35 = k3_xy*(2.0_rk*t32) - t33*t34
    ! link 2: second moment of the composite body [kg m^2]
    k2_zz = k3_xx + t35
    t36 = k3_zz - 0.632_rk*fu3_x_4
    k2_yy = t36 + 1.0321620612318807_rk
    k2_xy = nu2_x_5 + 0.003983358883935522_rk
    k2_xz = t34*t32 - k3_xy*(1.0_rk - 2.0_rk*t33) - 0.010261101821008168_rk
    k2_yz = nu2_z_5 - 0.0007689361029464017_rk
    t37 = t35 - k3_yy
    ! link 2: mass matrix, its row of this joint
    m2_2 = 1.0552399437268125_rk - (t37 - t36)
    ! link 1: moment for a unit acceleration of a joint further out
    nu1_z_6 = s2*k2_xz + c2*k2_yz
    t38 = k2_zz + (k2_yy - (c2*c2*(t37 + t36 + 1.009084178736949_rk) + k2_xy*(2.0_rk*(c2*s2))))
    ! link 1: mass matrix, its row of this joint
    m1_1 = t38 + 0.014259565994474374_rk
    t39 = -qd(1)
    ! link 2: angular velocity [rad/s]
    w2_x = t39*s2
    w2_y = t39*c2
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    a2_x = -9.81_rk*s2
    a2_y = -9.81_rk*c2
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
    neg_lam2_22 = ww2_xx + ww2_zz
    neg_lam2_33 = ww2_xx + ww2_yy
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_z = -0.316_rk*neg_lam2_22 - a2_y
    ! link 3: angular velocity [rad/s]
    w3_x = c3*w2_x + qd(2)*s3
    w3_y = qd(2)*c3 - s3*w2_x
    t40 = -0.632_rk*alpha2_x
    t41 = 0.316_rk*ww2_xy - a2_x
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_x = s3*t40 - c3*t41
    a3_y = s3*t41 + c3*t40
    ! link 3: angular acceleration [rad/s^2]
    alpha3_x = c3*alpha2_x + qd(3)*w3_y
    alpha3_y = t4*alpha2_x - qd(3)*w3_x
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
    lam3_12 = alpha2_y + ww3_xy
    lam3_13 = alpha3_y + ww3_zx
    lam3_21 = ww3_xy - alpha2_y
    neg_lam3_22 = ww3_xx + ww3_zz
    lam3_23 = ww3_yz - alpha3_x
    lam3_31 = ww3_zx - alpha3_y
    lam3_32 = alpha3_x + ww3_yz
    neg_lam3_33 = ww3_xx + ww3_yy
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_z = -0.0825_rk*lam3_21 - a3_y
    ! link 4: angular velocity [rad/s]
    w4_x = t19*w3_x - s4*w3_z
    w4_y = s4*w3_x - c4*w3_z
    t42 = 0.0825_rk*neg_lam3_11 - a3_x
    t43 = a3_z + 0.0825_rk*lam3_31
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_x = c4*t42 - s4*t43
    neg_a4_y = s4*t42 + c4*t43
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = s4*alpha2_y - c4*alpha3_x + qd(4)*w4_y
    alpha4_y = s4*alpha3_x + c4*alpha2_y - qd(4)*w4_x
    ! link 4: angular velocity [rad/s]
    w4_z = qd(4) - w3_y
    ! link 4: products of the angular velocity [1/s^2]
    ww4_yz = w4_y*w4_z
    ww4_zx = w4_x*w4_z
    ww4_xy = w4_x*w4_y
    ww4_xx = w4_x*w4_x
    ww4_yy = w4_y*w4_y
    neg_ww4_zz = -w4_z*w4_z
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_11 = neg_ww4_zz - ww4_yy
    lam4_12 = alpha3_y + ww4_xy
    lam4_13 = alpha4_y + ww4_zx
    lam4_21 = ww4_xy - alpha3_y
    lam4_22 = neg_ww4_zz - ww4_xx
    lam4_23 = ww4_yz - alpha4_x
    lam4_31 = ww4_zx - alpha4_y
    lam4_32 = alpha4_x + ww4_yz
    lam4_33 = -ww4_xx - ww4_yy
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_z = neg_a4_y + (0.384_rk*lam4_22 - 0.0825_rk*lam4_21)
    ! link 5: angular velocity [rad/s]
    w5_x = -(c5*w4_x) - s5*w4_z
    w5_y = s5*w4_x - c5*w4_z
    t44 = 0.384_rk*lam4_32 - 0.0825_rk*lam4_31 - a4_z
    t45 = a4_x - (0.384_rk*lam4_12 - 0.0825_rk*lam4_11)
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_x = s5*t44 - c5*t45
    a5_y = s5*t45 + c5*t44
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
    lam5_12 = alpha4_y + ww5_xy
    lam5_13 = alpha5_y + ww5_zx
    lam5_21 = ww5_xy - alpha4_y
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
    alpha6_x = qd(6)*w6_y - (s6*alpha4_y - c6*alpha5_x)
    alpha6_y = t9*alpha5_x - c6*alpha4_y - qd(6)*w6_x
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
    t46 = 0.088_rk*neg_lam6_11 - a6_x
    t47 = a5_y - 0.088_rk*lam6_31
    ! link 7: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a7_x = c7*t46 + s7*t47
    a7_y = s7*t46 - c7*t47
    ! link 7: angular acceleration [rad/s^2]
    alpha7_x = qd(7)*w7_y - (s7*alpha5_y - c7*alpha6_x)
    t48 = -s7
    alpha7_y = t48*alpha6_x - c7*alpha5_y - qd(7)*w7_x
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
    neg_nc2_x = 0.0007689361029464017_rk*(neg_lam2_22 - neg_lam2_33) - &
        2.0643241224637614_rk*alpha2_x + (0.007966717767871044_rk*alpha2_y - &
        0.010261101821008168_rk*ww2_xy)
    nc2_y = 0.04615576498986361_rk*alpha2_y + 0.010261101821008168_rk*(neg_lam2_11 - neg_lam2_33) &
        - (0.0007689361029464017_rk*ww2_xy + 0.007966717767871044_rk*alpha2_x)
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
    t49 = 0.022178148964878252_rk*lam3_12 - 0.061602421026527694_rk*lam3_21 - &
        0.0001219124209507298_rk*(neg_lam3_11 - neg_lam3_22) - (0.005487648106562251_rk*lam3_23 - &
        0.0043772571218395765_rk*lam3_13)
    nc3_z = 0.746857959872_rk*a3_y - 0.028227094877999827_rk*a3_x - t49
    ! link 4: force that moves the link [N]
    fc4_x = 0.5527802746499999_rk*lam4_11 - 2.0125235536029997_rk*lam4_12
    fc4_y = 0.5527802746499999_rk*lam4_21 - 2.0125235536029997_rk*lam4_22
    fc4_z = 0.5527802746499999_rk*lam4_31 - 2.0125235536029997_rk*lam4_32
    ! link 4: moment that turns the link [N m]
    nc4_x = 0.6972920750309717_rk*lam4_32 - 0.00164448757736928_rk*(lam4_33 - lam4_22) - &
        (0.16284087268546082_rk*lam4_31 + 0.0039053550262761055_rk*lam4_21) - &
        2.0125235536029997_rk*a4_z
    nc4_y = -0.5527802746499999_rk*a4_z - (0.05102013615681549_rk*lam4_31 + &
        0.0039053550262761055_rk*(lam4_33 - lam4_11) + (0.00164448757736928_rk*lam4_12 - &
        0.16284087268546082_rk*lam4_32))
    t50 = 0.6972920750309717_rk*lam4_12 - 0.05102013615681549_rk*lam4_21 + &
        0.16284087268546082_rk*(lam4_22 - lam4_11) + (-0.0039053550262761055_rk*lam4_23 - &
        0.00164448757736928_rk*lam4_13)
    neg_nc4_z = t50 + (0.5527802746499999_rk*neg_a4_y - 2.0125235536029997_rk*a4_x)
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
    t51 = 0.001451156065026714_rk*lam5_21 - 0.010045187828321245_rk*lam5_12 + &
        0.00151524447332703_rk*(neg_lam5_11 - neg_lam5_22) + (0.004600245517563107_rk*lam5_23 + &
        0.0021640520520981327_rk*lam5_13)
    nc5_z = t51 - (0.014653732538_rk*a5_y + 0.067870631425_rk*a5_x)
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
    t52 = 0.028934422545659907_rk*lam6_12 - 0.021522255370587554_rk*lam6_21 + &
        0.014748570382675314_rk*(neg_lam6_11 - neg_lam6_22) - (0.0001037589172186853_rk*lam6_23 + &
        9.35690973146064e-05_rk*lam6_13)
    nc6_z = 0.231847552695_rk*a6_y + 0.17380470556899996_rk*a6_x - t52
    ! link 7: force that moves the link [N]
    fc7_x = 0.0020344399586618637_rk*lam7_12 - 0.002573605371338201_rk*neg_lam7_11
    fc7_y = 0.002573605371338201_rk*lam7_21 - 0.0020344399586618637_rk*neg_lam7_22
    neg_fc7_z = 0.002573605371338201_rk*neg_lam7_31 - 0.0020344399586618637_rk*lam7_32
    ! link 7: moment that turns the link [N m]
    nc7_x = 0.0020344399586618637_rk*a7_z - (-0.004552547872941087_rk*lam7_32 - &
        0.0012555365982729084_rk*(neg_lam7_22 - neg_lam7_33) - &
        (0.0003913912816842475_rk*neg_lam7_31 - 0.0009653051699191118_rk*lam7_21))
    nc7_y = 0.00213160409441986_rk*neg_lam7_31 - 0.0009653051699191118_rk*(neg_lam7_11 - &
        neg_lam7_33) + (0.0012555365982729084_rk*lam7_12 + 0.0003913912816842475_rk*lam7_32) - &
        0.002573605371338201_rk*a7_z
    t53 = 0.004552547872941087_rk*lam7_12 - 0.00213160409441986_rk*lam7_21 + &
        0.0003913912816842475_rk*(neg_lam7_11 - neg_lam7_22) - (0.0009653051699191118_rk*lam7_23 - &
        0.0012555365982729084_rk*lam7_13)
    nc7_z = 0.002573605371338201_rk*a7_y + 0.0020344399586618637_rk*neg_a7_x - t53
    ! link 7: force through the joint, along the axes that its turn starts from [N]
    f07_x = c7*fc7_x - s7*fc7_y
    neg_f07_y = t48*fc7_x - c7*fc7_y
    ! link 7: moment through the joint, along the axes that its turn starts from [N m]
    n07_x = c7*nc7_x - s7*nc7_y
    n07_y = s7*nc7_x + c7*nc7_y
    ! link 6: moment through the joint, about the frame's origin [N m]
    n6_x = nc6_x + n07_x
    n6_y = nc6_y + 0.088_rk*neg_f07_y - nc7_z
    n6_z = n07_y + (nc6_z + 0.088_rk*neg_fc7_z)
    ! link 6: force through the joint [N]
    f6_x = fc6_x + f07_x
    f6_y = fc6_y + neg_fc7_z
    f6_z = fc6_z - neg_f07_y
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
    neg_f05_x = c5*f5_x - s5*f5_y
    f05_y = t1*f5_y - s5*f5_x
    ! link 5: moment through the joint, along the axes that its turn starts from [N m]
    n05_x = s5*n5_y - c5*n5_x
    n05_y = t10*n5_x - c5*n5_y
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = n05_x + (nc4_x - 0.384_rk*f05_y)
    n4_y = nc4_y - 0.0825_rk*f05_y - n5_z
    n4_z = n05_y - (neg_nc4_z + (0.0825_rk*f5_z + 0.384_rk*neg_f05_x))
    ! link 4: force through the joint [N]
    f4_x = fc4_x - neg_f05_x
    f4_y = fc4_y - f5_z
    f4_z = fc4_z + f05_y
    ! link 4: force through the joint, along the axes that its turn starts from [N]
    f04_x = s4*f4_y - c4*f4_x
    f04_y = t3*f4_x - c4*f4_y
    ! link 4: moment through the joint, along the axes that its turn starts from [N m]
    n04_x = s4*n4_y - c4*n4_x
    n04_y = t19*n4_y - s4*n4_x
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_x = nc3_x + n04_x
    n3_y = nc3_y - 0.0825_rk*f04_y - n4_z
    n3_z = n04_y - (0.0825_rk*f4_z - nc3_z)
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
    neg_n2_x = neg_nc2_x + 0.316_rk*f03_y - n03_x
    n2_y = nc2_y - n3_z
    n2_z = n03_y - (-0.316_rk*f03_x - nc2_z)
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_y = s2*neg_n2_x - c2*n2_y
    ! link 1: forward substitution
    y1 = tau(1) - n02_y
    ! factorisation M = L D L^T
    ipivot1 = 1.0_rk / m1_1
    l2_1 = nu1_z_6*ipivot1
    l3_1 = nu1_z_5*ipivot1
    l4_1 = nu1_z_4*ipivot1
    l5_1 = nu1_z_3*ipivot1
    l6_1 = nu1_z_2*ipivot1
    l7_1 = nu1_z*ipivot1
    pivot2 = m2_2 - nu1_z_6*l2_1
    ipivot2 = 1.0_rk / pivot2
    ld3_2 = nu2_z_5 - nu1_z_6*l3_1
    l3_2 = ipivot2*ld3_2
    ld4_2 = nu2_z_4 - nu1_z_6*l4_1
    l4_2 = ipivot2*ld4_2
    ld5_2 = nu2_z_3 - nu1_z_6*l5_1
    l5_2 = ipivot2*ld5_2
    ld6_2 = nu2_z_2 - nu1_z_6*l6_1
    l6_2 = ipivot2*ld6_2
    ld7_2 = nu2_z - nu1_z_6*l7_1
    l7_2 = ipivot2*ld7_2
    pivot3 = m3_3 - nu1_z_5*l3_1 - ld3_2*l3_2
    ipivot3 = 1.0_rk / pivot3
    ld4_3 = nu3_z_4 - nu1_z_5*l4_1 - ld3_2*l4_2
    l4_3 = ipivot3*ld4_3
    ld5_3 = nu3_z_3 - nu1_z_5*l5_1 - ld3_2*l5_2
    l5_3 = ipivot3*ld5_3
    ld6_3 = nu3_z_2 - nu1_z_5*l6_1 - ld3_2*l6_2
    l6_3 = ipivot3*ld6_3
    ld7_3 = nu3_z - nu1_z_5*l7_1 - ld3_2*l7_2
    l7_3 = ipivot3*ld7_3
    pivot4 = m4_4 - nu1_z_4*l4_1 - ld4_2*l4_2 - ld4_3*l4_3
    ipivot4 = 1.0_rk / pivot4
    ld5_4 = -(nu1_z_4*l5_1 - nu4_z_2 + ld4_2*l5_2) - ld4_3*l5_3
    l5_4 = ipivot4*ld5_4
    ld6_4 = -(neg_nu4_z + nu1_z_4*l6_1 + ld4_2*l6_2) - ld4_3*l6_3
    l6_4 = ipivot4*ld6_4
    ld7_4 = nu4_z - nu1_z_4*l7_1 - ld4_2*l7_2 - ld4_3*l7_3
    l7_4 = ipivot4*ld7_4
    pivot5 = m5_5 - nu1_z_3*l5_1 - ld5_2*l5_2 - ld5_3*l5_3 - ld5_4*l5_4
    ipivot5 = 1.0_rk / pivot5
    ld6_5 = nu5_z_2 - nu1_z_3*l6_1 - ld5_2*l6_2 - ld5_3*l6_3 - ld5_4*l6_4
    l6_5 = ipivot5*ld6_5
    ld7_5 = -ld5_4*l7_4 - (nu1_z_3*l7_1 - nu5_z + ld5_2*l7_2 + ld5_3*l7_3)
    l7_5 = ipivot5*ld7_5
    pivot6 = -(ld6_2*l6_2 - (m6_6 - nu1_z_2*l6_1) + ld6_3*l6_3 + ld6_4*l6_4) - ld6_5*l6_5
    ipivot6 = 1.0_rk / pivot6
    ld7_6 = -ld6_5*l7_5 - (nu1_z_2*l7_1 - nu6_z + ld6_2*l7_2 + ld6_3*l7_3 + ld6_4*l7_4)
    l7_6 = ipivot6*ld7_6
    t54 = 0.006684151967360947_rk - nu1_z*l7_1 - ld7_2*l7_2 - ld7_3*l7_3 - ld7_4*l7_4 - ld7_5*l7_5
    pivot7 = t54 - ld7_6*l7_6
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
    t55 = tau(7) - nc7_z - y1*l7_1 - l7_2*y2 - l7_3*y3 - l7_4*y4 - l7_5*y5
    ! link 7: forward substitution
    y7 = t55 - l7_6*y6
    ! link 7: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd7 = ipivot7*y7
    ! link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd6 = ipivot6*y6 - l7_6*qdd7
    ! link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd5 = ipivot5*y5 - l6_5*qdd6 - l7_5*qdd7
    ! link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd4 = ipivot4*y4 - l5_4*qdd5 - l6_4*qdd6 - l7_4*qdd7
    ! link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd3 = -(l4_3*qdd4 - ipivot3*y3 + l5_3*qdd5 + l6_3*qdd6) - l7_3*qdd7
    t56 = -(l3_2*qdd3 - ipivot2*y2 + l4_2*qdd4 + l5_2*qdd5 + l6_2*qdd6)
    ! link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd2 = t56 - l7_2*qdd7
    t57 = l2_1*qdd2 - y1*ipivot1 + l3_1*qdd3 + l4_1*qdd4 + l5_1*qdd5 + l6_1*qdd6
    ! link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd1 = -l7_1*qdd7 - t57
    qdd(1) = qdd1
    qdd(2) = qdd2
    qdd(3) = qdd3
    qdd(4) = qdd4
    qdd(5) = qdd5
    qdd(6) = qdd6
    qdd(7) = qdd7
  end subroutine
end module
