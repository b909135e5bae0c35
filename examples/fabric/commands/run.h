/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The parts of `fabric run`: its folder (run_folder.c) and its checkpoints (run_resume.c). */
#ifndef FABRIC_COMMANDS_RUN_H
#define FABRIC_COMMANDS_RUN_H

#include "base/files.h"
#include "commands/commands.h"
#include "output/checkpoint.h"
#include "output/progress.h"
#include "output/summary.h"

enum { FRAMES = 25, NOT_GIVEN = -1 };

/** Arguments of the command line. */
typedef struct run_request {
    const char *scene_name; /* NULL: the scene of the resumed run */
    const char *folder;     /* NULL: named after the scene */
    const char *resume;     /* NULL: a new run */
    long steps;             /* number of steps; NOT_GIVEN: the scene's */
    long stop_after;        /* step after which the run ends; NOT_GIVEN: the last */
    long threads;           /* number of threads; 0: the fastest number */
    long frames;            /* number of states kept for pictures; NOT_GIVEN: FRAMES, or the resumed
                             * run's number */
    long every;             /* number of steps between checkpoints; NOT_GIVEN: 0, or the resumed
                             * run's */
    int progress;           /* progress_style */
    setting_list settings;
} run_request;

/** The state of a run of this command. */
typedef struct cloth_run {
    scene of;
    mesh cloth;
    int *original; /* [vertices] number of each vertex in the mesh as generated */
    simulation *sim;
    run_record record;
    checkpoint from; /* checkpoint from which the run continues; empty for a new run */
    char from_path[FILE_PATH_SIZE];
    char folder[FILE_PATH_SIZE];
    char frames_folder[FILE_PATH_SIZE];
    run_account account;
} cloth_run;

/** Names and creates the run's folder, removes an older run's results from it, and writes
 *  scene.yaml. A resumed run keeps its checkpoint, and its frames up to record.step. Returns 0, or
 *  -1 after a message. */
int run_prepare_folder(cloth_run *run, const run_request *r);

/** If record.step is a frame, writes its state for pictures. Returns 0, or -1 after a message. */
int run_write_frame(const cloth_run *run);

/** Writes the last state and the summary. Returns 0, or -1 after a message. */
int run_write_results(const cloth_run *run);

/** Reads scene and state from a checkpoint. A scene and settings on the command line must agree
 *  with the checkpoint's. Returns 0, or -1 after a message. */
int run_resume(cloth_run *run, const run_request *r);

/** Restores the checkpoint's state in run->sim. Returns 0, or -1 after a message. */
int run_restore(cloth_run *run);

/** Writes the checkpoint of record.step. Returns 0, or -1 after a message; an older checkpoint is
 *  then unchanged. */
int run_save(cloth_run *run);

/** Removes the checkpoint of a finished run. */
void run_forget(const cloth_run *run);

#endif
