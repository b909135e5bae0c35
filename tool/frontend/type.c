/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* libclang's types to ours. Canonical ones only: typedefs are looked through. */
#include <string.h>

#include "frontend/translation.h"

static ir_type_kind kind_of(enum CXTypeKind kind) {
    switch (kind) {
    case CXType_Void:
        return IR_VOID;
    case CXType_Bool:
        return IR_BOOLEAN;
    case CXType_Char_U:
    case CXType_UChar:
    case CXType_UShort:
    case CXType_UInt:
    case CXType_ULong:
    case CXType_ULongLong:
    case CXType_Char_S:
    case CXType_SChar:
    case CXType_Short:
    case CXType_Int:
    case CXType_Long:
    case CXType_LongLong:
    case CXType_WChar:
    case CXType_Char16:
    case CXType_Char32:
    case CXType_Enum:
        return IR_INTEGER;
    case CXType_Float:
    case CXType_Double:
    case CXType_LongDouble:
        return IR_FLOATING;
    case CXType_Complex:
        return IR_COMPLEX;
    case CXType_Pointer:
        return IR_POINTER;
    case CXType_ConstantArray:
    case CXType_IncompleteArray:
    case CXType_VariableArray:
        return IR_ARRAY;
    case CXType_Record:
        return IR_RECORD;
    case CXType_FunctionProto:
    case CXType_FunctionNoProto:
        return IR_FUNCTION_TYPE;
    default:
        return IR_OTHER_TYPE;
    }
}

static bool is_signed_kind(enum CXTypeKind kind) {
    return kind == CXType_Char_S || kind == CXType_SChar || kind == CXType_Short ||
           kind == CXType_Int || kind == CXType_Long || kind == CXType_LongLong;
}

static bool is_character_kind(enum CXTypeKind kind) {
    return kind == CXType_Char_S || kind == CXType_SChar || kind == CXType_Char_U ||
           kind == CXType_UChar;
}

/* A type that cannot be written down again elsewhere: without a name, or with an expression in it.
 */
static bool can_be_spelled(const ir_type *type, const char *spelling) {
    if (strstr(spelling, "(unnamed") || strstr(spelling, "(anonymous"))
        return false;
    for (const ir_type *at = type; at; at = at->target)
        if (at->kind == IR_ARRAY && at->size < 0 && at->count < 0 && at != type && at->target &&
            at->target->size < 0)
            return false;
    return true;
}

typedef struct field_collector {
    translation *t;
    VECTOR(ir_field) fields;
    cursor_list cursors;
} field_collector;

static enum CXVisitorResult add_field(CXCursor cursor, CXClientData data) {
    field_collector *c = data;
    const long long bits = clang_Cursor_getOffsetOfField(cursor);
    const bool bit_field = clang_Cursor_isBitField(cursor) != 0;
    const ir_field field = {
        .name = take_string(c->t, clang_getCursorSpelling(cursor)),
        .type = translate_type(c->t, clang_getCursorType(cursor)),
        .offset = bit_field || bits < 0 ? -1 : bits / 8,
        .is_bit_field = bit_field,
    };
    VECTOR_PUSH(c->t->arena, &c->fields, field);
    VECTOR_PUSH(c->t->arena, &c->cursors, cursor);
    return CXVisit_Continue;
}

static const void *declaration_key(CXCursor declaration) {
    return clang_getCanonicalCursor(declaration).data[0];
}

static const ir_record *translate_record(translation *t, CXType type) {
    const CXCursor declaration = clang_getTypeDeclaration(type);
    const void *key = declaration_key(declaration);
    ir_record *record = map_get(t->records, &key, sizeof key);
    if (record)
        return record;
    record = ARENA_NEW(t->arena, ir_record);
    *map_at(t->records, &key, sizeof key) = record;
    const char *spelling = take_string(t, clang_getTypeSpelling(clang_getUnqualifiedType(type)));
    const bool named = !strstr(spelling, "(unnamed") && !strstr(spelling, "(anonymous");
    const char *blank = strrchr(spelling, ' ');
    record->name = named ? (blank ? blank + 1 : spelling) : "";
    record->spelling = named ? spelling : NULL;
    record->is_union = clang_getCursorKind(declaration) == CXCursor_UnionDecl;
    const long long size = clang_Type_getSizeOf(type);
    record->is_complete = size >= 0;
    record->size = size >= 0 ? size : -1;
    field_collector c = {.t = t};
    if (record->is_complete)
        clang_Type_visitFields(type, add_field, &c);
    record->field_count = c.fields.count;
    record->fields = c.fields.items;
    for (unsigned i = 0; i < c.cursors.count; i++) {
        const void *field_key = declaration_key(c.cursors.items[i]);
        *map_at(t->fields, &field_key, sizeof field_key) = (void *)&record->fields[i];
    }
    return record;
}

const ir_field *translate_field(translation *t, CXCursor field) {
    translate_type(t, clang_getCursorType(clang_getCursorSemanticParent(field)));
    const void *key = declaration_key(field);
    return map_get(t->fields, &key, sizeof key);
}

static void complete_array(translation *t, ir_type *type, CXType clang) {
    type->target = translate_type(t, clang_getArrayElementType(clang));
    type->count = clang.kind == CXType_ConstantArray ? clang_getArraySize(clang) : -1;
    type->size =
        type->count >= 0 && type->target->size >= 0 ? type->count * type->target->size : -1;
}

static void complete(translation *t, ir_type *type, CXType clang) {
    switch (type->kind) {
    case IR_ARRAY:
        complete_array(t, type, clang);
        break;
    case IR_POINTER:
        type->target = translate_type(t, clang_getPointeeType(clang));
        type->size = clang_Type_getSizeOf(clang);
        break;
    case IR_FUNCTION_TYPE:
        type->target = translate_type(t, clang_getResultType(clang));
        break;
    case IR_RECORD:
        type->record = translate_record(t, clang);
        type->size = type->record->size;
        break;
    case IR_COMPLEX:
        type->target = translate_type(t, clang_getElementType(clang));
        type->size = 2 * type->target->size;
        break;
    case IR_INTEGER:
        if (clang.kind == CXType_Enum) {
            const CXType integer = clang_getCanonicalType(
                clang_getEnumDeclIntegerType(clang_getTypeDeclaration(clang)));
            type->is_signed = is_signed_kind(integer.kind);
            type->size = integer.kind == CXType_Invalid ? -1 : clang_Type_getSizeOf(integer);
            break;
        }
        type->is_signed = is_signed_kind(clang.kind);
        type->is_character = is_character_kind(clang.kind);
        type->size = clang_Type_getSizeOf(clang);
        break;
    case IR_BOOLEAN:
    case IR_FLOATING:
        type->size = clang_Type_getSizeOf(clang);
        break;
    case IR_VOID:
    case IR_OTHER_TYPE:
        break;
    }
    if (type->size < 0)
        type->size = -1;
}

const ir_type *translate_type(translation *t, CXType written) {
    CXType clang = clang_getCanonicalType(written);
    ir_type *type = map_get(t->types, &clang.data[0], sizeof clang.data[0]);
    if (type)
        return type;
    type = ARENA_NEW(t->arena, ir_type);
    *map_at(t->types, &clang.data[0], sizeof clang.data[0]) = type;
    type->size = -1;
    type->count = -1;
    type->is_const = clang_isConstQualifiedType(clang) != 0;
    type->is_volatile = clang_isVolatileQualifiedType(clang) != 0;
    type->is_restrict = clang_isRestrictQualifiedType(clang) != 0;
    const char *spelling = take_string(t, clang_getTypeSpelling(clang));
    if (clang.kind == CXType_Atomic) {
        type->is_atomic = true;
        clang = clang_getCanonicalType(clang_Type_getValueType(clang));
    }
    type->kind = kind_of(clang.kind);
    complete(t, type, clang);
    type->spelling = can_be_spelled(type, spelling) ? spelling : NULL;
    return type;
}
