/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What waking threads takes, and starting those that are not there: measured in all loops of the
 *  process, estimated before. Thread-safe. */
#ifndef REDCC_CHOOSE_WAKING_H
#define REDCC_CHOOSE_WAKING_H

#include <stdbool.h>

/** Seconds that waking the threads takes. */
double redcc_wake_seconds(void);

/** Seconds that a region takes until so many threads are there that are to be started, at least
 * 0.1 ms; wanted: other programs run on the processors that they would need. */
double redcc_start_seconds(int missing, bool wanted);

/** ... that a region of so many threads takes for those that are not there, as the machine is now;
 *  0: all are. To look takes long beside a light loop. */
double redcc_likely_start(int threads);

/** ... at least. Takes no look. */
double redcc_least_start(int threads);

/** Of a region: starting `started` threads, or, where that is 0, waking all of them, took
 *  `seconds`; 0: not known. */
void redcc_note_waking(double seconds, int started);

#endif
