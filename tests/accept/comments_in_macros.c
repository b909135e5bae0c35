/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// A macro that contains comments, some as lines of their own. The end mark of a comment may stand
// directly before the backslash that ends a line. Generated text must not split this mark.
#include "case.h"

enum { N = 6000, M = 400 };
static int s[N];
static double e[N], h[M];

/* clang-format off */
#define ADDS(name, type)\
/**************************************/\
/*! Adds values at subscripts, "all",  \
    or none; it's here once a type. */\
/**************************************/\
static void name(int n, const int *restrict at, const type *restrict value, type *restrict sum) {\
    /* here */\
    for (int t = 0; t < n; t++)\
        sum[at[t]] += value[t];\
}\
/**/\
//
/* clang-format on */

ADDS(add, double)

static void count(int n, int *restrict counts) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        counts[s[t]]++;
}

int main(void) {
    int counts[M] = {0};
    case_values(e, N);
    for (int round = 0; round < 3; round++) {
        case_subscripts(s, N, M);
        add(N, s, e, h);
        count(N, counts);
    }
    CASE_PRINT(h);
    CASE_PRINT(counts);
    return 0;
}
