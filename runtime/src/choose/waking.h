/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The times to wake threads and to start missing ones, measured over all loops of the process.
 * Before the first measurement they are estimates. Thread-safe. */
#ifndef REDCC_CHOOSE_WAKING_H
#define REDCC_CHOOSE_WAKING_H

#include <stdbool.h>

/** The expected seconds to wake the threads of a region. */
double redcc_wake_seconds(void);

/** The expected seconds until a region has started `missing` threads, at least 0.1 ms. `wanted`:
 * other programs run on the processors that these threads would need. */
double redcc_start_seconds(int missing, bool wanted);

/** The expected seconds to start those of `threads` threads that do not exist yet, under the
 * current load; 0: all exist. Querying the load is expensive compared with a loop of short
 * iterations. */
double redcc_likely_start(int threads);

/** A lower bound of redcc_likely_start, without querying the load. */
double redcc_least_start(int threads);

/** Records a measurement: starting `started` threads took `seconds` or, if `started` is 0, waking
 * all threads of a region took `seconds`. seconds == 0: unknown. */
void redcc_note_waking(double seconds, int started);

#endif
