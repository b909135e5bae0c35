/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Internals of the printer of the text form: types, and keys (a name and, if needed, a number that
 *  distinguishes objects of the same name). */
#ifndef IR_IR_PRINTER_H
#define IR_IR_PRINTER_H

#include "ir/ir.h"
#include "support/buffer.h"
#include "support/map.h"
#include "support/vector.h"

typedef struct ir_printer {
    buffer *out;
    arena *scratch;
    const ir_unit *unit;               /* NULL when a single node is printed; then names have no
                                        * numbers */
    VECTOR(const ir_record *) records; /* all records that are reachable, in order of first use */
    map *record_numbers;               /* record -> its number among records of the same name,
                                        * from 1 */
    map *record_names;                 /* name -> number of records that have it */
    map *seen_types;
    map *variable_names;        /* name (for locals: "id of the function, name") -> number of
                                 * variables that have it */
    unsigned *variable_numbers; /* by variable id: its number among variables of the same name in
                                 * the file and its function */
    unsigned *function_numbers; /* by function id: its number among functions of the same name
                                 * (GNU C allows overloading) */
    ir_variable ***undeclared;  /* by function id: a NULL-terminated list of the locals without a
                                 * declarator in the function's body */
} ir_printer;

/** Finds and numbers all variables and records of the unit. */
void ir_printer_begin(ir_printer *p, buffer *out, arena *scratch, const ir_unit *unit);
void ir_print_variable_key(const ir_printer *p, const ir_variable *variable);
void ir_print_function_key(const ir_printer *p, const ir_function *function);
void ir_print_record_key(const ir_printer *p, const ir_record *record);
void ir_print_type(const ir_printer *p, const ir_type *type);

/** Appends the text in quotes, with the escapes \\ \" \n \r \t and \ooo. */
void ir_print_quoted(buffer *out, const char *text, size_t length);

#endif
