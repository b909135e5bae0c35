/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The linear system of a step, A dv = b: one row of 3x3 blocks a vertex.
 *
 *     A = M - h df/dv - h^2 df/dx   kg
 *     b = h (f + h df/dx v)         kg m/s
 *
 * (equation 4 of the paper; Baraff and Witkin 1998, equation 6). A is symmetric, so only its
 * diagonal and the blocks above it are stored.
 */
#ifndef FABRIC_SYSTEM_H
#define FABRIC_SYSTEM_H

/** Compressed block rows. Within a row columns ascend; the half of a symmetric matrix stores
 *  columns >= row, so that a row's first block is its diagonal. */
typedef struct block_matrix {
    int row_count;
    int block_count;
    int *row_start;        /* [row_count + 1] a row's first block */
    int *column;           /* [block_count] */
    double (*value)[3][3]; /* [block_count] */
} block_matrix;

typedef struct linear_system {
    block_matrix A;
    double (*b)[3]; /* [A.row_count] */
} linear_system;

/** Elements of one kind: `size` vertices each. Every pair of them has a block in A. */
typedef struct element_list {
    int count;
    int size;
    const int *vertex; /* [count * size] */
} element_list;

/** Lays out A for the elements in `lists`; values and b are unset until system_reset. A list that
 *  is left out costs neither memory nor time. 0, or -1: out of memory (then s is empty). */
int system_init(linear_system *s, int vertex_count, int list_count, const element_list *lists);
void system_free(linear_system *s);

/** A = M, b = h m g. mass [vertices] kg, gravity m/s^2, h s. */
void system_reset(linear_system *s, const double *mass, const double gravity[3], double h);

/** All blocks, above and below the diagonal, of the matrix whose half is given: for comparing
 *  products. 0, or -1: out of memory. */
int block_matrix_complete(const block_matrix *half, block_matrix *full);
void block_matrix_free(block_matrix *A);

/** Where the block (row, column) is stored: row <= column, and the two share an element. Rows are
 *  short (4 blocks, 7 with bending, on average): going through them beats bisection. */
static inline int block_find(const block_matrix *A, int row, int column) {
    int block = A->row_start[row];
    while (A->column[block] < column)
        block++;
    return block;
}

#endif
