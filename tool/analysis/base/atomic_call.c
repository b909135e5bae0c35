/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/base/atomic_call.h"

#include <string.h>

#include "analysis/base/expression.h"

static bool begins(const char *text, const char *with) {
    return strncmp(text, with, strlen(with)) == 0;
}

static bool is_builtin_name(const char *name) {
    static const char *const others[] = {"__sync_synchronize",    "__sync_lock_release",
                                         "__atomic_load",         "__atomic_store",
                                         "__atomic_clear",        "__atomic_thread_fence",
                                         "__atomic_signal_fence", "__atomic_always_lock_free",
                                         "__atomic_is_lock_free"};
    for (unsigned i = 0; i < sizeof others / sizeof *others; i++)
        if (begins(name, others[i]))
            return false;
    return begins(name, "__sync_") || begins(name, "__atomic_");
}

/* Is it the name of an operation of <stdatomic.h> that changes memory and returns a value? */
static bool is_standard_name(const char *name) {
    return begins(name, "atomic_fetch_") || begins(name, "atomic_exchange") ||
           begins(name, "atomic_compare_exchange_") || begins(name, "atomic_flag_test_and_set");
}

static bool is_store_name(const char *name) {
    return begins(name, "__atomic_store") || begins(name, "atomic_store");
}

#define FOR_THREADS                                                                                \
    "; where OpenMP's threads share the loop, under #pragma omp atomic in the loop's own text"

const char *atomic_advice(const char *name) {
    if (is_builtin_name(name) || begins(name, "__atomic_store"))
        return "it updates memory atomically: write the update itself, such as *x += v" FOR_THREADS;
    if (is_standard_name(name) || begins(name, "atomic_store"))
        return "it updates memory atomically: declare this memory without _Atomic, and write the "
               "update itself, such as *x += v" FOR_THREADS;
    return NULL;
}

static bool is_number(const ir_node *node) {
    return node->kind == IR_NUMBER && node->type && node->type->kind == IR_INTEGER;
}

static bool is_pointer_to_atomic(const ir_node *node) {
    return ir_is_pointer(node) && node->type->target && node->type->target->is_atomic;
}

/* Has the opaque node the operands of an atomic operation that returns a value: a pointer, the
 * memory order, and one to three values? A macro hides the operation's name. */
static bool has_operands(const ir_node *node) {
    return node->child_count >= 3 && ir_is_pointer(node->children[0]) && node->type &&
           ir_type_is_scalar(node->type) &&
           (is_pointer_to_atomic(node->children[0]) || is_number(node->children[1]));
}

/* Does the store depend on the memory that it changes? */
static bool stores_what_it_reads(arena *a, const ir_node *node) {
    const ir_node *target = atomic_pointee(a, node, 0);
    return target && expression_occurrences(node, target) > 1;
}

/* The text that the node's range has in the main file; NULL if it is empty. */
static const char *written_at(const ir_unit *unit, const ir_node *node) {
    const source *s = unit->source;
    return s && node->range.begin < node->range.end && node->range.end <= s->length
               ? s->text + node->range.begin
               : NULL;
}

/* In the IR, calls of __sync_... and __atomic_... are calls, or opaque nodes with the call's text.
 * Operations of <stdatomic.h> are macros, so their opaque nodes have no text. */
const char *atomic_name(arena *a, const ir_unit *unit, const ir_node *node) {
    const ir_function *function = node->kind == IR_CALL ? ir_called_function(node) : NULL;
    const char *text = function ? function->name : node->kind == IR_OPAQUE ? node->text : NULL;
    const bool is_of_macro = node->kind == IR_OPAQUE && node->flags & IR_FROM_MACRO;
    const char *written = is_of_macro ? written_at(unit, node) : NULL;
    if (written &&
        (is_standard_name(written) || is_store_name(written) || is_builtin_name(written)))
        text = written;
    if (!text || !(is_builtin_name(text) || is_standard_name(text) ||
                   (is_store_name(text) && stores_what_it_reads(a, node)))) {
        if (!is_of_macro || !has_operands(node))
            return NULL;
        return is_pointer_to_atomic(node->children[0]) ? "atomic_fetch_..." : "__atomic_fetch_...";
    }
    size_t length = strspn(text, "_abcdefghijklmnopqrstuvwxyz");
    while (text[length - 1] == '_') /* the number of bytes follows */
        length--;
    return arena_copy(a, text, length);
}

const ir_node *atomic_pointee(arena *a, const ir_node *node, unsigned number) {
    const unsigned first = node->kind == IR_CALL;
    if (first + number >= node->child_count)
        return NULL;
    const ir_node *pointer = node->children[first + number];
    while (pointer->kind == IR_CAST)
        pointer = pointer->children[0];
    if (pointer->kind == IR_UNARY && pointer->op == IR_OP_ADDRESS)
        return pointer->children[0];
    if (!ir_is_pointer(pointer) && !ir_is_array(pointer))
        return NULL;
    ir_node *whole = ir_new(a, IR_UNARY, NULL, 1);
    whole->op = IR_OP_DEREFERENCE;
    whole->children[0] = (ir_node *)pointer;
    whole->range = pointer->range;
    return whole;
}
