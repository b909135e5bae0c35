/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A picture of which rank owns what, with the option -part_picture FILE.png (PETSC_OPTIONS). On the
 * left the cloth is flat, on the right as the run leaves it. A vertex' surroundings have the colour
 * of the rank that owns it. Triangles that several ranks execute, the borders of the parts, are
 * darker.
 */
#ifndef FABRIC_MPI_PART_PICTURE_H
#define FABRIC_MPI_PART_PICTURE_H

#include "part_layout.h"

/** Ranks with colours of their own; more of them have these again. */
enum { PICTURE_RANKS = 8 };

/** The leader's, when parts are made: what of the division the picture needs; NULL where none is
 * asked for. */
struct part_picture *part_picture_new(const part *p, const mesh *whole, const division *d);

/** Draws and writes the picture, with the cloth at x [vertices], m; ends the program with a message
 *  where it cannot. NULL: nothing is done. */
void part_picture_write(const struct part_picture *picture, const double (*x)[3]);
void part_picture_free(struct part_picture *picture);

#endif
