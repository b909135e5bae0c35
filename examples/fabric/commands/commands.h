/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The program's commands, each in a file of its own. */
#ifndef FABRIC_COMMANDS_COMMANDS_H
#define FABRIC_COMMANDS_COMMANDS_H

#include "options.h"
#include "scene.h"

extern const command run_command;
extern const command plan_command;
extern const command compare_command;
extern const command render_command;
extern const command mesh_command;
extern const command accuracy_command;

/** What `--set` may be given how often, together. */
enum { MOST_SETTINGS = 256 };

/** Finds and reads a scene and makes its settings. 0, or -1 after a message. */
int read_scene(scene *s, const char *name, const char *const *settings, int setting_count);

#endif
