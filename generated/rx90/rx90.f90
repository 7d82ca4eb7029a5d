! rx90: Staubli RX90 geometry, random full inertias
! Numbers: published RX90 geometry; inertial parameters drawn at random
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
!   inverse_dynamics: 240 multiplications, 227 additions = 467; 3 unary minus; 10 sine/cosine
!   gravity: 42 multiplications, 25 additions = 67; 1 unary minus; 10 sine/cosine
!   bias: 227 multiplications, 198 additions = 425; 6 unary minus; 10 sine/cosine
!   mass_matrix: 125 multiplications, 108 additions = 233; 0 unary minus; 10 sine/cosine
!   forward_dynamics: 436 multiplications, 376 additions, 6 divisions = 818; 12 unary minus; 10
!       sine/cosine
module rx90_dynamics
  use, intrinsic :: iso_c_binding, only: rk => c_double
  implicit none
  private

  public :: rx90_inverse_dynamics
  public :: rx90_gravity
  public :: rx90_bias
  public :: rx90_mass_matrix
  public :: rx90_forward_dynamics

contains

  ! torques that give the accelerations qdd
  ! 240 multiplications, 227 additions = 467; 3 unary minus; 10 sine/cosine
  pure subroutine rx90_inverse_dynamics(q, qd, qdd, tau) &
      bind(c, name="rx90_inverse_dynamics_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(in) :: qdd(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: c2, s2, c4, s4, c5, s5, c6, s6, angle23, c23, s23, w3_z, alpha3_z, w2_x, w2_y
    real(rk) :: ww2_yz, ww2_zx, alpha2_x, alpha2_y, ww2_xy, ww2_xx, ww2_yy, ww2_zz, neg_lam2_11
    real(rk) :: lam2_12, lam2_13, lam2_21, neg_lam2_22, lam2_23, lam2_31, lam2_32, neg_lam2_33
    real(rk) :: w3_x, w3_y, t1, t2, t3, t4, neg_a3_x, a3_y, ww3_yz, ww3_zx, alpha3_x, alpha3_y
    real(rk) :: ww3_xy, ww3_xx, ww3_yy, ww3_zz, neg_lam3_11, lam3_12, lam3_13, lam3_21, neg_lam3_22
    real(rk) :: lam3_23, lam3_31, lam3_32, neg_lam3_33, a4_z, w4_x, w4_y, t5, t6, a4_x, a4_y
    real(rk) :: alpha4_x, neg_alpha4_y, alpha4_z, w4_z, ww4_yz, ww4_zx, ww4_xy, ww4_xx, ww4_yy
    real(rk) :: ww4_zz, neg_lam4_11, lam4_12, lam4_13, lam4_21, neg_lam4_22, lam4_23, lam4_31
    real(rk) :: lam4_32, neg_lam4_33, w5_x, w5_y, a5_x, a5_y, alpha5_x, neg_alpha5_y, alpha5_z
    real(rk) :: w5_z, ww5_yz, ww5_zx, ww5_xy, ww5_xx, ww5_yy, ww5_zz, neg_lam5_11, lam5_12, lam5_13
    real(rk) :: lam5_21, neg_lam5_22, lam5_23, lam5_31, lam5_32, neg_lam5_33, w6_x, w6_y, a6_x
    real(rk) :: a6_y, alpha6_x, neg_alpha6_y, alpha6_z, w6_z, ww6_yz, ww6_zx, ww6_xy, ww6_xx
    real(rk) :: ww6_yy, ww6_zz, neg_lam6_11, lam6_12, lam6_13, lam6_21, neg_lam6_22, neg_lam6_23
    real(rk) :: lam6_31, lam6_32, neg_lam6_33, nc1_z, nc2_x, nc2_y, t7, nc2_z, fc3_x, fc3_y, fc3_z
    real(rk) :: nc3_x, nc3_y, t8, nc3_z, fc4_x, fc4_y, fc4_z, nc4_x, nc4_y, t9, nc4_z, fc5_x, fc5_y
    real(rk) :: fc5_z, nc5_x, neg_nc5_y, t10, nc5_z, fc6_x, fc6_y, fc6_z, nc6_x, nc6_y, t11, nc6_z
    real(rk) :: f06_x, f06_y, n06_x, n06_y, n5_x, n5_y, n5_z, f5_x, f5_y, f5_z, f05_x, f05_y, n05_x
    real(rk) :: n05_y, n4_x, n4_y, n4_z, f4_x, f4_y, f4_z, f04_x, f04_y, n04_x, n04_y, n3_x, n3_y
    real(rk) :: n3_z, f3_x, f3_y, f3_z, f03_x, f03_y, n03_y, t12, n02_y, n02_z, n1_z

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
    ! link 2: angular velocity [rad/s]
    w2_x = qd(1)*s2
    w2_y = qd(1)*c2
    ! link 2: products of the angular velocity [1/s^2]
    ww2_yz = qd(2)*w2_y
    ww2_zx = qd(2)*w2_x
    ! link 2: angular acceleration [rad/s^2]
    alpha2_x = qdd(1)*s2 + ww2_yz
    alpha2_y = qdd(1)*c2 - ww2_zx
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
    lam2_31 = ww2_zx - alpha2_y
    lam2_32 = ww2_yz + alpha2_x
    neg_lam2_33 = ww2_xx + ww2_yy
    ! link 3: angular velocity [rad/s]
    w3_x = qd(1)*s23
    w3_y = qd(1)*c23
    t1 = 0.45_rk*neg_lam2_11
    t2 = 0.45_rk*lam2_21
    t3 = c2*t1 + s2*t2
    t4 = s2*t1 - c2*t2 - 9.8_rk
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a3_x = c23*t3 + s23*t4
    a3_y = s23*t3 - c23*t4
    ! link 3: products of the angular velocity [1/s^2]
    ww3_yz = w3_z*w3_y
    ww3_zx = w3_z*w3_x
    ! link 3: angular acceleration [rad/s^2]
    alpha3_x = qdd(1)*s23 + ww3_yz
    alpha3_y = qdd(1)*c23 - ww3_zx
    ! link 3: products of the angular velocity [1/s^2]
    ww3_xy = w3_x*w3_y
    ww3_xx = w3_x*w3_x
    ww3_yy = w3_y*w3_y
    ww3_zz = w3_z*w3_z
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_11 = ww3_yy + ww3_zz
    lam3_12 = ww3_xy - alpha3_z
    lam3_13 = ww3_zx + alpha3_y
    lam3_21 = alpha3_z + ww3_xy
    neg_lam3_22 = ww3_xx + ww3_zz
    lam3_23 = ww3_yz - alpha3_x
    lam3_31 = ww3_zx - alpha3_y
    lam3_32 = ww3_yz + alpha3_x
    neg_lam3_33 = ww3_xx + ww3_yy
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_z = a3_y - 0.45_rk*neg_lam3_22
    ! link 4: angular velocity [rad/s]
    w4_x = c4*w3_x - s4*w3_z
    w4_y = -c4*w3_z - s4*w3_x
    t5 = 0.45_rk*(lam2_31 + lam3_32)
    t6 = neg_a3_x - 0.45_rk*lam3_12
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_x = -s4*t5 - c4*t6
    a4_y = s4*t6 - c4*t5
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = c4*alpha3_x - s4*alpha3_z + qd(4)*w4_y
    neg_alpha4_y = s4*alpha3_x + c4*alpha3_z + qd(4)*w4_x
    alpha4_z = qdd(4) + alpha3_y
    ! link 4: angular velocity [rad/s]
    w4_z = qd(4) + w3_y
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
    lam4_23 = ww4_yz - alpha4_x
    lam4_31 = neg_alpha4_y + ww4_zx
    lam4_32 = alpha4_x + ww4_yz
    neg_lam4_33 = ww4_xx + ww4_yy
    ! link 5: angular velocity [rad/s]
    w5_x = c5*w4_x + s5*w4_z
    w5_y = c5*w4_z - s5*w4_x
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_x = c5*a4_x + s5*a4_z
    a5_y = c5*a4_z - s5*a4_x
    ! link 5: angular acceleration [rad/s^2]
    alpha5_x = c5*alpha4_x + s5*alpha4_z + qd(5)*w5_y
    neg_alpha5_y = s5*alpha4_x - c5*alpha4_z + qd(5)*w5_x
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
    lam5_13 = ww5_zx - neg_alpha5_y
    lam5_21 = alpha5_z + ww5_xy
    neg_lam5_22 = ww5_xx + ww5_zz
    lam5_23 = ww5_yz - alpha5_x
    lam5_31 = neg_alpha5_y + ww5_zx
    lam5_32 = alpha5_x + ww5_yz
    neg_lam5_33 = ww5_xx + ww5_yy
    ! link 6: angular velocity [rad/s]
    w6_x = c6*w5_x - s6*w5_z
    w6_y = -c6*w5_z - s6*w5_x
    ! link 6: acceleration of the frame's origin, gravity taken off [m/s^2]
    a6_x = c6*a5_x + s6*a4_y
    a6_y = c6*a4_y - s6*a5_x
    ! link 6: angular acceleration [rad/s^2]
    alpha6_x = c6*alpha5_x - s6*alpha5_z + qd(6)*w6_y
    neg_alpha6_y = s6*alpha5_x + c6*alpha5_z + qd(6)*w6_x
    alpha6_z = qdd(6) - neg_alpha5_y
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
    lam6_13 = ww6_zx - neg_alpha6_y
    lam6_21 = alpha6_z + ww6_xy
    neg_lam6_22 = ww6_xx + ww6_zz
    neg_lam6_23 = alpha6_x - ww6_yz
    lam6_31 = neg_alpha6_y + ww6_zx
    lam6_32 = alpha6_x + ww6_yz
    neg_lam6_33 = ww6_xx + ww6_yy
    ! link 1: moment that turns the link [N m]
    nc1_z = 0.6379688079078735_rk*qdd(1)
    ! link 2: moment that turns the link [N m]
    nc2_x = 0.5492245200976821_rk*lam2_32 + 0.09496171507178643_rk*(neg_lam2_22 - neg_lam2_33) + &
        (0.3355665158971724_rk*lam2_31 - 0.017315109477737248_rk*lam2_21)
    nc2_y = 0.09496171507178643_rk*lam2_12 - 0.3355665158971724_rk*lam2_32 - &
        (4.645960113642152_rk*lam2_31 + 0.017315109477737248_rk*(neg_lam2_11 - neg_lam2_33))
    t7 = 4.645960113642152_rk*lam2_21 - 0.5492245200976821_rk*lam2_12 + &
        0.3355665158971724_rk*(neg_lam2_11 - neg_lam2_22) + (0.017315109477737248_rk*lam2_23 - &
        0.09496171507178643_rk*lam2_13)
    nc2_z = t7 + (81.05525857884084_rk*c2 + 17.30463777489202_rk*s2)
    ! link 3: force that moves the link [N]
    fc3_x = 0.4001573159217507_rk*neg_lam3_11 + 9.392800548482231_rk*lam3_12
    fc3_y = -9.392800548482231_rk*neg_lam3_22 - 0.4001573159217507_rk*lam3_21
    fc3_z = 9.392800548482231_rk*lam3_32 - 0.4001573159217507_rk*lam3_31
    ! link 3: moment that turns the link [N m]
    nc3_x = 5.396088354585412_rk*lam3_32 + 0.0672049454639226_rk*(neg_lam3_22 - neg_lam3_33) + &
        (0.06558551272001446_rk*lam3_31 - 0.1093030288471206_rk*lam3_21) + &
        4.226760246817004_rk*lam2_31
    nc3_y = 0.1800707921647878_rk*lam2_31 - (0.19252101484679798_rk*lam3_31 + &
        0.1093030288471206_rk*(neg_lam3_11 - neg_lam3_33) + (0.06558551272001446_rk*lam3_32 - &
        0.0672049454639226_rk*lam3_12))
    t8 = 0.19252101484679798_rk*lam3_21 - 5.396088354585412_rk*lam3_12 + &
        0.06558551272001446_rk*(neg_lam3_11 - neg_lam3_22) + (0.1093030288471206_rk*lam3_23 - &
        0.0672049454639226_rk*lam3_13)
    nc3_z = t8 - (0.4001573159217507_rk*a3_y - 9.392800548482231_rk*neg_a3_x)
    ! link 4: force that moves the link [N]
    fc4_x = 1.0765039731522932_rk*lam4_12 - 0.21759393385311085_rk*neg_lam4_11
    fc4_y = 0.21759393385311085_rk*lam4_21 - 1.0765039731522932_rk*neg_lam4_22
    fc4_z = 0.21759393385311085_rk*lam4_31 + 1.0765039731522932_rk*lam4_32
    ! link 4: moment that turns the link [N m]
    nc4_x = 0.7570061710726514_rk*lam4_32 + 0.02981305527252843_rk*(neg_lam4_22 - neg_lam4_33) + &
        (0.09181695932507075_rk*lam4_31 - 0.1094831940191231_rk*lam4_21) + &
        1.0765039731522932_rk*a4_z
    nc4_y = -0.21759393385311085_rk*a4_z - (0.1886810537096668_rk*lam4_31 + &
        0.1094831940191231_rk*(neg_lam4_11 - neg_lam4_33) + (0.09181695932507075_rk*lam4_32 - &
        0.02981305527252843_rk*lam4_12))
    t9 = 0.1886810537096668_rk*lam4_21 - 0.7570061710726514_rk*lam4_12 + &
        0.09181695932507075_rk*(neg_lam4_11 - neg_lam4_22) - (0.02981305527252843_rk*lam4_13 - &
        0.1094831940191231_rk*lam4_23)
    nc4_z = t9 + (0.21759393385311085_rk*a4_y - 1.0765039731522932_rk*a4_x)
    ! link 5: force that moves the link [N]
    fc5_x = 0.8974188745594792_rk*neg_lam5_11 + 0.8067444135457743_rk*lam5_12
    fc5_y = -0.8067444135457743_rk*neg_lam5_22 - 0.8974188745594792_rk*lam5_21
    fc5_z = 0.8067444135457743_rk*lam5_32 - 0.8974188745594792_rk*lam5_31
    ! link 5: moment that turns the link [N m]
    nc5_x = 0.09969734753381411_rk*lam5_32 + 0.06545842652927093_rk*(neg_lam5_22 - neg_lam5_33) - &
        (0.04994749004669093_rk*lam5_31 + 0.022422989561630666_rk*lam5_21) - &
        0.8067444135457743_rk*a4_y
    neg_nc5_y = 0.4973859781056681_rk*lam5_31 + 0.022422989561630666_rk*(neg_lam5_11 - &
        neg_lam5_33) + (-0.06545842652927093_rk*lam5_12 - 0.04994749004669093_rk*lam5_32) + &
        0.8974188745594792_rk*a4_y
    t10 = 0.4973859781056681_rk*lam5_21 - 0.09969734753381411_rk*lam5_12 - &
        0.04994749004669093_rk*(neg_lam5_11 - neg_lam5_22) - (0.06545842652927093_rk*lam5_13 - &
        0.022422989561630666_rk*lam5_23)
    nc5_z = t10 - (0.8974188745594792_rk*a5_y + 0.8067444135457743_rk*a5_x)
    ! link 6: force that moves the link [N]
    fc6_x = 1.5707678306756712_rk*neg_lam6_11 + 0.6271000643521031_rk*lam6_12
    fc6_y = -0.6271000643521031_rk*neg_lam6_22 - 1.5707678306756712_rk*lam6_21
    fc6_z = 0.6271000643521031_rk*lam6_32 - 1.5707678306756712_rk*lam6_31
    ! link 6: moment that turns the link [N m]
    nc6_x = 0.13354610634435332_rk*lam6_32 + 0.07096581179296485_rk*(neg_lam6_22 - neg_lam6_33) - &
        (0.13821978029399798_rk*lam6_31 - 0.1601275610650136_rk*lam6_21) + &
        0.6271000643521031_rk*a5_y
    nc6_y = 1.5707678306756712_rk*a5_y - (0.4436030328765257_rk*lam6_31 - &
        0.1601275610650136_rk*(neg_lam6_11 - neg_lam6_33) + (-0.07096581179296485_rk*lam6_12 - &
        0.13821978029399798_rk*lam6_32))
    t11 = 0.4436030328765257_rk*lam6_21 - 0.13354610634435332_rk*lam6_12 - &
        0.13821978029399798_rk*(neg_lam6_11 - neg_lam6_22) + (0.1601275610650136_rk*neg_lam6_23 - &
        0.07096581179296485_rk*lam6_13)
    nc6_z = t11 - (1.5707678306756712_rk*a6_y + 0.6271000643521031_rk*a6_x)
    ! link 6: force through the joint, along the axes that its turn starts from [N]
    f06_x = c6*fc6_x - s6*fc6_y
    f06_y = s6*fc6_x + c6*fc6_y
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    n06_x = c6*nc6_x - s6*nc6_y
    n06_y = s6*nc6_x + c6*nc6_y
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_x = nc5_x + n06_x
    n5_y = nc6_z - neg_nc5_y
    n5_z = nc5_z - n06_y
    ! link 5: force through the joint [N]
    f5_x = fc5_x + f06_x
    f5_y = fc5_y + fc6_z
    f5_z = fc5_z - f06_y
    ! link 5: force through the joint, along the axes that its turn starts from [N]
    f05_x = c5*f5_x - s5*f5_y
    f05_y = s5*f5_x + c5*f5_y
    ! link 5: moment through the joint, along the axes that its turn starts from [N m]
    n05_x = c5*n5_x - s5*n5_y
    n05_y = s5*n5_x + c5*n5_y
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = nc4_x + n05_x
    n4_y = nc4_y - n5_z
    n4_z = nc4_z + n05_y
    ! link 4: force through the joint [N]
    f4_x = fc4_x + f05_x
    f4_y = fc4_y - f5_z
    f4_z = fc4_z + f05_y
    ! link 4: force through the joint, along the axes that its turn starts from [N]
    f04_x = c4*f4_x - s4*f4_y
    f04_y = s4*f4_x + c4*f4_y
    ! link 4: moment through the joint, along the axes that its turn starts from [N m]
    n04_x = c4*n4_x - s4*n4_y
    n04_y = s4*n4_x + c4*n4_y
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_x = n04_x + (nc3_x - 0.45_rk*f04_y)
    n3_y = nc3_y + n4_z
    n3_z = nc3_z - 0.45_rk*f04_x - n04_y
    ! link 3: force through the joint [N]
    f3_x = fc3_x + f04_x
    f3_y = fc3_y + f4_z
    f3_z = fc3_z - f04_y
    ! link 3: force through the joint, along the axes that its turn starts from [N]
    f03_x = c23*f3_x - s23*f3_y
    f03_y = s23*f3_x + c23*f3_y
    ! link 3: moment through the joint, along the axes that its turn starts from [N m]
    n03_y = s23*n3_x + c23*n3_y
    t12 = 0.45_rk*c2
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_y = n03_y + (s2*nc2_x + c2*nc2_y - f3_z*t12)
    n02_z = n3_z + (nc2_z + (f03_y*t12 - f03_x*(0.45_rk*s2)))
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = nc1_z + n02_y
    tau(1) = n1_z
    tau(2) = n02_z
    tau(3) = n3_z
    tau(4) = n4_z
    tau(5) = n5_z
    tau(6) = nc6_z
  end subroutine

  ! torques that hold the arm at rest
  ! 42 multiplications, 25 additions = 67; 1 unary minus; 10 sine/cosine
  pure subroutine rx90_gravity(q, tau) &
      bind(c, name="rx90_gravity_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: c2, s2, c4, s4, c5, s5, c6, s6, angle23, c23, s23, a3_x, a3_y, a4_x, a4_y, a5_x
    real(rk) :: a5_y, a6_x, a6_y, nc2_z, nc3_z, nc4_x, nc4_y, nc4_z, neg_nc5_x, neg_nc5_y, nc5_z
    real(rk) :: nc6_x, nc6_y, nc6_z, n06_x, n06_y, n5_x, n5_y, n5_z, n05_x, n05_y, n4_x, n4_y, n4_z
    real(rk) :: n04_x, n04_y, n3_z, n03_y, n02_z

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
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_x = 9.8_rk*s23
    a3_y = 9.8_rk*c23
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_x = c4*a3_x
    a4_y = -s4*a3_x
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_x = c5*a4_x + s5*a3_y
    a5_y = c5*a3_y - s5*a4_x
    ! link 6: acceleration of the frame's origin, gravity taken off [m/s^2]
    a6_x = c6*a5_x + s6*a4_y
    a6_y = c6*a4_y - s6*a5_x
    ! link 2: moment that turns the link [N m]
    nc2_z = 81.05525857884084_rk*c2 + 17.30463777489202_rk*s2
    ! link 3: moment that turns the link [N m]
    nc3_z = -92.04944537512587_rk*s23 - 3.921541696033157_rk*c23
    ! link 4: moment that turns the link [N m]
    nc4_x = 10.549738936892474_rk*c23
    nc4_y = -2.1324205517604864_rk*c23
    nc4_z = 0.21759393385311085_rk*a4_y - 1.0765039731522932_rk*a4_x
    ! link 5: moment that turns the link [N m]
    neg_nc5_x = 0.8067444135457743_rk*a4_y
    neg_nc5_y = 0.8974188745594792_rk*a4_y
    nc5_z = -0.8974188745594792_rk*a5_y - 0.8067444135457743_rk*a5_x
    ! link 6: moment that turns the link [N m]
    nc6_x = 0.6271000643521031_rk*a5_y
    nc6_y = 1.5707678306756712_rk*a5_y
    nc6_z = -1.5707678306756712_rk*a6_y - 0.6271000643521031_rk*a6_x
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    n06_x = c6*nc6_x - s6*nc6_y
    n06_y = s6*nc6_x + c6*nc6_y
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_x = n06_x - neg_nc5_x
    n5_y = nc6_z - neg_nc5_y
    n5_z = nc5_z - n06_y
    ! link 5: moment through the joint, along the axes that its turn starts from [N m]
    n05_x = c5*n5_x - s5*n5_y
    n05_y = s5*n5_x + c5*n5_y
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = nc4_x + n05_x
    n4_y = nc4_y - n5_z
    n4_z = nc4_z + n05_y
    ! link 4: moment through the joint, along the axes that its turn starts from [N m]
    n04_x = c4*n4_x - s4*n4_y
    n04_y = s4*n4_x + c4*n4_y
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_z = nc3_z - n04_y
    ! link 3: moment through the joint, along the axes that its turn starts from [N m]
    n03_y = s23*n04_x + c23*n4_z
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_z = nc2_z + n3_z
    tau(1) = n03_y
    tau(2) = n02_z
    tau(3) = n3_z
    tau(4) = n4_z
    tau(5) = n5_z
    tau(6) = nc6_z
  end subroutine

  ! torques at zero acceleration: Coriolis, centrifugal, gravity, friction
  ! 227 multiplications, 198 additions = 425; 6 unary minus; 10 sine/cosine
  pure subroutine rx90_bias(q, qd, tau) &
      bind(c, name="rx90_bias_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: c2, s2, c4, s4, c5, s5, c6, s6, angle23, c23, s23, w3_z, w2_x, w2_y, alpha2_x
    real(rk) :: neg_alpha2_y, ww2_xy, ww2_xx, ww2_yy, ww2_zz, neg_lam2_11, neg_lam2_22, neg_lam2_33
    real(rk) :: w3_x, w3_y, t1, t2, t3, t4, neg_a3_x, a3_y, alpha3_x, alpha3_y, ww3_xy, ww3_xx
    real(rk) :: ww3_yy, ww3_zz, neg_lam3_11, neg_lam3_22, neg_lam3_33, a4_z, w4_x, w4_y, t5, t6
    real(rk) :: a4_x, a4_y, alpha4_x, alpha4_y, w4_z, ww4_yz, ww4_zx, ww4_xy, ww4_xx, ww4_yy
    real(rk) :: ww4_zz, neg_lam4_11, lam4_12, lam4_13, lam4_21, neg_lam4_22, lam4_23, lam4_31
    real(rk) :: lam4_32, neg_lam4_33, w5_x, w5_y, a5_x, a5_y, alpha5_x, neg_alpha5_y, w5_z, ww5_yz
    real(rk) :: ww5_zx, ww5_xy, ww5_xx, ww5_yy, ww5_zz, neg_lam5_11, lam5_12, lam5_13, lam5_21
    real(rk) :: neg_lam5_22, lam5_23, lam5_31, lam5_32, neg_lam5_33, w6_x, w6_y, neg_a6_x, a6_y
    real(rk) :: alpha6_x, neg_alpha6_y, w6_z, ww6_yz, ww6_zx, ww6_xy, ww6_xx, ww6_yy, ww6_zz
    real(rk) :: neg_lam6_11, lam6_12, lam6_13, lam6_21, neg_lam6_22, neg_lam6_23, lam6_31, lam6_32
    real(rk) :: neg_lam6_33, nc2_x, nc2_y, nc2_z, fc3_x, fc3_y, fc3_z, nc3_x, nc3_y, nc3_z, fc4_x
    real(rk) :: fc4_y, fc4_z, nc4_x, nc4_y, t7, nc4_z, fc5_x, fc5_y, fc5_z, nc5_x, neg_nc5_y, t8
    real(rk) :: nc5_z, fc6_x, fc6_y, fc6_z, nc6_x, nc6_y, t9, nc6_z, f06_x, f06_y, n06_x, n06_y
    real(rk) :: n5_x, n5_y, n5_z, f5_x, f5_y, f5_z, f05_x, f05_y, n05_x, n05_y, n4_x, n4_y, n4_z
    real(rk) :: f4_x, f4_y, f4_z, f04_x, f04_y, n04_x, n04_y, n3_x, n3_y, n3_z, f3_x, f3_y, f3_z
    real(rk) :: f03_x, f03_y, n03_y, t10, n02_y, n02_z

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
    ! link 2: angular velocity [rad/s]
    w2_x = qd(1)*s2
    w2_y = qd(1)*c2
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
    ! link 3: angular velocity [rad/s]
    w3_x = qd(1)*s23
    w3_y = qd(1)*c23
    t1 = 0.45_rk*neg_lam2_11
    t2 = 0.45_rk*ww2_xy
    t3 = c2*t1 + s2*t2
    t4 = s2*t1 - c2*t2 - 9.8_rk
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a3_x = c23*t3 + s23*t4
    a3_y = s23*t3 - c23*t4
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
    a4_z = a3_y - 0.45_rk*neg_lam3_22
    ! link 4: angular velocity [rad/s]
    w4_x = c4*w3_x - s4*w3_z
    w4_y = -c4*w3_z - s4*w3_x
    t5 = 0.9_rk*(neg_alpha2_y + alpha3_x)
    t6 = neg_a3_x - 0.45_rk*ww3_xy
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_x = -s4*t5 - c4*t6
    a4_y = s4*t6 - c4*t5
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = c4*alpha3_x + qd(4)*w4_y
    alpha4_y = -qd(4)*w4_x - s4*alpha3_x
    ! link 4: angular velocity [rad/s]
    w4_z = qd(4) + w3_y
    ! link 4: products of the angular velocity [1/s^2]
    ww4_yz = w4_y*w4_z
    ww4_zx = w4_x*w4_z
    ww4_xy = w4_x*w4_y
    ww4_xx = w4_x*w4_x
    ww4_yy = w4_y*w4_y
    ww4_zz = w4_z*w4_z
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam4_11 = ww4_yy + ww4_zz
    lam4_12 = ww4_xy - alpha3_y
    lam4_13 = alpha4_y + ww4_zx
    lam4_21 = alpha3_y + ww4_xy
    neg_lam4_22 = ww4_xx + ww4_zz
    lam4_23 = ww4_yz - alpha4_x
    lam4_31 = ww4_zx - alpha4_y
    lam4_32 = alpha4_x + ww4_yz
    neg_lam4_33 = ww4_xx + ww4_yy
    ! link 5: angular velocity [rad/s]
    w5_x = c5*w4_x + s5*w4_z
    w5_y = c5*w4_z - s5*w4_x
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_x = c5*a4_x + s5*a4_z
    a5_y = c5*a4_z - s5*a4_x
    ! link 5: angular acceleration [rad/s^2]
    alpha5_x = c5*alpha4_x + s5*alpha3_y + qd(5)*w5_y
    neg_alpha5_y = s5*alpha4_x - c5*alpha3_y + qd(5)*w5_x
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
    lam5_13 = ww5_zx - neg_alpha5_y
    lam5_21 = ww5_xy - alpha4_y
    neg_lam5_22 = ww5_xx + ww5_zz
    lam5_23 = ww5_yz - alpha5_x
    lam5_31 = neg_alpha5_y + ww5_zx
    lam5_32 = alpha5_x + ww5_yz
    neg_lam5_33 = ww5_xx + ww5_yy
    ! link 6: angular velocity [rad/s]
    w6_x = c6*w5_x - s6*w5_z
    w6_y = -c6*w5_z - s6*w5_x
    ! link 6: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a6_x = -s6*a4_y - c6*a5_x
    a6_y = c6*a4_y - s6*a5_x
    ! link 6: angular acceleration [rad/s^2]
    alpha6_x = c6*alpha5_x + s6*alpha4_y + qd(6)*w6_y
    neg_alpha6_y = s6*alpha5_x - c6*alpha4_y + qd(6)*w6_x
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
    lam6_12 = neg_alpha5_y + ww6_xy
    lam6_13 = ww6_zx - neg_alpha6_y
    lam6_21 = ww6_xy - neg_alpha5_y
    neg_lam6_22 = ww6_xx + ww6_zz
    neg_lam6_23 = alpha6_x - ww6_yz
    lam6_31 = neg_alpha6_y + ww6_zx
    lam6_32 = alpha6_x + ww6_yz
    neg_lam6_33 = ww6_xx + ww6_yy
    ! link 2: moment that turns the link [N m]
    nc2_x = 1.0984490401953642_rk*alpha2_x + 0.09496171507178643_rk*(neg_lam2_22 - neg_lam2_33) + &
        (0.6711330317943448_rk*neg_alpha2_y - 0.017315109477737248_rk*ww2_xy)
    nc2_y = 0.09496171507178643_rk*ww2_xy - 0.6711330317943448_rk*alpha2_x - &
        (9.291920227284304_rk*neg_alpha2_y + 0.017315109477737248_rk*(neg_lam2_11 - neg_lam2_33))
    nc2_z = 4.09673559354447_rk*ww2_xy + 0.3355665158971724_rk*(neg_lam2_11 - neg_lam2_22) + &
        (81.05525857884084_rk*c2 + 17.30463777489202_rk*s2)
    ! link 3: force that moves the link [N]
    fc3_x = 0.4001573159217507_rk*neg_lam3_11 + 9.392800548482231_rk*ww3_xy
    fc3_y = -9.392800548482231_rk*neg_lam3_22 - 0.4001573159217507_rk*ww3_xy
    fc3_z = 0.8003146318435014_rk*alpha3_y + 18.785601096964463_rk*alpha3_x
    ! link 3: moment that turns the link [N m]
    nc3_x = 10.792176709170825_rk*alpha3_x + 0.0672049454639226_rk*(neg_lam3_22 - neg_lam3_33) + &
        (-0.13117102544002893_rk*alpha3_y - 0.1093030288471206_rk*ww3_xy) + &
        8.453520493634008_rk*neg_alpha2_y
    nc3_y = 0.3601415843295756_rk*neg_alpha2_y - (0.1093030288471206_rk*(neg_lam3_11 - &
        neg_lam3_33) - 0.38504202969359597_rk*alpha3_y - (0.0672049454639226_rk*ww3_xy - &
        0.13117102544002893_rk*alpha3_x))
    nc3_z = 9.392800548482231_rk*neg_a3_x - 0.4001573159217507_rk*a3_y - &
        (5.203567339738615_rk*ww3_xy - 0.06558551272001446_rk*(neg_lam3_11 - neg_lam3_22))
    ! link 4: force that moves the link [N]
    fc4_x = 1.0765039731522932_rk*lam4_12 - 0.21759393385311085_rk*neg_lam4_11
    fc4_y = 0.21759393385311085_rk*lam4_21 - 1.0765039731522932_rk*neg_lam4_22
    fc4_z = 0.21759393385311085_rk*lam4_31 + 1.0765039731522932_rk*lam4_32
    ! link 4: moment that turns the link [N m]
    nc4_x = 0.7570061710726514_rk*lam4_32 + 0.02981305527252843_rk*(neg_lam4_22 - neg_lam4_33) + &
        (0.09181695932507075_rk*lam4_31 - 0.1094831940191231_rk*lam4_21) + &
        1.0765039731522932_rk*a4_z
    nc4_y = -0.21759393385311085_rk*a4_z - (0.1886810537096668_rk*lam4_31 + &
        0.1094831940191231_rk*(neg_lam4_11 - neg_lam4_33) - (0.02981305527252843_rk*lam4_12 - &
        0.09181695932507075_rk*lam4_32))
    t7 = 0.7570061710726514_rk*lam4_12 - 0.1886810537096668_rk*lam4_21 - &
        0.09181695932507075_rk*(neg_lam4_11 - neg_lam4_22) + (0.02981305527252843_rk*lam4_13 - &
        0.1094831940191231_rk*lam4_23)
    nc4_z = 0.21759393385311085_rk*a4_y - 1.0765039731522932_rk*a4_x - t7
    ! link 5: force that moves the link [N]
    fc5_x = 0.8974188745594792_rk*neg_lam5_11 + 0.8067444135457743_rk*lam5_12
    fc5_y = -0.8067444135457743_rk*neg_lam5_22 - 0.8974188745594792_rk*lam5_21
    fc5_z = 0.8067444135457743_rk*lam5_32 - 0.8974188745594792_rk*lam5_31
    ! link 5: moment that turns the link [N m]
    nc5_x = 0.09969734753381411_rk*lam5_32 + 0.06545842652927093_rk*(neg_lam5_22 - neg_lam5_33) - &
        (0.04994749004669093_rk*lam5_31 + 0.022422989561630666_rk*lam5_21) - &
        0.8067444135457743_rk*a4_y
    neg_nc5_y = 0.4973859781056681_rk*lam5_31 + 0.022422989561630666_rk*(neg_lam5_11 - &
        neg_lam5_33) + (-0.06545842652927093_rk*lam5_12 - 0.04994749004669093_rk*lam5_32) + &
        0.8974188745594792_rk*a4_y
    t8 = 0.4973859781056681_rk*lam5_21 - 0.09969734753381411_rk*lam5_12 - &
        0.04994749004669093_rk*(neg_lam5_11 - neg_lam5_22) - (0.06545842652927093_rk*lam5_13 - &
        0.022422989561630666_rk*lam5_23)
    nc5_z = t8 - (0.8974188745594792_rk*a5_y + 0.8067444135457743_rk*a5_x)
    ! link 6: force that moves the link [N]
    fc6_x = 1.5707678306756712_rk*neg_lam6_11 + 0.6271000643521031_rk*lam6_12
    fc6_y = -0.6271000643521031_rk*neg_lam6_22 - 1.5707678306756712_rk*lam6_21
    fc6_z = 0.6271000643521031_rk*lam6_32 - 1.5707678306756712_rk*lam6_31
    ! link 6: moment that turns the link [N m]
    nc6_x = 0.13354610634435332_rk*lam6_32 + 0.07096581179296485_rk*(neg_lam6_22 - neg_lam6_33) - &
        (0.13821978029399798_rk*lam6_31 - 0.1601275610650136_rk*lam6_21) + &
        0.6271000643521031_rk*a5_y
    nc6_y = 1.5707678306756712_rk*a5_y - (0.4436030328765257_rk*lam6_31 - &
        0.1601275610650136_rk*(neg_lam6_11 - neg_lam6_33) - (0.07096581179296485_rk*lam6_12 + &
        0.13821978029399798_rk*lam6_32))
    t9 = 0.13354610634435332_rk*lam6_12 - 0.4436030328765257_rk*lam6_21 + &
        0.13821978029399798_rk*(neg_lam6_11 - neg_lam6_22) - (0.1601275610650136_rk*neg_lam6_23 - &
        0.07096581179296485_rk*lam6_13)
    nc6_z = 0.6271000643521031_rk*neg_a6_x - 1.5707678306756712_rk*a6_y - t9
    ! link 6: force through the joint, along the axes that its turn starts from [N]
    f06_x = c6*fc6_x - s6*fc6_y
    f06_y = s6*fc6_x + c6*fc6_y
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    n06_x = c6*nc6_x - s6*nc6_y
    n06_y = s6*nc6_x + c6*nc6_y
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_x = nc5_x + n06_x
    n5_y = nc6_z - neg_nc5_y
    n5_z = nc5_z - n06_y
    ! link 5: force through the joint [N]
    f5_x = fc5_x + f06_x
    f5_y = fc5_y + fc6_z
    f5_z = fc5_z - f06_y
    ! link 5: force through the joint, along the axes that its turn starts from [N]
    f05_x = c5*f5_x - s5*f5_y
    f05_y = s5*f5_x + c5*f5_y
    ! link 5: moment through the joint, along the axes that its turn starts from [N m]
    n05_x = c5*n5_x - s5*n5_y
    n05_y = s5*n5_x + c5*n5_y
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = nc4_x + n05_x
    n4_y = nc4_y - n5_z
    n4_z = nc4_z + n05_y
    ! link 4: force through the joint [N]
    f4_x = fc4_x + f05_x
    f4_y = fc4_y - f5_z
    f4_z = fc4_z + f05_y
    ! link 4: force through the joint, along the axes that its turn starts from [N]
    f04_x = c4*f4_x - s4*f4_y
    f04_y = s4*f4_x + c4*f4_y
    ! link 4: moment through the joint, along the axes that its turn starts from [N m]
    n04_x = c4*n4_x - s4*n4_y
    n04_y = s4*n4_x + c4*n4_y
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_x = n04_x + (nc3_x - 0.45_rk*f04_y)
    n3_y = nc3_y + n4_z
    n3_z = nc3_z - 0.45_rk*f04_x - n04_y
    ! link 3: force through the joint [N]
    f3_x = fc3_x + f04_x
    f3_y = fc3_y + f4_z
    f3_z = fc3_z - f04_y
    ! link 3: force through the joint, along the axes that its turn starts from [N]
    f03_x = c23*f3_x - s23*f3_y
    f03_y = s23*f3_x + c23*f3_y
    ! link 3: moment through the joint, along the axes that its turn starts from [N m]
    n03_y = s23*n3_x + c23*n3_y
    t10 = 0.45_rk*c2
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_y = n03_y + (s2*nc2_x + c2*nc2_y - f3_z*t10)
    n02_z = n3_z + (nc2_z + (f03_y*t10 - f03_x*(0.45_rk*s2)))
    tau(1) = n02_y
    tau(2) = n02_z
    tau(3) = n3_z
    tau(4) = n4_z
    tau(5) = n5_z
    tau(6) = nc6_z
  end subroutine

  ! mass matrix, rotor inertias on its diagonal
  ! 125 multiplications, 108 additions = 233; 0 unary minus; 10 sine/cosine
  pure subroutine rx90_mass_matrix(q, M) &
      bind(c, name="rx90_mass_matrix_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(out) :: M(36)
    real(rk) :: c2, s2, c4, s4, c5, s5, c6, s6, angle23, c23, s23, neg_h6_x, neg_h6_y, t1, t2
    real(rk) :: k6_xy, neg_k6_xz, k6_yz, fu5_x, fu5_y, nu5_x, nu5_y, fu4_x, fu4_y, nu4_x, nu4_y
    real(rk) :: m3_6, fu3_x, fu3_y, nu3_y, t3, nu2_y, t4, m2_6, t5, m5_5, t6, neg_h5_x, neg_h5_y
    real(rk) :: t7, t8, t9, t10, t11, k5_yy, k5_xy, t12, t13, neg_k5_xz, neg_k5_yz, fu4_x_2
    real(rk) :: fu4_y_2, nu4_x_2, nu4_y_2, m3_5, fu3_x_2, fu3_y_2, nu3_y_2, nu2_y_2, m2_5, m4_4
    real(rk) :: t14, t15, h4_x, neg_h4_y, t16, t17, t18, t19, t20, neg_k4_xx, k4_yy, k4_xy, t21
    real(rk) :: t22, k4_xz, k4_yz, m3_4, fu3_x_3, fu3_y_3, t23, nu3_y_3, nu2_y_3, m2_4, t24, m3_3
    real(rk) :: t25, t26, neg_h3_x, h3_y, t27, k3_xx, neg_k3_yy, neg_k3_yz, m2_3, t28, neg_k2_zz
    real(rk) :: t29, m2_2, k2_xx, neg_k2_yz, m1_1

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
    ! link 6: first moment of the composite body, about the frame's origin [kg m]
    neg_h6_x = 1.5707678306756712_rk*c6 + 0.6271000643521031_rk*s6
    neg_h6_y = 1.5707678306756712_rk*s6 - 0.6271000643521031_rk*c6
    t1 = c6*s6
    t2 = c6*c6
    ! link 6: second moment of the composite body [kg m^2]
    k6_xy = 0.31005692653217237_rk*t1 - 0.13821978029399798_rk*(2.0_rk*t2 - 1.0_rk)
    neg_k6_xz = 0.1601275610650136_rk*c6 + 0.07096581179296485_rk*s6
    k6_yz = 0.07096581179296485_rk*c6 - 0.1601275610650136_rk*s6
    ! link 5: force for a unit acceleration of a joint further out
    fu5_x = c5*neg_h6_y
    fu5_y = s5*neg_h6_y
    ! link 5: moment for a unit acceleration of a joint further out
    nu5_x = c5*neg_k6_xz - 0.5771491392208791_rk*s5
    nu5_y = s5*neg_k6_xz + 0.5771491392208791_rk*c5
    ! link 4: force for a unit acceleration of a joint further out
    fu4_x = c4*fu5_x + s4*neg_h6_x
    fu4_y = s4*fu5_x - c4*neg_h6_x
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_x = c4*nu5_x + s4*k6_yz
    nu4_y = s4*nu5_x - c4*k6_yz
    ! link 3: mass matrix, its row of this joint
    m3_6 = -0.45_rk*fu4_x - nu4_y
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x = c23*fu4_x - s23*fu5_y
    fu3_y = s23*fu4_x + c23*fu5_y
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_y = s23*(nu4_x - 0.45_rk*fu4_y) + c23*nu5_y
    t3 = 0.45_rk*c2
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y = nu3_y + t3*fu4_y
    t4 = 0.45_rk*s2
    ! link 2: mass matrix, its row of this joint
    m2_6 = m3_6 + (t3*fu3_y - t4*fu3_x)
    t5 = 0.31005692653217237_rk*t2 + 0.27643956058799596_rk*t1
    ! link 5: mass matrix, its row of this joint
    m5_5 = t5 + 0.7306294319838356_rk
    t6 = neg_h6_x + 0.8974188745594792_rk
    ! link 5: first moment of the composite body, about the frame's origin [kg m]
    neg_h5_x = c5*t6 + 0.8067444135457743_rk*s5
    neg_h5_y = s5*t6 - 0.8067444135457743_rk*c5
    t7 = c5*c5
    t8 = t5 + 0.5312347369162073_rk
    t9 = neg_k6_xz + 0.04994749004669093_rk
    t10 = c5*s5
    t11 = t7*t8 + t9*(2.0_rk*t10)
    ! link 5: second moment of the composite body [kg m^2]
    k5_yy = t5 + 0.6309320844500215_rk - t11
    k5_xy = t8*t10 + t9*(1.0_rk - 2.0_rk*t7)
    t12 = k6_xy - 0.022422989561630666_rk
    t13 = 0.06545842652927093_rk - k6_yz
    neg_k5_xz = c5*t12 + s5*t13
    neg_k5_yz = s5*t12 - c5*t13
    ! link 4: force for a unit acceleration of a joint further out
    fu4_x_2 = c4*neg_h5_y
    fu4_y_2 = s4*neg_h5_y
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_x_2 = c4*neg_k5_xz + s4*m5_5
    nu4_y_2 = s4*neg_k5_xz - c4*m5_5
    ! link 3: mass matrix, its row of this joint
    m3_5 = -0.45_rk*fu4_x_2 - nu4_y_2
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x_2 = c23*fu4_x_2 + s23*neg_h5_x
    fu3_y_2 = s23*fu4_x_2 - c23*neg_h5_x
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_y_2 = s23*(nu4_x_2 - 0.45_rk*fu4_y_2) + c23*neg_k5_yz
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y_2 = nu3_y_2 + t3*fu4_y_2
    ! link 2: mass matrix, its row of this joint
    m2_5 = m3_5 + (t3*fu3_y_2 - t4*fu3_x_2)
    ! link 4: mass matrix, its row of this joint
    m4_4 = 1.488987605192658_rk - (t5 - t11)
    t14 = neg_h6_y - 1.0765039731522932_rk
    t15 = neg_h5_x - 0.21759393385311085_rk
    ! link 4: first moment of the composite body, about the frame's origin [kg m]
    h4_x = s4*t14 - c4*t15
    neg_h4_y = s4*t15 + c4*t14
    t16 = c4*c4
    t17 = t5 + t11 - 0.9122308027056962_rk
    t18 = neg_k5_xz + 0.09181695932507075_rk
    t19 = c4*s4
    t20 = t16*t17 - t18*(2.0_rk*t19)
    ! link 4: second moment of the composite body [kg m^2]
    neg_k4_xx = t5 - 1.2006092039491771_rk - t20
    k4_yy = t11 + 0.2883784012434809_rk - t20
    k4_xy = t17*t19 - t18*(1.0_rk - 2.0_rk*t16)
    t21 = k5_xy + 0.1094831940191231_rk
    t22 = neg_k5_yz + 0.02981305527252843_rk
    k4_xz = c4*t21 - s4*t22
    k4_yz = s4*t21 + c4*t22
    ! link 3: mass matrix, its row of this joint
    m3_4 = k4_yz - 0.45_rk*neg_h4_y
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x_3 = c23*neg_h4_y
    fu3_y_3 = s23*neg_h4_y
    t23 = k4_xz + 0.45_rk*h4_x
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_y_3 = c23*m4_4 - s23*t23
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y_3 = nu3_y_3 + t3*h4_x
    ! link 2: mass matrix, its row of this joint
    m2_4 = m3_4 + (t3*fu3_y_3 - t4*fu3_x_3)
    t24 = k5_yy - 0.9_rk*neg_h5_y
    ! link 3: mass matrix, its row of this joint
    m3_3 = 5.588609369432211_rk - (neg_k4_xx - t24)
    t25 = 0.4001573159217507_rk - h4_x
    t26 = 9.392800548482231_rk - neg_h5_y
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    neg_h3_x = c23*t25 + s23*t26
    h3_y = c23*t26 - s23*t25
    t27 = c23*c23*(neg_k4_xx + t24 + 5.203567339738615_rk) + (t23 + &
        0.06558551272001446_rk)*(2.0_rk*(c23*s23))
    ! link 3: second moment of the composite body [kg m^2]
    k3_xx = t24 + 5.396088354585412_rk - t27
    neg_k3_yy = neg_k4_xx - 0.19252101484679798_rk - t27
    neg_k3_yz = s23*(k4_xy - 0.1093030288471206_rk) + c23*(m3_4 - 0.0672049454639226_rk)
    ! link 2: mass matrix, its row of this joint
    m2_3 = m3_3 + (t4*h3_y - t3*neg_h3_x)
    t28 = k4_yy + neg_k3_yy
    ! link 2: second moment of the composite body [kg m^2]
    neg_k2_zz = neg_k3_yy - t28
    t29 = k3_xx - t3*(2.0_rk*neg_h3_x)
    ! link 2: mass matrix, its row of this joint
    m2_2 = t29 + (k4_yy - t28 - t4*(-2.0_rk*h3_y)) + 5.195184633739834_rk
    ! link 2: second moment of the composite body [kg m^2]
    k2_xx = t29 + (4.09673559354447_rk*(c2*c2) - 0.6711330317943448_rk*(c2*s2) + &
        0.5492245200976821_rk)
    neg_k2_yz = neg_k3_yz - t4*neg_h4_y - (0.017315109477737248_rk*s2 + 0.09496171507178643_rk*c2)
    ! link 1: mass matrix, its row of this joint
    m1_1 = 0.6379688079078735_rk - (neg_k2_zz - k2_xx)
    M(1) = m1_1
    M(2) = neg_k2_yz
    M(3) = neg_k3_yz
    M(4) = nu2_y_3
    M(5) = nu2_y_2
    M(6) = nu2_y
    M(7) = neg_k2_yz
    M(8) = m2_2
    M(9) = m2_3
    M(10) = m2_4
    M(11) = m2_5
    M(12) = m2_6
    M(13) = neg_k3_yz
    M(14) = m2_3
    M(15) = m3_3
    M(16) = m3_4
    M(17) = m3_5
    M(18) = m3_6
    M(19) = nu2_y_3
    M(20) = m2_4
    M(21) = m3_4
    M(22) = m4_4
    M(23) = neg_k5_yz
    M(24) = nu5_y
    M(25) = nu2_y_2
    M(26) = m2_5
    M(27) = m3_5
    M(28) = neg_k5_yz
    M(29) = m5_5
    M(30) = k6_yz
    M(31) = nu2_y
    M(32) = m2_6
    M(33) = m3_6
    M(34) = nu5_y
    M(35) = k6_yz
    M(36) = 0.5771491392208791_rk
  end subroutine

  ! accelerations that the torques tau give
  ! 436 multiplications, 376 additions, 6 divisions = 818; 12 unary minus; 10 sine/cosine
  pure subroutine rx90_forward_dynamics(q, qd, tau, qdd) &
      bind(c, name="rx90_forward_dynamics_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(in) :: tau(6)
    real(rk), intent(out) :: qdd(6)
    real(rk) :: c2, s2, c4, s4, c5, s5, c6, s6, angle23, c23, s23, h6_x, neg_h6_y, t1, t2, k6_xy
    real(rk) :: k6_xz, k6_yz, fu5_x, fu5_y, nu5_x, nu5_y, fu4_x, fu4_y, nu4_x, nu4_y, neg_m3_6
    real(rk) :: fu3_x, fu3_y, nu3_y, t3, nu2_y, t4, m2_6, t5, m5_5, t6, h5_x, neg_h5_y, t7, t8, t9
    real(rk) :: t10, t11, k5_yy, k5_xy, t12, t13, k5_xz, k5_yz, fu4_x_2, fu4_y_2, nu4_x_2, t14
    real(rk) :: nu4_y_2, neg_m3_5, fu3_x_2, fu3_y_2, nu3_y_2, nu2_y_2, m2_5, m4_4, t15, t16, h4_x
    real(rk) :: neg_h4_y, t17, t18, t19, t20, t21, k4_xx, k4_yy, k4_xy, t22, t23, k4_xz, k4_yz
    real(rk) :: m3_4, fu3_x_3, fu3_y_3, t24, nu3_y_3, nu2_y_3, m2_4, t25, m3_3, t26, t27, h3_x
    real(rk) :: neg_h3_y, t28, k3_xx, k3_yy, k3_yz, m2_3, t29, k2_zz, t30, m2_2, k2_xx, k2_yz, m1_1
    real(rk) :: w3_z, w2_x, w2_y, alpha2_x, neg_alpha2_y, ww2_xy, ww2_xx, ww2_yy, ww2_zz
    real(rk) :: neg_lam2_11, neg_lam2_22, neg_lam2_33, w3_x, w3_y, t31, t32, t33, t34, neg_a3_x
    real(rk) :: a3_y, alpha3_x, alpha3_y, ww3_xy, ww3_xx, ww3_yy, ww3_zz, neg_lam3_11, neg_lam3_22
    real(rk) :: neg_lam3_33, a4_z, w4_x, w4_y, t35, t36, a4_x, a4_y, alpha4_x, alpha4_y, w4_z
    real(rk) :: ww4_yz, ww4_zx, ww4_xy, ww4_xx, ww4_yy, ww4_zz, neg_lam4_11, lam4_12, lam4_13
    real(rk) :: lam4_21, neg_lam4_22, lam4_23, lam4_31, lam4_32, neg_lam4_33, w5_x, w5_y, a5_x
    real(rk) :: a5_y, alpha5_x, neg_alpha5_y, w5_z, ww5_yz, ww5_zx, ww5_xy, ww5_xx, ww5_yy, ww5_zz
    real(rk) :: neg_lam5_11, lam5_12, lam5_13, lam5_21, neg_lam5_22, lam5_23, lam5_31, lam5_32
    real(rk) :: neg_lam5_33, w6_x, w6_y, a6_x, a6_y, alpha6_x, neg_alpha6_y, w6_z, ww6_yz, ww6_zx
    real(rk) :: ww6_xy, ww6_xx, ww6_yy, ww6_zz, neg_lam6_11, lam6_12, lam6_13, lam6_21, neg_lam6_22
    real(rk) :: neg_lam6_23, lam6_31, lam6_32, neg_lam6_33, nc2_x, nc2_y, nc2_z, fc3_x, fc3_y
    real(rk) :: fc3_z, nc3_x, nc3_y, nc3_z, fc4_x, fc4_y, fc4_z, nc4_x, nc4_y, t37, nc4_z, fc5_x
    real(rk) :: fc5_y, fc5_z, nc5_x, nc5_y, t38, nc5_z, fc6_x, fc6_y, fc6_z, nc6_x, nc6_y, t39
    real(rk) :: neg_nc6_z, f06_x, f06_y, n06_x, n06_y, n5_x, n5_y, n5_z, f5_x, f5_y, f5_z, f05_x
    real(rk) :: f05_y, n05_x, n05_y, n4_x, n4_y, n4_z, f4_x, f4_y, f4_z, f04_x, f04_y, n04_x, n04_y
    real(rk) :: n3_x, n3_y, n3_z, f3_x, f3_y, f3_z, f03_x, f03_y, n03_y, n02_y, n02_z, y1, ipivot1
    real(rk) :: l2_1, l3_1, l4_1, l5_1, l6_1, pivot2, ipivot2, ld3_2, l3_2, ld4_2, l4_2, ld5_2
    real(rk) :: l5_2, ld6_2, l6_2, pivot3, ipivot3, ld4_3, l4_3, ld5_3, l5_3, ld6_3, l6_3, pivot4
    real(rk) :: ipivot4, ld5_4, l5_4, ld6_4, l6_4, pivot5, ipivot5, ld6_5, l6_5, pivot6, ipivot6
    real(rk) :: y2, y3, y4, y5, y6, qdd6, qdd5, qdd4, qdd3, qdd2, t40, qdd1

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
    ! link 6: first moment of the composite body, about the frame's origin [kg m]
    h6_x = -0.6271000643521031_rk*s6 - 1.5707678306756712_rk*c6
    neg_h6_y = 1.5707678306756712_rk*s6 - 0.6271000643521031_rk*c6
    t1 = c6*s6
    t2 = c6*c6
    ! link 6: second moment of the composite body [kg m^2]
    k6_xy = 0.31005692653217237_rk*t1 - 0.13821978029399798_rk*(2.0_rk*t2 - 1.0_rk)
    k6_xz = -0.07096581179296485_rk*s6 - 0.1601275610650136_rk*c6
    k6_yz = 0.07096581179296485_rk*c6 - 0.1601275610650136_rk*s6
    ! link 5: force for a unit acceleration of a joint further out
    fu5_x = c5*neg_h6_y
    fu5_y = s5*neg_h6_y
    ! link 5: moment for a unit acceleration of a joint further out
    nu5_x = -0.5771491392208791_rk*s5 - c5*k6_xz
    nu5_y = 0.5771491392208791_rk*c5 - s5*k6_xz
    ! link 4: force for a unit acceleration of a joint further out
    fu4_x = c4*fu5_x - s4*h6_x
    fu4_y = s4*fu5_x + c4*h6_x
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_x = c4*nu5_x + s4*k6_yz
    nu4_y = s4*nu5_x - c4*k6_yz
    ! link 3: mass matrix, its row of this joint
    neg_m3_6 = nu4_y + 0.45_rk*fu4_x
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x = c23*fu4_x - s23*fu5_y
    fu3_y = s23*fu4_x + c23*fu5_y
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_y = s23*(nu4_x - 0.45_rk*fu4_y) + c23*nu5_y
    t3 = 0.45_rk*c2
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y = nu3_y + t3*fu4_y
    t4 = 0.45_rk*s2
    ! link 2: mass matrix, its row of this joint
    m2_6 = t3*fu3_y - t4*fu3_x - neg_m3_6
    t5 = 0.31005692653217237_rk*t2 + 0.27643956058799596_rk*t1
    ! link 5: mass matrix, its row of this joint
    m5_5 = t5 + 0.7306294319838356_rk
    t6 = 0.8974188745594792_rk - h6_x
    ! link 5: first moment of the composite body, about the frame's origin [kg m]
    h5_x = -0.8067444135457743_rk*s5 - c5*t6
    neg_h5_y = s5*t6 - 0.8067444135457743_rk*c5
    t7 = c5*c5
    t8 = t5 + 0.5312347369162073_rk
    t9 = 0.04994749004669093_rk - k6_xz
    t10 = c5*s5
    t11 = t7*t8 + t9*(2.0_rk*t10)
    ! link 5: second moment of the composite body [kg m^2]
    k5_yy = t5 + 0.6309320844500215_rk - t11
    k5_xy = t8*t10 + t9*(1.0_rk - 2.0_rk*t7)
    t12 = 0.022422989561630666_rk - k6_xy
    t13 = k6_yz - 0.06545842652927093_rk
    k5_xz = c5*t12 + s5*t13
    k5_yz = s5*t12 - c5*t13
    ! link 4: force for a unit acceleration of a joint further out
    fu4_x_2 = c4*neg_h5_y
    fu4_y_2 = s4*neg_h5_y
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_x_2 = s4*m5_5 - c4*k5_xz
    t14 = -c4
    nu4_y_2 = t14*m5_5 - s4*k5_xz
    ! link 3: mass matrix, its row of this joint
    neg_m3_5 = nu4_y_2 + 0.45_rk*fu4_x_2
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x_2 = c23*fu4_x_2 - s23*h5_x
    fu3_y_2 = s23*fu4_x_2 + c23*h5_x
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_y_2 = s23*(nu4_x_2 - 0.45_rk*fu4_y_2) - c23*k5_yz
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y_2 = nu3_y_2 + t3*fu4_y_2
    ! link 2: mass matrix, its row of this joint
    m2_5 = t3*fu3_y_2 - t4*fu3_x_2 - neg_m3_5
    ! link 4: mass matrix, its row of this joint
    m4_4 = 1.488987605192658_rk - (t5 - t11)
    t15 = neg_h6_y - 1.0765039731522932_rk
    t16 = -h5_x - 0.21759393385311085_rk
    ! link 4: first moment of the composite body, about the frame's origin [kg m]
    h4_x = s4*t15 - c4*t16
    neg_h4_y = s4*t16 + c4*t15
    t17 = c4*c4
    t18 = t5 + t11 - 0.9122308027056962_rk
    t19 = 0.09181695932507075_rk - k5_xz
    t20 = c4*s4
    t21 = t17*t18 - t19*(2.0_rk*t20)
    ! link 4: second moment of the composite body [kg m^2]
    k4_xx = t21 - (t5 - 1.2006092039491771_rk)
    k4_yy = t11 + 0.2883784012434809_rk - t21
    k4_xy = t18*t20 - t19*(1.0_rk - 2.0_rk*t17)
    t22 = k5_xy + 0.1094831940191231_rk
    t23 = 0.02981305527252843_rk - k5_yz
    k4_xz = c4*t22 - s4*t23
    k4_yz = s4*t22 + c4*t23
    ! link 3: mass matrix, its row of this joint
    m3_4 = k4_yz - 0.45_rk*neg_h4_y
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x_3 = c23*neg_h4_y
    fu3_y_3 = s23*neg_h4_y
    t24 = k4_xz + 0.45_rk*h4_x
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_y_3 = c23*m4_4 - s23*t24
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y_3 = nu3_y_3 + t3*h4_x
    ! link 2: mass matrix, its row of this joint
    m2_4 = m3_4 + (t3*fu3_y_3 - t4*fu3_x_3)
    t25 = k5_yy - 0.9_rk*neg_h5_y
    ! link 3: mass matrix, its row of this joint
    m3_3 = k4_xx + t25 + 5.588609369432211_rk
    t26 = neg_h5_y - 9.392800548482231_rk
    t27 = 0.4001573159217507_rk - h4_x
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    h3_x = s23*t26 - c23*t27
    neg_h3_y = s23*t27 + c23*t26
    t28 = c23*c23*(t25 - k4_xx + 5.203567339738615_rk) + (t24 + &
        0.06558551272001446_rk)*(2.0_rk*(c23*s23))
    ! link 3: second moment of the composite body [kg m^2]
    k3_xx = t25 + 5.396088354585412_rk - t28
    k3_yy = k4_xx + 0.19252101484679798_rk + t28
    k3_yz = c23*(0.0672049454639226_rk - m3_4) - s23*(k4_xy - 0.1093030288471206_rk)
    ! link 2: mass matrix, its row of this joint
    m2_3 = m3_3 - (t4*neg_h3_y - t3*h3_x)
    t29 = k4_yy - k3_yy
    ! link 2: second moment of the composite body [kg m^2]
    k2_zz = k3_yy + t29
    t30 = k3_xx - t3*(-2.0_rk*h3_x)
    ! link 2: mass matrix, its row of this joint
    m2_2 = t30 + (k4_yy - t29 - t4*(2.0_rk*neg_h3_y)) + 5.195184633739834_rk
    ! link 2: second moment of the composite body [kg m^2]
    k2_xx = t30 + (4.09673559354447_rk*(c2*c2) - 0.6711330317943448_rk*(c2*s2) + &
        0.5492245200976821_rk)
    k2_yz = k3_yz + t4*neg_h4_y + (0.017315109477737248_rk*s2 + 0.09496171507178643_rk*c2)
    ! link 1: mass matrix, its row of this joint
    m1_1 = k2_zz + k2_xx + 0.6379688079078735_rk
    ! link 3: angular velocity [rad/s]
    w3_z = qd(2) + qd(3)
    ! link 2: angular velocity [rad/s]
    w2_x = qd(1)*s2
    w2_y = qd(1)*c2
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
    ! link 3: angular velocity [rad/s]
    w3_x = qd(1)*s23
    w3_y = qd(1)*c23
    t31 = 0.45_rk*neg_lam2_11
    t32 = 0.45_rk*ww2_xy
    t33 = c2*t31 + s2*t32
    t34 = s2*t31 - c2*t32 - 9.8_rk
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a3_x = c23*t33 + s23*t34
    a3_y = s23*t33 - c23*t34
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
    a4_z = a3_y - 0.45_rk*neg_lam3_22
    ! link 4: angular velocity [rad/s]
    w4_x = c4*w3_x - s4*w3_z
    w4_y = t14*w3_z - s4*w3_x
    t35 = 0.9_rk*(neg_alpha2_y + alpha3_x)
    t36 = neg_a3_x - 0.45_rk*ww3_xy
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_x = -s4*t35 - c4*t36
    a4_y = s4*t36 - c4*t35
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = c4*alpha3_x + qd(4)*w4_y
    alpha4_y = -qd(4)*w4_x - s4*alpha3_x
    ! link 4: angular velocity [rad/s]
    w4_z = qd(4) + w3_y
    ! link 4: products of the angular velocity [1/s^2]
    ww4_yz = w4_y*w4_z
    ww4_zx = w4_x*w4_z
    ww4_xy = w4_x*w4_y
    ww4_xx = w4_x*w4_x
    ww4_yy = w4_y*w4_y
    ww4_zz = w4_z*w4_z
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam4_11 = ww4_yy + ww4_zz
    lam4_12 = ww4_xy - alpha3_y
    lam4_13 = alpha4_y + ww4_zx
    lam4_21 = alpha3_y + ww4_xy
    neg_lam4_22 = ww4_xx + ww4_zz
    lam4_23 = ww4_yz - alpha4_x
    lam4_31 = ww4_zx - alpha4_y
    lam4_32 = alpha4_x + ww4_yz
    neg_lam4_33 = ww4_xx + ww4_yy
    ! link 5: angular velocity [rad/s]
    w5_x = c5*w4_x + s5*w4_z
    w5_y = c5*w4_z - s5*w4_x
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_x = c5*a4_x + s5*a4_z
    a5_y = c5*a4_z - s5*a4_x
    ! link 5: angular acceleration [rad/s^2]
    alpha5_x = c5*alpha4_x + s5*alpha3_y + qd(5)*w5_y
    neg_alpha5_y = s5*alpha4_x - c5*alpha3_y + qd(5)*w5_x
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
    lam5_13 = ww5_zx - neg_alpha5_y
    lam5_21 = ww5_xy - alpha4_y
    neg_lam5_22 = ww5_xx + ww5_zz
    lam5_23 = ww5_yz - alpha5_x
    lam5_31 = neg_alpha5_y + ww5_zx
    lam5_32 = alpha5_x + ww5_yz
    neg_lam5_33 = ww5_xx + ww5_yy
    ! link 6: angular velocity [rad/s]
    w6_x = c6*w5_x - s6*w5_z
    w6_y = -c6*w5_z - s6*w5_x
    ! link 6: acceleration of the frame's origin, gravity taken off [m/s^2]
    a6_x = c6*a5_x + s6*a4_y
    a6_y = c6*a4_y - s6*a5_x
    ! link 6: angular acceleration [rad/s^2]
    alpha6_x = c6*alpha5_x + s6*alpha4_y + qd(6)*w6_y
    neg_alpha6_y = s6*alpha5_x - c6*alpha4_y + qd(6)*w6_x
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
    lam6_12 = neg_alpha5_y + ww6_xy
    lam6_13 = ww6_zx - neg_alpha6_y
    lam6_21 = ww6_xy - neg_alpha5_y
    neg_lam6_22 = ww6_xx + ww6_zz
    neg_lam6_23 = alpha6_x - ww6_yz
    lam6_31 = neg_alpha6_y + ww6_zx
    lam6_32 = alpha6_x + ww6_yz
    neg_lam6_33 = ww6_xx + ww6_yy
    ! link 2: moment that turns the link [N m]
    nc2_x = 1.0984490401953642_rk*alpha2_x + 0.09496171507178643_rk*(neg_lam2_22 - neg_lam2_33) + &
        (0.6711330317943448_rk*neg_alpha2_y - 0.017315109477737248_rk*ww2_xy)
    nc2_y = 0.09496171507178643_rk*ww2_xy - 0.6711330317943448_rk*alpha2_x - &
        (9.291920227284304_rk*neg_alpha2_y + 0.017315109477737248_rk*(neg_lam2_11 - neg_lam2_33))
    nc2_z = 4.09673559354447_rk*ww2_xy + 0.3355665158971724_rk*(neg_lam2_11 - neg_lam2_22) + &
        (81.05525857884084_rk*c2 + 17.30463777489202_rk*s2)
    ! link 3: force that moves the link [N]
    fc3_x = 0.4001573159217507_rk*neg_lam3_11 + 9.392800548482231_rk*ww3_xy
    fc3_y = -9.392800548482231_rk*neg_lam3_22 - 0.4001573159217507_rk*ww3_xy
    fc3_z = 0.8003146318435014_rk*alpha3_y + 18.785601096964463_rk*alpha3_x
    ! link 3: moment that turns the link [N m]
    nc3_x = 10.792176709170825_rk*alpha3_x + 0.0672049454639226_rk*(neg_lam3_22 - neg_lam3_33) + &
        (-0.13117102544002893_rk*alpha3_y - 0.1093030288471206_rk*ww3_xy) + &
        8.453520493634008_rk*neg_alpha2_y
    nc3_y = 0.3601415843295756_rk*neg_alpha2_y - (0.1093030288471206_rk*(neg_lam3_11 - &
        neg_lam3_33) - 0.38504202969359597_rk*alpha3_y - (0.0672049454639226_rk*ww3_xy - &
        0.13117102544002893_rk*alpha3_x))
    nc3_z = 9.392800548482231_rk*neg_a3_x - 0.4001573159217507_rk*a3_y - &
        (5.203567339738615_rk*ww3_xy - 0.06558551272001446_rk*(neg_lam3_11 - neg_lam3_22))
    ! link 4: force that moves the link [N]
    fc4_x = 1.0765039731522932_rk*lam4_12 - 0.21759393385311085_rk*neg_lam4_11
    fc4_y = 0.21759393385311085_rk*lam4_21 - 1.0765039731522932_rk*neg_lam4_22
    fc4_z = 0.21759393385311085_rk*lam4_31 + 1.0765039731522932_rk*lam4_32
    ! link 4: moment that turns the link [N m]
    nc4_x = 0.7570061710726514_rk*lam4_32 + 0.02981305527252843_rk*(neg_lam4_22 - neg_lam4_33) + &
        (0.09181695932507075_rk*lam4_31 - 0.1094831940191231_rk*lam4_21) + &
        1.0765039731522932_rk*a4_z
    nc4_y = -0.21759393385311085_rk*a4_z - (0.1886810537096668_rk*lam4_31 + &
        0.1094831940191231_rk*(neg_lam4_11 - neg_lam4_33) - (0.02981305527252843_rk*lam4_12 - &
        0.09181695932507075_rk*lam4_32))
    t37 = 0.7570061710726514_rk*lam4_12 - 0.1886810537096668_rk*lam4_21 - &
        0.09181695932507075_rk*(neg_lam4_11 - neg_lam4_22) + (0.02981305527252843_rk*lam4_13 - &
        0.1094831940191231_rk*lam4_23)
    nc4_z = 0.21759393385311085_rk*a4_y - 1.0765039731522932_rk*a4_x - t37
    ! link 5: force that moves the link [N]
    fc5_x = 0.8974188745594792_rk*neg_lam5_11 + 0.8067444135457743_rk*lam5_12
    fc5_y = -0.8067444135457743_rk*neg_lam5_22 - 0.8974188745594792_rk*lam5_21
    fc5_z = 0.8067444135457743_rk*lam5_32 - 0.8974188745594792_rk*lam5_31
    ! link 5: moment that turns the link [N m]
    nc5_x = 0.09969734753381411_rk*lam5_32 + 0.06545842652927093_rk*(neg_lam5_22 - neg_lam5_33) - &
        (0.04994749004669093_rk*lam5_31 + 0.022422989561630666_rk*lam5_21) - &
        0.8067444135457743_rk*a4_y
    nc5_y = -0.8974188745594792_rk*a4_y - (0.4973859781056681_rk*lam5_31 + &
        0.022422989561630666_rk*(neg_lam5_11 - neg_lam5_33) + (-0.06545842652927093_rk*lam5_12 - &
        0.04994749004669093_rk*lam5_32))
    t38 = 0.4973859781056681_rk*lam5_21 - 0.09969734753381411_rk*lam5_12 - &
        0.04994749004669093_rk*(neg_lam5_11 - neg_lam5_22) - (0.06545842652927093_rk*lam5_13 - &
        0.022422989561630666_rk*lam5_23)
    nc5_z = t38 - (0.8974188745594792_rk*a5_y + 0.8067444135457743_rk*a5_x)
    ! link 6: force that moves the link [N]
    fc6_x = 1.5707678306756712_rk*neg_lam6_11 + 0.6271000643521031_rk*lam6_12
    fc6_y = -0.6271000643521031_rk*neg_lam6_22 - 1.5707678306756712_rk*lam6_21
    fc6_z = 0.6271000643521031_rk*lam6_32 - 1.5707678306756712_rk*lam6_31
    ! link 6: moment that turns the link [N m]
    nc6_x = 0.13354610634435332_rk*lam6_32 + 0.07096581179296485_rk*(neg_lam6_22 - neg_lam6_33) - &
        (0.13821978029399798_rk*lam6_31 - 0.1601275610650136_rk*lam6_21) + &
        0.6271000643521031_rk*a5_y
    nc6_y = 1.5707678306756712_rk*a5_y - (0.4436030328765257_rk*lam6_31 - &
        0.1601275610650136_rk*(neg_lam6_11 - neg_lam6_33) - (0.07096581179296485_rk*lam6_12 + &
        0.13821978029399798_rk*lam6_32))
    t39 = 0.13354610634435332_rk*lam6_12 - 0.4436030328765257_rk*lam6_21 + &
        0.13821978029399798_rk*(neg_lam6_11 - neg_lam6_22) - (0.1601275610650136_rk*neg_lam6_23 - &
        0.07096581179296485_rk*lam6_13)
    neg_nc6_z = t39 + (1.5707678306756712_rk*a6_y + 0.6271000643521031_rk*a6_x)
    ! link 6: force through the joint, along the axes that its turn starts from [N]
    f06_x = c6*fc6_x - s6*fc6_y
    f06_y = s6*fc6_x + c6*fc6_y
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    n06_x = c6*nc6_x - s6*nc6_y
    n06_y = s6*nc6_x + c6*nc6_y
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_x = nc5_x + n06_x
    n5_y = nc5_y - neg_nc6_z
    n5_z = nc5_z - n06_y
    ! link 5: force through the joint [N]
    f5_x = fc5_x + f06_x
    f5_y = fc5_y + fc6_z
    f5_z = fc5_z - f06_y
    ! link 5: force through the joint, along the axes that its turn starts from [N]
    f05_x = c5*f5_x - s5*f5_y
    f05_y = s5*f5_x + c5*f5_y
    ! link 5: moment through the joint, along the axes that its turn starts from [N m]
    n05_x = c5*n5_x - s5*n5_y
    n05_y = s5*n5_x + c5*n5_y
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = nc4_x + n05_x
    n4_y = nc4_y - n5_z
    n4_z = nc4_z + n05_y
    ! link 4: force through the joint [N]
    f4_x = fc4_x + f05_x
    f4_y = fc4_y - f5_z
    f4_z = fc4_z + f05_y
    ! link 4: force through the joint, along the axes that its turn starts from [N]
    f04_x = c4*f4_x - s4*f4_y
    f04_y = s4*f4_x + c4*f4_y
    ! link 4: moment through the joint, along the axes that its turn starts from [N m]
    n04_x = c4*n4_x - s4*n4_y
    n04_y = s4*n4_x + c4*n4_y
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_x = n04_x + (nc3_x - 0.45_rk*f04_y)
    n3_y = nc3_y + n4_z
    n3_z = nc3_z - 0.45_rk*f04_x - n04_y
    ! link 3: force through the joint [N]
    f3_x = fc3_x + f04_x
    f3_y = fc3_y + f4_z
    f3_z = fc3_z - f04_y
    ! link 3: force through the joint, along the axes that its turn starts from [N]
    f03_x = c23*f3_x - s23*f3_y
    f03_y = s23*f3_x + c23*f3_y
    ! link 3: moment through the joint, along the axes that its turn starts from [N m]
    n03_y = s23*n3_x + c23*n3_y
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_y = n03_y + (s2*nc2_x + c2*nc2_y - t3*f3_z)
    n02_z = n3_z + (nc2_z + (t3*f03_y - t4*f03_x))
    ! link 1: forward substitution
    y1 = tau(1) - n02_y
    ! factorisation M = L D L^T
    ipivot1 = 1.0_rk / m1_1
    l2_1 = -k2_yz*ipivot1
    l3_1 = -k3_yz*ipivot1
    l4_1 = nu2_y_3*ipivot1
    l5_1 = nu2_y_2*ipivot1
    l6_1 = nu2_y*ipivot1
    pivot2 = m2_2 + k2_yz*l2_1
    ipivot2 = 1.0_rk / pivot2
    ld3_2 = m2_3 + k2_yz*l3_1
    l3_2 = ipivot2*ld3_2
    ld4_2 = m2_4 + k2_yz*l4_1
    l4_2 = ipivot2*ld4_2
    ld5_2 = m2_5 + k2_yz*l5_1
    l5_2 = ipivot2*ld5_2
    ld6_2 = m2_6 + k2_yz*l6_1
    l6_2 = ipivot2*ld6_2
    pivot3 = m3_3 + k3_yz*l3_1 - ld3_2*l3_2
    ipivot3 = 1.0_rk / pivot3
    ld4_3 = m3_4 + k3_yz*l4_1 - ld3_2*l4_2
    l4_3 = ipivot3*ld4_3
    ld5_3 = k3_yz*l5_1 - neg_m3_5 - ld3_2*l5_2
    l5_3 = ipivot3*ld5_3
    ld6_3 = k3_yz*l6_1 - neg_m3_6 - ld3_2*l6_2
    l6_3 = ipivot3*ld6_3
    pivot4 = m4_4 - nu2_y_3*l4_1 - ld4_2*l4_2 - ld4_3*l4_3
    ipivot4 = 1.0_rk / pivot4
    ld5_4 = -ld4_2*l5_2 - (k5_yz + nu2_y_3*l5_1) - ld4_3*l5_3
    l5_4 = ipivot4*ld5_4
    ld6_4 = nu5_y - nu2_y_3*l6_1 - ld4_2*l6_2 - ld4_3*l6_3
    l6_4 = ipivot4*ld6_4
    pivot5 = m5_5 - nu2_y_2*l5_1 - ld5_2*l5_2 - ld5_3*l5_3 - ld5_4*l5_4
    ipivot5 = 1.0_rk / pivot5
    ld6_5 = -(ld5_2*l6_2 - (k6_yz - nu2_y_2*l6_1) + ld5_3*l6_3) - ld5_4*l6_4
    l6_5 = ipivot5*ld6_5
    pivot6 = 0.5771491392208791_rk - nu2_y*l6_1 - ld6_2*l6_2 - ld6_3*l6_3 - ld6_4*l6_4 - &
        ld6_5*l6_5
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
    y6 = tau(6) + neg_nc6_z - y1*l6_1 - l6_2*y2 - l6_3*y3 - l6_4*y4 - l6_5*y5
    ! link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd6 = ipivot6*y6
    ! link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd5 = ipivot5*y5 - l6_5*qdd6
    ! link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd4 = ipivot4*y4 - l5_4*qdd5 - l6_4*qdd6
    ! link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd3 = -l6_3*qdd6 - (l4_3*qdd4 - ipivot3*y3 + l5_3*qdd5)
    ! link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd2 = ipivot2*y2 - l3_2*qdd3 - l4_2*qdd4 - l5_2*qdd5 - l6_2*qdd6
    t40 = -(l2_1*qdd2 - y1*ipivot1 + l3_1*qdd3 + l4_1*qdd4 + l5_1*qdd5)
    ! link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd1 = t40 - l6_1*qdd6
    qdd(1) = qdd1
    qdd(2) = qdd2
    qdd(3) = qdd3
    qdd(4) = qdd4
    qdd(5) = qdd5
    qdd(6) = qdd6
  end subroutine
end module
