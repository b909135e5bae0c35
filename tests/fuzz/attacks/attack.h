/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * One random attack: a legal program with a loop around an irregular reduction, which a translation
 * that assumes too much would change. The program's text depends only on the seed.
 *
 * A program consists of features. Each feature appends declarations, statements and changes between
 * the calls. It returns an expression that the loop uses as a value, a condition or a subscript. In
 * the text that a feature appends, `$` stands for a suffix that no other feature has: `tab$` is
 * `tab_17_0`.
 *
 * By construction no program has undefined behaviour. Positions are less than `trips` + SPARE. A
 * feature evaluates nothing outside of its memory. Integers that are summed are small or unsigned.
 */
#ifndef FUZZ_ATTACK_H
#define FUZZ_ATTACK_H

#include "fuzz/random.h"
#include "support/arena.h"
#include "support/buffer.h"

enum {
    BLOCK = 100, /* seeds of one block share the compiler's options */
    SPARE = 64   /* elements of every table after the last position */
};

typedef enum part {
    PART_INCLUDES,
    PART_GLOBALS,    /* declarations and functions before the kernel */
    PART_PARAMETERS, /* parameters of the kernel, each with a comma before it */
    PART_ARGUMENTS,  /* arguments of its calls, each with a comma before it */
    PART_BEFORE,     /* in the kernel, before the loop */
    PART_BODY,       /* in the loop, before the updates */
    PART_AFTER,      /* in the kernel, after the loop */
    PART_SETUP,      /* in the caller, before the first call */
    PART_FINISH,     /* in the caller, after the last call */
    PART_COUNT
} part;

/** How the programs of a block are compiled (flags.c). */
typedef struct block_flags {
    const char *options;
    bool keeps_errno;     /* library functions set errno */
    bool is_fast;         /* floating-point sums may be reordered */
    bool has_wide_floats; /* floating-point expressions have excess precision */
    bool wraps_signed;
} block_flags;

typedef struct changes {
    const char *statement[24]; /* each statement may be executed between two calls */
    int count;
} changes;

typedef struct attack {
    uint64_t seed;
    random_source random;
    arena *memory;
    const block_flags *flags;
    const bool *without; /* without[n]: statement n is omitted; NULL: none is */
    int statements;      /* number of statements so far */
    int features;        /* number of features so far, which is part of the suffix */
    buffer parts[PART_COUNT];
    changes changes;
    buffer kinds;        /* names of the features, to help in the analysis of a failure */
    const char *element; /* type of the elements of `h`, which is updated, and of `x`, which may
                            overlap it */
    bool is_floating;
    const char *counter_type;
    int trips;    /* positions `t` are in 0 ... trips - 1 */
    int elements; /* subscripts are in 0 ... elements - 1 */
    int limit;    /* number of elements that may be read from `x` on */
} attack;

/** What a feature returns. */
typedef struct operand {
    const char *text;
    bool is_integer;   /* if false, the expression is floating-point; an integer fits into an int */
    bool is_subscript; /* in 0 ... elements - 1 without conversion */
    const char *guard; /* the condition under which the text may be evaluated, or NULL */
} operand;

/* ---- skeleton.c */

const char *text(attack *a, const char *format, ...) __attribute__((format(printf, 2, 3)));
void put(attack *a, part where, const char *format, ...) __attribute__((format(printf, 3, 4)));
bool chance(attack *a, int percent);
int below(attack *a, int n);
const char *one_of(attack *a, int count, const char *const *choices);
/** Appends a statement that may be executed between two calls of the kernel. */
void may_change(attack *a, const char *format, ...) __attribute__((format(printf, 2, 3)));
/** Declares a static table `name$` of `trips` + SPARE ints in 0 ... below - 1. Elements in the
 * second half of the range of `trips` elements from `first` on may change between calls. */
void put_table(attack *a, const char *name, int below, int first);
/** Records the name of what this feature does. */
void note(attack *a, const char *kind);
/** Appends the program of this seed. Returns the number of its statements. */
int put_attack(buffer *b, uint64_t seed, const bool *without);

/* ---- flags.c */

const block_flags *flags_of_block(uint64_t block);

/* ---- one file per kind of attack */

typedef operand feature(attack *a);
feature wrapped_extents, hidden_names, shadowed_in_body, addresses_as_values, block_restrict,
    changed_types, names_like_builtins, values_of_the_thread, searches, floating_subscripts,
    odd_text, beside_scalars, made_valid, behind_the_loop, slices, mapped, counters_set_inside,
    masks, held;

#endif
