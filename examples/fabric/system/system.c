/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "system.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

/* Sorts the first `count` of `column` and drops repetitions. Returns how many are left. */
static int sort_unique(int *column, int count) {
    int kept = 0;
    for (int k = 0; k < count; k++) {
        const int c = column[k];
        int at = kept;
        while (at > 0 && column[at - 1] > c)
            at--;
        if (at > 0 && column[at - 1] == c)
            continue;
        memmove(&column[at + 1], &column[at], sizeof(int) * (size_t)(kept - at));
        column[at] = c;
        kept++;
    }
    return kept;
}

/* Adds every pair (smaller, larger) of vertices that share an element to the row of the smaller
 * one. If column is NULL, only counts in `next`; otherwise stores at `next` and advances it. */
static void visit_pairs(int list_count, const element_list *lists, int *next, int *column) {
    for (int l = 0; l < list_count; l++)
        for (int e = 0; e < lists[l].count; e++) {
            const int *v = lists[l].vertex + (size_t)e * (size_t)lists[l].size;
            for (int a = 0; a < lists[l].size; a++)
                for (int b = 0; b < lists[l].size; b++) {
                    if (v[a] >= v[b])
                        continue;
                    if (column)
                        column[next[v[a]]] = v[b];
                    next[v[a]]++;
                }
        }
}

/* Computes *column and row_start: lists the columns of each row with repetitions, then removes the
 * repetitions. */
static int find_columns(int rows, int list_count, const element_list *lists, int *row_start,
                        int **column) {
    int *first = calloc((size_t)rows + 1, sizeof *first);
    int *next = calloc((size_t)rows + 1, sizeof *next);
    int *wide = NULL;
    int total = 0, kept = 0;
    int status = -1;
    if (!first || !next)
        goto done;
    visit_pairs(list_count, lists, next, NULL);
    for (int i = 0; i < rows; i++) {
        first[i] = total;
        total += next[i] + 1; /* 1 for the diagonal */
        next[i] = first[i] + 1;
    }
    wide = malloc(sizeof *wide * ((size_t)total + 1));
    if (!wide)
        goto done;
    visit_pairs(list_count, lists, next, wide);
    for (int i = 0; i < rows; i++) {
        wide[first[i]] = i;
        const int count = sort_unique(&wide[first[i]], next[i] - first[i]);
        assert(count >= 1 && wide[first[i]] == i && kept <= first[i]);
        memmove(&wide[kept], &wide[first[i]], sizeof *wide * (size_t)count);
        row_start[i] = kept;
        kept += count;
    }
    assert(kept >= rows && kept <= total);
    row_start[rows] = kept;
    int *narrow = realloc(wide, sizeof *wide * ((size_t)kept + 1));
    *column = narrow ? narrow : wide;
    wide = NULL;
    status = 0;
done:
    free(first);
    free(next);
    free(wide);
    return status;
}

void block_matrix_free(block_matrix *A) {
    free(A->row_start);
    free(A->column);
    free(A->value);
    *A = (block_matrix){0};
}

void system_free(linear_system *s) {
    block_matrix_free(&s->A);
    free(s->b);
    s->b = NULL;
}

int system_init(linear_system *s, int vertex_count, int list_count, const element_list *lists) {
    *s = (linear_system){0};
    s->A.row_count = vertex_count;
    s->A.row_start = calloc((size_t)vertex_count + 1, sizeof *s->A.row_start);
    s->b = calloc((size_t)vertex_count + 1, sizeof *s->b);
    if (!s->A.row_start || !s->b ||
        find_columns(vertex_count, list_count, lists, s->A.row_start, &s->A.column) != 0) {
        system_free(s);
        return -1;
    }
    s->A.block_count = s->A.row_start[vertex_count];
    s->A.value = calloc((size_t)s->A.block_count + 1, sizeof *s->A.value);
    if (!s->A.value) {
        system_free(s);
        return -1;
    }
    return 0;
}

void system_reset(linear_system *s, const double *mass, const double gravity[3], double h) {
#pragma omp parallel for schedule(static)
    for (int i = 0; i < s->A.row_count; i++) {
        const int diagonal = s->A.row_start[i];
        const int end = s->A.row_start[i + 1];
        memset(s->A.value[diagonal], 0, sizeof *s->A.value * (size_t)(end - diagonal));
        for (int c = 0; c < 3; c++) {
            s->A.value[diagonal][c][c] = mass[i];
            s->b[i][c] = h * mass[i] * gravity[c];
        }
    }
}

/* Returns the index of block (row, column), row <= column; the two vertices must share an element.
 * Rows are short (on average 4 blocks, 7 with bending), so a linear search beats bisection. */
static int block_find(const block_matrix *A, int row, int column) {
    assert(row <= column);
    int block = A->row_start[row];
    while (A->column[block] < column)
        block++;
    assert(block < A->row_start[row + 1] && A->column[block] == column);
    return block;
}

void block_matrix_locate(const block_matrix *A, const element_list *list, int *block) {
    for (int e = 0; e < list->count; e++) {
        const int *v = list->vertex + (size_t)e * (size_t)list->size;
        for (int p = 0; p < list->size; p++)
            for (int q = p; q < list->size; q++)
                *block++ = block_find(A, v[p], v[q]);
    }
}
