/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Finds the directives that are followed by an uncompiled branch of #if. */
#include "frontend/convert.h"

static unsigned offset_of(CXSourceLocation location) {
    unsigned offset;
    clang_getExpansionLocation(location, NULL, NULL, NULL, &offset);
    return offset;
}

/* clang's ranges extend from the directive whose condition is false into the one that ends the
 * branch. */
void mark_skipped_directives(converter *c) {
    CXSourceRangeList *ranges = clang_getSkippedRanges(c->clang, c->main_file);
    if (ranges == NULL)
        return;
    unsigned next = 0; /* both are in order; ranges do not overlap, but may share a directive */
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
