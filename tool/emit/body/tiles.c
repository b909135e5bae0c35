/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Clips the loop over columns to a tile (plan/tiles.h). */
#include "plan/tiles.h"

#include <assert.h>

#include "emit/body/copy.h"
#include "emit/body/tile_rows.h"
#include "emit/text/origin.h"
#include "ir/ir_syntax.h"

bool is_clipped(const loop_text *loop, const ir_node *node) {
    return loop->tiles && (node == loop->tiles->lower || node == loop->tiles->bound);
}

/** Encloses the statements after the node, in its block, in a condition, so that only the last tile
 * of a row executes them. */
static void finish_rows(body_copy *copy, const ir_node *node) {
    loop_text *loop = copy->loop;
    const ir_node *block = node->parent, *last = block->children[block->child_count - 1];
    if (last == node)
        return;
    unsigned next = 1;
    while (block->children[next - 1] != node)
        next++;
    const ir_node *first = block->children[next];
    if (syntax_editable_statement(first, loop->facts->counted.body) != first ||
        syntax_editable_statement(last, loop->facts->counted.body) != last) {
        loop_obstacle(loop, first->range, "the end of a row cannot be enclosed");
        return;
    }
    edit_insert(loop->arena, &copy->edits, first->range.begin, "if (redcc__tile->is_last) { ");
    edit_insert(loop->arena, &copy->edits, syntax_statement_end(loop->unit->source, last), " }");
}

void clip_columns(body_copy *copy) {
    loop_text *loop = copy->loop;
    const tile_plan *tiles = loop->tiles;
    if (!tiles)
        return;
    assert(!tiles->declined && tiles->lower && tiles->bound);
    const ir_node *const inner = tiles->inner;
    const char *type = origin_type(loop->arena, tiles->column->type);
    const char *lower = text_operand(loop->arena, tiles->lower, local_name, loop);
    const char *bound = text_operand(loop->arena, tiles->bound, local_name, loop);
    if (!type || !lower || !bound || is_printed(copy, inner) ||
        syntax_editable_statement(inner, loop->facts->counted.body) != inner) {
        loop_obstacle(loop, inner->range, "the loop over columns cannot be clipped");
        return;
    }
    edit_insert(loop->arena, &copy->edits, inner->range.begin,
                arena_format(loop->arena,
                             "{ const %s redcc__column = REDCC_TILE_FROM(%s, %s), "
                             "redcc__column_end = REDCC_TILE_%s(%s, %s); %s",
                             type, type, macro_argument(loop->arena, lower),
                             tiles->is_inclusive ? "UP_TO" : "TO", type,
                             macro_argument(loop->arena, bound), take_tile_row(loop)));
    replace_bytes(copy, tiles->lower->range.begin, tiles->lower->range.end, "redcc__column");
    replace_bytes(copy, tiles->bound->range.begin, tiles->bound->range.end, "redcc__column_end");
    for (const ir_node *node = inner; node != loop->facts->counted.body; node = node->parent)
        finish_rows(copy, node);
}

void leave_columns(body_copy *copy) {
    loop_text *loop = copy->loop;
    if (loop->tiles)
        edit_insert(loop->arena, &copy->edits,
                    syntax_statement_end(loop->unit->source, loop->tiles->inner),
                    arena_format(loop->arena, " %s}", keep_tile_row(loop)));
}
