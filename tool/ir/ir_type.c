/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include <string.h>

#include "ir/ir.h"
#include "ir/ir_words.h"
#include "support/buffer.h"

bool ir_type_equal(const ir_type *a, const ir_type *b) {
    if (a == b)
        return true;
    if (a == NULL || b == NULL || a->kind != b->kind)
        return false;
    switch (a->kind) {
    case IR_VOID:
    case IR_BOOLEAN:
        return true;
    case IR_INTEGER:
        return a->size == b->size && a->is_signed == b->is_signed &&
               a->is_character == b->is_character;
    case IR_FLOATING:
    case IR_COMPLEX:
        return a->size == b->size;
    case IR_POINTER:
        return ir_type_equal(a->target, b->target);
    case IR_ARRAY:
        return a->count == b->count && ir_type_equal(a->target, b->target);
    case IR_RECORD:
        return a->record == b->record;
    case IR_FUNCTION_TYPE: /* their spelling is compared, because parameters are not stored */
    case IR_OTHER_TYPE:
        return a->spelling != NULL && b->spelling != NULL && strcmp(a->spelling, b->spelling) == 0;
    }
    return false;
}

bool ir_type_never_wraps(const ir_type *type) {
    return type && type->kind == IR_INTEGER && type->is_signed && type->size >= 4 && !type->wraps;
}

bool ir_type_is_plain_integer(const ir_type *type) {
    return type && type->kind == IR_INTEGER && type->size > 0 && type->size <= 8 &&
           !type->is_volatile && !type->is_atomic;
}

bool ir_type_is_variably_modified(const ir_type *type) {
    for (; type != NULL; type = type->target)
        if (type->kind == IR_ARRAY && type->count < 0)
            return true;
    return false;
}

bool ir_type_is_floating(const ir_type *type) {
    return type && (type->kind == IR_FLOATING || type->kind == IR_COMPLEX);
}

bool ir_type_is_scalar(const ir_type *type) {
    switch (type->kind) {
    case IR_BOOLEAN:
    case IR_INTEGER:
    case IR_FLOATING:
    case IR_COMPLEX:
    case IR_POINTER:
        return true;
    default:
        return false;
    }
}

const ir_type *ir_type_innermost(const ir_type *type) {
    while (type->kind == IR_ARRAY)
        type = type->target;
    return type;
}

/* ---- spelling ------------------------------------------------------------------------------ */

/* The qualifiers as text, each followed by a blank. */
static const char *qualifiers(arena *a, const ir_type *type) {
    return arena_format(a, "%s%s%s", type->is_const ? "const " : "",
                        type->is_volatile ? "volatile " : "", type->is_restrict ? "restrict " : "");
}

static const char *base_spelling(arena *a, const ir_type *type) {
    const char *base = type->kind == IR_RECORD ? type->record->spelling : ir_scalar_spelling(type);
    if (base == NULL)
        return NULL;
    if (type->is_atomic)
        base = arena_format(a, "_Atomic(%s)", base);
    return arena_format(a, "%s%s", qualifiers(a, type), base);
}

static const char *without_last_blank(arena *a, const char *text) {
    size_t length = strlen(text);
    return length > 0 && text[length - 1] == ' ' ? arena_copy(a, text, length - 1) : text;
}

static const char *spell(arena *a, const ir_type *type, const char *declarator);

/* Same as spell, for a pointee or an element. The innermost type keeps its own spelling. */
static const char *spell_target(arena *a, const ir_type *target, const char *declarator) {
    if (target->spelling == NULL)
        return NULL;
    if (target->kind == IR_POINTER || target->kind == IR_ARRAY)
        return spell(a, target, declarator);
    if (target->kind == IR_FUNCTION_TYPE)
        return NULL;
    const char *blank = declarator[0] == '[' ? "" : " ";
    return arena_format(a, "%s%s%s", target->spelling, blank, declarator);
}

/* Spells a declaration of `declarator` with this type. If `declarator` is empty, spells the type
 * itself: the pointer to an array of three doubles is "double (*)[3]". */
static const char *spell(arena *a, const ir_type *type, const char *declarator) {
    if (type->kind == IR_POINTER) {
        bool is_array = type->target->kind == IR_ARRAY;
        const char *star = arena_format(a, "*%s%s", qualifiers(a, type), declarator);
        if (declarator[0] == 0)
            star = without_last_blank(a, star);
        if (is_array)
            star = arena_format(a, "(%s)", star);
        return type->is_atomic ? NULL : spell_target(a, type->target, star);
    }
    if (type->kind == IR_ARRAY) {
        const char *count = type->count < 0 ? "" : arena_format(a, "%lld", (long long)type->count);
        return spell_target(a, type->target, arena_format(a, "%s[%s]", declarator, count));
    }
    return type->kind == IR_FUNCTION_TYPE ? NULL : base_spelling(a, type);
}

const char *ir_type_default_spelling(arena *a, const ir_type *type) {
    return spell(a, type, "");
}

/* Appends the parameters' types as a prototype spells them. Returns false if one of them cannot be
 * spelled. */
static bool spell_parameters(arena *a, buffer *out, const ir_function *function) {
    for (unsigned i = 0; i < function->parameter_count; i++) {
        const ir_type *type = function->parameters[i]->type;
        const char *spelling = type->spelling;
        if (spelling != NULL && (type->is_const || type->is_volatile || type->is_restrict)) {
            ir_type bare = *type; /* qualifiers of the parameter itself are not part of the
                                   * function's type */
            bare.is_const = bare.is_volatile = bare.is_restrict = false;
            spelling = ir_type_default_spelling(a, &bare);
        }
        if (spelling == NULL)
            return false;
        buffer_format(out, "%s%s", i > 0 ? ", " : "", spelling);
    }
    if (function->is_variadic)
        buffer_text(out, function->parameter_count > 0 ? ", ..." : "...");
    else if (function->parameter_count == 0)
        buffer_text(out, "void");
    return true;
}

const ir_type *ir_function_default_type(arena *a, const ir_function *function,
                                        const ir_type *result) {
    ir_type *type = ARENA_NEW(a, ir_type);
    *type = (ir_type){.kind = IR_FUNCTION_TYPE, .size = -1, .count = -1, .target = result};
    buffer parameters = {0};
    if (result->spelling != NULL && spell_parameters(a, &parameters, function))
        type->spelling = arena_format(a, "%s%s(%s)", result->spelling,
                                      result->kind == IR_POINTER ? "" : " ", parameters.data);
    buffer_free(&parameters);
    return type;
}
