// What Pinocchio's algorithms give of each of our functions, over any scalar: double, which is raced, and SX of
// CasADi, which is traced. Each writes its results one after another, matrices row by row.
#pragma once
#include "pinocchio_arm.hpp"

#include <pinocchio/algorithm/aba-derivatives.hpp>
#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/energy.hpp>
#include <pinocchio/algorithm/frames.hpp>
#include <pinocchio/algorithm/jacobian.hpp>
#include <pinocchio/algorithm/kinematics.hpp>
#include <pinocchio/algorithm/regressor.hpp>
#include <pinocchio/algorithm/rnea-derivatives.hpp>
#include <pinocchio/algorithm/rnea.hpp>

// Of joints there are Pinocchio's own, or only those that our arms have: CasADi's scalars take a compiler long.
template <typename S, template <typename, int> class Joints = pinocchio::JointCollectionDefaultTpl> struct Arm {
    using Model = pinocchio::ModelTpl<S, 0, Joints>;
    using Data = pinocchio::DataTpl<S, 0, Joints>;
    using Vector = Eigen::Matrix<S, Eigen::Dynamic, 1>;
    using Matrix = Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic>;
    using Wide = Eigen::Matrix<S, 6, Eigen::Dynamic>;

    Model model, weightless;
    Data data;
    Vector rest;
    Wide jacobian;
    Matrix by_q, by_v, by_tau;

    explicit Arm(const pinocchio::ModelTpl<double, 0, Joints> &numbers)
        : model(numbers.template cast<S>()), weightless(model), data(model), rest(Vector::Zero(model.nv)),
          jacobian(Wide::Zero(6, model.nv)), by_q(Matrix::Zero(model.nv, model.nv)), by_v(by_q), by_tau(by_q)
    {
        weightless.gravity.setZero();
    }

    int n() const { return model.nv; }
    int last() const { return model.njoints - 1; }

    template <typename M> static S *rows(const M &matrix, S *out)
    {
        for (Eigen::Index i = 0; i < matrix.rows(); i++)
            for (Eigen::Index j = 0; j < matrix.cols(); j++)
                *out++ = matrix(i, j);
        return out;
    }

    // Of a symmetric matrix what lies above the diagonal.
    template <typename M> static S *mirrored(const M &matrix, S *out)
    {
        for (Eigen::Index i = 0; i < matrix.rows(); i++)
            for (Eigen::Index j = 0; j < matrix.cols(); j++)
                *out++ = i < j ? matrix(i, j) : matrix(j, i);
        return out;
    }

    S *pose(S *out) const
    {
        const auto &place = data.oMi[last()];
        Eigen::Matrix<S, 3, 4> pose;
        pose << place.rotation(), place.translation();
        return rows(pose, out);
    }
};

// NAME, numbers of its results of n joints, and how they are computed from q, v (velocities) and a (accelerations or
// torques).
#define FUNCTION_OF(NAME, SIZE, BODY)                                                                                  \
    struct NAME {                                                                                                      \
        static int size(int n)                                                                                         \
        {                                                                                                              \
            (void)n;                                                                                                   \
            return SIZE;                                                                                               \
        }                                                                                                              \
        template <typename A, typename V, typename S>                                                                  \
        static void run(A &arm, const V &q, const V &v, const V &a, S *out)                                            \
        {                                                                                                              \
            auto &model = arm.model;                                                                                   \
            auto &data = arm.data;                                                                                     \
            (void)q, (void)v, (void)a, (void)model, (void)data;                                                        \
            BODY                                                                                                       \
        }                                                                                                              \
    };

namespace functions {
FUNCTION_OF(inverse_dynamics, n, { arm.rows(pinocchio::rnea(model, data, q, v, a), out); })
FUNCTION_OF(joint_reactions, 6 * n, {
    pinocchio::rnea(model, data, q, v, a);
    for (int i = 1; i <= arm.last(); i++)
        out = arm.rows(data.f[i].angular(), arm.rows(data.f[i].linear(), out));
})
FUNCTION_OF(gravity, n, { arm.rows(pinocchio::computeGeneralizedGravity(model, data, q), out); })
FUNCTION_OF(bias, n, { arm.rows(pinocchio::nonLinearEffects(model, data, q, v), out); })
FUNCTION_OF(mass_matrix, n *n, {
    pinocchio::crba(model, data, q);
    arm.mirrored(data.M, out);
})
FUNCTION_OF(mass_matrix_world, n *n, {
    pinocchio::crba(model, data, q, pinocchio::Convention::WORLD);
    arm.mirrored(data.M, out);
})
FUNCTION_OF(forward_dynamics, n, { arm.rows(pinocchio::aba(model, data, q, v, a), out); })
FUNCTION_OF(forward_dynamics_world, n,
            { arm.rows(pinocchio::aba(model, data, q, v, a, pinocchio::Convention::WORLD), out); })
FUNCTION_OF(coriolis_matrix, n *n, { arm.rows(pinocchio::computeCoriolisMatrix(model, data, q, v), out); })
FUNCTION_OF(inverse_dynamics_derivatives, 2 * n * n, {
    pinocchio::computeRNEADerivatives(model, data, q, v, a);
    arm.rows(data.dtau_dv, arm.rows(data.dtau_dq, out));
})
FUNCTION_OF(forward_dynamics_derivatives, 3 * n * n, {
    pinocchio::computeABADerivatives(model, data, q, v, a);
    arm.mirrored(data.Minv, arm.rows(data.ddq_dv, arm.rows(data.ddq_dq, out)));
})
FUNCTION_OF(kinetic_energy, 1, { *out = pinocchio::computeKineticEnergy(model, data, q, v); })
FUNCTION_OF(potential_energy, 1, { *out = pinocchio::computePotentialEnergy(model, data, q); })
FUNCTION_OF(momentum, n, { arm.rows(pinocchio::rnea(arm.weightless, data, q, arm.rest, v), out); })
FUNCTION_OF(coriolis, n, { arm.rows(pinocchio::nonLinearEffects(arm.weightless, data, q, v), out); })
FUNCTION_OF(momentum_observer_term, n, {
    pinocchio::computeCoriolisMatrix(model, data, q, v);
    const typename A::Vector turned = data.C.transpose() * v;
    const typename A::Vector rest = pinocchio::computeGeneralizedGravity(model, data, q);
    arm.rows((turned - rest).eval(), out);
})
FUNCTION_OF(forward_kinematics, 12, {
    pinocchio::forwardKinematics(model, data, q);
    arm.pose(out);
})
FUNCTION_OF(link_poses, 12 * n, {
    pinocchio::forwardKinematics(model, data, q);
    for (int i = 1; i <= arm.last(); i++)
        out = arm.rows(data.oMi[i].translation(), out);
    for (int i = 1; i <= arm.last(); i++)
        out = arm.rows(data.oMi[i].rotation(), out);
})
FUNCTION_OF(jacobian, 6 * n, {
    pinocchio::computeJointJacobians(model, data, q);
    pinocchio::getJointJacobian(model, data, arm.last(), pinocchio::LOCAL_WORLD_ALIGNED, arm.jacobian);
    arm.rows(arm.jacobian, out);
})
FUNCTION_OF(tool_jacobian, 6 * n, {
    pinocchio::computeJointJacobian(model, data, q, arm.last(), arm.jacobian);
    arm.rows(arm.jacobian, out);
})
FUNCTION_OF(jacobian_and_forward_kinematics, 6 * n + 12, {
    pinocchio::computeJointJacobians(model, data, q);
    pinocchio::getJointJacobian(model, data, arm.last(), pinocchio::LOCAL_WORLD_ALIGNED, arm.jacobian);
    arm.pose(arm.rows(arm.jacobian, out));
})
FUNCTION_OF(jacobian_dot_qd, 6, {
    pinocchio::forwardKinematics(model, data, q, v, arm.rest);
    const auto change = pinocchio::getClassicalAcceleration(model, data, arm.last(), pinocchio::LOCAL_WORLD_ALIGNED);
    arm.rows(change.angular(), arm.rows(change.linear(), out));
})
FUNCTION_OF(inverse_mass_matrix, n *n, { arm.mirrored(pinocchio::computeMinverse(model, data, q), out); })
FUNCTION_OF(lambda_inverse, 36, {
    pinocchio::computeMinverse(model, data, q);
    data.Minv.template triangularView<Eigen::StrictlyLower>() = data.Minv.transpose();
    pinocchio::computeJointJacobians(model, data, q);
    pinocchio::getJointJacobian(model, data, arm.last(), pinocchio::LOCAL_WORLD_ALIGNED, arm.jacobian);
    const typename A::Matrix half = data.Minv * arm.jacobian.transpose();
    arm.rows((arm.jacobian * half).eval(), out);
})
FUNCTION_OF(regressor, 10 * n *n, { arm.rows(pinocchio::computeJointTorqueRegressor(model, data, q, v, a), out); })
} // namespace functions

// CALL(NAME) for every one of them.
#define EVERY_FUNCTION(CALL)                                                                                           \
    CALL(inverse_dynamics)                                                                                             \
    CALL(joint_reactions)                                                                                              \
    CALL(gravity)                                                                                                      \
    CALL(bias)                                                                                                         \
    CALL(mass_matrix)                                                                                                  \
    CALL(mass_matrix_world)                                                                                            \
    CALL(forward_dynamics)                                                                                             \
    CALL(forward_dynamics_world)                                                                                       \
    CALL(coriolis_matrix)                                                                                              \
    CALL(inverse_dynamics_derivatives)                                                                                 \
    CALL(forward_dynamics_derivatives)                                                                                 \
    CALL(kinetic_energy)                                                                                               \
    CALL(potential_energy)                                                                                             \
    CALL(momentum)                                                                                                     \
    CALL(coriolis)                                                                                                     \
    CALL(momentum_observer_term)                                                                                       \
    CALL(forward_kinematics)                                                                                           \
    CALL(link_poses)                                                                                                   \
    CALL(jacobian)                                                                                                     \
    CALL(tool_jacobian)                                                                                                \
    CALL(jacobian_and_forward_kinematics)                                                                              \
    CALL(jacobian_dot_qd)                                                                                              \
    CALL(inverse_mass_matrix)                                                                                          \
    CALL(lambda_inverse)                                                                                               \
    CALL(regressor)
