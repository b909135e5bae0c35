/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The cloth of a scene from a file; for the files that read and use scenes. */
#ifndef FABRIC_SCENE_SHEET_H
#define FABRIC_SCENE_SHEET_H

#include "scene.h"

/** The checked mesh of the file, with defects printed on standard error; to be freed by
 *  mesh_free and free. NULL after a message there or in error[256]. */
mesh *scene_sheet_read(const char *path, int rest, char *error);

/** A copy of the scene's sheet in metres, with the rest shape that the scene asks for; positions
 *  are the file's still. 0, or -1: out of memory. */
int scene_sheet_copy(const scene *s, mesh *m);

#endif
