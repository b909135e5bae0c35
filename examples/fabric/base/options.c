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
    return OPTIONS_WRONG;
}

/** An option's value: after its '=', or the next word. */
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

int options_next(options *o) {
    if (o->next >= o->argc)
        return OPTIONS_END;
    const char *word = o->argv[o->next++];
    o->value = word;
    if (!o->only_words && strcmp(word, "--") == 0) {
        o->only_words = 1;
        return options_next(o);
    }
    if (o->only_words || word[0] != '-' || word[1] == '\0')
        return OPTIONS_WORD;
    if (strcmp(word, "--help") == 0) {
        print_help(o->of);
        return OPTIONS_HELP;
    }
    const char *equals = word[1] == '-' ? strchr(word, '=') : NULL;
    const size_t length = equals ? (size_t)(equals - word) : strlen(word);
    for (int k = 0; o->of->options[k].name; k++)
        if (strlen(o->of->options[k].name) == length &&
            memcmp(o->of->options[k].name, word, length) == 0)
            return take_value(o, &o->of->options[k], equals) == 0 ? k : OPTIONS_WRONG;
    return complain_unknown(o, word, (int)length);
}

int options_whole(const options *o, const char *name, long low, long high, long *value) {
    char *end;
    errno = 0;
    *value = strtol(o->value, &end, 10);
    if (end != o->value && *end == '\0' && errno == 0 && *value >= low && *value <= high)
        return 0;
    options_complain(o->of, "%s is '%s', expected a whole number from %ld to %ld", name, o->value,
                     low, high);
    return -1;
}

int options_number(const options *o, const char *name, double low, double *value) {
    char *end;
    *value = strtod(o->value, &end);
    if (end != o->value && *end == '\0' && isfinite(*value) && *value >= low)
        return 0;
    options_complain(o->of, "%s is '%s', expected a number, %g or more", name, o->value, low);
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
