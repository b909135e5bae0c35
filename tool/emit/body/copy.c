/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "emit/body/copy.h"

#include <assert.h>

#include "emit/base/forward.h"
#include "emit/base/names.h"
#include "emit/base/own.h"
#include "emit/base/wrapping.h"
#include "ir/ir_syntax.h"
#include "plan/lookup.h"
#include "plan/outline.h"

const char *local_name(const ir_node *node, void *context) {
    const loop_text *loop = context;
    const int array = loop_array_of_base(loop->facts, node);
    if (array >= 0)
        return loop->arrays[array].local;
    const char *name = own_name(loop, node);
    if (!name)
        name = forward_read_name(loop, node);
    return name ? name : pointed_name(loop, node);
}

const char *wrapping_name(const ir_node *node, void *context) {
    const char *name = local_name(node, context);
    arena *a = ((const loop_text *)context)->arena;
    return name ? name : wrapping_operation(a, node, wrapping_name, context);
}

static const char *line_ends(const loop_text *loop, uint32_t begin, uint32_t end) {
    const char *text = loop->unit->source->text;
    buffer out = {0};
    for (uint32_t i = begin; i < end; i++)
        if (text[i] == '\n')
            buffer_byte(&out, '\n');
    return buffer_take(loop->arena, &out);
}

void replace_bytes(body_copy *copy, uint32_t begin, uint32_t end, const char *text) {
    loop_text *loop = copy->loop;
    assert(begin <= end && end <= loop->unit->source->length);
    text = arena_format(loop->arena, "%s%s", text, line_ends(loop, begin, end));
    edit_replace(loop->arena, &copy->edits, begin, end, text);
}

bool is_printed(const body_copy *copy, const ir_node *node) {
    for (unsigned i = 0; i < copy->printed.count; i++)
        if (ir_contains(copy->printed.items[i], node))
            return true;
    return false;
}

/* The innermost statement around this one, or this one itself, whose bytes can be replaced; NULL if
 * not even those of the body can. */
static const ir_node *replaceable(const ir_node *statement, const ir_node *body) {
    const ir_node *whole = NULL;
    for (const ir_node *node = statement; node && !whole; node = node->parent) {
        whole = syntax_editable_statement(node, body);
        if (node == body)
            break;
    }
    return whole;
}

void print_instead(body_copy *copy, const ir_node *statement) {
    const ir_node *whole = replaceable(statement, copy->loop->facts->counted.body);
    if (!whole)
        loop_obstacle(copy->loop, statement->range,
                      "one macro call expands to the body's last statement and more");
    else if (!is_printed(copy, whole))
        VECTOR_PUSH(copy->loop->arena, &copy->printed, whole);
}
