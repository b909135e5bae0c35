/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// The runtime's long double is another.
// FLAGS: -mlong-double-128
void kernel(int n, const int *restrict s, long double *restrict h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse option
        h[s[t]] += 1;
}
