/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Impulses that keep features of the cloth (a vertex, a point of an edge or of a triangle) from
 *  meeting each other or a body. Pinned vertices have infinite mass, and vertices on a body have
 *  infinite mass for impulses into it. */
#ifndef FABRIC_IMPULSE_H
#define FABRIC_IMPULSE_H

struct collisions;

/** Which vertices may move: references to their masses, pins and contacts. */
typedef struct movable {
    const double *mass;              /* [vertices] kg */
    const struct collisions *bodies; /* these have the step's pins and contacts */
} movable;

/** Is the vertex pinned, or does it lie on a body? */
int movable_is_held(const movable *of, int vertex);

/** Computes the part of an impulse or velocity d that moves vertex i, which has velocity v [3] m/s.
 *  The part is 0 if the vertex is pinned, and lacks the component into a body on which it lies. A
 *  vertex that is leaving its body is free: otherwise impulses could lift it but not slow it down,
 *  and the rounds would not converge. */
void movable_part(const movable *of, int i, const double v[3], const double d[3], double part[3]);

/** Adds to v the part of `change` (m/s) that movable_part gives, but no velocity into a body on
 *  which vertex i lies. */
void movable_move(const movable *of, int i, const double change[3], double v[3]);

/** A point given by a weighted sum of vertices; its velocity is to be changed. */
typedef struct feature {
    int count; /* 1 to 4 */
    int vertex[4];
    double weight[4];
} feature;

/** The feature's velocity, m/s. */
void feature_velocity(const feature *f, const double (*v)[3], double speed[3]);

/** Can the feature be moved along the unit normal? Not if its point is far from all vertices that
 *  are not held: these would have to move many times as fast. */
int impulse_is_possible(const movable *of, const feature *f, const double (*v)[3],
                        const double normal[3]);

/** Changes the feature's velocity along the unit normal by `change` m/s, with Coulomb's friction
 *  against a surface that moves with `base` m/s (NULL: 0). Weights of both signs give equal and
 *  opposite impulses. Adds the energy gained to *work, J. Returns 0 if that is not possible. */
int impulse_give(const movable *of, const feature *f, const double normal[3], double change,
                 double friction, const double *base, double (*v)[3], double *work);

#endif
