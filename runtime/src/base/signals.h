/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Signals are blocked while threads start, and while a loop runs in parallel if a handler may leave
 * it (escapes.h). Without this:
 * - a handler that left the loop by siglongjmp would leave the other threads writing to its arrays;
 * - a handler that executed another loop would find this loop's locks held;
 * - a handler that the program expects in its own thread could run in another thread.
 *
 * Threads that OpenMP creates for the loop never run a handler. Signals whose action is the
 * default, which usually ends the program, are not blocked during long work: starting threads,
 * inspections, and executions that are expected to take more than a millisecond.
 */
#ifndef REDCC_SIGNALS_H
#define REDCC_SIGNALS_H

#include <stdbool.h>
#include <stdint.h>

/** Blocks signals in the calling thread, except those that its own instructions raise and the
 * signal by which the C library changes the user id of all threads. Thereby also blocks
 * asynchronous cancellation of the thread. Returns the previous mask, for redcc_signals_release. */
uint64_t redcc_signals_hold(void);

/** Restores the mask that redcc_signals_hold returned; pending signals are delivered now. */
void redcc_signals_release(uint64_t before);

/** Called in the threads of a region for which OpenMP may have created threads. A thread that was
 * created while signals were blocked has all real-time signals blocked, by which it is recognised.
 * From now on it blocks all signals, including those with default actions. */
void redcc_signals_take_over(void);

/** Is the calling thread in a signal handler? The handler may have interrupted the thread in malloc
 * or in OpenMP's library. `before` is the mask before redcc_signals_hold. Makes some 70 system
 * calls. If handlers are installed, it scans the whole stack on x86-64. */
bool redcc_signals_in_handler(uint64_t before);

/** Unblocks, in the calling thread, the signals with the default action, so that an interrupt ends
 * the program at once, even in a long loop. Called between redcc_signals_hold, which returned
 * `before`, and redcc_signals_release. Makes some 30 system calls. */
void redcc_signals_let_default(uint64_t before);

/** Does the signal have its default action, according to the system? */
bool redcc_signal_is_default(int number);

#endif
