/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "base/forked.h"

#include <pthread.h>
#include <sys/stat.h>

static bool had_threads; /* of the thread that forks, from before fork to the child */
static bool is_forked;   /* written where there is one thread only */

/* A folder has a link for itself, one for its parent's entry, and one for each folder in it. Where
 * there is no /proc threads are assumed. */
static bool has_threads(void) {
    struct stat tasks;
    return stat("/proc/self/task", &tasks) != 0 || tasks.st_nlink > 3;
}

static void before(void) {
    had_threads = has_threads();
}

static void in_child(void) {
    is_forked = is_forked || had_threads;
}

/* From the beginning, for the program may have parallel regions of its own. */
__attribute__((constructor)) static void watch(void) {
    if (pthread_atfork(before, NULL, in_child) != 0)
        is_forked = true;
}

bool redcc_is_forked(void) {
    return is_forked;
}
