/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/memory/variable_facts.h"

#include <assert.h>
#include <string.h>

#include "analysis/base/expression.h"
#include "support/map.h"

struct variable_facts {
    arena *memory;
    const ir_unit *unit;
    must_write *prover;
    variable_fact *facts; /* indexed by variable id */
    map *jumps;           /* a function's body -> a value other than NULL: `jumps` if it has one */
};

/* The variable that the node changes, wholly or in part, or whose address it takes. NULL if there
 * is none. */
static ir_variable *changed_variable(const ir_node *node) {
    const ir_node *lvalue = expression_written(node);
    if (node->kind == IR_UNARY && node->op == IR_OP_ADDRESS)
        lvalue = node->children[0];
    return lvalue ? expression_object(lvalue) : NULL;
}

/* Is an array passed to a function, which may write to it? The array is the node itself, or the
 * part of it that the expression around the node denotes. */
static bool is_handed_over(const ir_node *node) {
    const ir_node *parent = node->parent;
    while (parent && ((parent->kind == IR_INDEX && parent->children[0] == node) ||
                      (parent->kind == IR_MEMBER && !(parent->flags & IR_ARROW)) ||
                      parent->kind == IR_CAST || parent->kind == IR_BINARY)) {
        const bool is_part = parent->kind == IR_INDEX || parent->kind == IR_MEMBER;
        if (is_part && parent->type && parent->type->kind != IR_ARRAY &&
            parent->type->kind != IR_RECORD)
            return false; /* only an element's value is used */
        node = parent;
        parent = node->parent;
    }
    return parent && parent->kind == IR_CALL && node->type &&
           (node->type->kind == IR_ARRAY || node->kind == IR_CAST || node->kind == IR_BINARY);
}

static bool is_step(const ir_node *write) {
    return ir_is_increment(write) ||
           (write->kind == IR_ASSIGN && (write->op == IR_OP_ADD || write->op == IR_OP_SUBTRACT));
}

/* Notes an operand of inline assembly or another opaque node as written, because it may be an
 * output. The lengths of variable-length arrays are only read. The statements of a statement
 * expression are noted by themselves. */
static void note_hidden_write(variable_facts *all, const ir_node *node, const ir_node *operand) {
    const ir_variable *variable = expression_object(operand);
    if (!variable || ir_is_statement_expression(node) || ir_is_lengths(node))
        return;
    variable_fact *fact = &all->facts[variable->id];
    VECTOR_PUSH(all->memory, &fact->writes, node);
    fact->write_count++;
    fact->definition = fact->start = NULL;
    fact->definition_place = node;
}

static bool note_occurrence(ir_node *node, void *context) {
    variable_facts *all = context;
    for (unsigned i = 0; node->kind == IR_OPAQUE && i < node->child_count; i++)
        note_hidden_write(all, node, node->children[i]);
    if (node->kind == IR_VARIABLE && node->variable) {
        variable_fact *fact = &all->facts[node->variable->id];
        VECTOR_PUSH(all->memory, &fact->occurrences, node);
        if (node->type && ir_type_innermost(node->type)->kind != IR_POINTER &&
            (node->type->kind == IR_ARRAY || node->type->kind == IR_RECORD) && is_handed_over(node))
            VECTOR_PUSH(all->memory, &fact->writes, node);
    }
    if (node->kind == IR_DECLARATOR && node->variable) {
        variable_fact *fact = &all->facts[node->variable->id];
        /* `extern int x;` in a block only names the variable, perhaps in several functions */
        if (node->variable->storage != IR_GLOBAL)
            fact->declarator = node;
        if (node->child_count) {
            VECTOR_PUSH(all->memory, &fact->writes, node);
            fact->write_count++;
            fact->definition = fact->start = node->children[0];
            fact->definition_place = node;
        }
    }
    ir_variable *changed = changed_variable(node);
    if (changed)
        VECTOR_PUSH(all->memory, &all->facts[changed->id].writes, node);
    const ir_node *target = expression_written(node);
    if (target && target->kind == IR_VARIABLE) {
        variable_fact *fact = &all->facts[target->variable->id];
        fact->write_count++;
        fact->definition =
            node->kind == IR_ASSIGN && node->op == IR_OP_NONE ? node->children[1] : NULL;
        fact->definition_place = node;
        if (is_step(node))
            fact->step_count++;
        else
            fact->start = fact->definition;
    }
    return true;
}

variable_facts *variable_facts_new(arena *a, const ir_unit *unit, must_write *prover) {
    variable_facts *all = ARENA_NEW(a, variable_facts);
    all->memory = a;
    all->unit = unit;
    all->prover = prover;
    all->facts = ARENA_ARRAY(a, variable_fact, unit->variable_count + 1);
    all->jumps = map_new(a);
    for (unsigned i = 0; i < unit->function_count; i++)
        if (unit->functions[i]->body)
            ir_walk(unit->functions[i]->body, note_occurrence, all);
    return all;
}

const ir_unit *variable_facts_unit(const variable_facts *facts) {
    return facts->unit;
}

const variable_fact *variable_fact_of(variable_facts *facts, const ir_variable *variable) {
    assert(facts->unit->variables[variable->id] == variable);
    return &facts->facts[variable->id];
}

static bool is_jump_or_opaque(const ir_node *node) {
    return node->kind == IR_LABEL || node->kind == IR_GOTO || node->kind == IR_OPAQUE;
}

bool variable_facts_has_jump(variable_facts *facts, const ir_function *function) {
    void **known = map_at(facts->jumps, &function->body, sizeof function->body);
    if (!*known)
        *known = ir_any(function->body, is_jump_or_opaque) ? (void *)facts->jumps : (void *)facts;
    return *known == facts->jumps;
}

unsigned expression_last_id(const ir_node *node) {
    while (node->child_count)
        node = node->children[node->child_count - 1];
    return node->id;
}

/* How a call uses the target of this argument. The call must name its function. */
static parameter_effect effect_of_argument(const variable_facts *facts, const ir_node *call,
                                           const ir_node *argument) {
    for (unsigned i = 1; i < call->child_count; i++)
        if (call->children[i] == argument)
            return must_write_parameter(facts->prover, call->children[0]->function, i - 1);
    return (parameter_effect){.keeps_address = true};
}

/* Is the node &v, passed to a function that only reads through this pointer? */
static bool is_only_read(const variable_facts *facts, const ir_node *address) {
    const ir_node *call = address->parent;
    if (address->kind != IR_UNARY || address->op != IR_OP_ADDRESS || !call ||
        call->kind != IR_CALL || call->children[0]->kind != IR_FUNCTION)
        return false;
    const parameter_effect effect = effect_of_argument(facts, call, address);
    return effect.is_known && !effect.may_write;
}

static bool has_write_in(variable_facts *facts, const ir_node *node, const ir_variable *variable,
                         bool counts_reading_calls) {
    assert(facts->unit->variables[variable->id] == variable);
    const variable_fact *fact = &facts->facts[variable->id];
    for (unsigned i = 0; i < fact->writes.count; i++) {
        const ir_node *write = fact->writes.items[i];
        if (ir_contains(node, write) && /* not by ids: those of new nodes are in no such order */
            (counts_reading_calls || !is_only_read(facts, write)))
            return true;
    }
    return false;
}

bool variable_written_in(variable_facts *facts, const ir_node *node, const ir_variable *variable) {
    return has_write_in(facts, node, variable, true);
}

bool variable_may_change_in(variable_facts *facts, const ir_node *node,
                            const ir_variable *variable) {
    return has_write_in(facts, node, variable, false);
}

const ir_node *variable_single_definition(variable_facts *facts, const ir_variable *variable) {
    const variable_fact *fact = variable_fact_of(facts, variable);
    assert(fact->write_count > 0 || !fact->definition);
    if (variable->storage != IR_LOCAL || fact->write_count != 1 || !fact->definition)
        return NULL;
    if (variable->type->kind != IR_ARRAY && variable->address_taken)
        return NULL;
    return fact->definition;
}

const ir_node *variable_walk_start(variable_facts *facts, const ir_variable *variable,
                                   const ir_node *scope) {
    const variable_fact *fact = variable_fact_of(facts, variable);
    assert(fact->step_count <= fact->write_count);
    if (variable->storage != IR_LOCAL || variable->type->kind != IR_POINTER ||
        variable->address_taken || !fact->step_count || fact->write_count != fact->step_count + 1 ||
        !fact->start || expression_mentions(fact->start, variable))
        return NULL;
    for (unsigned i = 0; i < fact->writes.count; i++)
        if (!scope || !ir_contains(scope, fact->writes.items[i]))
            return NULL;
    return fact->start;
}

static const ir_node *value_set(const ir_node *write) {
    if (write->kind == IR_DECLARATOR)
        return write->children[0];
    return write->kind == IR_ASSIGN && write->op == IR_OP_NONE ? write->children[1] : NULL;
}

static bool is_null_pointer(const ir_node *value) {
    int64_t number;
    while (value->kind == IR_CAST && value->type->kind == IR_POINTER)
        value = value->children[0];
    return value->type && value->type->kind == IR_INTEGER && expression_constant(value, &number) &&
           number == 0;
}

/* The node of the array w in w, w + k, w - k or &w[k]; NULL for other values. */
static const ir_node *array_pointed_into(const ir_node *value) {
    if (!expression_is_plain(value))
        return NULL;
    if (value->kind == IR_UNARY && value->op == IR_OP_ADDRESS &&
        value->children[0]->kind == IR_INDEX)
        value = value->children[0]->children[0];
    while (value->kind == IR_BINARY && (value->op == IR_OP_ADD || value->op == IR_OP_SUBTRACT))
        value = value->children[0];
    return value->kind == IR_VARIABLE && value->type->kind == IR_ARRAY ? value : NULL;
}

const ir_node *variable_walked_array(variable_facts *facts, const ir_variable *pointer) {
    const variable_fact *fact = variable_fact_of(facts, pointer);
    const ir_node *array = NULL;
    if (pointer->storage != IR_LOCAL || pointer->type->kind != IR_POINTER || pointer->address_taken)
        return NULL;
    for (unsigned i = 0; i < fact->writes.count; i++) {
        const ir_node *write = fact->writes.items[i];
        if (is_step(write))
            continue;
        const ir_node *value = value_set(write);
        if (value && is_null_pointer(value))
            continue;
        const ir_node *start = value ? array_pointed_into(value) : NULL;
        if (!start || (array && array->variable != start->variable))
            return NULL;
        array = start;
    }
    return array && array->variable->storage == IR_LOCAL &&
                   ir_type_equal(array->type->target, pointer->type->target)
               ? array
               : NULL;
}

/* ---- uses of a pointer's value -------------------------------------------------------------- */

static bool pointer_value_escapes(variable_facts *all, const ir_node *node, unsigned depth);

static bool is_memory_function(const char *name) {
    return strcmp(name, "memset") == 0 || strcmp(name, "memcpy") == 0 ||
           strcmp(name, "memmove") == 0 || strcmp(name, "__builtin_memset") == 0 ||
           strcmp(name, "__builtin_memcpy") == 0 || strcmp(name, "__builtin_memmove") == 0;
}

static bool argument_escapes(variable_facts *all, const ir_node *call, const ir_node *argument) {
    const ir_node *callee = call->children[0];
    if (callee == argument)
        return false; /* a pointer that is only called is not stored */
    if (callee->kind != IR_FUNCTION)
        return true;
    if (!callee->function->body)
        return callee->function->linkage.is_renamed ||
               !is_memory_function(callee->function->name) || ir_value_is_used(call);
    return effect_of_argument(all, call, argument).keeps_address;
}

static bool holder_escapes(variable_facts *all, const ir_variable *holder, unsigned depth) {
    const variable_fact *fact = &all->facts[holder->id];
    if (depth > 4 || holder->storage != IR_LOCAL || holder->address_taken ||
        (fact->write_count != 1 && !variable_walked_array(all, holder)))
        return true;
    for (unsigned i = 0; i < fact->occurrences.count; i++) {
        const ir_node *use = fact->occurrences.items[i];
        const bool is_written = expression_written(use->parent) == use;
        if (is_written ? ir_value_is_used(use->parent) &&
                             pointer_value_escapes(all, use->parent, depth + 1)
                       : pointer_value_escapes(all, use, depth + 1))
            return true;
    }
    return false;
}

/* Does a use of this lvalue, which is inside the object, store the object's address? Reading or
 * writing the lvalue does not, unless the lvalue is an array that decays. */
static bool lvalue_escapes(variable_facts *all, const ir_node *node, unsigned depth) {
    const ir_node *parent = node->parent;
    bool is_array = node->type && node->type->kind == IR_ARRAY;
    if (!parent)
        return true;
    if (parent->kind == IR_MEMBER && !(parent->flags & IR_ARROW))
        return lvalue_escapes(all, parent, depth);
    if (parent->kind == IR_UNARY && parent->op == IR_OP_ADDRESS)
        return pointer_value_escapes(all, parent, depth);
    return is_array && pointer_value_escapes(all, node, depth);
}

static bool pointer_value_escapes(variable_facts *all, const ir_node *node, unsigned depth) {
    const ir_node *parent = node->parent;
    if (!parent)
        return true;
    switch (parent->kind) {
    case IR_INDEX:
        return parent->children[0] == node ? lvalue_escapes(all, parent, depth) : true;
    case IR_MEMBER:
        return lvalue_escapes(all, parent, depth);
    case IR_UNARY:
        if (parent->op == IR_OP_DEREFERENCE)
            return lvalue_escapes(all, parent, depth);
        return parent->op != IR_OP_NOT;
    case IR_BINARY:
        if (parent->op == IR_OP_COMMA)
            return true;
        return parent->type && parent->type->kind == IR_POINTER &&
               pointer_value_escapes(all, parent, depth);
    case IR_CAST:
        if (parent->type && parent->type->kind == IR_VOID)
            return false;
        return !parent->type || parent->type->kind != IR_POINTER ||
               pointer_value_escapes(all, parent, depth);
    case IR_CONDITIONAL:
        return parent->children[0] != node;
    case IR_CALL:
        return argument_escapes(all, parent, node);
    case IR_DECLARATOR:
        return holder_escapes(all, parent->variable, depth);
    case IR_ASSIGN:
        return parent->children[1] != node || parent->op != IR_OP_NONE ||
               ir_value_is_used(parent) || parent->children[0]->kind != IR_VARIABLE ||
               holder_escapes(all, parent->children[0]->variable, depth);
    case IR_EXPRESSION:
    case IR_IF:
    case IR_WHILE:
    case IR_DO:
    case IR_FOR:
        return false;
    default:
        return true;
    }
}

bool variable_escapes(variable_facts *facts, const ir_variable *variable) {
    variable_fact *fact = &facts->facts[variable->id];
    if (!variable_is_automatic(variable))
        return true;
    if (fact->escape == ESCAPE_NOT_ASKED) {
        fact->escape = ESCAPE_IN_PROGRESS;
        assert(facts->unit->variables[variable->id] == variable);
        bool escapes = false;
        for (unsigned i = 0; i < fact->occurrences.count && !escapes; i++)
            escapes = lvalue_escapes(facts, fact->occurrences.items[i], 0);
        fact->escape = escapes ? ESCAPE_YES : ESCAPE_NO;
    }
    return fact->escape != ESCAPE_NO;
}

static bool is_exposing(const ir_node *node) {
    const ir_node *parent = node->parent;
    bool is_array = node->type && node->type->kind == IR_ARRAY;
    if (!parent)
        return true;
    if (parent->kind == IR_MEMBER && (is_array || !(parent->flags & IR_ARROW)))
        return is_exposing(parent);
    if (parent->kind == IR_UNARY && parent->op == IR_OP_ADDRESS)
        return true;
    if (!is_array)
        return false;
    if ((parent->kind == IR_INDEX && parent->children[0] == node) ||
        (parent->kind == IR_UNARY && parent->op == IR_OP_DEREFERENCE))
        return is_exposing(parent);
    return true;
}

bool variable_is_exposed(variable_facts *facts, const ir_variable *variable) {
    variable_fact *fact = &facts->facts[variable->id];
    if (fact->exposure == EXPOSURE_NOT_ASKED) {
        bool is_exposed = variable->address_taken;
        for (unsigned i = 0; i < fact->occurrences.count && !is_exposed; i++)
            is_exposed = is_exposing(fact->occurrences.items[i]);
        fact->exposure = is_exposed ? EXPOSURE_YES : EXPOSURE_NO;
    }
    return fact->exposure == EXPOSURE_YES;
}

static bool is_restricted(variable_facts *facts, const ir_variable *variable) {
    const variable_fact *fact = &facts->facts[variable->id];
    unsigned allowed = variable->storage == IR_LOCAL ? 1 : 0;
    if (!variable_is_automatic(variable) || !variable->type->is_restrict ||
        variable->address_taken || fact->write_count > allowed)
        return false;
    /* A restrict pointer of a block is exclusive from its declaration on. If it is assigned later,
     * less is known, so such a pointer is not used. */
    if (allowed && (!fact->declarator || fact->definition_place != fact->declarator))
        return false;
    for (unsigned i = 0; i < fact->occurrences.count; i++)
        if (pointer_value_escapes(facts, fact->occurrences.items[i], 0))
            return false;
    return true;
}

bool variable_is_restricted(variable_facts *facts, const ir_variable *variable) {
    variable_fact *fact = &facts->facts[variable->id];
    if (fact->restricted == RESTRICTED_NOT_ASKED)
        fact->restricted = is_restricted(facts, variable) ? RESTRICTED_YES : RESTRICTED_NO;
    return fact->restricted == RESTRICTED_YES;
}
