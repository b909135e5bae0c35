/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Restrictions on the calling thread during an execution: signals are blocked, and loops that begin
 * in it run sequentially. Begin and end are called by the same thread.
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
 * execution or begin another one. If `always` is set, blocks signals even if no threads must be
 * created and no handler can leave (escapes.h). */
void redcc_within_begin(struct within *within, bool always, int threads);

/** Called when the region's threads exist. Unblocks signals, unless `always` is set or a handler
 * may leave the execution. In these cases, is_long unblocks the signals with the default action,
 * because a user may be waiting for the end of the execution. */
void redcc_within_relax(struct within *within, bool always, bool is_long);

/** Called when the execution's data are not used any more. `within` is passed by value, because
 *  another thread may use the execution already. */
void redcc_within_end(struct within within);

#endif
