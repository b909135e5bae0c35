/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The linear system of a step, A dv = b, with one row of 3x3 blocks per vertex.
 *
 *     A = M - h df/dv - h^2 df/dx   kg
 *     b = h (f + h df/dx v)         kg m/s
 *
 * with the vertices' masses M, the step h (s), forces f (N), positions x (m), velocities v (m/s)
 * and the unknown change of velocity dv (equation 4 of the paper, docs/paper.md; Baraff and Witkin
 * 1998, equation 6). A is symmetric, so only its diagonal and the blocks above it are stored.
 */
#ifndef FABRIC_SYSTEM_H
#define FABRIC_SYSTEM_H

/** Compressed block rows (CSR with 3x3 blocks). Within a row columns ascend. A symmetric matrix
 *  stores only columns >= row, so a row's first block is its diagonal. */
typedef struct block_matrix {
    int row_count;
    int block_count;
    int *row_start;        /* [row_count + 1] index of each row's first block */
    int *column;           /* [block_count] */
    double (*value)[3][3]; /* [block_count] */
} block_matrix;

typedef struct linear_system {
    block_matrix A;
    double (*b)[3]; /* [A.row_count] */
} linear_system;

/** Elements of one kind, of `size` vertices each. Every pair of an element's vertices has a block
 * in A. */
typedef struct element_list {
    int count;
    int size;
    const int *vertex; /* [count * size] */
} element_list;

/** Lays out A for the elements in `lists`; values and b are unset until system_reset. Elements that
 *  exert no force should be left out, to save memory and time. Returns 0, or -1 if out of memory
 *  (then s is empty). */
int system_init(linear_system *s, int vertex_count, int list_count, const element_list *lists);
void system_free(linear_system *s);

/** Sets A = M and b = h m g: mass m [vertices] in kg, gravity g in m/s^2, step h in s. */
void system_reset(linear_system *s, const double *mass, const double gravity[3], double h);

/** Stores in block [count * size (size + 1) / 2], element by element, the indices in A of the
 *  blocks (i,i) (i,j) ... (j,j) ... of the element's vertices i < j < ..., which must ascend. */
void block_matrix_locate(const block_matrix *A, const element_list *list, int *block);

void block_matrix_free(block_matrix *A);

/** y += A x for a symmetric A with half its blocks stored. x, y [A->row_count] must not overlap. */
void half_product(const block_matrix *A, const double (*x)[3], double (*y)[3]);

#endif
