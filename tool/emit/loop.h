/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * One loop being written: what the parts of its text (trip count, inspector, bodies) share.
 *
 * Where something cannot be written, the part records an obstacle and goes on; the text is then
 * thrown away as a whole.
 */
#ifndef EMIT_LOOP_H
#define EMIT_LOOP_H

#include "analysis/overlap/row_address.h"
#include "emit/emit.h"
#include "emit/text.h"
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

/** A source as the runtime is told of it: one or more of the facts' that move together. */
typedef struct source_text {
    const loop_source *fact; /* the first of them */
    bool is_subscript;
} source_text;

enum { SOURCE_NOT_TOLD = -1 };

/** A function for several iterations at once (lanes.c). */
typedef struct lanes_text {
    bool is_wanted;
    const char *name; /* NULL: there is none */
    const char *arguments;
    lanes_outcome *outcome; /* of the loop, whatever form it gets; NULL: not asked for */
} lanes_text;

/** Slice and body as functions of their own (outline.c). */
typedef struct outline_text {
    bool done;
    bool possible;                                /* cleared by what finds that it is not */
    const char *slice_call, *body_call;           /* of iteration redcc__k */
    const char *body_parameters, *body_arguments; /* ", ..." but for the counter */
} outline_text;

/** Whether all iterations are told in order before they are inspected (dry_run.c). */
typedef enum dry_run {
    DRY_RUN_NONE,
    DRY_RUN_OF_UPDATES, /* what must not be updated meanwhile is known before */
    DRY_RUN_OF_ALL      /* or it is told as the iterations read it */
} dry_run;

/* What its executor prefetches (prefetch.c). */
typedef struct prefetch_text {
    unsigned ahead; /* iterations; 0: nothing */
    bool is_light;  /* an iteration; then only where they come in no order */
} prefetch_text;

typedef struct loop_text {
    arena *arena;
    const ir_unit *whole; /* with all that the file holds; */
    const ir_unit *unit;  /* without what its loops leave out (as_compiled.h) */
    const loop_facts *facts;
    const emit_options *options;
    const char *obstacle; /* the first; NULL: none so far */
    ir_range obstacle_range;

    const array_text *arrays; /* indexed as facts->arrays */
    unsigned source_count;
    const source_text *sources;
    const int *source_number; /* of each of the facts' sources: index into sources */
    const char *counter_type; /* as it is spelled in a declaration or cast of the counter */

    bool is_unfused; /* contraction is turned off in its functions and its block */
    outline_text outline;
    struct bins_text *bins; /* bins.c: its form for binning; NULL: it has none */
    lanes_text lanes;
    prefetch_text prefetch;
    dry_run dry_run;
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
/** The array whose base this node says, or -1. */
int loop_array_of_base(const loop_text *loop, const ir_node *node);
/** The first update that this statement makes, or NULL. */
const reduction_update *loop_update_at(const loop_facts *facts, const ir_node *statement);

/** setup.c: fills arrays, sources and counter_type, and records what forbids writing the loop. */
void prepare_loop(loop_text *loop);

/** hoist.c: records an obstacle where something that must be evaluated before the first iteration
 *  is not certain to be evaluated by the loop itself. */
void check_what_is_read_ahead(loop_text *loop);
/** Is this pointer or array valid as soon as the loop is known to iterate? */
bool can_be_read_ahead(const loop_facts *facts, const ir_node *base);

/** distribution.c: after the loop, where it has run in parallel, the stores that are made then. */
void write_distributed_stores(loop_text *loop, writer *out);

/** scalars.c: room for the operands that each iteration keeps of scalar updates; whether there was
 *  memory for it, as a condition (NULL: there are no such updates); */
void declare_operands(loop_text *loop, writer *out);
const char *operands_are_there(loop_text *loop);
/** in an iteration, variables for what is put together, that no update was executed yet of those
 *  that may not be, and what number `number` does; */
void declare_repeated_operands(loop_text *loop, writer *out);
void note_no_operands(loop_text *loop, writer *out);
void write_operand(loop_text *loop, writer *out, unsigned number, const char *value);
/** after the loop, the updates themselves. */
void apply_operands(loop_text *loop, writer *out);
/** The number of the scalar update that is this statement, or -1. */
int scalar_update_at(const loop_facts *facts, const ir_node *statement);

/** forward.c: variables for what an iteration stores and reads again, of the slice only or all; */
void declare_forwards(loop_text *loop, writer *out, bool of_slice);
/** the variable that this node is to be read from, or NULL; */
const char *forward_read_name(const loop_text *loop, const ir_node *node);
/** the stored value that this statement makes, or NULL; its assignment to the variable, and from
 *  there to the element, which is a statement of its own. */
const forwarded_store *forward_stored_by(const loop_facts *facts, const ir_node *statement);
void write_forward(loop_text *loop, writer *out, const forwarded_store *store, ir_c_rename rename,
                   void *context);
void write_forwarded_store(loop_text *loop, writer *out, const forwarded_store *store,
                           ir_c_rename rename, void *context);

/** unroll.c: what stands in front of a `for` of few iterations, which the compiler is to unroll, in
 * text that computes; of others "". */
const char *unrolled_computation(const ir_node *loop);
/** The same around updates of lanes, which their text for guarded iterations leaves rolled. */
const char *unrolled_lane_updates(const ir_node *loop);
/** The same in the body for one iteration. */
const char *unrolled_in_body(const ir_node *loop);
/** May that stand in front of a `for` of the user's text? Not beside a pragma, attribute or label.
 */
bool takes_pragma(const loop_text *loop, const ir_node *node);
/** trip.c: declares redcc__lower, redcc__bound, redcc__trip and redcc__final. Returns what else
 * must hold for the parallel form to be entered ("redcc__trip > 0 && ..."). */
const char *write_trip_count(loop_text *loop, writer *out);

/** describe.c: the static objects that describe the loop; the key of one execution. */
void write_description(loop_text *loop, writer *out);
/** May the runtime update private copies of the array? They hold elements side by side, so not
 * where other things lie between them; nor where updates of copies could not be brought together.
 */
bool may_be_copied(const loop_text *loop, const reduction_array *array);
unsigned key_length(const loop_text *loop);
void fill_key(loop_text *loop, writer *out);

/** extents.c: redcc__known, for the sources whose place is known before the inspection; */
bool has_affine_extents(const loop_text *loop);
void declare_extents(loop_text *loop, writer *out);
void fill_extents(loop_text *loop, writer *out);
/** what must hold of them for the parallel form to be entered, or NULL. */
const char *extents_are_known(const loop_text *loop);

/** unconditional.c: texts that may be evaluated where the program does not come to them. Does the
 *  inspector come to this statement where the program may not? */
bool is_bare(const loop_facts *facts, const ir_node *statement);
/** A signed sum, product or shift as one that wraps around: a primary expression. NULL: the node is
 *  none of these. A rename and its context as ir_c_expression takes them. */
const char *wrapping_operation(arena *a, const ir_node *node, ir_c_rename rename, void *context);
/** Does it begin with & of an object? An array needs none, nor a pointer in its place. */
bool needs_address(const row_address *address);
/** The address as a number, redcc_size. `counter`: one of its subscripts steps with it (spans), and
 *  is computed in 64 bits, as if its type were as wide; or NULL. NULL: cannot be spelled. */
const char *address_number(arena *a, const row_address *address, const ir_variable *counter,
                           ir_c_rename rename, void *context);

/** outline.c: slice and body as functions, to be inserted at *place, and sets is_outlined and the
 *  calls; NULL: the loop is to be written in place. */
const char *write_outlined(loop_text *loop, uint32_t *place);
/** The name of something in front of the function: "redcc__slice_springs_15". */
const char *outlined_name(loop_text *loop, const char *part);
/** The declaration of a private variable in one of these functions. */
const char *outlined_declaration(loop_text *loop, const ir_variable *variable);
/** setup.c: may a pointer stand for this array in the body? */
bool can_be_pointer(const loop_text *loop, const ir_variable *variable);
/** Is a macro used in the body? */
bool has_macro(const loop_text *loop);
/** loop.c: the #if around what is there only where the loop may run in parallel; behind what
 *  begin_as_compiled writes. */
const char *loop_condition(const loop_text *loop);
/** as_compiled.c: before text that is made of the branches in the loop that this compilation takes,
 *  and after it: they define a word where it takes the same. Nothing, of loops without branches. */
void begin_as_compiled(loop_text *loop, buffer *out);
void end_as_compiled(const loop_text *loop, buffer *out);
bool has_branches(const loop_text *loop);

/** bins.c: sets loop->bins, where updates can be taken apart and be made later; */
void find_bins(loop_text *loop);
/** what goes before an update whose element has this address; */
const char *bins_update(loop_text *loop, const reduction_update *update, const char *address);
/** bins_text.c: what goes in front of a loop over constants, to append what it adds; NULL: nothing.
 */
const char *bins_appends(loop_text *loop, const ir_node *statement, ir_c_rename name);
/** bins_text.c: what applies records; the streams, and how many; the arguments of
 *  REDCC_PARALLEL_BINNED that say so. */
void write_bins(loop_text *loop, writer *out);
void write_streams(loop_text *loop, writer *out);
unsigned bins_stream_count(const loop_text *loop);
const char *bins_phase(loop_text *loop);

/** dry_run.c: sets loop->dry_run, or records an obstacle where that would not do. */
void check_stale_slice(loop_text *loop);

/** stale.c: may the body be executed before what it reads is compared with what it writes? */
bool is_harmless_when_stale(loop_text *loop);

/** turns.c: what asks, in the body of an inner loop and in front of statement *before, whether any
 *  row that the rest of the turn updates is the thread's: if not, it goes on to the next turn.
 *  NULL: nothing is to be left out so. */
const char *turn_question(loop_text *loop, const ir_node *inner, ir_c_rename name,
                          const ir_node **before);

/** prefetch.c: can the executor prefetch what iterations to come touch, once the loop is outlined?
 *  loop->prefetch says it then. */
prefetch_text prefetch_of(const loop_text *loop);
/** At the end of the slice: rows that an iteration reads and the inspector is not told. Only
 *  variables that the slice mentions are used; sets is_mentioned of the rows' bases. */
void write_gathers(loop_text *loop, writer *out, bool *is_mentioned);

/** lanes.c: may the loop have a form for several iterations at once, as far as it is known before
 *  its body is written? Sets the outcome. */
bool may_have_lanes(const loop_text *loop);
/** The function that executes several iterations at once, where it is asked for and the body can be
 *  written so; sets loop->lanes and the outcome. */
void write_lanes(loop_text *loop, writer *out);
/** outline.c: is it the iteration's own, or declared in the body? */
bool is_declared_in(const loop_facts *facts, const ir_variable *variable);
/** outline.c: what the name of that function ends with. */
const char *loop_lanes_name(loop_text *loop);

/** region.c: `#pragma omp parallel` and what stands in it. */
void write_region(loop_text *loop, writer *out);
/** Has each thread a copy of its own? */
bool is_copied_in(const ir_variable *variable);
/** Copies of thread-local scalars: before the region, or in it, under their own names. */
void write_thread_local_copies(loop_text *loop, writer *out, bool in_region);
/** Is the counter another variable than the loop's own, with a value after it that is wanted? */
bool counter_outlives(const loop_facts *facts);
bool has_last_values(const loop_facts *facts);
void declare_last_values(loop_text *loop, writer *out);
/** Stores the last values, of the thread that has them; or from there into the user's variables. */
void write_last_values(loop_text *loop, writer *out, bool into_variables);

/** lasting.c: private variables assigned in some iterations only, whose last value is wanted; what
 *  notes the value and when it was assigned, of all threads or of one in the region; */
bool has_sought_values(const loop_facts *facts);
void declare_sought_values(loop_text *loop, writer *out, bool in_region);
/** the number of the private variable that this statement assigns so, or -1; the note after it; */
int sought_value_of(const loop_facts *facts, const ir_node *statement);
void write_note(loop_text *loop, writer *out, unsigned number);
/** the latest of all threads', at the end of the region; and from there to the variables. */
void gather_sought_values(loop_text *loop, writer *out);
void take_sought_values(loop_text *loop, writer *out);

/** step.c: variables that each iteration moves by a constant: their values when the loop is
 *  entered, as redcc__from_N, those that the header gives them or the others'; what private
 * variable `number` begins an iteration with, " = ..."; their values after the loop. */
void declare_entry_values(loop_text *loop, writer *out, bool by_header);
const char *stepped_value(loop_text *loop, unsigned number);
void write_stepped_values(loop_text *loop, writer *out);

/** inspector.c: the statements of one iteration, counter and private variables declared: they tell
 *  its addresses, or probe them and leave the loop around them where they must be told. */
void write_inspected_iteration(loop_text *loop, writer *out, bool probes);
/** inspector.c: the inner loop, where the slice tells its rows at once; or NULL. */
const loop_span *span_of(const loop_facts *facts, const ir_node *loop);
/** The same by the macros of loop.h, which do either; sets is_mentioned for each variable, by its
 *  number, that is named. */
void write_slice_statements(loop_text *loop, writer *out, bool *is_mentioned);

/** source_loops.c: in the inspector, the name of the counter number `depth` of a source's loops, */
const char *source_loop_counter(arena *a, unsigned depth);
/** and the head of the loop, after which a block follows: `if` where one turn tells all of it. */
const char *source_loop_header(arena *a, const loop_source *read, unsigned depth,
                               const char *counter, const char *bound, bool is_span);

/** inline.c: keeps inlined what the compiler inlines in the sequential program because it is called
 *  at one place only. */
void declare_inlined(loop_text *loop, writer *out);

/** body.c: the user's body for one iteration, with the counter and private variables declared. */
void write_iteration(loop_text *loop, writer *out);
/** The declaration of a private variable, of an iteration or of its slice. */
const char *private_declaration(loop_text *loop, const ir_variable *variable);
bool body_reads(const loop_facts *facts, const ir_variable *variable);
/** The increment at the end of a while or do loop's body, which is the executor's own: copies of
 * the body do not have it. NULL: there is none. */
const ir_node *body_increment(const loop_facts *facts);

/** macro_names.c: the name of a macro of the program that is used in the text; NULL: there is none.
 */
const char *macro_name_in(arena *a, const ir_unit *unit, const char *text, size_t length);
/** The name of a macro, defined before the program's file begins, that the head of the written file
 *  uses (the runtime's header, pragmas); NULL: there is none. */
const char *macro_name_in_head(const ir_unit *unit);
/** A name of the runtime's, or of OpenMP's, that is written into the text and that the program
 * gives to something of its own; NULL: there is none. */
const char *taken_name(const ir_unit *unit);
/** Would a macro of the program change what the macros of the runtime's header say? */
bool has_macro_of_header_words(const loop_text *loop);
/** Records an obstacle where a macro would change the text written, the user's own apart. */
void check_macro_names(loop_text *loop, const buffer *written);

/** A text that replaces bytes of the file, with marks (origin.h). */
typedef struct loop_piece {
    const char *text; /* NULL: there is none */
    ir_range replaced;
} loop_piece;

/** With slice and body in front of the function: with a body for several iterations at once as
 * well, with a form for bins, with neither; and in place. Each is tried where the one before is not
 *  possible. */
typedef enum loop_form { FORM_LANES, FORM_BINNED, FORM_SHORT, FORM_IN_PLACE } loop_form;

/** loop.c: the block of a loop of which arena, unit, facts, options and is_unfused are set, and
 * what goes in front of the function (in place: nothing does); sets *form to what was possible.
 * False, with the obstacle in *why: it cannot be written. */
bool write_loop(loop_text loop, loop_form *form, loop_piece *front, loop_piece *block, reason *why);

#endif
