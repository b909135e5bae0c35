/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The folder of a run: removal of older files, states for pictures, results. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "commands/run.h"
#include "output/state.h"

static void remove_file(const char *folder, const char *name) {
    char path[FILE_PATH_SIZE];
    if (files_join(path, folder, name) == 0)
        remove(path);
}

/** Removes states and pictures of steps after `step`. */
static void remove_frames(const cloth_run *run, long step) {
    static const char *const suffixes[] = {".state", ".png"};
    char name[32];
    for (int k = 0; k < 2; k++) {
        long *numbers;
        const int count = files_numbered(run->frames_folder, suffixes[k], &numbers);
        for (int i = 0; i < count; i++) {
            snprintf(name, sizeof name, "%04ld%s", numbers[i], suffixes[k]);
            if (numbers[i] > step)
                remove_file(run->frames_folder, name);
        }
        if (count > 0)
            free(numbers);
    }
}

void run_forget(const cloth_run *run) {
    remove_file(run->folder, "checkpoint");
}

static void remove_old_results(const cloth_run *run) {
    const int goes_on = run->from.memory != NULL;
    remove_file(run->folder, "final.state");
    remove_file(run->folder, "summary.json");
    if (!goes_on)
        run_forget(run);
    remove_frames(run, goes_on ? run->record.step : -1);
}

/** Sets run->folder unless a run is resumed (then it is that run's), and run->frames_folder. The
 *  default is the scene's name without folders and .yaml, followed by "-run". Returns 0, or -1
 *  after a message. */
static int name_folder(cloth_run *run, const run_request *r) {
    if (!run->from.memory) {
        const char *slash = strrchr(r->scene_name, '/');
        const char *name = slash ? slash + 1 : r->scene_name;
        const size_t length = strlen(name);
        const size_t stem =
            length > 5 && strcmp(name + length - 5, ".yaml") == 0 ? length - 5 : length;
        const int written =
            r->folder ? snprintf(run->folder, FILE_PATH_SIZE, "%s", r->folder)
                      : snprintf(run->folder, FILE_PATH_SIZE, "%.*s-run", (int)stem, name);
        if (written >= FILE_PATH_SIZE) {
            fprintf(stderr, "%.100s...: path too long\n", run->folder);
            return -1;
        }
    }
    return files_join(run->frames_folder, run->folder, "frames");
}

/** Is the step a frame? Frames are step 0, the last step, and steps evenly distributed between
 *  them. */
static int is_frame(const cloth_run *run, long step) {
    const long steps = run->of.time.steps, frames = run->record.frames, gaps = frames - 1;
    return frames > 0 && (step == 0 || step == steps ||
                          (step < steps && step * gaps / steps != (step - 1) * gaps / steps));
}

static int frame_path(const cloth_run *run, long step, char path[FILE_PATH_SIZE]) {
    char name[32];
    snprintf(name, sizeof name, "%04ld.state", step);
    return files_join(path, run->frames_folder, name);
}

/** Prints how many frames up to the step of the checkpoint are missing: a resumed run does not
 * write them again. */
static void report_missing_frames(const cloth_run *run) {
    char path[FILE_PATH_SIZE];
    long missing = 0;
    for (long step = 0; step <= run->record.step; step++)
        missing += is_frame(run, step) && frame_path(run, step, path) == 0 && access(path, R_OK);
    if (missing > 0)
        fprintf(stderr, "%s: %ld of the frames up to step %ld are missing and cannot be drawn\n",
                run->frames_folder, missing, run->record.step);
}

int run_prepare_folder(cloth_run *run, const run_request *r) {
    char path[FILE_PATH_SIZE];
    if (name_folder(run, r) != 0 || files_make_folder(run->frames_folder) != 0 ||
        files_join(path, run->folder, "scene.yaml") != 0)
        return -1;
    remove_old_results(run);
    if (run->from.memory && run->of.time.steps == run->from.of.time.steps)
        report_missing_frames(run);
    if (scene_write(&run->of, path) == 0)
        return 0;
    fprintf(stderr, "%s: cannot be written: %s\n", path, strerror(errno));
    return -1;
}

static state state_of(const cloth_run *run, unsigned parts) {
    return (state){.vertex_count = run->cloth.vertex_count,
                   .triangle_count = run->cloth.triangle_count,
                   .time = simulation_time(run->sim),
                   .step = run->record.step,
                   .parts = parts,
                   .position = &simulation_positions(run->sim)[0][0],
                   .velocity = &simulation_velocities(run->sim)[0][0],
                   .triangle = &run->cloth.triangle[0][0],
                   .original = run->original};
}

int run_write_frame(const cloth_run *run) {
    char path[FILE_PATH_SIZE];
    /* The first frame has the triangles; the others share them. */
    const state s =
        state_of(run, run->record.step == 0 ? STATE_SINGLE | STATE_TRIANGLES : STATE_SINGLE);
    if (!is_frame(run, run->record.step))
        return 0;
    return frame_path(run, run->record.step, path) == 0 ? state_write(&s, path) : -1;
}

int run_write_results(const cloth_run *run) {
    char path[FILE_PATH_SIZE];
    state s = state_of(run, STATE_VELOCITIES | STATE_TRIANGLES | STATE_ORIGINAL);
    s.step = simulation_counts(run->sim).taken;
    return files_join(path, run->folder, "final.state") == 0 && state_write(&s, path) == 0 &&
                   files_join(path, run->folder, "summary.json") == 0 &&
                   summary_write(&run->account, path) == 0
               ? 0
               : -1;
}
