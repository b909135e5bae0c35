/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Options that the commands share. */
#include <stdio.h>

#include "view/view.h"

static int take_word(const options *o, void *request) {
    return options_only_word(o, &((view_request *)request)->folder, "folder");
}

int view_read_request(const command *self, int argc, char **argv, view_request *r) {
    *r = (view_request){.width = PICTURE_WIDTH, .height = PICTURE_HEIGHT};
    const int status = options_read(self, argc, argv, r, take_word);
    if (status != OPTIONS_READ)
        return status;
    /* Makes both even, because halving a picture and films require it. */
    r->width = r->width / 2 * 2;
    r->height = r->height / 2 * 2;
    return r->folder ? OPTIONS_READ : options_complain(self, "which folder? %s", self->synopsis);
}

int view_output(char path[FILE_PATH_SIZE], const char *folder, const char *name,
                const char *given) {
    if (!given)
        return files_join(path, folder, name);
    if (snprintf(path, FILE_PATH_SIZE, "%s", given) < FILE_PATH_SIZE)
        return 0;
    fprintf(stderr, "%.100s...: path too long\n", given);
    return -1;
}
