/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/*
 * attacks FIRST COUNT [--only=S,S...] [--without=N,N...] [--statements] [--flags]
 *
 * Prints a C program of the attacks of the seeds FIRST ... FIRST + COUNT - 1, which lie in one
 * block of a hundred; --only takes of these the ones named, --without leaves statements of these
 * numbers out,
 * --statements prints how many there are, --flags how the block is to be compiled. The program
 * prints a line for each seed; given a seed as its argument it begins with that one.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fuzz/attacks/attack.h"

enum { MOST_STATEMENTS = 1000 };

typedef struct request {
    uint64_t first;
    int count;
    bool taken[BLOCK];
    bool without[MOST_STATEMENTS];
    bool only_statements, only_flags;
} request;

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
            if (!read_list(r->without, MOST_STATEMENTS, 0, argv[i] + 10))
                return false;
        } else if (strncmp(argv[i], "--only=", 7) == 0) {
            memset(r->taken, false, sizeof r->taken);
            if (!read_list(r->taken, BLOCK, r->first, argv[i] + 7))
                return false;
        } else if (strcmp(argv[i], "--statements") == 0) {
            r->only_statements = true;
        } else if (strcmp(argv[i], "--flags") == 0) {
            r->only_flags = true;
        } else {
            return false;
        }
    }
    return r->count > 0 && r->first % BLOCK + (uint64_t)r->count <= BLOCK;
}

static int put_programs(buffer *b, const request *r) {
    int statements = 0;
    buffer_text(b, "#include \"attack_support.h\"\n");
    for (int i = 0; i < r->count; i++)
        if (r->taken[i])
            statements = put_attack(b, r->first + (uint64_t)i, r->without);
    buffer_text(b, "unsigned long strtoul(const char *, char **, int);\n"
                   "int main(int argc, char **argv) {\n"
                   "const unsigned long from = argc > 1 ? strtoul(argv[1], 0, 10) : 0;\n");
    for (int i = 0; i < r->count; i++)
        if (r->taken[i])
            buffer_format(b, "if (from <= %llu)\nrun_%llu();\n",
                          (unsigned long long)r->first + (unsigned)i,
                          (unsigned long long)r->first + (unsigned)i);
    buffer_text(b, "return 0;\n}\n");
    return statements;
}

int main(int argc, char **argv) {
    static request r;
    if (!read_request(&r, argc, argv)) {
        fputs("usage: attacks FIRST COUNT [--only=S,S...] [--without=N,N...] [--statements] "
              "[--flags]\n"
              "       (seeds of one block of a hundred)\n",
              stderr);
        return 2;
    }
    buffer b = {0};
    const int statements = put_programs(&b, &r);
    if (r.only_flags)
        puts(flags_of_block(r.first / BLOCK)->options);
    else if (r.only_statements)
        printf("%d\n", statements);
    else
        fputs(b.data, stdout);
    buffer_free(&b);
    return 0;
}
