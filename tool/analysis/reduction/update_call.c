/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/reduction/update_call.h"

#include "analysis/base/counted.h"
#include "analysis/base/expression.h"

/* ---- inside the parameter's target ----------------------------------------------------------- */

static bool is_parameter(const ir_node *node, const ir_variable *parameter) {
    return node->kind == IR_VARIABLE && node->variable == parameter;
}

static bool is_subscript_below(const ir_node *subscript, int64_t count) {
    int64_t low, high;
    return count > 0 && counted_range(subscript, &low, &high) && low >= 0 && high < count;
}

/* Is the lvalue *(T (*)[n])p, where the parameter p points to T? It consists of the n elements that
 * begin at p (callee_terms.c). */
static bool is_widened(const ir_node *lvalue, const ir_variable *parameter) {
    const ir_node *cast = lvalue->children[0];
    return cast->kind == IR_CAST && is_parameter(cast->children[0], parameter) &&
           lvalue->type->kind == IR_ARRAY && parameter->type->target &&
           ir_type_equal(lvalue->type->target, parameter->type->target);
}

/* Are all bytes of the lvalue inside the first `size` bytes to which the parameter points? */
static bool lies_within(const ir_node *lvalue, const ir_variable *parameter, int64_t size) {
    const ir_node *child = lvalue->child_count ? lvalue->children[0] : NULL;
    if (!child || !lvalue->type || lvalue->type->size <= 0 || lvalue->type->size > size)
        return false;
    switch (lvalue->kind) {
    case IR_UNARY:
        if (lvalue->op != IR_OP_DEREFERENCE)
            return false;
        return is_parameter(child, parameter) || is_widened(lvalue, parameter);
    case IR_INDEX:
        if (is_parameter(child, parameter))
            return is_subscript_below(lvalue->children[1], size / lvalue->type->size);
        return child->type && child->type->kind == IR_ARRAY &&
               is_subscript_below(lvalue->children[1], child->type->count) &&
               lies_within(child, parameter, size);
    case IR_MEMBER:
        if (!(lvalue->flags & IR_ARROW))
            return lies_within(child, parameter, size);
        return is_parameter(child, parameter) && child->type->target &&
               child->type->target->size > 0 && child->type->target->size <= size;
    default:
        return false;
    }
}

/* ---- the element or row ---------------------------------------------------------------------- */

/* The lvalue to which the argument points; NULL if it is unknown. */
static const ir_node *pointed_element(const loop_analysis *j, const ir_node *argument) {
    if (argument->kind == IR_UNARY && argument->op == IR_OP_ADDRESS)
        return argument->children[0];
    if (argument->type && argument->type->kind == IR_ARRAY && expression_is_lvalue(argument))
        return argument;
    if (argument->kind != IR_BINARY || argument->op != IR_OP_ADD || !argument->type ||
        argument->type->kind != IR_POINTER || !expression_is_plain(argument))
        return NULL;
    const ir_type *left = argument->children[0]->type;
    bool left_is_pointer = left && (left->kind == IR_POINTER || left->kind == IR_ARRAY);
    arena *a = j->an->memory;
    ir_node *element = ir_new(a, IR_INDEX, argument->type->target, 2);
    element->range = argument->range;
    for (unsigned i = 0; i < 2; i++) {
        const ir_node *part = argument->children[left_is_pointer ? i : 1 - i];
        element->children[i] = ir_substitute(a, part, NULL, NULL);
        element->children[i]->parent = element;
    }
    return element;
}

static bool points_to(const ir_type *pointer, const ir_type *target) {
    const ir_type *pointee = pointer->kind == IR_POINTER ? pointer->target : NULL;
    return pointee && (ir_type_equal(pointee, target) ||
                       (target->kind == IR_ARRAY && ir_type_equal(pointee, target->target)));
}

/* ---- the call -------------------------------------------------------------------------------- */

/* The only parameter through which the function writes. NULL if there are several, or if it writes
 * elsewhere. */
static const ir_variable *written_parameter(const access_list *known) {
    const ir_variable *found = NULL;
    for (unsigned i = 0; i < known->items.count; i++) {
        const access *item = &known->items.items[i];
        if (item->kind == ACCESS_READ)
            continue;
        const ir_variable *root =
            item->lvalue && item->is_exact ? ir_root_variable(item->lvalue) : NULL;
        if (!root || root->storage != IR_PARAMETER || (found && found != root))
            return NULL;
        found = root;
    }
    return found;
}

static bool writes_within(const access_list *known, const ir_variable *parameter, int64_t size) {
    for (unsigned i = 0; i < known->items.count; i++)
        if (known->items.items[i].kind != ACCESS_READ &&
            !lies_within(known->items.items[i].lvalue, parameter, size))
            return false;
    return true;
}

/* Is the node a member p->v, p->m.v or p->m->v of the record to which the parameter p points? */
static bool is_member_of(const ir_node *node, const ir_variable *parameter) {
    if (node->kind != IR_MEMBER || !node->type)
        return false;
    const ir_node *record = node->children[0];
    return ((node->flags & IR_ARROW) && is_parameter(record, parameter)) ||
           is_member_of(record, parameter);
}

/* Does the expression consist of parameters that are numbers, and of integer members of the record
 * to which `parameter` points? */
static bool is_of_parameters(const ir_node *node, const ir_variable *parameter) {
    if (node->kind == IR_VARIABLE)
        return node->variable->storage == IR_PARAMETER && ir_type_is_scalar(node->type) &&
               node->type->kind != IR_POINTER;
    if (node->kind == IR_MEMBER)
        return node->type && node->type->kind == IR_INTEGER && is_member_of(node, parameter);
    if (node->kind != IR_NUMBER && node->kind != IR_BINARY && node->kind != IR_CAST &&
        node->kind != IR_UNARY)
        return false;
    for (unsigned i = 0; i < node->child_count; i++)
        if (!is_of_parameters(node->children[i], parameter))
            return false;
    return true;
}

/* Is the lvalue a scalar element p[k], p[k][c] or p->v[k] behind the parameter p, with subscripts
 * that the caller can compute too? */
static bool is_plain_element(const ir_node *lvalue, const ir_variable *parameter) {
    const ir_node *node = lvalue;
    while (node->kind == IR_INDEX && is_of_parameters(node->children[1], parameter)) {
        node = node->children[0];
        if (is_parameter(node, parameter) || is_member_of(node, parameter))
            return node->type && ir_type_is_scalar(lvalue->type) &&
                   (node->type->kind == IR_POINTER ||
                    (node->type->kind == IR_ARRAY && !is_parameter(node, parameter)));
        if (!node->type || node->type->kind != IR_ARRAY)
            return false;
    }
    return false;
}

/* The one element that each call writes, as in add_at(h, k, v), expressed by the function's
 * parameters. NULL if a call may write no element, several elements or other memory. */
static const ir_node *written_element(const access_list *known, const ir_variable *parameter) {
    const ir_node *element = NULL;
    for (unsigned i = 0; i < known->items.count; i++) {
        const access *item = &known->items.items[i];
        if (item->kind == ACCESS_READ)
            continue;
        if (item->is_conditional || (element && !expression_same(element, item->lvalue)))
            return NULL;
        element = item->lvalue;
    }
    return element && is_plain_element(element, parameter) ? element : NULL;
}

static const ir_node *argument_for(const ir_node *call, const ir_variable *parameter) {
    const ir_function *function = call->children[0]->function;
    for (unsigned i = 0; i < function->parameter_count && i + 1 < call->child_count; i++)
        if (function->parameters[i] == parameter)
            return call->children[i + 1];
    return NULL;
}

/* The memory that a call writes, expressed by the function's parameters: one element, or the first
 * `size` bytes to which a parameter points. */
typedef struct written_part {
    const ir_variable *parameter;
    const ir_node *element; /* NULL if it is the first `size` bytes */
    int64_t size;
} written_part;

static bool is_in_part(const ir_node *lvalue, const written_part *part) {
    return part->element ? expression_same(lvalue, part->element)
                         : lies_within(lvalue, part->parameter, part->size);
}

/* Can the updates be exchanged, as far as types are concerned? False if the target is a _Bool, or
 * an integer that is updated by a value of another kind. Each update then converts its result, so
 * the order matters. */
static bool keeps_type(const update_form *form) {
    const ir_type *type = form->target->type;
    return type && type->kind != IR_BOOLEAN &&
           (type->kind != IR_INTEGER || !form->value ||
            (form->value->type && form->value->type->kind == IR_INTEGER));
}

/* Sets the operator, if all writes are updates by one operator (*d += e) and nothing else reads
 * this memory. */
static void find_operator(const access_list *known, const written_part *part, update_call *found) {
    unsigned writes = 0;
    for (unsigned i = 0; i < known->items.count; i++) {
        const access *item = &known->items.items[i];
        if (item->kind == ACCESS_READ) {
            if (item->lvalue && is_in_part(item->lvalue, part))
                return;
            continue;
        }
        if (item->kind != ACCESS_UPDATE || !item->form.has_operator || !keeps_type(&item->form) ||
            (writes++ && item->form.op != found->op))
            return;
        found->op = item->form.op;
    }
    found->has_operator = writes > 0;
}

static const access_list *summary_of(const loop_analysis *j, const ir_node *call) {
    const ir_node *callee = call->children[0];
    if (call->kind != IR_CALL || callee->kind != IR_FUNCTION || !callee->function->body)
        return NULL;
    const access_list *known = effects_of(j->an->effects, callee->function);
    return known && !known->problems.count ? known : NULL;
}

/* The target of a call that receives the address of an element or row, as in add(&h[k], v);
 * otherwise NULL. */
static const ir_node *target_by_address(const loop_analysis *j, const ir_node *call,
                                        const access_list *known, written_part *part) {
    const ir_variable *parameter = part->parameter;
    const ir_node *target = pointed_element(j, argument_for(call, parameter));
    if (!target || !target->type || !points_to(parameter->type, target->type) ||
        !writes_within(known, parameter, target->type->size))
        return NULL;
    part->size = target->type->size;
    return target;
}

/* Is the array a member of the record to which the argument points, so that the call's text does
 * not name the array? */
static bool is_by_member(const written_part *part) {
    const ir_node *base = part->element;
    while (base && base->kind == IR_INDEX)
        base = base->children[0];
    return base && base->kind == IR_MEMBER;
}

/* The target of a call that receives an array and separate subscripts, as in add_at(h, k, v);
 * otherwise NULL. */
static const ir_node *target_by_subscript(const loop_analysis *j, const ir_node *call,
                                          const access_list *known, written_part *part) {
    const ir_node *array = argument_for(call, part->parameter);
    part->element = written_element(known, part->parameter);
    if (!part->element)
        return NULL;
    /* for an argument &s.x, only that one object is certain to exist */
    if (!is_by_member(part) && array->kind == IR_UNARY && array->op == IR_OP_ADDRESS)
        return NULL;
    const ir_node *target = ir_substitute(j->an->memory, part->element, call->children[0]->function,
                                          &call->children[1]);
    return expression_is_plain(target) ? target : NULL;
}

/* The element or row that the call updates, expressed by the caller's variables; NULL if the call
 * is no update of either form. */
static const ir_node *target_of(const loop_analysis *j, const ir_node *call,
                                const access_list *known, written_part *part) {
    *part = (written_part){.parameter = written_parameter(known)};
    if (!part->parameter || !argument_for(call, part->parameter))
        return NULL;
    const ir_node *target = target_by_address(j, call, known, part);
    return target ? target : target_by_subscript(j, call, known, part);
}

update_call update_call_of(const loop_analysis *j, const ir_node *call) {
    update_call none = {0};
    const access_list *known = summary_of(j, call);
    if (!known || !call->parent || call->parent->kind != IR_EXPRESSION)
        return none;
    written_part part;
    const ir_node *target = target_of(j, call, known, &part);
    if (!target)
        return none;
    update_call found = {
        .statement = call->parent, .target = target, .is_by_member = is_by_member(&part)};
    find_operator(known, &part, &found);
    return found;
}

/* Relies on the order of the accesses: those of a call are in the order of the function's summary,
 * and each has the call as its node. */
void update_call_mark_reads(loop_analysis *j, const update_call *update) {
    const ir_node *call = update->statement->children[0];
    const access_list *known = summary_of(j, call);
    written_part part;
    unsigned number = 0;
    if (!known || !target_of(j, call, known, &part))
        return;
    for (unsigned i = 0; i < j->access_count && number < known->items.count; i++) {
        loop_access *read = &j->accesses[i];
        if (read->access.node != call || !read->access.callee)
            continue;
        const access *item = &known->items.items[number++];
        if (item->kind == ACCESS_READ && item->lvalue && is_in_part(item->lvalue, &part))
            read->class = CLASS_SELF;
    }
}
