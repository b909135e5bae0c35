/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "emit/team_parts.h"

#include "analysis/base/openmp_loop.h"
#include "emit/macro_names.h"
#include "emit/text/origin.h"

/* The name of a built-in type with the same values, or NULL if there is none. */
static const char *plain_type(const ir_type *type) {
    static const char *const integers[][2] = {{"unsigned char", "signed char"},
                                              {"unsigned short", "short"},
                                              {"unsigned int", "int"},
                                              {"unsigned long long", "long long"}};
    if (type->kind == IR_BOOLEAN)
        return "_Bool";
    if (type->kind == IR_INTEGER)
        for (int i = 0; i < 4; i++)
            if (type->size == 1 << i)
                return integers[i][type->is_signed];
    return type->kind != IR_FLOATING ? NULL
           : type->size == 4         ? "float"
           : type->size == 8         ? "double"
                                     : "long double";
}

/* A number that identifies the loop within its file: the loop's offset. */
static unsigned number_of(const loop_text *loop) {
    return loop->facts->loop->range.begin;
}

bool has_frame_parts(const loop_text *loop) {
    const fixed_blocks *blocks = loop->facts->variables.blocks;
    const ir_node *body = loop->facts->function->body;
    bool has = blocks->team.shares_frame && !(body->flags & IR_FROM_MACRO) &&
               loop->unit->source->text[body->range.begin] == '{';
    for (unsigned i = 0; i < blocks->scalar_count; i++)
        has &= plain_type(blocks->scalars[i].variable->type) != NULL;
    return has;
}

loop_piece frame_parts(loop_text *loop, int blocks) {
    const fixed_blocks *facts = loop->facts->variables.blocks;
    const uint32_t at = loop->facts->function->body->range.begin + 1;
    writer out = {0};
    buffer_text(&out.out, "\n#ifdef REDCC_RUNTIME_H\n");
    writer_line(&out, "REDCC_QUIET_BEGIN");
    writer_line(&out, "struct {");
    for (unsigned i = 0; i < facts->scalar_count; i++)
        writer_line(&out, "    %s redcc__%u;", plain_type(facts->scalars[i].variable->type), i);
    writer_line(&out, "} redcc__parts_%u[%d];", number_of(loop), blocks);
    writer_line(&out, "redcc_int redcc__ended_%u = 0;", number_of(loop));
    writer_line(&out, "REDCC_QUIET_END");
    buffer_format(&out.out, "#endif\n%s\n%s", loop_line_directive(loop, at - 1),
                  loop_column_blanks(loop, at));
    check_macro_names(loop, &out.out);
    return (loop_piece){writer_text(loop->arena, &out), {at, at}};
}

void write_team_parts(loop_text *loop, writer *out, int blocks) {
    const fixed_blocks *facts = loop->facts->variables.blocks;
    if (has_frame_parts(loop)) {
        writer_line(out, "__typeof__(redcc__parts_%u[0]) *const redcc__parts = redcc__parts_%u;",
                    number_of(loop), number_of(loop));
        writer_line(out, "redcc_int *const redcc__all_ended = &redcc__ended_%u, redcc__mine = 0;",
                    number_of(loop));
        return;
    }
    writer_line(out, "struct {");
    for (unsigned i = 0; i < facts->scalar_count; i++)
        writer_line(out, "    __typeof__(%s) redcc__%u;",
                    origin_variable(loop->arena, facts->scalars[i].variable), i);
    writer_line(out, "} redcc__own[%d], *redcc__parts;", blocks);
    writer_line(out, "redcc_int redcc__ended = 0, *redcc__all_ended, redcc__mine = 0;");
}

void write_team_begin(const loop_text *loop, writer *out) {
    if (!has_frame_parts(loop))
        buffer_text(&out->out,
                    "#pragma omp single copyprivate(redcc__parts, redcc__all_ended)\n"
                    "    redcc__parts = redcc__own, redcc__all_ended = &redcc__ended;\n");
    else if (loop->facts->variables.blocks->team.may_be_early)
        buffer_text(&out->out, "#pragma omp barrier\n");
}
