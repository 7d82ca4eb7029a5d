/* Runs of a mechanical system with dry friction: see system.h for the system, settings.h for what can be asked.
 * Fixed steps end on the samples, adaptive ones are interpolated.
 */
#include <stdlib.h>
#include "advance.h"

enum { ROW = 1 + 3 * N + K + E + 2 };

static double *put(double *to, const double *from, int count) {
    memcpy(to, from, sizeof(double) * (size_t)count);
    return to + count;
}

static void record(run *r, double t, const double *x) {
    double *to = r->is.record + r->recorded++ * (ROW + 2 * r->is.motors);
    *to++ = t;
    to = put(to, x, 2 * N);
    to = put(to, r->a, N);
    to = put(to, x + Z, K);
    to = put(to, r->s, E);
    to = put(to, r->command, r->is.motors);
    to = put(to, r->applied, r->is.motors);
    put(to, x + WORK, 2);
}

/* Go on to the end, or for about so many evaluations of the acceleration; 0 if all is well. */
int run_advance(run *r, long evaluations) {
    long enough = r->counter[EVALUATIONS] + evaluations;
    while (r->status == GOING && r->recorded < r->samples && r->counter[EVALUATIONS] < enough) {
        double due = (double)r->recorded * r->is.sample_period, x[SIZE];
        if (due < r->t - nearness(r)) {
            interpolated(r, (due - r->from) / r->length, x);
            still(r, x + V);
            if (!acceleration(r, due, x)) failed(r, NO_ACCELERATION);
            else record(r, due, x);
            continue;
        }
        double next;
        if (!prepared(r, &next)) break;
        if (due <= r->t + nearness(r)) {
            if (r->is.control == LINEAR) torques(r, r->t, r->x);
            memcpy(r->a, r->k[0] + V, sizeof r->a);
            record(r, due, r->x);
            continue;
        }
        step(r, r->is.method == 0 && due < next ? due : next);
    }
    return r->status;
}

run *run_new(const settings *is) {
    run *r = calloc(1, sizeof *r);
    if (r == NULL) return NULL;
    begin(r, is);
    r->samples = (long)floor(is->duration / is->sample_period + 1e-9) + 1;
    r->finish = (double)(r->samples - 1) * is->sample_period;
    return r;
}

void run_free(run *r) { free(r); }
double run_time(const run *r) { return r->t; }
long run_samples(const run *r) { return r->samples; }
long run_recorded(const run *r) { return r->recorded; }
long run_counter(const run *r, int which) { return r->counter[which]; }

int engine_size(int which) {
    const int size[] = {N, E, K, SYSTEM_PARAMETERS, SYSTEM_CONSERVED, SYSTEM_MODEL};
    return size[which];
}

int model_torques(long rows, const double *q, const double *qd, const double *qdd, double *tau, int motors,
                  const double *parameters) {
#if SYSTEM_MODEL
    for (long k = 0; k < rows; k++) {
        long at = k * motors;
        system_model(q + at, qd + at, qdd + at, tau + at, parameters);
    }
    return 0;
#else
    (void)rows, (void)q, (void)qd, (void)qdd, (void)tau, (void)motors, (void)parameters;
    return 1;
#endif
}
