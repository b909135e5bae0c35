/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#ifndef REDCC_ESCAPES_H
#define REDCC_ESCAPES_H

#include <stdbool.h>

/** May a signal handler or a cancellation leave the function that it interrupts, or continue that
 * function in another process? False only if no object of the process refers to a function that
 * does this, or to a function that could load more objects or functions. The result of the first
 * call is cached. */
bool redcc_may_escape(void);

/** May the program map the same memory at more than one address? False only if neither the program
 * nor a shared library refers to a function that maps or attaches memory, or to a function that
 * could load more libraries or look up functions. The result of the first call is cached. */
bool redcc_may_map(void);

/** Does the program define free, but not the functions for aligned memory? gcc's OpenMP library
 * allocates its teams by aligned_alloc or a similar function and releases them by free. It does so
 * after a region of one thread and when the number of threads changes. The result of the first call
 * is cached. */
bool redcc_allocator_is_split(void);

/** Does a failing assertion end the process without calling another function of the program? True
 * if the C library reports the failure and SIGABRT has its default action. */
bool redcc_assertions_abort(void);

#endif
