/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** --analyze -p DIR without an input: a report on all C files of a build. */
#ifndef WHOLE_PROGRAM_H
#define WHOLE_PROGRAM_H

#include "redcc/options.h"

/** Reports on each file as it would alone, except that the facts of external_functions.h are used.
 *  Prints a summary on standard error. Returns false if a file could not be analysed; the others
 *  are analysed anyway. */
bool whole_program_analyse(arena *a, const options *o);

#endif
