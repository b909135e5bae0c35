/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Known properties of functions that other files define, as given by the analysis options. */
#ifndef ANALYSIS_EXTERNAL_H
#define ANALYSIS_EXTERNAL_H

#include "analysis/base/facts.h"

/** Known properties of the function that this declaration refers to. EXPORTED_NOTHING if it has a
 *  body here, or if attributes or an asm label may rename it. */
exported_kind external_kind(const analysis_options *options, const ir_function *function);

#endif
