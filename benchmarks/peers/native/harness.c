/*
 * Races runners (shared libraries, see peer.h) in one process.
 *
 *   harness check STATES FOLDER OUT LIB...          results of all, one after another, to OUT
 *   harness time STATES FOLDER ROUNDS NS LIB...     a line a round: nanoseconds a state of every runner
 *   harness count STATES FOLDER PASSES LIB          so many passes and nothing else, for callgrind
 *
 * In every round each runner has one block of about NS nanoseconds, after a pass that brings it into the caches;
 * who begins changes from round to round. The clock is that of this thread's processor time.
 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

typedef struct {
    int (*open)(const char *, int, int, const double *, const double *, const double *);
    void (*run)(void);
    void (*result)(double *);
    size_t size; /* of a state's results */
    long repeats;
} runner;

static int count, n;
static double *states;

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return 1e9 * (double)t.tv_sec + (double)t.tv_nsec;
}

static void fail(const char *what, const char *name)
{
    fprintf(stderr, "%s: %s\n", name, what);
    exit(2);
}

static void read_states(const char *path)
{
    int64_t head[2];
    FILE *file = fopen(path, "rb");
    size_t wanted;
    if (!file || fread(head, sizeof head, 1, file) != 1)
        fail("cannot be read", path);
    count = (int)head[0];
    n = (int)head[1];
    wanted = (size_t)count * (size_t)n * 3;
    states = malloc(wanted * sizeof(double));
    if (!states || fread(states, sizeof(double), wanted, file) != wanted)
        fail("is too short", path);
    fclose(file);
}

static runner open_runner(const char *path, const char *folder)
{
    runner r;
    int (*size)(int);
    size_t block = (size_t)count * (size_t)n;
    void *library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    if (!library)
        fail(dlerror(), path);
    *(void **)&r.open = dlsym(library, "peer_open");
    *(void **)&r.run = dlsym(library, "peer_run");
    *(void **)&r.result = dlsym(library, "peer_result");
    if (!r.open || !r.run || !r.result)
        fail("is no runner", path);
    if (r.open(folder, count, n, states, states + block, states + 2 * block))
        fail("cannot be set up", path);
    *(void **)&size = dlsym(library, "peer_size");
    r.size = (size_t)(size ? size(n) : n);
    r.repeats = 1;
    return r;
}

static double block_time(const runner *r)
{
    double start = now();
    long k;
    for (k = 0; k < r->repeats; k++)
        r->run();
    return (now() - start) / ((double)r->repeats * count);
}

static void check(runner *all, int runners, const char *path)
{
    FILE *file = fopen(path, "wb");
    int i;
    if (!file)
        fail("cannot be written", path);
    for (i = 0; i < runners; i++) {
        size_t block = (size_t)count * all[i].size;
        double *results = malloc(block * sizeof(double));
        if (!results)
            fail("has too many results", path);
        all[i].run();
        all[i].result(results);
        if (fwrite(results, sizeof(double), block, file) != block)
            fail("cannot be written", path);
        free(results);
    }
    fclose(file);
}

static void race(runner *all, int runners, long rounds, double wanted)
{
    double *times = malloc((size_t)runners * sizeof(double));
    long round;
    int i;
    for (i = 0; i < runners; i++) { /* how often fits into a block */
        double each;
        all[i].run();
        do {
            all[i].repeats *= 2;
            each = block_time(&all[i]);
        } while (each * (double)all[i].repeats * count < wanted / 2 && all[i].repeats < 1L << 30);
        all[i].repeats = (long)(wanted / (each * count));
        if (all[i].repeats < 1)
            all[i].repeats = 1;
    }
    for (round = 0; round < rounds; round++) {
        for (i = 0; i < runners; i++) {
            int who = (int)((i * (round % 2 ? runners - 1 : 1) + round) % runners);
            all[who].run();
            times[who] = block_time(&all[who]);
        }
        for (i = 0; i < runners; i++)
            printf("%.6g%c", times[i], i + 1 < runners ? ' ' : '\n');
    }
    free(times);
}

int main(int argc, char **argv)
{
    int first = argc > 1 && strcmp(argv[1], "time") == 0 ? 6 : 5, runners = argc - first, i;
    runner *all;
    if (runners < 1) {
        fprintf(stderr, "harness check|time|count STATES FOLDER ... LIB...\n");
        return 2;
    }
    read_states(argv[2]);
    all = malloc((size_t)runners * sizeof *all);
    for (i = 0; i < runners; i++)
        all[i] = open_runner(argv[first + i], argv[3]);
    if (strcmp(argv[1], "check") == 0)
        check(all, runners, argv[4]);
    else if (strcmp(argv[1], "time") == 0)
        race(all, runners, atol(argv[4]), atof(argv[5]));
    else
        for (i = 0; i < atoi(argv[4]); i++)
            all[0].run();
    return 0;
}
