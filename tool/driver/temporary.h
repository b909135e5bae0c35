/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The private folder for temporaries of one call of redcc-cc, and those that killed calls left. */
#ifndef DRIVER_TEMPORARY_H
#define DRIVER_TEMPORARY_H

#include <stdint.h>

#include "support/arena.h"

/** A new folder that only this user can enter, below $TMPDIR or /tmp; NULL where there can be none.
 *  It is locked as long as this process lives. Folders of earlier calls that are locked no more
 *  (killed by SIGKILL, the machine went down) are removed on the way. */
const char *temporary_create(arena *a);

/** A folder whose name is its content's, for calls that want the same content at the same time. */
typedef struct shared_folder {
    const char *path;
    int lock; /**< open as long as this process uses the folder */
} shared_folder;

/** The folder of this key beside the private one, made where it is not there, for this user alone.
 *  It is locked against removal until temporary_leave. path is NULL where it cannot be had: another
 *  user owns the name, or the file system has no locks. */
shared_folder temporary_share(arena *a, uint64_t key);

/** Removes the folder unless another process uses it; the last one that leaves removes it. */
void temporary_leave(shared_folder folder);

/** Removes a folder and all that is in it. */
void temporary_remove(const char *folder);

#endif
