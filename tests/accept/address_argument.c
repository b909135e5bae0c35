/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// An element's address is passed as an argument: &e->rest[t] reads the pointer e->rest in every iteration.
// covers: row 17, row 45 of docs/constructs.md
#include "case.h"

enum { N = 9000, M = 700 };

struct rest {
    double area, slope[3];
};
struct elements {
    int count;
    int (*vertex)[3];
    struct rest *rest;
};
static int vertex[N][3];
static struct rest rest[N];
static double b[M][3];

static void force(const struct rest *r, double scale, double f[3]) {
    const double weight = scale * r->area;
    for (int c = 0; c < 3; c++)
        f[c] = weight * r->slope[c];
}

static void forces(const struct elements *e, double scale, double (*to)[3]) {
    double f[3];
    int t, k, c;
    for (t = 0; t < e->count; t++) { // EXPECT: transformed
        force(&e->rest[t], scale, f);
        for (k = 0; k < 3; k++)
            for (c = 0; c < 3; c++)
                to[e->vertex[t][k]][c] += f[c];
    }
}

int main(void) {
    const struct elements e = {N, vertex, rest};
    case_near_subscripts(&vertex[0][0], 3 * N, M);
    case_values(&rest[0].area, 4 * N);
    for (int round = 0; round < 3; round++) {
        forces(&e, 1.0 + round, b);
        CASE_PRINT(b);
    }
    return 0;
}
