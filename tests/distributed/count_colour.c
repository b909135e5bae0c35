/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* count_colour FILE.png R,G,B...: prints, for each colour on a line, the number of the picture's
 * pixels with exactly this colour. */
#include <png.h>
#include <stdio.h>
#include <stdlib.h>

static long count(const unsigned char *rgb, size_t pixels, const int colour[3]) {
    long found = 0;
    for (size_t k = 0; k < pixels; k++)
        found +=
            rgb[3 * k] == colour[0] && rgb[3 * k + 1] == colour[1] && rgb[3 * k + 2] == colour[2];
    return found;
}

int main(int argc, char **argv) {
    png_image image = {.version = PNG_IMAGE_VERSION};
    if (argc < 2 || png_image_begin_read_from_file(&image, argv[1]) == 0) {
        fprintf(stderr, "count_colour: no picture: %s\n", image.message);
        return EXIT_FAILURE;
    }
    image.format = PNG_FORMAT_RGB;
    unsigned char *rgb = malloc(PNG_IMAGE_SIZE(image));
    if (!rgb || png_image_finish_read(&image, NULL, rgb, 0, NULL) == 0) {
        fprintf(stderr, "count_colour: the picture cannot be read\n");
        free(rgb);
        return EXIT_FAILURE;
    }
    for (int k = 2; k < argc; k++) {
        int colour[3];
        if (sscanf(argv[k], "%d,%d,%d", &colour[0], &colour[1], &colour[2]) != 3) {
            fprintf(stderr, "count_colour: '%s', expected R,G,B\n", argv[k]);
            free(rgb);
            return EXIT_FAILURE;
        }
        printf("%ld\n", count(rgb, (size_t)image.width * image.height, colour));
    }
    free(rgb);
    return EXIT_SUCCESS;
}
