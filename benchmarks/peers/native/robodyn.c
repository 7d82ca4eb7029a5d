/* Our kernel, one state a call, or all in one, in blocks of BATCH states. HEADER, REAL, KERNEL:
 * of the kernel; GIVEN: sines and cosines are in given.bin. Of another function than the inverse dynamics:
 * SIZE, numbers of its results; ARGUMENTS(k) and RESULTS(k) of the state k. */
#include HEADER
#include "peer.h"

#ifdef BATCH
#define AT(k, j, size) (((k) / BATCH * (size) + (j)) * BATCH + (k) % BATCH)
#define ROOM (count + BATCH)
#else
#define ROOM count
#define AT(k, j, size) ((k) * (size) + (j))
#endif

#ifndef SIZE
#define SIZE n
#define ARGUMENTS(k) angle + (k) * width, qd + (k) * n, qdd + (k) * n
#define RESULTS(k) results + (k) * n
#endif

static int count, n, width;
static REAL *angle, *qd, *qdd, *results;

int peer_size(int joints)
{
    n = joints;
    return SIZE;
}

static REAL *kept(const double *from, int size)
{
    REAL *to = malloc((size_t)ROOM * (size_t)size * sizeof(REAL));
    int k, j;
    for (k = 0; k < count; k++)
        for (j = 0; j < size; j++)
            to[AT(k, j, size)] = (REAL)from[k * size + j];
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
    results = calloc((size_t)ROOM * (size_t)(SIZE), sizeof(REAL));
    return !results;
}

void peer_run(void)
{
#ifdef BATCH
    KERNEL((size_t)count, BATCH, angle, qd, qdd, results);
#else
    int k;
    for (k = 0; k < count; k++)
        KERNEL(ARGUMENTS(k), RESULTS(k));
#endif
}

void peer_result(double *out)
{
    int k, j;
    for (k = 0; k < count; k++)
        for (j = 0; j < SIZE; j++)
            out[k * (SIZE) + j] = (double)results[AT(k, j, SIZE)];
}
