/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Functions of other files that a file's loops call. They are found in the project's sources, and
 *  parsed. The facts about them hold only for a program linked with these definitions. A loop
 *  checks that when it runs (redcc_are_linked), so correctness does not depend on which file was
 *  found. */
#ifndef IMPORTS_H
#define IMPORTS_H

#include "analysis/analysis.h"
#include "driver/project.h"
#include "redcc/options.h"

/**
 * Adds the bodies of functions that refused loops call, directly or not, and that the file only
 * declares, if these bodies may change the reason. Returns whether any body was added; if so, the
 * unit must be analysed again.
 */
bool imports_add(arena *a, ir_unit *unit, const project *around, const string_list *flags,
                 const analysis_result *before);

/**
 * The text to append to the file: `static const redcc_linkage *redcc__linked(void)`. With it the
 * runtime compares the definitions that are linked with those that were parsed, for all functions
 * on which translated loops depend. Returns NULL if they depend on no function of another file.
 * Sets *obstacle if the text cannot be compiled.
 */
const char *imports_check(arena *a, const ir_unit *unit, const analysis_result *analysed,
                          const char **obstacle);

#endif
