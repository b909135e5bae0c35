/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Own elements in the executor. Each thread that executes an iteration keeps the value that an own
 * element has at the iteration's end. All of them keep the same value, by atomic stores. After the
 * loop the kept value is stored if its bits differ from the element's: then the sequential
 * iteration would have stored it, too. If the iteration stored nothing, or the same bits, memory is
 * not written.
 */
#include "emit/body/own.h"

#include <assert.h>

#include "emit/body/scalars.h"
#include "emit/text/origin.h"

const char *kept_own_type(const loop_text *loop, unsigned number) {
    assert(number < loop->facts->variables.own_count);
    return origin_type(loop->arena, loop->facts->variables.own[number].element->type);
}

const char *kept_own_name(loop_text *loop, unsigned number) {
    return arena_format(loop->arena, "redcc__kept_%u", number);
}

unsigned kept_own_number(const loop_text *loop, unsigned number) {
    assert(number < loop->facts->variables.own_count);
    return kept_operand_number(loop, loop->facts->scalar_count, false) + number;
}

void keep_own(loop_text *loop, writer *out) {
    for (unsigned i = 0; i < loop->facts->variables.own_count; i++)
        writer_line(out, "__atomic_store(&%s[redcc__k], &redcc__element_%u, __ATOMIC_RELAXED);",
                    kept_own_name(loop, i), i);
}

void store_own(loop_text *loop, writer *out) {
    const loop_facts *facts = loop->facts;
    if (facts->variables.own_count == 0)
        return;
    writer_line(out, "    redcc_int redcc__k;");
    writer_line(out, "    for (redcc__k = 0; redcc__k < %s; redcc__k++) {", loop_made(loop));
    writer_line(out, "        const %s %s = %s;", loop->counter_type,
                origin_declarator(loop->arena, facts->counted.counter), loop_counter_value(loop));
    for (unsigned i = 0; i < facts->variables.own_count; i++) {
        const char *element = loop_operand(loop, facts->variables.own[i].element);
        writer_line(out, "        REDCC_STORE_KEPT(%s, %s, redcc__operands[%u]);",
                    macro_argument(loop->arena, element), kept_own_type(loop, i),
                    kept_own_number(loop, i));
    }
    writer_line(out, "    }");
}
