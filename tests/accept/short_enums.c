/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// With -fshort-enums the program's enumerations have one byte, but the runtime's structures must not change.
// CFLAGS: -fshort-enums
#include "case.h"

enum { N = 9000 };

static double h[300];
static int count[300];

static void kernel(int n, const int *s, const double *e) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        h[s[t]] += e[t];
        count[s[t]]++;
    }
}

int main(void) {
    static int s[N];
    static double e[N];
    for (int t = 0; t < N; t++) {
        s[t] = t * 37 % 300;
        e[t] = case_value();
    }
    kernel(N, s, e);
    case_print("h", h, sizeof h);
    case_print("count", count, sizeof count);
    return 0;
}
