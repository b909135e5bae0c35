/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "driver/store.h"

#include <assert.h>
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "driver/files.h"
#include "support/buffer.h"
#include "support/vector.h"

/* Entries are in 16 folders, one for each first digit of their keys. The folders share the limit
 * equally. */
enum { SHARES = 16, KEPT_OF_TEN = 8, FRESH_SECONDS = 600, ABANDONED_SECONDS = 3600 };
static const uint64_t DEFAULT_LIMIT = UINT64_C(1) << 30;

/* The first bytes of every entry; they change with its layout. */
static const char magic[8] = "redcc-1";
static const char partial[] = ".new-";

/* ---- the folder ------------------------------------------------------------------------------ */

static const char *chosen_folder(arena *a, const char **wrong) {
    const char *given = getenv("REDCC_CACHE"), *home = getenv("HOME");
    const char *general = getenv("XDG_CACHE_HOME");
    if (given && *given) {
        if (strcmp(given, "off") != 0 && *given != '/') {
            *wrong = arena_format(a,
                                  "REDCC_CACHE takes the absolute path of a folder, or off, not "
                                  "'%s': nothing is cached",
                                  given);
            return NULL;
        }
        return *given == '/' ? given : NULL;
    }
    if (general && *general == '/')
        return arena_format(a, "%s/redcc", general);
    return home && *home == '/' ? arena_format(a, "%s/.cache/redcc", home) : NULL;
}

static uint64_t chosen_limit(arena *a, const char **wrong) {
    static const char letters[] = "KMG";
    const char *given = getenv("REDCC_CACHE_SIZE");
    if (!given || !*given)
        return DEFAULT_LIMIT;
    char *end;
    errno = 0;
    uint64_t value = strtoull(given, &end, 10);
    const char *letter = *end ? strchr(letters, *end) : NULL;
    const unsigned shift = letter ? 10 * (unsigned)(letter - letters + 1) : 0;
    const bool fits = errno == 0 && value <= UINT64_MAX >> shift;
    if (*given < '0' || *given > '9' || end[letter ? 1 : 0] || !fits || value == 0) {
        *wrong = arena_format(a,
                              "REDCC_CACHE_SIZE takes a number of bytes, with K, M or G, not '%s': "
                              "1G is used",
                              given);
        return DEFAULT_LIMIT;
    }
    return value << shift;
}

store store_open(arena *a, const char **wrong) {
    store s = {chosen_folder(a, wrong), chosen_limit(a, wrong)};
    struct stat about;
    if (!s.folder)
        return s;
    /* the folder's contents become part of programs: it must be this user's, and not writable by
     * all */
    if (!folder_create_for(a, arena_format(a, "%s/", s.folder)) || stat(s.folder, &about) != 0 ||
        !S_ISDIR(about.st_mode) || about.st_uid != geteuid() || (about.st_mode & S_IWOTH))
        s.folder = NULL;
    return s;
}

static const char *share_of(arena *a, const store *s, const digest *key) {
    return arena_format(a, "%s/%x", s->folder, key->bytes[0] >> 4);
}

static const char *path_of(arena *a, const store *s, const digest *key) {
    char name[2 * sizeof key->bytes + 1];
    for (unsigned i = 0; i < sizeof key->bytes; i++)
        snprintf(name + 2 * i, 3, "%02x", key->bytes[i]);
    return arena_format(a, "%s/%s", share_of(a, s, key), name);
}

/* ---- entries: magic, digest of the rest; for each part its length and bytes ------------------ */

enum { HEADER = sizeof magic + sizeof(digest) };

static digest digest_of(const char *bytes, size_t length) {
    digester d = digest_begin();
    digest_add(&d, bytes, length);
    return digest_end(&d);
}

/* Splits an entry's bytes into parts; false if it is corrupt. */
static bool split_entry(const char *bytes, size_t length, unsigned count, store_part *parts) {
    if (length < HEADER || memcmp(bytes, magic, sizeof magic) != 0)
        return false;
    const digest sum = digest_of(bytes + HEADER, length - HEADER);
    if (memcmp(bytes + sizeof magic, sum.bytes, sizeof sum.bytes) != 0)
        return false;
    const char *at = bytes + HEADER, *end = bytes + length;
    for (unsigned i = 0; i < count; i++) {
        uint64_t size;
        if ((size_t)(end - at) < sizeof size)
            return false;
        memcpy(&size, at, sizeof size);
        at += sizeof size;
        if (size > (uint64_t)(end - at))
            return false;
        parts[i] = (store_part){at, (size_t)size};
        at += size;
    }
    return at == end;
}

/* Marks an entry as recently used. Its time is not written again within a short time. */
static void touch(const char *path) {
    struct stat about;
    if (stat(path, &about) == 0 && time(NULL) - about.st_mtime > FRESH_SECONDS)
        utimensat(AT_FDCWD, path, NULL, 0);
}

bool store_get(arena *a, const store *s, const digest *key, unsigned count, store_part *parts) {
    assert(count > 0);
    size_t length;
    const char *path = s->folder ? path_of(a, s, key) : NULL;
    const char *bytes = path ? file_read(a, path, &length) : NULL;
    if (!bytes)
        return false;
    if (!split_entry(bytes, length, count, parts)) {
        unlink(path);
        return false;
    }
    touch(path);
    return true;
}

/* ---- the limit ------------------------------------------------------------------------------- */

typedef struct old_entry {
    const char *path;
    struct timespec used;
    uint64_t size;
} old_entry;

static int older_first(const void *left, const void *right) {
    const old_entry *l = left, *r = right;
    if (l->used.tv_sec != r->used.tv_sec)
        return l->used.tv_sec < r->used.tv_sec ? -1 : 1;
    return (l->used.tv_nsec > r->used.tv_nsec) - (l->used.tv_nsec < r->used.tv_nsec);
}

/* Removes, from one of the 16 folders, files that killed writers have left and, if the folder
 * exceeds its limit, the least recently used entries. */
static void evict(arena *a, const char *share, uint64_t limit) {
    VECTOR(old_entry) entries = {0};
    uint64_t sum = 0;
    DIR *folder = opendir(share);
    const struct dirent *entry;
    while (folder && (entry = readdir(folder))) {
        struct stat about;
        const char *path = arena_format(a, "%s/%s", share, entry->d_name);
        if (lstat(path, &about) != 0 || !S_ISREG(about.st_mode))
            continue;
        if (strncmp(entry->d_name, partial, sizeof partial - 1) == 0) {
            if (time(NULL) - about.st_mtime > ABANDONED_SECONDS)
                unlink(path);
            continue;
        }
        const old_entry one = {path, about.st_mtim, (uint64_t)about.st_blocks * 512};
        VECTOR_PUSH(a, &entries, one);
        sum += one.size;
    }
    if (folder)
        closedir(folder);
    if (sum <= limit)
        return;
    qsort(entries.items, entries.count, sizeof *entries.items, older_first);
    for (unsigned i = 0; i < entries.count && sum > limit / 10 * KEPT_OF_TEN; i++)
        if (unlink(entries.items[i].path) == 0)
            sum -= entries.items[i].size;
}

/* ---- writing --------------------------------------------------------------------------------- */

static bool write_entry(const char *path, const buffer *bytes) {
    const int file = open(path, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    if (file < 0)
        return false;
    size_t done = 0;
    while (done < bytes->length) {
        const ssize_t some = write(file, bytes->data + done, bytes->length - done);
        if (some <= 0)
            break;
        done += (size_t)some;
    }
    if (close(file) == 0 && done == bytes->length)
        return true;
    unlink(path);
    return false;
}

void store_put(arena *a, const store *s, const digest *key, unsigned count,
               const store_part *parts) {
    assert(count > 0);
    if (!s->folder)
        return;
    buffer rest = {0}, whole = {0};
    for (unsigned i = 0; i < count; i++) {
        const uint64_t size = parts[i].length;
        buffer_append(&rest, (const char *)&size, sizeof size);
        buffer_append(&rest, parts[i].bytes, parts[i].length);
    }
    const digest sum = digest_of(rest.data, rest.length);
    buffer_append(&whole, magic, sizeof magic);
    buffer_append(&whole, (const char *)sum.bytes, sizeof sum.bytes);
    buffer_append(&whole, rest.data, rest.length);
    const char *path = path_of(a, s, key), *share = share_of(a, s, key);
    /* a name that no other process of this machine uses for the entry */
    const char *fresh =
        arena_format(a, "%s/%s%s-%ld", share, partial, path_base(path), (long)getpid());
    if (whole.length <= s->limit / SHARES && folder_create_for(a, path)) {
        if (write_entry(fresh, &whole) && rename(fresh, path) != 0)
            unlink(fresh);
        evict(a, share, s->limit / SHARES);
    }
    buffer_free(&rest);
    buffer_free(&whole);
}
