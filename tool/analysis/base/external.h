/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Functions of other files, as the options say. */
#ifndef ANALYSIS_EXTERNAL_H
#define ANALYSIS_EXTERNAL_H

#include "analysis/base/facts.h"

/** What may be relied on where this declaration is called. EXPORTED_NOTHING of functions with a
 *  body here, and of those that attributes or an asm label may make another one. */
exported_kind external_kind(const analysis_options *options, const ir_function *function);

#endif
