/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Functions of other files that a file's loops call: found in the project's sources, and read.
 * What is found there holds of a program only if it is linked with these definitions: a loop asks
 * when it runs (redcc_are_linked), so that nothing rests on which file was found. */
#ifndef IMPORTS_H
#define IMPORTS_H

#include "analysis/analysis.h"
#include "driver/project.h"
#include "redcc/options.h"

/**
 * Adds the bodies of functions that loops of refused verdicts lead to and that the file only
 * declares. Returns whether there is any; the unit is then to be analysed anew.
 */
bool imports_add(arena *a, ir_unit *unit, const project *around, const string_list *flags,
                 const analysis_result *before);

/**
 * The text behind the file's own that compares what is linked with what was read of the functions
 * that translated loops rest on: `static const redcc_linkage *redcc__linked(void)`; NULL: they rest
 * on none of another file. *obstacle is set where it cannot be written.
 */
const char *imports_check(arena *a, const ir_unit *unit, const analysis_result *analysed,
                          const char **obstacle);

#endif
