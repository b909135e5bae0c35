/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* fabric-view: shows what `fabric run` has left. A program of its own, so that simulating loads no
 * renderer. */
#include "base/program.h"
#include "view/view.h"

int main(int argc, char **argv) {
    static const command *const commands[] = {&render_command, &film_command, &gltf_command,
                                              &export_command, &plot_command};
    return program_run("Shows the frames of a run.", commands, sizeof commands / sizeof *commands,
                       argc, argv);
}
