/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Why is a loop sequential? One answer, in a sentence that its user can act on. */
#ifndef REDCC_WHY_H
#define REDCC_WHY_H

#include "report.h"

enum { REDCC_WHY = 256 };

/** Writes the sentence, of the reason that most of its sequential calls had; "": most calls ran in
 *  parallel, or there was none. */
void redcc_why_sequential(const struct statistics *it, char text[REDCC_WHY]);

#endif
