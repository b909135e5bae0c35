/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* fabric render: pictures of a run. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "commands/commands.h"
#include "files.h"
#include "output/camera.h"
#include "output/frames.h"
#include "output/picture.h"
#include "output/stage.h"
#include "surface.h"

enum { SHEET_COLUMNS = 4, SHEET_ROWS = 2, SHEET_FRAMES = SHEET_COLUMNS * SHEET_ROWS };
enum { WIDTH_DEFAULT = 960, HEIGHT_DEFAULT = 720, MOST_CAMERA_POINTS = 200000 };

enum { WIDTH, HEIGHT };
static const option render_options[] = {
    [WIDTH] = {"--width", "N", "of a frame's picture, in pixels, even (default 960)"},
    [HEIGHT] = {"--height", "N", "of a frame's picture, in pixels, even (default 720)"},
    {NULL, NULL, NULL}};

/** A run's folder being drawn. */
typedef struct job {
    const char *folder;
    frames frames;
    int width, height;
    scene of;
    float *material; /* [2 * vertices] m, from the first frame: the cloth is flat in it */
    camera from;
    stage *drawing;
    picture sheet;
} job;

static int out_of_memory(void) {
    fprintf(stderr, "render: out of memory\n");
    return -1;
}

/** Coordinates in the plane of the flat cloth, along two of its own directions. */
static int find_material(job *j) {
    const state *s = &j->frames.first;
    const double *n = j->of.normal;
    const double across[3] = {fabs(n[2]) < 0.9 ? -n[1] : 1.0, fabs(n[2]) < 0.9 ? n[0] : 0.0, 0.0};
    const double length = sqrt(across[0] * across[0] + across[1] * across[1]);
    double along[3];
    for (int k = 0; k < 3; k++)
        along[k] = n[(k + 1) % 3] * across[(k + 2) % 3] - n[(k + 2) % 3] * across[(k + 1) % 3];
    j->material = malloc(2 * (size_t)s->vertex_count * sizeof *j->material);
    if (!j->material)
        return out_of_memory();
    for (size_t v = 0; v < (size_t)s->vertex_count; v++) {
        double u[2] = {0.0, 0.0};
        for (int k = 0; k < 3; k++) {
            u[0] += (s->position[3 * v + (size_t)k] - j->of.origin[k]) * across[k] / length;
            u[1] += (s->position[3 * v + (size_t)k] - j->of.origin[k]) * along[k] / length;
        }
        j->material[2 * v] = (float)u[0];
        j->material[2 * v + 1] = (float)u[1];
    }
    return 0;
}

/** Corners of the boxes around the solids, at the time given. */
static long collider_points(const job *j, double time, double (*points)[3]) {
    long count = 0;
    for (int k = 0; k < j->of.collider_count; k++) {
        const collider *c = &j->of.colliders[k];
        if (c->kind == COLLIDER_PLANE)
            continue;
        for (int corner = 0; corner < 8; corner++, count++)
            for (int i = 0; i < 3; i++) {
                double half = c->size[i];
                if (c->kind == COLLIDER_SPHERE)
                    half = c->size[0];
                else if (c->kind == COLLIDER_CYLINDER)
                    half = fabs(c->axis[i]) * c->size[1] +
                           sqrt(fmax(0.0, 1.0 - c->axis[i] * c->axis[i])) * c->size[0];
                else if (c->kind == COLLIDER_MESH)
                    half = surface_reach(c->surface);
                points[count][i] = c->position[i] + time * c->velocity[i] +
                                   ((corner >> i & 1) != 0 ? half : -half);
            }
    }
    return count;
}

/** One camera for all frames. */
static int place_camera(job *j) {
    static const double back[3] = {0.8, -1.0, 0.5};
    const long of_solids = 8L * j->of.collider_count;
    const long all = (long)j->frames.count * j->frames.first.vertex_count;
    const long every = all / MOST_CAMERA_POINTS + 1;
    long count = 0;
    int status = 0;
    double(*points)[3] =
        malloc(((size_t)(all / every + j->frames.count) + 2 * (size_t)of_solids) * sizeof *points);
    if (!points)
        return out_of_memory();
    for (int number = 0; status == 0 && number < j->frames.count; number++) {
        state s;
        status = frames_read(&j->frames, number, &s);
        if (status != 0)
            break;
        for (long v = 0; v < s.vertex_count; v += every)
            memcpy(points[count++], &s.position[3 * v], sizeof *points);
        if (number == 0 || number == j->frames.count - 1)
            count += collider_points(j, s.time, points + count);
        state_free(&s);
    }
    if (status == 0)
        j->from = camera_frame(back, (double)j->width / j->height, points, count);
    free(points);
    return status;
}

static int open_job(job *j) {
    char path[FILE_PATH_SIZE];
    if (files_join(path, j->folder, "scene.yaml") != 0 || scene_read(&j->of, path) != 0 ||
        frames_open(&j->frames, j->folder) != 0 || find_material(j) != 0 || place_camera(j) != 0)
        return -1;
    if (picture_new(&j->sheet, SHEET_COLUMNS * (j->width / 2), SHEET_ROWS * (j->height / 2)) != 0)
        return out_of_memory();
    /* Twice as large as asked for, then halved: smooth edges. */
    j->drawing = stage_new(&j->of, 2 * j->width, 2 * j->height);
    return j->drawing ? 0 : -1;
}

static void close_job(job *j) {
    stage_free(j->drawing);
    picture_free(&j->sheet);
    frames_close(&j->frames);
    free(j->material);
    scene_free(&j->of);
}

/** The frame's places on the contact sheet: eight frames, evenly; fewer frames leave places free.
 */
static int put_on_sheet(job *j, int number, const picture *frame) {
    const int last = j->frames.count - 1;
    picture small;
    if (picture_halve(frame, &small) != 0)
        return out_of_memory();
    for (int place = 0; place < SHEET_FRAMES; place++) {
        const int wanted = j->frames.count <= SHEET_FRAMES
                               ? place
                               : (place * last + (SHEET_FRAMES - 1) / 2) / (SHEET_FRAMES - 1);
        if (wanted == number)
            picture_paste(&j->sheet, &small, place % SHEET_COLUMNS * small.width,
                          place / SHEET_COLUMNS * small.height);
    }
    picture_free(&small);
    return 0;
}

static int save_frame(job *j, int number, const picture *large, double time) {
    char name[32], path[FILE_PATH_SIZE], label[32];
    picture frame;
    if (picture_halve(large, &frame) != 0)
        return out_of_memory();
    snprintf(label, sizeof label, "t = %.2f s", time);
    picture_text(&frame, j->width / 40, j->height / 30, j->height / 360 + 1, label);
    snprintf(name, sizeof name, "%04ld.png", j->frames.steps[number]);
    const int status = files_join(path, j->frames.folder, name) == 0 &&
                               picture_write_png(&frame, path) == 0 &&
                               put_on_sheet(j, number, &frame) == 0
                           ? 0
                           : -1;
    picture_free(&frame);
    return status;
}

static int draw_frame(job *j, int number) {
    state s;
    picture large;
    if (frames_read(&j->frames, number, &s) != 0)
        return -1;
    const stage_cloth cloth = {j->frames.first.vertex_count, j->frames.first.triangle_count,
                               s.position, j->frames.first.triangle, j->material};
    int status = stage_draw(j->drawing, &j->from, &cloth, s.time, &large);
    if (status == 0) {
        status = save_frame(j, number, &large, s.time);
        picture_free(&large);
    }
    state_free(&s);
    return status;
}

static int render(job *j) {
    char path[FILE_PATH_SIZE];
    if (open_job(j) != 0)
        return -1;
    for (int number = 0; number < j->frames.count; number++)
        if (draw_frame(j, number) != 0)
            return -1;
    if (files_join(path, j->folder, "contact-sheet.png") != 0 ||
        picture_write_png(&j->sheet, path) != 0)
        return -1;
    printf("%d pictures in %s, eight of them on %s\n", j->frames.count, j->frames.folder, path);
    return 0;
}

static int run(const command *self, int argc, char **argv) {
    options o = {self, argc, argv, 0, NULL, 0};
    long width = WIDTH_DEFAULT, height = HEIGHT_DEFAULT;
    job j = {0};
    for (int next; (next = options_next(&o)) != OPTIONS_END;)
        switch (next) {
        case WIDTH:
            if (options_whole(&o, "--width", 32, 4096, &width) != 0)
                return EXIT_USAGE;
            break;
        case HEIGHT:
            if (options_whole(&o, "--height", 32, 4096, &height) != 0)
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
    j.width = (int)(width / 2 * 2);
    j.height = (int)(height / 2 * 2);
    const int status = render(&j);
    close_job(&j);
    return status == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

const command render_command = {"render", "DIR [options]",
                                "Draws the frames of a run: DIR/frames/NNNN.png and "
                                "DIR/contact-sheet.png with eight of them.",
                                render_options, run};
