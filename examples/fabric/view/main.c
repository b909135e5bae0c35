/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* fabric-view: shows the results of `fabric run`. It is a separate program, so that a simulation
 * loads no renderer. */
#include "base/program.h"
#include "view/view.h"

int main(int argc, char **argv) {
    static const command *const commands[] = {&render_command, &film_command, &gltf_command,
                                              &export_command, &plot_command};
    return program_run("Shows the frames of a run.", commands, sizeof commands / sizeof *commands,
                       argc, argv);
}
