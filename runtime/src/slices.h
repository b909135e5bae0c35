/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** REDCC_VALIDATE=1, loops of redcc/parallel.h: do slices name all that their bodies update? */
#ifndef REDCC_SLICES_H
#define REDCC_SLICES_H

#include "redcc/entry.h"

/** Executes slice and body of each iteration once more, without an update being made, and says on
 *  standard error which updated rows a slice does not name. Returns how many were found. Called
 *  after an execution in parallel, so that what iterations read is known not to be updated. */
long redcc_slices_check(redcc_site *site, const redcc_attempt *attempt, redcc_member *member,
                        const void *context);

#endif
