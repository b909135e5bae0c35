#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# A signal that is left to the system ends a program at once, in a loop of seconds and while threads
# are started, also where handlers might leave a loop and signals wait for its end.
set -euo pipefail
. "$(dirname "$0")/a-loop"
cat >long.c <<'C'
#include <setjmp.h>
#include <signal.h>
#include <stdlib.h>
enum { N = 1000000, K = 1000 };
static int k[N];
static double h[K];
static sigjmp_buf out;
static void leave(int number) {
    siglongjmp(out, number);
}
__attribute__((noinline)) static void fill(int count, int weight) {
    for (int t = 0; t < count; t++) {
        double v = t;
        for (int c = 0; c < weight; c++)
            v = v * 0.999 + 1;
        h[k[t]] += v;
    }
}
int main(int count, char **argument) {
    signal(SIGUSR1, leave);
    for (int t = 0; t < N; t++)
        k[t] = (int)(t * 7919LL % K);
    if (count > 1)
        for (int round = 0; round < 20; round++) /* short ones are known */
            fill(20000, 1);
    fill(N, 20000);
    return 0;
}
C
"$ATTACK_REDCC" long.c -o translated.c -- -O2 >/dev/null 2>&1
gcc -O2 -Wl,-u,redcc_run -I"$ATTACK_INCLUDE" translated.c "$ATTACK_LIBRARY" -o long
export REDCC_METHOD=localwrite
ends() { # ends SIGNAL AFTER ARGUMENT...: within two seconds, by the signal
    local status=0 signal=$1 after=$2
    shift 2
    ./long "$@" &
    local process=$!
    sleep "$after"
    kill -s "$signal" "$process"
    local -i before=$(date +%s%N)
    wait "$process" || status=$?
    local -i took=$(($(date +%s%N) - before))
    if [ "$status" != $((128 + $(kill -l "$signal"))) ] || [ "$took" -gt 2000000000 ]; then
        echo "$signal after $after s: status $status, $((took / 1000)) us" >&2
        exit 1
    fi
}
for threads in 2 7 33; do
    export OMP_NUM_THREADS=$threads
    ends TERM 0.2
    ends ALRM 0.2 short
    for after in 0.004 0.006 0.008 0.012; do
        ends TERM $after
    done
done
