/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Floating-point work in subscripts, in a function that is compiled with options of its own: two
// copies of the text may be rounded differently.
// covers: row 33 of docs/constructs.md
__attribute__((optimize("fast-math"))) void by_attribute(int n, double *h, const double *x) {
    for (int t = 0; t < n; t++) // EXPECT: refuse index-too-dear
        h[(int)(x[t] * 10.0 + x[t])] += 1;
}
