/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** A scene, read from a YAML file; scenes/README.md documents the format. SI units. */
#ifndef FABRIC_SCENE_H
#define FABRIC_SCENE_H

#include <stddef.h>

#include "mesh/mesh.h"

typedef enum collider_kind {
    COLLIDER_PLANE,
    COLLIDER_BOX,
    COLLIDER_SPHERE,
    COLLIDER_CYLINDER,
    COLLIDER_MESH
} collider_kind;

enum { SCENE_FILE_SIZE = 1024 };

/** The pose of a collider at a time (see motion.h). */
typedef struct keyframe {
    double time;    /* s, ascending */
    double move[3]; /* m, displacement from the collider's position */
    double angle;   /* degrees, rotation about the collider's turn_axis */
} keyframe;

typedef struct collider {
    collider_kind kind;
    double position[3]; /* m, centre (for a plane: a point of it) at time 0 */
    double velocity[3]; /* m/s */
    double axis[3];     /* unit: plane's normal, cylinder's axis */
    double size[3];     /* box: half edges; sphere and cylinder: radius, cylinder: half length */
    double friction;    /* Coulomb coefficient */
    double gap;         /* m, distance at which cloth rests on the collider */
    char file[SCENE_FILE_SIZE]; /* mesh: full path of a file for input/mesh_file.h */
    struct surface *surface;    /* mesh: read from the file; freed by scene_free */
    double from, until;         /* s, interval in which the collider exists; until 0: no end */
    double turn_axis[3];        /* unit, axis of the keyframes' rotations */
    int keyframe_count;         /* 0: the collider moves with its constant velocity */
    keyframe *keyframes;        /* [keyframe_count]; owned by the scene */
} collider;

/** How a pin selects its vertices. */
typedef enum pin_kind { PIN_RECTANGLE, PIN_BOX, PIN_NEAREST, PIN_VERTICES } pin_kind;

typedef struct pin {
    int by;                       /* pin_kind */
    double low[2], high[2];       /* m, rectangle of material coordinates */
    double box_low[3];            /* m, lowest corner of a box in space */
    double box_high[3];           /* m, highest corner; the pin selects the vertices that start in
                                     the box */
    double nearest[3];            /* m, a point: selects the vertex that starts nearest to it */
    int vertex_count;             /* length of `vertices` */
    int *vertices;                /* [vertex_count] numbers before reordering, from 1; owned by the
                                   * scene */
    double velocity[3];           /* m/s; 0: the pinned vertices are held in place */
    double move_from, move_until; /* s, interval in which the pin moves; move_until 0: no end */
    double until;                 /* s, time at which the pin releases the cloth; 0: never */
} pin;

/** Limits of a step; a step that exceeds one is repeated with half the length (see monitor.h). */
typedef struct monitor_limits {
    double energy;      /* limit for the gain in a step, as a fraction of the initial and the added
                         * energy */
    double growth;      /* limit for the growth of a triangle's strain in a step */
    double strain;      /* the growth is limited only if the strain ends above this */
    double penetration; /* m, limit for the depth of a vertex in a collider */
    int off;            /* true: no limits; a step is rejected only if it is not finite, not solved
                         * or passing */
} monitor_limits;

/** The source of the cloth's mesh. */
typedef enum sheet_kind { SHEET_GENERATED, SHEET_FILE } sheet_kind;

/** The rest shape of a cloth from a file. */
typedef enum sheet_rest { REST_POSITIONS, REST_TEXTURE } sheet_rest;

/** The shape in which bending is at rest: the flat cloth, or the cloth's start. */
typedef enum sheet_angles { ANGLES_FLAT, ANGLES_OF_MESH } sheet_angles;

/** A section `mesh`. */
typedef struct scene_cloth {
    int from;                   /* sheet_kind */
    char file[SCENE_FILE_SIZE]; /* SHEET_FILE: path of a mesh for input/mesh_file.h */
    double scale;               /* SHEET_FILE: metres in a unit of the file */
    int rest;                   /* sheet_rest */
    int rest_angles;            /* sheet_angles */
    struct mesh *sheet;         /* SHEET_FILE: the mesh as read; freed by scene_free */
    int vertices, boundary;     /* number of vertices, and of those on the border; SHEET_FILE: the
                                 * file's number, and 0 */
    double side;                /* m, side of the square; SHEET_FILE: the square root of the area */
    unsigned seed;
    mesh_order order;
    double origin[3]; /* m, the sheet's centre */
    double normal[3]; /* unit, normal of the sheet's plane */
} scene_cloth;

/** A section `material`. */
typedef struct scene_material {
    double density; /* kg/m^2 */
#define MATERIAL(name, required) double name;
#include "effects/effects.def"
} scene_material;

/** A section `surroundings`. */
typedef struct scene_surroundings {
#define SURROUNDINGS(name) double name;
#include "effects/effects.def"
    double gravity[3];            /* m/s^2 */
    double wind[3];               /* m/s */
    double wind_from, wind_until; /* s, interval in which the wind blows; wind_until 0: no end */
} scene_surroundings;

/** A section `self_collision`. */
typedef struct scene_self_collision {
    double gap;      /* m, distance that cloth keeps from itself; 0: cloth may pass through
                      * itself */
    double friction; /* Coulomb coefficient */
} scene_self_collision;

/** Method of contact, in the order of the values of contact.method. */
typedef enum contact_method {
    CONTACT_CONSTRAINTS, /* vertices are constrained (collision.h), and impulses given (impact.h) */
    CONTACT_BARRIER      /* contact by an energy: barrier.h */
} contact_method;

/** A section `contact`. */
typedef struct scene_contact {
    int method;   /* contact_method */
    int untangle; /* with barriers: overlapping parts are separated before the first step */
} scene_contact;

/** A section `time`. */
typedef struct scene_time {
    double step; /* s */
    int steps;
    int integrator; /* integrator_kind of integrator.h */
} scene_time;

/** A section `solution`. */
typedef struct scene_solution {
    double tolerance; /* relative tolerance of conjugate gradients */
    int max_iterations;
    int method;              /* solver_method of solver.h */
    int preconditioner;      /* preconditioner_kind of solver.h */
    int precision;           /* solver_precision of solver.h */
    double newton_tolerance; /* tolerance of Newton's method, relative to the right-hand side */
    int newton_iterations;   /* limit of Newton's iterations in a step */
    double sleep;            /* m/s, a cloth slower than this for some steps sleeps; 0: never */
} scene_solution;

/** The names in scene files of the values of mesh.order, time.integrator, solution.method, ..., in
 *  the order of their enumerations, NULL after the last. */
extern const char *const scene_orders[], *const scene_integrators[],
                                             *const scene_methods[], *const scene_preconditioners[],
                                                                         *const scene_precisions[];

/** Members have the names of the file's sections. */
typedef struct scene {
    char name[64];
    scene_cloth mesh;
    scene_material material;
    scene_surroundings surroundings;
    int pin_count;
    pin *pins; /* [pin_count] */
    int collider_count;
    collider *colliders; /* [collider_count] */
    scene_contact contact;
    scene_self_collision self_collision;
    scene_time time;
    scene_solution solution;
    monitor_limits monitor;
} scene;

/** Reads a scene. Returns 0, or -1 after a message "file:line: ..., expected ..." on standard
 * error. For an unknown key it has the nearest valid name. */
int scene_read(scene *s, const char *path);
/** Applies an assignment such as material.bend=0.01 (--set). Its left side has the file's keys,
 *  joined by dots. Returns 0, or -1 after a message. */
int scene_set(scene *s, const char *assignment);
void scene_free(scene *s);

/** Makes the scene's cloth: generated or from its file, placed by origin and normal, connected,
 *  numbered in its order. new_of_old: as for mesh_reorder, [s->mesh.vertices] or NULL. Returns 0,
 *  or -1 after a message on standard error. */
int scene_mesh(const scene *s, mesh *m, int *new_of_old);

/** Does wind ever act on the cloth? */
static inline int scene_has_wind(const scene *s) {
    return (s->surroundings.drag > 0 || s->surroundings.tangential_drag > 0) &&
           (s->surroundings.wind[0] != 0 || s->surroundings.wind[1] != 0 ||
            s->surroundings.wind[2] != 0);
}

/** Writes the scene so that scene_read gives the same bits. Returns 0, or -1 with errno set. */
int scene_write(const scene *s, const char *path);

/** Returns the text, of *size bytes, that scene_write writes, or NULL if out of memory. The caller
 *  frees it. */
char *scene_text(const scene *s, size_t *size);
/** Like scene_read, but from a text in memory, which is not changed. Messages begin with `name`
 *  instead of the file's name. */
int scene_read_text(scene *s, char *text, size_t size, const char *name);

/** Do two scenes differ in anything but the number of steps and the names of files? True also if
 * memory runs out. If they differ, the first difference is in text[256]: "'material.bend' is 0.01,
 * there 0". */
int scene_differ(const scene *a, const scene *b, char *text);

#endif
