#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# A conversion that the program makes under a condition alone ends it, where the sanitizer is on and the value is
# outside of the integer's range: lanes may not make it for all iterations.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
cat >x.c <<'END'
#include <math.h>
#include <stdio.h>
#define N 4096
static double x[N][3], h[N];
static int k[N][2];
static void sums(int n, double q) {
    for (int t = 0; t < n; t++) {
        const int i = k[t][0], j = k[t][1];
        double r = 0, z = 1.0;
        for (int c = 0; c < 3; c++)
            r += (x[i][c] - x[j][c]) * (x[i][c] - x[j][c]);
        if (r < -1.0 && (int)q > 3)
            z = 2.0;
        const double w = r < -1.0 ? 1.0 + (double)(int)q : 2.0;
        const double g = z * w / (1.0 + r) + sqrt(r) / (2 + r) + sqrt(3 + r) / sqrt(z + r);
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
        sums(N, 1e30);
    for (int t = 0; t < N; t++)
        printf("%a\n", h[t]);
    return 0;
}
END
checks="-fsanitize=float-cast-overflow -fno-sanitize-recover=all"
"$ATTACK_REDCC" --lanes=4 x.c -o y.c
# shellcheck disable=SC2086
gcc -O2 -w $checks x.c -o x -lm
# shellcheck disable=SC2086
gcc -O2 -w $checks -Wl,-u,redcc_run -I"$ATTACK_INCLUDE" y.c "$ATTACK_LIBRARY" -o y -lm
./x >expected
for lanes in auto off; do
    REDCC_LANES=$lanes REDCC_METHOD=localwrite OMP_NUM_THREADS=1 ./y >found
    cmp expected found
done
