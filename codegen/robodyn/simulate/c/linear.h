/* Small dense linear algebra; matrices are row-major with rows of length `wide`. */
#ifndef LINEAR_H
#define LINEAR_H
#include <math.h>

/* L D L^T of a symmetric matrix: L goes below the diagonal, the inverses of D to `inverse`; the diagonal and what
 * is above it stay. 0 unless positive definite. */
static inline int ldl_factor(int n, int wide, double *A, double *inverse) {
    double c[N > E1 ? N : E1];
    for (int i = 0; i < n; i++) {
        double *row = A + i * wide, d = row[i];
        for (int j = 0; j < i; j++) {
            const double *other = A + j * wide;
            double sum = other[i];
            for (int k = 0; k < j; k++) sum -= c[k] * other[k];
            c[j] = sum;
            row[j] = sum * inverse[j];
            d -= sum * row[j];
        }
        if (!(d > 0 && d <= 1e300)) return 0;
        inverse[i] = 1 / d;
    }
    return 1;
}

static inline void ldl_solve(int n, int wide, const double *A, const double *inverse, double *b) {
    for (int i = 1; i < n; i++)
        for (int k = 0; k < i; k++) b[i] -= A[i * wide + k] * b[k];
    for (int i = 0; i < n; i++) b[i] *= inverse[i];
    for (int i = n - 1; i > 0; i--)
        for (int k = 0; k < i; k++) b[k] -= A[i * wide + k] * b[i];
}

/* L U with partial pivoting, in place. 0 if singular. */
static inline int lu_factor(int n, int wide, double *A, int *pivot) {
    for (int j = 0; j < n; j++) {
        int best = j;
        for (int i = j + 1; i < n; i++)
            if (fabs(A[i * wide + j]) > fabs(A[best * wide + j])) best = i;
        double d = A[best * wide + j];
        pivot[j] = best;
        if (!(fabs(d) > 0 && fabs(d) <= 1e300)) return 0;
        if (best != j)
            for (int k = 0; k < n; k++) {
                double kept = A[j * wide + k];
                A[j * wide + k] = A[best * wide + k];
                A[best * wide + k] = kept;
            }
        for (int i = j + 1; i < n; i++) {
            double factor = A[i * wide + j] /= d;
            for (int k = j + 1; k < n; k++) A[i * wide + k] -= factor * A[j * wide + k];
        }
    }
    return 1;
}

static inline void lu_solve(int n, int wide, const double *A, const int *pivot, double *b) {
    for (int i = 0; i < n; i++) {
        double kept = b[pivot[i]];
        b[pivot[i]] = b[i];
        b[i] = kept;
    }
    for (int i = 1; i < n; i++)
        for (int k = 0; k < i; k++) b[i] -= A[i * wide + k] * b[k];
    for (int i = n - 1; i >= 0; i--) {
        for (int k = i + 1; k < n; k++) b[i] -= A[i * wide + k] * b[k];
        b[i] /= A[i * wide + i];
    }
}

static inline double dot(const double *a, const double *b) {
    double sum = 0;
    for (int i = 0; i < N; i++) sum += a[i] * b[i];
    return sum;
}
#endif
