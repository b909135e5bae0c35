/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Loops in other files that cannot be copied here: two files include the file, its text depends on
// its name, or it is a part of a function. Unused functions have no code to transform.
// covers: row 66 of docs/constructs.md
#include "included_function.h"
#include "included_source.inc"

void no_range(int n, const int *restrict s, double *restrict h) { // EXPECT: refuse no-range
    for (int t = 0; t < n; t++)
#include "included_body.h"
}

void whole(int n, const int *restrict s, double *restrict h) {
#include "included_whole.h"
}

static void (*const table[])(int, const int *restrict, double *restrict) = {in_a_table};

void caller(int n, const int *restrict s, double *restrict h) {
    in_a_header(n, s, h);
    table[n > 0](n, s, h);
    for (int t = 0; t < n; t *= 2) // EXPECT: refuse step
        h[s[t]]++;
}
