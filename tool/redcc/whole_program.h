/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** --analyze -p DIR without an input: a report on all C files of a build. */
#ifndef WHOLE_PROGRAM_H
#define WHOLE_PROGRAM_H

#include "redcc/options.h"

/** Reports on each file as it would be alone, but for what foreign.h says, and a summary on
 * standard error. Returns false where a file could not be analysed; the others are nevertheless. */
bool whole_program_analyse(arena *a, const options *o);

#endif
