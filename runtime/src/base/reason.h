/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#ifndef REDCC_REASON_H
#define REDCC_REASON_H

/** Why a loop ran serially: identifier, and what the report says. */
#define REDCC_REASON_LIST(X)                                                                       \
    X(REASON_NONE, "")                                                                             \
    X(REASON_FORKED, "in a process forked from one with several threads")                          \
    X(REASON_TRAPS, "floating-point exceptions trap in the calling thread")                        \
    X(REASON_NO_THREADS, "the system gives the process no more threads")                           \
    X(REASON_HANDLER, "in the handler of a signal, before there were threads")                     \
    X(REASON_NESTED, "inside a parallel region")                                                   \
    X(REASON_CONCURRENT, "the loop is being executed by another thread")                           \
    X(REASON_ONE_THREAD, "one thread")                                                             \
    X(REASON_TEAM, "more threads came than were asked for")                                        \
    X(REASON_LITTLE_WORK, "too little work")                                                       \
    X(REASON_SERIAL_FASTER, "the sequential loop was measured to be faster")                       \
    X(REASON_SAVING, "a trial may cost more than the loop's credit allows so far")                 \
    X(REASON_COMPARED, "timed beside a plan")                                                      \
    X(REASON_UNATTRACTIVE, "no plan is expected to be faster")                                     \
    X(REASON_DEADLINE, "an inspection took longer than it was allowed to")                         \
    X(REASON_CHANGED, "the subscripts are not those of the plan")                                  \
    X(REASON_NO_MEMORY, "out of memory, or past REDCC_MEMORY_LIMIT")                               \
    X(REASON_ORDER_NEEDED, "an update needs an order that the method named does not keep")         \
    X(REASON_NO_COPIES, "no private copies can be made of a reduction array")                      \
    X(REASON_MIXED, "reduction arrays of unlike type or operator overlap")                         \
    X(REASON_OUT_OF_STEP, "reduction arrays overlap out of step")                                  \
    X(REASON_LEVELS, "too many iterations or touches to be put in levels, or none")                \
    X(REASON_INSPECTOR, "the inspector did not tell all iterations")                               \
    X(REASON_NO_BINS, "the translated loop has no form for binning")                               \
    X(REASON_SPREAD, "subscripts lie too far apart for binning")                                   \
    X(REASON_OVERLAP, "something read overlaps a reduction array")

enum reason {
#define REDCC_REASON(id, text) id,
    REDCC_REASON_LIST(REDCC_REASON)
#undef REDCC_REASON
        REASON_COUNT
};

#endif
