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
 * which is twice differentiable and grows beyond all bounds as d goes to 0 (Li et al. 2020,
 * equation 6). For edges it is multiplied by e(c) = (2 - c / eps) c / eps, c = |e1 x e2|^2 < eps,
 * eps = 1e-3 |E1|^2 |E2|^2, because the nearest points of parallel edges are not unique (there,
 * equation 24). A plane is on one side only: its pairs are of each vertex and the plane.
 *
 * No pair passes: every change of positions is cut to the part that conservative continuous
 * collision detection allows (barrier_part.c), and a start in which something crosses is refused
 * (barrier_start.c). What crosses nowhere on the way from a state to the next never has to be
 * untangled.
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
    int vertex[4]; /* of the surface; of a plane: the cloth's, then three times the plane's point */
    barrier_kind kind;
    int collider; /* -1: the cloth itself */
    double reach; /* m */
} barrier_pair;

/** A pair within its reach. */
typedef struct barrier_contact {
    barrier_pair pair;
    nearest at;
} barrier_contact;

/** A contact at the beginning of a step, for friction: Li et al. 2020, section 5. */
typedef struct barrier_grip {
    barrier_contact touch; /* where the step began */
    double most;           /* N, friction's greatest force */
} barrier_grip;

/** An element's part of the gradient and of the positive semidefinite Hessian. */
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
    mesh surface;          /* all triangles; positions: where the cloth starts */
    double (*rest)[3];     /* [cloth's vertices] m, rest positions */
    int *component;        /* [cloth's vertices] which connected part of the cloth */
    int *collider;         /* [surface's vertices] -1: the cloth's */
    unsigned char *driven; /* [surface's vertices] moved by a pin or a body */
    double stiffness;      /* J */
    double slip_speed;     /* m/s, below which friction grows from 0 */
    self_collision search; /* the grid and its candidates; */
    double margin;         /* m, displacement of vertices for which candidates are kept; */
    double (*searched)[3]; /* [surface's vertices] m, positions of the search; */
    int has_candidates;    /* they may be reused */
    barrier_list list;
    double (*begin)[3]; /* [surface's vertices] m, positions at the step's beginning */
    double (*x)[3];     /* [surface's vertices] m, current positions */
    double (*way)[3];   /* [surface's vertices] m, planned displacements */
    double (*goal)[3];  /* [surface's vertices] m, final positions of driven vertices */
    arrays own;         /* of those above, all but the surface, its owners and the lists */
} barrier;

/** Keeps references to scene and cloth; mass [vertices] kg. 0, or -1 with a message in
 *  error[200]: the scene is not supported, or out of memory. */
int barrier_init(barrier *b, const mesh *cloth, const scene *s, const double *mass, char *error);
void barrier_free(barrier *b);

/** Where the vertices of bodies are at `time` (s): writes x from the cloth's last vertex on. */
void barrier_place_bodies(const barrier *b, double time, double (*x)[3]);

/** Lists the pairs that may come within their reach while x moves by part of `way` (NULL: rests).
 *  0, or -1: out of memory, or not all is finite. */
int barrier_find_pairs(barrier *b, const double (*x)[3], const double (*way)[3]);

/** Forgets the candidates of earlier searches. The order of pairs depends on them, hence the bits:
 *  those of a step must not depend on the steps before. */
static inline void barrier_begin_search(barrier *b) {
    b->has_candidates = 0;
}

/** Lists those of the pairs that are within their reach at x. 0, or -1: out of memory. */
int barrier_find_contacts(barrier *b, const double (*x)[3]);

/** Keeps the contacts found last for friction. 0, or -1: out of memory. */
int barrier_grip_contacts(barrier *b);

/** How much of `way` may be gone from x so that no listed pair passes: 0 to 1. */
double barrier_part_of_way(const barrier *b, const double (*x)[3], const double (*way)[3]);

/** The listed pairs' energy at x, J; infinite where a pair has passed. */
double barrier_energy(const barrier *b, const double (*x)[3]);

/** Friction's potential at x in a step of h s, J. */
double barrier_friction(const barrier *b, double h, const double (*x)[3]);

/** Fills the elements: of all contacts, with the nearest points found last, and of all grips, at x.
 *  0, or -1: out of memory. */
int barrier_make_elements(barrier *b, double h, const double (*x)[3]);

/** An edge that goes through a triangle. */
typedef struct barrier_crossing {
    int edge[2], triangle[3];
    int nearer;       /* the end of the edge that is nearer to the triangle's plane: 0 or 1 */
    double depth;     /* m, how far that end lies beyond the plane */
    double normal[3]; /* unit, of the triangle, on the side of that end */
    double weight[3]; /* of the triangle's vertices where the edge meets it */
} barrier_crossing;

/** Looks at a crossing; a status other than 0 ends the search. */
typedef int barrier_visitor(void *context, const barrier *b, const barrier_crossing *found);

/** Visits all crossings at b->x of cloth with itself and with bodies; an edge of two triangles is
 *  visited for each. The visitor's last status, or -1: out of memory. */
int barrier_visit_crossings(const barrier *b, barrier_visitor *visit, void *context);

/** Moves the cloth at b->x out of itself and out of bodies, as far as it can. 0, or -1: out of
 *  memory, or not all is finite. barrier_check_start says whether something is left. */
int barrier_untangle(barrier *b);

/** Is the cloth through itself or a body where it starts, or does it touch? Then -1, with features,
 *  depth and a remedy in error[200]; 0: neither. barrier_find_pairs was called for b->x. */
int barrier_check_start(barrier *b, char *error);

/** The pair's nearest points at x. */
void barrier_nearest(const barrier *b, const barrier_pair *pair, const double x[4][3],
                     nearest *found);

/** The positions of the pair's vertices. */
static inline void barrier_gather(const int vertex[4], const double (*x)[3], double at[4][3]) {
    for (int k = 0; k < 4; k++)
        for (int a = 0; a < 3; a++)
            at[k][a] = x[vertex[k]][a];
}

#endif
