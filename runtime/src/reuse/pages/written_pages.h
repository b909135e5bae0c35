/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Which pages were written since? Asked of the system, where it can tell (Linux from 6.7 on;
 * docs/decisions/0007). Not thread-safe: watch.c holds its lock around every call.
 */
#ifndef REDCC_WRITTEN_PAGES_H
#define REDCC_WRITTEN_PAGES_H

#include "base/range.h"

/** Can pages be watched by what was begun in this very process? After a fork the child cannot: what
 *  the parent had open speaks of the parent's memory. */
bool redcc_pages_begun(void);

/** Opens what it takes, and tries it. False: the system cannot tell, or must not be asked; it is
 *  not asked again. */
bool redcc_pages_begin(void);

/** From now on a write to these whole pages will be known. False: it cannot be. */
bool redcc_pages_protect(struct range pages);

/** Are all pages there and none written since they were protected? False also where that cannot be
 *  told, as of a place where something else was mapped meanwhile. */
bool redcc_pages_untouched(struct range pages);

#endif
