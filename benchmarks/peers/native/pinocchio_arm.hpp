// The arm as Pinocchio's model.
#pragma once
#include <pinocchio/multibody.hpp>

#include "peer.h"

template <typename Model = pinocchio::Model> Model pinocchio_arm(const peer_arm &arm)
{
    using Joints = typename Model::JointCollection;
    using Matrix = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
    Model model;
    model.gravity.linear() = Eigen::Map<const Eigen::Vector3d>(arm.gravity);
    pinocchio::JointIndex parent = 0;
    for (int i = 0; i < arm.n; i++) {
        const peer_link &link = arm.link[i];
        const pinocchio::SE3 place(Eigen::Map<const Matrix>(link.rotation), Eigen::Map<const Eigen::Vector3d>(link.position));
        const std::string name = "joint" + std::to_string(i + 1);
        parent = link.revolute != 0 ? model.addJoint(parent, typename Joints::JointModelRZ(), place, name)
                                    : model.addJoint(parent, typename Joints::JointModelPZ(), place, name);
        const Eigen::Matrix3d inertia = Eigen::Map<const Matrix>(link.inertia);
        const pinocchio::Inertia body(link.mass, Eigen::Map<const Eigen::Vector3d>(link.com), inertia);
        model.appendBodyToJoint(parent, body, pinocchio::SE3::Identity());
    }
    for (int i = 0; i < arm.n; i++)
        model.armature[i] = arm.link[i].rotor;
    return model;
}
