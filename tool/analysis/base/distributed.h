/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** A loop's body with and without the stores that are made after it (facts.h: distributed_store).
 */
#ifndef ANALYSIS_DISTRIBUTED_H
#define ANALYSIS_DISTRIBUTED_H

#include "analysis/base/facts.h"

/** Takes the stores out of the tree of the function; each is asked for under its block no more, but
 *  has its parent still. NULL: nothing to do. */
void distributed_take_out(const distribution *stores);
/** Puts them back. Whoever takes them out does so before anything else asks for the function. */
void distributed_put_back(const distribution *stores);

#endif
