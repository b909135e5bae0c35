/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Loops that are accepted although they resemble refused ones.
// covers: row 11, row 22, row 26, row 59 of docs/constructs.md
#include "case.h"

enum { N = 7000, M = 600 };
typedef struct box {
    double f[3];
    int which;
} box;

static int k[N], chain[M], live;
static unsigned short narrow[N];
static double w[N], h[M];
static float single[M];
static box boxes[M];
double outside = 0.75;

static void inner_counter_outlives(int n) {
    int c = 0;
    for (int t = 0; t < n; t++) // EXPECT: transformed
        for (c = 0; c < k[t] % 4; c++)
            h[k[c]] += 1.0;
    live = c;
}

static void own_histogram(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        double a[4] = {0};
        for (int c = 0; c < 6; c++)
            a[k[c + t % 100] & 3] += w[t];
        h[k[t]] += a[0] - a[3];
    }
}

static void member_subscript(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        boxes[k[t]].f[boxes[t % M].which] += w[t];
}

static void in_the_middle(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[k[t]] = w[t] + h[k[t]] + w[t];
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[k[t]] = h[k[t]] + w[t] - 3.0 * w[t];
}

static void along_chains(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        int i = k[t];
        while (i > 0) {
            h[i] += w[t];
            i = chain[i];
        }
    }
}

/* The sum wraps around in an unsigned char before it becomes a subscript. */
static void narrow_arithmetic(int n) {
    unsigned char i;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        i = (unsigned char)narrow[t];
        i += 200;
        h[i] += 1.0;
    }
}

static void mixed_precision(unsigned long n) {
    for (unsigned long t = 0; t < n; t++) // EXPECT: transformed
        single[k[t]] += w[t];
}

static void from_the_end(int n, double *end) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        end[-k[t] - 1] += outside;
}

static void overflowing_rows(double (*rows)[3], int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        rows[0][k[t]] += w[t];
}

int main(void) {
    case_values(w, N);
    for (int i = 0; i < M; i++) {
        chain[i] = i / 3;
        boxes[i].which = i % 3;
    }
    for (int round = 0; round < 3; round++) {
        case_subscripts(k, N, M);
        for (int t = 0; t < N; t++)
            narrow[t] = (unsigned short)case_below(65536);
        inner_counter_outlives(N - round);
        own_histogram(N);
        member_subscript(N);
        in_the_middle(N);
        along_chains(N);
        narrow_arithmetic(N);
        mixed_precision(N);
        from_the_end(N, h + M);
        overflowing_rows((double(*)[3])h, N);
        CASE_PRINT(h);
        CASE_PRINT(single);
        case_print("live", &live, sizeof live);
        case_print("boxes", boxes, sizeof boxes);
        for (int i = 0; i < M; i++)
            single[i] = 0.0f;
    }
    return 0;
}
