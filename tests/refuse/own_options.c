/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Subscripts computed in floating point, in a function with its own compiler options: two copies of
// the text may round differently.
// covers: row 33 of docs/constructs.md
__attribute__((optimize("fast-math"))) void by_attribute(int n, double *h, const double *x) {
    for (int t = 0; t < n; t++) // EXPECT: refuse index-too-dear
        h[(int)(x[t] * 10.0 + x[t])] += 1;
}
