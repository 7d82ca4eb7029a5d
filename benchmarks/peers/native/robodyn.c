/* Our kernel, one state a call. HEADER, REAL, KERNEL: of the kernel; GIVEN: sines and cosines are in given.bin. */
#include HEADER
#include "peer.h"

static int count, n, width;
static REAL *angle, *qd, *qdd, *tau;

static REAL *kept(const double *from, int size)
{
    REAL *to = malloc((size_t)count * (size_t)size * sizeof(REAL));
    int k;
    for (k = 0; k < count * size; k++)
        to[k] = (REAL)from[k];
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
        angle = kept(sc, width);
        free(sc);
        (void)q;
    }
#else
    (void)folder;
    angle = kept(q, n);
#endif
    qd = kept(v, n);
    qdd = kept(a, n);
    tau = calloc((size_t)count * (size_t)n, sizeof(REAL));
    return !tau;
}

void peer_run(void)
{
    int k;
    for (k = 0; k < count; k++)
        KERNEL(angle + k * width, qd + k * n, qdd + k * n, tau + k * n);
}

void peer_result(double *out)
{
    int k;
    for (k = 0; k < count * n; k++)
        out[k] = (double)tau[k];
}
