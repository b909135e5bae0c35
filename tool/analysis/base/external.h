/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Functions of other files, as given by the options. */
#ifndef ANALYSIS_EXTERNAL_H
#define ANALYSIS_EXTERNAL_H

#include "analysis/base/facts.h"

/** Known properties of the function called by this declaration. EXPORTED_NOTHING for functions with
 *  a body here, and for those that attributes or an asm label may rename. */
exported_kind external_kind(const analysis_options *options, const ir_function *function);

#endif
