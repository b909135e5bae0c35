#pragma once
#include "included_deeper.h"
#define LEVEL "one"
static void once(int n, const int *s, const double *e, double *g) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        g[s[t]] += weight(e[t]);
}
