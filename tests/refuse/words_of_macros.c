/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// A function-like macro named like a member of the runtime's structures that the generated text calls.
#define rows(t) k[t]

void histogram(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse text
        h[rows(t)] += 1.0;
}
