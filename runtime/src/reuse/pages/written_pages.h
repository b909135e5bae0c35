/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Finds out which pages were written since they were protected, if the system supports it (Linux
 * 6.7 and later; docs/decisions/0007). Not thread-safe: watch.c holds its lock around every call.
 */
#ifndef REDCC_WRITTEN_PAGES_H
#define REDCC_WRITTEN_PAGES_H

#include "base/range.h"

/** Was tracking started in this process? After a fork the child cannot use the parent's
 *  descriptors, which refer to the parent's memory. */
bool redcc_pages_begun(void);

/** Opens the descriptors and tests them. False: the system does not support tracking, or the
 * process must not try it (redcc_is_confined). Then no further attempt is made. */
bool redcc_pages_begin(void);

/** Protects these whole pages, so that writes to them are recorded. False on failure. */
bool redcc_pages_protect(struct range pages);

/** Are all pages present and unwritten since they were protected? Also false if that is unknown,
 * for example because an address was remapped. */
bool redcc_pages_untouched(struct range pages);

#endif
