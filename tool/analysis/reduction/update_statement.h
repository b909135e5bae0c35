/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Finds the statement that the owner of an element executes as a whole and every other thread
 *  skips. It is an assignment, or a conditional statement that reads the element in its condition
 *  and assigns nothing else:
 *
 *      R[k] = e - R[k]; if (R[k] < v) R[k] = v; if (R[k]) R[k] = 0; else R[k] += v; */
#ifndef ANALYSIS_UPDATE_STATEMENT_H
#define ANALYSIS_UPDATE_STATEMENT_H

#include "analysis/loop/loop_analysis.h"

/** The statement for a write of the element `target`, a node of the loop's text. NULL if the write
 *  is part of a larger expression, or its value is used. */
const ir_node *update_statement(const loop_analysis *j, const ir_node *target);

/** Is the access a read, in the loop's text, of the same element that the statement writes? Only
 *  the owner makes such a read, between its own updates, so it reads the value that the sequential
 *  loop would read. */
bool update_statement_reads_itself(const loop_access *read, const ir_node *statement,
                                   const ir_node *target);

/** Is the access a read for which update_statement_reads_itself is true with some statement of the
 *  loop? */
bool is_read_of_own_element(const loop_analysis *j, const loop_access *read);

#endif
