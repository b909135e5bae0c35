#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# A caller in another file looks at errno when the loop is done: what other threads' calls of
# mathematical functions leave in it must be there, and nothing else.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
cat >loops.c <<'END'
#include <math.h>
enum { N = 20000, BINS = 300 };
extern double x[N], sums[BINS];
extern int k[N];
void roots(void) {
    for (int t = 0; t < N; t++)
        sums[k[t]] += sqrt(x[t]);
}
void powers(void) {
    for (int t = 0; t < N; t++)
        sums[k[t]] += exp(x[t]) * 1e-300;
}
/* where it fails nothing is updated */
void filtered(void) {
    for (int t = 0; t < N; t++) {
        double v = log(x[t]);
        if (x[t] > 0)
            sums[k[t]] += v;
    }
}
/* pairs of blocks, of which a thread leaves out those that it updates nothing of */
double f[N];
void blocks(void) {
    for (int b = 0; b < 200; b++)
        for (int q = 0; q < 3; q++) {
            int o = k[3 * b + q] % 200;
            for (int i = 8 * b; i < 8 * b + 8; i++)
                for (int j = 8 * o; j < 8 * o + 8; j++) {
                    double v = log(x[i]) * 0.5 + x[j] * 0.25 + x[i] * x[j];
                    if (x[i] > 0) {
                        f[i] += v;
                        f[j] -= v;
                    }
                }
        }
}
END
cat >main.c <<'END'
#include <errno.h>
#include <stdio.h>
enum { N = 20000, BINS = 300 };
double x[N], sums[BINS];
int k[N];
void roots(void);
void powers(void);
void filtered(void);
void blocks(void);
static void show(const char *name, void (*loop)(void), int before, int at, double value) {
    for (int t = 0; t < N; t++)
        x[t] = 1 + t % 7;
    if (at >= 0)
        x[at] = value;
    errno = before;
    loop();
    printf("%s %d %d: %d\n", name, before, at, errno);
    for (int i = 0; i < BINS; i++)
        sums[i] = 0;
}
int main(void) {
    for (int t = 0; t < N; t++)
        k[t] = (int)(t * 7919LL % BINS);
    for (int round = 0; round < 3; round++)
        for (int before = 0; before < 3; before++) {
            static const int places[] = {-1, 0, 5, N / 25, N / 3, N - 1};
            for (int i = 0; i < 6; i++) {
                show("sqrt", roots, before, places[i], -1.0);
                show("exp", powers, before, places[i], 1e6);
                show("log", filtered, before, places[i], -1.0);
                show("blocks", blocks, before, places[i], -1.0);
                show("log of 0", filtered, before, places[i], 0.0);
            }
        }
    return 0;
}
END
fail() { echo "$*" >&2; exit 1; }
"$ATTACK_REDCC" loops.c -o parallel.c --report=json --report-file=report.json -- -O2
[ "$(jq -r '[.loops[].verdict] | join(" ")' report.json)" = "transformed transformed transformed transformed" ] ||
    fail "loops with mathematical functions are not translated"
cc -w -O2 -ffp-contract=off main.c loops.c -lm -o sequential
cc -w -O2 -ffp-contract=off -Wl,-u,redcc_run -idirafter "$ATTACK_INCLUDE" main.c parallel.c "$ATTACK_LIBRARY" -lm -o parallel
./sequential >expected
for threads in 1 2 3 7; do
    for method in auto localwrite localwrite-steal localwrite-direct; do
        REDCC_METHOD=$method OMP_NUM_THREADS=$threads ./parallel >found
        cmp expected found || fail "$method, $threads threads: another errno: $(diff expected found | head -n 4)"
    done
done
# a file that looks at errno itself is left alone, wherever it does
sed -i '1i#include <errno.h>\nint look(void) { return errno; }' loops.c
"$ATTACK_REDCC" --analyze loops.c --report=json -- -O2 >report.json
[ "$(jq -r '[.loops[:3][].reason.slug] | join(" ")' report.json)" = "errno errno errno" ] || fail "errno is read"
"$ATTACK_REDCC" --analyze loops.c --report=json -- -O2 -fno-math-errno >report.json
[ "$(jq -r '[.loops[].verdict] | join(" ")' report.json)" = "transformed transformed transformed transformed" ] ||
    fail "-fno-math-errno"
