/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "emit/text/print.h"

#include "analysis/base/expression.h"
#include "emit/text/origin.h"

static void complain(printer *p, const char *problem) {
    if (!p->problem)
        p->problem = problem;
}

static bool is_kept(const printer *p, const ir_node *node) {
    return !p->keep || p->keep[node->id];
}

/** The expression as C; sets p->problem if it cannot be spelled, and returns "0". */
static const char *print_expression(printer *p, const ir_node *expression) {
    const char *text = text_expression(p->arena, expression, p->rename, p->context);
    if (text)
        return text;
    complain(p, "an expression in it cannot be spelled a second time");
    return "0";
}

/* ---- declarations -------------------------------------------------------------------------- */

static bool declares_kept(const printer *p, const ir_node *declaration) {
    for (unsigned i = 0; i < declaration->child_count; i++)
        if (is_kept(p, declaration->children[i]))
            return true;
    return false;
}

static bool is_assignment(const ir_node *node) {
    return expression_written(node);
}

static void print_declarator(printer *p, const ir_node *declarator) {
    const ir_variable *variable = declarator->variable;
    const char *text =
        text_declaration(p->arena, variable->type, origin_declarator(p->arena, variable));
    if (!text || variable->storage != IR_LOCAL) {
        complain(p, "a declaration in it cannot be spelled a second time");
        return;
    }
    const ir_node *initialiser = ir_child(declarator, 0);
    if (initialiser) /* `w = e[k++]`: the slice may need the initialiser only for k */
        writer_line(p->out, "%s%s = %s;", text,
                    ir_any(initialiser, is_assignment) ? " __attribute__((__unused__))" : "",
                    print_expression(p, initialiser));
    else
        writer_line(p->out, "%s;", text);
}

static void print_declaration(printer *p, const ir_node *declaration) {
    for (unsigned i = 0; i < declaration->child_count; i++)
        if (is_kept(p, declaration->children[i]))
            print_declarator(p, declaration->children[i]);
}

/* ---- blocks -------------------------------------------------------------------------------- */

static void open_block(printer *p, const char *text) {
    writer_line(p->out, "%s", text);
    p->out->depth++;
}

/** Records that control does not reach the next statement from here. */
static void forbid_fall_through(printer *p) {
    p->no_fall_through_at = p->out->out.length;
}

static bool cannot_fall_through(const printer *p) {
    return p->no_fall_through_at == p->out->out.length;
}

static void close_block(printer *p, const char *text) {
    const bool is_last = cannot_fall_through(p);
    p->out->depth--;
    writer_line(p->out, "%s", text);
    if (is_last)
        forbid_fall_through(p);
}

/**
 * Prints the statements of a block. A slice may contain statements between the user's declarations,
 * which C89 forbids. A declaration after a statement therefore opens a nested block, which extends
 * to the end of this one. `at_end` may use all declared names.
 */
static void print_children(printer *p, const ir_node *block, void (*at_end)(printer *p)) {
    unsigned opened = 0;
    const size_t start = p->out->out.length;
    size_t after_declarations = start;
    for (unsigned i = 0; i < block->child_count; i++) {
        const ir_node *child = block->children[i];
        if (child->kind != IR_DECLARATION) {
            print_statement(p, child);
            continue;
        }
        size_t length = p->out->out.length;
        if (p->before && p->before(p, child))
            continue;
        for (unsigned k = 0; k < child->child_count; k++) {
            if (p->before)
                p->before(p, child->children[k]);
            if (!is_kept(p, child->children[k]))
                continue;
            if (length != after_declarations || p->out->out.length != length) {
                open_block(p, "{");
                opened++;
            }
            print_declarator(p, child->children[k]);
            length = after_declarations = p->out->out.length;
        }
    }
    if (at_end)
        at_end(p);
    while (opened-- > 0)
        close_block(p, "}");
}

static bool has_kept_declarations(const printer *p, const ir_node *block) {
    for (unsigned i = 0; i < block->child_count; i++)
        if (block->children[i]->kind == IR_DECLARATION && declares_kept(p, block->children[i]))
            return true;
    return false;
}

void print_body(printer *p, const ir_node *body) {
    const bool is_block = body->kind == IR_BLOCK;
    const bool has_braces = is_block && has_kept_declarations(p, body);
    if (p->before && is_block && p->before(p, body))
        return;
    if (has_braces)
        open_block(p, "{");
    if (is_block) {
        print_children(p, body, p->at_end);
    } else {
        print_statement(p, body);
        if (p->at_end)
            p->at_end(p);
    }
    if (has_braces)
        close_block(p, "}");
}

/** Prints the body of a control statement, whose opening brace has been printed. */
static void print_part(printer *p, const ir_node *part) {
    p->out->depth++;
    if (part->kind == IR_BLOCK) {
        if (!p->before || !p->before(p, part))
            print_children(p, part, NULL);
    } else {
        print_statement(p, part);
    }
    p->out->depth--;
}

/* ---- control ------------------------------------------------------------------------------- */

static void print_if(printer *p, const ir_node *node) {
    writer_line(p->out, "if (%s) {", print_expression(p, ir_child(node, 0)));
    print_part(p, ir_child(node, 1));
    const ir_node *otherwise = ir_child(node, 2);
    if (otherwise) {
        writer_line(p->out, "} else {");
        print_part(p, otherwise);
    }
    writer_line(p->out, "}");
}

static const char *header_expression(printer *p, const ir_node *node) {
    return node->kind == IR_EMPTY ? "" : print_expression(p, node);
}

static void print_for(printer *p, const ir_node *node) {
    const ir_node *start = ir_child(node, 0);
    const bool declares = start->kind == IR_DECLARATION;
    if (declares) {
        open_block(p, "{");
        for (unsigned i = 0; i < start->child_count; i++)
            print_declarator(p, start->children[i]);
    }
    const char *first = declares ? "" : header_expression(p, start);
    const char *condition = header_expression(p, ir_child(node, 1));
    if (p->is_at_once && p->is_at_once(p, node)) {
        if (*first)
            writer_line(p->out, "%s;", first);
        open_block(p, arena_format(p->arena, "if (%s) {", condition));
        p->print_at_once(p, node);
        close_block(p, "}");
    } else {
        const char *step = p->step_of ? p->step_of(p, node) : NULL;
        writer_line(p->out, "%sfor (%s; %s; %s) {",
                    p->in_front_of_for ? p->in_front_of_for(node) : "", first, condition,
                    step ? step : header_expression(p, ir_child(node, 2)));
        print_part(p, ir_child(node, 3));
        writer_line(p->out, "}");
    }
    if (declares)
        close_block(p, "}");
}

/** Calls `print` for a loop or switch, which becomes the target of jumps inside it. */
static void print_target(printer *p, const ir_node *node,
                         void (*print)(printer *, const ir_node *)) {
    const printer outside = *p;
    const bool is_loop = node->kind != IR_SWITCH;
    p->unkept_since_break = 0;
    p->in_switch = true;
    if (is_loop) {
        p->unkept_since_continue = 0;
        p->in_loop = true;
    }
    print(p, node);
    p->unkept_since_break = outside.unkept_since_break;
    p->unkept_since_continue = outside.unkept_since_continue;
    p->in_switch = outside.in_switch;
    p->in_loop = outside.in_loop;
}

static void print_while(printer *p, const ir_node *node) {
    writer_line(p->out, "while (%s) {", print_expression(p, ir_child(node, 0)));
    print_part(p, ir_child(node, 1));
    writer_line(p->out, "}");
}

static void print_do(printer *p, const ir_node *node) {
    writer_line(p->out, "do {");
    print_part(p, ir_child(node, 0));
    writer_line(p->out, "} while (%s);", print_expression(p, ir_child(node, 1)));
}

static void print_switch(printer *p, const ir_node *node) {
    writer_line(p->out, "switch (%s) {", print_expression(p, ir_child(node, 0)));
    forbid_fall_through(p);
    print_part(p, ir_child(node, 1));
    writer_line(p->out, "}");
}

static void print_case(printer *p, const ir_node *node) {
    if (!cannot_fall_through(p))
        writer_line(p->out, "__attribute__((fallthrough));");
    if (node->kind == IR_CASE)
        writer_line(p->out, "case %s:;", print_expression(p, ir_child(node, 0)));
    else
        writer_line(p->out, "default:;");
    forbid_fall_through(p);
    print_statement(p, node->children[node->child_count - 1]);
}

/** Prints a jump, unless the slice omits a control statement between the jump and its target.
 * Without the jump the inspector merely logs more than the loop touches. */
static void print_jump(printer *p, const ir_node *node) {
    const bool is_break = node->kind == IR_BREAK;
    if ((is_break ? p->unkept_since_break : p->unkept_since_continue) > 0)
        return;
    if (is_break && !p->in_switch) {
        complain(p, "it may be left by 'break'");
        return;
    }
    writer_line(p->out, is_break ? "break;" : "continue;");
    forbid_fall_through(p);
    if (!is_break && !p->in_loop)
        p->continues = true;
}

/** Prints the statements under an omitted control statement, as if executed once. */
static void print_below(printer *p, const ir_node *node) {
    p->unkept_since_break++;
    p->unkept_since_continue++;
    for (unsigned i = 0; i < node->child_count; i++) {
        const ir_node *child = node->children[i];
        if (child->kind >= IR_BLOCK && child->kind != IR_DECLARATOR)
            print_statement(p, child);
    }
    p->unkept_since_break--;
    p->unkept_since_continue--;
}

static void print_kept(printer *p, const ir_node *node) {
    switch (node->kind) {
    case IR_EXPRESSION:
        writer_line(p->out, "%s;", print_expression(p, ir_child(node, 0)));
        break;
    case IR_IF:
        print_if(p, node);
        break;
    case IR_FOR:
        print_target(p, node, print_for);
        break;
    case IR_WHILE:
        print_target(p, node, print_while);
        break;
    case IR_DO:
        print_target(p, node, print_do);
        break;
    case IR_SWITCH:
        print_target(p, node, print_switch);
        break;
    case IR_EMPTY:
        if (!p->keep)
            writer_line(p->out, ";");
        break;
    default:
        complain(p, "a statement in it cannot be spelled a second time");
        break;
    }
}

void print_statement(printer *p, const ir_node *node) {
    if (p->before && p->before(p, node))
        return;
    switch (node->kind) {
    case IR_BREAK:
    case IR_CONTINUE:
        print_jump(p, node);
        break;
    case IR_CASE:
    case IR_DEFAULT: /* if the switch is omitted, only the labelled statement is printed */
        if (p->unkept_since_break == 0 && p->in_switch)
            print_case(p, node);
        else
            print_statement(p, node->children[node->child_count - 1]);
        break;
    case IR_BLOCK: {
        const bool declares = has_kept_declarations(p, node);
        if (declares || !p->keep)
            open_block(p, "{");
        print_children(p, node, NULL);
        if (declares || !p->keep)
            close_block(p, "}");
        break;
    }
    case IR_DECLARATION:
        if (declares_kept(p, node))
            print_declaration(p, node);
        break;
    default:
        if (is_kept(p, node))
            print_kept(p, node);
        else if (node->kind != IR_EXPRESSION)
            print_below(p, node);
        break;
    }
}
