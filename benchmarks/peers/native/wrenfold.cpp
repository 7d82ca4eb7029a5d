// C++ that wrenfold has generated (generated.h), on plain arrays: its spans are those few lines here.
#include "peer.h"

#include <cmath>

namespace wf {
template <int rows, int columns, typename T> struct span {
    T *data;
    T &operator()(int row, int) const { return data[row]; }
};
template <int rows, int columns> span<rows, columns, const double> make_input_span(const double *data)
{
    return {data};
}
template <int rows, int columns> span<rows, columns, double> make_output_span(double *data) { return {data}; }
} // namespace wf

#include "generated.h"

static int count, n;
static const double *q, *qd, *qdd;
static double *tau;

extern "C" int peer_open(const char *, int states, int joints, const double *p, const double *v, const double *a)
{
    count = states;
    n = joints;
    q = static_cast<double *>(peer_copy(p, static_cast<std::size_t>(count * n)));
    qd = static_cast<double *>(peer_copy(v, static_cast<std::size_t>(count * n)));
    qdd = static_cast<double *>(peer_copy(a, static_cast<std::size_t>(count * n)));
    tau = static_cast<double *>(std::calloc(static_cast<std::size_t>(count * n), sizeof(double)));
    return n != JOINTS || !tau;
}

extern "C" void peer_run(void)
{
    for (int k = 0; k < count; k++)
        inverse_dynamics<double>(q + k * n, qd + k * n, qdd + k * n, tau + k * n);
}

extern "C" void peer_result(double *out)
{
    for (int k = 0; k < count * n; k++)
        out[k] = tau[k];
}
