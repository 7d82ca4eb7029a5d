/*
 * Checks and times kernels on the GPU of this machine: roofline VALUES > FIGURES.json
 *
 * arms.h lists the kernels (benchmarks/cuda/program.py writes it), VALUES has states and what the C gives there.
 * Kernels whose products and sums are not fused have to give the same bits, the others, which are timed, nearly.
 */
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include <cuda_runtime.h>

#include "arms.h"

static void need(cudaError_t error, const char *what)
{
    if (error != cudaSuccess) {
        fprintf(stderr, "%s: %s\n", what, cudaGetErrorString(error));
        exit(1);
    }
}

/* States of blocks of 32, again and again the given rows of n numbers. */
template <class Real> __global__ void fill(Real *blocks, const Real *rows, int n, int states, size_t numbers)
{
    const size_t step = (size_t)gridDim.x * blockDim.x;
    for (size_t i = (size_t)blockIdx.x * blockDim.x + threadIdx.x; i < numbers; i += step) {
        const size_t k = i / (32 * n) * 32 + i % 32;
        blocks[i] = rows[k % states * n + i / 32 % n];
    }
}

static char *pool;
static size_t pool_bytes;
static cudaEvent_t begin_event, end_event;

static size_t padded(size_t count, size_t n, size_t real)
{
    return ((count + 31) / 32 * 32 * n * real + 255) / 256 * 256;
}

static void launch(const void *kernel, const Function &f, char *const *arrays, size_t count, int blocks, int threads)
{
    void *arguments[20] = {&count};
    for (int i = 0; i < f.inputs + f.outputs; ++i) {
        arguments[i + 1] = (void *)&arrays[i];
    }
    need(cudaLaunchKernel(kernel, dim3(blocks), dim3(threads), arguments, 0, nullptr), f.name);
}

/* The arrays of count states in the pool; how many bytes they take. */
static size_t place(const Function &f, size_t count, size_t real, char **arrays)
{
    size_t at = 0;
    for (int i = 0; i < f.inputs + f.outputs; ++i) {
        arrays[i] = pool + at;
        at += padded(count, f.sizes[i], real);
    }
    return at;
}

struct Difference {
    int bits, far, behind;
    double worst;
};

template <class Real>
static Difference difference(const void *kernel, const Function &f, const std::vector<std::vector<Real>> &rows)
{
    char *arrays[20];
    place(f, STATES, sizeof(Real), arrays);
    char *const given = pool + pool_bytes / 2;
    for (int i = 0; i < f.inputs + f.outputs; ++i) {
        const size_t numbers = (STATES + 31) / 32 * 32 * (size_t)f.sizes[i];
        need(cudaMemset(arrays[i], 0xff, numbers * sizeof(Real)), "memset");
        if (i < f.inputs) {
            need(cudaMemcpy(given, rows[i].data(), rows[i].size() * sizeof(Real), cudaMemcpyHostToDevice), "copy");
            fill<Real><<<64, 128>>>((Real *)arrays[i], (const Real *)given, f.sizes[i], STATES, numbers);
            need(cudaDeviceSynchronize(), "fill");
        }
    }
    launch(kernel, f, arrays, STATES, 3, 64); /* fewer threads than states */
    need(cudaDeviceSynchronize(), f.name);
    Difference found = {0, 0, 0, 0.0};
    const double near = sizeof(Real) == 4 ? 1e-3 : 1e-9;
    for (int i = f.inputs; i < f.inputs + f.outputs; ++i) {
        const size_t n = f.sizes[i], whole = (STATES + 31) / 32 * 32;
        std::vector<Real> results(whole * n);
        need(cudaMemcpy(results.data(), arrays[i], results.size() * sizeof(Real), cudaMemcpyDeviceToHost), "copy");
        double size = 1e-30;
        for (Real x : rows[i]) {
            size = fmax(size, fabs((double)x));
        }
        for (size_t k = 0; k < whole; ++k) {
            int bits = 0, far = 0;
            for (size_t j = 0; j < n; ++j) {
                const Real *const at = &results[(k / 32 * n + j) * 32 + k % 32];
                if (k >= STATES) {
                    for (size_t b = 0; b < sizeof(Real); ++b) {
                        found.behind += ((const unsigned char *)at)[b] != 0xff;
                    }
                    continue;
                }
                const Real expected = rows[i][k * n + j];
                if (*at != *at && expected != expected) {
                    continue; /* no number, as it should be */
                }
                const double error = fabs((double)*at - (double)expected) / size;
                bits |= memcmp(at, &expected, sizeof(Real)) != 0;
                far |= !(error <= near);
                found.worst = error <= found.worst ? found.worst : error;
            }
            found.bits += bits;
            found.far += far;
        }
    }
    return found;
}

static double best(const void *kernel, const Function &f, char *const *arrays, size_t count)
{
    const int blocks = (int)((count + 127) / 128);
    double least = 1e30;
    launch(kernel, f, arrays, count, blocks, 128); /* a warm-up */
    for (int turn = 0; turn < 10; ++turn) {
        float ms;
        need(cudaEventRecord(begin_event), "event");
        launch(kernel, f, arrays, count, blocks, 128);
        need(cudaEventRecord(end_event), "event");
        need(cudaEventSynchronize(end_event), f.name);
        need(cudaEventElapsedTime(&ms, begin_event, end_event), "event");
        least = ms * 1e-3 < least ? ms * 1e-3 : least;
        if (turn > 1 && ms > 50.0f) {
            break;
        }
    }
    return least;
}

static double copied(void)
{
    const size_t bytes = pool_bytes / 2 < (size_t)1 << 31 ? pool_bytes / 2 : (size_t)1 << 31;
    double least = 1e30;
    for (int turn = 0; turn < 11; ++turn) {
        float ms;
        need(cudaEventRecord(begin_event), "event");
        need(cudaMemcpyAsync(pool + pool_bytes / 2, pool, bytes, cudaMemcpyDeviceToDevice), "copy");
        need(cudaEventRecord(end_event), "event");
        need(cudaEventSynchronize(end_event), "copy");
        need(cudaEventElapsedTime(&ms, begin_event, end_event), "event");
        least = ms * 1e-3 < least ? ms * 1e-3 : least;
    }
    return 2e-9 * (double)bytes / least;
}

static std::chrono::steady_clock::time_point start;

template <class Real> static void measure(const Arm &arm, FILE *values, double copy, int *wrong, const char **comma)
{
    for (int m = 0; m < arm.count; ++m) {
        const Function &f = arm.functions[m];
        std::vector<std::vector<Real>> rows(f.inputs + f.outputs);
        size_t bytes = 0;
        for (int i = 0; i < f.inputs + f.outputs; ++i) {
            rows[i].resize((size_t)STATES * f.sizes[i]);
            bytes += f.sizes[i] * sizeof(Real);
            if (fread(rows[i].data(), sizeof(Real), rows[i].size(), values) != rows[i].size()) {
                fprintf(stderr, "the file of values is too short\n");
                exit(1);
            }
        }
        const Difference exact = difference<Real>(arm.exact[m], f, rows);
        const Difference fused = difference<Real>(arm.kernels[m], f, rows);
        *wrong += exact.bits > 0 || exact.behind > 0 || fused.behind > 0;
        printf("%s\n{\"arm\": \"%s\", \"scalar\": \"%s\", \"function\": \"%s\", \"bytes\": %zu, \"states\": %d,\n"
               " \"other_bits\": %d, \"behind\": %d, \"fused_far\": %d, \"fused_worst\": %.3g, \"times\": [",
               *comma, arm.name, arm.scalar, f.name, bytes, STATES, exact.bits, exact.behind + fused.behind, fused.far,
               fused.worst);
        *comma = ",";
        fprintf(stderr, "%-8s %-6s %-34s %s bits, fused %.1e (%d far)", arm.name, arm.scalar, f.name,
                exact.bits ? "OTHER" : "same", fused.worst, fused.far);
        size_t most = (size_t)1 << 24;
        char *arrays[20];
        while (place(f, most, sizeof(Real), arrays) + ((size_t)1 << 24) > pool_bytes) {
            most /= 4;
        }
        for (int i = 0; i < f.inputs; ++i) {
            char *const given = pool + pool_bytes - ((size_t)1 << 24);
            const size_t numbers = (most + 31) / 32 * 32 * (size_t)f.sizes[i];
            need(cudaMemcpy(given, rows[i].data(), rows[i].size() * sizeof(Real), cudaMemcpyHostToDevice), "copy");
            fill<Real><<<4096, 256>>>((Real *)arrays[i], (const Real *)given, f.sizes[i], STATES, numbers);
            need(cudaDeviceSynchronize(), "fill");
        }
        double seconds = 0.0;
        const char *between = "";
        for (size_t count = 1024; count <= most; count *= 4) {
            const std::chrono::duration<double> past = std::chrono::steady_clock::now() - start;
            if (past.count() > SECONDS) {
                break;
            }
            seconds = best(arm.kernels[m], f, arrays, count);
            printf("%s[%zu, %.9g]", between, count, seconds);
            between = ", ";
            if (count * 4 > most) {
                const double gbs = 1e-9 * (double)(bytes * count) / seconds;
                fprintf(stderr, "; %zu states: %.3g states/s, %.0f GB/s, %.0f %% of a copy", count, count / seconds,
                        gbs, 100.0 * gbs / copy);
            }
        }
        printf("]}");
        fprintf(stderr, "\n");
    }
}

int main(int argc, char **argv)
{
    size_t free_bytes, all;
    int wrong = 0, version = 0;
    cudaDeviceProp device;
    const char *comma = "";
    FILE *const values = argc == 2 ? fopen(argv[1], "rb") : nullptr;
    if (values == nullptr) {
        fprintf(stderr, "usage: roofline VALUES > FIGURES.json\n");
        return 2;
    }
    start = std::chrono::steady_clock::now();
    need(cudaGetDeviceProperties(&device, 0), "device");
    need(cudaRuntimeGetVersion(&version), "version");
    need(cudaMemGetInfo(&free_bytes, &all), "memory");
    pool_bytes = free_bytes / 10 * 9 / 512 * 512;
    need(cudaMalloc((void **)&pool, pool_bytes), "memory");
    need(cudaEventCreate(&begin_event), "event");
    need(cudaEventCreate(&end_event), "event");
    const double copy = copied();
    fprintf(stderr, "%s, a copy in its memory: %.0f GB/s\n", device.name, copy);
    printf("{\"device\": \"%s\", \"cuda\": %d, \"copy\": %.1f, \"functions\": [", device.name, version, copy);
    for (const Arm &arm : arms) {
        if (arm.real == sizeof(float)) {
            measure<float>(arm, values, copy, &wrong, &comma);
        } else {
            measure<double>(arm, values, copy, &wrong, &comma);
        }
    }
    const std::chrono::duration<double> past = std::chrono::steady_clock::now() - start;
    printf("\n], \"wrong\": %d, \"seconds\": %.1f}\n", wrong, past.count());
    fprintf(stderr, "%d functions with other bits than the C, or written behind the last state; %.1f s\n", wrong,
            past.count());
    return wrong != 0;
}
