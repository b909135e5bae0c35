/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* fabric-view gltf: a run as an animated glTF file. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "base/files.h"
#include "view/gltf.h"
#include "view/run_frames.h"
#include "view/view.h"

static const option gltf_options[] = {
    VIEW_OUTPUT("FILE", "output file: .glb is binary, .gltf text (default DIR/cloth.glb)"),
    {.name = NULL}};

/** Returns the format that the file's extension requests: 1 for binary, 0 for text, or -1 after a
 *  message. */
static int is_binary(const char *path) {
    const char *dot = strrchr(path, '.');
    if (dot && strcasecmp(dot, ".glb") == 0)
        return 1;
    if (dot && strcasecmp(dot, ".gltf") == 0)
        return 0;
    fprintf(stderr, "%s: not a glTF file by its name, expected .glb or .gltf\n", path);
    return -1;
}

static int write_run(const char *folder, const char *path) {
    const int binary = is_binary(path);
    char scene_path[FILE_PATH_SIZE];
    run_frames run;
    scene of;
    if (binary < 0)
        return -1;
    int status = run_frames_open(&run, folder);
    if (status == 0 && files_join(scene_path, folder, "scene.yaml") == 0 &&
        scene_read(&of, scene_path) == 0) {
        status = gltf_write(&run.of, &of, binary, path);
        scene_free(&of);
    } else
        status = -1;
    return run_frames_finish(&run, status, path);
}

static int run(const command *self, int argc, char **argv) {
    view_request r;
    const int read = view_read_request(self, argc, argv, &r);
    if (read != OPTIONS_READ)
        return read;
    char path[FILE_PATH_SIZE];
    if (view_output(path, r.folder, "cloth.glb", r.output) != 0 || write_run(r.folder, path) != 0)
        return EXIT_FAILURE;
    return EXIT_SUCCESS;
}

const command gltf_command = {"gltf", "DIR [options]",
                              "Writes a run as one animated glTF file, the colliders with it, for "
                              "Blender and viewers.",
                              gltf_options, run};
