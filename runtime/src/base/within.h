/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Restrictions on the calling thread during an execution: blocked signals, and loops that begin in
 * it. Each begin is ended by the same thread.
 */
#ifndef REDCC_WITHIN_H
#define REDCC_WITHIN_H

#include <stdbool.h>
#include <stdint.h>

struct within {
    uint64_t signals; /* the previous mask; if signals are held */
    bool holds_signals;
    bool was_within; /* within another execution */
};

/** Called if a region of `threads` threads may follow: from now on no handler may leave the
 *  execution, and none begins one of its own. always: block signals, even if no object refers to a
 *  function that leaves a handler. */
void redcc_within_begin(struct within *within, bool always, int threads);

/** The region's threads exist. is_long: a user may be waiting for the end of the execution. */
void redcc_within_relax(struct within *within, bool always, bool is_long);

/** Nothing of the execution is touched any more. A copy, because the execution may belong to
 *  another thread by now. */
void redcc_within_end(struct within within);

#endif
