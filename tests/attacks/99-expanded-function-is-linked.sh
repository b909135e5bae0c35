#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Attack 99: a loop was translated with the body of another file's function in place of its call, and
# the program is linked with another definition, which depends on the order of its calls. Neighbour: the
# function that was seen; with it the loop runs in parallel.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
fail() { echo "99: $*" >&2; exit 1; }
mkdir other parallel
touch Makefile
cat >add.h <<'C'
#include <stdio.h>
#include <stdlib.h>
int add(double *h, int i, int limit, double x);
void run(int n, const int *s, const double *x, double *h);
C
cat >add.c <<'C'
#include "add.h"
int add(double *h, int i, int limit, double x)
{
    if (h == NULL || i >= limit) { fprintf(stderr, "%d\n", limit); exit(3); }
    h[i] += x;
    return 0;
}
C
cat >user.c <<'C'
#include "add.h"
void run(int n, const int *s, const double *x, double *h)
{
    static long count[400];
    for (int t = 0; t < n; t++) {
        count[s[t]]++;
        if (add(h, s[t], 400, x[t]))
            return;
    }
    h[0] += (double)count[1];
}
C
cat >main.c <<'C'
#include "add.h"
enum { N = 12000, M = 400 };
static double x[N], h[M];
static int s[N];
int main(void)
{
    for (int t = 0; t < N; t++) { s[t] = t * 7 % M; x[t] = t * 0.37; }
    for (int round = 0; round < 3; round++) run(N, s, x, h);
    double sum = 0;
    for (int i = 0; i < M; i++) sum = sum * 0.99 + h[i];
    printf("%a\n", sum);
    return 0;
}
C
# remembers: its result depends on the order of all calls
sed 's/^{/{ static double last; x += last * 0.5; last = x;/' add.c >other/add.c
flags="-w -I. -O2 -ffp-contract=off"
for name in user add; do
    "$ATTACK_REDCC" --files=project "$name.c" -o "parallel/$name.c" -- 2>>remarks
    gcc $flags -iquote . -idirafter "$ATTACK_INCLUDE" -c "parallel/$name.c" -o "$name.o"
done
grep -q "loop in 'run' runs in parallel" remarks || fail "the loop is not translated"
gcc -I. $flags -c other/add.c -o other_add.o
check() { # WHAT yes|no OBJECT SOURCE
    gcc $flags main.c user.c "$4" -o wanted
    gcc $flags -Wl,-u,redcc_run main.c user.o "$3" "$ATTACK_LIBRARY" -o found -lm
    ./wanted >expected
    for threads in 2 3 7; do
        rm -f report
        REDCC_METHOD=localwrite OMP_NUM_THREADS=$threads REDCC_REPORT=report ./found >out
        cmp -s expected out || fail "$1: another program at $threads threads"
        built=$(jq '[.loops[].plans_built] | add' report)
        [ "$2" = yes ] && [ "$built" -eq 0 ] && fail "$1: not in parallel"
        [ "$2" = no ] && [ "$built" -ne 0 ] && fail "$1: in parallel"
        true
    done
}
check "the function that was seen" yes add.o add.c
check "another function" no other_add.o other/add.c
# A function that adds twice may have other bits in its file, whose flags may permit another order.
sed 's/h\[i\] += x;/h[i] += x; h[i] += 0.5 * x;/' other/add.c | sed 's/static double last; x += last \* 0.5; last = x;//' >add.c
"$ATTACK_REDCC" --files=project user.c -o parallel/user.c -- -w -I. -O2 2>remarks
grep -q "loop in 'run' runs in parallel" remarks && fail "a function with several floating operations is expanded"
true
