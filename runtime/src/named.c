/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "named.h"

#include "base/memory.h"
#include "report.h"
#include "settings.h"
#include "spelling.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- reading --------------------------------------------------------------------------------- */

static void complain_of_method(const char *value) {
    enum { MOST = 32, LONGEST = 64 };
    char spelled[MOST][LONGEST];
    const char *names[MOST] = {"auto"};
    size_t count = 1;
    for (const struct method *const *method = redcc_methods; *method && count < MOST; method++) {
        const char *parameter = (*method)->parameter;
        snprintf(spelled[count], LONGEST, parameter ? "%s[:%s]" : "%s", (*method)->name, parameter);
        names[count] = spelled[count];
        count++;
    }
    redcc_complain_of_unknown("REDCC_METHOD", value, names, count);
}

static struct named_method parse_method(const char *value) {
    struct named_method named = {0};
    const size_t length = strcspn(value, ":");
    if (strcmp(value, "auto") == 0)
        return named;
    for (const struct method *const *each = redcc_methods; *each && !named.method; each++)
        if (redcc_method_is_named(*each, value, length))
            named.method = *each;
    if (named.method)
        named.parameter = named.method->usual;
    if (named.method && value[length] == ':')
        named.parameter = named.method->parse ? named.method->parse(value + length + 1) : 0;
    if (!named.method || (value[length] == ':' && !named.parameter))
        complain_of_method(value);
    return named;
}

/* Returns the line number in FILE:LINE and truncates the text at the colon. 0: there is no line
 * number. */
static int cut_line(char *place) {
    char *colon = strrchr(place, ':'), *end;
    if (!colon || colon == place || colon[1] < '0' || colon[1] > '9')
        return 0;
    const long line = strtol(colon + 1, &end, 10);
    if (*end || line > 1L << 30)
        return 0;
    *colon = '\0';
    return (int)line;
}

/* Is one name a suffix of the other, beginning at a path component? The name at compile time and
 * the name that the user gives may be relative to different directories. */
static bool is_same_file(const char *a, const char *b) {
    const size_t a_length = strlen(a), b_length = strlen(b);
    const char *longer = a_length > b_length ? a : b, *shorter = a_length > b_length ? b : a;
    const char *end = longer + strlen(longer) - strlen(shorter);
    return strcmp(end, shorter) == 0 && (end == longer || end[-1] == '/');
}

/* Adds an entry for `item`, FILE:LINE=METHOD. The entry takes ownership of `item`. */
static void read_loop(struct named *named, char *item, const char *whole) {
    char *equals = strrchr(item, '=');
    *equals = '\0';
    const struct named_method as = parse_method(equals + 1);
    const int line = cut_line(item);
    if (line == 0) {
        redcc_complain(
            "REDCC_METHOD=%s: '%s' is no FILE:LINE of a loop; the report (REDCC_REPORT=-) "
            "has them all",
            whole, item);
        return;
    }
    for (const struct named_loop *other = named->loops; other; other = other->next)
        if (other->line == line && is_same_file(other->file, item))
            redcc_complain("REDCC_METHOD=%s: two methods for %s:%d", whole, item, line);
    struct named_loop *loop = redcc_memory_alloc_zeroed(1, sizeof *loop);
    char *file = redcc_memory_copy_text(item);
    if (!loop || !file)
        return; /* out of memory: auto decides about this loop */
    *loop = (struct named_loop){.next = named->loops, .file = file, .line = line, .as = as};
    named->loops = loop;
}

void redcc_named_read(struct named *named, const char *value) {
    if (!value || !*value)
        return;
    if (!strpbrk(value, ",=")) { /* the usual case, without allocation */
        named->all = parse_method(value);
        return;
    }
    char *text = redcc_memory_copy_text(value);
    bool for_all = false;
    for (char *item = text; item;) {
        char *comma = strchr(item, ',');
        if (comma)
            *comma = '\0';
        if (strchr(item, '='))
            read_loop(named, item, value);
        else {
            if (for_all)
                redcc_complain("REDCC_METHOD=%s names two methods for all loops; write "
                               "FILE:LINE=METHOD for a single one",
                               value);
            for_all = true;
            named->all = parse_method(item);
        }
        item = comma ? comma + 1 : NULL;
    }
    redcc_memory_free(text);
}

/* ---- finding --------------------------------------------------------------------------------- */

const struct named_loop *redcc_named_find(const struct named *named, const redcc_loop *loop) {
    for (struct named_loop *each = named->loops; each; each = each->next)
        if (each->line == loop->line && is_same_file(each->file, loop->file)) {
            atomic_store_explicit(&each->met, 1, memory_order_relaxed);
            return each;
        }
    return NULL;
}

static const char *last_part(const char *file) {
    const char *slash = strrchr(file, '/');
    return slash ? slash + 1 : file;
}

/* The distance between an executed loop and the named loop. Loops of the same file differ by lines;
 * loops of other files are farther than those. */
static size_t distance_to(const struct named_loop *loop, const struct reported *reported) {
    const size_t lines = (size_t)labs((long)loop->line - (long)reported->line);
    const size_t letters =
        is_same_file(loop->file, reported->file)
            ? 0
            : 1 + redcc_spelling_distance(last_part(loop->file), last_part(reported->file));
    return (letters << 32) + lines;
}

void redcc_named_note_unmet(const struct named *named, const struct reported *reported) {
    for (struct named_loop *loop = named->loops; loop; loop = loop->next) {
        if (atomic_load(&loop->met) || !reported)
            continue;
        const struct reported *nearest = reported;
        for (const struct reported *each = reported; each; each = each->next)
            if (distance_to(loop, each) < distance_to(loop, nearest))
                nearest = each;
        fprintf(stderr,
                "redcc: REDCC_METHOD names %s:%d, but no translated loop that was executed is "
                "there; the nearest is %s:%d\n",
                loop->file, loop->line, nearest->file, nearest->line);
    }
}
