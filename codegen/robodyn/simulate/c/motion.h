/* The acceleration under given directions of friction, and the multipliers of the elements that are stuck. */
#ifndef MOTION_H
#define MOTION_H
#include <string.h>
#include "control.h"

static void solve(const run *r, double *b) {
#if SYSTEM_AFFINE
    ldl_solve(N, N, r->M[0], r->inverse, b);
#else
    lu_solve(N, N, r->M[0], r->pivot, b);
#endif
}

/* X = M^-1 w of the rows of the basis, and G = w X. */
static int meet(run *r) {
    int rows = r->stuck.rows;
    for (int b = 0; b < rows; b++) {
        memcpy(r->X[b], system_w[r->stuck.row[b]], sizeof r->X[b]);
        solve(r, r->X[b]);
    }
    for (int b = 0; b < rows; b++)
        for (int c = 0; c < rows; c++) r->G[b][c] = dot(system_w[r->stuck.row[b]], r->X[c]);
#if SYSTEM_AFFINE
    return ldl_factor(rows, E1, r->G[0], r->g_inverse);
#else
    return lu_factor(rows, E1, r->G[0], r->g_pivot);
#endif
}

/* Take from b what moves the rows of the basis, X G^-1 (w b + more); the factors go to `mu`. */
static void constrain(const run *r, double *b, const double *more, double *mu) {
    int rows = r->stuck.rows;
    for (int i = 0; i < rows; i++) mu[i] = dot(system_w[r->stuck.row[i]], b) + more[i];
#if SYSTEM_AFFINE
    ldl_solve(rows, E1, r->G[0], r->g_inverse, mu);
#else
    lu_solve(rows, E1, r->G[0], r->g_pivot, mu);
#endif
    for (int i = 0; i < rows; i++)
        for (int j = 0; j < N; j++) b[j] -= mu[i] * r->X[i][j];
}

/* To zero what is exactly so: coordinates that are stuck themselves. */
static void still(const run *r, double *values) {
    for (int i = 0; i < r->stuck.count; i++) {
        int unit = r->unit[r->stuck.stuck[i]];
        if (unit >= 0) values[unit] = 0;
    }
}

static const double nothing[E1];

#if SYSTEM_AFFINE
static int accelerate(run *r, const double *x) {
    system_mass(x, r->M[0], r->is.parameters);
    if (!ldl_factor(N, N, r->M[0], r->inverse)) return 0;
    system_bias(x, x + V, r->s, x + Z, r->force, r->is.parameters);
    for (int i = 0; i < N; i++) r->a[i] = r->tau[i] - r->force[i];
    solve(r, r->a);
    if (r->stuck.rows > 0) {
        if (!meet(r)) return 0;
        constrain(r, r->a, nothing, r->mu);
    }
    return 1;
}
#else
enum { MOST_ITERATIONS = 30, MOST_HALVINGS = 6 };

/* What is missing of the forces at a and mu, into `rest`; its length, and in `size` the largest force. */
static double residual(run *r, const double *x, const double *a, const double *mu, double *rest, double *size) {
    double sum = 0, largest = 0;
    system_force(x, x + V, a, r->s, x + Z, r->force, r->is.parameters);
    for (int i = 0; i < N; i++) {
        rest[i] = r->force[i] - r->tau[i];
        if (fabs(r->force[i]) > largest) largest = fabs(r->force[i]);
        if (fabs(r->tau[i]) > largest) largest = fabs(r->tau[i]);
    }
    for (int b = 0; b < r->stuck.rows; b++)
        for (int i = 0; i < N; i++) rest[i] += system_w[r->stuck.row[b]][i] * mu[b];
    for (int i = 0; i < N; i++) sum += rest[i] * rest[i];
    *size = largest;
    return sqrt(sum);
}

/* Semi-smooth Newton from r->a, with steps halved as long as that does not bring it nearer. The constraint is linear
 * and holds from the first step on. Near enough: 1e-13 of the forces and of the terms of the jacobian times a; or
 * 1e-10, where rounding lets it come no nearer. */
static int newton(run *r, const double *x) {
    double rest[N], d[N], a[N], dmu[E1], mu[E1], more[E1], size, terms = 0;
    double left = residual(r, x, r->a, r->mu, rest, &size);
    int rows = r->stuck.rows, kept = 0; /* the factors of the last iteration do as long as they bring it nearer */
    for (int k = 0; k < MOST_ITERATIONS; k++) {
        double most = 0;
        int apart = 0;
        for (int i = 0; i < N; i++)
            if (fabs(r->a[i]) > most) most = fabs(r->a[i]);
        for (int b = 0; b < rows; b++) {
            more[b] = dot(system_w[r->stuck.row[b]], r->a);
            if (k == 0 && fabs(more[b]) > 1e-13 * most) apart = 1; /* later it is rounding */
        }
        if (left != left) return 0;
        if (k > 0 && !apart && left <= 1e-13 * (size > terms ? size : terms)) return 1;
        r->counter[ITERATIONS]++;
        if (!kept) {
            system_jacobian(x, x + V, r->a, r->s, x + Z, r->M[0], r->is.parameters);
            terms = 0;
            for (int i = 0; i < N; i++) {
                double sum = 0;
                for (int j = 0; j < N; j++) sum += fabs(r->M[i][j] * r->a[j]);
                if (sum > terms) terms = sum;
            }
            if (!lu_factor(N, N, r->M[0], r->pivot) || !meet(r)) return 0;
        }
        if (size > terms) terms = size;
        if (!apart && left <= 1e-13 * terms) return 1;
        for (int i = 0; i < N; i++) d[i] = -rest[i];
        solve(r, d);
        constrain(r, d, more, dmu);
        double part = 1, now = 0, least = -1, best = 1;
        for (int halving = 0;; halving++) {
            for (int i = 0; i < N; i++) a[i] = r->a[i] + part * d[i];
            for (int b = 0; b < rows; b++) mu[b] = r->mu[b] + part * dmu[b];
            now = residual(r, x, a, mu, rest, &size);
            if (now < left || apart || halving > MOST_HALVINGS) break;
            if (least < 0 || now < least) least = now, best = part;
            part = halving == MOST_HALVINGS ? best : part / 2;
        }
        if (kept && !(now < left)) { /* not these factors: here with new ones */
            kept = 0;
            left = residual(r, x, r->a, r->mu, rest, &size);
            continue;
        }
        if (!apart && now >= left && left <= 1e-10 * terms) return 1;
        kept = now < 0.1 * left && part == 1;
        memcpy(r->a, a, sizeof a);
        memcpy(r->mu, mu, sizeof(double) * (size_t)rows);
        left = now;
    }
    return 0;
}

/* From the last acceleration, or else from none. */
static int accelerate(run *r, const double *x) {
    if (newton(r, x)) return 1;
    for (int i = 0; i < N; i++) r->a[i] = 0;
    for (int b = 0; b < E1; b++) r->mu[b] = 0;
    return newton(r, x);
}
#endif

/* The acceleration at (t, x) into r->a, and the multipliers of all that is stuck into r->lambda. */
static int acceleration(run *r, double t, const double *x) {
    const basis *stuck = &r->stuck;
    r->counter[EVALUATIONS]++;
    torques(r, t, x);
    if (!accelerate(r, x)) return 0;
    if (E == 0 || stuck->count == 0) return 1;
    still(r, r->a);
    if (stuck->rows == stuck->count) {
        for (int i = 0; i < stuck->count; i++) r->lambda[stuck->row[i]] = r->mu[i];
    } else {
        double least[E1];
        memcpy(least, r->mu, sizeof least);
        ldl_solve(stuck->rows, E1, stuck->normal[0], stuck->inverse, least);
        for (int i = 0; i < stuck->count; i++) {
            double sum = 0;
            for (int b = 0; b < stuck->rows; b++) sum += stuck->coefficient[i][b] * least[b];
            r->lambda[stuck->stuck[i]] = sum;
        }
    }
    return 1;
}

/* The slopes of everything that is integrated, from the acceleration at x. */
static void collect(run *r, const double *x, double *dx) {
    memcpy(dx, x + V, sizeof(double) * N);
    memcpy(dx + V, r->a, sizeof(double) * N);
#if SYSTEM_STATES > 0
    system_rates(x, x + V, x + Z, dx + Z, r->is.parameters);
#endif
    dx[WORK] = dx[LOSS] = 0;
#if SYSTEM_CONSERVED
    double h[N];
    system_conserved(x, x + V, h, r->is.parameters);
#if SYSTEM_AFFINE
    double (*M)[N] = r->M; /* above the factors, and its diagonal, it is itself */
#else
    double M[N][N];
    system_mass(x, M[0], r->is.parameters);
#endif
    for (int i = 0; i < N; i++) {
        double sum = h[i] + M[i][i] * r->a[i];
        for (int j = 0; j < i; j++) sum += M[j][i] * r->a[j];
        for (int j = i + 1; j < N; j++) sum += M[i][j] * r->a[j];
        dx[WORK] += x[V + i] * r->tau[i];
        dx[LOSS] += x[V + i] * (r->tau[i] - sum);
    }
#endif
}

static int slopes(run *r, double t, const double *x, double *dx) {
    if (!acceleration(r, t, x)) return 0;
    collect(r, x, dx);
    return 1;
}
#endif
