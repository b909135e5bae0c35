/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Sums of scalars in loops inside: of integers they are put together by each iteration; of floating
// numbers their order matters, and only the loop inside remains.
// covers: row 59
#include "case.h"

enum { N = 3000, M = 900 };
static int first[N + 1], neighbour[40 * N];
static double x[M], force[M];
static long pairs, energy_in_units;
static unsigned char small = 250;
static unsigned marks = ~0u, product = 1;

static void count_pairs(int n, double cut) {
    int near = 7;
    unsigned hash = 0;
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        for (int p = first[i]; p < first[i + 1]; p++) {
            const int j = neighbour[p];
            const double d = x[j] - x[i % M];
            if (d > cut)
                continue;
            near++;
            pairs -= j;
            hash ^= (unsigned)j * 2654435761u;
            force[j] += d;
        }
        force[i % M] -= 1.0;
        near += 2;
    }
    pairs += near;
    marks ^= hash;
}

static void all_operators(int n) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        int p = first[i];
        while (p < first[i + 1]) {
            force[neighbour[p]] += x[neighbour[p]];
            small += (unsigned char)p;
            product *= 2u * (unsigned)neighbour[p] + 1u;
            marks &= ~(1u << (neighbour[p] & 3));
            energy_in_units = energy_in_units - (long)(1e3 * x[neighbour[p]]);
            p++;
        }
    }
}

/* The operands of floating sums cannot be put together: other bits. */
static double energy(int n) {
    double sum = 0.0;
    for (int i = 0; i < n; i++) // EXPECT: refuse scalar-carried
        for (int p = first[i]; p < first[i + 1]; p++) { // EXPECT: transformed
            force[neighbour[p]] += x[neighbour[p]];
            sum += x[neighbour[p]];
        }
    return sum;
}

/* (s + a) * b + c: not what the iterations put together. */
static unsigned two_operators(int n) {
    unsigned s = 1;
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        for (int p = first[i]; p < first[i + 1]; p++) { // EXPECT: transformed
            force[neighbour[p]] += x[neighbour[p]];
            s += (unsigned)neighbour[p];
        }
        s *= 3;
    }
    return s;
}

/* What it has come to is the next inner loop's bound. */
static int read_as_a_bound(int n) {
    int s = 0;
    for (int i = 0; i < n; i++)
        for (int p = first[i]; p < first[i + 1] && p < s + 100000; p++) { // EXPECT: refuse trip-count
            force[neighbour[p]] += x[neighbour[p]];
            s++;
        }
    return s;
}

int main(void) {
    for (int i = 0; i < N; i++)
        first[i + 1] = first[i] + case_below(40);
    case_near_subscripts(neighbour, first[N], M);
    case_values(x, M);
    double sum = 0.0;
    unsigned s = 0;
    for (int k = 0; k < 3; k++) {
        count_pairs(N - k, 0.25);
        all_operators(N);
        sum += energy(20 + k);
        s += two_operators(15) + (unsigned)read_as_a_bound(N);
    }
    count_pairs(0, 1.0);
    CASE_PRINT(force);
    const long others[] = {pairs, energy_in_units, small, marks, product, s};
    CASE_PRINT(others);
    case_print("sum", &sum, sizeof sum);
    return 0;
}
