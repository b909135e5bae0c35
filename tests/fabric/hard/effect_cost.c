/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* A sheet in which stretch, shear and pins act and nothing else: what it costs is counted in a
 * build with all effects and in one without those that do not act. */
#include <stdio.h>

#include "cloth.h"
#include "simulation.h"

int main(void) {
    char error[256];
    pin hold = {.low = {-0.01, -0.01}, .high = {0.01, 100}};
    mesh m = cloth_sheet(25, 25, 0.04, 0.3, 1);
    scene s = cloth_scene();
    s.bend = s.bend_damping = 0;
    s.tolerance = 1e-3;
    s.pins = &hold;
    s.pin_count = 1;
    simulation *sim = simulation_new(&m, &s, error);
    int status = sim ? 0 : 1;
    for (int n = 0; n < 5 && status == 0; n++)
        status = simulation_step(sim, error) != 0;
    if (status != 0)
        fprintf(stderr, "%s\n", error);
    simulation_free(sim);
    cloth_free(&m);
    return status;
}
