/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Records of the functions that a file defines, for loops of other files that call them. */
#ifndef RECORDS_H
#define RECORDS_H

#include "driver/project.h"
#include "ir/ir.h"
#include "support/buffer.h"

/** The text to append to the file: a redcc_record for each function that a loop of another file
 * seems to call, or NULL if there is none. Must be called before imports_add. The text needs no
 * header, and is plain C with GNU attributes. */
const char *records_write(arena *a, const ir_unit *unit, const project *around);

/** Declares the record of `function` in text to be appended, weakly: its address is NULL if the
 * program has none. `type`: the record's type. `as`: the record's name in the text; NULL: the name
 * of the object file's symbol. */
void record_declare_weak(buffer *out, const char *type, const char *as, const char *function);

/** Declares `as` as a weak reference to `function`, which the program then need not define: the
 *  compiler may remove all other calls of it. */
void function_declare_weak(buffer *out, const char *as, const char *function);

#endif
