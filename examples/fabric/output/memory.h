/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The process's memory use. */
#ifndef FABRIC_MEMORY_H
#define FABRIC_MEMORY_H

/** The maximum resident size so far, bytes. */
double memory_peak(void);

/** Returns the number of bytes that are allocated and not yet freed, touched or not, or -1 if the C
 *  library does not report it. */
double memory_allocated(void);

#endif
