#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Sums in a histogram's loop keep operands for each iteration: a limit on memory must count them.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cat >"$work/loop.c" <<'C'
#include <stdio.h>
#include <sys/resource.h>
enum { N = 20000000 };
static unsigned char k[N];
static int h[256];
int main(void) {
    struct rusage used;
    double a = 0, b = 0, c = 0;
    for (int t = 0; t < N; t++)
        k[t] = (unsigned char)(t * 7919LL + t / 3);
    for (int t = 0; t < N; t++) {
        h[k[t]]++;
        a += k[t] / 3.0;
        b += k[t] / 7.0;
        c += k[t] / 9.0;
    }
    getrusage(RUSAGE_SELF, &used);
    printf("%d %a %a %a\n", h[7], a, b, c);
    fprintf(stderr, "%ld\n", used.ru_maxrss / 1024);
    return 0;
}
C
cd "$work"
"$ATTACK_REDCC" loop.c -o parallel.c -- -O2 >/dev/null 2>&1
gcc -O2 loop.c -o sequential
gcc -O2 -Wl,-u,redcc_run -I"$ATTACK_INCLUDE" parallel.c "$ATTACK_LIBRARY" -o parallel
./sequential >expected 2>/dev/null
export OMP_NUM_THREADS=3 REDCC_REPORT=run.json
REDCC_METHOD=localwrite ./parallel >found 2>/dev/null
cmp expected found
jq -e '.loops[0].method == "localwrite"' run.json >/dev/null
REDCC_MEMORY_LIMIT=40M ./parallel >found 2>megabytes
cmp expected found
if [ "$(cat megabytes)" -gt 100 ]; then
    echo "$(cat megabytes) MB where 40 were allowed beside the program's 20" >&2
    exit 1
fi
jq -e '[.loops[0].fallbacks[].reason | test("REDCC_MEMORY_LIMIT")] | any' run.json >/dev/null
