/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Secondary counters, stepped in the body or in the header, up and down, wrapping around, and read
// after the loop.
// covers: row 79 of docs/constructs.md
#include "case.h"

enum { N = 4000, ROWS = 90 };
static int s[3 * N + 9];
static double e[3 * N + 9], h[ROWS];
static long counted[ROWS];
static unsigned char bytes[ROWS];

static int behind(int lo, int hi, int k, double a) {
    int i;
    for (i = lo; i < hi; i++) { // EXPECT: transformed
        h[s[i]] -= a * e[k];
        ++k;
    }
    return k;
}

static int by_three(int n) {
    int q = 2;
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        h[s[q]] += e[i];
        q += 3;
    }
    return q;
}

static int in_header(int n) {
    int q = 2;
    for (int i = 0; i < n; i++, q += 3) // EXPECT: transformed
        h[s[i]] += e[q];
    return q;
}

static int counter_second(int n) {
    int q = 3 * n, i;
    for (i = 0; i < n; q -= 3, i++) // EXPECT: transformed
        h[s[i]] += e[q];
    return 7 * q + i;
}

static long set_in_header(int n, int m) {
    int i, q, r;
    long u = 3;
    for (i = 0, q = 2 * m + 1; i < n; i++, q += 2) // EXPECT: transformed
        h[s[i]] += e[q];
    for (r = m, i = n - 1, u = 4; i >= 0; u++, --i, r -= 0) // EXPECT: transformed
        h[s[u]] -= e[i] * r;
    for (q = 7, i = n; i < m; i++, q++) // EXPECT: transformed
        h[s[i]] += e[q];
    return 100 * u + 10 * q + r;
}

static long several(int n) {
    int q = n, r = 1;
    long u = 5;
    for (int i = n - 1; i >= 0; i -= 2, q--) { // EXPECT: transformed
        h[s[i]] += e[r] * (double)u;
        r++;
        if (e[q] > 0.25)
            h[s[r]] -= e[q];
        u = u - 2;
        r = 1 + r;
    }
    return 100 * u + 10 * q + r;
}

static unsigned wrapping(int n) {
    unsigned k = 4294967290u;
    unsigned char c = 250;
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        counted[s[i]] += k % 7;
        k += 5;
        bytes[s[i]] += c;
        c++;
    }
    return k + c;
}

static int used_where_it_moves(int n, int k) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        const int at = s[k++];
        const double w = e[++k];
        h[at] += w;
    }
    return k;
}

static int by_stride(int n, int k, const int by) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        h[s[k]] += e[i];
        k += by;
    }
    return k;
}

static long by_strides(int n, int by, unsigned wide, signed char narrow) {
    int i, q;
    long r = 4000;
    unsigned char c = 7;
    for (i = 0, q = 3; i < n; i++, q = q + 2 * by) { // EXPECT: transformed
        h[s[q]] += e[r];
        r -= narrow;
        r++;
        bytes[s[i]] += c;
        c += wide;
        c--;
    }
    return 10 * r + 5 * q + c;
}

static int by_while(int n, int k) {
    int i = 0;
    while (i < n) { // EXPECT: transformed
        h[s[k]] += e[i];
        k--;
        i++;
    }
    return k;
}

static void skipped_after(int n, int k) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        k += 2;
        if (s[i] % 3 == 0)
            continue;
        h[s[k]] += e[i];
    }
}

static int again_and_again(int n, int rows) {
    int k = 0;
    for (int r = 0; r < rows; r++)
        for (int i = 0; i < n; i++) { // EXPECT: transformed
            h[s[i]] += e[k];
            k++;
        }
    return k;
}

static void goes_on(int n, int rows) {
    int k = 0;
    for (int r = 0; r < rows; r++)
        for (int i = 0; i < n; i++) { // EXPECT: transformed
            h[s[i]] += e[k];
            k++;
        }
}

static void goes_on_by_jump(int n, int rows) {
    int k = 0;
again:
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        h[s[i]] -= e[k];
        k++;
    }
    if (--rows > 0)
        goto again;
}

/* Each turn of a triangular nest steps `k` or `q`, used as subscripts. Some rows have no turns. */
static int over_triangles(int n, int m, int k) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        h[s[i]] += 0.25;
        for (int j = i + 2; j <= m; j++) {
            h[s[k]] += e[i];
            k += 2;
            counted[s[j]] += k;
            k--;
        }
    }
    int q = k;
    for (int i = -9; i < n; i++) // EXPECT: transformed
        for (int j = 3; j < i; j++, q--)
            h[s[j]] -= e[q % 9 + 9];
    return 3 * k + q;
}

/* No triangular nests: the number of turns is not known in advance, or other statements step `k` as well. */
static int no_triangles(int n, int k) {
    for (int i = 0; i < n; i++) // EXPECT: refuse scalar-carried
        for (int j = 2 * i; j < n; j++, k++) // EXPECT: transformed
            h[s[j]] += e[k];
    for (int i = 0; i < n; i++) // EXPECT: refuse scalar-carried
        if (s[i] > 3)
            for (int j = i + 1; j < n; j++, k++) // EXPECT: transformed
                h[s[j]] += e[k];
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        for (int j = i + 1; j < n; j++, k++) // EXPECT: transformed
            h[s[j]] += e[k];
        k++;
    }
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        for (int j = i + 1; j < n; j++, k++) // EXPECT: transformed
            h[s[j]] += e[k];
        for (int j = 0; j < i; j++, k++) // EXPECT: transformed
            h[s[j]] += e[k];
    }
    for (int i = 0; i < n; i += 2) // EXPECT: refuse scalar-carried
        for (int j = i + 1; j < n; j++, k++) // EXPECT: transformed
            h[s[j]] += e[k];
    return k;
}

int main(void) {
    unsigned long sum = 0;
    case_values(e, 3 * N + 9);
    for (int round = 0; round < 4; round++) {
        if (round != 2)
            case_subscripts(s, 3 * N + 9, ROWS);
        sum = 3 * sum + (unsigned long)behind(round, N - round, round == 1 ? 40 : 7, 0.5);
        sum = 3 * sum + (unsigned long)behind(5, 2, 11, 0.5);
        sum = 3 * sum + (unsigned long)by_three(N - round);
        sum = 3 * sum + (unsigned long)in_header(N);
        sum = 3 * sum + (unsigned long)counter_second(N - 1);
        sum = 3 * sum + (unsigned long)set_in_header(N - 1, round);
        sum = 3 * sum + (unsigned long)several(N);
        sum = 3 * sum + (unsigned long)wrapping(N);
        sum = 3 * sum + (unsigned long)used_where_it_moves(N, round);
        sum = 3 * sum + (unsigned long)by_stride(N, round, 2);
        sum = 3 * sum + (unsigned long)by_stride(N, round + 5, round == 2 ? 3 : 0);
        sum = 3 * sum + (unsigned long)by_stride(N, 2 * N, -1);
        sum = 3 * sum + (unsigned long)by_strides(N, 1, 4000000001u, (signed char)(round - 1));
        sum = 3 * sum + (unsigned long)by_strides(0, 2000000000, 4, 5);
        sum = 3 * sum + (unsigned long)by_while(N, N + round);
        if (round == 0)
            sum = 3 * sum + (unsigned long)no_triangles(9, 2);
        skipped_after(N, 3);
        for (int m = -2; m < 100; m += 41)
            sum = 3 * sum + (unsigned long)over_triangles(70 - round, m, 5);
        sum = 3 * sum + (unsigned long)again_and_again(N, 2);
        goes_on(N, 3);
        goes_on_by_jump(N, 2);
    }
    printf("%lu\n", sum);
    CASE_PRINT(h);
    CASE_PRINT(counted);
    CASE_PRINT(bytes);
    return 0;
}
