/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A picture of ownership, with the option -part_picture FILE.png (PETSC_OPTIONS). On the left the
 * cloth is flat, on the right in its final state. The area around a vertex has the colour of the
 * rank that owns the vertex. Triangles that several ranks execute (the borders of parts) are
 * darker.
 */
#ifndef FABRIC_MPI_PART_PICTURE_H
#define FABRIC_MPI_PART_PICTURE_H

#include "part_layout.h"

/** The number of colours; further ranks reuse them. */
enum { PICTURE_RANKS = 8 };

/** Called when parts are made. On the leader, copies the data that the picture needs. Returns NULL
 *  on other ranks or if no picture is requested. */
struct part_picture *part_picture_new(const part *p, const mesh *whole, const division *d);

/** Draws and writes the picture, with the cloth at x [vertices], m; ends the program with a message
 * on errors. Does nothing if picture is NULL. */
void part_picture_write(const struct part_picture *picture, const double (*x)[3]);
void part_picture_free(struct part_picture *picture);

#endif
