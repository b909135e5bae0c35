/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What memory the process holds. */
#ifndef FABRIC_MEMORY_H
#define FABRIC_MEMORY_H

/** The most that was resident at any time, bytes. */
double memory_most(void);

/** Allocated and not freed, bytes, touched or not; -1 where the C library does not tell. */
double memory_allocated(void);

#endif
