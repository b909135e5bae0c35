/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The experiment `horizon`: the time after which chaos limits accuracy, from runs with nearly equal
 * starts. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "accuracy/study.h"

/* Number of perturbed runs, and the largest perturbation of a coordinate, m. */
enum { MOVED_RUNS = 16 };
static const double moved = 1e-9;

/* All runs of a scene, advanced together; [0] starts unperturbed. */
typedef struct ensemble {
    mesh cloth[1 + MOVED_RUNS]; /* the perturbed meshes own only `position` */
    simulation *run[1 + MOVED_RUNS];
    int count;
} ensemble;

static void ensemble_free(ensemble *all) {
    for (int r = 0; r < all->count; r++) {
        simulation_free(all->run[r]);
        if (r > 0)
            free(all->cloth[r].position);
    }
}

/* Adds a run with a perturbed start (the first: unperturbed). Returns 0, or -1 after a message. */
static int ensemble_add(ensemble *all, const study *of, random_source *source) {
    const int r = all->count;
    mesh *cloth = &all->cloth[r];
    if (r == 0)
        *cloth = of->cloth;
    else if (move_start(&of->cloth, moved, source, cloth) != 0)
        return -1;
    all->count++;
    all->run[r] = study_simulation(cloth, &of->base);
    return all->run[r] ? 0 : -1;
}

/* Writes a row for each run. Returns the root mean square of their distances from the first run,
 * m. */
static double write_rows(const study *of, const ensemble *all, FILE *file) {
    const int vertices = of->cloth.vertex_count;
    double squares = 0;
    for (int r = 0; r < all->count; r++) {
        const simulation *run = all->run[r];
        const double distance = distance_of(vertices, simulation_positions(run),
                                            simulation_positions(all->run[0]), NULL);
        squares += distance * distance;
        fprintf(file, "%.6g,%d,%.4g,%.6g,%.6g\n", simulation_time(run), r, distance,
                total_energy(run), lowest_point(vertices, simulation_positions(run)));
    }
    return sqrt(squares / (double)MOVED_RUNS);
}

/* Steps all runs until one fails, and reports when their distance exceeds each mark. */
static void follow(const study *of, ensemble *all, FILE *file) {
    static const double marks[] = {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1}; /* m */
    enum { MARKS = sizeof marks / sizeof *marks };
    char error[256] = "";
    int passed = 0;
    for (int n = 0; n < of->base.time.steps; n++) {
        for (int r = 0; r < all->count; r++)
            if (simulation_step(all->run[r], error) != 0) {
                fprintf(stderr, "%s: run %d: %s\n", of->base.name, r, error);
                return;
            }
        const double distance = write_rows(of, all, file);
        for (; passed < MARKS && distance > marks[passed]; passed++)
            fprintf(stderr, "horizon: %g mm apart after %.3g s\n", 1e3 * marks[passed],
                    simulation_time(all->run[0]));
    }
}

/* Reports mean and standard deviation over the perturbed runs' ends. */
static void report_ends(const study *of, const ensemble *all) {
    double sum[2] = {0}, squares[2] = {0};
    for (int r = 1; r < all->count; r++) {
        const double value[] = {
            total_energy(all->run[r]),
            lowest_point(of->cloth.vertex_count, simulation_positions(all->run[r]))};
        for (int k = 0; k < 2; k++) {
            sum[k] += value[k] / (double)MOVED_RUNS;
            squares[k] += value[k] * value[k] / (double)MOVED_RUNS;
        }
    }
    fprintf(stderr,
            "horizon: after %.3g s the %d runs have %.4g +- %.2g J, their lowest point at %.4g +- "
            "%.2g m\n",
            simulation_time(all->run[0]), MOVED_RUNS, sum[0],
            sqrt(fmax(squares[0] - sum[0] * sum[0], 0)), sum[1],
            sqrt(fmax(squares[1] - sum[1] * sum[1], 0)));
}

int study_horizon(study *of) {
    random_source source = {1};
    ensemble *all = calloc(1, sizeof *all);
    FILE *file = study_open(of, "horizon.csv", "time,run,distance_rms,energy,lowest\n");
    int status = all && file ? 0 : -1;
    while (status == 0 && all->count <= MOVED_RUNS)
        status = ensemble_add(all, of, &source);
    if (status == 0) {
        follow(of, all, file);
        report_ends(of, all);
    }
    if (all)
        ensemble_free(all);
    free(all);
    return file && study_close(file) != 0 ? -1 : status;
}
