/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Macros with which redcc's output expresses a loop. The slice, which computes the addresses that
 * an iteration touches, and the body are one function each; docs/generated-code.md shows a loop.
 *
 *     REDCC_SLICE f(REDCC_SLICE_PARAMETERS, ...)     records what one iteration touches:
 *       REDCC_TOUCH, REDCC_READ                        a row by its address,
 *       REDCC_TOUCH_ROW, REDCC_READ_ROW                a row by its number
 *     REDCC_BODY g(REDCC_BODY_PARAMETERS_n, ...)     executes one iteration:
 *       REDCC_UPDATE                                   precedes each update
 *     REDCC_PARALLEL                                 executed by each thread of the region
 *
 * runtime.h includes this file. Names that begin with redcc__ belong to the generated text.
 */
#ifndef REDCC_LOOP_FORM_H
#define REDCC_LOOP_FORM_H

#include <redcc/entry.h>

/** Keep the compiler from contracting a multiplication and an addition to a fused multiply-add.
 * REDCC_UNFUSED precedes a function, because gcc contracts within functions, after inlining.
 * REDCC_UNFUSED_BLOCK begins a block, because clang contracts within expressions; no pragma
 * overrides clang's option -ffp-contract=fast. */
#if defined(__clang__)
#define REDCC_UNFUSED
#define REDCC_UNFUSED_BLOCK _Pragma("clang fp contract(off)")
#elif defined(__FP_FAST_FMA) || defined(__FP_FAST_FMAF)
#define REDCC_UNFUSED __attribute__((__optimize__("fp-contract=off")))
#define REDCC_UNFUSED_BLOCK
#else
#define REDCC_UNFUSED
#define REDCC_UNFUSED_BLOCK
#endif

/* gcc 13 and later warn that 2 ^ 5 in generated text may be meant as a power; in the expansion of a
 * macro they do not. The more code gcc inlines, the more it also warns about uninitialised
 * variables. */
#if defined __GNUC__ && !defined __clang__ && __GNUC__ >= 13
#define REDCC_QUIET_GCC                                                                            \
    _Pragma("GCC diagnostic ignored \"-Wmaybe-uninitialized\"")                                    \
        _Pragma("GCC diagnostic ignored \"-Wxor-used-as-pow\"")
#elif defined __GNUC__ && !defined __clang__
#define REDCC_QUIET_GCC _Pragma("GCC diagnostic ignored \"-Wmaybe-uninitialized\"")
#else
#define REDCC_QUIET_GCC
#endif

/* Suppresses warnings of gcc and clang that only generated text causes. */
#define REDCC_QUIET_BEGIN                                                                          \
    _Pragma("GCC diagnostic push") _Pragma("GCC diagnostic ignored \"-Wshadow\"")                  \
        _Pragma("GCC diagnostic ignored \"-Wmisleading-indentation\"")                             \
            _Pragma("GCC diagnostic ignored \"-Wsign-compare\"")                                   \
                _Pragma("GCC diagnostic ignored \"-Wunused-but-set-variable\"")                    \
                    _Pragma("GCC diagnostic ignored \"-Wunused-variable\"")                        \
                        _Pragma("GCC diagnostic ignored \"-Wunused-parameter\"")                   \
                            _Pragma("GCC diagnostic ignored \"-Wc++-compat\"")                     \
                                _Pragma("GCC diagnostic ignored \"-Wmissing-field-initializers\"") \
                                    _Pragma("GCC diagnostic ignored \"-Wpedantic\"")               \
                                        REDCC_QUIET_GCC
#define REDCC_QUIET_END _Pragma("GCC diagnostic pop")

/** Hides from the compiler that the context may be uninitialised. Otherwise it would warn if the
 * loop sets none of the context's members. */
REDCC_INLINE int redcc_hide_context(void *context) {
    __asm__ __volatile__("" : : "r"(context) : "memory");
    return 1;
}

/** Declares the variables that describe one execution (bases, address ranges of sources, key), and
 * the loop's context. */
#define REDCC_ATTEMPT(redcc_context, redcc_arrays, redcc_sources, redcc_keys)                      \
    struct redcc_context redcc__context;                                                           \
    redcc_attempt redcc__attempt = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};                     \
    void *redcc__bases[redcc_arrays];                                                              \
    redcc_extent redcc__known[(redcc_sources) + 1] __attribute__((__unused__)) = {{0, 0}};         \
    redcc_word redcc__key[redcc_keys];                                                             \
    int redcc__end __attribute__((__unused__)) = redcc_hide_context(&redcc__context)

/** REDCC_PROGRESSIONS_OF declares, as a member of the context, the arithmetic progressions of rows
 * to prefetch. REDCC_NO_PROGRESSIONS clears them. */
#define REDCC_PROGRESSIONS_OF(redcc_sources)                                                       \
    redcc_progression redcc__progressions[(redcc_sources) + 1]
#define REDCC_NO_PROGRESSIONS                                                                      \
    __builtin_memset(redcc__context.redcc__progressions, 0,                                        \
                     sizeof redcc__context.redcc__progressions)

/** REDCC_BASE sets the address of an array's first element. REDCC_KEY sets a value on which the
 * subscripts depend. */
#define REDCC_BASE(redcc_i, redcc_base) redcc__bases[redcc_i] = (void *)redcc_base
#define REDCC_KEY(redcc_i, redcc_value) redcc__key[redcc_i] = (redcc_word)redcc_value

/** Declares the trip count (redcc__trip) of a loop from redcc_lower to before redcc_bound in steps
 * of 1, and the counter's value after the loop (redcc__final). */
#define REDCC_COUNT_UP(redcc_lower, redcc_bound)                                                   \
    const redcc_int redcc__lower = redcc_lower, redcc__bound = redcc_bound,                        \
                    redcc__trip = redcc__lower < redcc__bound ? redcc__bound - redcc__lower : 0,   \
                    redcc__final __attribute__((__unused__)) = redcc__lower + redcc__trip

/** The trip count of a loop without a bound. The original loop continues after these iterations. */
#define REDCC_OPEN(redcc_count) ((redcc_count) < REDCC_OPEN_TRIP ? (redcc_count) : REDCC_OPEN_TRIP)

/** REDCC_FIRST_AND_LAST executes a statement twice: once for the rows that the first iteration
 * reads, and once for those that the last iteration reads. In that statement REDCC_FIRST_OR_LAST is
 * the counter's value in the respective iteration. */
#define REDCC_FIRST_AND_LAST for (redcc__end = 0; redcc__end < 2; redcc__end++)
#define REDCC_FIRST_OR_LAST(redcc_step) (redcc__end ? redcc__final - (redcc_step) : redcc__lower)

/** Describes a row that the loop reads. If several rows of a source are described, the loop may
 * read all rows between them. */
#define REDCC_KNOWN_ROW(redcc_i, redcc_row)                                                        \
    do {                                                                                           \
        const char *const redcc__row = (const char *)&redcc_row;                                   \
        redcc_known_row(&redcc__known[redcc_i], redcc__row, sizeof(redcc_row));                    \
        if (redcc__prefetches > 0)                                                                 \
            redcc_progression_row(&redcc__context.redcc__progressions[redcc_i], redcc__row,        \
                                  sizeof(redcc_row), redcc__end, redcc__trip);                     \
    } while (0)
/* Not inlined, because its speed does not matter before the loop. */
static __attribute__((__noinline__, __unused__)) void
redcc_known_row(redcc_extent *extent, const char *row, redcc_size bytes) {
    if (!extent->first || row < extent->first)
        extent->first = row;
    if (row + bytes > extent->end)
        extent->end = row + bytes;
}
/** Extends *extent, as redcc_known_row does, to the element base[k + by] of `bytes` bytes. Sets
 * *lost on overflow. */
REDCC_INLINE void redcc_known_element(redcc_extent *extent, const void *base, redcc_int k,
                                      redcc_int by, redcc_int bytes, int *lost) {
    const redcc_int into = redcc_exact_product(redcc_exact_sum(k, by, lost), bytes, lost);
    const redcc_int at = redcc_exact_sum((redcc_int)(redcc_size)base, into, lost);
    redcc_extent element;
    redcc_exact_extent(&element, at, at, bytes, lost);
    redcc_known_row(extent, element.first, (redcc_size)(element.end - element.first));
}

#include <redcc/prefetch.h>

/** Occupies rbp with the function's frame pointer. Values that are live across redcc_run are in
 * callee-saved registers, so otherwise a base of the sequential loop in the same function might be
 * in rbp. Loads from rbp plus an index were slower than from other registers: this cost 6 % of the
 * time of a product with a sparse matrix (script/bench choice, columns, on an Intel Xeon). */
#if defined(__x86_64__)
#define REDCC_KEEP_FRAME redcc_keep_frame(__builtin_frame_address(0))
#else
#define REDCC_KEEP_FRAME (void)0
#endif
REDCC_INLINE void redcc_keep_frame(const void *frame) {
    __asm__ __volatile__("" : : "r"(frame));
}

/** The table of the runtime's functions, or 0 if redcc_run has not set it yet. Another thread may
 * be setting it at the same time. */
REDCC_INLINE const redcc_calls *redcc_calls_of(const redcc_site *site) {
    return __atomic_load_n(&site->calls, __ATOMIC_ACQUIRE);
}

/** Is the trip count positive and, for _LIGHT (short iterations), at least *calls->least_trip, if
 * that is known? 0 if no runtime is linked. */
#define REDCC_IS_WORTH(redcc_site, redcc_trip) (redcc_run && (redcc_trip) > 0)
#define REDCC_IS_WORTH_LIGHT(redcc_site, redcc_trip)                                               \
    (redcc_run && redcc_is_worth(&(redcc_site), redcc_trip))
REDCC_INLINE int redcc_is_worth(const redcc_site *site, redcc_int trip) {
    const redcc_calls *const calls = redcc_calls_of(site);
    return trip > 0 && (!calls || trip >= __atomic_load_n(calls->least_trip, __ATOMIC_RELAXED));
}

/** A pointer that the loop reads only under a condition may be loaded before the loop.
 * REDCC_MAY_LOAD: is this allowed in this execution? REDCC_LOAD loads redcc_variable from
 * `redcc_offset` bytes after the target of `redcc_through`. It returns 0 if that memory is not
 * readable. */
#define REDCC_MAY_LOAD(redcc_site, redcc_loaded)                                                   \
    (redcc_is_known(&(redcc_site)) &&                                                              \
     redcc_calls_of(&(redcc_site))->before->may_load(&(redcc_site).binned.loop, &(redcc_loaded)))
#define REDCC_LOAD(redcc_site, redcc_variable, redcc_through, redcc_offset)                        \
    redcc_calls_of(&(redcc_site))                                                                  \
        ->before->load(&(redcc_variable),                                                          \
                       (const char *)((redcc_size)(redcc_through) + (redcc_offset)),               \
                       sizeof(redcc_variable))
REDCC_INLINE int redcc_is_known(redcc_site *site) {
    if (!redcc_calls_of(site))
        redcc_run(REDCC_INTERFACE, site, 0, 0, 0);
    {
        const redcc_calls *const calls = redcc_calls_of(site);
        return calls && calls->bytes >= sizeof *calls; /* a smaller table: an older library */
    }
}

/** May the loop be executed without its OpenMP directives? If they protect the loop's updates
 * (redcc_locks), it may only if no other thread of the process runs the program's code. 0 if no
 * runtime is linked. */
#define REDCC_REPLACES(redcc_site, redcc_locks)                                                    \
    (redcc_run && (!(redcc_locks) ||                                                               \
                   (redcc_is_known(&(redcc_site)) &&                                               \
                    redcc_calls_of(&(redcc_site))->before->is_alone(&(redcc_site).binned.loop))))

#include <redcc/blocks.h>
#include <redcc/crew.h>

/** Executes the loop in parallel. Not 0: it is done (redcc_run). 0: nothing was written, and the
 * original loop must run. Marked unlikely, so that the compiler gives the registers to the
 * sequential loop. */
#define REDCC_EXECUTED(redcc_site, redcc_member)                                                   \
    (redcc__key[0] = (redcc_word)redcc__lower, REDCC_KEEP_FRAME,                                   \
     redcc__attempt.trip = redcc__trip, redcc__attempt.first = redcc__lower,                       \
     redcc__attempt.bases = redcc__bases, redcc__attempt.known = redcc__known,                     \
     redcc__attempt.key = redcc__key,                                                              \
     (int)__builtin_expect(redcc_run(REDCC_INTERFACE, &(redcc_site), &redcc__attempt,              \
                                     redcc_member, &redcc__context),                               \
                           0))

/** For REDCC_CONTINUES, before REDCC_EXECUTED: redcc__made becomes the number of iterations that
 * are executed. REDCC_MADE is that number in the function that each thread executes. */
#define REDCC_MAY_CONTINUE redcc__attempt.made = &redcc__made
#define REDCC_MADE redcc__worker->call->trip

/** For REDCC_SECTIONED. REDCC_SECTIONS declares the sections of all arrays. REDCC_SECTION sets that
 * of array number redcc_i: the redcc_length elements of redcc_array from element redcc_lower on. */
#define REDCC_SECTIONS(redcc_arrays)                                                               \
    redcc_extent redcc__sections[redcc_arrays];                                                    \
    redcc__attempt.sections = redcc__sections
#define REDCC_SECTION(redcc_i, redcc_array, redcc_lower, redcc_length)                             \
    do {                                                                                           \
        redcc__sections[redcc_i].first =                                                           \
            (const char *)(redcc_array) +                                                          \
            (redcc_int)(redcc_lower) * (redcc_int)sizeof *(redcc_array);                           \
        redcc__sections[redcc_i].end =                                                             \
            redcc__sections[redcc_i].first +                                                       \
            (redcc_int)(redcc_length) * (redcc_int)sizeof *(redcc_array);                          \
    } while (0)

/** Requests memory for the operands of `redcc_count` scalar updates, one operand per iteration and
 * update. redcc__operand_bytes has the size of an operand of each update. */
#define REDCC_OPERANDS(redcc_count)                                                                \
    void *redcc__operands[redcc_count];                                                            \
    redcc__attempt.operand_count = redcc_count;                                                    \
    redcc__attempt.operand_bytes = redcc__operand_bytes;                                           \
    redcc__attempt.operands = redcc__operands
/** Declares the loop's series (redcc/series.h), which the runtime allocates. */
#define REDCC_HAS_SERIES(redcc_count)                                                              \
    redcc_series *redcc__series[redcc_count];                                                      \
    redcc__attempt.series_count = redcc_count;                                                     \
    redcc__attempt.series = redcc__series
/** redcc_kept has one value of type redcc_type for each iteration. Copies the value of iteration
 * redcc__k to redcc_element, the iteration's own element, if their bits differ. */
#define REDCC_STORE_KEPT(redcc_element, redcc_type, redcc_kept)                                    \
    do {                                                                                           \
        const redcc_type *const redcc__of_iteration = (const redcc_type *)redcc_kept + redcc__k;   \
        if (__builtin_memcmp(&(redcc_element), redcc__of_iteration, sizeof(redcc_type)) != 0)      \
            __builtin_memcpy(&(redcc_element), redcc__of_iteration, sizeof(redcc_type));           \
    } while (0)
/** With REDCC_OPERANDS_IN_BLOCKS, the operands of REDCC_SUM_BLOCK iterations are added up to 8
 * sums, which replace the first operands of the block: every eighth operand to the same sum, so
 * that an addition need not wait for the one before it. */
#define REDCC_SUM_COUNT(redcc_trip)                                                                \
    ((redcc_trip) / REDCC_SUM_BLOCK * 8 +                                                          \
     ((redcc_trip) % REDCC_SUM_BLOCK < 8 ? (redcc_trip) % REDCC_SUM_BLOCK : 8))
/** Stores redcc__operand, the operand of iteration redcc_k. */
#define REDCC_ADD_OPERAND(redcc_operands, redcc_k)                                                 \
    if (redcc__worker->variant.operands == REDCC_OPERANDS_IN_BLOCKS) {                             \
        const redcc_word redcc__number = (redcc_word)(redcc_k);                                    \
        __typeof__(redcc__operand) *const redcc__sum =                                             \
            &(redcc_operands)[redcc__number / REDCC_SUM_BLOCK * 8 + redcc__number % 8];            \
        *redcc__sum =                                                                              \
            redcc__number % REDCC_SUM_BLOCK < 8 ? redcc__operand : *redcc__sum + redcc__operand;   \
    } else                                                                                         \
        __atomic_store(&(redcc_operands)[redcc_k], &redcc__operand, __ATOMIC_RELAXED);
/** The sum of these sums, in an order that depends only on their number. */
#define REDCC_DEFINE_SUM(redcc_type)                                                               \
    static __attribute__((__noinline__, __unused__))                                               \
    redcc_type redcc_sum_##redcc_type(const redcc_type *redcc_from, redcc_int redcc_count) {       \
        redcc_type redcc_sum[8] = {-0.0f, -0.0f, -0.0f, -0.0f, -0.0f, -0.0f, -0.0f, -0.0f};        \
        const redcc_type *const redcc_end = redcc_from + redcc_count;                              \
        for (; redcc_end - redcc_from >= 8; redcc_from += 8) {                                     \
            redcc_sum[0] += redcc_from[0];                                                         \
            redcc_sum[1] += redcc_from[1];                                                         \
            redcc_sum[2] += redcc_from[2];                                                         \
            redcc_sum[3] += redcc_from[3];                                                         \
            redcc_sum[4] += redcc_from[4];                                                         \
            redcc_sum[5] += redcc_from[5];                                                         \
            redcc_sum[6] += redcc_from[6];                                                         \
            redcc_sum[7] += redcc_from[7];                                                         \
        }                                                                                          \
        for (; redcc_from != redcc_end; redcc_from++)                                              \
            redcc_sum[0] += *redcc_from;                                                           \
        return ((redcc_sum[0] + redcc_sum[1]) + (redcc_sum[2] + redcc_sum[3])) +                   \
               ((redcc_sum[4] + redcc_sum[5]) + (redcc_sum[6] + redcc_sum[7]));                    \
    }
REDCC_DEFINE_SUM(float)
REDCC_DEFINE_SUM(double)

/** Frees the operands after their use. */
#define REDCC_OPERANDS_END(redcc_site) redcc_site.calls->series->release(&redcc__attempt)

/** The parameters of the function that each thread executes. */
#define REDCC_MEMBER_PARAMETERS                                                                    \
    redcc_worker *redcc__worker, const redcc_attempt *redcc__attempt, const void *redcc__given
#define REDCC_MEMBER static void
/** The first statements of that function. */
#define REDCC_BEGIN(redcc_context)                                                                 \
    const struct redcc_context *const redcc__context = (const struct redcc_context *)redcc__given; \
    const redcc_int redcc__lower __attribute__((__unused__)) = redcc__attempt->first;              \
    const redcc_int redcc__trip __attribute__((__unused__)) = redcc__attempt->trip

/** Used in the body of the last iteration, which several threads may execute: 1 for exactly one of
 * them. */
#define REDCC_CLAIMS_LAST redcc__worker->call->calls->claims_last(redcc__worker)

/** A spin lock, held only for a few instructions. */
REDCC_INLINE void redcc_lock(int *lock) {
    while (__atomic_exchange_n(lock, 1, __ATOMIC_ACQUIRE))
        ;
}
REDCC_INLINE void redcc_unlock(int *lock) {
    __atomic_store_n(lock, 0, __ATOMIC_RELEASE);
}

/** The induction variable's value, redcc_lower plus redcc_offset, converted to redcc_type.
 * redcc_assume tells compilers that the conversion preserves the value, so that they can increment
 * addresses. Otherwise they would sign-extend the value and compute the address in each iteration:
 * two instructions of 43 in springs (script/bench choice), 10 % of the time with two threads. */
#define REDCC_COUNTER(redcc_type, redcc_offset)                                                    \
    (redcc_assume((redcc_int)(redcc_type)(redcc__lower + (redcc_offset)) ==                        \
                  redcc__lower + (redcc_offset)),                                                  \
     (redcc_type)(redcc__lower + (redcc_offset)))
REDCC_INLINE void redcc_assume(int redcc_holds) {
    if (!redcc_holds)
        __builtin_unreachable();
}

/** Follows the original loop: if loops are being timed, tells the runtime that this one has
 * ended. */
#define REDCC_OVER(redcc_site)                                                                     \
    do {                                                                                           \
        const redcc_calls *const redcc__calls =                                                    \
            __atomic_load_n(&(redcc_site).calls, __ATOMIC_ACQUIRE);                                \
        if (redcc__calls && __atomic_load_n(redcc__calls->timed_loops, __ATOMIC_RELAXED))          \
            redcc__calls->sequential_end(&(redcc_site).binned.loop);                               \
    } while (0);

/** As REDCC_OVER, for a loop that a jump may leave: declares a variable whose cleanup function does
 * the work of REDCC_OVER when its scope ends. */
#define REDCC_OVER_AT_JUMPS(redcc_of)                                                              \
    redcc_site *redcc__left __attribute__((__unused__, __cleanup__(redcc_left_by_jump))) =         \
        &(redcc_of)
REDCC_INLINE void redcc_left_by_jump(redcc_site **site) {
    REDCC_OVER(**site)
}

#include <redcc/slice.h>

/* ---- the body ------------------------------------------------------------------------------ */

/** Qualifiers of a body. In each call the argument redcc__checked is a constant, so that the body
 * is compiled separately for each value. */
#define REDCC_BODY REDCC_INLINE void

/** Marked cold: otherwise gcc would keep the body's constants in memory, because floating-point
 * registers do not survive a call. */
static __attribute__((__noinline__, __cold__, __unused__)) int
redcc_call_hook(const redcc_worker *worker, struct redcc_hook *hook, const void *address) {
    return worker->call->calls->hooked(hook, address);
}
REDCC_INLINE int redcc_is_owned(const redcc_worker *worker, const redcc_owner *owner,
                                const void *address) {
    return redcc_has(owner, address) ||
           (owner->hook && redcc_call_hook(worker, owner->hook, address));
}
/* As redcc_is_owned, but not inlined; for long iterations. */
static __attribute__((__noinline__, __unused__)) int
redcc_is_owned_by_call(const redcc_worker *worker, const redcc_owner *owner, const void *address) {
    return redcc_is_owned(worker, owner, address);
}

/** Precedes an update of array number redcc_i. In an owner-checked iteration (redcc__checked is 1)
 * the thread makes the update only if it owns the element. */
#define REDCC_UPDATE(redcc_i, redcc_at)                                                            \
    if (!redcc__checked ||                                                                         \
        (redcc__by_calls ? redcc_is_owned_by_call(redcc__worker, redcc__own_##redcc_i, redcc_at)   \
                         : redcc_is_owned(redcc__worker, redcc__own_##redcc_i, redcc_at)))

/** Begins an inner iteration. In an owner-checked outer iteration (redcc__checked is 1) the thread
 * skips the inner iteration unless redcc_owned is true. redcc_owned: does it own a row that the
 * inner iteration would update? */
#define REDCC_INNER_ITERATION(redcc_owned)                                                         \
    if (redcc__checked == 1 && !(redcc_owned))                                                     \
        continue;
/** REDCC_LEADS_ALONE, for a loop without series: must the thread execute every inner iteration,
 * even if it owns none of the rows? REDCC_OWNS_ROW: does it own a part of this row? */
#define REDCC_LEADS_ALONE (redcc__worker->variant.operands != REDCC_OPERANDS_BY_LEADER)
#define REDCC_OWNS_ROW(redcc_i, redcc_at, redcc_bytes)                                             \
    redcc_owns_part(redcc__own_##redcc_i, (const void *)(redcc_at), redcc_bytes)

/* Parameters, arguments and local variables for the arrays of a chunk: for each array, the base to
 * write to, and the elements that the thread owns. */
#define REDCC_BODY_PARAMETERS_1                                                                    \
    redcc_worker *const redcc__worker __attribute__((__unused__)), const int redcc__checked,       \
        const redcc_owner *const redcc__own_0
#define REDCC_BODY_PARAMETERS_2 REDCC_BODY_PARAMETERS_1, const redcc_owner *const redcc__own_1
#define REDCC_BODY_PARAMETERS_3 REDCC_BODY_PARAMETERS_2, const redcc_owner *const redcc__own_2
#define REDCC_BODY_PARAMETERS_4 REDCC_BODY_PARAMETERS_3, const redcc_owner *const redcc__own_3
#define REDCC_BODY_PARAMETERS_5 REDCC_BODY_PARAMETERS_4, const redcc_owner *const redcc__own_4
#define REDCC_BODY_PARAMETERS_6 REDCC_BODY_PARAMETERS_5, const redcc_owner *const redcc__own_5
#define REDCC_BODY_ARGUMENTS_1 redcc__worker, redcc__checked, &redcc__owner_0
#define REDCC_BODY_ARGUMENTS_2 REDCC_BODY_ARGUMENTS_1, &redcc__owner_1
#define REDCC_BODY_ARGUMENTS_3 REDCC_BODY_ARGUMENTS_2, &redcc__owner_2
#define REDCC_BODY_ARGUMENTS_4 REDCC_BODY_ARGUMENTS_3, &redcc__owner_3
#define REDCC_BODY_ARGUMENTS_5 REDCC_BODY_ARGUMENTS_4, &redcc__owner_4
#define REDCC_BODY_ARGUMENTS_6 REDCC_BODY_ARGUMENTS_5, &redcc__owner_5
#define REDCC_CHUNK_OF(redcc_i)                                                                    \
    void *const redcc__base_##redcc_i __attribute__((__unused__)) = redcc__worker->base[redcc_i];  \
    const redcc_owner redcc__owner_##redcc_i = redcc__worker->owner[redcc_i];
#define REDCC_CHUNK_1 REDCC_CHUNK_OF(0)
#define REDCC_CHUNK_2 REDCC_CHUNK_1 REDCC_CHUNK_OF(1)
#define REDCC_CHUNK_3 REDCC_CHUNK_2 REDCC_CHUNK_OF(2)
#define REDCC_CHUNK_4 REDCC_CHUNK_3 REDCC_CHUNK_OF(3)
#define REDCC_CHUNK_5 REDCC_CHUNK_4 REDCC_CHUNK_OF(4)
#define REDCC_CHUNK_6 REDCC_CHUNK_5 REDCC_CHUNK_OF(5)

#include <redcc/tiles.h>

/** Executes the runs from redcc__run to before redcc__run_end, each owner-checked or plain. If the
 * loop prefetches, each iteration is preceded by its prefetches. */
#define REDCC_EXECUTE_RUNS(redcc_call_of_slice, redcc_call_of_body)                                \
    for (; redcc__run != redcc__run_end; redcc__run++) {                                           \
        const redcc_int redcc__end =                                                               \
            redcc__worker->origin + redcc__run->begin + redcc__run->count_and_check / 2;           \
        redcc__k = redcc__worker->origin + redcc__run->begin;                                      \
        while (redcc__k < redcc__end) {                                                            \
            const redcc_int redcc__stop = redcc__is_prefetching ? redcc__k + 1 : redcc__end;       \
            REDCC_PREFETCH_ONE(redcc_call_of_slice)                                                \
            if (!(redcc__run->count_and_check & 1)) {                                              \
                const int redcc__checked = 0;                                                      \
                for (; redcc__k < redcc__stop; redcc__k++)                                         \
                    redcc_call_of_body;                                                            \
            } else {                                                                               \
                const int redcc__checked = 1;                                                      \
                for (; redcc__k < redcc__stop; redcc__k++)                                         \
                    redcc_call_of_body;                                                            \
            }                                                                                      \
        }                                                                                          \
    }

/** At the beginning of a function that executes a loop whose slice has hulls. */
#define REDCC_HULLS enum { redcc__has_hulls = 1 };
enum { redcc__has_hulls = 0 };

/** Classifies iterations, up to the first that leaves a fence: does the thread own a row that they
 * touch? The classes go to a local array, so that the compiler sees that storing them does not
 * change the slice's reads. */
#define REDCC_CLASSIFY(redcc_selects, redcc_call_of_slice)                                         \
    {                                                                                              \
        const redcc_u32 redcc__source_mask = 0;                                                    \
        const int redcc__unmapped = redcc_are_unmapped(redcc__worker);                             \
        unsigned char redcc__class[REDCC_SELECTED];                                                \
        if (redcc__has_hulls && redcc__unmapped)                                                   \
            for (redcc__k = redcc__worker->first; redcc__k < redcc__worker->last; redcc__k++)      \
                REDCC_CLASSIFY_ONE(1, redcc_selects, redcc_call_of_slice)                          \
        else {                                                                                     \
            int redcc__alike = REDCC_SETTLED; /* number of consecutive iterations of this class */ \
            for (redcc__k = redcc__worker->first; redcc__k < redcc__worker->last; redcc__k++) {    \
                if (!redcc__has_hulls && redcc__unmapped && redcc__alike >= REDCC_SETTLED)         \
                    REDCC_CLASSIFY_ALIKE(redcc_selects, redcc_call_of_slice)                       \
                if (redcc__k == redcc__worker->last)                                               \
                    break;                                                                         \
                REDCC_CLASSIFY_ONE(0, redcc_selects, redcc_call_of_slice)                          \
                redcc__alike = redcc__class[redcc__k - redcc__worker->first] ==                    \
                                       REDCC_CLASS_ALIKE(redcc_selects)                            \
                                   ? redcc__alike + 1                                              \
                                   : 0;                                                            \
            }                                                                                      \
        }                                                                                          \
        redcc_store_classes(redcc__worker, redcc__class, redcc__k);                                \
    }
/* By hulls no calls are needed. */
#define REDCC_CLASSIFY_ONE(redcc_hull, redcc_selects, redcc_call_of_slice)                         \
    {                                                                                              \
        redcc_probe redcc__seen = {0, 0, redcc_selects, 0, 0, 0, 0, redcc_hull};                   \
        redcc_probe *const redcc__probe = &redcc__seen;                                            \
        redcc_call_of_slice;                                                                       \
        if (__builtin_expect(redcc__seen.strays, 0))                                               \
            break;                                                                                 \
        redcc__class[redcc__k - redcc__worker->first] = redcc_class_of(&redcc__seen);              \
    }
/* Consecutive iterations that only touch elements of this thread: one comparison for each touch or
 * read, and no calls. Such an iteration leaves no fence, and this thread leads. */
#define REDCC_CLASSIFY_ALIKE(redcc_selects, redcc_call_of_slice)                                   \
    for (; redcc__k < redcc__worker->last; redcc__k++) {                                           \
        redcc_probe redcc__seen = {0, 0, 0, 0, 0, 0, 0, 0};                                        \
        redcc_probe *const redcc__probe = &redcc__seen;                                            \
        redcc_call_of_slice;                                                                       \
        if (!redcc_is_alike(&redcc__seen))                                                         \
            break;                                                                                 \
        redcc__class[redcc__k - redcc__worker->first] = REDCC_CLASS_ALIKE(redcc_selects);          \
    }
#define REDCC_CLASS_ALIKE(redcc_selects)                                                           \
    (REDCC_CLASS_OWN | ((redcc_selects) == 2 ? REDCC_CLASS_LEADS : 0))
/** Has no owner of an array a map? */
REDCC_INLINE int redcc_are_unmapped(const redcc_worker *worker) {
    unsigned a = 0;
    while (a < worker->call->loop->array_count && !worker->window[a].map)
        a++;
    return a == worker->call->loop->array_count;
}

/** Precedes a block that executes the next chunk: gets the chunk. Whenever redcc_next returns
 * REDCC_SELECT, classifies iterations and calls it again. */
#define REDCC_NEXT_CHUNK(redcc_selects, redcc_call_of_slice)                                       \
    for (;;) {                                                                                     \
        redcc__chunk_kind = redcc__worker->call->calls->next(redcc__worker);                       \
        if (__builtin_expect(redcc__chunk_kind != REDCC_SELECT, 1))                                \
            break;                                                                                 \
        REDCC_CLASSIFY(redcc_selects, redcc_call_of_slice)                                         \
    }

/** Executes chunks run by run, owner-checked or plain. */
#define REDCC_EXECUTE(redcc_chunk, redcc_call_of_slice, redcc_call_of_body)                        \
    REDCC_EXECUTE_AND(0, 1, redcc_chunk, redcc_call_of_slice, redcc_call_of_body)
/** As REDCC_EXECUTE. When no chunk is left and redcc_again is true, the block is executed once
 * more, with the runs that the runtime then sets. */
#define REDCC_EXECUTE_AND(redcc_again, redcc_selects, redcc_chunk, redcc_call_of_slice,            \
                          redcc_call_of_body)                                                      \
    for (;;) {                                                                                     \
        int redcc__chunk_kind;                                                                     \
        REDCC_NEXT_CHUNK(redcc_selects, redcc_call_of_slice)                                       \
        if (!redcc__chunk_kind && !(redcc_again))                                                  \
            break;                                                                                 \
        {                                                                                          \
            redcc_chunk const redcc_iterations *redcc__run = redcc__worker->run;                   \
            const redcc_iterations *const redcc__run_end = redcc__worker->run_end;                 \
            REDCC_PREFETCH_BEGIN(redcc__prefetches)                                                \
            REDCC_EXECUTE_RUNS(redcc_call_of_slice, redcc_call_of_body)                            \
        }                                                                                          \
    }

/** Precedes an inner loop that the compiler shall unroll. redcc writes it for at most 16
 * iterations. REDCC_UNROLLED_PLAIN does not unroll the owner-checked form under gcc, because that
 * form takes long to compile and is rarely executed. */
#ifdef __clang__
#define REDCC_UNROLLED                                                                             \
    _Pragma("clang diagnostic ignored \"-Wpass-failed\"") _Pragma("clang loop unroll(full)")
#define REDCC_UNROLLED_PLAIN REDCC_UNROLLED
#else
#define REDCC_UNROLLED _Pragma("GCC unroll 16")
#define REDCC_UNROLLED_PLAIN _Pragma("GCC unroll (redcc__checked ? 1 : 16)")
#endif

/** Used in the step expression of a loop that REDCC_UNROLLED_PLAIN precedes. Prevents its unrolling
 * in owner-checked iterations. */
#define REDCC_ROLLED(redcc_counter)                                                                \
    __extension__({                                                                                \
        if (redcc__checked)                                                                        \
            __asm__("" : "+r"(redcc_counter));                                                     \
    })

/* ---- the function of each thread ------------------------------------------------------------ */

/** Declares redcc__k and inspects the blocks that the runtime hands out to this thread. */
#define REDCC_JOIN(redcc_call_of_slice)                                                            \
    redcc_worker *const redcc__recorder = redcc__worker;                                           \
    redcc_int redcc__k;                                                                            \
    REDCC_INSPECT(redcc_call_of_slice)

/** Executed by each thread. Inspects the iterations that the runtime hands out for inspection, then
 * executes the iterations that it hands out for execution. redcc__k is the iteration's number. */
#define REDCC_PARALLEL(redcc_chunk, redcc_call_of_slice, redcc_call_of_body)                       \
    {                                                                                              \
        REDCC_JOIN(redcc_call_of_slice)                                                            \
        REDCC_EXECUTE(redcc_chunk, redcc_call_of_slice, redcc_call_of_body)                        \
    }

/** As REDCC_PARALLEL, for loops with series (redcc/series.h): all iterations may be executed a
 * second time, and of the threads that execute an iteration one is its leader. */
#define REDCC_PARALLEL_SERIES(redcc_chunk, redcc_again, redcc_call_of_slice, redcc_call_of_body)   \
    {                                                                                              \
        REDCC_JOIN(redcc_call_of_slice)                                                            \
        REDCC_EXECUTE_AND(redcc_again, 2, redcc_chunk, redcc_call_of_slice, redcc_call_of_body)    \
    }

/** Precedes the region of a loop, to keep its function inlined under gcc. gcc inlines a static
 * function that has a single call, but the region is compiled in several copies, and the function
 * must be inlined in each. (clang decides for each call separately.) */
#if !defined(__clang__) && defined(__OPTIMIZE__)
#define REDCC_QUIET_REDUNDANT _Pragma("GCC diagnostic ignored \"-Wredundant-decls\"")
#define REDCC_KEEP_INLINED(redcc_function)                                                         \
    REDCC_QUIET_REDUNDANT extern __inline__ __typeof__(redcc_function) redcc_function              \
        __attribute__((__always_inline__));
#else
#define REDCC_KEEP_INLINED(redcc_function)
#endif

#include <redcc/bins.h>

#endif
