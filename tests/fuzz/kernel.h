/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * One random program: a loop around irregular reductions, the loop's memory, and the function that
 * calls it. The text depends only on the seed. By construction it has no undefined behaviour:
 *   subscripts   are in 0 ... elements - 1, as are all values of subscript arrays; subscripts are
 *                masked if the arrays may be written
 *   positions    are less than `size`, the length of every array
 *   integers     in contributions have a magnitude of at most 127, so that no sum overflows
 *   floats       are bounded where an updated array may be read
 *   variables    are assigned before they are read
 *   pointers     to different types never point to the same bytes, except pointers to characters
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
    STORAGE_CONTEXT, /* c->h, in a struct that is passed by address */
    STORAGE_VALUE,   /* c.h, in a struct that is passed by value */
    STORAGE_POINTER, /* a local pointer to the object */
    STORAGE_GLOBAL_POINTER,
    STORAGE_LOCAL, /* local to the kernel, copied from the object and back */
    STORAGE_STATIC_LOCAL,
    STORAGE_VARIABLE_LENGTH
} storage;

typedef struct array {
    const char *base;   /* the array's name in the kernel */
    const char *object; /* the static array that `base` denotes or points to */
    const char *given;  /* the caller's argument: the object, or memory that it overlaps */
    const char *record; /* the type of the elements if they are records */
    element type;
    shape shape;
    storage storage;
    const char *operation; /* of a reduction array: "+", "*", "&", "|", "^", "<", ">" */
    bool is_member;        /* the object is a member of a struct that holds other arrays as well */
    bool is_no_integer;    /* its floating-point values are no longer small integers */
} array;

enum { MOST_NAMES = 24, REDUCTIONS = 2, SUBSCRIPTS = 2 };

/** The variables in scope of one kind. */
typedef struct names {
    const char *name[MOST_NAMES];
    int count;
} names;

typedef struct scope {
    names subscripts; /* integer variables in 0 ... elements - 1 */
    names values;     /* floating-point variables with few significant bits */
    names positions;  /* in 0 ... size - 64 */
    names smalls;     /* in 0 ... 2 */
    int depth;        /* depth of nested blocks in the loop's body, or 0 if always executed */
    bool in_loop;     /* inside an inner loop */
    bool can_skip;    /* in an inner loop that continues after a `continue` */
} scope;

typedef struct kernel {
    uint64_t seed;
    random_source random;
    arena *memory;
    const bool *without; /* without[n]: statement n is omitted; NULL: none is */
    int without_count;
    int statements; /* number of statements so far */
    int names;      /* number of names so far */
    buffer globals, pointers, locals, body, after;
    scope scope;
    int size;     /* number of elements of every array */
    int elements; /* a power of two; subscripts are less */
    int trips;
    bool is_wide;         /* seed % 2 == 0: wide.c, more storages, more than one loop */
    bool has_rows;        /* seed % 5 == 0: rows.c */
    bool has_spans;       /* seed % 3 == 0: spans.c */
    bool sets_in_headers; /* has_spans and seed % 7 == 2 */
    bool has_helpers;     /* seed % 7 == 0: helpers.c */
    bool has_idioms;      /* seed % 11 == 0: idioms.c */
    bool has_steps;       /* seed % 9 == 7: put_step_statement */
    bool has_strides;     /* seed % 13 == 0: steps that are variables */
    bool has_drains;      /* seed % 17 == 0: read_then_stored, local records, i + 1 < n */
    bool has_parts;       /* seed % 6 == 1: loop_over_parts */
    bool has_turns;       /* seed % 7 == 6: turns.c */
    bool has_walks;       /* seed % 9 == 4: walks.c */
    bool has_pairs;       /* seed % 19 == 3: pairs.c */
    bool has_shapes;      /* seed % 3 == 1: shapes.c */
    bool has_leaving;     /* seed % 6 == 2: leave.c */
    bool has_recent;      /* seed % 10 is 2, 5, 6 or 9: recent.c */
    bool has_tables;      /* seed % 8 == 3: tables.c */
    bool has_lookups;     /* seed % 6 == 4: lookups.c */
    bool has_held;        /* some objects must not be written while the kernel is called */
    bool is_masked;       /* subscripts from memory are masked at their use */
    bool is_damped;       /* floating-point values are bounded at their use */
    bool has_outer_counter;
    const char *trip; /* the bound's expression in the kernel */
    const char *trip_type;
    bool trip_is_variable;
    const char *counter_type;
    bool has_plain_header; /* for (...; i < n; i++), whose body may step further */
    bool may_continue;
    bool is_integral; /* sums of integers are exact, so results are compared with methods in any
                         order */
    array reduction[REDUCTIONS];
    array subscript[SUBSCRIPTS]; /* the second one may have rows of three */
    array value;                 /* double or float */
    array other;                 /* double */
    array flag;                  /* int: small values */
    array chain;                 /* int: chain[k] < k, or 0 */
    array first;                 /* int: never decreasing, in steps below 4 */
    array far;                   /* int: positions, some far out of range */
    array out;                   /* double: each iteration writes its own element */
    int live;                    /* number of values stored after the loop */
} kernel;

/* ---- text */

const char *text(kernel *k, const char *format, ...) __attribute__((format(printf, 2, 3)));
void put(kernel *k, buffer *b, const char *format, ...) __attribute__((format(printf, 3, 4)));
const char *new_name(kernel *k, const char *stem);
bool chance(kernel *k, int percent);
int below(kernel *k, int n);
/** Adds the name to the list. */
void add_name(names *list, const char *name);
/** Returns a name of the list at random. */
const char *any_name(kernel *k, const names *list);
/** Appends an update. */
void plain_update(kernel *k);
/** Appends a loop over the parts of rows, with updates. */
void loop_over_parts(kernel *k);
/** begin_statement begins a numbered statement. end_statement removes the statement if its number
 * is in `without`. */
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
/** Returns an element of a reduction array. */
const char *place(kernel *k, const array *a, const char *index);
/** Like place, but by a function of the file that returns the address of the element or of the row
 * (helpers.c). */
const char *place_by_accessor(kernel *k, const array *a, const char *index);
/** Returns an expression that may be combined with elements of `a` by its operation. */
const char *contribution(kernel *k, const array *a);
/** Returns one update of one element as a statement without `;`. */
const char *update(kernel *k, const array *a, const char *where);

/* ---- statement.c, inner.c, stored.c, bait.c, wide.c, rows.c, spans.c, helpers.c, idioms.c,
 * turns.c, walks.c, pairs.c, shapes.c, leave.c, lists.c, recent.c, tables.c, lookups.c */

void statement(kernel *k);
void block(kernel *k, int count);
void inner_loop(kernel *k);
/** stored_again appends a store to an element that later statements of the iteration may read. With
 * nearly_stored_again the value that they read may differ from the one stored. */
void stored_again(kernel *k);
void nearly_stored_again(kernel *k);
/** Appends a read of the iteration's own element. Returns a statement that stores to this element
 * or to one next to it. */
const char *read_then_stored(kernel *k);
/** Appends a sum whose operand is a call that fills an array. */
void filling_operand(kernel *k);
/** Appends sums in members of a record, accessed by name or through a pointer. */
void sum_in_memory(kernel *k);
void bait(kernel *k);
/** The functions down to recent_shape append statements only in programs with some seeds, as their
 * files say, so that other seeds yield the same programs as before. */
void wide_statement(kernel *k);
void wide_bait(kernel *k);
void rows_behind_pointers(kernel *k);
void loop_along_a_row(kernel *k);
void call_of_helper(kernel *k);
void in_pieces(kernel *k);
void idiom(kernel *k);
void shape_of_an_attack(kernel *k);
void leave_or_look(kernel *k);
void list_of_row(kernel *k);
void recent_shape(kernel *k);
/** Appends a loop with OpenMP directives, behind the other loops. */
void loop_with_directives(kernel *k);
void loop_along_a_list(kernel *k);
void walk_along_elements(kernel *k);
void call_of_pair(kernel *k);
void tables_by_pointers(kernel *k);
void look_up_by_changed(kernel *k);
array *any_reduction(kernel *k);
/** Declares a variable of the loop outside of it, with the first value `initial`. */
void declare_outside(kernel *k, const char *type, const char *name, const char *initial);

/* ---- world.c */

void make_world(kernel *k);
/** Declares the memory of the arrays. */
void put_objects(kernel *k, buffer *b);
/** Returns the kernel's parameters with parentheses. */
const char *parameters(kernel *k);
/** Returns the arguments of a call of the kernel. */
const char *arguments(kernel *k);
/** Appends the function that fills the arrays, calls the kernel and prints the results. */
void put_runner(kernel *k, buffer *b);

/* ---- loop.c, noise.c */

/** Appends the program of this seed, without statements whose numbers are in `without`. Returns the
 * number of its statements. */
int put_kernel(buffer *b, uint64_t seed, const bool *without, int without_count);
/** Writes the text with unusual but equivalent formatting: blanks, comments and line ends between
 * words. */
void put_with_noise(buffer *b, random_source *r, const char *text);
/** Puts some lines into a branch of a conditional directive, next to lines that are not compiled.
 */
void put_with_branches(buffer *b, random_source *r, const char *text);

#endif
