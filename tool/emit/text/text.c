/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "emit/text/text.h"

#include <assert.h>
#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "emit/text/origin.h"

enum { SPACES_A_LEVEL = 4, LONGEST_FILLED = 150 };

/** The width of marked text. */
static size_t visible_width(const char *at, const char *end) {
    size_t width = 0;
    for (; at < end; width++) {
        const char *after = at;
        while ((after = origin_skip(at, end)) != at)
            at = after;
        at += at < end;
    }
    return width;
}

void writer_fill(writer *w, bool fills) {
    if (fills && w->fills++ == 0)
        w->fill_begin = w->out.length;
    if (!fills)
        w->fills--;
}

/** Appends the line from `begin` on to the preceding one, if both are short. */
static void join_line(writer *w, size_t begin) {
    char *data = w->out.data;
    assert(w->fill_begin <= begin);
    size_t text = begin;
    while (data[text] == ' ')
        text++;
    const size_t width = visible_width(data + w->fill_begin, data + begin) +
                         visible_width(data + text, data + w->out.length);
    if (begin == w->fill_begin || width > LONGEST_FILLED) {
        w->fill_begin = begin;
        return;
    }
    data[begin - 1] = ' ';
    memmove(data + begin, data + text, w->out.length - text);
    buffer_shorten(&w->out, text - begin);
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
    if (w->fills && !w->on_one_line)
        join_line(w, begin);
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
        else if (byte == '?' && c[1] == '?') /* no trigraph */
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

/** Is it an enumerator? Other constants begin with a digit, or have quotes. */
static bool is_enumerator(const ir_node *node) {
    return node->kind == IR_NUMBER && node->flags & IR_HAS_VALUE && node->text &&
           source_is_name_byte(node->text[0]) && !isdigit((unsigned char)node->text[0]) &&
           !strchr(node->text, '\'');
}

/** A constant of the given type, as a primary expression. */
static const char *constant_text(arena *a, int64_t value, const ir_type *type) {
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
    return arena_format(a, "(-%lld%s - 1)", (long long)-(value + 1), suffix); /* also of INT_MIN */
}

/** Names with marks. The meaning of an enumerator or a sizeof depends on its place; its value does
 *  not. */
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
    return text;
}

/** Postfix and primary expressions bind tighter than any cast or & before them. */
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
