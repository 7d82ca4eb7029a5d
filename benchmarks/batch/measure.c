/* Nanoseconds a state of batches, thread CPU time, the fastest of all rounds: a line for each function, layout
 * and number of states. functions.h: functions[]; BLOCK; MOST, SUM: numbers that a state has in one array of
 * any function, and in all results of one. */
#define _GNU_SOURCE
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <time.h>

#include "functions.h"

enum { ARRAYS = 6, LAYOUTS = 3, ROUNDS = 12, LINE = 8, HUGE_PAGE = 1 << 21 };
static const size_t counts[] = {64, 512, 4096, 131072, 1000000};
enum { COUNTS = sizeof counts / sizeof *counts, FUNCTIONS = sizeof functions / sizeof *functions };
static const char *const layouts[] = {"blocks", "rows", "columns"};
static double *memory[ARRAYS];
static volatile double sink;

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return (double)t.tv_sec * 1e9 + (double)t.tv_nsec;
}

/* The bytes of a state alone: the inputs read, and as many as the results have written past the caches. */
static double bytes_alone(size_t count, size_t read, size_t written)
{
    typedef double Two __attribute__((vector_size(16)));
    const Two *from = (const Two *)memory[0];
    double *to = memory[ARRAYS - 1];
    const double start = now();
    Two sum = {0, 0};
    size_t k, i;
    for (k = 0; k < count / LINE; ++k) {
        for (i = 0; i < read * LINE / 2; ++i) {
            sum += *from++;
        }
        for (i = 0; i < written * LINE; i += 2, to += 2) {
            __builtin_ia32_movntpd(to, sum);
        }
    }
    __builtin_ia32_sfence();
    sink = sum[0] + sum[1];
    return (now() - start) / (double)count;
}

/* Products of the widest vectors, eight at a time: two multipliers are busy for the four cycles of one. */
__attribute__((target_clones("avx512f", "avx2", "default"))) static double products(size_t times)
{
    typedef double Vector __attribute__((vector_size(64)));
    Vector a = {sink}, b = a + 1, c = a + 2, d = a + 3, e = a + 4, f = a + 5, g = a + 6, h = a + 7, x = a + 1;
    const double start = now();
    size_t k;
    for (k = 0; k < times; ++k) {
        a *= x, b *= x, c *= x, d *= x, e *= x, f *= x, g *= x, h *= x;
    }
    {
        const double took = (now() - start) / (double)times / 8 / 8;
        a += b + c + d + e + f + g + h;
        sink = a[0];
        return took;
    }
}

int main(void)
{
    static double best[FUNCTIONS][LAYOUTS][COUNTS], alone[FUNCTIONS], product = 1e9;
    const size_t most = counts[COUNTS - 1];
    size_t f, l, n, k, round;
    for (k = 0; k < ARRAYS; ++k) {
        const size_t size = (most * (k == ARRAYS - 1 ? SUM : MOST) + LINE) * sizeof(double);
        memory[k] = aligned_alloc(HUGE_PAGE, (size + HUGE_PAGE - 1) / HUGE_PAGE * HUGE_PAGE);
        if (memory[k] == NULL) {
            return 1;
        }
        madvise(memory[k], size, MADV_HUGEPAGE); /* as numpy does */
        for (f = 0; f < size / sizeof(double); ++f) {
            memory[k][f] = (double)(f * 7919 % 601) / 100 - 3;
        }
    }
    for (round = 0; round < ROUNDS; ++round) {
        double took = products(200000);
        product = took < product ? took : product;
        for (f = 0; f < FUNCTIONS; ++f) {
            const struct Function *one = functions + f;
            took = bytes_alone(counts[3], one->read, one->written);
            alone[f] = round && alone[f] < took ? alone[f] : took;
            for (l = 0; l < LAYOUTS; ++l) {
                for (n = 0; n < COUNTS; ++n) {
                    const size_t count = counts[n], block = l == 0 ? BLOCK : l == 1 ? 1 : count;
                    const size_t times = 1 + 16384 / count;
                    double *array[ARRAYS];
                    double start;
                    for (k = 0; k < ARRAYS; ++k) {
                        array[k] = memory[k] + (l == 0 ? 0 : 2); /* 16 bytes, as numpy's are */
                    }
                    start = now();
                    for (k = 0; k < times; ++k) {
                        one->call(count, block, array);
                    }
                    took = (now() - start) / (double)(times * count);
                    if (!round || took < best[f][l][n]) {
                        best[f][l][n] = took;
                    }
                }
            }
        }
    }
    printf("product %.6g\n", product);
    for (f = 0; f < FUNCTIONS; ++f) {
        printf("%s %s alone %.6g\n", functions[f].arm, functions[f].name, alone[f]);
        for (l = 0; l < LAYOUTS; ++l) {
            for (n = 0; n < COUNTS; ++n) {
                printf("%s %s %s ", functions[f].arm, functions[f].name, layouts[l]);
                printf("%zu %.6g\n", counts[n], best[f][l][n]);
            }
        }
    }
    return 0;
}
