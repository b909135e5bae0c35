/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/*
 * generate FIRST COUNT [--only=S,S...] [--without=N,N...] [--crlf] [--statements]
 *
 * Prints a C program that consists of COUNT random programs, with the seeds FIRST ... FIRST + COUNT
 * - 1. Each is a kernel with separate memory, and depends only on its seed. --only selects the
 * seeds named, --without leaves out the statements with these numbers, and --crlf ends lines with
 * CR LF. --statements prints only the number of statements of the last program.
 */
#include <stdio.h>

#include "fuzz/kernel.h"
#include "fuzz/request.h"

static void print(const buffer *b, bool with_crlf) {
    for (size_t i = 0; i < b->length; i++) {
        if (with_crlf && b->data[i] == '\n')
            putchar('\r');
        putchar(b->data[i]);
    }
}

/* Writes the file. Returns the number of statements of its last program. */
static int put_programs(buffer *b, const request *r) {
    int statements = 0;
    buffer_text(b, "#include \"fuzz.h\"\n\n");
    for (int i = 0; i < r->count; i++)
        if (r->taken[i])
            statements = put_kernel(b, r->first + (uint64_t)i, r->has_without ? r->without : NULL,
                                    MOST_STATEMENTS);
    buffer_text(b, "int main(void) {\n");
    for (int i = 0; i < r->count; i++)
        if (r->taken[i])
            buffer_format(b, "    if (fuzz_runs(%llu))\n        run_%llu();\n",
                          (unsigned long long)r->first + (unsigned)i,
                          (unsigned long long)r->first + (unsigned)i);
    buffer_text(b, "    return 0;\n}\n");
    return statements;
}

int main(int argc, char **argv) {
    static request r;
    own_option crlf = {.name = "--crlf"};
    if (!request_read(&r, &crlf, argc, argv)) {
        fputs("usage: generate FIRST COUNT [--only=S,S...] [--without=N,N...] [--crlf] "
              "[--statements]\n",
              stderr);
        return 2;
    }
    buffer b = {0};
    const int statements = put_programs(&b, &r);
    if (r.only_statements)
        printf("%d\n", statements);
    else
        print(&b, crlf.is_given);
    buffer_free(&b);
    return 0;
}
