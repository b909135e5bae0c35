/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Runs other programs: redirects their streams to files, forwards signals, returns statuses. */
#ifndef DRIVER_PROCESS_H
#define DRIVER_PROCESS_H

#include "driver/words.h"

/** Files that replace the standard streams; NULL: those of this process. */
typedef struct process_streams {
    const char *input;
    const char *output;
    const char *error;
} process_streams;

/** From this call on, SIGINT, SIGTERM, SIGHUP and SIGPIPE are forwarded to the running program, and
 * recorded. */
void process_catch_signals(void);

/** The signal caught so far, 0 for none. */
int process_signal(void);

/** Runs a program and waits for it. Returns its exit status, 127 or 126 if it cannot be started,
 * or the negative of the signal that ended it. Not thread-safe: one child at a time. */
int process_run(arena *a, const word_list *words, process_streams streams);

/** Replaces this process by the program; on failure ends with 127 (not found) or 126, with a
 *  message. */
_Noreturn void process_become(arena *a, const word_list *words);

/** Ends this process as the child ended, given a status of process_run: with the same exit status,
 *  or by the same signal. */
_Noreturn void process_end_as(int status);

#endif
