/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Induction variables (analysis/private/induction.h): in iteration redcc__k such a variable starts
 * with its value on entry to the loop, redcc__from_N, plus redcc__k steps. If an inner loop of a
 * triangle (its trip count changes by one per outer iteration) steps the variable, there is one
 * step for each preceding inner iteration instead (redcc/tiles.h). The value is computed in 64-bit
 * words, which wrap around. Converted to the variable's type, it equals that of the sequential
 * loop.
 */
#include "emit/base/step.h"

#include <assert.h>

#include "emit/text/origin.h"

/** The step as an expression of type redcc_word (64 bits); for a pointer, in bytes. */
static const char *stride_text(loop_text *loop, const private_variable *item) {
    const ir_type *type = item->variable->type;
    const int64_t size = type->kind == IR_POINTER ? type->target->size : 1;
    const char *sum = arena_format(loop->arena, "(redcc_word)%lld", (long long)(item->step * size));
    for (unsigned i = 0; i < item->stride_count; i++) {
        const int64_t factor = item->strides[i].times * size;
        const char *value = loop_operand(loop, item->strides[i].value);
        const char sign = factor < 0 ? '-' : '+';
        sum = factor == 1 || factor == -1
                  ? arena_format(loop->arena, "%s %c (redcc_word)%s", sum, sign, value)
                  : arena_format(loop->arena, "%s %c %lld * (redcc_word)%s", sum, sign,
                                 (long long)(factor < 0 ? -factor : factor), value);
    }
    return item->stride_count ? arena_format(loop->arena, "(%s)", sum) : sum;
}

/** The number of inner iterations in the first outer iteration, as C; a negative number means
 * none. */
static const char *turns_text(loop_text *loop, const private_variable *item) {
    const triangle *turns = &item->inner;
    const char *end = loop_operand(loop, turns->end);
    const long long offset = (long long)turns->offset;
    return turns->is_below
               ? arena_format(loop->arena, "redcc__lower - (redcc_int)%s + %lld", end, offset)
               : arena_format(loop->arena, "(redcc_int)%s - redcc__lower + %lld", end, offset);
}

/** Returns the number of steps before `iteration`, as C text. `first`: the number of inner
 * iterations in the first outer iteration, as C text. */
static const char *count_text(loop_text *loop, const private_variable *item, const char *first,
                              const char *iteration) {
    if (!item->inner.loop)
        return arena_format(loop->arena, "(redcc_word)%s", iteration);
    return arena_format(loop->arena, "redcc_inner_trips_%s(%s, %s)",
                        item->inner.is_below ? "below" : "above", first, iteration);
}

/** The variable's type, spelled so that no undeclared name is needed. */
static const char *type_of(loop_text *loop, const private_variable *item) {
    return item->is_declared_in_header ? origin_type(loop->arena, item->variable->type)
                                       : arena_format(loop->arena, "__typeof__(%s)",
                                                      origin_variable(loop->arena, item->variable));
}

void declare_entry_values(loop_text *loop, writer *out, bool by_header) {
    for (unsigned i = 0; i < loop->facts->variables.private_count; i++) {
        const private_variable *item = &loop->facts->variables.privates[i];
        const char *name = origin_variable(loop->arena, item->variable);
        if (item->stride_count &&
            !by_header) /* inside the `if`: the loop iterates, so it evaluates the step */
            writer_line(out, "const redcc_word redcc__by_%u = %s;", i, stride_text(loop, item));
        if (item->inner.loop && !by_header)
            writer_line(out, "const redcc_int redcc__inner_trips_%u = %s;", i,
                        turns_text(loop, item));
        if (!item->is_stepped || by_header != (item->entry != NULL))
            continue;
        if (by_header)
            writer_line(out, "const redcc_word redcc__from_%u = (redcc_word)(%s)%s;", i,
                        type_of(loop, item), loop_operand(loop, item->entry));
        else
            writer_line(out, "const redcc_word redcc__from_%u = (redcc_word)%s;", i, name);
    }
}

const char *stepped_value(loop_text *loop, unsigned number) {
    assert(number < loop->facts->variables.private_count);
    const private_variable *item = &loop->facts->variables.privates[number];
    if (!item->is_stepped)
        return "";
    const char *stride = item->stride_count ? arena_format(loop->arena, "redcc__by_%u", number)
                                            : stride_text(loop, item);
    const char *turns = arena_format(loop->arena, "redcc__inner_trips_%u", number);
    return arena_format(loop->arena, " = (__typeof__(%s))(redcc__from_%u + %s * %s)",
                        origin_variable(loop->arena, item->variable), number, stride,
                        count_text(loop, item, turns, "redcc__k"));
}

const char *stepped_after(loop_text *loop, unsigned number) {
    const private_variable *item = &loop->facts->variables.privates[number];
    const char *from = item->entry ? arena_format(loop->arena, "redcc__from_%u", number)
                                   : arena_format(loop->arena, "(redcc_word)%s",
                                                  origin_variable(loop->arena, item->variable));
    return arena_format(
        loop->arena, "%s + %s * %s", from, stride_text(loop, item),
        count_text(loop, item, item->inner.loop ? turns_text(loop, item) : "", loop_made(loop)));
}

void write_stepped_values(loop_text *loop, writer *out) {
    for (unsigned i = 0; i < loop->facts->variables.private_count; i++) {
        const private_variable *item = &loop->facts->variables.privates[i];
        const bool is_wanted =
            item->is_step_wanted || (loop->continues && !item->is_declared_in_header);
        const char *name = origin_variable(loop->arena, item->variable);
        if (item->is_stepped && is_wanted)
            writer_line(out, "%s = (__typeof__(%s))(%s);", name, name, stepped_after(loop, i));
    }
}

static bool is_stepped(const loop_facts *facts, const ir_variable *variable) {
    for (unsigned i = 0; i < facts->variables.private_count; i++)
        if (facts->variables.privates[i].variable == variable)
            return facts->variables.privates[i].is_stepped;
    return false;
}

void write_starts(loop_text *loop, writer *out) {
    const counted_loop *counted = &loop->facts->counted;
    for (unsigned i = 0; i < counted->start_count; i++) {
        const loop_start *start = &counted->starts[i];
        if (!start->is_declared && !is_stepped(loop->facts, start->variable))
            writer_line(out, "%s = %s;", origin_variable(loop->arena, start->variable),
                        loop_operand(loop, start->value));
    }
}
