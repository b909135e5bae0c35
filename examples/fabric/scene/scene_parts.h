/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What files that read and write scenes share; scene.h has whole scenes. */
#ifndef FABRIC_SCENE_PARTS_H
#define FABRIC_SCENE_PARTS_H

#include <stdio.h>

#include "scene.h"
#include "scene_keys.h"

/** The checked mesh of the file, with defects printed on standard error; to be freed by
 *  mesh_free and free. NULL after a message there or in error[256]. */
mesh *scene_sheet_read(const char *path, int rest, char *error);

/** Writes one value, no section or list, of the struct at `source`. */
void scene_write_value(FILE *file, const scene_key *key, const char *source);

#endif
