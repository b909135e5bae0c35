/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// With this option the structures of the runtime's header would have another layout than in its library.
// FLAGS: -fpack-struct=4
void kernel(int n, const int *restrict s, double *restrict h, const double *e) {
    for (int t = 0; t < n; t++) // EXPECT: refuse option
        h[s[t]] += e[t];
}
