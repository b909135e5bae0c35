#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# In the system that Containerfile's last stage makes, as root, with its environment: redcc translates, a
# build by redcc-cc gives the sequential program's bits. Run by script/clean-system.
set -euo pipefail
fail() { echo "FAIL: $*" >&2; exit 1; }
redcc --version >/dev/null || fail "redcc does not start"
cat >count.c <<'END'
#include <stdio.h>
static double b[64];
static int s[100000];
int main(void) {
    for (int t = 0; t < 100000; t++)
        s[t] = (t * 7919) % 64;
    for (int t = 0; t < 100000; t++)
        b[s[t]] += 1.0 / (1 + t);
    for (int e = 0; e < 64; e++)
        printf("%a\n", b[e]);
    return 0;
}
END
printf 'count: count.c\n\t$(CC) -O2 count.c -o count\n' >Makefile
cc -O2 -ffp-contract=off count.c -o serial && ./serial >expected
REDCC_STRICT=1 make -s CC=redcc-cc && OMP_NUM_THREADS=2 ./count | cmp - expected || fail "make CC=redcc-cc"
redcc count.c -o out.c 2>remarks && grep -q 'runs in parallel' remarks || fail "redcc: $(cat remarks)"
# shellcheck disable=SC2046
cc -O2 -ffp-contract=off -Wl,-u,redcc_run out.c $(pkg-config --cflags --libs redcc) -o by-hand && ./by-hand | cmp - expected || fail "by hand"
echo "container: passed"
