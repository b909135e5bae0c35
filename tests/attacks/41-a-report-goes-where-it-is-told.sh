#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# A report is written through a pipe, a device or a link, which stays; %p is the process's id, and - is
# standard error, for people.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cat >"$work/loop.c" <<'C'
enum { N = 100000, K = 1000 };
static int k[N];
static double h[K];
int main(void) {
    for (int t = 0; t < N; t++)
        k[t] = (int)((t * 7919LL + t / 3) % K);
    for (int t = 0; t < N; t++)
        h[k[t]] += 1.0 / (1 + t);
    return h[3] < 0;
}
C
cd "$work"
"$ATTACK_REDCC" loop.c -o parallel.c -- -O2 >/dev/null 2>&1
gcc -O2 -Wl,-u,redcc_run -I"$ATTACK_INCLUDE" parallel.c "$ATTACK_LIBRARY" -o parallel
export OMP_NUM_THREADS=2 REDCC_METHOD=localwrite

mkfifo pipe
timeout 20 cat pipe >from_pipe &
REDCC_REPORT=pipe timeout 20 ./parallel
wait $!
jq -e '.loops[0].method == "localwrite"' from_pipe >/dev/null
[ -p pipe ]

echo old >file
ln -s file link
REDCC_REPORT=link ./parallel
[ -L link ]
jq -e '.loops[0].method == "localwrite"' file >/dev/null

REDCC_REPORT=/dev/null ./parallel
[ -c /dev/null ]

REDCC_REPORT=run-%p.json ./parallel &
process=$!
wait $process
jq -e '.loops[0].method == "localwrite"' "run-$process.json" >/dev/null

REDCC_REPORT=- ./parallel 2>table
grep -q 'localwrite, built, named; loop.c:7 (main)' table
[ ! -e ./- ]
REDCC_REPORT=./plain.json ./parallel
jq -e '.loops[0].method == "localwrite"' plain.json >/dev/null
[ "$(find . -name 'plain.json*' | wc -l)" = 1 ]
