/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * What is done before OpenMP makes threads for a region, and after. Nothing, where the calling
 * thread's last region had as many: GCC's OpenMP and LLVM's keep them.
 */
#ifndef REDCC_TEAM_H
#define REDCC_TEAM_H

#include <stdbool.h>
#include <stdint.h>

/** Before a region of `threads` threads begins: how many can be had (OpenMP ends a program where
 *  the system refuses it a thread); 1: none beside the calling one; 0: the region must not begin,
 *  for the thread is in a handler, which may have found it in malloc. before: what the thread
 *  blocked before redcc_signals_hold. Sees to it that the code the
 *  threads run is not unloaded while they are there, and that their stacks are as large as the
 *  main thread's may become. Signals must be held (signals.h); those left to the system
 *  are let through. */
int redcc_team_prepare(int threads, uint64_t before);

/** Has what every translated loop asks OpenMP's library bound, as the program begins: that takes a
 *  first loop of some microseconds longer than the loop itself. */
void redcc_team_bind(void);

/** Is the calling thread within an execution? A loop that begins meanwhile, unless in its body, is
 *  one in a handler, which may find locks held. */
extern _Thread_local int redcc_within __attribute__((__tls_model__("initial-exec")));

/** May the system refuse the process a thread, or memory for one? */
bool redcc_team_is_limited(void);

/** Will a region of `threads` threads have OpenMP make some? */
bool redcc_team_grows(int threads);

/** How many threads more than its last region had does one of `threads` need? */
int redcc_team_missing(int threads);

/** How many of these must OpenMP start? For the main thread none, where the process has as many
 *  threads as that: the program's regions may have started them. They may be other threads than
 *  OpenMP's, so this is for estimates. */
int redcc_team_to_start(int threads);

/** Is the calling thread the process's first one, outside of parallel regions, and are all others
 *  idle ones of regions that it had? Then no other thread runs any of the program's code until it
 *  makes one do so. Threads of regions of the program's own may be taken for such only after a
 *  region of as many threads of the runtime's, which this begins. */
bool redcc_team_is_alone(void);

/** To be called by each thread of a region but its first: it is one that OpenMP, or the runtime,
 *  has made. */
void redcc_team_note_member(void);

/** In a new process only the calling thread is there. */
void redcc_team_forked(void);

/** The region has begun, with `threads` threads; to be called by its first thread. */
void redcc_team_came(int threads);

#endif
