/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The decision table of `auto`: identifier, what is known, what is done. The report names the row
 *  that decided last; docs/methods.md shows the table, and a test compares the two. */
#ifndef REDCC_RULE_H
#define REDCC_RULE_H

#define REDCC_RULE_LIST(X)                                                                         \
    X(RULE_NOT_PARALLEL,                                                                           \
      "one thread, inside a parallel region, or the loop is in use by another thread",             \
      "the original loop")                                                                         \
    X(RULE_SMALL_FIRST, "fewer than 4096 iterations, first call at such a trip count",             \
      "the original loop")                                                                         \
    X(RULE_SMALL, "fewer than 4096 iterations, next calls",                                        \
      "one thread executes all within the region, timed; below 10 µs: the original loop from "    \
      "then on")                                                                                   \
    X(RULE_CHEAP_COPIES,                                                                           \
      "order `any` or all arrays integer; copies possible and memory allows; 4 ns a touch that "   \
      "`localwrite` executes once more and 3 ns a run are more than 0.15 ns a byte of a copy "     \
      "(0.6 where plans cannot be kept)",                                                          \
      "`expansion`")                                                                               \
    X(RULE_TIMED,                                                                                  \
      "by a sample more than every fourth iteration begins a run; inspecting is reckoned "         \
      "at more than 1 ms, which is not within the budget; nothing is timed yet",                   \
      "one thread executes all within the region, timed")                                          \
    X(RULE_COSTLY, "the same; it is timed, and inspecting is reckoned at more than half of that",  \
      "the original loop")                                                                         \
    X(RULE_EVEN,                                                                                   \
      "by `localwrite`, no thread executes more than 1.1 times an equal share of the iterations",  \
      "`spare-localwrite` where spare parts are worth it (below), else `localwrite`")              \
    X(RULE_GRAPH,                                                                                  \
      "more; plans can be kept; what cutting the access graph will take is within the budget",     \
      "`graph-localwrite` is tried, or `spare-graph-localwrite` where spare parts are worth it")   \
    X(RULE_LEVELS,                                                                                 \
      "these owners too leave some thread more than 1.25 times an equal share; iterations in "     \
      "levels, a barrier reckoned as 200 of them, take less than 0.9 of that thread's",            \
      "`wavefront` is tried in its place")                                                         \
    X(RULE_INDEX, "more, but no thread executes more than 0.85 of the iterations", "`localwrite`") \
    X(RULE_COPIES,                                                                                 \
      "more than that; order `any` or all arrays integer; copies possible and memory allows",      \
      "`expansion`")                                                                               \
    X(RULE_DEFERRED, "more than that by a sample; an inspection is not yet within the budget",     \
      "the original loop")                                                                         \
    X(RULE_SERIAL, "more than that; otherwise",                                                    \
      "one thread executes all within the region, timed; then the original loop")                  \
    X(RULE_FASTER,                                                                                 \
      "two executions by a plan have been timed and one or two by one thread, or what that takes " \
      "is reckoned (below)",                                                                       \
      "the faster course is kept for trip counts of that size (between two powers of two)")        \
    X(RULE_GRAPH_KEPT,                                                                             \
      "it and what there was before have been timed three times each, in turn; it was the faster", \
      "it is kept")                                                                                \
    X(RULE_GRAPH_LOST, "it was not",                                                               \
      "what there was before; tried again after 16 to 1024 calls, the sooner the less slow it "    \
      "was (after 16, then at growing distances, where it was cut and other subscripts came "      \
      "before it had paid)")                                                                       \
    X(RULE_SLOWER,                                                                                 \
      "a parallel course is slower than the sequential loop was, 16 times in turn, and than it "   \
      "is, timed once more",                                                                       \
      "both are timed again")                                                                      \
    X(RULE_RESTING, "the original loop was chosen",                                                \
      "tried again after 16 to 256 calls, the sooner the less slow the parallel course was (16 "   \
      "after too much replication, or while an inspection is put off; 2 after a failed guard), "   \
      "then at growing distances")

enum rule {
    RULE_NONE, /* REDCC_METHOD names a method */
#define REDCC_RULE(id, known, done) id,
    REDCC_RULE_LIST(REDCC_RULE)
#undef REDCC_RULE
        RULE_COUNT
};

#endif
