/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Loops whose bodies begin with the step, for loops whose step is a statement of the body, and bare
// counters as conditions: the iterations, and the counter's value afterwards, also without
// iterations and after an early end.
// covers: rows 7, 86 and 91 of docs/constructs.md
// THREADS: 1 2 3 7 16 33
#include <stdint.h>

#include "case.h"

enum { N = 4000, ROWS = 90 };
static int s[N + 9];
static double e[N + 9], h[ROWS];
static long counted[ROWS];

static int down(int k) {
    while (k > 0) { // EXPECT: transformed
        --k;
        h[s[k]] += e[k];
    }
    return k;
}

static size_t down_unsigned(size_t k) {
    while (k > 0) { // EXPECT: transformed
        k--;
        h[s[k]] -= e[k];
    }
    return k;
}

static unsigned down_while_any(unsigned k) {
    while (k) { // EXPECT: transformed
        k -= 1;
        counted[s[k]] += (long)k;
    }
    return k;
}

static unsigned down_while_unequal(unsigned k) {
    while (k != 0) { // EXPECT: transformed
        k = k - 1;
        h[s[k]] += 2 * e[k];
    }
    return k;
}

static int down_last(int k) {
    while (k) { // EXPECT: transformed
        h[s[k]] += e[k];
        k--;
    }
    return k;
}

static size_t down_last_unsigned(size_t k) {
    for (; k; k--) // EXPECT: transformed
        h[s[k]] += 3 * e[k];
    return k;
}

static long to_a_bound(long k, int low) {
    while (low < k) { // EXPECT: transformed
        --k;
        h[s[k]] += e[k];
    }
    return k;
}

static unsigned unsigned_to_a_bound(unsigned k, unsigned low) {
    while (k > low) { // EXPECT: transformed
        --k;
        h[s[k]] -= e[k];
    }
    return k;
}

static int at_least_one(int k) {
    while (k >= 1) { // EXPECT: transformed
        --k;
        h[s[k]] += e[k];
    }
    return k;
}

static int up(int n) {
    int i = 0;
    while (i < n) { // EXPECT: transformed
        ++i;
        h[s[i - 1]] += e[i];
    }
    return i;
}

static int up_from_below(int n) {
    int i = -n;
    while (i) { // EXPECT: transformed
        i++;
        h[s[-i]] += e[-i];
    }
    return i;
}

static int by_fours(int k) {
    while (k >= 4) { // EXPECT: transformed
        k -= 4;
        h[s[k]] += e[k] * e[k + 3];
    }
    return k;
}

static int by_a_stride(int k, int by) {
    while (k >= by) { // EXPECT: transformed
        k -= by;
        h[s[k]] += e[k];
    }
    return k;
}

static int headers_without_a_step(int n) {
    int i, k;
    for (k = n; k > 0;) { // EXPECT: transformed
        --k;
        h[s[k]] += e[k];
    }
    for (i = 0; i < n;) { // EXPECT: transformed
        h[s[i]] -= e[i];
        i++;
    }
    for (int j = n; j > 1;) { // EXPECT: transformed
        j--;
        h[s[j]] += e[j];
    }
    return 3 * i + k;
}

static int skips(int k) {
    while (k > 0) { // EXPECT: transformed
        --k;
        if (s[k] % 3 == 0)
            continue;
        h[s[k]] += e[k];
    }
    return k;
}

static long declares(int k) {
    long sum = 0;
    while (k > 0) { // EXPECT: transformed
        double w = 0.5;
        const double *at;
        int row;
        k--;
        row = s[k];
        at = &e[k];
        h[row] += w * *at;
        sum += row * k;
    }
    return sum + k;
}

static int once_or_more(int k) {
    do { // EXPECT: transformed
        --k;
        h[s[k]] += e[k];
    } while (k > 0);
    return k;
}

static unsigned once_or_more_unsigned(unsigned k) {
    do { // EXPECT: transformed
        --k;
        h[s[k]] += e[k];
    } while (k);
    return k;
}

static long back_through(const int *end, const int *begin) {
    const int *p = end;
    while (p > begin) { // EXPECT: transformed
        --p;
        counted[*p] += 3;
    }
    return p - begin;
}

static int until_negative(int k) {
    while (k > 0) { // EXPECT: transformed
        --k;
        if (s[k] < 0)
            break;
        h[s[k]] += e[k];
    }
    return k;
}

static int induction(int k) {
    int q = 3, last = 0;
    while (k > 0) { // EXPECT: transformed
        --k;
        h[s[k]] += e[q];
        q++;
        last = k;
    }
    return q + k + 5 * last;
}

static int reaches_its_row(int k) {
    static int made[N + 9];
    while (k > 0) { // EXPECT: transformed
        --k;
        made[k] = s[k] / 2;
        h[made[k]] += e[k];
    }
    return made[0] + k;
}

static int minimum(int k) {
    double best = 9;
    int at = -1;
    while (k > 0) { // EXPECT: transformed
        --k;
        h[s[k]] += e[k];
        if (e[k] < best) {
            best = e[k];
            at = k;
        }
    }
    return at + k;
}

static int triangle(int n) {
    int q = 0, i;
    for (i = 0; i < n;) { // EXPECT: transformed
        i++;
        for (int j = i; j < n; j++) {
            h[s[q % N]] += e[j];
            q++;
        }
    }
    return q + i;
}

static int ends_by_return(int k) {
    do { // EXPECT: transformed
        k--;
        if (s[k] < 0)
            return k;
        h[s[k]] += e[k];
    } while (k > 0);
    return -1;
}

static int drains(double *restrict t, int k) {
    while (k > 0) { // EXPECT: transformed
        --k;
        h[s[k]] += t[k];
        t[k] = 0;
    }
    return k;
}

static int rows_inside(int n) {
    int made = 0;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        int k = t % 5;
        while (k > 0) {
            --k;
            h[s[t + k]] += e[k];
        }
        made += k;
    }
    return made;
}

static int rows_to_bounds(const int *begin, int n) {
    int left = 0;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        int j = begin[t] + 3;
        while (j > begin[t]) {
            --j;
            h[s[j]] += e[t];
        }
        for (j = begin[t]; j < begin[t] + 2;) {
            h[s[j]] -= e[t];
            j++;
        }
        left += j - begin[t];
    }
    return left;
}

int main(void) {
    static int begin[N];
    static double t[N];
    unsigned long sum = 0;
    case_values(e, N + 9);
    for (int t = 0; t < N; t++)
        begin[t] = N - t;
    for (int round = 0; round < 4; round++) {
        if (round != 2)
            case_subscripts(s, N + 9, ROWS);
        for (int n = round < 2 ? N : 2; n >= 0; n = n > 1 ? 1 : n - 1) {
            sum = 3 * sum + (unsigned long)((long)down(n) + (long)down_unsigned((size_t)n));
            sum = 3 * sum + (unsigned long)(down_while_any((unsigned)n) + down_last(n));
            sum = 3 * sum + (unsigned long)(down_while_unequal((unsigned)n) + 1u);
            sum = 3 * sum + (unsigned long)((long)down_last_unsigned((size_t)n) + up(n));
            sum = 3 * sum + (unsigned long)(up_from_below(n) + at_least_one(n) + by_fours(n + 3));
            sum = 3 * sum + (unsigned long)(by_a_stride(n, 3) + headers_without_a_step(n));
            sum = 3 * sum + (unsigned long)(skips(n) + declares(n) + induction(n));
            sum = 3 * sum + (unsigned long)(back_through(s + n, s) + reaches_its_row(n));
            sum = 3 * sum + (unsigned long)(rows_inside(n) + rows_to_bounds(begin, n));
            sum = 3 * sum + (unsigned long)(to_a_bound(n, -0) + to_a_bound(n, 1));
            sum = 3 * sum + unsigned_to_a_bound((unsigned)n, 0);
            sum = 3 * sum + unsigned_to_a_bound((unsigned)n, 5);
            sum = 3 * sum + (unsigned long)(until_negative(n) + minimum(n) + triangle(n / 3));
            for (int i = 0; i < N; i++)
                t[i] = 1 + e[i];
            sum = 3 * sum + (unsigned long)drains(t, n);
            CASE_PRINT(t);
            if (n > 0)
                sum = 3 * sum + (unsigned long)once_or_more(n) + once_or_more_unsigned((unsigned)n);
        }
        sum = 3 * sum + (unsigned long)(down(-7) + at_least_one(-7) + by_fours(-7));
        const int row = s[N / 3];
        s[N / 3] = -1;
        sum = 3 * sum + (unsigned long)(until_negative(N) + ends_by_return(N));
        s[N / 3] = row;
        sum = 3 * sum + (unsigned long)ends_by_return(N);
    }
    printf("%lu\n", sum);
    CASE_PRINT(h);
    CASE_PRINT(counted);
    return 0;
}
