/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The times and counts of a run: summary.json, and a short text for a reader. */
#ifndef FABRIC_OUTPUT_SUMMARY_H
#define FABRIC_OUTPUT_SUMMARY_H

#include "step/simulation.h"

typedef struct run_account {
    const char *program;
    const scene *of;
    const mesh *cloth;
    const simulation *sim;
    int threads;          /* number of threads, 1 without OpenMP */
    double mesh_seconds;  /* wall time to generate and order the mesh */
    double setup_seconds; /* wall time to make the simulation from the mesh */
    double step_seconds;  /* wall time of all steps, including those before a checkpoint */
    int interrupted;      /* the run ended before its last step */
} run_account;

/** Writes the JSON object to a temporary file and renames it. Returns 0, or -1 after a message. */
int summary_write(const run_account *run, const char *path);

/** Prints a few lines to standard output. */
void summary_print(const run_account *run);

/** The phase's name: "forces", "collisions", "solve" or "update". */
const char *summary_phase_name(int phase_number);

#endif
