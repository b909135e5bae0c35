/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** `omp for`: all threads of the team reach the loop, one executes it without its directive, and
 *  the others work for it (redcc/crew.h). */
#ifndef EMIT_CREW_H
#define EMIT_CREW_H

#include "emit/base/loop.h"

/** Is it such a loop? */
bool has_crew(const loop_text *loop);

/** At the beginning of the loop's block: opens a block that only the first thread enters, while the
 * others help; all threads enter it if the loop is executed as it is written. */
void write_meeting(loop_text *loop, writer *out);

/** At the end of the loop's block: closes the block that write_meeting opened. */
void write_parting(loop_text *loop, writer *out);

#endif
