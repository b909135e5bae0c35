/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Running other programs: streams to files, signals passed on, statuses handed back. */
#ifndef DRIVER_PROCESS_H
#define DRIVER_PROCESS_H

#include "driver/words.h"

/** Files in the place of the standard streams; NULL: those of this process. */
typedef struct process_streams {
    const char *input;
    const char *output;
    const char *error;
} process_streams;

/** From here on SIGINT, SIGTERM, SIGHUP and SIGPIPE go to the program that runs, and are
 *  remembered. */
void process_catch_signals(void);

/** The signal caught so far, 0 for none. */
int process_signal(void);

/** Runs a program and waits for it. Returns its exit status, 127 where it cannot be started, or the
 *  negative of the signal that ended it. Not thread-safe: one child at a time. */
int process_run(arena *a, const word_list *words, process_streams streams);

/** Becomes the program; returns only by ending this one: 127 (not found) or 126, with a message. */
_Noreturn void process_become(arena *a, const word_list *words);

/** Ends this process as the child ended, for a status that process_run gave: by the same exit
 *  status, or the same signal. */
_Noreturn void process_end_as(int status);

#endif
