/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* fabric export: the frames of a run for other programs. */
#include <stdio.h>
#include <stdlib.h>

#include "base/files.h"
#include "commands/commands.h"
#include "output/exchange.h"
#include "output/frames.h"
#include "output/gltf.h"
#include "output/picture.h"
#include "output/video.h"

enum { FORMAT, OUTPUT, WIDTH, HEIGHT };
static const option export_options[] = {
    [FORMAT] = {"--format", "FORMAT", "pc2, vtu, gltf, glb or mp4 (default pc2)"},
    [OUTPUT] = {"-o", "PATH",
                "where to: a folder for vtu (default DIR/vtu), a file for the others (default "
                "DIR/cloth.FORMAT)"},
    [WIDTH] = {"--width", "N", "mp4: of the pictures, in pixels, even (default 960)"},
    [HEIGHT] = {"--height", "N", "mp4: of the pictures, in pixels, even (default 720)"},
    {NULL, NULL, NULL}};

typedef enum format { PC2, VTU, GLTF, GLB, MP4 } format;
static const char *const formats[] = {"pc2", "vtu", "gltf", "glb", "mp4", NULL};

/** A run's folder being exported. */
typedef struct job {
    const char *folder;
    char path[FILE_PATH_SIZE];
    frames frames;
    double *time;     /* [frames.count] s */
    char (*name)[32]; /* [frames.count] of files of one frame */
    cloth_frames of;
    int width, height; /* of pictures */
} job;

static int read_frame(void *context, int number, state *s) {
    return frames_read(context, number, s);
}

/** Reads all of it once before anything is written, so that a damaged frame leaves nothing behind.
 */
static int read_times(job *j) {
    for (int k = 0; k < j->frames.count; k++) {
        state s;
        if (frames_read(&j->frames, k, &s) != 0)
            return -1;
        j->time[k] = s.time;
        state_free(&s);
    }
    return 0;
}

static int open_job(job *j) {
    if (frames_open(&j->frames, j->folder) != 0)
        return -1;
    const size_t count = (size_t)j->frames.count;
    j->time = malloc(count * sizeof *j->time);
    j->name = malloc(count * sizeof *j->name);
    if (!j->time || !j->name) {
        fprintf(stderr, "export: out of memory\n");
        return -1;
    }
    j->of = (cloth_frames){.count = j->frames.count,
                           .time = j->time,
                           .vertex_count = j->frames.first.vertex_count,
                           .triangle_count = j->frames.first.triangle_count,
                           .triangle = j->frames.first.triangle,
                           .read = read_frame,
                           .context = &j->frames};
    return read_times(j);
}

static void close_job(job *j) {
    free(j->time);
    free(j->name);
    frames_close(&j->frames);
}

/** A file for each frame, NNNN.vtu, and the collection of them, cloth.pvd. */
static int write_vtu(job *j) {
    char path[FILE_PATH_SIZE];
    if (files_make_folder(j->path) != 0)
        return -1;
    for (int k = 0; k < j->frames.count; k++) {
        state s;
        snprintf(j->name[k], sizeof j->name[k], "%04ld.vtu", j->frames.steps[k]);
        if (files_join(path, j->path, j->name[k]) != 0 || frames_read(&j->frames, k, &s) != 0)
            return -1;
        const int status = vtu_write(&j->of, &s, path);
        state_free(&s);
        if (status != 0)
            return -1;
    }
    return files_join(path, j->path, "cloth.pvd") == 0 ? pvd_write(&j->of, j->name, path) : -1;
}

static int write_gltf(job *j, int binary) {
    char path[FILE_PATH_SIZE];
    scene of;
    if (files_join(path, j->folder, "scene.yaml") != 0 || scene_read(&of, path) != 0)
        return -1;
    const int status = gltf_write(&j->of, &of, binary, j->path);
    scene_free(&of);
    return status;
}

static int write_all(job *j, format as) {
    switch (as) {
    case GLTF:
    case GLB:
        return write_gltf(j, as == GLB);
    case MP4:
        return video_write(j->folder, j->width, j->height, j->path);
    case VTU:
        return write_vtu(j);
    default:
        return pc2_write(&j->of, j->path);
    }
}

static int choose_path(job *j, format as, const char *given) {
    char name[32];
    snprintf(name, sizeof name, as == VTU ? "%s" : "cloth.%s", formats[as]);
    if (!given)
        return files_join(j->path, j->folder, name);
    if (snprintf(j->path, FILE_PATH_SIZE, "%s", given) < FILE_PATH_SIZE)
        return 0;
    fprintf(stderr, "%.100s...: path too long\n", given);
    return -1;
}

static int run(const command *self, int argc, char **argv) {
    options o = {self, argc, argv, 0, NULL, 0};
    job j = {.width = PICTURE_WIDTH, .height = PICTURE_HEIGHT};
    const char *path = NULL;
    int as = PC2;
    for (int next; (next = options_next(&o)) != OPTIONS_END;)
        switch (next) {
        case FORMAT:
            if ((as = options_choice(&o, "--format", formats)) < 0)
                return EXIT_USAGE;
            break;
        case OUTPUT:
            path = o.value;
            break;
        case WIDTH:
            if (read_picture_size(&o, "--width", &j.width) != 0)
                return EXIT_USAGE;
            break;
        case HEIGHT:
            if (read_picture_size(&o, "--height", &j.height) != 0)
                return EXIT_USAGE;
            break;
        case OPTIONS_WORD:
            if (j.folder)
                return options_complain(self, "one folder at a time, not '%s' as well", o.value);
            j.folder = o.value;
            break;
        case OPTIONS_HELP:
            return EXIT_SUCCESS;
        default:
            return EXIT_USAGE;
        }
    if (!j.folder)
        return options_complain(self, "which folder? %s", self->synopsis);
    const int status = open_job(&j) == 0 && choose_path(&j, (format)as, path) == 0
                           ? write_all(&j, (format)as)
                           : -1;
    if (status == 0)
        printf("%d frames of %d vertices in %s\n", j.of.count, j.of.vertex_count, j.path);
    close_job(&j);
    return status == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

const command export_command = {
    "export", "DIR [options]",
    "Writes the frames of a run for other programs: a point cache (pc2: "
    "Blender's mesh\ncache), one animated file with the colliders "
    "(gltf, glb), a film (mp4, by ffmpeg), or\na file for each frame "
    "with a collection of them (vtu, for ParaView).",
    export_options, run};
