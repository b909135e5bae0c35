// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// A comparison of doubles is stored in an integer of another type than int. With --lanes it is a mask,
// and arithmetic on the mask must give what the integer type gives.
// OPTIONS: --lanes=4
// CFLAGS: -O1 -ffp-contract=off
// METHODS: localwrite localwrite-steal
#include <stdio.h>

enum { N = 9000, K = 300 };
static int s[N];
static double x[N], h[K];
static long long whole[K];

static void of_unsigned(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        const double r = x[t] * 0.5;
        const unsigned near = r < 3.0;
        h[s[t]] += (near - 2) / 3 * 0.5 + r;
        whole[s[t]] += (near - 2) < 0;
        whole[s[t]] += -near >> 1;
        whole[s[t]] += ~near;
    }
}

static void of_size(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        const double r = x[t] * 0.5;
        const unsigned long near = r < 3.0 && r > 1.0;
        h[s[t]] += (double)((near - 2) / 3) * 0.5 + r;
        whole[s[t]] += (near - 2) < 0;
        whole[s[t]] += -near >> 1;
        whole[s[t]] += ~near;
    }
}

static void of_long(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        const double r = x[t] * 0.5;
        const long near = r < 3.0;
        h[s[t]] += (double)(near << 40) * 0.5 + r;
        whole[s[t]] += (near << 33) - 5;
    }
}

static void of_bytes(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        const double r = x[t] * 0.5;
        const unsigned char near = r < 3.0;
        const signed char far = !(r < 3.0);
        const unsigned short not_near = r >= 3.0;
        h[s[t]] += near * 0.5 - far * 0.25 + not_near * 0.125;
        whole[s[t]] += ~near + -far - ~not_near;
    }
}

enum side { LEFT, RIGHT };

static void of_an_enumeration(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        const double r = x[t] * 0.5;
        const enum side side = r < 3.0;
        h[s[t]] += r;
        whole[s[t]] += (side - 2) < 0;
        whole[s[t]] += side == RIGHT ? 7 : -3;
    }
}

/* For comparison: an int, and a value that is not constant. */
static void of_int(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        const double r = x[t] * 0.5;
        const int near = r < 3.0;
        h[s[t]] += (near - 2) / 3 * 0.5 + r;
        whole[s[t]] += -near >> 1;
    }
}

int main(void) {
    for (int t = 0; t < N; t++) {
        s[t] = (int)((t * 7919LL + t / 3) % K);
        x[t] = 1.0 + (t * 31 % 997) * 0.01;
    }
    for (int round = 0; round < 2; round++) {
        of_unsigned(N);
        of_size(N);
        of_long(N);
        of_bytes(N);
        of_an_enumeration(N);
        of_int(N);
    }
    for (int i = 0; i < K; i++)
        printf("%a %lld\n", h[i], whole[i]);
    return 0;
}
