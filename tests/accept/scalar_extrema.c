/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Minima and maxima of scalars in addition to the array, with the iteration in which they occur: by each
// comparison and in each spelling, with equal values, zeros of either sign and NaNs.
// covers: row 88 of docs/constructs.md
#include <math.h>

#include "case.h"

enum { N = 4000, ROWS = 90 };
static int s[N];
static double e[N], h[ROWS], odd[N];
static long counted[ROWS];
static unsigned char bytes[N];
static double shown[20];
static int shown_at[16];

static double largest(int n, int *place) {
    double big = -1e300;
    int at = -1;
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        const double x = 2 * e[i];
        h[s[i]] += x;
        if (x > big) {
            big = x;
            at = i;
        }
    }
    *place = at;
    return big;
}

static double last_of_equal(int n, const double *x, double big, long *place) {
    long at = 7;
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        h[s[i]] += e[i];
        if (big <= x[i]) {
            at = i;
            big = x[i];
        }
    }
    *place = at;
    return big;
}

static double smallest(int n, const double *x, double low) {
    for (int i = n - 1; i >= 0; i -= 2) { // EXPECT: transformed
        h[s[i]] += e[i];
        low = x[i] < low ? x[i] : low;
    }
    return low;
}

static double smallest_negated(int n, const double *x, double low) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        h[s[i]] += e[i];
        low = low <= x[i] ? low : x[i];
    }
    return low;
}

static float narrow(int n) {
    float big = -2;
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        const float f = (float)e[i];
        h[s[i]] += e[i];
        if (f > big)
            big = f;
    }
    return big;
}

static int of_some(int n, int *at_most) {
    int most = -5, least = 90, where = -1;
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        if (e[i] < 0.125)
            continue;
        counted[s[i]] += 2;
        if (s[i] > most) {
            most = s[i];
            where = i;
        }
        if (s[i] % 3 == 0) {
            if (least > s[i])
                least = s[i];
        }
    }
    *at_most = most;
    return 1000 * least + where;
}

static double of_some_odd(int n, double big, int *at) {
    int i, where = -1;
    for (i = 0; i < n; i++) { // EXPECT: transformed
        h[s[i]] -= e[i];
        if (e[i] > 0)
            if (odd[i] > big) {
                big = odd[i];
                where = i;
            }
    }
    *at = where + i;
    return big;
}

static unsigned wrapped(int n) {
    unsigned char most = 3;
    unsigned count = 0, low = 4000000000u, at = 0;
    for (unsigned i = (unsigned)n; i-- > 0;) { // EXPECT: transformed
        const unsigned v = 4000000000u - (unsigned)s[i];
        h[s[i]] += 1.0;
        count += 3;
        if (bytes[i] > most)
            most = bytes[i];
        if (v < low) {
            low = v;
            at = i;
        }
    }
    return most + count + 3 * low + 5 * at;
}

static double twice(int n) {
    double big = -9, low = 9;
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        h[s[i]] += e[i];
        if (e[i] > big)
            big = e[i];
        if (odd[i] > big)
            big = odd[i];
        low = low < e[i] ? low : e[i];
        low += 0.25;
    }
    return big + low;
}

/* Under a condition, by each comparison, and with other updates of one scalar. */
static double sometimes(int n, double big, double low) {
    double both = 3;
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        h[s[i]] += e[i];
        if (s[i] > 3) {
            if (odd[i] >= big)
                big = odd[i];
            low = low < odd[i] ? low : odd[i];
            if (e[i] > both)
                both = e[i];
        }
        if (s[i] > 30)
            both -= 0.5;
        if (s[i] % 3 == 1)
            both = both <= odd[i] ? both : odd[i];
    }
    return big + 2 * low + 4 * both;
}

int main(void) {
    unsigned sum = 0;
    long at = 0;
    for (int round = 0; round < 4; round++) {
        case_values(e, N);
        case_subscripts(s, N, ROWS);
        for (int i = 0; i < N; i++) {
            odd[i] = i % 7 == 3 ? NAN : i % 5 == 0 ? -0.0 : i % 3 == 0 ? 0.0 : (double)(s[i] / 9);
            bytes[i] = (unsigned char)(s[i] * 2 + 60);
        }
        const int n = round == 3 ? 0 : N - round;
        int k = 0;
        shown[0] = largest(n, &shown_at[0]);
        shown[1] = last_of_equal(n, odd, -3, &at);
        shown[2] = last_of_equal(n, e, NAN, &at);
        sum += (unsigned)at;
        shown[3] = smallest(n, odd, 0.0);
        shown[4] = smallest(n, odd, NAN);
        shown[5] = smallest_negated(n, odd, -0.0);
        shown[6] = smallest_negated(n, e, NAN);
        shown[7] = (double)narrow(n);
        shown_at[1] = of_some(n, &shown_at[2]);
        shown[8] = of_some_odd(n, -2, &shown_at[3]);
        shown[9] = of_some_odd(n, NAN, &shown_at[4]);
        shown[10] = of_some_odd(n, 100, &shown_at[5]);
        shown[11] = of_some_odd(n, 0.0, &k);
        sum += wrapped(n) + (unsigned)k;
        shown[12] = twice(n);
        shown[13] = sometimes(n, -1, 1);
        shown[14] = sometimes(n, -0.0, 0.0);
        shown[15] = sometimes(n, NAN, 9);
        shown[16] = sometimes(n, 0.0, -0.0);
        CASE_PRINT(shown);
        CASE_PRINT(shown_at);
    }
    printf("%u\n", sum);
    CASE_PRINT(h);
    CASE_PRINT(counted);
    return 0;
}
