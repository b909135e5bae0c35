/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "fuzz/request.h"

#include <stdlib.h>
#include <string.h>

/* Reads numbers with commas between them and marks them in `set`, counted from `first`. */
static bool read_list(bool *set, int size, uint64_t first, const char *list) {
    while (*list) {
        char *end;
        const uint64_t number = strtoull(list, &end, 10) - first;
        if (end == list || number >= (uint64_t)size)
            return false;
        set[number] = true;
        list = *end == ',' ? end + 1 : end;
    }
    return true;
}

static bool read_option(request *r, own_option *own, const char *option) {
    if (strncmp(option, "--without=", 10) == 0) {
        r->has_without = true;
        return read_list(r->without, MOST_STATEMENTS, 0, option + 10);
    }
    if (strncmp(option, "--only=", 7) == 0) {
        memset(r->taken, false, sizeof r->taken);
        return read_list(r->taken, MOST_PROGRAMS, r->first, option + 7);
    }
    if (strcmp(option, "--statements") == 0)
        return r->only_statements = true;
    return strcmp(option, own->name) == 0 && (own->is_given = true);
}

bool request_read(request *r, own_option *own, int argc, char **argv) {
    if (argc < 3)
        return false;
    r->first = strtoull(argv[1], NULL, 10);
    r->count = atoi(argv[2]);
    memset(r->taken, true, sizeof r->taken);
    for (int i = 3; i < argc; i++)
        if (!read_option(r, own, argv[i]))
            return false;
    return r->count > 0 && r->count <= MOST_PROGRAMS;
}
