/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/*
 * generate FIRST COUNT [--without=N,N...] [--crlf]
 *
 * Prints a C program of COUNT random programs, of the seeds FIRST ... FIRST + COUNT - 1, each a
 * kernel with memory of its own: program S of one text is program S of any other. --without leaves
 * statements of these numbers out; --statements prints how many there are.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fuzz/kernel.h"

enum { MOST_STATEMENTS = 1000 };

typedef struct request {
    uint64_t first;
    int count;
    bool has_without;
    bool without[MOST_STATEMENTS];
    bool with_crlf;
    bool only_statements;
} request;

static bool read_without(request *r, const char *list) {
    r->has_without = true;
    while (*list) {
        char *end;
        const long number = strtol(list, &end, 10);
        if (end == list || number < 0 || number >= MOST_STATEMENTS)
            return false;
        r->without[number] = true;
        list = *end == ',' ? end + 1 : end;
    }
    return true;
}

static bool read_request(request *r, int argc, char **argv) {
    if (argc < 3)
        return false;
    r->first = strtoull(argv[1], NULL, 10);
    r->count = atoi(argv[2]);
    for (int i = 3; i < argc; i++) {
        if (strncmp(argv[i], "--without=", 10) == 0) {
            if (!read_without(r, argv[i] + 10))
                return false;
        } else if (strcmp(argv[i], "--crlf") == 0) {
            r->with_crlf = true;
        } else if (strcmp(argv[i], "--statements") == 0) {
            r->only_statements = true;
        } else {
            return false;
        }
    }
    return r->count > 0;
}

static void print(const buffer *b, bool with_crlf) {
    for (size_t i = 0; i < b->length; i++) {
        if (with_crlf && b->data[i] == '\n')
            putchar('\r');
        putchar(b->data[i]);
    }
}

int main(int argc, char **argv) {
    static request r;
    if (!read_request(&r, argc, argv)) {
        fputs("usage: generate FIRST COUNT [--without=N,N...] [--crlf] [--statements]\n", stderr);
        return 2;
    }
    buffer b = {0};
    int statements = 0;
    buffer_text(&b, "#include \"fuzz.h\"\n\n");
    for (int i = 0; i < r.count; i++)
        statements = put_kernel(&b, r.first + (uint64_t)i, r.has_without ? r.without : NULL,
                                MOST_STATEMENTS);
    buffer_text(&b, "int main(void) {\n");
    for (int i = 0; i < r.count; i++)
        buffer_format(&b, "    run_%llu();\n", (unsigned long long)r.first + (unsigned)i);
    buffer_text(&b, "    return 0;\n}\n");
    if (r.only_statements)
        printf("%d\n", statements);
    else
        print(&b, r.with_crlf);
    buffer_free(&b);
    return 0;
}
