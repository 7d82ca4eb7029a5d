/* New values: their residues and truth, whether definitions hold, and what rounding does to them. */
#ifndef VALUES_H
#define VALUES_H
#include <math.h>
#include "network.h"
#include "tables.h"

static void solve(u64 x0, u64 x1, u64 y0, u64 y1, u64 z0, u64 z1, u64 c, u64 *k, u64 *l) {
    /* x = k y + l z at two points, modulo 2^61 - c */
    u64 p = ((u64)1 << 61) - c;
#define M(a, b) mul_below(a, b, c)
#define S(a, b) ((a) >= (b) ? (a) - (b) : (a) + p - (b))
    u64 det = inv_below(S(M(y0, z1), M(y1, z0)), c);
    *k = M(S(M(x0, z1), M(x1, z0)), det);
    *l = M(S(M(y0, x1), M(y1, x0)), det);
#undef M
#undef S
}
static int value_of_def(walk *w, const def *d, u64 *val, quad *truth) {
    for (int r = 0; r < w->residues; r++) {
        u64 c = below_2_61[prime_of(r)], p = ((u64)1 << 61) - c, a = w->val[d->a][r], b = w->val[d->b][r];
        if (d->op == MUL) val[r] = mul_below(a, b, c);
        else { if (d->sign < 0) b = b ? p - b : 0; a += b; val[r] = a >= p ? a - p : a; }
    }
    for (int s = 0; s < w->states; s++) {
        quad a = w->truth[d->a][s], b = w->truth[d->b][s];
        truth[s] = d->op == MUL ? a * b : d->sign < 0 ? a - b : a + b;
    }
    return 1;
}
static int form(walk *w, int slot, int p, const origin *o, int y, int z, const def *d) {
    /* residues and truth of a new value */
    u64 *val = w->val[slot];
    quad *truth = w->truth[slot];
    if (o->how == INSIDE) return value_of_def(w, d, val, truth);
    if (o->how == PART || o->how == SUM) {
        static const u64 ones[RESIDUES] = {[0 ... RESIDUES - 1] = 1};
        const u64 *x = w->val[p], *a = w->val[y], *b = z < 0 ? ones : w->val[z];
        for (int r = 0; r < w->residues; r += (r < POINTS ? POINTS : 2)) {
            u64 c = below_2_61[prime_of(r)], k, l;
            int width = r < POINTS ? POINTS : 2;
            solve(x[r], x[r + 1], a[r], a[r + 1], b[r], b[r + 1], c, &k, &l);
            if (!k || !l) return 0;
            if (o->how == SUM) k = mul_below(k, inv_below(l, c), c);
            for (int j = 0; j < width; j++) val[r + j] = mul_below(k, a[r + j], c);
        }
        quad best = 0, k = 0, l = 0;
        for (int i = 0; i < w->states; i++)
            for (int j = 0; j < i; j++) {
                quad b_i = z < 0 ? 1 : w->truth[z][i], b_j = z < 0 ? 1 : w->truth[z][j];
                quad a_i = w->truth[y][i], a_j = w->truth[y][j], x_i = w->truth[p][i], x_j = w->truth[p][j];
                quad det = a_i * b_j - a_j * b_i;
                if (mag(det) <= best) continue;
                best = mag(det);
                k = (x_i * b_j - x_j * b_i) / det;
                l = (a_i * x_j - a_j * x_i) / det;
            }
        if (best == 0 || l == 0) return 0;
        if (o->how == SUM) k /= l;
        for (int s = 0; s < w->states; s++) truth[s] = k * w->truth[y][s];
        return 1;
    }
    const u64 *x = w->val[p], *b = w->val[y];
    for (int r = 0; r < w->residues; r++) {
        u64 c = below_2_61[prime_of(r)], q = ((u64)1 << 61) - c;
        if (o->how == OVER) { if (!b[r]) return 0; val[r] = mul_below(x[r], inv_below(b[r], c), c); }
        else if (o->how == MINUS) val[r] = x[r] >= b[r] ? x[r] - b[r] : x[r] + q - b[r];
        else { val[r] = x[r] + b[r]; if (val[r] >= q) val[r] -= q; }
    }
    for (int s = 0; s < w->states; s++) {
        quad a = w->truth[p][s], t = w->truth[y][s];
        if (o->how == OVER && t == 0) return 0;
        truth[s] = o->how == OVER ? a / t : o->how == MINUS ? a - t : a + t;
    }
    return 1;
}
static int same_up_to_sign(const u64 *x, const u64 *y, int n) { /* 1, -1, or 0: they are not */
    int plus = 1, minus = 1;
    for (int r = 0; r < n; r++) {
        u64 p = ((u64)1 << 61) - below_2_61[prime_of(r)];
        if (x[r] != y[r]) plus = 0;
        if ((x[r] ? p - x[r] : 0) != y[r]) minus = 0;
    }
    return plus ? 1 : minus ? -1 : 0;
}
static int holds(walk *w, int v) { /* v's definition gives its value */
    const def *d = &w->d[v];
    const u64 *x = w->val[v], *a = w->val[d->a];
    w->flip[v] = 0;
    if (d->op == ADD || d->op == MUL) {
        u64 val[RESIDUES];
        quad truth[STATES];
        value_of_def(w, d, val, truth);
        int same = same_up_to_sign(val, x, w->residues);
        w->flip[v] = same < 0;
        return same != 0;
    }
    if (d->op == SCALE) {
        for (int r = 1; r < w->residues; r++) {
            if (r >= POINTS && (r - POINTS) % 2 == 0) continue;
            int first = r < POINTS ? 0 : r - 1;
            u64 c = below_2_61[prime_of(r)];
            if (mul_below(x[first], a[r], c) != mul_below(x[r], a[first], c)) return 0;
        }
        return 1;
    }
    int plus = 1, minus = 1;
    for (int r = 1; r < w->residues; r++) {
        if (r >= POINTS && (r - POINTS) % 2 == 0) continue;
        int first = r < POINTS ? 0 : r - 1;
        u64 p = ((u64)1 << 61) - below_2_61[prime_of(r)];
        u64 dx = x[r] >= x[first] ? x[r] - x[first] : x[r] + p - x[first];
        u64 da = a[r] >= a[first] ? a[r] - a[first] : a[r] + p - a[first];
        if (dx != da) plus = 0;
        if (dx != (da ? p - da : 0)) minus = 0;
    }
    w->d[v].sign = plus ? 1 : -1;
    return plus || minus;
}
static void constants(walk *w, int v) { /* the factor or offset of v's definition, in single precision */
    const def *d = &w->d[v];
    if (d->op != SCALE && d->op != OFFSET) return;
    quad best = 0, c = 0;
    for (int s = 0; s < w->states; s++) {
        quad x = w->truth[v][s], a = w->truth[d->a][s];
        if (d->op == SCALE) { if (mag(a) > best) { best = mag(a); c = x / a; } }
        else if (s == 0 || mag(a) < best) { best = mag(a); c = d->sign < 0 ? x + a : x - a; }
    }
    w->factor[v] = (float)c;
}
static double single_error(walk *w) {
    double worst = 0;
    for (int i = w->leaves; i < w->n_live; i++) {
        int v = w->live[i];
        const def *d = &w->d[v];
        const float *a = w->run[d->a], *b = w->run[d->b];
        float *x = w->run[v], k = w->factor[v];
        if (d->op == SCALE) for (int s = 0; s < STATES; s++) x[s] = k * a[s];
        else if (d->op == OFFSET) { if (d->sign < 0) for (int s = 0; s < STATES; s++) x[s] = k - a[s]; else for (int s = 0; s < STATES; s++) x[s] = a[s] + k; }
        else if (d->op == MUL) for (int s = 0; s < STATES; s++) x[s] = a[s] * b[s];
        else if (d->sign < 0) for (int s = 0; s < STATES; s++) x[s] = a[s] - b[s];
        else for (int s = 0; s < STATES; s++) x[s] = a[s] + b[s];
        if (w->flip[v]) for (int s = 0; s < STATES; s++) x[s] = -x[s];
    }
    for (int o = 0; o < w->n_out; o++)
        for (int s = 0; s < w->states; s++) {
            double e = fabs((double)w->run[w->out[o]][s] - (double)w->expected[o][s]);
            if (!(e <= worst)) worst = e == e ? e : INFINITY;
        }
    return worst / w->yardstick;
}
static int settle(walk *w, int v) { /* what of a new value is looked up by */
    for (int j = 0; j < 2; j++) {
        if (!w->val[v][j]) return 0;
        w->inv[v][j] = inv_below(w->val[v][j], 1);
    }
    w->ratio[v] = mulp(w->val[v][1], w->inv[v][0]);
    return w->ratio[v] != 1;
}
static inline int place_of(const int *slot, int x) { return x >= TEMP ? slot[x - TEMP] : x; }

#endif
