/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "cloth.h"

#include <stdlib.h>
#include <string.h>

double random_number(unsigned *state) {
    *state = *state * 1664525u + 1013904223u;
    return (double)(*state >> 8) / (double)(1u << 23) - 1.0;
}

/* Writes the hinge of two triangles with a common edge. Returns 0 if they have none. */
static int common_edge(const int a[3], const int b[3], int hinge[4]) {
    for (int p = 0; p < 3; p++)
        for (int q = 0; q < 3; q++)
            if (a[p] == b[(q + 1) % 3] && a[(p + 1) % 3] == b[q]) {
                hinge[0] = a[p];
                hinge[1] = a[(p + 1) % 3];
                hinge[2] = a[(p + 2) % 3];
                hinge[3] = b[(q + 2) % 3];
                return 1;
            }
    return 0;
}

mesh cloth_of(int vertices, const double (*material)[2], int triangles, const int (*triangle)[3]) {
    mesh m = {.vertex_count = vertices, .triangle_count = triangles};
    m.position = calloc((size_t)vertices, sizeof *m.position);
    m.material = calloc((size_t)vertices, sizeof *m.material);
    m.triangle = calloc((size_t)triangles, sizeof *m.triangle);
    m.hinge = calloc((size_t)triangles * 2, sizeof *m.hinge);
    for (int i = 0; i < vertices; i++)
        for (int a = 0; a < 2; a++)
            m.position[i][a] = m.material[i][a] = material[i][a];
    memcpy(m.triangle, triangle, sizeof *triangle * (size_t)triangles);
    for (int s = 0; s < triangles; s++)
        for (int t = s + 1; t < triangles; t++)
            m.hinge_count += common_edge(triangle[s], triangle[t], m.hinge[m.hinge_count]);
    return m;
}

mesh cloth_sheet(int columns, int rows, double spacing, double jitter, unsigned seed) {
    const int vertices = columns * rows;
    double(*material)[2] = calloc((size_t)vertices, sizeof *material);
    int(*triangle)[3] = calloc((size_t)vertices * 2, sizeof *triangle);
    int *name = calloc((size_t)vertices, sizeof *name);
    int triangles = 0;
    for (int i = 0; i < vertices; i++) {
        const int other = (int)((random_number(&seed) + 1) / 2 * (i + 1));
        name[i] = name[other];
        name[other] = i;
    }
    for (int r = 0; r < rows; r++)
        for (int c = 0; c < columns; c++) {
            const int inner = r > 0 && c > 0 && r < rows - 1 && c < columns - 1;
            double *at = material[name[r * columns + c]];
            at[0] = spacing * (c + (inner ? jitter * random_number(&seed) : 0));
            at[1] = spacing * (r + (inner ? jitter * random_number(&seed) : 0));
        }
    for (int r = 0; r + 1 < rows; r++)
        for (int c = 0; c + 1 < columns; c++) {
            const int o = name[r * columns + c], p = name[r * columns + c + 1];
            const int q = name[(r + 1) * columns + c + 1], s = name[(r + 1) * columns + c];
            const int other_way = (r + c) % 2;
            const int first[3] = {o, p, other_way ? s : q};
            const int second[3] = {other_way ? p : o, q, s};
            memcpy(triangle[triangles++], first, sizeof first);
            memcpy(triangle[triangles++], second, sizeof second);
        }
    mesh m = cloth_of(vertices, (const double(*)[2])material, triangles, (const int(*)[3])triangle);
    free(material);
    free(triangle);
    free(name);
    return m;
}

void cloth_free(mesh *m) {
    free(m->position);
    free(m->material);
    free(m->triangle);
    free(m->hinge);
    *m = (mesh){0};
}

scene cloth_scene(void) {
    return (scene){.name = "test",
                   .material = {.density = 0.2,
                                .stretch = 100,
                                .shear = 30,
                                .bend = 1e-3,
                                .stretch_damping = 0.5,
                                .shear_damping = 0.1,
                                .bend_damping = 1e-5},
                   .surroundings.gravity = {0, 0, -9.81},
                   .time = {.step = 0.01, .steps = 10},
                   .solution = {.tolerance = 1e-10, .max_iterations = 10000},
                   .monitor = {.energy = 0.25, .growth = 0.5, .strain = 1, .penetration = 0.01}};
}

double (*cloth_moved(const mesh *m, double size, unsigned seed))[3] {
    double(*x)[3] = calloc((size_t)m->vertex_count, sizeof *x);
    for (int i = 0; i < m->vertex_count; i++)
        for (int a = 0; a < 3; a++)
            x[i][a] = m->position[i][a] + size * random_number(&seed);
    return x;
}

double hinge_energy(const hinge_elements *e, const hinge_material *material) {
    double sum = 0;
    for (int t = 0; t < e->count; t++)
        sum += e->weight[t] * e->angle[t] * e->angle[t];
    return material->bend * sum / 2;
}

void collisions_count(const collisions *c, long *contacts, long *sticking) {
    long all = 0, still = 0;
    for (int i = 0; c->before && i < c->mesh->vertex_count; i++)
        for (int n = 0; n < c->before[i].count; n++) {
            all++;
            still += c->before[i].list[n].sticks;
        }
    if (contacts)
        *contacts = all;
    if (sticking)
        *sticking = still;
}
