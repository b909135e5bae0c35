/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "emit/base/own.h"

#include "emit/text/origin.h"
#include "plan/lookup.h"

const char *own_name(const loop_text *loop, const ir_node *node) {
    const int number = own_element_at(loop->facts, node);
    return number < 0 ? NULL
                      : origin_value(loop->arena, node->type,
                                     arena_format(loop->arena, "redcc__element_%d", number));
}

void declare_own(loop_text *loop, writer *out, bool of_slice, ir_c_rename rename, void *context) {
    for (unsigned i = 0; i < loop->facts->variables.own_count; i++) {
        const own_element *own = &loop->facts->variables.own[i];
        if (of_slice && !own->is_in_slice)
            continue;
        const char *text = own->is_stored_first
                               ? "0"
                               : text_expression(loop->arena, own->element, rename, context);
        if (!text)
            loop_obstacle(loop, own->element->range, "an element cannot be spelled a second time");
        writer_line(out, "%s redcc__element_%u = %s;", origin_type(loop->arena, own->element->type),
                    i, text ? text : "0");
    }
}
