/* Explicit Runge-Kutta steps: the classic one, and Dormand and Prince's 5(4) with its interpolant.
 *
 * Source: Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I, II.4 to II.6. */
#ifndef STEP_H
#define STEP_H
#include "friction.h"

typedef struct { int stages; double c[STAGES], a[STAGES][STAGES], b[STAGES]; } tableau;

static const tableau methods[2] = {
    {4, {0, 0.5, 0.5, 1}, {{0}, {0.5}, {0, 0.5}, {0, 0, 1}}, {1. / 6, 1. / 3, 1. / 3, 1. / 6}},
    {7,
     {0, 0.2, 0.3, 0.8, 8. / 9, 1, 1},
     {{0},
      {0.2},
      {3. / 40, 9. / 40},
      {44. / 45, -56. / 15, 32. / 9},
      {19372. / 6561, -25360. / 2187, 64448. / 6561, -212. / 729},
      {9017. / 3168, -355. / 33, 46732. / 5247, 49. / 176, -5103. / 18656},
      {35. / 384, 0, 500. / 1113, 125. / 192, -2187. / 6784, 11. / 84}},
     {35. / 384, 0, 500. / 1113, 125. / 192, -2187. / 6784, 11. / 84, 0}}};

static const double error_of[STAGES] = {71. / 57600, 0, -71. / 16695, 71. / 1920, -17253. / 339200, 22. / 525, -1. / 40};

static const double middle[STAGES] = {-12715105075. / 11282082432, 0, 87487479700. / 32700410799,
    -10690763975. / 1880347072, 701980252875. / 199316789632, -1453857185. / 822651844, 69997945. / 29380423};

static double *added(const run *r, double h, const double *factor, int count, double *result) {
    memcpy(result, r->x, sizeof r->x);
    for (int j = 0; j < count; j++)
        if (factor[j] != 0) {
            double by = h * factor[j];
            for (int i = 0; i < SIZE; i++) result[i] += by * r->k[j][i];
        }
    return result;
}

/* A step from t, of length h, to r->end; k[0] is known. 0: no acceleration. */
static int attempt(run *r, double h) {
    const tableau *m = &methods[r->is.method];
    double x[SIZE];
    for (int i = 1; i < m->stages; i++)
        if (!slopes(r, r->t + m->c[i] * h, added(r, h, m->a[i], i, x), r->k[i])) return 0;
    added(r, h, m->b, m->stages, r->end);
    still(r, r->end + V);
    if (r->is.method == 0) return 1;
    double sum = 0;
    for (int i = 0; i < MOVING; i++) {
        double off = 0, a = fabs(r->x[i]), b = fabs(r->end[i]);
        for (int j = 0; j < STAGES; j++) off += error_of[j] * r->k[j][i];
        off *= h / (r->is.atol + r->is.rtol * (a > b ? a : b));
        sum += off * off;
    }
    r->error = sqrt(sum / MOVING);
    return 1;
}

static int finite(const double *x) {
    for (int i = 0; i < SIZE; i++)
        if (!(fabs(x[i]) <= 1e300)) return 0;
    return 1;
}

/* Keep the interpolant of the step that was made. */
static void remember(run *r, double h) {
    r->from = r->t;
    r->length = h;
    for (int i = 0; i < SIZE; i++) {
        double change = r->end[i] - r->x[i], first = h * r->k[0][i] - change, sum = 0;
        for (int j = 0; j < STAGES; j++) sum += middle[j] * r->k[j][i];
        r->coefficient[0][i] = r->x[i];
        r->coefficient[1][i] = change;
        r->coefficient[2][i] = first;
        r->coefficient[3][i] = change - h * r->k[6][i] - first;
        r->coefficient[4][i] = h * sum;
    }
}

static void interpolated(const run *r, double part, double *x) {
    double rest = 1 - part;
    for (int i = 0; i < SIZE; i++)
        x[i] = r->coefficient[0][i]
            + part * (r->coefficient[1][i]
            + rest * (r->coefficient[2][i]
            + part * (r->coefficient[3][i] + rest * r->coefficient[4][i])));
}

/* A first length (Hairer's, without its second evaluation). */
static double first_length(const run *r) {
    double position = 0, slope = 0;
    for (int i = 0; i < MOVING; i++) {
        double scale = r->is.atol + r->is.rtol * fabs(r->x[i]);
        position += (r->x[i] / scale) * (r->x[i] / scale);
        slope += (r->k[0][i] / scale) * (r->k[0][i] / scale);
    }
    double h = position > 1e-10 && slope > 1e-10 ? 0.01 * sqrt(position / slope) : 1e-6;
    return h > 1e-9 ? h : 1e-9;
}

/* In how many parts a step of length h is made because the internal states move fast: the length times the largest
 * row sum of d rates / d z stays below 1. */
static double parts(run *r, double h) {
#if SYSTEM_STATES > 0
    double z[K], other[K], sum[K] = {0}, most = 0;
    memcpy(z, r->x + Z, sizeof z);
    for (int j = 0; j < K; j++) {
        double kept = z[j], by = 1e-7 * (fabs(kept) > 1e-6 ? fabs(kept) : 1e-6);
        z[j] = kept + by;
        system_rates(r->x, r->x + V, z, other, r->is.parameters);
        for (int i = 0; i < K; i++) sum[i] += fabs(other[i] - r->k[0][Z + i]) / by;
        z[j] = kept;
    }
    for (int i = 0; i < K; i++)
        if (sum[i] > most) most = sum[i];
    return ceil(h * most < 1 ? 1 : h * most < 1e4 ? h * most : 1e4);
#else
    (void)r;
    (void)h;
    return 1;
#endif
}
#endif
