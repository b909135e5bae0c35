/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "driver/project.h"

#include <dirent.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "driver/files.h"
#include "support/map.h"

enum { MOST_FILES = 600, MOST_BYTES = 12 << 20, MOST_DEEP = 6, MOST_UP = 4 };

/* ---- which files ----------------------------------------------------------------------------- */

typedef struct listing {
    arena *memory;
    word_list files;
    long bytes;
    bool is_recursive;
} listing;

static int compare_paths(const void *a, const void *b) {
    return strcmp(*(const char *const *)a, *(const char *const *)b);
}

static bool is_c_source(const char *name) {
    const size_t length = strlen(name);
    return length > 2 && strcmp(name + length - 2, ".c") == 0;
}

/* Lists the C sources in the folder and, if is_recursive, below it. Returns false if there are too
 * many. */
static bool list_folder(listing *all, const char *folder, int depth) {
    DIR *stream = opendir(folder);
    bool is_small = true;
    if (!stream)
        return true;
    for (struct dirent *entry; is_small && (entry = readdir(stream));) {
        struct stat about;
        if (entry->d_name[0] == '.' || (entry->d_type == DT_REG && !is_c_source(entry->d_name)) ||
            entry->d_type == DT_LNK)
            continue;
        const char *path = arena_format(all->memory, "%s/%s", folder, entry->d_name);
        if (lstat(path, &about) != 0)
            continue;
        if (S_ISREG(about.st_mode) && is_c_source(entry->d_name)) {
            VECTOR_PUSH(all->memory, &all->files, path);
            all->bytes += about.st_size;
            is_small = all->files.count <= MOST_FILES && all->bytes <= MOST_BYTES;
        } else if (all->is_recursive && S_ISDIR(about.st_mode) && depth < MOST_DEEP) {
            is_small = list_folder(all, path, depth + 1);
        }
    }
    closedir(stream);
    return is_small;
}

static bool describes_build(arena *a, const char *folder) {
    static const char *const names[] = {
        "Makefile",     "makefile",    "GNUmakefile", "CMakeLists.txt", "meson.build",
        "configure.ac", "Makefile.am", "SConstruct",  "BUILD.bazel",    "compile_commands.json",
        ".git"};
    for (unsigned i = 0; i < sizeof names / sizeof *names; i++)
        if (access(arena_format(a, "%s/%s", folder, names[i]), F_OK) == 0)
            return true;
    return false;
}

/* Returns the outermost folder with a build description, at most a few levels above `folder`; NULL
 * if there is none. The home folder, and folders above it, do not count. */
static const char *root_of(arena *a, const char *folder) {
    const char *root = NULL, *home = getenv("HOME");
    char *at = arena_string(a, folder);
    for (int i = 0; i <= MOST_UP && strlen(at) > 1 && !(home && strcmp(at, home) == 0); i++) {
        if (describes_build(a, at))
            root = arena_string(a, at);
        char *slash = strrchr(at, '/');
        if (!slash || slash == at)
            break;
        *slash = 0;
    }
    return root;
}

/* The folder directly in `root` that contains `folder`, or is `folder`. */
static const char *child_towards(arena *a, const char *root, const char *folder) {
    const size_t length = strlen(root);
    const char *end = strchr(folder + length + 1, '/');
    return end ? arena_copy(a, folder, (size_t)(end - folder)) : folder;
}

/* Lists the sources below the root. If there are too many, lists those below the outermost folder
 * around the source that does not have too many; otherwise those in the source's own folder. */
static word_list list_files(arena *a, const char *folder) {
    listing all = {.memory = a, .is_recursive = true};
    const char *root = root_of(a, folder);
    while (root && !list_folder(&all, root, 0)) {
        all = (listing){.memory = a, .is_recursive = true};
        root = strcmp(root, folder) == 0 ? NULL : child_towards(a, root, folder);
    }
    if (!root) {
        all = (listing){.memory = a};
        if (!list_folder(&all, folder, 0))
            all.files.count = 0;
    }
    if (all.files.count)
        qsort(all.files.items, all.files.count, sizeof *all.files.items, compare_paths);
    return all.files;
}

/* ---- contents of the files ------------------------------------------------------------------- */

typedef struct scanner {
    arena *memory;
    const char *at, *end;
    project_file *file;
    project_function *function; /* the function whose body is being read, or NULL */
    int braces, parentheses;    /* numbers of open braces and parentheses */
    const char *name;           /* outside of bodies: the word before a declaration's first '(' */
    bool is_static,
        is_called; /* outside of bodies: was `static` read? are the parentheses closed? */
    bool has_loop, has_update;
} scanner;

/* The functions of ctype.h would be a third of the work for all the project's files. */
static bool is_blank(char c) {
    return c == ' ' || (c >= '\t' && c <= '\r');
}

static bool starts_name(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

static void skip_quoted(scanner *s) {
    const char quote = *s->at++;
    for (; s->at < s->end && *s->at != quote && *s->at != '\n'; s->at++)
        if (*s->at == '\\' && s->at + 1 < s->end)
            s->at++;
    s->at += s->at < s->end;
}

static void skip_line(scanner *s) {
    for (; s->at < s->end && *s->at != '\n'; s->at++)
        if (*s->at == '\\' && s->at + 1 < s->end)
            s->at++;
}

static bool skip_comment(scanner *s) {
    if (s->end - s->at < 2 || s->at[0] != '/' || (s->at[1] != '/' && s->at[1] != '*'))
        return false;
    if (s->at[1] == '/') {
        skip_line(s);
        return true;
    }
    const char *close = strstr(s->at + 2, "*/");
    s->at = close ? close + 2 : s->end;
    return true;
}

static bool is_word(const char *name, size_t length, const char *word) {
    return strlen(word) == length && memcmp(name, word, length) == 0;
}

static bool is_followed_by(const scanner *s, char c) {
    const char *at = s->at;
    while (at < s->end && is_blank(*at))
        at++;
    return at < s->end && *at == c;
}

static void note_word(scanner *s, const char *word, size_t length) {
    if (!s->function) {
        s->is_static |= is_word(word, length, "static");
        if (!s->name && s->parentheses == 0 && is_followed_by(s, '(') &&
            !is_word(word, length, "__attribute__"))
            s->name = arena_copy(s->memory, word, length);
        return;
    }
    if (is_word(word, length, "for") || is_word(word, length, "while"))
        s->has_loop = true;
    else if (is_followed_by(s, '(') && !is_word(word, length, "if") &&
             !is_word(word, length, "sizeof") && !is_word(word, length, "return"))
        VECTOR_PUSH(s->memory, &s->function->calls, arena_copy(s->memory, word, length));
}

static void begin_declaration(scanner *s) {
    s->name = NULL;
    s->is_static = s->is_called = false;
}

static void open_brace(scanner *s) {
    if (s->braces++ == 0 && s->name && s->is_called && !s->function) {
        const project_function one = {.name = s->name, .is_static = s->is_static};
        VECTOR_PUSH(s->memory, &s->file->functions, one);
        s->function = &s->file->functions.items[s->file->functions.count - 1];
        s->has_loop = s->has_update = false;
    }
}

static void close_brace(scanner *s) {
    s->braces -= s->braces > 0;
    if (s->braces > 0)
        return;
    if (s->function)
        s->function->has_loop = s->has_loop && s->has_update;
    s->function = NULL;
    s->parentheses = 0;
    begin_declaration(s);
}

/* Records a possible update: `op=`, `] =`, `]++`, `++a[`. */
static void note_operator(scanner *s) {
    const char *at = s->at;
    if (s->end - at < 2)
        return;
    const bool is_compound = at[1] == '=' && strchr("+-*/|&^%", at[0]);
    const bool is_step = (at[0] == '+' && at[1] == '+') || (at[0] == '-' && at[1] == '-');
    if (is_compound || (at[0] == ']' && strchr("=+-", at[1])) || is_step ||
        (at[0] == ']' && at[1] == ' '))
        s->has_update = true;
}

static void scan_mark(scanner *s) {
    switch (*s->at) {
    case '{':
        open_brace(s);
        break;
    case '}':
        close_brace(s);
        break;
    case '(':
        s->parentheses++;
        break;
    case ')':
        s->parentheses -= s->parentheses > 0;
        s->is_called |= s->parentheses == 0;
        break;
    case ';':
        if (!s->function && s->braces == 0 && s->parentheses == 0)
            begin_declaration(s);
        break;
    default:
        if (s->function)
            note_operator(s);
        break;
    }
    s->at++;
}

static void scan(arena *a, project_file *file, const char *text, size_t length) {
    scanner s = {.memory = a, .at = text, .end = text + length, .file = file};
    bool begins_line = true;
    while (s.at < s.end) {
        const char c = *s.at;
        if (is_blank(c)) {
            begins_line |= c == '\n';
            s.at++;
            continue;
        }
        if (c == '/' && skip_comment(&s))
            continue;
        if (starts_name(c)) {
            const char *word = s.at;
            while (s.at < s.end && (starts_name(*s.at) || (*s.at >= '0' && *s.at <= '9')))
                s.at++;
            note_word(&s, word, (size_t)(s.at - word));
        } else if (c == '#' && begins_line) {
            skip_line(&s);
        } else if (c == '"' || c == '\'') {
            skip_quoted(&s);
        } else {
            scan_mark(&s);
        }
        begins_line = false;
    }
}

/* ---- definitions and calls ------------------------------------------------------------------- */

typedef struct project_definers {
    VECTOR(unsigned) files;
} project_definers;

static void note_definers(project *p) {
    p->definers = map_new(p->memory);
    for (unsigned i = 0; i < p->files.count; i++)
        for (unsigned k = 0; k < p->files.items[i].functions.count; k++) {
            const project_function *function = &p->files.items[i].functions.items[k];
            if (function->is_static)
                continue;
            void **known = map_at(p->definers, function->name, strlen(function->name));
            if (!*known)
                *known = ARENA_NEW(p->memory, project_definers);
            project_definers *list = *known;
            VECTOR_PUSH(p->memory, &list->files, i);
        }
}

static const project_definers no_definers;

static const project_definers *definers_of(const project *p, const char *name) {
    const project_definers *known = map_get(p->definers, name, strlen(name));
    return known ? known : &no_definers;
}

/* The files that define the function; none if `seen` contains its name already. */
static const project_definers *new_definers_of(const project *p, map *seen, const char *name) {
    void **is_seen = map_at(seen, name, strlen(name));
    const bool is_new = !*is_seen;
    *is_seen = p->memory;
    return is_new ? definers_of(p, name) : &no_definers;
}

/* Records in `seen` the functions that this function calls, directly or not. In each file that
 * defines one of them, also follows the calls of all static functions. */
static void note_calls(project *p, map *seen, const project_function *function) {
    for (unsigned m = 0; m < function->calls.count; m++) {
        const char *name = function->calls.items[m];
        const project_definers *list = new_definers_of(p, seen, name);
        for (unsigned i = 0; i < list->files.count; i++) {
            const project_file *file = &p->files.items[list->files.items[i]];
            for (unsigned k = 0; k < file->functions.count; k++)
                if (file->functions.items[k].is_static ||
                    strcmp(file->functions.items[k].name, name) == 0)
                    note_calls(p, seen, &file->functions.items[k]);
        }
    }
}

/* Records the functions that are called, directly or not, from functions with loops in other files.
 * In a file with a loop, each static function counts as one with a loop, so calls of static
 * functions need not be followed. */
static void note_called(project *p) {
    p->called = map_new(p->memory);
    for (unsigned i = 0; i < p->files.count; i++) {
        const project_file *file = &p->files.items[i];
        bool has_loop = false;
        for (unsigned k = 0; k < file->functions.count; k++)
            has_loop |= file->functions.items[k].has_loop;
        for (unsigned k = 0;
             has_loop && strcmp(file->path, p->own) != 0 && k < file->functions.count; k++)
            if (file->functions.items[k].has_loop || file->functions.items[k].is_static)
                note_calls(p, p->called, &file->functions.items[k]);
    }
}

static const char *resolved(arena *a, const char *path) {
    char *whole = realpath(path, NULL);
    const char *copy = arena_string(a, whole ? whole : path);
    free(whole);
    return copy;
}

word_list project_list(arena *a, const char *path) {
    const char *own = resolved(a, path);
    return own[0] == '/' ? list_files(a, path_folder(a, own)) : (word_list){0};
}

/* Reads the files, with a digest of each if `has_digests`. */
static project_scan scan_files(arena *a, const word_list *files, bool has_digests) {
    project_scan all = {0};
    for (unsigned i = 0; i < files->count; i++) {
        size_t length;
        const char *text = file_read(a, files->items[i], &length);
        if (!text)
            continue;
        project_file file = {.path = files->items[i]};
        digester d = digest_begin();
        if (has_digests)
            digest_text(&d, text);
        file.contents = digest_end(&d);
        scan(a, &file, text, strlen(text));
        VECTOR_PUSH(a, &all, file);
    }
    return all;
}

project_scan project_scan_files(arena *a, const word_list *files) {
    return scan_files(a, files, true);
}

project *project_from(arena *a, const char *path, const project_scan *files) {
    project *p = ARENA_NEW(a, project);
    p->memory = a;
    p->own = resolved(a, path);
    p->files = *files;
    note_definers(p);
    note_called(p);
    return p;
}

project *project_around(arena *a, const char *path) {
    const word_list list = project_list(a, path);
    const project_scan files = scan_files(a, &list, false);
    return project_from(a, path, &files);
}

/* ---- queries --------------------------------------------------------------------------------- */

/* The file's name without folder and ending: "value" for a/value.c. */
static const char *stem(arena *a, const char *path) {
    const char *base = path_base(path), *dot = strrchr(base, '.');
    return arena_copy(a, base, dot ? (size_t)(dot - base) : strlen(base));
}

const char *project_definer(const project *p, const char *name, const char *header) {
    arena *a = p->memory;
    const char *best = NULL, *folder = path_folder(a, p->own);
    int best_rank = -1;
    const project_definers *list = definers_of(p, name);
    for (unsigned i = 0; i < list->files.count; i++) {
        const char *path = p->files.items[list->files.items[i]].path;
        if (strcmp(path, p->own) == 0)
            continue;
        const bool is_near = strcmp(path_folder(a, path), folder) == 0;
        const bool is_named = header && strcmp(stem(a, path), stem(a, header)) == 0;
        const int rank = is_near + 2 * is_named;
        if (rank > best_rank) {
            best_rank = rank;
            best = path;
        }
    }
    return best;
}

bool project_calls_in_loop(const project *p, const char *name) {
    return map_get(p->called, name, strlen(name)) != NULL;
}

/* Adds to the digest the files that define the function's callees, their callees, and so on. */
static void add_called(const project *p, digester *d, map *seen, const project_function *function) {
    for (unsigned m = 0; m < function->calls.count; m++) {
        const char *name = function->calls.items[m];
        const project_definers *list = new_definers_of(p, seen, name);
        for (unsigned i = 0; i < list->files.count; i++) {
            const project_file *file = &p->files.items[list->files.items[i]];
            digest_text(d, name);
            digest_add(d, file->contents.bytes, sizeof file->contents.bytes);
            for (unsigned k = 0; k < file->functions.count; k++)
                add_called(p, d, seen, &file->functions.items[k]);
        }
    }
}

digest project_digest(const project *p) {
    digester d = digest_begin();
    map *seen = map_new(p->memory);
    for (unsigned i = 0; i < p->files.count; i++) {
        const project_file *file = &p->files.items[i];
        for (unsigned k = 0; strcmp(file->path, p->own) == 0 && k < file->functions.count; k++) {
            const project_function *own = &file->functions.items[k];
            digest_text(&d, project_calls_in_loop(p, own->name) ? own->name : "");
            add_called(p, &d, seen, own);
        }
    }
    return digest_end(&d);
}
