#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# A branch that is not compiled brings a macro's old meaning back: compiled with it, what stands in front of
# the function and what stands in it are decided otherwise.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
cat >x.c <<'END'
#include <stdio.h>
enum { N = 5000, ROWS = 60 };
static int s[N];
static long h[ROWS];
#ifdef B
#define A 1
#pragma push_macro("A")
#undef A
#define A 2
#else
#define A 1
#endif
static int calls;
static void sums(int n) {
    calls++;
    for (int t = 0; t < n; t++) {
#ifdef B
#pragma pop_macro("A")
#endif
        h[s[t]] += 3;
    }
    for (int t = 0; t < n; t++) {
#if A == 1
        h[s[t]] *= 3;
#else
        h[s[t]] += 5;
#endif
    }
}
int main(void) {
    for (int t = 0; t < N; t++)
        s[t] = t * 37 % ROWS;
    sums(N);
    for (int i = 0; i < ROWS; i++)
        printf("%ld\n", h[i]);
    return calls - 1;
}
END
"$ATTACK_REDCC" x.c -o y.c --report=json --report-file=report.json
for with in "" -DB; do
    gcc -O1 -w $with x.c -o x
    gcc -O1 -w $with -Wl,-u,redcc_run -I"$ATTACK_INCLUDE" y.c "$ATTACK_LIBRARY" -o y -lm
    ./x >expected
    REDCC_METHOD=localwrite OMP_NUM_THREADS=3 ./y >found
    cmp expected found
done
