/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The statement that the owner of an element executes as a whole, and every other thread skips: an
 * assignment, or a conditional statement that reads the element in its condition and assigns
 * nothing else:
 *
 *     R[k] = e - R[k];        if (R[k] < v) R[k] = v;        if (R[k]) R[k] = 0; else R[k] += v;
 */
#ifndef ANALYSIS_UPDATE_STATEMENT_H
#define ANALYSIS_UPDATE_STATEMENT_H

#include "analysis/loop/loop_analysis.h"

/** The statement for a write of the element `target`, a node of the loop's text. NULL: it is part
 *  of a larger expression, or its value is used. */
const ir_node *update_statement(const loop_analysis *j, const ir_node *target);

/** Is this a read, in the text itself, of the element that the statement around it writes? Only the
 *  owner makes it, between its own updates: it reads the sequential loop's value. */
bool update_statement_reads_itself(const loop_access *read, const ir_node *statement,
                                   const ir_node *target);

/** The same for any statement of the loop around the read that writes the element it reads. */
bool is_read_of_own_element(const loop_analysis *j, const loop_access *read);

#endif
