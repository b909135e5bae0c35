/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The part of a cloth that one rank works on, as a mesh of its own: the vertices that it owns, and
 * those that share a triangle or a hinge with one of them (ghosts), in the order of the whole mesh.
 * It has every element that touches a vertex it owns, in the order of the whole mesh. So a row of
 * the linear system that the rank owns gets the terms of the sequential program in their order, and
 * nothing is summed over the network. What the elements add to rows of ghosts is not used.
 *
 * Vertices are owned by blocks: of SOLVER_CHUNK vertices with block-Jacobi, the domains with
 * Gauss-Seidel (solver_domains.c). Dot products are sums of a block, and the blocks' sums in order,
 * as in the sequential program; and what is in one domain is swept by one rank. With --bits=any
 * they are of SOLVER_CHUNK vertices whatever the preconditioner, and PETSc solves the system.
 *
 * Rank 0 leads: it has the whole cloth and runs fabric. Functions below that take a `whole` are
 * called by all ranks at once; only the leader's is read or written, the others pass NULL.
 */
#ifndef FABRIC_MPI_PART_H
#define FABRIC_MPI_PART_H

#include <petscsf.h>

#include "bits.h"
#include "scene/scene.h"
#include "step/simulation_state.h"

enum { LEADER = 0 };

/** Consecutive vertices of the cloth. */
typedef struct own_block {
    int number;     /* among the whole cloth's */
    int begin, end; /* in the part's own numbers */
    int sends;      /* are some of them ghosts of other ranks? */
} own_block;

/** The sums of all blocks of the cloth, as they come in rank by rank. */
typedef struct block_sums {
    int count;    /* blocks of the whole cloth */
    int *order;   /* [count] which block's sum it is */
    int *counts;  /* [ranks] */
    int *starts;  /* [ranks] */
    double *came; /* [count] */
    double *sum;  /* [count] in the order of the blocks */
} block_sums;

typedef struct part {
    int rank, ranks;
    int vertices; /* of the whole cloth */
    bits_order bits;
    scene scene; /* the cloth's material and surroundings, without pins and bodies */
    mesh mesh;
    simulation *sim; /* of `mesh`: its elements, system, and the solver's arrays */
    struct domain_solver
        *domains;                 /* Gauss-Seidel, with the domains of the whole cloth; else NULL */
    struct petsc_solver *petsc;   /* --bits=any (solution_petsc.h); else NULL */
    struct part_picture *picture; /* of the division, which the leader draws; else NULL */
    double (*diagonal)[9]; /* [mesh.vertex_count] of the matrix, on its way from or to the leader */
    int *global;      /* [mesh.vertex_count] each vertex' number in the whole mesh, ascending */
    int *hinge;       /* [mesh.hinge_count] the same for hinges */
    own_block *block; /* [blocks] ascending */
    int blocks;
    block_sums sums;
    PetscSF all;     /* from the leader's vertices to the part's, */
    PetscSF own;     /* to those that it owns, */
    PetscSF ghosts;  /* and from their owners to the ghosts, */
    PetscSF kind[2]; /* to those in even domains, and in odd ones; NULL without domains */
} part;

/** Lays out every rank's part. Collective; whole and of: the leader's, else NULL. Ends the program
 *  where memory is out. */
void part_make(part *p, bits_order bits, const mesh *whole, const scene *of);
void part_free(part *p);

/** Are the blocks Gauss-Seidel's domains? */
int part_has_domains(const scene *s, bits_order bits);
/** How many blocks a cloth of so many vertices has: at most so many ranks can have a part. */
int part_block_count(const scene *s, bits_order bits, int vertices);

/** From the leader to the vertices whose diagonal and constraints a solution uses: Gauss-Seidel
 *  scales the blocks of a row by both vertices, and PETSc's matrix has their constraints. */
static inline PetscSF part_solved(const part *p) {
    return p->domains || p->petsc ? p->all : p->own;
}

/* ---- exchange; the unit is of `size` doubles a vertex ---- */
/** whole [vertices] to local [mesh.vertex_count]. */
void part_receive(PetscSF sf, int size, const void *whole, void *local);
/** The same with one byte or one int a vertex. */
void part_receive_bytes(PetscSF sf, const unsigned char *whole, unsigned char *local);
void part_receive_ints(PetscSF sf, const int *whole, int *local);
/** The same back, of those that each rank owns. */
void part_return(const part *p, int size, const void *local, void *whole);
/** Ghosts become what their owners have. value [mesh.vertex_count][3] */
void part_update_ghosts(const part *p, double (*value)[3]);
/** Those in odd domains alone, or in even ones, in two halves: between them the rank may work on
 * what is not sent and not received. */
void part_update_kind_begin(const part *p, int odd, double (*value)[3]);
void part_update_kind_end(const part *p, int odd, double (*value)[3]);
/** The sum over all blocks of the cloth, in order, of own [blocks]: the same on all ranks. With
 *  --bits=any in an order that is MPI's. */
double part_sum(const part *p, const double *own);
/** The same, by SOLVER_CHUNK vertices, of one term a vertex, term [mesh.vertex_count], where blocks
 *  are others. */
double part_sum_terms(const part *p, const double *term);

/** With the option -part_view (PETSC_OPTIONS), prints what each rank has. Collective. */
void part_view(const part *p);

/* A stage of PETSc's log (-log_view), from begin to end. */
void part_stage_begin(const char *name);
void part_stage_end(void);

/** Ends all ranks with a message. */
_Noreturn void part_give_up(const char *why);

#endif
