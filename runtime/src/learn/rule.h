/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The decision table of `auto`: identifier, slug, what is known, what is done. The report's
 *  `choice` is the slug of the row that decided last; docs/methods.md shows the table, and a test
 *  compares the two. */
#ifndef REDCC_RULE_H
#define REDCC_RULE_H

#define REDCC_RULE_LIST(X)                                                                         \
    X(RULE_NOT_PARALLEL, "not-parallel",                                                           \
      "one thread and no form for vectors, inside a parallel region, or the loop is in use by "    \
      "another thread",                                                                            \
      "the original loop")                                                                         \
    X(RULE_FIRST, "first",                                                                         \
      "no execution at trip counts of this size (between two powers of two) is timed",             \
      "the original loop, timed")                                                                  \
    X(RULE_SHORT, "short", "an execution takes less than 16 times as long as waking the threads",  \
      "the original loop; timed again after 16 calls, then at doubling distances up to 2048")      \
    X(RULE_SAVING, "saving",                                                                       \
      "a trial is worth it, but it may cost more than a 32nd of the time that the loop has "       \
      "taken so far and would not repay a loan at once, or its like has failed lately",            \
      "the original loop")                                                                         \
    X(RULE_LOOKING, "looking", "the credit allows a sample; what may be gained is not known",      \
      "a sample, and what follows from it; by one thread alone, where nothing says that the "      \
      "subscripts stay, or starting the others may cost too much")                                 \
    X(RULE_SET_UP, "set-up",                                                                       \
      "a way is expected to pay for its set-up, which credit or loan allow",                       \
      "an inspection with a deadline, and a plan")                                                 \
    X(RULE_UNATTRACTIVE, "unattractive", "by a sample no way is expected to be faster",            \
      "the original loop; another sample after 16 calls, then at doubling distances")              \
    X(RULE_CHANGING, "changing",                                                                   \
      "two plans in a row were abandoned before they had paid, and a sample of the subscripts "    \
      "differs from the call before",                                                              \
      "the original loop")                                                                         \
    X(RULE_CHANGED, "changed", "the subscripts are not those of the plan", "the original loop")    \
    X(RULE_COMPARING, "comparing",                                                                 \
      "a plan is new or was slow, or the sequential loop was not timed for long",                  \
      "the two ways take turns, until one is clearly faster or three pairs are timed")             \
    X(RULE_FASTER, "faster", "a plan was the faster way", "it is used while the subscripts stay")  \
    X(RULE_SLOWER, "slower", "a plan was the slower way",                                          \
      "the original loop; compared again after 16 calls, then at doubling distances")              \
    X(RULE_STOPPED, "stopped", "an inspection came to its deadline",                               \
      "the original loop; another set-up when the credit allows what is now known of its cost")    \
    X(RULE_REFUSED, "refused", "a guard or memory forbade it",                                     \
      "the original loop; tried again after 16 calls, then at doubling distances")

enum rule {
    RULE_NONE, /* REDCC_METHOD names a method */
#define REDCC_RULE(id, slug, known, done) id,
    REDCC_RULE_LIST(REDCC_RULE)
#undef REDCC_RULE
        RULE_COUNT
};

#endif
