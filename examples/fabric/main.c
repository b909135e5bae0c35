/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The command line of the cloth simulator: picks the command. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/words.h"
#include "commands/commands.h"

static const command *const commands[] = {&run_command,     &plan_command,   &compare_command,
                                          &render_command,  &export_command, &mesh_command,
                                          &accuracy_command};
enum { COMMAND_COUNT = sizeof commands / sizeof *commands };

static void print_help(FILE *out) {
    fprintf(out,
            "usage: %s COMMAND ...\n\nSimulates a piece of cloth. The commands, each with "
            "--help:\n",
            program_name);
    for (int k = 0; k < COMMAND_COUNT; k++)
        fprintf(out, "  %-10s %.*s\n", commands[k]->name,
                (int)strcspn(commands[k]->summary, ";.\n"), commands[k]->summary);
}

static int complain_unknown(const char *word) {
    const char *names[COMMAND_COUNT + 2] = {[COMMAND_COUNT] = "--help", "--version"};
    for (int k = 0; k < COMMAND_COUNT; k++)
        names[k] = commands[k]->name;
    const char *nearest = words_nearest(word, names, COMMAND_COUNT + 2);
    fprintf(stderr, "%s: unknown %s '%s'", program_name, word[0] == '-' ? "option" : "command",
            word);
    if (nearest)
        fprintf(stderr, ", did you mean '%s'?\n", nearest);
    else
        fprintf(stderr, ", --help lists the known ones\n");
    return EXIT_USAGE;
}

int main(int argc, char **argv) {
    if (argc > 0 && argv[0]) {
        const char *slash = strrchr(argv[0], '/');
        program_name = slash ? slash + 1 : argv[0];
    }
    if (argc < 2) {
        print_help(stderr);
        return EXIT_USAGE;
    }
    if (strcmp(argv[1], "--help") == 0) {
        print_help(stdout);
        return EXIT_SUCCESS;
    }
    if (strcmp(argv[1], "--version") == 0) {
        printf("%s %s\n", program_name, FABRIC_VERSION);
        return EXIT_SUCCESS;
    }
    for (int k = 0; k < COMMAND_COUNT; k++)
        if (strcmp(argv[1], commands[k]->name) == 0)
            return commands[k]->run(commands[k], argc - 2, argv + 2);
    return complain_unknown(argv[1]);
}
