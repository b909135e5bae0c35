/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "ir/ir_words.h"

#include <assert.h>
#include <stdio.h>
#include <string.h>

/* ---- scalar types -------------------------------------------------------------------------- */

const ir_scalar ir_scalars[] = {
    {"void", "void", IR_VOID, false, false, -1},
    {"bool", "_Bool", IR_BOOLEAN, false, false, 1},
    {"char", "char", IR_INTEGER, true, true, 1},
    {"schar", "signed char", IR_INTEGER, true, true, 1},
    {"uchar", "unsigned char", IR_INTEGER, false, true, 1},
    {"short", "short", IR_INTEGER, true, false, 2},
    {"ushort", "unsigned short", IR_INTEGER, false, false, 2},
    {"int", "int", IR_INTEGER, true, false, 4},
    {"uint", "unsigned int", IR_INTEGER, false, false, 4},
    {"long", "long", IR_INTEGER, true, false, 8},
    {"ulong", "unsigned long", IR_INTEGER, false, false, 8},
    {"llong", "long long", IR_INTEGER, true, false, 8},
    {"ullong", "unsigned long long", IR_INTEGER, false, false, 8},
    {"float", "float", IR_FLOATING, false, false, 4},
    {"double", "double", IR_FLOATING, false, false, 8},
    {"ldouble", "long double", IR_FLOATING, false, false, 16},
    {"cfloat", "_Complex float", IR_COMPLEX, false, false, 8},
    {"cdouble", "_Complex double", IR_COMPLEX, false, false, 16},
    {"cldouble", "_Complex long double", IR_COMPLEX, false, false, 32},
};
const unsigned ir_scalar_count = sizeof ir_scalars / sizeof ir_scalars[0];

const ir_scalar *ir_scalar_named(const char *word, size_t length) {
    for (unsigned i = 0; i < ir_scalar_count; i++)
        if (strlen(ir_scalars[i].word) == length && strncmp(ir_scalars[i].word, word, length) == 0)
            return &ir_scalars[i];
    return NULL;
}

static bool is_alike(const ir_scalar *scalar, const ir_type *type) {
    return scalar->kind == type->kind && scalar->is_signed == type->is_signed &&
           scalar->is_character == type->is_character;
}

/* The spelling without leading qualifiers. */
static const char *bare(const char *spelling) {
    static const char *const words[] = {"const ", "volatile ", "restrict "};
    for (unsigned i = 0; i < 3; i++)
        if (strncmp(spelling, words[i], strlen(words[i])) == 0)
            return bare(spelling + strlen(words[i]));
    return spelling;
}

const ir_scalar *ir_scalar_of(const ir_type *type) {
    const ir_scalar *same_size = NULL, *alike = NULL;
    for (unsigned i = 0; i < ir_scalar_count; i++) {
        const ir_scalar *scalar = &ir_scalars[i];
        if (!is_alike(scalar, type))
            continue;
        if (type->spelling != NULL && strcmp(scalar->spelling, bare(type->spelling)) == 0)
            return scalar;
        if (same_size == NULL && scalar->size == type->size)
            same_size = scalar;
        if (alike == NULL)
            alike = scalar;
    }
    return same_size != NULL ? same_size : alike;
}

const char *ir_scalar_spelling(const ir_type *type) {
    const ir_scalar *scalar = ir_scalar_of(type);
    return scalar != NULL ? scalar->spelling : NULL;
}

void ir_scalar_type(ir_type *type, const ir_scalar *scalar) {
    *type = (ir_type){.kind = scalar->kind,
                      .is_signed = scalar->is_signed,
                      .is_character = scalar->is_character,
                      .size = scalar->size,
                      .count = -1,
                      .spelling = scalar->spelling};
}

int64_t ir_type_default_size(const ir_type *type) {
    switch (type->kind) {
    case IR_POINTER:
        return 8;
    case IR_ARRAY:
        if (type->count < 0 || type->target->size < 0)
            return -1;
        return type->count * type->target->size;
    case IR_RECORD:
        return type->record->size;
    case IR_FUNCTION_TYPE:
    case IR_OTHER_TYPE:
        return -1;
    default: {
        const ir_scalar *scalar = ir_scalar_of(type);
        return scalar != NULL ? scalar->size : -1;
    }
    }
}

/* ---- operators ----------------------------------------------------------------------------- */

static const char *const operators[] = {
    [IR_OP_NONE] = "",
    [IR_OP_ADD] = "+",
    [IR_OP_SUBTRACT] = "-",
    [IR_OP_MULTIPLY] = "*",
    [IR_OP_DIVIDE] = "/",
    [IR_OP_REMAINDER] = "%",
    [IR_OP_SHIFT_LEFT] = "<<",
    [IR_OP_SHIFT_RIGHT] = ">>",
    [IR_OP_BIT_AND] = "&",
    [IR_OP_BIT_OR] = "|",
    [IR_OP_BIT_XOR] = "^",
    [IR_OP_LESS] = "<",
    [IR_OP_GREATER] = ">",
    [IR_OP_LESS_EQUAL] = "<=",
    [IR_OP_GREATER_EQUAL] = ">=",
    [IR_OP_EQUAL] = "==",
    [IR_OP_NOT_EQUAL] = "!=",
    [IR_OP_AND] = "&&",
    [IR_OP_OR] = "||",
    [IR_OP_COMMA] = ",",
    [IR_OP_PLUS] = "+",
    [IR_OP_MINUS] = "-",
    [IR_OP_NOT] = "!",
    [IR_OP_BIT_NOT] = "~",
    [IR_OP_DEREFERENCE] = "*",
    [IR_OP_ADDRESS] = "&",
    [IR_OP_PRE_INCREMENT] = "++",
    [IR_OP_PRE_DECREMENT] = "--",
    [IR_OP_POST_INCREMENT] = "++",
    [IR_OP_POST_DECREMENT] = "--",
    [IR_OP_REAL] = "__real",
    [IR_OP_IMAG] = "__imag",
};
enum { OPERATOR_COUNT = sizeof operators / sizeof operators[0] };
_Static_assert(OPERATOR_COUNT == IR_OP_IMAG + 1, "a spelling for each operator");

const char *ir_operator_spelling(ir_operator op) {
    assert((unsigned)op < OPERATOR_COUNT);
    return operators[op];
}

/* As operators[], except that "++_" is the prefix and "_++" the postfix operator. */
static const char *operator_word(ir_operator op) {
    assert((unsigned)op < OPERATOR_COUNT);
    switch (op) {
    case IR_OP_PRE_INCREMENT:
        return "++_";
    case IR_OP_PRE_DECREMENT:
        return "--_";
    case IR_OP_POST_INCREMENT:
        return "_++";
    case IR_OP_POST_DECREMENT:
        return "_--";
    default:
        return operators[op];
    }
}

static bool find_operator(const char *word, unsigned first, unsigned last, ir_operator *op) {
    assert(first <= last && last < OPERATOR_COUNT);
    for (unsigned i = first; i <= last; i++)
        if (strcmp(operator_word((ir_operator)i), word) == 0) {
            *op = (ir_operator)i;
            return true;
        }
    return false;
}

/* ---- nodes --------------------------------------------------------------------------------- */

static const ir_kind_word kinds[] = {
    [IR_NUMBER] = {"number", 0, 0},
    [IR_STRING] = {"string", 0, 0},
    [IR_VARIABLE] = {"variable", 0, 0},
    [IR_FUNCTION] = {"function", 0, 0},
    [IR_INDEX] = {"index", 2, 2},
    [IR_MEMBER] = {"member", 1, 1},
    [IR_UNARY] = {NULL, 1, 1},
    [IR_BINARY] = {NULL, 2, 2},
    [IR_ASSIGN] = {NULL, 2, 2},
    [IR_CONDITIONAL] = {"conditional", 3, 3},
    [IR_CALL] = {"call", 1, IR_ANY_NUMBER},
    [IR_CAST] = {"cast", 1, 1},
    [IR_SIZEOF] = {"sizeof", 0, 0},
    [IR_INITIALIZERS] = {"initializers", 0, IR_ANY_NUMBER},
    [IR_OPAQUE] = {"opaque", 0, IR_ANY_NUMBER},
    [IR_BLOCK] = {"block", 0, IR_ANY_NUMBER},
    [IR_DECLARATION] = {"declaration", 0, IR_ANY_NUMBER},
    [IR_DECLARATOR] = {"declarator", 0, 1},
    [IR_EXPRESSION] = {"expression", 1, 1},
    [IR_IF] = {"if", 2, 3},
    [IR_FOR] = {"for", 4, 4},
    [IR_WHILE] = {"while", 2, 2},
    [IR_DO] = {"do", 2, 2},
    [IR_SWITCH] = {"switch", 2, 2},
    [IR_CASE] = {"case", 2, 2},
    [IR_DEFAULT] = {"default", 1, 1},
    [IR_LABEL] = {"label", 1, 1},
    [IR_GOTO] = {"goto", 0, 1},
    [IR_RETURN] = {"return", 0, 1},
    [IR_BREAK] = {"break", 0, 0},
    [IR_CONTINUE] = {"continue", 0, 0},
    [IR_EMPTY] = {"empty", 0, 0},
};
enum { KIND_COUNT = sizeof kinds / sizeof kinds[0] };
_Static_assert(KIND_COUNT == IR_EMPTY + 1, "a word for each kind");

const ir_kind_word *ir_kind_words(ir_kind kind) {
    assert((unsigned)kind < KIND_COUNT);
    return &kinds[kind];
}

bool ir_node_word(const ir_node *node, char word[16]) {
    if ((unsigned)node->kind >= KIND_COUNT || (unsigned)node->op >= OPERATOR_COUNT)
        return false;
    const char *text = kinds[node->kind].word;
    if (node->kind == IR_MEMBER && (node->flags & IR_ARROW))
        text = "arrow";
    if (text == NULL)
        text = operator_word(node->op);
    assert(strlen(text) < 15);
    snprintf(word, 16, "%s%s", text, node->kind == IR_ASSIGN ? "=" : "");
    return word[0] != 0;
}

static bool word_is_assignment(const char *word, ir_node *node) {
    char op[8];
    size_t length = strlen(word);
    if (length == 0 || length >= sizeof op || word[length - 1] != '=')
        return false;
    memcpy(op, word, length - 1);
    op[length - 1] = 0;
    node->kind = IR_ASSIGN;
    node->op = IR_OP_NONE;
    return length == 1 || find_operator(op, IR_OP_ADD, IR_OP_BIT_XOR, &node->op);
}

bool ir_word_node(const char *word, unsigned child_count, ir_node *node) {
    for (unsigned i = 0; i < KIND_COUNT; i++)
        if (kinds[i].word != NULL && strcmp(kinds[i].word, word) == 0) {
            node->kind = (ir_kind)i;
            return true;
        }
    if (strcmp(word, "arrow") == 0) {
        node->kind = IR_MEMBER;
        node->flags |= IR_ARROW;
        return true;
    }
    if (child_count == 1) {
        node->kind = IR_UNARY;
        return find_operator(word, IR_OP_PLUS, IR_OP_IMAG, &node->op);
    }
    node->kind = IR_BINARY;
    return find_operator(word, IR_OP_ADD, IR_OP_COMMA, &node->op) || word_is_assignment(word, node);
}

bool ir_is_statement_place(ir_kind kind, unsigned index) {
    assert(index < ir_kind_words(kind)->max_children);
    switch (kind) {
    case IR_BLOCK:
    case IR_DEFAULT:
    case IR_LABEL:
        return true;
    case IR_IF:
    case IR_WHILE:
    case IR_SWITCH:
    case IR_CASE:
        return index > 0;
    case IR_DO:
        return index == 0;
    case IR_FOR:
        return index == 3;
    default:
        return false;
    }
}

const char *ir_storage_word(ir_storage storage) {
    static const char *const words[] = {
        [IR_LOCAL] = "local",
        [IR_PARAMETER] = "parameter",
        [IR_GLOBAL] = "global",
        [IR_STATIC] = "static",
        [IR_STATIC_LOCAL] = "static-local",
        [IR_THREAD_LOCAL] = "thread-local",
    };
    assert((unsigned)storage < sizeof words / sizeof *words);
    return words[storage];
}
