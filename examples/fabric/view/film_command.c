/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* fabric-view film: a run as an MP4 film. */
#include <stdio.h>
#include <stdlib.h>

#include "base/files.h"
#include "view/picture.h"
#include "view/video.h"
#include "view/view.h"

enum { OUTPUT, WIDTH, HEIGHT };
static const option film_options[] = {
    [OUTPUT] = {"-o", "FILE.mp4", "output file (default DIR/cloth.mp4)"},
    [WIDTH] = {"--width", "N", "of the pictures, in pixels, even (default 960)"},
    [HEIGHT] = {"--height", "N", "of the pictures, in pixels, even (default 720)"},
    {NULL, NULL, NULL}};

static int run(const command *self, int argc, char **argv) {
    options o = {self, argc, argv, 0, NULL, 0};
    const char *folder = NULL, *given = NULL;
    int width = PICTURE_WIDTH, height = PICTURE_HEIGHT;
    for (int next; (next = options_next(&o)) != OPTIONS_END;) {
        if (next == OPTIONS_HELP)
            return EXIT_SUCCESS;
        if (next == OPTIONS_WRONG ||
            (next == WIDTH && read_picture_size(&o, "--width", &width) != 0) ||
            (next == HEIGHT && read_picture_size(&o, "--height", &height) != 0) ||
            (next == OPTIONS_WORD && take_folder(&o, &folder) != 0))
            return EXIT_USAGE;
        if (next == OUTPUT)
            given = o.value;
    }
    if (!folder)
        return options_complain(self, "which folder? %s", self->synopsis);
    char path[FILE_PATH_SIZE];
    int frames;
    if (files_output(path, folder, "cloth.mp4", given) != 0 ||
        video_write(folder, width, height, path, &frames) != 0)
        return EXIT_FAILURE;
    printf("%d frames in %s\n", frames, path);
    return EXIT_SUCCESS;
}

const command film_command = {"film", "DIR [options]",
                              "Makes an MP4 film of a run, by ffmpeg, which takes as long as what "
                              "it shows.",
                              film_options, run};
