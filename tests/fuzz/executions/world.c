/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "world.h"

#include <stdlib.h>
#include <string.h>

enum { ALIGNMENT = 64 };

const char *change_name(change kind) {
    static const char *const names[CHANGE_COUNT] = {
        [CHANGE_NOTHING] = "nothing",
        [CHANGE_ONE_SUBSCRIPT] = "one-subscript",
        [CHANGE_ALL_SUBSCRIPTS] = "all-subscripts",
        [CHANGE_TWO_EXCHANGED] = "two-exchanged",
        [CHANGE_TO_AND_FRO] = "to-and-fro",
        [CHANGE_TABLE] = "table",
        [CHANGE_VALUES] = "values",
        [CHANGE_LENGTH] = "length",
        [CHANGE_PLACE] = "place",
        [CHANGE_OVERLAP] = "overlap",
    };
    return names[kind];
}

static double value(random_source *r) {
    return (random_below(r, 200001) - 100000) / 777.0;
}

static int smaller(int a, int b) {
    return a < b ? a : b;
}

/* ---- making ---------------------------------------------------------------------------------- */

static void *take(world *w, size_t count, size_t size) {
    void *place = w->memory + w->taken;
    w->taken += (count * size + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
    return place;
}

static int subscript(random_source *r, const world_shape *shape, int number) {
    const int along = (int)((int64_t)number * shape->rows / (2 * (int64_t)shape->most));
    switch (shape->order) {
    case SUBSCRIPTS_SORTED:
        return along;
    case SUBSCRIPTS_NEARLY_SORTED:
        return random_chance(r, 2) ? random_below(r, shape->rows) : along;
    case SUBSCRIPTS_CROWDED:
        return random_below(r, 1 + random_below(r, shape->rows));
    default:
        return random_below(r, shape->rows);
    }
}

static void fill_doubles(random_source *r, double *v, size_t count) {
    for (size_t i = 0; i < count; i++)
        v[i] = value(r);
}

bool world_make(world *w, const world_shape *shape, uint64_t seed) {
    random_source r = {seed};
    const size_t rows = (size_t)shape->rows, most = (size_t)shape->most;
    const size_t values = 3 * rows > 4 * most ? 3 * rows : 4 * most;
    *w = (world){.most = shape->most};
    /* the subscripts twice, three arrays of doubles, the rest, and space for alignment */
    w->size = (2 * 2 * most + most + 1 + rows) * sizeof(int) +
              (values + 6 * rows + EDGES) * sizeof(double) + most * sizeof(float) +
              rows * (sizeof(float) + sizeof(int)) + (size_t)16 * ALIGNMENT;
    w->memory = calloc(w->size, 1);
    if (!w->memory)
        return false;
    double *v = take(w, values, sizeof(double)), *h = take(w, 3 * rows, sizeof(double));
    double *g = take(w, 3 * rows, sizeof(double)), *edges = take(w, EDGES, sizeof(double));
    float *f = take(w, most, sizeof(float)), *s = take(w, rows, sizeof(float));
    int *count = take(w, rows, sizeof(int)), *m = take(w, rows, sizeof(int));
    int *first = take(w, most + 1, sizeof(int)), *k = take(w, 2 * most, sizeof(int));
    w->places[0] = k;
    w->places[1] = take(w, 2 * most, sizeof(int));
    w->own = h;
    fill_doubles(&r, v, values);
    fill_doubles(&r, h, 3 * rows);
    fill_doubles(&r, g, 3 * rows);
    for (int i = 0; i < EDGES; i++)
        edges[i] = -128 + 2.6 * i;
    for (size_t i = 0; i < most; i++) {
        f[i] = (float)value(&r);
        first[i + 1] = smaller(first[i] + random_below(&r, 4), 2 * shape->most);
    }
    for (size_t i = 0; i < 2 * most; i++)
        k[i] = subscript(&r, shape, (int)i);
    for (size_t i = 0; i < rows; i++)
        m[i] = random_below(&r, shape->rows);
    w->problem = (problem){.n = shape->most,
                           .rows = shape->rows,
                           .k = k,
                           .m = m,
                           .first = first,
                           .v = v,
                           .f = f,
                           .edges = edges,
                           .cut = value(&r),
                           .h = h,
                           .g = g,
                           .s = s,
                           .count = count};
    return true;
}

void world_free(world *w) {
    free(w->memory);
    *w = (world){0};
}

/* ---- changing -------------------------------------------------------------------------------- */

static void exchange(int *k, int i, int j) {
    const int kept = k[i];
    k[i] = k[j];
    k[j] = kept;
}

/* Moves h into v, which lies in front of it, if all rows fit, or moves it back to its own place. */
static void change_overlap(world *w, random_source *r) {
    problem *p = &w->problem;
    double *const inside = (double *)p->v + random_below(r, p->n);
    const bool has_room = inside + 3 * (ptrdiff_t)p->rows <= w->own;
    p->h = p->h == w->own && has_room ? inside : w->own;
}

static void change_place(world *w) {
    int *const to = w->places[w->problem.k == w->places[0]];
    memcpy(to, w->problem.k, 2 * (size_t)w->most * sizeof(int));
    w->problem.k = to;
}

void world_change(world *w, change kind, uint64_t seed) {
    random_source r = {seed};
    problem *p = &w->problem;
    int *k = (int *)p->k;
    double *v = (double *)p->v;
    switch (kind) {
    case CHANGE_ONE_SUBSCRIPT:
        k[random_below(&r, p->n)] = random_below(&r, p->rows);
        break;
    case CHANGE_ALL_SUBSCRIPTS:
        for (int i = 0; i < 2 * w->most; i++)
            k[i] = random_below(&r, p->rows);
        break;
    case CHANGE_TWO_EXCHANGED:
        exchange(k, random_below(&r, p->n), random_below(&r, p->n));
        break;
    case CHANGE_TO_AND_FRO:
        exchange(k, 0, p->n - 1);
        exchange(k, p->n / 3, p->n / 2);
        break;
    case CHANGE_TABLE:
        ((int *)p->m)[random_below(&r, p->rows)] = random_below(&r, p->rows);
        break;
    case CHANGE_VALUES:
        for (int i = 0; i < p->n; i++)
            v[random_below(&r, p->n)] = value(&r);
        p->cut = value(&r);
        break;
    case CHANGE_LENGTH:
        p->n = 1 + random_below(&r, w->most);
        break;
    case CHANGE_PLACE:
        change_place(w);
        break;
    case CHANGE_OVERLAP:
        change_overlap(w, &r);
        break;
    default:
        break;
    }
}
