/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Detects memory that has several addresses. A file, a System V segment or anonymous shared memory
 * may be mapped at several addresses. Owners, plans, bins and the overlap guard identify memory by
 * its address. So a loop may run in parallel only if each byte that it touches has one address.
 * Private mappings satisfy this, because writes to them are not visible in other mappings of the
 * file.
 */
#ifndef REDCC_ALIASES_H
#define REDCC_ALIASES_H

#include "base/range.h"

/** The addresses that a loop touches. */
struct touches {
    const struct range *written; /* [written_count] */
    uint32_t written_count;
    const struct range *read; /* [read_count] */
    uint32_t read_count;
    const redcc_loop *loop; /* the loop that reads these sources; NULL if no loop does */
};

/** May the loop also touch the written memory at other addresses? Also true if that is unknown.
 * Takes a few nanoseconds if no object of the process refers to a function that maps memory.
 * Otherwise it reads the process's mappings in each execution, because the kernel does not report
 * new mappings. (It does not consider threads that map the written memory again during the loop:
 * that is a data race.) Thread-safe. */
bool redcc_may_be_aliased(struct touches touches);

/** Does the process have writable memory with several addresses? Also true if that is unknown.
 * Called before the touched addresses are known. */
bool redcc_may_have_aliases(void);

#endif
