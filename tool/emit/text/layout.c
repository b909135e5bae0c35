/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "emit/text/layout.h"

#include <assert.h>
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "emit/text/origin.h"
#include "emit/text/text.h"
#include "support/arena.h"
#include "support/vector.h"

enum { MOST_INDENT = 40, CONTINUED_INDENT = 4 };

/** A visible byte of the text. */
typedef struct letter {
    char byte;
    bool is_copy;   /* of the user's file, at offset `from` */
    bool is_within; /* in a literal, a comment or a directive that began before it */
    bool is_quiet;  /* in one of these, or their beginning */
    uint32_t from;
    unsigned depth;   /* the number of open parentheses and brackets before the letter */
    const char *mark; /* `mark_length` bytes of marks before the letter */
    size_t mark_length;
} letter;

/** A range of letters. */
typedef struct span {
    unsigned begin, end;
} span;

typedef struct layout {
    arena *arena;
    buffer *out;
    VECTOR(letter) text; /* ends with a letter 0, which may have marks before it */
    unsigned line;       /* the number of the user's line */
    unsigned next;       /* the number that compilers give to the next line of the output */
    bool has_line;       /* the user's text has directives that number lines */
} layout;

static const letter *letter_at(const layout *it, unsigned i) {
    assert(i < it->text.count);
    return &it->text.items[i];
}

/* ---- reading ------------------------------------------------------------------------------- */

static void add_letters(layout *it, const char *bytes, size_t length, letter first) {
    for (size_t i = 0; i < length; i++) {
        first.byte = bytes[i];
        VECTOR_PUSH(it->arena, &it->text, first);
        first.from++;
        first.mark_length = 0;
    }
}

static void read_letters(layout *it, const char *marked) {
    const char *at = marked, *mark = marked, *const end = marked + strlen(marked);
    while (at < end) {
        letter first = {.mark = mark, .mark_length = (size_t)(at - mark)};
        const char *const after = origin_skip(at, end);
        const char *const bytes = origin_copied(at, end, &first.from);
        if (bytes || after == at) {
            first.is_copy = bytes != NULL;
            mark = bytes ? after : at + 1;
            add_letters(it, bytes ? bytes : at, (size_t)(mark - (bytes ? bytes : at)), first);
            at = mark;
        } else {
            at = after;
        }
    }
    const letter last = {.mark = mark, .mark_length = (size_t)(end - mark)};
    VECTOR_PUSH(it->arena, &it->text, last);
}

/** The state between two letters. */
typedef struct scan {
    char within;     /* a literal's quote; '*' or '/': a comment; '#': a directive; 0: none */
    bool is_first;   /* only blanks since the line's begin */
    bool is_escaped; /* the next byte of a literal is escaped */
    unsigned begin;  /* where the comment begins */
    unsigned depth;
} scan;

/** Does this directive number lines (`#line 7`, `# 7`)? */
static bool numbers_lines(const letter *sign) {
    do
        sign++;
    while (sign->byte == ' ' || sign->byte == '\t');
    return sign->byte == 'l' || isdigit((unsigned char)sign->byte);
}

static void scan_within(scan *s, const letter *at, unsigned i) {
    const bool is_literal = s->within == '"' || s->within == '\'';
    const char before = i > 0 ? at[-1].byte : 0;
    if (is_literal && !s->is_escaped && at->byte == s->within)
        s->within = 0;
    else if (is_literal)
        s->is_escaped = at->byte == '\\' && !s->is_escaped;
    else if (s->within == '*' && at->byte == '/' && before == '*' && i > s->begin + 2)
        s->within = 0;
    else if (s->within != '*' && at->byte == '\n' && before != '\\')
        s->within = 0;
}

static void scan_outside(scan *s, const letter *at, unsigned i) {
    const char byte = at->byte, next = byte ? at[1].byte : 0;
    if (byte == '"' || byte == '\'')
        s->within = byte;
    else if (byte == '/' && (next == '*' || next == '/'))
        s->within = next;
    else if (byte == '#' && s->is_first)
        s->within = '#';
    else if (byte == '(' || byte == '[')
        s->depth++;
    else if ((byte == ')' || byte == ']') && s->depth > 0)
        s->depth--;
    s->begin = i;
    s->is_escaped = false;
}

static void scan_letters(layout *it) {
    scan s = {0};
    for (unsigned i = 0; i + 1 < it->text.count; i++) {
        letter *const at = &it->text.items[i];
        at->depth = s.depth;
        at->is_within = s.within != 0;
        if (s.within)
            scan_within(&s, at, i);
        else
            scan_outside(&s, at, i);
        at->is_quiet = at->is_within || s.within;
        it->has_line |= s.within == '#' && !at->is_within && numbers_lines(at);
        s.is_first = at->byte == '\n' || (s.is_first && strchr(" \t\r", at->byte));
    }
}

/* ---- writing ------------------------------------------------------------------------------- */

static void put_marks(layout *it, unsigned i) {
    const letter *at = letter_at(it, i);
    buffer_append(it->out, at->mark, at->mark_length);
}

/** Appends letters. Copies that are consecutive in the file become one. */
static void put(layout *it, span part) {
    buffer bytes = {0};
    for (unsigned i = part.begin; i < part.end;) {
        const letter *const first = letter_at(it, i);
        put_marks(it, i);
        do
            buffer_byte(&bytes, letter_at(it, i++)->byte);
        while (i < part.end && first->is_copy && letter_at(it, i)->is_copy &&
               letter_at(it, i)->mark_length == 0 &&
               letter_at(it, i)->from == letter_at(it, i - 1)->from + 1);
        if (first->is_copy)
            origin_copy_bytes(it->out, bytes.data, first->from, (uint32_t)bytes.length);
        else
            buffer_append(it->out, bytes.data, bytes.length);
        buffer_shorten(&bytes, bytes.length);
    }
    buffer_free(&bytes);
}

static void end_line(layout *it) {
    buffer_byte(it->out, '\n');
    it->next++;
}

/** Makes the next line of the output belong to the user's line. */
static void number_line(layout *it) {
    if (it->next != it->line)
        buffer_format(it->out, "#line %u\n", it->line);
    it->next = it->line;
}

/* ---- parts of a line ------------------------------------------------------------------------ */

static bool is_blank(const layout *it, unsigned i) {
    const char byte = letter_at(it, i)->byte;
    return byte == ' ' || byte == '\t' || byte == '\r';
}

static span trimmed(const layout *it, span part) {
    while (part.begin < part.end && is_blank(it, part.begin))
        part.begin++;
    while (part.end > part.begin && is_blank(it, part.end - 1))
        part.end--;
    return part;
}

/** Does a statement, or text inserted before one, begin after the blank i? What is inserted before
 * a statement ends with a blank, and what is inserted after it begins with a blank. A text that
 * replaces a name does neither. */
static bool divides(const layout *it, span line, unsigned i) {
    const letter *const blank = letter_at(it, i), *const after = letter_at(it, i + 1);
    unsigned last = i;
    if (!is_blank(it, i) || blank->is_quiet || blank->depth > 0 || i + 1 == line.end ||
        is_blank(it, i + 1))
        return false;
    while (last > line.begin && is_blank(it, last))
        last--;
    const letter *const before = letter_at(it, last);
    if (is_blank(it, last))
        return false;
    if (before->is_copy != after->is_copy)
        return !blank->is_copy || after->byte == '{';
    if (before->is_copy || !strchr(";{})", before->byte))
        return false;
    return before->byte != ')' || !strchr("=+-*/%<>&|^?:,.){", after->byte);
}

/** The number of statements that end in the part; of inserted ones if `is_inserted`. */
static unsigned statement_count(const layout *it, span part, bool is_inserted) {
    unsigned count = 0;
    for (unsigned i = part.begin; i < part.end; i++) {
        const letter *at = letter_at(it, i);
        count +=
            at->byte == ';' && !at->is_quiet && at->depth == 0 && !(is_inserted && at->is_copy);
    }
    return count;
}

/** Does the part consist of these bytes, and, if `or_quiet`, of comments? */
static bool consists_of(const layout *it, span part, const char *bytes, bool or_quiet) {
    for (unsigned i = part.begin; i < part.end; i++)
        if (!is_blank(it, i) && !strchr(bytes, letter_at(it, i)->byte) &&
            !(or_quiet && letter_at(it, i)->is_quiet))
            return false;
    return true;
}

static bool begins_with(const layout *it, span part, const char *word) {
    for (; *word; word++, part.begin++)
        if (part.begin >= part.end || letter_at(it, part.begin)->byte != *word)
            return false;
    return true;
}

/** Is the part a call of a macro of redcc's headers? Compilers charge all of a call to the line of
 * its name. */
static bool is_own_call(const layout *it, span part) {
    while (part.begin < part.end && strchr(" {", letter_at(it, part.begin)->byte))
        part.begin++;
    return begins_with(it, part, "REDCC_");
}

/** Where to break a part that begins at column `indent` and is too long for a line: at a blank
 * outside of parentheses; in calls of redcc's macros, after a comma. Sets *is_outside if a
 * directive can follow. Returns part.end if there is no place. */
static unsigned line_break(const layout *it, span part, unsigned indent, bool *is_outside) {
    unsigned comma = part.end, blank = part.end, outside = part.end;
    const bool is_call = is_own_call(it, part), is_header = begins_with(it, part, "for (");
    for (unsigned i = part.begin + 1; i < part.end && indent + (i - part.begin) <= MOST_COLUMNS;
         i++) {
        if (!is_blank(it, i) || letter_at(it, i)->is_quiet)
            continue;
        const char before = letter_at(it, i - 1)->byte, after = letter_at(it, i + 1)->byte;
        if (is_header ? before == ';' : letter_at(it, i)->depth == 0 && after != '(')
            outside = i;
        else if (before == ',' &&
                 (comma == part.end || letter_at(it, i)->depth <= letter_at(it, comma)->depth))
            comma = i;
        else
            blank = i;
    }
    *is_outside = outside != part.end && !(is_call && comma != part.end);
    return *is_outside ? outside : comma != part.end ? comma : blank;
}

static void write_part(layout *it, span part, unsigned indent) {
    const unsigned continued = (indent < MOST_INDENT ? indent : MOST_INDENT) + CONTINUED_INDENT;
    bool is_outside = false;
    while (part.begin < part.end) {
        const unsigned stop = indent + (part.end - part.begin) <= MOST_COLUMNS
                                  ? part.end
                                  : line_break(it, part, indent, &is_outside);
        put(it, (span){part.begin, stop});
        put_marks(it, stop);
        if (stop == part.end)
            return;
        part = trimmed(it, (span){stop, part.end});
        end_line(it);
        if (is_outside)
            number_line(it);
        indent = continued;
        for (unsigned i = 0; i < indent; i++)
            buffer_byte(it->out, ' ');
    }
}

/** The longest part that begins at `begin`, has at most one statement, and fits in a line, if there
 * is one. Parts end where `divides` allows it, but not after an opening brace. */
static span next_part(const layout *it, span line, unsigned begin, unsigned indent) {
    span part = {begin, begin};
    for (unsigned end = begin + 1; end <= line.end; end++) {
        if (end < line.end && !divides(it, line, end - 1))
            continue;
        const span longer = trimmed(it, (span){begin, end});
        const span added = {part.end, end};
        const bool is_open = consists_of(it, part, "{", false);
        const bool fits =
            indent + (longer.end - longer.begin) <= MOST_COLUMNS &&
            (statement_count(it, part, false) == 0 || consists_of(it, added, "}", true));
        if (!is_open && !fits)
            break;
        part.end = end;
    }
    return part;
}

static void write_divided(layout *it, span line, unsigned column) {
    const span rest = trimmed(it, line);
    put(it, (span){line.begin, rest.begin});
    unsigned indent = column + (rest.begin - line.begin);
    for (unsigned at = rest.begin; at < rest.end;) {
        const span part = next_part(it, rest, at, indent);
        if (at > rest.begin) {
            end_line(it);
            if (!consists_of(it, part, "{}", false))
                number_line(it);
            for (unsigned i = 0; i < indent; i++)
                buffer_byte(it->out, ' ');
        }
        write_part(it, trimmed(it, part), indent);
        at = part.end;
        indent = indent < MOST_INDENT ? indent : MOST_INDENT;
    }
}

static void write_line(layout *it, span line, unsigned column) {
    bool has_own = false;
    for (unsigned i = line.begin; i < line.end; i++)
        has_own |= !letter_at(it, i)->is_copy && !is_blank(it, i);
    const letter *const first = letter_at(it, line.begin);
    const bool is_spliced = line.begin > 1 && letter_at(it, line.begin - 2)->byte == '\\';
    if (line.begin > 0 && first->depth == 0 && !first->is_within && !is_spliced)
        number_line(it);
    if (has_own &&
        (column + line.end - line.begin > MOST_COLUMNS || statement_count(it, line, true) > 1)) {
        write_divided(it, line, column);
    } else {
        put(it, line);
        put_marks(it, line.end);
    }
}

void layout_copy(buffer *out, const char *marked, unsigned line, unsigned column) {
    layout it = {.arena = arena_new(), .out = out, .line = line, .next = line};
    read_letters(&it, marked);
    scan_letters(&it);
    const unsigned end = it.text.count - 1;
    if (it.has_line)
        buffer_text(out, marked);
    for (unsigned begin = 0, stop; !it.has_line && begin <= end; begin = stop + 1) {
        for (stop = begin; stop < end && letter_at(&it, stop)->byte != '\n';)
            stop++;
        write_line(&it, (span){begin, stop}, begin > 0 ? 0 : column);
        if (stop < end)
            end_line(&it);
        it.line++;
    }
    arena_free(it.arena);
}

/* ---- directives ----------------------------------------------------------------------------- */

void layout_directive(buffer *out, const char *marked) {
    layout it = {.arena = arena_new(), .out = out};
    read_letters(&it, marked);
    const unsigned end = it.text.count - 1;
    unsigned place = end; /* the last place on this line where it may be broken */
    char quote = 0;
    for (unsigned i = 0, begin = 0, at = 0, indent = 0; i <= end; i++) {
        const char byte = letter_at(&it, i)->byte;
        if (indent + (i - begin) >= MOST_COLUMNS - 1 && place != end) {
            put(&it, (span){at, place});
            buffer_text(out, " \\\n    ");
            at = begin = place + 1;
            indent = CONTINUED_INDENT;
            place = end;
        }
        if (byte == '\n') {
            begin = i + 1;
            indent = 0;
            place = end;
        }
        if (quote ? byte == quote : byte == '"' || byte == '\'')
            quote = quote ? 0 : byte;
        if (!quote && byte == ' ' && strchr(",)", letter_at(&it, i - 1)->byte))
            place = i;
        if (i == end)
            put(&it, (span){at, end});
    }
    put_marks(&it, end);
    buffer_byte(out, '\n');
    arena_free(it.arena);
}
