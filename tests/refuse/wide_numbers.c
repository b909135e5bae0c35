/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// With this option long double has another format than in the runtime library.
// FLAGS: -mlong-double-128
void kernel(int n, const int *restrict s, long double *restrict h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse option
        h[s[t]] += 1;
}
