/* The clock in GHz, several times: additions of which each waits for the one before take a cycle each. */
#define _GNU_SOURCE
#include <stdio.h>
#include <time.h>

#if !defined(__x86_64__)
#error "the additions are written for x86-64"
#endif

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return 1e9 * (double)t.tv_sec + (double)t.tv_nsec;
}

int main(void)
{
    int k;
    for (k = 0; k < 20; k++) {
        const long count = 20000000;
        double start = now();
        unsigned long x = 0;
        long i;
        for (i = 0; i < count; i++)
            __asm__ volatile("add $1, %0" : "+r"(x));
        printf("%.3f\n", (double)count / (now() - start));
    }
    return 0;
}
