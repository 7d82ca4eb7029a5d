// What the runners of inverse kinematics share: poses and positions as the harness hands them over, solutions as it
// takes them back. A state has TWELVE numbers: q is the pose, [R p] row by row, and qd the positions from which a
// redundant joint takes its own, the rest 0. A state's results: how many solutions, then SLOTS of
// them, n numbers each; more than SLOTS are left out, the number says so.
#pragma once
#include "peer.h"

#include <Eigen/Dense>

#include <fstream>
#include <string>
#include <vector>

constexpr int TWELVE = 12;

inline Eigen::Matrix4d pose_of(const double *T)
{
    Eigen::Matrix4d pose = Eigen::Matrix4d::Identity();
    for (int i = 0; i < TWELVE; i++)
        pose(i / 4, i % 4) = T[i];
    return pose;
}

template <class Row> inline void hand_out(double *&out, int count, int n, Row row)
{
    *out++ = count;
    for (int slot = 0; slot < SLOTS; slot++)
        for (int joint = 0; joint < n; joint++)
            *out++ = slot < count ? row(slot)[joint] : 0.0;
}
