/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* fabric plan: prints the effects of a scene without running it. */
#include <stdio.h>
#include <stdlib.h>

#include "commands/commands.h"
#include "output/memory.h"
#include "step/doubts.h"
#include "step/plan.h"
#include "step/simulation.h"

enum { ERROR_SIZE = 256 };

typedef struct request {
    const char *scene_name;
    setting_list settings;
} request;

static const option plan_options[] = {SETTING_OPTION(request, "material.bend=0"), {.name = NULL}};

static double mebibytes(double bytes) {
    return bytes / (1024.0 * 1024.0);
}

static void print_events(const scene *s) {
    enum { MOST_EVENTS = 20 };
    double time[MOST_EVENTS];
    const int count = plan_events(s, time, MOST_EVENTS);
    for (int k = 0; k < count && k < MOST_EVENTS; k++)
        printf("%s %g s%s", k == 0 ? "something begins or ends at" : ",", time[k],
               k == MOST_EVENTS - 1 && count > MOST_EVENTS ? ", ..." : "");
    if (count > 0)
        putchar('\n');
}

/* Resident memory, bytes, of code and libraries' tables. text_of_steps: first touched in the first
 * steps (0.7 to 1.2 MiB measured). text_of_direct: by the first direct solution, in CHOLMOD and
 * BLAS. */
static const double text_of_steps = 0.9 * 1024 * 1024, text_of_direct = 0.8 * 1024 * 1024;

/* Memory of the process before the cloth is made. */
typedef struct memory_account {
    double at_start, allocated_at_start; /* bytes */
} memory_account;

static void print_memory(const memory_account *before, const scene *s, const simulation *sim) {
    const double allocated = memory_allocated();
    if (allocated < 0)
        return;
    const double cloth = allocated - before->allocated_at_start, most = memory_peak();
    const double held = before->at_start + text_of_steps + cloth;
    int only;
    const double bytes = simulation_direct_bytes(sim, &only);
    const double direct = bytes > 0 ? bytes + text_of_direct : 0;
    const double run = (held > most ? held : most) + (only ? direct : 0);
    printf("memory: the cloth takes %.2f MiB, a run %.2f MiB", mebibytes(cloth), mebibytes(run));
    if (!only && direct > 0)
        printf(", %.2f MiB more where systems are solved directly", mebibytes(direct));
    puts(s->self_collision.gap > 0 ? ", and more for pairs that come close" : "");
}

static void print_plan(const scene *s, const mesh *m, const simulation *sim) {
    int count;
    const effect_account *effects = simulation_effects(sim, &count);
    const double blocks = (double)simulation_counts(sim).matrix_blocks;
    const double mesh_bytes =
        (double)m->vertex_count * (sizeof *m->position + sizeof *m->material) +
        (double)m->triangle_count * sizeof *m->triangle + (double)m->edge_count * sizeof *m->edge +
        (double)m->hinge_count * sizeof *m->hinge;
    printf("%s: %d steps of %g s\n", s->name, s->time.steps, s->time.step);
    printf("mesh: %d particles, %d triangles, %d edges, %d hinges, %.2f MiB\n", m->vertex_count,
           m->triangle_count, m->edge_count, m->hinge_count, mebibytes(mesh_bytes));
    printf("matrix: %.0f blocks of 3 x 3, %.0f bytes (%.2f MiB)\n", blocks,
           blocks * 9.0 * sizeof(double), mebibytes(blocks * 9.0 * sizeof(double)));
    printf("%-20s %-8s %10s\n", "effect", "active", "elements");
    for (int k = 0; k < count; k++)
        printf("%-20s %-8s %10ld\n", effects[k].name,
               !effects[k].active ? "no" : (effects[k].on ? "yes" : "later"),
               effects[k].active ? effects[k].elements : 0);
    print_events(s);
}

static int plan(const scene *s) {
    char error[ERROR_SIZE] = "";
    mesh m = {0};
    const memory_account before = {memory_peak(), memory_allocated()};
    if (scene_mesh(s, &m, NULL) != 0)
        return EXIT_FAILURE;
    scene_doubts(s, &m, stderr);
    simulation *sim = simulation_new(&m, s, error);
    if (sim) {
        simulation_make_room(sim);
        print_plan(s, &m, sim);
        print_memory(&before, s, sim);
    } else
        fprintf(stderr, "%s: %s\n", s->name, error);
    const int status = sim ? EXIT_SUCCESS : EXIT_FAILURE;
    simulation_free(sim);
    mesh_free(&m);
    return status;
}

static int take_word(const options *o, void *to) {
    return options_only_word(o, &((request *)to)->scene_name, "scene");
}

static int run(const command *self, int argc, char **argv) {
    request r = {.scene_name = NULL};
    scene s;
    const int read = options_read(self, argc, argv, &r, take_word);
    if (read != OPTIONS_READ)
        return read;
    if (!r.scene_name)
        return options_complain(self, "which scene? %s", self->synopsis);
    if (read_scene(&s, r.scene_name, &r.settings) != 0)
        return EXIT_FAILURE;
    const int status = plan(&s);
    scene_free(&s);
    return status;
}

const command plan_command = {"plan", "SCENE [options]",
                              "Lists the effects that a scene uses with their elements, matrix "
                              "blocks, bytes.",
                              plan_options, run};
