/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The decision table of `auto`: for each rule its identifier, slug, condition and action. The
 * report's `rule` is the slug of the rule that decided last. docs/methods.md shows the table, and a
 * test compares it with this list. */
#ifndef REDCC_RULE_H
#define REDCC_RULE_H

#define REDCC_RULE_LIST(X)                                                                         \
    X(RULE_NOT_PARALLEL, "not-parallel",                                                           \
      "one thread and no form for vectors, inside a parallel region, or "                          \
      "another thread executes the loop",                                                          \
      "the original loop")                                                                         \
    X(RULE_FIRST, "first", "no execution at trip counts of this size is timed",                    \
      "the original loop, timed")                                                                  \
    X(RULE_SHORT, "short", "an execution takes less than 16 times the wake-up of the threads",     \
      "the original loop; timed again after a back-off")                                           \
    X(RULE_SAVING, "saving",                                                                       \
      "a trial may pay, but the credit does not cover it, and no overdraft is "                    \
      "allowed",                                                                                   \
      "the original loop, while the credit accumulates")                                           \
    X(RULE_SAMPLING, "looking", "the credit allows a sample; the possible gain is unknown",        \
      "a sample, and its consequences")                                                            \
    X(RULE_SET_UP, "set-up",                                                                       \
      "a method is expected to repay its plan construction, covered by credit or "                 \
      "overdraft",                                                                                 \
      "an inspection with a deadline, and a plan")                                                 \
    X(RULE_UNATTRACTIVE, "unattractive", "by a sample no method is expected to be faster",         \
      "the original loop; another sample after a back-off")                                        \
    X(RULE_CHANGING, "changing",                                                                   \
      "two plans in a row were abandoned before they had paid, and a sample "                      \
      "of the subscripts differs",                                                                 \
      "the original loop")                                                                         \
    X(RULE_CHANGED, "changed", "the subscripts are not those of the plan", "the original loop")    \
    X(RULE_COMPARING, "comparing",                                                                 \
      "a plan is new or was slow, or the sequential loop was not timed for "                       \
      "long",                                                                                      \
      "plan and sequential loop alternate, until one is clearly faster or "                        \
      "three pairs are timed")                                                                     \
    X(RULE_FASTER, "faster", "a plan was faster", "it is used while the subscripts are unchanged") \
    X(RULE_SLOWER, "slower", "a plan was slower",                                                  \
      "the original loop; compared again after a back-off")                                        \
    X(RULE_STOPPED, "stopped", "an inspection reached its deadline",                               \
      "the original loop; another when the credit allows its new estimate")                        \
    X(RULE_REFUSED, "refused", "a guard or memory forbade it",                                     \
      "the original loop; tried again after a back-off")

enum rule {
    RULE_NONE, /* used if REDCC_METHOD names a method */
#define REDCC_RULE(id, slug, known, done) id,
    REDCC_RULE_LIST(REDCC_RULE)
#undef REDCC_RULE
        RULE_COUNT
};

#endif
