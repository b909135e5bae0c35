/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "driver/session.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "driver/build_report.h"
#include "driver/files.h"
#include "driver/temporary.h"

/* Greatest length of a command line; a longer one is passed in a response file. Linux accepts 2
 * MiB, including the environment, at the default stack limit. */
enum { COMMAND_BYTES_MAX = 512 * 1024 };

void session_read_options(session *s) {
    const char *text = getenv("REDCC_OPTS");
    if (text)
        words_split(s->memory, text, &s->options);
    if (s->remarks)
        words_add(s->memory, &s->options, "--report=text");
    for (unsigned i = 0; i < s->options.count; i++) {
        const char *word = s->options.items[i];
        if (strncmp(word, "--order=", 8) == 0)
            s->contracts = strcmp(word + 8, "any") == 0;
        else if (strcmp(word, "--order") == 0 && i + 1 < s->options.count)
            s->contracts = strcmp(s->options.items[i + 1], "any") == 0;
    }
}

const char *session_liberty(const session *s) {
    for (unsigned i = 0; !s->contracts && i < s->command.count; i++)
        if (s->command.items[i].meaning & OPTION_LIBERTY)
            return s->command.items[i].text;
    return NULL;
}

unsigned session_liberties(const session *s) {
    return session_liberty(s) ? OPTION_LIBERTY : 0;
}

static void show(const session *s, const word_list *words, process_streams streams) {
    (void)s;
    buffer line = {0};
    for (unsigned i = 0; i < words->count; i++) {
        if (i > 0)
            buffer_byte(&line, ' ');
        word_for_shell(&line, words->items[i]);
    }
    if (streams.input)
        buffer_format(&line, " <%s", streams.input);
    puts(line.data ? line.data : "");
    buffer_free(&line);
}

static word_list through_response_file(session *s, const word_list *words) {
    word_list head = {0}, rest = {0};
    size_t bytes = 0;
    for (unsigned i = 0; i < words->count; i++) {
        bytes += strlen(words->items[i]) + 1 + sizeof(char *);
        words_add(s->memory, i < s->real.words.count ? &head : &rest, words->items[i]);
    }
    if (bytes < COMMAND_BYTES_MAX || !s->folder)
        return *words;
    const char *path = arena_format(s->memory, "%s/arguments", s->folder);
    if (!words_write(&rest, path))
        return *words;
    words_add(s->memory, &head, arena_format(s->memory, "@%s", path));
    return head;
}

int session_run(session *s, const word_list *words, process_streams streams) {
    if (s->show) {
        show(s, words, streams);
        return 0;
    }
    word_list fitting = through_response_file(s, words);
    return process_run(s->memory, &fitting, streams);
}

static void say(const char *level, const char *format, va_list values) {
    buffer line = {0};
    char text[4096];
    vsnprintf(text, sizeof text, format, values);
    buffer_format(&line, "redcc-cc: %s: %s\n", level, text);
    fputs(line.data, stderr);
    buffer_free(&line);
}

void session_warn(const session *s, const char *format, ...) {
    (void)s;
    va_list values;
    va_start(values, format);
    say("warning", format, values);
    va_end(values);
}

void session_note(const session *s, const char *format, ...) {
    (void)s;
    va_list values;
    va_start(values, format);
    say("note", format, values);
    va_end(values);
}

void session_explain(const session *s, const char *format, ...) {
    if (!s->verbose)
        return;
    va_list values;
    va_start(values, format);
    say("note", format, values);
    va_end(values);
}

void session_read_environment(session *s) {
    const char *strict = getenv("REDCC_STRICT");
    s->strict = strict && *strict && strcmp(strict, "0") != 0;
    bool by_run;
    s->report = build_report_file(&by_run);
    if (by_run)
        fprintf(stderr,
                "redcc-cc: note: the build's report goes to '%s', which REDCC_REPORT names for "
                "runs; REDCC_BUILD_REPORT=FILE keeps the two apart\n",
                s->report);
}

void session_pass_by(session *s, const char *file, const char *why) {
    if (s->show)
        return;
    if (s->report && !build_report_append_left_alone(file, why, s->report))
        session_warn(s, "cannot append to '%s'", s->report);
    if (!s->strict && (s->verbose || s->remarks))
        session_note(s, "%s: compiled as it is: %s", file, why);
}

void session_leave_alone(session *s, const char *file, const char *why) {
    session_pass_by(s, file, why);
    if (s->show || !s->strict)
        return;
    fprintf(stderr, "redcc-cc: error: %s: not translated (REDCC_STRICT): %s\n", file, why);
    session_end(s, 1);
}

static void name_fallbacks(const session *s) {
    for (unsigned i = 0; i < s->fallbacks.count; i++)
        session_warn(s,
                     "%s: the translated text does not compile, but the source itself does and "
                     "was used; please report this with what REDCC_KEEP=DIR keeps of it",
                     s->fallbacks.items[i]);
    for (unsigned i = 0; i < s->unlinked.count; i++)
        session_warn(s,
                     "%s: the program does not link with its translated loops; the source itself "
                     "was used",
                     s->unlinked.items[i]);
}

static void remove_temporaries(const session *s) {
    for (unsigned i = 0; i < s->shared.count; i++)
        temporary_leave(s->shared.items[i]);
    if (s->folder && !s->show)
        temporary_remove(s->folder);
}

_Noreturn void session_end(session *s, int status) {
    if (status == 0)
        name_fallbacks(s);
    remove_temporaries(s);
    if (process_signal())
        status = -process_signal();
    arena_free(s->memory);
    process_end_as(status);
}

void session_add_original(session *s, word_list *list) {
    words_add_all(s->memory, list, &s->real.words);
    words_add_all(s->memory, list, &s->given);
}

_Noreturn void session_become_compiler(session *s) {
    if (s->only_reports)
        session_end(s, 0);
    word_list words = {0};
    session_add_original(s, &words);
    if (s->show) {
        show(s, &words, (process_streams){NULL, NULL, NULL});
        exit(0);
    }
    if (s->input ||
        s->fallbacks.count > 0) { /* standard input, already read, comes from the copy */
        int status = session_run(s, &words, (process_streams){s->input, NULL, NULL});
        session_end(s, status);
    }
    remove_temporaries(s);
    if (process_signal())
        process_end_as(-process_signal());
    process_become(s->memory, &words);
}
