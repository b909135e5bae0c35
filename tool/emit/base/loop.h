/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * One loop being written: data shared by the parts of its text (trip count, inspector, bodies).
 *
 * A part that cannot be written records an obstacle and continues; the whole text is then
 * discarded.
 */
#ifndef EMIT_BASE_LOOP_H
#define EMIT_BASE_LOOP_H

#include "emit/text/text.h"
#include "plan/plan.h"
#include "support/vector.h"

/** The names of a reduction array in the generated text. */
typedef struct array_text {
    const char *base;  /* the user's own expression: `b`, `s->b` */
    const char *local; /* the array's name in the executor: the user's name, if a pointer of that
                        * name shadows the array (is_shadowed); otherwise another name, which
                        * replaces the user's bytes. `base` and `local` are NULL if the rows are
                        * scattered, that is, reached through pointers in memory */
    const char *declarator; /* `local`, marked as a declarator (origin.h) */
    bool is_shadowed;
} array_text;

/** A function for several iterations at once, called lanes (emit/lanes/lanes.c). */
typedef struct lanes_text {
    bool is_wanted;   /* the loop is being written with such a function */
    const char *name; /* NULL: none */
    const char *arguments;
    lanes_outcome *outcome; /* set to whether the loop has lanes; NULL: not requested */
} lanes_text;

/** Slice and body as separate functions (outline.c). */
typedef struct outline_text {
    bool possible;           /* cleared when an obstacle is found */
    bool *is_passed;         /* indexed by variable: is it passed to slice or body? */
    const char **by_address; /* indexed by variable: the text that replaces its name, or NULL */
    const char *text;        /* the texts of slice, body and each thread's last
                              * statements, joined; the context must pass the values
                              * that they name */
    const char *slice_call, *body_call; /* the calls for iteration redcc__k */
    const char *reads_call; /* call that replaces slice_call while records are appended (bins), or
                             * NULL */
    const char *tile_call;  /* call for the inner iterations of a row in a tile, or NULL */
    const char *body_parameters, *body_arguments; /* lists of the body's parameters and arguments,
                                                   * without the counter; each begins with a
                                                   * comma */
} outline_text;

typedef struct loop_text {
    arena *arena;
    const ir_unit *whole; /* all code of the file */
    const ir_unit *unit;  /* the file without the skipped branches in its loops (as_compiled.h) */
    const loop_facts *facts;
    const loop_plan *plan;
    const plan_options *options;
    const char *obstacle; /* the first reason why the loop cannot be written; NULL: none so far */
    ir_range obstacle_range;

    const array_text *arrays; /* same indices as facts->arrays */
    const char *counter_type; /* the spelling of the counter's type, for a declaration or a cast */

    bool continues;  /* the original loop may continue at an iteration that leaves it, after
                      * redcc__made iterations were executed (plan/continuation.h) */
    bool is_unfused; /* contraction is turned off in the loop's functions and its block */
    outline_text outline;
    const struct bins_plan *bins; /* plan->bins if the form for bins is being written; otherwise
                                   * NULL */
    lanes_text lanes;
    const struct tile_plan *tiles; /* non-NULL only while the body for tiles is written */
} loop_text;

/** Records the reason why this loop cannot be written, unless there is one already. */
void loop_obstacle(loop_text *loop, ir_range range, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
/** As text_operand; if the expression cannot be spelled, records an obstacle and returns "0". */
const char *loop_operand(loop_text *loop, const ir_node *expression);
/** `#line N "file"` for the user's text at `offset`. */
const char *loop_line_directive(loop_text *loop, uint32_t offset);
/** Blanks (and tabs) as wide as the text before `offset` on its line, so that the following text
 *  keeps its column, if it is before column 50. */
const char *loop_column_blanks(loop_text *loop, uint32_t offset);
/** The counter's step as text: "2", "redcc__stride". */
const char *loop_step(loop_text *loop);

/** The number of iterations that were executed in parallel: "redcc__trip", or "redcc__made". */
const char *loop_made(const loop_text *loop);
/** The counter's value in iteration redcc__k: "REDCC_COUNTER(int, 2 * redcc__k)". */
const char *loop_counter_value(loop_text *loop);

#endif
