/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Overlap of accesses whose order counts, also if one of them gives the memory another type. */
#ifndef ANALYSIS_TYPE_CHANGES_H
#define ANALYSIS_TYPE_CHANGES_H

#include "analysis/loop/loop_analysis.h"

/** Does an iteration, whenever it makes the access, first read the memory with the access's type?
 *  True of a read, and of an update that reads its element. For the first read of an own element
 *  (own.h): do all iterations read the element before they store to it? */
bool access_reads_first(const loop_analysis *j, const loop_access *a);

/** May the two overlap? Their types prove that they do not only if each reads first: then the
 *  access that the program makes later finds the other's type, which is undefined (C17 6.5p7). A
 *  plain store over memory that is not read any more as another type is allowed (6.5p6). */
overlap accesses_overlap(const loop_analysis *j, const loop_access *a, const loop_access *b);

#endif
