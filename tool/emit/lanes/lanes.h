/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Writes the form for several iterations at once, called lanes (redcc/lanes.h). */
#ifndef EMIT_LANES_LANES_H
#define EMIT_LANES_LANES_H

#include "emit/base/loop.h"

/** Writes the function that executes several iterations at once, if requested and possible; sets
 *  loop->lanes and the outcome. */
void write_lanes(loop_text *loop, writer *out);

#endif
