/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Whether what a command links has translated loops. */
#ifndef DRIVER_LINKED_LOOPS_H
#define DRIVER_LINKED_LOOPS_H

#include "driver/session.h"

/** Does an object, an archive or a library that the command names hold loops for the runtime? Of
 *  libraries by their short names those in the folders that it names are looked at. */
bool loops_are_linked(session *s);

/** Does this file? */
bool has_loops(session *s, const char *path);

#endif
