/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/*
 * Which flags of a compiler's command line libclang may see. Only what changes the meaning of the
 * text: others write files (-MMD), are fatal to libclang (-save-temps), or hide loops (-fopenmp).
 */
#include <dirent.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "frontend/translation.h"

enum { JOINED = 1, SEPARATE = 2 };

/* Sorted by name is not needed: few, and looked at once. */
static const struct {
    const char *name;
    unsigned form; /* how its argument is given; 0: none */
} forwarded[] = {
    {"-I", JOINED | SEPARATE},
    {"-isystem", JOINED | SEPARATE},
    {"-iquote", JOINED | SEPARATE},
    {"-idirafter", JOINED | SEPARATE},
    {"-include", SEPARATE},
    {"-imacros", SEPARATE},
    {"-D", JOINED | SEPARATE},
    {"-U", JOINED | SEPARATE},
    {"-std=", JOINED},
    {"-ansi", 0},
    {"-m", JOINED},
    {"-fsigned-char", 0},
    {"-funsigned-char", 0},
    {"-fno-signed-char", 0},
    {"-fno-unsigned-char", 0},
    {"-fshort-enums", 0},
    {"-fno-builtin", JOINED},
    {"-nostdinc", 0},
    {"--sysroot", JOINED | SEPARATE},
    {"-pthread", 0},
    {"-O", JOINED},
    {"-fno-strict-aliasing", 0},
};

static const char *const ours[] = {
    "-xc",
    "-w",
    "-ferror-limit=0",
    "-fbracket-depth=100000",
    "-Wno-error=implicit-function-declaration",
    "-Wno-error=implicit-int",
    "-Wno-error=int-conversion",
    "-Wno-error=incompatible-function-pointer-types",
    "-Wno-error=incompatible-pointer-types",
    "-Wno-error=return-type",
};

/* 0: not forwarded; 1: this word; 2: this and the next. */
static int words_of(const char *flag) {
    for (size_t i = 0; i < sizeof forwarded / sizeof *forwarded; i++) {
        const size_t n = strlen(forwarded[i].name);
        if (strncmp(flag, forwarded[i].name, n) != 0)
            continue;
        if (flag[n] == 0)
            return forwarded[i].form & SEPARATE ? 2 : 1;
        if (forwarded[i].form & JOINED)
            return 1;
    }
    return 0;
}

/* gcc's own headers (omp.h), after all others: the newest version there is. */
static const char *gcc_headers(arena *a) {
    const char *root = "/usr/lib/gcc/x86_64-linux-gnu";
    long newest = -1;
    DIR *folder = opendir(root);
    if (!folder)
        return NULL;
    for (const struct dirent *entry; (entry = readdir(folder)) != NULL;) {
        const long version = strtol(entry->d_name, NULL, 10);
        if (version > newest)
            newest = version;
    }
    closedir(folder);
    return newest > 0 ? arena_format(a, "%s/%ld/include", root, newest) : NULL;
}

flag_list frontend_flags(arena *a, unsigned count, const char *const *flags,
                         bool *strict_aliasing) {
    flag_list list = {0};
    bool openmp = false;
    *strict_aliasing = true;
    for (size_t i = 0; i < sizeof ours / sizeof *ours; i++)
        VECTOR_PUSH(a, &list, ours[i]);
    if (access(CLANG_RESOURCE_DIRECTORY "/include/stddef.h", R_OK) == 0) {
        VECTOR_PUSH(a, &list, "-resource-dir");
        VECTOR_PUSH(a, &list, CLANG_RESOURCE_DIRECTORY);
    }
    for (unsigned i = 0; i < count; i++) {
        if (strcmp(flags[i], "-fno-strict-aliasing") == 0)
            *strict_aliasing = false;
        if (strcmp(flags[i], "-fstrict-aliasing") == 0)
            *strict_aliasing = true;
        openmp |= strncmp(flags[i], "-fopenmp", 8) == 0 && strcmp(flags[i], "-fopenmp-simd") != 0;
        const int words = words_of(flags[i]);
        if (words > 0)
            VECTOR_PUSH(a, &list, flags[i]);
        if (words == 2 && i + 1 < count)
            VECTOR_PUSH(a, &list, flags[++i]);
    }
    if (openmp) {
        VECTOR_PUSH(a, &list, "-D_OPENMP=201511");
        VECTOR_PUSH(a, &list, "-D__malloc__(...)=__malloc__"); /* gcc-12's omp.h */
    }
    const char *headers = gcc_headers(a);
    if (headers) {
        VECTOR_PUSH(a, &list, "-idirafter");
        VECTOR_PUSH(a, &list, headers);
    }
    return list;
}
