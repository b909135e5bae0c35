/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What a scene that can be run probably does not mean. */
#ifndef FABRIC_DOUBTS_H
#define FABRIC_DOUBTS_H

#include <stdio.h>

#include "mesh/mesh.h"
#include "scene/scene.h"

/**
 * Prints a line for each on `to`, with the scene's name, what was found and what would be expected:
 * pins that hold nothing, gaps as wide as the cloth's edges or the cloth, coordinates that look
 * like another unit's. Returns how many there are, or -1: out of memory.
 */
int scene_doubts(const scene *s, const mesh *m, FILE *to);

#endif
