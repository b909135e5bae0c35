/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// CFLAGS: -Wno-sign-compare
// INTEGERS: no
// MAY-RUN-SERIALLY: records overlap the updated array or the structure that holds their number
// An iteration's own record lies behind a pointer in a structure: one loop moves particles and deposits them on a grid.
#include <string.h>
#include "case.h"

enum { N = 4000, CELLS = 300 };
struct part {
    float x, v;
};
struct tag {
    int cell, other[2];
};
struct species {
    int n;
    struct part *part;
    struct tag *tag;
    float charge, *grid;
};
struct world {
    int step;
    struct species *species;
};
static struct part parts[N];
static struct tag tags[N];
static float grid[CELLS], seen[CELLS];

/* Moves and deposits particles; the grid is a parameter or a member of the structure. */
static void move(struct species *s, float *to) {
    for (int i = 0; i < s->n; i++) { // EXPECT: transformed
        const float x = s->part[i].x + s->part[i].v;
        const int cells = x >= 1 ? 1 : x < 0 ? -1 : 0;
        s->part[i].x = x - (float)cells;
        s->tag[i].cell = (s->tag[i].cell + cells + CELLS) % CELLS;
        to[s->tag[i].cell] += s->charge * s->part[i].x;
    }
}

static void move_there(struct species *s) {
    for (int i = 0; i < s->n; i++) { // EXPECT: transformed
        s->tag[i].cell = (s->tag[i].cell + 1) % CELLS;
        s->tag[i].other[1] += 2;
        s->grid[s->tag[i].cell] += s->part[i].v;
        s->grid[(s->tag[i].cell + 1) % CELLS] -= s->part[i].x;
    }
}

/* Behind two pointers; stored under a condition; for every second iteration. */
static void two_pointers(struct world *w, int n, float *to) {
    for (int i = 0; i < n; i += 2) { // EXPECT: transformed
        const float v = w->species->part[i + 1].v;
        if (v < 0)
            w->species->part[i + 1].v = v * 0.5f;
        to[w->species->tag[i + 1].cell] += w->species->part[i + 1].v;
    }
}

/* The own element is stored first and then read. */
static void stored_first(struct species *s, const int *k, float *to) {
    for (int i = 0; i < s->n; i++) { // EXPECT: transformed
        s->tag[i].cell = k[i];
        to[s->tag[i].cell] += 0.25f * (float)i;
    }
}

static void fill(void) {
    for (int i = 0; i < N; i++) {
        parts[i] = (struct part){(float)case_value() * 0.5f + 0.5f, (float)case_value()};
        tags[i] = (struct tag){case_below(CELLS), {0, 0}};
    }
    for (int i = 0; i < CELLS; i++)
        grid[i] = (float)case_value();
}

static void all(struct species *s, struct world *w, const int *k, float *to) {
    for (int times = 0; times < 3; times++) {
        move(s, to);
        move_there(s);
        two_pointers(w, s->n, to);
    }
    stored_first(s, k, to);
}

int main(void) {
    static int k[N];
    case_subscripts(k, N, CELLS);
    fill();
    struct species s = {N, parts, tags, 0.3f, grid};
    struct world w = {0, &s};
    all(&s, &w, k, grid);
    CASE_PRINT(parts);
    CASE_PRINT(tags);
    CASE_PRINT(grid);

    /* Without particles the pointers may have any value. */
    struct species none = {0, NULL, NULL, 1, grid};
    w.species = &none;
    all(&none, &w, k, grid);
    CASE_PRINT(grid);

    /* The grid lies among the particles. */
    w.species = &s;
    all(&s, &w, k, &parts[N / 2].x);
    CASE_PRINT(parts);

    /* The structure lies among the tags: storing a particle's cell overwrites `n`, which ends the loop. */
    char *memory = calloc(N, sizeof(struct tag));
    struct species *inside = (struct species *)(memory + 120 * sizeof(struct tag));
    *inside = (struct species){400, parts, (struct tag *)memory, 0.3f, seen};
    k[120] = 50;
    stored_first(inside, k, seen);
    CASE_PRINT(seen);
    printf("%d\n", inside->n);
    free(memory);
    return 0;
}
