/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Dirty-page tracking (by write protection) for all loops of the process. A range of pages keeps
 * its version until one of the pages is written; versions are never reused. The functions are
 * thread-safe and never wait. If another thread is in one of them, they return 0 or WATCH_BUSY.
 */
#ifndef REDCC_WATCH_H
#define REDCC_WATCH_H

#include "base/range.h"

/** The whole pages in `range`; empty if there are none. */
struct range redcc_whole_pages(struct range range);

/** Starts tracking `pages`, which must be whole pages, and returns their version; 0: tracking is
 * impossible. What is read after this call is unmodified as long as redcc_watch_ask returns
 * WATCH_UNTOUCHED for this version. */
uint64_t redcc_watch_begin(struct range pages);

/** The version of `pages`, if they are already tracked (for another loop) and unmodified; otherwise
 * 0. Makes no system call if they are not tracked. */
uint64_t redcc_watch_share(struct range pages);

enum watch_answer {
    WATCH_TOUCHED,   /* the pages were written since that version, or that is unknown */
    WATCH_UNTOUCHED, /* the pages are unchanged since that version */
    WATCH_BUSY       /* another thread is querying */
};

/** Have the pages been written since they had this version? */
enum watch_answer redcc_watch_ask(struct range pages, uint64_t version);

#endif
