/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * What the analysis says of a loop: facts, reasons, verdicts. All rooms of the analysis share these
 * types, and whoever asks it reads them.
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
    ir_range range;      /* the access or statement that is in the way */
    const char *advice;  /* what the user could change, or NULL */
} reason;

/* ---- the counted loop ---------------------------------------------------------------------- */

/** A variable that the header sets before the first iteration: `q` of for (i = 0, q = 5; ...), of
 * for (i = q = 5; ...), of for (int i = 0, q = 5; ...). */
typedef struct loop_start {
    ir_variable *variable;
    const ir_node *value; /* plain, and of nothing else that the header sets */
    const ir_node *node;  /* the assignment or declarator */
    bool is_declared;     /* it is the loop's own */
} loop_start;

/** for (counter = lower; counter <comparison> bound; counter += step), or a while or do like it.
 * The counter is an integer, or a pointer to objects: then lower and bound are pointers, or arrays.
 */
typedef struct counted_loop {
    ir_variable *counter;
    bool counter_is_declared_in_header;
    const ir_node *lower; /* expression; NULL: the counter's value on entry (while and do loops) */
    const ir_node *bound; /* loop-invariant expression */
    const ir_variable *bound_variable; /* that the header sets to `bound`, and that is mentioned
                                          nowhere else in the loop; NULL: there is none */
    unsigned start_count;
    loop_start starts[4];   /* what the header sets beside the counter and the bound */
    ir_operator comparison; /* LESS, LESS_EQUAL, GREATER, GREATER_EQUAL, NOT_EQUAL (step +-1);
                               as counter <comparison> bound */
    int64_t ahead; /* of an integer that moves up by 1: counter + ahead <comparison> bound */
    int64_t step;  /* non-zero constant; sign agrees with comparison. Of a pointer: bytes */
    const ir_node *stride; /* the counter is an integer, and moves by `step`, 1 or -1, times this
                              one, of variables that stay: of at least 1, as generated code asks;
                              NULL: by `step` */
    const ir_node *body;   /* executed each iteration; of a while or do, the increment may be its
                              last statement, `increment`, and not part of the copy */
    const ir_node *increment;
    bool steps_inside; /* of a while or do: `increment` is v++ or v-- somewhere in the body, whose
                          copy keeps it; after it the iteration does not ask for v */
    bool steps_first;  /* the condition steps the counter before the body: the first iteration has
                          `lower` and one step */
    bool ends_below;   /* the condition steps it after the comparison: an unsigned one ends one step
                          below 0 */
} counted_loop;

/* ---- arrays, updates ----------------------------------------------------------------------- */

/** operators.def, and REDUCTION_NONE: stores and functions of the old value that are none of these.
 */
typedef enum reduction_operator {
#define X(NAME, SPELLING) REDUCTION_##NAME,
#include "analysis/base/operators.def"
#undef X
    REDUCTION_NONE
} reduction_operator;

/** As the JSON report wants it; NULL for REDUCTION_NONE. */
const char *reduction_operator_spelling(reduction_operator op);

typedef struct reduction_array {
    const ir_node *base;    /* loop-invariant lvalue: `b`, `s->b`; array or pointer type */
    const char *name;       /* its text */
    const ir_type *element; /* scalar */
    reduction_operator op;  /* of its first update, if order_is_kept */
    bool order_is_kept;     /* its updates do not commute: only methods that execute the updates of
                               each element in the order of the loop will do, without copies */
    int64_t unit;           /* bytes of its largest row (update.row), or of the record around it */
    bool is_scattered; /* its elements are found through pointers that iterations read from memory,
                          out of `base`: rows[k][c] of rows. They may lie anywhere, with anything
                          between them; the order is kept */
    bool is_interleaved; /* other things than these elements lie between them, or are read through
                            base: no private copies can be made (runtime: REDCC_OTHER_TYPE) */
} reduction_array;

typedef struct reduction_update {
    const ir_node *statement; /* IR_EXPRESSION, or an IR_IF that reads the element in its condition:
                                 what the guarded form wraps; writes nothing but the element */
    const ir_node *last;   /* of several statements, wrapped together, of which `statement` is the
                              first; NULL: there is one. A declaration goes by its declarator */
    const ir_node *target; /* the lvalue updated: b[i][c] */
    const ir_node *row;    /* the part of it whose address is told to the inspector: b[i] where all
                              that follows is proved to stay inside the row; else target itself */
    unsigned array;        /* index into arrays */
} reduction_update;

/* ---- what else the loop touches ------------------------------------------------------------ */

typedef enum source_extent {
    EXTENT_INVARIANT, /* one address for all iterations: sizeof(row) bytes at &row */
    EXTENT_AFFINE,    /* moves one way with the counter: from &row in the first iteration to the end
                         of row in the last; row mentions only the counter and invariants */
    EXTENT_TOUCHED    /* the inspector tells it, at the place of `row` in the slice */
} source_extent;

/** Iterations in which the counter does not stand so to `bound`, compared as numbers, do not read.
 */
typedef struct counter_limit {
    ir_operator comparison; /* LESS, LESS_EQUAL, GREATER, GREATER_EQUAL, EQUAL, NOT_EQUAL */
    const ir_node *bound;   /* loop-invariant integer; evaluating it reads no memory */
} counter_limit;

/** A counted loop of a function that is called, around what it reads there. */
typedef struct source_loop {
    const ir_variable *counter;   /* the function's own; in the row and in the loops inside of this
                                     one   it stands for each of its values */
    const ir_node *lower, *bound; /* in the caller's terms */
    ir_operator comparison;       /* counter <comparison> bound */
    int64_t step;
    bool may_end_early; /* then it is the innermost one, and what it comes to is a span
                           (row_steps.h) of which the first elements are read */
} source_loop;

/** Something read that may overlap a reduction array, or decides its subscripts. */
typedef struct loop_source {
    const char *name;    /* "x", "s->x" */
    const ir_node *base; /* loop-invariant: the pointer or array that the address moves with; NULL:
                            pointers that the slice reads lead to it, it is where they say */
    const ir_node *row;  /* lvalue in the caller's terms (callees' parameters substituted) */
    source_extent extent;
    const ir_node *place; /* EXTENT_TOUCHED: the node of the loop (statement) before which the
                             inspector can compute &row; it and what it needs are in the slice */
    bool is_subscript;    /* its contents decide which elements are touched */
    bool needs_guard;     /* may overlap what the loop writes as far as the analysis knows */
    bool is_scalar;       /* a scalar that the loop accumulates into in memory (scalar_update's
                             is_guarded): compared with all that may be it */
    bool meets_scalars;   /* may be such a scalar */
    bool is_sometimes; /* read in some iterations only: its address may have no meaning in others,
                          and is computed as a number (row_address.h knows it, unless TOUCHED) */
    bool is_checked;   /* EXTENT_AFFINE: subscripts may wrap around between the ends, or be out of
                          all bounds there: both ends are to be computed with checks (exact.h) */
    bool is_ahead; /* EXTENT_TOUCHED: a condition inside of `place` decides whether it is read */
    unsigned loop_count;      /* EXTENT_TOUCHED: it is many rows, one for each turn of these */
    const source_loop *loops; /* outermost first */
    unsigned limit_count;     /* EXTENT_AFFINE, is_checked */
    const counter_limit *limits;
} loop_source;

typedef struct private_variable {
    ir_variable *variable;
    bool is_declared_inside; /* then nothing is to be generated for it */
    bool is_live_after;      /* its last value is needed: assigned in every iteration, proved */
    bool is_last_sought;     /* its last value is needed, but some iterations leave it as it was: a
                                scalar that is assigned by statements of its own (IR_EXPRESSION) */
    bool is_stepped; /* an integer or pointer that each iteration moves by `step`, once: it begins
                        with the value on entry and as many steps as there were iterations
                        before */
    bool is_step_wanted; /* is_stepped: its value after the loop is needed */
    bool is_in_slice;    /* is_stepped: the inspector asks for it */
    int64_t step;
    const ir_node *by; /* is_stepped: it is moved by this integer as well, of local variables that
                          the loop leaves as they are; NULL: by none */
    bool is_down;      /* `by` is subtracted */
    const ir_node *entry; /* is_stepped: its value on entry, which the header gives it; NULL: the
                             one that it has */
    bool is_declared_in_header; /* beside the counter: there is none of it outside the loop. Its
                                   type can be spelled */
} private_variable;

/** How an operand of a scalar's update is kept: as the type in which the operation is made. */
typedef enum operand_type { OPERAND_INTEGER, OPERAND_FLOAT, OPERAND_DOUBLE } operand_type;

/** s op= e, or if (e > s) s = e, of a scalar that nothing else in the loop reads or writes: each
 * iteration's operand is kept, and all are applied in order after the loop. */
typedef struct scalar_update {
    ir_variable *variable;    /* s; NULL: it is a member, an element, what a pointer leads to */
    const ir_node *target;    /* s as an lvalue */
    const ir_node *statement; /* IR_EXPRESSION; of extrema also IR_IF */
    const ir_node *value;     /* the operand; NULL: 1 */
    ir_operator op;           /* + - * & | ^ */
    operand_type operand;
    bool is_conditional; /* not executed in each iteration */
    bool is_repeated;    /* executed several times in one, in a loop inside: of integers, whose
                            operands an iteration may put together before */
    bool is_series;      /* floating, and some update of this scalar is repeated: all operands of an
                            iteration are kept, of all updates of the scalar together */
    bool is_guarded;     /* a place in memory that other accesses of the loop may be of, as far as
                            is known: compared before anything is written */
    bool is_extremum;    /* if (e op s) s = e; with a comparison op, of one type with s. Where it is
                            conditional no operand is before s in that order */
    bool is_negated;     /* is_extremum: if (!(e op s)) s = e */
    ir_variable *place;  /* is_extremum: that gets the counter's value when s is set; or NULL */
} scalar_update;

/** target = value, of an element that the iteration reads again below: wherever else the loop's
 *  text says `target`, it reads, and takes the value stored instead of the memory. */
typedef struct forwarded_store {
    const ir_node *statement; /* IR_EXPRESSION; one of the updates. In the slice, where what it
                                 stores is needed for it */
    const ir_node *target;
    const ir_node *value;
} forwarded_store;

/** t[i] = v or t[i] op= v, of the iteration's own element of an array that other statements of the
 *  same iteration only read, and before it: such stores are made by a loop of their own, after all
 *  else (loop distribution). While the loop is analysed, and while it is written, `rest` stands in
 * the statement's place (distributed.h). */
typedef struct distributed_store {
    ir_node *statement;        /* IR_EXPRESSION */
    ir_node *rest;             /* IR_EMPTY */
    const ir_node *assignment; /* of a constant, or of a variable that the loop leaves as it is */
    const ir_node *condition;  /* under which it is made, of the counter, the element, and what the
                                  loop leaves as it is; NULL: in each iteration */
} distributed_store;

typedef struct distribution {
    unsigned count;
    const distributed_store *stores; /* in source order */
} distribution;

enum { MOST_STEPPED = 4 };

/** A statement that leaves the loop for good where its condition holds (loop_exits.h). While the
 *  loop is analysed, and while it is written, `rest` stands in its place: the iteration goes no
 *  further. */
typedef struct loop_exit {
    ir_node *statement;
    ir_node *rest;
    const ir_node *condition;
    ir_node *holder; /* the condition's parent in the statement */
    ir_node *parent; /* the statement's block */
    bool is_negated; /* it leaves where the condition does not hold */
} loop_exit;

enum { LOOP_MOST_EXITS = 8 };

typedef struct loop_exits {
    unsigned count;
    loop_exit items[LOOP_MOST_EXITS];
} loop_exits;

/** A pointer that stays as it is while the loop runs, and a variable that stands for it: it is read
 *  at `offset` behind what `through` points to. */
typedef struct loop_load {
    const ir_variable *variable; /* its stands_for is the pointer */
    const ir_variable *through;  /* the function's own, or that of an earlier load */
    int64_t offset;
} loop_load;

/** Where it stands in the tree: child number `number` of `parent`. */
typedef struct load_use {
    ir_node *node;
    ir_node *stand_in;
    ir_node *parent;
    unsigned number;
} load_use;

enum { LOOP_MOST_LOADS = 16 };

typedef struct loop_loads {
    unsigned count;
    loop_load items[LOOP_MOST_LOADS]; /* each behind those on the way to it */
    VECTOR(load_use) uses;
} loop_loads;

/** An inner `for` of the slice, with step 1 up to (LESS, LESS_EQUAL) its bound, whose iterations do
 *  nothing but tell rows, perhaps in spans inside of it whose headers stay the same. Rows that
 *  mention what it steps are elements of arrays, one after the other: what its first and its last
 *  iteration tell is all, and what lies between. */
typedef struct loop_span {
    const ir_node *loop;
    counted_loop counted;
    unsigned stepped_count; /* variables that the header steps by 1: the counter, and others, */
    const ir_variable *stepped[MOST_STEPPED]; /* which the body does not write */
} loop_span;

/** A read because of which no plan of the loop can be kept. */
typedef struct unkept_read {
    const char *name; /* of what is read; NULL: plans are kept, as far as the analysis knows */
    ir_range range;   /* of the read, or of the call that makes it */
} unkept_read;

/** The variables of a loop that are no scalars of updates. */
typedef struct loop_variables {
    unsigned private_count;
    const private_variable *privates; /* counter excluded; includes inner loops' counters */
    unsigned captured_count;
    ir_variable *const *captured;     /* declared outside, read only in the loop, in order of use */
    const loop_loads *loads;          /* NULL: none stands for a pointer */
    const struct openmp_loop *openmp; /* its directives; where it is transformed it
                                         is executed without them. NULL: none */
} loop_variables;

/** The slice: statements and control needed for rows and touched sources. */
typedef struct loop_slice {
    const loop_exits *exits; /* whose conditions it evaluates; NULL: no iteration leaves. Without
                                items: a callee may end the program by an assertion */
    bool may_abort;          /* by an assertion in a function that it calls */
    bool *holds; /* indexed by node id of the function; set for IR_DECLARATOR, IR_EXPRESSION,
                    control statements and the IR_BLOCKs in between. Control that only decides
                    whether an update happens, and is too expensive or not safe to evaluate twice,
                    is left out: the inspector may then touch more than is written. */
    bool has_floating_work; /* it may run only where two copies of one floating-point expression
                               give the same bits */
    bool is_verifiable; /* a plan may be kept while the sources marked is_subscript, the key and the
                           trip count are unchanged (runtime: REDCC_VERIFIABLE) */
    unkept_read unkept; /* the first one, where not is_verifiable */
} loop_slice;

/** What executes the slice, to tell the rows that each iteration touches. */
typedef struct loop_inspector {
    bool exists; /* false: subscripts as expensive as the body, or not sliceable */
    unsigned span_count;
    const loop_span *spans;
    unsigned key_count; /* scalars and pointers (invariant expressions) the slice depends on */
    const ir_node *const *key;
} loop_inspector;

typedef struct loop_facts {
    ir_node *loop; /* the for or while that is analysed */
    ir_function *function;
    counted_loop counted;
    bool counter_is_live_after;
    bool sets_errno;           /* mathematical functions are called that set it where they fail */
    bool has_short_iterations; /* a few of them are not worth asking the runtime */
    unsigned array_count;
    const reduction_array *arrays;
    unsigned update_count;
    const reduction_update *updates; /* in source order */
    unsigned scalar_count;
    const scalar_update *scalars; /* in source order */
    unsigned forward_count;
    const forwarded_store *forwards;  /* in source order */
    const distribution *distribution; /* NULL: there is none */
    unsigned source_count;
    const loop_source *sources; /* in the order in which the slice reads them */
    loop_variables variables;
    loop_slice slice;
    loop_inspector inspector;
} loop_facts;

typedef enum verdict_kind {
    VERDICT_TRANSFORM,
    VERDICT_REFUSE,
    VERDICT_NOT_A_REDUCTION
} verdict_kind;

/** A function of another file that a verdict rests on; set by who knows of other files. */
typedef struct foreign_call {
    const char *name, *file;
    const char *word; /* what it is: "const" */
    ir_range range;   /* of its name in the loop, or of the callee's on the way to it */
} foreign_call;

typedef struct loop_verdict {
    verdict_kind kind;
    const ir_node
        *loop; /* that is reported: outermost analysed as one, or innermost where refused */
    const ir_function *function;
    reason why; /* refusals */
    unsigned pragma_count;
    unsigned foreign_count;
    const foreign_call *foreign;
    const user_pragma *pragmas; /* the user's word that the verdict rests on, or that it follows */
    loop_facts *facts; /* arrays as far as known also for refusals; complete for TRANSFORM */
} loop_verdict;

/** What is known of a function that another file of the build defines. */
typedef enum exported_kind {
    EXPORTED_NOTHING,   /* it may do anything */
    EXPORTED_CONST,     /* no side effects, reads nothing but its arguments */
    EXPORTED_ARGUMENTS, /* no side effects, reads what its pointer arguments point to */
    EXPORTED_PURE       /* no side effects, may read anything */
} exported_kind;

typedef struct analysis_options {
    unsigned pure_count;
    const char *const *pure; /* --pure: the user's word */
    bool assume_noalias;     /* --assume-noalias */
    bool report_all;         /* --all: NOT_A_REDUCTION verdicts too */
    bool any_order;          /* --order=any: other bits will do */
    const map *external;     /* name -> const exported_kind *, of functions that exactly one other
                                file of the build defines; NULL: nothing is known of other files */
} analysis_options;

#endif
