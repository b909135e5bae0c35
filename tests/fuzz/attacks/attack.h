/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * One random attack: a legal loop around an irregular reduction, with data and calls of its own, at
 * which a translation that assumes too much gives other results. The text is a function of the
 * seed.
 *
 * A program is made of features: each appends declarations, statements and changes between the
 * calls, and gives an expression that the loop uses as a value, a condition or a subscript. In all
 * that a feature appends `$` stands for a suffix that no other feature has: `tab$` is `tab_17_0`.
 *
 * There is no undefined behaviour, by construction: positions stay below `trips` + SPARE, and a
 * feature evaluates nothing outside of its memory; integers that are accumulated are small or
 * unsigned.
 */
#ifndef FUZZ_ATTACK_H
#define FUZZ_ATTACK_H

#include "fuzz/random.h"
#include "support/arena.h"
#include "support/buffer.h"

enum {
    BLOCK = 100, /* seeds of one block share the flags of the compiler */
    SPARE = 64   /* elements of every table behind the last position */
};

typedef enum part {
    PART_INCLUDES,
    PART_GLOBALS,    /* declarations and functions before the kernel */
    PART_PARAMETERS, /* of the kernel, each with a comma before it */
    PART_ARGUMENTS,  /* of its calls, likewise */
    PART_BEFORE,     /* in the kernel, before the loop */
    PART_BODY,       /* in the loop, before the updates */
    PART_AFTER,      /* behind the loop */
    PART_SETUP,      /* in the caller, before the first call */
    PART_FINISH,     /* in the caller, behind the last call */
    PART_COUNT
} part;

/** How the whole block is compiled (flags.c). */
typedef struct block_flags {
    const char *options;
    bool keeps_errno;     /* library functions set errno */
    bool is_fast;         /* floating sums may be rearranged */
    bool has_wide_floats; /* excess precision */
    bool wraps_signed;
} block_flags;

typedef struct changes {
    const char *statement[24]; /* each one may be executed between two calls */
    int count;
} changes;

typedef struct attack {
    uint64_t seed;
    random_source random;
    arena *memory;
    const block_flags *flags;
    const bool *without; /* by number of statement: to be left out; NULL: none */
    int statements;      /* numbered so far */
    int features;        /* made so far; part of the suffix */
    buffer parts[PART_COUNT];
    changes changes;
    buffer kinds; /* names of the features, for the one who looks at a failure */
    const char
        *element; /* the type of the array that is reduced, `h`, and of `x`, which may overlap it */
    bool is_floating;
    const char *counter_type;
    int trips;    /* positions `t` lie in 0 ... trips - 1 */
    int elements; /* subscripts lie in 0 ... elements - 1 */
    int limit;    /* elements that may be read behind `x` */
} attack;

/** What a feature gives. */
typedef struct operand {
    const char *text;
    bool is_integer;   /* else floating; an integer fits into an int */
    bool is_subscript; /* in 0 ... elements - 1 as it is */
    const char *guard; /* NULL, or what must hold where the text is evaluated */
} operand;

/* ---- skeleton.c */

const char *text(attack *a, const char *format, ...) __attribute__((format(printf, 2, 3)));
void put(attack *a, part where, const char *format, ...) __attribute__((format(printf, 3, 4)));
bool chance(attack *a, int percent);
int below(attack *a, int n);
const char *one_of(attack *a, int count, const char *const *choices);
/** `statement` may be executed between two calls of the kernel. */
void may_change(attack *a, const char *format, ...) __attribute__((format(printf, 2, 3)));
/** A static table `name$` of `trips` + SPARE ints in 0 ... below - 1; one element may change, in
 * the second half of the range that begins at `first` and has as many elements as there are
 * positions. */
void put_table(attack *a, const char *name, int below, int first);
/** Notes the name of what this feature does. */
void note(attack *a, const char *kind);
/** The program of this seed. Returns how many statements it has. */
int put_attack(buffer *b, uint64_t seed, const bool *without);

/* ---- flags.c */

const block_flags *flags_of_block(uint64_t block);

/* ---- one file a kind of attack */

typedef operand feature(attack *a);
feature wrapped_extents, hidden_names, shadowed_in_body, addresses_as_values, block_restrict,
    changed_types, names_like_builtins, values_of_the_thread, searches, floating_subscripts,
    odd_text, beside_scalars, made_valid, behind_the_loop, slices, mapped, counters_set_inside,
    masks, held;

#endif
