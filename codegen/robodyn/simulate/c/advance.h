/* From step to step: what is due before one, how long it is, and a run before its first.
 *
 * Fixed steps look for elements that come to rest inside a step, and end it there; whether one that rests breaks
 * away is decided where steps start. Adaptive steps end on both. Steps also end on control instants and breaks, so
 * that no jump of a torque lies inside one.
 */
#ifndef ADVANCE_H
#define ADVANCE_H
#include "events.h"

static int failed(run *r, int status) {
    r->status = status;
    return 0;
}

/* Why there is no acceleration: what is not finite has been met before. */
static int missing(const run *r) {
    for (int i = 0; i < N; i++)
        if (!(fabs(r->a[i]) <= 1e300)) return NOT_FINITE;
    return NO_ACCELERATION;
}

/* The slopes at t, under the directions that hold from there on. */
static int ready(run *r) {
    if (r->known) return 1;
    if (!finite(r->x)) return failed(r, NOT_FINITE);
    if (!decide(r, r->t, r->x)) return failed(r, NO_ACCELERATION);
    collect(r, r->x, r->k[0]);
    r->known = 1;
    return finite(r->k[0]) ? 1 : failed(r, NOT_FINITE);
}

/* A step that is accurate enough to r->end; its length, and in `whole` whether that is all of `rest`. 0: failed. */
static double adaptive_step(run *r, double rest, int *whole) {
    double h = r->h > 0 ? r->h : first_length(r);
    int tried = 0;
    if (h > r->is.step) h = r->is.step;
    *whole = 1.01 * h >= rest;
    if (*whole) h = rest;
    else if (2 * h > rest) h = rest / 2;
    for (;;) {
        int ok = attempt(r, h);
        r->counter[STEPS]++;
        if (ok && r->error <= 1 && finite(r->end)) break;
        r->counter[REJECTED]++;
        tried = 1;
        double by = ok && r->error <= 1e300 ? 0.9 * pow(r->error, -0.2) : 0.2;
        h *= by > 0.2 ? by : 0.2;
        *whole = 0;
        if (h < 1e-15 * (1 + fabs(r->t)))
            return failed(r, !ok ? missing(r) : finite(r->end) ? STEP_TOO_SMALL : NOT_FINITE);
        if (r->counter[STEPS] >= r->is.max_steps) return failed(r, TOO_MANY_STEPS);
    }
    double error = r->error > 1e-10 ? r->error : 1e-10, by = pow(error, 0.17) / pow(r->last_error, 0.04) / 0.9;
    by = by < 0.1 ? 0.1 : by > 5 ? 5 : by;
    if (tried && by < 1) by = 1;
    double next = h / by;
    r->h = *whole && next < r->h ? r->h : next;
    r->last_error = error > 1e-4 ? error : 1e-4;
    return h;
}

static double fixed_step(run *r, double rest, int *whole) {
    double count = ceil(rest / r->is.step - 1e-9);
    if (count < 1) count = 1;
    count *= parts(r, rest / count);
    *whole = count == 1;
    r->counter[STEPS]++;
    if (!attempt(r, rest / count)) return failed(r, missing(r));
    return finite(r->end) ? rest / count : failed(r, NOT_FINITE);
}

/* One step, to `until` at the most. */
static int step(run *r, double until) {
    int whole, adaptive = r->is.method == 1, again = 0, idle = 0;
    if (r->counter[STEPS] >= r->is.max_steps) return failed(r, TOO_MANY_STEPS);
    double h = adaptive ? adaptive_step(r, until - r->t, &whole) : fixed_step(r, until - r->t, &whole);
    if (h == 0) return 0;
    if (adaptive) remember(r, h);
    if (E > 0) {
        double right = passed(r, h);
        if (right > 0) {
            h = locate(r, h, right);
            if (h == 0) return failed(r, NO_ACCELERATION);
            if (adaptive) remember(r, h);
            r->landing = 1;
            r->h = 0;
            whole = 0;
        }
        for (int e = 0; e < E; e++) {
            double u = speed(e, r->end + V);
            r->moved[e] = u - speed(e, r->x + V);
            if (!r->rest[e] || r->s[e] == 0) continue;
            again = 1;
            if (r->s[e] * u > 1e-12 * h * lost(r, e)) continue;
            idle = 1; /* let go, but others hold it */
            r->s[e] = 0;
        }
    }
    memcpy(r->x, r->end, sizeof r->x);
    r->t = whole ? until : r->t + h;
    if (!r->landing) {
        r->burst = r->hold = 0;
        if (idle) span(r);
        if (r->stuck.rows > 0) project(r, r->x);
    }
    r->known = adaptive && !whole && !r->landing && !again;
    if (r->known) memcpy(r->k[0], r->k[STAGES - 1], sizeof r->k[0]);
    return 1;
}

/* All that is due at t, and the slopes from there on; `next` is where the next step ends at the latest. 0: failed. */
static int prepared(run *r, double *next) {
    if (r->landing) land(r);
    update(r);
    *next = next_jump(r);
    r->until = nextafter(*next, -HUGE_VAL);
    return ready(r);
}

/* A run that stands at its start. */
static void begin(run *r, const settings *is) {
    r->is = *is;
    r->last_error = 1e-4;
    memcpy(r->x, is->y, sizeof(double) * N);
    memcpy(r->x + V, is->v, sizeof(double) * N);
    if (K > 0) memcpy(r->x + Z, is->z, sizeof(double) * K);
    for (int e = 0; e < E; e++) {
        int entries = 0;
        r->unit[e] = -1;
        r->square[e] = dot(system_w[e], system_w[e]);
        for (int i = 0; i < N; i++)
            if (system_w[e][i] != 0) entries++, r->unit[e] = i;
        if (entries != 1) r->unit[e] = -1;
        /* elements of one colour have no coordinate in common */
        for (int colour = 0; colour <= e; colour++) {
            int clash = 0;
            for (int other = 0; other < e; other++)
                for (int i = 0; i < N && r->colour[other] == colour; i++)
                    clash |= system_w[other][i] != 0 && system_w[e][i] != 0;
            if (clash) continue;
            r->colour[e] = colour;
            if (colour >= r->colours) r->colours = colour + 1;
            break;
        }
    }
}
#endif
