/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "emit/sections.h"

#include "emit/sequential_copy.h"
#include "emit/text/origin.h"

void write_sections(loop_text *loop, writer *out) {
    const array_section *sections = loop->plan->execution.sections;
    if (!sections)
        return;
    writer_line(out, "REDCC_SECTIONS(%u);", loop->facts->array_count);
    for (unsigned i = 0; i < loop->facts->array_count; i++)
        writer_line(out, "REDCC_SECTION(%u, %s, %s, %s);", i,
                    origin_variable(loop->arena, loop->facts->arrays[i].base->variable),
                    clause_expression(loop, sections[i].lower),
                    clause_expression(loop, sections[i].length));
}
