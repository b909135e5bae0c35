/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include <assert.h>
#include <string.h>

#include "analysis/base/external.h"
#include "analysis/base/library.h"
#include "analysis/memory/must_write/must_write_run.h"

enum { MOST_CALLS_DEEP = 32, MOST_ARGUMENTS = 64 };

/* ---- library functions whose accesses through pointers are known ---------------------------- */

typedef struct known_access {
    bool is_write;
    unsigned argument;
    int64_t size;           /* number of bytes accessed; 0 if an argument gives it */
    unsigned size_argument; /* if `size` is 0, the argument that gives the number of bytes */
} known_access;

typedef struct known_function {
    const char *name;
    unsigned access_count;
    known_access accesses[2];
    bool is_gnu; /* it belongs to the C library only if a system header declares it or its name
                  * begins with __ */
} known_function;

/* Functions of C17 7.12 and 7.24, and some of GNU and POSIX. None of them stores an address.
 * memcpy, memmove, memset and mempcpy return a pointer into their first argument. */
static const known_function known_functions[] = {
    {"memset", 1, {{true, 0, 0, 2}}, false},
    {"memcpy", 2, {{false, 1, 0, 2}, {true, 0, 0, 2}}, false},
    {"memmove", 2, {{false, 1, 0, 2}, {true, 0, 0, 2}}, false},
    {"mempcpy", 2, {{false, 1, 0, 2}, {true, 0, 0, 2}}, true},
    {"memcmp", 2, {{false, 0, 0, 2}, {false, 1, 0, 2}}, false},
    {"bzero", 1, {{true, 0, 0, 1}}, true},
    {"sincos", 2, {{true, 1, 8, 0}, {true, 2, 8, 0}}, true},
    {"sincosf", 2, {{true, 1, 4, 0}, {true, 2, 4, 0}}, true},
    {"frexp", 1, {{true, 1, 4, 0}}, false},
    {"frexpf", 1, {{true, 1, 4, 0}}, false},
    {"modf", 1, {{true, 1, 8, 0}}, false},
    {"modff", 1, {{true, 1, 4, 0}}, false},
    {"remquo", 1, {{true, 2, 4, 0}}, false},
    {"remquof", 1, {{true, 2, 4, 0}}, false},
};

/* Does the function belong to the C library? C reserves these names; a name of GNU or POSIX must
 * begin with __ or be declared by a system header. */
static bool is_of_library(const ir_function *function, const known_function *known) {
    return !known->is_gnu || function->is_from_system || strncmp(function->name, "__", 2) == 0;
}

static const known_function *find_known(const ir_function *function) {
    if (function->body != NULL || function->linkage.is_static || function->linkage.is_renamed)
        return NULL;
    char name[LIBRARY_NAME_SIZE];
    if (!library_plain_name(function->name, name))
        return NULL;
    for (size_t i = 0; i < sizeof known_functions / sizeof known_functions[0]; i++)
        if (strcmp(name, known_functions[i].name) == 0)
            return is_of_library(function, &known_functions[i]) ? &known_functions[i] : NULL;
    return NULL;
}

static bool is_pure(const must_write *prover, const ir_function *function) {
    if (function->is_attribute_pure || function->is_attribute_const ||
        external_kind(prover->options, function) != EXPORTED_NOTHING)
        return true;
    for (unsigned i = 0; prover->options != NULL && i < prover->options->pure_count; i++)
        if (strcmp(prover->options->pure[i], function->name) == 0)
            return true;
    return false;
}

static void access_known(run *r, state *s, const ir_node *node, const known_access *access,
                         const value *arguments, unsigned count) {
    const value pointer = arguments[access->argument];
    int64_t size = access->size;
    bool is_exact = pointer.is_exact;
    if (pointer.kind != VALUE_POINTER)
        return;
    if (size == 0) {
        const value length =
            access->size_argument < count ? arguments[access->size_argument] : value_other;
        is_exact = is_exact && length.kind == VALUE_INTEGER && length.number >= 0;
        size = length.number;
    }
    if (!is_exact)
        size = 0;
    const int64_t begin = is_exact ? pointer.number : 0;
    if (!is_exact && r->is_open) {
        run_give_up(r, node, "its elements are reached by subscripts that are not constant");
        return;
    }
    if (begin < 0 || begin > r->size || size > r->size - begin) {
        run_give_up(r, node, "it is accessed outside its bounds");
        return;
    }
    const int64_t end = is_exact ? begin + size : r->size;
    if (access->is_write)
        run_write(r, s, node, begin, end, is_exact);
    else
        run_read(r, s, node, begin, end);
}

static value call_known(run *r, state *s, const ir_node *node, const known_function *known,
                        const value *arguments, unsigned count) {
    value result = value_other;
    for (unsigned i = 0; i < known->access_count; i++) {
        if (known->accesses[i].argument >= count)
            return run_give_up(r, node, "a library function is called with too few arguments");
        access_known(r, s, node, &known->accesses[i], arguments, count);
    }
    if (node->type->kind == IR_POINTER) {
        result = arguments[0];
        result.is_exact = result.is_exact && strstr(known->name, "mempcpy") == NULL;
        result.number = result.is_exact ? result.number : 0;
    }
    return result;
}

/* ---- summaries ----------------------------------------------------------------------------- */

static bool same_arguments(const value *a, const value *b, unsigned count) {
    for (unsigned i = 0; i < count; i++)
        if (!value_equal(a[i], b[i]))
            return false;
    return true;
}

static call_summary *find_summary(must_write *prover, const ir_function *function, int64_t size,
                                  bool is_open, unsigned count, const value *arguments) {
    call_summary *summary = prover->summaries[function->id % SUMMARY_LISTS];
    for (; summary != NULL; summary = summary->next)
        if (summary->function == function && summary->object_size == size &&
            summary->is_open == is_open && summary->argument_count == count &&
            same_arguments(summary->arguments, arguments, count))
            return summary;
    return NULL;
}

/* Why the function's body cannot be interpreted with these arguments; NULL if it can. */
static const char *find_obstacle(const ir_function *function, unsigned count,
                                 const value *arguments, unsigned depth) {
    if (function->body == NULL || function->linkage.is_weak)
        return "it is passed to a function whose body is not known";
    if (function->has_errors)
        return "it is passed to a function that has errors";
    if (function->is_variadic || count != function->parameter_count)
        return "it is passed to a function without a plain list of parameters";
    if (depth > MOST_CALLS_DEEP)
        return "it is passed through too many calls";
    for (unsigned i = 0; i < count; i++) {
        const ir_variable *parameter = function->parameters[i];
        const ir_type *type = parameter->type;
        if (arguments[i].kind == VALUE_POINTER && (type->kind != IR_POINTER || type->is_volatile ||
                                                   type->is_atomic || parameter->address_taken))
            return "a parameter that points to it is not a plain pointer";
        for (const ir_type *t = type; t != NULL; t = t->target)
            if (t->kind == IR_ARRAY && t->count < 0)
                return "the size of a type may depend on it";
    }
    return NULL;
}

static void interpret_callee(must_write *prover, call_summary *summary, unsigned depth) {
    const ir_function *function = summary->function;
    run r = {.prover = prover,
             .function = function,
             .size = summary->object_size,
             .is_open = summary->is_open,
             .depth = depth,
             .read = byte_set_new(prover->arena, summary->object_size),
             .touched = byte_set_new(prover->arena, summary->object_size),
             .on_return = {.is_reachable = false}};
    state s = state_new(prover->scratch, summary->object_size);
    for (unsigned i = 0; i < summary->argument_count; i++) {
        const ir_variable *parameter = function->parameters[i];
        if (summary->arguments[i].kind == VALUE_POINTER ||
            (parameter->type->kind == IR_INTEGER && !parameter->address_taken))
            state_set(prover->scratch, &s, parameter, summary->arguments[i]);
    }
    run_execute(&r, &s, function->body);
    state_join(prover->scratch, &s, &r.on_return);
    summary->unknown = r.unknown;
    summary->read = r.read;
    summary->touched = r.touched;
    summary->written = byte_set_new(prover->arena, summary->object_size);
    if (s.is_reachable)
        byte_set_assign(summary->written, s.written);
    summary->result = r.has_result ? r.result : value_other;
}

const call_summary *summarise_call(must_write *prover, const ir_function *function, int64_t size,
                                   bool is_open, unsigned count, const value *arguments,
                                   unsigned depth) {
    call_summary *summary = find_summary(prover, function, size, is_open, count, arguments);
    assert(count <= MOST_ARGUMENTS && function);
    if (summary == NULL) {
        const char *obstacle = find_obstacle(function, count, arguments, depth);
        summary = ARENA_NEW(prover->arena, call_summary);
        summary->function = function;
        summary->object_size = size;
        summary->is_open = is_open;
        summary->argument_count = count;
        value *kept = ARENA_ARRAY(prover->arena, value, count + 1);
        memcpy(kept, arguments, count * sizeof *arguments);
        summary->arguments = kept;
        summary->unknown = obstacle;
        summary->result = value_other;
        summary->next = prover->summaries[function->id % SUMMARY_LISTS];
        prover->summaries[function->id % SUMMARY_LISTS] = summary;
        if (obstacle != NULL)
            return summary;
        summary->unknown = "it is passed to a function that calls itself";
        interpret_callee(prover, summary, depth);
    }
    return summary;
}

/* ---- calls --------------------------------------------------------------------------------- */

static const ir_function *called_function(const ir_node *node) {
    const ir_node *callee = node->children[0];
    while (callee->kind == IR_UNARY &&
           (callee->op == IR_OP_DEREFERENCE || callee->op == IR_OP_ADDRESS))
        callee = callee->children[0];
    return callee->kind == IR_FUNCTION ? callee->function : NULL;
}

/* Returns the value that the parameter gets from an argument with the value `v`. Returns
 * value_other for an integer that the conversion to the parameter's type may change. */
static value as_parameter(const ir_function *function, unsigned index, value v) {
    if (v.kind != VALUE_INTEGER)
        return v;
    if (index >= function->parameter_count)
        return value_other;
    const ir_type *type = function->parameters[index]->type;
    const int64_t limit = INT64_C(1) << (type->size == 1 ? 7 : type->size == 2 ? 15 : 31);
    if (type->kind != IR_INTEGER || v.number >= limit || v.number < (type->is_signed ? -limit : 0))
        return value_other;
    return v;
}

static value call_summarised(run *r, state *s, const ir_node *node, const ir_function *function,
                             const value *arguments, unsigned count) {
    const call_summary *summary =
        summarise_call(r->prover, function, r->size, r->is_open, count, arguments, r->depth + 1);
    if (summary->unknown != NULL)
        return run_give_up(r, node, summary->unknown);
    if (!run_step(r, node, 4 * (1 + summary->read.word_count)))
        return value_other;
    run_read_set(r, s, node, byte_set_copy(r->prover->scratch, summary->read));
    byte_set_unite(r->touched, summary->touched);
    byte_set_unite(s->written, summary->written);
    return summary->result;
}

/* Evaluates the function and the arguments. C does not fix their order, so reads in each rely only
 * on bytes written before all of them. Returns whether an argument may point into the object. */
static bool evaluate_arguments(run *r, state *s, const ir_node *node, value *arguments) {
    const unsigned count = node->child_count - 1;
    bool is_passed = false;
    byte_set before = byte_set_copy(r->prover->scratch, s->written);
    byte_set all = byte_set_copy(r->prover->scratch, s->written);
    for (unsigned i = 0; i <= count && run_step(r, node, 4 * state_weight(s)); i++) {
        const value v = run_evaluate(r, s, node->children[i]);
        byte_set_unite(all, s->written);
        byte_set_assign(s->written, before);
        if (i > 0) {
            arguments[i - 1] = v;
            is_passed = is_passed || v.kind == VALUE_POINTER;
        }
    }
    byte_set_assign(s->written, all);
    return is_passed;
}

value run_call(run *r, state *s, const ir_node *node) {
    assert(node->kind == IR_CALL);
    const unsigned count = node->child_count - 1;
    const ir_function *function = called_function(node);
    value arguments[MOST_ARGUMENTS];
    if (count > MOST_ARGUMENTS)
        return run_give_up(r, node, "a call has too many arguments");
    if (!evaluate_arguments(r, s, node, arguments) || r->unknown != NULL)
        return value_other; /* without a pointer argument, the callee cannot reach the object,
                             * whose address is not stored */
    if (function == NULL)
        return run_give_up(r, node, "it is passed to a function that is not known");
    const known_function *known = find_known(function);
    if (known != NULL)
        return call_known(r, s, node, known, arguments, count);
    if (function->body == NULL && is_pure(r->prover, function)) {
        const value anywhere = {VALUE_POINTER, false, 0};
        if (r->is_open)
            return run_give_up(r, node, "it is passed to a function whose body is not known");
        run_read(r, s, node, 0, r->size);
        return ir_is_expression(node) && node->type->kind == IR_POINTER ? anywhere : value_other;
    }
    for (unsigned i = 0; i < count; i++)
        arguments[i] = as_parameter(function, i, arguments[i]);
    return call_summarised(r, s, node, function, arguments, count);
}

bool call_keeps_address(must_write *prover, const ir_node *call, unsigned argument, int64_t size) {
    assert(call->kind == IR_CALL);
    const ir_function *function = called_function(call);
    const unsigned count = call->child_count - 1;
    value arguments[MOST_ARGUMENTS] = {{VALUE_OTHER, false, 0}};
    if (function == NULL || count > MOST_ARGUMENTS)
        return true;
    if (find_known(function) != NULL || (function->body == NULL && is_pure(prover, function)))
        return call->type->kind == IR_POINTER && ir_value_is_used(call);
    arguments[argument].kind = VALUE_POINTER;
    const call_summary *summary =
        summarise_call(prover, function, size, false, count, arguments, 1);
    return summary->unknown != NULL ||
           (summary->result.kind == VALUE_POINTER && ir_value_is_used(call));
}
