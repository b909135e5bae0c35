#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# The system refuses a process the threads, or the memory for their stacks: OpenMP would end it.
set -euo pipefail
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
    for (int round = 0; round < 5; round++)
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
gcc -O2 loop.c -o sequential
gcc -O2 -fopenmp -I"$ATTACK_INCLUDE" parallel.c "$ATTACK_LIBRARY" -o parallel
./sequential >expected
export REDCC_METHOD=localwrite REDCC_REPORT=run.json
check() { # check WHAT COMMAND...
    local what=$1 status=0
    shift
    "$@" >found 2>error || status=$?
    if [ "$status" != 0 ] || ! cmp -s expected found; then
        echo "$what: status $status: $(cat error)" >&2
        exit 1
    fi
}
for threads in 2 7 40; do
    export OMP_NUM_THREADS=$threads
    check "no limit" ./parallel
    jq -e ".loops[0].threads == $threads" run.json >/dev/null
    for megabytes in 8 16 24 32 48 64 96 200; do # address space
        check "$threads threads in $megabytes MB" bash -c "ulimit -v $((megabytes * 1024)) && exec ./parallel"
    done
done
# As somebody whom the limit on processes binds (it does not bind root).
if [ "$(id -u)" = 0 ] && command -v setpriv >/dev/null; then
    chmod 777 "$work"
    rm -f run.json
    for processes in 1 2 3 5; do
        export OMP_NUM_THREADS=4
        check "$processes processes" setpriv --reuid=54321 --regid=54321 --clear-groups \
            prlimit --nproc=$processes ./parallel
    done
fi
