/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "doubts.h"

#include <math.h>
#include <stdlib.h>

#include "contact/collision.h"

/* The usual sizes of cloth, m. */
static const double smallest = 0.005, largest = 50;

/* The longest side of the box around the cloth. */
static double extent_of(const mesh *m) {
    double longest = 0;
    for (int a = 0; a < 3; a++) {
        double low = INFINITY, high = -INFINITY;
        for (int v = 0; v < m->vertex_count; v++) {
            low = fmin(low, m->position[v][a]);
            high = fmax(high, m->position[v][a]);
        }
        longest = fmax(longest, high - low);
    }
    return longest;
}

static int doubt_units(const scene *s, double extent, FILE *to) {
    if (extent >= smallest && extent <= largest)
        return 0;
    fprintf(to, "%s: the cloth is %.3g m long; coordinates are metres", s->name, extent);
    if (extent > largest)
        fputs(", 'mesh.scale: 0.001' converts millimetres", to);
    fputc('\n', to);
    return 1;
}

static int doubt_gaps(const scene *s, double edge, double extent, FILE *to) {
    int count = 0;
    if (s->self_collision.gap >= edge) {
        fprintf(to,
                "%s: 'self_collision.gap' is %.3g m, as wide as the cloth's edges (%.3g m in the "
                "mean), expected a part of them\n",
                s->name, s->self_collision.gap, edge);
        count++;
    }
    for (int n = 0; n < s->collider_count; n++)
        if (s->colliders[n].gap >= extent) {
            fprintf(to,
                    "%s: 'colliders.%d.gap' is %.3g m, as wide as the cloth (%.3g m), expected a "
                    "part of that\n",
                    s->name, n, s->colliders[n].gap, extent);
            count++;
        }
    return count;
}

/* Finds pins that hold nothing. Each pin is tested alone, since a vertex that two pins select is
 * held by the first. */
static int doubt_pins(const scene *s, const mesh *m, int *pin_of, FILE *to) {
    int count = 0;
    for (int p = 0; p < s->pin_count; p++) {
        int held = 0;
        for (int v = 0; v < m->vertex_count; v++)
            pin_of[v] = -1;
        pin_find(&s->pins[p], m, p, pin_of);
        for (int v = 0; v < m->vertex_count; v++)
            held += pin_of[v] == p;
        if (held > 0)
            continue;
        fprintf(to, "%s: 'pins.%d' holds no vertex of the cloth\n", s->name, p);
        count++;
    }
    return count;
}

int scene_doubts(const scene *s, const mesh *m, FILE *to) {
    int *pin_of = malloc(((size_t)m->vertex_count + 1) * sizeof *pin_of);
    if (!pin_of)
        return -1;
    const double extent = extent_of(m);
    const int count = doubt_units(s, extent, to) + doubt_gaps(s, mesh_mean_edge(m), extent, to) +
                      doubt_pins(s, m, pin_of, to);
    free(pin_of);
    return count;
}
