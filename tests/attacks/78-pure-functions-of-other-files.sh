#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Attack 78: a function of another file, rightly declared pure or const, reads what each thread has for
# itself: workers would read their own. Such a function is refused by a message that says what to do;
# --pure=NAME and #pragma redcc pure(NAME) say that it is the same in all threads. Neighbours: those, a
# body in the file, and functions of the C library.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
fail() { echo "78: $*" >&2; exit 1; }
cat >other.c <<'C'
static _Thread_local double level = 1;
void set_level(double v) { level = v; }
double level_at(int i) { return level * i; }
double scaled(double v) { return level * v; }
double twice(double v) { return v * 2; }
double dysize(int i) { return level + i; }
C
cat >loops.c <<'C'
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
void set_level(double v);
__attribute__((pure)) double level_at(int i);
__attribute__((const)) double scaled(double v);
__attribute__((const)) double twice(double v);
__attribute__((pure)) double dysize(int i); /* <time.h> has another */
__attribute__((pure)) static double here(const double *v, int i) { return v[i] + 1; }
enum { N = 20000, K = 300 };
static int s[N];
static double x[N];
static char text[N + 8];
double by_pure(int n) {
    double h[K] = {0}, sum = 0;
    for (int t = 0; t < n; t++)
        h[s[t]] += level_at(t);
    for (int i = 0; i < K; i++)
        sum = sum * 0.9 + h[i];
    return sum;
}
double by_const(int n) {
    double h[K] = {0}, sum = 0;
    for (int t = 0; t < n; t++)
        h[s[t]] += scaled(x[t]);
    for (int i = 0; i < K; i++)
        sum = sum * 0.9 + h[i];
    return sum;
}
double by_a_name_of_the_library(int n) {
    double h[K] = {0}, sum = 0;
    for (int t = 0; t < n; t++)
        h[s[t]] += dysize(t);
    for (int i = 0; i < K; i++)
        sum = sum * 0.9 + h[i];
    return sum;
}
double by_word(int n) {
    double h[K] = {0}, sum = 0;
    for (int t = 0; t < n; t++)
        h[s[t]] += twice(x[t]);
    for (int i = 0; i < K; i++)
        sum = sum * 0.9 + h[i];
    return sum;
}
double by_body(int n) {
    double h[K] = {0}, sum = 0;
    for (int t = 0; t < n; t++)
        h[s[t]] += here(x, t);
    for (int i = 0; i < K; i++)
        sum = sum * 0.9 + h[i];
    return sum;
}
double by_library(int n) {
    double h[K] = {0}, sum = 0;
    for (int t = 0; t < n; t++) {
        h[s[t]] += (double)strlen(text + n - t % 9) + abs(t - 50) + ffs(t) + memcmp(text, text + t % 7, 3);
        h[s[t]] += (isnan(x[t]) != 0) + floor(x[t]) + round(x[t]) + (strchr(text + n - t % 9, 'c') != NULL);
    }
    for (int i = 0; i < K; i++)
        sum = sum * 0.9 + h[i];
    return sum;
}
int main(void) {
    for (int t = 0; t < N; t++) {
        s[t] = (int)((t * 7919LL + t / 3) % K);
        x[t] = 1.0 + (t * 31 % 997) * 0.01;
        text[t] = (char)('a' + t % 7);
    }
    set_level(3);
    printf("%a %a %a %a %a %a\n", by_a_name_of_the_library(N), by_pure(N), by_const(N), by_word(N), by_body(N), by_library(N));
    return 0;
}
C
gcc -w -O2 -ffp-contract=off loops.c other.c -o original -lm
./original >expected

check() { # check NAME FLAGS...: in `parallel` the functions whose loops are to run in parallel
  "$ATTACK_REDCC" "$1.c" -o "$1-parallel.c" --report=json --report-file=report.json "${@:2}" 2>remarks
  found=$(jq -r '.loops[] | select(.verdict == "transformed").function' report.json | sort | paste -sd ' ')
  [ "$found" = "$parallel" ] || fail "$*: in parallel '$found', not '$parallel'"
  gcc -w -O2 -ffp-contract=off -Wl,-u,redcc_run -I"$ATTACK_INCLUDE" "$1-parallel.c" other.c "$ATTACK_LIBRARY" -o changed -lm
  for threads in 1 2 3 7; do
    REDCC_METHOD=localwrite OMP_NUM_THREADS=$threads OMP_WAIT_POLICY=passive ./changed | cmp -s - expected ||
      fail "$*: another program at $threads threads"
  done
}
parallel="by_body by_library"
check loops
"$ATTACK_REDCC" --analyze loops.c 2>remarks
for name in level_at scaled twice; do
  grep -q "R412: '$name' is declared pure or const, but its body is unknown" remarks || fail "no reason names $name"
done
grep -qF -- '--pure=NAME, or #pragma redcc pure(NAME)' remarks || fail "what a user can do is not said"
parallel="by_body by_library by_word"
check loops --pure=twice
sed '1i #pragma redcc pure(twice)' loops.c >said.c
check said
