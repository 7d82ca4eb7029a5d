// A function of Pinocchio (FUNCTION, of pinocchio_functions.hpp), states in Eigen's vectors from the start, results
// stored as ours are.
#include "pinocchio_functions.hpp"

#include <memory>
#include <vector>

using Function = functions::FUNCTION;

static std::vector<Eigen::VectorXd> q, v, a;
static std::vector<double> results;
static std::unique_ptr<Arm<double>> arm;

extern "C" int peer_size(int n) { return Function::size(n); }

extern "C" int peer_open(const char *folder, int count, int n, const double *p, const double *pv, const double *pa)
{
    peer_arm numbers;
    if (peer_read_arm(folder, &numbers) || numbers.n != n)
        return 1;
    arm = std::make_unique<Arm<double>>(pinocchio_arm(numbers));
    for (int k = 0; k < count; k++) {
        q.push_back(Eigen::Map<const Eigen::VectorXd>(p + k * n, n));
        v.push_back(Eigen::Map<const Eigen::VectorXd>(pv + k * n, n));
        a.push_back(Eigen::Map<const Eigen::VectorXd>(pa + k * n, n));
    }
    results.resize(static_cast<std::size_t>(count) * Function::size(n));
    return 0;
}

extern "C" void peer_run(void)
{
    const std::size_t size = results.size() / q.size();
    for (std::size_t k = 0; k < q.size(); k++)
        Function::run(*arm, q[k], v[k], a[k], results.data() + k * size);
}

extern "C" void peer_result(double *out)
{
    for (const double x : results)
        *out++ = x;
}
