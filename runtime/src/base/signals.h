/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Signals wait while a loop runs in parallel. A handler that left the loop by siglongjmp would
 * leave the other threads writing to its arrays; one that began a loop of its own would find the
 * locks of this one held; and one that the program expects in its own thread would run in another.
 * Threads that OpenMP makes meanwhile inherit that all is blocked, and so never run a handler.
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

/** Is the calling thread in a handler, which may have found it in malloc or in OpenMP's library?
 * Some 70 system calls where handlers are installed, and a look at all of its stack. before: what
 * was blocked before redcc_signals_hold. */
bool redcc_signals_in_handler(uint64_t before);

/** In the calling thread, between the two: lets those through that the program has left to the
 *  system, so that an interrupt ends it at once, however long the loop takes. Some 30 system
 *  calls. */
void redcc_signals_let_default(uint64_t before);

#endif
