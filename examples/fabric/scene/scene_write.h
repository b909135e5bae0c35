/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Values as scene files have them; scene.h has whole scenes. */
#ifndef FABRIC_SCENE_WRITE_H
#define FABRIC_SCENE_WRITE_H

#include <stdio.h>

#include "scene_keys.h"

/** Writes one value, no section or list, of the struct at `source`. */
void scene_write_value(FILE *file, const scene_key *key, const char *source);

#endif
