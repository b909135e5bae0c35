/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Finds pragmas in the program's own headers, which clang's tree does not show: FENV_ACCESS,
 * threadprivate, weak. Those in system headers do not matter here. */
#include <string.h>

#include "frontend/convert.h"

static void visit(CXFile file, CXSourceLocation *stack, unsigned depth, CXClientData data) {
    (void)stack;
    converter *c = data;
    if (depth == 0 || is_of_system(c, file))
        return;
    if (!text_has(text_of_file(c, file), "ragma"))
        return;
    const file_directives found = directives_of_file(c, file);
    for (unsigned i = 0; i < found.count; i++)
        if (found.items[i].kind == IR_DIRECTIVE_PRAGMA ||
            strstr(found.items[i].text, "_Pragma") != NULL)
            VECTOR_PUSH(c->arena, &c->headers.pragmas, found.items[i].text);
}

void find_header_pragmas(converter *c) {
    clang_getInclusions(c->clang, visit, c);
    c->unit->text.header_pragma_count = c->headers.pragmas.count;
    c->unit->text.header_pragmas = c->headers.pragmas.items;
}
