/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Memory that has several addresses. In a shared mapping an address does not name memory: a file, a
 * segment or anonymous shared memory may be mapped at several places. Owners, plans, bins and the
 * overlap guard identify memory by its address, so that a loop may run in parallel only if all that
 * it touches has one address each. Private memory has one: other mappings of a file show what is
 * written to a shared one, never what is written to a private one.
 */
#ifndef REDCC_ALIASES_H
#define REDCC_ALIASES_H

#include "base/range.h"

/** What a loop touches, by address. */
struct touches {
    const struct range *written; /* [written_count] */
    uint32_t written_count;
    const struct range *read; /* [read_count] */
    uint32_t read_count;
    const redcc_loop *loop; /* whose sources are read; NULL: of no loop */
};

/** May memory that is written be touched at another address as well? True also where that cannot be
 * told. A few nanoseconds where no object of the process refers to a function by which memory is
 * mapped; else a look at the mappings: no event tells of a new one, so each execution looks.
 * Threads of the program that map meanwhile do so while their memory is written: a data race.
 * Thread-safe.
 */
bool redcc_may_be_aliased(struct touches touches);

/** Is there memory in the process that has several addresses, and that may be written? For what is
 *  done before it is known what a loop touches. */
bool redcc_may_have_aliases(void);

#endif
