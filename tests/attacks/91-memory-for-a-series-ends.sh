#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# How many operands a sum in an inner loop has is not known before the loop; where memory ends in the
# midst of it, the elements are written already, and the sums must come out all the same.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cat >"$work/loop.c" <<'C'
#include <stdio.h>
enum { N = 30000, E = 64, P = 1800 };
static unsigned short k[N * E];
static double h[65536], x[65536];
struct { int pad; double potential; float narrow; } total;
int main(void) {
    double sum = 0.5, largest = 0;
    long pairs = 0;
    int last = -1;
    for (int t = 0; t < N * E; t++)
        k[t] = (unsigned short)(t / 37 + t % 64 * 5);
    for (int t = 0; t < 65536; t++)
        x[t] = 1.0 / (t + 3);
    for (int again = 0; again < 3; again++)
        for (int t = 0; t < N; t++) {
            for (int c = 0; c < E; c++) {
                const double d = x[k[t * E + c]] - 1e-4;
                if (d < 0)
                    continue;
                h[k[t * E + c]] += d;
                sum += d;
                total.potential += d * d;
                pairs++;
                last = t;
            }
            total.narrow += (float)x[t];
            if (x[k[t * E]] > largest)
                largest = x[k[t * E]];
        }
    for (int again = 0; again < 3; again++)
        for (int i = 0; i < P; i++)
            for (int j = i + 1; j < P; j++) {
                const double d = x[i] - x[j];
                h[i] += d;
                h[j] = h[j] * 0.5 - d;
                total.potential -= d * d;
            }
    double all = 0;
    for (int t = 0; t < 65536; t++)
        all = all * 1.25 + h[t];
    printf("%a %a %a %a %a %ld %d\n", all, sum, total.potential, (double)total.narrow, largest, pairs, last);
    return 0;
}
C
cd "$work"
"$ATTACK_REDCC" loop.c -o parallel.c --report=json --report-file=report.json -- -O2 >/dev/null 2>&1
jq -e '[.loops[] | select(.verdict == "transformed" and .line == 15)] | length == 1' report.json >/dev/null
gcc -O2 -ffp-contract=off loop.c -o sequential
gcc -O2 -ffp-contract=off -Wl,-u,redcc_run -I"$ATTACK_INCLUDE" parallel.c "$ATTACK_LIBRARY" -o parallel
./sequential >expected
for method in localwrite localwrite-direct localwrite-steal tiles wavefront graph-localwrite auto; do
    for limit in 4M 9M 20M 4G; do
        OMP_NUM_THREADS=3 REDCC_METHOD=$method REDCC_MEMORY_LIMIT=$limit REDCC_REPORT=run.json ./parallel >found
        cmp expected found || { echo "$method, $limit" >&2; exit 1; }
        [ "$method" != localwrite ] || [ "$limit" = 4M ] ||
            jq -e '.loops[] | select(.line == 15) | .method == "localwrite"' run.json >/dev/null ||
            { echo "$limit: not in parallel" >&2; exit 1; }
        [ "$method" != tiles ] || jq -e '.loops[] | select(.line == 31) | .method == "tiles"' run.json >/dev/null ||
            { echo "$limit: not in tiles" >&2; exit 1; }
    done
done
