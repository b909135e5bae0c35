/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/memory/must_write/must_write_state.h"

#include <assert.h>
#include <string.h>

byte_set byte_set_new(arena *a, int64_t size) {
    assert(size >= 0);
    byte_set s;
    s.word_count = (unsigned)((size + 63) / 64);
    s.words = ARENA_ARRAY(a, uint64_t, s.word_count + 1);
    return s;
}

byte_set byte_set_copy(arena *a, byte_set other) {
    byte_set s = byte_set_new(a, (int64_t)other.word_count * 64);
    byte_set_assign(s, other);
    return s;
}

void byte_set_assign(byte_set to, byte_set from) {
    assert(to.word_count >= from.word_count);
    if (from.word_count > 0)
        memcpy(to.words, from.words, from.word_count * sizeof *from.words);
}

void byte_set_add(byte_set s, int64_t begin, int64_t end) {
    assert(begin >= end || (begin >= 0 && end <= (int64_t)s.word_count * 64));
    while (begin < end) {
        const int64_t word = begin / 64;
        const int64_t stop = (word + 1) * 64 < end ? (word + 1) * 64 : end;
        const uint64_t ones = ~UINT64_C(0) >> (64 - (stop - begin));
        s.words[word] |= ones << (begin % 64);
        begin = stop;
    }
}

bool byte_set_has(byte_set s, int64_t begin, int64_t end) {
    assert(begin >= end || (begin >= 0 && end <= (int64_t)s.word_count * 64));
    while (begin < end) {
        const int64_t word = begin / 64;
        const int64_t stop = (word + 1) * 64 < end ? (word + 1) * 64 : end;
        const uint64_t ones = (~UINT64_C(0) >> (64 - (stop - begin))) << (begin % 64);
        if ((s.words[word] & ones) != ones)
            return false;
        begin = stop;
    }
    return true;
}

void byte_set_unite(byte_set s, byte_set other) {
    assert(s.word_count == other.word_count);
    for (unsigned i = 0; i < s.word_count; i++)
        s.words[i] |= other.words[i];
}

static void byte_set_intersect(byte_set s, byte_set other) {
    assert(s.word_count == other.word_count);
    for (unsigned i = 0; i < s.word_count; i++)
        s.words[i] &= other.words[i];
}

void byte_set_subtract(byte_set s, byte_set other) {
    assert(s.word_count == other.word_count);
    for (unsigned i = 0; i < s.word_count; i++)
        s.words[i] &= ~other.words[i];
}

bool byte_set_is_empty(byte_set s) {
    for (unsigned i = 0; i < s.word_count; i++)
        if (s.words[i] != 0)
            return false;
    return true;
}

bool byte_set_includes(byte_set s, byte_set other) {
    assert(s.word_count == other.word_count);
    for (unsigned i = 0; i < s.word_count; i++)
        if ((other.words[i] & ~s.words[i]) != 0)
            return false;
    return true;
}

int64_t byte_set_end(byte_set s) {
    for (unsigned i = s.word_count; i-- > 0;)
        if (s.words[i] != 0)
            return (int64_t)i * 64 + 64 - __builtin_clzll(s.words[i]);
    return 0;
}

/* Can each field be treated separately? False for unions and for records with bit-fields, because
 * their fields share bytes. Such a record is treated as a whole. */
static bool record_has_plain_fields(const ir_record *record) {
    if (record == NULL || record->is_union || !record->is_complete)
        return false;
    for (unsigned i = 0; i < record->field_count; i++)
        if (record->fields[i].is_bit_field || record->fields[i].type->size < 0)
            return false;
    return true;
}

static bool contains_record(const ir_type *type) {
    return ir_type_innermost(type)->kind == IR_RECORD;
}

void byte_set_add_value(byte_set s, const ir_type *type, int64_t offset) {
    if (type->kind == IR_RECORD && record_has_plain_fields(type->record)) {
        for (unsigned i = 0; i < type->record->field_count; i++)
            byte_set_add_value(s, type->record->fields[i].type,
                               offset + type->record->fields[i].offset);
    } else if (type->kind == IR_ARRAY && contains_record(type) && type->target->size > 0) {
        for (int64_t i = 0; i < type->size / type->target->size; i++)
            byte_set_add_value(s, type->target, offset + i * type->target->size);
    } else {
        byte_set_add(s, offset, offset + type->size);
    }
}

bool value_equal(value a, value b) {
    if (a.kind != b.kind || a.kind == VALUE_OTHER)
        return a.kind == b.kind;
    return a.is_exact == b.is_exact && (!a.is_exact || a.number == b.number);
}

value value_join(value a, value b) {
    const value anywhere = {VALUE_POINTER, false, 0};
    const value other = {VALUE_OTHER, false, 0};
    if (value_equal(a, b))
        return a;
    return a.kind == VALUE_POINTER || b.kind == VALUE_POINTER ? anywhere : other;
}

state state_new(arena *a, int64_t size) {
    state s = {.is_reachable = true, .written = byte_set_new(a, size)};
    return s;
}

state state_copy(arena *a, const state *s) {
    state copy = {.is_reachable = s->is_reachable, .written = byte_set_copy(a, s->written)};
    for (unsigned i = 0; i < s->bindings.count; i++)
        VECTOR_PUSH(a, &copy.bindings, s->bindings.items[i]);
    return copy;
}

void state_join(arena *a, state *s, const state *other) {
    if (!other->is_reachable)
        return;
    if (!s->is_reachable) {
        *s = state_copy(a, other);
        return;
    }
    byte_set_intersect(s->written, other->written);
    for (unsigned i = 0; i < other->bindings.count; i++) {
        const ir_variable *variable = other->bindings.items[i].variable;
        state_set(a, s, variable,
                  value_join(state_get(s, variable), other->bindings.items[i].value));
    }
    for (unsigned i = 0; i < s->bindings.count; i++)
        s->bindings.items[i].value =
            value_join(s->bindings.items[i].value, state_get(other, s->bindings.items[i].variable));
}

static bool bindings_within(const state *a, const state *b) {
    for (unsigned i = 0; i < a->bindings.count; i++)
        if (!value_equal(a->bindings.items[i].value, state_get(b, a->bindings.items[i].variable)))
            return false;
    return true;
}

bool state_same_bindings(const state *a, const state *b) {
    return bindings_within(a, b) && bindings_within(b, a);
}

value state_get(const state *s, const ir_variable *variable) {
    const value other = {VALUE_OTHER, false, 0};
    for (unsigned i = 0; i < s->bindings.count; i++)
        if (s->bindings.items[i].variable == variable)
            return s->bindings.items[i].value;
    return other;
}

void state_set(arena *a, state *s, const ir_variable *variable, value v) {
    const binding added = {variable, v};
    for (unsigned i = 0; i < s->bindings.count; i++)
        if (s->bindings.items[i].variable == variable) {
            s->bindings.items[i].value = v;
            return;
        }
    if (v.kind != VALUE_OTHER)
        VECTOR_PUSH(a, &s->bindings, added);
}

unsigned state_weight(const state *s) {
    return 1 + s->written.word_count + s->bindings.count;
}
