/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "why.h"

#include "learn/constants.h"

#include <assert.h>
#include <string.h>

/* The first estimate of the time to wake the threads, 10 microseconds (choose/waking.c). */
static const double first_wake = LEARN_SAMPLE / 40;

/* Advice to the user for each reason. */
static const char *const remedies[REASON_COUNT] = {
    [REASON_NAMED] = "unset it, or name another method",
    [REASON_FORKED] =
        "execute another program in the child, or fork before the first parallel loop",
    [REASON_TRAPS] = "switch the traps off around the loop",
    [REASON_NO_THREADS] = "raise the limit on processes or on memory (ulimit)",
    [REASON_ALLOCATOR] = "link an allocator that defines aligned_alloc as well",
    [REASON_HANDLER] = "execute the loop outside of the handler first",
    [REASON_NESTED] = "the region around it has the threads already",
    [REASON_CONCURRENT] = "let one thread execute it at a time",
    [REASON_ONE_THREAD] = "set OMP_NUM_THREADS, or give the process more processors",
    [REASON_TEAM] = "let OpenMP give no more threads than it is asked for",
    [REASON_LITTLE_WORK] = "raise the work per call, or name a method",
    [REASON_SERIAL_FASTER] =
        "raise the work per iteration; REDCC_METHOD names a method all the same",
    [REASON_SAVING] = "raise the work per call, or name a method",
    [REASON_COMPARED] = "the faster of the two is used from then on",
    [REASON_UNATTRACTIVE] =
        "sort what is subscripted, raise the work per iteration, or name a method",
    [REASON_DEADLINE] = "call it more often with the same subscripts, or name a method",
    [REASON_CHANGED] = "keep subscripts for several calls, or name binning, which needs no plan",
    [REASON_NO_MEMORY] = "raise REDCC_MEMORY_LIMIT, or give the process more memory",
    [REASON_ORDER_NEEDED] = "name a method that keeps the order, as localwrite",
    [REASON_NO_COPIES] = "name a method without private copies, as localwrite",
    [REASON_MIXED] = "give each reduction array memory of its own",
    [REASON_OUT_OF_STEP] = "give each reduction array memory of its own",
    [REASON_LEVELS] = "name localwrite",
    [REASON_INSPECTOR] = "this is a fault of redcc's: please report it",
    [REASON_NO_BINS] = "name a method with a plan, as localwrite",
    [REASON_NO_INSPECTOR] = "name binning, which computes each iteration once",
    [REASON_NO_SELECTION] = "name localwrite, which makes a plan",
    [REASON_NO_TILES] = "name localwrite, which makes a plan",
    [REASON_ASSERTION] =
        "link the C library dynamically, and leave SIGABRT and __assert_fail to it",
    [REASON_LEAVES] = "nothing: the loop as it was written runs",
    [REASON_UNLINKED] = "compile both files again, together",
    [REASON_OTHER_THREADS] = "call the loop from the main thread, outside parallel regions, while "
                             "no other thread exists",
    [REASON_SPREAD] = "name a method with a plan, as localwrite",
    [REASON_TWO_ADDRESSES] = "map the memory once",
    [REASON_STRAYED] = "name a method that inspects each execution, such as localwrite, if this is "
                       "frequent",
    [REASON_OVERLAP] = "keep the arrays that the loop reads disjoint from those it updates"};

/* Is the reason that a method, rather than any method, cannot execute the loop? */
static bool is_about_method(enum reason reason) {
    switch (reason) {
    case REASON_ORDER_NEEDED:
    case REASON_NO_COPIES:
    case REASON_MIXED:
    case REASON_LEVELS:
    case REASON_NO_BINS:
    case REASON_NO_INSPECTOR:
    case REASON_NO_SELECTION:
    case REASON_NO_TILES:
    case REASON_SPREAD:
        return true;
    default:
        return false;
    }
}

/* Says which method can execute the loop in place of the named one; false if no method was named,
 * or the reason has nothing to do with it. */
static bool not_as_named(const struct statistics *it, enum reason reason, char text[REDCC_WHY]) {
    const struct named_for_loop named = it->why.named;
    if (!is_about_method(reason) || !named.method || !named.able || named.able == named.method)
        return false;
    snprintf(text, REDCC_WHY, "%s cannot execute this loop, but %s can: %s", named.method->name,
             named.able->name, redcc_reason_text(reason));
    return true;
}

/* The number of calls that were sequential for this reason. For overlaps it includes the counts of
 * the pairs of names. */
static long count_of(const struct statistics *it, enum reason reason) {
    long count = atomic_load(&it->fallback[reason]);
    for (int i = 0; reason == REASON_OVERLAP && i < REDCC_TEXTS; i++)
        count += it->why.overlap[i].count;
    return count;
}

/* The most frequent reason for sequential calls. Sets *sequential to the number of all sequential
 * calls; if that is 0, the returned reason has no meaning. */
static enum reason commonest(const struct statistics *it, long *sequential) {
    enum reason most = REASON_NONE;
    long greatest = 0;
    *sequential = 0;
    for (enum reason reason = REASON_NONE + 1; reason < REASON_COUNT; reason++) {
        const long count = count_of(it, reason);
        *sequential += count;
        if (count > greatest) {
            most = reason;
            greatest = count;
        }
    }
    return most;
}

/* The number of executions, each of `seconds` seconds, after which auto's credit covers a sample
 * and a plan construction that takes half an execution. */
static long repaid_after(double seconds) {
    const double look = LEARN_SAMPLE < LEARN_CLEAR * seconds ? LEARN_SAMPLE / seconds : LEARN_CLEAR;
    return (long)((look + 0.5) / LEARN_SHARE);
}

void redcc_why_sequential(const struct statistics *it, char text[REDCC_WHY]) {
    long sequential;
    const enum reason reason = commonest(it, &sequential);
    assert(reason < REASON_COUNT && sequential >= 0);
    const long calls = atomic_load(&it->calls), timed = it->sequential.calls;
    text[0] = '\0';
    if (sequential == 0 || 2 * sequential < calls)
        return;
    const char *remedy = remedies[reason];
    assert(remedy || reason == REASON_NONE);
    const double each = timed > 0 ? it->sequential.seconds / (double)timed : 0;
    if (reason == REASON_SAVING && timed > 0 && calls > repaid_after(each))
        snprintf(text, REDCC_WHY, "a call takes %.3g ms; no method is expected to save time: %s",
                 1e3 * each, remedy);
    else if (reason == REASON_SAVING && timed > 0)
        snprintf(text, REDCC_WHY,
                 "executed %ld times for %.3g ms; a plan repays after some %ld: %s", calls,
                 1e3 * each * (double)calls, repaid_after(each), remedy);
    else if (reason == REASON_LITTLE_WORK && timed > 0)
        snprintf(text, REDCC_WHY, "a call takes %.3g ms; threads pay from some %.2g ms on: %s",
                 1e3 * each, 1e3 * LEARN_WAKES * first_wake, remedy);
    else if (!not_as_named(it, reason, text))
        snprintf(text, REDCC_WHY, "%s: %s", redcc_report_reason(it, reason), remedy);
}
