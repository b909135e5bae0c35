/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What memory a thread may read and write by protection keys: pkeys(7). Each thread has its own
 *  rights, which pkey_set changes; 64-bit x86. */
#ifndef REDCC_RIGHTS_H
#define REDCC_RIGHTS_H

#include <stdbool.h>
#include <stdint.h>

/** For tests: the processor and the system count as having keys. */
extern bool redcc_rights_assumed;

/** The calling thread's; 0 where there are no keys. */
uint32_t redcc_rights(void);

/** Makes them the calling thread's. */
void redcc_rights_take(uint32_t rights);

#endif
