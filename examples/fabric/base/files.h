/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Folders and paths. */
#ifndef FABRIC_FILES_H
#define FABRIC_FILES_H

#include <stdio.h>

enum { FILE_PATH_SIZE = 4096 };

/**
 * Finds the file of a scene. `name` is a path (it contains '/' or ends in .yaml) or a bare name in
 * the scenes folder. That folder is $FABRIC_SCENES or, if unset, ../share/fabric/scenes relative to
 * the program's own folder. Returns 0, or -1 after a message if `name` is a path that is too long,
 * or the scenes folder or the scene is not found.
 */
int files_find_scene(const char *name, char path[FILE_PATH_SIZE]);

/** Writes "folder/name" to `path`. Returns 0, or -1 after a message if it is too long. */
int files_join(char path[FILE_PATH_SIZE], const char *folder, const char *name);

/** Writes the path of file `name` in the running program's folder. Returns 0, or -1 if the folder
 *  is unknown or the path too long. */
int files_in_program_folder(char path[FILE_PATH_SIZE], const char *name);

/** Opens a file for reading in binary mode. Returns NULL after a message if that fails. */
FILE *files_open(const char *path);

/** Creates a folder and its missing parents. Returns 0, or -1 after a message. */
int files_make_folder(const char *path);

/** Finds the files in `folder` whose names are up to 9 digits followed by `suffix`. Sets *numbers
 *  to their numbers, ascending; the caller frees it. Returns their count, or -1 after a message. */
int files_numbered(const char *folder, const char *suffix, long **numbers);

#endif
