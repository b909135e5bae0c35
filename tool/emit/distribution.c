/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "emit/distribution.h"

#include "emit/text/origin.h"

static const char *spelled(loop_text *loop, const ir_node *expression) {
    const char *text = text_expression(loop->arena, expression, NULL, NULL);
    if (!text)
        loop_obstacle(loop, expression->range,
                      "an expression of the loop cannot be written as C outside of it");
    return text ? text : "0";
}

void write_distributed_stores(loop_text *loop, writer *out) {
    const distribution *stores = loop->facts->distribution;
    if (!stores)
        return;
    writer_line(out, "/* stores that the body leaves out */");
    writer_line(out, "for (redcc_int redcc__k = 0; redcc__done && redcc__k < redcc__trip; "
                     "redcc__k++) {");
    writer_line(out, "    const %s %s = %s;", loop->counter_type,
                origin_declarator(loop->arena, loop->facts->counted.counter),
                loop_counter_value(loop));
    for (unsigned i = 0; i < stores->count; i++) {
        const ir_node *condition = stores->stores[i].condition;
        const bool begins = condition && (i == 0 || stores->stores[i - 1].condition != condition);
        const bool ends =
            condition && (i + 1 == stores->count || stores->stores[i + 1].condition != condition);
        if (begins)
            writer_line(out, "    if (%s) {", spelled(loop, condition));
        writer_line(out, "    %s;", spelled(loop, stores->stores[i].assignment));
        if (ends)
            writer_line(out, "    }");
    }
    writer_line(out, "}");
}
