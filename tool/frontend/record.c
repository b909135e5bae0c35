/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Converts structs and unions with their fields. */
#include "frontend/convert.h"

typedef struct field_list {
    converter *converter;
    VECTOR(CXCursor) fields;
} field_list;

static enum CXVisitorResult collect_field(CXCursor field, CXClientData data) {
    field_list *list = data;
    VECTOR_PUSH(list->converter->arena, &list->fields, field);
    return CXVisit_Continue;
}

static void fill_field(converter *c, ir_field *field, CXCursor cursor) {
    const char *name = take_string(c, clang_getCursorSpelling(cursor));
    field->name = is_nameless(name) ? "" : name;
    field->type = convert_type(c, clang_getCursorType(cursor));
    field->is_bit_field = clang_Cursor_isBitField(cursor) != 0;
    long long bits = clang_Cursor_getOffsetOfField(cursor);
    field->offset = field->is_bit_field || bits < 0 ? -1 : bits / 8;
}

static void fill_fields(converter *c, ir_record *record, CXType type) {
    field_list list = {.converter = c};
    clang_Type_visitFields(type, collect_field, &list);
    ir_field *fields = ARENA_ARRAY(c->arena, ir_field, list.fields.count + 1u);
    record->fields = fields;
    record->field_count = list.fields.count;
    for (unsigned i = 0; i < list.fields.count; i++) {
        const void *key = list.fields.items[i].data[0];
        *map_at(c->converted.fields, &key, sizeof key) = &fields[i];
        fields[i].name = "";
    }
    for (unsigned i = 0; i < list.fields.count; i++)
        fill_field(c, &fields[i], list.fields.items[i]);
}

/* Sets the record's name and spelling, such as "node" and "struct node". An unnamed record gets ""
 * and NULL. */
static void name_record(converter *c, ir_record *record, CXCursor declaration, CXType type) {
    const char *name = take_string(c, clang_getCursorSpelling(declaration));
    const char *spelling = take_string(c, clang_getTypeSpelling(type));
    bool has_name = !is_nameless(name) && !is_nameless(spelling) && spelling[0] != 0;
    record->name = has_name ? name : "";
    record->spelling = has_name ? spelling : NULL;
}

const ir_record *convert_record(converter *c, CXType canonical) {
    CXCursor declaration = clang_getTypeDeclaration(canonical);
    const void *key = clang_getCanonicalCursor(declaration).data[0];
    ir_record *record = map_get(c->converted.records, &key, sizeof key);
    if (record != NULL)
        return record;
    record = ARENA_NEW(c->arena, ir_record);
    *map_at(c->converted.records, &key, sizeof key) = record;
    CXCursor definition = clang_getCursorDefinition(declaration);
    if (has_may_alias(declaration) || has_may_alias(definition))
        c->unit->dialect.strict_aliasing = false;
    record->is_union = clang_getCursorKind(declaration) == CXCursor_UnionDecl;
    record->size = -1;
    name_record(c, record, declaration, canonical);
    record->is_complete =
        !clang_Cursor_isNull(definition) && !clang_isInvalidDeclaration(definition);
    if (record->is_complete) {
        long long size = clang_Type_getSizeOf(canonical);
        record->size = size < 0 ? -1 : size;
        const long long alignment = clang_Type_getAlignOf(canonical);
        record->alignment = alignment < 0 ? 0 : alignment;
        fill_fields(c, record, canonical);
    }
    return record;
}

const ir_field *convert_field(converter *c, CXCursor field) {
    const void *key = field.data[0];
    ir_field *known = map_get(c->converted.fields, &key, sizeof key);
    if (known == NULL) { /* the field's record has not been converted yet */
        CXCursor record = clang_getCursorSemanticParent(field);
        convert_type(c, clang_getCursorType(record));
        known = map_get(c->converted.fields, &key, sizeof key);
    }
    return known;
}
