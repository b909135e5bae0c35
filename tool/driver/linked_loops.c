/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "driver/linked_loops.h"

#include <string.h>

#include "driver/files.h"
#include "support/source.h"

/* Is the file a shared library that was linked with the runtime's archive? Then it contains the
 * runtime that its loops use, and the link needs no other. */
static bool is_served(const session *s, const char *path) {
    const bool is_shared = source_ends_with(path, ".so") || strstr(path_base(path), ".so.");
    return is_shared && !source_ends_with(s->tools.library, ".so");
}

bool has_loops(session *s, const char *path) {
    if (is_served(s, path))
        return false;
    size_t length = 0;
    const char *bytes = file_read(s->memory, path, &length);
    return bytes && memmem(bytes, length, "redcc_run", sizeof "redcc_run") != NULL;
}

/* Does library -lNAME in the folder, given by -L, have loops? */
static bool is_in_folder(session *s, const char *folder, const char *name) {
    return has_loops(s, arena_format(s->memory, "%s/lib%s.a", folder, name)) ||
           has_loops(s, arena_format(s->memory, "%s/lib%s.so", folder, name));
}

static bool library_has_loops(session *s, const char *name) {
    for (unsigned i = 0; i < s->command.count; i++) {
        const item *one = &s->command.items[i];
        if (source_starts_with(one->text, "-L") && is_in_folder(s, item_argument(one), name))
            return true;
    }
    return false;
}

bool loops_are_linked(session *s) {
    for (unsigned i = 0; i < s->command.count; i++) {
        const item *one = &s->command.items[i];
        const bool is_library = source_starts_with(one->text, "-l");
        if (is_library ? library_has_loops(s, item_argument(one))
                       : one->kind == INPUT_LINK && has_loops(s, one->text))
            return true;
    }
    return false;
}
