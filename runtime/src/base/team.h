/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Preparation before OpenMP creates threads for a region, and the work afterwards. Does nothing if
 * the calling thread's last region had the same number: GCC's OpenMP and LLVM's keep their threads.
 */
#ifndef REDCC_TEAM_H
#define REDCC_TEAM_H

#include <stdbool.h>
#include <stdint.h>

/** Called before a region of `threads` threads: returns how many are available (OpenMP ends a
 *  program if the system refuses it a thread); 1: only the calling one; 0: the region must not
 *  begin, because the thread is in a handler, which may have interrupted malloc. before: the
 *  thread's mask before redcc_signals_hold. Ensures that the threads' code is not unloaded while
 *  they exist, and that their stacks are as large as the main thread's may become. Signals must be
 *  blocked (signals.h); those with the default action are unblocked while threads start. */
int redcc_team_prepare(int threads, uint64_t before);

/** At program start, binds the functions of OpenMP's library that every translated loop calls:
 *  otherwise binding them would take longer than a first loop of some microseconds. */
void redcc_team_bind(void);

/** Is the calling thread within an execution? A loop that begins then, and not in the loop's body,
 * is in a signal handler, which may find locks held. */
extern _Thread_local int redcc_within __attribute__((__tls_model__("initial-exec")));

/** Will OpenMP create threads for a region of `threads` threads? */
bool redcc_team_grows(int threads);

/** The number of threads by which a region of `threads` exceeds the calling thread's last region.
 */
int redcc_team_missing(int threads);

/** How many of these must OpenMP start? None for the main thread if the process already has that
 * many threads, which the program's own regions may have started. They need not be OpenMP's, so
 * this is only an estimate. */
int redcc_team_to_start(int threads);

/** Is the calling thread the process's first one, outside of parallel regions, and are all others
 *  idle threads of its regions? Then no other thread executes the program's code until this one
 * starts a region. Threads of the program's own regions are recognised only in a region of the
 * runtime with as many threads, which this function opens. */
bool redcc_team_is_alone(void);

/** Does every running thread of the process belong to the calling thread's team, whose threads have
 * all registered and reached the same loop? False in nested regions. Outside of regions this is
 * redcc_team_is_alone. */
bool redcc_team_has_met(void);

/** Called by each thread of a region except the first: registers it as made by OpenMP or the
 * runtime. */
void redcc_team_note_member(void);

/** Called in a child process, where only the calling thread exists: forgets the parent's threads.
 */
void redcc_team_forked(void);

/** Called by the region's first thread when the region has begun with `threads` threads. */
void redcc_team_begun(int threads);

#endif
