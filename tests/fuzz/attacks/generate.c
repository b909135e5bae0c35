/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/*
 * attacks FIRST COUNT [--only=S,S...] [--without=N,N...] [--statements] [--flags]
 *
 * Prints a C program with the attacks of the seeds FIRST ... FIRST + COUNT - 1, all in one block of
 * a hundred seeds. --only selects the seeds named, and --without leaves out the statements with
 * these numbers. --statements prints the number of statements, and --flags the block's compiler
 * options. The program prints a line for each seed, and begins with the seed that is its argument.
 */
#include <stdio.h>

#include "fuzz/attacks/attack.h"
#include "fuzz/request.h"

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
    own_option flags = {.name = "--flags"};
    if (!request_read(&r, &flags, argc, argv) || r.first % BLOCK + (uint64_t)r.count > BLOCK) {
        fputs("usage: attacks FIRST COUNT [--only=S,S...] [--without=N,N...] [--statements] "
              "[--flags]\n"
              "       (seeds of one block of a hundred)\n",
              stderr);
        return 2;
    }
    buffer b = {0};
    const int statements = put_programs(&b, &r);
    if (flags.is_given)
        puts(flags_of_block(r.first / BLOCK)->options);
    else if (r.only_statements)
        printf("%d\n", statements);
    else
        fputs(b.data, stdout);
    buffer_free(&b);
    return 0;
}
