/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Updates under conditions, in branches, and in inner loops that may have no iteration.
// covers: row 35, row 5, row 7 of docs/constructs.md
#include "case.h"

enum { N = 12000, M = 700 };
static int s[N], kind[N];
static double w[N], h[M], g[M];
static int tally[M];

static void guarded_updates(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        if (w[t] > 0.25)
            h[s[t]] += w[t];
        else if (kind[t] == 1) {
            g[s[t]] -= w[t];
            tally[s[t]]++;
        }
        if (kind[t] != 0 && s[t] % 2 == 0)
            h[(s[t] + 1) % M] += 0.5;
    }
}

static void in_cases(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        switch (kind[t]) {
        case 0:
            h[s[t]] += 1.0;
            break;
        case 1:
            g[s[t]] += w[t];
            /* fall through */
        default:
            tally[s[t]] += kind[t];
        }
    }
}

static void inner_rounds(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        if (kind[t] == 2)
            continue;
        for (int c = 0; c < kind[t]; c++) {
            if ((s[t] + c) % 5 == 0)
                continue;
            if ((s[t] + c) % 7 == 0)
                break;
            h[(s[t] + c) % M] += w[t] * c + 0.125;
        }
    }
}

static void clamped(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int i = s[t] > M / 2 ? M / 2 : s[t];
        const double v = w[t] < 0.0 ? -w[t] : w[t];
        h[i] += v > 0.5 ? 0.5 : v;
    }
}

int main(void) {
    case_values(w, N);
    for (int round = 0; round < 3; round++) {
        case_subscripts(s, N, M);
        case_subscripts(kind, N, 4);
        guarded_updates(N);
        in_cases(N);
        inner_rounds(N);
        clamped(N);
        CASE_PRINT(h);
        CASE_PRINT(g);
        CASE_PRINT(tally);
    }
    return 0;
}
