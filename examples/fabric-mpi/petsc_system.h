/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A part's system as PETSc has it, for --bits=any: 3x3 blocks, rows by the ranks that own the
 * vertices.
 *
 *     (S A S + s (I - S)) y = S (b - A z),    dv = S y + z
 *
 * It is symmetric positive definite where A is, and has the solution that conjugate gradients
 * within the constraints have (Baraff and Witkin 1998, section 5.3): y lies in the free directions,
 * since the matrix maps these and the given ones each to themselves, and the right-hand side is
 * free. This is the prefiltered system of Tamstorf, Jones and McCormick 2015, which lets any
 * preconditioner be used; s > 0 is the row's A_ii, so that given directions have the scale of free
 * ones (prefiltered_block in solver_precondition.h). Collective.
 */
#ifndef FABRIC_MPI_PETSC_SYSTEM_H
#define FABRIC_MPI_PETSC_SYSTEM_H

#include <petscmat.h>

#include "part.h"

/** A block of a row, stored in the row of the half matrix that its lower vertex has. */
typedef struct petsc_block {
    int column;     /* PETSc's number of its vertex, ascending in a row */
    int row;        /* of the half matrix */
    int place;      /* there */
    int transposed; /* the row of the half matrix is the column here */
} petsc_block;

typedef struct petsc_system {
    Mat A;
    Vec b, y;           /* right-hand side; guess, then solution */
    int rows;           /* vertices that the rank owns */
    int *vertex;        /* [rows] their numbers in the part */
    int first;          /* PETSc's number of the first of them */
    int *start;         /* [rows + 1] a row's first block */
    petsc_block *block; /* [start[rows]] */
    int widest;         /* blocks in a row, at most */
} petsc_system;

/** Lays out matrix and vectors. The matrix is of the type `type` unless -mat_type (PETSC_OPTIONS)
 * says otherwise: aij, baij or sbaij. */
void petsc_system_init(petsc_system *of, const part *p, MatType type);
void petsc_system_free(petsc_system *of);

/** The matrix, of the part's system and constraints, those of ghosts, too. */
void petsc_system_fill(petsc_system *of, const part *p);

/** To a vector of PETSc's from the vertices that the rank owns, and back. value
 *  [mesh.vertex_count][3] */
void petsc_system_put(const petsc_system *of, const double (*value)[3], Vec to);
void petsc_system_get(const petsc_system *of, Vec from, double (*value)[3]);

#endif
