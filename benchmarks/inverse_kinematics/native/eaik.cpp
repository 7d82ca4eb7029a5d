// EAIK's inverse kinematics, poses and solutions in its own types from the start. Its robot is made once, or where a
// joint is locked at positions that change from pose to pose, once for each.
#include "inverse.hpp"

#include "EAIK.h"

#include <memory>
#include <stdexcept>

static std::vector<IKS::Homogeneous_T> poses;
static std::vector<std::unique_ptr<EAIK::Robot>> robots;
static std::vector<IKS::IK_Solution> solutions;
static int joints;

// axes.txt: how many joints, which is locked (-1: none), the axes, the offsets from one to the next, the tool's
// rotation, all by rows.
extern "C" int peer_open(const char *folder, int count, int n, const double *T, const double *near, const double *)
{
    std::ifstream file(std::string(folder) + "/axes.txt");
    int locked;
    if (!(file >> joints >> locked) || n != TWELVE)
        return 1;
    Eigen::MatrixXd H(3, joints), P(3, joints + 1);
    Eigen::Matrix3d tool;
    for (int i = 0; i < 3 * joints; i++)
        file >> H(i % 3, i / 3);
    for (int i = 0; i < 3 * (joints + 1); i++)
        file >> P(i % 3, i / 3);
    for (int i = 0; i < 9; i++)
        file >> tool(i / 3, i % 3);
    if (!file)
        return 1;
    bool same = true;
    for (int k = 0; k < count; k++) {
        poses.push_back(pose_of(T + k * n));
        same = same && (locked < 0 || near[k * n + locked] == near[locked]);
    }
    for (int k = 0; k < (same ? 1 : count); k++) {
        std::vector<std::pair<int, double>> fixed;
        if (locked >= 0)
            fixed.emplace_back(locked, near[k * n + locked]);
        robots.push_back(std::make_unique<EAIK::Robot>(H, P, tool, fixed, true));
        if (!robots.back()->has_known_decomposition())
            return 1;
    }
    solutions.resize(count);
    return 0;
}

extern "C" void peer_run(void)
{
    const bool same = robots.size() == 1;
    for (std::size_t k = 0; k < poses.size(); k++)
        solutions[k] = robots[same ? 0 : k]->calculate_IK(poses[k]);
}

extern "C" int peer_size(int)
{
    return 1 + SLOTS * joints;
}

extern "C" void peer_result(double *out)
{
    for (const auto &solution : solutions) {
        std::vector<const double *> exact;
        for (std::size_t i = 0; i < solution.Q.size(); i++)
            if (!solution.is_LS_vec[i])
                exact.push_back(solution.Q[i].data());
        hand_out(out, (int)exact.size(), joints, [&](int slot) { return exact[slot]; });
    }
}
