/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "emit/body/tile_rows.h"

#include "emit/base/names.h"
#include "emit/text/origin.h"
#include "plan/tiles.h"

bool has_tile_rows(const loop_text *loop) {
    const tile_plan *tiles = tiles_of(loop->plan);
    return tiles && tiles->kept_count > 0;
}

static const char *value_name(loop_text *loop, unsigned number) {
    return arena_format(loop->arena, "redcc__value_%u", number);
}

void declare_tile_row(loop_text *loop, writer *out) {
    const tile_plan *tiles = tiles_of(loop->plan);
    if (!has_tile_rows(loop))
        return;
    writer_line(out, "struct %s {", outlined_name(loop, "row"));
    for (unsigned i = 0; i < tiles->kept_count; i++)
        writer_line(out, "    %s;",
                    declaration_text(loop, tiles->kept[i].variable->type, value_name(loop, i)));
    writer_line(out, "};");
}

void declare_tile_rows(loop_text *loop, writer *out) {
    if (loop->outline.tile_call && has_tile_rows(loop))
        writer_line(out, "struct %s redcc__of_thread_rows[REDCC_TILE_ROWS];",
                    outlined_name(loop, "row"));
}

extra_value tile_rows_value(loop_text *loop) {
    return (extra_value){
        "redcc__rows",
        arena_format(loop->arena, "struct %s *const redcc__rows", outlined_name(loop, "row")), NULL,
        "redcc__of_thread_rows"};
}

/** Statements that copy all variables to the row's storage (is_kept), or back from it. */
static const char *copies(loop_text *loop, bool is_kept) {
    const tile_plan *tiles = loop->tiles;
    buffer text = {0};
    for (unsigned i = 0; i < tiles->kept_count; i++) {
        const char *name = origin_variable(loop->arena, tiles->kept[i].variable);
        const char *value = arena_format(loop->arena, "redcc__rows[redcc__k - redcc__tile->row].%s",
                                         value_name(loop, i));
        const char *to = is_kept ? value : name, *from = is_kept ? name : value;
        if (tiles->kept[i].variable->type->kind == IR_ARRAY)
            buffer_format(&text, "__builtin_memcpy(%s, %s, sizeof(%s)); ", to, from, to);
        else
            buffer_format(&text, "%s = %s; ", to, from);
    }
    return buffer_take(loop->arena, &text);
}

/** Returns statements that set variables without a value to 0. Without these statements compilers
 *  would warn when the variables are copied. */
static const char *first_values(loop_text *loop) {
    buffer text = {0};
    for (unsigned i = 0; i < loop->tiles->kept_count; i++)
        if (loop->tiles->kept[i].is_unset) {
            const char *name = origin_variable(loop->arena, loop->tiles->kept[i].variable);
            buffer_format(&text, "__builtin_memset(&%s, 0, sizeof(%s)); ", name, name);
        }
    return buffer_take(loop->arena, &text);
}

const char *take_tile_row(loop_text *loop) {
    if (loop->tiles->kept_count == 0)
        return "";
    const char *first = first_values(loop);
    return arena_format(loop->arena, "if (!redcc__tile->is_first) { %s} %s%s%s",
                        copies(loop, false), *first ? "else { " : "", first, *first ? "} " : "");
}

const char *keep_tile_row(loop_text *loop) {
    return loop->tiles->kept_count == 0 ? "" : copies(loop, true);
}
