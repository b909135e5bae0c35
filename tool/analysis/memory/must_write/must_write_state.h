/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The state of the must-write proof at a point of the program: the bytes of the analysed object
 * that are definitely written, and the relevant values of local scalars.
 */
#ifndef ANALYSIS_MUST_WRITE_STATE_H
#define ANALYSIS_MUST_WRITE_STATE_H

#include "ir/ir.h"
#include "support/vector.h"

/** A set of bytes of an object of fixed size; combined sets have the same size. */
typedef struct byte_set {
    uint64_t *words;
    unsigned word_count;
} byte_set;

byte_set byte_set_new(arena *a, int64_t size); /* empty */
byte_set byte_set_copy(arena *a, byte_set other);
void byte_set_assign(byte_set to, byte_set from);
void byte_set_add(byte_set s, int64_t begin, int64_t end);
/** All of [begin, end)? */
bool byte_set_has(byte_set s, int64_t begin, int64_t end);
void byte_set_unite(byte_set s, byte_set other);
/** s becomes s without other. */
void byte_set_subtract(byte_set s, byte_set other);
bool byte_set_is_empty(byte_set s);
bool byte_set_includes(byte_set s, byte_set other);
/** One past the last byte in the set; 0: empty. */
int64_t byte_set_end(byte_set s);
/** Adds the bytes that store a value of `type` at `offset`, without padding. All of them must lie
 *  within the set's size. */
void byte_set_add_value(byte_set s, const ir_type *type, int64_t offset);

typedef enum value_kind {
    VALUE_OTHER,   /* anything that does not point into the object */
    VALUE_INTEGER, /* this number */
    VALUE_POINTER  /* into the object, `number` bytes from its start; or, inexact, anywhere: into
                      the object or elsewhere */
} value_kind;

typedef struct value {
    value_kind kind;
    bool is_exact; /* pointers */
    int64_t number;
} value;

value value_join(value a, value b);
bool value_equal(value a, value b);

typedef struct binding {
    const ir_variable *variable;
    value value;
} binding;

typedef struct state {
    bool is_reachable; /* if not, the other fields are invalid */
    byte_set written;
    VECTOR(binding) bindings; /* variables that are not in it hold VALUE_OTHER */
} state;

state state_new(arena *a, int64_t size); /* reachable, nothing known */
state state_copy(arena *a, const state *s);
/** The facts that hold in both states. */
void state_join(arena *a, state *s, const state *other);
/** Do variables hold the same values? */
bool state_same_bindings(const state *a, const state *b);
value state_get(const state *s, const ir_variable *variable);
void state_set(arena *a, state *s, const ir_variable *variable, value v);
/** The cost of a copy or join of it, in steps. */
unsigned state_weight(const state *s);

#endif
