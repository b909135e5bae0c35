/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "ir/ir_position.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

/** The contents of a line directive: `#line 12 "name"` or `# 12 "name" 1`. */
typedef struct line_directive {
    unsigned line;
    const char *file; /* NULL if the directive does not change it */
} line_directive;

static const char *skip_spaces(const char *text) {
    return text + strspn(text, " \t");
}

/** The contents of the string literal at `text`, with escapes resolved; NULL if there is none. */
static const char *file_of_literal(arena *a, const char *text) {
    if (*text != '"')
        return NULL;
    char *file = arena_allocate(a, strlen(text) + 1);
    size_t length = 0;
    for (text++; *text && *text != '"'; text++) {
        if (*text == '\\' && text[1])
            text++;
        file[length++] = *text;
    }
    return *text == '"' ? file : NULL;
}

static bool read_line_directive(arena *a, const char *text, line_directive *result) {
    text = skip_spaces(text);
    if (*text != '#')
        return false;
    text = skip_spaces(text + 1);
    if (strncmp(text, "line", 4) == 0)
        text = skip_spaces(text + 4);
    if (*text < '0' || *text > '9')
        return false;
    char *after;
    result->line = (unsigned)strtoul(text, &after, 10);
    result->file = file_of_literal(a, skip_spaces(after));
    return true;
}

ir_position ir_position_of(const ir_unit *unit, uint32_t offset) {
    assert(offset <= unit->source->length);
    const position at = source_position(unit->source, offset);
    ir_position result = {unit->source->path, at.line, at.column};
    for (unsigned i = 0; i < unit->directive_count; i++) {
        const ir_directive *directive = &unit->directives[i];
        line_directive said;
        assert(i == 0 || unit->directives[i - 1].range.end <= directive->range.begin);
        if (directive->range.begin > offset)
            break;
        if (directive->kind != IR_DIRECTIVE_OTHER ||
            !read_line_directive(unit->arena, directive->text, &said))
            continue;
        const uint32_t end = directive->range.end;
        const uint32_t last = end > directive->range.begin ? end - 1 : end;
        const unsigned directive_line = source_position(unit->source, last).line;
        if (at.line <= directive_line)
            continue;
        result.line = said.line + (at.line - directive_line - 1);
        if (said.file)
            result.file = said.file;
    }
    return result;
}

const ir_position *ir_position_in_header(const ir_unit *unit, const ir_node *loop) {
    assert(ir_is_loop(loop));
    return unit->text.header_loops ? map_get(unit->text.header_loops, &loop, sizeof loop) : NULL;
}
