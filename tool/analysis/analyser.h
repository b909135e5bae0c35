/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What is known of the unit as a whole, and of the one loop under judgement. */
#ifndef ANALYSIS_ANALYSER_H
#define ANALYSIS_ANALYSER_H

#include "analysis/access.h"
#include "analysis/alias.h"
#include "analysis/analysis.h"
#include "analysis/counted.h"
#include "analysis/unit_text.h"

typedef struct analyser {
    arena *memory;
    const ir_unit *unit;
    const analysis_options *options;
    must_write *prover;
    variable_facts *facts;
    effects *effects;
    alias_rules rules;
    unit_text *text;
    const user_pragmas *pragmas;
} analyser;

/** What an access of the loop turned out to be. */
typedef enum access_class {
    CLASS_OPEN,      /* not decided */
    CLASS_SCALAR,    /* of a variable of the iteration's own, or one that nothing can change */
    CLASS_REDUCTION, /* an update of arrays[number] */
    CLASS_SELF, /* a read, by an update's statement, of the element that it updates; all accesses
                   to a scalar that the loop accumulates into */
    CLASS_FORWARDED, /* a read of what the iteration has stored: it takes the value */
    CLASS_SHARED     /* a read of memory that other loops' iterations may read as well */
} access_class;

typedef struct judged_access {
    access access;
    location where;
    access_class class;
    unsigned array;        /* CLASS_REDUCTION */
    reduction_operator op; /* CLASS_REDUCTION */
    bool needs_guard;      /* CLASS_SHARED: may overlap an array as far as is known */
} judged_access;

typedef struct judged_array {
    reduction_array array;
    location where; /* of its first update */
    const ir_node *first;
    bool is_irregular;
} judged_array;

/** One loop under judgement. The steps (gate, arrays, privates, sources, slice) fill it in turn;
 *  the first that finds something in the way sets `why` and returns false. */
typedef struct judgement {
    const analyser *an;
    ir_function *function;
    ir_node *loop;
    counted_loop counted;
    access_list found;
    unsigned access_count;
    judged_access *accesses;
    VECTOR(judged_array) arrays;
    VECTOR(reduction_update) updates;
    VECTOR(scalar_update) scalars;
    VECTOR(forwarded_store) forwards;
    VECTOR(private_variable) privates;
    VECTOR(ir_variable *) captured;
    VECTOR(loop_source) sources;
    VECTOR(const ir_node *) key;
    bool *in_slice; /* [function->node_count] */
    VECTOR(loop_span) spans;
    bool slice_has_floating_work;
    bool is_verifiable;
    unkept_read unkept;
    bool counter_is_live_after;
    reason why;
} judgement;

/** Sets the reason, if none is set yet. Returns false. */
bool judgement_refuse(judgement *j, reason_id why, const ir_node *node, const char *name);

/** Is an address in the array with this base used as a value below `node`, as in `h == p` or
 *  `&h[i] - q`? A function that gets it is judged by what it reaches. */
bool judgement_has_address_as_value(const ir_node *node, const ir_node *base);

/** Is this statement one of the updates found? */
bool judgement_is_update(const judgement *j, const ir_node *statement);

/** A name for messages: the text of the lvalue's base, or its root variable. */
const char *judgement_name(const judgement *j, const ir_node *lvalue);

/** May the loop's text be rewritten at all, and is it left only at its end? */
bool judge_text(judgement *j);
bool judge_jumps(judgement *j);

/** Lists all accesses of one iteration, header included; refuses what is not understood. */
bool judge_accesses(judgement *j);

/** Finds updates and their arrays, decides which writes are private, refuses all others. */
bool judge_updates(judgement *j);

/** Proves what is left to the privates: not carried, last values. */
bool judge_privates(judgement *j);

/** Reads against arrays: apart, guarded, or refused; the sources of the loop. */
bool judge_sources(judgement *j);

/** What computes rows and touched sources, and whether a plan may be kept. */
bool judge_slice(judgement *j);

/** spans.c: the slice's inner loops that are told at once. */
void find_spans(judgement *j);

/** All of these steps for one loop. */
loop_verdict verdict_of(const analyser *an, ir_function *function, ir_node *loop);

/** Of a loop that the user wants left alone, and all in it, by this pragma. */
loop_verdict verdict_ignored(const analyser *an, ir_function *function, ir_node *loop,
                             const user_pragma *pragma);

#endif
