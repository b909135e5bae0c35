/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/*
 * Stretch and shear: one loop for each combination of effects. The loops differ in a constant
 * argument of triangle_force, so that the compiler removes unused terms.
 */
#include "effect.h"
#include "triangle_terms.h"

/* The effects that this build contains. The macro FABRIC_WITHOUT leaves some out. */
enum {
    built_effects = (BUILT_WITH(EFFECT_STRETCH) ? TRIANGLE_STRETCH : 0) |
                    (BUILT_WITH(EFFECT_SHEAR) ? TRIANGLE_SHEAR : 0)
};

/* These macros add f and df of triangle t; every loop contains the same statements. redcc could not
 * parallelise a called function that makes all these updates. */
#define ADD_FORCE                                                                                  \
    for (p = 0; p < 3; p++)                                                                        \
        for (c = 0; c < 3; c++)                                                                    \
            s->b[e->vertex[t][p]][c] += f[p][c];
#define ADD_BLOCKS                                                                                 \
    for (p = 0; p < 6; p++)                                                                        \
        for (r = 0; r < 3; r++)                                                                    \
            for (c = 0; c < 3; c++)                                                                \
                s->A.value[e->block[t][p]][r][c] += df[p][r][c];

static void add_stretch(const triangle_elements *e, const triangle_material *material, double h,
                        const double (*restrict x)[3], const double (*restrict v)[3],
                        linear_system *s) {
    int t, p, r, c;
    double f[3][3], df[6][3][3];
    for (t = 0; t < e->count; t++) {
        triangle_force(TRIANGLE_STRETCH, &e->rest[t], material, h, x, v, e->vertex[t][0],
                       e->vertex[t][1], e->vertex[t][2], f, df);
        ADD_FORCE
        ADD_BLOCKS
    }
}

static void add_shear(const triangle_elements *e, const triangle_material *material, double h,
                      const double (*restrict x)[3], const double (*restrict v)[3],
                      linear_system *s) {
    int t, p, r, c;
    double f[3][3], df[6][3][3];
    for (t = 0; t < e->count; t++) {
        triangle_force(TRIANGLE_SHEAR, &e->rest[t], material, h, x, v, e->vertex[t][0],
                       e->vertex[t][1], e->vertex[t][2], f, df);
        ADD_FORCE
        ADD_BLOCKS
    }
}

static void add_both(const triangle_elements *e, const triangle_material *material, double h,
                     const double (*restrict x)[3], const double (*restrict v)[3],
                     linear_system *s) {
    int t, p, r, c;
    double f[3][3], df[6][3][3];
    for (t = 0; t < e->count; t++) {
        triangle_force(built_effects, &e->rest[t], material, h, x, v, e->vertex[t][0],
                       e->vertex[t][1], e->vertex[t][2], f, df);
        ADD_FORCE
        ADD_BLOCKS
    }
}

void triangle_forces(const triangle_elements *e, const triangle_material *material, double h,
                     const double (*restrict x)[3], const double (*restrict v)[3],
                     linear_system *s) {
    const int stretch = material->stretch > 0 || material->stretch_damping > 0;
    const int shear = material->shear > 0 || material->shear_damping > 0;
    if (stretch && shear)
        add_both(e, material, h, x, v, s);
    else if (stretch)
        add_stretch(e, material, h, x, v, s);
    else if (shear)
        add_shear(e, material, h, x, v, s);
}
