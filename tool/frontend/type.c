/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Converts clang's types to IR types. Each canonical type is converted once. */
#include <string.h>

#include "frontend/convert.h"
#include "ir/ir_words.h"

bool is_nameless(const char *spelling) {
    return strstr(spelling, "(unnamed") != NULL || strstr(spelling, "(anonymous") != NULL;
}

/* Returns clang's spelling of the type. NULL if it is empty, or contains a name that clang has
 * invented for an unnamed type. */
static const char *clang_spelling(converter *c, CXType type) {
    const char *text = take_string(c, clang_getTypeSpelling(type));
    return text[0] == 0 || is_nameless(text) ? NULL : text;
}

static int64_t size_of(CXType type) {
    long long size = clang_Type_getSizeOf(type);
    return size < 0 ? -1 : size;
}

/* ---- scalars ------------------------------------------------------------------------------- */

static const char *scalar_word(enum CXTypeKind kind) {
    switch (kind) {
    case CXType_Void:
        return "void";
    case CXType_Bool:
        return "bool";
    case CXType_Char_S:
    case CXType_Char_U:
        return "char";
    case CXType_SChar:
        return "schar";
    case CXType_UChar:
        return "uchar";
    case CXType_Short:
        return "short";
    case CXType_UShort:
        return "ushort";
    case CXType_Int:
        return "int";
    case CXType_UInt:
        return "uint";
    case CXType_Long:
        return "long";
    case CXType_ULong:
        return "ulong";
    case CXType_LongLong:
        return "llong";
    case CXType_ULongLong:
        return "ullong";
    case CXType_Float:
        return "float";
    case CXType_Double:
        return "double";
    case CXType_LongDouble:
        return "ldouble";
    default:
        return NULL;
    }
}

enum { INT_SIZE = 4 }; /* in bytes; integers narrower than int become int in arithmetic */

static bool fill_scalar(const converter *c, ir_type *type, CXType clang) {
    const char *word = scalar_word(clang.kind);
    if (word == NULL)
        return false;
    ir_scalar_type(type, ir_scalar_named(word, strlen(word)));
    if (type->kind != IR_VOID)
        type->size = size_of(clang);
    if (clang.kind == CXType_Char_U)
        type->is_signed = false;
    type->wraps = type->kind == IR_INTEGER && type->is_signed && type->size >= INT_SIZE &&
                  c->unit->dialect.wraps;
    return true;
}

static void fill_complex(ir_type *type, CXType clang) {
    static const char *const words[] = {"cfloat", "cdouble", "cldouble"};
    enum CXTypeKind part = clang_getElementType(clang).kind;
    unsigned row = part == CXType_Float ? 0 : part == CXType_Double ? 1 : 2;
    if (row == 2 && part != CXType_LongDouble) { /* complex integers, a GNU extension */
        type->kind = IR_OTHER_TYPE;
        return;
    }
    ir_scalar_type(type, ir_scalar_named(words[row], strlen(words[row])));
    type->size = size_of(clang);
}

/* Fills in an enumeration: its integer type, spelled by the enumeration's name if it has one. */
static void fill_enumeration(converter *c, ir_type *type, CXType clang) {
    CXCursor declaration = clang_getTypeDeclaration(clang);
    CXType integer = clang_getCanonicalType(clang_getEnumDeclIntegerType(declaration));
    if (!fill_scalar(c, type, integer) || type->kind != IR_INTEGER) {
        *type = (ir_type){.kind = IR_OTHER_TYPE, .size = -1, .count = -1};
        return;
    }
    const char *spelling = clang_spelling(c, clang_getUnqualifiedType(clang));
    if (spelling != NULL)
        type->spelling = spelling;
    type->tag = declared_of(c, declaration);
}

/* ---- derived types ------------------------------------------------------------------------- */

static const ir_type *bottom(const ir_type *type) {
    while (type->kind == IR_POINTER || type->kind == IR_ARRAY)
        type = type->target;
    return type;
}

/* Adds qualifiers to a pointer to a function: "int (*)(int)" becomes "int (*const)(int)". NULL if
 * the spelling has another form. */
static const char *qualified_function_pointer(converter *c, const ir_type *type,
                                              const char *spelling) {
    const char *star = strstr(spelling, "(*");
    const char *close = star != NULL ? strchr(star, ')') : NULL;
    if (close == NULL || close[-1] != '*')
        return NULL;
    return arena_format(
        c->arena, "%.*s%s%s%s", (int)(close - spelling), spelling, type->is_const ? "const" : "",
        type->is_volatile ? (type->is_const ? " volatile" : "volatile") : "", close);
}

static ir_type *qualified(converter *c, const ir_type *type, CXType quals) {
    ir_type *copy = ARENA_NEW(c->arena, ir_type);
    *copy = *type;
    if (type->kind == IR_ARRAY) { /* qualifiers of an array apply to its elements (C17 6.7.3
                                   * p9) */
        copy->target = qualified(c, type->target, quals);
        if (copy->spelling != NULL)
            copy->spelling = ir_type_default_spelling(c->arena, copy);
        return copy;
    }
    copy->is_const |= clang_isConstQualifiedType(quals) != 0;
    copy->is_volatile |= clang_isVolatileQualifiedType(quals) != 0;
    copy->is_restrict |= clang_isRestrictQualifiedType(quals) != 0;
    copy->has_address_space |= clang_getAddressSpace(quals) != 0;
    if (copy->has_address_space)
        copy->spelling = NULL;
    if (copy->spelling == NULL)
        return copy;
    if (type->kind == IR_POINTER && bottom(type)->kind == IR_FUNCTION_TYPE) {
        copy->spelling = qualified_function_pointer(c, copy, type->spelling);
        return copy;
    }
    const char *usual = ir_type_default_spelling(c->arena, type);
    if (usual != NULL && strcmp(usual, type->spelling) == 0)
        copy->spelling = ir_type_default_spelling(c->arena, copy);
    else
        copy->spelling = arena_format(c->arena, "%s%s%s", copy->is_const ? "const " : "",
                                      copy->is_volatile ? "volatile " : "", type->spelling);
    return copy;
}

static bool is_array(enum CXTypeKind kind) {
    return kind == CXType_ConstantArray || kind == CXType_IncompleteArray ||
           kind == CXType_VariableArray;
}

static void fill_array(converter *c, ir_type *type, CXType clang) {
    type->kind = IR_ARRAY;
    type->target = convert_type(c, clang_getArrayElementType(clang));
    type->count = clang.kind == CXType_ConstantArray ? clang_getArraySize(clang) : -1;
    type->size = clang.kind == CXType_ConstantArray ? ir_type_default_size(type) : -1;
    if (clang.kind != CXType_VariableArray)
        type->spelling = ir_type_default_spelling(c->arena, type);
}

static void fill_pointer(converter *c, ir_type *type, CXType clang) {
    type->kind = IR_POINTER;
    type->size = size_of(clang);
    type->target = convert_type(c, clang_getPointeeType(clang));
    if (bottom(type)->kind == IR_FUNCTION_TYPE) /* only clang's spelling has the parameters */
        type->spelling = bottom(type)->spelling != NULL ? clang_spelling(c, clang) : NULL;
    else
        type->spelling = ir_type_default_spelling(c->arena, type);
}

/* The spelling without the attribute noreturn, which cannot occur in a cast. */
static const char *without_noreturn(converter *c, const char *spelling) {
    static const char attribute[] = " __attribute__((noreturn))";
    size_t length = spelling != NULL ? strlen(spelling) : 0, tail = sizeof attribute - 1;
    if (length < tail || strcmp(spelling + length - tail, attribute) != 0)
        return spelling;
    return arena_copy(c->arena, spelling, length - tail);
}

static void fill_function(converter *c, ir_type *type, CXType clang) {
    type->kind = IR_FUNCTION_TYPE;
    type->target = convert_type(c, clang_getResultType(clang));
    type->spelling = without_noreturn(c, clang_spelling(c, clang));
}

static void fill_record(converter *c, ir_type *type, CXType clang) {
    type->kind = IR_RECORD;
    type->record = convert_record(c, clang);
    type->tag = declared_of(c, clang_getTypeDeclaration(clang));
    type->size = type->record->size;
    type->spelling = type->record->spelling;
}

static void fill_atomic(converter *c, ir_type *type, CXType clang) {
    *type = *convert_type(c, clang_Type_getValueType(clang));
    type->is_atomic = true;
    type->spelling = clang_spelling(c, clang);
}

static bool has_plain_name(enum CXTypeKind kind) {
    return kind == CXType_Int128 || kind == CXType_UInt128 || kind == CXType_Float128 ||
           kind == CXType_Float16 || kind == CXType_BFloat16;
}

static void fill_other(converter *c, ir_type *type, CXType clang) {
    type->kind = IR_OTHER_TYPE;
    type->size = -1;
    if (has_plain_name(clang.kind)) {
        type->size = size_of(clang);
        type->spelling = clang_spelling(c, clang);
    }
}

/* Fills in the IR type. `clang` is canonical and has none of the qualifiers in has_qualifiers. */
static void fill(converter *c, ir_type *type, CXType clang) {
    type->size = -1;
    type->count = -1;
    if (fill_scalar(c, type, clang))
        return;
    if (is_array(clang.kind)) {
        fill_array(c, type, clang);
        return;
    }
    switch (clang.kind) {
    case CXType_Complex:
        fill_complex(type, clang);
        break;
    case CXType_Enum:
        fill_enumeration(c, type, clang);
        break;
    case CXType_Pointer:
        fill_pointer(c, type, clang);
        break;
    case CXType_FunctionProto:
    case CXType_FunctionNoProto:
        fill_function(c, type, clang);
        break;
    case CXType_Record:
        fill_record(c, type, clang);
        break;
    case CXType_Atomic:
        fill_atomic(c, type, clang);
        break;
    default:
        fill_other(c, type, clang);
        break;
    }
}

/* Spells the pointer to a function: "int (int)" becomes "int (*)(int)". NULL if the spelling has
 * another form. */
static const char *function_pointer(converter *c, const char *function) {
    const char *open = function != NULL ? strchr(function, '(') : NULL;
    if (open == NULL || open[1] == '*') /* A function that returns a pointer to a function is too
                                         * rare to be handled. */
        return NULL;
    return arena_format(c->arena, "%.*s(*)%s", (int)(open - function), function, open);
}

const ir_type *pointer_to(converter *c, const ir_type *target) {
    void **known = map_at(c->converted.pointers, &target, sizeof target);
    if (*known == NULL) {
        ir_type *type = ARENA_NEW(c->arena, ir_type);
        *known = type;
        *type = (ir_type){.kind = IR_POINTER, .count = -1, .target = target};
        CXTargetInfo machine = clang_getTranslationUnitTargetInfo(c->clang);
        type->size = clang_TargetInfo_getPointerWidth(machine) / 8;
        clang_TargetInfo_dispose(machine);
        type->spelling = target->kind == IR_FUNCTION_TYPE
                             ? function_pointer(c, target->spelling)
                             : ir_type_default_spelling(c->arena, type);
    }
    return *known;
}

const ir_type *decayed(converter *c, const ir_type *type) {
    if (type->kind == IR_FUNCTION_TYPE)
        return pointer_to(c, type);
    return type->kind == IR_ARRAY ? pointer_to(c, type->target) : type;
}

bool has_variable_length(const ir_type *type) {
    for (; type != NULL &&
           (type->kind == IR_ARRAY || type->kind == IR_POINTER || type->kind == IR_FUNCTION_TYPE);
         type = type->target)
        if (type->kind == IR_ARRAY && type->count < 0 && type->spelling == NULL)
            return true;
    return false;
}

static bool has_qualifiers(CXType type) {
    return clang_isConstQualifiedType(type) || clang_isVolatileQualifiedType(type) ||
           clang_isRestrictQualifiedType(type) || clang_getAddressSpace(type) != 0;
}

/* Does the type, or a type it points to, name a typedef with the attribute may_alias? The canonical
 * type does not show this. */
static bool names_may_alias(CXType type) {
    while (type.kind != CXType_Invalid) {
        switch (type.kind) {
        case CXType_Pointer:
            type = clang_getPointeeType(type);
            break;
        case CXType_ConstantArray:
        case CXType_IncompleteArray:
        case CXType_VariableArray:
            type = clang_getArrayElementType(type);
            break;
        case CXType_Elaborated:
            type = clang_Type_getNamedType(type);
            break;
        case CXType_Typedef:
            if (has_may_alias(clang_getTypeDeclaration(type)))
                return true;
            type = clang_getTypedefDeclUnderlyingType(clang_getTypeDeclaration(type));
            break;
        default:
            return false;
        }
    }
    return false;
}

const ir_type *convert_type(converter *c, CXType type) {
    const void *key[2] = {type.data[0], (const void *)(uintptr_t)type.kind};
    const ir_type *known = map_get(c->converted.types, key, sizeof key);
    if (known != NULL)
        return known;
    CXType canonical = clang_getCanonicalType(type);
    if (canonical.data[0] != type.data[0] || canonical.kind != type.kind) {
        if (c->unit->dialect.strict_aliasing && names_may_alias(type))
            c->unit->dialect.strict_aliasing = false;
        known = convert_type(c, canonical);
        *map_at(c->converted.types, key, sizeof key) = (void *)known;
        return known;
    }
    const ir_type *made;
    if (has_qualifiers(canonical)) {
        made = qualified(c, convert_type(c, clang_getUnqualifiedType(canonical)), canonical);
    } else {
        ir_type *one = ARENA_NEW(c->arena, ir_type);
        fill(c, one, canonical);
        made = one;
    }
    *map_at(c->converted.types, key, sizeof key) = (void *)made;
    return made;
}
