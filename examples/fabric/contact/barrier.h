/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Contact as energy: incremental potential contact (Li et al. 2020, "Incremental Potential Contact:
 * Intersection- and Inversion-free, Large-Deformation Dynamics"; Li, Kaufman and Jiang 2021,
 * "Codimensional Incremental Potential Contact").
 *
 * The cloth and the bodies are one surface of triangles, the cloth's first; a body's vertices move
 * as its keyframes say. Each pair of a vertex and a triangle, or of two edges, that is nearer than
 * its reach has the energy, for the distance d and s = d / reach,
 *     B(d) = -stiffness (s - 1)^2 ln s        0 < s < 1, else 0     J
 * which is twice differentiable and grows without bound as d goes to 0 (Li et al. 2020, equation
 * 6). For edges e1 and e2, at first E1 and E2, the energy is multiplied by
 *     e(c) = (2 - c / eps) c / eps        c = |e1 x e2|^2 < eps = 1e-3 |E1|^2 |E2|^2
 * because the nearest points of parallel edges are not unique (equation 24 of the same paper). A
 * plane has no edges: each vertex forms a pair with it.
 *
 * No pair's features ever pass each other: conservative continuous collision detection cuts every
 * displacement to the fraction that is safe (barrier_part.c), and a start with crossings is
 * rejected (barrier_start.c).
 */
#ifndef FABRIC_BARRIER_H
#define FABRIC_BARRIER_H

#include "base/arrays.h"
#include "mesh/mesh.h"
#include "nearest.h"
#include "scene/scene.h"
#include "self_collision.h"

typedef enum barrier_kind { BARRIER_VERTEX, BARRIER_EDGES, BARRIER_PLANE } barrier_kind;

/** Two features that may come nearer to each other than `reach`. */
typedef struct barrier_pair {
    int vertex[4]; /* vertices of the surface; for a plane: the cloth's vertex, then the plane's
                    * point three times */
    barrier_kind kind;
    int collider; /* index, or -1 for the cloth itself */
    double reach; /* m */
} barrier_pair;

/** A pair within its reach. */
typedef struct barrier_contact {
    barrier_pair pair;
    nearest at;
} barrier_contact;

/** A contact at the beginning of a step, for friction: Li et al. 2020, section 5. */
typedef struct barrier_grip {
    barrier_contact touch; /* as it was at the beginning of the step */
    double most;           /* N, greatest friction force */
} barrier_grip;

/** An element's contribution to the gradient and to the positive semidefinite Hessian. */
typedef struct barrier_element {
    int vertex[4];
    double gradient[4][3];  /* N */
    double block[10][3][3]; /* N/m, (0,0) (0,1) ... (3,3); of vertices in the order of `vertex` */
} barrier_element;

typedef struct barrier_list {
    int pairs, contacts, grips, elements; /* lengths of the lists below */
    int pair_room, contact_room, grip_room, element_room;
    barrier_pair *pair;
    barrier_contact *contact;
    barrier_grip *grip;
    barrier_element *element;
} barrier_list;

typedef struct barrier {
    const scene *scene;
    const mesh *cloth;
    mesh surface;          /* triangles of cloth and bodies at initial positions, a body's in its
                            * own axes */
    double (*rest)[3];     /* [cloth's vertices] m, rest positions */
    int *component;        /* [cloth's vertices] connected component of the cloth */
    int *collider;         /* [surface's vertices] index of the vertex's collider; -1: of the
                            * cloth */
    unsigned char *driven; /* [surface's vertices] 1 if a pin or a body moves the vertex */
    double stiffness;      /* J */
    double slip_speed;     /* m/s, speed up to which friction grows */
    self_collision search; /* grid of the search, and candidate pairs */
    double margin;         /* m, candidates stay valid for displacements up to this */
    double (*searched)[3]; /* [surface's vertices] m, positions at the last search */
    int has_candidates;    /* the last search may be reused */
    barrier_list list;
    double (*begin)[3];        /* [surface's vertices] m, positions at the step's beginning */
    double (*x)[3];            /* [surface's vertices] m, current positions */
    double (*displacement)[3]; /* [surface's vertices] m, planned displacements */
    double (*goal)[3];         /* [surface's vertices] m, final positions of driven vertices */
    arrays own; /* all arrays above but those of surface, collider, search and list */
} barrier;

/** Keeps references to scene and cloth; mass [vertices] kg. Returns 0, or -1 with a message in
 *  error[200] if the scene is not supported or memory runs out. */
int barrier_init(barrier *b, const mesh *cloth, const scene *s, const double *mass, char *error);
void barrier_free(barrier *b);

/** Writes the positions of the bodies' vertices at `time` (s) to x, behind the cloth's vertices. */
void barrier_place_bodies(const barrier *b, double time, double (*x)[3]);

/** Lists the pairs that may come within their reach while x moves by any fraction of `displacement`
 *  (NULL stands for 0). Returns 0, or -1 if out of memory or if a number is not finite. */
int barrier_find_pairs(barrier *b, const double (*x)[3], const double (*displacement)[3]);

/** Discards the candidates of earlier searches, because a step's bits must not depend on them:
 *  candidates determine the order of pairs. */
static inline void barrier_begin_search(barrier *b) {
    b->has_candidates = 0;
}

/** Lists as contacts the pairs that are within their reach at x. Returns 0, or -1 if out of
 *  memory. */
int barrier_find_contacts(barrier *b, const double (*x)[3]);

/** Stores the last found contacts for friction. Returns 0, or -1 if out of memory. */
int barrier_grip_contacts(barrier *b);

/** Returns the fraction, 0 to 1, of `displacement` by which x may move without any listed pair
 *  passing. */
double barrier_allowed_part(const barrier *b, const double (*x)[3],
                            const double (*displacement)[3]);

/** Returns the listed pairs' energy at x, J, or infinity if a pair has passed. */
double barrier_energy(const barrier *b, const double (*x)[3]);

/** Returns friction's potential at x in a step of h s, J. */
double barrier_friction(const barrier *b, double h, const double (*x)[3]);

/** Computes the elements of all contacts, with the last found nearest points, and of all grips, at
 *  x. Returns 0, or -1 if out of memory. */
int barrier_make_elements(barrier *b, double h, const double (*x)[3]);

/** An edge that goes through a triangle. */
typedef struct barrier_crossing {
    int edge[2], triangle[3];
    int nearer;       /* the end of the edge that is nearer to the triangle's plane: 0 or 1 */
    double depth;     /* m, how far that end lies beyond the plane */
    double normal[3]; /* unit normal of the triangle, on the side of that end */
    double
        weight[3]; /* barycentric coordinates of the point in which the edge meets the triangle */
} barrier_crossing;

/** Called for each crossing; a status other than 0 ends the search. */
typedef int barrier_visitor(void *context, const barrier *b, const barrier_crossing *found);

/** Visits the crossings at b->x of cloth with bodies and, if the scene has self-collision, with
 *  itself, until the visitor returns a status other than 0. An edge that two triangles share is
 *  visited twice. Returns the visitor's last status (0 if there is no crossing), or -1 if out of
 *  memory. */
int barrier_visit_crossings(const barrier *b, barrier_visitor *visit, void *context);

/** Moves the cloth at b->x out of itself and out of bodies, as far as possible. Returns 0, or -1 if
 *  out of memory or if a number is not finite. barrier_check_start tests whether a crossing
 *  remains. */
int barrier_untangle(barrier *b);

/** Tests the cloth's start, after barrier_find_pairs at b->x. Returns 0, or -1 if the cloth crosses
 *  or touches itself or a body or starts in one, with features, depth and a remedy in error[200].
 *  Returns -1 also if out of memory. */
int barrier_check_start(barrier *b, char *error);

/** Finds the pair's nearest points at positions x of its vertices. */
void barrier_nearest(const barrier *b, const barrier_pair *pair, const double x[4][3],
                     nearest *found);

/** Copies the positions of the pair's vertices. */
static inline void barrier_gather(const int vertex[4], const double (*x)[3], double at[4][3]) {
    for (int k = 0; k < 4; k++)
        for (int a = 0; a < 3; a++)
            at[k][a] = x[vertex[k]][a];
}

#endif
