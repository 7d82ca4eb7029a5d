/* Other ways to compute a value. */
#ifndef CANDIDATES_H
#define CANDIDATES_H
#include "network.h"
#include "tables.h"

static void consider(walk *w, const candidate *c, int freed) {
    int delta = hold_def(w, c, &c->own) - freed;
    release_def(w, c, &c->own);
    if (delta > w->limit || w->n_candidates >= CANDIDATES) return;
    w->candidates[w->n_candidates] = *c;
    w->candidates[w->n_candidates++].delta = delta;
}
static inline int usable(const walk *w, int x) { return w->mark[x] != w->stamp; }
static inline int fresh(const walk *w, const entry *e) {
    return (uint16_t)w->gen[e->a] == e->ga && (uint16_t)w->gen[e->b] == e->gb && usable(w, e->a) && usable(w, e->b);
}
static inline def pair_def(const entry *e) {
    int op = (int)(e->key >> 61);
    def d = {op == 2 ? MUL : ADD, e->a, e->b, op == 1 ? -1 : 1};
    return d;
}
static inline int new_value(candidate *c, def d, int how, int p, int y) {
    int i = c->count++;
    c->defs[i] = d;
    c->from[i] = (origin){how, p, y, 0};
    return i;
}

/* All ways to compute a value (x0, x1 its residues; `hole` where its definition goes) from what stands. */
static void ways(walk *w, candidate *c, def *hole, int self, u64 x0, u64 ratio, u64 offset, int freed) {
    u64 key = canon(x0), h = mix(key), mask;
    int count = c->count;
    if (bloom_has(&w->pairs, h, 0)) {
        mask = ((u64)1 << w->pairs.bits) - 1;
        for (u64 i = h & mask; w->pairs.slot[i].key != ~(u64)0; i = (i + 1) & mask) {
            const entry *e = &w->pairs.slot[i];
            if ((e->key & P) != key || !fresh(w, e)) continue;
            *hole = pair_def(e);
            consider(w, c, freed);
        }
    }
    for (u64 i = mix(ratio) & SMALL; w->hash_r[i] >= 0; i = (i + 1) & SMALL) {
        int z = w->hash_r[i];
        if (w->ratio[z] != ratio || !usable(w, z) || z == self) continue;
        *hole = (def){SCALE, z, 0, 1};
        consider(w, c, freed);
    }
    for (u64 i = mix(offset) & SMALL; w->hash_o[i] >= 0; i = (i + 1) & SMALL) {
        int z = w->hash_o[i];
        if (offset_key(w->val[z][0], w->val[z][1]) != offset || !usable(w, z) || z == self) continue;
        *hole = (def){OFFSET, z, 0, 1};
        consider(w, c, freed);
    }
    h = mix(ratio);
    if (c->count < NEW && bloom_has(&w->ratios, h, 0)) {
        mask = ((u64)1 << w->ratios.bits) - 1;
        for (u64 i = h & mask; w->ratios.slot[i].key != ~(u64)0; i = (i + 1) & mask) {
            const entry *e = &w->ratios.slot[i];
            if ((e->key & P) != ratio || !fresh(w, e)) continue;
            int t = new_value(c, pair_def(e), INSIDE, 0, 0);
            *hole = (def){SCALE, TEMP + t, 0, 1};
            consider(w, c, freed);
            c->count = count;
        }
    }
}

/* p = y + t, t - y, y t for every value y that stands: then all ways to compute t. */
static void scan(walk *w, const candidate *start, int hole, int p, u64 p0, u64 p1, int freed) {
    int n = 0, m = 0;
    if (start->count >= NEW) return;
    for (int i = 0; i < w->n_live; i++) {
        int y = w->live[i];
        if (!usable(w, y)) continue;
        const u64 *x = w->val[y];
        w->stack[m++] = y;
        w->t0[n] = subp(p0, x[0]); w->t1[n++] = subp(p1, x[1]);
        w->t0[n] = addp(p0, x[0]); w->t1[n++] = addp(p1, x[1]);
        w->t0[n] = mulp(p0, w->inv[y][0]); w->t1[n++] = mulp(p1, w->inv[y][1]);
    }
    invert_all(w, n);
    /* Memory is what this waits for: ask for all the places first, then look at them. */
    for (int i = 0; i < n; i++) {
        u64 ratio = w->ratio_of[i] = mulp(w->t1[i], w->pre[i]);
        u64 h = w->hash_of[i] = mix(canon(w->t0[i])), g = w->ratio_hash[i] = mix(ratio);
        __builtin_prefetch(&w->pairs.bloom[h >> (67 - w->pairs.bits)]);
        __builtin_prefetch(&w->ratios.bloom[g >> (67 - w->ratios.bits)]);
    }
    for (int i = 0; i < n; i++) {
        u64 h = w->hash_of[i], g = w->ratio_hash[i];
        int many = p == TARGET && i % 3 != OVER; /* v + y and v - y are there in any case: what else? */
        w->maybe[i] = 0;
        if (!w->t0[i] || w->ratio_of[i] == 1) continue; /* zero, or a constant */
        if (bloom_has(&w->pairs, h, many)) {
            w->maybe[i] = 1;
            __builtin_prefetch(&w->pairs.slot[h & (((u64)1 << w->pairs.bits) - 1)]);
        }
        if (bloom_has(&w->ratios, g, many)) {
            w->maybe[i] |= 2;
            __builtin_prefetch(&w->ratios.slot[g & (((u64)1 << w->ratios.bits) - 1)]);
        }
        if (w->hash_r[g & SMALL] >= 0 || w->hash_o[mix(offset_key(w->t0[i], w->t1[i])) & SMALL] >= 0) w->maybe[i] |= 4;
    }
    for (int i = 0; i < n; i++) {
        if (!w->maybe[i]) continue;
        u64 x0 = w->t0[i], x1 = w->t1[i];
        int y = w->stack[i / 3], how = i % 3;
        candidate c = *start;
        int t = new_value(&c, (def){0, 0, 0, 0}, how, p, y);
        def outer = {how == OVER ? MUL : ADD, how == PLUS ? TEMP + t : y, how == PLUS ? y : TEMP + t, how == PLUS ? -1 : 1};
        *(hole < 0 ? &c.own : &c.defs[hole]) = outer;
        ways(w, &c, &c.defs[t], -1, x0, w->ratio_of[i], offset_key(x0, x1), freed);
    }
}

/* v = t u or t +- u, t a product or sum of two values of which one is given, u likewise or proportional. */
static void both_new(walk *w, int v, int freed) {
    int z = w->live[below(w, w->n_live)];
    if (!usable(w, z)) return;
    const u64 *x = w->val[v], *a = w->val[z];
    int n = 0, m = 0;
    for (int i = 0; i < w->n_live; i++) {
        int y = w->live[i];
        if (!usable(w, y)) continue;
        const u64 *b = w->val[y];
        w->stack[m++] = y;
        w->t0[n] = addp(a[0], b[0]); w->t1[n++] = addp(a[1], b[1]);
        w->t0[n] = subp(a[0], b[0]); w->t1[n++] = subp(a[1], b[1]);
        w->t0[n] = mulp(a[0], b[0]); w->t1[n++] = mulp(a[1], b[1]);
    }
    invert_all(w, n);
    for (int i = 0; i < n; i++) {
        u64 s0 = w->t0[i], s1 = w->t1[i];
        int y = w->stack[i / 3], kind = i % 3;
        if (!s0 || (y == z && kind < 2)) continue;
        u64 u0[3] = {subp(x[0], s0), addp(x[0], s0), mulp(x[0], w->pre[i])};
        for (int how = 0; how < 3; how++) {
            u64 key = canon(u0[how]), h = mix(key);
            if (!u0[how] || !bloom_has(&w->pairs, h, 0)) continue;
            candidate c;
            c.count = 0;
            int s = new_value(&c, (def){kind == 2 ? MUL : ADD, z, y, kind == 1 ? -1 : 1}, INSIDE, 0, 0);
            int t = new_value(&c, (def){0, 0, 0, 0}, how, TARGET, TEMP + s);
            c.own = (def){how == OVER ? MUL : ADD, how == PLUS ? TEMP + t : TEMP + s, how == PLUS ? TEMP + s : TEMP + t, how == PLUS ? -1 : 1};
            u64 mask = ((u64)1 << w->pairs.bits) - 1;
            for (u64 j = h & mask; w->pairs.slot[j].key != ~(u64)0; j = (j + 1) & mask) {
                const entry *e = &w->pairs.slot[j];
                if ((e->key & P) != key || !fresh(w, e)) continue;
                c.defs[t] = pair_def(e);
                consider(w, &c, freed);
            }
            (void)s1;
        }
    }
}

/* v = k y + l z, and v = k y + c. */
static void combined(walk *w, int v, int tries, int freed) {
    const u64 *x = w->val[v];
    for (int j = 0; j < tries; j++) {
        int y = w->live[below(w, w->n_live)];
        if (!usable(w, y) || w->ratio[y] == w->ratio[v]) continue;
        const u64 *b = w->val[y];
        u64 c0 = subp(mulp(x[1], b[2]), mulp(x[2], b[1]));
        u64 c1 = subp(mulp(x[2], b[0]), mulp(x[0], b[2]));
        u64 c2 = subp(mulp(x[0], b[1]), mulp(x[1], b[0]));
        candidate c;
        if (addp(addp(c0, c1), c2) == 0) {
            c.count = 0;
            int t = new_value(&c, (def){SCALE, y, 0, 1}, PART, y, 0);
            c.from[t].z = TARGET;
            c.own = (def){OFFSET, TEMP + t, 0, 1};
            consider(w, &c, freed);
        }
        for (int i = 0; i < w->n_live; i++) {
            int z = w->live[i];
            const u64 *a = w->val[z];
            if (z == y || !usable(w, z)) continue;
            if (addp(addp(mulp(c0, a[0]), mulp(c1, a[1])), mulp(c2, a[2])) != 0) continue;
            if (w->ratio[z] == w->ratio[y] || w->ratio[z] == w->ratio[v]) continue;
            c.count = 0; /* k y + l z */
            int t = new_value(&c, (def){SCALE, y, 0, 1}, PART, y, 0), u = new_value(&c, (def){SCALE, z, 0, 1}, PART, z, 0);
            c.from[t].z = z; c.from[u].z = y;
            c.own = (def){ADD, TEMP + t, TEMP + u, 1};
            consider(w, &c, freed);
            c.count = 0; /* l (m y + z): the sum is v / l */
            t = new_value(&c, (def){SCALE, y, 0, 1}, SUM, y, 0); /* (v - l z) / l */
            c.from[t].z = z;
            u = new_value(&c, (def){ADD, TEMP + t, z, 1}, INSIDE, 0, 0);
            c.own = (def){SCALE, TEMP + u, 0, 1};
            consider(w, &c, freed);
        }
    }
}

#endif
