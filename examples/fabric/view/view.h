/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The commands of fabric-view, one per file, and shared declarations. */
#ifndef FABRIC_VIEW_VIEW_H
#define FABRIC_VIEW_VIEW_H

#include "base/files.h"
#include "base/options.h"
#include "view/picture.h"

extern const command render_command;
extern const command film_command;
extern const command gltf_command;
extern const command export_command;
extern const command plot_command;

typedef struct view_request {
    const char *folder; /* folder of a run */
    const char *output; /* NULL: not given */
    long width, height; /* size of pictures in pixels */
} view_request;

#define VIEW_OUTPUT(argument, help)                                                                \
    { "-o", argument, help, .offset = offsetof(view_request, output) }
#define VIEW_WIDTH                                                                                 \
    {                                                                                              \
        "--width", "N", "of the pictures, in pixels, even (default 960)", OPTION_WHOLE,            \
            .offset = offsetof(view_request, width), .low = 32, .high = 4096                       \
    }
#define VIEW_HEIGHT                                                                                \
    {                                                                                              \
        "--height", "N", "of the pictures, in pixels, even (default 720)", OPTION_WHOLE,           \
            .offset = offsetof(view_request, height), .low = 32, .high = 4096                      \
    }

/** Reads a command line with one folder. Returns OPTIONS_READ, or the exit status. */
int view_read_request(const command *self, int argc, char **argv, view_request *r);

/** Sets the output's path to `given`, or to "folder/name" if `given` is NULL. Returns 0, or -1
 *  after a message if the path is too long. */
int view_output(char path[FILE_PATH_SIZE], const char *folder, const char *name, const char *given);

#endif
