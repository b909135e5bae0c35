/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** For programs of tests/accept that an exit or an abort ends. */
#ifndef CHILD_H
#define CHILD_H

#include <stdio.h>
#include <sys/wait.h>
#include <unistd.h>

/* Calls run(name) in a child process, and prints how that process ended. */
static inline void run_in_child(void (*run)(const char *name), const char *name) {
    const pid_t child = fork();
    int status = 0;
    if (child == 0) {
        run(name);
        _exit(0);
    }
    waitpid(child, &status, 0);
    printf("%s: %d\n", name, status);
    fflush(stdout);
}

#endif
