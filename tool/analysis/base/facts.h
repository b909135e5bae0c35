/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Results of the analysis of a loop: facts, reasons, verdicts. All parts of the analysis and its
 * callers share these types.
 */
#ifndef ANALYSIS_FACTS_H
#define ANALYSIS_FACTS_H

#include "analysis/base/pragma.h"
#include "ir/ir.h"
#include "support/map.h"
#include "support/vector.h"

/* ---- reasons ------------------------------------------------------------------------------- */

/** reasons.def: X(IDENTIFIER, "R104", "update-value-used", "message with '%s'") */
typedef enum reason_id {
    REASON_NONE,
#define X(identifier, id, slug, message) identifier,
#include "analysis/base/reasons.def"
#undef X
    REASON_COUNT
} reason_id;

const char *reason_code(reason_id id); /* "R104"; NULL for REASON_NONE */
const char *reason_slug(reason_id id);

typedef struct reason {
    reason_id id;
    const char *message; /* complete, names filled in */
    ir_range range;      /* the access or statement that causes it */
    const char *advice;  /* a change of the source that would help, or NULL */
} reason;

/* ---- the counted loop ---------------------------------------------------------------------- */

/** A variable that the header sets before the first iteration: `q` in for (i = 0, q = 5; ...), for
 *  (i = q = 5; ...), for (int i = 0, q = 5; ...). */
typedef struct loop_start {
    ir_variable *variable;
    const ir_node *value; /* plain, independent of other variables set by the header */
    const ir_node *node;  /* the assignment or declarator */
    bool is_declared;     /* it is local to the loop */
} loop_start;

/** for (counter = lower; counter <comparison> bound; counter += step), or an equivalent while or
 *  do. The counter is an integer, or a pointer to objects: then lower and bound are pointers, or
 *  arrays. */
typedef struct counted_loop {
    ir_variable *counter;
    bool counter_is_declared_in_header;
    const ir_node *lower; /* expression; NULL: the counter's value on entry (while and do loops) */
    const ir_node *bound; /* loop-invariant expression */
    const ir_variable *bound_variable; /* a variable that the header sets to `bound`, and that is
                                        * not used otherwise in the loop; NULL: none */
    unsigned start_count;
    loop_start starts[4];   /* other variables set by the header */
    ir_operator comparison; /* LESS, LESS_EQUAL, GREATER, GREATER_EQUAL, NOT_EQUAL (step +-1);
                               as counter <comparison> bound */
    int64_t ahead; /* the condition is: counter + ahead <comparison> bound. A constant, other
                    * than 0 only for an integer incremented by 1 */
    int64_t step;  /* non-zero constant; its sign agrees with the comparison. For a pointer:
                    * bytes */
    const ir_node *stride; /* an integer counter changes by step * stride, with a step of 1 or -1:
                            * an expression of invariant variables, at least 1, which generated code
                            * checks. NULL: the counter changes by `step` */
    const ir_node *body;   /* executed each iteration; in a while or do, the increment may be its
                            * last statement, `increment`, and not part of the copy */
    const ir_node *increment;
    bool steps_inside; /* in a while or do: `increment` is v++ or v-- somewhere in the body, whose
                        * copy keeps it; after it the iteration does not use v */
    bool steps_first;  /* the condition steps the counter before the body: the first iteration has
                        * `lower` plus one step */
    bool ends_below;   /* the condition steps it after the comparison: an unsigned one ends one step
                        * below 0 */
} counted_loop;

/* ---- arrays, updates ----------------------------------------------------------------------- */

/** operators.def, and REDUCTION_NONE: stores and functions of the old value with other
 *  operators. */
typedef enum reduction_operator {
#define X(NAME, SPELLING) REDUCTION_##NAME,
#include "analysis/base/operators.def"
#undef X
    REDUCTION_NONE
} reduction_operator;

/** As in the JSON report; NULL for REDUCTION_NONE. */
const char *reduction_operator_spelling(reduction_operator op);

typedef struct reduction_array {
    const ir_node *base;    /* loop-invariant lvalue: `b`, `s->b`; array or pointer type */
    const char *name;       /* its text */
    const ir_type *element; /* scalar */
    reduction_operator op;  /* of its first update, if order_is_kept */
    int64_t limit;          /* REDUCTION_SATURATING: of all its updates, if they commute */
    bool order_is_kept;     /* its updates do not commute: only methods that execute each element's
                             * updates in the order of the loop apply, without copies */
    int64_t unit;           /* bytes of its largest row (update.row), or of the structure around
                             * it */
    bool is_scattered;      /* its elements are reached through pointers that iterations load from
                             * `base`, as in rows[k][c] with the base rows. They may lie anywhere,
                             * with other data between them; the order is kept */
    bool is_interleaved;    /* other data lie between these elements, or are read through base: no
                             * private copies are possible (runtime: REDCC_OTHER_TYPE) */
} reduction_array;

typedef struct reduction_update {
    const ir_node *statement; /* IR_EXPRESSION, or an IR_IF that reads the element in its condition:
                               * the statement that the owner-checked form encloses; writes only the
                               * element */
    const ir_node *last;      /* the last of several statements, enclosed together, the first being
                               * `statement`; NULL: there is one. A declaration is given by its
                               * declarator */
    const ir_node *target;    /* the lvalue updated: b[i][c] */
    const ir_node *row;       /* the part of it whose address the inspector records: b[i] if all
                               * further subscripts are proved to stay inside the row; else target
                               * itself */
    unsigned array;           /* index into arrays */
} reduction_update;

/* ---- other reads of the loop ---------------------------------------------------------------- */

typedef enum source_extent {
    EXTENT_INVARIANT, /* one address for all iterations: sizeof(row) bytes at &row */
    EXTENT_AFFINE,    /* monotonic in the counter: it ends with the rows of the first and of the
                       * last iteration; row mentions only the counter and invariants */
    EXTENT_TOUCHED,   /* the inspector records it, at the place of `row` in the slice */
    EXTENT_BOUNDED    /* elements between bounds that are known before the loop (element_bounds) */
} source_extent;

/** The read is made only in iterations whose counter satisfies this comparison with `bound`. Both
 *  are compared as mathematical numbers. */
typedef struct counter_limit {
    ir_operator comparison; /* LESS, LESS_EQUAL, GREATER, GREATER_EQUAL, EQUAL, NOT_EQUAL */
    const ir_node *bound;   /* loop-invariant integer; evaluating it reads no memory */
} counter_limit;

/** A counted loop in a called function, around a read there. */
typedef struct source_loop {
    const ir_variable *counter;   /* a variable of the function: rows are recorded for each of
                                   * its values */
    const ir_node *lower, *bound; /* in the caller's terms */
    ir_operator comparison;       /* counter <comparison> bound */
    int64_t step;
    bool may_end_early; /* then it is the innermost one, and its rows form a span (row_steps.h) of
                         * which the first elements are read */
} source_loop;

/** The integer value + offset; value NULL: offset alone. */
typedef struct bound_term {
    const ir_node *value;
    int64_t offset;
} bound_term;

enum { BOUNDS_MOST_TERMS = 8, BOUNDS_MOST_CONDITIONS = 8 };

/** Some elements base[k] are read, with k between the minimum and the maximum of the terms,
 * provided that no condition, a floating value, is negative. Terms and conditions are constants,
 * parameters, or read through parameters; they are expressed by the caller's variables. Generated
 * code reads them even if the program would not. */
typedef struct element_bounds {
    const ir_node *base; /* a pointer */
    const ir_type *element;
    unsigned term_count;
    bound_term terms[BOUNDS_MOST_TERMS];
    unsigned condition_count;
    const ir_node *conditions[BOUNDS_MOST_CONDITIONS];
    bool is_certain; /* each iteration reads all elements between the bounds */
} element_bounds;

/** A read that is compared with what the loop writes, or that determines subscripts; or an
 *  accumulator in memory (is_scalar) or an own element, which are compared, too. */
typedef struct loop_source {
    const char *name;    /* "x", "s->x" */
    const ir_node *base; /* loop-invariant: the pointer or array that the address moves with; NULL:
                          * it is reached through pointers that the slice reads */
    const ir_node *row;  /* lvalue in the caller's terms (callees' parameters substituted) */
    source_extent extent;
    const ir_node *place; /* EXTENT_TOUCHED: the node of the loop (a statement) before which the
                           * inspector can compute &row; it and its operands are in the slice */
    bool is_subscript;    /* its contents determine which elements are touched */
    bool needs_guard;     /* may overlap the loop's writes, according to the analysis */
    bool is_scalar;       /* a scalar in memory that the loop accumulates into (scalar_update's
                           * is_guarded): compared with all reads that may alias it */
    bool meets_scalars;   /* may overlap such a scalar */
    bool meets_arrays;    /* may overlap a reduction array, according to the analysis */
    bool is_sometimes; /* read in some iterations only: its address may be invalid in others, and is
                        * computed as a number (row_address.h; EXTENT_TOUCHED otherwise) */
    bool is_checked;   /* EXTENT_AFFINE: subscripts may wrap around between the ends, or be out of
                        * bounds there: both ends must be computed with checks (exact.h) */
    bool is_ahead; /* EXTENT_TOUCHED: recorded before a condition inside of `place` decides whether
                    * it is read */
    bool is_repeated; /* EXTENT_TOUCHED: each iteration executes `place`, and reads the same rows as
                       * long as nothing is stored */
    unsigned loop_count;      /* EXTENT_TOUCHED: it is many rows, one for each iteration of these */
    const source_loop *loops; /* outermost first */
    unsigned limit_count;     /* EXTENT_AFFINE, is_checked */
    const counter_limit *limits;
    const element_bounds *bounds; /* EXTENT_BOUNDED */
} loop_source;

/** An inner `for` with step 1 over a triangle, `for (j = i + c; j < end; j++)` or `for (j = end; j
 * < i + c; j++)` with the loop's counter i, which has step 1. Its trip count in iteration i is
 * `offset` + end - i, or (is_below) `offset` + i - end; if that is negative, 0. */
typedef struct triangle {
    const ir_node *loop; /* NULL: none */
    const ir_node *end;  /* of numbers and of variables that the loop does not change */
    int64_t offset;
    bool is_below;
} triangle;

typedef struct private_variable {
    ir_variable *variable;
    bool is_declared_inside;      /* then no code is generated for it */
    bool is_live_after;           /* live-out, and proved to be assigned in every iteration */
    bool is_conditional_live_out; /* live-out, but some iterations leave it unchanged (conditional
                                   * lastprivate): a scalar assigned by separate statements
                                   * (IR_EXPRESSION) */
    bool is_stepped;     /* an integer or pointer that each iteration steps by `step` in all: its
                          * value is the one on entry plus the steps of all preceding iterations */
    bool is_step_wanted; /* is_stepped: its last value is needed: it is live-out, or the header
                          * does not set it */
    bool is_in_slice;    /* is_stepped: the inspector uses it */
    int64_t step;
    const ir_node *stride; /* is_stepped: each iteration also adds this integer expression of
                            * invariant local variables; NULL: nothing */
    bool is_down;          /* `stride` is subtracted */
    triangle inner;       /* is_stepped: not each iteration of the loop, but each of this inner loop
                           * steps it */
    const ir_node *entry; /* is_stepped: its value on entry, if the header sets it; NULL: the
                           * value that it has before the loop */
    bool is_declared_in_header; /* with the counter: it does not exist outside of the loop. Its type
                                 * can be spelled */
} private_variable;

/** The type in which an operand of a scalar's update is stored: the operation's type. */
typedef enum operand_type { OPERAND_INTEGER, OPERAND_FLOAT, OPERAND_DOUBLE } operand_type;

/** s op= e, or if (e > s) s = e, for a scalar that the loop does not use otherwise: each
 *  iteration's operand is kept, and all are applied in order after the loop. */
typedef struct scalar_update {
    ir_variable *variable;    /* s; NULL: it is a member, an element, or the target of a pointer */
    const ir_node *target;    /* s as an lvalue */
    const ir_node *statement; /* IR_EXPRESSION; for extrema also IR_IF */
    const ir_node *value;     /* the operand; NULL: 1 */
    ir_operator op;           /* + - * & | ^; is_extremum: a comparison */
    operand_type operand;
    bool is_conditional; /* not executed in each iteration */
    bool is_repeated;    /* executed several times per iteration, in an inner loop: for integers,
                          * whose operands an iteration may combine first */
    bool is_series;      /* floating, and some update of this scalar is repeated: all operands of an
                          * iteration are kept, for all updates of the scalar together */
    bool is_guarded;     /* memory that other accesses of the loop may alias: checked before
                          * anything is written */
    bool is_extremum;    /* if (e op s) s = e; with a comparison op, and e of the type of s */
    bool is_negated;     /* is_extremum: if (!(e op s)) s = e */
    ir_variable *place;  /* is_extremum: a variable that gets the counter's value when s is set; or
                          * NULL */
} scalar_update;

/** target = value, for an element that the same iteration reads again later: other occurrences of
 *  `target` in the loop are reads, and use the stored value instead of memory. */
typedef struct forwarded_store {
    const ir_node *statement; /* IR_EXPRESSION; it is also one of `updates`. In the slice if the
                               * slice needs the stored value */
    const ir_node *target;
    const ir_node *value;
} forwarded_store;

/** t[i] = v or t[i] op= v, for the iteration's own element of an array. Other statements of the
 *  iteration only read that element, and only before the store. A separate loop makes such stores
 *  after this one (loop fission). While the loop is analysed and written, `rest` replaces the
 *  statement (distributed.h). */
typedef struct distributed_store {
    ir_node *statement;        /* IR_EXPRESSION */
    ir_node *rest;             /* an empty IR_BLOCK */
    const ir_node *assignment; /* of a constant, or of a loop-invariant variable */
    const ir_node *condition;  /* its condition, on the counter, the element, and loop invariants;
                                * NULL: it is made in each iteration */
} distributed_store;

typedef struct distribution {
    unsigned count;
    const distributed_store *stores; /* in source order */
} distribution;

enum { MOST_STEPPED = 4 };

/** A statement that leaves the loop, or prints, if its condition holds (loop_exits.h). While the
 * loop is analysed and written, `rest` replaces it: the iteration ends there. */
typedef struct loop_exit {
    ir_node *statement;
    ir_node *rest;
    const ir_node *condition;
    ir_node *holder; /* the condition's parent in the statement */
    ir_node *parent; /* the statement's block */
    bool is_negated; /* it leaves if the condition does not hold */
} loop_exit;

enum { LOOP_MOST_EXITS = 8 };

typedef struct loop_exits {
    unsigned count;
    loop_exit items[LOOP_MOST_EXITS];
} loop_exits;

/** A loop-invariant pointer, and a variable that replaces it: it is loaded from `offset` bytes
 *  after the target of `through`. */
typedef struct loop_load {
    const ir_variable *variable; /* its stands_for is the pointer */
    const ir_variable *through;  /* a variable of the function, or of an earlier load */
    int64_t offset;
} loop_load;

/** A use of the pointer, `node`, which `stand_in` replaces as child number `number` of `parent`. */
typedef struct load_use {
    ir_node *node;
    ir_node *stand_in;
    ir_node *parent;
    unsigned number;
} load_use;

enum { LOOP_MOST_LOADS = 16 };

typedef struct loop_loads {
    unsigned count;
    loop_load items[LOOP_MOST_LOADS]; /* each after the ones it is loaded through */
    VECTOR(load_use) uses;
} loop_loads;

/** A scalar element t[i], t[i + 1].x, x[i][2] that the iteration stores to, and that no other
 *  iteration touches. A variable replaces it wherever the body names it: it begins with the
 *  element's value; its last value is kept, and stored after all iterations. */
typedef struct own_element {
    const ir_node *element; /* the first place that names it */
    bool is_stored_first; /* each iteration stores it before reading it: the variable need not begin
                           * with the element's value */
    bool is_in_slice;     /* the inspector needs its value */
    bool is_guarded;      /* the loop's other reads, or own elements, may overlap it: compared
                           * before anything is written */
} own_element;

/** An inner `for` of the slice, that counts up (LESS, LESS_EQUAL) to its bound, whose iterations
 *  only record rows, perhaps in nested spans with invariant headers. Rows that mention its stepped
 *  variables are consecutive elements of arrays. (With a step of s an iteration has s such rows.)
 * So the first and the last iteration determine the whole range. */
typedef struct loop_span {
    const ir_node *loop;
    counted_loop counted;
    /* The header steps these by counted.step: the counter, and integers and pointers stepped with
     * it. The body does not write them. */
    unsigned stepped_count;
    const ir_variable *stepped[MOST_STEPPED];
    /* The header changes these in another way, `w += dw`. The slice neither reads nor changes
     * them. */
    unsigned other_count;
    const ir_variable *others[MOST_STEPPED];
} loop_span;

/** A read that prevents keeping a plan of the loop. */
typedef struct unkept_read {
    const char *name; /* of the memory read; NULL: there is no such read */
    ir_range range;   /* range of the read, or of the call that makes it */
} unkept_read;

/** Variables of a loop other than scalars of updates. */
typedef struct loop_variables {
    unsigned private_count;
    const private_variable *privates; /* counter excluded; includes inner loops' counters */
    unsigned captured_count;
    ir_variable *const *captured; /* declared outside, only read in the loop, in order of first
                                   * use */
    const loop_loads *loads;      /* NULL: no variable replaces a pointer */
    unsigned own_count;
    const own_element *own;
    const struct openmp_loop *openmp;  /* the loop's OpenMP directives; the parallel form omits
                                        * them, except that of VERDICT_BLOCKS; NULL: none */
    const struct fixed_blocks *blocks; /* of VERDICT_BLOCKS */
} loop_variables;

/** The slice: statements and control needed for rows and touched sources. */
typedef struct loop_slice {
    const loop_exits *exits; /* those whose conditions it evaluates; NULL: no iteration leaves the
                              * loop. An empty list: a callee may end the program by an assertion */
    bool may_abort;          /* by an assertion in a function that it calls */
    bool has_rows;           /* false: it is for the touched sources alone */
    bool *holds;       /* indexed by node id of the function; set for IR_DECLARATOR, IR_EXPRESSION,
                        * control statements and the IR_BLOCKs in between. A condition of an update that
                        * is too expensive or unsafe to evaluate twice is left out: the inspector may then
                        * record more than is written. */
    const bool *reads; /* likewise, of the smaller slice for the touched sources that need a guard
                        * (no rows); NULL: there is none */
    bool has_floating_work; /* it may run only if two copies of one floating-point expression give
                             * the same bits */
    bool is_verifiable; /* a plan may be kept while the sources marked is_subscript, the key and the
                         * trip count are unchanged (runtime: REDCC_VERIFIABLE) */
    unkept_read unkept; /* the first one, if not is_verifiable */
} loop_slice;

/** The code that executes the slice, to record the rows that each iteration touches. */
typedef struct loop_inspector {
    bool exists; /* false: the subscripts cannot be computed a second time. Only in-order binning,
                  * which computes each iteration once, can execute the loop */
    unsigned span_count;
    const loop_span *spans;
    unsigned hull_count;
    const ir_node *const *hulls; /* loops whose first and last iterations have the extreme addresses
                                  * of their updates (loop/hulls.h) */
    unsigned key_count; /* scalars and pointers (invariant expressions) the slice depends on */
    const ir_node *const *key;
} loop_inspector;

typedef struct loop_facts {
    ir_node *loop; /* the loop that is analysed */
    ir_function *function;
    counted_loop counted;
    bool counter_is_live_after;
    bool sets_errno;           /* it calls mathematical functions, which set errno on failure */
    bool has_short_iterations; /* a few of them are not worth a call of the runtime */
    unsigned array_count;
    const reduction_array *arrays;
    unsigned update_count;
    const reduction_update *updates; /* in source order */
    unsigned scalar_count;
    const scalar_update *scalars; /* in source order */
    unsigned forward_count;
    const forwarded_store *forwards;  /* in source order */
    const distribution *distribution; /* NULL: none */
    unsigned source_count;
    const loop_source *sources; /* in the order in which the slice reads them */
    loop_variables variables;
    loop_slice slice;
    loop_inspector inspector;
} loop_facts;

typedef enum verdict_kind {
    VERDICT_TRANSFORM,
    VERDICT_REFUSE,
    VERDICT_NOT_A_REDUCTION,
    VERDICT_BLOCKS /* its OpenMP directive stays, and reduces scalars in fixed blocks */
} verdict_kind;

/** A function of another file that a verdict depends on; set by the callers that know other
 *  files. */
typedef struct external_call {
    const char *name, *file;
    const char *word; /* its property: "const" */
    ir_range range;   /* range of its name in the loop, or of the name of the callee that calls
                       * it */
} external_call;

typedef struct loop_verdict {
    verdict_kind kind;
    const ir_node *loop; /* the reported loop: the outermost one analysed as a whole, or the
                          * innermost one if refused */
    const ir_function *function;
    reason why; /* if it is refused */
    unsigned pragma_count;
    unsigned external_call_count;
    const external_call *external_calls;
    const user_pragma *pragmas; /* the pragmas that the verdict depends on, or that it follows */
    loop_facts *facts; /* arrays as far as known also for refusals; complete for TRANSFORM */
} loop_verdict;

/** A statement whose call updates elements that iterations share, in a loop that stays
 * sequential. */
typedef struct updating_call {
    ir_function *function;
    ir_node *statement;
} updating_call;

typedef VECTOR(updating_call) updating_calls;

/** Does the output have generated code for the loop? */
static inline bool verdict_is_written(const loop_verdict *verdict) {
    return verdict->kind == VERDICT_TRANSFORM || verdict->kind == VERDICT_BLOCKS;
}

/** Known properties of a function that another file of the build defines. */
typedef enum exported_kind {
    EXPORTED_NOTHING,   /* it may do anything */
    EXPORTED_CONST,     /* no side effects, reads only its arguments */
    EXPORTED_ARGUMENTS, /* no side effects, reads the targets of its pointer arguments */
    EXPORTED_PURE       /* no side effects, may read anything */
} exported_kind;

typedef struct analysis_options {
    unsigned pure_count;
    const char *const *pure; /* --pure: asserted by the user */
    bool assume_noalias;     /* --assume-noalias */
    bool report_all;         /* --all: NOT_A_REDUCTION verdicts too */
    bool any_order;          /* --order=any: results need not have the sequential program's bits */
    const map *external;     /* name -> const exported_kind *, of functions that exactly one other
                              * file of the build defines; NULL: nothing is known of other files */
} analysis_options;

#endif
