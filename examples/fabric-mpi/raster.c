/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "raster.h"

#include <math.h>
#include <stdlib.h>

int raster_init(raster *r, picture *onto) {
    const size_t count = (size_t)onto->width * (size_t)onto->height;
    *r = (raster){onto, malloc(count * sizeof(float))};
    for (size_t k = 0; r->depth && k < count; k++)
        r->depth[k] = INFINITY;
    return r->depth ? 0 : -1;
}

void raster_free(raster *r) {
    free(r->depth);
    *r = (raster){0};
}

/* Twice the area of (a, b, (x, y)), positive where these turn from x to y. */
static double turn(const raster_corner *a, const raster_corner *b, double x, double y) {
    return (b->x - a->x) * (y - a->y) - (b->y - a->y) * (x - a->x);
}

static int nearest(const double weight[3]) {
    const int first = weight[0] >= weight[1] ? 0 : 1;
    return weight[first] >= weight[2] ? first : 2;
}

/* `height`: of each corner over its edge, in pixels. */
static void draw_pixel(raster *r, const raster_corner c[3], const double weight[3],
                       const double height[3], int x, int y, double line) {
    const size_t at = (size_t)y * (size_t)r->onto->width + (size_t)x;
    double depth = 0, to_edge = INFINITY;
    for (int k = 0; k < 3; k++) {
        depth += weight[k] * c[k].depth;
        to_edge = fmin(to_edge, weight[k] * height[k]);
    }
    if (!(depth < r->depth[at]))
        return;
    r->depth[at] = (float)depth;
    const unsigned char *colour = c[nearest(weight)].colour;
    for (int k = 0; k < 3; k++)
        r->onto->rgb[3 * at + (size_t)k] =
            (unsigned char)(to_edge < line / 2 ? colour[k] + (255 - colour[k]) * 3 / 10
                                               : colour[k]);
}

static int within(double value, int limit) {
    return value < 0 ? 0 : value > limit ? limit : (int)value;
}

void raster_triangle(raster *r, const raster_corner c[3], double line) {
    const double area = turn(&c[0], &c[1], c[2].x, c[2].y);
    double height[3];
    if (!(fabs(area) > 0))
        return;
    for (int k = 0; k < 3; k++) {
        const raster_corner *a = &c[(k + 1) % 3], *b = &c[(k + 2) % 3];
        height[k] = fabs(area) / hypot(b->x - a->x, b->y - a->y);
    }
    const int left = within(floor(fmin(c[0].x, fmin(c[1].x, c[2].x))), r->onto->width);
    const int right = within(ceil(fmax(c[0].x, fmax(c[1].x, c[2].x))), r->onto->width);
    const int top = within(floor(fmin(c[0].y, fmin(c[1].y, c[2].y))), r->onto->height);
    const int bottom = within(ceil(fmax(c[0].y, fmax(c[1].y, c[2].y))), r->onto->height);
    for (int y = top; y < bottom; y++)
        for (int x = left; x < right; x++) {
            double weight[3];
            for (int k = 0; k < 3; k++)
                weight[k] = turn(&c[(k + 1) % 3], &c[(k + 2) % 3], x + 0.5, y + 0.5) / area;
            if (weight[0] >= 0 && weight[1] >= 0 && weight[2] >= 0)
                draw_pixel(r, c, weight, height, x, y, line);
        }
}
