/* MuJoCo's mj_inverse on a compiled model (arm.mjb): contacts and constraints are switched off in it. */
#include "peer.h"
#include <mujoco/mujoco.h>

static int count, n;
static const double *q, *qd, *qdd;
static double *tau;
static mjModel *model;
static mjData *data;

static void quiet(const char *message)
{
    (void)message; /* it warns of a singular mass matrix, which inverse dynamics does not need */
}

int peer_open(const char *folder, int states, int joints, const double *p, const double *v, const double *a)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/arm.mjb", folder);
    mju_user_warning = quiet;
    model = mj_loadModel(path, 0);
    count = states;
    n = joints;
    if (!model || model->nv != n)
        return 1;
    data = mj_makeData(model);
    q = peer_copy(p, (size_t)(count * n));
    qd = peer_copy(v, (size_t)(count * n));
    qdd = peer_copy(a, (size_t)(count * n));
    tau = calloc((size_t)(count * n), sizeof(double));
    return !tau || !data;
}

void peer_run(void)
{
    int k, i;
    for (k = 0; k < count; k++) {
        for (i = 0; i < n; i++) {
            data->qpos[i] = q[k * n + i];
            data->qvel[i] = qd[k * n + i];
            data->qacc[i] = qdd[k * n + i];
        }
        mj_inverse(model, data);
        for (i = 0; i < n; i++)
            tau[k * n + i] = data->qfrc_inverse[i];
    }
}

void peer_result(double *out)
{
    int k;
    for (k = 0; k < count * n; k++)
        out[k] = tau[k];
}
