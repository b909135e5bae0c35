/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Prepares a region for which OpenMP may have to create threads, and restores settings afterwards.
 * Does nothing if the calling thread's last region had at least as many threads, because GCC's and
 * LLVM's OpenMP keep their threads.
 */
#ifndef REDCC_TEAM_H
#define REDCC_TEAM_H

#include <stdbool.h>
#include <stdint.h>

/** Called before a region of `threads` threads. Returns how many threads are available, because
 * OpenMP ends the program if the system refuses to start one. 1: only the calling thread is
 * available. 0: the region must not begin, because the thread is in a signal handler, which may
 * have interrupted malloc. Ensures that the threads' code is not unloaded while they exist. If
 * memory permits, makes their stacks as large as the main thread's stack may become. Signals must
 * be blocked (signals.h), and `before` is the mask before that; signals with the default action are
 * unblocked while OpenMP's threads start. */
int redcc_team_prepare(int threads, uint64_t before);

/** Called at program start: binds the functions of GNU's OpenMP library that every translated loop
 * calls. Binding them in a first loop of some microseconds would take longer than the loop. */
void redcc_team_bind(void);

/** Is the calling thread within an execution? If so, a loop that begins now was called by the body
 * of the executed loop, or by a signal handler. It must run sequentially, because it may find locks
 * held. */
extern _Thread_local int redcc_within __attribute__((__tls_model__("initial-exec")));

/** Must threads be created for a region of `threads` threads? */
bool redcc_team_grows(int threads);

/** The number of threads that must be created for a region of `threads` threads. */
int redcc_team_missing(int threads);

/** How many of the missing threads must OpenMP start? The answer is an estimate. For the main
 * thread's first region it is 0 if the process already has `threads` threads, because regions of
 * the program may have started them. */
int redcc_team_to_start(int threads);

/** Is the calling thread the process's initial thread, outside of parallel regions, and are all
 * other threads idle threads of its earlier regions? Then no other thread executes the program's
 * code until this thread starts a region. Idle threads register only in a region of the runtime, so
 * this function opens one if it finds unknown threads. */
bool redcc_team_is_alone(void);

/** Is each thread of the process either a thread of the calling thread's OpenMP team, or an idle
 * thread of OpenMP? All threads of the team must have registered and reached the same loop. False
 * in nested regions. Outside of regions it returns redcc_team_is_alone(). */
bool redcc_team_has_met(void);

/** Called by each thread of an OpenMP region except the first: registers it as a thread of OpenMP.
 */
void redcc_team_note_member(void);

/** Called in a child process, where only the calling thread exists: forgets the parent's threads.
 */
void redcc_team_forked(void);

/** Called by the first thread of a region of `threads` threads, when all of them exist: stores
 * their number, and restores the default stack size. */
void redcc_team_begun(int threads);

#endif
