/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Prescribed changes of velocity (Baraff and Witkin 1998, section 5). A vertex's change of velocity
 * in a step is dv = S y + z. S = I - sum e e' projects the unknown y onto the free directions. The
 * e are the orthonormal directions in which the change is given, and z is the given change in these
 * directions.
 */
#ifndef FABRIC_CONSTRAINT_H
#define FABRIC_CONSTRAINT_H

#include "base/vector.h"

typedef struct vertex_constraint {
    double S[3][3]; /* projection onto free directions */
    double z[3];    /* m/s, the given change of velocity */
} vertex_constraint;

/** S and z are stored only for vertices that have been constrained; others have the identity and 0.
 */
typedef struct constraints {
    int count;               /* number of vertices */
    unsigned char *given;    /* [count] number of given directions: 0 (free) to 3 (all) */
    int *place;              /* [count] index in `list`, or -1; NULL: no vertex has an entry */
    vertex_constraint *list; /* [used] */
    int used, room;
} constraints;

/** Makes all vertices free. Returns 0, or -1 if out of memory. */
int constraints_init(constraints *c, int count);
void constraints_free(constraints *c);

/** Adds vertex i to `list`, if it is not in it. Returns 0, or -1 if out of memory. To be called by
 *  one thread, before constraint_give. */
int constraint_place(constraints *c, int i);

/** Makes vertex i free; it stays in `list`. */
void constraint_release(constraints *c, int i);

/** The entry of vertex i, which must be in `list`. */
static inline const vertex_constraint *constraint_at(const constraints *c, int i) {
    return &c->list[c->place[i]];
}

/** S of any vertex. */
static inline const double (*constraint_projection(const constraints *c, int i))[3] {
    static const double identity[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    return c->given[i] > 0 ? (const double(*)[3])constraint_at(c, i)->S : identity;
}

/** z of any vertex. */
static inline const double *constraint_change(const constraints *c, int i) {
    static const double none[3] = {0, 0, 0};
    return c->given[i] > 0 ? constraint_at(c, i)->z : none;
}

/** Replaces r by S r, with the S of vertex i. */
static inline void constraint_filter(const constraints *c, int i, double r[3]) {
    if (c->given[i] == 0)
        return;
    const double whole[3] = {r[0], r[1], r[2]};
    const vertex_constraint *of = constraint_at(c, i);
    for (int a = 0; a < 3; a++)
        r[a] = vector_dot(of->S[a], whole);
}

/**
 * Prescribes d[k] . dv = change[k] (m/s) for `count` directions d (of any length except 0). They
 * are orthonormalised in order (Gram-Schmidt); one that depends linearly on earlier ones (its
 * squared remainder is below 1e-8) is left out, so that earlier directions win conflicts. The
 * vertex must be in `list`.
 */
void constraint_give(constraints *c, int i, int count, const double (*d)[3], const double *change);

#endif
