/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Explains in one sentence why a loop is sequential and what the user can do. */
#ifndef REDCC_WHY_H
#define REDCC_WHY_H

#include "report.h"

enum { REDCC_WHY = 256 };

/** Writes a sentence about the most frequent reason of the loop's sequential calls to `text`. The
 * text is empty if most calls ran in parallel, or if there were no calls. */
void redcc_why_sequential(const struct statistics *it, char text[REDCC_WHY]);

#endif
