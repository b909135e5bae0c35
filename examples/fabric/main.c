/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* fabric and fabric-serial: the cloth simulator. */
#include "base/program.h"
#include "commands/commands.h"

int main(int argc, char **argv) {
    static const command *const commands[] = {&run_command,     &plan_command,   &compare_command,
                                              &render_command,  &export_command, &mesh_command,
                                              &accuracy_command};
    return program_run("Simulates a piece of cloth.", commands, sizeof commands / sizeof *commands,
                       argc, argv);
}
