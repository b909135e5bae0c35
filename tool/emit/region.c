/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "emit/region.h"

#include <assert.h>

#include "emit/bins/bins.h"
#include "emit/body/live_out.h"
#include "emit/body/series.h"
#include "plan/inner_iterations.h"
#include "plan/lookup.h"

void write_region(loop_text *loop, writer *out) {
    const char *kind = loop->outline.reads_call ? "_BINNED_READS"
                       : loop->bins             ? "_BINNED"
                       : loop->lanes.name       ? "_LANES"
                                                : "";
    const bool has_leaders = plan_has_leaders(loop->plan);
    assert(!has_leaders || !loop->lanes.name);         /* plan/lanes.c: such a loop has no lanes */
    assert(!has_leaders || !loop->outline.reads_call); /* write_slice_of_reads has written none */
    const char *series = has_leaders ? "_SERIES" : "";
    join_series(loop, out);
    if (loop->facts->inspector.hull_count > 0)
        writer_line(out, "REDCC_HULLS");
    const char *tiles = loop->outline.tile_call
                            ? arena_format(loop->arena, " REDCC_TILED(%lld, %s, %s)",
                                           (long long)loop->facts->counted.step,
                                           loop->outline.tile_call, series_of_band(loop))
                            : "";
    writer_line(out, "REDCC_PARALLEL%s%s(%sREDCC_CHUNK_%u%s,%s%s%s", kind, series,
                loop->bins ? streams_argument(loop) : "", loop->facts->array_count, tiles,
                loop->bins ? " " : "", loop->bins ? bins_phase(loop) : "", loop->bins ? "," : "");
    if (has_leaders)
        writer_line(out, "    (%s),", has_series(loop->facts) ? series_condition(loop) : "0");
    if (loop->outline.reads_call)
        writer_line(out, "    %s,", loop->outline.reads_call);
    writer_line(out, "    %s,", loop->outline.slice_call);
    writer_line(out, "    %s%s", loop->outline.body_call, loop->lanes.name ? "," : ")");
    if (loop->lanes.name)
        writer_line(out, "    %s, (%s))", loop->lanes.name, loop->lanes.arguments);
    write_thread_end(loop, out);
}

void write_thread_end(loop_text *loop, writer *out) {
    finish_series(loop, out);
    write_last_notes(loop, out);
}
