/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Lists the files that a parse has read. */
#include "frontend/convert.h"
#include "frontend/flags.h"

typedef struct file_list {
    arena *arena;
    VECTOR(const char *) names;
} file_list;

static void visit(CXFile file, CXSourceLocation *stack, unsigned depth, CXClientData data) {
    (void)stack;
    (void)depth;
    file_list *list = data;
    CXString name = clang_getFileName(file);
    VECTOR_PUSH(list->arena, &list->names, arena_string(list->arena, clang_getCString(name)));
    clang_disposeString(name);
}

void list_inclusions(arena *a, CXTranslationUnit clang, frontend_result *result) {
    file_list list = {.arena = a};
    clang_getInclusions(clang, visit, &list);
    result->file_count = list.names.count;
    result->files = list.names.items;
}
