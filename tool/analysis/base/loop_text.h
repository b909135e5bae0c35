/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The bytes of the file that belong to a loop, and the preprocessing directives among them. */
#ifndef ANALYSIS_LOOP_TEXT_H
#define ANALYSIS_LOOP_TEXT_H

#include "ir/ir.h"

/**
 * The beginning of the loop's text, with the pragmas directly above it, and groups of conditional
 * directives (#if to #endif) there that compile nothing but pragmas: they apply to the loop, in
 * this compilation or another. Excluded are pragmas made by macros, and `omp barrier`.
 */
uint32_t loop_text_begin(const ir_unit *unit, const ir_node *loop);

/** Index of the unit's first directive at or after `offset`. */
unsigned loop_text_first_directive(const ir_unit *unit, uint32_t offset);

/** Does a directive that begins in the range have the word in its text? Directives that are not
 *  compiled count as well, and so do definitions of macros. */
bool directives_name(const ir_unit *unit, ir_range range, const char *word);

/** The same of the whole file, and of the pragmas in its headers. */
bool file_names(const ir_unit *unit, const char *word);

/** The end of the directive with this number and of the text that it excludes, up to the next. */
uint32_t loop_text_end_of_branch(const ir_unit *unit, unsigned number);

/**
 * A directive in the loop's text that prevents it from being one statement in each compilation of
 * the file, or that only one copy of the text can have; or NULL. Permitted are conditional
 * directives in complete groups, and pragmas that are not compiled, precede the loop, or concern
 * only the speed of inner loops.
 */
const ir_directive *loop_text_obstacle(const ir_unit *unit, const ir_node *loop);

/** A name in this range of the main file that a macro may expand to a pragma, or "\\" if a name is
 *  split over two lines; NULL: none. */
const char *text_pragma_macro(arena *a, const ir_unit *unit, ir_range range);

/** The first compiled OpenMP directive in the function's text, or a macro that may make one; NULL:
 *  none. In the arena or the unit. */
const char *text_openmp_in(arena *a, const ir_unit *unit, const ir_function *function);

/** Are there conditional directives in the loop's text? */
bool loop_text_has_branches(const ir_unit *unit, const ir_node *loop);

/** May a copy of the text omit it, and the text that it excludes? True for conditional directives,
 *  once it is known which branch is compiled, and for pragmas that are not compiled or only make a
 *  loop faster; for OpenMP's if the compiler ignores them or redcc replaces them. */
bool directive_can_be_left_out(const ir_unit *unit, const ir_directive *d);

/** Is it an OpenMP directive in a compilation without OpenMP, which ignores it? */
bool directive_is_ignored_openmp(const ir_unit *unit, const ir_directive *d);

/** A preceding OpenMP directive of the loop, perhaps followed by others, that is compiled or is no
 *  part of the loop's text; NULL: none. */
const ir_directive *loop_text_openmp_above(const ir_unit *unit, const ir_node *loop);

/** In a compilation without OpenMP: does the function's text have OpenMP directives, or does the
 *  file have any that would make variables thread-local? */
bool function_has_ignored_openmp(const ir_unit *unit, const ir_function *function);

/** Does the loop's translation depend on whether a compilation uses OpenMP? If one differs from
 * this one in that, it compiles the original loop. */
bool loop_text_depends_on_openmp(const ir_unit *unit, const ir_function *function,
                                 const ir_node *loop);

/** Does its text contain an OpenMP pragma, or _OPENMP? */
bool directive_is_openmp(const ir_directive *d);

static inline bool directive_is_conditional(const ir_directive *d) {
    return d->kind == IR_DIRECTIVE_IF || d->kind == IR_DIRECTIVE_ELSE ||
           d->kind == IR_DIRECTIVE_ENDIF;
}

#endif
