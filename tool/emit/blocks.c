/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "emit/blocks.h"

#include <string.h>

#include "analysis/base/loop_text.h"
#include "analysis/base/openmp_loop.h"
#include "emit/as_compiled.h"
#include "emit/block_ranges.h"
#include "emit/macro_names.h"
#include "emit/team_parts.h"
#include "emit/text/layout.h"
#include "emit/text/origin.h"
#include "ir/ir_position.h"
#include "ir/ir_syntax.h"

enum {
    MOST_BLOCKS = 256, /* so the shares of 7 or 12 threads differ by a few percent only */
    MOST_BLOCKS_UNBALANCED = 1024 /* for iterations of unequal length */
};

static const fixed_blocks *blocks_of(const loop_text *loop) {
    return loop->facts->variables.blocks;
}

/** The scalar's name without a mark (origin.h), for directives. The self-check (self_check.h)
 * cannot compare names in directives, because the parser does not report them. */
static const char *name_of(const loop_text *loop, unsigned scalar) {
    return blocks_of(loop)->scalars[scalar].variable->name;
}

static const char *value_of(const loop_text *loop, unsigned scalar) {
    return origin_variable(loop->arena, blocks_of(loop)->scalars[scalar].variable);
}

/* ---- the clause's operator ------------------------------------------------------------------- */

static bool is_operator(const blocked_scalar *scalar, const char *text) {
    return strcmp(scalar->operator, text) == 0;
}

/** The greatest or least value of the type (OpenMP 4.5, table 2.7). */
static const char *extreme_value(arena *a, const ir_type *type, bool is_greatest) {
    if (type->kind == IR_FLOATING)
        return arena_format(a, "%sREDCC_GREATEST(%s)", is_greatest ? "" : "-",
                            type->size == 4   ? "FLT"
                            : type->size == 8 ? "DBL"
                                              : "LDBL");
    if (type->kind == IR_BOOLEAN || !type->is_signed)
        return is_greatest ? type->kind == IR_BOOLEAN ? "1" : "-1" : "0";
    const unsigned long long greatest = ~0ull >> (65 - 8 * type->size);
    return is_greatest ? arena_format(a, "%lluLL", greatest)
                       : arena_format(a, "-%lluLL - 1", greatest);
}

static const char *neutral_value(arena *a, const blocked_scalar *scalar) {
    const ir_type *type = scalar->variable->type;
    if (is_operator(scalar, "min") || is_operator(scalar, "max"))
        return extreme_value(a, type, is_operator(scalar, "min"));
    if (is_operator(scalar, "&"))
        return type->kind == IR_BOOLEAN ? "1" : "-1";
    return is_operator(scalar, "*") || is_operator(scalar, "&&") ? "1" : "0";
}

/** The expression that combines `sum` with a block's partial result. */
static const char *combination(arena *a, const blocked_scalar *scalar, const char *sum,
                               const char *part) {
    if (is_operator(scalar, "min") || is_operator(scalar, "max"))
        return arena_format(a, "%s %c %s ? %s : %s", part, is_operator(scalar, "min") ? '<' : '>',
                            sum, part, sum);
    return arena_format(a, "%s %s %s", sum, is_operator(scalar, "-") ? "+" : scalar->operator,
                        part);
}

/* ---- before the loop ------------------------------------------------------------------------- */

/** Writes the loop's description, from which the runtime reads only the required order of
 * results. */
static void write_site(loop_text *loop, writer *out) {
    const ir_position place = ir_position_of(loop->unit, loop->facts->loop->range.begin);
    writer_line(out, "static redcc_site redcc__site = {");
    writer_line(out, "    {{__FILE__, %u, %s, REDCC_ORDER_FIXED, 0, 0, 0, 0, 0, 0, 0}, 0, 0}, 0",
                place.line, text_quoted(loop->arena, loop->facts->function->name));
    writer_line(out, "};");
}

/** Is the loop executed by the team of an enclosing parallel region? */
static bool is_of_team(const loop_text *loop) {
    return blocks_of(loop)->directive.construct == OPENMP_FOR;
}

static int most_blocks(const loop_text *loop) {
    return blocks_of(loop)->is_balanced ? MOST_BLOCKS : MOST_BLOCKS_UNBALANCED;
}

static void write_parts(loop_text *loop, writer *out) {
    if (is_of_team(loop)) {
        write_team_parts(loop, out, most_blocks(loop));
        return;
    }
    writer_line(out, "struct {");
    for (unsigned i = 0; i < blocks_of(loop)->scalar_count; i++)
        writer_line(out, "    __typeof__(%s) redcc__%u;", value_of(loop, i), i);
    writer_line(out, "} redcc__parts[%d];", most_blocks(loop));
}

/** Writes the directive for the loop over blocks. */
static void write_directive(loop_text *loop, writer *out) {
    const fixed_blocks *blocks = blocks_of(loop);
    if (is_of_team(loop))
        write_team_begin(loop, out);
    write_if_any(loop, out, is_of_team(loop));
    buffer line = {0};
    buffer_format(&line, "#pragma omp %s schedule(%s)",
                  is_of_team(loop) ? "for nowait" : "parallel for",
                  blocks->is_balanced ? "static" : "dynamic");
    for (unsigned i = 0; i < blocks->directive.item_count; i++) {
        const openmp_item *item = &blocks->directive.items[i];
        if (item->kind != OPENMP_REDUCTION && item->kind != OPENMP_SCHEDULE &&
            item->kind != OPENMP_COLLAPSE && item->kind != OPENMP_NOWAIT)
            buffer_format(&line, " %s(%s)", item->word, item->text);
    }
    if (!is_of_team(loop)) {
        buffer_text(&line, " \\\n    shared(redcc__parts");
        write_shared(loop, &line);
        for (unsigned i = 0; i < blocks->scalar_count; i++)
            buffer_format(&line, ", %s", name_of(loop, i));
        buffer_byte(&line, ')');
    }
    layout_directive(&out->out, line.data);
    buffer_free(&line);
}

/** Writes the beginning of the loop over blocks: a block's private variables, and the header of the
 * inner loop over the block's iterations. */
static void write_block(loop_text *loop, writer *out) {
    const fixed_blocks *blocks = blocks_of(loop);
    writer_line(out, "for (redcc__block = 0; redcc__block < redcc__blocks; redcc__block++) {");
    out->depth++;
    writer_line(out, "REDCC_QUIET_BEGIN");
    write_ranges(loop, out);
    for (unsigned i = 0; i < blocks->scalar_count; i++) {
        writer_line(out, "__typeof__(%s) redcc__%u =", value_of(loop, i), i);
        writer_line(out, "    redcc__in_order ? %s : (%s);", value_of(loop, i),
                    neutral_value(loop->arena, &blocks->scalars[i]));
    }
    for (unsigned i = 0; i < blocks->scalar_count; i++)
        writer_line(out, "__typeof__(redcc__%u) %s = redcc__%u;", i,
                    origin_declarator(loop->arena, blocks->scalars[i].variable), i);
    writer_line(out, "REDCC_QUIET_END");
    write_header(loop, out);
    out->depth--;
}

static void write_condition(loop_text *loop, writer *out) {
    buffer_byte(&out->out, '\n');
    begin_as_compiled(loop, &out->out);
    buffer_text(&out->out, "#if defined(REDCC_RUNTIME_H) && defined(redcc__as_compiled)\n"
                           "#define redcc__in_blocks\n"
                           "#endif\n");
    end_as_compiled(loop, &out->out);
    buffer_text(&out->out, "#ifdef redcc__in_blocks\n");
}

static void write_head(loop_text *loop, writer *out, ir_range replaced) {
    write_condition(loop, out);
    writer_line(out, "{ /* redcc: in fixed blocks, with the same bits at every thread count */");
    out->depth = 1;
    writer_line(out, "REDCC_QUIET_BEGIN");
    write_site(loop, out);
    write_parts(loop, out);
    write_counts(loop, out, most_blocks(loop));
    writer_line(out, "REDCC_QUIET_END");
    write_directive(loop, out);
    write_block(loop, out);
    check_macro_names(loop, &out->out);
    out->depth = 0;
    const char *text = loop->unit->source->text;
    buffer_format(&out->out, "#else\n%s\n%s", loop_line_directive(loop, replaced.begin),
                  loop_column_blanks(loop, replaced.begin));
    buffer_append(&out->out, text + replaced.begin, replaced.end - replaced.begin);
    buffer_format(&out->out, "\n#endif\n%s\n%s", loop_line_directive(loop, replaced.end - 1),
                  loop_column_blanks(loop, replaced.end));
}

/* ---- after the loop -------------------------------------------------------------------------- */

static void write_tail(loop_text *loop, writer *out, uint32_t end) {
    const fixed_blocks *blocks = blocks_of(loop);
    buffer_text(&out->out, "\n#ifdef redcc__in_blocks\n");
    out->depth = 2;
    for (unsigned i = 0; i < blocks->scalar_count; i++)
        writer_line(out, "redcc__parts[redcc__block].redcc__%u = %s;", i, value_of(loop, i));
    out->depth = 1;
    if (is_of_team(loop))
        writer_line(out, "    redcc__mine++;");
    writer_line(out, "}");
    writer_line(out, "REDCC_QUIET_BEGIN");
    if (is_of_team(loop))
        writer_line(out, "if (REDCC_IS_LAST(redcc__all_ended, redcc__mine, redcc__blocks))");
    writer_line(out, "for (redcc__block = 0; redcc__block < redcc__blocks; redcc__block++) {");
    for (unsigned i = 0; i < blocks->scalar_count; i++) {
        const char *part = arena_format(loop->arena, "redcc__parts[redcc__block].redcc__%u", i);
        const char *sum = value_of(loop, i);
        writer_line(out, "    %s = redcc__in_order ? %s", sum, part);
        writer_line(out, "        : (__typeof__(%s))(%s);", sum,
                    combination(loop->arena, &blocks->scalars[i], sum, part));
    }
    writer_line(out, "}");
    if (is_of_team(loop))
        buffer_text(&out->out, "#pragma omp barrier\n");
    writer_line(out, "REDCC_QUIET_END");
    out->depth = 0;
    writer_line(out, "}");
    buffer_format(&out->out, "#undef redcc__in_blocks\n#endif\n%s\n%s",
                  loop_line_directive(loop, end - 1), loop_column_blanks(loop, end));
}

bool write_blocks(loop_text loop, block_pieces *pieces, reason *why) {
    const ir_node *whole = loop.facts->loop;
    writer out = {0};
    loop_piece *head = &pieces->head, *tail = &pieces->tail;
    head->replaced = (ir_range){loop_text_begin(loop.whole, whole), blocks_of(&loop)->header.end};
    write_head(&loop, &out, head->replaced);
    head->text = writer_text(loop.arena, &out);
    pieces->front = (loop_piece){0};
    if (is_of_team(&loop) && has_frame_parts(&loop))
        pieces->front = frame_parts(&loop, most_blocks(&loop));
    pieces->inner = inner_header(&loop);
    const uint32_t end = syntax_statement_end(loop.unit->source, whole);
    tail->replaced = (ir_range){end, end};
    write_tail(&loop, &out, end);
    check_macro_names(&loop, &out.out);
    tail->text = writer_text(loop.arena, &out);
    *why = (reason){.message = loop.obstacle, .range = loop.obstacle_range};
    return !loop.obstacle;
}
