// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// A neutral operand may change a value: rounding downwards, 0.0 + -0.0 is -0.0, and any addition turns a
// signalling NaN into a quiet one. So nothing may be applied for an iteration that does not execute the
// update. For comparison: sums that every iteration adds to.
// METHODS: localwrite localwrite-steal binning
#include <fenv.h>
#include <stdio.h>
#include <string.h>

enum { N = 20000, K = 300 };
static int s[N];
static double x[N], h[K], sum, product, difference, highest;
static float narrow;
static long long signalling;

static void nothing_added(int n, double limit) {
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        h[s[t]] += x[t];
        if (x[t] > limit) {
            sum += x[t];
            product *= x[t];
            difference -= x[t];
            narrow += (float)x[t];
        }
        if (x[t] > limit)
            highest = x[t] > highest ? x[t] : highest;
    }
}

static void each_adds(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        h[s[t]] += x[t];
        sum += x[t] * 0x1p-1000;
        narrow -= (float)x[t];
    }
}

static void set(double *to, long long bits) {
    memcpy(to, &bits, sizeof bits);
}

static void print(void) {
    long long bits[4];
    int of_narrow;
    memcpy(&bits[0], &sum, sizeof sum);
    memcpy(&bits[1], &product, sizeof product);
    memcpy(&bits[2], &difference, sizeof difference);
    memcpy(&bits[3], &highest, sizeof highest);
    memcpy(&of_narrow, &narrow, sizeof narrow);
    printf("%llx %llx %llx %llx %x\n", bits[0], bits[1], bits[2], bits[3], of_narrow);
}

int main(void) {
    static const int modes[] = {FE_TONEAREST, FE_DOWNWARD, FE_UPWARD, FE_TOWARDZERO};
    for (int t = 0; t < N; t++) {
        s[t] = (int)((t * 7919LL + t / 3) % K);
        x[t] = 1.0 + (t * 31 % 997) * 0.01;
    }
    for (int m = 0; m < 4; m++) {
        fesetround(modes[m]);
        sum = product = difference = narrow = 0;
        highest = -1;
        nothing_added(N, 1e9);
        print();
        each_adds(N);
        print();
        nothing_added(N, 10.5);
        print();
        signalling = 0x7ff4000000000001;
        set(&sum, signalling);
        set(&product, signalling);
        set(&difference, signalling);
        set(&highest, signalling);
        nothing_added(N, 1e9);
        print();
    }
    fesetround(FE_TONEAREST);
    for (int i = 0; i < K; i++)
        printf("%a\n", h[i]);
    return 0;
}
