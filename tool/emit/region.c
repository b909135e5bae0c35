/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The parallel region: each thread inspects its iterations, then executes what it is handed. */
#include "emit/region.h"

#include "emit/bins/bins.h"
#include "emit/body/body.h"
#include "emit/body/live_out.h"
#include "emit/body/series.h"
#include "emit/slice/slice.h"
#include "emit/text/origin.h"
#include "plan/lookup.h"

/* ---- variables of the region --------------------------------------------------------------- */

static bool is_thread_local(const ir_variable *variable) {
    return variable->storage == IR_THREAD_LOCAL;
}

/** The clause, or "" where there is nothing to copy in. */
static const char *firstprivate_clause(loop_text *loop) {
    buffer out = {0};
    for (unsigned i = 0; i < loop->facts->variables.captured_count; i++) {
        const ir_variable *variable = loop->facts->variables.captured[i];
        if (is_copied_in(variable) && !is_thread_local(variable))
            buffer_format(&out, "%s%s", out.length > 0 ? ", " : "firstprivate(",
                          origin_declarator(loop->arena, variable));
    }
    add_series_variables(loop, &out);
    if (out.length > 0)
        buffer_text(&out, ")");
    return buffer_take(loop->arena, &out);
}

/** Thread-local scalars cannot be named in the clause: what this thread's hold goes by a copy. */
void write_thread_local_copies(loop_text *loop, writer *out, bool in_region) {
    for (unsigned i = 0; i < loop->facts->variables.captured_count; i++) {
        const ir_variable *variable = loop->facts->variables.captured[i];
        if (!is_thread_local(variable))
            continue;
        const char *name = origin_variable(loop->arena, variable);
        if (in_region)
            writer_line(out, "const __typeof__(%s) %s = redcc__copy_%s;", name,
                        origin_declarator(loop->arena, variable), variable->name);
        else
            writer_line(out, "const __typeof__(%s) redcc__copy_%s = %s;", name, variable->name,
                        name);
    }
}

/* ---- the region ---------------------------------------------------------------------------- */

/** Iterations that need not be logged are gone through in a loop of their own, in which nothing is
 *  called or stored: the compiler keeps in registers what does not change. */
static void write_probing(loop_text *loop, writer *out) {
    writer_line(out, "if (redcc_is_settled(&redcc__worker)) {");
    writer_line(out, "    const redcc_int redcc__from = redcc__k;");
    writer_line(out, "    for (; redcc__k < redcc__worker.last; redcc__k++) {");
    out->depth += 2;
    write_inspected_iteration(loop, out, true);
    out->depth -= 2;
    writer_line(out, "    }");
    writer_line(out, "    redcc__worker.alike += redcc__k - redcc__from;");
    writer_line(out, "    if (redcc__k == redcc__worker.last)");
    writer_line(out, "        break;");
    writer_line(out, "}");
}

static void write_inspector(loop_text *loop, writer *out) {
    writer_line(out, "/* inspector: which elements does each iteration update? */");
    writer_line(out, "while (redcc_inspect(&redcc__worker))");
    writer_line(out, "    for (redcc__k = redcc__worker.first; redcc__k < redcc__worker.last;");
    writer_line(out, "         redcc__k += redcc__worker.stride) {");
    out->depth += 2;
    write_probing(loop, out);
    writer_line(out, "{");
    out->depth++;
    write_inspected_iteration(loop, out, false);
    out->depth--;
    writer_line(out, "}");
    out->depth -= 2;
    writer_line(out, "    }");
}

/** Is it of the very type of what it stands for? Then a typeof in the body may name it. */
static bool stands_for_pointer(const loop_text *loop, unsigned number) {
    return loop->arrays[number].is_shadowed &&
           loop->facts->arrays[number].base->type->kind == IR_POINTER;
}

static void declare_chunk(loop_text *loop, writer *out) {
    for (unsigned i = 0; i < loop->facts->array_count; i++) {
        const array_text *array = &loop->arrays[i];
        if (array->local)
            writer_line(out, "__typeof__(&%s[0]) %s%s = redcc__worker.base[%u];", array->base,
                        stands_for_pointer(loop, i) ? "" : "const ", array->declarator, i);
        writer_line(out, "const redcc_owner %s = redcc__worker.owner[%u];", array->owner, i);
    }
    declare_live_privates(loop, out);
    writer_line(out, "const redcc_run *redcc__run = redcc__worker.run;");
}

static void write_run(loop_text *loop, writer *out) {
    writer_line(out, "const redcc_int redcc__end = redcc__worker.origin + redcc__run->begin");
    writer_line(out, "                             + redcc__run->count_and_guard / 2;");
    writer_line(out, "int redcc__guarded;");
    writer_line(out, "REDCC_PLAIN_OR_GUARDED");
    writer_line(out, "for (redcc__k = redcc__worker.origin + redcc__run->begin; "
                     "redcc__k < redcc__end; redcc__k++) {");
    out->depth++;
    write_iteration(loop, out);
    out->depth--;
    writer_line(out, "}");
    if (has_live_outs(loop->facts)) {
        writer_line(out, "if (redcc__end == redcc__trip && redcc_claims_last(&redcc__worker)) {");
        out->depth++;
        write_live_outs(loop, out, false);
        out->depth--;
        writer_line(out, "}");
    }
}

static void write_executor(loop_text *loop, writer *out) {
    writer_line(out, "/* executor */");
    writer_line(out, "while (%s) {", series_go_on(loop));
    out->depth++;
    declare_chunk(loop, out);
    writer_line(out, "for (; redcc__run != redcc__worker.run_end; redcc__run++) {");
    out->depth++;
    write_run(loop, out);
    out->depth--;
    writer_line(out, "}");
    out->depth--;
    writer_line(out, "}");
}

void write_region(loop_text *loop, writer *out) {
    if (loop->outline.done) {
        const char *kind = loop->bins ? "_BINNED" : loop->lanes.name ? "_LANES" : "";
        writer_line(out, "REDCC_THREADS(%s)", firstprivate_clause(loop));
        writer_line(out, "    REDCC_PARALLEL%s(REDCC_CHUNK_%u, %s%s", kind,
                    loop->facts->array_count, loop->bins ? bins_phase(loop) : "",
                    loop->bins ? "," : "");
        writer_line(out, "        %s,", loop->outline.slice_call);
        writer_line(out, "        %s%s", loop->outline.body_call, loop->lanes.name ? "," : ")");
        if (loop->lanes.name)
            writer_line(out, "        %s, (%s))", loop->lanes.name, loop->lanes.arguments);
        return;
    }
    buffer_format(&out->out, "#pragma omp parallel num_threads(redcc__call.threads) %s\n",
                  firstprivate_clause(loop));
    writer_line(out, "{");
    out->depth++;
    writer_line(out, "redcc_worker redcc__worker;");
    writer_line(out, "redcc_int redcc__k;");
    declare_conditional_live_outs(loop, out, true);
    write_thread_local_copies(loop, out, true);
    writer_line(out, "redcc_join(&redcc__worker, &redcc__call, omp_get_thread_num(), "
                     "omp_get_num_threads());");
    join_series(loop, out);
    write_inspector(loop, out);
    write_executor(loop, out);
    finish_series(loop, out);
    gather_conditional_live_outs(loop, out);
    out->depth--;
    writer_line(out, "}");
}
