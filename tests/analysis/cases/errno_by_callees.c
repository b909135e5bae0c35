/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Functions that set errno, called by other functions. */
#include <math.h>

static double root(double x) {
    return sqrt(x);
}

static double sum_of_roots(double x, double y) {
    return root(x) + root(y);
}

void by_a_function(int n, const int *s, const double *w, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) sets-errno
        h[s[i]] += sum_of_roots(w[i], 2);
}
