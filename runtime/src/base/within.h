/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * What the calling thread gives up while an execution goes on: signals that could leave it, and
 * loops that begin in it. Every begin has its end, by the same thread.
 */
#ifndef REDCC_WITHIN_H
#define REDCC_WITHIN_H

#include <stdbool.h>
#include <stdint.h>

struct within {
    uint64_t signals; /* what it blocked before; where they are held */
    bool holds_signals;
    bool was_within; /* another execution */
};

/** To be called where a region of `threads` threads may follow: no handler may leave the execution
 *  then, and none begins one of its own. always: signals wait whatever the program refers to. */
void redcc_within_begin(struct within *within, bool always, int threads);

/** The region's threads are there. is_long: somebody may wait for the end of the execution. */
void redcc_within_relax(struct within *within, bool always, bool is_long);

/** Nothing of the execution's is touched any more. A copy: the execution may be another's by now.
 */
void redcc_within_end(struct within within);

#endif
