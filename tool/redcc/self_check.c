/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "redcc/self_check.h"

#include <string.h>

#include "analysis/base/reason.h"
#include "driver/files.h"
#include "driver/installation.h"
#include "redcc/bindings.h"

static frontend_result parse(arena *a, const source *file, const string_list *flags) {
    return frontend_parse(a, file, flags->count, flags->items);
}

static string_list with_flags(arena *a, const string_list *flags, const char *const *more) {
    string_list all = {0};
    for (unsigned i = 0; i < flags->count; i++)
        VECTOR_PUSH(a, &all, flags->items[i]);
    for (; *more; more++)
        VECTOR_PUSH(a, &all, *more);
    return all;
}

static void note(arena *a, const emit_result *written, int loop, reason_id id, const char *text,
                 reason *found) {
    for (unsigned i = 0; i < written->loop_count; i++)
        if ((loop < 0 || (unsigned)loop == i) && found[i].id == REASON_NONE)
            found[i] = reason_make(a, id, text, (ir_range){0});
}

static void note_errors(arena *a, bool is_parsed, const frontend_result *result,
                        const emit_result *written, reason *found) {
    if (!is_parsed)
        note(a, written, -1, REASON_INTERNAL, "it cannot be parsed at all", found);
    for (unsigned i = 0; i < result->diagnostic_count; i++) {
        const frontend_diagnostic *d = &result->diagnostics[i];
        const int loop = d->is_placed ? written_loop_at(written, d->offset) : -1;
        if (d->is_error)
            note(a, written, loop, REASON_INTERNAL, d->text, found);
    }
}

static void note_bindings(arena *a, const ir_unit *input, const ir_unit *output,
                          const emit_result *written, reason *found) {
    const char **wrong = ARENA_ARRAY(a, const char *, written->loop_count + 1);
    bindings_check(input, output, written, wrong);
    for (unsigned i = 0; i < written->loop_count; i++)
        if (wrong[i])
            note(a, written, (int)i, REASON_BINDING, wrong[i], found);
}

static void note_types(arena *a, const ir_unit *output, const emit_result *written, reason *found) {
    const char **wrong = ARENA_ARRAY(a, const char *, written->loop_count + 1);
    types_check(output, written, wrong);
    for (unsigned i = 0; i < written->loop_count; i++)
        if (wrong[i])
            note(a, written, (int)i, REASON_INTERNAL,
                 arena_format(a, "an expression in it is not of type '%s'", wrong[i]), found);
}

bool self_check(arena *a, const ir_unit *input, const string_list *flags,
                const emit_result *written, reason *found) {
    const source *output = source_from_text(a, input->source->path, written->text, written->length);
    const char *const parallel_flags[] = {"-DREDCC_IS_CHECKED", "-idirafter",
                                          installation_find(a).include, NULL};
    const string_list parallel = with_flags(a, flags, parallel_flags);
    const frontend_result first = parse(a, output, &parallel);
    if (first.unit) /* reported before errors, since changed meanings of names explain more */
        note_bindings(a, input, first.unit, written, found);
    note_errors(a, first.unit != NULL, &first, written, found);
    if (first.unit)
        note_types(a, first.unit, written, found);
    const char *const sequential_flags[] = {"-DREDCC_OFF", NULL};
    const string_list sequential = with_flags(a, flags, sequential_flags);
    frontend_result second;
    const bool is_parsed =
        frontend_diagnose(a, output, sequential.count, sequential.items, &second);
    note_errors(a, is_parsed, &second, written, found);
    for (unsigned i = 0; i < written->loop_count; i++)
        if (found[i].id != REASON_NONE)
            return false;
    return true;
}

/* The folder that flag *i adds to the search path of headers, or NULL if it is another flag. */
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

bool own_runtime_header_exists(arena *a) {
    return installation_find(a).include != NULL;
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
