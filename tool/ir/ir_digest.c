/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "ir/ir_digest.h"

#include <string.h>

#include "support/vector.h"

typedef struct digester {
    uint64_t state;
    arena *scratch;
    map *numbers; /* object or type -> its number in order of first occurrence, from 1 */
    uintptr_t count;
    VECTOR(const ir_function *) pending;
} digester;

/* ---- FNV-1a ---------------------------------------------------------------------------------- */

static void add_bytes(digester *d, const void *data, size_t length) {
    const unsigned char *bytes = data;
    for (size_t i = 0; i < length; i++)
        d->state = (d->state ^ bytes[i]) * UINT64_C(1099511628211);
}

static void add_number(digester *d, int64_t number) {
    add_bytes(d, &number, sizeof number);
}

static void add_text(digester *d, const char *text) {
    add_number(d, text ? (int64_t)strlen(text) : -1);
    if (text)
        add_bytes(d, text, strlen(text));
}

/* Hashes the number of an object or type. Returns whether it occurs for the first time. */
static bool add_identity(digester *d, const void *thing) {
    void **number = map_at(d->numbers, &thing, sizeof thing);
    const bool is_new = *number == NULL;
    if (is_new)
        *number = (void *)++d->count;
    add_number(d, (int64_t)(uintptr_t)*number);
    return is_new;
}

/* ---- types ----------------------------------------------------------------------------------- */

static void add_type(digester *d, const ir_type *type);

static void add_record(digester *d, const ir_record *record) {
    if (!add_identity(d, record))
        return;
    add_text(d, record->spelling);
    add_number(d, record->is_union | record->is_complete << 1);
    add_number(d, record->size);
    add_number(d, record->alignment);
    add_number(d, record->field_count);
    for (unsigned i = 0; i < record->field_count; i++) {
        const ir_field *field = &record->fields[i];
        add_text(d, field->name);
        add_number(d, field->offset);
        add_number(d, field->is_bit_field);
        add_type(d, field->type);
    }
}

static void add_type(digester *d, const ir_type *type) {
    for (; type; type = type->target) {
        add_number(d, type->kind);
        add_number(d, type->is_signed | type->is_character << 1 | type->is_const << 2 |
                          type->is_volatile << 3 | type->is_restrict << 4 | type->is_atomic << 5 |
                          type->has_address_space << 6);
        add_number(d, type->size);
        add_number(d, type->count);
        if (type->kind == IR_FUNCTION_TYPE || type->kind == IR_OTHER_TYPE)
            add_text(d, type->spelling);
        if (type->record)
            add_record(d, type->record);
    }
    add_number(d, -1);
}

/* ---- variables, functions, nodes ------------------------------------------------------------- */

static void add_variable(digester *d, const ir_variable *v) {
    if (!add_identity(d, v))
        return;
    add_number(d, v->storage);
    add_number(d, v->address_taken | v->has_other_name << 1);
    if (!v->function) /* the names of local variables do not count */
        add_text(d, v->name);
    add_type(d, v->type);
}

static void add_function(digester *d, const ir_function *f) {
    if (!add_identity(d, f))
        return;
    add_text(d, f->name);
    add_type(d, f->type);
    add_number(d, f->is_variadic | f->is_noreturn << 1 | f->is_attribute_pure << 2 |
                      f->is_attribute_const << 3 | f->has_other_attributes << 4 |
                      f->linkage.is_static << 5 |
                      (f->linkage.is_weak && !f->linkage.is_interposable) << 6 |
                      f->linkage.is_renamed << 7);
    if (f->linkage.is_static && f->body)
        VECTOR_PUSH(d->scratch, &d->pending, f);
}

static void add_field(digester *d, const ir_field *field) {
    add_text(d, field->name);
    add_number(d, field->offset);
}

/* Does not hash strings, nor arguments of functions that end the program. A string may contain the
 * file's name as a command gives it, and such an argument may be a line number. Neither matters to
 * what the function computes. */
static void add_node(digester *d, const ir_node *node) {
    add_number(d, node->kind);
    if (node->kind == IR_STRING)
        return;
    if (node->kind == IR_CALL && node->children[0]->kind == IR_FUNCTION &&
        node->children[0]->function->is_noreturn) {
        add_function(d, node->children[0]->function);
        return;
    }
    add_number(d, node->op);
    add_number(d, node->flags & (IR_ARROW | IR_DESIGNATED | IR_HAS_VALUE | IR_COMPOUND_LITERAL |
                                 IR_SEQUENCE));
    add_number(d, node->child_count);
    add_text(d, node->text);
    add_number(d, node->flags & IR_HAS_VALUE ? node->value : 0);
    add_type(d, node->type);
    if (node->variable)
        add_variable(d, node->variable);
    if (node->function)
        add_function(d, node->function);
    if (node->field)
        add_field(d, node->field);
    for (unsigned i = 0; i < node->child_count; i++)
        add_node(d, node->children[i]);
}

static void add_definition(digester *d, const ir_function *f) {
    add_number(d, f->parameter_count);
    for (unsigned i = 0; i < f->parameter_count; i++)
        add_variable(d, f->parameters[i]);
    add_node(d, f->body);
}

static void add_dialect(digester *d, const ir_dialect *dialect) {
    add_number(d, dialect->strict_aliasing | dialect->is_c89 << 1 | dialect->math_errno << 2 |
                      dialect->is_sanitized << 3 | dialect->wraps << 4);
    add_text(d, dialect->refusing_option);
    add_text(d, dialect->inexact_option);
}

uint64_t ir_digest(const ir_unit *unit, const ir_function *function) {
    arena *scratch = arena_new();
    digester d = {
        .state = UINT64_C(14695981039346656037), .scratch = scratch, .numbers = map_new(scratch)};
    add_dialect(&d, &unit->dialect);
    add_function(&d, function);
    add_definition(&d, function);
    for (unsigned i = 0; i < d.pending.count; i++) /* the list grows during the loop */
        add_definition(&d, d.pending.items[i]);
    arena_free(scratch);
    return d.state;
}
