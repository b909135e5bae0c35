/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Structures shared by the runtime and compiled loops: the description of a loop, a thread's part
 * in an execution, and bins. redcc/parallel.h and redcc/runtime.h include this file. It includes no
 * header, and compiles as C89 with GNU extensions. The fields are part of the interface's version
 * (REDCC_INTERFACE).
 */
#ifndef REDCC_STRUCTURES_H
#define REDCC_STRUCTURES_H

/** For use in #if: are float and double evaluated in their own types? gcc defines 16 instead of 0
 * if it also has registers for _Float16. */
#define REDCC_EVALUATES_IN_TYPE (__FLT_EVAL_METHOD__ == 0 || __FLT_EVAL_METHOD__ == 16)

__extension__ typedef long long redcc_int;           /**< counts of iterations */
__extension__ typedef unsigned long long redcc_word; /**< values of a key */
typedef __SIZE_TYPE__ redcc_size;                    /**< numbers of bytes */
typedef unsigned int redcc_u32;

typedef enum redcc_operator {
    REDCC_SUM, /**< element + contribution, or element - contribution */
    REDCC_PRODUCT,
    REDCC_MINIMUM,
    REDCC_MAXIMUM,
    REDCC_SATURATING, /**< adds 1 while the element is below the array's `limit` */
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
    REDCC_OTHER_TYPE /**< any other type: private copies are impossible, so only methods without
                        private copies apply */
} redcc_type;

/** How the result of the parallel loop may differ from that of the sequential loop. */
typedef enum redcc_order {
    REDCC_ORDER_SERIAL, /**< not at all: the same bits at every thread count */
    REDCC_ORDER_FIXED,  /**< the same bits in every run and at every thread count */
    REDCC_ORDER_ANY
} redcc_order;

/** One reduction array of a loop. */
typedef struct redcc_array {
    const char *name;    /**< as the user wrote it: "b", "A->value" */
    redcc_u32 operation; /**< a redcc_operator; stored in 32 bits, because the option -fshort-enums
                            changes the size of enumerations */
    redcc_u32 type;      /**< a redcc_type */
    redcc_u32 element;   /**< bytes of a scalar element */
    redcc_u32 unit; /**< bytes of a row b[i], or of an element if there are no rows. A touch covers
                       whole units, and each unit has one owner */
    redcc_word limit; /**< for REDCC_SATURATING: the limit, a value of the element's type above 0 */
} redcc_array;

/** An object that the loop reads. Unless `flags` allow it, the loop must not run in parallel if the
 * object overlaps a reduction array. */
typedef struct redcc_source {
    const char *name;
    int flags; /**< a sum of the bits below */
} redcc_source;

enum {
    /** The source's contents determine which elements are touched. A plan is reused only while
     * these contents are unchanged. */
    REDCC_IS_SUBSCRIPT = 1,
    /** A scalar in memory to which the loop adds. It must not overlap an array of the loop, another
     * scalar with this bit, or a source with REDCC_MAY_OVERLAP_SCALARS. */
    REDCC_IS_SCALAR = 2,
    /** A source that was not proved disjoint from the scalars with REDCC_IS_SCALAR. */
    REDCC_MAY_OVERLAP_SCALARS = 4,
    /** A source that is disjoint from all arrays, although it may lie between their elements
     * (another member of their structures). It may overlap only scalars. */
    REDCC_OVERLAPS_NO_ARRAY = 8
};
/** Elements that only one iteration touches are also described as scalars (REDCC_IS_SCALAR). This
 * value, added to the flags, identifies the pointer through which they are reached. Two such
 * sources with the same redcc_base are disjoint. */
#define REDCC_SCALAR_BASE(redcc_base) ((redcc_base)*256)

/** The address of any function. */
typedef void (*redcc_code)(void);

/** Describes a function's definition; emitted in the object that defines the function. The digest
 * depends only on the definition. `own` is the address of this definition, even if calls of the
 * function are linked to another definition. redcc-cc compiles some files without redcc's headers;
 * such a file declares the structure itself (tool/redcc/records.c). */
typedef struct redcc_record {
    const char *name;
    redcc_u32 digest[2];
    redcc_code own;
    redcc_size callee_count;
    /** the functions that it calls, with the addresses that this object calls */
    const struct redcc_callee *callees;
} redcc_record;

typedef struct redcc_callee {
    const redcc_record *record; /**< NULL: the function has no record */
    redcc_code called;
} redcc_callee;

/** A definition that a translation relies on. */
typedef struct redcc_expectation {
    const char *name;
    redcc_u32 digest[2];
    const char *file; /**< the source that was analysed, without its folder */
} redcc_expectation;

/** The functions that an object's loops call, and the definitions on which the translation relies:
 * expected[i] is that of called[i] for i < count, and those of indirectly called functions
 * follow. */
typedef struct redcc_linkage {
    const redcc_callee *called;
    redcc_size count;
    const redcc_expectation *expected;
    redcc_size expected_count;
} redcc_linkage;

/** Fails to compile under -fpack-struct, because the library's structures are not packed. */
typedef char redcc_structures_are_packed[sizeof(redcc_source) == 2 * sizeof(void *) ? 1 : -1]
    __attribute__((__unused__));

enum {
    /** The subscripts depend only on the key, the trip count and the sources marked
     * REDCC_IS_SUBSCRIPT, so a plan may be reused while these are unchanged. The sources are listed
     * in the order in which the slice reads them. Without this flag every execution inspects
     * again. */
    REDCC_VERIFIABLE = 1,
    /** The order was named explicitly at translation, not by default. */
    REDCC_ORDER_EXPLICIT = 2,
    /** Some update requires that the updates of each element keep their order, so that only methods
     * that guarantee this apply. */
    REDCC_ORDER_NEEDED = 4,
    /** Iterations that touch no element must be executed, too. */
    REDCC_EVERY_ITERATION = 8,
    /** This redcc_loop is the first member of a redcc_binned. */
    REDCC_BINNED = 16,
    /** The loop's executor can prefetch what later iterations touch (prefetch.h). */
    REDCC_PREFETCHES = 32,
    /** The flags contain this value times 2 or 4 if the loop has a vector form that executes 2 or 4
     * iterations at once (lanes.h). On x86-64 it is used only with AVX2. */
    REDCC_LANES_UNIT = 64,
    /** An iteration has an inner loop of many hundred operations. */
    REDCC_LONG = 512,
    /** The vector form does not need AVX2. */
    REDCC_LANES_ANYWHERE = 1024,
    /** The slice may read values that the loop has not written yet, and so use invalid addresses.
     * Therefore one thread first records all iterations in order, before the inspection. If an
     * iteration would update an address in a range of `known`, worker->last becomes 0 and the slice
     * must return immediately. */
    REDCC_DRY_RUN = 2048,
    /** As REDCC_DRY_RUN, but the dry run also ends if an iteration would update an address that was
     * recorded as read (redcc_is_over). */
    REDCC_DRY_RUN_OF_READS = 4096,
    /** Replaces REDCC_PREFETCHES: the iterations are so short that prefetching pays only if their
     * accesses are irregular. In define_loop.h it implies REDCC_SHORT. */
    REDCC_LIGHT = 8192,
    /** The loop's executor classifies iterations by the rows they touch when redcc_next returns
     * REDCC_SELECT. */
    REDCC_SELECTS = 16384,
    /** Iterations contain no loops or calls, so a small number of iterations is not worth a call of
     * the runtime. */
    REDCC_SHORT = 32768,
    /** The slice is written by hand: REDCC_VALIDATE checks that it names all updated rows. */
    REDCC_BY_HAND = 65536,
    /** The slice calls a function with an assertion, which may end the program. */
    REDCC_MAY_ABORT = 131072,
    /** In the owner-checked form, iterations skip parts of the body that update no element of the
     * thread. */
    REDCC_PARTS = 262144,
    /** With REDCC_BINNED: before any iteration is pushed, all iterations record their reads and
     * updates, and these are checked not to overlap. */
    REDCC_BINS_CHECKED = 524288,
    /** redcc_attempt.threads is the number of threads that the program requests. */
    REDCC_TEAM = 1048576,
    /** A loop over pairs: the counter of its inner loop is above that of the outer loop, or below
     * it with REDCC_TILES_BELOW. Its executor accepts REDCC_TILE. */
    REDCC_TILES = 2097152,
    /** Together with REDCC_TILES: the inner counter is below the outer one. */
    REDCC_TILES_BELOW = 4194304,
    /** With REDCC_BINNED: the slice records no updates, so that no plan can be constructed. */
    REDCC_NO_INSPECTOR = 8388608,
    /** redcc_attempt.sections has the section of each array that OpenMP's clause `reduction` names.
     * All updates are inside it. */
    REDCC_SECTIONED = 16777216,
    /** An update might change a value that the executor reads before the loop, such as a bound of
     * the counter. Or it might change an element that is stored after the loop. So no update may be
     * made, not even in sequential order, before it is known that no update does so. */
    REDCC_WHOLE = 33554432,
    /** Iterations are long, so the first ones may be executed in order before the loop is
     * inspected. The remaining iterations are then executed as the same loop with a later first
     * iteration. */
    REDCC_BEGINS = 67108864,
    /** The slice records the rows of inner loops as blocks, so that an inspection is short even if
     *  iterations are long. */
    REDCC_BLOCKS = 134217728,
    /** The first iterations may be executed by owners and the remaining ones in order, because no
     *  value that an update might change is read before the loop or kept until its end. So threads
     *  may find out during the execution (REDCC_SELECT) which iteration first leaves a fence. */
    REDCC_FENCED = 268435456,
    /** Replaces REDCC_FENCED in a loop with series (series.h). */
    REDCC_FENCED_SERIES = 536870912,
    /** If an iteration leaves the loop, the iterations before it may be executed, because the
     * original loop can continue at any iteration (redcc_attempt.made). */
    REDCC_CONTINUES = 1073741824
};

enum {
    /** Result of redcc_next. Before the next call, the caller must write the class of each
     * iteration from `first` to before `last` (at most REDCC_SELECTED iterations) to the bytes at
     * `entry`. `window` has the elements that the thread owns, `owner` the fences of arrays, and
     * `sources` those of sources. If an iteration leaves a fence, the caller sets `last` to that
     * iteration, and classifies no later one. */
    REDCC_SELECT = 2,
    REDCC_SELECTED = 128,
    /** Result of redcc_next: the thread must execute the tile `variant.tile`, which has at most
     * REDCC_TILE_ROWS outer iterations. */
    REDCC_TILE = 3,
    REDCC_TILE_ROWS = 256,
    /** The class of an iteration is a sum of these bits. OWN: the iteration touches an element that
     * the thread owns. OTHERS: it touches an element that the thread does not own. */
    REDCC_CLASS_OWN = 1,
    REDCC_CLASS_OTHERS = 2,
    /** This thread is the leader of the threads that execute the iteration: it owns the leading row
     *  (redcc_probe_first). */
    REDCC_CLASS_LEADS = 4,
    /** Results of redcc_bins_next. REDCC_TO_PUSH: a chunk whose updates must be pushed.
     * REDCC_TO_EXECUTE: call redcc_next until it returns 0, then redcc_bins_next again. 0: no
     * chunks are left. */
    REDCC_TO_PUSH = 1,
    REDCC_TO_EXECUTE = 2,
    /** Results of redcc_run and redcc_end. REDCC_DONE: the loop is done. REDCC_DONE_IN_BLOCKS: it
     * is done, and its operands are stored as with REDCC_OPERANDS_IN_BLOCKS. 0: it is not done. */
    REDCC_DONE = 1,
    REDCC_DONE_IN_BLOCKS = 2
};

/** What the thread does with the operands of a chunk's updates of scalars
 * (redcc_variant.operands). */
enum {
    REDCC_OPERANDS_ONE_BY_ONE = 0, /**< it stores each of them */
    /** In owner-checked iterations it stores no operands of series (series.h). The iteration's
     * leader (REDCC_CLASS_LEADS), which executes the whole iteration, stores them. */
    REDCC_OPERANDS_BY_LEADER = 1,
    /** It adds them up in blocks of REDCC_SUM_BLOCK iterations (REDCC_ADD_OPERAND): the loop is
     * executed in shares of its iterations, and so in a fixed order that differs from that of the
     * sequential loop. */
    REDCC_OPERANDS_IN_BLOCKS = 2
};
/** The length of these blocks. The number of a share's first iteration is a multiple of it. */
enum { REDCC_SUM_BLOCK = 64 };

/** Passed to `is_stale` in place of a source's number if an iteration leaves the loop
 * (redcc_iteration_leaves). */
#define REDCC_LEAVES 0xffffffffu
/** The trip count that is given for a loop without a bound. */
#define REDCC_OPEN_TRIP ((redcc_int)1 << 30)
/** Passed to `is_stale`, with REDCC_CONTINUES, if iteration worker->first leaves the loop. */
#define REDCC_ENDS 0xfffffffeu

/** A loop as the translator describes it. There is one static object for each. */
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

/** Bytes [first, end). In `known` (redcc_enter in runtime.h, redcc_attempt in entry.h), end == 0
 * means that the range is not known before the inspection. Then `first` is the pointer through
 * which the loop reads, and redcc_read finds the range. A kept plan stores the range relative to
 * that pointer, since the data may have moved by the next execution. first == 0: no single pointer
 * leads to the data, or they lie in several objects. To reuse a plan, all bytes from the lowest to
 * the highest address read are compared. */
typedef struct redcc_extent {
    const char *first;
    const char *end;
} redcc_extent;

/** One execution of a loop; lives on the caller's stack from redcc_enter to redcc_leave. */
typedef struct redcc_call {
    redcc_loop *loop;
    redcc_int trip;                  /**< number of iterations */
    int threads;                     /**< number of threads to request from OpenMP */
    int decided;                     /**< owned by the runtime */
    void *execution;                 /**< owned by the runtime */
    const struct redcc_calls *calls; /**< functions that the inline functions call */
} redcc_call;

/** Consecutive iterations of a chunk. `begin` is relative to the chunk's origin. */
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
    /* the owner of each unit, from the unit at `first` on; 0: no map */
    const unsigned char *map;
    redcc_word reciprocal; /* replaces the division by `unit` (redcc_quotient); 0: divide */
    redcc_u32 self;
    redcc_u32 unit;          /* with a map: bytes of a unit */
    struct redcc_hook *hook; /* not 0: the hook decides about each update, and `size` is 0 */
} redcc_owner;

/** An address recorded by the inspector, or (array == REDCC_END_OF_ITERATION) the end of an
 *  iteration. */
typedef struct redcc_entry {
    const char *address;
    redcc_u32 array;
    redcc_u32 bytes;
} redcc_entry;

#define REDCC_END_OF_ITERATION 0xffffffffu

/** After this many consecutive iterations within the owned range, the next iterations are probed
 * (redcc_is_settled). If owners alternate, so many in a row are rare, and hardly any iteration is
 * inspected twice. */
#define REDCC_SETTLED 8
/** worker->alike in a dry run is negative: at most this if the next iterations are probed, because
 *  all ranges that they must not touch are known; otherwise greater. */
#define REDCC_DRY_PROBED (-((redcc_int)1 << 61))
/** The largest number of bytes that redcc_touch accepts. */
#define REDCC_LONGEST_TOUCH 0x40000000

/** A tile: a part of a loop over pairs. It has the outer iterations from `row` to before `row_end`.
 * Of their inner iterations, it has those whose counter is at least `column` and less than
 * `column_end` steps after the loop's first value. A band is the tiles of the same rows; a thread
 * executes them one after the other. */
typedef struct redcc_tile {
    redcc_int row, row_end;
    redcc_int column, column_end;
    int is_first; /**< it is the first tile of its rows */
    int is_last; /**< it is the last tile of its rows, with all inner iterations from `column` on */
} redcc_tile;

/** How a chunk is executed; it does not affect the result. */
typedef struct redcc_variant {
    int prefetches; /**< are rows of later iterations prefetched? */
    int lanes;      /**< number of iterations executed at once (REDCC_LANES_UNIT); 0: one by one */
    int operands;   /**< REDCC_OPERANDS_ONE_BY_ONE, ..._BY_LEADER or ..._IN_BLOCKS */
    const redcc_tile *tile; /**< after REDCC_TILE: the tile to execute */
} redcc_variant;

/** One thread's part in an execution. The object is on that thread's stack. */
typedef struct redcc_worker {
    redcc_call *call;
    /* set by redcc_inspect: record the addresses of iterations first, first + stride, ... < last */
    redcc_int first;
    redcc_int last;
    redcc_int stride;
    redcc_entry *entry; /* the next free entry */
    redcc_entry *entry_end;
    const redcc_owner *window; /* for each array, the range of the current owner. A touch within the
                                  range makes no entry */
    int inside;                /* the current iteration has a touch within the range */
    int outside;               /* the current iteration has a touch that made an entry */
    redcc_int alike; /* number of consecutive iterations, since the last flush, that touched only
                        the range; negative in a dry run */
    /* for each source, indexed as redcc_loop.sources: the range that this thread has recorded as
     * read (redcc_read). After REDCC_SELECT: the source's fence, which all threads share */
    redcc_extent *sources;
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
    /** Maximum number of arrays that one record updates. All are updated at the same subscript. */
    REDCC_STREAM_ARRAYS = 4,
    /** Number of bits of a record's place. The low bits of a place are the row's number within the
     * bin. The bits above are the tag, the number of the update in the body. */
    REDCC_PLACE_BITS = 16,
    REDCC_MOST_TAG_BITS = 8,
    REDCC_BLOCK_RECORDS = 1024, /**< number of records in a contiguous block */
    REDCC_LINE_PLACES = 32,     /**< places in a cache line */
    REDCC_CACHE_LINE = 64,      /**< bytes */
    REDCC_RECORDS_AHEAD = 16    /**< prefetch distance in records */
};

/** Records that an apply function is to apply, in this order. */
typedef struct redcc_applied {
    void *const *rows; /**< for each array of the stream, the address of the row whose place is 0 */
    const redcc_u16 *place; /**< [count + ahead] the place of each record */
    const void *records;    /**< [count] */
    redcc_size count;
    redcc_size ahead;     /**< prefetch distance in places; 0: no prefetches */
    const void *operands; /**< the operands given to redcc_bins_next */
    redcc_size row_count; /**< rows of the bin */
} redcc_applied;

enum { REDCC_STREAM_EXACT = 1, REDCC_STREAM_SPANS = 2 };

/** A stream: updates that are applied in order (unless `exact`). These are all updates of an array,
 * or of several arrays that are updated at one subscript. */
typedef struct redcc_stream {
    /** Applies records by executing the statements of the loop's updates. Writes only to the
     * rows. */
    void (*apply)(const redcc_applied *applied);
    redcc_u32 array_count;                 /**< 1 to REDCC_STREAM_ARRAYS */
    redcc_u32 arrays[REDCC_STREAM_ARRAYS]; /**< their indices in the loop's arrays; no array is in
                                              two streams */
    redcc_u32 rows[REDCC_STREAM_ARRAYS];   /**< for each array, the bytes of a row: its `unit` */
    redcc_u32 record; /**< bytes of a record, an even number; 0: records are empty, because the
                         contribution is a constant */
    redcc_u32 tag_bits;
    int exact; /**< REDCC_STREAM_EXACT: all updates use the array's operator on integers, so that
                  any order and private copies are possible. REDCC_STREAM_SPANS: a record covers
                  consecutive rows, and is in each bin that has some of these rows. Else 0 */
} redcc_stream;

/** A loop that can be binned; loop.flags has REDCC_BINNED. */
typedef struct redcc_binned {
    redcc_loop loop;
    redcc_u32 stream_count;
    int is_unordered; /**< OpenMP's directives leave the order of the updates open, and all updates
                         may be made on private copies. So the loop may be executed in a fixed order
                         that is not its own */
    const redcc_stream *streams;
} redcc_binned;

struct redcc_bin_buffer;

enum { REDCC_PAGE = 4096 }; /* in bytes; the system's pages are at least as large */
#define REDCC_NO_PAGE (~(redcc_size)0)

/** One thread's bins of one stream. Its fields do not change while a chunk is executed, so
 * generated code may copy it. */
typedef struct redcc_bins {
    redcc_int first;   /* row at place 0 of bin 0 */
    redcc_size span;   /* number of rows in the bins; 0: there are no bins yet, and redcc_push only
                          reports its row */
    redcc_u32 shift;   /* (row - first) >> shift is the row's bin */
    redcc_u32 *cursor; /* for each bin: the number of its next record */
    char *records;     /* indexed by record number */
    redcc_u16 *places; /* indexed by record number */
    char *lines; /* write combining: for each bin, the cache lines that are being filled; 0: no
                    write combining */
    char *copy[REDCC_STREAM_ARRAYS]; /* private copies of each array, from row `first` on; copy[0]
                                        is 0 if there are none */
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
    /** If the loop is executed by tiles: await_band is called when the thread has executed its band
     * of rows; end_band is called after the thread has added the band's operands. */
    void (*await_band)(redcc_worker *worker);
    const redcc_series_part *(*part_of)(const redcc_series *series, redcc_int k);
    void (*end_band)(redcc_worker *worker, redcc_series_writer *writers, redcc_u32 count);
    /** Frees all memory of the loop's operands. */
    void (*release)(const struct redcc_attempt *attempt);
} redcc_series_calls;

/** Functions of the library for bins. is_readable is for elements reached through pointers;
 * push_span is for inner loops over rows. */
typedef struct redcc_behind_calls {
    /** Is a pointer at this address readable? If so, sets *page to the number of its page. */
    int (*is_readable)(redcc_size *page, const void *address);
    /** Pushes a record of `count` rows that begin with row `low`. */
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
    /** May pointers that the loop reads only under conditions be loaded before the loop? 0: not in
     * this execution, because such loads would cost too much time in a loop that is executed this
     * often. *last is the time of the last call, and is updated. */
    int (*may_load)(const redcc_loop *loop, redcc_word *last);
    /** Copies `bytes` bytes from `from` to `to` and returns 1; returns 0 if they are not readable.
     * Never faults. */
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

/** The iteration whose rows are prefetched: a fixed distance ahead of the one that the worker
 * executes. */
typedef struct redcc_ahead {
    redcc_int k;
    redcc_int end; /* end of the run that contains `k` */
    redcc_int origin;
    const redcc_iterations *run; /* the run after it */
    const redcc_iterations *run_end;
    const struct redcc_ahead_calls *calls;
} redcc_ahead;

/** Functions of the library for redcc/prefetch.h. */
typedef struct redcc_ahead_calls {
    /** Sets *it to just before iteration number `distance` of the worker's runs. */
    void (*begin)(redcc_ahead *it, const redcc_worker *worker, int distance);
    /** Advances to the next run. Returns 0 if none is left. */
    int (*next_run)(redcc_ahead *it);
    /** Copies progressions. Leaves out a progression if an earlier one covers it, because both are
     * members of the same structures. */
    void (*rows)(redcc_progression *to, const redcc_progression *from, int count);
    /** Prefetches a row longer than a cache line. */
    void (*prefetch)(const char *address, redcc_size bytes);
} redcc_ahead_calls;

struct redcc_kept_row;

/**
 * Functions that inline functions call while a loop is inspected and executed. A thread finds the
 * table through its worker and its bins, so an object with loops refers to none of these functions
 * by name. Later versions append functions to the table. Functions without a comment here are
 * described in redcc/runtime.h and redcc/bins.h.
 */
typedef struct redcc_calls {
    redcc_u32 version; /**< the library's REDCC_INTERFACE */
    redcc_u32 bytes;   /**< size of this table */
    int (*inspect)(redcc_worker *worker);
    void (*flush)(redcc_worker *worker);
    int (*is_stale)(redcc_worker *worker, redcc_u32 source);
    int (*next)(redcc_worker *worker);
    int (*claims_last)(redcc_worker *worker);
    int (*hooked)(struct redcc_hook *hook, const void *address);
    int (*bins_next)(redcc_worker *worker, redcc_bins *bins, const void *operands);
    void (*push_outside)(struct redcc_bin_buffer *buffer, redcc_int row);
    redcc_u32 (*push_block)(struct redcc_bin_buffer *buffer, redcc_size bin, redcc_u32 record);
    /* Used by redcc/loop.h and redcc/parallel.h: */
    const redcc_int *least_trip;
    const int *timed_loops;
    void (*sequential_end)(redcc_loop *loop);
    /** Sets `bytes` bytes to the neutral element of the array's operator. */
    void (*fill)(const redcc_array *array, void *values, redcc_size bytes);
    /** Applies scratch rows to their arrays in order, under locks or as compensated sums. */
    void (*settle)(redcc_worker *worker, const struct redcc_kept_row *kept, int count);
    /** Ends the program with a message that names the violated rule of redcc/parallel.h. */
    void (*misuse)(const redcc_worker *worker, const char *rule);
    const redcc_series_calls *series;
    const redcc_before_calls *before;
    const redcc_ahead_calls *ahead;
} redcc_calls;

#endif
