/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Reads from Linux's /proc the facts that decide whether writes to the process's pages can be
 * tracked. */
#ifndef REDCC_MAPPINGS_H
#define REDCC_MAPPINGS_H

#include "base/range.h"

enum { REDCC_MAPPINGS = 16 };

/** Whole mappings, in ascending order. */
struct mappings {
    struct range whole[REDCC_MAPPINGS];
    int count;
};

/** The mapping that contains the address; an empty range if it is unknown. */
struct range redcc_mapping_of(uintptr_t address);

/** May system calls of the calling thread be intercepted or stopped (seccomp)? Also true if that is
 * unknown. */
bool redcc_is_confined(void);

/** The capacity of the process's descriptor table; 0 if unknown. When the table grows, the kernel
 * waits for all processors: 5 to 20 ms in a process with threads. */
int redcc_descriptor_room(void);

/** Does the machine have a device whose driver may move pages to the device's own memory and later
 * return them modified? The processor's page tables would not show such modifications. */
bool redcc_has_accelerator(void);

/** Would the processor's page tables show every write to `pages`? True only if all of the pages lie
 * in private memory without a file, and nothing that the process has mapped or opened may write to
 * its memory otherwise: no device, mapped socket or queue, and no userfault descriptor except
 * `own`. Sets *found to the mappings that contain the pages. */
bool redcc_may_watch(struct mappings *found, struct range pages, int own);

#endif
