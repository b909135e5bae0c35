/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "self_check.h"

#include <string.h>

#include "driver/files.h"
#include "driver/installation.h"

static frontend_result parse(arena *a, const source *file, const string_list *flags) {
    return frontend_parse(a, file, flags->count, flags->items);
}

static const char *first_error(const frontend_result *result) {
    for (unsigned i = 0; i < result->diagnostic_count; i++)
        if (result->diagnostics[i].is_error)
            return result->diagnostics[i].text;
    return result->unit ? NULL : "it cannot be parsed at all";
}

static bool is_missing_header(const char *error) {
    return strstr(error, "redcc/runtime.h") && strstr(error, "not found");
}

static string_list with_flags(arena *a, const string_list *flags, const char *const *more) {
    string_list all = {0};
    for (unsigned i = 0; i < flags->count; i++)
        VECTOR_PUSH(a, &all, flags->items[i]);
    for (; *more; more++)
        VECTOR_PUSH(a, &all, *more);
    return all;
}

const char *self_check(arena *a, const source *input, const string_list *flags, const char *text,
                       size_t length) {
    const source *output = source_from_text(a, input->path, text, length);
    const char *include = installation_find(a).include;
    const char *const parallel_flags[] = {"-fopenmp", include ? "-idirafter" : NULL, include, NULL};
    const string_list parallel = with_flags(a, flags, parallel_flags);
    const frontend_result first = parse(a, output, &parallel);
    const char *error = first_error(&first);
    if (error && !is_missing_header(error))
        return error;
    const char *const sequential_flags[] = {"-fno-openmp", "-U_OPENMP", NULL};
    const string_list sequential = with_flags(a, flags, sequential_flags);
    const frontend_result second = parse(a, output, &sequential);
    error = first_error(&second);
    if (!error)
        return NULL;
    /* the user's own text may hold without OpenMP what it does not hold with it */
    const frontend_result before = parse(a, input, &sequential);
    return first_error(&before) ? NULL : error;
}

/* The folder that a flag adds to the places where headers are looked for; NULL: another flag. */
static const char *header_folder(const string_list *flags, unsigned *i) {
    static const char *const names[] = {"-I", "-isystem"};
    const char *flag = flags->items[*i];
    for (unsigned k = 0; k < sizeof names / sizeof *names; k++) {
        const size_t length = strlen(names[k]);
        if (strncmp(flag, names[k], length) != 0)
            continue;
        if (flag[length])
            return flag + length;
        return *i + 1 < flags->count ? flags->items[++*i] : NULL;
    }
    return NULL;
}

const char *other_runtime_header(arena *a, const string_list *flags) {
    static const char name[] = "redcc/runtime.h";
    const char *own = installation_find(a).include;
    for (unsigned i = 0; own && i < flags->count; i++) {
        const char *folder = header_folder(flags, &i);
        const char *path = folder ? arena_format(a, "%s/%s", folder, name) : NULL;
        if (path && file_read(a, path, NULL) &&
            !file_equal(a, path, arena_format(a, "%s/%s", own, name)))
            return arena_format(a, "'%s' would be included in place of redcc's own header", path);
    }
    return NULL;
}
