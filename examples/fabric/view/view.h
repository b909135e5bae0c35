/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The commands of fabric-view, each in a file of its own, and what they share. */
#ifndef FABRIC_VIEW_VIEW_H
#define FABRIC_VIEW_VIEW_H

#include "base/options.h"

extern const command render_command;
extern const command film_command;
extern const command gltf_command;
extern const command export_command;
extern const command plot_command;

/** --width or --height of pictures, in pixels, made even: halving them, and films, want that. 0, or
 *  -1 after a message. */
int read_picture_size(const options *o, const char *name, int *size);

/** Takes the folder of a run, of which there is one. 0, or EXIT_USAGE after a message. */
int take_folder(const options *o, const char **folder);

#endif
