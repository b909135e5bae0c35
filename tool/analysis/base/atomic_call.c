/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/base/atomic_call.h"

#include <string.h>

static bool begins(const char *text, const char *with) {
    return strncmp(text, with, strlen(with)) == 0;
}

bool atomic_is_name(const char *name) {
    static const char *const others[] = {"__sync_synchronize",        "__atomic_load",
                                         "__atomic_thread_fence",     "__atomic_signal_fence",
                                         "__atomic_always_lock_free", "__atomic_is_lock_free"};
    for (unsigned i = 0; i < sizeof others / sizeof *others; i++)
        if (begins(name, others[i]))
            return false;
    return begins(name, "__sync_") || begins(name, "__atomic_");
}

static const ir_function *callee_of(const ir_node *node) {
    return node->kind == IR_CALL && node->children[0]->kind == IR_FUNCTION
               ? node->children[0]->function
               : NULL;
}

/* The text that names the operation; NULL if the node itself is none. The frontend has calls of
 * __sync_..., and __atomic_... as opaque nodes. */
static const char *operation_of(const ir_node *node) {
    const ir_function *function = callee_of(node);
    const char *text = function ? function->name : node->kind == IR_OPAQUE ? node->text : NULL;
    return text && atomic_is_name(text) ? text : NULL;
}

static const char *operation_in(const ir_node *node) {
    const char *found = operation_of(node);
    for (unsigned i = 0; i < node->child_count && !found; i++)
        found = operation_in(node->children[i]);
    return found;
}

const char *atomic_name(arena *a, const ir_node *node) {
    const ir_function *function = callee_of(node);
    const char *text = operation_of(node);
    if (!text && function && function->body)
        text = operation_in(function->body);
    if (!text)
        return NULL;
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
