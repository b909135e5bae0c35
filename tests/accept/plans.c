/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// A plan must not be reused after the subscripts have changed: the same pointers with other
// contents, other bounds, other memory, a change in the middle, or a change back.
// covers: row 71, row 53 of docs/constructs.md
// THREADS: 1 2 3 7 16 33
#include "case.h"
#include <string.h>

enum { N = 20000, M = 3000 };
static double h[M], w[N];

static void scatter(double *to, const int *s, const double *v, int first, int last) {
    for (int t = first; t < last; t++) // EXPECT: transformed
        to[s[t]] += v[t];
}

static void scatter_through(double *to, const int *s, const int *map, const double *v, int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        to[map[s[t]]] -= v[t];
}

static void scatter_shifted(double *to, const int *s, const double *v, int shift, int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        to[(s[t] + shift) % M] += v[t];
}

static void show(void) {
    CASE_PRINT(h);
}

int main(void) {
    static int map[M];
    int *s = malloc(N * sizeof *s);
    case_values(w, N);
    case_subscripts(s, N, M);
    case_subscripts(map, M, M);
    for (int round = 0; round < 4; round++) {
        scatter(h, s, w, 0, N);
        show();
    }
    for (int k = 0; k < 6; k++) { /* changes one subscript at a time: first, last, middle */
        const int at = k % 3 == 0 ? 0 : k % 3 == 1 ? N - 1 : N / 2 + k;
        const int old = s[at];
        s[at] = (s[at] + 1 + case_below(M - 1)) % M;
        scatter(h, s, w, 0, N);
        show();
        if (k > 2)
            s[at] = old;
        scatter(h, s, w, 0, N);
        show();
    }
    for (int k = 0; k < 4; k++) {
        scatter(h, s, w, k * 10, N - k * 100);
        show();
    }
    for (int k = 0; k < 3; k++) { /* frees the array and may get the same address again */
        free(s);
        s = malloc(N * sizeof *s);
        case_subscripts(s, N, M);
        scatter(h, s, w, 0, N);
        show();
    }
    for (int k = 0; k < 6; k++) {
        if (k % 2 == 1)
            map[case_below(M)] = case_below(M);
        scatter_through(h, s, map, w, N);
        show();
        scatter_shifted(h, s, w, k / 2 * 17, N);
        show();
    }
    free(s);
    return 0;
}
