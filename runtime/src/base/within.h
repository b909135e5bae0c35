/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Restrictions on the calling thread during an execution: signals may be blocked, and loops that
 * begin during the execution run sequentially. The same thread calls begin and end.
 */
#ifndef REDCC_WITHIN_H
#define REDCC_WITHIN_H

#include <stdbool.h>
#include <stdint.h>

struct within {
    uint64_t signals; /* the previous mask, if holds_signals */
    bool holds_signals;
    bool was_within; /* the thread was within another execution */
};

/** Called before a possible region of `threads` threads: from now on no handler can leave the
 * execution or begin another one. Signals are blocked if `always` is set, if threads must be
 * created, or if a handler may leave (escapes.h). */
void redcc_within_begin(struct within *within, bool always, int threads);

/** Called when the region's threads exist. Unblocks signals, unless `always` is set or a handler
 * may leave the execution. In these two cases, if is_long is set, unblocks the signals with the
 * default action, because a user may want to interrupt a long execution. */
void redcc_within_relax(struct within *within, bool always, bool is_long);

/** Called when the execution's data are no longer used. `within` is passed by value, because
 * another thread may already reuse the object that contains it. */
void redcc_within_end(struct within within);

#endif
