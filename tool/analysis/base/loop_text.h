/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Which bytes of the file are a loop's, and the preprocessing directives among them. */
#ifndef ANALYSIS_LOOP_TEXT_H
#define ANALYSIS_LOOP_TEXT_H

#include "ir/ir.h"

/**
 * Where the loop's text begins: with the pragmas that stand directly above it, and with groups of
 * conditional directives (#if to #endif) there of which nothing is compiled but pragmas. They are
 * meant for the loop, in this compilation or in another. What macros stand for is not among them.
 */
uint32_t loop_text_begin(const ir_unit *unit, const ir_node *loop);

/** Index of the unit's first directive that begins at `offset` or behind it. */
unsigned loop_text_first_directive(const ir_unit *unit, uint32_t offset);

/**
 * A directive in the loop's text by which it is no statement of its own in each compilation of the
 * file, or which only one copy of the text can have; or NULL. Conditional directives are none as
 * long as their groups are complete, and neither are pragmas that are not compiled, stand above the
 * loop, or are about the speed of loops inside.
 */
const ir_directive *loop_text_obstacle(const ir_unit *unit, const ir_node *loop);

/** A name in the main file's text of this range by which a macro may make a pragma; NULL: none. */
const char *text_pragma_macro(arena *a, const ir_unit *unit, ir_range range);

/** The first OpenMP directive in the function's text that is compiled, or the macro that may make
 * one; NULL: none. In the arena or the unit. */
const char *text_openmp_in(arena *a, const ir_unit *unit, const ir_function *function);

/** Are there conditional directives in the loop's text? */
bool loop_text_has_branches(const ir_unit *unit, const ir_node *loop);

/** May a copy of the text it stands in do without it, and without what it leaves out? So it is with
 *  conditional directives once they are decided, and with pragmas that are not compiled or by which
 *  a loop is only faster; with OpenMP's where they are asleep, which they are without -fopenmp. */
bool directive_can_be_left_out(const ir_unit *unit, const ir_directive *d);

/** Is it an OpenMP directive, and this compilation one without OpenMP, which passes over it? */
bool directive_is_asleep(const ir_unit *unit, const ir_directive *d);

/** An OpenMP directive that stands directly above the loop, others between, and that is compiled or
 *  no part of the loop's text; NULL: none. */
const ir_directive *loop_text_openmp_above(const ir_unit *unit, const ir_node *loop);

/** Do OpenMP directives stand in the loop's text or directly above it? Where another compilation
 * has OpenMP and this one has not, or the reverse, the loop is as it was written. */
bool loop_text_depends_on_openmp(const ir_unit *unit, const ir_node *loop);

/** #pragma omp, or #ifdef _OPENMP. */
bool directive_is_openmp(const ir_directive *d);

static inline bool directive_is_conditional(const ir_directive *d) {
    return d->kind == IR_DIRECTIVE_IF || d->kind == IR_DIRECTIVE_ELSE ||
           d->kind == IR_DIRECTIVE_ENDIF;
}

#endif
