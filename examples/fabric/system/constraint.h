/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Given directions of a vertex' velocity change, and their values: Baraff and Witkin 1998, section
 * 5. For each vertex dv = S y + z with S = I - sum e e' over orthonormal given directions e, and z
 * the given change of velocity along them.
 */
#ifndef FABRIC_CONSTRAINT_H
#define FABRIC_CONSTRAINT_H

#include "base/vector.h"

typedef struct vertex_constraint {
    double S[3][3]; /* projection onto free directions */
    double z[3];    /* m/s */
} vertex_constraint;

/** Vertices that never are constrained have no S and z: those are the identity and 0. */
typedef struct constraints {
    int count;               /* vertices */
    unsigned char *given;    /* [count] directions given: 0 (free) to 3 (all) */
    int *place;              /* [count] in `list`; -1: none. NULL: no vertex has a place */
    vertex_constraint *list; /* [used] */
    int used, room;
} constraints;

/** All free. 0, or -1: out of memory. */
int constraints_init(constraints *c, int count);
void constraints_free(constraints *c);

/** Makes a place for what vertex i is given, if it has none. 0, or -1: out of memory. To be called
 *  by one thread, before constraint_give. */
int constraint_place(constraints *c, int i);

/** Lets vertex i free. It keeps its place. */
void constraint_release(constraints *c, int i);

/** What vertex i is given, which is constrained. */
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

/** r = S r of vertex i. */
static inline void constraint_filter(const constraints *c, int i, double r[3]) {
    if (c->given[i] == 0)
        return;
    const double whole[3] = {r[0], r[1], r[2]};
    const vertex_constraint *of = constraint_at(c, i);
    for (int a = 0; a < 3; a++)
        r[a] = vector_dot(of->S[a], whole);
}

/**
 * Demands that d[k] . dv = change[k] (m/s) for `count` directions d (of any length but 0). They are
 * made orthonormal in turn; one that depends on those before (within 1e-8 squared) is left out, so
 * earlier demands win where they conflict. The vertex has a place.
 */
void constraint_give(constraints *c, int i, int count, const double (*d)[3], const double *change);

#endif
