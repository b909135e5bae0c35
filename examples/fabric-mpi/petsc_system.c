/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "petsc_system.h"

#include <stdlib.h>
#include <string.h>

#include "part_layout.h"
#include "petsc_check.h"
#include "solver/solver_precondition.h"

enum { SIZE = 3 }; /* rows of a block */

/* Numbers vertices for PETSc: owned vertices have consecutive numbers in the part's order.
 * number[mesh.vertex_count] receives the numbers of all vertices, also of ghosts.
 * row[mesh.vertex_count] receives the local rows, -1 for ghosts. */
static void number_vertices(petsc_system *of, const part *p, int *number, int *row) {
    for (int i = 0; i < p->mesh.vertex_count; i++)
        row[i] = -1;
    of->rows = 0;
    for (int n = 0; n < p->blocks; n++)
        of->rows += p->block[n].end - p->block[n].begin;
    of->first = 0;
    MPI_Exscan(&of->rows, &of->first, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
    of->vertex = part_memory((size_t)of->rows, sizeof *of->vertex);
    for (int n = 0, k = 0; n < p->blocks; n++)
        for (int i = p->block[n].begin; i < p->block[n].end; i++, k++) {
            of->vertex[k] = i;
            row[i] = k;
            number[i] = of->first + k;
        }
    part_receive_ints(p->ghosts, number, number);
}

static int by_column(const void *a, const void *b) {
    const petsc_block *left = a, *right = b;
    return (left->column > right->column) - (left->column < right->column);
}

/* Appends a block of the half matrix to row[at] if the rank owns that row. While of->block is NULL,
 * only counts it in of->start. */
static void add_block(petsc_system *of, const int *row, int at, petsc_block block, int *next) {
    if (row[at] < 0)
        return;
    if (!of->block)
        of->start[row[at] + 1]++;
    else
        of->block[of->start[row[at]] + next[row[at]]++] = block;
}

static void visit_blocks(petsc_system *of, const block_matrix *A, const int *number, const int *row,
                         int *next) {
    for (int i = 0; i < A->row_count; i++)
        for (int k = A->row_start[i]; k < A->row_start[i + 1]; k++) {
            const int j = A->column[k];
            add_block(of, row, i, (petsc_block){number[j], i, k, 0}, next);
            if (j != i)
                add_block(of, row, j, (petsc_block){number[i], i, k, 1}, next);
        }
}

static void find_blocks(petsc_system *of, const block_matrix *A, const int *number,
                        const int *row) {
    of->start = part_memory((size_t)of->rows + 1, sizeof *of->start);
    visit_blocks(of, A, number, row, NULL);
    for (int k = 0; k < of->rows; k++) {
        if (of->start[k + 1] > of->widest)
            of->widest = of->start[k + 1];
        of->start[k + 1] += of->start[k];
    }
    int *next = part_memory((size_t)of->rows, sizeof *next);
    of->block = part_memory((size_t)of->start[of->rows], sizeof *of->block);
    visit_blocks(of, A, number, row, next);
    for (int k = 0; k < of->rows; k++)
        qsort(of->block + of->start[k], (size_t)(of->start[k + 1] - of->start[k]),
              sizeof *of->block, by_column);
    free(next);
}

/* Preallocates the matrix. Counts the blocks of each row in columns that the rank owns and those in
 * other columns. For a matrix that stores only its upper half, also counts the blocks of either
 * kind at or right of the diagonal. */
static void allocate(const petsc_system *of) {
    enum { OWN, OTHER, OWN_UPPER, OTHER_UPPER, COUNTS };
    PetscInt *count[COUNTS];
    for (int c = 0; c < COUNTS; c++)
        count[c] = part_memory((size_t)of->rows, sizeof *count[c]);
    for (int k = 0; k < of->rows; k++)
        for (int n = of->start[k]; n < of->start[k + 1]; n++) {
            const int column = of->block[n].column;
            const int other = column < of->first || column >= of->first + of->rows;
            count[other ? OTHER : OWN][k]++;
            count[other ? OTHER_UPPER : OWN_UPPER][k] += column >= of->first + k;
        }
    CHECK(MatXAIJSetPreallocation(of->A, SIZE, count[OWN], count[OTHER], count[OWN_UPPER],
                                  count[OTHER_UPPER]));
    for (int c = 0; c < COUNTS; c++)
        free(count[c]);
}

static void make_matrix(petsc_system *of, MatType type) {
    const PetscInt own = SIZE * of->rows;
    PetscBool half;
    CHECK(MatCreate(PETSC_COMM_WORLD, &of->A));
    CHECK(MatSetSizes(of->A, own, own, PETSC_DETERMINE, PETSC_DETERMINE));
    CHECK(MatSetBlockSize(of->A, SIZE));
    CHECK(MatSetType(of->A, type));
    CHECK(MatSetFromOptions(of->A));
    allocate(of);
    CHECK(PetscObjectTypeCompareAny((PetscObject)of->A, &half, MATSEQSBAIJ, MATMPISBAIJ, ""));
    if (half)
        CHECK(MatSetOption(of->A, MAT_IGNORE_LOWER_TRIANGULAR, PETSC_TRUE));
    CHECK(MatCreateVecs(of->A, &of->y, &of->b));
}

void petsc_system_init(petsc_system *of, const part *p, MatType type) {
    const size_t vertices = (size_t)p->mesh.vertex_count;
    int *number = part_memory(vertices, sizeof *number), *row = part_memory(vertices, sizeof *row);
    *of = (petsc_system){0};
    number_vertices(of, p, number, row);
    find_blocks(of, &p->sim->system.A, number, row);
    free(number);
    free(row);
    make_matrix(of, type);
}

void petsc_system_free(petsc_system *of) {
    CHECK(MatDestroy(&of->A));
    CHECK(VecDestroy(&of->b));
    CHECK(VecDestroy(&of->y));
    free(of->vertex);
    free(of->start);
    free(of->block);
    *of = (petsc_system){0};
}

/* Computes the blocks of row k, side by side as PETSc requires: value [3][3 count]. */
static void compute_row(const petsc_system *of, const part *p, int k, double *value) {
    const int first = of->start[k], count = of->start[k + 1] - first;
    for (int n = 0; n < count; n++) {
        const petsc_block *block = &of->block[first + n];
        double of_half[SIZE][SIZE];
        prefiltered_block(&p->sim->system.A, &p->sim->constraints, block->row, block->place,
                          of_half);
        for (int r = 0; r < SIZE; r++)
            for (int c = 0; c < SIZE; c++)
                value[(r * count + n) * SIZE + c] =
                    block->transposed ? of_half[c][r] : of_half[r][c];
    }
}

void petsc_system_fill(petsc_system *of, const part *p) {
    double *value = part_memory((size_t)of->widest * SIZE * SIZE, sizeof *value);
    PetscInt *column = part_memory((size_t)of->widest, sizeof *column);
    for (int k = 0; k < of->rows; k++) {
        const int first = of->start[k], count = of->start[k + 1] - first;
        const PetscInt row = of->first + k;
        compute_row(of, p, k, value);
        for (int n = 0; n < count; n++)
            column[n] = of->block[first + n].column;
        CHECK(MatSetValuesBlocked(of->A, 1, &row, count, column, value, INSERT_VALUES));
    }
    CHECK(MatAssemblyBegin(of->A, MAT_FINAL_ASSEMBLY));
    CHECK(MatAssemblyEnd(of->A, MAT_FINAL_ASSEMBLY));
    CHECK(MatSetOption(of->A, MAT_SYMMETRIC, PETSC_TRUE)); /* new values reset the option */
    free(value);
    free(column);
}

void petsc_system_put(const petsc_system *of, const double (*value)[3], Vec to) {
    PetscScalar *own;
    CHECK(VecGetArrayWrite(to, &own));
    for (int k = 0; k < of->rows; k++)
        memcpy(own + (size_t)k * SIZE, value[of->vertex[k]], sizeof *value);
    CHECK(VecRestoreArrayWrite(to, &own));
}

void petsc_system_get(const petsc_system *of, Vec from, double (*value)[3]) {
    const PetscScalar *own;
    CHECK(VecGetArrayRead(from, &own));
    for (int k = 0; k < of->rows; k++)
        memcpy(value[of->vertex[k]], own + (size_t)k * SIZE, sizeof *value);
    CHECK(VecRestoreArrayRead(from, &own));
}
