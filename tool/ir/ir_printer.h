/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Internals of the text form's printer: keys (which distinguish objects of one name), types. */
#ifndef IR_IR_PRINTER_H
#define IR_IR_PRINTER_H

#include "ir/ir.h"
#include "support/buffer.h"
#include "support/map.h"
#include "support/vector.h"

typedef struct ir_printer {
    buffer *out;
    arena *scratch;
    const ir_unit *unit;               /* NULL: a single node, with all names unchanged */
    VECTOR(const ir_record *) records; /* all that are reachable, in order of first use */
    map *record_numbers;               /* record -> 1 for the first of its name, 2 ... */
    map *record_names;                 /* name -> number of records */
    map *seen_types;
    map *variable_names;        /* name, for locals "function's id, name" -> number of variables */
    unsigned *variable_numbers; /* by id: as for records, in the variable's function */
    unsigned *function_numbers; /* by id: overloaded ones (GNU) share a name */
    ir_variable ***undeclared;  /* by function id: locals without a declarator in its body; each
                                   list ends in NULL */
} ir_printer;

/** Finds and numbers all variables and records of the unit. */
void ir_printer_begin(ir_printer *p, buffer *out, arena *scratch, const ir_unit *unit);
void ir_print_variable_key(const ir_printer *p, const ir_variable *variable);
void ir_print_function_key(const ir_printer *p, const ir_function *function);
void ir_print_record_key(const ir_printer *p, const ir_record *record);
void ir_print_type(const ir_printer *p, const ir_type *type);

/** Appends the text in quotes, with \\ \" \n \r \t and \ooo. */
void ir_print_quoted(buffer *out, const char *text, size_t length);

#endif
