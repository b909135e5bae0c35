/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * What the runtime and compiled loops share: a loop's description, a thread's part in an execution,
 * bins. redcc/parallel.h and redcc/runtime.h include this file; it includes none, and compiles as
 * C89 with GNU extensions. The fields are part of the interface's version (REDCC_INTERFACE).
 */
#ifndef REDCC_STRUCTURES_H
#define REDCC_STRUCTURES_H

/** In #if: are float and double evaluated in their own types? gcc says 16 instead of 0 where there
 *  are registers for _Float16 as well. */
#define REDCC_EVALUATES_IN_TYPE (__FLT_EVAL_METHOD__ == 0 || __FLT_EVAL_METHOD__ == 16)

__extension__ typedef long long redcc_int;           /**< counts of iterations */
__extension__ typedef unsigned long long redcc_word; /**< keys */
typedef __SIZE_TYPE__ redcc_size;                    /**< bytes */
typedef unsigned int redcc_u32;

typedef enum redcc_operator {
    REDCC_SUM, /**< `+`; also `-` of the contribution */
    REDCC_PRODUCT,
    REDCC_MINIMUM,
    REDCC_MAXIMUM,
    REDCC_AND, /**< bitwise */
    REDCC_OR,
    REDCC_XOR
} redcc_operator;

typedef enum redcc_type {
    REDCC_INT8,
    REDCC_UINT8,
    REDCC_INT16,
    REDCC_UINT16,
    REDCC_INT32,
    REDCC_UINT32,
    REDCC_INT64,
    REDCC_UINT64,
    REDCC_FLOAT,
    REDCC_DOUBLE,
    REDCC_LONG_DOUBLE,
    REDCC_FLOAT_COMPLEX,
    REDCC_DOUBLE_COMPLEX,
    REDCC_OTHER_TYPE /**< no private copies of it can be made; methods without them will do */
} redcc_type;

/** What a result may differ in from the sequential loop's. */
typedef enum redcc_order {
    REDCC_ORDER_SERIAL, /**< in nothing: the same bits at every thread count */
    REDCC_ORDER_FIXED,  /**< the same bits in every run and at every thread count */
    REDCC_ORDER_ANY
} redcc_order;

/** One reduction array of a loop. */
typedef struct redcc_array {
    const char *name;    /**< as the user wrote it: "b", "A->value" */
    redcc_u32 operation; /**< a redcc_operator; here and below the size of an int, whatever
                              -fshort-enums makes of enumerations */
    redcc_u32 type;      /**< a redcc_type */
    redcc_u32 element;   /**< bytes of a scalar element */
    redcc_u32 unit;      /**< bytes of what one touch covers at least, and owners are cut at: a row
                              b[i], or the element where there are no rows */
} redcc_array;

/** One thing a loop reads that, should it overlap a reduction array, forbids running in parallel.
 */
typedef struct redcc_source {
    const char *name;
    int is_subscript; /**< 1: what it holds decides which elements are touched: a plan may be used
                           again only while it is unchanged; and of the following */
} redcc_source;

enum {
    /** A scalar that the loop adds to, in memory: nothing else of the loop may be it, neither an
     *  array, nor another such scalar, */
    REDCC_IS_SCALAR = 2,
    /** nor a source that is not known to be apart. */
    REDCC_MEETS_SCALARS = 4
};

/** Any function, by its address. */
typedef void (*redcc_code)(void);

/** What a file that defines a function says of it: beside the function, in the same object. Two
 * parses of one definition have one digest; `own` is that definition, whatever the linker puts in
 * its place. A file that redcc-cc compiles without redcc's headers has it in its own words
 * (tool/redcc/records.c). */
typedef struct redcc_record {
    const char *name;
    redcc_u32 digest[2];
    redcc_code own;
    redcc_size callee_count;
    const struct redcc_callee *callees; /**< that it leads to, as this object calls them */
} redcc_record;

typedef struct redcc_callee {
    const redcc_record *record; /**< NULL: there is none */
    redcc_code called;
} redcc_callee;

/** What a translation rests on. */
typedef struct redcc_expectation {
    const char *name;
    redcc_u32 digest[2];
} redcc_expectation;

/** The functions that an object's loops call, and what they and all that they lead to must be. */
typedef struct redcc_linkage {
    const redcc_callee *called;
    redcc_size count;
    const redcc_expectation *expected;
    redcc_size expected_count;
} redcc_linkage;

/** Structures that a compiler option packs (-fpack-struct) are not those of the library. */
typedef char redcc_structures_are_packed[sizeof(redcc_source) == 2 * sizeof(void *) ? 1 : -1]
    __attribute__((__unused__));

enum {
    /** The subscripts depend on nothing but the key, the trip count and the sources marked
     *  is_subscript, listed in the order in which the slice reads them, so that a plan may be used
     *  again once these are found unchanged. Without it every execution inspects anew. */
    REDCC_VERIFIABLE = 1,
    /** The order was asked for explicitly at translation (not just the default). */
    REDCC_ORDER_EXPLICIT = 2,
    /** Some update needs the order of each element kept: only methods that promise it will do. */
    REDCC_ORDER_NEEDED = 4,
    /** Iterations that touch no element are to be executed as well. */
    REDCC_EVERY_ITERATION = 8,
    /** The descriptor is the first member of a redcc_binned (redcc/bins.h). */
    REDCC_BINNED = 16,
    /** Its executor can prefetch what iterations to come touch (prefetch.h). */
    REDCC_PREFETCHES = 32,
    /** Times 2 or 4: so many iterations at once are executed (lanes.h), where the processor has
     * AVX2 or */
    REDCC_LANES_UNIT = 64,
    /** whatever it is. */
    REDCC_LANES_ANYWHERE = 1024,
    /** Where the slice read by values that the loop has yet to write, it might read what is not
     *  there. So before an inspection one thread has all iterations told in order; where one would
     *  update what `known` says is read, worker->last becomes 0, and the slice returns at once; */
    REDCC_DRY_RUN = 2048,
    /** the same where redcc_is_over says of what it has told as read. */
    REDCC_DRY_RUN_OF_READS = 4096,
    /** In place of REDCC_PREFETCHES: its iterations are so light that it pays only where they come
     *  in no order. */
    REDCC_LIGHT = 8192,
    /** Its executor says of iterations whose rows they touch, where redcc_next gives
     *  REDCC_SELECT. */
    REDCC_SELECTS = 16384,
    /** Without loops or calls inside: a few iterations are not worth asking the runtime. */
    REDCC_SHORT = 32768,
    /** A person wrote the slice: REDCC_VALIDATE looks whether it names all that is updated. */
    REDCC_BY_HAND = 65536,
    /** An assertion in a function that its slice calls may end the program. */
    REDCC_MAY_ABORT = 131072,
    /** Guarded iterations leave out what updates nothing of the thread's. */
    REDCC_PARTS = 262144,
    /** REDCC_BINNED: before any iteration is pushed, all of them tell what they read and update,
     * and these must not overlap. */
    REDCC_BINS_CHECKED = 524288,
    /** The attempt says how many threads the program asks for. */
    REDCC_TEAM = 1048576
};

enum {
    /** What redcc_next gives in place of 1: the class of each iteration first, first + 1, ... <
     *  last is to be written to the bytes at `entry` (REDCC_SELECTED of them at most), then comes
     *  the next call. Within `window` is what the thread owns. */
    REDCC_SELECT = 2,
    REDCC_SELECTED = 128,
    /** A class is 0 or a sum of these: something that the thread owns is touched, something else
     *  is. */
    REDCC_CLASS_OWN = 1,
    REDCC_CLASS_OTHERS = 2,
    /** The first byte that it touches is the thread's: of all threads that execute it one leads. */
    REDCC_CLASS_LEADS = 4,
    /** What redcc_bins_next gives: 0 where there are no more bins; iterations; or that some are in
     *  between, which redcc_next hands out, before the next call. */
    REDCC_HANDED = 1,
    REDCC_BETWEEN = 2
};

/** In the place of a source: an iteration leaves the loop (redcc_iteration_leaves). */
#define REDCC_LEAVES 0xffffffffu

/** A loop, as the translator knows it; one static object for each. */
typedef struct redcc_loop {
    const char *file;
    int line;
    const char *function;
    redcc_u32 order; /**< a redcc_order, asked for at translation; REDCC_ORDER overrides it */
    unsigned flags;
    unsigned array_count;
    const redcc_array *arrays;
    unsigned source_count;
    const redcc_source *sources;
    unsigned key_count;
    void *state; /**< the runtime's; starts as 0 */
} redcc_loop;

/** Bytes [first, end). In `known`, end == 0 says: not known before the inspection, redcc_read tells
 *  it; first is then the pointer that its addresses move with when a plan is used again. 0: none,
 * also where they lie in several objects: of a plan that is kept, all bytes between the first and
 * the last one read are compared. */
typedef struct redcc_extent {
    const char *first;
    const char *end;
} redcc_extent;

/** One execution of a loop; lives on the caller's stack from redcc_enter to redcc_leave. */
typedef struct redcc_call {
    redcc_loop *loop;
    redcc_int trip;                  /**< iterations */
    int threads;                     /**< ask OpenMP for so many */
    int decided;                     /**< the runtime's, as what follows */
    void *execution;                 /**< */
    const struct redcc_calls *calls; /**< what inline functions call */
} redcc_call;

/** Consecutive iterations of a chunk, relative to its origin. */
typedef struct redcc_iterations {
    redcc_u32 begin;
    redcc_u32 count_and_guard; /**< 2 * count + (each write must ask redcc_owns ? 1 : 0) */
} redcc_iterations;

struct redcc_hook;

/** The elements of one array that a thread owns: those at [first, first + size), where there is a
 *  map only those in units that it gives to `self`. */
typedef struct redcc_owner {
    const char *first;
    redcc_size size;
    const unsigned char *map; /* the owner of each unit from `first`; 0: no map */
    redcc_size unit;          /* bytes; of a map */
    redcc_u32 self;
    struct redcc_hook *hook; /* 0, or: it decides, and sees every update (nothing is inside) */
} redcc_owner;

/** An address told to the inspector, or (array == REDCC_END_OF_ITERATION) the end of an iteration.
 */
typedef struct redcc_entry {
    const char *address;
    redcc_u32 array;
    redcc_u32 bytes;
} redcc_entry;

#define REDCC_END_OF_ITERATION 0xffffffffu

/** So many iterations in a row within the window, and the next ones are probed (redcc_is_settled).
 *  Where owners alternate, hardly any iteration is looked at twice. */
#define REDCC_SETTLED 8
/** Bytes that redcc_touch takes at most. */
#define REDCC_LONGEST_TOUCH 0x40000000

/** How a chunk is executed, beside what it computes. */
typedef struct redcc_manner {
    int prefetches; /**< is what iterations to come touch to be prefetched? */
    int lanes;      /**< iterations at once, as the descriptor has it; 0: one by one */
    int follows;    /**< another thread keeps what the guarded iterations add to series */
} redcc_manner;

/** One thread's part in an execution; lives on that thread's stack. */
typedef struct redcc_worker {
    redcc_call *call;
    /* set by redcc_inspect: tell the addresses of iterations first, first + stride, ... < last */
    redcc_int first;
    redcc_int last;
    redcc_int stride;
    redcc_entry *entry; /* the next free one */
    redcc_entry *entry_end;
    const redcc_owner *window; /* what one owner owns; indexed as arrays. A touch within it makes
                                  no entry, */
    int inside;                /* it only sets this, */
    int outside;               /* and one that makes an entry sets that; of this iteration */
    redcc_int alike;           /* whole iterations within the window since the last flush */
    redcc_extent *sources;     /* of this thread; indexed as redcc_loop.sources */
    /* set by redcc_next: the chunk */
    redcc_int origin;
    const redcc_iterations *run;
    const redcc_iterations *run_end;
    void *const *base;        /* where to write, as if it were the array; indexed as arrays */
    const redcc_owner *owner; /* indexed as arrays; in a dry run, as sources: what was found to be
                                 none of what is updated */
    void *execution;          /* the runtime's, as what follows */
    int thread;
    redcc_manner manner; /* set by redcc_next */
    redcc_int position;
} redcc_worker;

/* ---- bins (redcc/bins.h) ---- */

typedef unsigned short redcc_u16;

enum {
    /** Arrays that one record may update, at one subscript. */
    REDCC_STREAM_ARRAYS = 4,
    /** Bits of a place: the row within its bin, and above it the update's number. */
    REDCC_PLACE_BITS = 16,
    REDCC_MOST_TAG_BITS = 8,
    REDCC_BLOCK_RECORDS = 1024, /**< that lie together */
    REDCC_LINE_PLACES = 32,     /**< that fill a cache line */
    REDCC_CACHE_LINE = 64,      /**< bytes */
    REDCC_RECORDS_AHEAD = 16    /**< to be prefetched */
};

/** Records to apply, in this order. */
typedef struct redcc_applied {
    void *const *rows;      /**< of each array of the stream: its row at place 0 */
    const redcc_u16 *place; /**< [count + ahead] */
    const void *records;    /**< [count] */
    redcc_size count;
    redcc_size ahead;     /**< so many places behind the one at hand may be prefetched; or 0 */
    const void *operands; /**< what redcc_bins_next was given */
} redcc_applied;

/** Updates that must be applied in order: all those of an array, or of several at one subscript. */
typedef struct redcc_stream {
    /** Applies records: the text of the updates. May write nothing but the rows. */
    void (*apply)(const redcc_applied *applied);
    redcc_u32 array_count;                 /**< 1 to REDCC_STREAM_ARRAYS */
    redcc_u32 arrays[REDCC_STREAM_ARRAYS]; /**< numbers in the loop's arrays; no array is in two
                                                streams */
    redcc_u32 rows[REDCC_STREAM_ARRAYS];   /**< bytes of a row of each: that array's `unit` */
    redcc_u32 record; /**< bytes of a record, even; 0: the contribution is a constant */
    redcc_u32 tag_bits;
    int exact; /**< all updates of an array are by its operator, on integers: they may be made in
                    any order, and on private copies */
} redcc_stream;

/** A loop that can be binned; loop.flags has REDCC_BINNED. */
typedef struct redcc_binned {
    redcc_loop loop;
    redcc_u32 stream_count;
    const redcc_stream *streams;
} redcc_binned;

struct redcc_bin_buffer;

/** One thread's bins of one stream. Constant while a chunk of iterations is executed: generated
 *  code has a copy of it. */
typedef struct redcc_bins {
    redcc_int first;   /* row at place 0 of bin 0 */
    redcc_size span;   /* rows that the bins hold; 0: none, rows are only counted */
    redcc_u32 shift;   /* of a row to its bin */
    redcc_u32 *cursor; /* of each bin: the number of its next record */
    char *records;     /* by their numbers */
    redcc_u16 *places; /* by the records' numbers */
    char *lines;       /* write combining: of each bin the lines that are being filled; or 0 */
    char *copy[REDCC_STREAM_ARRAYS]; /* private copies: of each array, of row `first`; or 0 */
    const void *operands;
    struct redcc_bin_buffer *buffer;
    const struct redcc_calls *calls;
} redcc_bins;

typedef struct redcc_series redcc_series;
typedef struct redcc_series_part redcc_series_part;
typedef struct redcc_series_writer redcc_series_writer;

struct redcc_attempt;

/** The same for redcc/series.h. */
typedef struct redcc_series_calls {
    void (*join)(redcc_series_writer *writer, redcc_series *series);
    int (*room)(redcc_series_writer *writer, redcc_int k);
    int (*again)(redcc_worker *worker, redcc_series_writer *writers, redcc_u32 count);
    int (*is_over)(const redcc_worker *worker);
    int (*has_any)(const redcc_series *series);
    const redcc_series_part *(*find)(const redcc_series *series, redcc_int *k);
    /** Gives back all that the loop's operands were kept in. */
    void (*give)(const struct redcc_attempt *attempt);
} redcc_series_calls;

/** What is asked before a loop begins. */
typedef struct redcc_before_calls {
    /** Can no other thread of the process run before the loop is over? */
    int (*is_alone)(redcc_loop *loop);
    /* Pointers that a loop reads under conditions only are read before it. */
    /** 0: not in this execution, for the loop is executed too often. */
    int (*may_load)(const redcc_loop *loop, redcc_word *last);
    /** Reads `bytes` bytes at `from`, if they can be read: 1. Never a fault. */
    int (*load)(void *to, const char *from, redcc_size bytes);
} redcc_before_calls;

struct redcc_kept_row;

/**
 * What inline functions call while a loop is inspected and executed. A thread reaches it by its
 * worker and its bins, so that an object with loops refers to none of these functions by name.
 * Later versions append. redcc/runtime.h describes each.
 */
typedef struct redcc_calls {
    redcc_u32 version; /**< a REDCC_INTERFACE */
    redcc_u32 bytes;   /**< of this table */
    int (*inspect)(redcc_worker *worker);
    void (*flush)(redcc_worker *worker);
    int (*is_stale)(redcc_worker *worker, redcc_u32 source);
    int (*next)(redcc_worker *worker);
    int (*claims_last)(redcc_worker *worker);
    int (*hooked)(struct redcc_hook *hook, const void *address);
    int (*bins_next)(redcc_worker *worker, redcc_bins *bins, const void *operands);
    void (*push_outside)(struct redcc_bin_buffer *buffer, redcc_int row);
    redcc_u32 (*push_block)(struct redcc_bin_buffer *buffer, redcc_size bin, redcc_u32 record);
    /* redcc/parallel.h alone: */
    const redcc_int *least_trip;
    redcc_int *unasked_iterations;
    const int *timed_loops;
    void (*sequential_end)(redcc_loop *loop);
    /** Sets `bytes` bytes to the neutral elements of the array's operator. */
    void (*fill)(const redcc_array *array, void *values, redcc_size bytes);
    /** Brings rows into their arrays, in order: under locks, or as compensated sums. */
    void (*settle)(redcc_worker *worker, const struct redcc_kept_row *kept, int count);
    /** Ends the program with a message: the rules of redcc/parallel.h are broken. */
    void (*misuse)(const redcc_worker *worker, const char *rule);
    const redcc_series_calls *series;
    const redcc_before_calls *before;
} redcc_calls;

#endif
