/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Private variables that each iteration moves by a constant (analysis/induction.h): the copy of
 * iteration redcc__k begins with the value on entry, redcc__from_N, and redcc__k steps. Words of 64
 * bits wrap around, and give after conversion what the sequential loop has.
 */
#include "emit/loop.h"

#include "emit/origin.h"
#include <assert.h>

void declare_entry_values(loop_text *loop, writer *out, bool by_header) {
    for (unsigned i = 0; i < loop->facts->private_count; i++) {
        const private_variable *item = &loop->facts->privates[i];
        const char *name = origin_variable(loop->arena, item->variable);
        if (!item->is_stepped || by_header != (item->entry != NULL))
            continue;
        if (by_header)
            writer_line(out, "const redcc_word redcc__from_%u = (redcc_word)(__typeof__(%s))%s;", i,
                        name, loop_operand(loop, item->entry));
        else
            writer_line(out, "const redcc_word redcc__from_%u = (redcc_word)%s;", i, name);
    }
}

const char *stepped_value(loop_text *loop, unsigned number) {
    assert(number < loop->facts->private_count);
    const private_variable *item = &loop->facts->privates[number];
    if (!item->is_stepped)
        return "";
    return arena_format(
        loop->arena,
        " = (__typeof__(%s))(redcc__from_%u + (redcc_word)%lld * (redcc_word)redcc__k)",
        origin_variable(loop->arena, item->variable), number, (long long)item->step);
}

void write_stepped_values(loop_text *loop, writer *out) {
    for (unsigned i = 0; i < loop->facts->private_count; i++) {
        const private_variable *item = &loop->facts->privates[i];
        const char *name = origin_variable(loop->arena, item->variable);
        const char *from = item->entry ? arena_format(loop->arena, "redcc__from_%u", i)
                                       : arena_format(loop->arena, "(redcc_word)%s", name);
        if (item->is_stepped && item->is_step_wanted)
            writer_line(out,
                        "%s = (__typeof__(%s))(%s + (redcc_word)%lld * (redcc_word)redcc__trip);",
                        name, name, from, (long long)item->step);
    }
}
