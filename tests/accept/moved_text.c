/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Loops whose slice and body would change their meaning if moved in front of the function.
// covers: row 2, row 63, row 65, row 68 of docs/constructs.md
// COMPILERS: gcc clang-19
// INTEGERS: no
#include "case.h"

enum { N = 6000, M = 500, SCALE = 3 };
typedef double real;
struct pair {
    double a;
};
static int s[N];
static double w[N], h[M], value = 4.0;
static double half(double x);
#define FACTOR 2.0
#define IN_FRONT __attribute__((noinline))

static void a_macro(int n) {
#undef FACTOR
#define FACTOR 8.0
    for (int t = 0; t < n; t++) // EXPECT: refuse text
        h[s[t]] += FACTOR * w[t];
}

static void a_type(int n) {
    typedef float real;
    struct pair {
        float a;
    } p = {0.1f};
    for (int t = 0; t < n; t++) { // EXPECT: refuse text
        real r = (real)w[t];
        struct pair q = p;
        h[s[t]] += r + q.a;
    }
}

static void an_enumerator(int n) {
    enum { SCALE = 7 };
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]] += SCALE * w[t];
}

static void a_name(int n, double value) {
    static const double table[] = {0.5, 0.25, 0.125};
    double local[3] = {1.0, value, 3.0};
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]] += value * w[t] + table[t % 3] + local[t % 3] + (double)(sizeof table / sizeof *table);
}

static void a_function(int n) {
    double half(double);
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]] += half(w[t]);
}

IN_FRONT
static void attributes(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]] += value * w[t];
}

static double half(double x) {
    return 0.5 * x;
}

static void commas(int n, int (*pairs)[2]) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[((void)0, pairs[t / 2][t % 2])] += w[t];
}

static void several(int n, double value) { for (int t = 0; t < n; t++) h[s[t]] += value; for (int t = 0; t < n; t++) h[s[t]] -= 0.1 * w[t]; } // EXPECT: transformed

int main(void) {
    case_values(w, N);
    for (int round = 0; round < 3; round++) {
        case_subscripts(s, N, M);
        a_macro(N);
        a_type(N);
        an_enumerator(N);
        a_name(N, 0.3);
        a_function(N);
        attributes(N);
        commas(N, (int (*)[2])s);
        several(N, 0.7);
        CASE_PRINT(h);
    }
    return 0;
}
