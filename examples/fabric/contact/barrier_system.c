/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/*
 * The loops of add_gradients and add_blocks are irregular reductions whose subscripts change at
 * every call.
 */
#include "barrier_system.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "base/vector.h"

int barrier_system_init(barrier_system *s, const block_matrix *A, int surface_vertices) {
    *s = (barrier_system){.elastic_count = A->block_count};
    s->elastic = calloc((size_t)A->block_count + 1, sizeof *s->elastic);
    s->push = calloc((size_t)surface_vertices + 1, sizeof *s->push);
    if (!s->elastic || !s->push)
        return -1;
    for (int i = 0; i < A->row_count; i++)
        for (int k = A->row_start[i]; k < A->row_start[i + 1]; k++) {
            s->elastic[k][0] = i;
            s->elastic[k][1] = A->column[k];
        }
    return 0;
}

void barrier_system_free(barrier_system *s) {
    system_free(&s->all);
    free(s->elastic);
    free(s->couple);
    free(s->place);
    free(s->push);
    *s = (barrier_system){0};
}

/* Vertices of bodies have no row in the matrix: the element's first cloth vertex replaces them. */
static void couple_cloth(const barrier *b, const int vertex[4], int couple[4]) {
    int first = 0;
    while (b->collider[vertex[first]] >= 0)
        first++;
    assert(first < 4);
    for (int k = 0; k < 4; k++)
        couple[k] = vertex[b->collider[vertex[k]] >= 0 ? first : k];
}

static int lay_out(barrier_system *s, const barrier *b) {
    const int count = b->list.elements;
    if (array_grow(&s->couple, &s->couple_room, count, sizeof *s->couple) != 0 ||
        array_grow(&s->place, &s->place_room, count, sizeof *s->place) != 0)
        return -1;
#pragma omp parallel for schedule(static)
    for (int e = 0; e < count; e++)
        couple_cloth(b, b->list.element[e].vertex, s->couple[e]);
    const element_list lists[2] = {{s->elastic_count, 2, &s->elastic[0][0]},
                                   {count, 4, &s->couple[0][0]}};
    system_free(&s->all);
    return system_init(&s->all, b->cloth->vertex_count, 2, lists);
}

/* Copies the cloth's matrix and b; each row's blocks are a subset of the combined row's. */
static void copy_cloth(barrier_system *s, const linear_system *cloth) {
    const block_matrix *from = &cloth->A;
    block_matrix *to = &s->all.A;
#pragma omp parallel for schedule(static)
    for (int i = 0; i < from->row_count; i++) {
        int k = to->row_start[i];
        memcpy(s->all.b[i], cloth->b[i], sizeof s->all.b[i]);
        for (int m = from->row_start[i]; m < from->row_start[i + 1]; m++) {
            while (to->column[k] != from->column[m])
                k++;
            memcpy(to->value[k], from->value[m], sizeof to->value[k]);
        }
    }
}

static void transpose(double m[3][3]) {
    for (int r = 0; r < 3; r++)
        for (int c = 0; c < r; c++) {
            const double kept = m[r][c];
            m[r][c] = m[c][r];
            m[c][r] = kept;
        }
}

static int find_block(const block_matrix *A, int row, int column) {
    assert(row <= column);
    int low = A->row_start[row], high = A->row_start[row + 1] - 1;
    while (low < high) {
        const int middle = (low + high) / 2;
        if (A->column[middle] < column)
            low = middle + 1;
        else
            high = middle;
    }
    assert(A->column[low] == column);
    return low;
}

/* Sets place[] to the indices in A of the element's blocks, or to -1 for blocks with a vertex of a
 * body. Transposes blocks that would lie below the diagonal. */
static void locate(const barrier *b, const block_matrix *A, barrier_element *e, int place[10]) {
    int k = 0;
    for (int p = 0; p < 4; p++)
        for (int q = p; q < 4; q++, k++) {
            const int i = e->vertex[p], j = e->vertex[q];
            place[k] = -1;
            if (b->collider[i] >= 0 || b->collider[j] >= 0)
                continue;
            if (i > j)
                transpose(e->block[k]);
            place[k] = find_block(A, i < j ? i : j, i < j ? j : i);
        }
}

/* Adds the change of the gradient caused by the displacement of the element's vertex number
 * `from`. */
static void add_driven_gradient(const double displacement[3], int from, barrier_element *e) {
    int k = 0;
    for (int p = 0; p < 4; p++)
        for (int q = p; q < 4; q++, k++)
            for (int r = 0; r < 3 && (p == from || q == from); r++)
                for (int c = 0; c < 3; c++)
                    if (q == from)
                        e->gradient[p][r] += e->block[k][r][c] * displacement[c];
                    else
                        e->gradient[q][r] += e->block[k][c][r] * displacement[c];
}

static void add_gradients(int count, const barrier_element *restrict element,
                          double (*restrict push)[3]) {
    int e, k, a;
    for (e = 0; e < count; e++)
        for (k = 0; k < 4; k++)
            for (a = 0; a < 3; a++)
                push[element[e].vertex[k]][a] += element[e].gradient[k][a];
}

static void add_blocks(int count, const barrier_element *restrict element,
                       const int (*restrict place)[10], double square,
                       double (*restrict value)[3][3]) {
    int e, k, r, c;
    for (e = 0; e < count; e++)
        for (k = 0; k < 10; k++) {
            if (place[e][k] < 0)
                continue;
            for (r = 0; r < 3; r++)
                for (c = 0; c < 3; c++)
                    value[place[e][k]][r][c] += square * element[e].block[k][r][c];
        }
}

int barrier_system_make(barrier_system *s, barrier *b, double h, const linear_system *cloth) {
    const int count = b->list.elements;
    if (lay_out(s, b) != 0)
        return -1;
    copy_cloth(s, cloth);
#pragma omp parallel for schedule(static)
    for (int e = 0; e < count; e++) {
        for (int k = 0; k < 4; k++) {
            const int i = b->list.element[e].vertex[k];
            if (b->collider[i] >= 0 && vector_length(b->displacement[i]) > 0)
                add_driven_gradient(b->displacement[i], k, &b->list.element[e]);
        }
        locate(b, &s->all.A, &b->list.element[e], s->place[e]);
    }
    memset(s->push, 0, (size_t)b->surface.vertex_count * sizeof *s->push);
    add_gradients(count, b->list.element, s->push);
    add_blocks(count, b->list.element, (const int(*)[10])s->place, h * h, s->all.A.value);
    for (int i = 0; i < b->cloth->vertex_count; i++)
        for (int a = 0; a < 3; a++)
            s->all.b[i][a] -= h * s->push[i][a];
    return 0;
}
