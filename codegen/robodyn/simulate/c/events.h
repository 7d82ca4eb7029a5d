/* Where in a step an element comes to rest or breaks away, and what happens there. */
#ifndef EVENTS_H
#define EVENTS_H
#include "step.h"

/* The least of the speeds of what slides, in its direction, and of the margins of what is stuck; negative if any
 * has passed its end. Margins count `with_margins`, which needs the acceleration at x. */
static double least(run *r, const double *x, double h, int with_margins) {
    double least = 1e300, margin[E1], way[E1];
    int stuck = 0;
    for (int e = 0; e < E; e++) {
        if (r->s[e] == 0) {
            stuck = 1;
            continue;
        }
        double along = r->s[e] * speed(e, x + V);
        if (r->rest[e]) along += 1e-12 * h * lost(r, e); /* has only just been let go */
        if (along < least) least = along;
    }
    if (!stuck || !with_margins || r->hold) return least;
    margins(r, x, margin, way);
    for (int e = 0; e < E; e++)
        if (r->s[e] == 0 && margin[e] < least) least = margin[e];
    return least;
}

/* The part of the step that was made (from t, of length h) after which something has passed its end; 0: nothing has. */
static double passed(run *r, double h) {
    int adaptive = r->is.method == 1;
    double right = least(r, r->end, h, adaptive) < 0 ? 1 : 0, x[SIZE];
    if (!adaptive) return right;
    for (int quarter = 1; quarter < 4; quarter++) {
        int with_margins = quarter == 2 && r->stuck.count > 0 && !r->hold;
        interpolated(r, quarter / 4., x);
        if (with_margins && !acceleration(r, r->t + quarter / 4. * h, x)) continue;
        if (least(r, x, h, with_margins) < 0) return quarter / 4.;
    }
    return right;
}

/* Shorten the step to the first instant at which something has passed its end; its length, 0: no acceleration. */
static double locate(run *r, double h, double right) {
    double left = 0, before = 0, after = 0, last = -1;
    for (int k = 0; k < 100 && (right - left) * h > 1e-14 * fabs(r->t) + 1e-13 * h; k++) {
        double part = (left + right) / 2;
        if (before > 0 && after < 0 && k % 4 != 3) {
            part = (left * after - right * before) / (after - before);
            if (!(part > left && part < right)) part = (left + right) / 2;
        }
        if (!attempt(r, part * h)) return 0;
        last = part;
        double value = least(r, r->end, h, r->is.method == 1);
        if (value < 0) {
            if (right == part || after < 0) before /= 2;
            right = part;
            after = value;
        } else {
            if (before > 0) after /= 2;
            left = part;
            before = value > 0 ? value : 1e-300;
        }
    }
    if (last != right && !attempt(r, right * h)) return 0;
    return right * h;
}

/* What has come to a halt is at rest from here on. */
static void land(run *r) {
    for (int e = 0; e < E; e++) {
        double u = speed(e, r->x + V);
        if (r->s[e] != 0 && (r->s[e] * u <= 0 || (!r->rest[e] && fabs(u) <= 1e-9 * fabs(r->moved[e])))) {
            r->rest[e] = 1;
            r->s[e] = 0;
        }
    }
    span(r);
    project(r, r->x);
    r->landing = 0;
    r->counter[EVENTS]++;
    if (++r->burst > 20 + 4 * E) r->hold = 1;
}
#endif
