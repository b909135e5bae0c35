/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "collision.h"

#include "base/vector.h"

static int is_within(const double *at, const double *low, const double *high, int axes) {
    for (int a = 0; a < axes; a++)
        if (!(at[a] >= low[a] && at[a] <= high[a]))
            return 0;
    return 1;
}

static int number_of(const mesh *m, int vertex) {
    return m->number ? m->number[vertex] : vertex;
}

/** Returns the vertex nearest to the point. Of several at the same distance, it is the one with the
 *  lowest number before the mesh was reordered. */
static int nearest_vertex(const mesh *m, const double point[3]) {
    int nearest = -1;
    double least = INFINITY;
    for (int i = 0; i < m->vertex_count; i++) {
        double away[3];
        vector_subtract(m->position[i], point, away);
        const double square = vector_dot(away, away);
        if (square < least ||
            (square <= least && nearest >= 0 && number_of(m, i) < number_of(m, nearest))) {
            least = square;
            nearest = i;
        }
    }
    return nearest;
}

static int has_number(const pin *p, int number) {
    for (int k = 0; k < p->vertex_count; k++)
        if (p->vertices[k] == number + 1)
            return 1;
    return 0;
}

static int holds(const pin *p, const mesh *m, int vertex) {
    switch (p->by) {
    case PIN_RECTANGLE:
        return is_within(m->material[vertex], p->low, p->high, 2);
    case PIN_BOX:
        return is_within(m->position[vertex], p->box_low, p->box_high, 3);
    case PIN_VERTICES:
        return has_number(p, number_of(m, vertex));
    case PIN_NEAREST:
        break;
    }
    return 0;
}

void pin_find(const pin *p, const mesh *m, int number, int *pin_of) {
    if (p->by == PIN_NEAREST) {
        const int nearest = nearest_vertex(m, p->nearest);
        if (nearest >= 0)
            pin_of[nearest] = number;
        return;
    }
    for (int i = 0; i < m->vertex_count; i++)
        if (holds(p, m, i))
            pin_of[i] = number;
}
