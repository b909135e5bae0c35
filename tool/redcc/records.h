/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What a file says of the functions that it defines, for loops of other files that call them. */
#ifndef RECORDS_H
#define RECORDS_H

#include "driver/project.h"
#include "ir/ir.h"

/** The text to be written behind the file's own: a redcc_record for each function that a loop of
 *  another file seems to lead to; NULL: there is none. To be called before bodies of other files
 *  are added. It needs no header, and is of plain C with GNU attributes. */
const char *records_write(arena *a, const ir_unit *unit, const project *around);

#endif
