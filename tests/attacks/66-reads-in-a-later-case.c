// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// After the loop the program reads x, set by the last iteration. In the text a write of x precedes the
// read, but it may not be executed: it is in another case of a switch, or in an initialiser evaluated
// earlier. For comparison: functions that write x on every path.
#include <stdio.h>

enum { N = 20000 };
static int s[N], h[64];

static __attribute__((noinline)) int in_a_case(int n, int v) {
    int x = 7, y = 0;
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        x = s[t];
        h[x & 63] += 1;
    }
    switch (v) {
    case 0:
        x = 1;
        break;
    case 1:
        y = x;
        break;
    }
    return y;
}

static __attribute__((noinline)) int in_a_default(int n, int v) {
    int x = 7;
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        x = s[t];
        h[x & 63] += 1;
    }
    switch (v) {
    case 0:
        x = 1;
        return 0;
    default:
        return x;
    }
}

/* A case label inside a statement that writes x before the label. */
static __attribute__((noinline)) int in_a_case_inside(int n, int v) {
    int x = 7, y = 0;
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        x = s[t];
        h[x & 63] += 1;
    }
    switch (v) {
    case 0:
        if ((x = n) < 9) {
        case 1:
            y = x;
        }
    }
    return y;
}

static __attribute__((noinline)) int in_a_later_round(int n, int v) {
    int x = 7, y = 0;
    for (int r = 0; r < 2; r++) {
        for (int t = 0; t < n; t++) { // EXPECT: parallel
            x = s[t];
            h[x & 63] += 1;
        }
        for (;;) {
            if (v++ % 3)
                break;
            x = 2;
        }
    }
    y = x;
    return y;
}

/* The initialiser of element 1 precedes that of element 0 in the text. */
static __attribute__((noinline)) int in_an_initialiser(int n) {
    int x = 7;
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        x = s[t];
        h[x & 63] += 1;
    }
    const int both[2] = {[1] = (x = 1), [0] = x};
    return both[1] == 1;
}

/* All cases write x first, or jump past the reads. */
static __attribute__((noinline)) int in_no_case(int n, int v) {
    int x = 7, y = 0;
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        x = s[t];
        h[x & 63] += 1;
    }
    for (int r = 0; r < 9; r++) {
        if (r % 2)
            continue;
        x = r + v;
        y += x;
    }
    return y;
}

int main(void) {
    for (int t = 0; t < N; t++)
        s[t] = (int)((unsigned)t * 7919u % 1000u) + 100;
    for (int again = 0; again < 20; again++)
        for (int v = 0; v < 2; v++)
            printf("%d %d %d %d %d %d\n", in_a_case(N, v), in_a_default(N, v),
                   in_a_case_inside(N, v), in_a_later_round(N, v), in_an_initialiser(N),
                   in_no_case(N, v));
    for (int i = 0; i < 64; i++)
        printf("%d\n", h[i]);
    return 0;
}
