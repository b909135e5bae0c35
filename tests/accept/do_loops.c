/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Loops that test the condition after each iteration: their trip count, also where the first value
// does not satisfy the condition, and the counter's value after the loop.
// covers: row 91 of docs/constructs.md
#include <limits.h>

#include "case.h"

enum { N = 4000, ROWS = 90 };
static int s[N + 9];
static double e[N + 9], h[ROWS];
static long counted[ROWS];
#define ZERO 0

static int down_to_one(int n) {
    do { // EXPECT: transformed
        h[s[n]] += e[n];
    } while (--n);
    return n;
}

static unsigned down_to_one_unsigned(unsigned n) {
    do // EXPECT: transformed
        counted[s[n]] += n;
    while (--n != 0);
    return n;
}

static size_t down_above(size_t n, size_t low) {
    do { // EXPECT: transformed
        if (s[n] % 3 == 0)
            continue;
        h[s[n]] -= e[n];
    } while (--n > low);
    return n;
}

static int down_to_zero(int n) {
    do { // EXPECT: transformed
        h[s[n]] += 2 * e[n];
    } while (--n >= ZERO);
    return n;
}

static int asked_before_the_step(int n) {
    do { // EXPECT: transformed
        h[s[n]] += e[n];
    } while (n--);
    return n;
}

static unsigned long asked_before_the_step_unsigned(unsigned long n) {
    do { // EXPECT: transformed
        counted[s[n]] ^= (long)n;
    } while (n-- > 0);
    return n;
}

static int steps_in_the_body(int n) {
    int i = 0;
    do { // EXPECT: transformed
        h[s[i]] += e[i];
        i += 2;
    } while (i < n);
    return i;
}

static size_t until_equal(size_t i, size_t n) {
    do { // EXPECT: transformed
        h[s[i]] += e[i];
        ++i;
    } while (i != n);
    return i;
}

static long by_branches(int n) {
    long sum = 0;
    if (n > 1)
        do { // EXPECT: transformed
            counted[s[n]] += n;
#ifdef BACKWARDS
            sum -= e[n] > 0;
#else
            sum += e[n] > 0;
#endif
        } while (n-- > ZERO);
    return sum + n;
}

static int up_behind(int n) {
    int i = -1;
    if (n > INT_MIN)
        do { // EXPECT: transformed
            counted[s[i + 1]] += i;
        } while (i++ < n);
    else
        i = 7;
    return i;
}

struct sizes {
    int pad, n;
};

static int bound_in_memory(const struct sizes *g) {
    int i = 0;
    do { // EXPECT: transformed
        h[s[i]] += e[i];
    } while (++i < g->n);
    return i;
}

static long pointers(const int *p, const int *end, const double *w) {
    const int *first = p;
    do { // EXPECT: transformed
        h[*p] += *w++;
    } while (++p < end);
    p = first;
    do // EXPECT: transformed
        counted[*p++]++;
    while (p != end);
    return (p - first) + (long)w[0];
}

static long counts_beside(int n) {
    long sum = 0;
    int k = 3;
    do { // EXPECT: transformed
        h[s[k]] += e[n];
        sum += s[n] * k;
        k += 1;
    } while (--n > 0);
    return sum + k;
}

static int several(int times, int n) {
    int i = 0;
    do {
        i = n;
        do { // EXPECT: transformed
            h[s[i]] += e[i];
        } while (--i > 0);
    } while (--times > 0);
    return i + times;
}

int main(void) {
    static const int counts[] = {N, N - 1, 2, 1};
    unsigned long sum = 0;
    case_values(e, N + 9);
    for (int round = 0; round < 3; round++) {
        if (round != 1)
            case_subscripts(s, N + 9, ROWS);
        for (unsigned c = 0; c < sizeof counts / sizeof *counts; c++) {
            const int n = counts[c];
            const struct sizes sizes = {0, n};
            sum = 3 * sum + (unsigned long)(down_to_one(n) + asked_before_the_step(n));
            sum = 3 * sum + down_to_one_unsigned((unsigned)n) + down_above((size_t)n, 0);
            sum = 3 * sum + down_above((size_t)n, 17) + asked_before_the_step_unsigned((unsigned)n);
            sum = 3 * sum + (unsigned long)(down_to_zero(n) + steps_in_the_body(n));
            sum = 3 * sum + until_equal(0, (size_t)n) + (unsigned long)bound_in_memory(&sizes);
            sum = 3 * sum + (unsigned long)(up_behind(n - 2) + pointers(s, s + n, e));
            sum = 3 * sum + (unsigned long)(counts_beside(n) + several(2, n) + by_branches(n));
        }
        /* One iteration, whatever the bound is. */
        const struct sizes none = {0, -5};
        sum = 3 * sum + (unsigned long)(down_to_zero(0) + asked_before_the_step(0));
        sum = 3 * sum + asked_before_the_step_unsigned(0) + down_above(5, 9);
        sum = 3 * sum + (unsigned long)(steps_in_the_body(-9) + bound_in_memory(&none));
        sum = 3 * sum + (unsigned long)(up_behind(-9) + counts_beside(0) + several(0, 0));
        sum = 3 * sum + (unsigned long)(pointers(s, s + 1, e) + (long)until_equal(7, 8));
    }
    printf("%lu\n", sum);
    CASE_PRINT(h);
    CASE_PRINT(counted);
    return 0;
}
