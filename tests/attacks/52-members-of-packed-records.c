/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// CFLAGS: -O2 -fsanitize=alignment -fno-sanitize-recover=all
// METHODS: auto localwrite binning
// Members of packed records may be misaligned for their type: none may be accessed through an ordinary pointer.
#include <stdio.h>

enum { N = 5000, K = 60 };
static int k[N];
static double h[K], v[N];

static struct __attribute__((packed)) { char at; struct __attribute__((packed)) { double x, y; char tag[8]; } of[K]; } p;
struct __attribute__((packed)) alone { double x; };
static char bytes[K * sizeof(struct alone) + 1];

static void members(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        p.of[k[t]].x += v[t];
        p.of[k[t]].y -= v[t];
    }
}

static void named(int n, struct alone *q) {
    for (int t = 0; t < n; t++) // EXPECT: parallel
        q[k[t]].x += v[t];
}

static void all(void) {
    members(N);
    named(N, (struct alone *)(bytes + 1));
    for (int i = 0; i < K; i++)
        h[i] = p.of[i].x * 3 + p.of[i].y * 5 + ((struct alone *)(bytes + 1))[i].x;
}

int main(void) {
    for (int t = 0; t < N; t++) {
        k[t] = t * 7919 % K;
        v[t] = 1.0 / (1 + t);
    }
    for (int round = 0; round < 3; round++)
        all();
    for (int i = 0; i < K; i++)
        printf("%a\n", (double)h[i]);
    return 0;
}
