/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Detects translated loops in the inputs of a link. */
#ifndef DRIVER_LINKED_LOOPS_H
#define DRIVER_LINKED_LOOPS_H

#include "driver/session.h"

/** Does an object, an archive or a library in the command contain loops for the runtime? A library
 *  given as -lNAME is searched in the folders that the command names. */
bool loops_are_linked(session *s);

/** Does this file contain loops for which this link must add a runtime? */
bool has_loops(session *s, const char *path);

#endif
