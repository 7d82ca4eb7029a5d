/* The state of a walk. */
#ifndef STATE_H
#define STATE_H
#include "field.h"

#if defined(__SIZEOF_FLOAT128__)
typedef __float128 quad;
#else
typedef long double quad; /* 128 bits on arm64 Linux; less elsewhere, and rounding is then judged a little less well */
#endif

enum { LEAF, ADD, MUL, SCALE, OFFSET };
enum { SLOTS = 4096, STATES = 12, NEW = 3, TEMP = 8192, TARGET = -1, CANDIDATES = 4096, OUTPUTS = 256 };

/* +-(a + sign b), +-(a b), k a, sign a + c */
typedef struct { int op, a, b, sign; } def;

/* How a new value is got: MINUS p - y, PLUS p + y, OVER p / y; INSIDE by its own definition; FIRST, SECOND
 * the parts of the target along y and z: target = k y + l z (z TARGET: the constant 1). */
enum { MINUS, PLUS, OVER, INSIDE, PART, SUM };
typedef struct { int how, p, y, z; } origin;

typedef struct {
    def own, defs[NEW]; /* operands from TEMP on are defs[] */
    origin from[NEW];
    int count;
    int delta;
} candidate;

typedef struct { u64 key; uint16_t a, b, ga, gb; } entry; /* the operation is in the key's top bits */
typedef struct { entry *slot; u64 *bloom; int bits; long filled; } table;
typedef struct { int count, cost, live[SLOTS]; def d[SLOTS]; u64 val[SLOTS][RESIDUES]; } network;

typedef struct walk {
    int leaves, primes, residues, states, cost, n_live, n_out, objective;
    int weight[5];
    double tolerance, yardstick, error;
    int out[OUTPUTS], live[SLOTS], refs[SLOTS], gen[SLOTS], place[SLOTS], mark[SLOTS], is_out[SLOTS];
    int stamp, free_slot[SLOTS], n_free;
    def d[SLOTS];
    u64 val[SLOTS][RESIDUES], inv[SLOTS][2], ratio[SLOTS];
    quad truth[SLOTS][STATES];
    float factor[SLOTS], run[SLOTS][STATES];
    int flip[SLOTS]; /* the value is minus what its definition gives */
    double expected[OUTPUTS][STATES];
    table pairs, ratios;
    int hash_v[2 * SLOTS], hash_r[2 * SLOTS], hash_o[2 * SLOTS];
    u64 rng;
    candidate candidates[CANDIDATES];
    int n_candidates, limit;
    network best;
    long steps, accepted, refused, false_hits, rebuilt;
    /* scratch */
    int stack[4 * SLOTS], seen[SLOTS], deep[SLOTS];
    u64 t0[3 * SLOTS], t1[3 * SLOTS], pre[3 * SLOTS + 1], ratio_of[3 * SLOTS], hash_of[3 * SLOTS], ratio_hash[3 * SLOTS];
    unsigned char maybe[3 * SLOTS];
} walk;

static inline u64 chance(walk *w) {
    u64 x = w->rng;
    x ^= x << 13; x ^= x >> 7; x ^= x << 17;
    return w->rng = x;
}
static inline int below(walk *w, int n) { return (int)((chance(w) >> 11) % (u64)n); }
static inline double unit(walk *w) { return (double)((chance(w) >> 11) + 1) / 9007199254740993.0; }
static inline quad mag(quad x) { return x < 0 ? -x : x; }

#endif
