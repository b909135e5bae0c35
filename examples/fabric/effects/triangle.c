/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/*
 * Stretch and shear: a loop for each combination of effects. The loops differ in a constant
 * argument of triangle_force, by which the compiler removes unused terms.
 */
#include "effect.h"
#include "triangle_terms.h"

/* The effects that this build has: FABRIC_WITHOUT leaves some out. */
enum {
    built_effects = (BUILT_WITH(EFFECT_STRETCH) ? TRIANGLE_STRETCH : 0) |
                    (BUILT_WITH(EFFECT_SHEAR) ? TRIANGLE_SHEAR : 0)
};

/* Adds f and df: one statement each, the same in every loop. (A parallel loop must contain its
 * updates.) */
#define ADD_FORCE(b)                                                                               \
    for (c = 0; c < 3; c++) {                                                                      \
        (b)[i][c] += f[0][c];                                                                      \
        (b)[j][c] += f[1][c];                                                                      \
        (b)[k][c] += f[2][c];                                                                      \
    }
#define ADD_BLOCKS(value)                                                                          \
    for (r = 0; r < 3; r++)                                                                        \
        for (c = 0; c < 3; c++) {                                                                  \
            (value)[ii][r][c] += df[0][r][c];                                                      \
            (value)[ij][r][c] += df[1][r][c];                                                      \
            (value)[ik][r][c] += df[2][r][c];                                                      \
            (value)[jj][r][c] += df[3][r][c];                                                      \
            (value)[jk][r][c] += df[4][r][c];                                                      \
            (value)[kk][r][c] += df[5][r][c];                                                      \
        }

static void add_stretch(const triangle_elements *e, const triangle_material *material, double h,
                        const double (*restrict x)[3], const double (*restrict v)[3],
                        linear_system *s) {
    int t, i, j, k, r, c;
    int ii, ij, ik, jj, jk, kk;
    double f[3][3], df[6][3][3];
    for (t = 0; t < e->count; t++) {
        i = e->vertex[t][0];
        j = e->vertex[t][1];
        k = e->vertex[t][2];
        triangle_force(TRIANGLE_STRETCH, &e->rest[t], material, h, x, v, i, j, k, f, df);
        ADD_FORCE(s->b)
        ii = e->block[t][0];
        ij = e->block[t][1];
        ik = e->block[t][2];
        jj = e->block[t][3];
        jk = e->block[t][4];
        kk = e->block[t][5];
        ADD_BLOCKS(s->A.value)
    }
}

static void add_shear(const triangle_elements *e, const triangle_material *material, double h,
                      const double (*restrict x)[3], const double (*restrict v)[3],
                      linear_system *s) {
    int t, i, j, k, r, c;
    int ii, ij, ik, jj, jk, kk;
    double f[3][3], df[6][3][3];
    for (t = 0; t < e->count; t++) {
        i = e->vertex[t][0];
        j = e->vertex[t][1];
        k = e->vertex[t][2];
        triangle_force(TRIANGLE_SHEAR, &e->rest[t], material, h, x, v, i, j, k, f, df);
        ADD_FORCE(s->b)
        ii = e->block[t][0];
        ij = e->block[t][1];
        ik = e->block[t][2];
        jj = e->block[t][3];
        jk = e->block[t][4];
        kk = e->block[t][5];
        ADD_BLOCKS(s->A.value)
    }
}

static void add_both(const triangle_elements *e, const triangle_material *material, double h,
                     const double (*restrict x)[3], const double (*restrict v)[3],
                     linear_system *s) {
    int t, i, j, k, r, c;
    int ii, ij, ik, jj, jk, kk;
    double f[3][3], df[6][3][3];
    for (t = 0; t < e->count; t++) {
        i = e->vertex[t][0];
        j = e->vertex[t][1];
        k = e->vertex[t][2];
        triangle_force(built_effects, &e->rest[t], material, h, x, v, i, j, k, f, df);
        ADD_FORCE(s->b)
        ii = e->block[t][0];
        ij = e->block[t][1];
        ik = e->block[t][2];
        jj = e->block[t][3];
        jk = e->block[t][4];
        kk = e->block[t][5];
        ADD_BLOCKS(s->A.value)
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
