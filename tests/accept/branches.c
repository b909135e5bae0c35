/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Conditional directives within a loop and directly above it. The generated text contains only the branches
// that this compilation selects. (tests/attacks tests other compilations, in case 47.)
// covers: row 3 of docs/constructs.md
#include "case.h"

#define HAS_WEIGHTS 1
#define LEVEL 2
#define ADD(array, place, value) (array)[place] += (value)

enum { N = 3000, ROWS = 80 };
static int s[N];
static double e[N], h[ROWS], g[ROWS];
static long counted[ROWS];
struct mesh {
    double *b;
};

static void one_of_two(int n, const int *k, double *restrict to) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
#ifdef NO_WEIGHTS
        to[k[t]] += 1.0;
#else
        to[k[t]] += e[t];
#endif
    }
}

static void nested(int n, struct mesh *m) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
#if HAS_WEIGHTS
#if LEVEL < 2
        m->b[s[t]] += 2 * e[t];
#  elif LEVEL == 2 /* over
                      two lines */ && \
      HAS_WEIGHTS
        m->b[s[t]] += 3 * e[t];
#ifdef NO_WEIGHTS
        m->b[0] = 7;
#endif
#elif LEVEL == 3
        m->b[s[t]] -= e[t];
#else
        m->b[s[t]] -= 2 * e[t];
#if LEVEL
        m->b = 0;
#else
        m->b = 1;
#endif
#endif
#elif LEVEL
        m->b[s[t]] = e[t];
#endif
    }
}

/* Branches that are not complete statements. */
static void pieces(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
#if 0
        } else { /* " */ h[0] = 1;
#endif
#ifndef NO_WEIGHTS
        if (s[t] > 3)
#endif
            h[s[t]] += e[t];
#ifdef NO_WEIGHTS
        if (e[t] > 0) {
            g[s[t]] = 0;
#else
        {
#endif
            g[s[t]] -=
#if LEVEL == 2
                2 *
#else
                3 *
#endif
                e[t];
        }
    }
}

static int without_braces(int n) {
    int t;
    if (n > 2)
        for (t = 0; // EXPECT: transformed
#ifdef NO_WEIGHTS
             t <= n
#else
             t < n
#endif
             ;
             t++)
            counted[s[t]
#ifdef NO_WEIGHTS
                    + 1
#endif
            ]++;
    else
        t = -1;
    return t;
}

static double sum_beside(int n) {
    double sum = 0;
    int t = 0;
    while (t < n) { // EXPECT: transformed
        double v = e[t];
#ifdef NO_WEIGHTS
        v = 1;
#endif
        sum += v;
#ifndef NO_WEIGHTS
        ADD(h, s[t], v);
#else
        ADD(h, s[t], 1);
#endif
#if LEVEL > 1
        t++;
#else
        t += 2;
#endif
    }
    return sum;
}

/* Pragmas that this compilation selects and pragmas that it does not. */
static void pragmas(int n) {
#ifndef NDEBUG
#ifdef CHECKED
    for (int t = 0; t < n; t++)
        if (s[t] < 0)
            return;
#endif
#endif
#ifdef WITH_THREADS
#pragma omp parallel for
#endif
    for (int t = 0; t < n; t++) { // EXPECT: transformed
#ifdef WITH_THREADS
#pragma omp atomic
#endif
        counted[s[t]] += 2;
    }
#ifdef __GNUC__
#pragma GCC unroll 2
#endif
    for (int t = 0; t < n; t++) // EXPECT: transformed
        counted[s[t]] += 3;
}

/* Preprocessor branches with two versions of the function. In the other version a declaration precedes the loop. */
static void other_versions(int n) {
#ifdef WITH_THREADS
    for (int t = 0; t < n; t++)
        counted[s[t]]--;
#else
#if LEVEL > 2
    int lock = -1; // of the row
#endif
    for (int t = 0; t < n; t++) { // EXPECT: transformed
#if LEVEL > 2
        lock = s[t];
#endif
        counted[s[t]] += 5;
    }
#endif
}

static void floating_subscript(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
#ifdef NO_WEIGHTS
        h[s[t]] += 1;
#else
        h[(int)(e[t] * 8 + 40.5)] += 1;
#endif
    }
}

/* Pragmas that are hints for the compiler: the generated copy omits them. */
static void hints(int n) {
    for (int t = 0; t < n; t += 2) { // EXPECT: transformed
#pragma GCC ivdep
        for (int c = 0; c < 2; c++)
            h[s[t + c]] += e[t];
#ifdef __GNUC__
#  pragma GCC unroll 4
#endif
        for (int c = 0; c < 2; c++) {
            const double v = e[t + c] * 0.5;
            if (s[t] > c)
                g[s[t + c]] -= v;
        }
    }
}

int main(void) {
    struct mesh m = {g};
    case_values(e, N);
    double sum = 0;
    for (int round = 0; round < 3; round++) {
        case_subscripts(s, N, ROWS);
        one_of_two(N, s, h);
        nested(N, &m);
        pieces(N);
        printf("%d %d\n", without_braces(N - 1), without_braces(1));
        sum += sum_beside(N);
        pragmas(N - 7);
        other_versions(N);
        floating_subscript(N);
        hints(N);
        CASE_PRINT(h);
        CASE_PRINT(g);
        CASE_PRINT(counted);
    }
    case_print("sum", &sum, sizeof sum);
    return 0;
}
