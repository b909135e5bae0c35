/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "driver/translate.h"

#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "driver/build_report.h"
#include "driver/cache.h"
#include "driver/dependencies.h"
#include "driver/files.h"
#include "driver/identity.h"
#include "driver/shared_text.h"

static const char *environment(const char *name) {
    const char *value = getenv(name);
    return value && *value ? value : NULL;
}

static const char *temporary(session *s, const translation *t, const char *name) {
    return arena_format(s->memory, "%s/%s", t->folder, name);
}

/* The first line of a file with a message, to be quoted in another message. */
static const char *first_line(session *s, const char *path) {
    char *text = file_read(s->memory, path, NULL);
    if (!text || !*text)
        return "no message";
    text[strcspn(text, "\n")] = 0;
    return text;
}

static bool wants_remarks(const session *s) {
    for (unsigned i = 0; i < s->options.count; i++)
        if (strncmp(s->options.items[i], "--report", 8) == 0)
            return true;
    return false;
}

/* May the translator use functions of other files? False with link-time optimisation: the linker
 * may inline such a function into one form of a loop, and contract its operations there. The
 * function's record describes only how the function's own object was compiled. */
static bool sees_project(const session *s) {
    for (unsigned i = 0; i < s->command.count; i++)
        if (strncmp(s->command.items[i].text, "-flto", 5) == 0)
            return false;
    return true;
}

static int run_translator(session *s, const translation *t, const char *messages) {
    arena *a = s->memory;
    word_list words = {0};
    words_add(a, &words, s->tools.translator);
    words_add(a, &words, t->is_input ? "-" : t->source->text);
    words_add(a, &words, "-o");
    words_add(a, &words, t->text);
    if (sees_project(s))
        words_add(a, &words, "--files=project");
    words_add_all(a, &words, &s->options);
    words_add(a, &words, "--in-process"); /* redcc starts no child: this process handles a crash */
    /* with "known", translate_for_compiler follows if the source tests which compiler it is */
    words_add(a, &words, s->real.is_clang ? "--compiler=clang" : "--compiler=known");
    if (t->predefined)
        words_add(a, &words, arena_format(a, "--predefined=%s", t->predefined));
    if (t->report) {
        words_add(a, &words, "--report=json");
        words_add(a, &words, arena_format(a, "--report-file=%s", t->report));
    }
    const char *list = temporary(s, t, "inputs");
    if (t->cached)
        words_add(a, &words, arena_format(a, "--inputs-file=%s", list));
    words_add(a, &words, "--");
    if (s->real.standard)
        words_add(a, &words, s->real.standard);
    command_add_parse_options(a, &words, &s->command, session_liberty(s) != NULL);
    if (!s->real.is_clang && (s->command.meaning & OPTION_THREADS))
        words_add(a, &words, "-pthread");
    const cached_run run = {.program = CACHE_TRANSLATOR,
                            .words = &words,
                            .streams = {s->input, messages, messages},
                            .outputs = {t->text, messages, t->report},
                            .read = list};
    return cached_run_program(s, t->cached, &run);
}

typedef enum outcome { OUTCOME_FAILED, OUTCOME_UNCHANGED, OUTCOME_CHANGED } outcome;

static outcome try_translator(session *s, const translation *t) {
    const char *messages = temporary(s, t, "translator");
    if (!s->show)
        remove(messages);
    int status = run_translator(s, t, messages);
    if (process_signal())
        return OUTCOME_FAILED;
    if (s->show)
        return OUTCOME_CHANGED;
    if (status == 1 || status < 0) {
        /* usually the source has an error, which the compiler will report; or the parser crashed */
        session_leave_alone(s, t->source->text,
                            arena_format(s->memory, "redcc: %s", first_line(s, messages)));
        return OUTCOME_FAILED;
    }
    if (status != 0) {
        const char *why = arena_format(s->memory, "redcc failed: %s", first_line(s, messages));
        session_warn(s, "%s: compiled as it is: %s", t->source->text, why);
        session_leave_alone(s, t->source->text, why);
        return OUTCOME_FAILED;
    }
    return file_equal(s->memory, t->file, t->text) ? OUTCOME_UNCHANGED : OUTCOME_CHANGED;
}

/* Lists the files that the compiler reads for the source. */
static bool list_files(session *s, translation *t) {
    arena *a = s->memory;
    const char *rule = temporary(s, t, "original.d");
    word_list words = {0};
    words_add_all(a, &words, &s->real.bare);
    command_add_options(a, &words, &s->command,
                        OPTION_NO_LINK | OPTION_DEPENDENCY | OPTION_LINKER | OPTION_AUXILIARY |
                            session_liberties(s));
    words_add(a, &words, "-M");
    words_add(a, &words, "-MF");
    words_add(a, &words, rule);
    words_add(a, &words, "-MT");
    words_add(a, &words, "x");
    words_add(a, &words, "-x");
    words_add(a, &words, "c");
    words_add(a, &words, t->source->text);
    const cached_run run = {.program = CACHE_COMPILER,
                            .words = &words,
                            .streams = {s->input, "/dev/null", "/dev/null"},
                            .outputs = {rule}};
    const bool is_listed = cached_run_program(s, t->cached, &run) == 0 &&
                           (s->show || dependencies_read(a, rule, &t->read));
    cached_compiler_read(t->cached, &t->read);
    return is_listed;
}

static void add_code_options(session *s, word_list *list) {
    if (!s->contracts)
        words_add(s->memory, list, "-ffp-contract=off");
}

static word_list files_of(session *s, const translation *t) {
    word_list files = {0};
    words_add(s->memory, &files, t->file);
    for (unsigned i = 0; i < t->read.count; i++)
        if (!t->is_input || strcmp(t->read.items[i], "-") != 0)
            words_add(s->memory, &files, t->read.items[i]);
    return files;
}

/* Returns the result of `search` in the source and its headers, or NULL if it finds nothing. The
 * result is cached together with the source, because searching again would take longer than all
 * other work for a cached translation. */
static const char *kept_answer_of(session *s, const translation *t, const char *about,
                                  const char *(*search)(session *s, const translation *t)) {
    word_list words = {0};
    words_add(s->memory, &words, t->source->text);
    command_add_options(s->memory, &words, &s->command, OPTION_DEPENDENCY);
    const char *kept = cached_text(s, t->cached, about, &words);
    const char *answer = kept ? kept : search(s, t);
    if (!kept)
        cached_keep_text(s, t->cached, about, &words, answer ? answer : "");
    return answer && *answer ? answer : NULL;
}

/* The reason why the source or a header would have another meaning in the translated text, or NULL
 * if there is none. */
static const char *sensitive_word(session *s, const translation *t) {
    const word_list files = files_of(s, t);
    if (s->real.is_clang && dependencies_mention(s->memory, &files, "__BASE_FILE__"))
        return "it uses __BASE_FILE__, which would name a temporary";
    return NULL;
}

static const char *assembled_file(session *s, const translation *t) {
    const word_list files = files_of(s, t);
    for (unsigned i = 0; i < files.count; i++) {
        const char *text = file_read(s->memory, files.items[i], NULL);
        if (!text || strstr(text, "incbin") || strstr(text, ".include"))
            return files.items[i];
    }
    return NULL;
}

bool translation_assembles_file(session *s, const translation *t) {
    return kept_answer_of(s, t, "a file for the assembler", assembled_file) != NULL;
}

/* Returns the precompiled form of a header that the compiler may read instead of the header; NULL
 * if there is none. Such a form is valid only with the options with which it was made: gcc 12
 * crashes if OpenMP was disabled then. */
static const char *precompiled_header(session *s, const translation *t) {
    static const char *const endings[] = {"gch", "pch"};
    for (unsigned i = 0; i < t->read.count; i++)
        for (unsigned k = 0; k < sizeof endings / sizeof endings[0]; k++) {
            const char *path = arena_format(s->memory, "%s.%s", t->read.items[i], endings[k]);
            if (access(path, F_OK) == 0)
                return path;
        }
    return NULL;
}

/* Must the source itself be compiled, with options such as -Ofast, although it was translated? True
 * if the translation has no parallel loops, but only records of its functions: the records would
 * describe functions that were compiled without these options. */
static bool keeps_liberty(session *s, const translation *t) {
    const char *text = session_liberty(s) && !s->show ? file_read(s->memory, t->text, NULL) : NULL;
    return text && !strstr(text, "REDCC_OVER(redcc__");
}

/* The reason why the text cannot replace the source, or NULL if it can. */
static const char *obstacle(session *s, translation *t) {
    if (!list_files(s, t))
        return "its headers could not be listed";
    if (s->show)
        return NULL;
    if (session_liberty(s) && s->command.links && s->command.meaning & OPTION_AUXILIARY)
        return arena_format(s->memory,
                            "the same call links it with %s, but a translated text must be "
                            "compiled without that option",
                            session_liberty(s));
    if (strchr(t->text, '=')) /* compilers split a prefix map at it */
        return "its name, or that of the temporary folder, holds a '='";
    const char *precompiled = precompiled_header(s, t);
    if (precompiled)
        return arena_format(s->memory, "the precompiled header %s is for other options",
                            precompiled);
    return kept_answer_of(s, t, "a word that forbids it", sensitive_word);
}

/* Writes the macros that the compiler predefines for the translated text to a file. Returns the
 * file's path, or NULL if the compiler does not list them. */
static const char *list_predefined(session *s, const translation *t) {
    arena *a = s->memory;
    const char *list = temporary(s, t, "predefined");
    word_list words = {0};
    words_add_all(a, &words, &s->real.bare);
    command_add_options(a, &words, &s->command,
                        OPTION_NO_LINK | OPTION_DEPENDENCY | OPTION_LINKER | OPTION_AUXILIARY |
                            OPTION_MACROS | session_liberties(s));
    add_code_options(s, &words);
    static const char *const ask[] = {"-dM", "-E", "-x", "c", "/dev/null"};
    for (unsigned i = 0; i < sizeof ask / sizeof *ask; i++)
        words_add(a, &words, ask[i]);
    remove(list);
    const cached_run run = {.program = CACHE_COMPILER,
                            .words = &words,
                            .streams = {NULL, list, "/dev/null"},
                            .outputs = {list}};
    return cached_run_program(s, t->cached, &run) == 0 ? list : NULL;
}

static const char *compiler_asked_for(session *s, const translation *t) {
    const word_list files = files_of(s, t);
    return identity_asked_in(s->memory, &files, s->real.is_clang);
}

/* If the source tests properties of the compiler, translates it again with the compiler's own
 * macros, since the first translation used clang's. Returns NULL if that succeeds or is not needed,
 * and otherwise the reason why it fails. */
static const char *translate_for_compiler(session *s, translation *t) {
    const char *asked =
        s->show ? NULL : kept_answer_of(s, t, "the compiler it asks for", compiler_asked_for);
    if (!asked)
        return NULL;
    t->predefined = list_predefined(s, t);
    if (t->predefined && try_translator(s, t) == OUTCOME_CHANGED)
        return NULL;
    return arena_format(s->memory, "it tests which compiler this is (%s)", asked);
}

/* Shows the output of the user's own --report. The translator writes only one kind of report per
 * run. So if it has written the build's report, it runs once more. */
static void show_remarks(session *s, const translation *t) {
    const char *messages = temporary(s, t, "translator");
    if (t->report) {
        translation again = *t;
        again.report = NULL;
        again.text = temporary(s, t, "remarks.c");
        messages = temporary(s, t, "remarks");
        run_translator(s, &again, messages);
    }
    file_show(messages, stderr);
}

/* Gives the file the source's time, to which __TIMESTAMP__ expands. */
static void copy_time(const char *from, const char *to) {
    struct stat about;
    if (stat(from, &about) == 0)
        utimensat(AT_FDCWD, to, (const struct timespec[]){about.st_atim, about.st_mtim}, 0);
}

translation translate(session *s, const item *source, unsigned number) {
    translation t;
    memset(&t, 0, sizeof t);
    t.source = source;
    t.is_input = strcmp(source->text, "-") == 0;
    t.file = t.is_input ? s->input : source->text;
    t.folder = arena_format(s->memory, "%s/%u", s->folder, number);
    struct stat about;
    if (!t.is_input && stat(t.file, &about) == 0 && !S_ISREG(about.st_mode)) {
        session_leave_alone(s, t.file, "it is no regular file, which could be read twice");
        return t;
    }
    if (!s->show && mkdir(t.folder, 0700) != 0)
        return t;
    t.text = temporary(s, &t, t.is_input ? "stdin.c" : path_base(source->text));
    if (s->report)
        t.report = arena_format(s->memory, "%s.json", t.text);
    t.cached = cached_begin(s, source, t.file);
    outcome result = try_translator(s, &t);
    if (result == OUTCOME_CHANGED && keeps_liberty(s, &t))
        result = OUTCOME_UNCHANGED;
    const char *why = result == OUTCOME_CHANGED ? obstacle(s, &t) : NULL;
    if (result == OUTCOME_CHANGED && !why)
        why = translate_for_compiler(s, &t);
    cached_end(s, t.cached);
    if (result != OUTCOME_FAILED && wants_remarks(s))
        show_remarks(s, &t);
    if (why)
        session_leave_alone(s, source->text, why);
    if (why || result == OUTCOME_FAILED)
        t.report = NULL;
    if (why || result != OUTCOME_CHANGED)
        t.text = NULL;
    if (t.text && !s->show)
        copy_time(t.file, t.text);
    if (t.text && compiler_has_launcher(&s->real))
        t.text = shared_text(s, t.text, source->text);
    return t;
}

/* Returns the folder that is searched first for an #include "x.h" of the source. Headers found
 * there must get the names that they have next to the source, such as src/x.h for src/. In the
 * current folder clang names a header ./x.h, and gcc names it x.h. No spelling of the folder makes
 * gcc write x.h, so a prefix map changes ././x.h to x.h. */
static const char *quote_folder(session *s, const translation *t) {
    const char *folder = path_folder(s->memory, t->source->text);
    if (*folder)
        return folder;
    return s->real.is_clang ? "." : "./.";
}

void translation_add_before(session *s, word_list *list, const translation *t) {
    if (t->is_input)
        return; /* the translated text is also compiled from standard input, so the compiler looks
                 * for headers in the same folders as for the original */
    words_add(s->memory, list, "-iquote");
    words_add(s->memory, list, quote_folder(s, t));
    /* Separates that folder from the user's first -I: if the two are one folder, the compiler would
     * use the spelling of -I in __FILE__. */
    words_add(s->memory, list, "-iquote");
    words_add(s->memory, list, path_folder(s->memory, t->text));
}

/* Returns the path as the user's own prefix maps change it. If several maps match, the last one
 * applies. */
static const char *mapped(session *s, const char *path) {
    const char *spelling = path;
    for (unsigned i = 0; i < s->command.count; i++) {
        const item *one = &s->command.items[i];
        if (!(one->meaning & OPTION_PREFIX_MAP))
            continue;
        const char *old = item_argument(one);
        size_t length = strcspn(old, "=");
        if (old[length] == '=' && strncmp(path, old, length) == 0)
            spelling = arena_format(s->memory, "%s%s", old + length + 1, path + length);
    }
    return spelling;
}

/* Adds options that make the object refer to the source, and not to the temporary file. */
static void add_prefix_maps(session *s, word_list *list, const translation *t) {
    arena *a = s->memory;
    const char *source = mapped(s, t->source->text);
    if (s->real.is_clang) { /* clang's -ffile-prefix-map would change "./x.c" in every __FILE__ */
        words_add(a, list, arena_format(a, "-fdebug-prefix-map=%s=%s", t->text, source));
        return;
    }
    if (strcmp(quote_folder(s, t), "./.") == 0)
        words_add(a, list, arena_format(a, "-ffile-prefix-map=././=%s", mapped(s, "")));
    words_add(a, list, arena_format(a, "-ffile-prefix-map=%s=%s", t->text, source));
}

void translation_add_after(session *s, word_list *list, const translation *t) {
    arena *a = s->memory;
    add_code_options(s, list);
    words_add(a, list, "-idirafter");
    words_add(a, list, s->tools.include);
    if (!t->is_input)
        add_prefix_maps(s, list, t);
    words_add(a, list, "-MD");
    words_add(a, list, "-MF");
    words_add(a, list, temporary(s, t, "translated.d"));
    words_add(a, list, "-MT");
    words_add(a, list, "x");
}

bool translation_read_same(session *s, const translation *t) {
    word_list read = {0};
    if (s->show)
        return true;
    const char *text = file_read(s->memory, t->text, NULL);
    const word_list listed = dependencies_included(s->memory, &t->read, text ? text : "");
    const bool is_listed = dependencies_read(s->memory, temporary(s, t, "translated.d"), &read);
    word_list others = {0};
    for (unsigned i = 0; i < read.count; i++)
        if (strcmp(read.items[i], t->text) != 0)
            words_add(s->memory, &others, read.items[i]);
    cached_compiler_read(t->cached, &others);
    return is_listed && dependencies_equal(s->memory, &listed, t->source->text, &read,
                                           t->is_input ? t->source->text : t->text);
}

/* Returns the path under which $REDCC_KEEP=DIR keeps the text: DIR/src/x.c for src/x.c, DIR/up/x.c
 * for ../x.c, and DIR/home/me/x.c for /home/me/x.c. */
static const char *kept_path(session *s, const char *folder, const translation *t) {
    const char *path = t->is_input ? "stdin.c" : t->source->text;
    buffer kept = {0};
    buffer_text(&kept, folder);
    while (*path) {
        size_t length = strcspn(path, "/");
        if (length == 2 && strncmp(path, "..", 2) == 0)
            buffer_text(&kept, "/up");
        else if (length > 0 && !(length == 1 && *path == '.')) {
            buffer_byte(&kept, '/');
            buffer_append(&kept, path, length);
        }
        path += length + (path[length] == '/');
    }
    const char *copy = arena_string(s->memory, kept.data);
    buffer_free(&kept);
    return copy;
}

void translation_keep(session *s, const translation *t, bool used, const char *messages) {
    const char *folder = environment("REDCC_KEEP");
    if (s->show)
        return;
    if (t->report && (used || !t->text) && !build_report_append(s->memory, t->report, s->report))
        session_warn(s, "cannot append to '%s'", s->report);
    if (!folder || !t->text)
        return;
    const char *path = kept_path(s, folder, t);
    bool good = folder_create_for(s->memory, path) && file_copy(s->memory, t->text, path);
    if (good && messages)
        good = file_copy(s->memory, messages, arena_format(s->memory, "%s.messages", path));
    if (!good)
        session_warn(s, "cannot keep '%s'", path);
}
