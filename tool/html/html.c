/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "html/html.h"

#include <ctype.h>
#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "html/pages.h"
#include "html/reports.h"

enum { DONE = 0, FAILED = 1, USAGE = 2 };

static int fail(const char *what, const char *path) {
    fprintf(stderr, "redcc-cc: error: %s '%s': %s\n", what, path, strerror(errno));
    return FAILED;
}

/* Is this the name of a file that an earlier call has written: index.html, style.css,
 * 12-x.c.html? */
static bool is_page(const char *name) {
    const size_t digits = strspn(name, "0123456789"), length = strlen(name);
    if (strcmp(name, "index.html") == 0 || strcmp(name, "style.css") == 0)
        return true;
    return digits > 0 && name[digits] == '-' && length > 5 &&
           strcmp(name + length - 5, ".html") == 0;
}

/* If `removes`, removes all entries of the folder and returns NULL. Otherwise returns, in the
 * arena, the name of an entry that is no page; NULL if there is none. */
static const char *visit_entries(arena *a, const char *folder, bool removes) {
    const char *stranger = NULL;
    DIR *entries = opendir(folder);
    const struct dirent *entry;
    while (entries && (entry = readdir(entries))) {
        const char *name = entry->d_name;
        if (strcmp(name, ".") == 0 || strcmp(name, "..") == 0)
            continue;
        if (removes)
            unlink(arena_format(a, "%s/%s", folder, name));
        else if (!is_page(name) && (!stranger || strcmp(name, stranger) < 0))
            stranger = arena_string(a, name);
    }
    if (entries)
        closedir(entries);
    return stranger;
}

static void remove_folder(arena *a, const char *folder) {
    visit_entries(a, folder, true);
    rmdir(folder);
}

static bool write_page(const reports *r, const char *folder, const char *name, const buffer *text) {
    const char *path = arena_format(r->memory, "%s/%s", folder, name);
    FILE *file = fopen(path, "wb");
    if (!file)
        return false;
    const bool good = fwrite(text->data, 1, text->length, file) == text->length;
    return fclose(file) == 0 && good;
}

static bool write_pages(const reports *r, const char *folder) {
    buffer text = {0};
    buffer_text(&text, page_style);
    bool good = write_page(r, folder, "style.css", &text);
    buffer_shorten(&text, text.length);
    page_index(r, &text);
    good = good && write_page(r, folder, "index.html", &text);
    for (unsigned i = 0; good && i < r->files.count; i++) {
        const char *name = page_name(r, r->files.items[i]);
        if (!name)
            continue;
        buffer_shorten(&text, text.length);
        page_source(r, r->files.items[i], &text);
        good = write_page(r, folder, name, &text);
    }
    buffer_free(&text);
    return good;
}

/* Writes the pages to a new folder, which then replaces the old one. */
static int write_folder(const reports *r, const char *folder) {
    arena *a = r->memory;
    struct stat about;
    const bool exists = lstat(folder, &about) == 0;
    const char *stranger = exists ? visit_entries(a, folder, false) : NULL;
    if (exists && !S_ISDIR(about.st_mode)) {
        fprintf(stderr, "redcc-cc: error: '%s' exists, and is no folder\n", folder);
        return FAILED;
    }
    if (stranger) {
        fprintf(
            stderr,
            "redcc-cc: error: '%s' holds '%s', which is none of the pages: name a folder that is "
            "new, empty or of an earlier --redcc-html\n",
            folder, stranger);
        return FAILED;
    }
    const char *fresh = arena_format(a, "%s.new-%ld", folder, (long)getpid());
    const char *old = arena_format(a, "%s.old-%ld", folder, (long)getpid());
    if (mkdir(fresh, 0777) != 0)
        return fail("cannot create", fresh);
    bool good = write_pages(r, fresh);
    good = good && (!exists || rename(folder, old) == 0);
    if (good && rename(fresh, folder) != 0) {
        good = false;
        if (exists)
            rename(old, folder);
    }
    const int status = good ? DONE : fail("cannot write", folder);
    remove_folder(a, good ? old : fresh);
    return status;
}

/* Sets `paths` to the reports that the environment names, and returns their number. */
static unsigned files_of_environment(char **paths) {
    char *build = getenv("REDCC_BUILD_REPORT"), *run = getenv("REDCC_REPORT");
    unsigned count = 0;
    if (!build || !*build)
        return 0;
    paths[count++] = build;
    if (run && *run && access(run, R_OK) == 0)
        paths[count++] = run;
    return count;
}

static const char *without_slashes(arena *a, const char *folder) {
    size_t length = strlen(folder);
    while (length > 1 && folder[length - 1] == '/')
        length--;
    return arena_copy(a, folder, length);
}

int html_write(const char *folder, unsigned count, char *const *paths) {
    char *usual[2];
    if (count == 0) {
        count = files_of_environment(usual);
        paths = usual;
    }
    if (!folder || !*folder || *folder == '-' || count == 0) {
        fputs(
            "redcc-cc: error: --redcc-html needs a folder for the pages and the reports of a build "
            "and of runs: redcc-cc --redcc-html DIR build.jsonl [run.json...]; without reports, "
            "REDCC_BUILD_REPORT names them\n",
            stderr);
        return USAGE;
    }
    reports r = {.memory = arena_new()};
    int status = FAILED;
    const char *why = reports_read(&r, count, paths);
    if (why)
        fprintf(stderr, "redcc-cc: %s\n", why);
    else
        status = write_folder(&r, without_slashes(r.memory, folder));
    reports_free(&r);
    arena_free(r.memory);
    return status;
}
