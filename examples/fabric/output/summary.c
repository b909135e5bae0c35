/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "output/summary.h"

#include <errno.h>
#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "output/fresh_file.h"
#include "output/memory.h"

const char *summary_phase_name(int phase_number) {
    static const char *const names[PHASE_COUNT] = {[PHASE_FORCES] = "forces",
                                                   [PHASE_COLLISIONS] = "collisions",
                                                   [PHASE_SOLVE] = "solve",
                                                   [PHASE_UPDATE] = "update"};
    return names[phase_number];
}

static json_t *phases_of(const simulation *sim) {
    json_t *phases = json_object();
    const phase *accounts = simulation_phases(sim);
    for (int k = 0; k < PHASE_COUNT; k++)
        json_object_set_new(phases, summary_phase_name(k),
                            json_pack("{s:f, s:I}", "seconds", accounts[k].seconds, "calls",
                                      (json_int_t)accounts[k].calls));
    return phases;
}

/** Lists the active effects with their counts and times, or the names of the inactive ones. */
static json_t *effects_of(const simulation *sim, int active) {
    int count;
    json_t *list = json_array();
    const effect_account *effects = simulation_effects(sim, &count);
    for (int k = 0; k < count; k++) {
        if ((effects[k].active != 0) != active)
            continue;
        json_array_append_new(
            list, active ? json_pack("{s:s, s:I, s:I, s:f}", "name", effects[k].name, "elements",
                                     (json_int_t)effects[k].elements, "visited",
                                     (json_int_t)effects[k].visited, "seconds", effects[k].seconds)
                         : json_string(effects[k].name));
    }
    return list;
}

/** Lists the rejected steps, each with the reason. */
static json_t *rejections_of(const simulation *sim) {
    int count;
    json_t *list = json_array();
    const rejection *all = simulation_rejections(sim, &count);
    for (int k = 0; k < count; k++) {
        const double value = isfinite(all[k].value) ? all[k].value : 0;
        json_array_append_new(list, json_pack("{s:s, s:f, s:f, s:f, s:f}", "reason", all[k].reason,
                                              "time", all[k].time, "step", all[k].h, "value", value,
                                              "limit", all[k].limit));
    }
    return list;
}

/** Faults that the run tolerated. */
static json_t *faults_of(const simulation *sim) {
    const run_faults f = simulation_faults(sim);
    json_t *faults =
        json_pack("{s:{s:I, s:I, s:I, s:I}, s:f, s:f, s:{s:I, s:f}, s:I}", "let_pass", "not solved",
                  (json_int_t)f.not_solved, "strain", (json_int_t)f.strain, "penetration",
                  (json_int_t)f.penetration, "passing", (json_int_t)f.passing, "greatest_strain",
                  f.greatest_strain, "deepest", f.deepest, "starts_inside", "vertices",
                  (json_int_t)f.start_inside, "deepest", f.start_depth, "solved_directly",
                  (json_int_t)f.solved_directly);
    if (!f.watched) { /* these are unknown if the monitor is off */
        json_object_del(faults, "greatest_strain");
        json_object_del(faults, "deepest");
        json_object_del(faults, "starts_inside");
    }
    return faults;
}

/* The number of threads in the last step. */
static int threads_at_last(const run_account *run) {
    const int chosen = simulation_threads(run->sim);
    return chosen > 0 ? chosen : run->threads;
}

static json_t *summary_of(const run_account *run) {
    const mesh *m = run->cloth;
    return json_pack(
        "{s:s, s:s, s:b, s:i, s:i, s:i, s:i, s:i, s:i, s:f, s:{s:I, s:I, s:I}, s:I, s:I, s:f, s:f, "
        "s:f, "
        "s:I, "
        "s:o, s:o, s:o, s:o, s:o}",
        "program", run->program, "scene", run->of->name, "interrupted", run->interrupted, "threads",
        run->threads, "threads_at_last", threads_at_last(run), "particles", m->vertex_count,
        "triangles", m->triangle_count, "edges", m->edge_count, "hinges", m->hinge_count,
        "simulated_seconds", simulation_time(run->sim), "steps", "taken",
        (json_int_t)simulation_counts(run->sim).taken, "rejected",
        (json_int_t)simulation_counts(run->sim).rejected, "slept",
        (json_int_t)simulation_counts(run->sim).slept, "cg_iterations",
        (json_int_t)simulation_counts(run->sim).iterations, "matrix_blocks",
        (json_int_t)simulation_counts(run->sim).matrix_blocks, "mesh_seconds", run->mesh_seconds,
        "setup_seconds", run->setup_seconds, "step_seconds", run->step_seconds, "most_memory_bytes",
        (json_int_t)memory_peak(), "phases", phases_of(run->sim), "effects",
        effects_of(run->sim, 1), "inactive_effects", effects_of(run->sim, 0), "rejections",
        rejections_of(run->sim), "faults", faults_of(run->sim));
}

int summary_write(const run_account *run, const char *path) {
    json_t *summary = summary_of(run);
    fresh_file f;
    int status = -1;
    if (!summary)
        fprintf(stderr, "%s: out of memory\n", path);
    else if (fresh_file_open(&f, path) == 0) {
        status = json_dumpf(summary, f.file, JSON_INDENT(2) | JSON_REAL_PRECISION(9));
        if (status != 0)
            fprintf(stderr, "%s: cannot be written: %s\n", path, strerror(errno));
        status = fresh_file_close(&f, status);
    }
    json_decref(summary);
    return status;
}

static void print_count(long count, const char *what) {
    if (count > 0)
        printf("  %ld %s\n", count, what);
}

static void print_faults(const simulation *sim) {
    const run_faults f = simulation_faults(sim);
    if (f.start_inside > 0)
        printf("  the cloth starts with %ld vertices inside a collider, %g m deep\n",
               f.start_inside, f.start_depth);
    print_count(
        f.solved_directly,
        "systems on which the conjugate gradients did not converge, or the ones after such, "
        "were solved directly");
    print_count(f.not_solved, "of the shortest steps were taken without a converged solution");
    print_count(f.strain, "of the shortest steps were taken though the strain grew too much");
    print_count(f.penetration,
                "steps were taken though vertices went into a collider: shorter ones "
                "did not help");
    print_count(f.passing,
                "steps were taken though cloth passed through itself or a collider: shorter ones "
                "did not help");
    if (f.greatest_strain >= f.strain_limit)
        printf("  the cloth was stretched to %.3g times its length\n", 1 + f.greatest_strain);
    if (f.deepest > f.start_depth && f.penetration > 0)
        printf("  the deepest vertex was %g m inside a collider\n", f.deepest);
}

void summary_print(const run_account *run) {
    const simulation *sim = run->sim;
    const phase *phases = simulation_phases(sim);
    printf("%s: %d particles, %d triangles; %ld steps taken, %ld rejected; %.3f s simulated\n",
           run->of->name, run->cloth->vertex_count, run->cloth->triangle_count,
           simulation_counts(sim).taken, simulation_counts(sim).rejected, simulation_time(sim));
    printf("%.3f s on %d thread%s", run->step_seconds, run->threads, run->threads == 1 ? "" : "s");
    if (threads_at_last(run) != run->threads)
        printf(" at most, %d at last", threads_at_last(run));
    printf(", %ld iterations of conjugate gradients\n", simulation_counts(sim).iterations);
    int count;
    const rejection *rejected = simulation_rejections(sim, &count);
    for (int k = 0; k < count && k < 5; k++)
        printf("  a step of %g s at %g s was taken again in halves: %s %g, limit %g%s\n",
               rejected[k].h, rejected[k].time, rejected[k].reason, rejected[k].value,
               rejected[k].limit, k == 4 && count > 5 ? " (and others)" : "");
    print_faults(sim);
    for (int k = 0; k < PHASE_COUNT; k++)
        printf("  %-12s %9.3f s %8ld calls\n", summary_phase_name(k), phases[k].seconds,
               phases[k].calls);
}
