/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Structures shared by the runtime and compiled loops: a loop's description, a thread's part in an
 * execution, bins. redcc/parallel.h and redcc/runtime.h include this file. It includes none, and
 * compiles as C89 with GNU extensions. The fields are part of the interface's version
 * (REDCC_INTERFACE).
 */
#ifndef REDCC_STRUCTURES_H
#define REDCC_STRUCTURES_H

/** For #if: are float and double evaluated in their own types? gcc gives 16 instead of 0 if it has
 *  registers for _Float16 as well. */
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
    REDCC_SATURATING, /**< 1 is added while the element is below the array's limit */
    REDCC_AND,        /**< bitwise */
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
    REDCC_OTHER_TYPE /**< no private copies are possible; only methods without them apply */
} redcc_type;

/** How a result may differ from that of the sequential loop. */
typedef enum redcc_order {
    REDCC_ORDER_SERIAL, /**< not at all: the same bits at every thread count */
    REDCC_ORDER_FIXED,  /**< the same bits in every run and at every thread count */
    REDCC_ORDER_ANY
} redcc_order;

/** One reduction array of a loop. */
typedef struct redcc_array {
    const char *name;    /**< as the user wrote it: "b", "A->value" */
    redcc_u32 operation; /**< a redcc_operator; stored in 32 bits, because -fshort-enums changes the
                          * size of enumerations */
    redcc_u32 type;      /**< a redcc_type */
    redcc_u32 element;   /**< bytes of a scalar element */
    redcc_u32 unit;      /**< bytes of a row b[i], or of an element if there are no rows: touches
                          * cover whole units, and each unit has one owner */
    redcc_word limit;    /**< REDCC_SATURATING: above 0, a value of the type */
} redcc_array;

/** An object that the loop reads. If it overlaps a reduction array, the loop must not run in
 *  parallel. */
typedef struct redcc_source {
    const char *name;
    int flags; /**< bits of the following */
} redcc_source;

enum {
    /** Its contents determine which elements are touched: a plan is reused only while they are
     *  unchanged. */
    REDCC_IS_SUBSCRIPT = 1,
    /** A scalar in memory to which the loop adds: it must not overlap an array of the loop, another
     *  such scalar, or a source with the next bit. */
    REDCC_IS_SCALAR = 2,
    /** A source that was not proved disjoint from such scalars. */
    REDCC_MAY_OVERLAP_SCALARS = 4,
    /** A source that is disjoint from all arrays, although it may lie between their elements
     * (another member of their structures). It may overlap only scalars. */
    REDCC_OVERLAPS_NO_ARRAY = 8
};
/** Elements that belong to one iteration count as such scalars (REDCC_IS_SCALAR). This flag
 * identifies their base: two such sources with the same base are disjoint. */
#define REDCC_SCALAR_BASE(redcc_base) ((redcc_base)*256)

/** The address of any function. */
typedef void (*redcc_code)(void);

/** Describes a function's definition; emitted in the object that defines it. The digest depends
 * only on the definition. `own` is the address of this definition, even if the linker substitutes
 * another. A file that redcc-cc compiles without redcc's headers declares the structure itself
 *  (tool/redcc/records.c). */
typedef struct redcc_record {
    const char *name;
    redcc_u32 digest[2];
    redcc_code own;
    redcc_size callee_count;
    const struct redcc_callee *callees; /**< functions that it calls, as this object calls them */
} redcc_record;

typedef struct redcc_callee {
    const redcc_record *record; /**< NULL: there is none */
    redcc_code called;
} redcc_callee;

/** A definition that a translation relies on. */
typedef struct redcc_expectation {
    const char *name;
    redcc_u32 digest[2];
} redcc_expectation;

/** The functions that an object's loops call, and the definitions on which the translation relies.
 */
typedef struct redcc_linkage {
    const redcc_callee *called;
    redcc_size count;
    const redcc_expectation *expected;
    redcc_size expected_count;
} redcc_linkage;

/** Fails to compile if -fpack-struct packs structures, since those of the library are not packed.
 */
typedef char redcc_structures_are_packed[sizeof(redcc_source) == 2 * sizeof(void *) ? 1 : -1]
    __attribute__((__unused__));

enum {
    /** The subscripts depend only on the key, the trip count and the sources marked
     *  REDCC_IS_SUBSCRIPT, so that a plan may be reused if these are unchanged. The sources are
     * listed in the order in which the slice reads them. Without the flag every execution inspects
     * again. */
    REDCC_VERIFIABLE = 1,
    /** The order was named explicitly at translation, not by default. */
    REDCC_ORDER_EXPLICIT = 2,
    /** Some update requires that each element's updates keep their order: only methods that
     * guarantee this apply. */
    REDCC_ORDER_NEEDED = 4,
    /** Iterations that touch no element must be executed, too. */
    REDCC_EVERY_ITERATION = 8,
    /** The descriptor is the first member of a redcc_binned. */
    REDCC_BINNED = 16,
    /** Its executor can prefetch what later iterations touch (prefetch.h). */
    REDCC_PREFETCHES = 32,
    /** Multiplied by 2 or 4: the number of iterations executed at once (lanes.h). x86-64: with
     * AVX2. */
    REDCC_LANES_UNIT = 64,
    /** The same on any processor. */
    REDCC_LANES_ANYWHERE = 1024,
    /** The slice may read through values that the loop has not written yet, and so read invalid
     *  addresses. Therefore one thread first records all iterations in order, before the
     * inspection. If an iteration would update an address in `known`, worker->last becomes 0 and
     * the slice returns immediately. */
    REDCC_DRY_RUN = 2048,
    /** The same, also for an update of an address that was recorded as read (redcc_is_over). */
    REDCC_DRY_RUN_OF_READS = 4096,
    /** Replaces REDCC_PREFETCHES: the iterations are so light that prefetching pays only if their
     *  accesses are irregular. */
    REDCC_LIGHT = 8192,
    /** Its executor classifies iterations by the rows they touch when redcc_next returns
     *  REDCC_SELECT. */
    REDCC_SELECTS = 16384,
    /** Iterations contain no loops or calls: a few of them are not worth a call of the runtime. */
    REDCC_SHORT = 32768,
    /** The slice is written by hand: REDCC_VALIDATE checks that it names all updated rows. */
    REDCC_BY_HAND = 65536,
    /** An assertion in a function that its slice calls may end the program. */
    REDCC_MAY_ABORT = 131072,
    /** Owner-checked iterations skip parts that update no element of the thread. */
    REDCC_PARTS = 262144,
    /** REDCC_BINNED: before any iteration is pushed, all iterations record their reads and updates,
     *  and these must not overlap. */
    REDCC_BINS_CHECKED = 524288,
    /** The attempt has the number of threads that the program requests. */
    REDCC_TEAM = 1048576,
    /** Its executor understands REDCC_TILE: the loop is over pairs. The counter of the inner loop
     * is above that of the outer loop. */
    REDCC_TILES = 2097152,
    /** The same, with an inner counter below the outer one. */
    REDCC_TILES_BELOW = 4194304,
    /** REDCC_BINNED: the slice records no updates, so that no plan can be made. */
    REDCC_NO_INSPECTOR = 8388608,
    /** The attempt has the section of each array that OpenMP's clause `reduction` names; all
     * updates are inside it. */
    REDCC_SECTIONED = 16777216,
    /** An update might change a value that the executor reads before the loop (the bound of its
     *  counter, the copy of a variable), or an element that is stored after it. So no update may be
     *  made, not even in order, before it is known that none does. */
    REDCC_WHOLE = 33554432,
    /** Iterations are heavy, so the first ones may be executed in order before the loop is
     * inspected. The others are the same loop with another first iteration. */
    REDCC_BEGINS = 67108864,
    /** Rows of inner loops are recorded block by block: an inspection is short, however heavy
     *  iterations are. */
    REDCC_BLOCKS = 134217728,
    /** Its executor may execute the first iterations by owners and the others in order: no value is
     * read before the loop, or kept until its end, that an update might change. So whether an
     * iteration stays within its fences (REDCC_SELECT) need not be known before the loop. */
    REDCC_FENCED = 268435456
};

enum {
    /** A result of redcc_next: the class of each iteration first, first + 1, ... < last must be
     * written to the bytes at `entry` (at most REDCC_SELECTED of them) before the next call.
     * `window` is the range that the thread owns, `owner` the fence of each array's updates,
     * `sources` that of each source's reads. At the first iteration that leaves a fence, `last` is
     * set to it, and no later iteration is classified. */
    REDCC_SELECT = 2,
    REDCC_SELECTED = 128,
    /** A result of redcc_next: the thread must execute `variant.tile`, of at most REDCC_TILE_ROWS
     *  iterations. */
    REDCC_TILE = 3,
    REDCC_TILE_ROWS = 256,
    /** A class is a sum of these: the iteration touches an element that the thread owns; it touches
     *  another element. */
    REDCC_CLASS_OWN = 1,
    REDCC_CLASS_OTHERS = 2,
    /** This thread is the leader of the threads that execute the iteration: it owns the leading row
     *  (redcc_probe_first). */
    REDCC_CLASS_LEADS = 4,
    /** Results of redcc_bins_next. 0: no chunks are left. TO_PUSH: a chunk whose updates must be
     * pushed. TO_EXECUTE: call redcc_next for chunks first. */
    REDCC_TO_PUSH = 1,
    REDCC_TO_EXECUTE = 2
};

/** Replaces a source's number: an iteration leaves the loop (redcc_iteration_leaves). */
#define REDCC_LEAVES 0xffffffffu

/** A loop, as the translator describes it; one static object for each. */
typedef struct redcc_loop {
    const char *file;
    int line;
    const char *function;
    redcc_u32 order; /**< a redcc_order, set at translation; REDCC_ORDER overrides it */
    unsigned flags;
    unsigned array_count;
    const redcc_array *arrays;
    unsigned source_count;
    const redcc_source *sources;
    unsigned key_count;
    void *state; /**< owned by the runtime; initially 0 */
} redcc_loop;

/** Bytes [first, end). In `known`, end == 0 means that the range is not known before the
 * inspection. Then redcc_read records the addresses, and `first` is the pointer to which they are
 * relative when a plan is reused. first == 0: no such pointer, or the addresses lie in several
 * objects. For a kept plan, all bytes between the first and the last one read are compared. */
typedef struct redcc_extent {
    const char *first;
    const char *end;
} redcc_extent;

/** One execution of a loop; lives on the caller's stack from redcc_enter to redcc_leave. */
typedef struct redcc_call {
    redcc_loop *loop;
    redcc_int trip;                  /**< iterations */
    int threads;                     /**< number of threads to request from OpenMP */
    int decided;                     /**< owned by the runtime */
    void *execution;                 /**< owned by the runtime */
    const struct redcc_calls *calls; /**< functions that the inline functions call */
} redcc_call;

/** Consecutive iterations of a chunk, relative to its origin. */
typedef struct redcc_iterations {
    redcc_u32 begin;
    redcc_u32 count_and_check; /**< 2 * count + (each write must test the owner ? 1 : 0) */
} redcc_iterations;

struct redcc_hook;

/** The elements of one array that a thread owns: those at [first, first + size); with a map, only
 *  those in units that the map gives to `self`. */
typedef struct redcc_owner {
    const char *first;
    redcc_size size;
    const unsigned char *map; /* the owner of each unit from `first`; 0: no map */
    redcc_word reciprocal;    /* for a division by `unit`; 0: none (redcc_unit_number) */
    redcc_u32 self;
    redcc_u32 unit;          /* with a map: bytes of a unit */
    struct redcc_hook *hook; /* not 0: the hook decides about each update, and the range is empty */
} redcc_owner;

/** An address recorded by the inspector, or (array == REDCC_END_OF_ITERATION) the end of an
 *  iteration. */
typedef struct redcc_entry {
    const char *address;
    redcc_u32 array;
    redcc_u32 bytes;
} redcc_entry;

#define REDCC_END_OF_ITERATION 0xffffffffu

/** After this many consecutive iterations within the owned range the next ones are probed
 *  (redcc_is_settled). If owners alternate, hardly any iteration is inspected twice. */
#define REDCC_SETTLED 8
/** worker->alike in a dry run is negative: at most this if the next iterations are probed, because
 *  all ranges that they must not touch are known; otherwise greater. */
#define REDCC_DRY_PROBED (-((redcc_int)1 << 61))
/** The largest number of bytes that redcc_touch accepts. */
#define REDCC_LONGEST_TOUCH 0x40000000

/** Part of a loop over pairs: outer iterations `row` to before `row_end`, and of these the inner
 * iterations whose counter is `column` to before `column_end` steps after the loop's first value. A
 * thread gets all tiles of a band of rows, one after the other. */
typedef struct redcc_tile {
    redcc_int row, row_end;
    redcc_int column, column_end;
    int is_first; /**< the first tile of its rows */
    int is_last;  /**< the last tile of its rows, with all inner iterations from `column` on */
} redcc_tile;

/** How a chunk is executed; it does not affect the result. */
typedef struct redcc_variant {
    int prefetches; /**< are rows of later iterations prefetched? */
    int lanes;      /**< iterations at once, as in the descriptor; 0: one by one */
    int follows;    /**< owner-checked iterations: another thread stores the operands of series */
    const redcc_tile *tile; /**< after REDCC_TILE: the tile to execute */
} redcc_variant;

/** One thread's part in an execution; lives on that thread's stack. */
typedef struct redcc_worker {
    redcc_call *call;
    /* set by redcc_inspect: record the addresses of iterations first, first + stride, ... < last */
    redcc_int first;
    redcc_int last;
    redcc_int stride;
    redcc_entry *entry; /* the next free entry */
    redcc_entry *entry_end;
    const redcc_owner *window; /* the range of one owner, for each array. A touch within it makes no
                                * entry */
    int inside;                /* the current iteration has a touch within the range */
    int outside;               /* the current iteration has a touch that made an entry */
    redcc_int alike;           /* consecutive iterations within the range since the last flush */
    redcc_extent *sources;     /* this thread's copies; indexed as redcc_loop.sources */
    /* set by redcc_next: the chunk */
    redcc_int origin;
    const redcc_iterations *run;
    const redcc_iterations *run_end;
    void *const *base;        /* for each array: the base to write to (perhaps of a copy) */
    const redcc_owner *owner; /* for each array; in a dry run, for each source: ranges found
                               * disjoint from all updates; after REDCC_SELECT, for each array: its
                               * fence */
    void *execution;          /* owned by the runtime, as are the fields below */
    int thread;
    redcc_variant variant; /* set by redcc_next */
    redcc_int position;
} redcc_worker;

/* ---- bins (redcc/bins.h) ---- */

typedef unsigned short redcc_u16;

enum {
    /** Maximum number of arrays that one record updates, at one subscript. */
    REDCC_STREAM_ARRAYS = 4,
    /** Bits of a place: the row within its bin, and above it the number of the update. */
    REDCC_PLACE_BITS = 16,
    REDCC_MOST_TAG_BITS = 8,
    REDCC_BLOCK_RECORDS = 1024, /**< records of a contiguous block */
    REDCC_LINE_PLACES = 32,     /**< places in a cache line */
    REDCC_CACHE_LINE = 64,      /**< bytes */
    REDCC_RECORDS_AHEAD = 16    /**< prefetch distance in records */
};

/** Records to apply, in this order. */
typedef struct redcc_applied {
    void *const *rows;      /**< for each array of the stream, its row at place 0 */
    const redcc_u16 *place; /**< [count + ahead] */
    const void *records;    /**< [count] */
    redcc_size count;
    redcc_size ahead;     /**< prefetch distance in places; 0: no prefetches */
    const void *operands; /**< the operands given to redcc_bins_next */
    redcc_size row_count; /**< rows of the bin */
} redcc_applied;

enum { REDCC_STREAM_EXACT = 1, REDCC_STREAM_SPANS = 2 };

/** Updates that must be applied in order: all those of an array, or of several arrays at one
 *  subscript. */
typedef struct redcc_stream {
    /** Applies records: contains the text of the updates. Writes only to the rows. */
    void (*apply)(const redcc_applied *applied);
    redcc_u32 array_count;                 /**< 1 to REDCC_STREAM_ARRAYS */
    redcc_u32 arrays[REDCC_STREAM_ARRAYS]; /**< their indices in the loop's arrays; no array is in
                                              two streams */
    redcc_u32 rows[REDCC_STREAM_ARRAYS];   /**< for each, the bytes of a row: the array's `unit` */
    redcc_u32 record; /**< bytes of a record, even; 0: the contribution is a constant */
    redcc_u32 tag_bits;
    int exact; /**< REDCC_STREAM_EXACT: all updates use the array's operator, on integers: any
                  order, and private copies, are possible. REDCC_STREAM_SPANS: a record covers
                  consecutive rows, and is in each bin that has some of them. Or 0 */
} redcc_stream;

/** A loop that can be binned; loop.flags has REDCC_BINNED. */
typedef struct redcc_binned {
    redcc_loop loop;
    redcc_u32 stream_count;
    const redcc_stream *streams;
} redcc_binned;

struct redcc_bin_buffer;

enum { REDCC_PAGE = 4096 }; /* bytes; the system's pages are at least as large */
#define REDCC_NO_PAGE (~(redcc_size)0)

/** One thread's bins of one stream. Constant while a chunk is executed, so that generated code may
 * copy it. */
typedef struct redcc_bins {
    redcc_int first;   /* row at place 0 of bin 0 */
    redcc_size span;   /* number of rows in the bins; 0: no bins yet, rows are only counted */
    redcc_u32 shift;   /* (row - first) >> shift is the row's bin */
    redcc_u32 *cursor; /* for each bin: the number of its next record */
    char *records;     /* indexed by record number */
    redcc_u16 *places; /* indexed by record number */
    char *lines;       /* write combining: the lines of each bin that are being filled; or 0 */
    char *copy[REDCC_STREAM_ARRAYS]; /* private copies of each array, from row `first` on; or 0 */
    const void *operands;
    struct redcc_bin_buffer *buffer;
    redcc_size
        *readable_page; /* the number of a page that is readable; REDCC_NO_PAGE: none is known */
    const struct redcc_calls *calls;
} redcc_bins;

typedef struct redcc_series redcc_series;
typedef struct redcc_series_part redcc_series_part;
typedef struct redcc_series_writer redcc_series_writer;

struct redcc_attempt;

/** Functions of the library for redcc/series.h. */
typedef struct redcc_series_calls {
    void (*join)(redcc_series_writer *writer, redcc_series *series);
    int (*room)(redcc_series_writer *writer, redcc_int k);
    int (*repeats)(redcc_worker *worker, redcc_series_writer *writers, redcc_u32 count);
    int (*is_over)(const redcc_worker *worker);
    int (*has_any)(const redcc_series *series);
    const redcc_series_part *(*find)(const redcc_series *series, redcc_int *k);
    /** With tiles: await_band is called when the thread's band is done, end_band when its operands
     * were added. */
    void (*await_band)(redcc_worker *worker);
    const redcc_series_part *(*part_of)(const redcc_series *series, redcc_int k);
    void (*end_band)(redcc_worker *worker, redcc_series_writer *writers, redcc_u32 count);
    /** Frees all memory of the loop's operands. */
    void (*release)(const struct redcc_attempt *attempt);
} redcc_series_calls;

/** In bins: for elements behind pointers, and for inner loops over rows. */
typedef struct redcc_behind_calls {
    /** Is a pointer at this address readable? If so, sets *page to the number of its page. */
    int (*is_readable)(redcc_size *page, const void *address);
    /** Pushes a record of `count` rows from row `low` on. */
    void (*push_span)(const redcc_bins *bins, const redcc_stream *stream, redcc_int low,
                      redcc_int count, const void *record);
} redcc_behind_calls;

typedef struct redcc_crew redcc_crew;

/** Functions of the library for a loop that all threads of a team reach (redcc/crew.h). */
typedef struct redcc_crew_calls {
    void (*arrive)(void);
    redcc_crew *(*begin)(redcc_loop *loop, int locks);
    int (*help)(redcc_crew *crew);
    void (*end)(redcc_crew *crew);
} redcc_crew_calls;

/** Functions of the library that are called before a loop begins. */
typedef struct redcc_before_calls {
    /** Is it certain that no other thread of the process executes the program's code before the
     * loop ends? */
    int (*is_alone)(redcc_loop *loop);
    /** May pointers that the loop reads only under conditions be loaded before it? 0: not in this
     *  execution, because the loop is executed too often. */
    int (*may_load)(const redcc_loop *loop, redcc_word *last);
    /** Reads `bytes` bytes at `from` and returns 1 if they are readable. Never faults. */
    int (*load)(void *to, const char *from, redcc_size bytes);
    const redcc_behind_calls *behind;
    /** Does REDCC_ORDER or REDCC_METHOD require the sequential loop's bits? */
    int (*is_in_order)(const redcc_loop *loop);
    const redcc_crew_calls *crew;
} redcc_before_calls;

/** An arithmetic progression of rows that iterations read: iteration k reads the row at first + k *
 *  step (bytes). */
typedef struct redcc_progression {
    redcc_size first; /* 0: unknown */
    redcc_int step;
    redcc_size bytes;
} redcc_progression;

struct redcc_ahead_calls;

/** The iteration at a given distance ahead in the current runs. */
typedef struct redcc_ahead {
    redcc_int k;
    redcc_int end; /* of its run */
    redcc_int origin;
    const redcc_iterations *run; /* the next run */
    const redcc_iterations *run_end;
    const struct redcc_ahead_calls *calls;
} redcc_ahead;

/** Functions of the library for redcc/prefetch.h. */
typedef struct redcc_ahead_calls {
    /** Sets `it` before iteration number `distance` of the worker's runs. */
    void (*begin)(redcc_ahead *it, const redcc_worker *worker, int distance);
    /** Advances to the next run. Returns 0 if none is left. */
    int (*next_run)(redcc_ahead *it);
    /** Copies progressions, except those that earlier ones cover because they are members of the
     * same structures. */
    void (*rows)(redcc_progression *to, const redcc_progression *from, int count);
    /** Prefetches a row longer than a cache line. */
    void (*prefetch)(const char *address, redcc_size bytes);
} redcc_ahead_calls;

struct redcc_kept_row;

/**
 * Functions that inline functions call while a loop is inspected and executed. A thread reaches the
 * table through its worker and its bins, so that an object with loops refers to none of these
 * functions by name. Later versions append to it. redcc/runtime.h and redcc/bins.h describe those
 * without a comment.
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
    /* Only for redcc/parallel.h: */
    const redcc_int *least_trip;
    const int *timed_loops;
    void (*sequential_end)(redcc_loop *loop);
    /** Sets `bytes` bytes to the neutral element of the array's operator. */
    void (*fill)(const redcc_array *array, void *values, redcc_size bytes);
    /** Applies kept rows to their arrays in order: under locks, or as compensated sums. */
    void (*settle)(redcc_worker *worker, const struct redcc_kept_row *kept, int count);
    /** Ends the program with a message: a rule of redcc/parallel.h is violated. */
    void (*misuse)(const redcc_worker *worker, const char *rule);
    const redcc_series_calls *series;
    const redcc_before_calls *before;
    const redcc_ahead_calls *ahead;
} redcc_calls;

#endif
