/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The times to wake threads and to start missing ones, measured over all loops of the process.
 * Before the first measurement they are estimates. Thread-safe. */
#ifndef REDCC_CHOOSE_WAKING_H
#define REDCC_CHOOSE_WAKING_H

#include <stdbool.h>

/** Seconds to wake the threads. */
double redcc_wake_seconds(void);

/** Seconds until a region has started `missing` threads, at least 0.1 ms; wanted: other programs
 * run on the processors that the threads would need. */
double redcc_start_seconds(int missing, bool wanted);

/** Seconds that a region of this many threads needs to start the missing ones under the current
 *  load; 0: none is missing. The query is expensive compared with a light loop. */
double redcc_likely_start(int threads);

/** A lower bound of that, without a query. */
double redcc_least_start(int threads);

/** Records that starting `started` threads or, if that is 0, waking all threads of a region took
 *  `seconds`; 0: not known. */
void redcc_note_waking(double seconds, int started);

#endif
