#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# ELF lets a program replace what a shared object exports: the body that is seen in the object's
# source is not the one that runs. gcc honours that with -fPIC.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
cat >object.c <<'END'
int h[400];
double value(double v) { return v * 0.5; }
double other(double v);
__attribute__((visibility("hidden"))) double hidden(double v) { return v * 0.5; }
__attribute__((visibility("protected"))) double kept(double v) { return v * 0.5; }
static double own(double v) { return v * 0.5; }
inline double inlined(double v) { return v * 0.5; }
static double through(double v) { return value(v) + 1; }
#pragma GCC visibility push(hidden)
double by_pragma(double v) { return v * 0.5; }
#pragma GCC visibility pop
double other(double v) { return v + 1; }

void run(int n, const int *s, const double *restrict x, double *restrict y) {
    for (int t = 0; t < n; t++) // 1: replaced
        y[s[t]] += value(x[t]);
    for (int t = 0; t < n; t++) // 2: replaced, declared before
        y[s[t]] += other(x[t]);
    for (int t = 0; t < n; t++) // 3: replaced, called by a function of the file
        y[s[t]] += through(x[t]);
    for (int t = 0; t < n; t++) // 4: not to be replaced
        y[s[t]] += hidden(x[t]) + own(x[t]) + kept(x[t]) + by_pragma(x[t]) + inlined(x[t]);
}
END
cat >main.c <<'END'
#include <stdio.h>
#include <string.h>
void run(int n, const int *s, const double *x, double *y);
enum { N = 20000, BINS = 400 };
static double x[N], y[BINS];
static int s[N];
int calls;
double value(double v) { calls++; return v + y[calls % BINS] * 1e-3; }
double other(double v) { calls += 3; return v + calls; }
int main(void) {
    for (int t = 0; t < N; t++) { s[t] = t * 7 % BINS; x[t] = t; }
    for (int round = 0; round < 3; round++) run(N, s, x, y);
    double sum = 0;
    for (int i = 0; i < BINS; i++) sum = sum * 0.99 + y[i];
    printf("%a %d\n", sum, calls);
    return 0;
}
END
fail() { echo "$*" >&2; exit 1; }
verdicts() {
    "$ATTACK_REDCC" --analyze object.c --report=json "$@" |
        jq -r '[.loops[] | if .verdict == "transformed" then "+" else .reason.slug end] | join(" ")'
}
expect() { # WORDS FLAGS
    local wanted=$1 found
    shift
    found=$(verdicts -- -O2 "$@")
    [ "$found" = "$wanted" ] || fail "-- $*: expected '$wanted', found '$found'"
    jq -n --arg folder "$work" '[{directory: $folder, file: "object.c",
        arguments: (["gcc", "-O2"] + $ARGS.positional + ["-c", "object.c", "-o", "x.o"])}]' \
        --args -- "$@" >compile_commands.json
    found=$(verdicts -p .)
    [ "$found" = "$wanted" ] || fail "-p $*: expected '$wanted', found '$found'"
}
all="+ + + +" some="interposed interposed interposed +"
expect "$all" -O1
expect "$all" -fPIE
expect "$all" -fPIC -fvisibility=hidden
expect "$all" -fPIC -fno-semantic-interposition
expect "$all" -fPIC -fPIE
expect "$all" -fpic -fvisibility=protected
expect "$some" -fPIC
expect "$some" -fpic
expect "$some" -fPIE -fPIC
expect "$some" -fPIC -fno-semantic-interposition -fsemantic-interposition
expect "$some" -fPIC -fvisibility=hidden -fvisibility=default

"$ATTACK_REDCC" object.c -o parallel.c -- -O2 -fPIC 2>remarks
for form in object parallel; do
    cc -w -O2 -fPIC -ffp-contract=off -Wl,-u,redcc_run -idirafter "$ATTACK_INCLUDE" -shared $form.c "$ATTACK_LIBRARY" -o lib$form.so
    cc -w -O2 main.c ./lib$form.so -Wl,-u,redcc_run -lm -o $form
done
./object >expected
for threads in 1 2 3 7; do
    for method in auto localwrite localwrite-steal; do
        REDCC_METHOD=$method OMP_NUM_THREADS=$threads ./parallel >found
        cmp expected found || fail "$method, $threads threads: another program"
    done
done
