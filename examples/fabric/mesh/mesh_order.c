/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Renumbering a mesh: reverse Cuthill-McKee (George and Liu, Computer solution of large sparse
 * positive definite systems, 1981, chapter 4), random permutation, and the orders of mesh_curve.c
 * and mesh_dissection.c. */
#include "mesh.h"

#include <assert.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/arrays.h"
#include "base/random.h"
#include "mesh_parts.h"

enum { ERROR_SIZE = 256 };

/** Work arrays of the search for an order. */
typedef struct search {
    int *order;   /* vertices in the order they were reached */
    int *mark;    /* [vertex_count] number of the search that last reached the vertex */
    int *level;   /* [vertex_count] its distance from that search's root */
    int searches; /* number of searches so far */
} search;

static int compare_words(const int *a, const int *b, int count) {
    for (int k = 0; k < count; k++)
        if (a[k] != b[k])
            return a[k] < b[k] ? -1 : 1;
    return 0;
}

static int compare_2(const void *a, const void *b) {
    return compare_words(a, b, 2);
}

static int compare_3(const void *a, const void *b) {
    return compare_words(a, b, 3);
}

static int compare_4(const void *a, const void *b) {
    return compare_words(a, b, 4);
}

void mesh_sort_triangles(mesh *m) {
    for (int t = 0; t < m->triangle_count; t++) {
        const int *v = m->triangle[t];
        const int lowest = v[0] < v[1] ? (v[0] < v[2] ? 0 : 2) : (v[1] < v[2] ? 1 : 2);
        const int turned[3] = {v[lowest], v[(lowest + 1) % 3], v[(lowest + 2) % 3]};
        memcpy(m->triangle[t], turned, sizeof turned);
    }
    qsort(m->triangle, (size_t)m->triangle_count, sizeof *m->triangle, compare_3);
}

/** Makes the two vertices of each edge, and of each hinge's shared edge, ascend. Then sorts edges
 *  and hinges by their vertices. */
static void sort_edges(mesh *m) {
    for (int e = 0; e < m->edge_count; e++)
        if (m->edge[e][0] > m->edge[e][1]) {
            const int swap = m->edge[e][0];
            m->edge[e][0] = m->edge[e][1];
            m->edge[e][1] = swap;
        }
    for (int h = 0; h < m->hinge_count; h++)
        if (m->hinge[h][0] > m->hinge[h][1]) { /* rotated by 180 degrees, which keeps its angle */
            const int turned[4] = {m->hinge[h][1], m->hinge[h][0], m->hinge[h][3], m->hinge[h][2]};
            memcpy(m->hinge[h], turned, sizeof turned);
        }
    if (m->edge_count > 0)
        qsort(m->edge, (size_t)m->edge_count, sizeof *m->edge, compare_2);
    if (m->hinge_count > 0)
        qsort(m->hinge, (size_t)m->hinge_count, sizeof *m->hinge, compare_4);
}

int mesh_graph_make(mesh_graph *g, const mesh *m) {
    g->vertex_count = m->vertex_count;
    g->start = calloc((size_t)m->vertex_count + 1, sizeof *g->start);
    g->neighbour = malloc(6 * (size_t)m->triangle_count * sizeof *g->neighbour);
    if (!g->start || !g->neighbour)
        return -1;
    for (int t = 0; t < m->triangle_count; t++)
        for (int k = 0; k < 3; k++)
            g->start[m->triangle[t][k]] += 2;
    for (int v = 0, sum = 0; v <= m->vertex_count; v++) {
        sum += g->start[v];
        g->start[v] = sum;
    }
    for (int t = m->triangle_count - 1; t >= 0; t--)
        for (int k = 0; k < 3; k++) {
            const int v = m->triangle[t][k];
            g->neighbour[--g->start[v]] = m->triangle[t][(k + 1) % 3];
            g->neighbour[--g->start[v]] = m->triangle[t][(k + 2) % 3];
        }
    assert(g->start[0] == 0 && g->start[m->vertex_count] == 6 * m->triangle_count);
    return 0;
}

void mesh_graph_free(mesh_graph *g) {
    free(g->start);
    free(g->neighbour);
    *g = (mesh_graph){0};
}

static int degree(const mesh_graph *g, int v) {
    return g->start[v + 1] - g->start[v];
}

/** Insertion sort by degree: stable, and a vertex has few neighbours. */
static void sort_by_degree(const mesh_graph *g, int *vertices, int count) {
    for (int i = 1; i < count; i++) {
        const int moving = vertices[i];
        int k = i;
        for (; k > 0 && degree(g, vertices[k - 1]) > degree(g, moving); k--)
            vertices[k] = vertices[k - 1];
        vertices[k] = moving;
    }
}

/** Breadth-first search from the root, neighbours in ascending order of degree. Fills order[0 ..]
 *  with the root's connected component. Returns its number of vertices. */
static int cuthill_mckee(const mesh_graph *g, search *s, int *order, int root) {
    assert(root >= 0 && root < g->vertex_count);
    int reached = 1;
    s->searches++;
    order[0] = root;
    s->mark[root] = s->searches;
    s->level[root] = 0;
    for (int i = 0; i < reached; i++) {
        const int v = order[i], first = reached;
        for (int k = g->start[v]; k < g->start[v + 1]; k++) {
            const int w = g->neighbour[k];
            if (s->mark[w] == s->searches)
                continue;
            s->mark[w] = s->searches;
            s->level[w] = s->level[v] + 1;
            order[reached++] = w;
        }
        assert(reached <= g->vertex_count);
        sort_by_degree(g, order + first, reached - first);
    }
    return reached;
}

/** Fills order[0 ..] with the connected component of `start`, from a pseudo-peripheral root: the
 *  search is repeated from the last vertex reached until the number of levels does not grow. */
static int order_part(const mesh_graph *g, search *s, int *order, int start) {
    int count = cuthill_mckee(g, s, order, start), length = -1;
    while (s->level[order[count - 1]] > length) {
        length = s->level[order[count - 1]];
        count = cuthill_mckee(g, s, order, order[count - 1]);
    }
    return count;
}

static int sorted_order(const mesh *m, int *new_of_old) {
    mesh_graph g = {0};
    search s = {0};
    arrays own = {0};
    const size_t count = (size_t)m->vertex_count;
    int status = -1, done = 0;
    s.order = arrays_add(&own, count, sizeof *s.order);
    s.mark = arrays_add(&own, count, sizeof *s.mark);
    s.level = arrays_add(&own, count, sizeof *s.level);
    if (!own.failed && mesh_graph_make(&g, m) == 0) {
        for (int v = 0; v < m->vertex_count; v++)
            if (s.mark[v] == 0)
                done += order_part(&g, &s, s.order + done, v);
        assert(done == m->vertex_count); /* each vertex is in one component */
        for (int i = 0; i < m->vertex_count; i++)
            new_of_old[s.order[i]] =
                m->vertex_count - 1 - i; /* reversed: less fill-in, George 1971 */
        status = 0;
    }
    mesh_graph_free(&g);
    arrays_free(&own);
    return status;
}

/** A random permutation, by the Fisher-Yates shuffle. */
static void shuffled_order(int count, random_source *source, int *new_of_old) {
    for (int i = 0; i < count; i++)
        new_of_old[i] = i;
    for (int i = count - 1; i > 0; i--) {
        const int k = random_below(source, i + 1), swap = new_of_old[i];
        new_of_old[i] = new_of_old[k];
        new_of_old[k] = swap;
    }
}

static void shuffle_records(int *records, int count, int words, random_source *source) {
    int swap[4];
    const size_t size = (size_t)words * sizeof *records;
    for (int i = count - 1; i > 0; i--) {
        int *a = records + (ptrdiff_t)i * words;
        int *b = records + (ptrdiff_t)random_below(source, i + 1) * words;
        memcpy(swap, a, size);
        memcpy(a, b, size);
        memcpy(b, swap, size);
    }
}

static void rename_vertices(int *records, int words, const int *new_of_old) {
    for (int i = 0; i < words; i++)
        records[i] = new_of_old[records[i]];
}

static int move_vertices(mesh *m, const int *new_of_old) {
    double(*position)[3] = malloc((size_t)m->vertex_count * sizeof *position);
    double(*material)[2] = malloc((size_t)m->vertex_count * sizeof *material);
    int *number = m->number ? malloc((size_t)m->vertex_count * sizeof *number) : NULL;
    if (!position || !material || (m->number && !number)) {
        free(position);
        free(material);
        free(number);
        return -1;
    }
    for (int v = 0; v < m->vertex_count; v++) {
        memcpy(position[new_of_old[v]], m->position[v], sizeof *position);
        memcpy(material[new_of_old[v]], m->material[v], sizeof *material);
        if (number)
            number[new_of_old[v]] = m->number[v];
    }
    free(m->position);
    free(m->material);
    free(m->number);
    m->position = position;
    m->material = material;
    m->number = number;
    if (m->triangle_count > 0)
        rename_vertices(&m->triangle[0][0], 3 * m->triangle_count, new_of_old);
    if (m->edge_count > 0)
        rename_vertices(&m->edge[0][0], 2 * m->edge_count, new_of_old);
    if (m->hinge_count > 0)
        rename_vertices(&m->hinge[0][0], 4 * m->hinge_count, new_of_old);
    return 0;
}

static int find_order(const mesh *m, mesh_order order, random_source *source, int *new_of_old,
                      char *error) {
    switch (order) {
    case MESH_ORDER_SORTED:
        return sorted_order(m, new_of_old);
    case MESH_ORDER_HILBERT:
        return mesh_order_by_curve(m, new_of_old);
    case MESH_ORDER_DISSECTED:
        return mesh_order_by_dissection(m, new_of_old, error);
    case MESH_ORDER_SHUFFLED:
    case MESH_ORDER_GENERATED:
        break;
    }
    shuffled_order(m->vertex_count, source, new_of_old);
    return 0;
}

static int reorder(mesh *m, mesh_order order, unsigned seed, int *new_of_old, char *error) {
    random_source source = {seed};
    if (find_order(m, order, &source, new_of_old, error) != 0 || move_vertices(m, new_of_old) != 0)
        return -1;
    sort_edges(m);
    if (order != MESH_ORDER_SHUFFLED) {
        mesh_sort_triangles(m);
        return 0;
    }
    if (m->triangle_count > 0)
        shuffle_records(&m->triangle[0][0], m->triangle_count, 3, &source);
    if (m->edge_count > 0)
        shuffle_records(&m->edge[0][0], m->edge_count, 2, &source);
    if (m->hinge_count > 0)
        shuffle_records(&m->hinge[0][0], m->hinge_count, 4, &source);
    return 0;
}

int mesh_reorder(mesh *m, mesh_order order, unsigned seed, int *new_of_old, char *error) {
    if (order == MESH_ORDER_GENERATED) {
        for (int v = 0; new_of_old && v < m->vertex_count; v++)
            new_of_old[v] = v;
        return 0;
    }
    int *permutation = new_of_old;
    snprintf(error, ERROR_SIZE, "out of memory"); /* overwritten by other messages */
    if (!permutation)
        permutation = malloc((size_t)m->vertex_count * sizeof *permutation);
    const int status = permutation ? reorder(m, order, seed, permutation, error) : -1;
    if (!new_of_old)
        free(permutation);
    return status;
}

int mesh_renumber(mesh *m, const int *new_of_old, int back, char *error) {
    int status = -1;
    int *to = malloc((size_t)m->vertex_count * sizeof *to);
    char *taken = calloc((size_t)m->vertex_count, 1);
    snprintf(error, ERROR_SIZE, "out of memory");
    for (int v = 0; to && taken && v < m->vertex_count; v++) {
        const int w = new_of_old[v];
        if (w < 0 || w >= m->vertex_count || taken[w]) {
            snprintf(error, ERROR_SIZE, "no permutation of %d vertices: number %d, for vertex %d",
                     m->vertex_count, w, v);
            goto out;
        }
        taken[w] = 1;
        to[back ? w : v] = back ? v : w;
    }
    if (to && taken && move_vertices(m, to) == 0) {
        sort_edges(m);
        mesh_sort_triangles(m);
        status = 0;
    }
out:
    free(to);
    free(taken);
    return status;
}
