/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Shared by the files of this solver: its layout, and the passes of an iteration, each over one
 * domain unless stated otherwise. Passes over different domains of a kind, even or odd, may run in
 * parallel; the other kind must be complete before.
 */
#ifndef FABRIC_SOLVER_DOMAINS_PARTS_H
#define FABRIC_SOLVER_DOMAINS_PARTS_H

#include "solver_parts.h"
#include "system/constraint.h"
#include "system/system.h"

/* A block of `across` as its column sees it. */
typedef struct reached {
    int row, block;
} reached;

struct domain_solver {
    const block_matrix *A;
    int count;               /* domains */
    int *start;              /* [count + 1] a domain's first vertex */
    int *domain;             /* [rows] a vertex' domain */
    int *place;              /* [A's blocks] its index in the matrix that it belongs to */
    block_matrix within;     /* of U, within domains */
    block_matrix across;     /* of U, from even domains' vertices to odd ones' */
    int *reached_start;      /* [rows + 1] where in `reached` a column of `across` begins */
    reached *reached;        /* [across' blocks] column by column, each from its first row on */
    block_matrix between;    /* E, and D^ - 2 I as its diagonal */
    int has_between;         /* is E more than 0? */
    double (*root)[3][3];    /* [rows] C^-1, lower triangles */
    double (*direction)[3];  /* p */
    double (*residual)[3];   /* of the transformed system */
    double (*correction)[3]; /* its solution */
    double (*swept)[3];      /* t */
    double (*image)[3];      /* w, then (I + U)^-T w */
    double *sum_direction, *sum_residual; /* [count] partial sums of p . image and r . r */
    arrays own;                           /* of those above, but for the matrices' */
};

/** The number of domains of a cloth with this number of vertices. */
int domain_count(int vertices);
/** The first vertex of a domain; for domain == domain_count: vertices. */
int domain_start(int vertices, int domain);

/** Domains begin at start [count + 1], vertices of A; NULL: out of memory. If A is a part of a
 *  cloth, the domains are those of the whole; domains of other parts may be empty or incomplete. */
domain_solver *domain_solver_divided(const block_matrix *A, int count, const int *start);

/** All matrices from A, and roots. */
void domain_build(domain_solver *d, const constraints *c);

/** residual = C^-1 r, of all vertices. */
void domain_scale(domain_solver *d, const double (*r)[3]);

/** to = (I + U)^-1 from, row by row from the last; an even domain reads `to` of odd ones. to may be
 *  from. */
void domain_sweep_up(const domain_solver *d, int domain, const double (*from)[3], double (*to)[3]);

/** r = (I + U)^-T r, in place; an odd domain reads r of even ones. */
void domain_sweep_down(const domain_solver *d, int domain, double (*r)[3]);

/** The residual scaled, and of even domains swept down, becomes the transformed one; returns its
 *  square, r' M^-1 r. */
double domain_transform(domain_solver *d, int domain);

/** Begins an iteration: computes t, and w without its product with `between`, which adds the
 *  diagonal's part as well. If `between` has no other blocks, w is complete, and even domains are
 *  swept down at once. An even domain reads t of odd ones. */
void domain_sweep_direction(domain_solver *d, int domain);

/** Sweeps the rest down; returns p . image. An odd domain reads w, swept down, of even ones. */
double domain_finish_image(domain_solver *d, int domain);

/** correction += alpha p, residual -= alpha image; returns the residual's square. */
double domain_advance(domain_solver *d, int domain, double alpha);

/** p = residual + beta p */
void domain_turn(domain_solver *d, int domain, double beta);

/** dv += the correction after its upward sweep, in the units of the system, for all vertices. */
void domain_add_correction(const domain_solver *d, double (*dv)[3]);

#endif
