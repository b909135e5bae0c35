/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Cloth against colliders and pins, as constraints on vertices' velocities.
 *
 * The velocity of a vertex in contact is prescribed along the normal, so that it ends the step at
 * the collider's gap. The contact ends when the constraint has pulled for two steps. Friction is
 * Coulomb's: a vertex sticks (its whole velocity is prescribed: the collider's) while the
 * tangential force is at most friction x normal force. Otherwise it slides. The friction force is
 * computed with the normal force of the step before. It enters the linear system as -c (v -
 * v_collider) in the tangential plane with c = h friction force / slip speed, and so never reverses
 * a motion.
 */
#ifndef FABRIC_COLLISION_H
#define FABRIC_COLLISION_H

#include "base/arrays.h"
#include "impulse.h"
#include "mesh/mesh.h"
#include "motion.h"
#include "scene/scene.h"
#include "shape.h"
#include "system/constraint.h"
#include "system/system.h"

enum { CONTACTS_PER_VERTEX = 3 };

typedef struct contact {
    int collider;
    int sticks;        /* true: the vertex sticks; false: it slides */
    int pulls;         /* number of consecutive steps in which the constraint pulled */
    double normal[3];  /* unit */
    double speed;      /* m/s, prescribed along the normal */
    double force;      /* N, normal force of the last accepted step; > 0: it presses */
    double slip_speed; /* m/s, slip speed in the factor c of friction */
} contact;

typedef struct vertex_contacts {
    int count;
    contact list[CONTACTS_PER_VERTEX];
} vertex_contacts;

typedef struct met_triangle {
    int triangle, collider;
    int is_known;     /* has the following been computed in this step? */
    int meets;        /* does the collider penetrate the triangle, at these velocities? */
    double v[3][3];   /* m/s, the corners' velocities for which it was computed */
    double weight[3]; /* weights of the point of contact */
    approach found;
} met_triangle;

/** Triangles that a collider may penetrate between their vertices in the current step. */
typedef struct met_triangles {
    met_triangle *list; /* [count] */
    int count, room;
    int left;               /* how many of the triangles a collider still penetrates after the
                             * impulses */
    double gap;             /* m, the smallest gap of their colliders; infinite without triangles */
    double *distance;       /* [vertices] m, distance to the collider being tested; NULL: not
                             * allocated */
    unsigned char *is_near; /* [triangles] may the triangle meet the collider being tested? */
} met_triangles;

/** Colliders that the cloth cannot reach for some time: all that are not in `watched`. They are
 *  tested again when the cloth and the nearest of them may have moved so far that they meet. */
typedef struct out_of_reach {
    int *watched;     /* [count] indices of the colliders to be tested, ascending */
    int count;        /* -1: all are to be tested */
    double center[3]; /* m, centre of the cloth when all colliders were tested last */
    double time;      /* s, time of that test */
    double clearance; /* m, distance at that time from the centre to the nearest other collider,
                       * less its gap */
    double speed;     /* m/s, speed of the fastest other collider */
} out_of_reach;

/** The vertices that pins hold. */
typedef struct pinned_vertices {
    int *pin_of;        /* [vertices] index of the pin that holds it; -1: none. NULL: no pins */
    int count;          /* number of held vertices */
    int *list;          /* [count] the held vertices, ascending */
    double (*speed)[3]; /* [pins + 1] m/s, each pin's mean velocity in the current step; the last
                         * entry is 0 */
} pinned_vertices;

typedef struct collisions {
    const scene *scene;
    const mesh *mesh;
    const double *mass; /* [vertices] kg */
    pinned_vertices pinned;
    unsigned char *there; /* [colliders] does the collider exist now? */
    int *near_list;       /* [any_near] colliders that may touch the cloth in the current step,
                             ascending */
    body_motion *motion;  /* [colliders] motion in the current step, set for colliders in near_list
                           * that have keyframes; NULL if no collider has keyframes */
    int any_near;
    int any_there; /* number of colliders that exist now */
    out_of_reach others;
    int now_empty, before_empty; /* no vertex has a contact in `now`; none has one in `before` */
    long visits;                 /* number of vertices tested against colliders, all steps */
    long friction_visits;        /* number of contacts with friction, all steps */
    double stick_speed;          /* m/s, speed below which a sliding vertex sticks */
    vertex_contacts *before;     /* [vertices] contacts of the last accepted step; NULL without
                                  * colliders */
    vertex_contacts *now;        /* [vertices] contacts of the current step */
    double (*carried)[CONTACTS_PER_VERTEX][3]; /* [vertices] m/s, velocity of the colliders'
                                                * material at contacts in `now`; NULL: no collider
                                                * has keyframes */
    met_triangles met;
    arrays own; /* all arrays above, except those of `met` and pinned.list */
} collisions;

/** The index of the pin that holds the vertex, or -1 if none does. */
static inline int collisions_pin_of(const collisions *c, int vertex) {
    return c->pinned.pin_of ? c->pinned.pin_of[vertex] : -1;
}

/** Returns the velocity, [3] m/s, of the collider's material at the vertex's contact n of the
 *  current step. */
static inline const double *collisions_carried(const collisions *c, int vertex, int n) {
    return c->carried ? c->carried[vertex][n]
                      : c->scene->colliders[c->now[vertex].list[n].collider].velocity;
}

/** Keeps references to mesh, scene and mass [vertices] kg. A vertex without mass (in no triangle)
 *  is held in place. Returns 0, or -1 if out of memory. */
int collisions_init(collisions *c, const mesh *m, const scene *s, const double *mass);
void collisions_free(collisions *c);

/** Updates pins and colliders to those that exist at `time`. */
void collisions_follow(collisions *c, double time);

/** Finds the vertices that would come too near to a collider in a step of h s. The step begins at
 *  `time` (s) with positions x and velocities v; dv is the expected change of velocity. */
void collisions_detect(collisions *c, double time, double h, const double (*x)[3],
                       const double (*v)[3], const double (*dv)[3]);

/** Adds the friction of sliding contacts to A and b, for velocities v and a step of h s. */
void collisions_add_friction(collisions *c, double h, const double (*v)[3], linear_system *system);

/** Converts contacts and pins to constraints on dv. Returns 0, or -1 if out of memory. */
int collisions_constrain(const collisions *c, const double (*v)[3], constraints *given);

/** Adds the contacts that were not expected but occur with the solution dv. Returns their
 *  number. */
int collisions_add_missed(collisions *c, double time, double h, const double (*x)[3],
                          const double (*v)[3], const double (*dv)[3]);

/** Last resort for contacts that were missed: changes v so that x + h v stays outside, and adds
 *  the required work to *work, J. Returns the largest change of a velocity, m/s. */
double collisions_keep_out(collisions *c, double time, double h, const double (*x)[3],
                           double (*v)[3], double *work);

/** Finds the colliders that may touch the cloth in the step, with velocities v + dv. A NULL dv or v
 *  stands for 0. Later calls of the other functions test only these colliders. */
void collisions_find_near(collisions *c, double time, double h, const double (*x)[3],
                          const double (*v)[3], const double (*dv)[3]);

/** Finds the triangles that a near collider may penetrate between their vertices (shape_triangle.h)
 *  in the step; planes penetrate none. Returns 0, or -1 if out of memory. */
int collisions_find_triangles(collisions *c, double time, double h, const double (*x)[3],
                              const double (*v)[3]);

/** Gives one round of impulses to the triangles in c->met; `work` and result as for
 *  collisions_keep_out. */
double collisions_push_triangles(collisions *c, const movable *of, double time, double h,
                                 const double (*x)[3], double (*v)[3], double *work);

/** Counts in c->met.left the triangles that are still penetrated and could be moved. */
void collisions_check_triangles(collisions *c, const movable *of, double time, double h,
                                const double (*x)[3], const double (*v)[3]);

/** Returns the velocity along found->normal, m/s, that ends a step of h s at the collider's gap. A
 *  vertex inside is pushed out by at most the gap per step of the scene's length. The push remains
 *  in its velocity, so it must not be faster in a shorter step. */
double collisions_given_speed(const collisions *c, const collider *k, const approach *found,
                              double h);

/** Sets pinned vertices exactly to their positions and velocities at `time`. */
void collisions_place_pins(const collisions *c, double time, double (*x)[3], double (*v)[3]);

/** Accepts the step of h s with final velocities v and the solver's residual: stores the contacts'
 *  forces, and which stick or slide from now on. */
void collisions_accept(collisions *c, double h, const double (*v)[3], const double (*residual)[3]);

/** Returns the work in J of constraints and friction in the step of h s that ends with velocities
 *  v. The result is an upper bound if a collider moves. Colliders at rest do no positive work
 *  except to push vertices out. residual: the solver's, for a stage of stage_h s. */
double collisions_work(const collisions *c, const constraints *given, double h, double stage_h,
                       const double (*v)[3], const double (*residual)[3]);

/** Returns the depth in m of the deepest vertex that is inside a collider at `time` and not pinned,
 *  or 0 if there is none. */
double collisions_depth(const collisions *c, double time, const double (*x)[3]);

/** Returns the number of vertices that are inside a collider at `time` and not pinned. */
long collisions_inside(const collisions *c, double time, const double (*x)[3]);

/** Sets pin_of[i] = number for each vertex i that the pin holds, according to the mesh's initial
 *  positions. pin_of: [vertex_count]. */
void pin_find(const pin *p, const mesh *m, int number, int *pin_of);

#endif
