/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "expectation.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "support/buffer.h"

/* Prints " h(+)", or " h(+,kept)" if the order is kept, or " h(kept)" if the update has no operator. */
static void describe_array(buffer *out, const reduction_array *array) {
    const char *op = reduction_operator_spelling(array->op);
    buffer_format(out, " %s(%s%s%s)", array->name, op ? op : "",
                  op && array->order_is_kept ? "," : "", array->order_is_kept ? "kept" : "");
}

/* Prints " rests-on=start,q": the arrays whose contents select the touched elements, each name once. */
static void describe_subscripts(buffer *out, const loop_facts *facts) {
    const char *joint = " rests-on=";
    for (unsigned i = 0; i < facts->source_count; i++) {
        bool is_first = facts->sources[i].is_subscript;
        for (unsigned k = 0; k < i && is_first; k++)
            is_first = !facts->sources[k].is_subscript ||
                       strcmp(facts->sources[k].name, facts->sources[i].name) != 0;
        if (is_first)
            buffer_format(out, "%s%s", joint, facts->sources[i].name);
        if (is_first)
            joint = ",";
    }
}

/* Prints the numbers of subscripts, of recorded, checked and conditionally read sources, and of spans. */
static void describe_sources(buffer *out, const loop_facts *facts) {
    unsigned subscripts = 0, told = 0, checked = 0, sometimes = 0;
    for (unsigned i = 0; i < facts->source_count; i++) {
        subscripts += facts->sources[i].is_subscript;
        told += facts->sources[i].extent == EXTENT_TOUCHED;
        checked += facts->sources[i].is_checked;
        sometimes += facts->sources[i].is_sometimes;
    }
    buffer_format(out, " subscripts=%u told=%u checked=%u sometimes=%u spans=%u", subscripts, told,
                  checked, sometimes, facts->inspector.span_count);
}

static void describe_scalars(buffer *out, const loop_facts *facts) {
    static const char *const types[] = {
        [OPERAND_INTEGER] = "integer", [OPERAND_FLOAT] = "float", [OPERAND_DOUBLE] = "double"};
    for (unsigned i = 0; i < facts->scalar_count; i++)
        buffer_format(out, " %s=%s%s",
                      facts->scalars[i].variable ? facts->scalars[i].variable->name : "memory",
                      types[facts->scalars[i].operand],
                      facts->scalars[i].is_conditional ? "-sometimes" : "");
}

const char *expectation_describe(arena *a, const loop_verdict *verdict) {
    buffer out = {0};
    const loop_facts *facts = verdict->facts;
    if (verdict->kind == VERDICT_NOT_A_REDUCTION) {
        buffer_text(&out, "not-a-reduction");
    } else if (verdict->kind == VERDICT_REFUSE) {
        buffer_format(&out, "refuse %s", reason_slug(verdict->why.id));
    } else {
        unsigned guards = 0;
        unsigned outside = 0;
        buffer_text(&out, "transform");
        for (unsigned i = 0; i < facts->array_count; i++)
            describe_array(&out, &facts->arrays[i]);
        for (unsigned i = 0; i < facts->source_count; i++)
            guards += facts->sources[i].needs_guard;
        for (unsigned i = 0; i < facts->variables.private_count; i++)
            outside += !facts->variables.privates[i].is_declared_inside;
        buffer_format(&out, " guards=%u %s privates=%u", guards,
                      facts->slice.is_verifiable ? "verifiable" : "not-verifiable", outside);
        for (unsigned i = 0; i < facts->variables.private_count; i++)
            if (facts->variables.privates[i].is_live_after)
                buffer_format(&out, " last=%s", facts->variables.privates[i].variable->name);
        buffer_format(&out, " keys=%u", facts->inspector.key_count);
        if (facts->counter_is_live_after)
            buffer_text(&out, " counter-live");
        for (unsigned i = 0; i < facts->array_count; i++)
            if (facts->arrays[i].is_interleaved)
                buffer_format(&out, " interleaved=%s", facts->arrays[i].name);
        describe_subscripts(&out, facts);
        if (facts->slice.unkept.name)
            buffer_format(&out, " unkept=%s", facts->slice.unkept.name);
        describe_sources(&out, facts);
        describe_scalars(&out, facts);
        if (facts->sets_errno)
            buffer_text(&out, " sets-errno");
    }
    const char *text = arena_copy(a, out.data, out.length);
    buffer_free(&out);
    return text;
}

/* ---- comments -------------------------------------------------------------------------------- */

static const char *line_of(arena *a, const source *s, unsigned line) {
    uint32_t begin = s->line_begin[line - 1];
    uint32_t end = line < s->line_count ? s->line_begin[line] : s->length;
    while (end > begin && (s->text[end - 1] == '\n' || s->text[end - 1] == '\r'))
        end--;
    return arena_copy(a, s->text + begin, end - begin);
}

static const char *expected_on(arena *a, const source *s, unsigned line) {
    static const char mark[] = "// EXPECT: ";
    const char *text = line_of(a, s, line);
    const char *found = strstr(text, mark);
    return found ? found + strlen(mark) : NULL;
}

analysis_options expectation_options(arena *a, const source *s) {
    analysis_options options = {0};
    const char **names = ARENA_ARRAY(a, const char *, 16);
    const char *pure = strstr(s->text, "// PURE: ");
    if (pure) {
        char *list = arena_copy(a, pure + 9, strcspn(pure + 9, "\n"));
        for (char *name = strtok(list, ", "); name && options.pure_count < 16;
             name = strtok(NULL, ", "))
            names[options.pure_count++] = name;
        options.pure = names;
    }
    options.assume_noalias = strstr(s->text, "// NOALIAS") != NULL;
    return options;
}

/* ---- comparing ------------------------------------------------------------------------------- */

/* Is each word of `expected` also in `text`, and does `expected` list all arrays of `text`? */
static int words_agree(arena *a, const char *expected, const char *text) {
    char *words = arena_string(a, expected);
    const char *padded = arena_format(a, " %s ", text);
    for (char *word = strtok(words, " "); word; word = strtok(NULL, " "))
        if (!strstr(padded, arena_format(a, " %s ", word)))
            return 0;
    unsigned expected_arrays = 0, arrays = 0;
    for (const char *c = expected; *c; c++)
        expected_arrays += *c == '(';
    for (const char *c = text; *c; c++)
        arrays += *c == '(';
    return expected_arrays == arrays;
}

unsigned expectation_check(arena *a, const ir_unit *unit, const analysis_result *result) {
    const source *s = unit->source;
    unsigned differences = 0;
    bool *seen = ARENA_ARRAY(a, bool, s->line_count + 2);
    for (unsigned i = 0; i < result->verdict_count; i++) {
        const loop_verdict *verdict = &result->verdicts[i];
        unsigned line = source_position(s, verdict->loop->range.begin).line;
        const char *text = expectation_describe(a, verdict);
        const char *expected = expected_on(a, s, line);
        seen[line] = true;
        if (expected && words_agree(a, expected, text))
            continue;
        differences++;
        fprintf(stderr, "%s:%u: expected '%s'\n    but it is '%s'%s%s\n", s->path, line,
                expected ? expected : "nothing", text, verdict->why.message ? ": " : "",
                verdict->why.message ? verdict->why.message : "");
    }
    for (unsigned line = 1; line <= s->line_count; line++) {
        const char *expected = expected_on(a, s, line);
        if (!expected || seen[line])
            continue;
        differences++;
        fprintf(stderr, "%s:%u: expected '%s' but there is no verdict\n", s->path, line, expected);
    }
    return differences;
}
