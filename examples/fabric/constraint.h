/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Which directions of a vertex' velocity are given, and what they are given: Baraff and Witkin
 * 1998, section 5. For each vertex dv = S y + z with S = I - sum e e' over orthonormal given
 * directions e, and z the change of velocity given along them.
 */
#ifndef FABRIC_CONSTRAINT_H
#define FABRIC_CONSTRAINT_H

typedef struct constraints {
    int count;            /* vertices */
    unsigned char *given; /* [count] directions given: 0 (free) to 3 (all) */
    double (*S)[3][3];    /* [count] projection on what is free */
    double (*z)[3];       /* [count] m/s */
} constraints;

/** All free. 0, or -1: out of memory. */
int constraints_init(constraints *c, int count);
void constraints_free(constraints *c);

/** Lets vertex i free. */
void constraint_release(constraints *c, int i);

/**
 * Demands that d[k] . dv = change[k] (m/s) for `count` directions d (of any length but 0). They are
 * made orthonormal in turn; one that depends on those before (within 1e-8 squared) is left out, so
 * earlier demands win where they conflict.
 */
void constraint_give(constraints *c, int i, int count, const double (*d)[3], const double *change);

#endif
