/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// gcc stores this record's members in big-endian order; clang ignores the attribute.
struct __attribute__((scalar_storage_order("big-endian"))) record {
    int count;
};

void counted(int n, const int *k, struct record *restrict r) {
    for (int t = 0; t < n; t++) // EXPECT: refuse compiler
        r[k[t]].count += 1;
}

void looked_up(int n, const struct record *k, int *restrict h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse compiler
        h[k[t].count] += 1;
}
