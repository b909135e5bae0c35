/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "view/film.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/files.h"
#include "contact/motion.h"
#include "mesh/surface.h"
#include "view/camera.h"
#include "view/stage.h"

enum { MOST_CAMERA_POINTS = 200000 };

struct film {
    frames frames;
    int width, height;
    scene of;
    float *material; /* [2 * vertices] m, computed from the first frame as if it were flat */
    camera from;
    stage *drawing;
};

static int out_of_memory(void) {
    fprintf(stderr, "render: out of memory\n");
    return -1;
}

/** Computes material coordinates along two directions in the plane of the flat cloth. */
static int find_material(film *f) {
    const state *s = &f->frames.first;
    const double *n = f->of.mesh.normal;
    const double across[3] = {fabs(n[2]) < 0.9 ? -n[1] : 1.0, fabs(n[2]) < 0.9 ? n[0] : 0.0, 0.0};
    const double length = sqrt(across[0] * across[0] + across[1] * across[1]);
    double along[3];
    for (int k = 0; k < 3; k++)
        along[k] = n[(k + 1) % 3] * across[(k + 2) % 3] - n[(k + 2) % 3] * across[(k + 1) % 3];
    f->material = malloc(2 * (size_t)s->vertex_count * sizeof *f->material);
    if (!f->material)
        return out_of_memory();
    for (size_t v = 0; v < (size_t)s->vertex_count; v++) {
        double u[2] = {0.0, 0.0};
        for (int k = 0; k < 3; k++) {
            u[0] += (s->position[3 * v + (size_t)k] - f->of.mesh.origin[k]) * across[k] / length;
            u[1] += (s->position[3 * v + (size_t)k] - f->of.mesh.origin[k]) * along[k] / length;
        }
        f->material[2 * v] = (float)u[0];
        f->material[2 * v + 1] = (float)u[1];
    }
    return 0;
}

/** Returns the radius, m, of a ball around the body's origin that contains the body. */
static double reach_of(const collider *c) {
    switch (c->kind) {
    case COLLIDER_BOX:
        return sqrt(c->size[0] * c->size[0] + c->size[1] * c->size[1] + c->size[2] * c->size[2]);
    case COLLIDER_CYLINDER:
        return hypot(c->size[0], c->size[1]);
    case COLLIDER_MESH:
        return surface_reach(c->surface);
    case COLLIDER_SPHERE:
    case COLLIDER_PLANE:
        break;
    }
    return c->size[0];
}

/** Stores the corners of boxes around the colliders at `time`. Returns the number of corners. */
static long collider_points(const film *f, double time, double (*points)[3]) {
    long count = 0;
    for (int k = 0; k < f->of.collider_count; k++) {
        const collider *c = &f->of.colliders[k];
        body_pose pose;
        if (c->kind == COLLIDER_PLANE)
            continue;
        motion_pose(c, time, &pose);
        const double all_ways = motion_rotates(c) ? reach_of(c) : 0.0;
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
                half = fmax(half, all_ways);
                points[count][i] = pose.origin[i] + ((corner >> i & 1) != 0 ? half : -half);
            }
    }
    return count;
}

/** Chooses one camera for all frames. */
static int place_camera(film *f) {
    static const double back[3] = {0.8, -1.0, 0.5};
    const long of_solids = 8L * f->of.collider_count;
    const long all = (long)f->frames.count * f->frames.first.vertex_count;
    const long every = all / MOST_CAMERA_POINTS + 1;
    long count = 0;
    int status = 0;
    double(*points)[3] =
        malloc(((size_t)(all / every + f->frames.count) + 2 * (size_t)of_solids) * sizeof *points);
    if (!points)
        return out_of_memory();
    for (int number = 0; status == 0 && number < f->frames.count; number++) {
        state s;
        status = frames_read(&f->frames, number, &s);
        if (status != 0)
            break;
        for (long v = 0; v < s.vertex_count; v += every)
            memcpy(points[count++], &s.position[3 * v], sizeof *points);
        if (number == 0 || number == f->frames.count - 1)
            count += collider_points(f, s.time, points + count);
        state_free(&s);
    }
    if (status == 0)
        f->from = camera_frame(back, (double)f->width / f->height, points, count);
    free(points);
    return status;
}

static int prepare(film *f, const char *folder) {
    char path[FILE_PATH_SIZE];
    if (files_join(path, folder, "scene.yaml") != 0 || scene_read(&f->of, path) != 0 ||
        frames_open(&f->frames, folder) != 0 || find_material(f) != 0 || place_camera(f) != 0)
        return -1;
    /* Pictures are drawn at twice the size and then halved, for anti-aliasing. */
    f->drawing = stage_new(&f->of, 2 * f->width, 2 * f->height);
    return f->drawing ? 0 : -1;
}

film *film_open(const char *folder, int width, int height) {
    film *f = calloc(1, sizeof *f);
    if (!f) {
        out_of_memory();
        return NULL;
    }
    f->width = width;
    f->height = height;
    if (prepare(f, folder) == 0)
        return f;
    film_close(f);
    return NULL;
}

void film_close(film *f) {
    stage_free(f->drawing);
    frames_close(&f->frames);
    free(f->material);
    scene_free(&f->of);
    free(f);
}

const frames *film_frames(const film *f) {
    return &f->frames;
}

static int finish_picture(const film *f, const picture *large, double time, picture *p) {
    char label[32];
    if (picture_halve(large, p) != 0)
        return out_of_memory();
    snprintf(label, sizeof label, "t = %.2f s", time);
    picture_text(p, f->width / 40, f->height / 30, f->height / 360 + 1, label);
    return 0;
}

int film_draw(film *f, int number, picture *p, double *time) {
    state s;
    picture large;
    if (frames_read(&f->frames, number, &s) != 0)
        return -1;
    const stage_cloth cloth = {f->frames.first.vertex_count, f->frames.first.triangle_count,
                               s.position, f->frames.first.triangle, f->material};
    int status = stage_draw(f->drawing, &f->from, &cloth, s.time, &large);
    if (status == 0) {
        status = finish_picture(f, &large, s.time, p);
        picture_free(&large);
    }
    *time = s.time;
    state_free(&s);
    return status;
}
