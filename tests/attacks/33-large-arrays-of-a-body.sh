#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Without a limit on stacks, as usual on clusters, threads get 2 MB each; the body's array has 5.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cat >"$work/loop.c" <<'C'
#include <stdio.h>
enum { N = 400, K = 50, LONG = 5 * 1024 * 1024 };
static int k[N];
static double h[K];
int main(void) {
    for (int t = 0; t < N; t++)
        k[t] = t * 7 % K;
    for (int t = 0; t < N; t++) {
        char page[LONG];
        for (int i = t % 4096; i < LONG; i += 65536)
            page[i] = (char)t;
        h[k[t]] += page[t % 4096 + 65536] / 3.0;
    }
    double sum = 0;
    for (int i = 0; i < K; i++)
        sum = sum * 0.5 + h[i];
    printf("%a\n", sum);
    return 0;
}
C
cd "$work"
ulimit -Hs | grep -q unlimited || exit 0 # it cannot be lifted here
ulimit -s unlimited
"$ATTACK_REDCC" loop.c -o parallel.c -- -O2 >/dev/null 2>&1
gcc -O2 loop.c -o sequential
gcc -O2 -Wl,-u,redcc_run -I"$ATTACK_INCLUDE" parallel.c "$ATTACK_LIBRARY" -o parallel
./sequential >expected
for threads in 1 2 3 7; do
    OMP_NUM_THREADS=$threads REDCC_METHOD=localwrite REDCC_REPORT=run.json ./parallel >found
    cmp expected found
    [ "$threads" = 1 ] || jq -e '.loops[0].method == "localwrite"' run.json >/dev/null
done
