/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Nested dissection (George, Nested dissection of a regular finite element mesh, 1973) by METIS, if
 * the build has METIS. The two halves of the mesh come first, each numbered recursively, then the
 * vertices that separate them. */
#include <stdio.h>
#include <stdlib.h>

#include "base/arrays.h"
#include "mesh_parts.h"

enum { ERROR_SIZE = 256 };

#ifdef FABRIC_WITH_METIS
#include <metis.h>

static int compare_numbers(const void *a, const void *b) {
    const int p = *(const int *)a, q = *(const int *)b;
    return (p > q) - (p < q);
}

/** Copies the graph for METIS, which requires each neighbour exactly once. */
static void take_neighbours_once(const mesh_graph *g, idx_t *start, idx_t *neighbour) {
    idx_t count = 0;
    for (int v = 0; v < g->vertex_count; v++) {
        const int first = g->start[v], end = g->start[v + 1];
        start[v] = count;
        qsort(g->neighbour + first, (size_t)(end - first), sizeof *g->neighbour, compare_numbers);
        for (int k = first; k < end; k++)
            if (g->neighbour[k] != v && (k == first || g->neighbour[k] != g->neighbour[k - 1]))
                neighbour[count++] = g->neighbour[k];
    }
    start[g->vertex_count] = count;
}

static int dissect(const mesh_graph *g, int *new_of_old) {
    idx_t count = g->vertex_count, options[METIS_NOPTIONS];
    const size_t room = (size_t)count;
    arrays own = {0};
    idx_t *start = arrays_add(&own, room + 1, sizeof *start);
    idx_t *neighbour = arrays_add(&own, (size_t)g->start[count], sizeof *neighbour);
    idx_t *old_of_new = arrays_add(&own, room, sizeof *old_of_new);
    idx_t *to = arrays_add(&own, room, sizeof *to);
    int status = -1;
    METIS_SetDefaultOptions(options);
    options[METIS_OPTION_SEED] = 1; /* the same order each time */
    if (!own.failed) {
        take_neighbours_once(g, start, neighbour);
        if (METIS_NodeND(&count, start, neighbour, NULL, options, old_of_new, to) == METIS_OK)
            status = 0;
    }
    for (idx_t v = 0; status == 0 && v < count; v++)
        new_of_old[v] = (int)to[v];
    arrays_free(&own);
    return status;
}

int mesh_order_by_dissection(const mesh *m, int *new_of_old, char *error) {
    mesh_graph g = {0};
    const int status = mesh_graph_make(&g, m) == 0 ? dissect(&g, new_of_old) : -1;
    mesh_graph_free(&g);
    if (status != 0)
        snprintf(error, ERROR_SIZE, "out of memory");
    return status;
}
#else
int mesh_order_by_dissection(const mesh *m, int *new_of_old, char *error) {
    (void)m;
    (void)new_of_old;
    snprintf(error, ERROR_SIZE,
             "the order 'metis' is not built in: METIS (Debian's libmetis-dev) was missing then");
    return -1;
}
#endif
