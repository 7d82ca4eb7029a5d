// C++ that SymForce has generated (generated.h: sym::InverseDynamics), states in Eigen's vectors of fixed size.
#include "peer.h"

#include "generated.h"

#include <vector>

using Vector = Eigen::Matrix<double, JOINTS, 1>;
static std::vector<Vector, Eigen::aligned_allocator<Vector>> q, qd, qdd, tau;

extern "C" int peer_open(const char *, int count, int n, const double *p, const double *v, const double *a)
{
    if (n != JOINTS)
        return 1;
    for (int k = 0; k < count; k++) {
        q.push_back(Eigen::Map<const Vector>(p + k * n));
        qd.push_back(Eigen::Map<const Vector>(v + k * n));
        qdd.push_back(Eigen::Map<const Vector>(a + k * n));
        tau.push_back(Vector::Zero());
    }
    return 0;
}

extern "C" void peer_run(void)
{
    for (std::size_t k = 0; k < q.size(); k++)
        tau[k] = sym::InverseDynamics<double>(q[k], qd[k], qdd[k]);
}

extern "C" void peer_result(double *out)
{
    for (const auto &one : tau)
        for (int i = 0; i < JOINTS; i++)
            *out++ = one[i];
}
