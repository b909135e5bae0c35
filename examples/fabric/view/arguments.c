/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* What the commands' command lines have in common. */
#include "view/view.h"

int read_picture_size(const options *o, const char *name, int *size) {
    long given;
    if (options_whole(o, name, 32, 4096, &given) != 0)
        return -1;
    *size = (int)(given / 2 * 2);
    return 0;
}

int take_folder(const options *o, const char **folder) {
    if (*folder)
        return options_complain(o->of, "one folder at a time, not '%s' as well", o->value);
    *folder = o->value;
    return 0;
}
