/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The program's commands. Each is in the file of its name, except export, which is in render.c.
 * `run` has two more files, run_folder.c and run_resume.c. */
#ifndef FABRIC_COMMANDS_COMMANDS_H
#define FABRIC_COMMANDS_COMMANDS_H

#include "base/options.h"
#include "scene/scene.h"

extern const command run_command;
extern const command plan_command;
extern const command compare_command;
extern const command render_command;
extern const command export_command;
extern const command mesh_command;
extern const command accuracy_command;

/** Maximum number of `--set` options. */
enum { MOST_SETTINGS = 256 };

/** Pointers to the values of the `--set` options. */
typedef struct setting_list {
    const char *setting[MOST_SETTINGS];
    int count;
} setting_list;

/** An option_taker: appends a `--set` to the list. */
int take_setting(const options *o, void *list);

/** The entry for `--set` in the options of a request that has a member `settings`. */
#define SETTING_OPTION(request_, example)                                                          \
    {                                                                                              \
        "--set", "KEY=VALUE", "change a key of the scene, such as " example,                       \
            .kind = OPTION_OWN, .offset = offsetof(request_, settings), .take = take_setting       \
    }

/** Applies the settings to the scene. Returns 0. If one is invalid, prints a message, empties the
 *  scene and returns -1. */
int make_settings(scene *s, const setting_list *settings);

/** Finds and reads a scene and applies the settings. Returns 0, or -1 after a message. */
int read_scene(scene *s, const char *name, const setting_list *settings);

#endif
