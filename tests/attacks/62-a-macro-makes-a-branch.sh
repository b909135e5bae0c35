#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# One macro makes a variable and the branch that assigns it: some lanes alone assign it.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
cat >x.c <<'END'
#include <math.h>
#include <stdio.h>
#define N 4096
#define PART static double part(double r, double q) { double s = 1.0; if (r < 2.0) { s = 3.0 + r; } return s * q; }
PART
#define BELOW_ONE double z = 1.0; if (d < 1.0) { z = 0.25; }
static double x[N][3], h[N];
static int k[N][2];
static void sums(int n) {
    for (int t = 0; t < n; t++) {
        const int i = k[t][0], j = k[t][1];
        double d = 0, s = 1.0;
        for (int c = 0; c < 3; c++)
            d += (x[i][c] - x[j][c]) * (x[i][c] - x[j][c]);
        BELOW_ONE
        const double g = part(d, s) * z / (1.0 + d) + sqrt(d) / (2 + s) + sqrt(s + d);
        h[i] += g;
        h[j] -= g;
    }
}
int main(void) {
    for (int t = 0; t < N; t++) {
        for (int c = 0; c < 3; c++)
            x[t][c] = (t * 37 + c * 11) % 101 / 50.0;
        k[t][0] = t * 7919 % N;
        k[t][1] = (t * 31 + 7) % N;
    }
    for (int round = 0; round < 30; round++)
        sums(N);
    for (int t = 0; t < N; t++)
        printf("%a\n", h[t]);
    return 0;
}
END
"$ATTACK_REDCC" --lanes=4 x.c -o y.c
grep -q redcc_select y.c
gcc -O2 -w x.c -o x -lm
gcc -O2 -w -Wl,-u,redcc_run -I"$ATTACK_INCLUDE" y.c "$ATTACK_LIBRARY" -o y -lm
./x >expected
for lanes in auto off; do
    REDCC_LANES=$lanes REDCC_METHOD=localwrite OMP_NUM_THREADS=1 ./y >found
    cmp expected found
done
