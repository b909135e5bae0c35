/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "emit/base/loop.h"

#include <assert.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "ir/ir_position.h"

enum { MOST_BLANKS = 50 };

void loop_obstacle(loop_text *loop, ir_range range, const char *format, ...) {
    if (loop->obstacle)
        return;
    char text[256];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    loop->obstacle = arena_string(loop->arena, text);
    loop->obstacle_range = range;
}

static const char *or_obstacle(loop_text *loop, const ir_node *expression, const char *text) {
    if (text)
        return text;
    loop_obstacle(loop, expression->range,
                  "an expression of the loop cannot be written as C outside of it");
    return "0";
}

const char *loop_operand(loop_text *loop, const ir_node *expression) {
    return or_obstacle(loop, expression, text_operand(loop->arena, expression, NULL, NULL));
}

const char *loop_line_directive(loop_text *loop, uint32_t offset) {
    assert(offset <= loop->unit->source->length);
    const ir_position place = ir_position_of(loop->unit, offset);
    return arena_format(loop->arena, "#line %u %s", place.line,
                        text_quoted(loop->arena, place.file));
}

const char *loop_column_blanks(loop_text *loop, uint32_t offset) {
    const source *text = loop->unit->source;
    uint32_t begin = text->line_begin[source_position(text, offset).line - 1];
    assert(begin <= offset && offset <= text->length);
    begin = offset - begin > MOST_BLANKS ? offset - MOST_BLANKS : begin;
    char *blanks = arena_allocate(loop->arena, offset - begin + 1);
    for (uint32_t i = begin; i < offset; i++)
        blanks[i - begin] = text->text[i] == '\t' ? '\t' : ' ';
    return blanks;
}

const char *loop_made(const loop_text *loop) {
    return loop->continues ? "redcc__made" : "redcc__trip";
}

const char *loop_counter_value(loop_text *loop) {
    const char *step = loop_step(loop);
    const bool is_one = strcmp(step, "1") == 0;
    return arena_format(loop->arena, "REDCC_COUNTER(%s, %s%sredcc__k)", loop->counter_type,
                        is_one ? "" : step, is_one ? "" : " * ");
}

const char *loop_step(loop_text *loop) {
    const counted_loop *counted = &loop->facts->counted;
    assert(counted->step != 0);
    if (counted->stride)
        return counted->step > 0 ? "redcc__stride" : "-redcc__stride";
    return arena_format(loop->arena, "%lld", (long long)counted->step);
}
