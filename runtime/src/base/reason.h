/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#ifndef REDCC_REASON_H
#define REDCC_REASON_H

/** Reasons why a loop ran sequentially. Each has an identifier, a slug, and a text for the
 * report. */
#define REDCC_REASON_LIST(X)                                                                       \
    X(REASON_NONE, "", "")                                                                         \
    X(REASON_NAMED, "named-serial", "REDCC_METHOD says serial")                                    \
    X(REASON_FORKED, "forked", "in a process forked from one with several threads")                \
    X(REASON_TRAPS, "float-traps", "floating-point exceptions trap in the calling thread")         \
    X(REASON_NO_THREADS, "no-threads", "the system gives the process no more threads")             \
    X(REASON_ALLOCATOR, "allocator", "the program's free does not belong to aligned_alloc")        \
    X(REASON_HANDLER, "signal-handler", "in a signal handler, before threads exist")               \
    X(REASON_NESTED, "nested", "inside a parallel region")                                         \
    X(REASON_CONCURRENT, "concurrent", "the loop is being executed by another thread")             \
    X(REASON_ONE_THREAD, "one-thread", "one thread")                                               \
    X(REASON_TEAM, "more-threads", "the region has more threads than requested")                   \
    X(REASON_LITTLE_WORK, "little-work", "too little work")                                        \
    X(REASON_SERIAL_FASTER, "sequential-faster", "the sequential loop was measured to be faster")  \
    X(REASON_SAVING, "saving", "a trial may cost more than the loop's credit allows so far")       \
    X(REASON_COMPARED, "compared", "timed to compare with a plan")                                 \
    X(REASON_UNATTRACTIVE, "unattractive", "no plan is expected to be faster")                     \
    X(REASON_DEADLINE, "deadline", "an inspection exceeded its deadline")                          \
    X(REASON_CHANGED, "changed", "the subscripts are not those of the plan")                       \
    X(REASON_NO_MEMORY, "no-memory", "out of memory, or above REDCC_MEMORY_LIMIT")                 \
    X(REASON_ORDER_NEEDED, "order-needed",                                                         \
      "an update needs an order that the named method does not keep")                              \
    X(REASON_NO_COPIES, "no-copies", "no private copies can be made of a reduction array")         \
    X(REASON_MIXED, "mixed", "reduction arrays of unlike type or operator overlap")                \
    X(REASON_OUT_OF_STEP, "out-of-step", "reduction arrays overlap out of step")                   \
    X(REASON_LEVELS, "levels", "too many iterations or touches for levels, or none")               \
    X(REASON_INSPECTOR, "inspector", "the inspector did not record all iterations")                \
    X(REASON_NO_BINS, "no-bins", "the translated loop has no form for binning")                    \
    X(REASON_NO_INSPECTOR, "no-inspector",                                                         \
      "the subscripts cannot be computed twice: no plan can be made")                              \
    X(REASON_NO_SELECTION, "no-selection",                                                         \
      "the translated loop cannot select iterations during execution")                             \
    X(REASON_NO_TILES, "no-tiles", "the translated loop has no form for tiles")                    \
    X(REASON_SPREAD, "spread", "the range of the subscripts is too large for binning")             \
    X(REASON_TWO_ADDRESSES, "two-addresses",                                                       \
      "memory that is updated is, or may be, mapped at two addresses")                             \
    X(REASON_ASSERTION, "assertion",                                                               \
      "the program may see what an assertion that fails in a function leaves undone")              \
    X(REASON_LEAVES, "leaves", "an iteration leaves the loop")                                     \
    X(REASON_UNLINKED, "unlinked", "a function of another file is not linked as it was analysed")  \
    X(REASON_OTHER_THREADS, "other-threads",                                                       \
      "the loop ran with its OpenMP directives: other threads may update the same array")          \
    X(REASON_STRAYED, "strayed", "an iteration left the memory that the last inspection found")    \
    X(REASON_OVERLAP, "overlap", "something read overlaps a reduction array")

enum reason {
#define REDCC_REASON(id, slug, text) id,
    REDCC_REASON_LIST(REDCC_REASON)
#undef REDCC_REASON
        REASON_COUNT
};

/** The slug of a reason, and the text of a reason in the report. */
const char *redcc_reason_slug(enum reason reason);
const char *redcc_reason_text(enum reason reason);

#endif
