/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Values of private variables after the loop that only one of several paths uses.
#include "case.h"

enum { N = 5000, M = 400 };
static int s[N];
static double h[M];
static long kept[16];

static void one_branch_writes(int n, int m) {
    int k = 0;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        k = s[t];
        h[k] += 1;
    }
    if (m > 3)
        k = -7;
    kept[0] = k;
}

static void a_loop_that_is_not_entered(int n, int m) {
    int k = 0;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        k = s[t];
        h[k] += 2;
    }
    for (int i = 3; i < m; i++)
        k = i;
    kept[1] = k;
}

static void around_again(int n) {
    int k = 1;
    for (int r = 0; r < 3; r++) {
        kept[2] = kept[2] * 5 + k;
        for (int t = 0; t < n; t++) { // EXPECT: transformed
            k = s[t] + 1;
            h[k - 1] += 3;
        }
    }
}

static void by_a_label(int n) {
    int k = 1, r = 0;
again:
    kept[3] = kept[3] * 5 + k;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        k = s[t] + 2;
        h[k - 2] += 4;
    }
    if (++r < 3)
        goto again;
}

static void past_the_write(int n, int m) {
    int k = 1;
    do {
        for (int t = 0; t < n; t++) { // EXPECT: transformed
            k = s[t] + 3;
            h[k - 3] += 5;
        }
        if (m < 100)
            break;
        k = 0;
    } while (m > 1000);
    kept[4] = k;
}

static double large_operands(int n) {
    double sum = 0.5;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        sum += (t * 40009 + 16777217);
        h[s[t]] += 1;
    }
    return sum;
}

int main(void) {
    for (int i = 0; i < N; i++)
        s[i] = (i * 7919) % M;
    one_branch_writes(N, 2);
    a_loop_that_is_not_entered(N, 2);
    around_again(N);
    by_a_label(N);
    past_the_write(N, 2);
    printf("%a\n", large_operands(N));
    for (int i = 0; i < 16; i++)
        printf("%ld\n", kept[i]);
    for (int i = 0; i < M; i++)
        printf("%a\n", h[i]);
    return 0;
}
