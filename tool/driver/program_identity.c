/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "driver/program_identity.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "driver/compiler.h"
#include "driver/files.h"

extern char **environ;

/* A file that changed within these seconds may change again and keep its time stamp. */
enum { SETTLED_SECONDS = 2 };

/* Adds a file's path, identity, size and times to the digest. Returns false if it is no plain file.
 * Clears *is_settled if the file changed recently. */
static bool add_times(digester *d, const char *path, bool *is_settled) {
    struct stat about;
    if (stat(path, &about) != 0 || !S_ISREG(about.st_mode))
        return false;
    const int64_t numbers[] = {(int64_t)about.st_dev,          (int64_t)about.st_ino,
                               (int64_t)about.st_size,         (int64_t)about.st_mtim.tv_sec,
                               (int64_t)about.st_mtim.tv_nsec, (int64_t)about.st_ctim.tv_sec,
                               (int64_t)about.st_ctim.tv_nsec};
    digest_text(d, path);
    digest_add(d, numbers, sizeof numbers);
    *is_settled &= time(NULL) - about.st_ctim.tv_sec > SETTLED_SECONDS;
    return true;
}

/* Adds a file's contents to the digest, in pieces, because libraries have hundreds of megabytes. */
static bool add_contents(digester *d, const char *path) {
    FILE *file = fopen(path, "rb");
    char part[65536];
    uint64_t length = 0;
    size_t count;
    if (!file)
        return false;
    while ((count = fread(part, 1, sizeof part, file)) > 0) {
        digest_add(d, part, count);
        length += count;
    }
    const bool good = !ferror(file);
    fclose(file);
    digest_add(d, &length, sizeof length);
    return good;
}

bool identity_add_times(digester *d, const word_list *paths) {
    bool is_settled = true;
    for (unsigned i = 0; i < paths->count; i++)
        if (!add_times(d, paths->items[i], &is_settled))
            return false;
    return is_settled;
}

bool identity_add_files(arena *a, const store *s, digester *d, const word_list *paths) {
    digester times = digest_begin(), contents = digest_begin();
    bool is_settled = true;
    digest_text(&times, "contents of files");
    for (unsigned i = 0; i < paths->count; i++)
        if (!add_times(&times, paths->items[i], &is_settled))
            return false;
    const digest key = digest_end(&times);
    store_part kept;
    if (is_settled && store_get(a, s, &key, 1, &kept) && kept.length == sizeof(digest)) {
        digest_add(d, kept.bytes, kept.length);
        return true;
    }
    for (unsigned i = 0; i < paths->count; i++)
        if (!add_contents(&contents, paths->items[i]))
            return false;
    const digest sum = digest_end(&contents);
    if (is_settled)
        store_put(a, s, &key, 1, &(store_part){(const char *)sum.bytes, sizeof sum.bytes});
    digest_add(d, sum.bytes, sizeof sum.bytes);
    return true;
}

static bool add_file(arena *a, const store *s, digester *d, const char *path) {
    word_list one = {0};
    words_add(a, &one, path);
    return identity_add_files(a, s, d, &one);
}

/* Adds one executable file to the digest; false if it is no ELF file. */
static bool add_executable(arena *a, const store *s, digester *d, const char *path) {
    char magic[4] = "";
    FILE *file = fopen(path, "rb");
    const bool is_read = file && fread(magic, 1, sizeof magic, file) == sizeof magic;
    if (file)
        fclose(file);
    return is_read && memcmp(magic, "\177ELF", sizeof magic) == 0 && add_file(a, s, d, path);
}

static bool is_launchers_link(const char *path) {
    char real[PATH_MAX];
    return realpath(path, real) && compiler_is_launcher(real) && !compiler_is_launcher(path);
}

bool identity_add_program(arena *a, const store *s, digester *d, const char *name) {
    if (strchr(name, '/')) {
        if (!add_executable(a, s, d, name))
            return false;
        if (!is_launchers_link(name))
            return true;
        name = path_base(name);
    }
    const char *path = getenv("PATH");
    while (path && *path) {
        const size_t length = strcspn(path, ":");
        const char *folder = length ? arena_copy(a, path, length) : ".";
        const char *candidate = arena_format(a, "%s/%s", folder, name);
        path += length + (path[length] == ':');
        if (!path_is_executable(candidate))
            continue;
        if (!add_executable(a, s, d, candidate))
            return false;
        if (!is_launchers_link(candidate))
            return true;
    }
    return false;
}

static int compare_texts(const void *left, const void *right) {
    return strcmp(*(const char *const *)left, *(const char *const *)right);
}

/* Does the environment variable in `entry` affect what the compiler or the translator does? */
static bool counts(const char *entry) {
    static const char *const beginnings[] = {"C_INCLUDE_PATH=",
                                             "CCC_",
                                             "CLANG",
                                             "COMPILER_PATH=",
                                             "CPATH=",
                                             "GCC_",
                                             "GLIBC_TUNABLES=",
                                             "LANG",
                                             "LC_",
                                             "LD_",
                                             "LIBCLANG_",
                                             "LIBRARY_PATH=",
                                             "POSIXLY_CORRECT=",
                                             "REDCC_ROOT=",
                                             "SOURCE_DATE_EPOCH="};
    for (size_t i = 0; i < sizeof beginnings / sizeof *beginnings; i++)
        if (strncmp(entry, beginnings[i], strlen(beginnings[i])) == 0)
            return true;
    return false;
}

void identity_add_environment(arena *a, digester *d) {
    word_list found = {0};
    for (char **entry = environ; entry && *entry; entry++)
        if (counts(*entry))
            words_add(a, &found, *entry);
    if (found.count > 0)
        qsort(found.items, found.count, sizeof *found.items, compare_texts);
    for (unsigned i = 0; i < found.count; i++)
        digest_text(d, found.items[i]);
    digest_text(d, NULL);
}
