/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The abstract interpreter of the must-write proof: expressions, statements, calls.
 * For must_write*.c only.
 */
#ifndef ANALYSIS_MUST_WRITE_RUN_H
#define ANALYSIS_MUST_WRITE_RUN_H

#include "analysis/memory/must_write/must_write.h"
#include "analysis/memory/must_write/must_write_state.h"

/** The effect of a call on the object, with these values of its parameters. */
typedef struct call_summary {
    struct call_summary *next;
    const ir_function *function;
    int64_t object_size;
    bool is_open;
    unsigned argument_count;
    const value *arguments;
    const char *unknown; /* why nothing is known; NULL: the other fields are valid */
    byte_set read;       /* bytes that may be read before the call itself has written them */
    byte_set touched;    /* bytes that may be written */
    byte_set written;    /* bytes definitely written when it returns */
    value result;
} call_summary;

enum { SUMMARY_LISTS = 256 };

struct must_write {
    arena *arena;
    const ir_unit *unit;
    const analysis_options *options;
    call_summary *summaries[SUMMARY_LISTS]; /* by function id % SUMMARY_LISTS */
    arena *scratch;                         /* of the current query */
    unsigned steps;                         /* remaining for the query */
};

/** One body being interpreted: the analysed one, or a callee's. */
typedef struct run {
    must_write *prover;
    const ir_function *function;
    const ir_variable *object; /* NULL in callees: they reach it by pointers only */
    const ir_node *body;       /* of the loop; NULL in callees */
    int64_t size;              /* of the object, in bytes */
    bool is_open;              /* the object's true end is unknown, `size` is only a window */
    unsigned depth;            /* of calls */
    byte_set read, touched;    /* as in call_summary */
    const ir_node *read_node;  /* the first premature read */
    const char *unknown;       /* set: the interpretation has ended, nothing is known */
    const ir_node *unknown_node;
    state *on_break, *on_continue; /* joined with the states that jump; NULL: a jump gives up */
    state on_return;
    bool has_result;
    value result;
} run;

extern const value value_other;

/* ---- values (must_write_value.c) ------------------------------------------------------------- */

/** The number as a value of the type, or value_other if a conversion would change it. */
value value_integer(int64_t number, const ir_type *type);
/** False if the result is unknown. */
bool value_compute(ir_operator op, int64_t a, int64_t b, int64_t *result);
/** Bytes of the pointer type's target; void counts as 1, as in GNU C; -1: unknown. */
int64_t value_pointee_size(const ir_type *type);
/** pointer +- number * element */
value value_move(value pointer, value number, int64_t element, bool is_back);
/** left op right; `node` has operator and types. */
value value_combine(const ir_node *node, value left, value right);

/* ---- the interpreter ------------------------------------------------------------------------- */

/** Gives up, keeping the first reason. Returns value_other. */
value run_give_up(run *r, const ir_node *node, const char *why);
/** Counts work; false once the interpretation has ended. */
bool run_step(run *r, const ir_node *node, unsigned steps);

/** Records that the bytes may be read now. */
void run_read(run *r, const state *s, const ir_node *node, int64_t begin, int64_t end);
void run_read_set(run *r, const state *s, const ir_node *node, byte_set bytes);
/** Records a write of exactly these bytes, or of some of them. */
void run_write(run *r, state *s, const ir_node *node, int64_t begin, int64_t end, bool is_exact);

/** The value after an assignment or cast to the type. */
value run_convert(run *r, const ir_node *node, value v, const ir_type *type);

/** May evaluating it have side effects, according to its form? */
bool run_has_effects(run *r, const ir_node *node);

/** A read in one operand must not rely on a write in another: f[0] + set(f). Each is evaluated with
 *  the state before all of them. */
typedef struct unsequenced {
    bool is_needed;
    byte_set before, all;
} unsequenced;

unsequenced run_begin_unsequenced(run *r, const state *s, const ir_node *node,
                                  ir_node *const *operands, unsigned count);
void run_next_unsequenced(unsequenced *u, state *s); /* between operands */
void run_end_unsequenced(unsequenced *u, state *s);

/* ---- places (must_write_place.c) ------------------------------------------------------------- */

/** Where an lvalue lies. */
typedef enum place_kind { PLACE_ELSEWHERE, PLACE_OBJECT, PLACE_LOCAL } place_kind;

typedef struct place {
    place_kind kind;
    bool is_exact; /* PLACE_OBJECT: at `offset`; else somewhere in [begin, end) */
    int64_t offset;
    int64_t begin, end;          /* the range that an unknown subscript may reach */
    const ir_variable *variable; /* if it is a scalar variable whose value is followed */
} place;

place run_variable_place(const run *r, const ir_variable *variable);
/** The place of an lvalue; other expressions are evaluated, and their place is elsewhere. */
place run_locate(run *r, state *s, const ir_node *node);
/** Reads the lvalue `node` that lies there; arrays decay. */
value run_load(run *r, state *s, const ir_node *node, const place *p);
/** Assigns to the lvalue `target` that lies there; returns the value it then has. */
value run_store(run *r, state *s, const ir_node *target, const place *p, value v);

/** Does the lvalue name an element that an earlier loop of the same body with the same header has
 *  written (must_write_repeat.c)? */
bool run_repeats_write(const run *r, const ir_node *read);

/* ---- expressions and statements -------------------------------------------------------------- */

/** The value of an expression, its effects applied to the state. */
value run_evaluate(run *r, state *s, const ir_node *expression);
/** Evaluates an expression whose value is not used: x; (void)x; */
void run_discard(run *r, state *s, const ir_node *expression);
/** As run_evaluate, for a place where a pointer into the object could not be followed: gives up if
 *  the value is one. */
void run_evaluate_closed(run *r, state *s, const ir_node *expression);
/** Gives up if C text that is not in the tree (the size of an array type) may read the object. */
void run_check_hidden(run *r, const state *s, const ir_node *node, const ir_type *type);
void run_initialise(run *r, state *s, const ir_node *declarator);
value run_call(run *r, state *s, const ir_node *call);

void run_execute(run *r, state *s, const ir_node *statement);

/** Never NULL; it is valid unless its `unknown` is set. */
const call_summary *summarise_call(must_write *prover, const ir_function *function, int64_t size,
                                   bool is_open, unsigned argument_count, const value *arguments,
                                   unsigned depth);
/** Does the function store or pass on the address of an object of this size that its argument
 *  points into? For calls outside of the analysed loop. */
bool call_keeps_address(must_write *prover, const ir_node *call, unsigned argument, int64_t size);
/** May code outside of `body`, executed before or between its executions, store the variable's
 *  address? */
bool address_kept_outside(must_write *prover, const ir_node *body, const ir_variable *variable);

/** The trip count of a `for` whose first value and bound are one variable plus constants, unless it
 *  is left before. -1: unknown. */
int64_t run_known_trip_count(run *r, const ir_node *loop);

#endif
