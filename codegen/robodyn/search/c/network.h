/* The program as a network: what uses what, in which order, at what cost. */
#ifndef NETWORK_H
#define NETWORK_H
#include "state.h"

static inline int arity(int op) { return op == LEAF ? 0 : op == ADD || op == MUL ? 2 : 1; }

static int release(walk *w, int v) { /* v lets go of its operands: what becomes free, v included */
    const def *d = &w->d[v];
    int freed = w->weight[d->op], k = arity(d->op);
    if (k > 0 && --w->refs[d->a] == 0) freed += release(w, d->a);
    if (k > 1 && --w->refs[d->b] == 0) freed += release(w, d->b);
    return freed;
}
static int hold(walk *w, int v) {
    const def *d = &w->d[v];
    int cost = w->weight[d->op], k = arity(d->op);
    if (k > 0 && w->refs[d->a]++ == 0) cost += hold(w, d->a);
    if (k > 1 && w->refs[d->b]++ == 0) cost += hold(w, d->b);
    return cost;
}
static int hold_def(walk *w, const candidate *c, const def *d) {
    int cost = w->weight[d->op], k = arity(d->op);
    for (int i = 0; i < k; i++) {
        int x = i ? d->b : d->a;
        if (x >= TEMP) { if (!i || d->b != d->a) cost += hold_def(w, c, &c->defs[x - TEMP]); }
        else if (w->refs[x]++ == 0) cost += hold(w, x);
    }
    return cost;
}
static void release_def(walk *w, const candidate *c, const def *d) {
    int k = arity(d->op);
    for (int i = 0; i < k; i++) {
        int x = i ? d->b : d->a;
        if (x >= TEMP) { if (!i || d->b != d->a) release_def(w, c, &c->defs[x - TEMP]); }
        else if (--w->refs[x] == 0) release(w, x);
    }
}

static void order(walk *w) { /* live values, operands first */
    int n = 0;
    w->stamp++;
    for (int v = 0; v < w->leaves; v++) { w->place[v] = n; w->live[n++] = v; w->seen[v] = 2 * w->stamp + 1; }
    for (int o = 0; o < w->n_out; o++) {
        int top = 0;
        w->stack[top++] = w->out[o];
        while (top) {
            int v = w->stack[top - 1];
            if (w->seen[v] == 2 * w->stamp + 1) { top--; continue; }
            const def *d = &w->d[v];
            int k = arity(d->op);
            if (w->seen[v] != 2 * w->stamp) {
                w->seen[v] = 2 * w->stamp;
                if (k > 1 && w->seen[d->b] < 2 * w->stamp) w->stack[top++] = d->b;
                if (k > 0 && w->seen[d->a] < 2 * w->stamp) w->stack[top++] = d->a;
            } else {
                w->seen[v] = 2 * w->stamp + 1; w->place[v] = n; w->live[n++] = v; top--;
            }
        }
    }
    w->n_live = n;
}

/* What the program costs in all. Objective 1: a multiplication whose product goes into one sum only is
 * fused with it. Objective 2: the longest chain first. */
static int whole_cost(walk *w) {
    if (w->objective == 1) {
        int saved = 0;
        for (int i = 0; i < w->n_live; i++) w->deep[w->live[i]] = 0;
        for (int i = w->leaves; i < w->n_live; i++) {
            const def *d = &w->d[w->live[i]];
            if (d->op != ADD && d->op != OFFSET) continue;
            int k = arity(d->op);
            for (int j = 0; j < k; j++) {
                int x = j ? d->b : d->a, op = w->d[x].op;
                if ((op == MUL || op == SCALE) && w->refs[x] == 1 && !w->is_out[x]) { saved++; break; }
            }
        }
        return w->cost - saved * w->weight[MUL];
    }
    if (w->objective == 2) {
        int deepest = 0;
        for (int i = 0; i < w->n_live; i++) {
            int v = w->live[i], k = arity(w->d[v].op), deep = -1;
            if (k > 0) deep = w->deep[w->d[v].a];
            if (k > 1 && w->deep[w->d[v].b] > deep) deep = w->deep[w->d[v].b];
            w->deep[v] = deep + 1;
            if (deep + 1 > deepest) deepest = deep + 1;
        }
        return deepest * 4 * w->weight[ADD] + w->cost;
    }
    return w->cost;
}

#endif
