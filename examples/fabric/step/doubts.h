/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Settings that are valid but probably not intended. */
#ifndef FABRIC_DOUBTS_H
#define FABRIC_DOUBTS_H

#include <stdio.h>

#include "mesh/mesh.h"
#include "scene/scene.h"

/**
 * Prints a line for each on `to`, with the scene's name, the value found and the one expected: pins
 * that hold nothing, gaps as wide as the cloth's edges or the cloth, coordinates that seem to have
 * another unit. Returns their number, or -1: out of memory.
 */
int scene_doubts(const scene *s, const mesh *m, FILE *to);

#endif
