/* Where values are looked up: single ones, and all sums, differences and products of two. */
#ifndef TABLES_H
#define TABLES_H
#include <stdlib.h>
#include <string.h>
#include "state.h"

static int table_new(table *t, int bits) {
    t->bits = bits;
    t->slot = malloc(sizeof(entry) << bits);
    t->bloom = malloc((size_t)1 << bits);
    return t->slot && t->bloom;
}
static void table_clear(table *t) {
    memset(t->slot, 0xff, sizeof(entry) << t->bits);
    memset(t->bloom, 0, (size_t)1 << t->bits);
    t->filled = 0;
}
/* Two bits a cell: something is there, and something more is there. */
static inline void bloom_set(table *t, u64 h) {
    u64 i = h >> (62 - t->bits), *word = &t->bloom[i >> 5], bit = (u64)1 << (2 * (i & 31));
    *word |= *word & bit ? bit << 1 : bit;
}
static inline int bloom_has(const table *t, u64 h, int many) {
    u64 i = h >> (62 - t->bits);
    return (int)(t->bloom[i >> 5] >> (2 * (i & 31) + (u64)many) & 1);
}
static inline void table_put(walk *w, table *t, u64 key, int op, int a, int b) {
    u64 h = mix(key), mask = ((u64)1 << t->bits) - 1, i = h & mask;
    while (t->slot[i].key != ~(u64)0) i = (i + 1) & mask;
    entry *e = &t->slot[i];
    e->key = key | (u64)op << 61; e->a = (uint16_t)a; e->b = (uint16_t)b;
    e->ga = (uint16_t)w->gen[a]; e->gb = (uint16_t)w->gen[b];
    bloom_set(t, h);
    t->filled++;
}
static void invert_all(walk *w, int n) { /* pre[i] = 1 / t0[i]; 0 stays 0 */
    u64 *pre = w->pre, *x = w->t0, inv;
    pre[0] = 1;
    for (int i = 0; i < n; i++) pre[i + 1] = x[i] ? mulp(pre[i], x[i]) : pre[i];
    inv = inv_below(pre[n], 1);
    for (int i = n - 1; i >= 0; i--) {
        if (!x[i]) { pre[i] = 0; continue; }
        pre[i] = mulp(inv, pre[i]);
        inv = mulp(inv, x[i]);
    }
}
static void put_pairs(walk *w, int v, int upto) { /* v with the first `upto` live values */
    const u64 *x = w->val[v];
    int n = 0;
    for (int i = 0; i < upto; i++) {
        const u64 *y = w->val[w->live[i]];
        w->t0[n] = addp(x[0], y[0]); w->t1[n++] = addp(x[1], y[1]);
        w->t0[n] = subp(x[0], y[0]); w->t1[n++] = subp(x[1], y[1]);
        w->t0[n] = mulp(x[0], y[0]); w->t1[n++] = mulp(x[1], y[1]);
    }
    invert_all(w, n);
    for (int i = 0; i < n; i++) {
        int u = w->live[i / 3], op = i % 3;
        if (!w->t0[i] || (u == v && op < 2)) continue;
        table_put(w, &w->pairs, canon(w->t0[i]), op, v, u);
        table_put(w, &w->ratios, mulp(w->t1[i], w->pre[i]), op, v, u);
    }
}
static void rebuild_pairs(walk *w) {
    table_clear(&w->pairs); table_clear(&w->ratios);
    for (int i = 0; i < w->n_live; i++) put_pairs(w, w->live[i], i + 1);
    w->rebuilt++;
}

/* ---- small tables of the live values ---- */
enum { SMALL = 2 * SLOTS - 1 };
static inline void small_put(int *h, u64 key, int v) {
    u64 i = mix(key) & SMALL;
    while (h[i] >= 0) i = (i + 1) & SMALL;
    h[i] = v;
}
static inline u64 offset_key(u64 x0, u64 x1) { return canon(subp(x1, x0)); }
static void rebuild_small(walk *w) {
    memset(w->hash_v, 0xff, sizeof w->hash_v);
    memset(w->hash_r, 0xff, sizeof w->hash_r);
    memset(w->hash_o, 0xff, sizeof w->hash_o);
    for (int i = 0; i < w->n_live; i++) {
        int v = w->live[i];
        small_put(w->hash_v, canon(w->val[v][0]), v);
        small_put(w->hash_r, w->ratio[v], v);
        small_put(w->hash_o, offset_key(w->val[v][0], w->val[v][1]), v);
    }
}
static inline int find_value(const walk *w, u64 key) {
    for (u64 i = mix(key) & SMALL; w->hash_v[i] >= 0; i = (i + 1) & SMALL)
        if (canon(w->val[w->hash_v[i]][0]) == key) return w->hash_v[i];
    return -1;
}

#endif
