/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "base/program.h"

#include <assert.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/words.h"

enum { MOST_COMMANDS = 16 };

static void print_help(FILE *out, const char *purpose, const command *const *commands, int count) {
    fprintf(out, "usage: %s COMMAND ...\n\n%s The commands, each with --help:\n", program_name,
            purpose);
    for (int k = 0; k < count; k++)
        fprintf(out, "  %-10s %.*s\n", commands[k]->name,
                (int)strcspn(commands[k]->summary, ";.\n"), commands[k]->summary);
}

static int complain_unknown(const command *const *commands, int count, const char *word) {
    const char *names[MOST_COMMANDS + 2];
    for (int k = 0; k < count; k++)
        names[k] = commands[k]->name;
    names[count] = "--help";
    names[count + 1] = "--version";
    const char *nearest = words_nearest(word, names, count + 2);
    fprintf(stderr, "%s: unknown %s '%s'", program_name, word[0] == '-' ? "option" : "command",
            word);
    if (nearest)
        fprintf(stderr, ", did you mean '%s'?\n", nearest);
    else
        fprintf(stderr, ", --help lists the known ones\n");
    return EXIT_USAGE;
}

int program_run(const char *purpose, const command *const *commands, int count, int argc,
                char **argv) {
    assert(count <= MOST_COMMANDS);
    if (argc > 0 && argv[0]) {
        const char *slash = strrchr(argv[0], '/');
        program_name = slash ? slash + 1 : argv[0];
    }
    if (argc < 2) {
        print_help(stderr, purpose, commands, count);
        return EXIT_USAGE;
    }
    if (strcmp(argv[1], "--help") == 0) {
        print_help(stdout, purpose, commands, count);
        return EXIT_SUCCESS;
    }
    if (strcmp(argv[1], "--version") == 0) {
        printf("%s %s\n", program_name, FABRIC_VERSION);
        return EXIT_SUCCESS;
    }
    for (int k = 0; k < count; k++)
        if (strcmp(argv[1], commands[k]->name) == 0)
            return commands[k]->run(commands[k], argc - 2, argv + 2);
    return complain_unknown(commands, count, argv[1]);
}
