/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The part of a cloth that one rank works on, as a separate mesh. It has the vertices that the rank
 * owns, and ghosts, which share a triangle or a hinge with an owned vertex, in the whole mesh's
 * order. The part has every element that touches a vertex the rank owns, in the order of the whole
 * mesh. So a row of the linear system that the rank owns gets the terms of the sequential program
 * in their order, and no terms are summed over the network. Terms that the elements add to rows of
 * ghosts are not used.
 *
 * Ownership is by blocks of vertices: blocks of SOLVER_CHUNK vertices with block-Jacobi, domains
 * with Gauss-Seidel (solver_domains.c). Dot products are computed within blocks and then summed
 * over the blocks in order, as in the sequential program; one rank sweeps all of a domain. With
 * --bits=any, blocks have SOLVER_CHUNK vertices whatever the preconditioner, and PETSc solves the
 * system.
 *
 * Rank 0 is the leader: it has the whole cloth and runs fabric. Functions below with a parameter
 * `whole` are collective; only the leader's argument is used, other ranks pass NULL.
 */
#ifndef FABRIC_MPI_PART_H
#define FABRIC_MPI_PART_H

#include <petscsf.h>

#include "bits.h"
#include "scene/scene.h"
#include "step/simulation_state.h"

enum { LEADER = 0 };

/** A block of consecutive vertices that the rank owns. */
typedef struct own_block {
    int number;     /* index among the whole cloth's blocks */
    int begin, end; /* first vertex and end, in the part's numbers */
    int sends;      /* are some of its vertices ghosts of other ranks? */
} own_block;

/** A sum over the whole cloth, in parts: one number for each block, received rank by rank. */
typedef struct block_sums {
    int count;    /* number of blocks of the whole cloth */
    int *order;   /* [count] the block to which a received sum belongs */
    int *counts;  /* [ranks] number of sums that each rank sends */
    int *starts;  /* [ranks] index of a rank's first sum in `came` */
    double *came; /* [count] the received sums */
    double *sum;  /* [count] the sums in the order of the blocks */
} block_sums;

typedef struct part {
    int rank, ranks;
    int vertices; /* number of vertices of the whole cloth */
    bits_order bits;
    scene scene; /* the cloth's material and surroundings, without pins and bodies */
    mesh mesh;
    simulation *sim; /* the simulation of `mesh`: its elements, system, and the solver's arrays */
    struct domain_solver
        *domains;                 /* Gauss-Seidel, with the domains of the whole cloth; else NULL */
    struct petsc_solver *petsc;   /* --bits=any (solution_petsc.h); else NULL */
    struct part_picture *picture; /* the leader's, if a picture was requested; else NULL */
    double (*diagonal)[9];        /* [mesh.vertex_count] buffer to exchange the matrix's diagonal */
    int *global;      /* [mesh.vertex_count] each vertex's number in the whole mesh, ascending */
    int *hinge;       /* [mesh.hinge_count] each hinge's number in the whole mesh, ascending */
    own_block *block; /* [blocks] ascending */
    int blocks;
    block_sums sums;
    PetscSF all;     /* exchange from the leader's vertices to all of the part's */
    PetscSF own;     /* exchange from the leader's vertices to those that the part owns */
    PetscSF ghosts;  /* exchange from owners to ghosts */
    PetscSF kind[2]; /* exchanges from owners to ghosts in even and in odd domains; NULL without
                      * domains */
} part;

/** Lays out every rank's part. Collective; `whole` and `of` are the leader's, or NULL on other
 *  ranks. Ends the program if out of memory. */
void part_make(part *p, bits_order bits, const mesh *whole, const scene *of);
void part_free(part *p);

/** Are the blocks Gauss-Seidel's domains? */
int part_has_domains(const scene *s, bits_order bits);
/** Returns the number of blocks of a cloth with this number of vertices, which is also the maximum
 *  number of ranks. */
int part_block_count(const scene *s, bits_order bits, int vertices);

/** Returns the exchange for diagonal and constraints. It includes ghosts if the solver uses theirs:
 *  Gauss-Seidel scales a block by both vertices, and PETSc's matrix includes both constraints. */
static inline PetscSF part_solved(const part *p) {
    return p->domains || p->petsc ? p->all : p->own;
}

/* ---- exchange of `size` doubles per vertex ---- */
/** Sends whole [vertices] to local [mesh.vertex_count]. */
void part_receive(PetscSF sf, int size, const void *whole, void *local);
/** Like part_receive, but with one byte or one int per vertex. */
void part_receive_bytes(PetscSF sf, const unsigned char *whole, unsigned char *local);
void part_receive_ints(PetscSF sf, const int *whole, int *local);
/** Sends the values of the vertices that each rank owns back to the leader. */
void part_return(const part *p, int size, const void *local, void *whole);
/** Sets the ghosts' values, value [mesh.vertex_count][3], to those of their owners. */
void part_update_ghosts(const part *p, double (*value)[3]);
/** Like part_update_ghosts, but only for ghosts in odd domains or in even ones, and split into
 *  begin and end. In between, the rank may use values that are neither sent nor received. */
void part_update_kind_begin(const part *p, int odd, double (*value)[3]);
void part_update_kind_end(const part *p, int odd, double (*value)[3]);
/** Sums own [blocks] of all ranks in the order of the cloth's blocks. The result is the same on all
 *  ranks. With --bits=any the order is MPI's. */
double part_sum(const part *p, const double *own);
/** Sums one term per vertex, term [mesh.vertex_count], by chunks of SOLVER_CHUNK vertices even if
 *  blocks are not chunks. */
double part_sum_terms(const part *p, const double *term);

/** With the option -part_view (PETSC_OPTIONS), prints the size of each rank's part. Collective. */
void part_view(const part *p);

/* Delimit a stage of PETSc's log (-log_view). */
void part_stage_begin(const char *name);
void part_stage_end(void);

/** Ends all ranks with a message. */
_Noreturn void part_give_up(const char *why);

#endif
