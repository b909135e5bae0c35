/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Internal interface of the reader of the IR's text form. A function that fails sets `message`. */
#ifndef IR_IR_READER_H
#define IR_IR_READER_H

#include "ir/ir.h"
#include "ir_reader/sexp.h"
#include "support/map.h"
#include "support/vector.h"

typedef struct ir_reader {
    arena *arena;
    ir_unit *unit;
    const char *message; /* the first failure's message */
    map *records;        /* key -> ir_record */
    map *file_names;     /* key -> ir_variable */
    map *functions;      /* key -> ir_function */
    map *local_names;    /* key -> ir_variable, for the function being read */
    ir_function *function;
    VECTOR(ir_variable *) variables;
} ir_reader;

/** Sets the message unless one is set. Returns false. */
bool ir_reader_expected(ir_reader *r, const sexp *at, const char *what);

/** Returns the type that an atom names after its first `skip` bytes, or NULL on failure. */
const ir_type *ir_read_type(ir_reader *r, const sexp *atom, size_t skip);

/** Returns the name in a key: "i" for "i" and "i.2", "" for ".1". */
const char *ir_key_name(arena *a, const char *key);
/** Reads "begin-end" after the first `skip` bytes of the atom. */
bool ir_read_range(ir_reader *r, const sexp *atom, size_t skip, ir_range *range);
/** Reads an integer after the first `skip` bytes of the atom. */
bool ir_read_integer(ir_reader *r, const sexp *atom, size_t skip, int64_t *value);

/** Makes a variable with this key. Fails if there is one already. */
ir_variable *ir_read_new_variable(ir_reader *r, const sexp *key, ir_storage storage);

/** Reads an expression or statement, whose variables and functions are given by their keys. */
ir_node *ir_read_node(ir_reader *r, const sexp *s);

#endif
