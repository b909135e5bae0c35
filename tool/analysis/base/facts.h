/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The types of the analysis' results: facts about a loop, reasons and verdicts. All parts of the
 *  analysis and its callers share them. The terms row, touch, source, slice, key, plan and guard
 *  are explained in docs/glossary.md. */
#ifndef ANALYSIS_FACTS_H
#define ANALYSIS_FACTS_H

#include "analysis/base/pragma.h"
#include "ir/ir.h"
#include "support/map.h"
#include "support/vector.h"

/* ---- reasons ------------------------------------------------------------------------------- */

/** reasons.def has lines X(IDENTIFIER, "R104", "update-value-used", "message with '%s'"). */
typedef enum reason_id {
    REASON_NONE,
#define X(identifier, id, slug, message) identifier,
#include "analysis/base/reasons.def"
#undef X
    REASON_COUNT
} reason_id;

const char *reason_code(reason_id id); /* such as "R104"; NULL for REASON_NONE */
const char *reason_slug(reason_id id);

typedef struct reason {
    reason_id id;
    const char *message; /* the complete message, with names filled in */
    ir_range range;      /* the access or statement that causes it */
    const char *advice;  /* a change of the source that would help; NULL if none is known */
} reason;

/* ---- the counted loop ---------------------------------------------------------------------- */

/** A variable other than the counter that the header sets before the first iteration: `q` in
 *  `for (i = 0, q = 5; ...)`, `for (i = q = 5; ...)` and `for (int i = 0, q = 5; ...)`. */
typedef struct loop_start {
    ir_variable *variable;
    const ir_node *value; /* without side effects, and independent of other variables that the
                           * header sets */
    const ir_node *node;  /* the assignment, or the declarator */
    bool is_declared;     /* the variable is local to the loop */
} loop_start;

/** A loop of the form for (counter = lower; counter <comparison> bound; counter += step), or an
 *  equivalent while or do loop. The counter is an integer, or a pointer to objects; then lower and
 *  bound are pointers or arrays. */
typedef struct counted_loop {
    ir_variable *counter;
    bool counter_is_declared_in_header;
    const ir_node *lower; /* an expression; NULL if the counter begins with its value on entry
                           * (while and do loops) */
    const ir_node *bound; /* loop-invariant expression */
    const ir_variable *bound_variable; /* a variable that the header sets to `bound` and that the
                                        * loop uses only in its condition; NULL if there is
                                        * none */
    unsigned start_count;
    loop_start starts[4];   /* variables other than the counter that the header sets */
    ir_operator comparison; /* LESS, LESS_EQUAL, GREATER, GREATER_EQUAL or NOT_EQUAL (step 1 or
                             * -1), with the counter on the left */
    int64_t ahead; /* the condition is: counter + ahead <comparison> bound. A constant; it may
                    * differ from 0 only if the counter is an integer incremented by 1 */
    int64_t step;  /* non-zero constant whose sign agrees with the comparison; in bytes if the
                    * counter is a pointer */
    const ir_node *stride; /* if not NULL, an integer counter changes by step * stride, and step
                            * is 1 or -1. The stride is an expression of invariant variables;
                            * generated code checks that it is at least 1. If NULL, the counter
                            * changes by `step` */
    const ir_node *body;   /* the statement executed in each iteration. If the header has no step,
                            * the body's last statement may be `increment`, or its first one
                            * (steps_at_start). The generated copy of the body omits it */
    const ir_node *increment;
    bool steps_at_start; /* `increment` is the first statement of the body that is no declaration:
                          * iterations use the counter only after the step. The trip count, `lower`
                          * and the final value are those of a step at the end */
    bool steps_inside;   /* in a while or do loop: `increment` is v++ or v-- somewhere in the body,
                          * and the copy of the body includes it. The iteration does not use v after
                          * it */
    bool steps_first;    /* the condition steps the counter before the body, so the first iteration
                          * has `lower` plus one step */
    bool ends_below;     /* the condition steps the counter after comparing it, so an unsigned
                          * counter ends one step below 0 */
} counted_loop;

/* ---- arrays, updates ----------------------------------------------------------------------- */

/** The operators in operators.def. REDUCTION_NONE stands for plain stores, and for functions of the
 *  old value with other operators. */
typedef enum reduction_operator {
#define X(NAME, SPELLING) REDUCTION_##NAME,
#include "analysis/base/operators.def"
#undef X
    REDUCTION_NONE
} reduction_operator;

/** As the JSON report spells the operator; NULL for REDUCTION_NONE. */
const char *reduction_operator_spelling(reduction_operator op);

typedef struct reduction_array {
    const ir_node *base;    /* the invariant lvalue from which elements are reached, such as `b`
                             * or `s->b`; of array or pointer type */
    const char *name;       /* the text of `base` */
    const ir_type *element; /* type of an element, a scalar */
    reduction_operator op;  /* the operator of the updates; if order_is_kept, that of the first
                             * update */
    int64_t limit;          /* for REDUCTION_SATURATING: the limit of all updates, if they
                             * commute */
    bool order_is_kept;     /* the updates do not commute. Only methods apply that execute each
                             * element's updates in the loop's order, without private copies */
    int64_t unit;           /* size in bytes of the largest row (update.row), or of the structure
                             * around it */
    bool is_scattered;      /* the elements are reached through pointers that iterations load from
                             * `base`, as in rows[k][c] with the base rows. They may be anywhere,
                             * with other data between them. order_is_kept is set */
    bool is_interleaved;    /* other data are between these elements, or are read through `base`,
                             * so private copies are impossible (runtime: REDCC_OTHER_TYPE) */
} reduction_array;

typedef struct reduction_update {
    const ir_node *statement; /* the statement that the owner-checked body encloses in a test of
                               * the owner: an IR_EXPRESSION, or an IR_IF whose condition reads
                               * the element. It writes nothing but the element */
    const ir_node *last;      /* if several statements are enclosed together, the last of them,
                               * and `statement` is the first; NULL if there is only one. If it is
                               * a declaration, this is its declarator */
    const ir_node *target;    /* the updated lvalue, such as b[i][c] */
    const ir_node *row;       /* the part of `target` whose address the inspector records: b[i] if
                               * all further subscripts are proved to stay inside the row,
                               * otherwise `target` itself */
    unsigned array;           /* index in `arrays` */
} reduction_update;

/* ---- other reads of the loop ---------------------------------------------------------------- */

typedef enum source_extent {
    EXTENT_INVARIANT, /* the same address in all iterations: sizeof(row) bytes at &row */
    EXTENT_AFFINE,    /* the address is monotonic in the counter, so the extent ends with the rows
                       * of the first and the last iteration. `row` depends only on the counter
                       * and invariants */
    EXTENT_TOUCHED,   /* the inspector records the address when it reaches `place` */
    EXTENT_BOUNDED    /* elements between bounds that are known before the loop (element_bounds) */
} source_extent;

/** A condition on the counter: the read happens only in iterations in which counter <comparison>
 *  bound holds. Both are compared as mathematical numbers. */
typedef struct counter_limit {
    ir_operator comparison; /* LESS, LESS_EQUAL, GREATER, GREATER_EQUAL, EQUAL or NOT_EQUAL */
    const ir_node *bound;   /* a loop-invariant integer; its evaluation reads no memory */
} counter_limit;

/** A counted loop around a read in a called function. */
typedef struct source_loop {
    const ir_variable *counter;   /* a variable of the called function; rows are recorded for each
                                   * of its values */
    const ir_node *lower, *bound; /* expressed by the caller's variables */
    ir_operator comparison;       /* the condition is: counter <comparison> bound */
    int64_t step;
    bool may_end_early; /* if set, this is the innermost loop, its rows form a span (row_steps.h),
                         * and possibly only the first elements of the span are read */
} source_loop;

/** The integer value + offset, or just the offset if `value` is NULL. */
typedef struct bound_term {
    const ir_node *value;
    int64_t offset;
} bound_term;

enum { BOUNDS_MOST_TERMS = 8, BOUNDS_MOST_CONDITIONS = 8 };

/** Elements base[k] that are read, with k between the minimum and the maximum of the terms. None is
 *  read if any of the conditions, which are floating values, is negative. Terms and conditions are
 *  constants, parameters, or values read through parameters, expressed by the caller's variables.
 *  Generated code evaluates them even if the program would not. */
typedef struct element_bounds {
    const ir_node *base; /* a pointer */
    const ir_type *element;
    unsigned term_count;
    bound_term terms[BOUNDS_MOST_TERMS];
    unsigned condition_count;
    const ir_node *conditions[BOUNDS_MOST_CONDITIONS];
    bool is_certain; /* each iteration reads all elements between the bounds */
} element_bounds;

/** A read of the loop that is compared with the loop's writes, or that determines subscripts. Also
 *  an accumulator in memory (is_scalar) or an own element, which are compared too. */
typedef struct loop_source {
    const char *name;    /* text for messages, such as "x" or "s->x" */
    const ir_node *base; /* the loop-invariant pointer or array from which the address is
                          * computed; NULL if the address comes from pointers that the slice
                          * reads */
    const ir_node *row;  /* the lvalue that is read, expressed by the caller's variables */
    source_extent extent;
    const ir_node *place; /* for EXTENT_TOUCHED: the statement of the loop before which the
                           * inspector can compute &row. It and its operands are in the slice */
    bool is_subscript;    /* its contents determine which elements the loop touches */
    bool needs_guard;     /* the loop's writes may overlap it, as far as the analysis can tell */
    bool is_scalar;       /* a scalar in memory that the loop accumulates into (scalar_update with
                           * is_guarded); it is compared with all reads that may alias it */
    bool meets_scalars;   /* it may overlap a scalar for which is_scalar is set */
    bool meets_arrays;    /* it may overlap a reduction array, as far as the analysis can tell */
    bool is_sometimes;    /* only some iterations read it, and in the others its address may be
                           * invalid. If possible the address is computed as a number
                           * (row_address.h); otherwise the extent is EXTENT_TOUCHED */
    bool is_checked;      /* for EXTENT_AFFINE: subscripts may wrap around between the first and the
                           * last iteration, or be out of bounds in one of these two, so both ends
                           * of the extent must be computed with checks (exact.h) */
    bool is_ahead;    /* for EXTENT_TOUCHED: recorded before a condition inside of `place` decides
                       * whether it is read */
    bool is_repeated; /* for EXTENT_TOUCHED: each iteration executes `place`, and all iterations
                       * read the same rows as long as the loop's updates are not applied */
    unsigned loop_count;      /* for EXTENT_TOUCHED: number of nested loops in a callee around the
                               * read; each of their iterations reads a row */
    const source_loop *loops; /* these loops, the outermost first */
    unsigned limit_count;     /* for EXTENT_AFFINE with is_checked: number of conditions on the
                               * counter */
    const counter_limit *limits;
    const element_bounds *bounds; /* for EXTENT_BOUNDED */
} loop_source;

/** An inner `for` whose trip count depends linearly on the counter i of the analysed loop, so that
 *  the two form a triangle:
 *      for (j = i + c; j < end; j++) or for (j = end; j < i + c; j++)
 *  Both steps are 1. The trip count in iteration i is `offset + end - i`, or with is_below
 *  `offset + i - end`; 0 if that is negative. */
typedef struct triangle {
    const ir_node *loop; /* NULL if there is none */
    const ir_node *end;  /* consists of numbers and of variables that the loop does not change */
    int64_t offset;
    bool is_below;
} triangle;

enum { MOST_STRIDES = 4 };

/** An amount that each iteration adds to a variable: times * value. */
typedef struct variable_stride {
    const ir_node *value; /* an integer expression of local variables that the loop does not
                           * change */
    int64_t times;
} variable_stride;

typedef struct private_variable {
    ir_variable *variable;
    bool is_declared_inside;      /* declared inside the loop, so no code is generated for it */
    bool is_live_after;           /* live-out (used after the loop), and proved to be assigned in
                                   * every iteration */
    bool is_conditional_live_out; /* live-out, but some iterations leave it unchanged (conditional
                                   * lastprivate). A scalar that separate statements
                                   * (IR_EXPRESSION) assign */
    bool is_stepped;     /* an integer or pointer whose steps in an iteration add up to the same
                          * `step` in every iteration (an induction variable). Its value is the
                          * one on entry plus the steps of all preceding iterations */
    bool is_step_wanted; /* for is_stepped: its last value is needed, because it is live-out or
                          * the header does not set it */
    bool is_in_slice;    /* for is_stepped: the inspector uses it */
    int64_t step;
    unsigned stride_count;
    variable_stride strides[MOST_STRIDES]; /* for is_stepped: each iteration adds these as well */
    triangle inner;       /* for is_stepped: if inner.loop is set, the iterations of that inner
                           * loop step the variable, not those of the analysed loop */
    const ir_node *entry; /* for is_stepped: the value to which the header sets it; NULL if it
                           * begins with its value before the loop */
    bool is_declared_in_header; /* declared in the header, like the counter, so it does not exist
                                 * outside of the loop. C can spell its type */
} private_variable;

/** The type in which an operand of a scalar's update is stored: the operation's type. */
typedef enum operand_type { OPERAND_INTEGER, OPERAND_FLOAT, OPERAND_DOUBLE } operand_type;

/** An update s op= e, or if (e > s) s = e, of a scalar that the loop does not use otherwise. The
 *  operand of each iteration is stored, and all are applied in order after the loop. */
typedef struct scalar_update {
    ir_variable *variable;    /* s; NULL if the scalar is a member, an element, or the target of a
                               * pointer */
    const ir_node *target;    /* s as an lvalue */
    const ir_node *statement; /* an IR_EXPRESSION; for extrema it may be an IR_IF */
    const ir_node *value;     /* the operand; NULL stands for 1 */
    ir_operator op;           /* + - * & | or ^; for is_extremum, a comparison */
    operand_type operand;
    bool is_conditional; /* some iterations may not execute it */
    bool is_repeated;    /* executed several times per iteration, in an inner loop. For integers
                          * only: an iteration may combine their operands before storing them */
    bool is_series;      /* floating, and some update of this scalar is in an inner loop: the
                          * operands of all updates of the scalar in an iteration are stored
                          * together */
    bool is_guarded;     /* the scalar is in memory that other accesses of the loop may alias. They
                          * are compared with it before anything is written */
    bool is_extremum;    /* if (e op s) s = e; with a comparison `op`. e has the type of s */
    bool is_negated;     /* for is_extremum: the form is if (!(e op s)) s = e */
    ir_variable *place;  /* for is_extremum: a variable that gets the counter's value whenever s
                          * is set; NULL if there is none */
} scalar_update;

/** A statement target = value, for an element that the same iteration reads again later. All other
 *  occurrences of `target` in the loop are reads, and use the stored value instead of memory. */
typedef struct forwarded_store {
    const ir_node *statement; /* an IR_EXPRESSION, which is also one of `updates`. It is in the
                               * slice if the slice needs the stored value */
    const ir_node *target;
    const ir_node *value;
} forwarded_store;

/** A store t[i] = v or t[i] op= v to an element that only this iteration uses. Other statements of
 *  the iteration only read the element, and only before the store. A separate loop makes these
 *  stores after this loop (loop fission). While the loop is analysed and its code is generated,
 *  `rest` replaces the statement (distributed.h). */
typedef struct distributed_store {
    ir_node *statement;        /* an IR_EXPRESSION */
    ir_node *rest;             /* an empty IR_BLOCK */
    const ir_node *assignment; /* the assignment, whose value is a constant or a loop-invariant
                                * variable */
    const ir_node *condition;  /* the condition of the store; it depends on the counter, the
                                * element and loop invariants. NULL if each iteration stores */
} distributed_store;

typedef struct distribution {
    unsigned count;
    const distributed_store *stores; /* in source order */
} distribution;

enum { MOST_STEPPED = 4 };

/** A statement that leaves the loop, or prints, if a condition holds (loop_exits.h). While the loop
 *  is analysed and its code is generated, `rest` replaces it and ends the iteration. */
typedef struct loop_exit {
    ir_node *statement;
    ir_node *rest;
    const ir_node *condition; /* of `rest` */
    const ir_node *tested;    /* of the statement; `condition` negates it if the other branch leaves
                               */
    ir_node *otherwise;       /* the branch that stays, or NULL; `rest` has it, too */
    ir_node *holder;          /* parent of `tested` in the statement */
    ir_node *parent;          /* block of the statement */
    bool is_negated;          /* the loop is left if the condition does not hold */
    bool is_message;          /* the loop may continue after the branch, which prints */
    bool is_kept;   /* the condition may assign variables, so that iterations evaluate it, too */
    bool is_shared; /* a macro call, or a call that is expanded, has the same bytes */
} loop_exit;

enum { LOOP_MOST_EXITS = 8 };

/** A loop without an upper bound (open_loop.h), and the nodes that stand for its condition and its
 *  body while it is analysed and its code is generated. */
typedef struct open_loop {
    ir_node *loop;
    ir_node **place;    /* where the loop has its condition */
    ir_node *header;    /* the node there */
    ir_node *condition; /* NULL: the loop has no condition */
    ir_node *negation;  /* !condition */
    ir_node *limited;   /* compares the counter with a limit */
    ir_node *body;
    ir_node *block; /* the body with an exit for the condition, if there is one, in front */
} open_loop;

typedef struct loop_exits {
    unsigned count;
    loop_exit items[LOOP_MOST_EXITS];
    const open_loop *open; /* NULL if the loop has a bound */
} loop_exits;

/** A loop-invariant pointer that is loaded through another pointer, and the variable that replaces
 *  it. The pointer is at `offset` bytes after the address in `through`. */
typedef struct loop_load {
    const ir_variable *variable; /* its stands_for is the pointer's expression */
    const ir_variable *through;  /* a variable of the function, or of an earlier loop_load */
    int64_t offset;
} loop_load;

/** A use of the pointer: `node` is child number `number` of `parent`, and `stand_in` replaces
 *  it. */
typedef struct load_use {
    ir_node *node;
    ir_node *stand_in;
    ir_node *parent;
    unsigned number;
} load_use;

enum { LOOP_MOST_LOADS = 16 };

typedef struct loop_loads {
    unsigned count;
    loop_load items[LOOP_MOST_LOADS]; /* each comes after the one that it is loaded through */
    VECTOR(load_use) uses;
} loop_loads;

/** An own element: a scalar element t[i], t[i + 1].x or x[i][2] that an iteration stores to and no
 *  other iteration touches. In the generated body a variable replaces it. The variable begins with
 *  the element's value, and its last value is stored to memory after all iterations. */
typedef struct own_element {
    const ir_node *element; /* the first expression that names it */
    bool is_stored_first;   /* each iteration stores to it before reading it, so the variable need
                             * not begin with the element's value */
    bool is_in_slice;       /* the inspector needs its value */
    bool is_guarded;        /* it may overlap other reads of the loop or other own elements, so it
                             * is compared with them before anything is written */
} own_element;

/** A span: an inner `for` of the slice that counts up to its bound (LESS or LESS_EQUAL) and whose
 *  iterations only record rows, perhaps in nested spans with invariant headers. Rows that depend on
 *  its stepped variables are consecutive elements of arrays; with a step of s, each iteration has s
 *  such rows. The first and the last iteration therefore determine the whole range. */
typedef struct loop_span {
    const ir_node *loop;
    counted_loop counted;
    /* Variables that the header steps by counted.step: the counter, and integers and pointers
     * stepped with it. The body does not write them. */
    unsigned stepped_count;
    const ir_variable *stepped[MOST_STEPPED];
    /* Variables that the header changes in another way, as in `w += dw`. The slice neither reads
     * nor changes them. */
    unsigned other_count;
    const ir_variable *others[MOST_STEPPED];
} loop_span;

/** A read, or an exit, that prevents keeping a plan of the loop for later executions. */
typedef struct unkept_read {
    const char *name; /* name of the memory that is read; NULL if there is no such read */
    ir_range range;   /* range of the read, of the call that makes it, or of the exit */
} unkept_read;

/** A loop's variables, except the scalars in scalar_update. */
typedef struct loop_variables {
    unsigned private_count;
    const private_variable *privates; /* includes the counters of inner loops, but not the loop's
                                       * own counter */
    unsigned captured_count;
    ir_variable *const *captured; /* variables declared outside that the loop only reads, in the
                                   * order of first use */
    const loop_loads *loads;      /* NULL if no variable replaces a pointer */
    unsigned own_count;
    const own_element *own;
    const struct openmp_loop *openmp;  /* the loop's OpenMP directives; NULL if it has none. The
                                        * parallel form omits them, except for VERDICT_BLOCKS */
    const struct fixed_blocks *blocks; /* for VERDICT_BLOCKS */
} loop_variables;

/** The slice: the statements and control structure needed to compute rows and touched sources. */
typedef struct loop_slice {
    const loop_exits *exits; /* the exits whose conditions the slice evaluates. NULL if no
                              * iteration leaves the loop. The list is empty if only a callee's
                              * assertion may end the program */
    bool may_abort;          /* an assertion in a called function may end the program */
    bool has_rows;           /* if false, the slice is only for the touched sources */
    bool *holds;             /* indexed by node id. Set for each IR_DECLARATOR, IR_EXPRESSION and
                              * control statement in the slice, and the blocks (IR_BLOCK) around
                              * them. An update's condition is left out if it is too expensive or
                              * unsafe to evaluate twice. The inspector may then record more than is
                              * written */
    const bool *reads; /* the same for a smaller slice, without rows, that only finds the touched
                        * sources that need a guard; NULL if there is none */
    bool has_floating_work; /* it has floating-point work, so it may run only if two copies of an
                             * expression give the same bits */
    bool is_verifiable; /* a plan may be kept while the sources marked is_subscript, the key and the
                         * trip count are unchanged (runtime: REDCC_VERIFIABLE) */
    unkept_read unkept; /* if not is_verifiable, the first exit or read that prevents it; empty if
                         * neither is the cause */
} loop_slice;

/** The inspector: the code that executes the slice to record the rows that each iteration
 *  touches. */
typedef struct loop_inspector {
    bool exists; /* if false, the subscripts cannot be computed twice. Then only in-order binning,
                  * which computes each iteration once, can execute the loop */
    unsigned span_count;
    const loop_span *spans;
    unsigned hull_count;
    const ir_node *const *hulls; /* inner loops that update their lowest and highest addresses
                                  * in their first and last iterations (loop/hulls.h) */
    unsigned key_count; /* number of invariant scalars and pointers on which the slice depends */
    const ir_node *const *key;
} loop_inspector;

typedef struct loop_facts {
    ir_node *loop; /* the analysed loop */
    ir_function *function;
    counted_loop counted;
    bool counter_is_live_after;
    bool sets_errno;           /* it calls mathematical functions, which set errno on failure */
    bool has_short_iterations; /* an iteration is so short that a call of the runtime does not pay
                                * off for a few of them */
    unsigned array_count;
    const reduction_array *arrays;
    unsigned update_count;
    const reduction_update *updates; /* in source order */
    unsigned scalar_count;
    const scalar_update *scalars; /* in source order */
    unsigned forward_count;
    const forwarded_store *forwards;  /* in source order */
    const distribution *distribution; /* NULL if there are no distributed stores */
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
    VERDICT_BLOCKS /* the loop's OpenMP directive stays, and its scalars are reduced in fixed
                    * blocks (fixed_blocks.h) */
} verdict_kind;

/** A function of another file on which a verdict depends. Callers that know other files set it. */
typedef struct external_call {
    const char *name, *file;
    const char *word; /* the property that is relied on, such as "const" */
    ir_range range;   /* range of its name in the loop, or of the name of the function through
                       * which the loop calls it */
} external_call;

typedef struct loop_verdict {
    verdict_kind kind;
    const ir_node *loop; /* the reported loop: the outermost one that was analysed as a whole, or
                          * the innermost one if refused */
    const ir_function *function;
    reason why; /* if it is refused */
    unsigned pragma_count;
    unsigned external_call_count;
    const external_call *external_calls;
    const user_pragma *pragmas; /* the pragmas on which the verdict depends, or that it obeys */
    loop_facts *facts; /* complete for VERDICT_TRANSFORM; for refusals it has the arrays found so
                        * far */
} loop_verdict;

/** A statement whose call updates elements that iterations share, in a loop that stays
 *  sequential. */
typedef struct updating_call {
    ir_function *function;
    ir_node *statement;
} updating_call;

typedef VECTOR(updating_call) updating_calls;

/** Does the output contain generated code for the loop? */
static inline bool verdict_is_written(const loop_verdict *verdict) {
    return verdict->kind == VERDICT_TRANSFORM || verdict->kind == VERDICT_BLOCKS;
}

/** Known properties of a function that another file of the build defines. */
typedef enum exported_kind {
    EXPORTED_NOTHING,   /* it may do anything */
    EXPORTED_CONST,     /* it has no side effects and reads only its arguments */
    EXPORTED_ARGUMENTS, /* it has no side effects and reads only the targets of its pointer
                         * arguments */
    EXPORTED_PURE       /* it has no side effects but may read anything */
} exported_kind;

typedef struct analysis_options {
    unsigned pure_count;
    const char *const *pure; /* --pure: names of functions that the user declares free of side
                              * effects */
    bool assume_noalias;     /* --assume-noalias */
    bool report_all;         /* --all: report NOT_A_REDUCTION verdicts too */
    bool any_order;          /* --order=any: floating-point results need not have the sequential
                              * program's bits */
    const map *external;     /* name -> const exported_kind *, for functions that exactly one
                              * other file of the build defines; NULL if nothing is known of other
                              * files */
} analysis_options;

#endif
