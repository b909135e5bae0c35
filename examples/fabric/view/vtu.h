/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Frames of a run as VTK XML files for ParaView. Each file is written to a temporary file and
 *  renamed when complete. Functions return 0, or -1 after a message on standard error. */
#ifndef FABRIC_VIEW_VTU_H
#define FABRIC_VIEW_VTU_H

#include "view/cloth_frames.h"

/** Writes a frame as an unstructured grid in ASCII. */
int vtu_write(const cloth_frames *frames, const state *s, const char *path);

/** Writes a list of the .vtu files of `frames`: file[k], a name in the folder of `path`, shows
 *  time[k]. */
int pvd_write(const cloth_frames *frames, char (*file)[32], const char *path);

#endif
