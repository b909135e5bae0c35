/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "driver/closure.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "driver/files.h"
#include "driver/include_names.h"
#include "support/source.h"

/* Identifies a file, whatever names lead to it. */
typedef struct place {
    dev_t device;
    ino_t inode;
} place;

static place place_of(const struct stat *about) {
    place p;
    memset(&p, 0, sizeof p); /* padding too: the bytes are a key of maps */
    p.device = about->st_dev;
    p.inode = about->st_ino;
    return p;
}

typedef struct search {
    arena *arena;
    word_list folders; /* the search folders that exist */
    closure found;
    lookups *seen; /* what the digest `state` depends on */
    digester state;
    map *tried;       /* the paths already tried */
    word_list texts;  /* the texts of files */
    word_list macros; /* macros that may expand to names of headers */
    map *met;         /* pairs of a file and the folder in which it was found */
    map *names;       /* names already searched in all folders */
    map *below;       /* folders of the paths tried, and whether each exists */
    uintptr_t count;  /* number of different files so far */
} search;

static bool is_new(map *m, const char *key) {
    void **at = map_at(m, key, strlen(key));
    const bool made = *at == NULL;
    *at = m;
    return made;
}

static void read_names(search *s, const char *name, const char *text, size_t length);

static char *read_open(arena *a, int file, size_t size) {
    char *text = arena_allocate(a, size + 1);
    size_t done = 0;
    while (done < size) {
        const ssize_t some = read(file, text + done, size - done);
        if (some <= 0)
            return NULL; /* the file was truncated meanwhile */
        done += (size_t)some;
    }
    return text;
}

/* Is this the first time that the file is found in this folder? A file that includes "../a/x.h"
 * leads to the same folder under ever longer names, and so to the same files again. */
static bool is_new_in_folder(search *s, const char *name, const struct stat *about) {
    struct stat folder;
    const char *path = path_folder(s->arena, name);
    path = *path ? path : ".";
    if (stat(path, &folder) != 0) {
        lookups_spoil(s->seen);
        return true;
    }
    lookups_note(s->seen, path, &folder);
    const place places[] = {place_of(&folder), place_of(about)};
    void **met = map_at(s->met, places, sizeof places);
    const bool is_first = *met == NULL;
    *met = s;
    return is_first;
}

/* Adds an existing file to the closure: its name, contents and identity, and the headers that it
 * includes. */
static void add_file(search *s, const char *name, int file) {
    struct stat about;
    if (fstat(file, &about) != 0 || (!S_ISREG(about.st_mode) && !S_ISDIR(about.st_mode))) {
        s->found.unknown = arena_format(s->arena, "%s is no plain file", name);
        return;
    }
    lookups_note(s->seen, name, &about);
    digest_text(&s->state, name);
    if (S_ISDIR(about.st_mode)) {
        digest_text(&s->state, "a folder");
        return;
    }
    const place p = place_of(&about);
    void **number = map_at(s->found.files, &p, sizeof p);
    if (!*number)
        *number = (void *)++s->count;
    const uintptr_t value = (uintptr_t)*number;
    if (!is_new_in_folder(s, name, &about)) {
        digest_add(&s->state, &value, sizeof value);
        return;
    }
    char *text = read_open(s->arena, file, (size_t)about.st_size);
    if (!text) {
        s->found.unknown = arena_format(s->arena, "%s cannot be read", name);
        return;
    }
    const uint64_t header[] = {value, (uint64_t)about.st_size};
    digest_add(&s->state, header, sizeof header);
    digest_add(&s->state, text, (size_t)about.st_size);
    read_names(s, name, text, (size_t)about.st_size);
}

/* Gives up if a precompiled form of the header exists, because the compiler would read this form,
 * which is not C. */
static void check_precompiled(search *s, const char *path, const char *ending) {
    const char *other = arena_format(s->arena, "%s.%s", path, ending);
    if (access(other, F_OK) == 0)
        s->found.unknown = arena_format(s->arena, "%s is precompiled", other);
    else
        lookups_note(s->seen, other, NULL);
}

/* Does the folder of `path` not exist? Half of all included names begin with bits/ or sys/, folders
 * that most search folders do not contain. */
static bool folder_is_absent(search *s, const char *path) {
    static const char absent[] = "absent";
    const char *slash = strrchr(path, '/');
    if (!slash || slash == path)
        return false;
    void **known = map_at(s->below, path, (size_t)(slash - path));
    if (!*known) {
        const char *folder = arena_copy(s->arena, path, (size_t)(slash - path));
        const bool is_there = access(folder, F_OK) == 0 || (errno != ENOENT && errno != ENOTDIR);
        *known = is_there ? (void *)s : (void *)absent;
        if (!is_there)
            lookups_note(s->seen, folder, NULL);
    }
    return *known == (const void *)absent;
}

/* Tries a path at which a header may be: adds the file if it exists. */
static void try_path(search *s, const char *path) {
    if (s->found.unknown || folder_is_absent(s, path) || !is_new(s->tried, path))
        return;
    check_precompiled(s, path, "gch");
    const int file = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (file < 0) {
        if (errno != ENOENT && errno != ENOTDIR)
            s->found.unknown = arena_format(s->arena, "%s cannot be read", path);
        lookups_note(s->seen, path, NULL);
        return;
    }
    add_file(s, path, file);
    close(file);
}

static void try_below(search *s, const char *folder, const char *name) {
    try_path(s, *folder ? arena_format(s->arena, "%s/%s", folder, name) : name);
}

static void try_everywhere(search *s, const char *name) {
    if (!is_new(s->names, name))
        return;
    if (*name == '/') {
        try_path(s, name);
        return;
    }
    for (unsigned i = 0; i < s->folders.count; i++)
        try_below(s, s->folders.items[i], name);
}

/* Searches for a header that -include names. clang may read a precompiled form of it, with the
 * ending pch. */
static void try_included(search *s, const char *name, const char *folder) {
    try_below(s, "", name);
    try_below(s, folder, name);
    try_everywhere(s, name);
    check_precompiled(s, name, "pch");
    for (unsigned i = 0; i < s->folders.count; i++)
        check_precompiled(s, arena_format(s->arena, "%s/%s", s->folders.items[i], name), "pch");
}

static void read_names(search *s, const char *name, const char *text, size_t length) {
    include_names names = {0};
    const char *why = include_names_find(s->arena, text, length, &names);
    if (why) {
        s->found.unknown = arena_format(s->arena, "%s: %s", name, why);
        return;
    }
    words_add(s->arena, &s->texts, names.text);
    words_add_all(s->arena, &s->macros, &names.macros);
    const char *folder = path_folder(s->arena, name);
    for (unsigned i = 0; i < names.quoted.count; i++) {
        if (*names.quoted.items[i] != '/')
            try_below(s, folder, names.quoted.items[i]);
        try_everywhere(s, names.quoted.items[i]);
    }
    for (unsigned i = 0; i < names.angled.count; i++)
        try_everywhere(s, names.angled.items[i]);
}

/* Finds the folders that exist. The digest `state` also covers those that do not exist, so it
 * changes if one of them is created later. */
static void find_folders(search *s, const word_list *all) {
    for (unsigned i = 0; i < all->count; i++) {
        struct stat about;
        const char *folder = all->items[i];
        const bool is_found = stat(folder, &about) == 0;
        const bool is_there = is_found && S_ISDIR(about.st_mode);
        if (!is_new(s->tried, arena_format(s->arena, "%s/", folder)))
            continue;
        if (source_ends_with(folder, ".hmap"))
            s->found.unknown = arena_format(s->arena, "%s is a map of headers", folder);
        lookups_note(s->seen, folder, is_found ? &about : NULL);
        digest_text(&s->state, folder);
        digest_text(&s->state, is_there ? "there" : "absent");
        if (is_there)
            words_add(s->arena, &s->folders, folder);
    }
}

/* Gives up if a text, or a word of the command, may define a macro that expands to the name of a
 * header. */
static void check_macros(search *s, const word_list *words) {
    for (unsigned i = 0; !s->found.unknown && i < s->macros.count; i++) {
        const char *macro = s->macros.items[i];
        bool is_defined = false;
        for (unsigned k = 0; k < s->texts.count; k++)
            is_defined |= include_names_may_define(s->texts.items[k], macro);
        for (unsigned k = 0; k < words->count; k++)
            is_defined |= strstr(words->items[k], macro) != NULL;
        if (is_defined)
            s->found.unknown =
                arena_format(s->arena, "the macro %s may make the name of a header", macro);
    }
}

static closure find(arena *a, const closure_request *request, lookups *seen) {
    search s = {.arena = a,
                .found = {.files = map_new(a)},
                .seen = seen,
                .state = digest_begin(),
                .tried = map_new(a),
                .met = map_new(a),
                .names = map_new(a),
                .below = map_new(a)};
    find_folders(&s, &request->folders);
    const int file = open(request->file, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (file < 0)
        s.found.unknown = arena_format(a, "%s cannot be read", request->name);
    else {
        add_file(&s, request->name, file);
        close(file);
    }
    for (unsigned i = 0; i < request->included.count; i++)
        try_included(&s, request->included.items[i], path_folder(a, request->name));
    check_macros(&s, &request->words);
    s.found.state = digest_end(&s.state);
    return s.found;
}

static void add_words(digester *d, const word_list *words) {
    for (unsigned i = 0; i < words->count; i++)
        digest_text(d, words->items[i]);
    digest_text(d, NULL);
}

static digest key_of(const closure_request *request) {
    char here[PATH_MAX];
    digester d = digest_begin();
    digest_text(&d, "a closure, " REDCC_VERSION);
    digest_text(&d, getcwd(here, sizeof here));
    digest_text(&d, request->file);
    digest_text(&d, request->name);
    add_words(&d, &request->included);
    add_words(&d, &request->folders);
    add_words(&d, &request->words);
    return digest_end(&d);
}

static void add_place(void *data, const struct stat *about) {
    const place p = place_of(about);
    *map_at(data, &p, sizeof p) = data;
}

closure closure_find(arena *a, const store *kept, const closure_request *request) {
    enum { STATE, SEEN, PARTS };
    store_part parts[PARTS];
    const digest key = key_of(request);
    closure known = {.files = map_new(a)};
    if (store_get(a, kept, &key, PARTS, parts) && parts[STATE].length == sizeof known.state &&
        lookups_hold(a, &parts[SEEN], add_place, known.files)) {
        memcpy(&known.state, parts[STATE].bytes, sizeof known.state);
        return known;
    }
    lookups *seen = lookups_new(a);
    const closure found = find(a, request, seen);
    parts[STATE] = (store_part){(const char *)found.state.bytes, sizeof found.state};
    if (!found.unknown && lookups_write(seen, &parts[SEEN]))
        store_put(a, kept, &key, PARTS, parts);
    return found;
}

bool closure_has(const closure *c, const char *path) {
    struct stat about;
    if (stat(path, &about) != 0)
        return false;
    const place p = place_of(&about);
    return map_get(c->files, &p, sizeof p) != NULL;
}
