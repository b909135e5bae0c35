/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* fabric and fabric-serial: the cloth simulator. */
#include "base/program.h"
#include "base/waiting.h"
#include "commands/commands.h"

#include <string.h>

int main(int argc, char **argv) {
    static const command *const commands[] = {&run_command,     &plan_command,   &compare_command,
                                              &render_command,  &export_command, &mesh_command,
                                              &accuracy_command};
    if (argc > 1 && strcmp(argv[1], run_command.name) == 0)
        waiting_is_short(argv);
    return program_run("Simulates a piece of cloth.", commands, sizeof commands / sizeof *commands,
                       argc, argv);
}
