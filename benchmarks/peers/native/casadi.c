/* C that CasADi has generated (FUNCTION), in its own calling convention; all its results, SIZE of them (not there: one
 * a joint), are one array. */
#include "peer.h"

int FUNCTION(const double **arg, double **res, long long int *iw, double *w, int mem);

#ifndef SIZE
#define SIZE n
#endif

static int count, n;
static const double *q, *qd, *qdd;
static double *results, *work;

int peer_size(int joints)
{
    n = joints;
    return SIZE;
}

int peer_open(const char *folder, int states, int joints, const double *p, const double *v, const double *a)
{
    (void)folder;
    count = states;
    n = joints;
    q = peer_copy(p, (size_t)(count * n));
    qd = peer_copy(v, (size_t)(count * n));
    qdd = peer_copy(a, (size_t)(count * n));
    results = calloc((size_t)count * (size_t)(SIZE), sizeof(double));
    work = calloc(65536, sizeof(double));
    return !results || !work;
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
        res[0] = results + k * (SIZE);
        FUNCTION(arg, res, 0, work, 0);
    }
}

void peer_result(double *out)
{
    int k;
    for (k = 0; k < count * (SIZE); k++)
        out[k] = results[k];
}
