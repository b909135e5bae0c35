/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Writes and finds checkpoints of a run, and compares them with the command line. */
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include "commands/run.h"

/** Sets the checkpoint's path and the run's folder from `name`, a folder or a file. */
static int find_checkpoint(cloth_run *run, const char *name) {
    struct stat status;
    const char *slash = strrchr(name, '/');
    if (stat(name, &status) == 0 && S_ISDIR(status.st_mode)) {
        snprintf(run->folder, FILE_PATH_SIZE, "%s", name);
        if (files_join(run->from_path, name, "checkpoint") != 0)
            return -1;
        if (stat(run->from_path, &status) == 0)
            return 0;
        fprintf(stderr,
                "%s: no checkpoint in it: a run leaves one when it is interrupted, and with "
                "--checkpoint-every\n",
                name);
        return -1;
    }
    if (strlen(name) >= FILE_PATH_SIZE) {
        fprintf(stderr, "%.100s...: path too long\n", name);
        return -1;
    }
    snprintf(run->from_path, FILE_PATH_SIZE, "%s", name);
    if (slash == NULL)
        snprintf(run->folder, FILE_PATH_SIZE, ".");
    else
        snprintf(run->folder, FILE_PATH_SIZE, "%.*s", slash == name ? 1 : (int)(slash - name),
                 name);
    return 0;
}

/** Reads the scene that the command line names, or the checkpoint's, and applies the settings. */
static int read_wanted_scene(cloth_run *run, const run_request *r) {
    if (r->scene_name)
        return read_scene(&run->of, r->scene_name, &r->settings);
    if (scene_read_text(&run->of, run->from.text, run->from.text_size, run->from_path) != 0)
        return -1;
    return make_settings(&run->of, &r->settings);
}

/** Chooses the number of steps: the option's or, if the command line names a scene, the
 *  checkpoint's. Returns 0, or -1 after a message if the checkpoint is of a later step. */
static int choose_steps(cloth_run *run, const run_request *r) {
    if (r->steps != NOT_GIVEN)
        run->of.time.steps = (int)r->steps;
    else if (r->scene_name)
        run->of.time.steps = run->from.of.time.steps;
    if (run->record.step <= run->of.time.steps)
        return 0;
    fprintf(stderr, "%s: of step %ld, expected one up to step %d, the last\n", run->from_path,
            run->record.step, run->of.time.steps);
    return -1;
}

int run_resume(cloth_run *run, const run_request *r) {
    char said[256];
    if (find_checkpoint(run, r->resume) != 0 || checkpoint_read(&run->from, run->from_path) != 0)
        return -1;
    run->record = run->from.record;
    if (r->every != NOT_GIVEN)
        run->record.every = r->every;
    if (read_wanted_scene(run, r) != 0)
        return -1;
    if (scene_differ(&run->of, &run->from.of, said)) {
        fprintf(stderr, "%s: of another scene: %s\n", run->from_path, said);
        return -1;
    }
    return choose_steps(run, r);
}

int run_restore(cloth_run *run) {
    return checkpoint_restore(&run->from, &run->of, &run->cloth, run->sim, run->from_path);
}

int run_save(cloth_run *run) {
    char path[FILE_PATH_SIZE];
    return files_join(path, run->folder, "checkpoint") == 0
               ? checkpoint_write(&run->record, &run->of, &run->cloth, run->sim, path)
               : -1;
}
