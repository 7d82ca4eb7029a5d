/*
 * What every runner in this folder offers to the harness, and the arm that they are given.
 *
 * A runner takes the states once and may keep them in its own layout; peer_run, which is what is timed, computes
 * the results of all of them in a loop, torques where nothing else is said; peer_result hands them out.
 */
#ifndef PEER_H
#define PEER_H

#include <stdio.h>
#include <stdlib.h>

#ifdef __cplusplus
extern "C" {
#endif

/* folder: where arm.txt (and what else a runner needs) lies; q, qd, qdd: [count][n]. 0, or not for an error. */
int peer_open(const char *folder, int count, int n, const double *q, const double *qd, const double *qdd);
void peer_run(void);
void peer_result(double *results); /* [count][peer_size] */
int peer_size(int n);              /* numbers that a state has; not there: n */

/* Links as robodyn.report.peers.numbers writes them; angles as (radians, cosine, sine). */
typedef struct {
    double revolute, alpha[3], a, d, theta[3], mass, com[3], inertia[9], rotor, rotation[9], position[3];
} peer_link;

typedef struct {
    int n;
    double gravity[3];
    peer_link link[64];
} peer_arm;

#define PEER_NUMBERS ((int)(sizeof(peer_link) / sizeof(double)))

static inline int peer_read_arm(const char *folder, peer_arm *arm)
{
    char path[4096];
    double n;
    FILE *file;
    int i, k, good;
    snprintf(path, sizeof path, "%s/arm.txt", folder);
    file = fopen(path, "r");
    if (!file)
        return 1;
    good = fscanf(file, "%lf %lf %lf %lf", &n, &arm->gravity[0], &arm->gravity[1], &arm->gravity[2]) == 4;
    arm->n = (int)n;
    good = good && arm->n >= 1 && arm->n <= 64;
    for (i = 0; good && i < arm->n; i++)
        for (k = 0; good && k < PEER_NUMBERS; k++)
            good = fscanf(file, "%lf", (double *)&arm->link[i] + k) == 1;
    fclose(file);
    return !good;
}

static inline void *peer_copy(const double *from, size_t count)
{
    double *to = (double *)malloc(count * sizeof(double));
    size_t k;
    for (k = 0; to && k < count; k++)
        to[k] = from[k];
    return to;
}

#ifdef __cplusplus
}
#endif

#endif
