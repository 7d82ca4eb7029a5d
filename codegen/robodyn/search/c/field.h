/* Numbers modulo primes near 2^61. Everything that is looked up is modulo 2^61 - 1. */
#ifndef FIELD_H
#define FIELD_H
#include <stdint.h>

typedef uint64_t u64;
typedef unsigned __int128 u128;

enum { POINTS = 3, PRIMES = 48, RESIDUES = POINTS + 2 * (PRIMES - 1) };

/* The primes are 2^61 less these: values are known at three points modulo the first, at two modulo each other. */
static const u64 below_2_61[PRIMES] = {
    1, 31, 45, 229, 259, 283, 339, 391, 403, 465, 531, 579, 675, 759, 799, 819, 829, 843, 859, 939, 985,
    1015, 1153, 1195, 1215, 1281, 1299, 1351, 1371, 1425, 1489, 1525, 1533, 1543, 1609, 1621, 1669,
    1741, 1753, 1813, 1845, 1849, 1855, 1863, 1869, 1909, 1921, 1923
};

static const u64 P = ((u64)1 << 61) - 1;
static inline u64 addp(u64 a, u64 b) { u64 c = a + b; return c >= P ? c - P : c; }
static inline u64 subp(u64 a, u64 b) { return a >= b ? a - b : a + P - b; }
static inline u64 mulp(u64 a, u64 b) {
    u128 c = (u128)a * b;
    return addp((u64)c & P, (u64)(c >> 61));
}
static inline u64 mul_below(u64 a, u64 b, u64 c) { /* modulo 2^61 - c, c < 2^20 */
    u64 p = ((u64)1 << 61) - c;
    u128 x = (u128)a * b;
    x = (u128)((u64)x & P) + (u128)(u64)(x >> 61) * c;
    u64 y = ((u64)x & P) + (u64)(x >> 61) * c;
    return y >= p ? y - p : y;
}
static u64 inv_below(u64 a, u64 c) {
    u64 e = ((u64)1 << 61) - c - 2, r = 1;
    for (; e; e >>= 1, a = mul_below(a, a, c))
        if (e & 1) r = mul_below(r, a, c);
    return r;
}
static inline u64 canon(u64 a) { return a > P - a ? P - a : a; }
static inline u64 mix(u64 k) { k *= 0x9E3779B97F4A7C15ull; k ^= k >> 32; k *= 0xD6E8FEB86659FD93ull; return k ^ (k >> 29); }
static inline int prime_of(int residue) { return residue < POINTS ? 0 : 1 + (residue - POINTS) / 2; }

#endif
