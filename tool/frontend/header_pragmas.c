/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Pragmas in the program's own headers, of which clang's tree tells nothing: FENV_ACCESS,
 * threadprivate, weak. Those of the system hold none that matter here. */
#define _GNU_SOURCE /* memmem */
#include <string.h>

#include "frontend/convert.h"
#include "frontend/directives.h"

static void visit(CXFile file, CXSourceLocation *stack, unsigned depth, CXClientData data) {
    (void)stack;
    converter *c = data;
    if (depth == 0 || is_of_system(c, file))
        return;
    const file_text text = text_of_file(c, file);
    if (text.length == 0 || memmem(text.text, text.length, "ragma", 5) == NULL)
        return;
    unsigned count;
    const ir_directive *found = directives_in(c->arena, text.text, text.length, &count);
    for (unsigned i = 0; i < count; i++)
        if (found[i].kind == IR_DIRECTIVE_PRAGMA || strstr(found[i].text, "_Pragma") != NULL)
            VECTOR_PUSH(c->arena, &c->header_pragmas, found[i].text);
}

void find_header_pragmas(converter *c) {
    clang_getInclusions(c->clang, visit, c);
    c->unit->text.header_pragma_count = c->header_pragmas.count;
    c->unit->text.header_pragmas = c->header_pragmas.items;
}
