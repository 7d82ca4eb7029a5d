// Pinocchio's rnea, states and torques in Eigen's vectors from the start.
#include "pinocchio_arm.hpp"
#include <pinocchio/algorithm/rnea.hpp>

#include <memory>
#include <vector>

static std::vector<Eigen::VectorXd> q, qd, qdd, tau;
static std::unique_ptr<pinocchio::Model> model;
static std::unique_ptr<pinocchio::Data> data;

extern "C" int peer_open(const char *folder, int count, int n, const double *p, const double *v, const double *a)
{
    peer_arm arm;
    if (peer_read_arm(folder, &arm) || arm.n != n)
        return 1;
    model = std::make_unique<pinocchio::Model>(pinocchio_arm(arm));
    data = std::make_unique<pinocchio::Data>(*model);
    for (int k = 0; k < count; k++) {
        q.push_back(Eigen::Map<const Eigen::VectorXd>(p + k * n, n));
        qd.push_back(Eigen::Map<const Eigen::VectorXd>(v + k * n, n));
        qdd.push_back(Eigen::Map<const Eigen::VectorXd>(a + k * n, n));
        tau.push_back(Eigen::VectorXd::Zero(n));
    }
    return 0;
}

extern "C" void peer_run(void)
{
    for (std::size_t k = 0; k < q.size(); k++)
        tau[k] = pinocchio::rnea(*model, *data, q[k], qd[k], qdd[k]);
}

extern "C" void peer_result(double *out)
{
    for (const auto &one : tau)
        for (Eigen::Index i = 0; i < one.size(); i++)
            *out++ = one[i];
}
