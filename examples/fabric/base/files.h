/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Folders and paths. */
#ifndef FABRIC_FILES_H
#define FABRIC_FILES_H

#include <stdio.h>

enum { FILE_PATH_SIZE = 4096 };

/**
 * The file of a scene: a path (with '/' or ending in .yaml), or a bare name in the scenes folder,
 * which is $FABRIC_SCENES or ../share/fabric/scenes as seen from the program's own folder.
 * 0, or -1 after a message that lists the available scenes.
 */
int files_find_scene(const char *name, char path[FILE_PATH_SIZE]);

/** "folder/name". 0, or -1 after a message when that is too long. */
int files_join(char path[FILE_PATH_SIZE], const char *folder, const char *name);

/** "FOLDER/name", FOLDER being that of the running program. 0, or -1: the folder is unknown. */
int files_in_program_folder(char path[FILE_PATH_SIZE], const char *name);

/** Opens a file to be read, as bytes. NULL after a message. */
FILE *files_open(const char *path);

/** Makes a folder and those above it. 0, or -1 after a message. */
int files_make_folder(const char *path);

/** *numbers: the numbers of the files DIGITS.suffix in a folder, ascending, to be freed. Returns
 *  their count, or -1 after a message. */
int files_numbered(const char *folder, const char *suffix, long **numbers);

#endif
