/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Where things lie that the loop reads, as far as that is known before the inspection. */
#include "emit/loop.h"
#include "emit/origin.h"

bool has_affine_extents(const loop_text *loop) {
    for (unsigned i = 0; i < loop->source_count; i++)
        if (loop->sources[i].fact->extent == EXTENT_AFFINE)
            return true;
    return false;
}

static bool is_address(const ir_type *type) {
    return type->kind == IR_POINTER || type->kind == IR_ARRAY;
}

static void fill_fixed_extents(loop_text *loop, writer *out) {
    for (unsigned i = 0; i < loop->source_count; i++) {
        const loop_source *fact = loop->sources[i].fact;
        if (fact->extent == EXTENT_INVARIANT) {
            const char *row = loop_operand(loop, fact->row);
            writer_line(out, "redcc__known[%u].first = (const char *)&%s;", i, row);
            writer_line(out, "redcc__known[%u].end = redcc__known[%u].first + sizeof(%s);", i, i,
                        row);
        } else if (fact->extent == EXTENT_TOUCHED && fact->base &&
                   can_be_read_ahead(loop->facts, fact->base)) {
            writer_line(out, "redcc__known[%u].first = (const char *)%s%s;", i,
                        is_address(fact->base->type) ? "" : "&", loop_operand(loop, fact->base));
        } else if (fact->extent == EXTENT_TOUCHED && !fact->base) {
            /* moves with nothing, as this object does not */
            writer_line(out, "redcc__known[%u].first = (const char *)&redcc__loop;", i);
        }
    }
}

/** From the row of the first iteration to the row of the last, whichever comes first in memory. */
static void fill_affine_extents(loop_text *loop, writer *out) {
    if (!has_affine_extents(loop))
        return;
    const counted_loop *counted = &loop->facts->counted;
    const char *counter = origin_variable(loop->arena, counted->counter);
    writer_line(out, "{ /* rows of the first and of the last iteration */");
    out->depth++;
    writer_line(out, "%s %s = (%s)redcc__lower;", loop->counter_type,
                origin_declarator(loop->arena, counted->counter), loop->counter_type);
    for (unsigned i = 0; i < loop->source_count; i++)
        if (loop->sources[i].fact->extent == EXTENT_AFFINE)
            writer_line(out, "redcc__known[%u].first = (const char *)&%s;", i,
                        loop_operand(loop, loop->sources[i].fact->row));
    writer_line(out, "%s = (%s)(redcc__final - %s%lld%s);", counter, loop->counter_type,
                counted->step < 0 ? "(" : "", (long long)counted->step,
                counted->step < 0 ? ")" : "");
    for (unsigned i = 0; i < loop->source_count; i++) {
        if (loop->sources[i].fact->extent != EXTENT_AFFINE)
            continue;
        const char *row = loop_operand(loop, loop->sources[i].fact->row);
        writer_line(out, "redcc__known[%u].end = (const char *)&%s;", i, row);
        writer_line(out, "if (redcc__known[%u].end < redcc__known[%u].first) {", i, i);
        writer_line(out, "    const char *const redcc__low = redcc__known[%u].end;", i);
        writer_line(out, "    redcc__known[%u].end = redcc__known[%u].first;", i, i);
        writer_line(out, "    redcc__known[%u].first = redcc__low;", i);
        writer_line(out, "}");
        writer_line(out, "redcc__known[%u].end += sizeof(%s);", i, row);
    }
    out->depth--;
    writer_line(out, "}");
}

void declare_extents(loop_text *loop, writer *out) {
    if (loop->source_count == 0)
        return;
    buffer zeros = {0};
    for (unsigned i = 0; i < loop->source_count; i++)
        buffer_text(&zeros, i > 0 ? ", {0, 0}" : "{0, 0}");
    writer_line(out, "redcc_extent redcc__known[%u] = {%s};", loop->source_count, zeros.data);
    buffer_free(&zeros);
}

void fill_extents(loop_text *loop, writer *out) {
    fill_fixed_extents(loop, out);
    fill_affine_extents(loop, out);
}
