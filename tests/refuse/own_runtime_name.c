/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// A type whose name the runtime's header declares as well.
// covers: row 68 of docs/constructs.md
typedef short redcc_int;

void kernel(int n, const redcc_int *restrict s, double *restrict h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse text
        h[s[t]] += 1;
}
