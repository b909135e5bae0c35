/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Pictures in memory, and as PNG files. */
#ifndef FABRIC_VIEW_PICTURE_H
#define FABRIC_VIEW_PICTURE_H

/* Default size of a picture. */
enum { PICTURE_WIDTH = 960, PICTURE_HEIGHT = 720 };

typedef struct picture {
    int width, height;
    unsigned char *rgb; /* [height][width][3], top row first */
} picture;

/** Makes a white picture, which picture_free frees. Returns 0, or -1 if out of memory. */
int picture_new(picture *p, int width, int height);
void picture_free(picture *p);

/** Halves width and height, which must be even: each pixel is the mean of four. Returns 0, or -1 if
 *  out of memory. */
int picture_halve(const picture *p, picture *half);

/** Copies `from` into `onto` with its upper left corner at (x, y). Parts outside of `onto` are
 *  clipped. */
void picture_paste(picture *onto, const picture *from, int x, int y);

/** Writes digits, '.', '=', ' ', 's' and 't' in dark grey. A character has 5 by 7 dots of `dot`
 *  pixels each; the upper left corner is at (x, y). */
void picture_text(picture *p, int x, int y, int dot, const char *text);

/** Writes a temporary file and renames it to `path`. Returns 0, or -1 after a message on standard
 *  error. */
int picture_write_png(const picture *p, const char *path);

#endif
