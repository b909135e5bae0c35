/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Removes from a loop's body the stores that a separate loop makes afterwards (loop fission;
 *  facts.h: distributed_store), and puts them back. */
#ifndef ANALYSIS_DISTRIBUTED_H
#define ANALYSIS_DISTRIBUTED_H

#include "analysis/base/facts.h"

/** Removes the stores from the function's tree. The stores' parent links remain, although the block
 *  no longer has them as children. Does nothing if `stores` is NULL. */
void distributed_take_out(const distribution *stores);
/** Puts the stores back, which must happen before any other analysis of the function. */
void distributed_put_back(const distribution *stores);

#endif
