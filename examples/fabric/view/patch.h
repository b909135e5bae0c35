/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Smooths a mesh for pictures, so that they show folds and not triangles. Each triangle becomes a
 * curved patch through its corners that follows the corners' normals (Vlachos and others, Curved PN
 * triangles, 2001). Patches that share a side share its curve.
 */
#ifndef FABRIC_VIEW_PATCH_H
#define FABRIC_VIEW_PATCH_H

/** The small triangles of all patches; patches share no vertices. */
typedef struct patches {
    int vertex_count, triangle_count;
    double *position; /* [3 * vertex_count] m */
    float *normal;    /* [3 * vertex_count] unit */
    float *material;  /* [2 * vertex_count] m */
    int *triangle;    /* [3 * triangle_count] */
} patches;

/** Replaces each triangle by parts * parts small ones. The arguments are triangle [3 *
 *  triangle_count] and, for each vertex, position [3 * vertex_count] m and material [2 *
 *  vertex_count] m. Returns 0, or -1 if out of memory; call patches_free in either case. */
int patches_make(patches *p, int vertex_count, int triangle_count, const double *position,
                 const float *material, const int *triangle, int parts);
void patches_free(patches *p);

#endif
