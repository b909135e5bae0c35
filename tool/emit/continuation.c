/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "emit/continuation.h"

#include <assert.h>
#include <string.h>

#include "emit/base/step.h"
#include "emit/call.h"
#include "emit/text/layout.h"
#include "emit/text/origin.h"
#include "ir/ir_position.h"
#include "plan/continuation.h"

static void begin_header(loop_text *loop, writer *out, uint32_t begin) {
    buffer_format(&out->out, "%s\n%s", loop_line_directive(loop, begin),
                  loop_column_blanks(loop, begin));
}

/* The beginning of the text that replaces the part; the part's own text and `)` follow. */
static const char *condition_before(loop_text *loop, const continued_part *part) {
    if (part->private_number == CONTINUED_CLAUSE)
        return "redcc__done ? (void)0 : (void)(";
    if (part->private_number == CONTINUED_COUNTER)
        return arena_format(loop->arena, "redcc__done ? (%s)(%s) : (%s)(", loop->counter_type,
                            counter_after(loop), loop->counter_type);
    const unsigned number = (unsigned)part->private_number;
    const char *type =
        origin_type(loop->arena, loop->facts->variables.privates[number].variable->type);
    return arena_format(loop->arena, "redcc__done ? (%s)(%s) : (%s)(", type,
                        stepped_after(loop, number), type);
}

uint32_t write_continued_header(loop_text *loop, writer *out, uint32_t begin) {
    continued_part parts[MOST_CONTINUED];
    unsigned count;
    const bool is_possible = continued_parts(loop->facts, parts, &count);
    assert(is_possible);
    if (!is_possible || count == 0)
        return begin;
    const char *text = loop->whole->source->text;
    const uint32_t body = loop->facts->counted.body->range.begin;
    uint32_t at = begin;
    buffer header = {0};
    begin_header(loop, out, begin);
    for (unsigned i = 0; i < count; i++) {
        origin_copy(&header, text, at, parts[i].range.begin);
        buffer_text(&header, condition_before(loop, &parts[i]));
        origin_copy(&header, text, parts[i].range.begin, parts[i].range.end);
        buffer_text(&header, ")");
        at = parts[i].range.end;
    }
    origin_copy(&header, text, at, body);
    layout_copy(&out->out, header.data, ir_position_of(loop->unit, begin).line,
                (unsigned)strlen(loop_column_blanks(loop, begin)));
    buffer_free(&header);
    buffer_text(&out->out, "\n#else\n");
    begin_header(loop, out, begin);
    for (at = begin; at < body; at++)
        if (text[at] == 1 || text[at] == 2) /* a mark of origin.h; only comments have such bytes */
            loop_obstacle(loop, loop->facts->loop->range, "the header has control characters");
    buffer_append(&out->out, text + begin, body - begin); /* unmarked: redcc does not parse it */
    buffer_text(&out->out, "\n");
    return body;
}
