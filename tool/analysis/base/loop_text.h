/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Finds the bytes of the file that belong to a loop, and the preprocessing directives among
 *  them. */
#ifndef ANALYSIS_LOOP_TEXT_H
#define ANALYSIS_LOOP_TEXT_H

#include "ir/ir.h"

/** The beginning of the loop's text. It includes the pragmas directly above the loop, and groups
 *  from #if to #endif there that compile nothing but pragmas, because these apply to the loop in
 *  this or another compilation. Pragmas that macros produce, and OpenMP directives that apply to no
 *  statement (such as `omp barrier`), are not included. */
uint32_t loop_text_begin(const ir_unit *unit, const ir_node *loop);

/** Index of the unit's first directive at or after `offset`. */
unsigned loop_text_first_directive(const ir_unit *unit, uint32_t offset);

/** Does a directive that begins in the range contain the word? Directives that are not compiled
 *  count too, and so do definitions of macros. */
bool directives_name(const ir_unit *unit, ir_range range, const char *word);

/** Does any directive of the main file, or any pragma in the program's headers, contain the
 *  word? */
bool file_names(const ir_unit *unit, const char *word);

/** The end of directive `number`, or of the text after it up to the next directive if that text is
 *  not compiled. */
uint32_t loop_text_end_of_branch(const ir_unit *unit, unsigned number);

/** A directive that keeps the loop's text from being a single statement in every compilation of the
 *  file, or from being copied. NULL if there is none. Permitted are complete groups of conditional
 *  directives, and pragmas that are not compiled, precede the loop, or only affect the speed of
 *  inner loops. */
const ir_directive *loop_text_obstacle(const ir_unit *unit, const ir_node *loop);

/** The first name in this range of the main file that is a macro which may expand to a pragma. "\\"
 *  if a name is split over two lines; NULL if neither occurs. */
const char *text_pragma_macro(arena *a, const ir_unit *unit, ir_range range);

/** The first compiled OpenMP directive in the function's text, or a macro that may expand to one;
 *  NULL if there is none. */
const char *text_openmp_in(arena *a, const ir_unit *unit, const ir_function *function);

/** Are there conditional directives in the loop's text? */
bool loop_text_has_branches(const ir_unit *unit, const ir_node *loop);

/** May a copy of the text omit the directive? True for conditional directives: a copy has only the
 *  compiled branches, so it omits the text that they exclude, too. Also true for pragmas that are
 *  not compiled (except push_macro and pop_macro), pragmas that only make a loop faster, and OpenMP
 *  pragmas that the compiler ignores or redcc replaces. */
bool directive_can_be_left_out(const ir_unit *unit, const ir_directive *d);

/** Is it an OpenMP pragma in a compilation without OpenMP, which ignores it? */
bool directive_is_ignored_openmp(const ir_unit *unit, const ir_directive *d);

/** The nearest OpenMP directive above the loop, with nothing but directives and skipped text
 *  between. It must be compiled, or be outside of the loop's text. NULL if there is none. */
const ir_directive *loop_text_openmp_above(const ir_unit *unit, const ir_node *loop);

/** For a compilation without OpenMP: does the function's text contain OpenMP directives, or does
 *  the file contain an OpenMP directive that would make variables thread-local? False in a
 *  compilation with OpenMP. */
bool function_has_ignored_openmp(const ir_unit *unit, const ir_function *function);

/** Does the loop's translation depend on whether OpenMP is enabled? If so, a compilation in which
 *  this differs must use the original loop. */
bool loop_text_depends_on_openmp(const ir_unit *unit, const ir_function *function,
                                 const ir_node *loop);

/** Does the directive contain an OpenMP pragma, or test _OPENMP? */
bool directive_is_openmp(const ir_directive *d);

static inline bool directive_is_conditional(const ir_directive *d) {
    return d->kind == IR_DIRECTIVE_IF || d->kind == IR_DIRECTIVE_ELSE ||
           d->kind == IR_DIRECTIVE_ENDIF;
}

#endif
