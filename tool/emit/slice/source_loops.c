/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The inspector's copies of loops of called functions, in which their reads are logged:
 *  `for (; redcc__each_0 < 4; redcc__each_0++)`. */
#include "analysis/base/expression.h"

#include "emit/slice/slice.h"
#include "ir/ir_words.h"
#include <assert.h>

const char *source_loop_counter(arena *a, unsigned depth) {
    return arena_format(a, "redcc__each_%u", depth);
}

/** Does the row, or the header of a nested loop, depend on this loop's counter? */
static bool is_counter_needed(const loop_source *read, unsigned depth) {
    const ir_variable *counter = read->loops[depth].counter;
    for (unsigned i = depth + 1; i < read->loop_count; i++)
        if (expression_mentions(read->loops[i].lower, counter) ||
            expression_mentions(read->loops[i].bound, counter))
            return true;
    return expression_mentions(read->row, counter);
}

const char *source_loop_header(arena *a, const loop_source *read, unsigned depth,
                               const char *counter, const char *bound, bool is_span) {
    assert(depth < read->loop_count);
    const source_loop *loop = &read->loops[depth];
    const char *condition =
        arena_format(a, "%s %s %s", counter, ir_operator_spelling(loop->comparison), bound);
    if (is_span || !is_counter_needed(read, depth))
        return arena_format(a, "if (%s)", condition);
    if (loop->step == 1 || loop->step == -1)
        return arena_format(a, "for (; %s; %s%s)", condition, counter,
                            loop->step == 1 ? "++" : "--");
    return arena_format(a, "for (; %s; %s = (__typeof__(%s))(%s + %lld))", condition, counter,
                        counter, counter, (long long)loop->step);
}
