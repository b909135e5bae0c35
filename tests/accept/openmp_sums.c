// Loops with OpenMP directives that update an array of integers and add up a scalar, executed in bins with private
// copies, in shares, and by owners: each execution adds up the scalar's operands in the order that it keeps.
// CFLAGS: -fopenmp
// FLAGS: -fopenmp
// SEQUENTIAL: with OpenMP, the program's own directives may sum in any order
// FIXED: 18 28
// THREADS: 1 2 3 7 16 33
// MAY-RUN-SERIALLY: some executions are short
#include "case.h"

enum { N = 20000, M = 256, ROUNDS = 4 };
static int k[N], counts[M];
static double w[N], sums[ROUNDS][4];

static double clause(int n, const int *restrict s, const double *restrict v, int *restrict h) {
    double total = 0;
#pragma omp parallel for reduction(+ : h[:M]) reduction(+ : total)
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        h[s[t]] += s[t] % 7;
        total += v[t];
    }
    return total;
}

static double locked(int n, const int *restrict s, const double *restrict v, int *restrict h) {
    double total = 0;
#pragma omp parallel for reduction(- : total)
    for (int t = 0; t < n; t++) { // EXPECT: transformed
#pragma omp atomic
        h[s[t]] -= s[t] % 7;
        total -= v[t];
    }
    return total;
}

int main(void) {
    case_subscripts(k, N, M);
    case_values(w, N);
    for (int round = 0; round < ROUNDS; round++) {
        sums[round][0] = clause(308 + round, k, w, counts);
        sums[round][1] = locked(300 + round, k, w, counts);
        sums[round][2] = clause(N - round, k, w, counts);
        sums[round][3] = locked(N - round, k, w, counts);
    }
    CASE_PRINT(sums);
    CASE_PRINT(counts);
    return 0;
}
