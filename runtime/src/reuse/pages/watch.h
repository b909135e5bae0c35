/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Ranges of pages that the system watches for writes, for all loops of the process. A range has a
 * version as long as nothing in it is written; no version is ever given twice. Every function is
 * thread-safe, and waits for nobody: where another thread is at it, the answer is no.
 */
#ifndef REDCC_WATCH_H
#define REDCC_WATCH_H

#include "base/range.h"

/** The whole pages in `range`; an empty range where there are none. */
struct range redcc_whole_pages(struct range range);

/** Has `pages` (whole ones) watched from now on. What is read of them after this call is what they
 *  hold as long as redcc_watch_ask says WATCH_UNTOUCHED of the version returned. 0: cannot be
 * watched. */
uint64_t redcc_watch_begin(struct range pages);

/** The version of pages that are watched already, for another loop, and untouched; 0: there is
 *  none. Costs nothing where they are not. */
uint64_t redcc_watch_share(struct range pages);

enum watch_answer {
    WATCH_TOUCHED,   /* written since, as far as is known */
    WATCH_UNTOUCHED, /* the pages are what they were at that version */
    WATCH_BUSY       /* another thread asks just now */
};

/** Has anything been written to the pages since that version? */
enum watch_answer redcc_watch_ask(struct range pages, uint64_t version);

#endif
