/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Arrays of structures, structures of arrays, and pointers in structures.
// covers: row 45, row 46, row 50 of docs/constructs.md
#include "case.h"

enum { N = 16000, M = 1100 };

struct particle {
    double mass;
    double force[3];
    int neighbours;
};

struct edge {
    int from, to;
    double stiffness;
};

struct field {
    int size;
    double *fx, *fy;
    const int *cell;
    struct {
        double *density;
    } grid;
};

static struct particle particles[M];
static struct edge edges[N];
static double fx[M], fy[M], density[M];
static int cell[N];

static void pull(struct particle *p, const struct edge *e, int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int i = e[t].from, j = e[t].to;
        const double f = e[t].stiffness * (p[i].mass - p[j].mass);
        p[i].force[0] += f;
        p[i].force[2] += f * f;
        p[j].force[0] -= f;
    }
}

static void count(struct particle *p, const struct edge *e, int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        p[e[t].from].neighbours++;
        p[e[t].to].neighbours++;
    }
}

static void deposit(struct field *s, const double *w, int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        int c = s->cell[t];
        s->fx[c] += w[t];
        s->fy[c] -= 0.5 * w[t];
        s->grid.density[c] += 1.0;
    }
}

int main(void) {
    static double w[N];
    struct field f = {M, fx, fy, cell, {density}};
    case_values(w, N);
    for (int i = 0; i < M; i++)
        particles[i] = (struct particle){.mass = case_value()};
    for (int round = 0; round < 3; round++) {
        for (int t = 0; t < N; t++) {
            edges[t].from = case_below(M);
            edges[t].to = (edges[t].from + case_below(M - 1) + 1) % M;
            edges[t].stiffness = case_value();
        }
        case_near_subscripts(cell, N, M);
        pull(particles, edges, N);
        count(particles, edges, N);
        deposit(&f, w, N);
        for (int i = 0; i < M; i++) {
            static double last[5];
            for (int c = 0; c < 3; c++)
                last[c] = last[c] * 0.5 + particles[i].force[c];
            last[3] += particles[i].neighbours;
            if (i == M - 1)
                CASE_PRINT(last);
        }
        case_print("all", particles, sizeof particles);
        CASE_PRINT(fx);
        CASE_PRINT(fy);
        CASE_PRINT(density);
    }
    return 0;
}
