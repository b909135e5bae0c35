/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* clang-format off */
/**
 * Defines how threads inspect and execute the loop REDCC_LOOP (redcc/parallel.h): NAME_run,
 * NAME_over and NAME_execute. Included once for each loop, after its slice, body, description and
 * entries. Plain C, so that a debugger steps through it. Before it:
 *
 *     #define REDCC_LOOP NAME
 *     #define REDCC_WHERE "file.c", 12, "function"     for reports: the line of your call
 *     #define REDCC_ARRAYS n           entries of NAME_arrays
 *     #define REDCC_SOURCES n          entries of NAME_sources; 0: there is no NAME_sources
 *   Options:
 *     #define REDCC_COUNTER type       of the counter; default: int
 *     #define REDCC_STEP expression    the counter's increment; default: 1. It may use `loop`
 *     #define REDCC_KEYS n             number of redcc_depends_on in the description; default: 0
 *     #define REDCC_FLAGS flags        of structures.h. REDCC_VERIFIABLE, the default: rows depend
 *                                      only on what parallel.h lists, so that a plan may be reused.
 *                                      For short iterations without loops:
 *                                      REDCC_VERIFIABLE | REDCC_LIGHT
 *     #define REDCC_ORDERED order      how the result may differ; default: REDCC_ORDER_SERIAL
 *     #define REDCC_STREAMS            NAME_streams is defined
 *     #define REDCC_NAMED bits         with NAME_streams: bit s if source s is given by
 *                                      redcc_reads_named, is no subscript, and may overlap an
 *                                      updated array. The slice is then executed with the body
 *     #define REDCC_ONE_BODY           the body is a REDCC_HEAVY_BODY
 *     #define REDCC_FINISH             void NAME_finish(const struct NAME *loop) is defined; the
 *                                      thread that executed the last iteration calls it
 * All of these are undefined at the end.
 */
/* clang-format on */
#pragma GCC system_header
#ifdef __clang__
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wpass-failed"
#endif

#define REDCC_PASTE_(redcc_a, redcc_b) redcc_a##redcc_b
#define REDCC_PASTE(redcc_a, redcc_b) REDCC_PASTE_(redcc_a, redcc_b)
#define REDCC_THIS(redcc_part) REDCC_PASTE(REDCC_LOOP, redcc_part)
#define REDCC_CONTEXT struct REDCC_LOOP
#ifndef REDCC_COUNTER
#define REDCC_COUNTER int
#endif
#ifndef REDCC_STEP
#define REDCC_STEP 1
#endif
#ifndef REDCC_KEYS
#define REDCC_KEYS 0
#endif
#ifndef REDCC_FLAGS
#define REDCC_FLAGS REDCC_VERIFIABLE
#endif
#define REDCC_ALL_FLAGS ((REDCC_FLAGS) | ((REDCC_FLAGS)&REDCC_LIGHT ? REDCC_SHORT : 0))
#ifndef REDCC_ORDERED
#define REDCC_ORDERED REDCC_ORDER_SERIAL
#endif
#ifndef REDCC_NAMED
#define REDCC_NAMED 0u
#endif

/* The counter's value in iteration k. The unreachable branch tells compilers that the conversion to
 * the counter's type preserves the value, so that they can increment addresses. */
REDCC_INLINE REDCC_COUNTER REDCC_THIS(_counter)(redcc_int first, redcc_int k,
                                                const REDCC_CONTEXT *loop) {
    const redcc_int value = first + k * (redcc_int)(REDCC_STEP);
    (void)loop;
    if ((redcc_int)(REDCC_COUNTER)value != value)
        __builtin_unreachable();
    return (REDCC_COUNTER)value;
}

/* Executes all iterations in order, in the calling thread. */
static __attribute__((__unused__)) void REDCC_THIS(_sequential)(const REDCC_CONTEXT *given,
                                                                const redcc_description *it) {
    const REDCC_CONTEXT context = *given;
    redcc_body body;
    redcc_int k;
    unsigned a;
    body.mode = REDCC_PLAIN;
    for (a = 0; a < REDCC_ARRAYS; a++)
        body.base[a] = it->bases[a];
    for (k = 0; k < it->trip; k++)
        REDCC_THIS(_body)(&body, REDCC_THIS(_counter)(it->first, k, &context), &context);
#ifdef REDCC_FINISH
    REDCC_THIS(_finish)(&context);
#endif
}

#ifndef REDCC_OFF

static redcc_site REDCC_THIS(_site) = {
    {{REDCC_WHERE, REDCC_ORDERED,
#ifdef REDCC_STREAMS
      REDCC_ALL_FLAGS | REDCC_BY_HAND | REDCC_SELECTS | REDCC_BINS_FLAG,
#else
      REDCC_ALL_FLAGS | REDCC_BY_HAND | REDCC_SELECTS,
#endif
      REDCC_ARRAYS, REDCC_THIS(_arrays), REDCC_SOURCES,
#if REDCC_SOURCES > 0
      REDCC_THIS(_sources),
#else
      0,
#endif
      1 + (REDCC_SOURCES) + (REDCC_KEYS), 0},
#ifdef REDCC_STREAMS
     REDCC_ARRAYS,
     0,
     REDCC_THIS(_streams)},
#else
     0,
     0,
     0},
#endif
    0};

/* Reports to the runtime what iterations touch. While redcc_is_settled returns 1, iterations are
 * only compared with known ranges, in a loop without calls. */
static void REDCC_THIS(_inspect)(redcc_worker *worker, const redcc_attempt *attempt,
                                 const REDCC_CONTEXT *given) {
    const REDCC_CONTEXT context = *given;
    const redcc_int first = attempt->first;
    redcc_slice report = {0, 0, 0};
    redcc_int k;
    report.worker = worker;
    while (worker->call->calls->inspect(worker))
        for (k = worker->first; k < worker->last; k += worker->stride) {
            if (redcc_is_settled(worker)) {
                const redcc_int from = k;
                for (; k < worker->last; k++) {
                    redcc_probe seen = {0, 0, 0};
                    redcc_slice compare = {0, 0, 0};
                    compare.probe = &seen;
                    compare.worker = worker;
                    REDCC_THIS(_slice)
                    (&compare, REDCC_THIS(_counter)(first, k, &context), &context);
                    if (!redcc_is_alike(&seen))
                        break;
                }
                worker->alike += k - from;
                if (k == worker->last)
                    break;
            }
            REDCC_THIS(_slice)(&report, REDCC_THIS(_counter)(first, k, &context), &context);
            redcc_iteration_done(worker);
        }
}

#ifdef REDCC_STREAMS
/* Executes iterations whose updates are pushed to bins, or made on the thread's private copies. 1:
 * the caller must execute the chunks that redcc_next hands out, and then call this function again.
 * 0: no such iterations are left. */
static int REDCC_THIS(_keep)(redcc_worker *worker, const redcc_attempt *attempt,
                             const REDCC_CONTEXT *given) {
    const REDCC_CONTEXT context = *given;
    redcc_bins handed[REDCC_ARRAYS];
    int more;
    while (__builtin_expect(
        (more = worker->call->calls->bins_next(worker, handed, 0)) == REDCC_TO_PUSH, 0)) {
        redcc_bins bins[REDCC_ARRAYS];
        redcc_slice named = {0, 0, REDCC_NAMED};
        redcc_rows rows;
        redcc_body body;
        redcc_int k;
        unsigned a;
        named.worker = worker;
        body.count = 0;
        body.used = 0;
        body.rows = &rows;
        body.worker = worker;
        body.arrays = REDCC_THIS(_arrays);
        body.streams = REDCC_THIS(_streams);
        body.bins = bins;
        for (a = 0; a < REDCC_ARRAYS; a++) {
            bins[a] = handed[a];
            body.base[a] = attempt->bases[a];
            if (REDCC_ARE_COPIED(&bins[0]))
                body.base[a] = redcc_copy_base(&bins[a], &REDCC_THIS(_streams)[a], 0);
        }
        for (k = worker->first; k < worker->last; k++) {
            const REDCC_COUNTER t = REDCC_THIS(_counter)(attempt->first, k, &context);
            if (REDCC_NAMED)
                REDCC_THIS(_slice)(&named, t, &context);
            if (REDCC_THIS(_streams)[0].exact && REDCC_ARE_COPIED(&bins[0])) {
                body.mode = REDCC_COPYING;
                REDCC_THIS(_body)(&body, t, &context);
            } else {
                body.mode = REDCC_KEEPING;
                REDCC_THIS(_body)(&body, t, &context);
            }
            redcc_end_rows(&body);
        }
    }
    return more == REDCC_TO_EXECUTE;
}
#endif

/* Classifies iterations, up to the first that leaves a fence: does the thread own a row that they
 * touch? The classes go to a local array, so that the compiler sees that storing them does not
 * change the slice's reads. */
static void REDCC_THIS(_select)(redcc_worker *worker, const redcc_attempt *attempt,
                                const REDCC_CONTEXT *given) {
    const REDCC_CONTEXT context = *given;
    unsigned char classes[REDCC_SELECTED];
    redcc_int k;
    for (k = worker->first; k < worker->last; k++) {
        redcc_probe seen = {0, 0, 1};
        redcc_slice select = {0, 0, 0};
        select.probe = &seen;
        select.worker = worker;
        REDCC_THIS(_slice)
        (&select, REDCC_THIS(_counter)(attempt->first, k, &context), &context);
        if (__builtin_expect(seen.strays, 0))
            break;
        classes[k - worker->first] = redcc_class_of(&seen);
    }
    redcc_store_classes(worker, classes, k);
}

/* Executes the chunks that redcc_next hands out. A chunk consists of runs of consecutive
 * iterations. The thread owns all rows of a plain run; in the iterations of an owner-checked run it
 * owns some rows. */
static void REDCC_THIS(_chunks)(redcc_worker *worker, const redcc_attempt *attempt,
                                const REDCC_CONTEXT *given) {
    const REDCC_CONTEXT context = *given;
    const redcc_int first = attempt->first;
    redcc_rows rows;
    int asked;
    while ((asked = worker->call->calls->next(worker)) != 0) {
        const redcc_iterations *run = worker->run;
        const redcc_iterations *const run_end = worker->run_end;
        redcc_body owned;
#ifndef REDCC_ONE_BODY
        redcc_body plain; /* separate from `owned`, so that its address does not escape */
        plain.mode = REDCC_PLAIN;
#endif
        unsigned a;
        if (__builtin_expect(asked == REDCC_SELECT, 0)) {
            REDCC_THIS(_select)(worker, attempt, given);
            continue;
        }
        owned.count = 0;
        owned.used = 0;
        owned.rows = &rows;
        owned.worker = worker;
        owned.arrays = REDCC_THIS(_arrays);
        owned.streams = 0;
        owned.bins = 0;
        for (a = 0; a < REDCC_ARRAYS; a++) {
            owned.owner[a] = worker->owner[a];
            owned.base[a] = worker->base[a];
#ifndef REDCC_ONE_BODY
            plain.base[a] = worker->base[a];
#endif
        }
        for (; run != run_end; run++) {
            const int asks = (int)(run->count_and_check & 1);
            redcc_int k = worker->origin + run->begin;
            const redcc_int end = k + run->count_and_check / 2;
#ifdef REDCC_ONE_BODY
            owned.mode = asks ? REDCC_OWNED : REDCC_PLAIN;
#else
            if (!asks) {
                for (; k < end; k++)
                    REDCC_THIS(_body)(&plain, REDCC_THIS(_counter)(first, k, &context), &context);
                continue;
            }
            owned.mode = REDCC_OWNED;
#endif
            for (; k < end; k++) {
                REDCC_THIS(_body)(&owned, REDCC_THIS(_counter)(first, k, &context), &context);
                redcc_end_rows(&owned);
            }
        }
    }
}

static void REDCC_THIS(_member)(redcc_worker *worker, const redcc_attempt *attempt,
                                const void *context) {
    const REDCC_CONTEXT *const loop = (const REDCC_CONTEXT *)context;
    REDCC_THIS(_inspect)(worker, attempt, loop);
#ifdef REDCC_STREAMS
    while (REDCC_THIS(_keep)(worker, attempt, loop))
        REDCC_THIS(_chunks)(worker, attempt, loop);
#endif
    REDCC_THIS(_chunks)(worker, attempt, loop);
#ifdef REDCC_FINISH
    if (worker->call->calls->claims_last(worker))
        REDCC_THIS(_finish)(loop);
#endif
}

/* Has this call an iteration and, if iterations are short, enough of them to call the runtime? */
REDCC_INLINE int REDCC_THIS(_is_worth)(redcc_int trip) {
    const redcc_calls *const calls = __atomic_load_n(&REDCC_THIS(_site).calls, __ATOMIC_ACQUIRE);
    return trip > 0 && (!((REDCC_FLAGS)&REDCC_LIGHT) || !calls ||
                        trip >= __atomic_load_n(calls->least_trip, __ATOMIC_RELAXED));
}

static int REDCC_THIS(_run)(const REDCC_CONTEXT *loop) {
    void *bases[REDCC_ARRAYS];
    redcc_extent known[(REDCC_SOURCES) + 1];
    redcc_word key[1 + (REDCC_SOURCES) + (REDCC_KEYS)];
    redcc_attempt attempt;
    redcc_description it;
    if (!redcc_run)
        return 0;
    it.counts_only = 1;
    it.gives_up = 0;
    REDCC_THIS(_describe)(&it, loop);
    if (!REDCC_THIS(_is_worth)(it.trip))
        return 0;
    it.counts_only = 0;
    it.bases = bases;
    it.known = known;
    it.starts = key + 1;
    it.extra = key + 1 + (REDCC_SOURCES);
    REDCC_THIS(_describe)(&it, loop);
    if (it.gives_up)
        return 0;
    key[0] = (redcc_word)it.first;
    attempt.trip = it.trip;
    attempt.first = it.first;
    attempt.bases = bases;
    attempt.known = known;
    attempt.key = key;
    attempt.linkage = 0;
    attempt.operand_count = 0;
    attempt.series_count = 0;
    return redcc_run(REDCC_INTERFACE, &REDCC_THIS(_site), &attempt, REDCC_THIS(_member), loop);
}

static __attribute__((__unused__)) void REDCC_THIS(_over)(void) {
    const redcc_calls *const calls = __atomic_load_n(&REDCC_THIS(_site).calls, __ATOMIC_ACQUIRE);
    if (calls && __atomic_load_n(calls->timed_loops, __ATOMIC_RELAXED))
        calls->sequential_end(&REDCC_THIS(_site).binned.loop);
}

#else

static __attribute__((__unused__)) int REDCC_THIS(_run)(const REDCC_CONTEXT *loop) {
    (void)loop;
    (void)REDCC_THIS(_arrays);
    return 0;
}

static __attribute__((__unused__)) void REDCC_THIS(_over)(void) {
}

#endif

static __attribute__((__unused__)) void REDCC_THIS(_execute)(const REDCC_CONTEXT *loop) {
    void *bases[REDCC_ARRAYS];
    redcc_extent known[(REDCC_SOURCES) + 1];
    redcc_word key[1 + (REDCC_SOURCES) + (REDCC_KEYS)];
    redcc_description it;
    if (REDCC_THIS(_run)(loop))
        return;
    it.counts_only = 0;
    it.gives_up = 0;
    it.bases = bases;
    it.known = known;
    it.starts = key + 1;
    it.extra = key + 1 + (REDCC_SOURCES);
    REDCC_THIS(_describe)(&it, loop);
    REDCC_THIS(_sequential)(loop, &it);
    REDCC_THIS(_over)();
}

#ifdef __clang__
#pragma clang diagnostic pop
#endif
#undef REDCC_PASTE_
#undef REDCC_PASTE
#undef REDCC_THIS
#undef REDCC_CONTEXT
#undef REDCC_LOOP
#undef REDCC_WHERE
#undef REDCC_ARRAYS
#undef REDCC_SOURCES
#undef REDCC_COUNTER
#undef REDCC_STEP
#undef REDCC_KEYS
#undef REDCC_FLAGS
#undef REDCC_ALL_FLAGS
#undef REDCC_ORDERED
#undef REDCC_STREAMS
#undef REDCC_NAMED
#undef REDCC_ONE_BODY
#undef REDCC_FINISH
