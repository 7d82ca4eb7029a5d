/* Our batch kernel, all states in one call, every joint's values one after another. HEADER, REAL, KERNEL. */
#include HEADER
#include "peer.h"

static int count, n, width;
static REAL *angle, *qd, *qdd, *tau;

static REAL *columns(const double *from, int size)
{
    REAL *to = malloc((size_t)count * (size_t)size * sizeof(REAL));
    int k, j;
    for (j = 0; j < size; j++)
        for (k = 0; k < count; k++)
            to[j * count + k] = (REAL)from[k * size + j];
    return to;
}

int peer_open(const char *folder, int states, int joints, const double *q, const double *v, const double *a)
{
    count = states;
    n = width = joints;
#ifdef GIVEN
    {
        char path[4096];
        double *sc;
        FILE *file;
        size_t wanted;
        width = GIVEN;
        wanted = (size_t)count * (size_t)width;
        snprintf(path, sizeof path, "%s/given.bin", folder);
        file = fopen(path, "rb");
        sc = malloc(wanted * sizeof(double));
        if (!file || !sc || fread(sc, sizeof(double), wanted, file) != wanted)
            return 1;
        fclose(file);
        angle = columns(sc, width);
        free(sc);
        (void)q;
    }
#else
    (void)folder;
    angle = columns(q, n);
#endif
    qd = columns(v, n);
    qdd = columns(a, n);
    tau = calloc((size_t)count * (size_t)n, sizeof(REAL));
    return !tau;
}

void peer_run(void)
{
    KERNEL((size_t)count, (size_t)count, angle, qd, qdd, tau);
}

void peer_result(double *out)
{
    int k, j;
    for (k = 0; k < count; k++)
        for (j = 0; j < n; j++)
            out[k * n + j] = (double)tau[j * count + k];
}
