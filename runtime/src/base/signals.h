/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Signals wait while a loop runs in parallel. A handler that left the loop by siglongjmp would
 * leave the other threads writing to its arrays; one that began a loop of its own would find the
 * locks of this one held; and one that the program expects in its own thread would run in another.
 * Threads that OpenMP makes meanwhile never run a handler. Signals that the program has left to the
 * system, whose default action most often ends it, wait for nothing that takes long: not for
 * threads to be started, not for an inspection, not for an execution of more than a millisecond.
 */
#ifndef REDCC_SIGNALS_H
#define REDCC_SIGNALS_H

#include <stdbool.h>
#include <stdint.h>

/** Blocks every signal in the calling thread but those that an instruction of its own raises (and
 *  those by which the C library has all threads change their identity). Blocks cancellation of the
 *  thread as well. Returns what was blocked before, for redcc_signals_release. */
uint64_t redcc_signals_hold(void);

/** What waited is delivered now. */
void redcc_signals_release(uint64_t before);

/** In a thread of a region for which OpenMP may have made some: one that was made by a thread that
 * held signals blocks them all from now on, also those that were let through while it was made. (It
 * is known by the real-time signals, which all are blocked.) */
void redcc_signals_take_over(void);

/** Is the calling thread in a handler, which may have found it in malloc or in OpenMP's library?
 * Some 70 system calls where handlers are installed, and a look at all of its stack. before: what
 * was blocked before redcc_signals_hold. */
bool redcc_signals_in_handler(uint64_t before);

/** In the calling thread, between the two: lets those through that the program has left to the
 *  system, so that an interrupt ends it at once, however long the loop takes. Some 30 system
 *  calls. */
void redcc_signals_let_default(uint64_t before);

/** Does the signal have its default action, as the system says? */
bool redcc_signal_is_default(int number);

#endif
