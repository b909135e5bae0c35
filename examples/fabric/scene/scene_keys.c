/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "scene_keys.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "mesh/surface.h"
#include "scene.h"

_Static_assert(sizeof((scene *)0)->name == TEXT_SIZE, "a text value fits the scene's name");

_Static_assert(sizeof((collider *)0)->file == FILE_SIZE, "a file fits the collider's");

_Static_assert(sizeof((scene_cloth *)0)->file == FILE_SIZE, "a file fits the scene's");

static const value_range any = {-1e300, 1e300, 0};
static const value_range positive = {0.0, 1e300, 1};
static const value_range not_negative = {0.0, 1e300, 0};
#define BETWEEN(low, high) (&(const value_range){low, high, 0})

/* A key with the name of its field. `of` has the bits of the kinds that have the key, or is 0 if
 * all have it. */
#define KEY(struct_, field, kind, required, components, range, of)                                 \
    { #field, kind, offsetof(struct_, field), required, components, range, of, NULL, NULL, NULL }
#define WHOLE(struct_, field, required, range)                                                     \
    KEY(struct_, field, VALUE_WHOLE, required, 1, range, 0)
#define NUMBER(struct_, field, required, range)                                                    \
    KEY(struct_, field, VALUE_NUMBER, required, 1, range, 0)
#define VECTOR(struct_, field, required, components)                                               \
    KEY(struct_, field, VALUE_VECTOR, required, components, &any, 0)
#define DIRECTION(struct_, field, required)                                                        \
    KEY(struct_, field, VALUE_DIRECTION, required, 3, &any, 0)
#define CHOICE(struct_, field, required, choices)                                                  \
    { #field, VALUE_CHOICE, offsetof(struct_, field), required, 1, &any, 0, choices, NULL, NULL }
#define SECTION(field, required, keys)                                                             \
    { #field, VALUE_SECTION, offsetof(scene, field), required, 1, &any, 0, NULL, keys, NULL }
#define LIST(struct_, field, keys, list)                                                           \
    { #field, VALUE_LIST, offsetof(struct_, field), 0, 1, &any, 0, NULL, keys, list }
#define END                                                                                        \
    { NULL, VALUE_TEXT, 0, 0, 0, NULL, 0, NULL, NULL, NULL }

const char *const scene_orders[] = {"generated", "sorted", "shuffled", "hilbert", "metis", NULL};
_Static_assert(sizeof scene_orders / sizeof *scene_orders == MESH_ORDER_DISSECTED + 2,
               "a word for each value, then NULL");
static const char *const contacts[] = {"constraints", "barrier", NULL};
_Static_assert(sizeof contacts / sizeof *contacts == CONTACT_BARRIER + 2,
               "a word for each value, then NULL");
static const char *const untangles[] = {"off", "on", NULL};
static const scene_key contact_keys[] = {CHOICE(scene_contact, method, 0, contacts),
                                         CHOICE(scene_contact, untangle, 0, untangles), END};
static const char *const kinds[] = {"plane", "box", "sphere", "cylinder", "mesh", NULL};
_Static_assert(sizeof kinds / sizeof *kinds == COLLIDER_MESH + 2,
               "a word for each value, then NULL");

const char *const scene_integrators[] = {"linear-euler", "euler", "bdf2", "midpoint", NULL};
const char *const scene_methods[] = {"conjugate-gradients", "direct", NULL};
const char *const scene_preconditioners[] = {"gauss-seidel", "block-jacobi",        "none",
                                             "jacobi",       "incomplete-cholesky", NULL};
const char *const scene_precisions[] = {"double", "float", "mixed", NULL};

/* A pseudo-key, the first of its section: the field for the kind, which follows from the keys
 * present in the file. */
#define KIND_BY_KEYS(struct_, field)                                                               \
    { "", VALUE_WHOLE, offsetof(struct_, field), 0, 1, &any, 0, NULL, NULL, NULL }

#define GENERATED (1u << SHEET_GENERATED)
#define FROM_FILE (1u << SHEET_FILE)
static const char *const rests[] = {"positions", "texture", NULL};
_Static_assert(sizeof rests / sizeof *rests == REST_TEXTURE + 2,
               "a word for each value, then NULL");
static const char *const angles[] = {"flat", "mesh", NULL};
_Static_assert(sizeof angles / sizeof *angles == ANGLES_OF_MESH + 2,
               "a word for each value, then NULL");
static const scene_key mesh_keys[] = {
    KIND_BY_KEYS(scene_cloth, from),
    KEY(scene_cloth, vertices, VALUE_WHOLE, 1, 1, BETWEEN(5, 2e7), GENERATED),
    KEY(scene_cloth, boundary, VALUE_WHOLE, 1, 1, BETWEEN(4, 1e7), GENERATED),
    KEY(scene_cloth, side, VALUE_NUMBER, 1, 1, &positive, GENERATED),
    KEY(scene_cloth, file, VALUE_FILE, 1, 1, &any, FROM_FILE),
    KEY(scene_cloth, scale, VALUE_NUMBER, 0, 1, &positive, FROM_FILE),
    {"rest", VALUE_CHOICE, offsetof(scene_cloth, rest), 0, 1, &any, FROM_FILE, rests, NULL, NULL},
    {"rest_angles", VALUE_CHOICE, offsetof(scene_cloth, rest_angles), 0, 1, &any, FROM_FILE, angles,
     NULL, NULL},
    KEY(scene_cloth, seed, VALUE_SEED, 0, 1, BETWEEN(0.0, 4294967295.0), 0),
    CHOICE(scene_cloth, order, 0, scene_orders),
    VECTOR(scene_cloth, origin, 0, 3),
    DIRECTION(scene_cloth, normal, 0),
    END};
_Static_assert(sizeof mesh_keys / sizeof *mesh_keys <= MOST_KEYS + 1,
               "no more keys than a reader counts");

/* The parameters of effects, from effects.def. */
static const scene_key material_keys[] = {NUMBER(scene_material, density, 1, &positive),
#define MATERIAL(name, required) NUMBER(scene_material, name, required, &not_negative),
#include "effects/effects.def"
                                          END};
_Static_assert(sizeof material_keys / sizeof *material_keys <= MOST_KEYS + 1,
               "no more keys than a reader counts");

static const scene_key surroundings_keys[] = {
    VECTOR(scene_surroundings, gravity, 0, 3),
#define SURROUNDINGS(name) NUMBER(scene_surroundings, name, 0, &not_negative),
#include "effects/effects.def"
    VECTOR(scene_surroundings, wind, 0, 3), NUMBER(scene_surroundings, wind_from, 0, &not_negative),
    NUMBER(scene_surroundings, wind_until, 0, &not_negative), END};

static const scene_key time_keys[] = {NUMBER(scene_time, step, 1, &positive),
                                      WHOLE(scene_time, steps, 1, BETWEEN(0, 1e9)),
                                      CHOICE(scene_time, integrator, 0, scene_integrators), END};

static const value_range tolerances = {0.0, 0.5, 1};
static const scene_key solution_keys[] = {
    NUMBER(scene_solution, tolerance, 0, &tolerances),
    WHOLE(scene_solution, max_iterations, 0, BETWEEN(1, 1e9)),
    CHOICE(scene_solution, method, 0, scene_methods),
    CHOICE(scene_solution, preconditioner, 0, scene_preconditioners),
    CHOICE(scene_solution, precision, 0, scene_precisions),
    NUMBER(scene_solution, newton_tolerance, 0, &tolerances),
    WHOLE(scene_solution, newton_iterations, 0, BETWEEN(1, 1e6)),
    NUMBER(scene_solution, sleep, 0, &not_negative),
    END};
_Static_assert(sizeof solution_keys / sizeof *solution_keys <= MOST_KEYS + 1,
               "no more keys than a reader counts");

static const char *const switches[] = {"on", "off", NULL};
static const scene_key monitor_keys[] = {
    {"watch", VALUE_CHOICE, offsetof(monitor_limits, off), 0, 1, &any, 0, switches, NULL, NULL},
    NUMBER(monitor_limits, energy, 0, &positive),
    NUMBER(monitor_limits, growth, 0, &positive),
    NUMBER(monitor_limits, strain, 0, &positive),
    NUMBER(monitor_limits, penetration, 0, &positive),
    END};

static const scene_key self_keys[] = {NUMBER(scene_self_collision, gap, 1, &not_negative),
                                      NUMBER(scene_self_collision, friction, 0, &not_negative),
                                      END};

#define BY(kind) (1u << PIN_##kind)
#define PLACE(field, components, kind) KEY(pin, field, VALUE_VECTOR, 1, components, &any, BY(kind))
static const scene_list vertex_list = {offsetof(pin, vertex_count), sizeof(int), NULL, NULL};
static const scene_key pin_keys[] = {KIND_BY_KEYS(pin, by),
                                     PLACE(low, 2, RECTANGLE),
                                     PLACE(high, 2, RECTANGLE),
                                     PLACE(box_low, 3, BOX),
                                     PLACE(box_high, 3, BOX),
                                     PLACE(nearest, 3, NEAREST),
                                     {"vertices", VALUE_NUMBERS, offsetof(pin, vertices), 1, 1,
                                      BETWEEN(1, 2e9), BY(VERTICES), NULL, NULL, &vertex_list},
                                     VECTOR(pin, velocity, 0, 3),
                                     NUMBER(pin, move_from, 0, &not_negative),
                                     NUMBER(pin, move_until, 0, &not_negative),
                                     NUMBER(pin, until, 0, &not_negative),
                                     END};
_Static_assert(sizeof pin_keys / sizeof *pin_keys <= MOST_KEYS + 1,
               "no more keys than a reader counts");

static const scene_key keyframe_keys[] = {NUMBER(keyframe, time, 1, &not_negative),
                                          VECTOR(keyframe, move, 0, 3),
                                          NUMBER(keyframe, angle, 0, &any), END};
static const keyframe keyframe_defaults;
static const scene_list keyframe_list = {offsetof(collider, keyframe_count), sizeof(keyframe),
                                         &keyframe_defaults, NULL};

#define OF(kind) (1u << COLLIDER_##kind)
static const scene_key collider_keys[] = {
    CHOICE(collider, kind, 1, kinds),
    VECTOR(collider, position, 0, 3),
    VECTOR(collider, velocity, 0, 3),
    {"normal", VALUE_DIRECTION, offsetof(collider, axis), 1, 3, &any, OF(PLANE), NULL, NULL, NULL},
    {"axis", VALUE_DIRECTION, offsetof(collider, axis), 1, 3, &any, OF(CYLINDER), NULL, NULL, NULL},
    {"half_edges", VALUE_VECTOR, offsetof(collider, size), 1, 3, &positive, OF(BOX), NULL, NULL,
     NULL},
    {"radius", VALUE_NUMBER, offsetof(collider, size), 1, 1, &positive, OF(SPHERE) | OF(CYLINDER),
     NULL, NULL, NULL},
    {"half_length", VALUE_NUMBER, offsetof(collider, size[1]), 1, 1, &positive, OF(CYLINDER), NULL,
     NULL, NULL},
    KEY(collider, file, VALUE_FILE, 1, 1, &any, OF(MESH)),
    NUMBER(collider, friction, 0, &not_negative),
    NUMBER(collider, gap, 0, &not_negative),
    NUMBER(collider, from, 0, &not_negative),
    NUMBER(collider, until, 0, &not_negative),
    DIRECTION(collider, turn_axis, 0),
    {"motion", VALUE_LIST, offsetof(collider, keyframes), 0, 1, &any, 0, NULL, keyframe_keys,
     &keyframe_list},
    END};
_Static_assert(sizeof collider_keys / sizeof *collider_keys <= MOST_KEYS + 1,
               "no more keys than a reader counts");

static const pin pin_defaults;
static const collider collider_defaults = {
    .friction = 0.3, .gap = 0.005, .turn_axis = {0.0, 0.0, 1.0}};
static void release_collider(void *item) {
    surface_free(((collider *)item)->surface);
    free(((collider *)item)->keyframes);
}

static void release_pin(void *item) {
    free(((pin *)item)->vertices);
}

static const scene_list pin_list = {offsetof(scene, pin_count), sizeof(pin), &pin_defaults,
                                    release_pin};
static const scene_list collider_list = {offsetof(scene, collider_count), sizeof(collider),
                                         &collider_defaults, release_collider};

const scene_key scene_keys[] = {KEY(scene, name, VALUE_TEXT, 1, 1, &any, 0),
                                SECTION(mesh, 1, mesh_keys),
                                SECTION(material, 1, material_keys),
                                SECTION(surroundings, 0, surroundings_keys),
                                LIST(scene, pins, pin_keys, &pin_list),
                                LIST(scene, colliders, collider_keys, &collider_list),
                                SECTION(contact, 0, contact_keys),
                                SECTION(self_collision, 0, self_keys),
                                SECTION(time, 1, time_keys),
                                SECTION(solution, 0, solution_keys),
                                SECTION(monitor, 0, monitor_keys),
                                END};

void scene_free_items(const scene_list *list, char *items, long count) {
    for (long k = 0; list->release && k < count; k++)
        list->release(items + (size_t)k * list->item_size);
    free(items);
}

char *scene_items(const scene_key *key, const char *source, int *count) {
    assert(key->kind == VALUE_LIST || key->kind == VALUE_NUMBERS);
    char *items;
    memcpy(&items, source + key->offset, sizeof items);
    memcpy(count, source + key->list->count_offset, sizeof *count);
    return items;
}

void scene_set_items(const scene_key *key, char *target, void *items, int count) {
    assert(count >= 0);
    int old_count;
    char *old = scene_items(key, target, &old_count);
    scene_free_items(key->list, old, old_count);
    memcpy(target + key->offset, &items, sizeof items);
    memcpy(target + key->list->count_offset, &count, sizeof count);
}

int scene_kind(const scene_key *keys, const void *struct_) {
    if (keys->name[0] != '\0' && strcmp(keys->name, "kind") != 0)
        return -1;
    return *(const int *)(const void *)((const char *)struct_ + keys->offset);
}

const scene scene_defaults = {
    .mesh = {.scale = 1.0, .seed = 1, .order = MESH_ORDER_SORTED, .normal = {0.0, 0.0, 1.0}},
    .self_collision = {.friction = 0.3},
    .solution = {.tolerance = 1e-3,
                 .max_iterations = 5000,
                 .newton_tolerance = 1e-6,
                 .newton_iterations = 50},
    .monitor = {.energy = 1e-3, .growth = 0.5, .strain = 1.0, .penetration = 0.01}};
