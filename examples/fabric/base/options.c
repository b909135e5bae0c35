/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "options.h"

#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "words.h"

enum { MOST_OPTIONS = 32 };

/** Results of read_next other than an option's index in the table. */
enum { END = -1, WORD = -2, HELP = -3, WRONG = -4 };

const char *program_name = "fabric";

int options_complain(const command *of, const char *format, ...) {
    va_list arguments;
    fprintf(stderr, "%s %s: ", program_name, of->name);
    va_start(arguments, format);
    vfprintf(stderr, format, arguments);
    va_end(arguments);
    fputc('\n', stderr);
    return EXIT_USAGE;
}

static void print_help(const command *of) {
    printf("usage: %s %s %s\n\n%s\n\n", program_name, of->name, of->synopsis, of->summary);
    for (const option *o = of->options; o->name; o++) {
        const int width =
            printf("  %s%s%s", o->name, o->argument ? " " : "", o->argument ? o->argument : "");
        printf("%*s%s\n", width < 26 ? 26 - width : 1, "", o->help);
    }
    printf("  --help%*sthis text\n", 18, "");
}

static int complain_unknown(const options *o, const char *word, int length) {
    const char *names[MOST_OPTIONS + 1];
    char name[64];
    int count = 0;
    while (count < MOST_OPTIONS && o->of->options[count].name) {
        names[count] = o->of->options[count].name;
        count++;
    }
    names[count++] = "--help";
    snprintf(name, sizeof name, "%.*s", length, word);
    const char *nearest = words_nearest(name, names, count);
    if (nearest)
        options_complain(o->of, "unknown option '%s', did you mean '%s'?", name, nearest);
    else
        options_complain(o->of, "unknown option '%s', --help lists the known ones", name);
    return WRONG;
}

/** Sets o->value to the option's value, which follows '=' or is the next argument. Returns 0, or -1
 *  after a message. */
static int take_value(options *o, const option *known, const char *equals) {
    o->value = NULL;
    if (!known->argument && equals) {
        options_complain(o->of, "option '%s' takes no value", known->name);
        return -1;
    }
    if (!known->argument)
        return 0;
    if (equals)
        o->value = equals + 1;
    else if (o->next < o->argc)
        o->value = o->argv[o->next++];
    if (o->value)
        return 0;
    options_complain(o->of, "option '%s' needs a value: %s", known->name, known->argument);
    return -1;
}

/** Reads the next argument. Returns an option's index in the table, or END, WORD, HELP or WRONG. */
static int read_next(options *o) {
    if (o->next >= o->argc)
        return END;
    const char *word = o->argv[o->next++];
    o->value = word;
    if (!o->only_words && strcmp(word, "--") == 0) {
        o->only_words = 1;
        return read_next(o);
    }
    if (o->only_words || word[0] != '-' || word[1] == '\0')
        return WORD;
    if (strcmp(word, "--help") == 0) {
        print_help(o->of);
        return HELP;
    }
    const char *equals = word[1] == '-' ? strchr(word, '=') : NULL;
    const size_t length = equals ? (size_t)(equals - word) : strlen(word);
    for (int k = 0; o->of->options[k].name; k++)
        if (strlen(o->of->options[k].name) == length &&
            memcmp(o->of->options[k].name, word, length) == 0)
            return take_value(o, &o->of->options[k], equals) == 0 ? k : WRONG;
    return complain_unknown(o, word, (int)length);
}

static int read_whole(const options *o, const option *known, long *value) {
    const long low = (long)known->low, high = (long)known->high;
    char *end;
    errno = 0;
    *value = strtol(o->value, &end, 10);
    if (end != o->value && *end == '\0' && errno == 0 && *value >= low && *value <= high)
        return 0;
    options_complain(o->of, "%s is '%s', expected a whole number from %ld to %ld", known->name,
                     o->value, low, high);
    return -1;
}

static int read_number(const options *o, const option *known, double *value) {
    char *end;
    *value = strtod(o->value, &end);
    if (end != o->value && *end == '\0' && isfinite(*value) && *value >= known->low)
        return 0;
    options_complain(o->of, "%s is '%s', expected a number, %g or more", known->name, o->value,
                     known->low);
    return -1;
}

int options_choice(const options *o, const char *name, const char *const *choices) {
    char list[256] = "";
    int count = 0;
    for (; choices[count]; count++) {
        if (strcmp(o->value, choices[count]) == 0)
            return count;
        const size_t used = strlen(list);
        snprintf(list + used, sizeof list - used, count == 0 ? "'%s'" : ", '%s'", choices[count]);
    }
    const char *nearest = words_nearest(o->value, choices, count);
    options_complain(o->of, "%s is '%s', expected one of %s%s%s%s", name, o->value, list,
                     nearest ? "; did you mean '" : "", nearest ? nearest : "",
                     nearest ? "'?" : "");
    return -1;
}

int options_only_word(const options *o, const char **text, const char *what) {
    if (*text)
        return options_complain(o->of, "one %s at a time, not '%s' as well", what, o->value);
    *text = o->value;
    return 0;
}

static int store(const options *o, const option *known, void *to) {
    switch (known->kind) {
    case OPTION_TEXT:
        *(const char **)to = o->value;
        return 0;
    case OPTION_FLAG:
        *(int *)to = 1;
        return 0;
    case OPTION_WHOLE:
        return read_whole(o, known, to);
    case OPTION_NUMBER:
        return read_number(o, known, to);
    case OPTION_CHOICE:
        *(int *)to = options_choice(o, known->name, known->choices);
        return *(int *)to < 0;
    case OPTION_OWN:
        break;
    }
    return known->take(o, to);
}

int options_read(const command *of, int argc, char **argv, void *request, option_taker *take_word) {
    options o = {of, argc, argv, 0, NULL, 0};
    for (int next; (next = read_next(&o)) != END;) {
        if (next == HELP)
            return EXIT_SUCCESS;
        if (next == WRONG ||
            (next == WORD
                 ? take_word(&o, request)
                 : store(&o, &of->options[next], (char *)request + of->options[next].offset)) != 0)
            return EXIT_USAGE;
    }
    return OPTIONS_READ;
}
