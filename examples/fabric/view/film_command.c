/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* fabric-view film: a run as an MP4 film. */
#include <stdio.h>
#include <stdlib.h>

#include "base/files.h"
#include "view/picture.h"
#include "view/video.h"
#include "view/view.h"

static const option film_options[] = {
    VIEW_OUTPUT("FILE.mp4", "output file (default DIR/cloth.mp4)"),
    VIEW_WIDTH,
    VIEW_HEIGHT,
    {.name = NULL}};

static int run(const command *self, int argc, char **argv) {
    view_request r;
    const int read = view_read_request(self, argc, argv, &r);
    if (read != OPTIONS_READ)
        return read;
    char path[FILE_PATH_SIZE];
    int frames;
    if (view_output(path, r.folder, "cloth.mp4", r.output) != 0 ||
        video_write(r.folder, (int)r.width, (int)r.height, path, &frames) != 0)
        return EXIT_FAILURE;
    printf("%d frames in %s\n", frames, path);
    return EXIT_SUCCESS;
}

const command film_command = {"film", "DIR [options]",
                              "Makes an MP4 film of a run, by ffmpeg, which takes as long as what "
                              "it shows.",
                              film_options, run};
