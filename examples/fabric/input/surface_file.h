/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Solids from mesh files (mesh_file.h). */
#ifndef FABRIC_INPUT_SURFACE_FILE_H
#define FABRIC_INPUT_SURFACE_FILE_H

#include "mesh/surface.h"

/** NULL with a message in error[256] that says what is wrong, where, and what was expected: the
 * file cannot be read, or it is no surface of a solid (surface_check.h). */
surface *surface_read(const char *path, char *error);

#endif
