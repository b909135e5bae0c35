/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Induction variables that advance through copies in other variables: walks over several rows or
// columns at once, as in dense and sparse factorisations.
// covers: row 79 of docs/constructs.md
#include "case.h"

enum { ROWS = 600, WIDE = 7, ALL = 3 * ROWS * WIDE };
static int s[ALL];
static double e[ALL], x[WIDE], h[90];
static long counted[90];
static struct pair { double a, b; } pairs[ALL];

static long three_rows(const double *entries, int n, int m) {
    const double *r0 = entries, *r1, *r2;
    for (int i = 0; i < n - 2; i += 3) { // EXPECT: transformed
        double s0 = 0, s1 = 0, s2 = 0;
        r1 = r0 + m;
        r2 = r1 + m;
        for (int k = 0; k < m; k++) {
            s0 += r0[k] * x[k];
            s1 += r1[k] * x[k];
            s2 += r2[k] * x[k];
        }
        h[s[i]] -= s0;
        h[s[i + 1]] -= s1;
        h[s[i + 2]] -= s2;
        r0 = r2 + m;
    }
    return r0 - entries;
}

/* The step's address is taken, but no update can write an int. The pointers are set in two loops. */
static void set_length(int *m, int by) {
    *m = by;
}

static long two_walks(const double *entries, int n, int by) {
    const double *r0 = entries, *r1, *r2;
    int m, i;
    set_length(&m, by);
    for (i = 0; i < n - 2; i += 3) { // EXPECT: transformed
        r1 = r0 + m;
        r2 = r1 + m;
        for (int k = 0; k < m; k++)
            h[s[i]] -= r0[k] * r1[k] + r2[k];
        r0 = r2 + m;
    }
    for (; i < n; i += 2) { // EXPECT: transformed
        r1 = &r0[m];
        for (int k = 0; k < m; k++)
            h[s[i]] -= r0[k] - r1[k];
        r0 = m + r1;
    }
    return r0 - entries;
}

static long in_header(const double *entries, int n, unsigned m) {
    const double *p, *q;
    int i;
    for (i = 0, p = entries; i < n; i++, p = q + m) { // EXPECT: transformed
        q = &p[m];
        h[s[i]] += p[1] - q[0];
    }
    return p - entries;
}

static int declared(int n, int k, const int by) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        const int second = k + by, third = by + second + 1;
        h[s[k]] += e[second];
        h[s[second]] -= e[third];
        k = third - 1;
    }
    return k;
}

static int plain_copy(int n, int k) {
    int next = 0;
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        next = k;
        next += 2;
        next++;
        h[s[k]] += e[next];
        k = next;
    }
    return 3 * k + next;
}

static int by_two(int n, int k, int a, int b) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        h[s[i]] += e[k];
        k += a;
        k += b;
        k += a;
    }
    return k;
}

static int down_and_up(int n, int k, int a, long b) {
    int at;
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        at = k - a, at = at + 3;
        h[s[k]] += e[at];
        k = (int)(at + b - a);
    }
    return k;
}

static unsigned wrapping(int n, unsigned k, unsigned by) {
    unsigned char c = 250, d;
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        const unsigned other = k - by;
        counted[s[i]] += other % 7 + c;
        k = other - 3;
        d = (unsigned char)(c + by);
        c = d;
    }
    return k + c;
}

static long of_records(int n, int m) {
    struct pair *p = pairs, *q;
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        q = p + 1;
        h[s[i]] += p->a * q->b;
        p = q + m;
    }
    return p - pairs;
}

static long by_while(const double *p, int n, int m) {
    const double *const first = p;
    int i = 0;
    while (i < n) { // EXPECT: transformed
        const double *q = p + m;
        h[s[i]] += *p - *q;
        p = m + q;
        i++;
    }
    return p - first;
}

/* Each column begins at the end of the one before; the loop is entered several times. */
static long columns(const double *p, int n, int m) {
    const double *const first = p;
    for (int c = 0; c < 3; c++)
        for (int i = 0; i < n; i++) { // EXPECT: transformed
            const double *q = p + m;
            h[s[i]] += *p - *q;
            p = q;
        }
    return p - first;
}

int main(void) {
    long sum = 0;
    case_values(e, ALL);
    case_values(x, WIDE);
    for (int i = 0; i < ALL; i++)
        pairs[i] = (struct pair){e[i], e[ALL - 1 - i]};
    for (int round = 0; round < 4; round++) {
        if (round != 2)
            case_subscripts(s, ALL, 90);
        sum = 3 * sum + three_rows(e, 3 * ROWS, WIDE);
        sum = 3 * sum + three_rows(e + round, ROWS, round);
        sum = 3 * sum + three_rows(e, 2, WIDE);
        sum = 3 * sum + two_walks(e, 2 * ROWS, WIDE);
        sum = 3 * sum + two_walks(e, 7, round);
        sum = 3 * sum + in_header(e, ROWS, 3);
        sum = 3 * sum + declared(2 * ROWS, round, 2);
        sum = 3 * sum + declared(2 * ROWS, 5 * ROWS * WIDE / 2, -2);
        sum = 3 * sum + declared(0, 2, 2000000000);
        sum = 3 * sum + plain_copy(2 * ROWS, round);
        sum = 3 * sum + by_two(ROWS, round, 2, 3);
        sum = 3 * sum + by_two(ROWS, ROWS, round, -1);
        sum = 3 * sum + down_and_up(ROWS, 4 * ROWS, 3, 2);
        sum = 3 * sum + down_and_up(ROWS, 12, 2, 5);
        sum = 3 * sum + wrapping(3 * ROWS, 7, 4000000001u);
        sum = 3 * sum + of_records(3 * ROWS, round);
        sum = 3 * sum + by_while(e, 2 * ROWS, 3);
        sum = 3 * sum + columns(e, ROWS, 4);
        sum %= 1000000007;
    }
    printf("%ld\n", sum);
    CASE_PRINT(h);
    CASE_PRINT(counted);
    return 0;
}
