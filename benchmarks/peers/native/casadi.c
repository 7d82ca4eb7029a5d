/* C that CasADi has generated (FUNCTION), in its own calling convention. */
#include "peer.h"

int FUNCTION(const double **arg, double **res, long long int *iw, double *w, int mem);

static int count, n;
static const double *q, *qd, *qdd;
static double *tau, *work;

int peer_open(const char *folder, int states, int joints, const double *p, const double *v, const double *a)
{
    (void)folder;
    count = states;
    n = joints;
    q = peer_copy(p, (size_t)(count * n));
    qd = peer_copy(v, (size_t)(count * n));
    qdd = peer_copy(a, (size_t)(count * n));
    tau = calloc((size_t)(count * n), sizeof(double));
    work = calloc(65536, sizeof(double));
    return !tau || !work;
}

void peer_run(void)
{
    int k;
    for (k = 0; k < count; k++) {
        const double *arg[3];
        double *res[1];
        arg[0] = q + k * n;
        arg[1] = qd + k * n;
        arg[2] = qdd + k * n;
        res[0] = tau + k * n;
        FUNCTION(arg, res, 0, work, 0);
    }
}

void peer_result(double *out)
{
    int k;
    for (k = 0; k < count * n; k++)
        out[k] = tau[k];
}
