/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The abstract interpreter of the must-write proof. It interprets expressions, statements and
 *  calls. Only must_write*.c use this header. */
#ifndef ANALYSIS_MUST_WRITE_RUN_H
#define ANALYSIS_MUST_WRITE_RUN_H

#include "analysis/memory/must_write/must_write.h"
#include "analysis/memory/must_write/must_write_state.h"

/** The effect that a call of a function with these arguments has on the object. */
typedef struct call_summary {
    struct call_summary *next;
    const ir_function *function;
    int64_t object_size;
    bool is_open;
    unsigned argument_count;
    const value *arguments;
    const char *unknown; /* why nothing is known; NULL if the other fields are valid */
    byte_set read;       /* bytes that the call may read before it has written them */
    byte_set touched;    /* bytes that the call may write */
    byte_set written;    /* bytes that have definitely been written when the call returns */
    value result;
} call_summary;

enum { SUMMARY_LISTS = 256 };

struct must_write {
    arena *arena;
    const ir_unit *unit;
    const analysis_options *options;
    call_summary *summaries[SUMMARY_LISTS]; /* lists, indexed by function id % SUMMARY_LISTS */
    arena *scratch;                         /* for the current query */
    unsigned steps;                         /* steps that the current query has left */
};

/** The interpretation of one body: that of the analysed loop, or that of a callee. */
typedef struct run {
    must_write *prover;
    const ir_function *function;
    const ir_variable *object; /* the analysed variable; NULL in callees, which reach it only
                                * through pointers */
    const ir_node *body;       /* body of the analysed loop; NULL in callees */
    int64_t size;              /* size of the object in bytes */
    bool is_open;              /* the object's end is unknown, and `size` is only the part that is
                                * examined */
    unsigned depth;            /* nesting depth of calls */
    byte_set read, touched;    /* as in call_summary */
    const ir_node *read_node;  /* the first node that may read bytes not written before */
    const char *unknown;       /* if set, why the interpretation has ended without a result */
    const ir_node *unknown_node;
    state *on_break, *on_continue; /* states to join with the state at a break or continue; NULL
                                    * if such a jump cannot be handled */
    state on_return;
    bool has_result;
    value result;
} run;

extern const value value_other;

/* ---- values (must_write_value.c) ------------------------------------------------------------- */

/** The number as a value of the type; value_other if the type cannot represent it. */
value value_integer(int64_t number, const ir_type *type);
/** Computes a <op> b. Returns false if the result is unknown. */
bool value_compute(ir_operator op, int64_t a, int64_t b, int64_t *result);
/** Size of the target of a pointer type; 1 for void and functions, as in GNU C. -1 if unknown. */
int64_t value_pointee_size(const ir_type *type);
/** The pointer moved by `number` elements of `element` bytes; backwards if is_back. */
value value_move(value pointer, value number, int64_t element, bool is_back);
/** The value of left <op> right; `node` has the operator and the types. */
value value_combine(const ir_node *node, value left, value right);

/* ---- the interpreter ------------------------------------------------------------------------- */

/** Ends the interpretation without a result. The first reason is recorded. Returns value_other. */
value run_give_up(run *r, const ir_node *node, const char *why);
/** Counts steps of work. Returns false if the interpretation has ended, perhaps because no steps
 *  are left. */
bool run_step(run *r, const ir_node *node, unsigned steps);

/** run_read notes that the bytes [begin, end) may be read at this point. run_read_set does so for
 *  `bytes`, from which it removes the bytes that are already written. */
void run_read(run *r, const state *s, const ir_node *node, int64_t begin, int64_t end);
void run_read_set(run *r, const state *s, const ir_node *node, byte_set bytes);
/** Notes a write: of all these bytes if is_exact, otherwise of some of them. */
void run_write(run *r, state *s, const ir_node *node, int64_t begin, int64_t end, bool is_exact);

/** The value after conversion to the type, as by an assignment or a cast. */
value run_convert(run *r, const ir_node *node, value v, const ir_type *type);

/** Does the expression contain an assignment, an increment, a call or an opaque node? */
bool run_has_effects(run *r, const ir_node *node);

/** State for operands that C evaluates in an unspecified order. In f[0] + set(f), the read must not
 *  rely on a write by the other operand. Before each operand, `written` is therefore reset to the
 *  bytes written before all of them. */
typedef struct unsequenced {
    bool is_needed;
    byte_set before, all;
} unsequenced;

unsequenced run_begin_unsequenced(run *r, const state *s, const ir_node *node,
                                  ir_node *const *operands, unsigned count);
void run_next_unsequenced(unsequenced *u, state *s); /* call it between two operands */
void run_end_unsequenced(unsequenced *u, state *s);

/* ---- places of lvalues (must_write_place.c) -------------------------------------------------- */

/** The kinds of places of an lvalue: in the analysed object, in a local variable with a tracked
 *  value, or elsewhere. */
typedef enum place_kind { PLACE_ELSEWHERE, PLACE_OBJECT, PLACE_LOCAL } place_kind;

typedef struct place {
    place_kind kind;
    bool is_exact; /* for PLACE_OBJECT: it is at `offset`. If false, it is somewhere in [begin,
                    * end) */
    int64_t offset;
    int64_t begin, end;          /* for PLACE_OBJECT: the part of the object in which the place may
                                  * be, if a subscript is unknown */
    const ir_variable *variable; /* for PLACE_LOCAL; NULL otherwise */
} place;

place run_variable_place(const run *r, const ir_variable *variable);
/** The place of an lvalue. Any other expression is evaluated and gives PLACE_ELSEWHERE. */
place run_locate(run *r, state *s, const ir_node *node);
/** Reads the lvalue `node` at its place. An array decays to a pointer. */
value run_load(run *r, state *s, const ir_node *node, const place *p);
/** Assigns to the lvalue `target` at its place. Returns the value that it has afterwards. */
value run_store(run *r, state *s, const ir_node *target, const place *p, value v);

/** Does the lvalue name an element that an earlier loop with an equal header has written in this
 *  execution of the body (must_write_repeat.c)? */
bool run_repeats_write(const run *r, const ir_node *read);

/* ---- expressions and statements -------------------------------------------------------------- */

/** Evaluates an expression, applying its effects to the state. */
value run_evaluate(run *r, state *s, const ir_node *expression);
/** Evaluates an expression whose value is not used, as in x; or (void)x; */
void run_discard(run *r, state *s, const ir_node *expression);
/** Same as run_evaluate, but ends the interpretation if the value is a pointer into the object,
 *  because such a pointer could not be tracked where this value goes. */
void run_evaluate_closed(run *r, state *s, const ir_node *expression);
/** Ends the interpretation if C text that the tree does not show may read the object. Such text is
 *  the length of an array in `type`, or in the operand of sizeof if `type` is NULL. */
void run_check_hidden(run *r, const state *s, const ir_node *node, const ir_type *type);
void run_initialise(run *r, state *s, const ir_node *declarator);
value run_call(run *r, state *s, const ir_node *call);

void run_execute(run *r, state *s, const ir_node *statement);

/** The summary of a call; never NULL. If its `unknown` is set, it has no other valid
 *  information. */
const call_summary *summarise_call(must_write *prover, const ir_function *function, int64_t size,
                                   bool is_open, unsigned argument_count, const value *arguments,
                                   unsigned depth);
/** May the call store or pass on the address of an object of this size, into which its argument
 *  points? For calls outside the analysed loop. */
bool call_keeps_address(must_write *prover, const ir_node *call, unsigned argument, int64_t size);
/** May code outside `body` that is executed before or between executions of `body` store the
 *  variable's address? */
bool address_kept_outside(must_write *prover, const ir_node *body, const ir_variable *variable);

/** The trip count of a `for` with step 1 whose first value and bound are the same variable plus
 *  constants. -1 if it is unknown. The loop may still end earlier by a jump. */
int64_t run_known_trip_count(run *r, const ir_node *loop);

#endif
