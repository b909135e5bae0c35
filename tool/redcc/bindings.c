/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "redcc/bindings.h"

#include <assert.h>
#include <string.h>

typedef struct comparison {
    const ir_unit *before;
    const emit_result *written;
} comparison;

/* ---- places -------------------------------------------------------------------------------- */

int written_loop_at(const emit_result *written, uint32_t offset) {
    assert(offset <= written->length);
    for (unsigned i = 0; i < written->loop_count; i++)
        if (offset >= written->loops[i].begin && offset < written->loops[i].end)
            return (int)i;
    return -1;
}

/** Returns the origin of the word or copy that contains this byte of the loop's text. NULL if the
 * translator itself wrote the byte. */
static const origin *origin_at(const written_loop *loop, uint32_t at) {
    unsigned low = 0, high = loop->origins.items.count;
    while (low < high) {
        const unsigned middle = low + (high - low) / 2;
        if (loop->origins.items.items[middle].end <= at)
            low = middle + 1;
        else
            high = middle;
    }
    const origin *found = low < loop->origins.items.count ? &loop->origins.items.items[low] : NULL;
    return found && found->begin <= at ? found : NULL;
}

/** The offset in the original file of a byte outside of the loops. */
static uint32_t place_before(const emit_result *written, uint32_t offset) {
    assert(written->loop_count > 0);
    const written_loop *last = NULL; /* the last piece that ends before the byte */
    for (unsigned i = 0; i < written->loop_count && written->loops[i].end <= offset; i++)
        last = &written->loops[i];
    if (last)
        return offset - last->end + last->replaced.end;
    const written_loop *first = &written->loops[0];
    return offset - first->begin + first->replaced.begin;
}

/* ---- declarations -------------------------------------------------------------------------- */

/** Does the declaration have a name? To a nameless declaration libclang gives a text with its
 * position, in parentheses. */
static bool has_name(const ir_declared *declared) {
    return declared->name[0] && !strchr(declared->name, '(');
}

/** Does a name in the written text refer to the intended declaration? A generated replacement for a
 *  variable counts as the variable. */
static bool is_meant(const comparison *c, const ir_declared *found, const ir_declared *meant) {
    if (!found || !meant)
        return false;
    if (has_name(found) && has_name(meant) && strcmp(found->name, meant->name) != 0)
        return false;
    if (found->is_external && meant->is_external)
        return has_name(found);
    if (found->file)
        return meant->file && strcmp(found->file, meant->file) == 0 &&
               found->offset == meant->offset;
    const int number = written_loop_at(c->written, found->offset);
    if (number < 0)
        return !meant->file && place_before(c->written, found->offset) == meant->offset;
    const written_loop *loop = &c->written->loops[number];
    const origin *from = origin_at(loop, found->offset - loop->begin);
    if (!from || from->kind == ORIGIN_TYPE || from->kind == ORIGIN_VALUE)
        return false;
    if (from->kind == ORIGIN_COPY)
        return !meant->file &&
               from->from + (found->offset - loop->begin - from->begin) == meant->offset;
    return from->meant == meant;
}

/** The structure or enumeration below a type's pointers. */
static const ir_declared *tag_of(const ir_type *type) {
    while (type->target)
        type = type->target;
    return type->tag;
}

/* ---- references ---------------------------------------------------------------------------- */

/** The program's first reference at or after this offset. */
static const ir_reference *first_at(const ir_unit *unit, uint32_t offset) {
    unsigned low = 0, high = unit->reference_count;
    while (low < high) {
        const unsigned middle = low + (high - low) / 2;
        if (unit->references[middle].offset < offset)
            low = middle + 1;
        else
            high = middle;
    }
    assert(low == 0 || unit->references[low - 1].offset < offset);
    assert(low == unit->reference_count || unit->references[low].offset >= offset);
    return unit->references + low;
}

/** Does the name have the same meaning at `offset` of the program's text, from which it was copied?
 * All names to which a macro expands have one offset. */
static bool is_as_before(const comparison *c, const ir_reference *reference, uint32_t offset) {
    const ir_reference *end = c->before->references + c->before->reference_count;
    bool is_known = false;
    for (const ir_reference *r = first_at(c->before, offset); r < end && r->offset == offset; r++) {
        if (r->is_type != reference->is_type ||
            strcmp(r->declared->name, reference->declared->name) != 0)
            continue;
        if (!is_meant(c, reference->declared, r->declared))
            return false;
        is_known = true;
    }
    return is_known;
}

static bool starts_with(const char *text, const char *prefix) {
    return strncmp(text, prefix, strlen(prefix)) == 0;
}

/** Is the name one of the runtime's or the compiler's? A program that uses one of the runtime's
 * names for something else is not translated (taken_name of plan/macros.h). */
static bool is_own_name(const char *name) {
    return starts_with(name, "redcc_") || starts_with(name, "REDCC_") ||
           starts_with(name, "__builtin_") || starts_with(name, "__atomic_");
}

/** Is the name declared by text that the translator wrote itself? */
static bool is_own(const comparison *c, const ir_declared *declared) {
    const int number = declared->file ? -1 : written_loop_at(c->written, declared->offset);
    const written_loop *loop = number < 0 ? NULL : &c->written->loops[number];
    return loop && !origin_at(loop, declared->offset - loop->begin);
}

static bool is_right(const comparison *c, const written_loop *loop, const ir_reference *reference) {
    const uint32_t at = reference->offset - loop->begin;
    const origin *from = origin_at(loop, at);
    if (!from)
        return is_own_name(reference->declared->name) || is_own(c, reference->declared);
    switch (from->kind) {
    case ORIGIN_COPY:
        return is_as_before(c, reference, from->from + (at - from->begin));
    case ORIGIN_TYPE: {
        const ir_declared *tag = reference->declared->tag;
        return is_meant(c, tag ? tag : reference->declared, tag_of(from->type));
    }
    default:
        return at == from->begin && is_meant(c, reference->declared, from->meant);
    }
}

/** Does the compiler find a declaration for the name at this offset? */
static bool has_reference(const ir_unit *unit, uint32_t offset) {
    const ir_reference *found = first_at(unit, offset);
    return found < unit->references + unit->reference_count && found->offset == offset;
}

static const char *wrong_reference(const comparison *c, const ir_unit *after,
                                   const written_loop *loop) {
    const ir_reference *end = after->references + after->reference_count;
    for (const ir_reference *r = first_at(after, loop->begin); r < end && r->offset < loop->end;
         r++)
        if (!is_right(c, loop, r))
            return r->declared->name;
    return NULL;
}

/** A name of the loop's text that is missing from the compiler's tree, or NULL if there is none. */
static const char *unseen_name(const comparison *c, const ir_unit *after,
                               const written_loop *loop) {
    const ir_reference *end = c->before->references + c->before->reference_count;
    for (unsigned i = 0; i < loop->origins.items.count; i++) {
        const origin *o = &loop->origins.items.items[i];
        if (o->kind == ORIGIN_NAME && !has_reference(after, loop->begin + o->begin))
            return o->meant ? o->meant->name : "?";
        if (o->kind != ORIGIN_COPY)
            continue;
        const ir_reference *r = first_at(c->before, o->from);
        for (; r < end && r->offset < o->from + (o->end - o->begin); r++)
            if (!has_reference(after, loop->begin + o->begin + (r->offset - o->from)))
                return r->declared->name;
    }
    return NULL;
}

/** The first typed place at or after this offset. */
static const ir_typed_place *typed_place_at(const ir_unit *unit, uint32_t offset) {
    unsigned low = 0, high = unit->typed_place_count;
    while (low < high) {
        const unsigned middle = low + (high - low) / 2;
        if (unit->typed_places[middle].offset < offset)
            low = middle + 1;
        else
            high = middle;
    }
    assert(low == 0 || unit->typed_places[low - 1].offset < offset);
    assert(low == unit->typed_place_count || unit->typed_places[low].offset >= offset);
    return unit->typed_places + low;
}

/** Are types of two different parses of the program the same? */
static bool is_same_type(const ir_type *a, const ir_type *b) {
    while (a->kind == b->kind && (a->kind == IR_POINTER || a->kind == IR_ARRAY) &&
           a->count == b->count)
        a = a->target, b = b->target;
    if (a->kind != IR_RECORD || b->kind != IR_RECORD)
        return ir_type_equal(a, b);
    const bool has_name = a->spelling && b->spelling;
    return a->size == b->size &&
           (has_name ? strcmp(a->spelling, b->spelling) == 0 : !a->spelling && !b->spelling);
}

/** Does an expression of the type begin at this offset? */
static bool has_type(const ir_unit *unit, uint32_t offset, const ir_type *type) {
    const ir_typed_place *const end = unit->typed_places + unit->typed_place_count;
    for (const ir_typed_place *at = typed_place_at(unit, offset); at < end && at->offset == offset;
         at++)
        if (is_same_type(at->type, type))
            return true;
    return false;
}

/** Returns the type of the first expression in the loop's text that has not the type it should
 * have, or is missing from the tree. NULL if there is none. */
static const char *wrong_type(const ir_unit *after, const written_loop *loop) {
    for (unsigned i = 0; i < loop->origins.items.count; i++) {
        const origin *o = &loop->origins.items.items[i];
        if (o->kind == ORIGIN_VALUE && !has_type(after, loop->begin + o->begin, o->type))
            return o->type->spelling ? o->type->spelling : "a type";
    }
    return NULL;
}

void bindings_check(const ir_unit *before, const ir_unit *after, const emit_result *written,
                    const char **wrong) {
    const comparison c = {before, written};
    for (unsigned i = 0; i < written->loop_count; i++) {
        if (!wrong[i])
            wrong[i] = wrong_reference(&c, after, &written->loops[i]);
        if (!wrong[i])
            wrong[i] = unseen_name(&c, after, &written->loops[i]);
    }
}

void types_check(const ir_unit *after, const emit_result *written, const char **wrong) {
    for (unsigned i = 0; i < written->loop_count; i++)
        if (!wrong[i])
            wrong[i] = wrong_type(after, &written->loops[i]);
}
