/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// The array named where its type or size counts, and where no expression of the tree shows it: in
// the length of another array, in a typeof, in a constant of the body.
// covers: row 47
#include "case.h"

enum { N = 6000, M = 300 };
#define LENGTH(array) (sizeof(array) / sizeof *(array))
#define ADD(k, e) a[k] += e

static int s[N];
static double w[N];
static double a[M], b[M], c[M], d[M], e[M], f[M];

__attribute__((noipa)) static void by_pointer(int n, double *to) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        __typeof__(to) from;
        from = &w[t];
        to[s[t]] += *from;
    }
}

int main(void) {
    case_subscripts(s, N, M);
    case_values(w, N);
    for (int t = 0; t < N; t++) { // EXPECT: transformed
        double like[sizeof a / sizeof *a];
        like[M - 1] = w[t];
        a[s[t]] += like[M - 1];
    }
    for (int t = 0; t < N; t++) { // EXPECT: transformed
        __typeof__(b) like;
        like[M - 1] = w[t];
        b[s[t]] += like[M - 1];
    }
    for (int t = 0; t < N; t++) { // EXPECT: transformed
        double like[LENGTH(c)];
        like[M - 1] = w[t];
        c[s[t]] += like[M - 1];
    }
    for (int t = 0; t < N; t++) { // EXPECT: transformed
        enum { SIZE = sizeof d };
        d[s[t]] += SIZE * w[t];
    }
    for (int t = 0; t < N; t++) // EXPECT: transformed
        switch (s[t]) {
        case LENGTH(e) - 20:
            e[s[t]] += 3.0;
            break;
        default:
            e[s[t]] -= w[t];
        }
    for (int t = 0; t < N; t++) { // EXPECT: transformed
        double like[LENGTH(a)];
        like[M - 1] = w[t];
        ADD(s[t], like[M - 1]);
    }
    by_pointer(N, f);
    CASE_PRINT(a);
    CASE_PRINT(b);
    CASE_PRINT(c);
    CASE_PRINT(d);
    CASE_PRINT(e);
    CASE_PRINT(f);
    return 0;
}
