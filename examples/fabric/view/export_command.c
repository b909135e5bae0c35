/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* fabric-view export: the frames of a run for ParaView. */
#include <stdio.h>
#include <stdlib.h>

#include "base/files.h"
#include "view/run_frames.h"
#include "view/view.h"
#include "view/vtu.h"

static const option export_options[] = {VIEW_OUTPUT("FOLDER", "output folder (default DIR/vtu)"),
                                        {.name = NULL}};

/** Writes a file NNNN.vtu for each frame, and stores the files' names. */
static int write_frames(const run_frames *run, const char *to, char (*name)[32]) {
    char path[FILE_PATH_SIZE];
    for (int k = 0; k < run->of.count; k++) {
        state s;
        snprintf(name[k], sizeof name[k], "%04ld.vtu", run->files.steps[k]);
        if (files_join(path, to, name[k]) != 0 || frames_read(&run->files, k, &s) != 0)
            return -1;
        const int status = vtu_write(&run->of, &s, path);
        state_free(&s);
        if (status != 0)
            return -1;
    }
    return 0;
}

/** Writes the frames, and cloth.pvd, which lists them. */
static int write_run(const run_frames *run, const char *to) {
    char path[FILE_PATH_SIZE];
    char(*name)[32] = malloc((size_t)run->of.count * sizeof *name);
    if (!name) {
        fprintf(stderr, "export: out of memory\n");
        return -1;
    }
    const int status = files_make_folder(to) == 0 && write_frames(run, to, name) == 0 &&
                               files_join(path, to, "cloth.pvd") == 0
                           ? pvd_write(&run->of, name, path)
                           : -1;
    free(name);
    return status;
}

static int export_run(const char *folder, const char *given) {
    char to[FILE_PATH_SIZE];
    run_frames run;
    const int status =
        run_frames_open(&run, folder) == 0 && view_output(to, folder, "vtu", given) == 0
            ? write_run(&run, to)
            : -1;
    return run_frames_finish(&run, status, to);
}

static int run(const command *self, int argc, char **argv) {
    view_request r;
    const int read = view_read_request(self, argc, argv, &r);
    if (read != OPTIONS_READ)
        return read;
    return export_run(r.folder, r.output) == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

const command export_command = {"export", "DIR [options]",
                                "Writes the frames of a run for ParaView: a VTK file for each, and "
                                "a collection of them.",
                                export_options, run};
