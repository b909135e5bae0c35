/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Returns the number of threads of the process, according to the system. */
#ifndef THREAD_COUNT_H
#define THREAD_COUNT_H

#include <dirent.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

static inline int count_threads(void) {
    int count = 0;
    DIR *tasks = opendir("/proc/self/task");
    assert_non_null(tasks);
    for (const struct dirent *task = readdir(tasks); task; task = readdir(tasks))
        count += task->d_name[0] != '.';
    closedir(tasks);
    return count;
}

#endif
