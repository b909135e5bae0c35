/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Which vertices a pin holds. */
#ifndef FABRIC_PIN_H
#define FABRIC_PIN_H

#include "mesh/mesh.h"
#include "scene/scene.h"

/** Sets pin_of[i] = number for each vertex i of the mesh that the pin holds: by where the mesh has
 *  it, before anything moves. pin_of: [vertex_count]. */
void pin_find(const pin *p, const mesh *m, int number, int *pin_of);

#endif
