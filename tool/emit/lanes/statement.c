/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Writes statements that compute, for all lanes, and the functions that they call. All lanes must
 * execute the same iterations of a loop; an `if` may be executed by some lanes only (mask.c).
 */
#include <assert.h>
#include <string.h>

#include "analysis/base/counted.h"
#include "emit/base/names.h"
#include "emit/lanes/vectoriser.h"
#include "emit/text/origin.h"
#include "ir/ir_words.h"

/* ---- declarations --------------------------------------------------------------------------- */

/** Drops the type's own qualifiers, since each lane's variable is assigned. */
const char *lane_type(vectoriser *l, const ir_type *type) {
    arena *a = l->loop->arena;
    ir_type *plain = ARENA_NEW(a, ir_type);
    *plain = *type;
    plain->is_const = plain->is_restrict = false;
    const char *spelling = ir_type_default_spelling(a, plain);
    if (!spelling) {
        lane_problem(&l->in, NO_LANES_SPELLING, NULL);
        return "int";
    }
    const char *marked = origin_spelling(a, type, spelling);
    return strpbrk(spelling, "*([") ? arena_format(a, "__typeof__(%s)", marked) : marked;
}

/** The extents of an array type: "[3][3]". */
static const char *extents(vectoriser *l, const ir_type *type) {
    const char *text = "";
    for (; type->kind == IR_ARRAY; type = type->target) {
        if (type->count <= 0)
            lane_problem(&l->in, NO_LANES_VARIABLE_TYPE, NULL);
        text = arena_format(l->loop->arena, "%s[%lld]", text, (long long)type->count);
    }
    return text;
}

static bool is_zero(const ir_node *node) {
    if (node->kind == IR_INITIALIZERS) {
        for (unsigned i = 0; i < node->child_count; i++)
            if (!is_zero(node->children[i]))
                return false;
        return !(node->flags & IR_DESIGNATED);
    }
    if (node->flags & IR_HAS_VALUE)
        return node->value == 0;
    if (node->kind != IR_NUMBER || !node->text)
        return false;
    const char *rest = node->text + strspn(node->text, "0.");
    return rest > node->text && (!*rest || strcmp(rest, "f") == 0 || strcmp(rest, "F") == 0);
}

/** An initialiser that zeroes all lanes of all elements: "{{{0}}}". */
static const char *zeros(vectoriser *l, const ir_type *type) {
    const char *text = "{0}";
    for (; type->kind == IR_ARRAY; type = type->target)
        text = arena_format(l->loop->arena, "{%s}", text);
    return text;
}

/** The initialiser of an array: zeros or, in one dimension, a value for each element. */
static const char *array_initialiser(vectoriser *l, const ir_type *type, const ir_node *value) {
    arena *a = l->loop->arena;
    if (value->kind == IR_INITIALIZERS && is_zero(value))
        return zeros(l, type);
    if (value->kind != IR_INITIALIZERS || value->flags & IR_DESIGNATED ||
        (int64_t)value->child_count != type->count || type->target->kind == IR_ARRAY) {
        lane_problem(&l->in, NO_LANES_INITIALISER, value);
        return "{{0}}";
    }
    const char *text = NULL;
    for (unsigned i = 0; i < value->child_count; i++) {
        const char *element = lane_vector(l, value->children[i], type->target);
        text = text ? arena_format(a, "%s, %s", text, element) : element;
    }
    return arena_format(a, "{%s}", text);
}

static void declare_vector(vectoriser *l, const ir_variable *variable, const ir_node *value) {
    const char *name = origin_declarator(l->loop->arena, variable);
    const ir_type *type = variable->type;
    const char *vector = lane_words_of(ir_type_innermost(type))->vector;
    if (!value && !l->is_kept[variable->id]) {
        writer_line(l->out, "%s %s%s;", vector, name, extents(l, type));
        return;
    }
    /* without a value it is zeroed: a select may read it, although the result is not used */
    writer_line(l->out, "%s %s%s = %s;", vector, name, extents(l, type),
                !value                   ? zeros(l, type)
                : type->kind == IR_ARRAY ? array_initialiser(l, type, value)
                                         : lane_vector(l, value, type));
}

/** The user's expression with the variables of lane redcc__l. */
static const char *lane_text(vectoriser *l, const ir_node *value) {
    lane_check_operand(&l->in, value);
    return lane_scalar(l, value);
}

static void declare_own(vectoriser *l, const ir_variable *variable, const ir_node *value) {
    arena *a = l->loop->arena;
    const char *name = origin_declarator(a, variable);
    switch (l->in.class_of[variable->id]) {
    case LANE_VECTOR:
        declare_vector(l, variable, value);
        break;
    case LANE_MASK:
        writer_line(l->out, "redcc_mask %s = %s;", name, lane_mask(l, value));
        break;
    case LANE_VARYING:
        writer_line(l->out, "%s %s[REDCC_WIDTH];", lane_type(l, variable->type), name);
        if (value)
            writer_line(l->out, "REDCC_EACH_LANE %s[redcc__l] = %s;", origin_variable(a, variable),
                        lane_masked(l, value, lane_text(l, value)));
        break;
    case LANE_LOCAL: /* the update statement contains the declaration */
        break;
    case LANE_UNIFORM:
        if (value)
            writer_line(l->out, "%s %s = %s;", lane_type(l, variable->type), name,
                        lane_scalar(l, value));
        else
            writer_line(l->out, "%s %s;", lane_type(l, variable->type), name);
        break;
    }
}

void lane_declare(vectoriser *l, const ir_variable *variable) {
    declare_own(l, variable, NULL);
}

/* ---- calls ---------------------------------------------------------------------------------- */

static const char *parameter_text(vectoriser *l, const ir_variable *parameter, lane_class class) {
    arena *a = l->loop->arena;
    const ir_type *type = parameter->type;
    const char *name = origin_declarator(a, parameter);
    if (class == LANE_VARYING)
        return arena_format(a, "%s *%s", lane_type(l, type), name);
    if (class == LANE_UNIFORM)
        return arena_format(a, "%s %s", lane_type(l, type), name);
    const char *vector = lane_words_of(lane_vector_type(parameter))->vector;
    if (type->kind != IR_POINTER)
        return arena_format(a, "%s %s", vector, name);
    const char *of = extents(l, type->target);
    return arena_format(a, *of ? "%s (*%s)%s" : "%s *%s%s", vector, name, of);
}

/** Is the argument an array with one value of the parameter's type per lane, and does the function
 * leave the parameter unchanged? If so, the argument need not be copied. */
static bool needs_no_copy(const vectoriser *l, const ir_variable *parameter, const ir_node *value) {
    return value->kind == IR_VARIABLE && l->in.class_of[value->variable->id] == LANE_VARYING &&
           ir_type_equal(parameter->type, value->variable->type) &&
           !variable_is_written_in(parameter->function->body, parameter);
}

static const char *argument_text(vectoriser *l, const ir_variable *parameter, lane_class class,
                                 const ir_node *value) {
    arena *a = l->loop->arena;
    if (class == LANE_UNIFORM)
        return lane_scalar(l, value);
    if (class == LANE_VARYING && needs_no_copy(l, parameter, value))
        return origin_variable(a, value->variable);
    if (class == LANE_VARYING)
        return arena_format(a, "REDCC_EACH(%s, %s)", lane_type(l, parameter->type),
                            lane_masked(l, value, lane_text(l, value)));
    if (parameter->type->kind != IR_POINTER)
        return lane_vector(l, value, parameter->type);
    const char *text = text_operand(a, value, NULL, NULL);
    if (!text)
        lane_problem(&l->in, NO_LANES_SPELLING, value);
    return text ? text : "0";
}

static void write_parameters(vectoriser *l, const ir_function *function, const lane_class *classes,
                             const char *name) {
    const ir_type *result = function->type->target;
    buffer head = {0};
    if (l->mask)
        buffer_format(&head, "const redcc_mask %s __attribute__((__unused__))", l->mask);
    for (unsigned i = 0; i < function->parameter_count; i++) {
        const ir_variable *parameter = function->parameters[i];
        l->in.class_of[parameter->id] = classes[i];
        buffer_format(&head, "%s%s __attribute__((__unused__))", head.data ? ", " : "",
                      parameter_text(l, parameter, classes[i]));
    }
    writer_line(l->out, "REDCC_VECTOR_INLINE %s %s(%s) {",
                lane_is_real(result) ? lane_words_of(result)->vector : "void", name,
                head.data ? head.data : "void");
    buffer_free(&head);
}

/** Writes the vector form of a function, to be inserted before the current function. */
static void write_clone(vectoriser *l, const ir_function *function, const lane_class *classes,
                        const char *name) {
    writer text = {0};
    vectoriser inner = *l;
    inner.in.function = function;
    inner.in.body = function->body;
    inner.depth = l->depth + 1;
    inner.out = &text;
    inner.mask = l->mask ? "redcc__m0" : NULL;
    inner.region = l->mask ? function->body : NULL;
    write_parameters(&inner, function, classes, name);
    lane_classify(&inner.in);
    text.depth = 1;
    writer_line(&text, "int redcc__l __attribute__((__unused__));");
    for (unsigned i = 0; i < function->body->child_count; i++) {
        const ir_node *statement = function->body->children[i];
        const bool is_last = i + 1 == function->body->child_count;
        if (statement->kind == IR_RETURN && is_last && statement->child_count > 0)
            writer_line(&text, "return %s;",
                        lane_vector(&inner, statement->children[0], function->type->target));
        else if (statement->kind != IR_RETURN || !is_last)
            lane_statement(&inner, statement);
    }
    text.depth = 0;
    writer_line(&text, "}");
    buffer_text(&l->front->out, writer_text(l->loop->arena, &text));
}

static const char *clone_of(vectoriser *l, const ir_function *function, const lane_class *classes) {
    arena *a = l->loop->arena;
    const size_t bytes = function->parameter_count * sizeof *classes;
    for (unsigned i = 0; i < l->clones->count; i++) {
        const lane_clone *it = &l->clones->items[i];
        if (it->function == function && it->is_masked == (l->mask != NULL) &&
            (!bytes || memcmp(it->classes, classes, bytes) == 0))
            return it->name;
    }
    const lane_clone clone = {
        function, classes, l->mask != NULL,
        arena_format(a, "redcc__%u_%s", l->clones->count + 1, loop_lanes_name(l->loop))};
    VECTOR_PUSH(a, l->clones, clone);
    write_clone(l, function, classes, clone.name);
    return clone.name;
}

const char *lane_call(vectoriser *l, const ir_node *call) {
    assert(call->kind == IR_CALL && call->children[0]->kind == IR_FUNCTION);
    arena *a = l->loop->arena;
    const ir_function *function = call->children[0]->function;
    if (!lane_can_be_called(function, call, l->depth)) {
        lane_problem(&l->in, NO_LANES_CALL, call);
        return "redcc_same(0.0)";
    }
    lane_class *classes = ARENA_ARRAY(a, lane_class, function->parameter_count + 1);
    const char *arguments = l->mask ? l->mask : "";
    for (unsigned i = 0; i < function->parameter_count; i++) {
        const ir_variable *parameter = function->parameters[i];
        const ir_node *value = call->children[i + 1];
        classes[i] = lane_parameter_class(&l->in, parameter, value);
        arguments = arena_format(a, "%s%s%s", arguments, *arguments ? ", " : "",
                                 argument_text(l, parameter, classes[i], value));
    }
    const char *name = clone_of(l, function, classes);
    for (unsigned i = 0; i < function->parameter_count; i++) {
        const ir_variable *root = lane_vector_root(&l->in, call->children[i + 1]);
        if (root && function->parameters[i]->type->kind == IR_POINTER)
            l->is_kept[root->id] |= l->is_kept[function->parameters[i]->id];
    }
    return arena_format(a, "%s(%s)", name, arguments);
}

/* ---- statements ----------------------------------------------------------------------------- */

/** Returns the result of `target op= value` or `target = value`: a vector of the target's type. As
 * in C, the operation is computed in the wider of both types, and the result is converted. */
static const char *assigned_value(vectoriser *l, const ir_node *node, const char *target) {
    const ir_node *value = node->children[1];
    const ir_type *type = node->children[0]->type;
    if (node->op == IR_OP_NONE)
        return lane_vector(l, value, type);
    const ir_type *computed = lane_common(type, value->type);
    if (!computed || !lane_has_operator(node->op)) {
        lane_problem(&l->in, computed ? NO_LANES_OPERAND_EFFECT : NO_LANES_OPERAND_TYPE, node);
        return target;
    }
    const lane_value held = lane_convert(l, (lane_value){target, true}, type, computed);
    const lane_value sum = {arena_format(l->loop->arena, "(%s %s %s)", held.text,
                                         ir_operator_spelling(node->op),
                                         lane_expression(l, value, computed).text),
                            true};
    return lane_convert(l, sum, computed, type).text;
}

static void assign_vector(vectoriser *l, const ir_node *node) {
    const ir_type *type = node->children[0]->type;
    const char *target = lane_expression(l, node->children[0], type).text;
    const ir_variable *root = lane_vector_root(&l->in, node->children[0]);
    const bool is_of_some = lane_needs_select(l, root);
    l->is_kept[root->id] |= is_of_some;
    const ir_type *computed = lane_common(type, node->children[1]->type);
    if (!is_of_some && lane_has_operator(node->op) && computed && computed->size == type->size) {
        writer_line(l->out, "%s %s= %s;", target, ir_operator_spelling(node->op),
                    lane_expression(l, node->children[1], type).text);
        return;
    }
    const char *value = assigned_value(l, node, target);
    if (is_of_some)
        value = arena_format(l->loop->arena, "%s(%s, %s, %s)", lane_words_of(type)->select, l->mask,
                             value, target);
    writer_line(l->out, "%s = %s;", target, value);
}

/** Returns the assignments of a private integer or pointer, one per lane, or a single assignment if
 * the variable is uniform. */
static const char *assignment_of(vectoriser *l, const ir_node *node) {
    const ir_node *target = node->children[0];
    if (target->kind != IR_VARIABLE || !lane_is_own(&l->in, target->variable) ||
        l->in.class_of[target->variable->id] == LANE_VECTOR ||
        (!ir_is_increment(node) && node->kind != IR_ASSIGN)) {
        lane_problem(&l->in, NO_LANES_STATEMENT, node);
        return "(void)0";
    }
    if (node->kind == IR_ASSIGN)
        lane_check_operand(&l->in, node->children[1]);
    const char *text = text_expression(l->loop->arena, node, lane_rename, l);
    if (!text)
        lane_problem(&l->in, NO_LANES_SPELLING, node);
    return text ? text : "(void)0";
}

static void write_expression(vectoriser *l, const ir_node *node) {
    if (node->kind == IR_CALL && node->children[0]->kind == IR_FUNCTION &&
        node->children[0]->function->body) {
        writer_line(l->out, "%s;", lane_call(l, node));
        return;
    }
    if (node->kind == IR_ASSIGN && lane_is_real(node->children[0]->type) &&
        lane_vector_root(&l->in, node->children[0])) {
        assign_vector(l, node);
        return;
    }
    const char *text = assignment_of(l, node);
    const ir_node *target = node->children[0];
    const bool varies = target && target->kind == IR_VARIABLE &&
                        l->in.class_of[target->variable->id] == LANE_VARYING;
    if (varies && l->mask)
        writer_line(l->out, "REDCC_EACH_LANE if (%s[redcc__l]) %s;", l->mask, text);
    else
        writer_line(l->out, "%s%s;", varies ? "REDCC_EACH_LANE " : "", text);
}

void lane_part(vectoriser *l, const ir_node *part) {
    l->out->depth++;
    if (part->kind != IR_BLOCK)
        lane_statement(l, part);
    for (unsigned i = 0; part->kind == IR_BLOCK && i < part->child_count; i++)
        lane_statement(l, part->children[i]);
    l->out->depth--;
    writer_line(l->out, "}");
}

static void write_if(vectoriser *l, const ir_node *node) {
    if (!lane_is_uniform(&l->in, node->children[0])) {
        lane_masked_if(l, node);
        return;
    }
    writer_line(l->out, "if (%s) {", lane_condition(l, node->children[0]));
    lane_part(l, node->children[1]);
    if (node->child_count < 3)
        return;
    writer_line(l->out, "else {");
    lane_part(l, node->children[2]);
}

void lane_statement(vectoriser *l, const ir_node *statement) {
    lane_note_place(&l->in, statement);
    switch (statement->kind) {
    case IR_EMPTY:
        break;
    case IR_BLOCK:
        writer_line(l->out, "{");
        lane_part(l, statement);
        break;
    case IR_DECLARATION:
        for (unsigned i = 0; i < statement->child_count; i++) {
            const ir_node *declarator = statement->children[i];
            if (!lane_is_own(&l->in, declarator->variable))
                lane_problem(&l->in, NO_LANES_STORAGE, declarator);
            else
                declare_own(l, declarator->variable, ir_child(declarator, 0));
        }
        break;
    case IR_EXPRESSION:
        write_expression(l, statement->children[0]);
        break;
    case IR_FOR:
        lane_for(l, statement);
        break;
    case IR_IF:
        write_if(l, statement);
        break;
    case IR_RETURN:
        lane_problem(&l->in, NO_LANES_RETURN, statement);
        break;
    default:
        lane_problem(&l->in, NO_LANES_STATEMENT, statement);
        break;
    }
}
