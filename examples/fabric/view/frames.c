/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "view/frames.h"

#include <stdio.h>
#include <stdlib.h>

int frames_read(const frames *f, int number, state *s) {
    char name[32], path[FILE_PATH_SIZE];
    snprintf(name, sizeof name, "%04ld.state", f->steps[number]);
    if (files_join(path, f->folder, name) != 0 || state_read(s, path) != 0)
        return -1;
    if (number == 0 ? s->triangle != NULL : s->vertex_count == f->first.vertex_count)
        return 0;
    fprintf(stderr, "%s: not a frame of this run\n", path);
    state_free(s);
    return -1;
}

int frames_open(frames *f, const char *folder) {
    *f = (frames){.count = 0};
    if (files_join(f->folder, folder, "frames") != 0)
        return -1;
    f->count = files_numbered(f->folder, ".state", &f->steps);
    if (f->count == 0)
        fprintf(stderr, "%s: no frames, which 'run' writes unless --frames is 0\n", f->folder);
    if (f->count <= 0)
        return -1;
    if (frames_read(f, 0, &f->first) == 0)
        return 0;
    f->first = (state){.memory = NULL};
    return -1;
}

void frames_close(frames *f) {
    if (f->count > 0)
        free(f->steps);
    state_free(&f->first);
    f->count = 0;
}
