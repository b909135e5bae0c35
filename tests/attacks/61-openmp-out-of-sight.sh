#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Directives of OpenMP that bind to the team around them: in a library's header (-isystem), as a macro and in a
# function; in a header included in a function's body.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
mkdir library
cat >library/lib.h <<'END'
#define LIB_MASTER _Pragma("omp master")
static inline double lib_weight(double v) {
    double r = 0;
#pragma omp master
    r = v;
    return r;
}
END
echo '#pragma omp master' >inside.h
cat >x.c <<'END'
#include <lib.h>
#include <stdio.h>
enum { N = 5000, K = 60 };
static int s[N];
static double h[K], e[N];
static double by_macro(int t) { double r = 0; LIB_MASTER r = e[t]; return r; }
static double by_inclusion(int t) {
    double r = 0;
#include "inside.h"
    r = e[t];
    return r;
}
static void sums(int n) {
    for (int t = 0; t < n; t++)
        h[s[t]] += by_macro(t);
    for (int t = 0; t < n; t++)
        h[s[t]] += lib_weight(e[t]);
    for (int t = 0; t < n; t++) {
        LIB_MASTER { h[s[t]] += e[t]; }
    }
    for (int t = 0; t < n; t++)
        h[s[t]] += by_inclusion(t);
}
int main(void) {
    for (int t = 0; t < N; t++) {
        s[t] = t * 37 % K;
        e[t] = 1.0 / (1 + t);
    }
    sums(N);
    for (int i = 0; i < K; i++)
        printf("%a\n", h[i]);
    return 0;
}
END
"$ATTACK_REDCC" x.c -o y.c -- -fopenmp -isystem library
gcc -O1 -w -fopenmp -isystem library x.c -o x
gcc -O1 -w -fopenmp -isystem library -I"$ATTACK_INCLUDE" y.c "$ATTACK_LIBRARY" -o y -lm
OMP_NUM_THREADS=3 ./x >expected
for method in localwrite binning; do
    REDCC_METHOD=$method OMP_NUM_THREADS=3 timeout 20 ./y >found
    cmp expected found
done
