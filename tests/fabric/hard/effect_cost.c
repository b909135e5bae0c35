/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* A sheet without some effects: its cost is counted in a build with these effects and in one
 * without them. Argument: the sheet's name. */
#include <stdio.h>
#include <string.h>

#include "cloth.h"
#include "step/simulation.h"

static pin hold = {.low = {-0.01, -0.01}, .high = {0.01, 100}};

/* Selects stretch, shear and pins, or the effects of sheet `name`. Returns 0, or -1 if there is no
 * such sheet. */
static int choose(scene *s, const char *name) {
    s->material.bend = s->material.bend_damping = 0;
    s->pins = &hold;
    s->pin_count = 1;
    if (strcmp(name, "held") == 0)
        return 0;
    if (strcmp(name, "no-shear") == 0)
        s->material.shear = s->material.shear_damping = 0;
    else if (strcmp(name, "no-stretch") == 0)
        s->material.stretch = s->material.stretch_damping = 0;
    else if (strcmp(name, "unwatched") == 0)
        s->monitor.off = 1;
    else if (strcmp(name, "weightless") == 0)
        s->surroundings.gravity[0] = s->surroundings.gravity[1] = s->surroundings.gravity[2] = 0;
    else if (strcmp(name, "free") == 0) /* only gravity and inner forces */
        s->pin_count = 0;
    else
        return -1;
    return 0;
}

int main(int argc, char **argv) {
    char error[256];
    mesh m = cloth_sheet(25, 25, 0.04, 0.3, 1);
    scene s = cloth_scene();
    s.solution.tolerance = 1e-3;
    if (argc != 2 || choose(&s, argv[1]) != 0) {
        fprintf(stderr, "which sheet?\n");
        return 2;
    }
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
