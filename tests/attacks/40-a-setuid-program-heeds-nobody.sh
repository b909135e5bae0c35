#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Who starts a setuid program may not have it write a report where he could not, nor change its results.
set -euo pipefail
if [ "$(id -u)" != 0 ] || ! command -v setpriv >/dev/null; then
    exit 0 # cannot be tried
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cat >"$work/loop.c" <<'C'
#include <stdio.h>
enum { N = 100000, K = 1000 };
static int k[N];
static double h[K];
int main(void) {
    for (int t = 0; t < N; t++)
        k[t] = (int)((t * 7919LL + t / 3) % K);
    for (int t = 0; t < N; t++)
        h[k[t]] += 1.0 / (1 + t);
    double sum = 0;
    for (int i = 0; i < K; i++)
        sum = sum * 0.5 + h[i];
    printf("%a\n", sum);
    return 0;
}
C
cd "$work"
"$ATTACK_REDCC" loop.c -o parallel.c -- -O2 >/dev/null 2>&1
gcc -O2 -fopenmp -I"$ATTACK_INCLUDE" parallel.c "$ATTACK_LIBRARY" -o parallel
mkdir mine
chmod 755 "$work"
export REDCC_REPORT=$work/mine/run.json REDCC_METHOD=unknown
if setpriv --reuid=54321 --regid=54321 --clear-groups ./parallel >/dev/null 2>&1; then
    echo "REDCC_METHOD=unknown was not heeded by a plain program" >&2
    exit 1
fi
chmod u+s parallel
setpriv --reuid=54321 --regid=54321 --clear-groups ./parallel >/dev/null || {
    echo "a setuid program heeded REDCC_METHOD" >&2
    exit 1
}
if [ -e "$REDCC_REPORT" ]; then
    echo "a setuid program wrote a report" >&2
    exit 1
fi
