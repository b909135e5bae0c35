/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Signals are blocked while a loop runs in parallel. A handler that left the loop by siglongjmp
 * would leave the other threads writing to its arrays; one that began a loop of its own would find
 * this loop's locks held; and one that the program expects in its own thread would run in another.
 * Threads that OpenMP creates meanwhile never run a handler. Signals with the system's default
 * action, which usually ends the program, are not delayed by anything long: neither by starting
 * threads, nor by an inspection, nor by an execution of more than a millisecond.
 */
#ifndef REDCC_SIGNALS_H
#define REDCC_SIGNALS_H

#include <stdbool.h>
#include <stdint.h>

/** Blocks every signal in the calling thread except those that its own instructions raise (and
 *  those by which the C library has all threads change their identity). Blocks cancellation of the
 *  thread as well. Returns the previous mask, for redcc_signals_release. */
uint64_t redcc_signals_hold(void);

/** Restores the mask; pending signals are delivered now. */
void redcc_signals_release(uint64_t before);

/** Called in the threads of a region for which OpenMP may have created threads. A thread that was
 *  created while signals were blocked blocks all of them from now on, including those that were let
 *  through at its creation. (It is recognised by the real-time signals, which are all blocked.) */
void redcc_signals_take_over(void);

/** Is the calling thread in a handler, which may have interrupted it in malloc or in OpenMP's
 *  library? Takes some 70 system calls if handlers are installed, and scans the whole stack.
 *  before: the mask before redcc_signals_hold. */
bool redcc_signals_in_handler(uint64_t before);

/** In the calling thread, between redcc_signals_hold and redcc_signals_release: unblocks the
 *  signals with their default action, so that an interrupt ends the program at once, even in a long
 *  loop. Some 30 system calls. */
void redcc_signals_let_default(uint64_t before);

/** Does the signal have its default action, according to the system? */
bool redcc_signal_is_default(int number);

#endif
