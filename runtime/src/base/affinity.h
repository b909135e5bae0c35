/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The processors that a thread may run on. Nothing in the runtime changes them: where threads run
 * is the user's, OpenMP's and the kernel's affair. */
#ifndef REDCC_AFFINITY_H
#define REDCC_AFFINITY_H

/** How many the calling thread may run on; at least 1. Any thread, at any time. */
int redcc_processors_here(void);

#endif
