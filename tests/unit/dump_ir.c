/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* dump_ir FILE.c [FLAGS] prints the errors and the IR. It fails if the checker reports a fault, or
 * if the printed text is not read back as the same IR. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "frontend/frontend.h"
#include "ir_reader/ir_read.h"

static int fail(const char *what) {
    fprintf(stderr, "dump_ir: %s\n", what);
    return EXIT_FAILURE;
}

static int check_round_trip(arena *a, const buffer *text) {
    const char *message = NULL;
    ir_unit *unit = ir_read(a, text->data, text->length, &message);
    if (unit == NULL)
        return fail(message);
    buffer again = {0};
    ir_print(&again, unit);
    bool is_same = strcmp(again.data, text->data) == 0;
    if (!is_same)
        fputs(again.data, stderr);
    buffer_free(&again);
    const char *problem = ir_check(a, unit);
    return !is_same ? fail("read and printed, it differs") : problem != NULL ? fail(problem) : 0;
}

static int dump(arena *a, const source *src, unsigned flag_count, const char *const *flags) {
    frontend_result result = frontend_parse(a, src, flag_count, flags);
    for (unsigned i = 0; i < result.diagnostic_count; i++)
        if (result.diagnostics[i].is_error)
            printf("; %s\n", result.diagnostics[i].text);
    if (result.unit == NULL)
        return fail("nothing could be parsed");
    const char *problem = ir_check(a, result.unit);
    if (problem != NULL)
        return fail(problem);
    buffer text = {0};
    ir_print(&text, result.unit);
    fputs(text.data, stdout);
    int status = check_round_trip(a, &text);
    buffer_free(&text);
    return status;
}

int main(int argc, char **argv) {
    const char *message = NULL;
    arena *a = arena_new();
    source *src = argc > 1 ? source_read(a, argv[1], &message) : NULL;
    if (src == NULL)
        return fail(message != NULL ? message : "usage: dump_ir FILE.c [FLAGS]");
    int status = dump(a, src, (unsigned)argc - 2, (const char *const *)argv + 2);
    arena_free(a);
    return status;
}
