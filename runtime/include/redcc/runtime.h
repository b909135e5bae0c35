/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The interface of the redcc runtime for generated code. docs/generated-code.md shows a whole loop.
 *
 * One execution of a transformed loop calls, in this order:
 *  - redcc_is_worth_entering (only if iterations are short): is the trip count large enough?
 *  - redcc_enter, by one thread: may the loop run in parallel? with how many threads?
 *  - redcc_join, by each thread of the parallel region
 *  - redcc_inspect, by each thread: hands out blocks of iterations. What they touch is recorded by
 *    redcc_touch, redcc_read and redcc_iteration_done; or, while redcc_is_settled returns 1,
 *    it is compared by redcc_probe_touch, redcc_probe_read, ..._row and redcc_is_alike
 *  - redcc_next, by each thread: hands out chunks of iterations to execute
 *  - redcc_owns, in the owner-checked form of the body: may the thread make this update?
 *  - redcc_leave, by one thread. 1: the loop is done. 0: nothing was written; run the loop serially
 *
 * This header includes only headers of redcc, because a user's feature-test macros must come before
 * any system header. It compiles as C89 with GNU extensions. Every name begins with redcc_ or
 * REDCC_.
 */
#ifndef REDCC_RUNTIME_H
#define REDCC_RUNTIME_H

#define REDCC_RUNTIME_VERSION 1

/** Generated text states the version for which it was written, and compiles with no other. */
#define REDCC_REQUIRE_VERSION(version)                                                             \
    typedef char                                                                                   \
        redcc_version_of_header_and_translator_differ[(REDCC_RUNTIME_VERSION == (version)) ? 1     \
                                                                                           : -1]   \
        __attribute__((__unused__))

/** For use in #if: 1 if each floating-point operation is rounded separately, to its own type, in
 * any context. Only then do two copies of one expression give the same bits. A loop whose
 * subscripts are computed in floating point runs in parallel only under this condition. gcc defines
 * macros for all relevant options, also after pragmas. clang defines them for -ffast-math; its
 * pragmas override the parts of that option in version 18 and later. The pragmas do not override
 * -ffp-contract=fast on a processor with fused multiply-adds. */
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
/* Expands to 1 if the macro is 1, and to 0 if it is undefined, without a warning by -Wundef. */
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
#ifdef REDCC_HIDDEN /* static library: programs linked with it export none of these names */
#pragma GCC visibility push(hidden)
#else
#pragma GCC visibility push(default) /* the shared library hides all other names */
#endif
#endif

/**
 * Begins an execution of `loop`.
 *   trip     iterations, counted by the caller
 *   bases    [array_count] the first element of each array, or the target of the pointer to it. 0:
 *            the elements are reached through pointers in memory. They may then lie anywhere, and
 *            the memory between them does not belong to the array. They stay in place while the
 *            subscripts (these pointers among them) are unchanged. Such an array needs
 *            REDCC_ORDER_NEEDED and REDCC_OTHER_TYPE.
 *   known    [source_count] address ranges that are known before the inspection, {base, 0} for the
 *            others
 *   key      [key_count] every scalar and pointer value that the subscripts depend on, including
 *            the loop's first value and step
 *   threads  maximum number of threads for the region
 *   nested   1 if the caller is already inside a parallel region
 * Returns 1 if call->threads threads are to call redcc_join. Returns 0 if the loop is to run
 * serially (few iterations, one thread, nested or concurrent use, or if the method or the order
 * requires it). Stops the program with a message if REDCC_METHOD or REDCC_ORDER is unknown, or if
 * the named method does not keep an order that is named explicitly. bases, known and key are read
 * before it returns. Thread-safe.
 */
int redcc_enter(redcc_call *call, redcc_loop *loop, redcc_int trip, void *const *bases,
                const redcc_extent *known, const redcc_word *key, int threads, int nested);

/** The trip count from which a loop of short iterations (without loops or calls inside) calls
 * redcc_enter. For fewer iterations that call alone would take as long as the loop. The runtime
 * sets it when it reads its environment variables: before main if none of them is set, else in the
 * first call of the runtime. Until then it is 0. It stays 0 if REDCC_METHOD names a method, sums
 * are compensated or results are validated. */
extern redcc_int redcc_least_trip;

/** The number of short iterations, of all loops together, that the program may still execute before
 * a loop calls redcc_enter. So few iterations could not repay the runtime's first call. If it is
 * zero or negative, every loop calls redcc_enter. It is approximate if several threads decrease it
 * at once. */
extern redcc_int redcc_exempt_iterations;

/** Are the functions that this object calls, directly or indirectly, the expected definitions?
 * False if the static or the dynamic linker has replaced one of them by another definition. *other
 * is then the expected definition of that function or, if the function has no record, of its
 * caller. */
int redcc_are_linked(const redcc_linkage *linkage, const redcc_expectation **other);

/** Counts an execution of the original loop that was chosen because redcc_are_linked returned 0.
 * Returns 0. */
int redcc_is_unlinked(redcc_loop *loop, const redcc_expectation *other) __attribute__((__cold__));

/** Is the calling thread the process's initial thread and the only one that runs the program's
 * code? Idle threads of OpenMP do not count. */
int redcc_is_alone(redcc_loop *loop);

/** Forms a crew (redcc/crew.h) of the calling thread's OpenMP team, all of whose threads reach the
 * loop: the first thread executes the loop, and the others help. If `locks` is set, all other
 * threads of the process must be idle. Returns NULL if the loop must be executed as written. */
redcc_crew *redcc_crew_begin(redcc_loop *loop, int locks);

/** Called once by each thread of the region, with its number and the number of threads. */
void redcc_join(redcc_worker *worker, redcc_call *call, int thread, int threads);

/** Gets the next block of iterations to inspect. 1: worker->first, worker->last and worker->stride
 * are set. 0: no block is left; continue with redcc_next. */
int redcc_inspect(redcc_worker *worker);

/** Processes the addresses recorded so far; called by redcc_touch and redcc_iteration_done. Marked
 * cold, because otherwise gcc keeps the body's constants in memory: floating-point registers do not
 * survive a call. */
void redcc_flush(redcc_worker *worker) __attribute__((__cold__));

/** Called by redcc_is_over: 1 if an earlier iteration of the dry run updated an address that is
 * recorded as read from source number `source`. The dry run then ends, and the slice must not use
 * the value. */
int redcc_is_stale(redcc_worker *worker, redcc_u32 source) __attribute__((__cold__));

/** Sets *worker to the next chunk to execute and returns 1. 0: no chunk is left. REDCC_SELECT: the
 * caller must classify iterations and call again. REDCC_TILE: the caller must execute a tile. Every
 * thread of the region must call it until it returns 0. */
int redcc_next(redcc_worker *worker);

/** Returns 1 to exactly one of the threads that call it after executing the last iteration. */
int redcc_claims_last(redcc_worker *worker);

/** Called by redcc_owns: may this thread write at `address`? If so, prepares the update that
 * follows: takes its lock, or begins a compensated sum. The update may be of one element or of
 * several elements of a unit. Cold for the same reason as redcc_flush. */
int redcc_hooked(struct redcc_hook *hook, const void *address) __attribute__((__cold__));

/** Does the work of redcc_leave if redcc_enter returned 1. Returns REDCC_DONE, REDCC_DONE_IN_BLOCKS
 * or 0. */
int redcc_end(redcc_call *call);

/** Does the work of redcc_sequential_done if a loop is timed. */
void redcc_sequential_end(redcc_loop *loop);

/** The number of original loops that are being timed now, in all threads. If it is not 0, each
 * original loop must report its end (redcc_sequential_done). */
extern int redcc_timed_loops;

#if defined(__GNUC__)
#pragma GCC visibility pop
#endif

/** Ends an execution, after any result of redcc_enter. Not 0: the loop is done. Returns 0 if
 * the arrays are untouched (a guard failed, or there was no memory or no plan). Then the caller
 * must run the original loop, and the report gives the reason. */
static __inline__ int redcc_leave(redcc_call *call) {
    return call->decided ? redcc_end(call) : 0;
}

/** Called after the original loop, and also if redcc_leave returned not 0, by the thread that
 * called redcc_leave. If redcc_enter requested timing, passes the original loop's time to method
 * `auto`; otherwise does nothing. */
static __inline__ void redcc_sequential_done(redcc_loop *loop) {
    if (__atomic_load_n(&redcc_timed_loops, __ATOMIC_RELAXED))
        redcc_sequential_end(loop);
}

/** Is a loop of `trip` short iterations worth redcc_enter? If not, the original loop runs and
 *  nothing is reported. Thread-safe. */
static __inline__ int redcc_is_worth_entering(redcc_int trip) {
    redcc_int left;
    if (trip < __atomic_load_n(&redcc_least_trip, __ATOMIC_RELAXED))
        return 0;
    left = __atomic_load_n(&redcc_exempt_iterations, __ATOMIC_RELAXED);
    if (left <= 0)
        return 1;
    left -= trip;
    __atomic_store_n(&redcc_exempt_iterations, left, __ATOMIC_RELAXED);
    return left <= 0;
}

/* Exact integer arithmetic before redcc_enter. It computes addresses of subscripts that may wrap
 * around in C, or that the program does not compute itself. Each function sets *lost on
 * overflow. */

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

/** Returns the value; sets *lost if it does not fit in an unsigned integer of `bits` < 64 bits. */
static __inline__ redcc_int redcc_exact_unsigned(redcc_int value, int bits, int *lost) {
    *lost |= value < 0 || value >> bits != 0;
    return value;
}

/** As redcc_exact_unsigned, for a signed integer. */
static __inline__ redcc_int redcc_exact_signed(redcc_int value, int bits, int *lost) {
    const redcc_int above = (redcc_int)1 << (bits - 1);
    *lost |= value < -above || value >= above;
    return value;
}

/** Sets *extent to the bytes from the lower of two addresses to `bytes` after the higher one.
 * Addresses below 1 are left out. Sets *lost if no byte is left or the end overflows. */
static __inline__ void redcc_exact_extent(redcc_extent *extent, redcc_int one, redcc_int other,
                                          redcc_int bytes, int *lost) {
    const redcc_int low = one < other ? one : other;
    const redcc_int end = redcc_exact_sum(one < other ? other : one, bytes, lost);
    *lost |= end <= 0;
    extent->first = (const char *)(redcc_size)(low > 0 ? low : 1);
    extent->end = (const char *)(redcc_size)end;
}

#include <redcc/steps.h>

/** Executor, owner-checked form: may this thread write at `address`? Called before each update of
 * an element. If several elements of one unit are updated together, called once, with the address
 * of the first. */
static __inline__ int redcc_owns(const redcc_owner *owner, const void *address) {
    return redcc_has(owner, address) || (owner->hook && redcc_hooked(owner->hook, address));
}

#include <redcc/series.h>

#ifndef REDCC_LIBRARY
#pragma weak redcc_run
#include "loop.h"
#endif

#endif
