/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Records of the functions that a file defines, for loops of other files that call them. */
#ifndef RECORDS_H
#define RECORDS_H

#include "driver/project.h"
#include "ir/ir.h"

/** The text to append to the file: a redcc_record for each function that a loop of another file
 * seems to call; NULL: there is none. Must be called before imports_add. The text needs no header,
 * and is plain C with GNU attributes. */
const char *records_write(arena *a, const ir_unit *unit, const project *around);

#endif
