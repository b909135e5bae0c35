/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#ifndef REDCC_ESCAPES_H
#define REDCC_ESCAPES_H

#include <stdbool.h>

/** May a signal handler, or a cancellation, leave the function that it interrupts, or continue it
 *  in another process? False only if no object of the process refers to a function that does this,
 *  or to one that could load more objects or functions. The answer of the first call is cached. */
bool redcc_may_escape(void);

/** May the program map memory at several addresses? False only if no object of the process refers
 *  to a function that maps or attaches memory, or to one that could load more objects or functions.
 *  The answer of the first call is cached. */
bool redcc_may_map(void);

/** Does the program define free without the functions for aligned memory? gcc's OpenMP library
 *  allocates its teams by these and releases them by free: after a region of one thread, and when
 *  the number of threads changes. The answer of the first call is cached. */
bool redcc_allocator_is_split(void);

/** Does a failing assertion end the process without calling any other function of the program: by
 * the C library's own report, with the default action of SIGABRT? */
bool redcc_assertions_abort(void);

#endif
