/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The state of the must-write proof at a point of the program: the bytes of the analysed object
 *  that have definitely been written, and the known values of local scalars. */
#ifndef ANALYSIS_MUST_WRITE_STATE_H
#define ANALYSIS_MUST_WRITE_STATE_H

#include "ir/ir.h"
#include "support/vector.h"

/** A set of bytes of an object with a fixed size. Functions that combine two sets require equal
 *  sizes. */
typedef struct byte_set {
    uint64_t *words;
    unsigned word_count;
} byte_set;

byte_set byte_set_new(arena *a, int64_t size); /* an empty set */
byte_set byte_set_copy(arena *a, byte_set other);
void byte_set_assign(byte_set to, byte_set from);
void byte_set_add(byte_set s, int64_t begin, int64_t end);
/** Does the set contain all of [begin, end)? */
bool byte_set_has(byte_set s, int64_t begin, int64_t end);
void byte_set_unite(byte_set s, byte_set other);
/** Removes the bytes of `other` from s. */
void byte_set_subtract(byte_set s, byte_set other);
bool byte_set_is_empty(byte_set s);
bool byte_set_includes(byte_set s, byte_set other);
/** The index after the last byte in the set; 0 if it is empty. */
int64_t byte_set_end(byte_set s);
/** Adds the bytes that hold a value of `type` at `offset`, without padding. All of them must be
 *  inside the set's size. */
void byte_set_add_value(byte_set s, const ir_type *type, int64_t offset);

typedef enum value_kind {
    VALUE_OTHER,   /* any value that does not point into the object */
    VALUE_INTEGER, /* the integer `number` */
    VALUE_POINTER  /* a pointer into the object, `number` bytes from its start. If not is_exact,
                    * it may point anywhere, into the object or elsewhere */
} value_kind;

typedef struct value {
    value_kind kind;
    bool is_exact; /* for pointers */
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
    VECTOR(binding) bindings; /* variables not listed have VALUE_OTHER */
} state;

state state_new(arena *a, int64_t size); /* a reachable state without any facts */
state state_copy(arena *a, const state *s);
/** Reduces *s to the facts that are true in both states. */
void state_join(arena *a, state *s, const state *other);
/** Do all variables have the same values in both states? */
bool state_same_bindings(const state *a, const state *b);
value state_get(const state *s, const ir_variable *variable);
void state_set(arena *a, state *s, const ir_variable *variable, value v);
/** The number of steps that copying or joining the state counts as. */
unsigned state_weight(const state *s);

#endif
