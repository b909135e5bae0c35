/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Loops changed as docs/reasons.md advises for source text (advice_updates.c explains BEFORE).
#include <stddef.h>
#include "case.h"

enum { N = 2000, ROWS = 80 };
static int s[N], table[ROWS];
static double e[N], h[ROWS], g[ROWS];

#define EACH(t, n) for (int t = 0; t < n; t++)

static void in_macro(int n) {
#ifdef BEFORE
    EACH(t, n) // BEFORE: in-macro
        h[s[t]]++;
#else
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]]++;
#endif
}

#ifndef BEFORE
#define WEIGHT 2
#endif

static void directive_in_range(int n) {
    int t;
#ifdef BEFORE
    for (t = 0; t < n; t++) { // BEFORE: directive-in-range
#define WEIGHT 2
        h[s[t]] += WEIGHT;
    }
#else
    for (t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]] += WEIGHT;
#endif
}

static void opaque(int n) {
#ifdef BEFORE
    for (int t = 0; t < n; t++) // BEFORE: opaque
        h[s[t]] += ({ int k = s[t]; k; });
    for (int t = 0; t < n; t++) { // BEFORE: opaque
        double f[n > 3 ? 3 : n];
        f[0] = e[t];
        h[s[t]] += f[0];
    }
#else
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        int k = s[t];
        h[s[t]] += k;
    }
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        double f[3];
        f[0] = e[t];
        h[s[t]] += f[0];
    }
#endif
}

#ifndef BEFORE
struct pair { double a, b; };
#endif

static void type_of_the_function(int n) {
#ifdef BEFORE
    struct pair { double a, b; };
#endif
    static struct pair pairs[ROWS];
#ifdef BEFORE
    for (int t = 0; t < n; t++) // BEFORE: text
        pairs[s[t]].a += e[t];
#else
    for (int t = 0; t < n; t++) // EXPECT: transformed
        pairs[s[t]].a += e[t];
#endif
    h[3] += pairs[5].a;
}

static void type_without_a_name(int n) {
#ifdef BEFORE
    static struct { double a, b; } pairs[ROWS];
    for (int t = 0; t < n; t++) // BEFORE: text
        pairs[s[t]].a += e[t];
#else
    static struct pair pairs[ROWS];
    for (int t = 0; t < n; t++) // EXPECT: transformed
        pairs[s[t]].a += e[t];
#endif
    h[3] += pairs[5].a;
}

static void array_of_variable_length(int n, int m) {
#ifdef BEFORE
    double row[2][m];
    row[0][0] = row[1][0] = 2;
    for (int t = 0; t < n; t++) // BEFORE: text
        h[s[t]] += row[t & 1][0];
#else
    double row[2][ROWS];
    row[0][0] = row[1][0] = m ? 2 : 0;
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]] += row[t & 1][0];
#endif
}

#ifndef BEFORE
#define TWICE(v) ((v) * 2)
extern double factor;
#endif

static void define_in_the_function(int n) {
#ifdef BEFORE
#define TWICE(v) ((v) * 2)
    for (int t = 0; t < n; t++) // BEFORE: text
        h[s[t]] += TWICE(e[t]);
#else
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]] += TWICE(e[t]);
#endif
}

static void extern_in_the_body(int n) {
#ifdef BEFORE
    for (int t = 0; t < n; t++) { // BEFORE: text
        extern double factor;
        h[s[t]] += factor * e[t];
    }
#else
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]] += factor * e[t];
#endif
}
double factor = 1.5;

static void ignored(int n) {
#ifdef BEFORE
#pragma redcc ignore
    for (int t = 0; t < n; t++) // BEFORE: ignored
        h[s[t]]++;
#else
    int t;
    for (t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]]++;
#endif
}

static int look(int t) { return table[t]; }

static size_t binding(int n) {
#ifdef BEFORE
    size_t bytes = sizeof(enum { table = 3 }); /* from here on `table` means 3 */
    for (int t = 0; t < n; t++) // BEFORE: binding
        h[look(t)]++;
#else
    size_t bytes = sizeof(enum { other = 3 });
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[look(t)]++;
#endif
    return bytes;
}

int main(void) {
    case_subscripts(s, N, ROWS);
    case_subscripts(table, ROWS, ROWS);
    case_values(e, N);
    for (int round = 0; round < 3; round++) {
        in_macro(N);
        directive_in_range(N);
        opaque(N);
        type_of_the_function(N);
        type_without_a_name(N);
        array_of_variable_length(N, ROWS);
        define_in_the_function(N);
        extern_in_the_body(N);
        ignored(N);
        g[0] += (double)binding(ROWS);
    }
    CASE_PRINT(h);
    CASE_PRINT(g);
    return 0;
}
