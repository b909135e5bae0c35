/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "driver/temporary.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <ftw.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

static const char prefix[] = "redcc-cc-";
static const char placeholder[] = "XXXXXX"; /* mkdtemp replaces it */

/* The creator of a younger folder may not have locked it yet. */
enum { YOUNG_SECONDS = 60 };

static const char *parent_folder(void) {
    const char *given = getenv("TMPDIR");
    return given && *given ? given : "/tmp";
}

enum { KEY_DIGITS = 16 };

static bool is_named_as_ours(const char *name) {
    if (strncmp(name, prefix, sizeof prefix - 1) != 0)
        return false;
    const size_t rest = strlen(name) - (sizeof prefix - 1);
    return rest == sizeof placeholder - 1 || rest == KEY_DIGITS;
}

/* Is the open folder abandoned: owned by this user, not young, and unlocked? On a file system
 * without locks the answer is false. If true, this process now holds the folder's lock. */
static bool is_left_behind(int folder) {
    struct stat about;
    return fstat(folder, &about) == 0 && about.st_uid == geteuid() &&
           time(NULL) - about.st_mtime > YOUNG_SECONDS && flock(folder, LOCK_EX | LOCK_NB) == 0;
}

static void remove_left_behind(arena *a, const char *parent) {
    DIR *entries = opendir(parent);
    if (!entries)
        return;
    const struct dirent *entry;
    while ((entry = readdir(entries))) {
        if (!is_named_as_ours(entry->d_name))
            continue;
        const char *path = arena_format(a, "%s/%s", parent, entry->d_name);
        int folder = open(path, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
        if (folder < 0)
            continue;
        if (is_left_behind(folder))
            temporary_remove(path);
        close(folder);
    }
    closedir(entries);
}

const char *temporary_create(arena *a) {
    const char *parent = parent_folder();
    char *folder = mkdtemp(arena_format(a, "%s/%s%s", parent, prefix, placeholder));
    if (!folder)
        return NULL;
    /* never closed: the lock lasts until the process ends, and child programs do not inherit it */
    int lock = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (lock >= 0)
        flock(lock, LOCK_SH);
    remove_left_behind(a, parent);
    return folder;
}

/* Does the path still name the open folder, and does only this user have access? */
static bool is_usable(int folder, const char *path) {
    struct stat opened, named;
    return fstat(folder, &opened) == 0 && lstat(path, &named) == 0 &&
           opened.st_ino == named.st_ino && opened.st_dev == named.st_dev &&
           opened.st_uid == geteuid() && (opened.st_mode & 077) == 0;
}

shared_folder temporary_share(arena *a, uint64_t key) {
    enum { TRIES = 10 }; /* an attempt fails if the last user removes the folder in between */
    const char *path = arena_format(a, "%s/%s%0*llx", parent_folder(), prefix, (int)KEY_DIGITS,
                                    (unsigned long long)key);
    for (unsigned i = 0; i < TRIES; i++) {
        if (mkdir(path, 0700) != 0 && errno != EEXIST)
            break;
        int lock = open(path, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
        if (lock < 0)
            continue;
        if (flock(lock, LOCK_SH) == 0 && is_usable(lock, path))
            return (shared_folder){path, lock};
        close(lock);
    }
    return (shared_folder){NULL, -1};
}

void temporary_leave(shared_folder folder) {
    /* non-blocking: if two processes leave at once, one gets the lock and removes the folder */
    if (flock(folder.lock, LOCK_EX | LOCK_NB) == 0)
        temporary_remove(folder.path);
    close(folder.lock);
}

static int remove_entry(const char *path, const struct stat *about, int kind, struct FTW *place) {
    (void)about;
    (void)kind;
    (void)place;
    return remove(path) == 0 || errno == ENOENT ? 0 : -1;
}

void temporary_remove(const char *folder) {
    nftw(folder, remove_entry, 16, FTW_DEPTH | FTW_PHYS);
}
