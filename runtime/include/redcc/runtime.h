/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * What generated code may use of the redcc runtime. docs/generated-code.md shows a whole loop.
 *
 * The life of one execution of a transformed loop:
 *
 *     redcc_is_worth_entering       where iterations are short: are they enough?
 *     redcc_enter      one thread   may it run in parallel at all? how many threads?
 *     redcc_join       each thread  of the parallel region
 *     redcc_inspect    each thread  hands out blocks of iterations whose addresses are to be told
 *       redcc_touch, redcc_read, redcc_iteration_done
 *       redcc_is_settled, redcc_probe_touch, redcc_probe_read, ..._row, redcc_is_alike
 *     redcc_next       each thread  hands out chunks of iterations to execute
 *       redcc_owns                  in the guarded form of the body
 *     redcc_leave      one thread   1: the loop is done; 0: nothing was written, run it serially
 *
 * This header includes none but loop.h (a user's feature-test macros must come before any system
 * header) and compiles as C89 with GNU extensions. Every name begins with redcc_ or REDCC_.
 */
#ifndef REDCC_RUNTIME_H
#define REDCC_RUNTIME_H

#define REDCC_RUNTIME_VERSION 1

/** Generated text states the version it was written for; any other does not compile. */
#define REDCC_REQUIRE_VERSION(version)                                                             \
    typedef char                                                                                   \
        redcc_version_of_header_and_translator_differ[(REDCC_RUNTIME_VERSION == (version)) ? 1     \
                                                                                           : -1]   \
        __attribute__((__unused__))

/** In #if: are float and double evaluated in their own types? gcc says 16 instead of 0 where there
 *  are registers for _Float16 as well. */
#define REDCC_EVALUATES_IN_TYPE (__FLT_EVAL_METHOD__ == 0 || __FLT_EVAL_METHOD__ == 16)

/** In #if: is each floating-point operation rounded by itself, to its own type, wherever it stands?
 *  Then two copies of one expression give the same bits. Where subscripts are computed so, a loop
 *  runs in parallel only then. gcc tells all that matters by macros, also after pragmas; clang
 * tells -ffast-math, and heeds pragmas against its parts from version 18 on, but not against
 * contraction where -ffp-contract=fast is given and the processor has fused multiply-adds. */
#if !defined(__FLT_EVAL_METHOD__) && !defined(__clang__)
#define REDCC_ROUNDS_ALIKE 0
#elif defined(__clang__) && (__clang_major__ < 18 || !defined(__x86_64__) ||                       \
                             !defined(__SSE2_MATH__) || defined(__FMA__) || defined(__FMA4__))
#define REDCC_ROUNDS_ALIKE 0
#else
#ifdef __clang__
#pragma clang fp reassociate(off) reciprocal(off)
#endif
#define REDCC_ROUNDS_ALIKE                                                                         \
    (REDCC_EVALUATES_IN_TYPE && !REDCC_IS_ON(__FAST_MATH__) &&                                     \
     !REDCC_IS_ON(__ASSOCIATIVE_MATH__) && !REDCC_IS_ON(__RECIPROCAL_MATH__) &&                    \
     !REDCC_IS_ON(__NO_SIGNED_ZEROS__) && !__FINITE_MATH_ONLY__)
/* 1 where the macro is 1, 0 where it is not defined, of which -Wundef would warn. */
#define REDCC_IS_ON(redcc_macro) REDCC_IS_ON_PASTED(redcc_macro)
#define REDCC_IS_ON_PASTED(redcc_value) REDCC_IS_ON_##redcc_value
#define REDCC_IS_ON_1 1
#define REDCC_IS_ON___FAST_MATH__ 0
#define REDCC_IS_ON___ASSOCIATIVE_MATH__ 0
#define REDCC_IS_ON___RECIPROCAL_MATH__ 0
#define REDCC_IS_ON___NO_SIGNED_ZEROS__ 0
#endif

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
    int is_subscript; /**< what it holds decides which elements are touched: a plan may be used
                           again only while it is unchanged */
} redcc_source;

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
    /** Times a set of 2, 4 and 8: so many iterations at once can be executed (lanes.h). */
    REDCC_LANES_UNIT = 64,
    /** They are compiled for the processor that all of the program is compiled for. */
    REDCC_LANES_ANYWHERE = 1024,
    /** Where the slice read by values that the loop has yet to write, it might read what is not
     *  there. So before an inspection one thread has all iterations told in order; where one would
     *  update what `known` says is read, worker->last becomes 0, and the slice returns at once; */
    REDCC_DRY_RUN = 2048,
    /** the same where redcc_is_over says of what it has told as read. */
    REDCC_DRY_RUN_OF_READS = 4096,
    /** In place of REDCC_PREFETCHES: its iterations are so light that it pays only where they come
     *  in no order. */
    REDCC_LIGHT = 8192
};

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
    redcc_int trip;  /**< iterations */
    int threads;     /**< ask OpenMP for so many */
    int decided;     /**< the runtime's, as what follows */
    void *execution; /**< */
} redcc_call;

/** Consecutive iterations of a chunk, relative to its origin. */
typedef struct redcc_run {
    redcc_u32 begin;
    redcc_u32 count_and_guard; /**< 2 * count + (each write must ask redcc_owns ? 1 : 0) */
} redcc_run;

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

#ifdef _OPENMP
/* Of OpenMP, what the calls below need; omp.h may follow. */
extern int omp_get_max_threads(void);
extern int omp_get_num_threads(void);
extern int omp_get_thread_num(void);
extern int omp_in_parallel(void);
#endif

#define REDCC_END_OF_ITERATION 0xffffffffu

/** So many iterations in a row within the window, and the next ones are probed (redcc_is_settled).
 *  Where owners alternate, hardly any iteration is looked at twice. */
#define REDCC_SETTLED 8
/** Bytes that redcc_touch takes at most. */
#define REDCC_LONGEST_TOUCH 0x40000000

/** How a chunk is executed, beside what it computes. */
typedef struct redcc_manner {
    int prefetches; /**< is what iterations to come touch to be prefetched? */
    int lanes; /**< iterations at once, one of those that the descriptor names; 0: one by one */
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
    const redcc_run *run;
    const redcc_run *run_end;
    void *const *base;        /* where to write, as if it were the array; indexed as arrays */
    const redcc_owner *owner; /* indexed as arrays; in a dry run, as sources: what was found to be
                                 none of what is updated */
    void *execution;          /* the runtime's, as what follows */
    int thread;
    redcc_manner manner; /* set by redcc_next */
    redcc_int position;
} redcc_worker;

#if defined(__GNUC__)
#ifdef REDCC_HIDDEN /* the archive: what it is linked into exports nothing of it */
#pragma GCC visibility push(hidden)
#else
#pragma GCC visibility push(default) /* the library hides everything else */
#endif
#endif

/**
 * Begins an execution of `loop`.
 *   trip     iterations, counted by the caller; bases [array_count] the arrays' first elements (or
 *            what pointers in their place point to), 0 for an array whose elements pointers in
 *            memory lead to: they may lie anywhere, what lies between them is not the array's, and
 *            they are where they were as long as its subscripts, those pointers among them, are
 *            unchanged (REDCC_ORDER_NEEDED and REDCC_OTHER_TYPE go with it);
 *            known [source_count] extents that do not
 *            depend on the inspection, {base, 0} for the others; key [key_count] every scalar and
 *            pointer value that the subscripts depend on, the loop's first value and step included.
 *   threads  omp_get_max_threads(); nested  omp_in_parallel().
 * Returns 1 where call->threads threads shall redcc_join, 0 where the loop is to run serially (few
 * iterations, one thread, nested or concurrent use, a method or order that says so).
 * Stops the program with a message where REDCC_METHOD or REDCC_ORDER name nothing known, or ask
 * together for what no method gives. bases, known and key are read before it returns.
 * Thread-safe.
 */
int redcc_enter(redcc_call *call, redcc_loop *loop, redcc_int trip, void *const *bases,
                const redcc_extent *known, const redcc_word *key, int threads, int nested);

/** From so many iterations on a loop of short iterations (without loops or calls inside) is worth
 *  redcc_enter, by which alone a few of them would take twice as long. Set by the first
 * redcc_enter; until then, and where a method is named, sums are compensated or results are
 * validated, 0. */
extern redcc_int redcc_least_trip;

/** So many short iterations the program may execute before redcc_enter is called for any, in all
 *  loops together: they take less than the first call of the runtime would have to gain. Not
 *  positive: none any more. Approximate where several threads count. */
extern redcc_int redcc_unasked_iterations;

/** Memory for an operand of `size` bytes an iteration, to be given back by redcc_operands_give
 * after redcc_leave. Counted by REDCC_MEMORY_LIMIT. NULL: trip is not positive, or there is no
 * memory (which is reported), and the original loop must run. */
void *redcc_operands_take(redcc_loop *loop, redcc_int trip, redcc_size size);

/** Gives it back; NULL does nothing. */
void redcc_operands_give(void *operands);

/** Called once by each thread of the region, with omp_get_thread_num() and omp_get_num_threads().
 */
void redcc_join(redcc_worker *worker, redcc_call *call, int thread, int threads);

/** The next block to inspect: 1 with first, last, stride set, or 0: go on to redcc_next. */
int redcc_inspect(redcc_worker *worker);

/** Takes in what was told so far; called by redcc_touch and redcc_iteration_done. Cold, or gcc
 * keeps the body's constants in memory: no floating-point register lives across a call. */
void redcc_flush(redcc_worker *worker) __attribute__((__cold__));

/** Called by redcc_is_over: 1 where something that was told of the source has been updated
 *  before; the dry run is over then, and the slice must use nothing of it. */
int redcc_is_stale(redcc_worker *worker, redcc_u32 source) __attribute__((__cold__));

/** The next chunk to execute, as set in *worker; 0: there is none left (or none at all). Every
 *  thread of the region must call it until it returns 0. */
int redcc_next(redcc_worker *worker);

/** 1 for exactly one of the threads that ask after having executed the last iteration. */
int redcc_claims_last(redcc_worker *worker);

/** Called by redcc_owns: may this thread write at `address`? If so the runtime takes part in the
 *  one update of that element, or of that one and others in its unit, which follows. Cold
 *  as redcc_flush is. */
int redcc_hooked(struct redcc_hook *hook, const void *address) __attribute__((__cold__));

/** What redcc_leave does where redcc_enter gave 1. */
int redcc_end(redcc_call *call);

/** What redcc_sequential_done does where loops are timed. */
void redcc_sequential_end(redcc_loop *loop);

/** How many original loops are being timed, in all threads: the end of each is reported. */
extern int redcc_timed_loops;

#if defined(__GNUC__)
#pragma GCC visibility pop
#endif

/** Ends an execution, after redcc_enter gave 1 or 0. Returns 1: the loop is done. 0: the arrays
 *  are untouched (a guard failed, memory or a plan could not be had) and the caller must run the
 *  original loop; the report says why. */
static __inline__ int redcc_leave(redcc_call *call) {
    return call->decided ? redcc_end(call) : 0;
}

/** After the original loop, and where redcc_leave gave 1 as well: auto learns by it what the
 * original loop takes. Called by the thread that called redcc_leave; it does nothing where
 * redcc_enter wanted no timing. */
static __inline__ void redcc_sequential_done(redcc_loop *loop) {
    if (__atomic_load_n(&redcc_timed_loops, __ATOMIC_RELAXED))
        redcc_sequential_end(loop);
}

/** Is a loop of `trip` short iterations worth redcc_enter? Otherwise the original loop runs, and
 *  nothing is reported. Thread-safe. */
static __inline__ int redcc_is_worth_entering(redcc_int trip) {
    redcc_int left;
    if (trip < __atomic_load_n(&redcc_least_trip, __ATOMIC_RELAXED))
        return 0;
    left = __atomic_load_n(&redcc_unasked_iterations, __ATOMIC_RELAXED);
    if (left <= 0)
        return 1;
    left -= trip;
    __atomic_store_n(&redcc_unasked_iterations, left, __ATOMIC_RELAXED);
    return left <= 0;
}

/* Before redcc_enter, of subscripts whose value in C may be another than the number, or that the
 * program does not compute in the first or the last iteration: numbers, or *lost is set. */

static __inline__ redcc_int redcc_exact_sum(redcc_int left, redcc_int right, int *lost) {
    redcc_int sum;
    *lost |= __builtin_add_overflow(left, right, &sum);
    return sum;
}

static __inline__ redcc_int redcc_exact_difference(redcc_int left, redcc_int right, int *lost) {
    redcc_int difference;
    *lost |= __builtin_sub_overflow(left, right, &difference);
    return difference;
}

static __inline__ redcc_int redcc_exact_product(redcc_int left, redcc_int right, int *lost) {
    redcc_int product;
    *lost |= __builtin_mul_overflow(left, right, &product);
    return product;
}

/** The value itself; *lost is set where no unsigned integer of so many bits (below 64) has it. */
static __inline__ redcc_int redcc_exact_unsigned(redcc_int value, int bits, int *lost) {
    *lost |= value < 0 || value >> bits != 0;
    return value;
}

/** The same of a signed one. */
static __inline__ redcc_int redcc_exact_signed(redcc_int value, int bits, int *lost) {
    const redcc_int above = (redcc_int)1 << (bits - 1);
    *lost |= value < -above || value >= above;
    return value;
}

/** From the lower one of two addresses to `bytes` behind the other. Below 0 nothing lies. */
static __inline__ void redcc_exact_extent(redcc_extent *extent, redcc_int one, redcc_int other,
                                          redcc_int bytes, int *lost) {
    const redcc_int low = one < other ? one : other;
    const redcc_int end = redcc_exact_sum(one < other ? other : one, bytes, lost);
    *lost |= end <= 0;
    extent->first = (const char *)(redcc_size)(low > 0 ? low : 1);
    extent->end = (const char *)(redcc_size)end;
}

/** Inspector: this iteration may update `bytes` bytes at `address` of array number `array`. */
static __inline__ void redcc_touch(redcc_worker *worker, redcc_u32 array, const void *address,
                                   redcc_size bytes) {
    const redcc_owner *window = &worker->window[array];
    const redcc_size into = (redcc_size)address - (redcc_size)window->first;
    redcc_entry *entry;
    if (into < window->size && bytes <= window->size - into) {
        worker->inside = 1;
        return;
    }
    worker->outside = 1;
    entry = worker->entry;
    entry->address = (const char *)address;
    entry->array = array;
    entry->bytes = (redcc_u32)bytes;
    worker->entry = entry + 1;
    if (worker->entry == worker->entry_end)
        redcc_flush(worker);
}

/** Inspector: the same of all that lies from `first` to before `end`, however much. */
static __inline__ void redcc_touch_span(redcc_worker *worker, redcc_u32 array, const char *first,
                                        const char *end) {
    for (; end - first > REDCC_LONGEST_TOUCH; first += REDCC_LONGEST_TOUCH)
        redcc_touch(worker, array, first, REDCC_LONGEST_TOUCH);
    redcc_touch(worker, array, first, (redcc_size)(end - first));
}

/** Inspector: this iteration may read `bytes` bytes at `address`, part of source number `source`.
 */
static __inline__ void redcc_read(redcc_worker *worker, redcc_u32 source, const void *address,
                                  redcc_size bytes) {
    redcc_extent *extent = &worker->sources[source];
    const char *first = (const char *)address;
    if (first < extent->first || !extent->first)
        extent->first = first;
    if (first + bytes > extent->end)
        extent->end = first + bytes;
}

/** Inspector: 1 in a dry run (worker->alike < 0) where something that was told of the source has
 * been updated before; the dry run is over then, and the slice must use nothing of it. */
static __inline__ int redcc_is_over(redcc_worker *worker, redcc_u32 source) {
    const redcc_extent *told = &worker->sources[source];
    const redcc_owner *clear;
    redcc_size into;
    if (worker->alike >= 0)
        return 0;
    clear = &worker->owner[source];
    into = (redcc_size)told->first - (redcc_size)clear->first;
    return !(into < clear->size && (redcc_size)(told->end - told->first) <= clear->size - into) &&
           redcc_is_stale(worker, source);
}

/** Inspector: the addresses of one iteration are told. */
static __inline__ void redcc_iteration_done(redcc_worker *worker) {
    if (worker->inside && !worker->outside) {
        worker->inside = 0;
        worker->alike++;
        return;
    }
    worker->entry->address = 0;
    worker->entry->array = REDCC_END_OF_ITERATION;
    worker->entry->bytes = 0;
    worker->entry++;
    worker->outside = 0;
    redcc_flush(worker); /* the window may be another one for the next iteration */
}

/** Inspector, of one iteration that may not have to be told: does it touch something within the
 *  window, does it touch or read something outside of what is known? Begins as {0, 0}. */
typedef struct redcc_probe {
    int inside;
    int outside;
} redcc_probe;

/** Are the last iterations told all within the window, so that the next ones are likely to be? Then
 *  they are probed first, in order, each by redcc_probe_touch and redcc_probe_read (or the same of
 *  a row by its number) for what is to be told; those that redcc_is_alike are counted in
 * worker->alike, the first that is not is told. Never while there is no window or the stride is
 * not 1. */
static __inline__ int redcc_is_settled(const redcc_worker *worker) {
    return worker->alike >= REDCC_SETTLED;
}

/* In what follows compilers keep all but `address` and `row` in registers over a loop. */

/** Are `bytes` bytes at `address` not all within the `size` bytes at `first`? */
static __inline__ int redcc_leaves(const char *first, redcc_size size, const void *address,
                                   redcc_size bytes) {
    const redcc_size places = bytes <= size ? size - bytes + 1 : 0; /* where they may begin */
    return (redcc_size)address - (redcc_size)first >= places;
}

/** The same of row number `row`, counted from `base`, of rows of `bytes` > 0 bytes. */
static __inline__ int redcc_row_leaves(const char *first, redcc_size size, const void *base,
                                       redcc_int row, redcc_size bytes) {
    const __PTRDIFF_TYPE__ step = (__PTRDIFF_TYPE__)bytes;
    const __PTRDIFF_TYPE__ from = (__PTRDIFF_TYPE__)((redcc_size)first - (redcc_size)base);
    const __PTRDIFF_TYPE__ to = (__PTRDIFF_TYPE__)((redcc_size)first + size - (redcc_size)base);
    const __PTRDIFF_TYPE__ low = from / step + (from % step > 0); /* the first whole row; */
    const __PTRDIFF_TYPE__ end = to / step - (to % step < 0);     /* one above the last */
    return (redcc_size)row - (redcc_size)low >= (redcc_size)(end > low ? end - low : 0);
}

static __inline__ void redcc_probe_touch(redcc_probe *probe, const redcc_worker *worker,
                                         redcc_u32 array, const void *address, redcc_size bytes) {
    const redcc_owner *window = &worker->window[array];
    probe->inside = 1;
    probe->outside |= redcc_leaves(window->first, window->size, address, bytes);
}

static __inline__ void redcc_probe_touch_row(redcc_probe *probe, const redcc_worker *worker,
                                             redcc_u32 array, const void *base, redcc_int row,
                                             redcc_size bytes) {
    const redcc_owner *window = &worker->window[array];
    probe->inside = 1;
    probe->outside |= redcc_row_leaves(window->first, window->size, base, row, bytes);
}

static __inline__ void redcc_probe_read(redcc_probe *probe, const redcc_worker *worker,
                                        redcc_u32 source, const void *address, redcc_size bytes) {
    const redcc_extent *known = &worker->sources[source];
    const redcc_size size = (redcc_size)known->end - (redcc_size)known->first;
    probe->outside |= redcc_leaves(known->first, size, address, bytes);
}

static __inline__ void redcc_probe_read_row(redcc_probe *probe, const redcc_worker *worker,
                                            redcc_u32 source, const void *base, redcc_int row,
                                            redcc_size bytes) {
    const redcc_extent *known = &worker->sources[source];
    const redcc_size size = (redcc_size)known->end - (redcc_size)known->first;
    probe->outside |= redcc_row_leaves(known->first, size, base, row, bytes);
}

/** Need the iteration that was probed not be told? */
static __inline__ int redcc_is_alike(const redcc_probe *probe) {
    return probe->inside && !probe->outside;
}

/** Executor, guarded form: may this thread write at `address`? Asked before each update of an
 *  element, or before one of several elements that begin there and lie in one unit. */
static __inline__ int redcc_owns(const redcc_owner *owner, const void *address) {
    const redcc_size into = (redcc_size)((const char *)address - owner->first);
    if (into < owner->size && (!owner->map || owner->map[into / owner->unit] == owner->self))
        return 1;
    return owner->hook && redcc_hooked(owner->hook, address);
}

/** May this thread write to any of the bytes at `address`, as far as is known without the hook? */
static __inline__ int redcc_owns_part(const redcc_owner *owner, const void *address,
                                      redcc_size bytes) {
    const redcc_size into = (redcc_size)((const char *)address - owner->first);
    const redcc_size last = into + bytes - 1;
    if (owner->hook)
        return 1;
    if (!owner->map)
        return last < owner->size + bytes - 1;
    return bytes > owner->unit ||
           (into < owner->size && owner->map[into / owner->unit] == owner->self) ||
           (last < owner->size && owner->map[last / owner->unit] == owner->self);
}

#include "loop.h"

#endif
