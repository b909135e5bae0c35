/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Loops under `omp for`: all threads of the team reach the loop, one executes it without its
 * directive, and the others help as workers (redcc/crew.h). */
#ifndef EMIT_CREW_H
#define EMIT_CREW_H

#include "emit/base/loop.h"

/** Is the loop under `omp for`, so that a team executes it? */
bool has_crew(const loop_text *loop);

/** Writes, at the beginning of the loop's block, the beginning of an inner block that only one
 * thread of the team enters, while the others help. If the loop is executed as written, all
 * threads enter it. */
void write_meeting(loop_text *loop, writer *out);

/** Writes, at the end of the loop's block, the end of the block that write_meeting begins. */
void write_parting(loop_text *loop, writer *out);

#endif
