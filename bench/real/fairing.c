/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Fairing of a scanned surface: mean curvature flow removes noise from a triangle mesh.
 *
 *   fairing LEVELS STEPS >surface
 *
 * An icosahedron, whose triangles are cut into four LEVELS times, becomes a sphere of 10 * 4^LEVELS
 * + 2 vertices, numbered in the order of their creation. Bumps and noise are added. Each step
 * visits every triangle. It adds the cotangents of the triangle's angles times its edges to the
 * curvature normals of its vertices, and a third of its area to the vertices' areas. Then the step
 * moves each vertex along its normal, as far as is stable. Scaling restores lost volume. Every
 * tenth step prints area and volume. At the end the program prints some of the vertices.
 *
 * M. Desbrun, M. Meyer, P. Schroeder, A. H. Barr: Implicit Fairing of Irregular Meshes using
 * Diffusion and Curvature Flow, SIGGRAPH 1999, equations 14 and 10. U. Pinkall, K. Polthier,
 * Experiment. Math. 2 (1993) 15.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct vector {
    double x, y, z;
} vector;

typedef struct mesh {
    int vertices, triangles;
    vector *position, *normal; /* normal: curvature normal times area */
    double *area;
    int (*triangle)[3];
} mesh;

static void *allocate(size_t count, size_t size) {
    void *memory = calloc(count, size);
    if (!memory) {
        fprintf(stderr, "fairing: out of memory\n");
        exit(1);
    }
    return memory;
}

static vector sub(vector a, vector b) {
    return (vector){a.x - b.x, a.y - b.y, a.z - b.z};
}

static double dot(vector a, vector b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static vector cross(vector a, vector b) {
    return (vector){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static vector scaled(double s, vector a) {
    return (vector){s * a.x, s * a.y, s * a.z};
}

/* ---- the mesh ------------------------------------------------------------------------------- */

typedef struct midpoint {
    int low, high, vertex; /* vertex: made from edge low-high; -1 if the entry is free */
} midpoint;

/* Returns the vertex in the middle of the edge a-b, projected onto the unit sphere; creates it if
 * it does not exist yet. The hash table `table` has the vertices that exist. */
static int middle(mesh *m, midpoint *table, unsigned size, int a, int b) {
    const int low = a < b ? a : b, high = a < b ? b : a;
    unsigned at = ((unsigned)low * 2654435761u ^ (unsigned)high * 40503u) & (size - 1);
    while (table[at].vertex >= 0 && (table[at].low != low || table[at].high != high))
        at = (at + 1) & (size - 1);
    if (table[at].vertex < 0) {
        const vector p = m->position[a], q = m->position[b];
        const vector sum = {p.x + q.x, p.y + q.y, p.z + q.z};
        table[at] = (midpoint){low, high, m->vertices};
        m->position[m->vertices++] = scaled(1.0 / sqrt(dot(sum, sum)), sum);
    }
    return table[at].vertex;
}

static void subdivide(mesh *m) {
    unsigned size = 1;
    while (size < 4u * (unsigned)m->triangles)
        size *= 2;
    midpoint *table = allocate(size, sizeof *table);
    int(*finer)[3] = allocate(4 * (size_t)m->triangles, sizeof *finer), n = 0;
    memset(table, -1, size * sizeof *table);
    for (int t = 0; t < m->triangles; t++) {
        const int *v = m->triangle[t];
        const int ab = middle(m, table, size, v[0], v[1]), bc = middle(m, table, size, v[1], v[2]),
                  ca = middle(m, table, size, v[2], v[0]);
        const int parts[4][3] = {{v[0], ab, ca}, {ab, v[1], bc}, {ca, bc, v[2]}, {ab, bc, ca}};
        memcpy(finer[n], parts, sizeof parts);
        n += 4;
    }
    free(table);
    free(m->triangle);
    m->triangle = finer;
    m->triangles = n;
}

/* Returns a random number, uniform in (-1/2, 1/2), by Park and Miller's minimal standard
 * generator. */
static double uniform(void) {
    static long seed = 20011;
    seed = seed * 16807 % 2147483647;
    return (double)seed / 2147483647.0 - 0.5;
}

static void make_surface(mesh *m, int levels) {
    static const int faces[20][3] = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                     {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                     {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                     {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    const double g = 0.5 * (1 + sqrt(5.0)), r = 1 / sqrt(1 + g * g);
    const vector corners[12] = {{-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0},
                                {0, -1, g}, {0, 1, g}, {0, -1, -g}, {0, 1, -g},
                                {g, 0, -1}, {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}};
    const size_t most = 10 * ((size_t)1 << 2 * levels) + 2;
    m->position = allocate(most, sizeof *m->position);
    m->normal = allocate(most, sizeof *m->normal);
    m->area = allocate(most, sizeof *m->area);
    m->triangle = allocate(20, sizeof *m->triangle);
    memcpy(m->triangle, faces, sizeof faces);
    m->triangles = 20;
    for (int i = 0; i < 12; i++)
        m->position[m->vertices++] = scaled(r, corners[i]);
    for (int i = 0; i < levels; i++)
        subdivide(m);
    const double noise = 0.4 / (1 << levels);
    for (int i = 0; i < m->vertices; i++) {
        const vector p = m->position[i];
        const double bump = 0.15 * sin(5 * p.x) * cos(4 * p.y + p.z);
        m->position[i] = scaled(1 + bump + noise * uniform(), p);
    }
}

/* ---- the flow ------------------------------------------------------------------------------- */

/* Computes the cotangents of the angles at the three corners. Returns the area. */
static double cotangents(const vector p[3], double cot[3]) {
    const vector n = cross(sub(p[1], p[0]), sub(p[2], p[0]));
    const double twice = sqrt(dot(n, n));
    for (int c = 0; c < 3; c++) {
        const vector e = sub(p[(c + 1) % 3], p[c]), f = sub(p[(c + 2) % 3], p[c]);
        cot[c] = dot(e, f) / twice;
    }
    return 0.5 * twice;
}

static void add(vector *to, double s, vector v) {
    to->x += s * v.x;
    to->y += s * v.y;
    to->z += s * v.z;
}

static double curvature_normals(mesh *m) {
    double whole = 0;
    memset(m->normal, 0, (size_t)m->vertices * sizeof *m->normal);
    memset(m->area, 0, (size_t)m->vertices * sizeof *m->area);
    for (int t = 0; t < m->triangles; t++) {
        const int *v = m->triangle[t];
        const vector p[3] = {m->position[v[0]], m->position[v[1]], m->position[v[2]]};
        double cot[3];
        const double area = cotangents(p, cot);
        for (int c = 0; c < 3; c++) { /* the edge opposite corner c */
            const int a = (c + 1) % 3, b = (c + 2) % 3;
            const vector edge = sub(p[b], p[a]);
            add(&m->normal[v[a]], 0.5 * cot[c], edge);
            add(&m->normal[v[b]], -0.5 * cot[c], edge);
            m->area[v[c]] += area / 3;
        }
        whole += area;
    }
    return whole;
}

static double volume(const mesh *m) {
    double six = 0;
    for (int t = 0; t < m->triangles; t++) {
        const int *v = m->triangle[t];
        six += dot(m->position[v[0]], cross(m->position[v[1]], m->position[v[2]]));
    }
    return six / 6;
}

static void move(mesh *m, double dt) {
    for (int i = 0; i < m->vertices; i++)
        add(&m->position[i], dt / m->area[i], m->normal[i]);
}

static void scale(mesh *m, double s) {
    for (int i = 0; i < m->vertices; i++)
        m->position[i] = scaled(s, m->position[i]);
}

int main(int argc, char **argv) {
    if (argc != 3 || atoi(argv[1]) < 2 || atoi(argv[1]) > 10 || atoi(argv[2]) < 1) {
        fprintf(stderr, "usage: fairing LEVELS (2 to 10) STEPS\n");
        return 2;
    }
    static mesh m;
    const int steps = atoi(argv[2]);
    make_surface(&m, atoi(argv[1]));
    const double start = volume(&m);
    double dt = 0;
    for (int step = 0; step < steps; step++) {
        const double whole = curvature_normals(&m);
        if (step == 0) /* explicit steps are stable up to about half the squared edge length */
            dt = 0.15 * whole / m.triangles;
        move(&m, dt);
        if (step % 10 == 9) {
            scale(&m, cbrt(start / volume(&m)));
            printf("%6d %.17g %.17g\n", step + 1, whole, volume(&m));
        }
    }
    for (int i = 0; i < m.vertices; i += 1 + m.vertices / 5000)
        printf("%.17g %.17g %.17g\n", m.position[i].x, m.position[i].y, m.position[i].z);
    return 0;
}
