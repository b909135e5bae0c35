/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* C89, for check-quiet: vectors, masks, gathers, and inner loops that clang does not unroll
 * although a pragma requests it. */
struct node {
    double at[3];
    int kind;
};

static double weight_of(double v) {
    return v < 0.5 ? v * 2 : v + 1;
}

void forces(int n, const int (*edge)[2], const struct node *x, double (*b)[3]);
void forces(int n, const int (*edge)[2], const struct node *x, double (*b)[3]) {
    int t, c;
    double d[3], length;
    for (t = 0; t < n; t++) {
        const int i = edge[t][0], j = edge[t][1];
        length = 0;
        for (c = 0; c < 3; c++) {
            d[c] = x[j].at[c] - x[i].at[c];
            length += d[c] * d[c];
        }
        if (length > 0.25)
            length = weight_of(length) + x[i].kind;
        for (c = 0; c < 3; c++) {
            b[i][c] += d[c] * length;
            b[j][c] -= d[c] * length;
        }
    }
}
