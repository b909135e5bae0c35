/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// The loop names the updated array where only the array's type or size matters, outside the syntax tree's expressions:
// in another array's length, in a typeof, in a constant of the body, or in a macro that hides one of these.
// covers: row 47 of docs/constructs.md
#include "case.h"

enum { N = 6000, M = 300 };
#define LENGTH(array) (sizeof(array) / sizeof *(array))
#define ADD(k, e) a[k] += e
#define TYPE_OF __typeof__
#define LIKE_G __typeof__(g)
#define LENGTH_OF_H (sizeof h / sizeof *h)

static int s[N];
static double w[N];
static double a[M], b[M], c[M], d[M], e[M], f[M], g[M], h[M], i[M], j[M];

__attribute__((noipa)) static void by_pointer(int n, double *to) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        __typeof__(to) from;
        from = &w[t];
        to[s[t]] += *from;
    }
}

__attribute__((noipa)) static void by_hidden_pointer(int n, double *to) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        TYPE_OF(to) from;
        from = &w[t];
        to[s[t]] += *from;
    }
}

__attribute__((noipa)) static void by_automatic_type(int n, double *to) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        __auto_type at = to;
        at += s[t];
        to[s[t]] += (double)(at - to) + w[t];
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
    for (int t = 0; t < N; t++) { // EXPECT: transformed
        LIKE_G like;
        like[M - 1] = w[t];
        g[s[t]] += like[M - 1];
    }
    for (int t = 0; t < N; t++) { // EXPECT: transformed
        double like[LENGTH_OF_H];
        like[M - 1] = w[t];
        h[s[t]] += like[M - 1];
    }
    by_pointer(N, f);
    by_hidden_pointer(N, i);
    by_automatic_type(N, j);
    CASE_PRINT(a);
    CASE_PRINT(b);
    CASE_PRINT(c);
    CASE_PRINT(d);
    CASE_PRINT(e);
    CASE_PRINT(f);
    CASE_PRINT(g);
    CASE_PRINT(h);
    CASE_PRINT(i);
    CASE_PRINT(j);
    return 0;
}
