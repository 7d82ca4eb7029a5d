! puma560_3dof_d11: PUMA 560, first three joints, the set of the thesis's program D.1.1
! Numbers: the 1990 thesis, program D.1.1 (Lagrange); pseudo-inertias as tensors about the centres
!   of mass
! Written by robodyn 0.1.0; do not edit, generate again.
! Description: e4acb3fa395de91cc0422790bfa2c096 (a hash of its numbers)
! Options: --optimize record --scalar double --trig libm
!
! Joints, base to tip, in modified Denavit-Hartenberg frames [rad, m]:
!   1  revolute  alpha 0      a 0       d 0        theta q
!   2  revolute  alpha -pi/2  a 0       d 0.2435   theta q
!   3  revolute  alpha 0      a 0.4318  d -0.0934  theta q
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
!   inverse_dynamics: 56 multiplications, 44 additions = 100; 0 unary minus; 4 sine/cosine
!   gravity: 2 multiplications, 2 additions = 4; 0 unary minus; 2 sine/cosine
!   bias: 46 multiplications, 25 additions = 71; 0 unary minus; 4 sine/cosine
!   mass_matrix: 13 multiplications, 14 additions = 27; 0 unary minus; 4 sine/cosine
!   forward_dynamics: 75 multiplications, 50 additions, 2 divisions = 127; 4 unary minus; 4
!       sine/cosine
module puma560_3dof_d11_dynamics
  use, intrinsic :: iso_c_binding, only: rk => c_double
  implicit none
  private

  public :: puma560_3dof_d11_inverse_dynamics
  public :: puma560_3dof_d11_gravity
  public :: puma560_3dof_d11_bias
  public :: puma560_3dof_d11_mass_matrix
  public :: puma560_3dof_d11_forward_dynamics

contains

  ! torques that give the accelerations qdd
  ! 56 multiplications, 44 additions = 100; 0 unary minus; 4 sine/cosine
  pure subroutine puma560_3dof_d11_inverse_dynamics(q, qd, qdd, tau) &
      bind(c, name="puma560_3dof_d11_inverse_dynamics_f")
    real(rk), intent(in) :: q(3)
    real(rk), intent(in) :: qd(3)
    real(rk), intent(in) :: qdd(3)
    real(rk), intent(out) :: tau(3)
    real(rk) :: c2, neg_w2_y, s2, neg_w2_x, lam2_23, neg_ww2_yz, neg_alpha2_x, neg_lam2_13
    real(rk) :: neg_ww2_zx, neg_alpha2_y, ww2_yy, ww2_zz, ww2_xy, neg_lam2_11, lam2_21, lam2_12
    real(rk) :: neg_lam2_32, lam2_31, neg_lam2_33, w3_z, angle23, s23, neg_w3_x, c23, neg_w3_y
    real(rk) :: alpha3_z, neg_ww3_yz, neg_alpha3_x, neg_ww3_zx, alpha3_y, ww3_xy, ww3_xx, ww3_zz
    real(rk) :: lam3_21, neg_lam3_12, neg_lam3_22, neg_lam3_32, neg_lam3_31, t1, t2, t3, nc3_z, t4
    real(rk) :: t5, n02_z, t6, t7, n1_z

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    ! link 2: angular velocity [rad/s]
    neg_w2_y = qd(1)*c2
    ! sines and cosines of the joint angles
    s2 = sin(q(2))
    ! link 2: angular velocity [rad/s]
    neg_w2_x = qd(1)*s2
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    lam2_23 = s2*qdd(1)
    ! link 2: products of the angular velocity [1/s^2]
    neg_ww2_yz = neg_w2_y*qd(2)
    ! link 2: angular acceleration [rad/s^2]
    neg_alpha2_x = lam2_23 + neg_ww2_yz
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_13 = c2*qdd(1)
    ! link 2: products of the angular velocity [1/s^2]
    neg_ww2_zx = neg_w2_x*qd(2)
    ! link 2: angular acceleration [rad/s^2]
    neg_alpha2_y = neg_lam2_13 - neg_ww2_zx
    ! link 2: products of the angular velocity [1/s^2]
    ww2_yy = neg_w2_y*neg_w2_y
    ww2_zz = qd(2)*qd(2)
    ww2_xy = neg_w2_y*neg_w2_x
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_11 = ww2_yy + ww2_zz
    lam2_21 = ww2_xy + qdd(2)
    lam2_12 = ww2_xy - qdd(2)
    neg_lam2_32 = neg_ww2_yz + neg_alpha2_x
    lam2_31 = neg_alpha2_y - neg_ww2_zx
    neg_lam2_33 = qd(1)*qd(1)
    ! link 3: angular velocity [rad/s]
    w3_z = qd(2) + qd(3)
    ! sines and cosines of the joint angles
    angle23 = q(2) + q(3)
    s23 = sin(angle23)
    ! link 3: angular velocity [rad/s]
    neg_w3_x = qd(1)*s23
    ! sines and cosines of the joint angles
    c23 = cos(angle23)
    ! link 3: angular velocity [rad/s]
    neg_w3_y = qd(1)*c23
    ! link 3: angular acceleration [rad/s^2]
    alpha3_z = qdd(2) + qdd(3)
    ! link 3: products of the angular velocity [1/s^2]
    neg_ww3_yz = w3_z*neg_w3_y
    ! link 3: angular acceleration [rad/s^2]
    neg_alpha3_x = neg_ww3_yz + qdd(1)*s23
    ! link 3: products of the angular velocity [1/s^2]
    neg_ww3_zx = w3_z*neg_w3_x
    ! link 3: angular acceleration [rad/s^2]
    alpha3_y = neg_ww3_zx - qdd(1)*c23
    ! link 3: products of the angular velocity [1/s^2]
    ww3_xy = neg_w3_x*neg_w3_y
    ww3_xx = neg_w3_x*neg_w3_x
    ww3_zz = w3_z*w3_z
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_21 = alpha3_z + ww3_xy
    neg_lam3_12 = alpha3_z - ww3_xy
    neg_lam3_22 = ww3_xx + ww3_zz
    neg_lam3_32 = neg_ww3_yz + neg_alpha3_x
    neg_lam3_31 = neg_ww3_zx + alpha3_y
    t1 = neg_lam2_11 + 0.3476146364057434_rk*neg_lam2_13
    t2 = lam2_21 + 0.3476146364057434_rk*lam2_23
    t3 = c23*(c2*t1 + s2*t2) + s23*(s2*t1 - c2*t2 + 22.69569245020843_rk)
    ! link 3: moment that turns the link [N m]
    nc3_z = 0.1828673_rk*(0.02132694035510996_rk*(lam3_21 + 8.58974358974359_rk*neg_lam3_12) - t3)
    t4 = c23*neg_lam3_12 - s23*neg_lam3_22
    t5 = lam2_23 + 17.560047467882075_rk*(lam2_21 - 0.01861555053452303_rk*lam2_12) - &
        134.66002709590805_rk*c2 + 1.7581612571010712_rk*(c2*(s23*neg_lam3_12 + c23*neg_lam3_22) - &
        s2*t4)
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_z = nc3_z + 0.104010539_rk*t5
    t6 = s2*(lam2_21 + 0.326889951026982_rk*neg_lam2_32) + c2*(neg_lam2_11 - neg_lam2_33 + &
        17.560047467882075_rk*lam2_31) - 0.6111625861298536_rk*(t4 - &
        2.876748834110593_rk*(c2*neg_lam3_32))
    t7 = t6 - 0.0374962002648597_rk*(c23*neg_lam3_31 + &
        46.889051282051284_rk*(s23*(0.3476146364057434_rk*neg_lam2_33 - lam2_31 - &
        0.18319294920414966_rk*neg_lam3_32)))
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = 0.104010539_rk*(t7 + 15.040703812716517_rk*qdd(1))
    tau(1) = n1_z
    tau(2) = n02_z
    tau(3) = nc3_z
  end subroutine

  ! torques that hold the arm at rest
  ! 2 multiplications, 2 additions = 4; 0 unary minus; 2 sine/cosine
  pure subroutine puma560_3dof_d11_gravity(q, tau) &
      bind(c, name="puma560_3dof_d11_gravity_f")
    real(rk), intent(in) :: q(3)
    real(rk), intent(out) :: tau(3)
    real(rk) :: angle23, s23, nc3_z, c2, neg_nc2_z, n02_z

    ! sines and cosines of the joint angles
    angle23 = q(2) + q(3)
    s23 = sin(angle23)
    ! link 3: moment that turns the link [N m]
    nc3_z = -4.1503_rk*s23
    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    ! link 2: moment that turns the link [N m]
    neg_nc2_z = 14.006062_rk*c2
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_z = nc3_z - neg_nc2_z
    tau(1) = 0.0_rk
    tau(2) = n02_z
    tau(3) = nc3_z
  end subroutine

  ! torques at zero acceleration: Coriolis, centrifugal, gravity, friction
  ! 46 multiplications, 25 additions = 71; 0 unary minus; 4 sine/cosine
  pure subroutine puma560_3dof_d11_bias(q, qd, tau) &
      bind(c, name="puma560_3dof_d11_bias_f")
    real(rk), intent(in) :: q(3)
    real(rk), intent(in) :: qd(3)
    real(rk), intent(out) :: tau(3)
    real(rk) :: c2, neg_w2_y, s2, neg_w2_x, ww2_yy, ww2_zz, ww2_xy, neg_ww2_yz, neg_ww2_zx
    real(rk) :: neg_lam2_11, neg_lam2_33, w3_z, angle23, s23, neg_w3_x, c23, neg_w3_y, ww3_xy
    real(rk) :: ww3_xx, ww3_zz, neg_ww3_yz, neg_ww3_zx, neg_lam3_22, t1, nc3_z, t2, t3, n02_z, t4
    real(rk) :: t5, neg_n02_y

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    ! link 2: angular velocity [rad/s]
    neg_w2_y = qd(1)*c2
    ! sines and cosines of the joint angles
    s2 = sin(q(2))
    ! link 2: angular velocity [rad/s]
    neg_w2_x = qd(1)*s2
    ! link 2: products of the angular velocity [1/s^2]
    ww2_yy = neg_w2_y*neg_w2_y
    ww2_zz = qd(2)*qd(2)
    ww2_xy = neg_w2_y*neg_w2_x
    neg_ww2_yz = neg_w2_y*qd(2)
    neg_ww2_zx = neg_w2_x*qd(2)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_11 = ww2_yy + ww2_zz
    neg_lam2_33 = qd(1)*qd(1)
    ! link 3: angular velocity [rad/s]
    w3_z = qd(2) + qd(3)
    ! sines and cosines of the joint angles
    angle23 = q(2) + q(3)
    s23 = sin(angle23)
    ! link 3: angular velocity [rad/s]
    neg_w3_x = qd(1)*s23
    ! sines and cosines of the joint angles
    c23 = cos(angle23)
    ! link 3: angular velocity [rad/s]
    neg_w3_y = qd(1)*c23
    ! link 3: products of the angular velocity [1/s^2]
    ww3_xy = neg_w3_x*neg_w3_y
    ww3_xx = neg_w3_x*neg_w3_x
    ww3_zz = w3_z*w3_z
    neg_ww3_yz = w3_z*neg_w3_y
    neg_ww3_zx = w3_z*neg_w3_x
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_22 = ww3_xx + ww3_zz
    t1 = c23*(c2*neg_lam2_11 + s2*ww2_xy) + s23*(s2*neg_lam2_11 - c2*ww2_xy + &
        22.69569245020843_rk)
    ! link 3: moment that turns the link [N m]
    nc3_z = -0.1828673_rk*(t1 + 0.1618660088490397_rk*ww3_xy)
    t2 = c23*ww3_xy + s23*neg_lam3_22
    t3 = ww2_xy - 7.814007790748863_rk*c2 - 0.10202200353484152_rk*(c2*(s23*ww3_xy - &
        c23*neg_lam3_22) - s2*t2)
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_z = nc3_z + 1.792430002_rk*t3
    t4 = s2*(ww2_xy + 0.653779902053964_rk*neg_ww2_yz) + c2*(neg_lam2_11 - neg_lam2_33 - &
        35.12009493576415_rk*neg_ww2_zx) + 0.6111625861298536_rk*(t2 + &
        5.753497668221186_rk*(c2*neg_ww3_yz))
    t5 = t4 - 0.0749924005297194_rk*(c23*neg_ww3_zx + 8.149660256410256_rk*(s23*(neg_lam2_33 + &
        5.753497668221186_rk*neg_ww2_zx - 1.0540002060806373_rk*neg_ww3_yz)))
    neg_n02_y = 0.104010539_rk*t5
    tau(1) = neg_n02_y
    tau(2) = n02_z
    tau(3) = nc3_z
  end subroutine

  ! mass matrix, rotor inertias on its diagonal
  ! 13 multiplications, 14 additions = 27; 0 unary minus; 4 sine/cosine
  pure subroutine puma560_3dof_d11_mass_matrix(q, M) &
      bind(c, name="puma560_3dof_d11_mass_matrix_f")
    real(rk), intent(in) :: q(3)
    real(rk), intent(out) :: M(9)
    real(rk) :: c2, s2, angle23, c23, s23, t1, k3_xx, k3_yy, t2, t3, m2_3, m1_3, t4, m2_2, k2_xx
    real(rk) :: m1_2, m1_1

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    angle23 = q(2) + q(3)
    c23 = cos(angle23)
    s23 = sin(angle23)
    t1 = 0.0296_rk*(c23*c23)
    ! link 3: second moment of the composite body [kg m^2]
    k3_xx = 0.0335_rk - t1
    k3_yy = t1 + 0.0039_rk
    t2 = c2*s23
    t3 = s2*c23
    ! link 2: mass matrix, its row of this joint
    m2_3 = 0.1828673_rk*(t2 - t3) + 0.0374_rk
    ! link 1: mass matrix, its row of this joint
    m1_3 = -0.06356735_rk*c23
    t4 = k3_xx + 0.3657346_rk*t2
    ! link 2: mass matrix, its row of this joint
    m2_2 = 1.860430002_rk - (0.3657346_rk*t3 - k3_yy - t4)
    ! link 2: second moment of the composite body [kg m^2]
    k2_xx = t4 + 1.792430002_rk*(c2*c2 + 0.01896866263232744_rk)
    ! link 1: mass matrix, its row of this joint
    m1_2 = 0.11051088_rk*(1.9411791762041892_rk*(s2 - 0.2963216927070578_rk*c23) - s2)
    m1_1 = k2_xx + 1.5643917105_rk
    M(1) = m1_1
    M(2) = m1_2
    M(3) = m1_3
    M(4) = m1_2
    M(5) = m2_2
    M(6) = m2_3
    M(7) = m1_3
    M(8) = m2_3
    M(9) = 0.0374_rk
  end subroutine

  ! accelerations that the torques tau give
  ! 75 multiplications, 50 additions, 2 divisions = 127; 4 unary minus; 4 sine/cosine
  pure subroutine puma560_3dof_d11_forward_dynamics(q, qd, tau, qdd) &
      bind(c, name="puma560_3dof_d11_forward_dynamics_f")
    real(rk), intent(in) :: q(3)
    real(rk), intent(in) :: qd(3)
    real(rk), intent(in) :: tau(3)
    real(rk), intent(out) :: qdd(3)
    real(rk) :: c2, t1, w2_y, s2, w2_x, ww2_yy, ww2_zz, ww2_xy, ww2_yz, ww2_zx, lam2_11
    real(rk) :: neg_lam2_33, w3_z, angle23, s23, w3_x, c23, w3_y, ww3_xy, ww3_xx, ww3_zz, ww3_yz
    real(rk) :: ww3_zx, lam3_22, t2, t3, t4, t5, neg_n02_z, t6, t7, n02_y, t8, t9, k3_xx, k3_yy
    real(rk) :: t10, t11, t12, m2_2, k2_xx, m1_2, m1_1, t13, pivot2, ipivot2, ud1_2, u1_2, pivot1
    real(rk) :: ipivot1, t14, y2, y1, qdd1, qdd2, qdd3

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    t1 = -qd(1)
    ! link 2: angular velocity [rad/s]
    w2_y = t1*c2
    ! sines and cosines of the joint angles
    s2 = sin(q(2))
    ! link 2: angular velocity [rad/s]
    w2_x = t1*s2
    ! link 2: products of the angular velocity [1/s^2]
    ww2_yy = w2_y*w2_y
    ww2_zz = qd(2)*qd(2)
    ww2_xy = w2_y*w2_x
    ww2_yz = w2_y*qd(2)
    ww2_zx = w2_x*qd(2)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    lam2_11 = -ww2_yy - ww2_zz
    neg_lam2_33 = qd(1)*qd(1)
    ! link 3: angular velocity [rad/s]
    w3_z = qd(2) + qd(3)
    ! sines and cosines of the joint angles
    angle23 = q(2) + q(3)
    s23 = sin(angle23)
    ! link 3: angular velocity [rad/s]
    w3_x = t1*s23
    ! sines and cosines of the joint angles
    c23 = cos(angle23)
    ! link 3: angular velocity [rad/s]
    w3_y = t1*c23
    ! link 3: products of the angular velocity [1/s^2]
    ww3_xy = w3_x*w3_y
    ww3_xx = w3_x*w3_x
    ww3_zz = w3_z*w3_z
    ww3_yz = w3_z*w3_y
    ww3_zx = w3_z*w3_x
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_22 = -ww3_xx - ww3_zz
    t2 = c23*(s2*ww2_xy - c2*lam2_11) + s23*(-c2*ww2_xy - s2*lam2_11 + 22.69569245020843_rk)
    t3 = t2 + 0.1618660088490397_rk*ww3_xy
    t4 = c23*ww3_xy - s23*lam3_22
    t5 = c2*(s23*ww3_xy + c23*lam3_22) - s2*t4 + 76.59139714973645_rk*(c2 - &
        0.1279753011231851_rk*ww2_xy)
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    neg_n02_z = 0.1828673_rk*(t3 + t5)
    t6 = t4 - 5.753497668221186_rk*(c2*ww3_yz) + 1.6362258140381816_rk*(s2*(ww2_xy - &
        0.653779902053964_rk*ww2_yz) + c2*(35.12009493576415_rk*ww2_zx - (lam2_11 + neg_lam2_33)))
    t7 = 8.58974358974359_rk*(s23*(ww3_yz + &
        5.458725373134328_rk*(0.1738073182028717_rk*neg_lam2_33 - ww2_zx))) - c23*ww3_zx - &
        8.149660256410256_rk*t6
    n02_y = 0.0078_rk*t7
    t8 = c23*c23
    t9 = 0.0296_rk*t8
    ! link 3: second moment of the composite body [kg m^2]
    k3_xx = 0.0335_rk - t9
    k3_yy = t9 + 0.0039_rk
    t10 = s2*c23
    t11 = c2*s23
    t12 = k3_xx + 0.3657346_rk*t11
    ! link 2: mass matrix, its row of this joint
    m2_2 = 1.860430002_rk - (0.3657346_rk*t10 - k3_yy - t12)
    ! link 2: second moment of the composite body [kg m^2]
    k2_xx = t12 + 1.792430002_rk*(c2*c2 + 0.01896866263232744_rk)
    ! link 1: mass matrix, its row of this joint
    m1_2 = 0.104010539_rk*(s2 - 0.6111625861298536_rk*c23)
    m1_1 = k2_xx + 1.5643917105_rk
    t13 = t11 - t10 + 0.20451988955925965_rk
    ! factorisation M = U D U^T
    pivot2 = m2_2 - 0.89412966335_rk*(t13*t13)
    ipivot2 = 1.0_rk / pivot2
    ud1_2 = m1_2 + 0.310812557825_rk*(c23*t13)
    u1_2 = ipivot2*ud1_2
    pivot1 = m1_1 - 0.10804299427867647_rk*t8 - ud1_2*u1_2
    ipivot1 = 1.0_rk / pivot1
    t14 = t3 + 5.46844624489999_rk*tau(3)
    ! link 2: forward substitution
    y2 = neg_n02_z + tau(2) - 0.89412966335_rk*(t13*t14)
    ! link 1: forward substitution
    y1 = n02_y + tau(1) + 0.310812557825_rk*(c23*t14) - u1_2*y2
    ! link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd1 = ipivot1*y1
    ! link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd2 = ipivot2*y2 - u1_2*qdd1
    ! link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd3 = 1.6996617647058823_rk*(c23*qdd1 + 2.876748834110593_rk*(t14 - t13*qdd2))
    qdd(1) = qdd1
    qdd(2) = qdd2
    qdd(3) = qdd3
  end subroutine
end module
