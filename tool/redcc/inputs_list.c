/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#define _GNU_SOURCE /* dl_iterate_phdr */
#include "redcc/inputs_list.h"

#include <link.h>

#include "redcc/output.h"
#include "support/buffer.h"

static void add(buffer *list, char kind, const char *path) {
    if (!path)
        return;
    buffer_byte(list, kind);
    buffer_text(list, path);
    buffer_byte(list, 0);
}

static int add_library(struct dl_phdr_info *library, size_t size, void *list) {
    (void)size;
    if (library->dlpi_name[0] == '/') /* not this program itself, nor the kernel's vDSO */
        add(list, 'l', library->dlpi_name);
    return 0;
}

const char *inputs_list_write(arena *a, const char *path, const frontend_result *parsed) {
    buffer list = {0};
    dl_iterate_phdr(add_library, &list);
    const frontend_folders folders = frontend_header_folders(a);
    add(&list, 'd', folders.own);
    add(&list, 'd', folders.of_gcc);
    for (unsigned i = 0; i < parsed->file_count; i++)
        add(&list, 'f', parsed->files[i]);
    const char *wrong = output_write(a, path, list.data ? list.data : "", list.length);
    buffer_free(&list);
    return wrong;
}
