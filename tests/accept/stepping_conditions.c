/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Loops whose condition steps the counter, before or after the comparison: their iterations, and
// the counter's value afterwards, also without iterations.
// covers: row 86 of docs/constructs.md
#include <limits.h>

#include "case.h"

enum { N = 4000, ROWS = 90 };
static int s[N + 9];
static double e[N + 9], h[ROWS];
static long counted[ROWS];

static int down_before(int n) {
    int i;
    for (i = n; --i >= 0;) // EXPECT: transformed
        h[s[i]] += e[i];
    return i;
}

static int down_after(int n) {
    int i;
    for (i = n; i-- > 0;) // EXPECT: transformed
        h[s[i]] -= e[i];
    return i;
}

static size_t down_unsigned(size_t n) {
    size_t i;
    for (i = n; i-- > 0;) // EXPECT: transformed
        h[s[i]] += 2 * e[i];
    return i;
}

static unsigned down_narrow(unsigned n) {
    while (n-- != 0) // EXPECT: transformed
        counted[s[n]] += n;
    return n;
}

static int while_there_are(int n) {
    while (n--) // EXPECT: transformed
        h[s[n]] += e[n];
    return n;
}

static int but_for_the_last(int n) {
    while (--n) // EXPECT: transformed
        h[s[n]] += e[n];
    return n;
}

static long to_a_bound(long n, int low) {
    while (0 + low < --n) // EXPECT: transformed
        h[s[n]] += e[n];
    while (n++ < low + N / 2) // EXPECT: transformed
        h[s[n]] -= e[n];
    while (++n < N) // EXPECT: transformed
        h[s[n]] += 3 * e[n];
    return n;
}

static int up_to_zero(int n) {
    int i = -n;
    while (i++) // EXPECT: transformed
        h[s[-i]] += e[-i];
    return i;
}

static int skips(int n) {
    int i = n;
    while (i-- > 0) { // EXPECT: transformed
        if (s[i] % 3 == 0)
            continue;
        h[s[i]] += e[i];
    }
    return i;
}

static int counts_beside(int n) {
    int i, k;
    for (i = n, k = 5; i--; k++) // EXPECT: transformed
        h[s[i]] += e[k];
    return 3 * i + k;
}

static long declared(int n) {
    long sum = 0;
    for (int i = n; i-- > 1;) { // EXPECT: transformed
        h[s[i]] += e[i];
        sum += s[i] * i;
    }
    return sum;
}

static int downwards_twice(int n, int m) {
    int j = 0;
    for (int i = n; i-- > 0;)
        for (j = m; j-- > 0;) // EXPECT: transformed
            h[s[j]] += e[j];
    return j;
}

int main(void) {
    unsigned long sum = 0;
    case_values(e, N + 9);
    for (int round = 0; round < 4; round++) {
        if (round != 2)
            case_subscripts(s, N + 9, ROWS);
        for (int n = round < 2 ? N : 2; n >= 0; n = n > 1 ? 1 : n - 1) {
            sum = 3 * sum + (unsigned long)(down_before(n) + down_after(n));
            sum = 3 * sum + (unsigned long)((long)down_unsigned((size_t)n) + down_narrow((unsigned)n));
            sum = 3 * sum + (unsigned long)(while_there_are(n) + skips(n) + up_to_zero(n));
            sum = 3 * sum + (unsigned long)(to_a_bound(n, -1) + counts_beside(n));
            sum = 3 * sum + (unsigned long)(declared(n) + downwards_twice(2, n));
        }
        sum = 3 * sum + (unsigned long)(but_for_the_last(N) + down_after(-7) + down_before(-7));
        sum = 3 * sum + (unsigned long)(to_a_bound(N, 17) + to_a_bound(5, 17));
    }
    printf("%lu\n", sum);
    CASE_PRINT(h);
    CASE_PRINT(counted);
    return 0;
}
