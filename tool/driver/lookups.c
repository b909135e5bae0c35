/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The format of a record: the number of folders, and each folder's path and identity; the number of
 * names that were missing in the folder, and these names; the number of files found in it, and
 * their names and identities. Numbers have 64 bits; texts end with a zero byte.
 */
#include "driver/lookups.h"

#include <assert.h>
#include <errno.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "driver/files.h"
#include "support/buffer.h"
#include "support/map.h"
#include "support/vector.h"

/* A file that changed this recently may change again without a new time stamp. */
enum { SETTLED_SECONDS = 2 };

/* The numbers that identify a path. For a folder that was found, only the first three are compared.
 * If names were missing in the folder, all are compared. */
enum { KIND, DEVICE, INODE, SIZE, MODIFIED, MODIFIED_PART, CHANGED, CHANGED_PART, NUMBERS };
enum { KIND_NOTHING, KIND_FILE, KIND_FOLDER };

typedef struct identity {
    int64_t numbers[NUMBERS];
} identity;

typedef struct found_file {
    const char *name;
    identity what;
} found_file;

typedef struct looked_folder {
    const char *path; /* "": the current folder */
    VECTOR(const char *) missing;
    VECTOR(found_file) found;
} looked_folder;

struct lookups {
    arena *memory;
    time_t began;
    bool is_spoilt;
    map *folders;
    VECTOR(looked_folder *) all;
};

static identity identity_of(const struct stat *about) {
    const int64_t kind = S_ISDIR(about->st_mode) ? KIND_FOLDER : KIND_FILE;
    return (identity){{kind, (int64_t)about->st_dev, (int64_t)about->st_ino,
                       (int64_t)about->st_size, (int64_t)about->st_mtim.tv_sec,
                       (int64_t)about->st_mtim.tv_nsec, (int64_t)about->st_ctim.tv_sec,
                       (int64_t)about->st_ctim.tv_nsec}};
}

/* ---- the search ------------------------------------------------------------------------------ */

lookups *lookups_new(arena *a) {
    lookups *l = ARENA_NEW(a, lookups);
    l->memory = a;
    l->began = time(NULL);
    l->folders = map_new(a);
    return l;
}

void lookups_spoil(lookups *l) {
    l->is_spoilt = true;
}

/* Returns the folder before the name at the end of a path, and sets *name. */
static looked_folder *folder_of(lookups *l, const char *path, const char **name) {
    *name = path_base(path);
    const size_t length = (size_t)(*name - path);
    void **known = map_at(l->folders, path, length);
    if (!*known) {
        looked_folder *made = ARENA_NEW(l->memory, looked_folder);
        made->path = arena_copy(l->memory, path, length);
        VECTOR_PUSH(l->memory, &l->all, made);
        *known = made;
    }
    return *known;
}

static bool is_settled(const lookups *l, const identity *what) {
    return what->numbers[CHANGED] + SETTLED_SECONDS < (int64_t)l->began;
}

void lookups_note(lookups *l, const char *path, const struct stat *about) {
    const char *name;
    struct stat link;
    looked_folder *folder = folder_of(l, path, &name);
    if (!about) {
        /* a dangling link may later lead to a file in another folder */
        l->is_spoilt |= !*name || lstat(path, &link) == 0;
        VECTOR_PUSH(l->memory, &folder->missing, name);
        return;
    }
    const found_file one = {*name ? name : ".", identity_of(about)};
    l->is_spoilt |= one.what.numbers[KIND] == KIND_FILE && !is_settled(l, &one.what);
    VECTOR_PUSH(l->memory, &folder->found, one);
}

/* ---- writing --------------------------------------------------------------------------------- */

static void write_numbers(buffer *out, const int64_t *numbers, size_t count) {
    buffer_append(out, (const char *)numbers, count * sizeof *numbers);
}

static void write_name(buffer *out, const char *text) {
    buffer_append(out, text, strlen(text) + 1);
}

static void write_folder(const lookups *l, buffer *out, const looked_folder *folder) {
    const int64_t missing = folder->missing.count, found = folder->found.count;
    struct stat about;
    identity now = {{KIND_NOTHING}};
    if (stat(*folder->path ? folder->path : ".", &about) == 0)
        now = identity_of(&about);
    if (!is_settled(l, &now)) /* later each name is looked up again */
        now = (identity){{KIND_NOTHING}};
    write_name(out, folder->path);
    write_numbers(out, now.numbers, NUMBERS);
    write_numbers(out, &missing, 1);
    for (unsigned i = 0; i < folder->missing.count; i++)
        write_name(out, folder->missing.items[i]);
    write_numbers(out, &found, 1);
    for (unsigned i = 0; i < folder->found.count; i++) {
        write_name(out, folder->found.items[i].name);
        write_numbers(out, folder->found.items[i].what.numbers, NUMBERS);
    }
}

bool lookups_write(lookups *l, store_part *part) {
    buffer out = {0};
    const int64_t count = l->all.count;
    if (l->is_spoilt)
        return false;
    write_numbers(&out, &count, 1);
    for (unsigned i = 0; i < l->all.count; i++)
        write_folder(l, &out, l->all.items[i]);
    part->length = out.length;
    part->bytes = buffer_take(l->memory, &out);
    return true;
}

/* ---- would the search find the same? --------------------------------------------------------- */

static int64_t read_number(const char **at) {
    int64_t number;
    memcpy(&number, *at, sizeof number);
    *at += sizeof number;
    return number;
}

static identity read_identity(const char **at) {
    identity what;
    memcpy(&what, *at, sizeof what);
    *at += sizeof what;
    return what;
}

static const char *read_name(const char **at) {
    const char *name = *at;
    *at += strlen(name) + 1;
    return name;
}

static bool is_same(const identity *one, const identity *other, unsigned count) {
    return memcmp(one->numbers, other->numbers, count * sizeof *one->numbers) == 0;
}

static bool is_missing(arena *a, const char *folder, const char *name) {
    return access(arena_format(a, "%s%s", folder, name), F_OK) != 0 &&
           (errno == ENOENT || errno == ENOTDIR);
}

static bool is_found(arena *a, const char *folder, const char *name, const identity *what,
                     struct stat *about) {
    if (stat(arena_format(a, "%s%s", folder, name), about) != 0)
        return false;
    const identity now = identity_of(about);
    return is_same(&now, what, what->numbers[KIND] == KIND_FOLDER ? SIZE : NUMBERS);
}

bool lookups_hold(arena *a, const store_part *part,
                  void (*found)(void *data, const struct stat *about), void *data) {
    assert(part->length >= sizeof(int64_t));
    const char *at = part->bytes;
    for (int64_t folders = read_number(&at); folders > 0; folders--) {
        struct stat about;
        const char *path = read_name(&at);
        const identity then = read_identity(&at);
        identity now = {{KIND_NOTHING}};
        if (then.numbers[KIND] == KIND_FOLDER && stat(*path ? path : ".", &about) == 0)
            now = identity_of(&about);
        const bool is_unchanged =
            then.numbers[KIND] == KIND_FOLDER && is_same(&now, &then, NUMBERS);
        for (int64_t names = read_number(&at); names > 0; names--) {
            const char *name = read_name(&at);
            if (!is_unchanged && !is_missing(a, path, name))
                return false;
        }
        for (int64_t files = read_number(&at); files > 0; files--) {
            const char *name = read_name(&at);
            const identity what = read_identity(&at);
            if (!is_found(a, path, name, &what, &about))
                return false;
            if (what.numbers[KIND] == KIND_FILE)
                found(data, &about);
        }
    }
    assert(at == part->bytes + part->length);
    return true;
}
