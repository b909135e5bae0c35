/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Steps that are known only when the loop begins: of all types and both directions, 1, longer than
// the loop, zero and negative. The stride may change between executions with the same first value
// and trip count. Counters may be unsigned.
// covers: row 8, row 10 of docs/constructs.md
#include "case.h"
#include <limits.h>
#include <stdint.h>

enum { N = 12000, M = 900 };
static int s[N];
static double w[N], h[M];
static long counts[M], seen[16];
static struct { double x, y; } pairs[M];

static void in_the_header(int n, int stride) {
    int j;
    for (j = 0; j < n; j += stride) // EXPECT: transformed
        h[s[j]] += w[j];
    seen[0] = j;
    for (j = n - 1; j >= 0; j -= stride) // EXPECT: transformed
        h[s[j]] -= w[j] * 0.5;
    seen[1] = j;
    for (j = 3; j <= n - 1; j = stride + j) // EXPECT: transformed
        counts[s[j]] += j;
    seen[2] = j;
    for (j = n; j > 7; j = j - stride) // EXPECT: transformed
        counts[s[j - 1]]++;
    seen[3] = j;
}

static long as_while(long n, short stride) {
    long j = 1;
    while (j < n) { // EXPECT: transformed
        pairs[s[j]].x += w[j];
        pairs[s[j]].y -= w[j];
        j += stride;
    }
    return j;
}

static long as_do(long n, size_t stride) {
    long j = 0;
    if (n > 0)
        do { // EXPECT: transformed
            counts[s[j]] ^= j;
            j += stride;
        } while (j < n);
    return j;
}

static void diagonal(int n) {
    for (int i = 0; i < n * n; i += n + 1) // EXPECT: transformed
        h[s[i]] += w[i];
}

static void unsigned_counters(size_t n, size_t by, unsigned m, unsigned char little) {
    for (size_t i = 0; i < n; i += by) // EXPECT: transformed
        h[s[i]] += w[i];
    for (unsigned i = 5; i < m; i += little) // EXPECT: transformed
        h[s[i]] += w[i];
    for (size_t i = 0; i < n; i += 3) // EXPECT: transformed
        counts[s[i]] += 2;
    for (unsigned i = 1; i < m; i += 2) // EXPECT: transformed
        counts[s[i]] -= 5;
}

/* Unsigned counters could step over the end of their type, but never do here. */
static void to_the_end(unsigned from, unsigned to, unsigned by) {
    const int *const table = s - 0;
    for (unsigned i = from; i < to; i += by) // EXPECT: transformed
        counts[table[i - from]]++;
}

static long with_others(int n, int stride, int ld) {
    int q = 2, at = -1;
    double most = -1e9, sum = 0;
    for (int j = 0; j < n; j += stride, q += ld) { // EXPECT: transformed
        h[s[j]] += w[q % N];
        sum += w[j];
        if (w[j] > most) {
            most = w[j];
            at = j;
        }
    }
    seen[5] = at;
    h[0] += sum;
    return q;
}

static void in_rows(int n, int stride, int width) {
    for (int j = 0; j < n; j += stride) // EXPECT: transformed
        for (int c = 0; c < width; c++)
            h[s[j] / 2 + c] += w[j] * (c + 1);
}

/* No memory determines these subscripts. With equal first values and trip counts only the stride changes the plan. */
static void computed(int n, int stride) {
    for (int j = 0; j < n; j += stride) // EXPECT: transformed
        h[(j * 7 + j / 11) % M] += w[j];
}

static void behind_a_condition(int n, int stride, const int *more) {
    for (int j = 0; j < n; j += stride) // EXPECT: transformed
        if (w[j] > 0.25)
            h[s[j]] += w[j] * (j > 4 ? more[j - 4] : 2);
}

int main(void) {
    static const int trips[] = {N, 0, 1, 2, -5, 5000, N, 11999};
    static const int strides[] = {1, 3, 2, 7, 3, N, 40, INT_MAX / 2};
    case_values(w, N);
    case_subscripts(s, N, M);
    for (int round = 0; round < 16; round++) {
        const int n = trips[round % 8], stride = strides[round / 2 % 8];
        in_the_header(n, stride);
        seen[4] += as_while(n, (short)(stride % 100 + 1));
        seen[7] += as_do(n, (size_t)stride);
        diagonal(round + 70);
        unsigned_counters((size_t)(n > 0 ? n : 0), (size_t)stride, (unsigned)(n > 0 ? n : 0),
                          (unsigned char)(stride % 9 + 1));
        unsigned_counters(N, SIZE_MAX - (size_t)(round % 3), N, 1);
        unsigned_counters(N, SIZE_MAX >> round % 5, 0, 1);
        for (int i = 0; i < 20; i++)
            computed((N / 4) * (1 + i / 5), 1 + i / 5);
        to_the_end(UINT_MAX - N + 1, UINT_MAX - 1000, 1 + (unsigned)stride % 50);
        seen[6] += with_others(n, stride, stride % 5);
        in_rows(n, stride, round % 4);
        behind_a_condition(n, stride, s);
        if (round % 5 == 4)
            case_subscripts(s, N, M);
        CASE_PRINT(h);
        CASE_PRINT(counts);
        CASE_PRINT(seen);
        for (int i = 0; i < M; i++)
            h[i] += pairs[i].x - pairs[i].y;
    }
    return 0;
}
