/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#ifndef REDCC_ESCAPES_H
#define REDCC_ESCAPES_H

#include <stdbool.h>

/** May a handler of a signal, or a cancellation, leave the function that it interrupts, or take it
 * to another process? False only if no object of the process refers to a function by which that is
 * done, nor to one by which more objects or functions could be found. The answer of the first call
 * holds for good. */
bool redcc_may_escape(void);

/** May the program map memory at several addresses? False only if no object of the process refers
 * to a function by which memory is mapped or attached, nor to one by which more objects or
 * functions could be found. The answer of the first call holds for good. */
bool redcc_may_map(void);

/** Does the program define free without the functions for aligned memory? gcc's OpenMP library
 * takes its teams by these and releases them by free: after a region of one thread, and when the
 * number of threads changes. The answer of the first call holds for good. */
bool redcc_allocator_is_split(void);

/** Does an assertion that fails end the process without another function of the program's: by the
 *  C library's own report, with no handler of SIGABRT? */
bool redcc_assertions_abort(void);

#endif
