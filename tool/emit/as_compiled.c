/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "emit/as_compiled.h"

#include <assert.h>
#include <string.h>

#include "analysis/base/loop_text.h"
#include "emit/text/origin.h"

/* ---- the text without skipped branches ------------------------------------------------------- */

static bool is_in_loop(const ir_unit *unit, const analysis_result *analysis, uint32_t place) {
    for (unsigned i = 0; i < analysis->verdict_count; i++) {
        const ir_node *loop = analysis->verdicts[i].loop;
        if (analysis->verdicts[i].kind == VERDICT_TRANSFORM && place < loop->range.end &&
            place >= loop_text_begin(unit, loop))
            return true;
    }
    return false;
}

/** Replaces bytes [begin, end) by blanks, except for line ends. */
static void blank(char *text, uint32_t begin, uint32_t end) {
    for (uint32_t i = begin; i < end; i++)
        if (text[i] != '\n' && text[i] != '\r')
            text[i] = ' ';
}

const ir_unit *unit_as_compiled(arena *a, const ir_unit *unit, const analysis_result *analysis) {
    bool *is_left_out = ARENA_ARRAY(a, bool, unit->directive_count + 1);
    unsigned count = 0;
    for (unsigned i = 0; i < unit->directive_count; i++) {
        const ir_directive *d = &unit->directives[i];
        is_left_out[i] =
            directive_can_be_left_out(unit, d) && is_in_loop(unit, analysis, d->range.begin);
        count += is_left_out[i];
    }
    if (count == 0)
        return unit;
    char *text = arena_copy(a, unit->source->text, unit->source->length);
    ir_directive *kept = ARENA_ARRAY(a, ir_directive, unit->directive_count);
    ir_unit *seen = ARENA_NEW(a, ir_unit);
    *seen = *unit;
    seen->directives = kept;
    seen->directive_count = 0;
    for (unsigned i = 0; i < unit->directive_count; i++)
        if (is_left_out[i])
            blank(text, unit->directives[i].range.begin, loop_text_end_of_branch(unit, i));
        else
            kept[seen->directive_count++] = unit->directives[i];
    source *file = ARENA_NEW(a, source);
    *file = *unit->source;
    file->text = text;
    seen->source = file;
    return seen;
}

/* ---- the conditions -------------------------------------------------------------------------- */

/** Copies the line ends in bytes [begin, end), except for the first one, which `out` already
 *  contains. */
static void copy_line_ends(buffer *out, const char *text, uint32_t begin, uint32_t end) {
    const char *at = memchr(text + begin, '\n', end - begin);
    for (at = at ? at + 1 : text + end; at < text + end; at++)
        buffer_text(out, *at == '\n' ? "\n" : "");
}

/** Copies a directive so that it keeps its line number, because its condition may use __LINE__,
 * perhaps through a macro. An #if gets a #line directive. Later directives of its group cannot get
 * a #line, which has no effect in a skipped branch. Instead, the line ends between `before`, the
 * directive copied last, and this one are copied. */
static void copy_directive(loop_text *loop, buffer *out, const ir_directive *d,
                           const ir_directive *before) {
    const char *text = loop->whole->source->text;
    if (d->kind == IR_DIRECTIVE_IF)
        buffer_format(out, "%s\n", loop_line_directive(loop, d->range.begin));
    else
        copy_line_ends(out, text, before->range.end, d->range.begin);
    origin_copy(out, text, d->range.begin, d->range.end);
    buffer_byte(out, '\n');
}

/** The bytes on which the parallel form depends: from the function's beginning to the loop's
 * end. */
static ir_range compiled_range(const loop_text *loop) {
    return (ir_range){loop->facts->function->range.begin, loop->facts->loop->range.end};
}

bool has_branches(const loop_text *loop) {
    if (loop_text_depends_on_openmp(loop->whole, loop->facts->function, loop->facts->loop))
        return true;
    const ir_range text = compiled_range(loop);
    for (unsigned i = loop_text_first_directive(loop->whole, text.begin);
         i < loop->whole->directive_count && loop->whole->directives[i].range.begin < text.end; i++)
        if (directive_is_conditional(&loop->whole->directives[i]))
            return true;
    return false;
}

/** Copies some directives of each group of conditional directives (#if to #endif): those up to the
 * branch that this compilation takes, without the #endif. The copied groups are therefore nested.
 * The innermost one contains the definition of redcc__as_compiled. It is reached only if all
 * conditions have the same values as in this compilation. */
void begin_as_compiled(loop_text *loop, buffer *out) {
    if (!has_branches(loop))
        return;
    const ir_unit *whole = loop->whole;
    const ir_range text = compiled_range(loop);
    assert(text.begin <= text.end && text.end <= whole->source->length);
    unsigned depth = 0,
             left_out = 0;  /* numbers of open groups: copied ones; those in skipped branches */
    bool is_decided = true; /* the current group's compiled branch has begun */
    const ir_directive *before = NULL;
    const bool depends =
        loop_text_depends_on_openmp(whole, loop->facts->function, loop->facts->loop);
    if (depends)
        buffer_text(out, whole->dialect.has_openmp ? "#ifdef _OPENMP\n" : "#ifndef _OPENMP\n");
    for (unsigned i = loop_text_first_directive(whole, text.begin);
         i < whole->directive_count && whole->directives[i].range.begin < text.end; i++) {
        const ir_directive *d = &whole->directives[i];
        const bool is_end = d->kind == IR_DIRECTIVE_ENDIF;
        if (!directive_is_conditional(d))
            continue;
        if (left_out > 0 || (d->kind == IR_DIRECTIVE_IF && i > 0 && d[-1].is_skipped)) {
            left_out += d->kind == IR_DIRECTIVE_IF;
            left_out -= is_end;
        } else if (is_end) {
            buffer_text(out, is_decided ? "" : "#else\n");
            is_decided = true; /* the enclosing group's compiled branch, which contains this group,
                                * has begun */
        } else if (d->kind == IR_DIRECTIVE_IF || !is_decided) {
            depth += d->kind == IR_DIRECTIVE_IF;
            copy_directive(loop, out, d, before);
            before = d;
            is_decided = !d->is_skipped;
        }
    }
    buffer_text(out, "#define redcc__as_compiled\n");
    for (depth += depends; depth > 0; depth--)
        buffer_text(out, "#endif\n");
}

void end_as_compiled(const loop_text *loop, buffer *out) {
    buffer_text(out, has_branches(loop) ? "#undef redcc__as_compiled\n" : "");
}
