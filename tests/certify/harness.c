#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "NAME.h"

/* The next number of the bytes, whatever it is; 0 where they are at an end. */
static const uint8_t *bytes;
static size_t left;
static NAME_real next(void)
{
    NAME_real x = 0;
    if (left >= sizeof x) {
        memcpy(&x, bytes, sizeof x);
        bytes += sizeof x;
        left -= sizeof x;
    }
    return x;
}

static void same_and_finite(const char *what, const NAME_real *x, const NAME_real *y, int n, int tame)
{
    for (int i = 0; i < n; i++) {
        if (x[i] != y[i] && !(isnan(x[i]) && isnan(y[i]))) {
            fprintf(stderr, "%s[%d] differs from call to call\n", what, i);
            abort();
        }
        if (tame && !isfinite(x[i])) {
            fprintf(stderr, "%s[%d] is not finite\n", what, i);
            abort();
        }
    }
}

FUNCTIONS
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
CALLS    return 0;
}

#ifdef ALONE
/* 64 bits at a time: raw, or a number that is special, tame, subnormal or huge. */
static uint64_t state = 88172645463325252u;
static uint64_t draw(void)
{
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return state;
}

int main(void)
{
    static const double special[] = {
        0.0, -0.0, 1e-310, 1e308, 1e30, 6434.0, 411775.0, 1.5707963267948966, INFINITY, NAN,
    };
    uint8_t data[64*sizeof(NAME_real)];
    for (int run = 0; run < 20000; run++) {
        for (size_t i = 0; i < sizeof data; i += sizeof(NAME_real)) {
            const uint64_t bits = draw();
            const uint64_t kind = run % 4 == 0 ? 0 : draw() % 4;
            NAME_real x = (NAME_real)((double)(int64_t)bits/3e18);
            if (kind == 1)
                x = (NAME_real)special[bits % (sizeof special/sizeof special[0])];
            memcpy(data + i, &x, sizeof x);
            if (kind == 2)
                memcpy(data + i, &bits, sizeof x);
        }
        LLVMFuzzerTestOneInput(data, sizeof data);
    }
    return 0;
}
#endif
