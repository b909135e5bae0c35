/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Finds the directives after which the text is not compiled, because an #if excludes it. */
#include "frontend/convert.h"

static unsigned offset_of(CXSourceLocation location) {
    unsigned offset;
    clang_getExpansionLocation(location, NULL, NULL, NULL, &offset);
    return offset;
}

/* Sets is_skipped of the file's directives. Each of clang's ranges begins in the directive whose
 * condition is false, and ends in the directive that ends the branch. */
void mark_skipped_directives(converter *c) {
    CXSourceRangeList *ranges = clang_getSkippedRanges(c->clang, c->main_file);
    if (ranges == NULL)
        return;
    unsigned next = 0; /* Ranges and directives are both in order. Ranges do not overlap, but two
                        * may share a directive. */
    for (unsigned i = 0; i < ranges->count; i++) {
        const unsigned begin = offset_of(clang_getRangeStart(ranges->ranges[i]));
        const unsigned end = offset_of(clang_getRangeEnd(ranges->ranges[i]));
        for (; next < c->unit->directive_count; next++) {
            ir_directive *directive = &c->unit->directives[next];
            if (directive->range.end >= end)
                break;
            directive->is_skipped = directive->range.end > begin;
        }
    }
    clang_disposeSourceRangeList(ranges);
}
