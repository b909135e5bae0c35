/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "driver/build.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "driver/cache.h"
#include "driver/compiled.h"
#include "driver/files.h"
#include "driver/linked_loops.h"
#include "support/source.h"

/* One run of the compiler, whose messages are held back until its result is accepted. */
typedef struct attempt {
    int status;
    bool same; /* for a translated text: the compiler read the same headers as for the source */
    const char *output;
    const char *error;
} attempt;

static attempt new_attempt(session *s) {
    unsigned number = s->attempts++;
    return (attempt){.output = arena_format(s->memory, "%s/output-%u", s->folder, number),
                     .error = arena_format(s->memory, "%s/error-%u", s->folder, number)};
}

static attempt try_command(session *s, const word_list *words, const char *input) {
    attempt made = new_attempt(s);
    made.status = session_run(s, words, (process_streams){input, made.output, made.error});
    return made;
}

static void show_attempt(const session *s, const attempt *made) {
    if (s->show)
        return;
    file_show(made->output, stdout);
    file_show(made->error, stderr);
}

/* Was the run interrupted? A signal to this process, or SIGINT or SIGTERM to the compiler, ends the
 * build without another attempt. */
static bool was_interrupted(const attempt *made) {
    return process_signal() || made->status == -SIGINT || made->status == -SIGTERM;
}

/* Adds the option for coloured messages. Without it the compiler prints no colours, because its
 * messages go to a file. */
static void add_colour(session *s, word_list *list) {
    const char *terminal = getenv("TERM");
    bool chosen = false;
    for (unsigned i = 0; i < s->command.count; i++)
        chosen |= strncmp(s->command.items[i].text, "-fdiagnostics-", 14) == 0 ||
                  strstr(s->command.items[i].text, "color-diagnostics") != NULL;
    if (!chosen && isatty(STDERR_FILENO) && terminal && strcmp(terminal, "dumb") != 0)
        words_add(s->memory, list, "-fdiagnostics-color=always");
}

bool build_can_add_runtime(const session *s) {
    return s->command.links && s->tools.library && !s->real.is_cross &&
           !(s->command.meaning & OPTION_NO_RUNTIME);
}

/* Adds the runtime if a linked object has loops for it. The loops refer to the runtime only weakly,
 * and a linker loads no part of an archive for a weak reference. */
static void add_runtime(session *s, word_list *list, bool has_loops) {
    arena *a = s->memory;
    if (!build_can_add_runtime(s) || !(has_loops || loops_are_linked(s)))
        return;
    const char *const library = s->tools.library;
    if (s->command.language)
        words_add(a, list, "-xnone");
    if (source_ends_with(library, ".so")) {
        words_add(a, list, "-Wl,--push-state,--no-as-needed");
        words_add(a, list, library);
        words_add(a, list, "-Wl,--pop-state");
        words_add(a, list, arena_format(a, "-Wl,-rpath,%s", path_folder(a, library)));
        return;
    }
    words_add(a, list, "-Wl,-u,redcc_run,--push-state,--as-needed");
    words_add(a, list, library);
    words_add(a, list, "-lpthread");
    words_add(a, list, "-lm");
    words_add(a, list, "-Wl,--pop-state");
}

/* Runs the original command. If it links objects with loops, the runtime is added. If the link with
 * the runtime fails, the command is repeated without it. */
static _Noreturn void build_original(session *s) {
    if (!build_can_add_runtime(s) || !loops_are_linked(s))
        session_become_compiler(s);
    word_list with_runtime = {0}, plain = {0};
    session_add_original(s, &with_runtime);
    add_colour(s, &with_runtime);
    add_runtime(s, &with_runtime, true);
    attempt first = try_command(s, &with_runtime, s->input);
    if (first.status == 0 || was_interrupted(&first)) {
        show_attempt(s, &first);
        session_end(s, first.status);
    }
    session_add_original(s, &plain);
    if (file_is_empty(first.error) && file_is_empty(first.output))
        session_become_compiler(s); /* the linker's messages were lost (a full disk) */
    attempt second = try_command(s, &plain, s->input);
    show_attempt(s, second.status == 0 ? &second : &first);
    if (second.status == 0)
        session_warn(s, "linked without the runtime: with it the linker fails");
    session_end(s, second.status == 0 ? 0 : first.status);
}

/* Adds the command with its one source replaced by the translated text. */
static void add_replaced(session *s, word_list *list, const translation *t) {
    words_add_all(s->memory, list, &s->real.words);
    translation_add_before(s, list, t);
    for (unsigned i = 0; i < s->command.count; i++) {
        const item *one = &s->command.items[i];
        if (one == t->source && !t->is_input)
            words_add(s->memory, list, t->text);
        else if (one->meaning & OPTION_DEPENDENCY)
            continue;
        else if (session_liberty(s))
            item_add_strict(s->memory, list, one);
        else
            item_add(s->memory, list, one);
    }
    translation_add_after(s, list, t);
    add_colour(s, list);
    add_runtime(s, list, true);
}

/* Adds the command that compiles one translated text to `object`. If `object` is NULL, the
 * command's own -c or -S is kept, with its default output. */
static void add_alone(session *s, word_list *list, const translation *t, const char *object) {
    arena *a = s->memory;
    words_add_all(a, list, &s->real.words);
    translation_add_before(s, list, t);
    command_add_options(a, list, &s->command,
                        OPTION_DEPENDENCY | OPTION_LINKER | session_liberties(s));
    translation_add_after(s, list, t);
    add_colour(s, list);
    if (object) {
        words_add(a, list, "-c");
        words_add(a, list, "-o");
        words_add(a, list, object);
    }
    words_add(a, list, "-x");
    words_add(a, list, "c");
    words_add(a, list, t->is_input ? "-" : t->text);
}

/* Compiles the source itself, only for its messages. The messages are cached, because otherwise
 * every build would compile a source with warnings twice. */
static attempt compile_for_messages(session *s, const translation *t) {
    arena *a = s->memory;
    word_list words = {0};
    words_add_all(a, &words, &s->real.words);
    command_add_options(a, &words, &s->command,
                        OPTION_DEPENDENCY | OPTION_AUXILIARY |
                            (s->command.links ? OPTION_LINKER : 0));
    add_colour(s, &words);
    words_add(a, &words, "-c");
    words_add(a, &words, "-o");
    words_add(a, &words, arena_format(a, "%s/messages.o", t->folder));
    words_add(a, &words, "-x");
    words_add(a, &words, "c");
    words_add(a, &words, t->source->text);
    attempt made = new_attempt(s);
    const cached_run run = {.program = CACHE_COMPILER,
                            .words = &words,
                            .streams = {t->is_input ? s->input : NULL, made.output, made.error},
                            .outputs = {made.output, made.error}};
    made.status = cached_run_program(s, t->cached, &run);
    cached_end(s, t->cached);
    return made;
}

static attempt try_text(session *s, const translation *t, const word_list *words,
                        const char *object) {
    attempt made = new_attempt(s);
    made.status = compiled_text(
        s, t, words, object,
        (process_streams){t->is_input ? t->text : NULL, made.output, made.error}, &made.same);
    return made;
}

/* Compiles a translated text. The text contains a loop's body several times, so the compiler would
 * repeat each warning. The messages shown are therefore those for the source itself. With -Werror
 * the text may fail because of warnings that the source does not have. In that case it is compiled
 * once more without warnings. */
static attempt compile_text(session *s, const translation *t, word_list *words,
                            const char *object) {
    attempt made = try_text(s, t, words, object);
    if (s->show || s->verbose || was_interrupted(&made) ||
        (made.status == 0 && file_is_empty(made.error)))
        return made;
    attempt plain = compile_for_messages(s, t);
    if (was_interrupted(&plain))
        return plain;
    if (plain.status != 0) {
        made.status = plain.status;
        made.error = NULL; /* the source has the error, not its translation */
        return made;
    }
    if (made.status != 0) {
        words_add(s->memory, words, "-w");
        made = try_text(s, t, words, object);
    }
    if (made.status == 0)
        made.error = plain.error;
    return made;
}

/* Prints a note that the file's results may differ from those of a build with an option such as
 * -Ofast. */
static void note_liberty(const session *s, const translation *t) {
    const char *liberty = session_liberty(s);
    if (liberty && !s->show)
        session_note(s,
                     "%s: has parallel loops and is compiled without %s's freedom to reorder "
                     "arithmetic; REDCC_OPTS=--order=any keeps it",
                     t->source->text, liberty);
}

/* Compiles a translated text, and shows its messages if it succeeds. Returns whether it succeeds
 * and reads the source's own headers. */
static bool compile(session *s, const translation *t, word_list *words, const char *object) {
    attempt made = compile_text(s, t, words, object);
    if (was_interrupted(&made))
        session_end(s, made.status);
    const bool same = made.status == 0 && made.same;
    if (same) {
        cached_end(s, t->cached);
        show_attempt(s, &made);
        note_liberty(s, t);
    } else if (made.status == 0)
        session_leave_alone(s, t->source->text, "the compiler would find other headers");
    else if (made.error)
        words_add(s->memory, &s->fallbacks, t->source->text);
    translation_keep(s, t, same, made.status == 0 ? NULL : made.error);
    if (made.status != 0 && made.error)
        session_leave_alone(s, t->source->text, "its translated text does not compile");
    return same;
}

/* Makes the compiler write the requested dependency files for the sources themselves, so that the
 * files have the names and contents that the compiler gives them. */
static bool write_dependencies(session *s, const translation *first) {
    if (!(s->command.meaning & OPTION_DEPENDENCY))
        return true;
    word_list words = {0};
    session_add_original(s, &words);
    words_add(s->memory, &words, "-fsyntax-only");
    return compiled_dependencies(s, first, &words) == 0;
}

/* Runs the original command although sources were translated. Reports `why` for each such
 * source. */
static _Noreturn void build_untranslated(session *s, const translation *translations,
                                         unsigned count, const char *why) {
    for (unsigned i = 0; i < count; i++)
        if (translations[i].text)
            session_leave_alone(s, translations[i].source->text, why);
    build_original(s);
}

static const char no_dependencies[] = "its dependency file cannot be written";

static _Noreturn void build_one(session *s, const translation *t) {
    word_list words = {0};
    add_replaced(s, &words, t);
    if (!write_dependencies(s, t))
        build_untranslated(s, t, 1, no_dependencies);
    if (!compile(s, t, &words, NULL))
        build_original(s);
    session_end(s, 0);
}

/* The translation that replaces this item of the command, or NULL. */
static const translation *translation_of(const item *one, const translation *translations,
                                         const bool *done, unsigned count) {
    for (unsigned i = 0; i < count; i++)
        if (done[i] && translations[i].source == one)
            return &translations[i];
    return NULL;
}

static const char *object_of(session *s, const translation *t) {
    return arena_format(s->memory, "%s/%s.o", t->folder, path_base(t->text));
}

/* Completes a command with -c or -S and several sources. The sources whose translated texts are not
 * used are compiled together. */
static _Noreturn void build_separately(session *s, const translation *translations,
                                       const bool *done, unsigned count) {
    word_list rest = {0};
    bool any = false;
    words_add_all(s->memory, &rest, &s->real.words);
    for (unsigned i = 0; i < s->command.count; i++) {
        const item *one = &s->command.items[i];
        if (translation_of(one, translations, done, count))
            continue;
        item_add(s->memory, &rest, one);
        any |= one->kind == INPUT_C || one->kind == INPUT_COMPILE;
    }
    int status = any ? session_run(s, &rest, (process_streams){s->input, NULL, NULL}) : 0;
    session_end(s, status);
}

static bool any_done(const bool *done, unsigned count) {
    for (unsigned i = 0; i < count; i++)
        if (done[i])
            return true;
    return false;
}

/* Links the program: the objects of the translated texts replace their sources in the command. */
static _Noreturn void build_linked(session *s, const translation *translations, const bool *done,
                                   unsigned count) {
    arena *a = s->memory;
    word_list words = {0};
    words_add_all(a, &words, &s->real.words);
    for (unsigned i = 0; i < s->command.count; i++) {
        const item *one = &s->command.items[i];
        const translation *t = translation_of(one, translations, done, count);
        if (!t) {
            if (!(one->meaning & OPTION_DEPENDENCY))
                item_add(a, &words, one);
            continue;
        }
        words_add(a, &words, "-xnone");
        words_add(a, &words, object_of(s, t));
        if (one->language)
            words_add(a, &words, arena_format(a, "-x%s", one->language));
    }
    add_colour(s, &words);
    add_runtime(s, &words, any_done(done, count));
    if (s->real.is_clang) /* the link has options that only the compilations needed */
        words_add(a, &words, "-Qunused-arguments");
    attempt made = try_command(s, &words, s->input);
    if (made.status != 0 && !was_interrupted(&made) && !s->strict) {
        for (unsigned i = 0; i < count; i++)
            if (done[i])
                words_add(a, &s->unlinked, translations[i].source->text);
        build_original(s);
    }
    show_attempt(s, &made);
    session_end(s, made.status);
}

static _Noreturn void build_several(session *s, const translation *translations, unsigned count) {
    bool *done = ARENA_ARRAY(s->memory, bool, count);
    if (s->command.links && (s->command.meaning & OPTION_AUXILIARY))
        build_untranslated(s, translations, count,
                           "an option asks for files other than objects, and several sources are "
                           "compiled and linked in one command");
    if (!s->command.links && s->command.output)
        build_original(s); /* one name for several objects: the compiler will report it */
    if (!write_dependencies(s, translations))
        build_untranslated(s, translations, count, no_dependencies);
    for (unsigned i = 0; i < count; i++) {
        const translation *t = &translations[i];
        if (!t->text)
            continue;
        word_list words = {0};
        const char *object = s->command.links ? object_of(s, t) : NULL;
        add_alone(s, &words, t, object);
        done[i] = compile(s, t, &words, object);
    }
    if (s->command.links)
        build_linked(s, translations, done, count);
    build_separately(s, translations, done, count);
}

_Noreturn void build(session *s, const translation *translations, unsigned count) {
    unsigned translated = 0;
    for (unsigned i = 0; i < count; i++) {
        translated += translations[i].text != NULL;
        if (s->only_reports || !translations[i].text)
            translation_keep(s, &translations[i], s->only_reports, NULL);
    }
    if (process_signal())
        session_end(s, -process_signal());
    if (s->only_reports)
        session_end(s, 0);
    if (translated == 0)
        build_original(s);
    /* Compiling and linking are two calls, to distinguish the linker's messages from the
     * compiler's. They are one call if an option asks for files named after the program. */
    if (s->command.compiled == 1 && (!s->command.links || s->command.meaning & OPTION_AUXILIARY))
        build_one(s, &translations[0]);
    build_several(s, translations, count);
}
