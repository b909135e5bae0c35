/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A mesh as its cloth would be between the vertices: each triangle becomes a curved patch through
 * its corners (Vlachos and others, Curved PN triangles, 2001), as its corners' normals lead it, so
 * that pictures show folds and not triangles. Patches that share a side share its curve.
 */
#ifndef FABRIC_VIEW_PATCH_H
#define FABRIC_VIEW_PATCH_H

/** Corners of small triangles, those of each patch by themselves. */
typedef struct patches {
    int vertex_count, triangle_count;
    double *position; /* [3 * vertex_count] m */
    float *normal;    /* [3 * vertex_count] unit */
    float *material;  /* [2 * vertex_count] m */
    int *triangle;    /* [3 * triangle_count] */
} patches;

/** Of triangles [3 * triangle_count] with corners position [3 * vertex_count] m and material
 *  [2 * vertex_count] m: `parts` squared small ones in place of each. 0, or -1: out of memory.
 *  patches_free in either case. */
int patches_make(patches *p, int vertex_count, int triangle_count, const double *position,
                 const float *material, const int *triangle, int parts);
void patches_free(patches *p);

#endif
