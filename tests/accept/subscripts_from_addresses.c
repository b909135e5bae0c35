/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// A subscript depends on the array's address: a plan made for another address must not be reused.
// INTEGERS: no
// covers: row 71 of docs/constructs.md
#include "case.h"

enum { N = 3000, M = 600 };
static double room[4 * M], e[N];
static int s[N], other[N];

static void difference(int n, double *a, const double *q) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        a[s[t] + (q - a)] += e[t];
        a[other[t] + (q - a)] -= e[t];
    }
}

static long apart(const double *a, const double *b) {
    return b - a;
}

static void by_function(int n, double *a, const double *q) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const long from = apart(a, q);
        a[s[t] + from] += e[t];
        a[other[t] + from] -= e[t];
    }
}

int main(void) {
    case_values(e, N);
    case_subscripts(s, N, M);
    case_subscripts(other, N, M);
    for (int round = 0; round < 6; round++) {
        difference(N, room + round / 2 * 400, room + 2 * M);
        by_function(N, room + round / 2 * 400, room + 2 * M);
    }
    CASE_PRINT(room);
    return 0;
}
