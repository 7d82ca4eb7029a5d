! iiwa: KUKA iiwa 14 geometry, random full inertias
! Numbers: published iiwa geometry; inertial parameters drawn at random
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
!   inverse_dynamics: 296 multiplications, 281 additions = 577; 6 unary minus; 12 sine/cosine
!   gravity: 64 multiplications, 38 additions = 102; 2 unary minus; 12 sine/cosine
!   bias: 288 multiplications, 262 additions = 550; 8 unary minus; 12 sine/cosine
!   mass_matrix: 183 multiplications, 150 additions = 333; 5 unary minus; 12 sine/cosine
!   forward_dynamics: 597 multiplications, 517 additions, 7 divisions = 1121; 17 unary minus; 12
!       sine/cosine
module iiwa_dynamics
  use, intrinsic :: iso_c_binding, only: rk => c_double
  implicit none
  private

  public :: iiwa_inverse_dynamics
  public :: iiwa_gravity
  public :: iiwa_bias
  public :: iiwa_mass_matrix
  public :: iiwa_forward_dynamics

contains

  ! torques that give the accelerations qdd
  ! 296 multiplications, 281 additions = 577; 6 unary minus; 12 sine/cosine
  pure subroutine iiwa_inverse_dynamics(q, qd, qdd, tau) &
      bind(c, name="iiwa_inverse_dynamics_f")
    real(rk), intent(in) :: q(7)
    real(rk), intent(in) :: qd(7)
    real(rk), intent(in) :: qdd(7)
    real(rk), intent(out) :: tau(7)
    real(rk) :: c2, s2, c3, s3, c4, s4, c5, s5, c6, s6, c7, s7, t1, w2_x, w2_y, neg_a2_x, neg_a2_y
    real(rk) :: ww2_yz, ww2_zx, alpha2_x, neg_alpha2_y, ww2_xy, ww2_xx, ww2_yy, ww2_zz, neg_lam2_11
    real(rk) :: lam2_12, lam2_13, lam2_21, neg_lam2_22, neg_lam2_23, lam2_31, lam2_32, neg_lam2_33
    real(rk) :: a3_z, w3_x, w3_y, t2, t3, a3_x, a3_y, alpha3_x, alpha3_y, alpha3_z, w3_z, ww3_yz
    real(rk) :: ww3_zx, ww3_xy, ww3_xx, ww3_yy, ww3_zz, neg_lam3_11, lam3_12, lam3_13, lam3_21
    real(rk) :: neg_lam3_22, lam3_23, neg_lam3_31, lam3_32, neg_lam3_33, w4_x, w4_y, a4_x, a4_y
    real(rk) :: alpha4_x, alpha4_y, alpha4_z, w4_z, ww4_yz, ww4_zx, ww4_xy, ww4_xx, ww4_yy, ww4_zz
    real(rk) :: neg_lam4_11, lam4_12, lam4_13, lam4_21, neg_lam4_22, lam4_23, lam4_31, lam4_32
    real(rk) :: neg_lam4_33, a5_z, w5_x, t4, w5_y, t5, t6, a5_x, a5_y, alpha5_x, alpha5_y, alpha5_z
    real(rk) :: w5_z, ww5_yz, ww5_zx, ww5_xy, ww5_xx, ww5_yy, ww5_zz, neg_lam5_11, lam5_12, lam5_13
    real(rk) :: lam5_21, neg_lam5_22, lam5_23, lam5_31, lam5_32, neg_lam5_33, w6_x, t7, w6_y, a6_x
    real(rk) :: a6_y, alpha6_x, alpha6_y, alpha6_z, w6_z, ww6_yz, ww6_zx, ww6_xy, ww6_xx, ww6_yy
    real(rk) :: ww6_zz, neg_lam6_11, lam6_12, lam6_13, lam6_21, neg_lam6_22, lam6_23, lam6_31
    real(rk) :: lam6_32, neg_lam6_33, a7_z, w7_x, w7_y, t8, t9, a7_x, a7_y, alpha7_x, alpha7_y
    real(rk) :: alpha7_z, w7_z, ww7_yz, ww7_zx, ww7_xy, ww7_xx, ww7_yy, ww7_zz, neg_lam7_11
    real(rk) :: lam7_12, lam7_13, lam7_21, neg_lam7_22, lam7_23, lam7_31, lam7_32, neg_lam7_33
    real(rk) :: nc1_z, nc2_x, nc2_y, t10, nc2_z, fc3_x, fc3_y, neg_nc3_x, nc3_y, t11, nc3_z, fc4_x
    real(rk) :: fc4_y, fc4_z, neg_nc4_x, nc4_y, t12, nc4_z, fc5_x, fc5_y, fc5_z, nc5_x, nc5_y, t13
    real(rk) :: nc5_z, fc6_x, fc6_y, fc6_z, nc6_x, nc6_y, t14, nc6_z, fc7_x, fc7_y, fc7_z, nc7_x
    real(rk) :: nc7_y, t15, nc7_z, f07_x, f07_y, n07_x, n07_y, n6_x, n6_y, n6_z, f6_x, f6_y, f6_z
    real(rk) :: f06_x, f06_y, n06_x, n06_y, n5_x, n5_y, n5_z, f5_x, f5_y, f5_z, f05_x, f05_y, n05_x
    real(rk) :: n05_y, n4_x, n4_y, n4_z, f4_x, f4_y, f4_z, f04_x, n04_x, n04_y, n3_x, n3_y, n3_z
    real(rk) :: f3_x, f3_y, f03_x, f03_y, n03_x, n03_y, n2_x, n2_y, n2_z, n02_y, n1_z

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
    neg_lam2_23 = alpha2_x - ww2_yz
    lam2_31 = ww2_zx + neg_alpha2_y
    lam2_32 = ww2_yz + alpha2_x
    neg_lam2_33 = ww2_xx + ww2_yy
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_z = neg_a2_y - 0.4_rk*neg_lam2_22
    ! link 3: angular velocity [rad/s]
    w3_x = c3*w2_x + qd(2)*s3
    w3_y = qd(2)*c3 - s3*w2_x
    t2 = -0.4_rk*lam2_32
    t3 = neg_a2_x + 0.4_rk*lam2_12
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
    neg_lam3_31 = alpha3_y - ww3_zx
    lam3_32 = alpha3_x + ww3_yz
    neg_lam3_33 = ww3_xx + ww3_yy
    ! link 4: angular velocity [rad/s]
    w4_x = c4*w3_x + s4*w3_z
    w4_y = c4*w3_z - s4*w3_x
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_x = c4*a3_x + s4*a3_z
    a4_y = c4*a3_z - s4*a3_x
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
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_z = a4_y - 0.4_rk*neg_lam4_22
    ! link 5: angular velocity [rad/s]
    w5_x = c5*w4_x - s5*w4_z
    t4 = -c5
    w5_y = t4*w4_z - s5*w4_x
    t5 = a3_y - 0.4_rk*lam4_32
    t6 = -0.4_rk*lam4_12 - a4_x
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_x = s5*t5 - c5*t6
    a5_y = s5*t6 + c5*t5
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
    lam5_31 = ww5_zx - alpha5_y
    lam5_32 = alpha5_x + ww5_yz
    neg_lam5_33 = ww5_xx + ww5_yy
    ! link 6: angular velocity [rad/s]
    w6_x = c6*w5_x - s6*w5_z
    t7 = -c6
    w6_y = t7*w5_z - s6*w5_x
    ! link 6: acceleration of the frame's origin, gravity taken off [m/s^2]
    a6_x = c6*a5_x - s6*a5_z
    a6_y = t7*a5_z - s6*a5_x
    ! link 6: angular acceleration [rad/s^2]
    alpha6_x = qd(6)*w6_y - (s6*alpha5_z - c6*alpha5_x)
    alpha6_y = t7*alpha5_z - s6*alpha5_x - qd(6)*w6_x
    alpha6_z = qdd(6) + alpha5_y
    ! link 6: angular velocity [rad/s]
    w6_z = qd(6) + w5_y
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
    a7_z = -0.126_rk*neg_lam6_22 - a6_y
    ! link 7: angular velocity [rad/s]
    w7_x = c7*w6_x + s7*w6_z
    w7_y = c7*w6_z - s7*w6_x
    t8 = a5_y - 0.126_rk*lam6_32
    t9 = 0.126_rk*lam6_12 - a6_x
    ! link 7: acceleration of the frame's origin, gravity taken off [m/s^2]
    a7_x = s7*t8 - c7*t9
    a7_y = s7*t9 + c7*t8
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
    lam7_31 = ww7_zx - alpha7_y
    lam7_32 = alpha7_x + ww7_yz
    neg_lam7_33 = ww7_xx + ww7_yy
    ! link 1: moment that turns the link [N m]
    nc1_z = 0.8058116303302202_rk*qdd(1)
    ! link 2: moment that turns the link [N m]
    nc2_x = 0.20091837135316784_rk*lam2_21 - 0.5218524991029152_rk*lam2_31 - &
        (-4.238401785575742_rk*lam2_32 - 0.26458063578324464_rk*(neg_lam2_22 - neg_lam2_33))
    nc2_y = 0.20091837135316784_rk*(neg_lam2_11 - neg_lam2_33) - 0.5265869353045646_rk*lam2_31 - &
        (-0.26458063578324464_rk*lam2_12 - 0.5218524991029152_rk*lam2_32)
    t10 = 0.5265869353045646_rk*lam2_21 - 4.238401785575742_rk*lam2_12 - &
        0.5218524991029152_rk*(neg_lam2_11 - neg_lam2_22) + (0.20091837135316784_rk*neg_lam2_23 - &
        0.26458063578324464_rk*lam2_13)
    nc2_z = t10 + (13.292379489096295_rk*c2 - 76.6738398539524_rk*s2)
    ! link 3: force that moves the link [N]
    fc3_x = 1.0168650139155704_rk*neg_lam3_11 - 0.04389618410240257_rk*lam3_12
    fc3_y = 0.04389618410240257_rk*neg_lam3_22 - 1.0168650139155704_rk*lam3_21
    ! link 3: moment that turns the link [N m]
    neg_nc3_x = 0.06405373385272267_rk*(neg_lam3_22 - neg_lam3_33) - &
        0.45257769458388303_rk*lam3_32 - (0.1005265342798281_rk*neg_lam3_31 - &
        0.16230144331072144_rk*lam3_21) + 0.04389618410240257_rk*a3_z
    nc3_y = 0.20191091047133833_rk*neg_lam3_31 - 0.16230144331072144_rk*(neg_lam3_11 - &
        neg_lam3_33) + (0.1005265342798281_rk*lam3_32 - 0.06405373385272267_rk*lam3_12) + &
        1.0168650139155704_rk*a3_z
    t11 = 0.20191091047133833_rk*lam3_21 - 0.45257769458388303_rk*lam3_12 + &
        0.1005265342798281_rk*(neg_lam3_22 - neg_lam3_11) + (0.16230144331072144_rk*lam3_23 + &
        0.06405373385272267_rk*lam3_13)
    nc3_z = t11 - (1.0168650139155704_rk*a3_y - 0.04389618410240257_rk*a3_x)
    ! link 4: force that moves the link [N]
    fc4_x = 0.5168019281781282_rk*neg_lam4_11 + 8.054835434921454_rk*lam4_12
    fc4_y = -8.054835434921454_rk*neg_lam4_22 - 0.5168019281781282_rk*lam4_21
    fc4_z = 8.054835434921454_rk*lam4_32 - 0.5168019281781282_rk*lam4_31
    ! link 4: moment that turns the link [N m]
    neg_nc4_x = -3.569490999313376_rk*lam4_32 - 0.09675036990607108_rk*(neg_lam4_22 - neg_lam4_33) &
        - (0.013124222729483126_rk*lam4_21 - 0.20921122087079386_rk*lam4_31) + &
        8.054835434921454_rk*a3_y
    nc4_y = 0.013124222729483126_rk*(neg_lam4_11 - neg_lam4_33) - 0.24852411424661205_rk*lam4_31 - &
        (-0.09675036990607108_rk*lam4_12 - 0.20921122087079386_rk*lam4_32) - &
        0.5168019281781282_rk*a3_y
    t12 = 0.24852411424661205_rk*lam4_21 - 3.569490999313376_rk*lam4_12 - &
        0.20921122087079386_rk*(neg_lam4_11 - neg_lam4_22) - (0.013124222729483126_rk*lam4_23 + &
        0.09675036990607108_rk*lam4_13)
    nc4_z = t12 - (0.5168019281781282_rk*a4_y + 8.054835434921454_rk*a4_x)
    ! link 5: force that moves the link [N]
    fc5_x = 0.25252954507510866_rk*neg_lam5_11 + 0.4193059538543958_rk*lam5_12
    fc5_y = -0.4193059538543958_rk*neg_lam5_22 - 0.25252954507510866_rk*lam5_21
    fc5_z = 0.4193059538543958_rk*lam5_32 - 0.25252954507510866_rk*lam5_31
    ! link 5: moment that turns the link [N m]
    nc5_x = 0.4193059538543958_rk*a5_z - (0.05680835589544868_rk*(neg_lam5_22 - neg_lam5_33) - &
        0.20655564034097101_rk*lam5_32 - (0.041147842218669614_rk*lam5_21 - &
        0.03284626166448073_rk*lam5_31))
    nc5_y = 0.041147842218669614_rk*(neg_lam5_11 - neg_lam5_33) - 0.09474888781047501_rk*lam5_31 + &
        (0.03284626166448073_rk*lam5_32 - 0.05680835589544868_rk*lam5_12) + &
        0.25252954507510866_rk*a5_z
    t13 = 0.09474888781047501_rk*lam5_21 - 0.20655564034097101_rk*lam5_12 - &
        0.03284626166448073_rk*(neg_lam5_11 - neg_lam5_22) - (0.041147842218669614_rk*lam5_23 - &
        0.05680835589544868_rk*lam5_13)
    nc5_z = t13 - (0.25252954507510866_rk*a5_y + 0.4193059538543958_rk*a5_x)
    ! link 6: force that moves the link [N]
    fc6_x = 1.5656307599463828_rk*neg_lam6_11 - 1.291128497815195_rk*lam6_12
    fc6_y = 1.291128497815195_rk*neg_lam6_22 - 1.5656307599463828_rk*lam6_21
    fc6_z = -1.5656307599463828_rk*lam6_31 - 1.291128497815195_rk*lam6_32
    ! link 6: moment that turns the link [N m]
    nc6_x = -1.291128497815195_rk*a5_y - (-2.0289563933923875_rk*lam6_32 - &
        0.0870114460092663_rk*(neg_lam6_22 - neg_lam6_33) - (0.042925575293549574_rk*lam6_21 - &
        0.36144292274665746_rk*lam6_31))
    nc6_y = 0.042925575293549574_rk*(neg_lam6_11 - neg_lam6_33) - 0.4239952187044951_rk*lam6_31 - &
        (-0.0870114460092663_rk*lam6_12 - 0.36144292274665746_rk*lam6_32) + &
        1.5656307599463828_rk*a5_y
    t14 = 0.4239952187044951_rk*lam6_21 - 2.0289563933923875_rk*lam6_12 - &
        0.36144292274665746_rk*(neg_lam6_11 - neg_lam6_22) - (0.042925575293549574_rk*lam6_23 + &
        0.0870114460092663_rk*lam6_13)
    nc6_z = t14 - (1.5656307599463828_rk*a6_y - 1.291128497815195_rk*a6_x)
    ! link 7: force that moves the link [N]
    fc7_x = 0.708306797966195_rk*lam7_12 - 0.9999503996366931_rk*neg_lam7_11
    fc7_y = 0.9999503996366931_rk*lam7_21 - 0.708306797966195_rk*neg_lam7_22
    fc7_z = 0.9999503996366931_rk*lam7_31 + 0.708306797966195_rk*lam7_32
    ! link 7: moment that turns the link [N m]
    nc7_x = 0.708306797966195_rk*a7_z - (-0.2922782720134952_rk*lam7_32 - &
        0.061680050398747424_rk*(neg_lam7_22 - neg_lam7_33) + (0.2024621683128357_rk*lam7_21 - &
        0.2114247825686032_rk*lam7_31))
    nc7_y = -0.19090892097190032_rk*lam7_31 - 0.2024621683128357_rk*(neg_lam7_11 - neg_lam7_33) - &
        (0.2114247825686032_rk*lam7_32 - 0.061680050398747424_rk*lam7_12) - &
        0.9999503996366931_rk*a7_z
    t15 = 0.19090892097190032_rk*lam7_21 - 0.2922782720134952_rk*lam7_12 + &
        0.2114247825686032_rk*(neg_lam7_11 - neg_lam7_22) + (0.2024621683128357_rk*lam7_23 - &
        0.061680050398747424_rk*lam7_13)
    nc7_z = t15 + (0.9999503996366931_rk*a7_y - 0.708306797966195_rk*a7_x)
    ! link 7: force through the joint, along the axes that its turn starts from [N]
    f07_x = c7*fc7_x - s7*fc7_y
    f07_y = s7*fc7_x + c7*fc7_y
    ! link 7: moment through the joint, along the axes that its turn starts from [N m]
    n07_x = c7*nc7_x - s7*nc7_y
    n07_y = s7*nc7_x + c7*nc7_y
    ! link 6: moment through the joint, about the frame's origin [N m]
    n6_x = n07_x + (nc6_x - 0.126_rk*f07_y)
    n6_y = nc6_y - nc7_z
    n6_z = n07_y + (nc6_z + 0.126_rk*f07_x)
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
    n5_y = nc5_y + n6_z
    n5_z = nc5_z - n06_y
    ! link 5: force through the joint [N]
    f5_x = fc5_x + f06_x
    f5_y = fc5_y + f6_z
    f5_z = fc5_z - f06_y
    ! link 5: force through the joint, along the axes that its turn starts from [N]
    f05_x = c5*f5_x - s5*f5_y
    f05_y = s5*f5_x + c5*f5_y
    ! link 5: moment through the joint, along the axes that its turn starts from [N m]
    n05_x = c5*n5_x - s5*n5_y
    n05_y = s5*n5_x + c5*n5_y
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = n05_x - (neg_nc4_x + 0.4_rk*f05_y)
    n4_y = nc4_y + n5_z
    n4_z = nc4_z - 0.4_rk*f05_x - n05_y
    ! link 4: force through the joint [N]
    f4_x = fc4_x + f05_x
    f4_y = fc4_y + f5_z
    f4_z = fc4_z - f05_y
    ! link 4: force through the joint, along the axes that its turn starts from [N]
    f04_x = c4*f4_x - s4*f4_y
    ! link 4: moment through the joint, along the axes that its turn starts from [N m]
    n04_x = c4*n4_x - s4*n4_y
    n04_y = s4*n4_x + c4*n4_y
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_x = n04_x - neg_nc3_x
    n3_y = nc3_y - n4_z
    n3_z = nc3_z + n04_y
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
    n2_x = n03_x - (0.4_rk*f03_y - nc2_x)
    n2_y = nc2_y - n3_z
    n2_z = n03_y + (nc2_z + 0.4_rk*f03_x)
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_y = s2*n2_x + c2*n2_y
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
  ! 64 multiplications, 38 additions = 102; 2 unary minus; 12 sine/cosine
  pure subroutine iiwa_gravity(q, tau) &
      bind(c, name="iiwa_gravity_f")
    real(rk), intent(in) :: q(7)
    real(rk), intent(out) :: tau(7)
    real(rk) :: c2, s2, c3, s3, c4, s4, c5, s5, c6, s6, c7, s7, neg_a2_x, neg_a2_y, a3_x, a3_y
    real(rk) :: a4_x, a4_y, a5_x, a5_y, a6_x, a6_y, a7_x, a7_y, nc2_z, neg_nc3_x, nc3_y, nc3_z
    real(rk) :: neg_nc4_x, neg_nc4_y, nc4_z, nc5_x, nc5_y, nc5_z, neg_nc6_x, nc6_y, nc6_z, nc7_x
    real(rk) :: nc7_y, nc7_z, n07_x, n07_y, n6_x, n6_y, n6_z, n06_x, n06_y, n5_x, n5_y, n5_z, n05_x
    real(rk) :: n05_y, n4_x, n4_y, n4_z, n04_x, n04_y, n3_x, n3_y, n3_z, n03_x, n03_y, n2_z
    real(rk) :: neg_n02_y

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
    a3_x = -c3*neg_a2_x
    a3_y = s3*neg_a2_x
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_x = c4*a3_x + s4*neg_a2_y
    a4_y = c4*neg_a2_y - s4*a3_x
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_x = c5*a4_x + s5*a3_y
    a5_y = c5*a3_y - s5*a4_x
    ! link 6: acceleration of the frame's origin, gravity taken off [m/s^2]
    a6_x = c6*a5_x - s6*a4_y
    a6_y = -c6*a4_y - s6*a5_x
    ! link 7: acceleration of the frame's origin, gravity taken off [m/s^2]
    a7_x = c7*a6_x + s7*a5_y
    a7_y = c7*a5_y - s7*a6_x
    ! link 2: moment that turns the link [N m]
    nc2_z = 13.292379489096295_rk*c2 - 76.6738398539524_rk*s2
    ! link 3: moment that turns the link [N m]
    neg_nc3_x = 0.43062156604456925_rk*c2
    nc3_y = 9.975445786511747_rk*c2
    nc3_z = 0.04389618410240257_rk*a3_x - 1.0168650139155704_rk*a3_y
    ! link 4: moment that turns the link [N m]
    neg_nc4_x = 8.054835434921454_rk*a3_y
    neg_nc4_y = 0.5168019281781282_rk*a3_y
    nc4_z = -8.054835434921454_rk*a4_x - 0.5168019281781282_rk*a4_y
    ! link 5: moment that turns the link [N m]
    nc5_x = 0.4193059538543958_rk*a4_y
    nc5_y = 0.25252954507510866_rk*a4_y
    nc5_z = -0.4193059538543958_rk*a5_x - 0.25252954507510866_rk*a5_y
    ! link 6: moment that turns the link [N m]
    neg_nc6_x = 1.291128497815195_rk*a5_y
    nc6_y = 1.5656307599463828_rk*a5_y
    nc6_z = 1.291128497815195_rk*a6_x - 1.5656307599463828_rk*a6_y
    ! link 7: moment that turns the link [N m]
    nc7_x = -0.708306797966195_rk*a6_y
    nc7_y = 0.9999503996366931_rk*a6_y
    nc7_z = 0.9999503996366931_rk*a7_y - 0.708306797966195_rk*a7_x
    ! link 7: moment through the joint, along the axes that its turn starts from [N m]
    n07_x = c7*nc7_x - s7*nc7_y
    n07_y = s7*nc7_x + c7*nc7_y
    ! link 6: moment through the joint, about the frame's origin [N m]
    n6_x = n07_x - neg_nc6_x
    n6_y = nc6_y - nc7_z
    n6_z = nc6_z + n07_y
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    n06_x = c6*n6_x - s6*n6_y
    n06_y = s6*n6_x + c6*n6_y
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_x = nc5_x + n06_x
    n5_y = nc5_y + n6_z
    n5_z = nc5_z - n06_y
    ! link 5: moment through the joint, along the axes that its turn starts from [N m]
    n05_x = c5*n5_x - s5*n5_y
    n05_y = s5*n5_x + c5*n5_y
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = n05_x - neg_nc4_x
    n4_y = n5_z - neg_nc4_y
    n4_z = nc4_z - n05_y
    ! link 4: moment through the joint, along the axes that its turn starts from [N m]
    n04_x = c4*n4_x - s4*n4_y
    n04_y = s4*n4_x + c4*n4_y
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_x = n04_x - neg_nc3_x
    n3_y = nc3_y - n4_z
    n3_z = nc3_z + n04_y
    ! link 3: moment through the joint, along the axes that its turn starts from [N m]
    n03_x = c3*n3_x - s3*n3_y
    n03_y = s3*n3_x + c3*n3_y
    ! link 2: moment through the joint, about the frame's origin [N m]
    n2_z = nc2_z + n03_y
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    neg_n02_y = c2*n3_z - s2*n03_x
    tau(1) = neg_n02_y
    tau(2) = n2_z
    tau(3) = n3_z
    tau(4) = n4_z
    tau(5) = n5_z
    tau(6) = n6_z
    tau(7) = nc7_z
  end subroutine

  ! torques at zero acceleration: Coriolis, centrifugal, gravity, friction
  ! 288 multiplications, 262 additions = 550; 8 unary minus; 12 sine/cosine
  pure subroutine iiwa_bias(q, qd, tau) &
      bind(c, name="iiwa_bias_f")
    real(rk), intent(in) :: q(7)
    real(rk), intent(in) :: qd(7)
    real(rk), intent(out) :: tau(7)
    real(rk) :: c2, s2, c3, s3, c4, s4, c5, s5, c6, s6, c7, s7, t1, w2_x, w2_y, neg_a2_x, neg_a2_y
    real(rk) :: alpha2_x, neg_alpha2_y, ww2_xy, ww2_xx, ww2_yy, ww2_zz, neg_lam2_11, neg_lam2_22
    real(rk) :: neg_lam2_33, neg_a3_z, w3_x, w3_y, t2, t3, a3_x, a3_y, alpha3_x, alpha3_y, w3_z
    real(rk) :: ww3_yz, ww3_zx, ww3_xy, ww3_xx, ww3_yy, ww3_zz, neg_lam3_11, lam3_12, lam3_13
    real(rk) :: lam3_21, neg_lam3_22, lam3_23, neg_lam3_31, lam3_32, neg_lam3_33, w4_x, w4_y
    real(rk) :: neg_a4_x, a4_y, alpha4_x, alpha4_y, w4_z, ww4_yz, ww4_zx, ww4_xy, ww4_xx, ww4_yy
    real(rk) :: ww4_zz, neg_lam4_11, lam4_12, lam4_13, lam4_21, neg_lam4_22, lam4_23, lam4_31
    real(rk) :: lam4_32, neg_lam4_33, a5_z, w5_x, w5_y, t4, t5, a5_x, a5_y, alpha5_x, alpha5_y
    real(rk) :: w5_z, ww5_yz, ww5_zx, ww5_xy, ww5_xx, ww5_yy, ww5_zz, neg_lam5_11, lam5_12, lam5_13
    real(rk) :: lam5_21, neg_lam5_22, lam5_23, lam5_31, lam5_32, neg_lam5_33, w6_x, t6, w6_y, a6_x
    real(rk) :: a6_y, alpha6_x, alpha6_y, w6_z, ww6_yz, ww6_zx, ww6_xy, ww6_xx, ww6_yy, ww6_zz
    real(rk) :: neg_lam6_11, lam6_12, lam6_13, lam6_21, neg_lam6_22, lam6_23, lam6_31, lam6_32
    real(rk) :: neg_lam6_33, a7_z, w7_x, w7_y, t7, t8, a7_x, a7_y, alpha7_x, alpha7_y, w7_z, ww7_yz
    real(rk) :: ww7_zx, ww7_xy, ww7_xx, ww7_yy, ww7_zz, neg_lam7_11, lam7_12, lam7_13, lam7_21
    real(rk) :: neg_lam7_22, lam7_23, lam7_31, lam7_32, neg_lam7_33, nc2_x, nc2_y, nc2_z, fc3_x
    real(rk) :: fc3_y, nc3_x, nc3_y, t9, neg_nc3_z, fc4_x, fc4_y, fc4_z, neg_nc4_x, nc4_y, t10
    real(rk) :: nc4_z, fc5_x, fc5_y, fc5_z, nc5_x, nc5_y, t11, nc5_z, fc6_x, fc6_y, fc6_z, nc6_x
    real(rk) :: nc6_y, t12, nc6_z, fc7_x, fc7_y, fc7_z, nc7_x, nc7_y, t13, nc7_z, f07_x, f07_y
    real(rk) :: n07_x, n07_y, n6_x, n6_y, n6_z, f6_x, f6_y, f6_z, f06_x, f06_y, n06_x, n06_y, n5_x
    real(rk) :: n5_y, n5_z, f5_x, f5_y, f5_z, f05_x, f05_y, n05_x, n05_y, n4_x, n4_y, n4_z, f4_x
    real(rk) :: f4_y, f4_z, f04_x, n04_x, n04_y, n3_x, n3_y, n3_z, f3_x, f3_y, f03_x, f03_y, n03_x
    real(rk) :: n03_y, n2_x, neg_n2_y, n2_z, neg_n02_y

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
    neg_a3_z = 0.4_rk*neg_lam2_22 - neg_a2_y
    ! link 3: angular velocity [rad/s]
    w3_x = c3*w2_x + qd(2)*s3
    w3_y = qd(2)*c3 - s3*w2_x
    t2 = -0.8_rk*alpha2_x
    t3 = neg_a2_x + 0.4_rk*ww2_xy
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
    neg_lam3_31 = alpha3_y - ww3_zx
    lam3_32 = alpha3_x + ww3_yz
    neg_lam3_33 = ww3_xx + ww3_yy
    ! link 4: angular velocity [rad/s]
    w4_x = c4*w3_x + s4*w3_z
    w4_y = c4*w3_z - s4*w3_x
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a4_x = s4*neg_a3_z - c4*a3_x
    a4_y = -s4*a3_x - c4*neg_a3_z
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = qd(4)*w4_y - (-c4*alpha3_x - s4*neg_alpha2_y)
    alpha4_y = c4*neg_alpha2_y - s4*alpha3_x - qd(4)*w4_x
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
    lam4_31 = ww4_zx - alpha4_y
    lam4_32 = alpha4_x + ww4_yz
    neg_lam4_33 = ww4_xx + ww4_yy
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_z = a4_y - 0.4_rk*neg_lam4_22
    ! link 5: angular velocity [rad/s]
    w5_x = c5*w4_x - s5*w4_z
    w5_y = -c5*w4_z - s5*w4_x
    t4 = a3_y - 0.4_rk*lam4_32
    t5 = neg_a4_x - 0.4_rk*lam4_12
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_x = s5*t4 - c5*t5
    a5_y = s5*t5 + c5*t4
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
    lam5_31 = ww5_zx - alpha5_y
    lam5_32 = alpha5_x + ww5_yz
    neg_lam5_33 = ww5_xx + ww5_yy
    ! link 6: angular velocity [rad/s]
    w6_x = c6*w5_x - s6*w5_z
    t6 = -c6
    w6_y = t6*w5_z - s6*w5_x
    ! link 6: acceleration of the frame's origin, gravity taken off [m/s^2]
    a6_x = c6*a5_x - s6*a5_z
    a6_y = t6*a5_z - s6*a5_x
    ! link 6: angular acceleration [rad/s^2]
    alpha6_x = qd(6)*w6_y - (s6*alpha4_y - c6*alpha5_x)
    alpha6_y = t6*alpha4_y - s6*alpha5_x - qd(6)*w6_x
    ! link 6: angular velocity [rad/s]
    w6_z = qd(6) + w5_y
    ! link 6: products of the angular velocity [1/s^2]
    ww6_yz = w6_y*w6_z
    ww6_zx = w6_x*w6_z
    ww6_xy = w6_x*w6_y
    ww6_xx = w6_x*w6_x
    ww6_yy = w6_y*w6_y
    ww6_zz = w6_z*w6_z
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam6_11 = ww6_yy + ww6_zz
    lam6_12 = ww6_xy - alpha5_y
    lam6_13 = alpha6_y + ww6_zx
    lam6_21 = alpha5_y + ww6_xy
    neg_lam6_22 = ww6_xx + ww6_zz
    lam6_23 = ww6_yz - alpha6_x
    lam6_31 = ww6_zx - alpha6_y
    lam6_32 = alpha6_x + ww6_yz
    neg_lam6_33 = ww6_xx + ww6_yy
    ! link 7: acceleration of the frame's origin, gravity taken off [m/s^2]
    a7_z = -0.126_rk*neg_lam6_22 - a6_y
    ! link 7: angular velocity [rad/s]
    w7_x = c7*w6_x + s7*w6_z
    w7_y = c7*w6_z - s7*w6_x
    t7 = a5_y - 0.126_rk*lam6_32
    t8 = 0.126_rk*lam6_12 - a6_x
    ! link 7: acceleration of the frame's origin, gravity taken off [m/s^2]
    a7_x = s7*t7 - c7*t8
    a7_y = s7*t8 + c7*t7
    ! link 7: angular acceleration [rad/s^2]
    alpha7_x = qd(7)*w7_y - (-s7*alpha5_y - c7*alpha6_x)
    alpha7_y = c7*alpha5_y - s7*alpha6_x - qd(7)*w7_x
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
    lam7_31 = ww7_zx - alpha7_y
    lam7_32 = alpha7_x + ww7_yz
    neg_lam7_33 = ww7_xx + ww7_yy
    ! link 2: moment that turns the link [N m]
    nc2_x = 0.20091837135316784_rk*ww2_xy - 1.0437049982058304_rk*neg_alpha2_y - &
        (-8.476803571151484_rk*alpha2_x - 0.26458063578324464_rk*(neg_lam2_22 - neg_lam2_33))
    nc2_y = 0.20091837135316784_rk*(neg_lam2_11 - neg_lam2_33) - &
        1.0531738706091291_rk*neg_alpha2_y + (0.26458063578324464_rk*ww2_xy + &
        1.0437049982058304_rk*alpha2_x)
    nc2_z = 13.292379489096295_rk*c2 - 76.6738398539524_rk*s2 - (3.711814850271177_rk*ww2_xy + &
        0.5218524991029152_rk*(neg_lam2_11 - neg_lam2_22))
    ! link 3: force that moves the link [N]
    fc3_x = 1.0168650139155704_rk*neg_lam3_11 - 0.04389618410240257_rk*lam3_12
    fc3_y = 0.04389618410240257_rk*neg_lam3_22 - 1.0168650139155704_rk*lam3_21
    ! link 3: moment that turns the link [N m]
    nc3_x = 0.04389618410240257_rk*neg_a3_z - (0.06405373385272267_rk*(neg_lam3_22 - neg_lam3_33) &
        - 0.45257769458388303_rk*lam3_32 - (0.1005265342798281_rk*neg_lam3_31 - &
        0.16230144331072144_rk*lam3_21))
    nc3_y = 0.20191091047133833_rk*neg_lam3_31 - 0.16230144331072144_rk*(neg_lam3_11 - &
        neg_lam3_33) - (0.06405373385272267_rk*lam3_12 - 0.1005265342798281_rk*lam3_32) - &
        1.0168650139155704_rk*neg_a3_z
    t9 = 0.45257769458388303_rk*lam3_12 - 0.20191091047133833_rk*lam3_21 + &
        0.1005265342798281_rk*(neg_lam3_11 - neg_lam3_22) - (0.16230144331072144_rk*lam3_23 + &
        0.06405373385272267_rk*lam3_13)
    neg_nc3_z = t9 + (1.0168650139155704_rk*a3_y - 0.04389618410240257_rk*a3_x)
    ! link 4: force that moves the link [N]
    fc4_x = 0.5168019281781282_rk*neg_lam4_11 + 8.054835434921454_rk*lam4_12
    fc4_y = -8.054835434921454_rk*neg_lam4_22 - 0.5168019281781282_rk*lam4_21
    fc4_z = 8.054835434921454_rk*lam4_32 - 0.5168019281781282_rk*lam4_31
    ! link 4: moment that turns the link [N m]
    neg_nc4_x = -3.569490999313376_rk*lam4_32 - 0.09675036990607108_rk*(neg_lam4_22 - neg_lam4_33) &
        - (0.013124222729483126_rk*lam4_21 - 0.20921122087079386_rk*lam4_31) + &
        8.054835434921454_rk*a3_y
    nc4_y = 0.013124222729483126_rk*(neg_lam4_11 - neg_lam4_33) - 0.24852411424661205_rk*lam4_31 + &
        (0.09675036990607108_rk*lam4_12 + 0.20921122087079386_rk*lam4_32) - &
        0.5168019281781282_rk*a3_y
    t10 = 3.569490999313376_rk*lam4_12 - 0.24852411424661205_rk*lam4_21 + &
        0.20921122087079386_rk*(neg_lam4_11 - neg_lam4_22) + (0.013124222729483126_rk*lam4_23 + &
        0.09675036990607108_rk*lam4_13)
    nc4_z = 8.054835434921454_rk*neg_a4_x - 0.5168019281781282_rk*a4_y - t10
    ! link 5: force that moves the link [N]
    fc5_x = 0.25252954507510866_rk*neg_lam5_11 + 0.4193059538543958_rk*lam5_12
    fc5_y = -0.4193059538543958_rk*neg_lam5_22 - 0.25252954507510866_rk*lam5_21
    fc5_z = 0.4193059538543958_rk*lam5_32 - 0.25252954507510866_rk*lam5_31
    ! link 5: moment that turns the link [N m]
    nc5_x = 0.4193059538543958_rk*a5_z - (0.05680835589544868_rk*(neg_lam5_22 - neg_lam5_33) - &
        0.20655564034097101_rk*lam5_32 - (0.041147842218669614_rk*lam5_21 - &
        0.03284626166448073_rk*lam5_31))
    nc5_y = 0.041147842218669614_rk*(neg_lam5_11 - neg_lam5_33) - 0.09474888781047501_rk*lam5_31 + &
        (0.03284626166448073_rk*lam5_32 - 0.05680835589544868_rk*lam5_12) + &
        0.25252954507510866_rk*a5_z
    t11 = 0.09474888781047501_rk*lam5_21 - 0.20655564034097101_rk*lam5_12 - &
        0.03284626166448073_rk*(neg_lam5_11 - neg_lam5_22) - (0.041147842218669614_rk*lam5_23 - &
        0.05680835589544868_rk*lam5_13)
    nc5_z = t11 - (0.25252954507510866_rk*a5_y + 0.4193059538543958_rk*a5_x)
    ! link 6: force that moves the link [N]
    fc6_x = 1.5656307599463828_rk*neg_lam6_11 - 1.291128497815195_rk*lam6_12
    fc6_y = 1.291128497815195_rk*neg_lam6_22 - 1.5656307599463828_rk*lam6_21
    fc6_z = -1.5656307599463828_rk*lam6_31 - 1.291128497815195_rk*lam6_32
    ! link 6: moment that turns the link [N m]
    nc6_x = -1.291128497815195_rk*a5_y - (-2.0289563933923875_rk*lam6_32 - &
        0.0870114460092663_rk*(neg_lam6_22 - neg_lam6_33) - (0.042925575293549574_rk*lam6_21 - &
        0.36144292274665746_rk*lam6_31))
    nc6_y = 0.042925575293549574_rk*(neg_lam6_11 - neg_lam6_33) - 0.4239952187044951_rk*lam6_31 - &
        (-0.0870114460092663_rk*lam6_12 - 0.36144292274665746_rk*lam6_32) + &
        1.5656307599463828_rk*a5_y
    t12 = 0.4239952187044951_rk*lam6_21 - 2.0289563933923875_rk*lam6_12 - &
        0.36144292274665746_rk*(neg_lam6_11 - neg_lam6_22) - (0.042925575293549574_rk*lam6_23 + &
        0.0870114460092663_rk*lam6_13)
    nc6_z = t12 - (1.5656307599463828_rk*a6_y - 1.291128497815195_rk*a6_x)
    ! link 7: force that moves the link [N]
    fc7_x = 0.708306797966195_rk*lam7_12 - 0.9999503996366931_rk*neg_lam7_11
    fc7_y = 0.9999503996366931_rk*lam7_21 - 0.708306797966195_rk*neg_lam7_22
    fc7_z = 0.9999503996366931_rk*lam7_31 + 0.708306797966195_rk*lam7_32
    ! link 7: moment that turns the link [N m]
    nc7_x = 0.708306797966195_rk*a7_z - (-0.2922782720134952_rk*lam7_32 - &
        0.061680050398747424_rk*(neg_lam7_22 - neg_lam7_33) + (0.2024621683128357_rk*lam7_21 - &
        0.2114247825686032_rk*lam7_31))
    nc7_y = -0.19090892097190032_rk*lam7_31 - 0.2024621683128357_rk*(neg_lam7_11 - neg_lam7_33) + &
        (0.061680050398747424_rk*lam7_12 - 0.2114247825686032_rk*lam7_32) - &
        0.9999503996366931_rk*a7_z
    t13 = 0.2922782720134952_rk*lam7_12 - 0.19090892097190032_rk*lam7_21 - &
        0.2114247825686032_rk*(neg_lam7_11 - neg_lam7_22) - (0.2024621683128357_rk*lam7_23 - &
        0.061680050398747424_rk*lam7_13)
    nc7_z = 0.9999503996366931_rk*a7_y - 0.708306797966195_rk*a7_x - t13
    ! link 7: force through the joint, along the axes that its turn starts from [N]
    f07_x = c7*fc7_x - s7*fc7_y
    f07_y = s7*fc7_x + c7*fc7_y
    ! link 7: moment through the joint, along the axes that its turn starts from [N m]
    n07_x = c7*nc7_x - s7*nc7_y
    n07_y = s7*nc7_x + c7*nc7_y
    ! link 6: moment through the joint, about the frame's origin [N m]
    n6_x = n07_x + (nc6_x - 0.126_rk*f07_y)
    n6_y = nc6_y - nc7_z
    n6_z = n07_y + (nc6_z + 0.126_rk*f07_x)
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
    n5_y = nc5_y + n6_z
    n5_z = nc5_z - n06_y
    ! link 5: force through the joint [N]
    f5_x = fc5_x + f06_x
    f5_y = fc5_y + f6_z
    f5_z = fc5_z - f06_y
    ! link 5: force through the joint, along the axes that its turn starts from [N]
    f05_x = c5*f5_x - s5*f5_y
    f05_y = s5*f5_x + c5*f5_y
    ! link 5: moment through the joint, along the axes that its turn starts from [N m]
    n05_x = c5*n5_x - s5*n5_y
    n05_y = s5*n5_x + c5*n5_y
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = n05_x - (neg_nc4_x + 0.4_rk*f05_y)
    n4_y = nc4_y + n5_z
    n4_z = nc4_z - 0.4_rk*f05_x - n05_y
    ! link 4: force through the joint [N]
    f4_x = fc4_x + f05_x
    f4_y = fc4_y + f5_z
    f4_z = fc4_z - f05_y
    ! link 4: force through the joint, along the axes that its turn starts from [N]
    f04_x = c4*f4_x - s4*f4_y
    ! link 4: moment through the joint, along the axes that its turn starts from [N m]
    n04_x = c4*n4_x - s4*n4_y
    n04_y = s4*n4_x + c4*n4_y
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_x = nc3_x + n04_x
    n3_y = nc3_y - n4_z
    n3_z = n04_y - neg_nc3_z
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
    n2_x = n03_x - (0.4_rk*f03_y - nc2_x)
    neg_n2_y = n3_z - nc2_y
    n2_z = n03_y + (nc2_z + 0.4_rk*f03_x)
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
  ! 183 multiplications, 150 additions = 333; 5 unary minus; 12 sine/cosine
  pure subroutine iiwa_mass_matrix(q, M) &
      bind(c, name="iiwa_mass_matrix_f")
    real(rk), intent(in) :: q(7)
    real(rk), intent(out) :: M(49)
    real(rk) :: c2, s2, c3, s3, c4, s4, c5, s5, c6, s6, c7, s7, h7_x, neg_h7_y, t1, t2, k7_xy
    real(rk) :: k7_xz, k7_yz, m6_7, fu6_x, fu6_y, t3, nu6_x, neg_nu6_y, fu5_x, fu5_y, nu5_x
    real(rk) :: neg_nu5_y, m4_7, fu4_x, t4, nu4_x, nu4_y, fu3_x, fu3_y, nu3_x, nu3_y, m2_7
    real(rk) :: neg_nu2_y, t5, m6_6, t6, h6_x, h6_y, t7, t8, t9, t10, t11, k6_yy, neg_k6_xy, t12
    real(rk) :: t13, k6_xz, k6_yz, neg_fu5_x, t14, fu5_y_2, nu5_x_2, nu5_y, m4_6, fu4_x_2, t15
    real(rk) :: nu4_x_2, nu4_y_2, fu3_x_2, fu3_y_2, nu3_x_2, nu3_y_2, m2_6, neg_nu2_y_2, m5_5, t16
    real(rk) :: t17, h5_x, h5_y, t18, t19, t20, t21, t22, k5_xx, k5_yy, neg_k5_xy, t23, t24, k5_xz
    real(rk) :: k5_yz, m4_5, fu4_x_3, t25, nu4_x_3, nu4_y_3, fu3_x_3, fu3_y_3, nu3_x_3, nu3_y_3
    real(rk) :: m2_5, neg_nu2_y_3, t26, m4_4, t27, t28, h4_x, h4_y, t29, t30, t31, t32, t33, k4_xx
    real(rk) :: k4_yy, k4_xy, t34, t35, k4_xz, neg_k4_yz, neg_fu3_x, neg_fu3_y, nu3_x_4, neg_nu3_y
    real(rk) :: m2_4, neg_nu2_y_4, m3_3, t36, t37, h3_x, h3_y, t38, t39, t40, t41, t42, k3_xx
    real(rk) :: k3_yy, k3_xy, t43, t44, k3_xz, k3_yz, m2_3, t45, neg_nu2_y_5, t46, m2_2, k2_xx
    real(rk) :: k2_yz, m1_1

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
    h7_x = 0.9999503996366931_rk*c7 - 0.708306797966195_rk*s7
    neg_h7_y = -0.708306797966195_rk*c7 - 0.9999503996366931_rk*s7
    t1 = c7*c7
    t2 = c7*s7
    ! link 7: second moment of the composite body [kg m^2]
    k7_xy = 0.2114247825686032_rk*(2.0_rk*t1 - 1.0_rk) - 0.10136935104159488_rk*t2
    k7_xz = 0.2024621683128357_rk*c7 - 0.061680050398747424_rk*s7
    k7_yz = 0.2024621683128357_rk*s7 + 0.061680050398747424_rk*c7
    ! link 6: mass matrix, its row of this joint
    m6_7 = 0.126_rk*neg_h7_y - k7_yz
    ! link 6: force for a unit acceleration of a joint further out
    fu6_x = c6*neg_h7_y
    fu6_y = s6*neg_h7_y
    t3 = k7_xz + 0.126_rk*h7_x
    ! link 6: moment for a unit acceleration of a joint further out
    nu6_x = 0.48318719298539553_rk*s6 - c6*t3
    neg_nu6_y = s6*t3 + 0.48318719298539553_rk*c6
    ! link 5: force for a unit acceleration of a joint further out
    fu5_x = c5*fu6_x - s5*h7_x
    fu5_y = s5*fu6_x + c5*h7_x
    ! link 5: moment for a unit acceleration of a joint further out
    nu5_x = c5*nu6_x - s5*m6_7
    neg_nu5_y = -c5*m6_7 - s5*nu6_x
    ! link 4: mass matrix, its row of this joint
    m4_7 = neg_nu5_y - 0.4_rk*fu5_x
    ! link 4: force for a unit acceleration of a joint further out
    fu4_x = c4*fu5_x + s4*fu6_y
    t4 = nu5_x - 0.4_rk*fu5_y
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_x = c4*t4 - s4*neg_nu6_y
    nu4_y = s4*t4 + c4*neg_nu6_y
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x = c3*fu4_x - s3*fu5_y
    fu3_y = s3*fu4_x + c3*fu5_y
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_x = c3*nu4_x + s3*m4_7
    nu3_y = s3*nu4_x - c3*m4_7
    ! link 2: mass matrix, its row of this joint
    m2_7 = nu3_y + 0.4_rk*fu3_x
    ! link 2: moment for a unit acceleration of a joint further out
    neg_nu2_y = c2*nu4_y - s2*(nu3_x - 0.4_rk*fu3_y)
    t5 = 0.10136935104159488_rk*t1 + 0.4228495651372064_rk*t2
    ! link 6: mass matrix, its row of this joint
    m6_6 = 2.745229884110378_rk - t5
    t6 = h7_x - 1.5656307599463828_rk
    ! link 6: first moment of the composite body, about the frame's origin [kg m]
    h6_x = c6*t6 + 1.291128497815195_rk*s6
    h6_y = s6*t6 - 1.291128497815195_rk*c6
    t7 = c6*c6
    t8 = t5 + 1.3126829026743974_rk
    t9 = t3 + 0.36144292274665746_rk
    t10 = c6*s6
    t11 = t7*t8 - t9*(2.0_rk*t10)
    ! link 6: second moment of the composite body [kg m^2]
    k6_yy = t11 - (t5 - 0.7162734907179903_rk)
    neg_k6_xy = t8*t10 - t9*(1.0_rk - 2.0_rk*t7)
    t12 = k7_xy - 0.042925575293549574_rk
    t13 = m6_7 + 0.0870114460092663_rk
    k6_xz = c6*t12 - s6*t13
    k6_yz = s6*t12 + c6*t13
    ! link 5: force for a unit acceleration of a joint further out
    neg_fu5_x = c5*h6_y
    t14 = -s5
    fu5_y_2 = t14*h6_y
    ! link 5: moment for a unit acceleration of a joint further out
    nu5_x_2 = t14*m6_6 - c5*k6_xz
    nu5_y = c5*m6_6 - s5*k6_xz
    ! link 4: mass matrix, its row of this joint
    m4_6 = 0.4_rk*neg_fu5_x - nu5_y
    ! link 4: force for a unit acceleration of a joint further out
    fu4_x_2 = s4*h6_x - c4*neg_fu5_x
    t15 = nu5_x_2 - 0.4_rk*fu5_y_2
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_x_2 = c4*t15 - s4*k6_yz
    nu4_y_2 = s4*t15 + c4*k6_yz
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x_2 = c3*fu4_x_2 - s3*fu5_y_2
    fu3_y_2 = s3*fu4_x_2 + c3*fu5_y_2
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_x_2 = c3*nu4_x_2 + s3*m4_6
    nu3_y_2 = s3*nu4_x_2 - c3*m4_6
    ! link 2: mass matrix, its row of this joint
    m2_6 = nu3_y_2 + 0.4_rk*fu3_x_2
    ! link 2: moment for a unit acceleration of a joint further out
    neg_nu2_y_2 = c2*nu4_y_2 - s2*(nu3_x_2 - 0.4_rk*fu3_y_2)
    ! link 5: mass matrix, its row of this joint
    m5_5 = t5 - t11 + 2.521169842515734_rk
    t16 = h6_x - 0.25252954507510866_rk
    t17 = 0.4193059538543958_rk - neg_h7_y
    ! link 5: first moment of the composite body, about the frame's origin [kg m]
    h5_x = c5*t16 - s5*t17
    h5_y = s5*t16 + c5*t17
    t18 = c5*c5
    t19 = t5 + t11 - 1.7262407198899914_rk
    t20 = 0.03284626166448073_rk - k6_xz
    t21 = c5*s5
    t22 = t18*t19 - t20*(2.0_rk*t21)
    ! link 5: second moment of the composite body [kg m^2]
    k5_xx = t5 + 0.39746456131287133_rk - t22
    k5_yy = t22 - (t11 - 2.1237052812028625_rk)
    neg_k5_xy = t19*t21 - t20*(1.0_rk - 2.0_rk*t18)
    t23 = neg_k6_xy - 0.041147842218669614_rk
    t24 = -k6_yz - 0.05680835589544868_rk
    k5_xz = c5*t23 - s5*t24
    k5_yz = s5*t23 + c5*t24
    ! link 4: mass matrix, its row of this joint
    m4_5 = k5_yz + 0.4_rk*h5_y
    ! link 4: force for a unit acceleration of a joint further out
    fu4_x_3 = -c4*h5_y
    t25 = k5_xz + 0.4_rk*h5_x
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_x_3 = -s4*m5_5 - c4*t25
    nu4_y_3 = c4*m5_5 - s4*t25
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x_3 = c3*fu4_x_3 - s3*h5_x
    fu3_y_3 = s3*fu4_x_3 + c3*h5_x
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_x_3 = c3*nu4_x_3 + s3*m4_5
    nu3_y_3 = s3*nu4_x_3 - c3*m4_5
    ! link 2: mass matrix, its row of this joint
    m2_5 = nu3_y_3 + 0.4_rk*fu3_x_3
    ! link 2: moment for a unit acceleration of a joint further out
    neg_nu2_y_3 = c2*nu4_y_3 - s2*(nu3_x_3 - 0.4_rk*fu3_y_3)
    t26 = 0.8_rk*h6_y - k6_yy
    ! link 4: mass matrix, its row of this joint
    m4_4 = k5_xx - t26 + 3.818015113559988_rk
    t27 = h5_x - 0.5168019281781282_rk
    t28 = h6_y - 8.054835434921454_rk
    ! link 4: first moment of the composite body, about the frame's origin [kg m]
    h4_x = c4*t27 + s4*t28
    h4_y = s4*t27 - c4*t28
    t29 = c4*c4
    t30 = k5_xx + t26 - 3.3209668850667637_rk
    t31 = t25 - 0.20921122087079386_rk
    t32 = c4*s4
    t33 = t29*t30 - t31*(2.0_rk*t32)
    ! link 4: second moment of the composite body [kg m^2]
    k4_xx = t33 - (t26 - 3.569490999313376_rk)
    k4_yy = k5_xx + 0.24852411424661205_rk - t33
    k4_xy = t30*t32 - t31*(1.0_rk - 2.0_rk*t29)
    t34 = neg_k5_xy - 0.013124222729483126_rk
    t35 = m4_5 - 0.09675036990607108_rk
    k4_xz = c4*t34 + s4*t35
    neg_k4_yz = c4*t35 - s4*t34
    ! link 3: force for a unit acceleration of a joint further out
    neg_fu3_x = c3*h4_y
    neg_fu3_y = s3*h4_y
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_x_4 = s3*m4_4 - c3*k4_xz
    neg_nu3_y = s3*k4_xz + c3*m4_4
    ! link 2: mass matrix, its row of this joint
    m2_4 = -0.4_rk*neg_fu3_x - neg_nu3_y
    ! link 2: moment for a unit acceleration of a joint further out
    neg_nu2_y_4 = c2*neg_k4_yz - s2*(nu3_x_4 + 0.4_rk*neg_fu3_y)
    ! link 3: mass matrix, its row of this joint
    m3_3 = k5_yy + k4_xx + 0.6544886050552213_rk
    t36 = h4_x - 1.0168650139155704_rk
    t37 = h5_y - 0.04389618410240257_rk
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    h3_x = c3*t36 - s3*t37
    h3_y = s3*t36 + c3*t37
    t38 = c3*c3
    t39 = k4_xx - k5_yy - 0.2506667841125447_rk
    t40 = k4_xz + 0.1005265342798281_rk
    t41 = c3*s3
    t42 = t38*t39 + t40*(2.0_rk*t41)
    ! link 3: second moment of the composite body [kg m^2]
    k3_xx = k5_yy + 0.45257769458388303_rk + t42
    k3_yy = k4_xx + 0.20191091047133833_rk - t42
    k3_xy = t39*t41 + t40*(1.0_rk - 2.0_rk*t38)
    t43 = k4_xy + 0.16230144331072144_rk
    t44 = 0.06405373385272267_rk - neg_k4_yz
    k3_xz = c3*t43 + s3*t44
    k3_yz = s3*t43 - c3*t44
    ! link 2: mass matrix, its row of this joint
    m2_3 = -0.4_rk*h3_y - k3_yz
    t45 = k3_xz + 0.4_rk*h3_x
    ! link 2: moment for a unit acceleration of a joint further out
    neg_nu2_y_5 = s2*t45 + c2*m3_3
    t46 = k4_yy + 0.8_rk*h4_y
    ! link 2: mass matrix, its row of this joint
    m2_2 = k3_xx + t46 + 4.764988720880306_rk
    ! link 2: second moment of the composite body [kg m^2]
    k2_xx = t46 + 4.238401785575742_rk - (c2*c2*(t46 - k3_xx + 3.711814850271177_rk) - (t45 + &
        0.5218524991029152_rk)*(2.0_rk*(c2*s2)))
    k2_yz = s2*(k3_xy - 0.20091837135316784_rk) + c2*(m2_3 + 0.26458063578324464_rk)
    ! link 1: mass matrix, its row of this joint
    m1_1 = k3_yy + k2_xx + 0.8058116303302202_rk
    M(1) = m1_1
    M(2) = k2_yz
    M(3) = neg_nu2_y_5
    M(4) = neg_nu2_y_4
    M(5) = neg_nu2_y_3
    M(6) = neg_nu2_y_2
    M(7) = neg_nu2_y
    M(8) = k2_yz
    M(9) = m2_2
    M(10) = m2_3
    M(11) = m2_4
    M(12) = m2_5
    M(13) = m2_6
    M(14) = m2_7
    M(15) = neg_nu2_y_5
    M(16) = m2_3
    M(17) = m3_3
    M(18) = neg_k4_yz
    M(19) = nu4_y_3
    M(20) = nu4_y_2
    M(21) = nu4_y
    M(22) = neg_nu2_y_4
    M(23) = m2_4
    M(24) = neg_k4_yz
    M(25) = m4_4
    M(26) = m4_5
    M(27) = m4_6
    M(28) = m4_7
    M(29) = neg_nu2_y_3
    M(30) = m2_5
    M(31) = nu4_y_3
    M(32) = m4_5
    M(33) = m5_5
    M(34) = k6_yz
    M(35) = neg_nu6_y
    M(36) = neg_nu2_y_2
    M(37) = m2_6
    M(38) = nu4_y_2
    M(39) = m4_6
    M(40) = k6_yz
    M(41) = m6_6
    M(42) = m6_7
    M(43) = neg_nu2_y
    M(44) = m2_7
    M(45) = nu4_y
    M(46) = m4_7
    M(47) = neg_nu6_y
    M(48) = m6_7
    M(49) = 0.48318719298539553_rk
  end subroutine

  ! accelerations that the torques tau give
  ! 597 multiplications, 517 additions, 7 divisions = 1121; 17 unary minus; 12 sine/cosine
  pure subroutine iiwa_forward_dynamics(q, qd, tau, qdd) &
      bind(c, name="iiwa_forward_dynamics_f")
    real(rk), intent(in) :: q(7)
    real(rk), intent(in) :: qd(7)
    real(rk), intent(in) :: tau(7)
    real(rk), intent(out) :: qdd(7)
    real(rk) :: c2, s2, c3, s3, c4, s4, c5, s5, c6, s6, c7, s7, h7_x, neg_h7_y, t1, t2, k7_xy
    real(rk) :: k7_xz, k7_yz, neg_m6_7, fu6_x, fu6_y, t3, nu6_x, nu6_y, fu5_x, fu5_y, nu5_x
    real(rk) :: neg_nu5_y, m4_7, fu4_x, t4, nu4_x, nu4_y, fu3_x, fu3_y, nu3_x, nu3_y, m2_7, nu2_y
    real(rk) :: t5, m6_6, t6, h6_x, h6_y, t7, t8, t9, t10, t11, k6_yy, neg_k6_xy, t12, t13, k6_xz
    real(rk) :: k6_yz, neg_fu5_x, t14, fu5_y_2, nu5_x_2, nu5_y, m4_6, fu4_x_2, t15, nu4_x_2
    real(rk) :: nu4_y_2, fu3_x_2, fu3_y_2, nu3_x_2, nu3_y_2, m2_6, nu2_y_2, m5_5, t16, t17, h5_x
    real(rk) :: h5_y, t18, t19, t20, t21, t22, k5_xx, k5_yy, neg_k5_xy, t23, t24, k5_xz, k5_yz
    real(rk) :: m4_5, t25, fu4_x_3, t26, nu4_x_3, nu4_y_3, fu3_x_3, fu3_y_3, nu3_x_3, nu3_y_3, m2_5
    real(rk) :: nu2_y_3, t27, m4_4, t28, t29, h4_x, h4_y, t30, t31, t32, t33, t34, k4_xx, k4_yy
    real(rk) :: k4_xy, t35, t36, k4_xz, k4_yz, neg_fu3_x, neg_fu3_y, nu3_x_4, neg_nu3_y, m2_4
    real(rk) :: nu2_y_4, m3_3, t37, t38, neg_h3_x, h3_y, t39, t40, t41, t42, t43, k3_xx, k3_yy
    real(rk) :: k3_xy, t44, t45, k3_xz, k3_yz, m2_3, t46, nu2_y_5, t47, m2_2, k2_xx, k2_yz, m1_1
    real(rk) :: t48, w2_x, w2_y, neg_a2_x, neg_a2_y, alpha2_x, neg_alpha2_y, ww2_xy, ww2_xx, ww2_yy
    real(rk) :: ww2_zz, neg_lam2_11, neg_lam2_22, neg_lam2_33, a3_z, w3_x, w3_y, t49, t50, a3_x
    real(rk) :: a3_y, alpha3_x, alpha3_y, w3_z, ww3_yz, ww3_zx, ww3_xy, ww3_xx, ww3_yy, ww3_zz
    real(rk) :: neg_lam3_11, lam3_12, lam3_13, lam3_21, neg_lam3_22, lam3_23, neg_lam3_31, lam3_32
    real(rk) :: neg_lam3_33, w4_x, w4_y, a4_x, a4_y, alpha4_x, alpha4_y, w4_z, ww4_yz, ww4_zx
    real(rk) :: ww4_xy, ww4_xx, ww4_yy, ww4_zz, neg_lam4_11, lam4_12, lam4_13, lam4_21, neg_lam4_22
    real(rk) :: lam4_23, lam4_31, lam4_32, neg_lam4_33, a5_z, w5_x, w5_y, t51, t52, a5_x, a5_y
    real(rk) :: alpha5_x, alpha5_y, w5_z, ww5_yz, ww5_zx, ww5_xy, ww5_xx, ww5_yy, ww5_zz
    real(rk) :: neg_lam5_11, lam5_12, lam5_13, lam5_21, neg_lam5_22, lam5_23, lam5_31, lam5_32
    real(rk) :: neg_lam5_33, w6_x, t53, w6_y, a6_x, a6_y, alpha6_x, alpha6_y, w6_z, ww6_yz, ww6_zx
    real(rk) :: ww6_xy, ww6_xx, ww6_yy, ww6_zz, neg_lam6_11, lam6_12, lam6_13, lam6_21, neg_lam6_22
    real(rk) :: lam6_23, lam6_31, lam6_32, neg_lam6_33, a7_z, w7_x, w7_y, t54, t55, a7_x, a7_y
    real(rk) :: alpha7_x, alpha7_y, w7_z, ww7_yz, ww7_zx, ww7_xy, ww7_xx, ww7_yy, ww7_zz
    real(rk) :: neg_lam7_11, lam7_12, lam7_13, lam7_21, neg_lam7_22, lam7_23, lam7_31, lam7_32
    real(rk) :: neg_lam7_33, nc2_x, nc2_y, nc2_z, fc3_x, fc3_y, neg_nc3_x, nc3_y, t56, neg_nc3_z
    real(rk) :: fc4_x, fc4_y, fc4_z, neg_nc4_x, nc4_y, t57, neg_nc4_z, fc5_x, fc5_y, fc5_z, nc5_x
    real(rk) :: nc5_y, t58, nc5_z, fc6_x, fc6_y, fc6_z, nc6_x, nc6_y, t59, nc6_z, fc7_x, fc7_y
    real(rk) :: fc7_z, nc7_x, nc7_y, t60, nc7_z, f07_x, f07_y, n07_x, n07_y, n6_x, n6_y, n6_z, f6_x
    real(rk) :: f6_y, f6_z, f06_x, f06_y, n06_x, n06_y, n5_x, n5_y, n5_z, f5_x, f5_y, f5_z, f05_x
    real(rk) :: f05_y, n05_x, n05_y, n4_x, n4_y, neg_n4_z, f4_x, f4_y, f4_z, f04_x, n04_x, n04_y
    real(rk) :: n3_x, n3_y, n3_z, f3_x, f3_y, f03_x, f03_y, n03_x, n03_y, n2_x, n2_y, n2_z, n02_y
    real(rk) :: y1, neg_ipivot1, l2_1, l3_1, l4_1, l5_1, l6_1, l7_1, pivot2, ipivot2, ld3_2, l3_2
    real(rk) :: ld4_2, l4_2, ld5_2, l5_2, ld6_2, l6_2, ld7_2, l7_2, pivot3, ipivot3, ld4_3, l4_3
    real(rk) :: ld5_3, l5_3, ld6_3, l6_3, ld7_3, l7_3, pivot4, ipivot4, ld5_4, l5_4, ld6_4, l6_4
    real(rk) :: ld7_4, l7_4, pivot5, ipivot5, ld6_5, l6_5, ld7_5, l7_5, pivot6, ipivot6, ld7_6
    real(rk) :: l7_6, t61, pivot7, ipivot7, y2, y3, y4, y5, y6, t62, y7, qdd7, qdd6, qdd5, qdd4
    real(rk) :: qdd3, qdd2, t63, qdd1

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
    h7_x = 0.9999503996366931_rk*c7 - 0.708306797966195_rk*s7
    neg_h7_y = -0.708306797966195_rk*c7 - 0.9999503996366931_rk*s7
    t1 = c7*c7
    t2 = c7*s7
    ! link 7: second moment of the composite body [kg m^2]
    k7_xy = 0.2114247825686032_rk*(2.0_rk*t1 - 1.0_rk) - 0.10136935104159488_rk*t2
    k7_xz = 0.2024621683128357_rk*c7 - 0.061680050398747424_rk*s7
    k7_yz = 0.2024621683128357_rk*s7 + 0.061680050398747424_rk*c7
    ! link 6: mass matrix, its row of this joint
    neg_m6_7 = k7_yz - 0.126_rk*neg_h7_y
    ! link 6: force for a unit acceleration of a joint further out
    fu6_x = c6*neg_h7_y
    fu6_y = s6*neg_h7_y
    t3 = k7_xz + 0.126_rk*h7_x
    ! link 6: moment for a unit acceleration of a joint further out
    nu6_x = 0.48318719298539553_rk*s6 - c6*t3
    nu6_y = -0.48318719298539553_rk*c6 - s6*t3
    ! link 5: force for a unit acceleration of a joint further out
    fu5_x = c5*fu6_x - s5*h7_x
    fu5_y = s5*fu6_x + c5*h7_x
    ! link 5: moment for a unit acceleration of a joint further out
    nu5_x = c5*nu6_x + s5*neg_m6_7
    neg_nu5_y = c5*neg_m6_7 - s5*nu6_x
    ! link 4: mass matrix, its row of this joint
    m4_7 = neg_nu5_y - 0.4_rk*fu5_x
    ! link 4: force for a unit acceleration of a joint further out
    fu4_x = c4*fu5_x + s4*fu6_y
    t4 = nu5_x - 0.4_rk*fu5_y
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_x = c4*t4 + s4*nu6_y
    nu4_y = s4*t4 - c4*nu6_y
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x = c3*fu4_x - s3*fu5_y
    fu3_y = s3*fu4_x + c3*fu5_y
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_x = c3*nu4_x + s3*m4_7
    nu3_y = s3*nu4_x - c3*m4_7
    ! link 2: mass matrix, its row of this joint
    m2_7 = nu3_y + 0.4_rk*fu3_x
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y = s2*(nu3_x - 0.4_rk*fu3_y) - c2*nu4_y
    t5 = 0.10136935104159488_rk*t1 + 0.4228495651372064_rk*t2
    ! link 6: mass matrix, its row of this joint
    m6_6 = 2.745229884110378_rk - t5
    t6 = h7_x - 1.5656307599463828_rk
    ! link 6: first moment of the composite body, about the frame's origin [kg m]
    h6_x = c6*t6 + 1.291128497815195_rk*s6
    h6_y = s6*t6 - 1.291128497815195_rk*c6
    t7 = c6*c6
    t8 = t5 + 1.3126829026743974_rk
    t9 = t3 + 0.36144292274665746_rk
    t10 = c6*s6
    t11 = t7*t8 - t9*(2.0_rk*t10)
    ! link 6: second moment of the composite body [kg m^2]
    k6_yy = t11 - (t5 - 0.7162734907179903_rk)
    neg_k6_xy = t8*t10 - t9*(1.0_rk - 2.0_rk*t7)
    t12 = k7_xy - 0.042925575293549574_rk
    t13 = 0.0870114460092663_rk - neg_m6_7
    k6_xz = c6*t12 - s6*t13
    k6_yz = s6*t12 + c6*t13
    ! link 5: force for a unit acceleration of a joint further out
    neg_fu5_x = c5*h6_y
    t14 = -s5
    fu5_y_2 = t14*h6_y
    ! link 5: moment for a unit acceleration of a joint further out
    nu5_x_2 = t14*m6_6 - c5*k6_xz
    nu5_y = c5*m6_6 - s5*k6_xz
    ! link 4: mass matrix, its row of this joint
    m4_6 = 0.4_rk*neg_fu5_x - nu5_y
    ! link 4: force for a unit acceleration of a joint further out
    fu4_x_2 = s4*h6_x - c4*neg_fu5_x
    t15 = nu5_x_2 - 0.4_rk*fu5_y_2
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_x_2 = c4*t15 - s4*k6_yz
    nu4_y_2 = s4*t15 + c4*k6_yz
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x_2 = c3*fu4_x_2 - s3*fu5_y_2
    fu3_y_2 = s3*fu4_x_2 + c3*fu5_y_2
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_x_2 = c3*nu4_x_2 + s3*m4_6
    nu3_y_2 = s3*nu4_x_2 - c3*m4_6
    ! link 2: mass matrix, its row of this joint
    m2_6 = nu3_y_2 + 0.4_rk*fu3_x_2
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y_2 = s2*(nu3_x_2 - 0.4_rk*fu3_y_2) - c2*nu4_y_2
    ! link 5: mass matrix, its row of this joint
    m5_5 = t5 - t11 + 2.521169842515734_rk
    t16 = h6_x - 0.25252954507510866_rk
    t17 = 0.4193059538543958_rk - neg_h7_y
    ! link 5: first moment of the composite body, about the frame's origin [kg m]
    h5_x = c5*t16 - s5*t17
    h5_y = s5*t16 + c5*t17
    t18 = c5*c5
    t19 = t5 + t11 - 1.7262407198899914_rk
    t20 = 0.03284626166448073_rk - k6_xz
    t21 = c5*s5
    t22 = t18*t19 - t20*(2.0_rk*t21)
    ! link 5: second moment of the composite body [kg m^2]
    k5_xx = t5 + 0.39746456131287133_rk - t22
    k5_yy = t22 - (t11 - 2.1237052812028625_rk)
    neg_k5_xy = t19*t21 - t20*(1.0_rk - 2.0_rk*t18)
    t23 = neg_k6_xy - 0.041147842218669614_rk
    t24 = -k6_yz - 0.05680835589544868_rk
    k5_xz = c5*t23 - s5*t24
    k5_yz = s5*t23 + c5*t24
    ! link 4: mass matrix, its row of this joint
    m4_5 = k5_yz + 0.4_rk*h5_y
    t25 = -c4
    ! link 4: force for a unit acceleration of a joint further out
    fu4_x_3 = t25*h5_y
    t26 = k5_xz + 0.4_rk*h5_x
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_x_3 = -s4*m5_5 - c4*t26
    nu4_y_3 = c4*m5_5 - s4*t26
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x_3 = c3*fu4_x_3 - s3*h5_x
    fu3_y_3 = s3*fu4_x_3 + c3*h5_x
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_x_3 = c3*nu4_x_3 + s3*m4_5
    nu3_y_3 = s3*nu4_x_3 - c3*m4_5
    ! link 2: mass matrix, its row of this joint
    m2_5 = nu3_y_3 + 0.4_rk*fu3_x_3
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y_3 = s2*(nu3_x_3 - 0.4_rk*fu3_y_3) - c2*nu4_y_3
    t27 = 0.8_rk*h6_y - k6_yy
    ! link 4: mass matrix, its row of this joint
    m4_4 = k5_xx - t27 + 3.818015113559988_rk
    t28 = h5_x - 0.5168019281781282_rk
    t29 = h6_y - 8.054835434921454_rk
    ! link 4: first moment of the composite body, about the frame's origin [kg m]
    h4_x = c4*t28 + s4*t29
    h4_y = s4*t28 - c4*t29
    t30 = c4*c4
    t31 = k5_xx + t27 - 3.3209668850667637_rk
    t32 = t26 - 0.20921122087079386_rk
    t33 = c4*s4
    t34 = t30*t31 - t32*(2.0_rk*t33)
    ! link 4: second moment of the composite body [kg m^2]
    k4_xx = t34 - (t27 - 3.569490999313376_rk)
    k4_yy = k5_xx + 0.24852411424661205_rk - t34
    k4_xy = t31*t33 - t32*(1.0_rk - 2.0_rk*t30)
    t35 = neg_k5_xy - 0.013124222729483126_rk
    t36 = m4_5 - 0.09675036990607108_rk
    k4_xz = c4*t35 + s4*t36
    k4_yz = s4*t35 - c4*t36
    ! link 3: force for a unit acceleration of a joint further out
    neg_fu3_x = c3*h4_y
    neg_fu3_y = s3*h4_y
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_x_4 = s3*m4_4 - c3*k4_xz
    neg_nu3_y = s3*k4_xz + c3*m4_4
    ! link 2: mass matrix, its row of this joint
    m2_4 = -0.4_rk*neg_fu3_x - neg_nu3_y
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y_4 = s2*(nu3_x_4 + 0.4_rk*neg_fu3_y) + c2*k4_yz
    ! link 3: mass matrix, its row of this joint
    m3_3 = k5_yy + k4_xx + 0.6544886050552213_rk
    t37 = h5_y - 0.04389618410240257_rk
    t38 = h4_x - 1.0168650139155704_rk
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    neg_h3_x = s3*t37 - c3*t38
    h3_y = s3*t38 + c3*t37
    t39 = c3*c3
    t40 = k4_xx - k5_yy - 0.2506667841125447_rk
    t41 = k4_xz + 0.1005265342798281_rk
    t42 = c3*s3
    t43 = t39*t40 + t41*(2.0_rk*t42)
    ! link 3: second moment of the composite body [kg m^2]
    k3_xx = k5_yy + 0.45257769458388303_rk + t43
    k3_yy = k4_xx + 0.20191091047133833_rk - t43
    k3_xy = t40*t42 + t41*(1.0_rk - 2.0_rk*t39)
    t44 = k4_xy + 0.16230144331072144_rk
    t45 = k4_yz + 0.06405373385272267_rk
    k3_xz = c3*t44 + s3*t45
    k3_yz = s3*t44 - c3*t45
    ! link 2: mass matrix, its row of this joint
    m2_3 = -0.4_rk*h3_y - k3_yz
    t46 = 0.4_rk*neg_h3_x - k3_xz
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y_5 = s2*t46 - c2*m3_3
    t47 = k4_yy + 0.8_rk*h4_y
    ! link 2: mass matrix, its row of this joint
    m2_2 = k3_xx + t47 + 4.764988720880306_rk
    ! link 2: second moment of the composite body [kg m^2]
    k2_xx = t47 + 4.238401785575742_rk - (c2*c2*(t47 - k3_xx + 3.711814850271177_rk) - &
        (0.5218524991029152_rk - t46)*(2.0_rk*(c2*s2)))
    k2_yz = s2*(k3_xy - 0.20091837135316784_rk) + c2*(m2_3 + 0.26458063578324464_rk)
    ! link 1: mass matrix, its row of this joint
    m1_1 = k3_yy + k2_xx + 0.8058116303302202_rk
    t48 = -qd(1)
    ! link 2: angular velocity [rad/s]
    w2_x = t48*s2
    w2_y = t48*c2
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
    a3_z = neg_a2_y - 0.4_rk*neg_lam2_22
    ! link 3: angular velocity [rad/s]
    w3_x = c3*w2_x + qd(2)*s3
    w3_y = qd(2)*c3 - s3*w2_x
    t49 = -0.8_rk*alpha2_x
    t50 = neg_a2_x + 0.4_rk*ww2_xy
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_x = s3*t49 - c3*t50
    a3_y = s3*t50 + c3*t49
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
    neg_lam3_31 = alpha3_y - ww3_zx
    lam3_32 = alpha3_x + ww3_yz
    neg_lam3_33 = ww3_xx + ww3_yy
    ! link 4: angular velocity [rad/s]
    w4_x = c4*w3_x + s4*w3_z
    w4_y = c4*w3_z - s4*w3_x
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_x = c4*a3_x + s4*a3_z
    a4_y = c4*a3_z - s4*a3_x
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = qd(4)*w4_y - (t25*alpha3_x - s4*neg_alpha2_y)
    alpha4_y = c4*neg_alpha2_y - s4*alpha3_x - qd(4)*w4_x
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
    lam4_31 = ww4_zx - alpha4_y
    lam4_32 = alpha4_x + ww4_yz
    neg_lam4_33 = ww4_xx + ww4_yy
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_z = a4_y - 0.4_rk*neg_lam4_22
    ! link 5: angular velocity [rad/s]
    w5_x = c5*w4_x - s5*w4_z
    w5_y = -c5*w4_z - s5*w4_x
    t51 = a3_y - 0.4_rk*lam4_32
    t52 = -0.4_rk*lam4_12 - a4_x
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_x = s5*t51 - c5*t52
    a5_y = s5*t52 + c5*t51
    ! link 5: angular acceleration [rad/s^2]
    alpha5_x = qd(5)*w5_y - (t14*alpha3_y - c5*alpha4_x)
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
    lam5_31 = ww5_zx - alpha5_y
    lam5_32 = alpha5_x + ww5_yz
    neg_lam5_33 = ww5_xx + ww5_yy
    ! link 6: angular velocity [rad/s]
    w6_x = c6*w5_x - s6*w5_z
    t53 = -c6
    w6_y = t53*w5_z - s6*w5_x
    ! link 6: acceleration of the frame's origin, gravity taken off [m/s^2]
    a6_x = c6*a5_x - s6*a5_z
    a6_y = t53*a5_z - s6*a5_x
    ! link 6: angular acceleration [rad/s^2]
    alpha6_x = qd(6)*w6_y - (s6*alpha4_y - c6*alpha5_x)
    alpha6_y = t53*alpha4_y - s6*alpha5_x - qd(6)*w6_x
    ! link 6: angular velocity [rad/s]
    w6_z = qd(6) + w5_y
    ! link 6: products of the angular velocity [1/s^2]
    ww6_yz = w6_y*w6_z
    ww6_zx = w6_x*w6_z
    ww6_xy = w6_x*w6_y
    ww6_xx = w6_x*w6_x
    ww6_yy = w6_y*w6_y
    ww6_zz = w6_z*w6_z
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam6_11 = ww6_yy + ww6_zz
    lam6_12 = ww6_xy - alpha5_y
    lam6_13 = alpha6_y + ww6_zx
    lam6_21 = alpha5_y + ww6_xy
    neg_lam6_22 = ww6_xx + ww6_zz
    lam6_23 = ww6_yz - alpha6_x
    lam6_31 = ww6_zx - alpha6_y
    lam6_32 = alpha6_x + ww6_yz
    neg_lam6_33 = ww6_xx + ww6_yy
    ! link 7: acceleration of the frame's origin, gravity taken off [m/s^2]
    a7_z = -0.126_rk*neg_lam6_22 - a6_y
    ! link 7: angular velocity [rad/s]
    w7_x = c7*w6_x + s7*w6_z
    w7_y = c7*w6_z - s7*w6_x
    t54 = a5_y - 0.126_rk*lam6_32
    t55 = 0.126_rk*lam6_12 - a6_x
    ! link 7: acceleration of the frame's origin, gravity taken off [m/s^2]
    a7_x = s7*t54 - c7*t55
    a7_y = s7*t55 + c7*t54
    ! link 7: angular acceleration [rad/s^2]
    alpha7_x = qd(7)*w7_y - (-s7*alpha5_y - c7*alpha6_x)
    alpha7_y = c7*alpha5_y - s7*alpha6_x - qd(7)*w7_x
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
    lam7_31 = ww7_zx - alpha7_y
    lam7_32 = alpha7_x + ww7_yz
    neg_lam7_33 = ww7_xx + ww7_yy
    ! link 2: moment that turns the link [N m]
    nc2_x = 0.20091837135316784_rk*ww2_xy - 1.0437049982058304_rk*neg_alpha2_y - &
        (-8.476803571151484_rk*alpha2_x - 0.26458063578324464_rk*(neg_lam2_22 - neg_lam2_33))
    nc2_y = 0.20091837135316784_rk*(neg_lam2_11 - neg_lam2_33) - &
        1.0531738706091291_rk*neg_alpha2_y + (0.26458063578324464_rk*ww2_xy + &
        1.0437049982058304_rk*alpha2_x)
    nc2_z = 13.292379489096295_rk*c2 - 76.6738398539524_rk*s2 - (3.711814850271177_rk*ww2_xy + &
        0.5218524991029152_rk*(neg_lam2_11 - neg_lam2_22))
    ! link 3: force that moves the link [N]
    fc3_x = 1.0168650139155704_rk*neg_lam3_11 - 0.04389618410240257_rk*lam3_12
    fc3_y = 0.04389618410240257_rk*neg_lam3_22 - 1.0168650139155704_rk*lam3_21
    ! link 3: moment that turns the link [N m]
    neg_nc3_x = 0.06405373385272267_rk*(neg_lam3_22 - neg_lam3_33) - &
        0.45257769458388303_rk*lam3_32 - (0.1005265342798281_rk*neg_lam3_31 - &
        0.16230144331072144_rk*lam3_21) + 0.04389618410240257_rk*a3_z
    nc3_y = 0.20191091047133833_rk*neg_lam3_31 - 0.16230144331072144_rk*(neg_lam3_11 - &
        neg_lam3_33) - (0.06405373385272267_rk*lam3_12 - 0.1005265342798281_rk*lam3_32) + &
        1.0168650139155704_rk*a3_z
    t56 = 0.45257769458388303_rk*lam3_12 - 0.20191091047133833_rk*lam3_21 + &
        0.1005265342798281_rk*(neg_lam3_11 - neg_lam3_22) - (0.16230144331072144_rk*lam3_23 + &
        0.06405373385272267_rk*lam3_13)
    neg_nc3_z = t56 + (1.0168650139155704_rk*a3_y - 0.04389618410240257_rk*a3_x)
    ! link 4: force that moves the link [N]
    fc4_x = 0.5168019281781282_rk*neg_lam4_11 + 8.054835434921454_rk*lam4_12
    fc4_y = -8.054835434921454_rk*neg_lam4_22 - 0.5168019281781282_rk*lam4_21
    fc4_z = 8.054835434921454_rk*lam4_32 - 0.5168019281781282_rk*lam4_31
    ! link 4: moment that turns the link [N m]
    neg_nc4_x = -3.569490999313376_rk*lam4_32 - 0.09675036990607108_rk*(neg_lam4_22 - neg_lam4_33) &
        - (0.013124222729483126_rk*lam4_21 - 0.20921122087079386_rk*lam4_31) + &
        8.054835434921454_rk*a3_y
    nc4_y = 0.013124222729483126_rk*(neg_lam4_11 - neg_lam4_33) - 0.24852411424661205_rk*lam4_31 + &
        (0.09675036990607108_rk*lam4_12 + 0.20921122087079386_rk*lam4_32) - &
        0.5168019281781282_rk*a3_y
    t57 = 3.569490999313376_rk*lam4_12 - 0.24852411424661205_rk*lam4_21 + &
        0.20921122087079386_rk*(neg_lam4_11 - neg_lam4_22) + (0.013124222729483126_rk*lam4_23 + &
        0.09675036990607108_rk*lam4_13)
    neg_nc4_z = t57 + (0.5168019281781282_rk*a4_y + 8.054835434921454_rk*a4_x)
    ! link 5: force that moves the link [N]
    fc5_x = 0.25252954507510866_rk*neg_lam5_11 + 0.4193059538543958_rk*lam5_12
    fc5_y = -0.4193059538543958_rk*neg_lam5_22 - 0.25252954507510866_rk*lam5_21
    fc5_z = 0.4193059538543958_rk*lam5_32 - 0.25252954507510866_rk*lam5_31
    ! link 5: moment that turns the link [N m]
    nc5_x = 0.4193059538543958_rk*a5_z - (0.05680835589544868_rk*(neg_lam5_22 - neg_lam5_33) - &
        0.20655564034097101_rk*lam5_32 - (0.041147842218669614_rk*lam5_21 - &
        0.03284626166448073_rk*lam5_31))
    nc5_y = 0.041147842218669614_rk*(neg_lam5_11 - neg_lam5_33) - 0.09474888781047501_rk*lam5_31 + &
        (0.03284626166448073_rk*lam5_32 - 0.05680835589544868_rk*lam5_12) + &
        0.25252954507510866_rk*a5_z
    t58 = 0.09474888781047501_rk*lam5_21 - 0.20655564034097101_rk*lam5_12 - &
        0.03284626166448073_rk*(neg_lam5_11 - neg_lam5_22) - (0.041147842218669614_rk*lam5_23 - &
        0.05680835589544868_rk*lam5_13)
    nc5_z = t58 - (0.25252954507510866_rk*a5_y + 0.4193059538543958_rk*a5_x)
    ! link 6: force that moves the link [N]
    fc6_x = 1.5656307599463828_rk*neg_lam6_11 - 1.291128497815195_rk*lam6_12
    fc6_y = 1.291128497815195_rk*neg_lam6_22 - 1.5656307599463828_rk*lam6_21
    fc6_z = -1.5656307599463828_rk*lam6_31 - 1.291128497815195_rk*lam6_32
    ! link 6: moment that turns the link [N m]
    nc6_x = -1.291128497815195_rk*a5_y - (-2.0289563933923875_rk*lam6_32 - &
        0.0870114460092663_rk*(neg_lam6_22 - neg_lam6_33) - (0.042925575293549574_rk*lam6_21 - &
        0.36144292274665746_rk*lam6_31))
    nc6_y = 0.042925575293549574_rk*(neg_lam6_11 - neg_lam6_33) - 0.4239952187044951_rk*lam6_31 - &
        (-0.0870114460092663_rk*lam6_12 - 0.36144292274665746_rk*lam6_32) + &
        1.5656307599463828_rk*a5_y
    t59 = 0.4239952187044951_rk*lam6_21 - 2.0289563933923875_rk*lam6_12 - &
        0.36144292274665746_rk*(neg_lam6_11 - neg_lam6_22) - (0.042925575293549574_rk*lam6_23 + &
        0.0870114460092663_rk*lam6_13)
    nc6_z = t59 - (1.5656307599463828_rk*a6_y - 1.291128497815195_rk*a6_x)
    ! link 7: force that moves the link [N]
    fc7_x = 0.708306797966195_rk*lam7_12 - 0.9999503996366931_rk*neg_lam7_11
    fc7_y = 0.9999503996366931_rk*lam7_21 - 0.708306797966195_rk*neg_lam7_22
    fc7_z = 0.9999503996366931_rk*lam7_31 + 0.708306797966195_rk*lam7_32
    ! link 7: moment that turns the link [N m]
    nc7_x = 0.708306797966195_rk*a7_z - (-0.2922782720134952_rk*lam7_32 - &
        0.061680050398747424_rk*(neg_lam7_22 - neg_lam7_33) + (0.2024621683128357_rk*lam7_21 - &
        0.2114247825686032_rk*lam7_31))
    nc7_y = -0.19090892097190032_rk*lam7_31 - 0.2024621683128357_rk*(neg_lam7_11 - neg_lam7_33) + &
        (0.061680050398747424_rk*lam7_12 - 0.2114247825686032_rk*lam7_32) - &
        0.9999503996366931_rk*a7_z
    t60 = 0.2922782720134952_rk*lam7_12 - 0.19090892097190032_rk*lam7_21 - &
        0.2114247825686032_rk*(neg_lam7_11 - neg_lam7_22) - (0.2024621683128357_rk*lam7_23 - &
        0.061680050398747424_rk*lam7_13)
    nc7_z = 0.9999503996366931_rk*a7_y - 0.708306797966195_rk*a7_x - t60
    ! link 7: force through the joint, along the axes that its turn starts from [N]
    f07_x = c7*fc7_x - s7*fc7_y
    f07_y = s7*fc7_x + c7*fc7_y
    ! link 7: moment through the joint, along the axes that its turn starts from [N m]
    n07_x = c7*nc7_x - s7*nc7_y
    n07_y = s7*nc7_x + c7*nc7_y
    ! link 6: moment through the joint, about the frame's origin [N m]
    n6_x = n07_x + (nc6_x - 0.126_rk*f07_y)
    n6_y = nc6_y - nc7_z
    n6_z = n07_y + (nc6_z + 0.126_rk*f07_x)
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
    n5_y = nc5_y + n6_z
    n5_z = nc5_z - n06_y
    ! link 5: force through the joint [N]
    f5_x = fc5_x + f06_x
    f5_y = fc5_y + f6_z
    f5_z = fc5_z - f06_y
    ! link 5: force through the joint, along the axes that its turn starts from [N]
    f05_x = c5*f5_x - s5*f5_y
    f05_y = s5*f5_x + c5*f5_y
    ! link 5: moment through the joint, along the axes that its turn starts from [N m]
    n05_x = c5*n5_x - s5*n5_y
    n05_y = s5*n5_x + c5*n5_y
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = n05_x - (neg_nc4_x + 0.4_rk*f05_y)
    n4_y = nc4_y + n5_z
    neg_n4_z = n05_y + (neg_nc4_z + 0.4_rk*f05_x)
    ! link 4: force through the joint [N]
    f4_x = fc4_x + f05_x
    f4_y = fc4_y + f5_z
    f4_z = fc4_z - f05_y
    ! link 4: force through the joint, along the axes that its turn starts from [N]
    f04_x = c4*f4_x - s4*f4_y
    ! link 4: moment through the joint, along the axes that its turn starts from [N m]
    n04_x = c4*n4_x - s4*n4_y
    n04_y = s4*n4_x + c4*n4_y
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_x = n04_x - neg_nc3_x
    n3_y = nc3_y + neg_n4_z
    n3_z = n04_y - neg_nc3_z
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
    n2_x = n03_x - (0.4_rk*f03_y - nc2_x)
    n2_y = nc2_y - n3_z
    n2_z = n03_y + (nc2_z + 0.4_rk*f03_x)
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_y = s2*n2_x + c2*n2_y
    ! link 1: forward substitution
    y1 = tau(1) + n02_y
    ! factorisation M = L D L^T
    neg_ipivot1 = -1.0_rk / m1_1
    l2_1 = -k2_yz*neg_ipivot1
    l3_1 = nu2_y_5*neg_ipivot1
    l4_1 = nu2_y_4*neg_ipivot1
    l5_1 = nu2_y_3*neg_ipivot1
    l6_1 = nu2_y_2*neg_ipivot1
    l7_1 = nu2_y*neg_ipivot1
    pivot2 = m2_2 - k2_yz*l2_1
    ipivot2 = 1.0_rk / pivot2
    ld3_2 = m2_3 - k2_yz*l3_1
    l3_2 = ipivot2*ld3_2
    ld4_2 = m2_4 - k2_yz*l4_1
    l4_2 = ipivot2*ld4_2
    ld5_2 = m2_5 - k2_yz*l5_1
    l5_2 = ipivot2*ld5_2
    ld6_2 = m2_6 - k2_yz*l6_1
    l6_2 = ipivot2*ld6_2
    ld7_2 = m2_7 - k2_yz*l7_1
    l7_2 = ipivot2*ld7_2
    pivot3 = m3_3 + nu2_y_5*l3_1 - ld3_2*l3_2
    ipivot3 = 1.0_rk / pivot3
    ld4_3 = nu2_y_5*l4_1 - k4_yz - ld3_2*l4_2
    l4_3 = ipivot3*ld4_3
    ld5_3 = nu4_y_3 + nu2_y_5*l5_1 - ld3_2*l5_2
    l5_3 = ipivot3*ld5_3
    ld6_3 = nu4_y_2 + nu2_y_5*l6_1 - ld3_2*l6_2
    l6_3 = ipivot3*ld6_3
    ld7_3 = nu4_y + nu2_y_5*l7_1 - ld3_2*l7_2
    l7_3 = ipivot3*ld7_3
    pivot4 = m4_4 + nu2_y_4*l4_1 - ld4_2*l4_2 - ld4_3*l4_3
    ipivot4 = 1.0_rk / pivot4
    ld5_4 = m4_5 + nu2_y_4*l5_1 - ld4_2*l5_2 - ld4_3*l5_3
    l5_4 = ipivot4*ld5_4
    ld6_4 = -ld4_3*l6_3 - (ld4_2*l6_2 - (m4_6 + nu2_y_4*l6_1))
    l6_4 = ipivot4*ld6_4
    ld7_4 = m4_7 + nu2_y_4*l7_1 - ld4_2*l7_2 - ld4_3*l7_3
    l7_4 = ipivot4*ld7_4
    pivot5 = m5_5 + nu2_y_3*l5_1 - ld5_2*l5_2 - ld5_3*l5_3 - ld5_4*l5_4
    ipivot5 = 1.0_rk / pivot5
    ld6_5 = -ld5_3*l6_3 - (ld5_2*l6_2 - (k6_yz + nu2_y_3*l6_1)) - ld5_4*l6_4
    l6_5 = ipivot5*ld6_5
    ld7_5 = nu2_y_3*l7_1 - nu6_y - ld5_2*l7_2 - ld5_3*l7_3 - ld5_4*l7_4
    l7_5 = ipivot5*ld7_5
    pivot6 = -ld6_5*l6_5 - (ld6_2*l6_2 - (m6_6 + nu2_y_2*l6_1) + ld6_3*l6_3 + ld6_4*l6_4)
    ipivot6 = 1.0_rk / pivot6
    ld7_6 = -(ld6_2*l7_2 - (nu2_y_2*l7_1 - neg_m6_7) + ld6_3*l7_3 + ld6_4*l7_4) - ld6_5*l7_5
    l7_6 = ipivot6*ld7_6
    t61 = nu2_y*l7_1 + 0.48318719298539553_rk - ld7_2*l7_2 - ld7_3*l7_3 - ld7_4*l7_4 - ld7_5*l7_5
    pivot7 = t61 - ld7_6*l7_6
    ipivot7 = 1.0_rk / pivot7
    ! link 2: forward substitution
    y2 = tau(2) - n2_z - y1*l2_1
    ! link 3: forward substitution
    y3 = tau(3) - n3_z - y1*l3_1 - l3_2*y2
    ! link 4: forward substitution
    y4 = tau(4) + neg_n4_z - y1*l4_1 - l4_2*y2 - l4_3*y3
    ! link 5: forward substitution
    y5 = tau(5) - n5_z - y1*l5_1 - l5_2*y2 - l5_3*y3 - l5_4*y4
    ! link 6: forward substitution
    y6 = tau(6) - n6_z - y1*l6_1 - l6_2*y2 - l6_3*y3 - l6_4*y4 - l6_5*y5
    t62 = tau(7) - nc7_z - y1*l7_1 - l7_2*y2 - l7_3*y3 - l7_4*y4 - l7_5*y5
    ! link 7: forward substitution
    y7 = t62 - l7_6*y6
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
    t63 = y1*neg_ipivot1 + l2_1*qdd2 + l3_1*qdd3 + l4_1*qdd4 + l5_1*qdd5 + l6_1*qdd6
    ! link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd1 = -t63 - l7_1*qdd7
    qdd(1) = qdd1
    qdd(2) = qdd2
    qdd(3) = qdd3
    qdd(4) = qdd4
    qdd(5) = qdd5
    qdd(6) = qdd6
    qdd(7) = qdd7
  end subroutine
end module
