// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Attack 66: what the loop leaves in x is read behind it, in places that stand in the text behind a
// statement that writes x and yet are reached without it: by another case of a switch, by an
// initialiser that is evaluated earlier. Neighbours: behind the loop x is written first, on every way.
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

/* A case in a statement that writes before it. */
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

/* The second element's initialiser comes first in the text. */
static __attribute__((noinline)) int in_an_initialiser(int n) {
    int x = 7;
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        x = s[t];
        h[x & 63] += 1;
    }
    const int both[2] = {[1] = (x = 1), [0] = x};
    return both[1] == 1;
}

/* Written first: by all cases, behind a jump that leads past the reads as well. */
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
