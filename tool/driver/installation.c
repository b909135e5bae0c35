/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "driver/installation.h"

#include <limits.h>
#include <stdlib.h>
#include <unistd.h>

#include "driver/files.h"
#include "support/buffer.h"

/* The library folder as configured ("lib", "lib64", "lib/x86_64-linux-gnu"), below the prefix. */
#ifndef REDCC_LIBRARY_FOLDER
#define REDCC_LIBRARY_FOLDER "lib"
#endif

/* The places of the files in a tree, as paths relative to its root. */
typedef struct layout {
    const char *translator;
    const char *library;
    const char *include;
} layout;

static const layout layouts[] = {
    {"bin/redcc", REDCC_LIBRARY_FOLDER, "include"}, /* installed; the root is the prefix */
    {"bin/redcc", "lib", "include"},      /* installed, with the libraries in lib in any case */
    {"tool/redcc", "runtime", "include"}, /* built; the root is the build folder */
};

/* The real path of a file in `folder`, NULL if it cannot be read. */
static const char *existing(arena *a, const char *folder, const char *name) {
    char real[PATH_MAX];
    const char *path = arena_format(a, "%s/%s", folder, name);
    return access(path, R_OK) == 0 && realpath(path, real) ? arena_string(a, real) : NULL;
}

static void search_tree(arena *a, const char *root, const layout *l, installation *found) {
    const char *library = arena_format(a, "%s/%s", root, l->library);
    const char *include = arena_format(a, "%s/%s", root, l->include);
    if (!found->translator)
        found->translator = existing(a, root, l->translator);
    if (!found->library)
        found->library = existing(a, library, "libredcc_rt.a");
    if (!found->library)
        found->library = existing(a, library, "libredcc_rt.so");
    if (!found->include && existing(a, include, "redcc/runtime.h"))
        found->include = existing(a, root, l->include);
}

installation installation_find(arena *a) {
    enum { LAYOUT_COUNT = sizeof layouts / sizeof layouts[0] };
    installation found = {NULL, NULL, NULL, NULL};
    char self[PATH_MAX];
    if (realpath("/proc/self/exe", self))
        found.self = arena_string(a, self);
    const char *given = getenv("REDCC_ROOT");
    if (given && *given) {
        for (unsigned i = 0; i < LAYOUT_COUNT; i++)
            search_tree(a, given, &layouts[i], &found);
        return found;
    }
    if (!found.self)
        return found;
    const char *folder = path_folder(a, found.self);
    search_tree(a, arena_format(a, "%s/..", folder), &layouts[0], &found);
    search_tree(a, arena_format(a, "%s/..", folder), &layouts[1], &found);
    search_tree(a, arena_format(a, "%s/../..", folder), &layouts[2], &found); /* self: redcc-cc */
    search_tree(a, arena_format(a, "%s/..", folder), &layouts[2], &found);    /* self: redcc */
    return found;
}

const char *installation_documents(arena *a) {
    if (*REDCC_DOCUMENTS_URI)
        return REDCC_DOCUMENTS_URI;
    char real[PATH_MAX];
    const installation found = installation_find(a);
    if (!found.self || !realpath(arena_format(a, "%s/../" REDCC_DOCUMENTS_FOLDER "/reasons.md",
                                              path_folder(a, found.self)),
                                 real))
        return NULL;
    buffer uri = {0};
    buffer_text(&uri, "file://");
    buffer_uri(&uri, path_folder(a, real));
    return buffer_take(a, &uri);
}
