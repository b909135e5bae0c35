/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * One random program: a loop around irregular reductions, the memory it works on, and the function
 * that calls it. The text is a function of the seed. It has no undefined behaviour, by
 * construction: subscripts   lie in 0 ... elements - 1: subscript arrays hold nothing else, and are
 * masked where something may write them; positions lie below `size`, the length of every array
 *   integers     of contributions are at most 127 in size, so that no sum overflows
 *   floats       are bounded where an array that is accumulated into may be read
 *   variables    are assigned before they are read
 *   pointers     to different types never lead to the same bytes, but for characters
 */
#ifndef FUZZ_KERNEL_H
#define FUZZ_KERNEL_H

#include "fuzz/random.h"
#include "support/arena.h"
#include "support/buffer.h"

typedef enum element {
    E_DOUBLE,
    E_FLOAT,
    E_LONG_DOUBLE,
    E_COMPLEX,
    E_INT,
    E_UNSIGNED,
    E_LONG,
    E_ULLONG,
    E_SHORT,
    E_USHORT,
    E_SCHAR,
    E_UCHAR,
    ELEMENT_COUNT
} element;

typedef enum shape {
    SHAPE_FLAT,   /* h[k] */
    SHAPE_ROWS,   /* h[k][c], c < 3 */
    SHAPE_RECORDS /* h[k].x, h[k].y; h[k].tag is input */
} shape;

typedef enum storage {
    STORAGE_PARAMETER,
    STORAGE_RESTRICT,
    STORAGE_GLOBAL,
    STORAGE_CONTEXT, /* c->h, of a struct that is given by its address */
    STORAGE_VALUE,   /* c.h, of a struct that is given by value */
    STORAGE_POINTER, /* a local pointer to the object */
    STORAGE_GLOBAL_POINTER,
    STORAGE_LOCAL, /* the kernel's own, copied from the object and back */
    STORAGE_STATIC_LOCAL,
    STORAGE_VARIABLE_LENGTH
} storage;

typedef struct array {
    const char *base;   /* as the kernel spells it */
    const char *object; /* the static array behind it */
    const char *given;  /* what the caller passes: the object, or what it overlaps with */
    const char *record; /* the type of records */
    element type;
    shape shape;
    storage storage;
    const char *operation; /* of a reduction array: "+", "*", "&", "|", "^", "<", ">" */
    bool is_member;        /* the object is a member of one that holds others as well */
    bool is_no_integer;    /* its floating values are no small integers any more */
} array;

enum { MOST_NAMES = 24, REDUCTIONS = 2, SUBSCRIPTS = 2 };

/** Variables in scope, of one kind. */
typedef struct names {
    const char *name[MOST_NAMES];
    int count;
} names;

typedef struct scope {
    names subscripts; /* integer variables in 0 ... elements - 1 */
    names values;     /* floating-point variables of a few bits */
    names positions;  /* in 0 ... size - 64 */
    names smalls;     /* in 0 ... 2 */
    int depth;        /* of blocks in the loop's body; 0: always executed */
    bool in_loop;     /* inside an inner loop */
    bool can_skip;    /* which goes on by itself after a `continue` */
} scope;

typedef struct kernel {
    uint64_t seed;
    random_source random;
    arena *memory;
    const bool *without; /* by number of statement: to be left out; NULL: none */
    int without_count;
    int statements; /* numbered so far */
    int names;      /* made so far */
    buffer globals, pointers, locals, body, after;
    scope scope;
    int size;     /* elements of every array */
    int elements; /* a power of two: subscripts lie below */
    int trips;
    bool is_wide;         /* programs of even seeds: wide.c, more storages, more than one loop */
    bool has_rows;        /* programs of seeds divisible by 5: rows.c */
    bool has_spans;       /* programs of seeds divisible by 3: spans.c */
    bool sets_in_headers; /* of these, of seeds that leave 2, divided by 7 */
    bool has_helpers;     /* programs of seeds divisible by 7: helpers.c */
    bool has_idioms;      /* programs of seeds divisible by 11: idioms.c */
    bool has_strides;     /* programs of seeds divisible by 13: steps that are variables */
    bool has_drains;  /* programs of seeds divisible by 17: read_then_stored, local records, i + 1 <
                         n */
    bool has_parts;   /* programs of seeds that leave 1, divided by 6: loop_over_parts */
    bool has_turns;   /* programs of seeds that leave 6, divided by 7: turns.c */
    bool has_walks;   /* programs of seeds that leave 4, divided by 9: walks.c */
    bool has_pairs;   /* programs of seeds that leave 3, divided by 19: pairs.c */
    bool has_shapes;  /* programs of seeds that leave 1, divided by 3: shapes.c */
    bool has_leaving; /* programs of seeds that leave 2, divided by 6: leave.c */
    bool has_recent;  /* programs of seeds that leave 2, 5, 6 or 9, divided by 10: recent.c */
    bool has_tables;  /* programs of seeds that leave 3, divided by 8: tables.c */
    bool has_lookups; /* programs of seeds that leave 4, divided by 6: lookups.c */
    bool has_held;    /* objects that cannot be written during the calls */
    bool is_masked;   /* subscripts from memory are masked at their use */
    bool is_damped;   /* floating values are bounded at their use */
    bool has_outer_counter;
    const char *trip; /* the bound, as the kernel spells it */
    const char *trip_type;
    bool trip_is_variable;
    const char *counter_type;
    bool has_plain_header; /* for (...; i < n; i++): may step further */
    bool may_continue;
    bool is_integral; /* sums of integers are exact: compared in any order */
    array reduction[REDUCTIONS];
    array subscript[SUBSCRIPTS]; /* the second may be rows of three */
    array value;                 /* double or float */
    array other;                 /* double */
    array flag;                  /* int: any small value */
    array chain;                 /* int: chain[k] < k, or 0 */
    array first;                 /* int: not decreasing, steps below 4 */
    array far;                   /* int: positions; some far out of range */
    array out;                   /* double: written at the own element */
    int live;                    /* values stored after the loop */
} kernel;

/* ---- text */

const char *text(kernel *k, const char *format, ...) __attribute__((format(printf, 2, 3)));
void put(kernel *k, buffer *b, const char *format, ...) __attribute__((format(printf, 3, 4)));
const char *new_name(kernel *k, const char *stem);
bool chance(kernel *k, int percent);
int below(kernel *k, int n);
/** The name becomes known in the scope. */
void add_name(names *list, const char *name);
const char *any_name(kernel *k, const names *list);
/** A statement: an update; a loop over the parts of rows, and updates of them. */
void plain_update(kernel *k);
void loop_over_parts(kernel *k);
/** Begins a numbered statement; end_statement takes it out where it is to be left out. */
size_t begin_statement(kernel *k);
void end_statement(kernel *k, size_t begin);

/* ---- expression.c */

typedef struct element_traits {
    const char *spelling;
    bool is_floating;
    bool is_signed;
} element_traits;
extern const element_traits elements[ELEMENT_COUNT];

const char *position(kernel *k);
const char *subscript(kernel *k);
const char *value(kernel *k, int depth);
const char *integer(kernel *k, int depth);
const char *condition(kernel *k);
/** An element of a reduction array. */
const char *place(kernel *k, const array *a, const char *index);
/** The same by a function of the file that returns the element's or the row's address: helpers.c.
 */
const char *place_by_accessor(kernel *k, const array *a, const char *index);
/** What may be accumulated into `a` by its operation. */
const char *contribution(kernel *k, const array *a);
/** One update of one element, as a statement's text without `;`. */
const char *update(kernel *k, const array *a, const char *where);

/* ---- statement.c, inner.c, stored.c, bait.c, wide.c, rows.c, spans.c, helpers.c, idioms.c,
 * turns.c, walks.c, pairs.c, shapes.c, leave.c, recent.c, tables.c, lookups.c */

void statement(kernel *k);
void block(kernel *k, int count);
void inner_loop(kernel *k);
/** An element that the iteration stores may be read below; or may not, though it looks so. */
void stored_again(kernel *k);
void nearly_stored_again(kernel *k);
/** The iteration's own element of an array is read here; the statement that is returned stores to
 *  it, or to one near. */
const char *read_then_stored(kernel *k);
/** A call in a sum's operand fills an array. */
void filling_operand(kernel *k);
/** Sums into members of a record, by its name or a pointer. */
void sum_in_memory(kernel *k);
void bait(kernel *k);
/** As statement and bait, of kinds that only programs of even seeds have: programs of odd seeds
 * stay what they were when these were added. */
void wide_statement(kernel *k);
void wide_bait(kernel *k);
void rows_behind_pointers(kernel *k);
void loop_along_a_row(kernel *k);
void call_of_helper(kernel *k);
void in_pieces(kernel *k);
void idiom(kernel *k);
void shape_of_an_attack(kernel *k);
void leave_or_look(kernel *k);
void recent_shape(kernel *k);
/** Behind the other loops: one for OpenMP. */
void loop_with_directives(kernel *k);
void loop_along_a_list(kernel *k);
void walk_along_elements(kernel *k);
void call_of_pair(kernel *k);
void tables_by_pointers(kernel *k);
void look_up_by_changed(kernel *k);
array *any_reduction(kernel *k);
/** A variable of the loop that is declared outside of it; `initial` is its first value. */
void declare_outside(kernel *k, const char *type, const char *name, const char *initial);

/* ---- world.c */

void make_world(kernel *k);
/** Declarations of the arrays' memory. */
void put_objects(kernel *k, buffer *b);
/** The kernel's parameters, with parentheses; and the arguments of a call. */
const char *parameters(kernel *k);
const char *arguments(kernel *k);
/** The function that fills the arrays, calls the kernel and prints what is left. */
void put_runner(kernel *k, buffer *b);

/* ---- loop.c, noise.c */

/** Appends the program of this seed; statements whose numbers are in `without` are left out.
 *  Returns how many statements it has. */
int put_kernel(buffer *b, uint64_t seed, const bool *without, int without_count);
/** Odd but equal formatting: blanks, comments and line ends between words. */
void put_with_noise(buffer *b, random_source *r, const char *text);
/** Of some lines, in a branch of a conditional directive, beside others that are not compiled. */
void put_with_branches(buffer *b, random_source *r, const char *text);

#endif
