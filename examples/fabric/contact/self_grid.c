/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Finds the triangles that may meet: their swept boxes are sorted into the cells of a grid. */
#include <assert.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "base/arrays.h"
#include "base/vector.h"
#include "self_collision.h"

/** A triangle in a cell. Several cells may hash to one bucket. */
typedef struct self_entry {
    int cell[3];
    int triangle, bucket;
} self_entry;

/* maximum average number of cells per triangle; beyond it cells are made larger */
enum { MOST_CELLS_EACH = 16 };

/* Like fmin and fmax, for arguments that are not NaN, but without a function call. */
static inline double least(double a, double b) {
    return b < a ? b : a;
}

static inline double most(double a, double b) {
    return b > a ? b : a;
}

static void sweep(self_collision *s, double h, const double (*x)[3], const double (*v)[3]) {
    const mesh *m = s->mesh;
#pragma omp parallel for schedule(static)
    for (int t = 0; t < m->triangle_count; t++)
        for (int a = 0; a < 3; a++) {
            double low = INFINITY, high = -INFINITY;
            for (int p = 0; p < 3; p++) {
                const int i = m->triangle[t][p];
                const double end = x[i][a] + h * v[i][a];
                low = least(low, least(x[i][a], end));
                high = most(high, most(x[i][a], end));
            }
            s->grid.box[t][0][a] = low - s->gap;
            s->grid.box[t][1][a] = high + s->gap;
        }
}

/* Mean extent of the cloth's triangles, m. */
static double mean_extent(const self_collision *s) {
    double sum = 0;
    for (int t = 0; t < s->bodies_from; t++)
        for (int a = 0; a < 3; a++)
            sum += s->grid.box[t][1][a] - s->grid.box[t][0][a];
    return sum / (3.0 * s->bodies_from);
}

/* If there are bodies, computes the box around all that the cloth sweeps. Bodies' triangles outside
 * of this box get no cell. */
static void bound_cloth(self_collision *s) {
    for (int a = 0; a < 3; a++) {
        s->grid.cloth[0][a] = INFINITY;
        s->grid.cloth[1][a] = -INFINITY;
    }
    for (int t = 0; t < s->bodies_from && s->bodies_from < s->mesh->triangle_count; t++)
        for (int a = 0; a < 3; a++) {
            s->grid.cloth[0][a] = least(s->grid.cloth[0][a], s->grid.box[t][0][a]);
            s->grid.cloth[1][a] = most(s->grid.cloth[1][a], s->grid.box[t][1][a]);
        }
}

static int is_far(const self_collision *s, int t) {
    for (int a = 0; a < 3 && t >= s->bodies_from; a++)
        if (s->grid.box[t][0][a] > s->grid.cloth[1][a] ||
            s->grid.box[t][1][a] < s->grid.cloth[0][a])
            return 1;
    return 0;
}

/* Returns the index of the cell that contains a coordinate; all coordinates far away share one
 * cell. */
static int cell_of(double at, double size) {
    const double cell = floor(at / size);
    return cell > 1e9 ? 1000000000 : (cell < -1e9 ? -1000000000 : (int)cell);
}

static unsigned bucket_of(const int cell[3], unsigned buckets) {
    assert(buckets > 0 && (buckets & (buckets - 1)) == 0);
    const unsigned key = (unsigned)cell[0] * 73856093u ^ (unsigned)cell[1] * 19349663u ^
                         (unsigned)cell[2] * 83492791u;
    return (key ^ key >> 15) & (buckets - 1);
}

/* Finds the cells of a triangle's box, from `low` to `high`. Returns their number, 0 for a body's
 * triangle that the cloth does not reach. */
static double cells_of(const self_collision *s, int t, double size, int low[3], int high[3]) {
    double cells = 1;
    if (is_far(s, t))
        return 0;
    for (int a = 0; a < 3; a++) {
        low[a] = cell_of(s->grid.box[t][0][a], size);
        high[a] = cell_of(s->grid.box[t][1][a], size);
        cells *= (double)high[a] - low[a] + 1;
    }
    return cells;
}

/* Returns the number of entries of all triangles. It does not depend on the order of the sum,
 * because the terms are whole numbers. */
static double count_entries(const self_collision *s, double size) {
    double count = 0;
#pragma omp parallel for schedule(static) reduction(+ : count)
    for (int t = 0; t < s->mesh->triangle_count; t++) {
        int low[3], high[3];
        count += cells_of(s, t, size, low, high);
    }
    return count;
}

static int make_room(self_grid *g, int triangles, int entries, int buckets) {
    if (!g->first)
        g->first = malloc(((size_t)triangles + 1) * sizeof *g->first);
    return g->first && array_grow(&g->entry, &g->entry_room, entries, sizeof *g->entry) == 0 &&
                   array_grow(&g->loose, &g->loose_room, entries, sizeof *g->loose) == 0 &&
                   array_grow(&g->start, &g->bucket_room, (long)buckets + 2, sizeof *g->start) == 0
               ? 0
               : -1;
}

/* Fills g->loose, triangle by triangle. */
static void list_entries(self_collision *s, double size, unsigned buckets) {
    self_grid *g = &s->grid;
    const int triangles = s->mesh->triangle_count;
#pragma omp parallel for schedule(static)
    for (int t = 0; t < triangles; t++) {
        int low[3], high[3];
        g->first[t + 1] = (int)cells_of(s, t, size, low, high);
    }
    g->first[0] = 0;
    for (int t = 0; t < triangles; t++)
        g->first[t + 1] += g->first[t];
#pragma omp parallel for schedule(static)
    for (int t = 0; t < triangles; t++) {
        int low[3], high[3], cell[3], at = g->first[t];
        if (cells_of(s, t, size, low, high) == 0)
            continue;
        for (cell[0] = low[0]; cell[0] <= high[0]; cell[0]++)
            for (cell[1] = low[1]; cell[1] <= high[1]; cell[1]++)
                for (cell[2] = low[2]; cell[2] <= high[2]; cell[2]++)
                    g->loose[at++] =
                        (self_entry){{cell[0], cell[1], cell[2]}, t, (int)bucket_of(cell, buckets)};
    }
}

/* Sorts the entries by bucket, stable in the order of triangles (counting sort). start[b + 1] moves
 * from the beginning of bucket b to its end. */
static void sort_entries(self_grid *g, int entries, int buckets) {
    int *restrict start = g->start;
    const self_entry *restrict loose = g->loose;
    memset(start, 0, ((size_t)buckets + 2) * sizeof *start);
    for (int e = 0; e < entries; e++)
        start[loose[e].bucket + 2]++;
    for (int b = 0; b < buckets; b++)
        start[b + 2] += start[b + 1];
    for (int e = 0; e < entries; e++)
        g->entry[start[loose[e].bucket + 1]++] = loose[e];
    assert(start[0] == 0 && start[buckets] == entries);
}

/* Fills the buckets. Returns their number, or 0 if out of memory or if a box is not finite. */
static int fill(self_collision *s, double *size) {
    const int triangles = s->mesh->triangle_count;
    *size = 2 * mean_extent(s);
    if (!isfinite(*size))
        return 0; /* no cell is large enough */
    if (!(*size > 0))
        *size = 1;
    double cells;
    while ((cells = count_entries(s, *size)) > (double)MOST_CELLS_EACH * triangles)
        *size *= 2;
    assert(cells >= 0 && cells <= INT_MAX);
    const int entries = (int)cells;
    int buckets = 64;
    while (buckets < entries && buckets < INT_MAX / 4)
        buckets *= 2;
    if (make_room(&s->grid, triangles, entries, buckets) != 0)
        return 0;
    list_entries(s, *size, (unsigned)buckets);
    sort_entries(&s->grid, entries, buckets);
    return buckets;
}

static int add_pair(self_pairs *to, const self_pair *added) {
    if (to->count == to->room &&
        array_grow(&to->pair, &to->room, (long)to->count + 1, sizeof *to->pair) != 0)
        return -1;
    to->pair[to->count++] = *added;
    return 0;
}

/* The squared distance of two vertices in the rest shape. */
static double rest_square(const mesh *m, int i, int j) {
    if (m->rest_in_space) {
        double apart[3];
        vector_subtract(m->position[i], m->position[j], apart);
        return vector_dot(apart, apart);
    }
    const double u = m->material[i][0] - m->material[j][0];
    const double v = m->material[i][1] - m->material[j][1];
    return u * u + v * v;
}

/* Is a corner of the first feature within two gaps of a corner of the second in the rest shape? */
static int near_at_rest(const self_collision *s, const int vertex[4], int firsts) {
    for (int p = 0; p < firsts; p++)
        for (int q = firsts; q < 4; q++) {
            if (rest_square(s->mesh, vertex[p], vertex[q]) < 4 * s->gap * s->gap)
                return 1;
        }
    return 0;
}

/** Arguments of a search: the step and the distance of self_grid_find. */
typedef struct self_search {
    double h, within;
    const double (*x)[3], (*v)[3];
} self_search;

static int add_if_separate(const self_collision *s, const self_search *by, const int vertex[4],
                           int is_edges, self_pairs *to) {
    const int firsts = is_edges ? 2 : 1;
    for (int p = 0; p < firsts; p++)
        for (int q = firsts; q < 4; q++)
            if (vertex[p] == vertex[q])
                return 0;
    self_pair pair = {{vertex[0], vertex[1], vertex[2], vertex[3]}, is_edges, 0, 0};
    if (by->within < INFINITY &&
        self_pair_keeps_distance(vertex, is_edges, by->within, by->h, by->x, by->v))
        return 0;
    pair.near_at_rest = near_at_rest(s, vertex, firsts);
    return add_pair(to, &pair);
}

/* Adds the pairs of the vertices that are assigned to triangle t (see self_collision.h) with
 * triangle u. */
static int add_vertices(const self_collision *s, const self_search *by, int t, int u,
                        self_pairs *to) {
    const int *a = s->mesh->triangle[t], *b = s->mesh->triangle[u];
    for (int p = 0; p < 3; p++) {
        const int vertex[4] = {a[p], b[0], b[1], b[2]};
        if ((s->grid.owned[t] >> p & 1) != 0 && add_if_separate(s, by, vertex, 0, to) != 0)
            return -1;
    }
    return 0;
}

static int add_edges(const self_collision *s, const self_search *by, int t, int u, self_pairs *to) {
    const int *a = s->mesh->triangle[t], *b = s->mesh->triangle[u];
    for (int p = 0; p < 3; p++)
        for (int q = 0; q < 3; q++) {
            const int vertex[4] = {a[p], a[(p + 1) % 3], b[q], b[(q + 1) % 3]};
            if ((s->grid.owned[t] >> (3 + p) & 1) != 0 && (s->grid.owned[u] >> (3 + q) & 1) != 0 &&
                add_if_separate(s, by, vertex, 1, to) != 0)
                return -1;
        }
    return 0;
}

/* Do the boxes meet, and does their intersection begin in this cell? (So each pair is found once.)
 */
static int meets_in_cell(const self_collision *s, const self_entry *a, const self_entry *b,
                         double size) {
    const double(*one)[3] = (const double(*)[3])s->grid.box[a->triangle];
    const double(*other)[3] = (const double(*)[3])s->grid.box[b->triangle];
    for (int k = 0; k < 3; k++)
        if (one[0][k] > other[1][k] || other[0][k] > one[1][k] || a->cell[k] != b->cell[k])
            return 0;
    for (int k = 0; k < 3; k++)
        if (cell_of(most(one[0][k], other[0][k]), size) != a->cell[k])
            return 0;
    return 1;
}

/* Adds the pairs of the buckets from `bucket` up to, but not including, `end`. Returns 0, or -1 if
 * out of memory. */
static int add_buckets(const self_collision *s, const self_search *by, int bucket, int end,
                       double size, self_pairs *to) {
    for (; bucket < end; bucket++)
        for (int i = s->grid.start[bucket]; i < s->grid.start[bucket + 1]; i++)
            for (int j = i + 1; j < s->grid.start[bucket + 1]; j++) {
                const self_entry *a = &s->grid.entry[i], *b = &s->grid.entry[j];
                const int t = a->triangle, u = b->triangle;
                if (t == u || (t >= s->bodies_from && u >= s->bodies_from) ||
                    !meets_in_cell(s, a, b, size))
                    continue;
                if (add_vertices(s, by, t, u, to) != 0 || add_vertices(s, by, u, t, to) != 0 ||
                    add_edges(s, by, t, u, to) != 0)
                    return -1;
            }
    return 0;
}

/* Finds the pairs of a part's buckets. Works on a local copy of the list's head, because neighbours
 * in the array share cache lines. Returns 0, or -1 if out of memory. */
static int find_part(self_collision *s, const self_search *by, int part, int buckets, double size) {
    self_pairs own = s->grid.part[part];
    own.count = 0;
    const int status = add_buckets(s, by, self_part_start(buckets, part),
                                   self_part_start(buckets, part + 1), size, &own);
    s->grid.part[part] = own;
    return status;
}

/* Concatenates the parts' pairs in order. Returns 0, or -1 if out of memory. */
static int join(self_collision *s) {
    long first[SELF_PARTS + 1] = {0};
    for (int part = 0; part < SELF_PARTS; part++)
        first[part + 1] = first[part] + s->grid.part[part].count;
    s->pair_count = 0;
    if (array_grow(&s->pair, &s->pair_room, first[SELF_PARTS], sizeof *s->pair) != 0)
        return -1;
    s->pair_count = (int)first[SELF_PARTS];
#pragma omp parallel for schedule(static)
    for (int part = 0; part < SELF_PARTS; part++) {
        const self_pairs *from = &s->grid.part[part];
        if (from->count > 0)
            memcpy(s->pair + first[part], from->pair, (size_t)from->count * sizeof *from->pair);
    }
    return 0;
}

int self_grid_find(self_collision *s, double h, const double (*x)[3], const double (*v)[3],
                   double within) {
    const self_search by = {h, within, x, v};
    double size;
    int failed = 0;
    s->pair_count = 0;
    sweep(s, h, x, v);
    bound_cloth(s);
    const int buckets = fill(s, &size);
    if (buckets == 0)
        return -1;
#pragma omp parallel for schedule(dynamic) reduction(| : failed)
    for (int part = 0; part < SELF_PARTS; part++)
        failed |= find_part(s, &by, part, buckets, size) != 0;
    return failed ? -1 : join(s);
}
