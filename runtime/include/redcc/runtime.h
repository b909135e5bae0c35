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

#include <redcc/entry.h>

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
 *   threads  that the region may have; nested  the caller is within a region already.
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

/** Are the functions that this object calls, and all that these lead to, those that `expected`
 * names? No other definition has been put in the place of one, by the linker or by the dynamic one.
 */
int redcc_are_linked(const redcc_callee *called, redcc_size count,
                     const redcc_expectation *expected, redcc_size expected_count);

/** Counts an execution of the original loop because they are not. Returns 0. */
int redcc_is_unlinked(redcc_loop *loop) __attribute__((__cold__));

/** Is the calling thread the process's only one that runs, OpenMP's idle ones apart? */
int redcc_is_alone(redcc_loop *loop);

/** Memory for an operand of `size` bytes an iteration, to be given back by redcc_operands_give
 * after redcc_leave. Counted by REDCC_MEMORY_LIMIT. NULL: trip is not positive, or there is no
 * memory (which is reported), and the original loop must run. */
void *redcc_operands_take(redcc_loop *loop, redcc_int trip, redcc_size size);

/** Gives it back; NULL does nothing. */
void redcc_operands_give(void *operands);

/** Called once by each thread of the region: its number, and how many there are. */
void redcc_join(redcc_worker *worker, redcc_call *call, int thread, int threads);

/** The next block to inspect: 1 with first, last, stride set, or 0: go on to redcc_next. */
int redcc_inspect(redcc_worker *worker);

/** Takes in what was told so far; called by redcc_touch and redcc_iteration_done. Cold, or gcc
 * keeps the body's constants in memory: no floating-point register lives across a call. */
void redcc_flush(redcc_worker *worker) __attribute__((__cold__));

/** Called by redcc_is_over: 1 where something that was told of the source has been updated
 *  before; the dry run is over then, and the slice must use nothing of it. */
int redcc_is_stale(redcc_worker *worker, redcc_u32 source) __attribute__((__cold__));

/** The next chunk to execute, as set in *worker; 0: there is none left (or none at all);
 *  REDCC_SELECT: iterations to be classified first. Every thread of the region must call it until
 *  it returns 0. */
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

/** Executor, guarded form: may this thread write at `address`? Asked before each update of an
 *  element, or before one of several elements that begin there and lie in one unit. */
static __inline__ int redcc_owns(const redcc_owner *owner, const void *address) {
    const redcc_size into = (redcc_size)((const char *)address - owner->first);
    if (into < owner->size && (!owner->map || owner->map[into / owner->unit] == owner->self))
        return 1;
    return owner->hook && redcc_hooked(owner->hook, address);
}

#include <redcc/steps.h>

#include <redcc/series.h>

#ifndef REDCC_LIBRARY
#pragma weak redcc_run
#include "loop.h"
#endif

#endif
