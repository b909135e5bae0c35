/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Conditional lastprivate: private variables that some iterations assign and that are live-out.
 * Their final value is that of the last iteration that assigned them. Each thread stores the value
 * at redcc__noted_N, and the iteration's number at redcc__when_N. After the loop the value with the
 * highest iteration number is taken. Several threads that execute one iteration store the same
 * value.
 */
#include "emit/body/live_out.h"

#include <assert.h>

#include "emit/text/origin.h"
#include "plan/lookup.h"

void declare_conditional_live_outs(loop_text *loop, writer *out) {
    if (has_conditional_live_outs(loop->facts))
        writer_line(out, "int redcc__lock = 0;");
    for (unsigned i = 0; i < loop->facts->variables.private_count; i++) {
        if (!loop->facts->variables.privates[i].is_conditional_live_out)
            continue;
        const char *name =
            origin_variable(loop->arena, loop->facts->variables.privates[i].variable);
        writer_line(out, "redcc_int redcc__latest_%u = -1;", i);
        writer_line(out, "__typeof__(%s) redcc__found_%u = 0;", name, i);
    }
}

void write_note(loop_text *loop, writer *out, unsigned number) {
    assert(loop->facts->variables.privates[number].is_conditional_live_out);
    writer_line(out, "if (redcc__k >= *redcc__when_%u) {", number);
    out->depth++;
    writer_line(out, "*redcc__when_%u = redcc__k;", number);
    writer_line(out, "*redcc__noted_%u = %s;", number,
                origin_variable(loop->arena, loop->facts->variables.privates[number].variable));
    out->depth--;
    writer_line(out, "}");
}

void write_last_notes(loop_text *loop, writer *out) {
    if (!has_conditional_live_outs(loop->facts))
        return;
    writer_line(out, "redcc_lock(redcc__lock);");
    for (unsigned i = 0; i < loop->facts->variables.private_count; i++) {
        if (!loop->facts->variables.privates[i].is_conditional_live_out)
            continue;
        writer_line(out, "if (*redcc__when_%u > *redcc__latest_%u) {", i, i);
        writer_line(out, "    *redcc__latest_%u = *redcc__when_%u;", i, i);
        writer_line(out, "    *redcc__found_%u = *redcc__noted_%u;", i, i);
        writer_line(out, "}");
    }
    writer_line(out, "redcc_unlock(redcc__lock);");
}

void take_conditional_live_outs(loop_text *loop, writer *out) {
    for (unsigned i = 0; i < loop->facts->variables.private_count; i++) {
        if (!loop->facts->variables.privates[i].is_conditional_live_out)
            continue;
        writer_line(out, "if (redcc__latest_%u >= 0) {", i);
        writer_line(out, "    %s = redcc__found_%u; }",
                    origin_variable(loop->arena, loop->facts->variables.privates[i].variable), i);
    }
}

/* ---- assigned in each iteration ------------------------------------------------------------ */

/** Returns an initialiser that prevents warnings. It is needed because compilers do not know that
 * the loop iterates and that each iteration assigns the variable. */
static const char *start_value(const ir_type *type) {
    if (type->size < 0)
        return "";
    return type->kind == IR_ARRAY || type->kind == IR_RECORD ? " = {0}" : " = 0";
}

void declare_live_outs(loop_text *loop, writer *out) {
    for (unsigned i = 0; i < loop->facts->variables.private_count; i++) {
        const private_variable *item = &loop->facts->variables.privates[i];
        if (item->is_live_after)
            writer_line(out, "__typeof__(%s) redcc__last_%s%s;",
                        origin_variable(loop->arena, item->variable), item->variable->name,
                        start_value(item->variable->type));
    }
}

static void copy_value(writer *out, const ir_type *type, const char *to, const char *from) {
    if (type->kind == IR_ARRAY)
        writer_line(out, "__builtin_memcpy(%s, %s, sizeof(%s));", to, from, to);
    else
        writer_line(out, "%s = %s;", to, from);
}

void note_live_outs(loop_text *loop, writer *out) {
    if (!has_live_outs(loop->facts))
        return;
    writer_line(out, "if (redcc__k + 1 == %s && REDCC_CLAIMS_LAST) {",
                loop->continues ? "REDCC_MADE" : "redcc__trip");
    for (unsigned i = 0; i < loop->facts->variables.private_count; i++) {
        const private_variable *item = &loop->facts->variables.privates[i];
        if (item->is_live_after)
            copy_value(out, item->variable->type,
                       arena_format(loop->arena, "*redcc__last_%s", item->variable->name),
                       origin_variable(loop->arena, item->variable));
    }
    writer_line(out, "}");
}

void take_live_outs(loop_text *loop, writer *out) {
    for (unsigned i = 0; i < loop->facts->variables.private_count; i++) {
        const private_variable *item = &loop->facts->variables.privates[i];
        if (item->is_live_after)
            copy_value(out, item->variable->type, origin_variable(loop->arena, item->variable),
                       arena_format(loop->arena, "redcc__last_%s", item->variable->name));
    }
}
