! stanford_full: Stanford geometry, random full inertias
! Numbers: geometry of Table 2.2 (corrected); inertial parameters drawn at random
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
!   inverse_dynamics: 223 multiplications, 208 additions = 431; 6 unary minus; 8 sine/cosine
!   gravity: 48 multiplications, 27 additions = 75; 1 unary minus; 8 sine/cosine
!   bias: 211 multiplications, 186 additions = 397; 7 unary minus; 8 sine/cosine
!   mass_matrix: 105 multiplications, 98 additions = 203; 9 unary minus; 8 sine/cosine
!   forward_dynamics: 402 multiplications, 354 additions, 6 divisions = 762; 20 unary minus; 8
!       sine/cosine
module stanford_full_dynamics
  use, intrinsic :: iso_c_binding, only: rk => c_double
  implicit none
  private

  public :: stanford_full_inverse_dynamics
  public :: stanford_full_gravity
  public :: stanford_full_bias
  public :: stanford_full_mass_matrix
  public :: stanford_full_forward_dynamics

contains

  ! torques that give the accelerations qdd
  ! 223 multiplications, 208 additions = 431; 6 unary minus; 8 sine/cosine
  pure subroutine stanford_full_inverse_dynamics(q, qd, qdd, tau) &
      bind(c, name="stanford_full_inverse_dynamics_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(in) :: qdd(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: c2, s2, c4, s4, c5, s5, c6, s6, ww1_zz, a2_z, t1, w2_x, w2_y, t2, a2_x, a2_y
    real(rk) :: ww2_yz, ww2_zx, alpha2_x, alpha2_y, ww2_xy, neg_ww2_xx, ww2_yy, ww2_zz, neg_lam2_11
    real(rk) :: lam2_12, lam2_13, lam2_21, lam2_22, lam2_23, neg_lam2_31, lam2_32, lam2_33, t3
    real(rk) :: a3_x, a3_y, a3_z, w4_x, w4_y, a4_x, a4_y, alpha4_x, alpha4_y, alpha4_z, w4_z
    real(rk) :: ww4_yz, ww4_zx, ww4_xy, ww4_xx, ww4_yy, ww4_zz, neg_lam4_11, lam4_12, lam4_13
    real(rk) :: lam4_21, neg_lam4_22, lam4_23, lam4_31, lam4_32, neg_lam4_33, w5_x, t4, w5_y, a5_x
    real(rk) :: a5_y, alpha5_x, alpha5_y, alpha5_z, w5_z, ww5_yz, ww5_zx, ww5_xy, ww5_xx, ww5_yy
    real(rk) :: ww5_zz, neg_lam5_11, lam5_12, lam5_13, lam5_21, neg_lam5_22, lam5_23, neg_lam5_31
    real(rk) :: lam5_32, neg_lam5_33, w6_x, w6_y, a6_x, a6_y, alpha6_x, alpha6_y, alpha6_z, w6_z
    real(rk) :: ww6_yz, ww6_zx, ww6_xy, ww6_xx, ww6_yy, ww6_zz, neg_lam6_11, lam6_12, lam6_13
    real(rk) :: lam6_21, neg_lam6_22, lam6_23, lam6_31, lam6_32, neg_lam6_33, nc1_z, fc2_x, fc2_y
    real(rk) :: nc2_x, nc2_y, t5, nc2_z, fc3_x, fc3_y, fc3_z, nc3_x, nc3_y, nc3_z, fc4_x, fc4_y
    real(rk) :: fc4_z, nc4_x, nc4_y, t6, nc4_z, fc5_x, fc5_y, fc5_z, neg_nc5_x, nc5_y, t7, nc5_z
    real(rk) :: fc6_x, fc6_y, fc6_z, nc6_x, nc6_y, t8, nc6_z, f06_x, f06_y, n06_x, n06_y, n5_x
    real(rk) :: n5_y, n5_z, f5_x, f5_y, f5_z, f05_x, f05_y, n05_x, n05_y, n4_x, n4_y, n4_z, f4_x
    real(rk) :: f4_y, f4_z, f04_x, f04_y, n04_x, n04_y, n3_x, n3_y, n3_z, f3_x, f3_y, f3_z, n2_x
    real(rk) :: n2_y, n2_z, f2_x, f2_y, f02_x, n02_y, n1_z

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
    neg_ww2_xx = -w2_x*w2_x
    ww2_yy = w2_y*w2_y
    ww2_zz = qd(2)*qd(2)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_11 = ww2_yy + ww2_zz
    lam2_12 = ww2_xy - qdd(2)
    lam2_13 = ww2_zx + alpha2_y
    lam2_21 = qdd(2) + ww2_xy
    lam2_22 = neg_ww2_xx - ww2_zz
    lam2_23 = ww2_yz - alpha2_x
    neg_lam2_31 = alpha2_y - ww2_zx
    lam2_32 = ww2_yz + alpha2_x
    lam2_33 = neg_ww2_xx - ww2_yy
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
    t4 = -c5
    w5_y = t4*w4_z - s5*w4_x
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_x = c5*a4_x - s5*a3_z
    a5_y = t4*a3_z - s5*a4_x
    ! link 5: angular acceleration [rad/s^2]
    alpha5_x = qd(5)*w5_y - (s5*alpha4_z - c5*alpha4_x)
    alpha5_y = t4*alpha4_z - s5*alpha4_x - qd(5)*w5_x
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
    ! link 6: angular velocity [rad/s]
    w6_x = c6*w5_x + s6*w5_z
    w6_y = c6*w5_z - s6*w5_x
    ! link 6: acceleration of the frame's origin, gravity taken off [m/s^2]
    a6_x = c6*a5_x + s6*a4_y
    a6_y = c6*a4_y - s6*a5_x
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
    ! link 1: moment that turns the link [N m]
    nc1_z = 1.1129758995253813_rk*qdd(1)
    ! link 2: force that moves the link [N]
    fc2_x = -0.14889539863184567_rk*neg_lam2_11 - 0.5558718199714463_rk*lam2_12
    fc2_y = 0.14889539863184567_rk*lam2_21 - 0.5558718199714463_rk*lam2_22
    ! link 2: moment that turns the link [N m]
    nc2_x = 0.0847148653636484_rk*ww1_zz - (0.06807816021551473_rk*(lam2_33 - lam2_22) - &
        0.6226618668666462_rk*lam2_32 + (0.04911220265093226_rk*neg_lam2_31 + &
        0.0511982033036484_rk*lam2_21))
    nc2_y = 0.124038775446629_rk*neg_lam2_31 - 0.0511982033036484_rk*(neg_lam2_11 + lam2_33) + &
        (-0.06807816021551473_rk*lam2_12 - 0.04911220265093226_rk*lam2_32) + &
        0.02269165875149328_rk*ww1_zz
    t5 = 0.124038775446629_rk*lam2_21 - 0.6226618668666462_rk*lam2_12 + &
        0.04911220265093226_rk*(neg_lam2_11 + lam2_22) - (-0.0511982033036484_rk*lam2_23 - &
        0.06807816021551473_rk*lam2_13)
    nc2_z = t5 + (0.14889539863184567_rk*a2_y + 0.5558718199714463_rk*a2_x)
    ! link 3: force that moves the link [N]
    fc3_x = 19.732838668844984_rk*a3_x - (0.22200183325724177_rk*neg_lam2_11 - &
        0.4516316755890639_rk*lam2_13 + 0.012168751997232599_rk*lam2_12)
    fc3_y = 19.732838668844984_rk*a3_y - (0.22200183325724177_rk*neg_lam2_31 - &
        0.4516316755890639_rk*lam2_33 + 0.012168751997232599_rk*lam2_32)
    fc3_z = 19.732838668844984_rk*a3_z - (0.22200183325724177_rk*lam2_21 + &
        0.4516316755890639_rk*lam2_23 - 0.012168751997232599_rk*lam2_22)
    ! link 3: moment that turns the link [N m]
    nc3_x = 0.4516316755890639_rk*a3_z - 0.012168751997232599_rk*a3_y
    nc3_y = 0.012168751997232599_rk*a3_x - 0.22200183325724177_rk*a3_z
    nc3_z = 0.22200183325724177_rk*a3_y - 0.4516316755890639_rk*a3_x
    ! link 4: force that moves the link [N]
    fc4_x = 0.28054187970758354_rk*lam4_12 - 0.9022885982543313_rk*neg_lam4_11
    fc4_y = 0.9022885982543313_rk*lam4_21 - 0.28054187970758354_rk*neg_lam4_22
    fc4_z = 0.9022885982543313_rk*lam4_31 + 0.28054187970758354_rk*lam4_32
    ! link 4: moment that turns the link [N m]
    nc4_x = 0.28054187970758354_rk*a3_z - (0.23523950726161555_rk*(neg_lam4_22 - neg_lam4_33) - &
        1.1561689763413345_rk*lam4_32 - (0.002655628796226608_rk*lam4_21 - &
        0.06784076259315977_rk*lam4_31))
    nc4_y = 0.002655628796226608_rk*(neg_lam4_11 - neg_lam4_33) - 0.3448462092987837_rk*lam4_31 + &
        (0.06784076259315977_rk*lam4_32 - 0.23523950726161555_rk*lam4_12) - &
        0.9022885982543313_rk*a3_z
    t6 = 0.3448462092987837_rk*lam4_21 - 1.1561689763413345_rk*lam4_12 - &
        0.06784076259315977_rk*(neg_lam4_11 - neg_lam4_22) - (0.002655628796226608_rk*lam4_23 - &
        0.23523950726161555_rk*lam4_13)
    nc4_z = t6 + (0.9022885982543313_rk*a4_y - 0.28054187970758354_rk*a4_x)
    ! link 5: force that moves the link [N]
    fc5_x = 0.5911078910549018_rk*neg_lam5_11 - 0.6468331423588011_rk*lam5_12
    fc5_y = 0.6468331423588011_rk*neg_lam5_22 - 0.5911078910549018_rk*lam5_21
    fc5_z = 0.5911078910549018_rk*neg_lam5_31 - 0.6468331423588011_rk*lam5_32
    ! link 5: moment that turns the link [N m]
    neg_nc5_x = 0.23560176217086468_rk*(neg_lam5_22 - neg_lam5_33) - &
        0.17535491873574263_rk*lam5_32 + (0.060693211657558095_rk*neg_lam5_31 - &
        0.13660343902034475_rk*lam5_21) + 0.6468331423588011_rk*a4_y
    nc5_y = 0.20245111268601115_rk*neg_lam5_31 + 0.13660343902034475_rk*(neg_lam5_11 - &
        neg_lam5_33) + (-0.23560176217086468_rk*lam5_12 - 0.060693211657558095_rk*lam5_32) + &
        0.5911078910549018_rk*a4_y
    t7 = 0.20245111268601115_rk*lam5_21 - 0.17535491873574263_rk*lam5_12 - &
        0.060693211657558095_rk*(neg_lam5_22 - neg_lam5_11) - (0.13660343902034475_rk*lam5_23 - &
        0.23560176217086468_rk*lam5_13)
    nc5_z = t7 - (0.5911078910549018_rk*a5_y - 0.6468331423588011_rk*a5_x)
    ! link 6: force that moves the link [N]
    fc6_x = -1.193403445777575_rk*neg_lam6_11 - 1.2174687787169953_rk*lam6_12
    fc6_y = 1.193403445777575_rk*lam6_21 + 1.2174687787169953_rk*neg_lam6_22
    fc6_z = 1.193403445777575_rk*lam6_31 - 1.2174687787169953_rk*lam6_32
    ! link 6: moment that turns the link [N m]
    nc6_x = 1.2174687787169953_rk*a5_y - (-0.35115649005241384_rk*lam6_32 - &
        0.0625396920897071_rk*(neg_lam6_22 - neg_lam6_33) - (0.06483323523282834_rk*lam6_21 - &
        0.31745868108016423_rk*lam6_31))
    nc6_y = 0.06483323523282834_rk*(neg_lam6_11 - neg_lam6_33) - 0.3409906449060338_rk*lam6_31 - &
        (-0.0625396920897071_rk*lam6_12 - 0.31745868108016423_rk*lam6_32) + &
        1.193403445777575_rk*a5_y
    t8 = 0.3409906449060338_rk*lam6_21 - 0.35115649005241384_rk*lam6_12 - &
        0.31745868108016423_rk*(neg_lam6_11 - neg_lam6_22) - (0.06483323523282834_rk*lam6_23 + &
        0.0625396920897071_rk*lam6_13)
    nc6_z = t8 + (1.193403445777575_rk*a6_y + 1.2174687787169953_rk*a6_x)
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
    n3_x = nc3_x + n04_x
    n3_y = nc3_y + n04_y
    n3_z = nc3_z + n4_z
    ! link 3: force through the joint [N]
    f3_x = fc3_x + f04_x
    f3_y = fc3_y + f04_y
    f3_z = fc3_z + f4_z
    ! link 2: moment through the joint, about the frame's origin [N m]
    n2_x = n3_x + (nc2_x - q(3)*f3_y)
    n2_y = nc2_y - n3_z
    n2_z = n3_y + (nc2_z + q(3)*f3_x)
    ! link 2: force through the joint [N]
    f2_x = fc2_x + f3_x
    f2_y = fc2_y - f3_z
    ! link 2: force through the joint, along the axes that its turn starts from [N]
    f02_x = c2*f2_x - s2*f2_y
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_y = s2*n2_x + c2*n2_y
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = nc1_z - 0.1524_rk*f02_x - n02_y
    tau(1) = n1_z
    tau(2) = n2_z
    tau(3) = f3_z
    tau(4) = n4_z
    tau(5) = n5_z
    tau(6) = nc6_z
  end subroutine

  ! torques that hold the arm at rest
  ! 48 multiplications, 27 additions = 75; 1 unary minus; 8 sine/cosine
  pure subroutine stanford_full_gravity(q, tau) &
      bind(c, name="stanford_full_gravity_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: c2, s2, c4, s4, c5, s5, c6, s6, neg_a2_x, a2_y, a4_x, a4_y, a5_x, a5_y, a6_x, a6_y
    real(rk) :: neg_fc3_x, fc3_z, nc3_x, nc3_z, nc4_x, neg_nc4_y, nc4_z, neg_nc5_x, nc5_y, nc5_z
    real(rk) :: nc6_x, nc6_y, nc6_z, n06_x, n06_y, n5_x, n5_y, n5_z, n05_x, n05_y, n4_x, n4_y, n4_z
    real(rk) :: n04_x, n3_x, n3_z, n2_z, neg_f02_x, n02_y, n1_z

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    c4 = cos(q(4))
    s4 = sin(q(4))
    c5 = cos(q(5))
    s5 = sin(q(5))
    c6 = cos(q(6))
    s6 = sin(q(6))
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a2_x = 9.8_rk*s2
    a2_y = -9.8_rk*c2
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_x = -c4*neg_a2_x
    a4_y = s4*neg_a2_x
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_x = c5*a4_x + s5*a2_y
    a5_y = c5*a2_y - s5*a4_x
    ! link 6: acceleration of the frame's origin, gravity taken off [m/s^2]
    a6_x = c6*a5_x + s6*a4_y
    a6_y = c6*a4_y - s6*a5_x
    ! link 3: force that moves the link [N]
    neg_fc3_x = 193.38181895468085_rk*s2
    fc3_z = 193.38181895468085_rk*c2
    ! link 3: moment that turns the link [N m]
    nc3_x = 4.425990420772826_rk*c2
    nc3_z = 4.425990420772826_rk*s2
    ! link 4: moment that turns the link [N m]
    nc4_x = 2.749310421134319_rk*c2
    neg_nc4_y = 8.842428262892447_rk*c2
    nc4_z = 0.9022885982543313_rk*a4_y - 0.28054187970758354_rk*a4_x
    ! link 5: moment that turns the link [N m]
    neg_nc5_x = 0.6468331423588011_rk*a4_y
    nc5_y = 0.5911078910549018_rk*a4_y
    nc5_z = 0.6468331423588011_rk*a5_x - 0.5911078910549018_rk*a5_y
    ! link 6: moment that turns the link [N m]
    nc6_x = 1.2174687787169953_rk*a5_y
    nc6_y = 1.193403445777575_rk*a5_y
    nc6_z = 1.193403445777575_rk*a6_y + 1.2174687787169953_rk*a6_x
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    n06_x = c6*nc6_x - s6*nc6_y
    n06_y = s6*nc6_x + c6*nc6_y
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_x = n06_x - neg_nc5_x
    n5_y = nc5_y - nc6_z
    n5_z = nc5_z + n06_y
    ! link 5: moment through the joint, along the axes that its turn starts from [N m]
    n05_x = c5*n5_x - s5*n5_y
    n05_y = s5*n5_x + c5*n5_y
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = nc4_x + n05_x
    n4_y = n5_z - neg_nc4_y
    n4_z = nc4_z - n05_y
    ! link 4: moment through the joint, along the axes that its turn starts from [N m]
    n04_x = c4*n4_x - s4*n4_y
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_x = nc3_x + n04_x
    n3_z = nc3_z + n4_z
    ! link 2: moment through the joint, about the frame's origin [N m]
    n2_z = -3.634792872513057_rk*c2 - (5.566797605293052_rk*s2 - (s4*n4_x - (q(3)*neg_fc3_x - &
        c4*n4_y)))
    ! link 2: force through the joint, along the axes that its turn starts from [N]
    neg_f02_x = c2*neg_fc3_x - s2*fc3_z
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_y = s2*n3_x - c2*n3_z
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = 0.1524_rk*neg_f02_x - n02_y
    tau(1) = n1_z
    tau(2) = n2_z
    tau(3) = fc3_z
    tau(4) = n4_z
    tau(5) = n5_z
    tau(6) = nc6_z
  end subroutine

  ! torques at zero acceleration: Coriolis, centrifugal, gravity, friction
  ! 211 multiplications, 186 additions = 397; 7 unary minus; 8 sine/cosine
  pure subroutine stanford_full_bias(q, qd, tau) &
      bind(c, name="stanford_full_bias_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: c2, s2, c4, s4, c5, s5, c6, s6, ww1_zz, a2_z, t1, w2_x, w2_y, neg_a2_x, neg_a2_y
    real(rk) :: alpha2_x, alpha2_y, ww2_xy, neg_ww2_xx, ww2_yy, ww2_zz, neg_lam2_11, lam2_22
    real(rk) :: lam2_32, lam2_33, a3_z, t2, a3_x, a3_y, w4_x, w4_y, a4_x, a4_y, alpha4_x, alpha4_y
    real(rk) :: w4_z, ww4_yz, ww4_zx, ww4_xy, ww4_xx, ww4_yy, ww4_zz, neg_lam4_11, lam4_12, lam4_13
    real(rk) :: lam4_21, neg_lam4_22, lam4_23, lam4_31, lam4_32, neg_lam4_33, w5_x, t3, w5_y, a5_x
    real(rk) :: a5_y, alpha5_x, alpha5_y, w5_z, ww5_yz, ww5_zx, ww5_xy, ww5_xx, ww5_yy, ww5_zz
    real(rk) :: neg_lam5_11, lam5_12, lam5_13, lam5_21, neg_lam5_22, lam5_23, neg_lam5_31, lam5_32
    real(rk) :: neg_lam5_33, w6_x, w6_y, a6_x, a6_y, alpha6_x, alpha6_y, w6_z, ww6_yz, ww6_zx
    real(rk) :: ww6_xy, ww6_xx, ww6_yy, ww6_zz, neg_lam6_11, lam6_12, lam6_13, lam6_21, neg_lam6_22
    real(rk) :: lam6_23, lam6_31, lam6_32, neg_lam6_33, fc2_x, fc2_y, nc2_x, nc2_y, neg_nc2_z
    real(rk) :: fc3_x, fc3_y, fc3_z, nc3_x, nc3_y, nc3_z, fc4_x, fc4_y, fc4_z, nc4_x, nc4_y, t4
    real(rk) :: nc4_z, fc5_x, fc5_y, fc5_z, neg_nc5_x, nc5_y, t5, nc5_z, fc6_x, fc6_y, fc6_z, nc6_x
    real(rk) :: nc6_y, t6, nc6_z, f06_x, f06_y, n06_x, n06_y, n5_x, n5_y, n5_z, f5_x, f5_y, f5_z
    real(rk) :: f05_x, f05_y, n05_x, n05_y, n4_x, n4_y, n4_z, f4_x, f4_y, f4_z, f04_x, f04_y, n04_x
    real(rk) :: n04_y, n3_x, n3_y, n3_z, f3_x, f3_y, f3_z, n2_x, n2_y, n2_z, f2_x, f2_y, f02_x
    real(rk) :: n02_y, n1_z

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
    alpha2_y = -qd(2)*w2_x
    ! link 2: products of the angular velocity [1/s^2]
    ww2_xy = w2_x*w2_y
    neg_ww2_xx = -w2_x*w2_x
    ww2_yy = w2_y*w2_y
    ww2_zz = qd(2)*qd(2)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_11 = ww2_yy + ww2_zz
    lam2_22 = neg_ww2_xx - ww2_zz
    lam2_32 = 2.0_rk*alpha2_x
    lam2_33 = neg_ww2_xx - ww2_yy
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
    neg_lam4_11 = ww4_yy + ww4_zz
    lam4_12 = alpha2_y + ww4_xy
    lam4_13 = alpha4_y + ww4_zx
    lam4_21 = ww4_xy - alpha2_y
    neg_lam4_22 = ww4_xx + ww4_zz
    lam4_23 = ww4_yz - alpha4_x
    lam4_31 = ww4_zx - alpha4_y
    lam4_32 = alpha4_x + ww4_yz
    neg_lam4_33 = ww4_xx + ww4_yy
    ! link 5: angular velocity [rad/s]
    w5_x = c5*w4_x - s5*w4_z
    t3 = -c5
    w5_y = t3*w4_z - s5*w4_x
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_x = c5*a4_x - s5*a3_z
    a5_y = t3*a3_z - s5*a4_x
    ! link 5: angular acceleration [rad/s^2]
    alpha5_x = qd(5)*w5_y - (-s5*alpha2_y - c5*alpha4_x)
    alpha5_y = c5*alpha2_y - s5*alpha4_x - qd(5)*w5_x
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
    ! link 6: angular velocity [rad/s]
    w6_x = c6*w5_x + s6*w5_z
    w6_y = c6*w5_z - s6*w5_x
    ! link 6: acceleration of the frame's origin, gravity taken off [m/s^2]
    a6_x = c6*a5_x + s6*a4_y
    a6_y = c6*a4_y - s6*a5_x
    ! link 6: angular acceleration [rad/s^2]
    alpha6_x = qd(6)*w6_y - (-s6*alpha4_y - c6*alpha5_x)
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
    fc2_x = -0.14889539863184567_rk*neg_lam2_11 - 0.5558718199714463_rk*ww2_xy
    fc2_y = 0.14889539863184567_rk*ww2_xy - 0.5558718199714463_rk*lam2_22
    ! link 2: moment that turns the link [N m]
    nc2_x = 0.0847148653636484_rk*ww1_zz - (0.06807816021551473_rk*(lam2_33 - lam2_22) - &
        1.2453237337332923_rk*alpha2_x + (0.09822440530186452_rk*alpha2_y + &
        0.0511982033036484_rk*ww2_xy))
    nc2_y = 0.248077550893258_rk*alpha2_y - 0.0511982033036484_rk*(neg_lam2_11 + lam2_33) - &
        (0.06807816021551473_rk*ww2_xy + 0.09822440530186452_rk*alpha2_x) + &
        0.02269165875149328_rk*ww1_zz
    neg_nc2_z = 0.49862309142001715_rk*ww2_xy - 0.04911220265093226_rk*(neg_lam2_11 + lam2_22) + &
        (1.4591749065920876_rk*c2 + 5.4475438357201735_rk*s2)
    ! link 3: force that moves the link [N]
    fc3_x = 19.732838668844984_rk*a3_x - (0.22200183325724177_rk*neg_lam2_11 + &
        0.012168751997232599_rk*ww2_xy)
    fc3_y = 19.732838668844984_rk*a3_y - (0.44400366651448353_rk*alpha2_y - &
        0.4516316755890639_rk*lam2_33 + 0.024337503994465198_rk*alpha2_x)
    fc3_z = 19.732838668844984_rk*a3_z - (0.22200183325724177_rk*ww2_xy - &
        0.012168751997232599_rk*lam2_22)
    ! link 3: moment that turns the link [N m]
    nc3_x = 0.4516316755890639_rk*a3_z - 0.012168751997232599_rk*a3_y
    nc3_y = 0.012168751997232599_rk*a3_x - 0.22200183325724177_rk*a3_z
    nc3_z = 0.22200183325724177_rk*a3_y - 0.4516316755890639_rk*a3_x
    ! link 4: force that moves the link [N]
    fc4_x = 0.28054187970758354_rk*lam4_12 - 0.9022885982543313_rk*neg_lam4_11
    fc4_y = 0.9022885982543313_rk*lam4_21 - 0.28054187970758354_rk*neg_lam4_22
    fc4_z = 0.9022885982543313_rk*lam4_31 + 0.28054187970758354_rk*lam4_32
    ! link 4: moment that turns the link [N m]
    nc4_x = 0.28054187970758354_rk*a3_z - (0.23523950726161555_rk*(neg_lam4_22 - neg_lam4_33) - &
        1.1561689763413345_rk*lam4_32 - (0.002655628796226608_rk*lam4_21 - &
        0.06784076259315977_rk*lam4_31))
    nc4_y = 0.002655628796226608_rk*(neg_lam4_11 - neg_lam4_33) - 0.3448462092987837_rk*lam4_31 - &
        (0.23523950726161555_rk*lam4_12 - 0.06784076259315977_rk*lam4_32) - &
        0.9022885982543313_rk*a3_z
    t4 = 1.1561689763413345_rk*lam4_12 - 0.3448462092987837_rk*lam4_21 + &
        0.06784076259315977_rk*(neg_lam4_11 - neg_lam4_22) + (0.002655628796226608_rk*lam4_23 - &
        0.23523950726161555_rk*lam4_13)
    nc4_z = 0.9022885982543313_rk*a4_y - 0.28054187970758354_rk*a4_x - t4
    ! link 5: force that moves the link [N]
    fc5_x = 0.5911078910549018_rk*neg_lam5_11 - 0.6468331423588011_rk*lam5_12
    fc5_y = 0.6468331423588011_rk*neg_lam5_22 - 0.5911078910549018_rk*lam5_21
    fc5_z = 0.5911078910549018_rk*neg_lam5_31 - 0.6468331423588011_rk*lam5_32
    ! link 5: moment that turns the link [N m]
    neg_nc5_x = 0.23560176217086468_rk*(neg_lam5_22 - neg_lam5_33) - &
        0.17535491873574263_rk*lam5_32 + (0.060693211657558095_rk*neg_lam5_31 - &
        0.13660343902034475_rk*lam5_21) + 0.6468331423588011_rk*a4_y
    nc5_y = 0.20245111268601115_rk*neg_lam5_31 + 0.13660343902034475_rk*(neg_lam5_11 - &
        neg_lam5_33) + (-0.23560176217086468_rk*lam5_12 - 0.060693211657558095_rk*lam5_32) + &
        0.5911078910549018_rk*a4_y
    t5 = 0.20245111268601115_rk*lam5_21 - 0.17535491873574263_rk*lam5_12 - &
        0.060693211657558095_rk*(neg_lam5_22 - neg_lam5_11) - (0.13660343902034475_rk*lam5_23 - &
        0.23560176217086468_rk*lam5_13)
    nc5_z = t5 - (0.5911078910549018_rk*a5_y - 0.6468331423588011_rk*a5_x)
    ! link 6: force that moves the link [N]
    fc6_x = -1.193403445777575_rk*neg_lam6_11 - 1.2174687787169953_rk*lam6_12
    fc6_y = 1.193403445777575_rk*lam6_21 + 1.2174687787169953_rk*neg_lam6_22
    fc6_z = 1.193403445777575_rk*lam6_31 - 1.2174687787169953_rk*lam6_32
    ! link 6: moment that turns the link [N m]
    nc6_x = 1.2174687787169953_rk*a5_y - (-0.35115649005241384_rk*lam6_32 - &
        0.0625396920897071_rk*(neg_lam6_22 - neg_lam6_33) - (0.06483323523282834_rk*lam6_21 - &
        0.31745868108016423_rk*lam6_31))
    nc6_y = 0.06483323523282834_rk*(neg_lam6_11 - neg_lam6_33) - 0.3409906449060338_rk*lam6_31 + &
        (0.0625396920897071_rk*lam6_12 + 0.31745868108016423_rk*lam6_32) + &
        1.193403445777575_rk*a5_y
    t6 = 0.35115649005241384_rk*lam6_12 - 0.3409906449060338_rk*lam6_21 + &
        0.31745868108016423_rk*(neg_lam6_11 - neg_lam6_22) + (0.06483323523282834_rk*lam6_23 + &
        0.0625396920897071_rk*lam6_13)
    nc6_z = 1.193403445777575_rk*a6_y + 1.2174687787169953_rk*a6_x - t6
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
    n3_x = nc3_x + n04_x
    n3_y = nc3_y + n04_y
    n3_z = nc3_z + n4_z
    ! link 3: force through the joint [N]
    f3_x = fc3_x + f04_x
    f3_y = fc3_y + f04_y
    f3_z = fc3_z + f4_z
    ! link 2: moment through the joint, about the frame's origin [N m]
    n2_x = n3_x + (nc2_x - q(3)*f3_y)
    n2_y = nc2_y - n3_z
    n2_z = n3_y + (q(3)*f3_x - neg_nc2_z)
    ! link 2: force through the joint [N]
    f2_x = fc2_x + f3_x
    f2_y = fc2_y - f3_z
    ! link 2: force through the joint, along the axes that its turn starts from [N]
    f02_x = c2*f2_x - s2*f2_y
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_y = s2*n2_x + c2*n2_y
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = -0.1524_rk*f02_x - n02_y
    tau(1) = n1_z
    tau(2) = n2_z
    tau(3) = f3_z
    tau(4) = n4_z
    tau(5) = n5_z
    tau(6) = nc6_z
  end subroutine

  ! mass matrix, rotor inertias on its diagonal
  ! 105 multiplications, 98 additions = 203; 9 unary minus; 8 sine/cosine
  pure subroutine stanford_full_mass_matrix(q, M) &
      bind(c, name="stanford_full_mass_matrix_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(out) :: M(36)
    real(rk) :: c2, s2, c4, s4, c5, s5, c6, s6, h6_x, h6_y, t1, t2, k6_xy, k6_xz, k6_yz, fu5_x
    real(rk) :: neg_fu5_y, nu5_x, neg_nu5_y, fu4_x, fu4_y, nu4_x, nu4_y, m2_6, neg_fu2_x, nu2_y
    real(rk) :: m1_6, t3, m5_5, t4, h5_x, neg_h5_y, t5, t6, t7, t8, t9, k5_yy, neg_k5_xy, t10, t11
    real(rk) :: k5_xz, k5_yz, fu4_x_2, fu4_y_2, nu4_x_2, nu4_y_2, m2_5, fu2_x, nu2_y_2, m1_5, m4_4
    real(rk) :: t12, t13, h4_x, h4_y, t14, t15, t16, t17, t18, k4_xx, k4_yy, k4_xy, t19, t20, k4_xz
    real(rk) :: k4_yz, m2_4, neg_fu2_x_2, neg_nu2_y, m1_4, t21, k3_zz, h3_x, h3_y, h3_z, t22, t23
    real(rk) :: k3_xx, k3_yy, m1_3, t24, t25, m2_2, h2_y, t26, neg_k2_xx, k2_yz, m1_2, m1_1, t27
    real(rk) :: t28, t29

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    c4 = cos(q(4))
    s4 = sin(q(4))
    c5 = cos(q(5))
    s5 = sin(q(5))
    c6 = cos(q(6))
    s6 = sin(q(6))
    ! link 6: first moment of the composite body, about the frame's origin [kg m]
    h6_x = 1.193403445777575_rk*c6 + 1.2174687787169953_rk*s6
    h6_y = 1.193403445777575_rk*s6 - 1.2174687787169953_rk*c6
    t1 = c6*c6
    t2 = c6*s6
    ! link 6: second moment of the composite body [kg m^2]
    k6_xy = 0.31745868108016423_rk*(1.0_rk - 2.0_rk*t1) - 0.010165845146380005_rk*t2
    k6_xz = -0.0625396920897071_rk*s6 - 0.06483323523282834_rk*c6
    k6_yz = 0.0625396920897071_rk*c6 - 0.06483323523282834_rk*s6
    ! link 5: force for a unit acceleration of a joint further out
    fu5_x = -c5*h6_y
    neg_fu5_y = s5*h6_y
    ! link 5: moment for a unit acceleration of a joint further out
    nu5_x = 0.6921471349584476_rk*s5 - c5*k6_xz
    neg_nu5_y = s5*k6_xz + 0.6921471349584476_rk*c5
    ! link 4: force for a unit acceleration of a joint further out
    fu4_x = c4*fu5_x - s4*h6_x
    fu4_y = s4*fu5_x + c4*h6_x
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_x = c4*nu5_x + s4*k6_yz
    nu4_y = s4*nu5_x - c4*k6_yz
    ! link 2: mass matrix, its row of this joint
    m2_6 = nu4_y + q(3)*fu4_x
    ! link 2: force for a unit acceleration of a joint further out
    neg_fu2_x = -c2*fu4_x - s2*neg_fu5_y
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y = s2*(nu4_x - q(3)*fu4_y) - c2*neg_nu5_y
    ! link 1: mass matrix, its row of this joint
    m1_6 = 0.1524_rk*neg_fu2_x - nu2_y
    t3 = 0.010165845146380005_rk*t1 - 0.6349173621603285_rk*t2
    ! link 5: mass matrix, its row of this joint
    m5_5 = 0.7289625214741676_rk - t3
    t4 = h6_x - 0.5911078910549018_rk
    ! link 5: first moment of the composite body, about the frame's origin [kg m]
    h5_x = c5*t4 + 0.6468331423588011_rk*s5
    neg_h5_y = 0.6468331423588011_rk*c5 - s5*t4
    t5 = c5*c5
    t6 = t3 - 0.37825268400268236_rk
    t7 = 0.060693211657558095_rk - k6_xz
    t8 = c5*s5
    t9 = t5*t6 + t7*(2.0_rk*t8)
    ! link 5: second moment of the composite body [kg m^2]
    k5_yy = t9 - (t3 - 0.553607602738425_rk)
    neg_k5_xy = t6*t8 + t7*(1.0_rk - 2.0_rk*t5)
    t10 = k6_xy - 0.13660343902034475_rk
    t11 = k6_yz + 0.23560176217086468_rk
    k5_xz = c5*t10 + s5*t11
    k5_yz = s5*t10 - c5*t11
    ! link 4: force for a unit acceleration of a joint further out
    fu4_x_2 = c4*neg_h5_y
    fu4_y_2 = s4*neg_h5_y
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_x_2 = -s4*m5_5 - c4*k5_xz
    nu4_y_2 = c4*m5_5 - s4*k5_xz
    ! link 2: mass matrix, its row of this joint
    m2_5 = nu4_y_2 + q(3)*fu4_x_2
    ! link 2: force for a unit acceleration of a joint further out
    fu2_x = c2*fu4_x_2 - s2*h5_x
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y_2 = s2*(nu4_x_2 - q(3)*fu4_y_2) - c2*k5_yz
    ! link 1: mass matrix, its row of this joint
    m1_5 = -0.1524_rk*fu2_x - nu2_y_2
    ! link 4: mass matrix, its row of this joint
    m4_4 = t3 - t9 + 2.017360749281895_rk
    t12 = h5_x + 0.9022885982543313_rk
    t13 = h6_y + 0.28054187970758354_rk
    ! link 4: first moment of the composite body, about the frame's origin [kg m]
    h4_x = c4*t12 - s4*t13
    h4_y = s4*t12 + c4*t13
    t14 = c4*c4
    t15 = t3 + t9 + 0.976958493212842_rk
    t16 = 0.06784076259315977_rk - k5_xz
    t17 = c4*s4
    t18 = t14*t15 - t16*(2.0_rk*t17)
    ! link 4: second moment of the composite body [kg m^2]
    k4_xx = t3 + 1.4971596212473683_rk - t18
    k4_yy = t18 - (t9 - 0.5202011280345263_rk)
    k4_xy = t16*(1.0_rk - 2.0_rk*t14) - t15*t17
    t19 = neg_k5_xy - 0.002655628796226608_rk
    t20 = -k5_yz - 0.23523950726161555_rk
    k4_xz = c4*t19 - s4*t20
    k4_yz = s4*t19 + c4*t20
    ! link 2: mass matrix, its row of this joint
    m2_4 = -q(3)*h4_y - k4_yz
    ! link 2: force for a unit acceleration of a joint further out
    neg_fu2_x_2 = c2*h4_y
    ! link 2: moment for a unit acceleration of a joint further out
    neg_nu2_y = s2*(k4_xz + q(3)*h4_x) + c2*m4_4
    ! link 1: mass matrix, its row of this joint
    m1_4 = neg_nu2_y + 0.1524_rk*neg_fu2_x_2
    t21 = k4_yy - k5_yy
    ! link 3: second moment of the composite body [kg m^2]
    k3_zz = k4_yy - t21
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    h3_x = h4_x + 0.22200183325724177_rk
    h3_y = h4_y + 0.4516316755890639_rk
    h3_z = neg_h5_y + 0.012168751997232599_rk
    t22 = k5_yy + t21
    t23 = k4_xx - t22
    ! link 3: second moment of the composite body [kg m^2]
    k3_xx = t22 + t23
    k3_yy = k4_xx - t23
    ! link 1: mass matrix, its row of this joint
    m1_3 = s2*(-h4_y - 3.45891628872104_rk)
    t24 = 19.732838668844984_rk*q(3)
    t25 = q(3)*(-2.0_rk*h3_z - t24) - k3_zz
    ! link 2: mass matrix, its row of this joint
    m2_2 = 0.7467006423132752_rk - (t25 - k3_xx)
    ! link 2: first moment of the composite body, about the frame's origin [kg m]
    h2_y = s2*(h4_x + 0.3708972318890874_rk) - c2*(h3_z + t24 + 0.5558718199714463_rk)
    t26 = c2*c2*(0.49862309142001715_rk - (k3_xx + t25)) - (k4_xz + q(3)*h3_x - &
        0.04911220265093226_rk)*(2.0_rk*(c2*s2))
    ! link 2: second moment of the composite body [kg m^2]
    neg_k2_xx = t25 - 0.6226618668666462_rk + t26
    k2_yz = s2*(k4_xy + 0.0511982033036484_rk) - c2*(k4_yz + q(3)*h3_y + 0.06807816021551473_rk)
    ! link 1: mass matrix, its row of this joint
    m1_2 = k2_yz + 0.1524_rk*h2_y
    m1_1 = k3_yy + 0.1524_rk*(3.0072846131319757_rk + 2.0_rk*h3_y) - neg_k2_xx + &
        1.1129758995253813_rk
    t27 = -h3_x
    t28 = -h5_x
    t29 = -k6_yz
    M(1) = m1_1
    M(2) = m1_2
    M(3) = m1_3
    M(4) = m1_4
    M(5) = m1_5
    M(6) = m1_6
    M(7) = m1_2
    M(8) = m2_2
    M(9) = t27
    M(10) = m2_4
    M(11) = m2_5
    M(12) = m2_6
    M(13) = m1_3
    M(14) = t27
    M(15) = 19.732838668844984_rk
    M(16) = 0.0_rk
    M(17) = t28
    M(18) = neg_fu5_y
    M(19) = m1_4
    M(20) = m2_4
    M(21) = 0.0_rk
    M(22) = m4_4
    M(23) = k5_yz
    M(24) = neg_nu5_y
    M(25) = m1_5
    M(26) = m2_5
    M(27) = t28
    M(28) = k5_yz
    M(29) = m5_5
    M(30) = t29
    M(31) = m1_6
    M(32) = m2_6
    M(33) = neg_fu5_y
    M(34) = neg_nu5_y
    M(35) = t29
    M(36) = 0.6921471349584476_rk
  end subroutine

  ! accelerations that the torques tau give
  ! 402 multiplications, 354 additions, 6 divisions = 762; 20 unary minus; 8 sine/cosine
  pure subroutine stanford_full_forward_dynamics(q, qd, tau, qdd) &
      bind(c, name="stanford_full_forward_dynamics_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(in) :: tau(6)
    real(rk), intent(out) :: qdd(6)
    real(rk) :: c2, s2, c4, s4, c5, s5, c6, s6, h6_x, neg_h6_y, t1, t2, k6_xy, k6_xz, k6_yz, fu5_x
    real(rk) :: fu5_y, nu5_x, nu5_y, fu4_x, fu4_y, nu4_x, nu4_y, m2_6, neg_fu2_x, nu2_y, m1_6, t3
    real(rk) :: m5_5, t4, h5_x, neg_h5_y, t5, t6, t7, t8, t9, k5_yy, neg_k5_xy, t10, t11, k5_xz
    real(rk) :: k5_yz, fu4_x_2, fu4_y_2, nu4_x_2, nu4_y_2, m2_5, fu2_x, nu2_y_2, m1_5, m4_4, t12
    real(rk) :: t13, h4_x, h4_y, t14, t15, t16, t17, t18, k4_xx, k4_yy, k4_xy, t19, t20, k4_xz
    real(rk) :: k4_yz, m2_4, neg_fu2_x_2, neg_nu2_y, m1_4, t21, k3_zz, h3_x, h3_y, h3_z, t22, t23
    real(rk) :: k3_xx, k3_yy, m1_3, t24, t25, m2_2, h2_y, t26, neg_k2_xx, k2_yz, m1_2, m1_1, ww1_zz
    real(rk) :: a2_z, t27, w2_x, w2_y, neg_a2_x, neg_a2_y, alpha2_x, alpha2_y, ww2_xy, neg_ww2_xx
    real(rk) :: ww2_yy, ww2_zz, neg_lam2_11, lam2_22, lam2_32, lam2_33, a3_z, t28, a3_x, a3_y, w4_x
    real(rk) :: w4_y, a4_x, a4_y, alpha4_x, alpha4_y, w4_z, ww4_yz, ww4_zx, ww4_xy, ww4_xx, ww4_yy
    real(rk) :: ww4_zz, neg_lam4_11, lam4_12, lam4_13, lam4_21, neg_lam4_22, lam4_23, lam4_31
    real(rk) :: lam4_32, neg_lam4_33, w5_x, t29, w5_y, a5_x, a5_y, alpha5_x, alpha5_y, w5_z, ww5_yz
    real(rk) :: ww5_zx, ww5_xy, ww5_xx, ww5_yy, ww5_zz, neg_lam5_11, lam5_12, lam5_13, lam5_21
    real(rk) :: neg_lam5_22, lam5_23, neg_lam5_31, lam5_32, neg_lam5_33, w6_x, w6_y, a6_x, a6_y
    real(rk) :: alpha6_x, alpha6_y, w6_z, ww6_yz, ww6_zx, ww6_xy, ww6_xx, ww6_yy, ww6_zz
    real(rk) :: neg_lam6_11, lam6_12, lam6_13, lam6_21, neg_lam6_22, lam6_23, lam6_31, lam6_32
    real(rk) :: neg_lam6_33, fc2_x, fc2_y, nc2_x, nc2_y, neg_nc2_z, fc3_x, fc3_y, fc3_z, nc3_x
    real(rk) :: nc3_y, nc3_z, fc4_x, fc4_y, fc4_z, nc4_x, nc4_y, t30, nc4_z, fc5_x, fc5_y, fc5_z
    real(rk) :: neg_nc5_x, nc5_y, t31, nc5_z, fc6_x, fc6_y, fc6_z, nc6_x, nc6_y, t32, nc6_z, f06_x
    real(rk) :: f06_y, n06_x, n06_y, n5_x, n5_y, n5_z, f5_x, f5_y, f5_z, f05_x, f05_y, n05_x, n05_y
    real(rk) :: n4_x, n4_y, n4_z, f4_x, f4_y, f4_z, f04_x, f04_y, n04_x, n04_y, n3_x, n3_y, n3_z
    real(rk) :: f3_x, f3_y, f3_z, n2_x, n2_y, n2_z, f2_x, f2_y, f02_x, n02_y, n1_z, y1, ipivot1
    real(rk) :: l2_1, l3_1, l4_1, l5_1, l6_1, pivot2, ipivot2, ld3_2, l3_2, ld4_2, l4_2, ld5_2
    real(rk) :: l5_2, ld6_2, l6_2, pivot3, ipivot3, ld4_3, l4_3, t33, ld5_3, l5_3, ld6_3, l6_3
    real(rk) :: pivot4, ipivot4, ld5_4, l5_4, ld6_4, l6_4, pivot5, ipivot5, ld6_5, l6_5, pivot6
    real(rk) :: ipivot6, y2, y3, y4, y5, y6, qdd6, qdd5, qdd4, qdd3, qdd2, qdd1

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    c4 = cos(q(4))
    s4 = sin(q(4))
    c5 = cos(q(5))
    s5 = sin(q(5))
    c6 = cos(q(6))
    s6 = sin(q(6))
    ! link 6: first moment of the composite body, about the frame's origin [kg m]
    h6_x = 1.193403445777575_rk*c6 + 1.2174687787169953_rk*s6
    neg_h6_y = 1.2174687787169953_rk*c6 - 1.193403445777575_rk*s6
    t1 = c6*c6
    t2 = c6*s6
    ! link 6: second moment of the composite body [kg m^2]
    k6_xy = 0.31745868108016423_rk*(1.0_rk - 2.0_rk*t1) - 0.010165845146380005_rk*t2
    k6_xz = -0.0625396920897071_rk*s6 - 0.06483323523282834_rk*c6
    k6_yz = 0.0625396920897071_rk*c6 - 0.06483323523282834_rk*s6
    ! link 5: force for a unit acceleration of a joint further out
    fu5_x = c5*neg_h6_y
    fu5_y = s5*neg_h6_y
    ! link 5: moment for a unit acceleration of a joint further out
    nu5_x = 0.6921471349584476_rk*s5 - c5*k6_xz
    nu5_y = -0.6921471349584476_rk*c5 - s5*k6_xz
    ! link 4: force for a unit acceleration of a joint further out
    fu4_x = c4*fu5_x - s4*h6_x
    fu4_y = s4*fu5_x + c4*h6_x
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_x = c4*nu5_x + s4*k6_yz
    nu4_y = s4*nu5_x - c4*k6_yz
    ! link 2: mass matrix, its row of this joint
    m2_6 = nu4_y + q(3)*fu4_x
    ! link 2: force for a unit acceleration of a joint further out
    neg_fu2_x = s2*fu5_y - c2*fu4_x
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y = s2*(nu4_x - q(3)*fu4_y) + c2*nu5_y
    ! link 1: mass matrix, its row of this joint
    m1_6 = 0.1524_rk*neg_fu2_x - nu2_y
    t3 = 0.010165845146380005_rk*t1 - 0.6349173621603285_rk*t2
    ! link 5: mass matrix, its row of this joint
    m5_5 = 0.7289625214741676_rk - t3
    t4 = h6_x - 0.5911078910549018_rk
    ! link 5: first moment of the composite body, about the frame's origin [kg m]
    h5_x = c5*t4 + 0.6468331423588011_rk*s5
    neg_h5_y = 0.6468331423588011_rk*c5 - s5*t4
    t5 = c5*c5
    t6 = t3 - 0.37825268400268236_rk
    t7 = 0.060693211657558095_rk - k6_xz
    t8 = c5*s5
    t9 = t5*t6 + t7*(2.0_rk*t8)
    ! link 5: second moment of the composite body [kg m^2]
    k5_yy = t9 - (t3 - 0.553607602738425_rk)
    neg_k5_xy = t6*t8 + t7*(1.0_rk - 2.0_rk*t5)
    t10 = k6_xy - 0.13660343902034475_rk
    t11 = k6_yz + 0.23560176217086468_rk
    k5_xz = c5*t10 + s5*t11
    k5_yz = s5*t10 - c5*t11
    ! link 4: force for a unit acceleration of a joint further out
    fu4_x_2 = c4*neg_h5_y
    fu4_y_2 = s4*neg_h5_y
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_x_2 = -s4*m5_5 - c4*k5_xz
    nu4_y_2 = c4*m5_5 - s4*k5_xz
    ! link 2: mass matrix, its row of this joint
    m2_5 = nu4_y_2 + q(3)*fu4_x_2
    ! link 2: force for a unit acceleration of a joint further out
    fu2_x = c2*fu4_x_2 - s2*h5_x
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y_2 = s2*(nu4_x_2 - q(3)*fu4_y_2) - c2*k5_yz
    ! link 1: mass matrix, its row of this joint
    m1_5 = -0.1524_rk*fu2_x - nu2_y_2
    ! link 4: mass matrix, its row of this joint
    m4_4 = t3 - t9 + 2.017360749281895_rk
    t12 = h5_x + 0.9022885982543313_rk
    t13 = 0.28054187970758354_rk - neg_h6_y
    ! link 4: first moment of the composite body, about the frame's origin [kg m]
    h4_x = c4*t12 - s4*t13
    h4_y = s4*t12 + c4*t13
    t14 = c4*c4
    t15 = t3 + t9 + 0.976958493212842_rk
    t16 = 0.06784076259315977_rk - k5_xz
    t17 = c4*s4
    t18 = t14*t15 - t16*(2.0_rk*t17)
    ! link 4: second moment of the composite body [kg m^2]
    k4_xx = t3 + 1.4971596212473683_rk - t18
    k4_yy = t18 - (t9 - 0.5202011280345263_rk)
    k4_xy = t16*(1.0_rk - 2.0_rk*t14) - t15*t17
    t19 = neg_k5_xy - 0.002655628796226608_rk
    t20 = -k5_yz - 0.23523950726161555_rk
    k4_xz = c4*t19 - s4*t20
    k4_yz = s4*t19 + c4*t20
    ! link 2: mass matrix, its row of this joint
    m2_4 = -q(3)*h4_y - k4_yz
    ! link 2: force for a unit acceleration of a joint further out
    neg_fu2_x_2 = c2*h4_y
    ! link 2: moment for a unit acceleration of a joint further out
    neg_nu2_y = s2*(k4_xz + q(3)*h4_x) + c2*m4_4
    ! link 1: mass matrix, its row of this joint
    m1_4 = neg_nu2_y + 0.1524_rk*neg_fu2_x_2
    t21 = k4_yy - k5_yy
    ! link 3: second moment of the composite body [kg m^2]
    k3_zz = k4_yy - t21
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    h3_x = h4_x + 0.22200183325724177_rk
    h3_y = h4_y + 0.4516316755890639_rk
    h3_z = neg_h5_y + 0.012168751997232599_rk
    t22 = k5_yy + t21
    t23 = k4_xx - t22
    ! link 3: second moment of the composite body [kg m^2]
    k3_xx = t22 + t23
    k3_yy = k4_xx - t23
    ! link 1: mass matrix, its row of this joint
    m1_3 = s2*(-h4_y - 3.45891628872104_rk)
    t24 = 19.732838668844984_rk*q(3)
    t25 = q(3)*(-2.0_rk*h3_z - t24) - k3_zz
    ! link 2: mass matrix, its row of this joint
    m2_2 = 0.7467006423132752_rk - (t25 - k3_xx)
    ! link 2: first moment of the composite body, about the frame's origin [kg m]
    h2_y = s2*(h4_x + 0.3708972318890874_rk) - c2*(h3_z + t24 + 0.5558718199714463_rk)
    t26 = c2*c2*(0.49862309142001715_rk - (k3_xx + t25)) - (k4_xz + q(3)*h3_x - &
        0.04911220265093226_rk)*(2.0_rk*(c2*s2))
    ! link 2: second moment of the composite body [kg m^2]
    neg_k2_xx = t25 - 0.6226618668666462_rk + t26
    k2_yz = s2*(k4_xy + 0.0511982033036484_rk) - c2*(k4_yz + q(3)*h3_y + 0.06807816021551473_rk)
    ! link 1: mass matrix, its row of this joint
    m1_2 = k2_yz + 0.1524_rk*h2_y
    m1_1 = k3_yy + 0.1524_rk*(3.0072846131319757_rk + 2.0_rk*h3_y) - neg_k2_xx + &
        1.1129758995253813_rk
    ! link 1: products of the angular velocity [1/s^2]
    ww1_zz = qd(1)*qd(1)
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    a2_z = -0.1524_rk*ww1_zz
    t27 = -qd(1)
    ! link 2: angular velocity [rad/s]
    w2_x = t27*s2
    w2_y = t27*c2
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a2_x = 9.8_rk*s2
    neg_a2_y = 9.8_rk*c2
    ! link 2: angular acceleration [rad/s^2]
    alpha2_x = qd(2)*w2_y
    alpha2_y = -qd(2)*w2_x
    ! link 2: products of the angular velocity [1/s^2]
    ww2_xy = w2_x*w2_y
    neg_ww2_xx = -w2_x*w2_x
    ww2_yy = w2_y*w2_y
    ww2_zz = qd(2)*qd(2)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_11 = ww2_yy + ww2_zz
    lam2_22 = neg_ww2_xx - ww2_zz
    lam2_32 = 2.0_rk*alpha2_x
    lam2_33 = neg_ww2_xx - ww2_yy
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_z = neg_a2_y + q(3)*lam2_22
    t28 = 2.0_rk*qd(3)
    a3_x = qd(2)*t28 - (neg_a2_x + q(3)*ww2_xy)
    a3_y = a2_z - q(3)*lam2_32 - w2_x*t28
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
    neg_lam4_11 = ww4_yy + ww4_zz
    lam4_12 = alpha2_y + ww4_xy
    lam4_13 = alpha4_y + ww4_zx
    lam4_21 = ww4_xy - alpha2_y
    neg_lam4_22 = ww4_xx + ww4_zz
    lam4_23 = ww4_yz - alpha4_x
    lam4_31 = ww4_zx - alpha4_y
    lam4_32 = alpha4_x + ww4_yz
    neg_lam4_33 = ww4_xx + ww4_yy
    ! link 5: angular velocity [rad/s]
    w5_x = c5*w4_x - s5*w4_z
    t29 = -c5
    w5_y = t29*w4_z - s5*w4_x
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_x = c5*a4_x - s5*a3_z
    a5_y = t29*a3_z - s5*a4_x
    ! link 5: angular acceleration [rad/s^2]
    alpha5_x = qd(5)*w5_y - (-s5*alpha2_y - c5*alpha4_x)
    alpha5_y = c5*alpha2_y - s5*alpha4_x - qd(5)*w5_x
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
    ! link 6: angular velocity [rad/s]
    w6_x = c6*w5_x + s6*w5_z
    w6_y = c6*w5_z - s6*w5_x
    ! link 6: acceleration of the frame's origin, gravity taken off [m/s^2]
    a6_x = c6*a5_x + s6*a4_y
    a6_y = c6*a4_y - s6*a5_x
    ! link 6: angular acceleration [rad/s^2]
    alpha6_x = qd(6)*w6_y - (-s6*alpha4_y - c6*alpha5_x)
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
    fc2_x = -0.14889539863184567_rk*neg_lam2_11 - 0.5558718199714463_rk*ww2_xy
    fc2_y = 0.14889539863184567_rk*ww2_xy - 0.5558718199714463_rk*lam2_22
    ! link 2: moment that turns the link [N m]
    nc2_x = 0.0847148653636484_rk*ww1_zz - (0.06807816021551473_rk*(lam2_33 - lam2_22) - &
        1.2453237337332923_rk*alpha2_x + (0.09822440530186452_rk*alpha2_y + &
        0.0511982033036484_rk*ww2_xy))
    nc2_y = 0.248077550893258_rk*alpha2_y - 0.0511982033036484_rk*(neg_lam2_11 + lam2_33) - &
        (0.06807816021551473_rk*ww2_xy + 0.09822440530186452_rk*alpha2_x) + &
        0.02269165875149328_rk*ww1_zz
    neg_nc2_z = 0.49862309142001715_rk*ww2_xy - 0.04911220265093226_rk*(neg_lam2_11 + lam2_22) + &
        (1.4591749065920876_rk*c2 + 5.4475438357201735_rk*s2)
    ! link 3: force that moves the link [N]
    fc3_x = 19.732838668844984_rk*a3_x - (0.22200183325724177_rk*neg_lam2_11 + &
        0.012168751997232599_rk*ww2_xy)
    fc3_y = 19.732838668844984_rk*a3_y - (0.44400366651448353_rk*alpha2_y - &
        0.4516316755890639_rk*lam2_33 + 0.024337503994465198_rk*alpha2_x)
    fc3_z = 19.732838668844984_rk*a3_z - (0.22200183325724177_rk*ww2_xy - &
        0.012168751997232599_rk*lam2_22)
    ! link 3: moment that turns the link [N m]
    nc3_x = 0.4516316755890639_rk*a3_z - 0.012168751997232599_rk*a3_y
    nc3_y = 0.012168751997232599_rk*a3_x - 0.22200183325724177_rk*a3_z
    nc3_z = 0.22200183325724177_rk*a3_y - 0.4516316755890639_rk*a3_x
    ! link 4: force that moves the link [N]
    fc4_x = 0.28054187970758354_rk*lam4_12 - 0.9022885982543313_rk*neg_lam4_11
    fc4_y = 0.9022885982543313_rk*lam4_21 - 0.28054187970758354_rk*neg_lam4_22
    fc4_z = 0.9022885982543313_rk*lam4_31 + 0.28054187970758354_rk*lam4_32
    ! link 4: moment that turns the link [N m]
    nc4_x = 0.28054187970758354_rk*a3_z - (0.23523950726161555_rk*(neg_lam4_22 - neg_lam4_33) - &
        1.1561689763413345_rk*lam4_32 - (0.002655628796226608_rk*lam4_21 - &
        0.06784076259315977_rk*lam4_31))
    nc4_y = 0.002655628796226608_rk*(neg_lam4_11 - neg_lam4_33) - 0.3448462092987837_rk*lam4_31 - &
        (0.23523950726161555_rk*lam4_12 - 0.06784076259315977_rk*lam4_32) - &
        0.9022885982543313_rk*a3_z
    t30 = 1.1561689763413345_rk*lam4_12 - 0.3448462092987837_rk*lam4_21 + &
        0.06784076259315977_rk*(neg_lam4_11 - neg_lam4_22) + (0.002655628796226608_rk*lam4_23 - &
        0.23523950726161555_rk*lam4_13)
    nc4_z = 0.9022885982543313_rk*a4_y - 0.28054187970758354_rk*a4_x - t30
    ! link 5: force that moves the link [N]
    fc5_x = 0.5911078910549018_rk*neg_lam5_11 - 0.6468331423588011_rk*lam5_12
    fc5_y = 0.6468331423588011_rk*neg_lam5_22 - 0.5911078910549018_rk*lam5_21
    fc5_z = 0.5911078910549018_rk*neg_lam5_31 - 0.6468331423588011_rk*lam5_32
    ! link 5: moment that turns the link [N m]
    neg_nc5_x = 0.23560176217086468_rk*(neg_lam5_22 - neg_lam5_33) - &
        0.17535491873574263_rk*lam5_32 + (0.060693211657558095_rk*neg_lam5_31 - &
        0.13660343902034475_rk*lam5_21) + 0.6468331423588011_rk*a4_y
    nc5_y = 0.20245111268601115_rk*neg_lam5_31 + 0.13660343902034475_rk*(neg_lam5_11 - &
        neg_lam5_33) + (-0.23560176217086468_rk*lam5_12 - 0.060693211657558095_rk*lam5_32) + &
        0.5911078910549018_rk*a4_y
    t31 = 0.20245111268601115_rk*lam5_21 - 0.17535491873574263_rk*lam5_12 - &
        0.060693211657558095_rk*(neg_lam5_22 - neg_lam5_11) - (0.13660343902034475_rk*lam5_23 - &
        0.23560176217086468_rk*lam5_13)
    nc5_z = t31 - (0.5911078910549018_rk*a5_y - 0.6468331423588011_rk*a5_x)
    ! link 6: force that moves the link [N]
    fc6_x = -1.193403445777575_rk*neg_lam6_11 - 1.2174687787169953_rk*lam6_12
    fc6_y = 1.193403445777575_rk*lam6_21 + 1.2174687787169953_rk*neg_lam6_22
    fc6_z = 1.193403445777575_rk*lam6_31 - 1.2174687787169953_rk*lam6_32
    ! link 6: moment that turns the link [N m]
    nc6_x = 1.2174687787169953_rk*a5_y - (-0.35115649005241384_rk*lam6_32 - &
        0.0625396920897071_rk*(neg_lam6_22 - neg_lam6_33) - (0.06483323523282834_rk*lam6_21 - &
        0.31745868108016423_rk*lam6_31))
    nc6_y = 0.06483323523282834_rk*(neg_lam6_11 - neg_lam6_33) - 0.3409906449060338_rk*lam6_31 + &
        (0.0625396920897071_rk*lam6_12 + 0.31745868108016423_rk*lam6_32) + &
        1.193403445777575_rk*a5_y
    t32 = 0.35115649005241384_rk*lam6_12 - 0.3409906449060338_rk*lam6_21 + &
        0.31745868108016423_rk*(neg_lam6_11 - neg_lam6_22) + (0.06483323523282834_rk*lam6_23 + &
        0.0625396920897071_rk*lam6_13)
    nc6_z = 1.193403445777575_rk*a6_y + 1.2174687787169953_rk*a6_x - t32
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
    n3_x = nc3_x + n04_x
    n3_y = nc3_y + n04_y
    n3_z = nc3_z + n4_z
    ! link 3: force through the joint [N]
    f3_x = fc3_x + f04_x
    f3_y = fc3_y + f04_y
    f3_z = fc3_z + f4_z
    ! link 2: moment through the joint, about the frame's origin [N m]
    n2_x = n3_x + (nc2_x - q(3)*f3_y)
    n2_y = nc2_y - n3_z
    n2_z = n3_y + (q(3)*f3_x - neg_nc2_z)
    ! link 2: force through the joint [N]
    f2_x = fc2_x + f3_x
    f2_y = fc2_y - f3_z
    ! link 2: force through the joint, along the axes that its turn starts from [N]
    f02_x = c2*f2_x - s2*f2_y
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_y = s2*n2_x + c2*n2_y
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = -0.1524_rk*f02_x - n02_y
    ! link 1: forward substitution
    y1 = tau(1) - n1_z
    ! factorisation M = L D L^T
    ipivot1 = 1.0_rk / m1_1
    l2_1 = m1_2*ipivot1
    l3_1 = m1_3*ipivot1
    l4_1 = m1_4*ipivot1
    l5_1 = m1_5*ipivot1
    l6_1 = m1_6*ipivot1
    pivot2 = m2_2 - m1_2*l2_1
    ipivot2 = 1.0_rk / pivot2
    ld3_2 = -h3_x - m1_2*l3_1
    l3_2 = ipivot2*ld3_2
    ld4_2 = m2_4 - m1_2*l4_1
    l4_2 = ipivot2*ld4_2
    ld5_2 = m2_5 - m1_2*l5_1
    l5_2 = ipivot2*ld5_2
    ld6_2 = m2_6 - m1_2*l6_1
    l6_2 = ipivot2*ld6_2
    pivot3 = 19.732838668844984_rk - m1_3*l3_1 - ld3_2*l3_2
    ipivot3 = 1.0_rk / pivot3
    ld4_3 = -m1_3*l4_1 - ld3_2*l4_2
    l4_3 = ipivot3*ld4_3
    t33 = -ld3_2
    ld5_3 = t33*l5_2 - (h5_x + m1_3*l5_1)
    l5_3 = ipivot3*ld5_3
    ld6_3 = t33*l6_2 - (fu5_y + m1_3*l6_1)
    l6_3 = ipivot3*ld6_3
    pivot4 = m4_4 - m1_4*l4_1 - ld4_2*l4_2 - ld4_3*l4_3
    ipivot4 = 1.0_rk / pivot4
    ld5_4 = -ld4_3*l5_3 - (m1_4*l5_1 - k5_yz + ld4_2*l5_2)
    l5_4 = ipivot4*ld5_4
    ld6_4 = -ld4_2*l6_2 - (nu5_y + m1_4*l6_1) - ld4_3*l6_3
    l6_4 = ipivot4*ld6_4
    pivot5 = -ld5_4*l5_4 - (ld5_2*l5_2 - (m5_5 - m1_5*l5_1) + ld5_3*l5_3)
    ipivot5 = 1.0_rk / pivot5
    ld6_5 = -ld5_2*l6_2 - (k6_yz + m1_5*l6_1) - ld5_3*l6_3 - ld5_4*l6_4
    l6_5 = ipivot5*ld6_5
    pivot6 = 0.6921471349584476_rk - m1_6*l6_1 - ld6_2*l6_2 - ld6_3*l6_3 - ld6_4*l6_4 - ld6_5*l6_5
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
    qdd2 = -l5_2*qdd5 - (l3_2*qdd3 - ipivot2*y2 + l4_2*qdd4) - l6_2*qdd6
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
