/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** A loop's body with and without the stores that are made in a separate loop after it (loop
 *  fission; facts.h: distributed_store). */
#ifndef ANALYSIS_DISTRIBUTED_H
#define ANALYSIS_DISTRIBUTED_H

#include "analysis/base/facts.h"

/** Removes the stores from the function's tree; the statement's block no longer has them as
 *  children, but their parent links remain. NULL: nothing to do. */
void distributed_take_out(const distribution *stores);
/** Puts them back, before any other analysis of the function. */
void distributed_put_back(const distribution *stores);

#endif
