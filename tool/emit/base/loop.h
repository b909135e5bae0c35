/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * One loop being written: what the parts of its text (trip count, inspector, bodies) share.
 *
 * Where something cannot be written, the part records an obstacle and goes on; the text is then
 * thrown away as a whole.
 */
#ifndef EMIT_BASE_LOOP_H
#define EMIT_BASE_LOOP_H

#include "emit/text/text.h"
#include "plan/plan.h"
#include "support/vector.h"

/** How a reduction array is called in the generated text. */
typedef struct array_text {
    const char *base;  /* the user's own expression: `b`, `s->b` */
    const char *local; /* what stands for it in the executor: the same name (a shadow), or another
                          that replaces the user's bytes; NULL, as is base: nothing does, of an
                          array whose elements are scattered */
    const char *declarator; /* the same, where it is declared */
    const char *owner;      /* the local that redcc_owns is asked with */
    bool is_shadowed;
} array_text;

/** A function for several iterations at once (lanes.c). */
typedef struct lanes_text {
    bool is_wanted;
    const char *name; /* NULL: there is none */
    const char *arguments;
    lanes_outcome *outcome; /* of the loop, whatever form it gets; NULL: not asked for */
} lanes_text;

/** Slice and body as functions of their own (outline.c). */
typedef struct outline_text {
    bool possible;                                /* cleared by what finds that it is not */
    bool *is_handed;                              /* by variable: slice or body get it */
    const char **by_address;                      /* by variable: what is written for its name */
    const char *text;                             /* of both, and of what each thread does last */
    const char *slice_call, *body_call;           /* of iteration redcc__k */
    const char *body_parameters, *body_arguments; /* ", ..." but for the counter */
} outline_text;

typedef struct loop_text {
    arena *arena;
    const ir_unit *whole; /* with all that the file holds; */
    const ir_unit *unit;  /* without what its loops leave out (as_compiled.h) */
    const loop_facts *facts;
    const loop_plan *plan;
    const plan_options *options;
    const char *obstacle; /* the first; NULL: none so far */
    ir_range obstacle_range;

    const array_text *arrays; /* indexed as facts->arrays */
    const char *counter_type; /* as it is spelled in a declaration or cast of the counter */

    bool is_unfused; /* contraction is turned off in its functions and its block */
    outline_text outline;
    const struct bins_plan *bins; /* of the plan, where it is written in that form; or NULL */
    lanes_text lanes;
} loop_text;

/** Records why this loop cannot be written, unless there is a reason already. */
void loop_obstacle(loop_text *loop, ir_range range, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
/** text_operand that records an obstacle, and then gives "0". */
const char *loop_operand(loop_text *loop, const ir_node *expression);
/** `#line N "file"` for the user's text at `offset`. */
const char *loop_line_directive(loop_text *loop, uint32_t offset);
/** Blanks (and tabs) as wide as what stands before `offset` on its line: what follows them keeps
 * its column. */
const char *loop_column_blanks(loop_text *loop, uint32_t offset);
/** The counter's step as text: "2", "redcc__stride". */
const char *loop_step(loop_text *loop);

/** The counter's value in iteration redcc__k: "REDCC_COUNTER(int, 2 * redcc__k)". */
const char *loop_counter_value(loop_text *loop);

#endif
