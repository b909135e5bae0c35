/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Inside the reader of the text form. Each function that fails has set `message`. */
#ifndef IR_IR_READER_H
#define IR_IR_READER_H

#include "ir/ir.h"
#include "ir_reader/sexp.h"
#include "support/map.h"
#include "support/vector.h"

typedef struct ir_reader {
    arena *arena;
    ir_unit *unit;
    const char *message; /* of the first failure */
    map *records;        /* key -> ir_record */
    map *file_names;     /* key -> ir_variable */
    map *functions;      /* key -> ir_function */
    map *local_names;    /* key -> ir_variable, of the function being read */
    ir_function *function;
    VECTOR(ir_variable *) variables;
} ir_reader;

/** Sets the message, unless one is set. Always false. */
bool ir_reader_expected(ir_reader *r, const sexp *at, const char *what);

/** The type an atom names; from behind its first `skip` bytes. NULL on failure. */
const ir_type *ir_read_type(ir_reader *r, const sexp *atom, size_t skip);

/** The name in a key: "i" for "i" and "i.2", "" for ".1". */
const char *ir_key_name(arena *a, const char *key);
/** "begin-end" behind the first `skip` bytes of the atom. */
bool ir_read_range(ir_reader *r, const sexp *atom, size_t skip, ir_range *range);
bool ir_read_integer(ir_reader *r, const sexp *atom, size_t skip, int64_t *value);

/** Makes a variable of that key; fails where there is one already. */
ir_variable *ir_read_new_variable(ir_reader *r, const sexp *key, ir_storage storage);

/** An expression or statement; variables and functions by their keys. */
ir_node *ir_read_node(ir_reader *r, const sexp *s);

#endif
