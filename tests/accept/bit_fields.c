/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Bit-fields have no address. If the loop reads one, the guard records the enclosing structure.
// covers: row 43 of docs/constructs.md
#include "case.h"

enum { N = 9000 };

struct edge {
    unsigned from : 9;
    int weight : 7;
    unsigned to : 9;
};

static struct edge edges[N];
static struct wide {
    struct edge of;
    double length;
} beside[N];
static double h[512], g[512];

static void pointer(int n, const struct edge *e, double *b) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        b[e[t].from] += e[t].weight;
        b[e[t].to] -= 1;
    }
}

static void nested(int n, const struct wide *e, double *b) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        b[e[t].of.from] += e[t].length;
}

int main(void) {
    for (int t = 0; t < N; t++) {
        edges[t] = (struct edge){(unsigned)t * 37 % 500, t % 50 - 20, (unsigned)t * 91 % 500};
        beside[t] = (struct wide){edges[t], case_value()};
    }
    pointer(N, edges, h);
    nested(N, beside, g);
    edges[3].from = 499; /* the plan of the last call must not be reused */
    pointer(N, edges, h);
    case_print("h", h, sizeof h);
    case_print("g", g, sizeof g);
    return 0;
}
