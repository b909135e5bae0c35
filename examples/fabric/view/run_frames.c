/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "view/run_frames.h"

#include <stdio.h>
#include <stdlib.h>

static int read_frame(void *context, int number, state *s) {
    return frames_read(context, number, s);
}

static int read_times(run_frames *r) {
    for (int k = 0; k < r->files.count; k++) {
        state s;
        if (frames_read(&r->files, k, &s) != 0)
            return -1;
        r->time[k] = s.time;
        state_free(&s);
    }
    return 0;
}

int run_frames_open(run_frames *r, const char *folder) {
    *r = (run_frames){.time = NULL};
    if (frames_open(&r->files, folder) != 0)
        return -1;
    r->time = malloc((size_t)r->files.count * sizeof *r->time);
    if (!r->time) {
        fprintf(stderr, "%s: out of memory\n", folder);
        return -1;
    }
    r->of = (cloth_frames){.count = r->files.count,
                           .time = r->time,
                           .vertex_count = r->files.first.vertex_count,
                           .triangle_count = r->files.first.triangle_count,
                           .triangle = r->files.first.triangle,
                           .read = read_frame,
                           .context = &r->files};
    return read_times(r);
}

static void run_frames_close(run_frames *r) {
    free(r->time);
    frames_close(&r->files);
}

int run_frames_finish(run_frames *r, int status, const char *to) {
    if (status == 0)
        printf("%d frames of %d vertices in %s\n", r->of.count, r->of.vertex_count, to);
    run_frames_close(r);
    return status;
}
