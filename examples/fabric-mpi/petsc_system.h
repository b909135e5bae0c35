/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A part's system in PETSc's format, for --bits=any: 3x3 blocks; a row belongs to the rank that
 * owns the vertex.
 *
 *     (S A S + s (I - S)) y = S (b - A z),    dv = S y + z
 *
 * with S, z and dv of system/constraint.h, and A and b of system/system.h. The matrix is symmetric
 * positive definite if A is. The solution is the same as that of conjugate gradients with filtered
 * constraints (Baraff and Witkin 1998, section 5.3): the matrix maps the subspaces of free and of
 * given directions each to itself, and the right-hand side is in the free one, so y is too. This is
 * the prefiltered system of Tamstorf, Jones and McCormick 2015, which allows any preconditioner. s
 * > 0 is the first entry of the row's A_ii, so that given directions have the scale of free ones
 * (prefiltered_block in solver_precondition.h). Functions are collective.
 */
#ifndef FABRIC_MPI_PETSC_SYSTEM_H
#define FABRIC_MPI_PETSC_SYSTEM_H

#include <petscmat.h>

#include "part.h"

/** A block of a row. The half matrix stores it in the row of its lower vertex. */
typedef struct petsc_block {
    int column;     /* PETSc's number of the column's vertex, ascending in a row */
    int row;        /* the block's row in the half matrix */
    int place;      /* the block's index in the half matrix */
    int transposed; /* the half matrix stores it transposed, in the row of its column */
} petsc_block;

typedef struct petsc_system {
    Mat A;
    Vec b, y;           /* right-hand side b; y is the guess, then the solution */
    int rows;           /* number of vertices that the rank owns */
    int *vertex;        /* [rows] the vertices' numbers in the part */
    int first;          /* PETSc's number of the first row */
    int *start;         /* [rows + 1] index of each row's first block */
    petsc_block *block; /* [start[rows]] */
    int widest;         /* largest number of blocks in a row */
} petsc_system;

/** Lays out matrix and vectors. The matrix has the type `type` unless -mat_type in PETSC_OPTIONS
 *  names another: aij, baij or sbaij. */
void petsc_system_init(petsc_system *of, const part *p, MatType type);
void petsc_system_free(petsc_system *of);

/** Fills the matrix from the part's system and constraints, including those of ghosts. */
void petsc_system_fill(petsc_system *of, const part *p);

/** petsc_system_put copies value [mesh.vertex_count][3] of the vertices that the rank owns to a
 * PETSc vector. petsc_system_get copies the vector's values back. */
void petsc_system_put(const petsc_system *of, const double (*value)[3], Vec to);
void petsc_system_get(const petsc_system *of, Vec from, double (*value)[3]);

#endif
