/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Scalars summed in inner loops. Integer sums are combined from a partial sum per iteration. For
// floating-point sums each iteration keeps a series of operands, since their order matters.
// covers: row 59 of docs/constructs.md
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

static double energy(int n) {
    double sum = 0.0;
    for (int i = 0; i < n; i++) // EXPECT: transformed
        for (int p = first[i]; p < first[i + 1]; p++) {
            force[neighbour[p]] += x[neighbour[p]];
            sum += x[neighbour[p]];
        }
    return sum;
}

/* `kinetic` is updated in and outside inner loops, in textual order; the other scalars are summed separately. */
struct state {
    int step;
    double virial[3], potential;
};
static double kinetic = 0.125;
static float narrow = 3.0f;

static void several(int n, double cut, struct state *restrict s) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        double own = 0.0;
        kinetic += x[i % M];
        for (int p = first[i]; p < first[i + 1]; p++) {
            const int j = neighbour[p];
            const double d = x[j] - x[i % M];
            if (d > cut)
                continue;
            own += d;
            s->potential = s->potential - d;
            for (int c = 0; c < 3; c++)
                if (c != j % 4)
                    s->virial[1] += d * (double)(c + 1);
            narrow += (float)d;
            force[j] -= d;
        }
        kinetic += own;
        int q = first[i];
        do
            kinetic = x[(i + q) % M] + kinetic;
        while (++q < first[i] + i % 3);
        force[i % M] += own;
    }
}

/* Each addition is in double, and its result is rounded to float. */
static float rounded_each_time(int n) {
    float sum = 1.0f;
    int i = n;
    while (i-- > 0) // EXPECT: transformed
        for (int p = first[i]; p < first[i + 1]; p++) {
            sum += x[neighbour[p]];
            force[neighbour[p]] += 1.0;
        }
    return sum;
}

static double product_of_all(int n, double *restrict f) {
    double whole = 1.0;
    for (int i = 0; i < n; i++) // EXPECT: transformed
        for (int p = first[i]; p < first[i + 1]; p++) {
            whole *= 1.0 + x[neighbour[p]] * 0x1p-9;
            f[neighbour[p]] += (double)(p & 7);
        }
    return whole;
}

/* No iteration reaches the sum: the pointer `s` must not be dereferenced. */
static void never(int n, struct state *restrict s, double limit) {
    for (int i = 0; i < n; i++) // EXPECT: transformed
        for (int p = first[i]; p < first[i + 1]; p++) {
            force[neighbour[p]] += 0.5;
            if (x[neighbour[p]] > limit)
                s->potential += x[neighbour[p]];
        }
}

/* + and - are two operations: with NaNs their results differ in the sign. */
static double two_signs(int n) {
    double sum = 0.0;
    for (int i = 0; i < n; i++) // EXPECT: refuse scalar-carried
        for (int p = first[i]; p < first[i + 1]; p++) { // EXPECT: transformed
            force[neighbour[p]] += x[neighbour[p]];
            sum += x[neighbour[p]];
            if (x[neighbour[p]] > 0.5)
                sum -= 1.0;
        }
    return sum;
}

/* One addition is in double and the other in float: they form no single series. */
static float two_widths(int n) {
    float sum = 0.0f;
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        for (int p = first[i]; p < first[i + 1]; p++) { // EXPECT: transformed
            force[neighbour[p]] += x[neighbour[p]];
            sum += (float)x[neighbour[p]];
        }
        sum += x[i % M];
    }
    return sum;
}

static double read_in_between(int n) {
    double sum = 0.0;
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        for (int p = first[i]; p < first[i + 1]; p++) { // EXPECT: transformed
            force[neighbour[p]] += x[neighbour[p]];
            sum += x[neighbour[p]];
        }
        force[i % M] += sum;
    }
    return sum;
}

static double largest_too(int n) {
    double sum = 0.0;
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        for (int p = first[i]; p < first[i + 1]; p++) { // EXPECT: transformed
            force[neighbour[p]] += x[neighbour[p]];
            sum += x[neighbour[p]];
        }
        if (x[i % M] > sum)
            sum = x[i % M];
    }
    return sum;
}

/* `sum` may point to an element of `f`, and does in some calls. */
static void by_pointer(int n, double *sum, double *f) {
    for (int i = 0; i < n; i++) // EXPECT: transformed
        for (int p = first[i]; p < first[i + 1]; p++) {
            f[neighbour[p]] += x[neighbour[p]];
            *sum += x[neighbour[p]];
        }
}

/* (s + a) * b + c: the operands of two iterations cannot be combined. */
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

/* The sum's current value is part of the inner loop's bound. */
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
    struct state state = {0};
    for (int k = 0; k < 3; k++) {
        count_pairs(N - k, 0.25);
        all_operators(N);
        sum += energy(N - k);
        several(N - k, 0.25, &state);
        sum += rounded_each_time(N - k) + product_of_all(N, force);
        sum += two_signs(5) + (double)two_widths(5) + read_in_between(5) + largest_too(5);
        never(N - k, NULL, 1e9);
        by_pointer(9, &force[3], force);
        by_pointer(N - k, &state.virial[2], force);
        s += two_operators(15) + (unsigned)read_as_a_bound(N);
    }
    count_pairs(0, 1.0);
    CASE_PRINT(force);
    const long others[] = {pairs, energy_in_units, small, marks, product, s};
    CASE_PRINT(others);
    case_print("sum", &sum, sizeof sum);
    case_print("state", &state, sizeof state);
    case_print("kinetic", &kinetic, sizeof kinetic);
    case_print("narrow", &narrow, sizeof narrow);
    return 0;
}
