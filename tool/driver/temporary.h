/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The private temporary folder of one call of redcc-cc. Folders that killed calls have left are
 * removed. */
#ifndef DRIVER_TEMPORARY_H
#define DRIVER_TEMPORARY_H

#include <stdint.h>

#include "support/arena.h"

/** A new folder that only this user can enter, below $TMPDIR or /tmp, or NULL if none can be
 * created. This process locks it for its lifetime. Also removes the unlocked folders that earlier
 * processes left (killed by SIGKILL, machine crashes). */
const char *temporary_create(arena *a);

/** A folder named by its content, for processes that need the same content at the same time. */
typedef struct shared_folder {
    const char *path;
    int lock; /**< open while this process uses the folder */
} shared_folder;

/** The folder of this key in the parent of the private one, created for this user alone if missing.
 * It is locked against removal until temporary_leave. Its path is NULL on failure: another user
 * owns the name, or the file system has no locks. */
shared_folder temporary_share(arena *a, uint64_t key);

/** Ends this process's use of the folder. The last process that uses it removes it. */
void temporary_leave(shared_folder folder);

/** Removes a folder and its contents. */
void temporary_remove(const char *folder);

#endif
