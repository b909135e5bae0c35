/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "emit/text/text.h"

#include <assert.h>
#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "emit/text/origin.h"

enum { SPACES_A_LEVEL = 4 };

/** The state after scanning a part of a line of marked text. */
typedef struct line_scan {
    size_t columns;  /* without marks */
    size_t indent;   /* the number of blanks at the beginning */
    size_t comma;    /* position of the last blank after a comma, or 0 */
    size_t blank;    /* position of the last blank of any kind, or 0 */
    bool is_remark;  /* the last blank is in a comment */
    char quote;      /* the quote of the literal at the end of the part, or 0 */
    bool is_escaped; /* the next byte of that literal is escaped */
    bool is_comment; /* the part ends in a comment */
} line_scan;

/** Returns the end of the line; sets *has_copy if it contains bytes of the user's file. */
static const char *line_end(const char *at, const char *end, bool *has_copy) {
    *has_copy = false;
    while (at < end && *at != '\n') {
        const char *after = origin_skip(at, end);
        *has_copy |= after != at && origin_is_copy(at, end);
        at = after != at ? after : at + 1;
    }
    return at;
}

/** Updates the state for a byte that was appended to `out`. */
static void scan_byte(line_scan *line, const buffer *out, char byte) {
    const char before = out->length > 1 ? out->data[out->length - 2] : ' ';
    line->columns++;
    if (line->is_comment)
        line->is_comment = byte != '/' || before != '*';
    else if (line->quote && (line->is_escaped || byte != line->quote))
        line->is_escaped = byte == '\\' && !line->is_escaped;
    else if (line->quote)
        line->quote = 0;
    else if (byte == '"' || byte == '\'')
        line->quote = byte;
    else if (byte == '*' && before == '/')
        line->is_comment = true;
    if (byte != ' ' || line->quote || line->columns > MOST_COLUMNS)
        return;
    if (line->columns == line->indent + 1)
        line->indent++;
    else {
        line->blank = out->length - 1;
        line->is_remark = line->is_comment;
    }
    if (before == ',' && !line->is_comment)
        line->comma = out->length - 1;
}

/** Replaces the last blank after a comma, or else the last blank, by a line end and an
 *  indentation. */
static void break_line(arena *scratch, line_scan *line, buffer *out) {
    assert(line->comma || line->blank);
    const size_t at = line->comma ? line->comma : line->blank;
    const char *rest = arena_format(scratch, "%s", out->data + at + 1);
    buffer_shorten(out, out->length - at);
    buffer_byte(out, '\n');
    line_scan next = {.is_comment = !line->comma && line->is_remark};
    for (size_t i = 0; i < line->indent + SPACES_A_LEVEL; i++) {
        buffer_byte(out, ' ');
        scan_byte(&next, out, ' ');
    }
    next.indent = line->indent; /* so all continuation lines have the same indentation */
    for (const char *c = rest, *const end = rest + strlen(rest); c < end;) {
        const char *after = origin_skip(c, end);
        for (; c < after; c++)
            buffer_byte(out, *c);
        if (c == end)
            break;
        buffer_byte(out, *c);
        scan_byte(&next, out, *c++);
    }
    *line = next;
}

/** Breaks lines from `begin` on that are too long, except for directives and lines with the user's
 * bytes. */
static void break_lines(writer *w, size_t begin) {
    arena *scratch = arena_new();
    const char *at = arena_format(scratch, "%s", w->out.data + begin);
    const char *const end = at + strlen(at);
    buffer_shorten(&w->out, w->out.length - begin);
    while (at < end) {
        bool has_copy;
        const char *const stop = line_end(at, end, &has_copy);
        const bool stays = has_copy || at[strspn(at, " ")] == '#';
        line_scan line = {0};
        while (at < stop) {
            const char *const after = stays ? stop : origin_skip(at, stop);
            for (; at < after; at++)
                buffer_byte(&w->out, *at);
            if (at == stop)
                break;
            buffer_byte(&w->out, *at);
            scan_byte(&line, &w->out, *at++);
            if (line.columns > MOST_COLUMNS && (line.comma || line.blank))
                break_line(scratch, &line, &w->out);
        }
        if (at < end)
            buffer_byte(&w->out, *at++);
    }
    arena_free(scratch);
}

void writer_line(writer *w, const char *format, ...) {
    const size_t begin = w->out.length;
    for (unsigned i = 0; !w->on_one_line && i < w->depth * SPACES_A_LEVEL; i++)
        buffer_byte(&w->out, ' ');
    va_list arguments, again;
    va_start(arguments, format);
    va_copy(again, arguments);
    const int length = vsnprintf(NULL, 0, format, arguments);
    va_end(arguments);
    char small[256];
    if (length >= 0 && (size_t)length < sizeof small) {
        vsnprintf(small, sizeof small, format, again);
        buffer_text(&w->out, small);
    } else if (length >= 0) {
        arena *scratch = arena_new();
        char *large = arena_allocate(scratch, (size_t)length + 1);
        vsnprintf(large, (size_t)length + 1, format, again);
        buffer_text(&w->out, large);
        arena_free(scratch);
    }
    va_end(again);
    buffer_byte(&w->out, w->on_one_line ? ' ' : '\n');
    if (!w->on_one_line && w->out.length - begin > MOST_COLUMNS)
        break_lines(w, begin);
}

const char *writer_text(arena *a, writer *w) {
    assert(!w->out.data || w->out.data[w->out.length] == 0);
    return buffer_take(a, &w->out);
}

const char *text_quoted(arena *a, const char *text) {
    buffer out = {0};
    buffer_byte(&out, '"');
    for (const char *c = text; *c; c++) {
        const unsigned char byte = (unsigned char)*c;
        if (byte == '"' || byte == '\\')
            buffer_format(&out, "\\%c", byte);
        else if (byte == '?' && c[1] == '?') /* so that no trigraph arises */
            buffer_text(&out, "\\?");
        else if (byte < ' ' || byte == 0x7f)
            buffer_format(&out, "\\%03o", byte);
        else
            buffer_byte(&out, *c);
    }
    buffer_byte(&out, '"');
    return buffer_take(a, &out);
}

/* ---- expressions --------------------------------------------------------------------------- */

typedef struct marking {
    arena *arena;
    ir_c_rename rename; /* or NULL */
    void *context;
} marking;

/** Is the node an enumerator? Other constants begin with a digit, or have quotes. */
static bool is_enumerator(const ir_node *node) {
    return node->kind == IR_NUMBER && node->flags & IR_HAS_VALUE && node->text &&
           source_is_name_byte(node->text[0]) && !isdigit((unsigned char)node->text[0]) &&
           !strchr(node->text, '\'');
}

/** A constant of the given type, as a primary expression. */
static const char *constant_text(arena *a, int64_t value, const ir_type *type) {
    assert(type->kind == IR_INTEGER && type->size > 0);
    const bool is_long = type->size > 4;
    const bool is_very_long = is_long && type->spelling && strstr(type->spelling, "long long");
    const char *suffix = is_very_long ? "LL" : is_long ? "L" : "";
    if (!type->is_signed && type->size >= 4)
        return arena_format(a, "%lluU%s",
                            type->size == 4 ? (unsigned long long)(uint32_t)value
                                            : (unsigned long long)value,
                            suffix);
    if (value >= 0)
        return arena_format(a, "%lld%s", (long long)value, suffix);
    return arena_format(a, "(-%lld%s - 1)", (long long)-(value + 1), suffix); /* even INT64_MIN */
}

/** A rename hook that marks names. It writes enumerators and sizeof expressions as numbers, because
 * their meaning may differ at another place, but their value does not. */
static const char *marked_name(const ir_node *node, void *context) {
    const marking *m = context;
    const char *other = m->rename ? m->rename(node, m->context) : NULL;
    if (other)
        return other;
    if (node->kind == IR_VARIABLE)
        return origin_variable(m->arena, node->variable);
    if (node->kind == IR_FUNCTION)
        return origin_function(m->arena, node->function);
    if (is_enumerator(node) || (node->kind == IR_SIZEOF && node->flags & IR_HAS_VALUE))
        return constant_text(m->arena, node->value, node->type);
    return NULL;
}

static const char *marked_type(const ir_type *type, void *context) {
    return origin_type(((const marking *)context)->arena, type);
}

const char *text_expression(arena *a, const ir_node *expression, ir_c_rename rename,
                            void *context) {
    buffer out = {0};
    const char *text = NULL;
    marking m = {a, rename, context};
    if (ir_c_expression_spelled(&out, expression, marked_name, marked_type, &m))
        text = buffer_take(a, &out);
    buffer_free(&out);
    return text;
}

/** Is the expression postfix or primary, so that it binds tighter than a cast or & before it? */
static bool is_tight(const ir_node *expression) {
    switch (expression->kind) {
    case IR_NUMBER: /* may print as -1 for an enumerator or macro */
        return expression->text && expression->text[0] != '-';
    case IR_STRING:
    case IR_VARIABLE:
    case IR_FUNCTION:
    case IR_INDEX:
    case IR_MEMBER:
    case IR_CALL:
        return true;
    default:
        return false;
    }
}

const char *text_operand(arena *a, const ir_node *expression, ir_c_rename rename, void *context) {
    const char *text = text_expression(a, expression, rename, context);
    if (!text || is_tight(expression))
        return text;
    return arena_format(a, "(%s)", text);
}

const char *macro_argument(arena *a, const char *marked) {
    const char *plain = origin_unmark(a, marked, strlen(marked), false, NULL);
    return strchr(plain, ',') ? arena_format(a, "(%s)", marked) : marked;
}

const char *text_declaration(arena *a, const ir_type *type, const char *name) {
    if (!type || !type->spelling)
        return NULL;
    const char *spelling = type->spelling;
    const char *marked = origin_type(a, type);
    if (strpbrk(spelling, "(["))
        return arena_format(a, "__typeof__(%s) %s", marked, name);
    const char last = spelling[0] ? spelling[strlen(spelling) - 1] : ' ';
    return arena_format(a, last == '*' ? "%s%s" : "%s %s", marked, name);
}
