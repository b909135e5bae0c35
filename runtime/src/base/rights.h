/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** A thread's memory access rights by protection keys, see pkeys(7). Each thread has rights of its
 * own; the program changes them by pkey_set. Only 64-bit x86 is supported. */
#ifndef REDCC_RIGHTS_H
#define REDCC_RIGHTS_H

#include <stdbool.h>
#include <stdint.h>

/** For tests: if set, the processor and the system are assumed to have protection keys. */
extern bool redcc_rights_assumed;

/** The calling thread's rights; 0 if there are no keys. */
uint32_t redcc_rights(void);

/** Sets the calling thread's rights. */
void redcc_rights_set(uint32_t rights);

#endif
