/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Orders vertices along Hilbert's curve (Hilbert, Ueber die stetige Abbildung einer Linie auf ein
 * Flaechenstueck, 1891). Points near each other on the curve are near in the plane. */
#include <assert.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "mesh_parts.h"

enum { BITS = 16 }; /* per coordinate: the curve passes through 2^16 * 2^16 cells */

typedef struct stop {
    uint32_t along; /* number of cells on the curve before the vertex's cell */
    int vertex;
} stop;

/** Returns the number of cells that the curve passes before cell (x, y). The curve is recursive: in
 *  each quarter of a square it is the same, mirrored or rotated. */
static uint32_t along_curve(uint32_t x, uint32_t y) {
    assert(x < 1u << BITS && y < 1u << BITS);
    uint32_t along = 0;
    for (uint32_t half = 1u << (BITS - 1); half > 0; half /= 2) {
        const uint32_t right = (x & half) > 0, upper = (y & half) > 0;
        along += half * half * ((3 * right) ^ upper);
        if (upper)
            continue;
        if (right) {
            x = half - 1 - (x & (half - 1));
            y = half - 1 - (y & (half - 1));
        }
        const uint32_t swap = x;
        x = y;
        y = swap;
    }
    return along;
}

static uint32_t cell(double value, double least, double width) {
    const double cells = 1u << BITS, at = width > 0.0 ? (value - least) / width * cells : 0.0;
    return at > 0.0 ? (uint32_t)fmin(at, cells - 1.0) : 0; /* NaN gives the first cell */
}

static int compare_stops(const void *a, const void *b) {
    const stop *p = a, *q = b;
    if (p->along != q->along)
        return p->along < q->along ? -1 : 1;
    return (p->vertex > q->vertex) - (p->vertex < q->vertex);
}

int mesh_order_by_curve(const mesh *m, int *new_of_old) {
    stop *stops = malloc((size_t)m->vertex_count * sizeof *stops);
    double least[2] = {INFINITY, INFINITY}, most[2] = {-INFINITY, -INFINITY};
    if (!stops)
        return -1;
    for (int v = 0; v < m->vertex_count; v++)
        for (int k = 0; k < 2; k++) {
            least[k] = fmin(least[k], m->material[v][k]);
            most[k] = fmax(most[k], m->material[v][k]);
        }
    const double width = fmax(most[0] - least[0], most[1] - least[1]);
    for (int v = 0; v < m->vertex_count; v++) {
        const uint32_t x = cell(m->material[v][0], least[0], width);
        const uint32_t y = cell(m->material[v][1], least[1], width);
        stops[v] = (stop){along_curve(x, y), v};
    }
    qsort(stops, (size_t)m->vertex_count, sizeof *stops, compare_stops);
    for (int i = 0; i < m->vertex_count; i++)
        new_of_old[stops[i].vertex] = i;
    free(stops);
    return 0;
}
