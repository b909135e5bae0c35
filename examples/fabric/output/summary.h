/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The accounts of a run: summary.json, and the same in short for a reader. */
#ifndef FABRIC_OUTPUT_SUMMARY_H
#define FABRIC_OUTPUT_SUMMARY_H

#include "step/simulation.h"

typedef struct run_account {
    const char *program;
    const scene *of;
    const mesh *cloth;
    const simulation *sim;
    int threads;          /* 1 without OpenMP */
    double mesh_seconds;  /* wall, to generate and order the mesh */
    double setup_seconds; /* wall, from mesh to simulation */
    double step_seconds;  /* wall, all steps, those before a checkpoint too */
    int interrupted;      /* it has ended before its last step */
} run_account;

/** Writes the JSON object to a temporary file and renames it. 0, or -1 after a message. */
int summary_write(const run_account *run, const char *path);

/** A few lines on standard output. */
void summary_print(const run_account *run);

/** "forces", "collisions", "solve", "update": by the number of the phase. */
const char *summary_phase_name(int phase_number);

#endif
