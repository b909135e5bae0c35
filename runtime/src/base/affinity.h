/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The processors that a thread may run on. The runtime never changes them, because thread
 * placement is left to the user, OpenMP and the kernel. */
#ifndef REDCC_AFFINITY_H
#define REDCC_AFFINITY_H

/** The number of processors that the calling thread may run on; at least 1. Thread-safe. */
int redcc_processors_here(void);

#endif
