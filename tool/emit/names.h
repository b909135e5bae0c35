/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What things are called in the text of a loop. */
#ifndef EMIT_NAMES_H
#define EMIT_NAMES_H

#include "emit/loop.h"

/** Sets arrays and counter_type. */
void name_things(loop_text *loop);

#endif
