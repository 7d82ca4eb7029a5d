/* A random walk over straight-line programs that compute the same outputs.
 *
 * Every value is known by its residues at random points modulo primes near 2^61, so that an identity
 * between values is found by looking a number up in a table, and no rule of algebra is written down
 * anywhere. A step takes one value and looks for other ways to compute it from values that stand
 * already, with up to three new ones; it takes one of them by the cost that the whole program then
 * has (heat bath). Values that nothing needs any more go.
 *
 * Constants are never stored: a factor is the quotient of the two values that it joins, an offset
 * their difference, both the same at every point. Residues modulo further primes let the caller
 * recover them as exact fractions.
 *
 * Rounding is watched on the way: the program runs in single precision at sample states after every
 * step, and a step that takes it too far from the truth (kept in quadruple precision) is undone.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "candidates.h"
#include "values.h"

static void keep_best(walk *w) {
    network *b = &w->best;
    b->cost = whole_cost(w);
    b->count = w->n_live;
    memcpy(b->live, w->live, sizeof(int) * (size_t)w->n_live);
    for (int i = 0; i < w->n_live; i++) {
        int v = w->live[i];
        b->d[v] = w->d[v];
        memcpy(b->val[v], w->val[v], sizeof b->val[v]);
    }
}

static int take(walk *w, int v, const candidate *c, double temperature) {
    int slot[NEW], n_slots = 0, ok = 1, before = whole_cost(w);
    /* the tables of pairs stay at most half full, whatever the temperature: a search in a full one never ends */
    if (c->count && 3 * (u64)(w->n_live + NEW) * (u64)(w->n_live + NEW) > (u64)1 << w->pairs.bits) return 0;
    for (int i = 0; i < c->count; i++) {
        if (w->n_free == 0) { while (n_slots) w->free_slot[w->n_free++] = slot[--n_slots]; return 0; }
        slot[n_slots++] = w->free_slot[--w->n_free];
    }
    /* outside-in first come in order of making, save what comes by its own definition: until all are formed */
    int formed[NEW] = {0}, left = c->count;
    for (int round = 0; ok && left && round < 2 * NEW; round++)
        for (int i = 0; i < c->count && ok; i++) {
            const origin *o = &c->from[i];
            if (formed[i]) continue;
            def d = c->defs[i];
            if (o->how == INSIDE) {
                if ((d.a >= TEMP && !formed[d.a - TEMP]) || (d.b >= TEMP && !formed[d.b - TEMP])) continue;
            } else if ((o->how <= OVER && o->y >= TEMP && !formed[o->y - TEMP]) || (o->p >= TEMP && o->how <= OVER && !formed[o->p - TEMP])) continue;
            d.a = place_of(slot, d.a); d.b = place_of(slot, d.b);
            int p = o->how <= OVER ? (o->p == TARGET ? v : place_of(slot, o->p)) : v;
            int y = o->how <= OVER ? place_of(slot, o->y) : o->p;
            ok = form(w, slot[i], p, o, y, o->z, &d) && settle(w, slot[i]);
            if (ok && find_value(w, canon(w->val[slot[i]][0])) >= 0) ok = 0; /* stands already: another way finds it */
            for (int j = 0; ok && j < c->count; j++)
                if (j != i && formed[j] && canon(w->val[slot[j]][0]) == canon(w->val[slot[i]][0])) ok = 0;
            formed[i] = 1; left--;
        }
    if (left) ok = 0;
    for (int i = 0; i < n_slots && ok; i++) {
        def d = c->defs[i];
        d.a = place_of(slot, d.a); d.b = place_of(slot, d.b);
        w->d[slot[i]] = d; w->refs[slot[i]] = 0;
        if (!holds(w, slot[i])) ok = 0, w->false_hits++;
        else constants(w, slot[i]);
    }
    def old = w->d[v], own = c->own;
    own.a = place_of(slot, own.a); own.b = place_of(slot, own.b);
    int old_cost = w->cost;
    if (ok) {
        float k = w->factor[v];
        int flip = w->flip[v];
        release(w, v);
        w->d[v] = own;
        hold(w, v);
        if (!holds(w, v)) ok = 0, w->false_hits++;
        else {
            constants(w, v);
            w->cost += c->delta;
            order(w);
            int after = whole_cost(w);
            if (w->objective && after > before && unit(w) >= exp((before - after) / temperature)) ok = 0;
            double error = ok ? single_error(w) : 0;
            if (error > w->tolerance && error > w->error) ok = 0, w->refused++;
            if (ok) w->error = error;
        }
        if (!ok) { /* undo */
            release(w, v);
            w->d[v] = old; w->factor[v] = k; w->flip[v] = flip; w->cost = old_cost;
            hold(w, v);
            order(w);
        }
    }
    if (!ok) {
        while (n_slots) { int s = slot[--n_slots]; w->gen[s]++; w->place[s] = -1; w->free_slot[w->n_free++] = s; }
        return 0;
    }
    /* what nothing needs goes; what is new joins */
    for (int i = 0; i < SLOTS; i++) w->mark[i] = 0;
    for (int i = 0; i < w->n_live; i++) w->mark[w->live[i]] = -1;
    for (int s = w->leaves; s < SLOTS; s++)
        if (w->mark[s] != -1 && w->place[s] >= 0) { w->place[s] = -1; w->gen[s]++; w->refs[s] = 0; w->free_slot[w->n_free++] = s; }
    for (int i = 0; i < n_slots; i++)
        if (w->mark[slot[i]] != -1) { w->gen[slot[i]]++; }
    rebuild_small(w);
    if (w->pairs.filled + (long)n_slots * 3 * w->n_live > (long)((u64)1 << w->pairs.bits) / 2) rebuild_pairs(w);
    else for (int i = 0; i < n_slots; i++) if (w->mark[slot[i]] == -1) put_pairs(w, slot[i], w->n_live);
    w->accepted++;
    return 1;
}

static int step(walk *w, double temperature) {
    w->steps++;
    if (w->n_live <= w->leaves) return 0;
    int v = w->live[w->leaves + below(w, w->n_live - w->leaves)];
    w->stamp++;
    w->mark[v] = w->stamp;
    for (int i = w->place[v] + 1; i < w->n_live; i++) {
        int x = w->live[i], k = arity(w->d[x].op);
        if ((k > 0 && w->mark[w->d[x].a] == w->stamp) || (k > 1 && w->mark[w->d[x].b] == w->stamp)) w->mark[x] = w->stamp;
    }
    /* refs of v itself stay; its operands are let go for the while */
    int freed = release(w, v);
    double reach = -temperature * log(unit(w));
    w->limit = (int)(reach < 40 ? reach : 40);
    w->n_candidates = 0;
    candidate c;
    memset(&c, 0, sizeof c);
    const u64 *x = w->val[v];
    int kind = below(w, 100);
    ways(w, &c, &c.own, v, x[0], w->ratio[v], offset_key(x[0], x[1]), freed);
    if (kind < 60) {
        c.count = 0;
        scan(w, &c, -1, TARGET, x[0], x[1], freed);
    } else if (kind < 80) {
        int y = w->live[below(w, w->n_live)], how = below(w, 3);
        if (usable(w, y)) {
            c.count = 0;
            const u64 *b = w->val[y];
            u64 p0 = how == MINUS ? subp(x[0], b[0]) : how == PLUS ? addp(x[0], b[0]) : mulp(x[0], w->inv[y][0]);
            u64 p1 = how == MINUS ? subp(x[1], b[1]) : how == PLUS ? addp(x[1], b[1]) : mulp(x[1], w->inv[y][1]);
            if (p0 && p1 && p0 != p1 && find_value(w, canon(p0)) < 0) {
                int t = new_value(&c, (def){0, 0, 0, 0}, how, TARGET, y);
                c.own = (def){how == OVER ? MUL : ADD, how == PLUS ? TEMP + t : y, how == PLUS ? y : TEMP + t, how == PLUS ? -1 : 1};
                scan(w, &c, t, TEMP + t, p0, p1, freed);
            }
        }
    } else if (kind < 90) {
        both_new(w, v, freed);
    } else {
        combined(w, v, 24, freed);
    }
    hold(w, v);
    if (!w->n_candidates) return 0;
    /* one of the cheapest within reach */
    int n = 0;
    for (int i = 0; i < w->n_candidates; i++) {
        def *o = &w->candidates[i].own, *d = &w->d[v];
        if (o->op == d->op && o->a == d->a && o->b == d->b) continue;
        if (o->op == d->op && o->a == d->b && o->b == d->a && arity(o->op) == 2) continue;
        if (n != i) w->candidates[n] = w->candidates[i];
        n++;
    }
    if (!n) return 0;
    int least = w->limit + 1, choice = -1, equal = 0;
    if (w->objective) choice = below(w, n);
    else {
        for (int i = 0; i < n; i++) if (w->candidates[i].delta < least) least = w->candidates[i].delta;
        if (least < 0) { for (int i = 0; i < n; i++) if (w->candidates[i].delta == least && below(w, ++equal) == 0) choice = i; }
        else choice = below(w, n);
    }
    return take(w, v, &w->candidates[choice], temperature);
}

/* ---- for the caller ---- */
walk *walk_new(int leaves, int count, int outputs, int primes, int states, const int *ops, const int *out,
               const u64 *residues, const double *high, const double *low, const int *weights, int objective, double tolerance, u64 seed) {
    /* ops: count rows (op, a, b, sign), leaves first; residues [leaves + count][residues] and truth [..][states], high + low */
    if (count + leaves > SLOTS / 2 || outputs > OUTPUTS || primes > PRIMES || states > STATES) return 0;
    walk *w = calloc(1, sizeof *w);
    if (!w) return 0;
    int n = leaves + count;
    w->leaves = leaves; w->primes = primes; w->residues = POINTS + 2 * (primes - 1); w->states = states;
    w->n_out = outputs; w->objective = objective; w->tolerance = tolerance;
    w->rng = seed * 2654435761u + 88172645463325252ull;
    memcpy(w->weight, weights, sizeof w->weight);
    for (int v = 0; v < SLOTS; v++) w->place[v] = -1;
    for (int v = 0; v < n; v++) {
        w->d[v] = (def){ops[4 * v], ops[4 * v + 1], ops[4 * v + 2], ops[4 * v + 3]};
        for (int r = 0; r < w->residues; r++) w->val[v][r] = residues[v * w->residues + r];
        for (int s = 0; s < states; s++) {
            w->truth[v][s] = (quad)high[v * states + s] + (quad)low[v * states + s];
            w->run[v][s] = (float)w->truth[v][s];
        }
        if (!settle(w, v)) { free(w); return 0; }
    }
    w->yardstick = 1e-300;
    for (int o = 0; o < outputs; o++) {
        w->out[o] = out[o]; w->is_out[out[o]] = 1;
        w->refs[out[o]]++;
        for (int s = 0; s < states; s++) { double m = fabs((double)w->truth[out[o]][s]); w->expected[o][s] = (double)w->truth[out[o]][s]; if (m > w->yardstick) w->yardstick = m; }
    }
    for (int v = 0; v < n; v++) w->refs[v] += v < leaves; /* leaves stay */
    for (int o = 0; o < outputs; o++) {
        int first = 1;
        for (int j = 0; j < o; j++) if (out[j] == out[o]) first = 0;
        if (first && out[o] >= leaves) w->cost += hold(w, out[o]);
    }
    order(w);
    for (int i = 0; i < w->n_live; i++) w->mark[w->live[i]] = -1;
    for (int v = SLOTS - 1; v >= leaves; v--) if (w->mark[v] != -1) { w->free_slot[w->n_free++] = v; w->place[v] = -1; }
    for (int i = leaves; i < w->n_live; i++) {
        if (!holds(w, w->live[i])) { free(w); return 0; }
        constants(w, w->live[i]);
    }
    w->error = single_error(w);
    int bits = 16;
    while (((u64)1 << bits) < (u64)w->n_live * (u64)w->n_live * 6) bits++;
    if (!table_new(&w->pairs, bits) || !table_new(&w->ratios, bits)) return 0;
    rebuild_small(w);
    rebuild_pairs(w);
    keep_best(w);
    return w;
}
void walk_free(walk *w) {
    if (!w) return;
    free(w->pairs.slot); free(w->pairs.bloom); free(w->ratios.slot); free(w->ratios.bloom); free(w);
}
int walk_run(walk *w, long steps, double temperature) { /* the best cost so far */
    for (long i = 0; i < steps; i++)
        if (step(w, temperature)) {
            int cost = whole_cost(w);
            if (cost < w->best.cost) keep_best(w);
        }
    return w->best.cost;
}
int walk_cost(const walk *w) { return w->cost; }
double walk_error(const walk *w) { return w->error; }
long walk_count(const walk *w, int what) { return what == 0 ? w->steps : what == 1 ? w->accepted : what == 2 ? w->refused : what == 3 ? w->false_hits : w->rebuilt; }
int walk_best(const walk *w, int *ids, int *ops, u64 *residues) { /* rows of the best program, operands first */
    const network *b = &w->best;
    for (int i = 0; i < b->count; i++) {
        int v = b->live[i];
        ids[i] = v;
        ops[4 * i] = b->d[v].op; ops[4 * i + 1] = b->d[v].a; ops[4 * i + 2] = b->d[v].b; ops[4 * i + 3] = b->d[v].sign;
        memcpy(residues + (size_t)i * (size_t)w->residues, b->val[v], sizeof(u64) * (size_t)w->residues);
    }
    return b->count;
}
