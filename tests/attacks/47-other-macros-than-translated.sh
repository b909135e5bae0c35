#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# A file is translated for one compilation, and compiled with other macros: a loop with conditional
# directives is then the loop that the source has there, statement for statement, OpenMP directives of
# its own included.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
cat >x.c <<'END'
#include <stdio.h>
enum { N = 5000, ROWS = 60 };
static int s[N + 1];
static long h[ROWS], g[ROWS];
#ifndef LIMIT
#define LIMIT 0
#endif
#define HERE __LINE__
static void lines(int n) {
    for (int t = 0; t < n; t++) {
#if HERE > LIMIT
        h[s[t]] += 1;
#elif HERE > LIMIT - 1 /*
        over two lines */
        h[s[t]] += 2;
#else
        h[s[t]] += 3;
#endif
#if HERE == LIMIT
        g[s[t]] += 1;
#endif
    }
}
static void sums(int n) {
    int done = 0;
    for (int t = 0; t < n; t++) {
#if defined(A) && defined(B)
        h[s[t]] += 1;
#elif defined(A)
        h[s[t]] += 10;
    }
    done++;
    for (int t = 0; t < n; t += 2) {
#else
#ifdef B
        h[s[t]] *= 3;
#endif
        h[s[t]] += 100;
#endif
        g[s[t]] -= 7;
    }
    if (n > 3)
#ifdef A
#pragma GCC unroll 2
#endif
        for (int t = 0; t < n; t++) {
#ifdef B
            h[s[t]] += 4;
#else
            h[s[t]] += 5;
#endif
        }
    else
        g[0] += done;
#ifdef B
#pragma omp parallel for
#endif
    for (int t = 0; t < n; t++) {
#ifdef B
#pragma omp atomic
#endif
        h[s[t]] += 2;
    } for (int t = 0; t < 2; t++) h[t] += __LINE__;
}
int main(void) {
    for (int t = 0; t <= N; t++)
        s[t] = t * 37 % ROWS;
    sums(N);
    lines(N);
    long hash = 0;
    for (int i = 0; i < ROWS; i++)
        hash = hash * 1000003 + h[i] * 31 + g[i];
    printf("%ld %ld %ld\n", hash, h[3], g[5]);
    return 0;
}
END
expected() { # FLAGS: what the source prints
    # shellcheck disable=SC2086
    gcc -O1 -w $1 x.c -o x
    OMP_NUM_THREADS=3 ./x
}
declare -A expected
for with in "" -DA -DB "-DA -DB"; do
    for openmp in -fopenmp -fno-openmp; do
        expected[$with $openmp]=$(expected "$with $openmp")
    done
done
line=$(grep -n '#if HERE >' x.c | cut -d : -f 1)
for more in -1 0 2 3 4 8; do
    with="-DLIMIT=$((line + more)) -fopenmp"
    expected[$with]=$(expected "$with")
done
for of in "" -DB "-DLIMIT=$line" "-DLIMIT=$((line + 4))"; do
    # shellcheck disable=SC2086
    "$ATTACK_REDCC" x.c -o y.c --report=json --report-file=report.json -- $of
    transformed=$(jq '[.loops[] | select(.verdict == "transformed")] | length' report.json)
    [ "$of" != "" ] || [ "$transformed" -eq 4 ] || {
        echo "$transformed loops are transformed" >&2
        exit 1
    }
    for with in "${!expected[@]}"; do
        [[ $of$with != -D*LIMIT*-DA* && $of$with != -D*LIMIT*-DB* && $of$with != -DB*LIMIT* ]] || continue
        # shellcheck disable=SC2086
        gcc -O1 -w $with -I"$ATTACK_INCLUDE" y.c "$ATTACK_LIBRARY" -o y -lm
        found=$(REDCC_METHOD=localwrite OMP_NUM_THREADS=3 ./y)
        [ "${expected[$with]}" = "$found" ] || {
            echo "translated with '$of', compiled with '$with': '$found', not '${expected[$with]}'" >&2
            exit 1
        }
    done
done
