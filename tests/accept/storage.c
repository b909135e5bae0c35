/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Globals, statics, locals, heap memory, flexible array members, typedefs, const and register.
// covers: row 50, row 46, row 63 of docs/constructs.md
#include "case.h"

enum { N = 12000, M = 700 };
typedef double table[M];
typedef int subscript;

struct bag {
    long size;
    double values[];
};

double global_table[M];
extern double later_table[];
static table static_table;
static subscript s[N];
static double w[N];

static void globals(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        global_table[s[t]] += w[t];
        later_table[s[t]] -= w[t];
        static_table[s[t]] += 0.5 * w[t];
    }
}

static void flexible(struct bag *b, int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        b->values[s[t]] += w[t];
}

static double locals(int n) {
    double h[M] = {0}, sum = 0.0;
    static double kept[M];
    register int t;
    for (t = 0; t < n; t++) { // EXPECT: transformed
        h[s[t]] += w[t];
        kept[s[t]] += 2.0 * w[t];
    }
    for (t = 0; t < M; t++)
        sum = sum * 0.5 + h[t] + kept[t];
    return sum;
}

static void parameter(double h[static M], const subscript *const k, const int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[k[t]] += w[t];
}

/* A function definition in the old style. */
static void old_style(h, k, n)
double *h;
int *k, n;
{
    int t;
    for (t = 0; t < n; t++) // EXPECT: transformed
        h[k[t]] += 1.0;
}

double later_table[M];

int main(void) {
    struct bag *b = calloc(1, sizeof *b + M * sizeof(double));
    double *h = calloc(M, sizeof *h);
    case_values(w, N);
    for (int round = 0; round < 3; round++) {
        case_subscripts(s, N, M);
        globals(N);
        flexible(b, N);
        double sum = locals(N);
        parameter(h, s, N);
        old_style(h, s, N);
        CASE_PRINT(global_table);
        case_print("later_table", later_table, M * sizeof(double));
        CASE_PRINT(static_table);
        case_print("values", b->values, M * sizeof(double));
        case_print("h", h, M * sizeof(double));
        case_print("sum", &sum, sizeof sum);
    }
    free(b);
    free(h);
    return 0;
}
