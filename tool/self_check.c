/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "self_check.h"

#include <string.h>

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
