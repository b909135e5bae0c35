/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* One thread: enough executions for auto to construct a plan, and their results. */
#include <math.h>
#include <stdio.h>

enum { NODES = 4000, EDGES = 30000, CALLS = 300 };

static int edge[EDGES][2];
static double x[NODES][3], force[NODES][3];

static void pull(int count, const int (*edge)[2], const double (*x)[3], double (*force)[3]) {
    for (int t = 0; t < count; t++) {
        const int i = edge[t][0], j = edge[t][1];
        double d[3];
        for (int c = 0; c < 3; c++)
            d[c] = x[j][c] - x[i][c];
        const double length = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2] + 0.01);
        const double bent = sqrt(1.0 + d[0] * d[1] / length);
        double stiff = 1.0;
        for (int step = 0; step < 8; step++)
            stiff = 0.5 * stiff + bent / (stiff + length);
        const double strength = 80.0 * stiff * (length - 0.5) / (length * bent);
        for (int c = 0; c < 3; c++) {
            force[i][c] += strength * d[c];
            force[j][c] -= strength * d[c];
        }
    }
}

int main(void) {
    unsigned random = 12345;
    for (int i = 0; i < NODES; i++)
        for (int c = 0; c < 3; c++) {
            random = random * 1664525u + 1013904223u;
            x[i][c] = (double)(random >> 8) / (1 << 24);
        }
    for (int t = 0; t < EDGES; t++) {
        edge[t][0] = (int)((long)t * NODES / EDGES);
        random = random * 1664525u + 1013904223u;
        edge[t][1] = (int)((edge[t][0] + 1 + (random >> 8) % 50) % NODES);
    }
    for (int call = 0; call < CALLS; call++)
        pull(EDGES, edge, x, force);
    for (int i = 0; i < NODES; i++)
        printf("%a %a %a\n", force[i][0], force[i][1], force[i][2]);
    return 0;
}
