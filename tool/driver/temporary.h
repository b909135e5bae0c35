/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The private temporary folder of one call of redcc-cc. Folders that killed calls have left are
 * removed. */
#ifndef DRIVER_TEMPORARY_H
#define DRIVER_TEMPORARY_H

#include <stdint.h>

#include "support/arena.h"

/** A new folder that only this user can enter, below $TMPDIR or /tmp; NULL if none can be created.
 *  This process locks it for its lifetime. Unlocked folders of earlier calls (killed by SIGKILL,
 *  machine crashes) are removed at the same time. */
const char *temporary_create(arena *a);

/** A folder named by its content, for calls that need the same content at the same time. */
typedef struct shared_folder {
    const char *path;
    int lock; /**< open while this process uses the folder */
} shared_folder;

/** The folder of this key in the parent of the private one, created for this user alone if missing.
 *  It is locked against removal until temporary_leave. path is NULL on failure: another user owns
 *  the name, or the file system has no locks. */
shared_folder temporary_share(arena *a, uint64_t key);

/** Removes the folder unless another process uses it; the last one removes it. */
void temporary_leave(shared_folder folder);

/** Removes a folder and its contents. */
void temporary_remove(const char *folder);

#endif
