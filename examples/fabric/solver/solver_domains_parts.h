/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Shared by the files of this solver: its layout, and the passes of an iteration, each over one
 * domain unless stated otherwise. A pass may run in parallel over all even domains, or over all odd
 * ones; passes that read the other kind's results must run after it.
 */
#ifndef FABRIC_SOLVER_DOMAINS_PARTS_H
#define FABRIC_SOLVER_DOMAINS_PARTS_H

#include "solver_parts.h"
#include "system/constraint.h"
#include "system/system.h"

/* A block of `across` in the list by columns. */
typedef struct reached {
    int row, block;
} reached;

struct domain_solver {
    const block_matrix *A;
    int count;               /* domains */
    int *start;              /* [count + 1] a domain's first vertex */
    int *domain;             /* [rows] a vertex' domain */
    int *place;              /* [A's blocks] a block's index in the matrix to which it belongs */
    block_matrix within;     /* U's blocks within domains */
    block_matrix across;     /* U's blocks with an even domain's row and an odd domain's column */
    int *reached_start;      /* [rows + 1] index in `reached` of a column's first block */
    reached *reached;        /* [across' blocks] column by column, rows ascending */
    block_matrix between;    /* E, and D^ - 2 I as its diagonal */
    int has_between;         /* has E any blocks? */
    double (*root)[3][3];    /* [rows] C^-1, lower triangles */
    double (*direction)[3];  /* p */
    double (*residual)[3];   /* of the transformed system */
    double (*correction)[3]; /* its solution */
    double (*swept)[3];      /* t */
    double (*image)[3];      /* w, then (I + U)^-T w */
    double *sum_direction, *sum_residual; /* [count] partial sums of p . image and r . r */
    arrays own;                           /* all arrays above except those of the matrices */
};

/** The number of domains of a cloth with this number of vertices. */
int domain_count(int vertices);
/** The first vertex of a domain; for domain == domain_count: vertices. */
int domain_start(int vertices, int domain);

/** A solver whose domains begin at the vertices start [count + 1] of A; NULL: out of memory. If A
 * is one rank's part of a cloth, the domains are those of the whole cloth, and those of other parts
 * are empty or incomplete. */
domain_solver *domain_solver_divided(const block_matrix *A, int count, const int *start);

/** Computes all matrices and the roots from A. */
void domain_build(domain_solver *d, const constraints *c);

/** residual = C^-1 r, for all vertices. */
void domain_scale(domain_solver *d, const double (*r)[3]);

/** to = (I + U)^-1 from, row by row from the last; an even domain reads `to` of odd ones. to may be
 *  from. */
void domain_sweep_up(const domain_solver *d, int domain, const double (*from)[3], double (*to)[3]);

/** r = (I + U)^-T r, in place; an odd domain reads r of even ones. */
void domain_sweep_down(const domain_solver *d, int domain, double (*r)[3]);

/** Transforms the residual after scaling and the even domains' downward sweep; returns its squared
 *  norm, r' M^-1 r. */
double domain_transform(domain_solver *d, int domain);

/** Begins an iteration: computes t, and w without the product with `between` (E and the diagonal).
 *  If `between` has only the diagonal, w is completed here, and even domains are swept down at
 * once. An even domain reads t of odd ones. */
void domain_sweep_direction(domain_solver *d, int domain);

/** Completes the downward sweep; returns p . image. An odd domain reads the swept w of even ones.
 */
double domain_finish_image(domain_solver *d, int domain);

/** correction += alpha p, residual -= alpha image; returns the residual's squared norm. */
double domain_advance(domain_solver *d, int domain, double alpha);

/** p = residual + beta p */
void domain_update_direction(domain_solver *d, int domain, double beta);

/** dv += C^-T correction, after the correction's upward sweep, for all vertices. */
void domain_add_correction(const domain_solver *d, double (*dv)[3]);

#endif
