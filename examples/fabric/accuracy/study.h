/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The experiments of `fabric accuracy`. Each runs a scene many times and writes NAME.csv into a
 * folder, most with these columns:
 *
 *   experiment, scene, vertices, variant  what was varied, as text
 *   step, tolerance                       time step, s; tolerance that the experiment varies
 *   steps, rejected                       accepted steps, and rejected ones
 *   cg_iterations, newton_iterations      sums over all steps, free of timing noise
 *   cpu_seconds                           CPU time of the steps, minimum of the repetitions
 *   error_rms, error_max                  m, distance from the reference at the scene's end
 *   error_own                             m rms, distance from the same method with exact algebra,
 *                                         in experiments that run it
 *   front                                 1: on the Pareto front of time and error
 *   side, stiffness                       side of the cloth, m; its scene_stiffness
 *   contact, wind                         1 if the scene has colliders; if it has wind
 *   error_strain, error_energy            differences of the largest strain and of the energy (J)
 *                                         from the reference
 *   depth                                 m, greatest depth of a vertex in a collider in the run
 */
#ifndef FABRIC_ACCURACY_STUDY_H
#define FABRIC_ACCURACY_STUDY_H

#include <stdio.h>

#include "accuracy/measure.h"

typedef struct study_row {
    const char *experiment;
    char variant[48];
    int vertices;
    double step, tolerance;
    measured got; /* study_write frees its x */
    double error_rms, error_max, error_own, error_strain, error_energy;
    int front;
} study_row;

enum { MOST_ROWS = 256, MOST_COUNTS = 12 };

typedef struct study {
    scene base;
    mesh cloth;
    const char *folder;
    int repeat;
    int quick;                          /* fewer and coarser runs, for a test of the program */
    int steps[MOST_COUNTS], step_count; /* numbers of steps, ascending */
    measured reference;
    double reference_gap; /* m rms distance between the final states of the reference's two
                           * integrators */
    study_row rows[MOST_ROWS];
    int row_count;
} study;

/** Stretch stiffness divided by the weight of a strip as long as the sheet: the inverse of the
 *  strain under its own weight. No unit. */
double scene_stiffness(const scene *s);

/** Runs the scene on a cloth, which need not be the study's, and appends the result to the rows.
 *  Returns 0, or -1 after a message. */
int study_run(study *of, const char *experiment, const char *variant, const scene *s,
              const mesh *cloth, double tolerance);
/** Computes of->reference by the implicit midpoint, unless it exists, and of->reference_gap, its
 *  distance from BDF2. Doubles the number of steps until the gap is at most a tenth of the
 *  midpoint's error in the study's finest run. Doubles at most three times, and never in a quick
 *  study. Returns 0, or -1 after a message. */
int study_reference(study *of);
/** Computes the errors of all rows against the reference, and finds the Pareto front. */
void study_compare(study *of);
/**
 * Returns 0 if reference_gap is at most a tenth of the smallest error of the rows. Otherwise
 * returns -1 after a message, and removes from the rows all errors below ten times the gap (none if
 * there is no reference). Always returns 0 in a quick study.
 */
int study_trusts_reference(study *of);
/** Opens folder/NAME for a table with other columns, and writes the line of column names. Returns
 *  NULL after a message. */
FILE *study_open(const study *of, const char *name, const char *columns);
/** Closes the table. Returns 0, or -1 after a message if not all of it was written. */
int study_close(FILE *file);
/** Returns the z of the lowest vertex, m. It can be compared between runs on different meshes. */
double lowest_point(int count, const double (*x)[3]);
/** Writes folder/NAME.csv of all rows and removes the rows. Returns 0, or -1 after a message. */
int study_write(study *of, const char *name);
void study_free(study *of);

/** The experiments. Each returns 0, or -1 after a message. */
int study_dt(study *of);         /* error against step and CPU time, every integrator */
int study_cg(study *of);         /* error against the linear systems' tolerance */
int study_newton(study *of);     /* error against Newton's tolerance */
int study_integrator(study *of); /* energy over time; step and stiffness that a run survives */
int study_preconditioner(
    study *of);                 /* iterations and time to tolerance; also the direct solution */
int study_precision(study *of); /* error and time in float, mixed precision and double */
int study_solver(study *of);    /* direct and iterative solution, over step and mesh */
int study_sum(study *of);       /* the orders of reduction of the parallel program */
int study_mesh(study *of);      /* lowest point and time against the number of vertices */
int study_horizon(study *of);   /* divergence of runs with nearly equal starts */

#endif
