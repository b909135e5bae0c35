/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "emit/crew.h"

#include "analysis/base/openmp_loop.h"
#include "emit/base/names.h"

bool has_crew(const loop_text *loop) {
    const openmp_loop *openmp = loop->facts->variables.openmp;
    return openmp && openmp->is_of_team;
}

void write_meeting(loop_text *loop, writer *out) {
    if (!has_crew(loop))
        return;
    const char *site = outlined_name(loop, "site");
    const bool has_locks = loop->facts->variables.openmp->has_locks;
    writer_line(out, "redcc_crew *redcc__crew;");
    if (has_locks) {
        writer_line(out, "REDCC_ARRIVE(%s);", site);
        buffer_text(&out->out, "#pragma omp barrier\n");
    }
    buffer_text(&out->out, "#pragma omp single copyprivate(redcc__crew)\n");
    writer_line(out, "redcc__crew = REDCC_CREW_BEGINS(%s, %d);", site, has_locks);
    writer_line(out, "if (!REDCC_HAS_HELPED(%s)) {", site);
}

void write_parting(loop_text *loop, writer *out) {
    writer_line(out, "REDCC_CREW_ENDS(%s);", outlined_name(loop, "site"));
    writer_line(out, "}");
}
