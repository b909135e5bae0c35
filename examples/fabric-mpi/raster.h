/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Triangles drawn into a picture, nearest in front. */
#ifndef FABRIC_MPI_RASTER_H
#define FABRIC_MPI_RASTER_H

#include "output/picture.h"

typedef struct raster_corner {
    double x, y, depth; /* pixels from the left and from above; the least depth is in front */
    unsigned char colour[3];
} raster_corner;

typedef struct raster {
    picture *onto; /* by reference */
    float *depth;  /* [height][width] of what is drawn there; infinite at first */
} raster;

/** 0, or -1 when memory is out. */
int raster_init(raster *r, picture *onto);
void raster_free(raster *r);

/** Each pixel has the colour of the corner that is nearest in barycentric coordinates, and along
 * the edges, `line` pixels wide, a lighter one. */
void raster_triangle(raster *r, const raster_corner corner[3], double line);

#endif
