/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Solids from mesh files (mesh_file.h). */
#ifndef FABRIC_INPUT_SURFACE_FILE_H
#define FABRIC_INPUT_SURFACE_FILE_H

#include "mesh/surface.h"

/** NULL with a message in error[256] that names the defect, its position and the expected value:
 *  the file cannot be read, or is not the surface of a solid (surface_check.h). */
surface *surface_read(const char *path, char *error);

#endif
