/* Torques: what the control commands, what the drives apply, what acts on the coordinates. */
#ifndef CONTROL_H
#define CONTROL_H
#include <math.h>
#include "run.h"

enum { HELD, LINEAR, PD, COMPUTED };

/* Instants nearer than this are one. */
static double nearness(const run *r) { return 1e-12 * (1 + fabs(r->t)); }

static const double *row_of(const run *r, const double *table, long instant) {
    long last = r->is.rows - 1;
    return table + (instant < last ? instant : last) * r->is.motors;
}

static double clipped(const run *r, int j, double torque) {
    if (r->is.limit == NULL) return torque;
    double limit = r->is.limit[j];
    return torque > limit ? limit : torque < -limit ? -limit : torque;
}

static void control(run *r, long instant) {
    const settings *is = &r->is;
    double q[N], qd[N];
    for (int j = 0; j < is->motors; j++) {
        q[j] = r->x[is->seen[j]];
        qd[j] = r->x[V + is->seen[j]];
    }
    if (is->control == HELD || is->control == LINEAR) {
        for (int j = 0; j < is->motors; j++) r->command[j] = row_of(r, is->torque, instant)[j];
    } else {
        const double *want = row_of(r, is->q, instant), *rate = row_of(r, is->qd, instant);
        if (is->control == PD) {
            const double *ahead = row_of(r, is->torque, instant);
            for (int j = 0; j < is->motors; j++)
                r->command[j] = ahead[j] + is->kp[j] * (want[j] - q[j]) + is->kd[j] * (rate[j] - qd[j]);
        } else {
#if SYSTEM_MODEL
            const double *second = row_of(r, is->qdd, instant);
            double qdd[N];
            for (int j = 0; j < is->motors; j++)
                qdd[j] = second[j] + is->kd[j] * (rate[j] - qd[j]) + is->kp[j] * (want[j] - q[j]);
            system_model(q, qd, qdd, r->command, is->parameters);
#endif
        }
    }
    for (int j = 0; j < is->motors; j++) r->applied[j] = clipped(r, j, r->command[j]);
}

/* What is due at t: control, at once for the first time, and breaks. */
static void update(run *r) {
    double now = r->t + nearness(r);
    while (r->instant == 0 || (double)r->instant * r->is.period <= now) {
        control(r, r->instant);
        r->instant++;
        r->known = 0;
    }
    while (r->next_break < r->is.break_count && r->is.breaks[r->next_break] <= now) {
        r->next_break++;
        r->known = 0;
    }
}

/* The next time at which a torque may jump or bend, or the run's end. */
static double next_jump(const run *r) {
    double next = r->finish, due = (double)r->instant * r->is.period;
    if (due < next) next = due;
    if (r->next_break < r->is.break_count && r->is.breaks[r->next_break] < next) next = r->is.breaks[r->next_break];
    return next;
}

static void torques(run *r, double t, const double *x) {
    if (r->is.control == LINEAR) {
        long instant = r->instant > 0 ? r->instant - 1 : 0;
        double part = t / r->is.period - (double)instant;
        const double *left = row_of(r, r->is.torque, instant), *right = row_of(r, r->is.torque, instant + 1);
        for (int j = 0; j < r->is.motors; j++) {
            r->command[j] = left[j] + part * (right[j] - left[j]);
            r->applied[j] = clipped(r, j, r->command[j]);
        }
    }
#if SYSTEM_EXTERNAL
    system_external(t < r->until ? t : r->until, x, r->tau, r->is.parameters);
#else
    for (int i = 0; i < N; i++) r->tau[i] = 0;
    (void)x;
#endif
    for (int j = 0; j < r->is.motors; j++) r->tau[r->is.place[j]] += r->applied[j];
}
#endif
