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

/** May the two accesses overlap? Different types prove that they do not, but only if both accesses
 *  read first: the later access would then read memory of the earlier one's type, which is
 *  undefined (C17 6.5p7). Otherwise the later access may be a plain store, which may change the
 *  memory's type (6.5p6). */
overlap accesses_overlap(const loop_analysis *j, const loop_access *a, const loop_access *b);

#endif
