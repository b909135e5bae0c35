/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Finds out which pages were written since they were protected, if the system supports it (Linux
 * 6.7 and later; docs/decisions/0007). Not thread-safe: watch.c holds its lock around every call.
 */
#ifndef REDCC_WRITTEN_PAGES_H
#define REDCC_WRITTEN_PAGES_H

#include "base/range.h"

/** Was tracking started in this process? A forked child must start it again, because the parent's
 * descriptors refer to the parent's memory. */
bool redcc_pages_begun(void);

/** Opens the descriptors and tests them. Returns false if the system does not support tracking, or
 * if the process must not try it (redcc_is_confined, redcc_has_accelerator). After a failure, all
 * later attempts in this process fail at once. */
bool redcc_pages_begin(void);

/** Protects these whole pages, so that writes to them are recorded. False on failure. */
bool redcc_pages_protect(struct range pages);

/** Are all pages present and unwritten since they were protected? Also false if that is unknown,
 * for example because an address was remapped.  */
bool redcc_pages_untouched(struct range pages);

#endif
