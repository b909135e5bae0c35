// What a binning record holds: operands in the types that they have in the expression, several
// operands, several updates of an array. Values are also NaN, infinities, -0.0 and overflow. Some
// integers may be summed in private copies, others may not.
// INTEGERS: no
#include <math.h>
#include <stdint.h>
#include <stdio.h>

#include "case.h"

enum { N = 3000, M = 200 };
static int k[N];
static double w[N], u[N], h[M], g[M];
static float f[N], fs[M];
static uint32_t wide[N];
static uint64_t large[N];
static int8_t narrow[M];
static long counts[M], sums[M];
static struct __attribute__((packed)) off_step {
    char tag;
    float y;
    char rest[3];
} off[M];
static struct pair {
    double x;
    double y;
} pairs[M];
static struct kinds {
    double x;
    float y;
} kinds[M];
static struct same_size {
    double x;
    long n;
    uint64_t bits;
} same_size[M];
static struct small_pair {
    int n;
    float y;
} small_pairs[M];
static long double longs[M];

static void odd_numbers(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        h[k[t]] += w[t];
        g[k[t]] *= w[t];
    }
} // BINNED: 44

static void unsigned_operands(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[k[t]] += wide[t];
    for (int t = 0; t < n; t++) // EXPECT: transformed
        g[k[t]] += large[t];
    for (int t = 0; t < n; t++) // EXPECT: transformed
        narrow[k[t]] -= wide[t];
} // BINNED: 51 53 55

static void several_operands(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[k[t]] = (h[k[t]] * 0.5 + w[t]) / (u[t] + 2) - f[t];
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[k[t]] = (h[k[t]] * f[t] + w[t]) / u[t] - wide[t];
} // BINNED: 60

static void several_updates(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        h[k[t]] += w[t];
        h[(k[t] + 1) % M] -= w[t];
        h[(k[t] + 2) % M] += w[t];
        h[(k[t] + 3) % M] = h[(k[t] + 3) % M] * 0.75 + u[t];
        h[(k[t] + 4) % M] += 1;
    }
} // BINNED: 67

static void records_of_two_types(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        fs[k[t]] += f[t];
        fs[(k[t] + 1) % M] += w[t];
    }
} // NOT-BINNED: 77

static void uncertain_operand(int n, const int *restrict at, const double *restrict x, double *restrict to) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        if (x[t] < to[at[t]])
            to[at[t]] = x[t] * 2 + at[t] * 3;
} // NOT-BINNED: 84

static void in_pairs(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        pairs[k[t]].x += w[t];
        pairs[k[t]].y -= u[t];
    }
} // BINNED: 90

static void out_of_step(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        off[k[t]].y += f[t];
} // NOT-BINNED: 97

static void of_two_kinds(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        kinds[k[t]].x += w[t];
        kinds[k[t]].y += f[t];
    }
} // NOT-BINNED: 102

// A record is applied to elements of one type only, never to those of another type of the same size.
static void of_one_size(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        same_size[k[t]].x += w[t];
        same_size[k[t]].n++;
    }
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        same_size[k[t]].n += wide[t];
        same_size[(k[t] + 1) % M].bits += wide[t];
    }
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        small_pairs[k[t]].n += t;
        small_pairs[k[t]].y -= f[t];
    }
} // NOT-BINNED: 110 114 118

static void too_large(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        longs[k[t]] += w[t];
} // NOT-BINNED: 125

// Integers whose update is no integer sum: sums in private copies would give other results.
static void truncated(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        counts[k[t]] += u[t] * 3.7;
} // BINNED: 131

static void steps(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        sums[k[t]] = sums[k[t]] * 3 % 1000003 + wide[t] % 5;
} // BINNED: 136

static void by_two_operators(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        counts[k[t]] += t;
        counts[(k[t] + 1) % M] ^= t;
    }
} // BINNED: 141

// The operand is evaluated once, when the record is made.
static double twice(double x) {
    return x + x;
}
static void by_functions(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[k[t]] = h[k[t]] * 0.5 + (fabs(w[t]) + twice(u[t]));
} // BINNED: 152

// If a read turns out to overlap an update, all results are discarded and the original loop runs.
static void read_far_away(int n, const int *at, const int *deep, const double *from, double *to) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        to[at[t]] += from[deep[t]] * 0.5;
} // BINNED: 158

static void show(const char *what, const void *bytes, size_t size) {
    case_print(what, bytes, size);
}

int main(void) {
    static int deep[N];
    static double both[2 * M];
    case_subscripts(k, N, M);
    case_subscripts(deep, N, M);
    case_values(u, N);
    for (int t = 0; t < N; t++) {
        w[t] = case_value() * 3;
        f[t] = (float)case_value();
        wide[t] = (uint32_t)case_random();
        large[t] = case_random();
        u[t] = u[t] < 0 ? -u[t] : u[t];
    }
    for (int i = 0; i < M; i++)
        h[i] = -0.0, g[i] = i % 7 ? 1 : -0.0;
    w[11] = NAN, w[12] = -INFINITY, w[13] = INFINITY, w[14] = -0.0, w[15] = 1.7e308, w[16] = 5e-324;
    k[13] = k[12], k[16] = k[15], w[17] = 1.7e308, k[17] = k[15];
    for (int round = 0; round < 2; round++) {
        odd_numbers(N);
        show("h", h, sizeof h);
        show("g", g, sizeof g);
        for (int i = 0; i < M; i++)
            h[i] = g[i] = both[i] = i;
        unsigned_operands(N);
        several_operands(N);
        several_updates(N);
        records_of_two_types(N);
        uncertain_operand(N, k, w, h);
        in_pairs(N);
        out_of_step(N);
        of_two_kinds(N);
        of_one_size(N);
        too_large(N);
        truncated(N);
        steps(N);
        by_two_operators(N);
        by_functions(N);
        read_far_away(N, k, deep, both, both);
        read_far_away(N, k, deep, both, both + M / 2);
        read_far_away(N, k, deep, both, both + M);
        show("h", h, sizeof h);
        show("g", g, sizeof g);
        show("narrow", narrow, sizeof narrow);
        show("fs", fs, sizeof fs);
        show("pairs", pairs, sizeof pairs);
        show("off", off, sizeof off);
        for (int i = 0; i < M; i++)
            printf("%a %a %La\n", kinds[i].x, kinds[i].y, longs[i]);
        for (int i = 0; i < M; i++)
            printf("%a %ld %llu %d %a\n", same_size[i].x, same_size[i].n,
                   (unsigned long long)same_size[i].bits, small_pairs[i].n, small_pairs[i].y);
        show("counts", counts, sizeof counts);
        show("sums", sums, sizeof sums);
        show("both", both, sizeof both);
    }
}
