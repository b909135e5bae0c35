/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What Linux tells of the process in /proc, as far as it bears on watching its pages. */
#ifndef REDCC_MAPPINGS_H
#define REDCC_MAPPINGS_H

#include "base/range.h"

enum { REDCC_MAPPINGS = 16 };

/** Whole mappings, in ascending order. */
struct mappings {
    struct range whole[REDCC_MAPPINGS];
    int count;
};

/** The mapping that holds the address; an empty range where that cannot be told. */
struct range redcc_mapping_of(uintptr_t address);

/** May the calling thread be stopped for a system call that it makes (seccomp)? True also where
 *  that cannot be told. */
bool redcc_is_confined(void);

/** How many descriptors the process's table has room for as it is; 0 where that cannot be told. To
 *  make it larger the system waits for all processors: 5 to 20 ms in a process with threads. */
int redcc_descriptor_room(void);

/** Has the machine a device whose driver may take pages to the device's own memory and bring them
 *  back written, unseen by the processor? */
bool redcc_has_accelerator(void);

/** Would every write to `pages` be seen by the processor's page tables? True only if all of them
 *  lie in private memory without a file behind it; and if nothing that the process has pinned,
 *  mapped or opened may write to its memory by other ways (devices, sockets and queues mapped,
 *  another userfault descriptor than `own`). Sets *found to the mappings that hold the pages. */
bool redcc_may_watch(struct mappings *found, struct range pages, int own);

#endif
