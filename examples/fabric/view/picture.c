/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "view/picture.h"

#include <png.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "output/fresh_file.h"

int picture_new(picture *p, int width, int height) {
    const size_t size = 3 * (size_t)width * (size_t)height;
    *p = (picture){width, height, malloc(size)};
    if (!p->rgb)
        return -1;
    memset(p->rgb, 255, size);
    return 0;
}

void picture_free(picture *p) {
    free(p->rgb);
    *p = (picture){0};
}

static unsigned char *pixel(const picture *p, int x, int y) {
    return p->rgb + 3 * ((size_t)y * (size_t)p->width + (size_t)x);
}

int picture_halve(const picture *p, picture *half) {
    if (picture_new(half, p->width / 2, p->height / 2) != 0)
        return -1;
    for (int y = 0; y < half->height; y++)
        for (int x = 0; x < half->width; x++) {
            const unsigned char *above = pixel(p, 2 * x, 2 * y);
            const unsigned char *below = pixel(p, 2 * x, 2 * y + 1);
            unsigned char *to = pixel(half, x, y);
            for (int c = 0; c < 3; c++)
                to[c] =
                    (unsigned char)((above[c] + above[c + 3] + below[c] + below[c + 3] + 2) / 4);
        }
    return 0;
}

void picture_paste(picture *onto, const picture *from, int x, int y) {
    for (int row = 0; row < from->height; row++)
        for (int column = 0; column < from->width; column++) {
            const int to_x = x + column, to_y = y + row;
            if (to_x >= 0 && to_x < onto->width && to_y >= 0 && to_y < onto->height)
                memcpy(pixel(onto, to_x, to_y), pixel(from, column, row), 3);
        }
}

/** Seven rows of five dots from top to bottom; the left dot is the highest bit. */
typedef struct glyph {
    char character;
    unsigned char row[7];
} glyph;

static const glyph glyphs[] = {
    {'0', {0x0e, 0x11, 0x13, 0x15, 0x19, 0x11, 0x0e}},
    {'1', {0x04, 0x0c, 0x04, 0x04, 0x04, 0x04, 0x0e}},
    {'2', {0x0e, 0x11, 0x01, 0x02, 0x04, 0x08, 0x1f}},
    {'3', {0x1f, 0x02, 0x04, 0x02, 0x01, 0x11, 0x0e}},
    {'4', {0x02, 0x06, 0x0a, 0x12, 0x1f, 0x02, 0x02}},
    {'5', {0x1f, 0x10, 0x1e, 0x01, 0x01, 0x11, 0x0e}},
    {'6', {0x06, 0x08, 0x10, 0x1e, 0x11, 0x11, 0x0e}},
    {'7', {0x1f, 0x01, 0x02, 0x04, 0x08, 0x08, 0x08}},
    {'8', {0x0e, 0x11, 0x11, 0x0e, 0x11, 0x11, 0x0e}},
    {'9', {0x0e, 0x11, 0x11, 0x0f, 0x01, 0x02, 0x0c}},
    {'.', {0x00, 0x00, 0x00, 0x00, 0x00, 0x0c, 0x0c}},
    {'=', {0x00, 0x00, 0x1f, 0x00, 0x1f, 0x00, 0x00}},
    {'s', {0x00, 0x00, 0x0f, 0x10, 0x0e, 0x01, 0x1e}},
    {'t', {0x08, 0x08, 0x1c, 0x08, 0x08, 0x09, 0x06}},
};

static void draw_dot(picture *p, int x, int y, int size) {
    for (int row = y; row < y + size; row++)
        for (int column = x; column < x + size; column++)
            if (column >= 0 && column < p->width && row >= 0 && row < p->height)
                memset(pixel(p, column, row), 60, 3);
}

void picture_text(picture *p, int x, int y, int dot, const char *text) {
    for (; *text; text++, x += 6 * dot)
        for (size_t g = 0; g < sizeof glyphs / sizeof *glyphs; g++)
            for (int k = 0; k < 35 && glyphs[g].character == *text; k++)
                if ((glyphs[g].row[k / 5] >> (4 - k % 5) & 1) != 0)
                    draw_dot(p, x + k % 5 * dot, y + k / 5 * dot, dot);
}

int picture_write_png(const picture *p, const char *path) {
    png_image image = {.version = PNG_IMAGE_VERSION,
                       .width = (png_uint_32)p->width,
                       .height = (png_uint_32)p->height,
                       .format = PNG_FORMAT_RGB};
    fresh_file f;
    if (fresh_file_open(&f, path) != 0)
        return -1;
    const int written = png_image_write_to_stdio(&image, f.file, 0, p->rgb, 0, NULL) != 0;
    if (!written)
        fprintf(stderr, "%s: cannot be written: %s\n", path, image.message);
    return fresh_file_close(&f, written ? 0 : -1);
}
