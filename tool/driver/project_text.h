/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The functions of a project's files as bytes, for the cache: reading these bytes takes a small
 * part of the time that reading the files takes. */
#ifndef DRIVER_PROJECT_TEXT_H
#define DRIVER_PROJECT_TEXT_H

#include "driver/project.h"
#include "driver/store.h"

store_part project_write(arena *a, const project_scan *files);

/** Reads the files that project_write has written. Their names point into `part`; they are not
 * copied. */
project_scan project_read(arena *a, const store_part *part);

#endif
