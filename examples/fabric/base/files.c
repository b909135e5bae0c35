/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "files.h"

#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "words.h"

enum { MOST_SCENES = 64 };

int files_join(char path[FILE_PATH_SIZE], const char *folder, const char *name) {
    if (snprintf(path, FILE_PATH_SIZE, "%s/%s", folder, name) < FILE_PATH_SIZE)
        return 0;
    fprintf(stderr, "%.100s.../%.100s: path too long\n", folder, name);
    return -1;
}

static int has_suffix(const char *text, const char *suffix) {
    const size_t length = strlen(text), end = strlen(suffix);
    return length > end && strcmp(text + length - end, suffix) == 0;
}

int files_in_program_folder(char path[FILE_PATH_SIZE], const char *name) {
    const ssize_t length = readlink("/proc/self/exe", path, FILE_PATH_SIZE - 1);
    if (length <= 0)
        return -1;
    path[length] = '\0';
    char *slash = strrchr(path, '/');
    const size_t room = slash ? FILE_PATH_SIZE - (size_t)(slash + 1 - path) : 0;
    if (strlen(name) >= room)
        return -1;
    strcpy(slash + 1, name);
    return 0;
}

static int find_scenes_folder(char folder[FILE_PATH_SIZE]) {
    const char *chosen = getenv("FABRIC_SCENES");
    if (!chosen || chosen[0] == '\0')
        return files_in_program_folder(folder, "../share/fabric/scenes");
    return snprintf(folder, FILE_PATH_SIZE, "%s", chosen) < FILE_PATH_SIZE ? 0 : -1;
}

static int compare_names(const void *a, const void *b) {
    return strcmp(*(char *const *)a, *(char *const *)b);
}

/** Prints the scenes of the folder, and the one whose name is nearest to `name`. */
static void complain_no_scene(const char *folder, const char *name) {
    char *names[MOST_SCENES];
    int count = 0;
    DIR *listing = opendir(folder);
    fprintf(stderr, "no scene is called '%s' in %s", name, folder);
    for (struct dirent *entry; listing && count < MOST_SCENES && (entry = readdir(listing));)
        if (has_suffix(entry->d_name, ".yaml") &&
            (names[count] = strndup(entry->d_name, strlen(entry->d_name) - strlen(".yaml"))))
            count++;
    if (!listing)
        fprintf(stderr, " (%s)", strerror(errno));
    else
        closedir(listing);
    qsort(names, (size_t)count, sizeof *names, compare_names);
    for (int k = 0; k < count; k++)
        fprintf(stderr, k == 0 ? ", expected a path or one of '%s'" : ", '%s'", names[k]);
    const char *nearest = words_nearest(name, (const char *const *)names, count);
    if (nearest)
        fprintf(stderr, "; did you mean '%s'?", nearest);
    fputc('\n', stderr);
    for (int k = 0; k < count; k++)
        free(names[k]);
}

int files_find_scene(const char *name, char path[FILE_PATH_SIZE]) {
    char folder[FILE_PATH_SIZE];
    if (strchr(name, '/') || has_suffix(name, ".yaml")) {
        if (snprintf(path, FILE_PATH_SIZE, "%s", name) < FILE_PATH_SIZE)
            return 0;
        fprintf(stderr, "%.100s...: path too long\n", name);
        return -1;
    }
    if (find_scenes_folder(folder) != 0) {
        fprintf(stderr, "the scenes folder cannot be found; FABRIC_SCENES can name it\n");
        return -1;
    }
    if (snprintf(path, FILE_PATH_SIZE, "%s/%s.yaml", folder, name) < FILE_PATH_SIZE &&
        access(path, R_OK) == 0)
        return 0;
    complain_no_scene(folder, name);
    return -1;
}

FILE *files_open(const char *path) {
    FILE *file = fopen(path, "rb");
    if (!file)
        fprintf(stderr, "%s: cannot be read: %s\n", path, strerror(errno));
    return file;
}

int files_make_folder(const char *path) {
    char part[FILE_PATH_SIZE];
    struct stat status;
    if (snprintf(part, sizeof part, "%s", path) >= FILE_PATH_SIZE || part[0] == '\0') {
        fprintf(stderr, "%.100s: not a folder's name\n", path);
        return -1;
    }
    for (char *slash = part; slash;) {
        slash = strchr(slash + 1, '/');
        if (slash)
            *slash = '\0';
        if (mkdir(part, 0777) != 0 && errno != EEXIST) {
            fprintf(stderr, "%s: cannot be made: %s\n", part, strerror(errno));
            return -1;
        }
        if (slash)
            *slash = '/';
    }
    if (stat(path, &status) == 0 && S_ISDIR(status.st_mode))
        return 0;
    fprintf(stderr, "%s: not a folder\n", path);
    return -1;
}

static int compare_numbers(const void *a, const void *b) {
    const long first = *(const long *)a, second = *(const long *)b;
    return (first > second) - (first < second);
}

int files_numbered(const char *folder, const char *suffix, long **numbers) {
    int count = 0, room = 0;
    DIR *listing = opendir(folder);
    *numbers = NULL;
    if (!listing) {
        fprintf(stderr, "%s: cannot be read: %s\n", folder, strerror(errno));
        return -1;
    }
    for (struct dirent *entry; (entry = readdir(listing));) {
        const size_t digits = strspn(entry->d_name, "0123456789");
        if (digits == 0 || digits > 9 || strcmp(entry->d_name + digits, suffix) != 0)
            continue;
        if (count == room) {
            room = 2 * room + 64;
            long *grown = realloc(*numbers, (size_t)room * sizeof *grown);
            if (!grown) {
                fprintf(stderr, "out of memory\n");
                closedir(listing);
                free(*numbers);
                *numbers = NULL;
                return -1;
            }
            *numbers = grown;
        }
        (*numbers)[count++] = strtol(entry->d_name, NULL, 10);
    }
    closedir(listing);
    if (count > 0)
        qsort(*numbers, (size_t)count, sizeof **numbers, compare_numbers);
    return count;
}
