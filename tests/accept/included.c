/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Loops in headers, whose text replaces their #include in the output: headers with guards, without
// guards, with #pragma once, with headers of their own, and an included source file.
// OPTIONS: --compiler=known
#include <stdio.h>
#include "case.h"
#include "included_guarded.h"
  #include "included_once.h"   
#include "included_source.h"

enum { N = 3000, ROWS = 90 };

static int s[N];
static double e[N], h[ROWS], g[ROWS], f[ROWS];

int main(void) {
    case_subscripts(s, N, ROWS);
    case_values(e, N);
    for (int round = 0; round < 6; round++) {
        const int n = round == 4 ? 1 : N;
        guarded(n, s, e, h);
        once(n, s, e, g);
        of_a_source(n, s, e, f);
        for (int t = 0; t < n; t++) // EXPECT: transformed
            f[s[t]] -= e[t] * 0.5;
    }
    CASE_PRINT(h);
    CASE_PRINT(g);
    CASE_PRINT(f);
    printf("%d %s\n", __LINE__, LEVEL);
    return 0;
}
