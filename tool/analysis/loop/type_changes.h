/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Decides whether two accesses whose order matters may overlap, also if one of them changes the
 *  type of the memory. */
#ifndef ANALYSIS_TYPE_CHANGES_H
#define ANALYSIS_TYPE_CHANGES_H

#include "analysis/loop/loop_analysis.h"

/** Whenever an iteration makes the access, does it first read the memory with the access's type?
 *  True for a read, and for an update that reads its element. For an access to an own element
 *  (own.h): does each iteration read the element before it stores to it? */
bool access_reads_first(const loop_analysis *j, const loop_access *a);

/** May the two accesses overlap? Their types can prove that they do not only if both read first.
 *  Otherwise, the later one may be a plain store to memory that is no longer read as its old type,
 *  which C permits (C17 6.5p6). If both read first, the later one would read memory of the other's
 *  type, which is undefined (6.5p7). */
overlap accesses_overlap(const loop_analysis *j, const loop_access *a, const loop_access *b);

#endif
