/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* fabric-view render: pictures of a run. */
#include <stdio.h>
#include <stdlib.h>

#include "base/files.h"
#include "view/film.h"
#include "view/view.h"

enum { SHEET_COLUMNS = 4, SHEET_ROWS = 2, SHEET_FRAMES = SHEET_COLUMNS * SHEET_ROWS };

static const option render_options[] = {VIEW_WIDTH, VIEW_HEIGHT, {.name = NULL}};

/** State while the frames of a run's folder are drawn. */
typedef struct job {
    const char *folder;
    int width, height;
    film *of;
    const frames *frames;
    picture sheet;
} job;

static int out_of_memory(void) {
    fprintf(stderr, "render: out of memory\n");
    return -1;
}

static int open_job(job *j) {
    j->of = film_open(j->folder, j->width, j->height);
    if (!j->of)
        return -1;
    j->frames = film_frames(j->of);
    if (picture_new(&j->sheet, SHEET_COLUMNS * (j->width / 2), SHEET_ROWS * (j->height / 2)) != 0)
        return out_of_memory();
    return 0;
}

static void close_job(job *j) {
    if (j->of)
        film_close(j->of);
    picture_free(&j->sheet);
}

/** Pastes the frame to its places on the contact sheet, which shows eight evenly spaced frames.
 *  With fewer frames, places stay empty. */
static int put_on_sheet(job *j, int number, const picture *frame) {
    const int last = j->frames->count - 1;
    picture small;
    if (picture_halve(frame, &small) != 0)
        return out_of_memory();
    for (int place = 0; place < SHEET_FRAMES; place++) {
        const int wanted = j->frames->count <= SHEET_FRAMES
                               ? place
                               : (place * last + (SHEET_FRAMES - 1) / 2) / (SHEET_FRAMES - 1);
        if (wanted == number)
            picture_paste(&j->sheet, &small, place % SHEET_COLUMNS * small.width,
                          place / SHEET_COLUMNS * small.height);
    }
    picture_free(&small);
    return 0;
}

static int draw_frame(job *j, int number) {
    char name[32], path[FILE_PATH_SIZE];
    picture p;
    double time;
    if (film_draw(j->of, number, &p, &time) != 0)
        return -1;
    snprintf(name, sizeof name, "%04ld.png", j->frames->steps[number]);
    const int status = files_join(path, j->frames->folder, name) == 0 &&
                               picture_write_png(&p, path) == 0 && put_on_sheet(j, number, &p) == 0
                           ? 0
                           : -1;
    picture_free(&p);
    return status;
}

static int render(job *j) {
    char path[FILE_PATH_SIZE];
    if (open_job(j) != 0)
        return -1;
    for (int number = 0; number < j->frames->count; number++)
        if (draw_frame(j, number) != 0)
            return -1;
    if (files_join(path, j->folder, "contact-sheet.png") != 0 ||
        picture_write_png(&j->sheet, path) != 0)
        return -1;
    printf("%d pictures in %s, eight of them on %s\n", j->frames->count, j->frames->folder, path);
    return 0;
}

static int run(const command *self, int argc, char **argv) {
    view_request r;
    const int read = view_read_request(self, argc, argv, &r);
    if (read != OPTIONS_READ)
        return read;
    job j = {.folder = r.folder, .width = (int)r.width, .height = (int)r.height};
    const int status = render(&j);
    close_job(&j);
    return status == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

const command render_command = {"render", "DIR [options]",
                                "Draws the frames of a run: DIR/frames/NNNN.png and "
                                "DIR/contact-sheet.png with eight of them.",
                                render_options, run};
