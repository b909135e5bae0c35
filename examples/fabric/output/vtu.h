/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Frames of a run as VTK's XML files, a file for each frame, which ParaView reads. All are written
 *  beside, then renamed. Functions return 0, or -1 after a message on standard error. */
#ifndef FABRIC_OUTPUT_VTU_H
#define FABRIC_OUTPUT_VTU_H

#include "output/cloth_frames.h"

/** A frame as an unstructured grid, ASCII. */
int vtu_write(const cloth_frames *frames, const state *s, const char *path);

/** The collection of `frames`' .vtu files: file[k], a name beside `path`, at time[k]. */
int pvd_write(const cloth_frames *frames, char (*file)[32], const char *path);

#endif
