/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "ir/ir_c.h"

#include <assert.h>

#include "ir/ir_words.h"

/* Precedence levels of C's grammar (C17 6.5), from the weakest to the strongest. */
typedef enum level {
    LEVEL_COMMA,
    LEVEL_ASSIGNMENT,
    LEVEL_CONDITIONAL,
    LEVEL_OR,
    LEVEL_AND,
    LEVEL_BIT_OR,
    LEVEL_BIT_XOR,
    LEVEL_BIT_AND,
    LEVEL_EQUALITY,
    LEVEL_RELATION,
    LEVEL_SHIFT,
    LEVEL_SUM,
    LEVEL_PRODUCT,
    LEVEL_UNARY, /* includes casts */
    LEVEL_POSTFIX,
    LEVEL_PRIMARY
} level;

typedef struct c_printer {
    buffer *out;
    ir_c_rename rename;
    ir_c_spell spell;
    void *context;
} c_printer;

static level level_of_binary(ir_operator op) {
    switch (op) {
    case IR_OP_MULTIPLY:
    case IR_OP_DIVIDE:
    case IR_OP_REMAINDER:
        return LEVEL_PRODUCT;
    case IR_OP_ADD:
    case IR_OP_SUBTRACT:
        return LEVEL_SUM;
    case IR_OP_SHIFT_LEFT:
    case IR_OP_SHIFT_RIGHT:
        return LEVEL_SHIFT;
    case IR_OP_LESS:
    case IR_OP_GREATER:
    case IR_OP_LESS_EQUAL:
    case IR_OP_GREATER_EQUAL:
        return LEVEL_RELATION;
    case IR_OP_EQUAL:
    case IR_OP_NOT_EQUAL:
        return LEVEL_EQUALITY;
    case IR_OP_BIT_AND:
        return LEVEL_BIT_AND;
    case IR_OP_BIT_XOR:
        return LEVEL_BIT_XOR;
    case IR_OP_BIT_OR:
        return LEVEL_BIT_OR;
    case IR_OP_AND:
        return LEVEL_AND;
    case IR_OP_OR:
        return LEVEL_OR;
    default:
        assert(op == IR_OP_COMMA);
        return LEVEL_COMMA;
    }
}

static bool is_postfix_operator(ir_operator op) {
    return op == IR_OP_POST_INCREMENT || op == IR_OP_POST_DECREMENT;
}

static level level_of(const ir_node *node) {
    switch (node->kind) {
    case IR_BINARY:
        return level_of_binary(node->op);
    case IR_ASSIGN:
        return LEVEL_ASSIGNMENT;
    case IR_CONDITIONAL:
        return LEVEL_CONDITIONAL;
    case IR_CAST:
    case IR_SIZEOF:
        return LEVEL_UNARY;
    case IR_UNARY:
        return is_postfix_operator(node->op) ? LEVEL_POSTFIX : LEVEL_UNARY;
    case IR_INDEX:
    case IR_MEMBER:
    case IR_CALL:
    case IR_INITIALIZERS:
        return LEVEL_POSTFIX;
    default:
        return LEVEL_PRIMARY;
    }
}

static bool print(c_printer *p, const ir_node *node, level least);

static bool print_list(c_printer *p, const ir_node *node, unsigned first) {
    for (unsigned i = first; i < node->child_count; i++) {
        if (i > first)
            buffer_text(p->out, ", ");
        if (!print(p, node->children[i], LEVEL_ASSIGNMENT))
            return false;
    }
    return true;
}

static bool print_between(c_printer *p, const ir_node *node, const char *op, level left,
                          level right) {
    assert(node->child_count == 2);
    if (!print(p, node->children[0], left))
        return false;
    buffer_text(p->out, op);
    return print(p, node->children[1], right);
}

/* Would gcc warn (-Wparentheses) about an inner operator without parentheses, although C does not
 * need them? */
static bool is_doubtful(level outer, level inner) {
    switch (outer) {
    case LEVEL_OR:
        return inner == LEVEL_AND;
    case LEVEL_BIT_OR:
    case LEVEL_BIT_XOR:
    case LEVEL_BIT_AND:
        return inner != outer && inner < LEVEL_PRODUCT;
    case LEVEL_EQUALITY:
    case LEVEL_RELATION:
        return inner == LEVEL_EQUALITY || inner == LEVEL_RELATION;
    case LEVEL_SHIFT:
        return inner == LEVEL_SUM;
    default:
        return false;
    }
}

static level least_of_operand(level outer, const ir_node *operand, level by_grammar) {
    return is_doubtful(outer, level_of(operand)) ? LEVEL_UNARY : by_grammar;
}

/* Would clang take the expression for an intended power, as in 2 ^ 5, and warn (-Wxor-used-as-pow)?
 * Written as (2) ^ 5 it causes no warning. */
static bool looks_like_power(const ir_node *node) {
    const ir_node *left = node->children[0];
    return node->op == IR_OP_BIT_XOR && left->kind == IR_NUMBER && left->text;
}

static bool print_binary(c_printer *p, const ir_node *node) {
    if (node->op == IR_OP_COMMA)
        return print_between(p, node, ", ", LEVEL_COMMA, LEVEL_ASSIGNMENT);
    level own = level_of(node);
    char op[8] = " ";
    size_t length = 1;
    for (const char *c = ir_operator_spelling(node->op); *c != 0; c++)
        op[length++] = *c;
    assert(length + 1 < sizeof op);
    op[length] = ' ';
    if (looks_like_power(node)) {
        buffer_format(p->out, "(%s)%s", node->children[0]->text, op);
        return print(p, node->children[1],
                     least_of_operand(own, node->children[1], (level)(own + 1)));
    }
    return print_between(p, node, op, least_of_operand(own, node->children[0], own),
                         least_of_operand(own, node->children[1], (level)(own + 1)));
}

static bool print_assignment(c_printer *p, const ir_node *node) {
    if (!print(p, node->children[0], LEVEL_UNARY))
        return false;
    buffer_format(p->out, " %s= ", ir_operator_spelling(node->op));
    return print(p, node->children[1], LEVEL_ASSIGNMENT);
}

static bool print_conditional(c_printer *p, const ir_node *node) {
    if (!print(p, node->children[0], LEVEL_OR))
        return false;
    buffer_text(p->out, " ? ");
    if (!print(p, node->children[1], LEVEL_COMMA))
        return false;
    buffer_text(p->out, " : ");
    return print(p, node->children[2], LEVEL_CONDITIONAL);
}

/* Would the operator and the first character of its operand form another operator? -(-x) must not
 * become --x. */
static bool would_run_together(const char *op, const char *operand) {
    return (op[0] == '-' || op[0] == '+' || op[0] == '&') && operand[0] == op[0];
}

static bool print_unary(c_printer *p, const ir_node *node) {
    const char *op = ir_operator_spelling(node->op);
    if (is_postfix_operator(node->op)) {
        if (!print(p, node->children[0], LEVEL_POSTFIX))
            return false;
        buffer_text(p->out, op);
        return true;
    }
    buffer operand = {0};
    c_printer inner = {
        .out = &operand, .rename = p->rename, .spell = p->spell, .context = p->context};
    bool is_printed = print(&inner, node->children[0], LEVEL_UNARY);
    if (is_printed) {
        bool is_word = node->op == IR_OP_REAL || node->op == IR_OP_IMAG;
        bool together = would_run_together(op, operand.data);
        buffer_format(p->out, "%s%s%s%s%s", op, is_word ? " " : "", together ? "(" : "",
                      operand.data, together ? ")" : "");
    }
    buffer_free(&operand);
    return is_printed;
}

static bool print_text(c_printer *p, const char *text) {
    if (text == NULL || text[0] == 0)
        return false;
    buffer_text(p->out, text);
    return true;
}

/* Appends "(type)". */
static bool print_type(c_printer *p, const ir_type *type) {
    if (type == NULL || type->spelling == NULL)
        return false;
    const char *text = p->spell != NULL ? p->spell(type, p->context) : type->spelling;
    if (text == NULL)
        return false;
    buffer_format(p->out, "(%s)", text);
    return true;
}

/* Appends the values in braces, of a compound literal or of a declaration's initialiser. */
static bool print_braces(c_printer *p, const ir_node *node) {
    if (node->flags & IR_DESIGNATED)
        return false;
    buffer_byte(p->out, '{');
    for (unsigned i = 0; i < node->child_count; i++) {
        const ir_node *value = node->children[i];
        bool is_list = value->kind == IR_INITIALIZERS && !(value->flags & IR_COMPOUND_LITERAL);
        if (i > 0)
            buffer_text(p->out, ", ");
        if (is_list ? !print_braces(p, value) : !print(p, value, LEVEL_ASSIGNMENT))
            return false;
    }
    buffer_byte(p->out, '}');
    return true;
}

static bool is_anonymous_member(const ir_node *node) {
    return node->kind == IR_MEMBER && node->field->name[0] == 0;
}

/* Omits the names of anonymous members, because their members count as members of the enclosing
 * record (C17 6.7.2.1 p13). */
static bool print_member(c_printer *p, const ir_node *node) {
    if (is_anonymous_member(node))
        return false;
    const ir_node *from = node;
    while (is_anonymous_member(from->children[0]))
        from = from->children[0];
    if (!print(p, from->children[0], LEVEL_POSTFIX))
        return false;
    buffer_format(p->out, "%s%s", from->flags & IR_ARROW ? "->" : ".", node->field->name);
    return true;
}

static bool print_postfix(c_printer *p, const ir_node *node) {
    if (!print(p, node->children[0], LEVEL_POSTFIX))
        return false;
    bool is_index = node->kind == IR_INDEX;
    buffer_byte(p->out, is_index ? '[' : '(');
    if (is_index ? !print(p, node->children[1], LEVEL_COMMA) : !print_list(p, node, 1))
        return false;
    buffer_byte(p->out, is_index ? ']' : ')');
    return true;
}

/* Prints the node without parentheses around it, and its children with those they need. */
static bool print_bare(c_printer *p, const ir_node *node) {
    switch (node->kind) {
    case IR_NUMBER:
    case IR_STRING:
    case IR_SIZEOF:
        return print_text(p, node->text);
    case IR_VARIABLE:
        return print_text(p, node->variable->name);
    case IR_FUNCTION:
        return print_text(p, node->function->name);
    case IR_INDEX:
    case IR_CALL:
        return print_postfix(p, node);
    case IR_MEMBER:
        return print_member(p, node);
    case IR_UNARY:
        return print_unary(p, node);
    case IR_BINARY:
        return print_binary(p, node);
    case IR_ASSIGN:
        return print_assignment(p, node);
    case IR_CONDITIONAL:
        return print_conditional(p, node);
    case IR_CAST:
        return print_type(p, node->type) && print(p, node->children[0], LEVEL_UNARY);
    case IR_INITIALIZERS:
        return (!(node->flags & IR_COMPOUND_LITERAL) || print_type(p, node->type)) &&
               print_braces(p, node);
    default:
        return false;
    }
}

static bool print(c_printer *p, const ir_node *node, level least) {
    const char *other = p->rename != NULL ? p->rename(node, p->context) : NULL;
    if (other != NULL)
        return print_text(p, other);
    bool parentheses = level_of(node) < least;
    if (parentheses)
        buffer_byte(p->out, '(');
    if (!print_bare(p, node))
        return false;
    if (parentheses)
        buffer_byte(p->out, ')');
    return true;
}

bool ir_c_expression(buffer *out, const ir_node *expression, ir_c_rename rename, void *context) {
    return ir_c_expression_spelled(out, expression, rename, NULL, context);
}

bool ir_c_expression_spelled(buffer *out, const ir_node *expression, ir_c_rename rename,
                             ir_c_spell spell, void *context) {
    c_printer p = {.out = out, .rename = rename, .spell = spell, .context = context};
    buffer_append(out, "", 0);
    size_t length = out->length;
    if (print(&p, expression, LEVEL_COMMA))
        return true;
    out->length = length;
    out->data[length] = 0;
    return false;
}
