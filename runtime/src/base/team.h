/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Preparation before OpenMP creates threads for a region, and the work after it. Nothing if the
 * calling thread's last region had the same number: GCC's OpenMP and LLVM's keep them.
 */
#ifndef REDCC_TEAM_H
#define REDCC_TEAM_H

#include <stdbool.h>
#include <stdint.h>

/** Before a region of `threads` threads begins: returns how many are available (OpenMP ends a
 *  program if the system refuses it a thread); 1: only the calling one; 0: the region must not
 *  begin, because the thread is in a handler, which may have interrupted malloc. before: the
 *  thread's mask before redcc_signals_hold. Ensures that the threads' code is not unloaded while
 *  they exist, and that their stacks are as large as the main thread's may become. Signals must be
 *  blocked (signals.h); those with default actions are let through. */
int redcc_team_prepare(int threads, uint64_t before);

/** At program start, binds the functions of OpenMP's library that every translated loop calls:
 *  otherwise binding them would take longer than a first loop of some microseconds. */
void redcc_team_bind(void);

/** Is the calling thread within an execution? A loop that begins meanwhile, other than in its body,
 *  is in a signal handler, which may find locks held. */
extern _Thread_local int redcc_within __attribute__((__tls_model__("initial-exec")));

/** Will OpenMP create threads for a region of `threads` threads? */
bool redcc_team_grows(int threads);

/** How many more threads than its last region had does one of `threads` need? */
int redcc_team_missing(int threads);

/** How many of these must OpenMP start? None for the main thread if the process has that many
 *  threads: the program's regions may have started them. They may be other threads than OpenMP's,
 *  so this is only an estimate. */
int redcc_team_to_start(int threads);

/** Is the calling thread the process's first one, outside of parallel regions, and are all others
 *  idle threads of its regions? Then no other thread executes the program's code until this one
 *  lets it. Threads of the program's own regions are recognised only after a region of the runtime
 *  with as many threads, which this begins. */
bool redcc_team_is_alone(void);

/** Are all threads of the process those of the calling thread's team, which have noted themselves
 *  and come together, or idle ones? The team is of an outermost region; outside of regions the same
 *  as redcc_team_is_alone. */
bool redcc_team_has_met(void);

/** Called by each thread of a region but its first: OpenMP or the runtime has made it. */
void redcc_team_note_member(void);

/** In a new process only the calling thread exists. */
void redcc_team_forked(void);

/** The region has begun, with `threads` threads; called by its first thread. */
void redcc_team_came(int threads);

#endif
