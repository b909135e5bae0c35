/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Settings that are valid but probably not intended. */
#ifndef FABRIC_DOUBTS_H
#define FABRIC_DOUBTS_H

#include <stdio.h>

#include "mesh/mesh.h"
#include "scene/scene.h"

/**
 * Prints a line to `to` for each pin that holds nothing, a self-collision gap as wide as the
 * cloth's edges, each collider's gap as wide as the cloth, and coordinates that seem to be in
 * another unit. A line begins with the scene's name. Returns the number of lines, or -1 if out of
 * memory.
 */
int scene_doubts(const scene *s, const mesh *m, FILE *to);

#endif
