/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Store forwarding: if an iteration stores a value into an element and reads it again, the value
 * goes through a variable, redcc__forward_N, of the element's type. Each thread that executes the
 * iteration computes the value; only the owner of the element stores it in memory.
 */
#include "emit/base/forward.h"

#include <assert.h>

#include "emit/text/origin.h"
#include "ir/ir_syntax.h"

static unsigned number_of(const loop_facts *facts, const forwarded_store *store) {
    assert(store >= facts->forwards && store < facts->forwards + facts->forward_count);
    return (unsigned)(store - facts->forwards);
}

const char *forward_read_name(const loop_text *loop, const ir_node *node) {
    const loop_facts *facts = loop->facts;
    for (unsigned i = 0; i < facts->forward_count; i++)
        if (node != facts->forwards[i].target && syntax_same(node, facts->forwards[i].target))
            return origin_value(loop->arena, node->type,
                                arena_format(loop->arena, "redcc__forward_%u", i));
    return NULL;
}

void declare_forwards(loop_text *loop, writer *out, bool of_slice) {
    const loop_facts *facts = loop->facts;
    for (unsigned i = 0; i < facts->forward_count; i++) {
        const forwarded_store *store = &facts->forwards[i];
        if (!of_slice || facts->slice.holds[store->statement->id])
            writer_line(out, "%s redcc__forward_%u;", origin_type(loop->arena, store->target->type),
                        i);
    }
}

static const char *spelled(loop_text *loop, const ir_node *node, ir_c_rename rename,
                           void *context) {
    const char *text = text_expression(loop->arena, node, rename, context);
    if (!text)
        loop_obstacle(loop, node->range, "a stored value cannot be spelled a second time");
    return text ? text : "0";
}

void write_forward(loop_text *loop, writer *out, const forwarded_store *store, ir_c_rename rename,
                   void *context) {
    writer_line(out, "redcc__forward_%u = %s;", number_of(loop->facts, store),
                spelled(loop, store->value, rename, context));
}

void write_forwarded_store(loop_text *loop, writer *out, const forwarded_store *store,
                           ir_c_rename rename, void *context) {
    writer_line(out, "%s = redcc__forward_%u;", spelled(loop, store->target, rename, context),
                number_of(loop->facts, store));
}
