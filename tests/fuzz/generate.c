/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/*
 * generate FIRST COUNT [--only=S,S...] [--without=N,N...] [--crlf]
 *
 * Prints a C program of COUNT random programs, of the seeds FIRST ... FIRST + COUNT - 1, each a
 * kernel with memory of its own: program S of one text is program S of any other. --only takes of
 * these seeds the ones named; --without leaves statements of these numbers out; --statements prints
 * how many there are.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fuzz/kernel.h"

enum { MOST_STATEMENTS = 1000, MOST_PROGRAMS = 1000 };

typedef struct request {
    uint64_t first;
    int count;
    bool taken[MOST_PROGRAMS]; /* seed first + i */
    bool has_without;
    bool without[MOST_STATEMENTS];
    bool with_crlf;
    bool only_statements;
} request;

/* Numbers with commas between them, counted from `first`. */
static bool read_list(bool *set, int size, uint64_t first, const char *list) {
    while (*list) {
        char *end;
        const uint64_t number = strtoull(list, &end, 10) - first;
        if (end == list || number >= (uint64_t)size)
            return false;
        set[number] = true;
        list = *end == ',' ? end + 1 : end;
    }
    return true;
}

static bool read_request(request *r, int argc, char **argv) {
    if (argc < 3)
        return false;
    r->first = strtoull(argv[1], NULL, 10);
    r->count = atoi(argv[2]);
    memset(r->taken, true, sizeof r->taken);
    for (int i = 3; i < argc; i++) {
        if (strncmp(argv[i], "--without=", 10) == 0) {
            r->has_without = true;
            if (!read_list(r->without, MOST_STATEMENTS, 0, argv[i] + 10))
                return false;
        } else if (strncmp(argv[i], "--only=", 7) == 0) {
            memset(r->taken, false, sizeof r->taken);
            if (!read_list(r->taken, MOST_PROGRAMS, r->first, argv[i] + 7))
                return false;
        } else if (strcmp(argv[i], "--crlf") == 0) {
            r->with_crlf = true;
        } else if (strcmp(argv[i], "--statements") == 0) {
            r->only_statements = true;
        } else {
            return false;
        }
    }
    return r->count > 0 && r->count <= MOST_PROGRAMS;
}

static void print(const buffer *b, bool with_crlf) {
    for (size_t i = 0; i < b->length; i++) {
        if (with_crlf && b->data[i] == '\n')
            putchar('\r');
        putchar(b->data[i]);
    }
}

/* The file; returns the number of statements of its last program. */
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
    if (!read_request(&r, argc, argv)) {
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
        print(&b, r.with_crlf);
    buffer_free(&b);
    return 0;
}
