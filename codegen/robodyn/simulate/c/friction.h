/* Dry friction as a set-valued law: which elements stick, and which way the others go. */
#ifndef FRICTION_H
#define FRICTION_H
#include "motion.h"

static double speed(int e, const double *v) { return dot(system_w[e], v); }

static double magnitude(int e, const double *v) {
    double sum = 0;
    for (int i = 0; i < N; i++) sum += fabs(system_w[e][i] * v[i]);
    return sum;
}

/* A basis of the rows of what is stuck; coordinates that are stuck themselves come first. */
static void span(run *r) {
    basis *b = &r->stuck;
    double part[E1][N], length[E1];
    b->count = b->rows = 0;
    for (int round = 0; round < 2; round++)
        for (int e = 0; e < E; e++) {
            if (!r->rest[e] || r->s[e] != 0 || (r->unit[e] >= 0) != (round == 0)) continue;
            double *left = part[b->rows];
            memcpy(left, system_w[e], sizeof part[0]);
            for (int twice = 0; twice < 2; twice++)
                for (int k = 0; k < b->rows; k++) {
                    double factor = dot(left, part[k]) / length[k];
                    for (int i = 0; i < N; i++) left[i] -= factor * part[k][i];
                }
            b->stuck[b->count++] = e;
            length[b->rows] = dot(left, left);
            if (length[b->rows] > 1e-20 * r->square[e]) b->row[b->rows++] = e;
        }
    if (b->rows == b->count) return;
    /* w = coefficient w_row, by w_row w_row^T; then the normal equations of what is least */
    for (int i = 0; i < b->rows; i++)
        for (int j = 0; j < b->rows; j++) b->normal[i][j] = dot(system_w[b->row[i]], system_w[b->row[j]]);
    if (!ldl_factor(b->rows, E1, b->normal[0], b->inverse)) return;
    for (int i = 0; i < b->count; i++) {
        for (int j = 0; j < b->rows; j++) b->coefficient[i][j] = dot(system_w[b->stuck[i]], system_w[b->row[j]]);
        ldl_solve(b->rows, E1, b->normal[0], b->inverse, b->coefficient[i]);
    }
    for (int i = 0; i < b->rows; i++)
        for (int j = 0; j < b->rows; j++) {
            b->normal[i][j] = 0;
            for (int k = 0; k < b->count; k++) b->normal[i][j] += b->coefficient[k][i] * b->coefficient[k][j];
        }
    ldl_factor(b->rows, E1, b->normal[0], b->inverse);
}

static void friction(run *r, const double *x, const double *s, double *f) {
#if SYSTEM_AFFINE
    system_bias(x, x + V, s, x + Z, f, r->is.parameters);
#else
    system_force(x, x + V, r->a, s, x + Z, f, r->is.parameters);
#endif
}

/* How far the multiplier of each stuck element is inside its band, negative outside, as part of the band; and the
 * way it would go. r->force, r->a and r->lambda are those of x. */
static void margins(run *r, const double *x, double *margin, double *way) {
    for (int colour = 0; colour < r->colours; colour++) {
        double s[E1], low[N], high[N];
        int any = 0;
        memcpy(s, r->s, sizeof s);
        for (int e = 0; e < E; e++)
            if (r->rest[e] && r->s[e] == 0 && r->colour[e] == colour) any = 1, s[e] = 1;
        if (!any) continue;
        friction(r, x, s, high);
        for (int e = 0; e < E; e++)
            if (s[e] != r->s[e]) s[e] = -1;
        friction(r, x, s, low);
        for (int e = 0; e < E; e++) {
            if (s[e] == r->s[e]) continue;
            double lo = 0, hi = 0, lambda = r->lambda[e];
            for (int i = 0; i < N; i++) {
                lo += system_w[e][i] * (low[i] - r->force[i]);
                hi += system_w[e][i] * (high[i] - r->force[i]);
            }
            lo /= r->square[e];
            hi /= r->square[e];
            double size = fabs(lo) + fabs(hi), inside = hi - lambda < lambda - lo ? hi - lambda : lambda - lo;
            way[e] = hi - lambda < lambda - lo ? 1 : -1;
            margin[e] = size > 0 ? inside / size + 1e-13 : lambda == 0 ? 1e-13 : -fabs(lambda);
        }
    }
}

/* What is lost in rounding of the acceleration of element e. */
static double lost(const run *r, int e) {
    double sum = magnitude(e, r->a);
    for (int b = 0; b < r->stuck.rows; b++) sum += fabs(r->mu[b]) * magnitude(e, r->X[b]);
    return sum;
}

/* Directions at (t, x), and the acceleration. From all that rests being stuck, one element changes at a time: the
 * worst, later the first, of those whose multiplier is outside its band or that move off against their direction. */
static int decide(run *r, double t, const double *x) {
    int resting = 0;
    for (int e = 0; e < E; e++) {
        double u = speed(e, x + V);
        r->rest[e] = (r->rest[e] && r->s[e] == 0) || fabs(u) <= 1e-13 * magnitude(e, x + V);
        r->s[e] = r->rest[e] ? 0 : u > 0 ? 1 : -1;
        resting += r->rest[e];
    }
    if (E == 0) return acceleration(r, t, x);
    if (resting == 0 && r->stuck.count == 0) return acceleration(r, t, x);
    for (int change = 0; change < 8 * E + 64; change++) {
        double margin[E1], way[E1], worst = 0;
        int chosen = -1;
        span(r);
        memset(r->mu, 0, sizeof r->mu);
        if (!acceleration(r, t, x)) return 0;
        if (resting == 0 || r->hold) return 1;
        margins(r, x, margin, way);
        for (int e = 0; e < E; e++) {
            double wrong = 0;
            if (!r->rest[e]) continue;
            if (r->s[e] == 0) wrong = -margin[e];
            else if (r->s[e] * speed(e, r->a) < -1e-10 * lost(r, e)) wrong = 1e300;
            if (wrong > worst && (chosen < 0 || change < 3 * E)) chosen = e, worst = wrong;
        }
        if (chosen < 0) return 1;
        r->s[chosen] = r->s[chosen] == 0 ? way[chosen] : 0;
    }
    return 0;
}

/* Bring elements to rest: their speeds, and those of all that is stuck, to zero with the least change of momentum. */
static void project(run *r, double *x) {
    double *v = x + V, impulse[E1];
    if (r->stuck.rows > 0 && meet(r)) constrain(r, v, nothing, impulse);
    still(r, v);
}
#endif
