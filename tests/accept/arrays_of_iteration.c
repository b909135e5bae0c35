/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Arrays and structures that are private to an iteration, and their values after the loop.
// covers: row 58, row 59 of docs/constructs.md
#include "case.h"
#include <string.h>

enum { N = 8000, M = 500 };

struct result {
    double value[2];
};

static int s[N][2];
static double w[N], h[M], last[8];

static void with_last_values(int n) {
    double f[4];
    struct result r = {{0.0, 0.0}};
    int c = -1, at = -1;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        for (c = 0; c < 4; c++)
            f[c] = w[t] * c;
        at = s[t][0];
        r.value[0] = f[1] + f[3];
        r.value[1] = f[2];
        h[at] += r.value[0];
        h[s[t][1]] -= r.value[1];
    }
    if (n > 0)
        last[0] = f[0] + f[1] + f[2] + f[3];
    last[1] = at;
    last[2] = r.value[0] + r.value[1];
    last[3] = c;
}

static void cleared(int n) {
    double f[3][3], g[9];
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        memset(f, 0, sizeof f);
        f[s[t][0] % 3][s[t][1] % 3] = w[t];
        memcpy(g, f, sizeof g);
        for (int c = 0; c < 9; c++)
            if (g[c] != 0.0)
                h[s[t][0]] += g[c] * (c + 1);
    }
}

static void by_pointer(int n) {
    double f[2][3];
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        for (int a = 0; a < 2; a++) {
            double *row = f[a];
            for (int c = 0; c < 3; c++)
                row[c] = w[t] + a * c;
        }
        h[s[t][0]] += f[0][2] + f[1][1];
    }
}

/* Either of the two loops may be transformed; the inner loop is executed many times. */
static void variable_length(int n, int m) {
    for (int t = 0; t < n; t++) {
        double f[m];
        for (int c = 0; c < m; c++)
            f[c] = w[t] * c;
        for (int c = m - 1; c >= 0; c--)
            h[(s[t][0] + c) % M] += f[c];
    }
}

int main(void) {
    case_values(w, N);
    for (int round = 0; round < 3; round++) {
        case_subscripts(&s[0][0], 2 * N, M);
        with_last_values(N - round);
        cleared(N);
        by_pointer(N);
        variable_length(N / 32, 3 + round);
        CASE_PRINT(last);
        CASE_PRINT(h);
    }
    with_last_values(0);
    CASE_PRINT(last);
    return 0;
}
