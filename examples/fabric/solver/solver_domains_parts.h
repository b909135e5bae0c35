/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Shared by the files of the domain solver; solver_domains.c explains the symbols. Declares its
 * layout and the passes of an iteration. A pass handles one domain unless stated otherwise. It may
 * run in parallel over all even domains, or over all odd ones. A pass that reads results of the
 * other kind must run after that kind.
 */
#ifndef FABRIC_SOLVER_DOMAINS_PARTS_H
#define FABRIC_SOLVER_DOMAINS_PARTS_H

#include "solver_domains_turns.h"
#include "solver_parts.h"
#include "system/constraint.h"
#include "system/system.h"

/* An entry in the list of blocks of `across` by columns: the block's row and its index. */
typedef struct reached {
    int row, block;
} reached;

/* The blocks of `across` by columns. */
typedef struct reached_columns {
    int *start;     /* [rows + 1] index in `entry` of a column's first block */
    reached *entry; /* [blocks of `across`] the blocks column by column, rows ascending */
} reached_columns;

struct domain_solver {
    const block_matrix *A;
    int count;               /* number of domains */
    int *start;              /* [count + 1] each domain's first vertex */
    int *domain;             /* [rows] each vertex's domain */
    domain_turn *turn;       /* [count] */
    int *place;              /* [A's blocks] each block's index in `within`, `across` or
                              * `between` */
    block_matrix within;     /* U's blocks within domains */
    block_matrix across;     /* U's blocks with an even domain's row and an odd domain's column */
    reached_columns columns; /* the same blocks by columns */
    block_matrix between;    /* the blocks of E, with D^ - 2 I as the diagonal */
    int has_between;         /* has E any blocks? */
    double (*root)[3][3];    /* [rows] C^-1, lower triangles */
    double (*direction)[3];  /* p */
    double (*residual)[3];   /* residual of the transformed system */
    double (*correction)[3]; /* solution of the transformed system */
    double (*swept)[3];      /* t = (I + U)^-1 p */
    double (*image)[3];      /* w, then (I + U)^-T w */
    double *sum_direction, *sum_residual; /* [count] partial sums of p . image and r . r */
    arrays own;                           /* all arrays above except those of the matrices */
};

/** Returns the number of domains of a cloth with this number of vertices. */
int domain_count(int vertices);
/** Returns the first vertex of a domain, or `vertices` if domain is domain_count(vertices). */
int domain_start(int vertices, int domain);

/** Creates a solver for A whose domains begin at the vertices start [count + 1]. Returns NULL if
 *  out of memory. If A is the part of a cloth that one MPI rank holds, the domains are those of the
 *  whole cloth; domains of other ranks are empty or incomplete. */
domain_solver *domain_solver_divided(const block_matrix *A, int count, const int *start);

/** Computes all matrices and the roots from A. */
void domain_build(domain_solver *d, const constraints *c);

/** Sets residual = C^-1 r for all vertices. */
void domain_scale(domain_solver *d, const double (*r)[3]);

/** Computes to = (I + U)^-1 from, from the last row to the first. An even domain reads `to` of odd
 *  domains. `to` and `from` may be the same array. */
void domain_sweep_up(const domain_solver *d, int domain, const double (*from)[3], double (*to)[3]);

/** Replaces r by (I + U)^-T r. An odd domain reads r of even domains. */
void domain_sweep_down(const domain_solver *d, int domain, double (*r)[3]);

/** Completes the transformation of the residual after domain_scale and the even domains' downward
 *  sweep. Returns the domain's part of its squared norm, r' M^-1 r with the preconditioner M. */
double domain_transform(domain_solver *d, int domain);

/** Begins an iteration: computes t, and w without its product with `between`. If `between` has only
 *  the diagonal, w is completed here, and even domains are swept down at once. An even domain reads
 *  t of odd domains. */
void domain_sweep_direction(domain_solver *d, int domain);

/** Completes the downward sweep and returns the domain's part of p . image. An odd domain reads the
 *  swept w of even domains. */
double domain_finish_image(domain_solver *d, int domain);

/** Adds alpha p to the correction and subtracts alpha image from the residual. Returns the domain's
 *  part of the residual's squared norm. */
double domain_advance(domain_solver *d, int domain, double alpha);

/** p = residual + beta p */
void domain_update_direction(domain_solver *d, int domain, double beta);

/** dv += C^-T correction, after the correction's upward sweep, for all vertices. */
void domain_add_correction(const domain_solver *d, double (*dv)[3]);

#endif
