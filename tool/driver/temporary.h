/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The private folder for temporaries of one call of redcc-cc, and those that killed calls left. */
#ifndef DRIVER_TEMPORARY_H
#define DRIVER_TEMPORARY_H

#include "support/arena.h"

/** A new folder that only this user can enter, below $TMPDIR or /tmp; NULL where there can be none.
 *  It is locked as long as this process lives. Folders of earlier calls that are locked no more
 *  (killed by SIGKILL, the machine went down) are removed on the way. */
const char *temporary_create(arena *a);

/** Removes a folder and all that is in it. */
void temporary_remove(const char *folder);

#endif
