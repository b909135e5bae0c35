#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# A macro in a header, or an option's, lets a function be compiled for processors that fuse products and sums.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
grep -qw fma /proc/cpuinfo || { echo "the processor has no FMA"; exit 0; }
cat >fast.h <<'END'
#ifndef FAST
#define FAST __attribute__((target("avx2,fma")))
#endif
END
cat >x.c <<'END'
#include "fast.h"
#include <stdio.h>
enum { N = 5000, K = 60 };
static int s[N], s2[N];
static double h[K], e[N + 1];
static FAST void sums(int n) {
    for (int t = 0; t < n; t++) {
        const double p = e[t] * e[t + 1];
        h[s[t]] += p;
        h[s2[t]] -= p;
    }
}
int main(void) {
    for (int t = 0; t < N; t++) {
        s[t] = t * 37 % K;
        s2[t] = t * 31 % K;
        e[t] = 1.0 / (3 + t);
    }
    for (int round = 0; round < 3; round++)
        sums(N);
    for (int i = 0; i < K; i++)
        printf("%a\n", h[i]);
    return 0;
}
END
for option in -DOTHER '-DFAST=__attribute__((target("avx2,fma")))'; do
    "$ATTACK_REDCC" x.c -o y.c -- "$option"
    gcc -O2 -w -Wl,-u,redcc_run "$option" -I"$ATTACK_INCLUDE" y.c "$ATTACK_LIBRARY" -o y -lm
    REDCC_METHOD=serial ./y >expected
    REDCC_METHOD=localwrite OMP_NUM_THREADS=2 ./y >found
    cmp expected found
done
