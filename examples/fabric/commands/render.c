/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* fabric render and fabric export: replace this process by fabric-view. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/files.h"
#include "commands/commands.h"

static const option no_options[] = {{.name = NULL}};

/** Executes fabric-view from this program's folder, otherwise from PATH. Returns only on errors. */
static void become_view(char **words) {
    char path[FILE_PATH_SIZE];
    if (files_in_program_folder(path, words[0]) == 0)
        execv(path, words);
    execvp(words[0], words);
}

static int run(const command *self, int argc, char **argv) {
    char view[] = "fabric-view", action[16];
    char **words = calloc((size_t)argc + 3, sizeof *words);
    if (!words)
        return options_complain(self, "out of memory");
    snprintf(action, sizeof action, "%s", self->name);
    words[0] = view;
    words[1] = action;
    memcpy(words + 2, argv, (size_t)argc * sizeof *words);
    become_view(words);
    free(words);
    options_complain(self, "%s, which draws, cannot be started: %s", view, strerror(errno));
    return EXIT_FAILURE;
}

const command render_command = {"render", "DIR [options]",
                                "Draws the frames of a run: the same as fabric-view render.",
                                no_options, run};
const command export_command = {"export", "DIR [options]",
                                "Writes the frames of a run for ParaView: the same as fabric-view "
                                "export.",
                                no_options, run};
