/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** REDCC_VALIDATE=1 for loops of redcc/parallel.h: checks that their slices name all rows that the
 * bodies update. */
#ifndef REDCC_SLICES_H
#define REDCC_SLICES_H

#include "redcc/entry.h"

/** Executes slice and body of each iteration, without making updates. Prints to standard error
 * updates of rows that the slice does not name, and returns the number of these updates. Called
 * before each execution, even if the loop then runs sequentially. */
long redcc_slices_check(redcc_site *site, const redcc_attempt *attempt, redcc_member *member,
                        const void *context);

#endif
