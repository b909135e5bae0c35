/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * All constants that `auto` learns by, each with what it was measured by. Eleven are of the rule
 * (docs/choosing.md), nine of the cost model: first estimates, which give way to what is measured
 * in the run. Seconds are of the machines of bench/results.
 */
#ifndef REDCC_LEARN_CONSTANTS_H
#define REDCC_LEARN_CONSTANTS_H

/* ---- the rule ---- */

/** The bound's epsilon: the fraction of the sequential time that trials may cost. Two runs of a
 *  loop that never pays differ by 5 to 15 % on a shared machine (script/bench choice); 3 % is
 *  less. */
#define LEARN_SHARE (1.0 / 32)
/** The fraction of an execution that one by a strategy that is not clearly faster may lose.
 *  LOCALWRITE on loops without runs took up to 1.6 times the sequential loop, but estimates predict
 *  that; otherwise 1.25. */
#define LEARN_RISK 0.25
/** The fraction of the sequential time that one execution by a clearly faster strategy takes at
 *  most: twice the noise of a busy machine, whose medians differ by 10 %. */
#define LEARN_CLEAR 0.8
/** The fraction of the present time that a strategy must reach to be worth a trial. Estimates were
 *  off by 10 % at best, and medians of one loop differ by 3 to 5 %. */
#define LEARN_BETTER 0.9
/** The difference that ends a comparison after one pair; after n pairs, the n-th part of it.
 *  Executions on a shared machine vary by 30 %. */
#define LEARN_NOISE 0.3
/** Maximum pairs of a comparison: at a noise of 30 % it decides correctly in 19 of 20 cases. */
#define LEARN_PAIRS 3
/** Initially a plan construction waits until `since` is this multiple of its cost (theorem 2).
 *  Strategies are also compared over this many executions for an overdraft: with fewer, the second
 *  execution could not distinguish a plan that is used ten times from one that is used twice. */
#define LEARN_FACTOR 10
/** Maximum overdraft, in executions: twice the cost of cutting the access graph of a heavy loop,
 *  0.6. */
#define LEARN_LOAN 1.25
/** An execution must take this multiple of the time to wake threads: then waking two takes an
 *  eighth of the time that each executes. With 50, loops of 0.3 ms that gain 1.5 to 1.9 were left
 *  sequential. */
#define LEARN_WAKES 16
/** Calls of the first wait of an exponential back-off; the longest is 128 times as long. A failed
 *  trial costs a fraction of an execution, so that its cost falls to 0.1 %. */
#define LEARN_REST 16
/** Consecutive calls with known subscripts after which these are expected to stay. After half this
 *  number they no longer count as new, and half this number of plan constructions that did not pay
 *  shows that subscripts keep changing. In a loop that changes two of millions of keys before each
 *  call, 4 loses 1 %, 2 loses 6 (`count`). */
#define LEARN_SURE 4

/* ---- the cost model: seconds of one thread ---- */

/** A sample: 256 iterations of some touches. Starting threads on an idle machine takes as long (0.1
 *  to 0.4 ms), ten times as long on a busy one (2 to 6). */
#define LEARN_LOOK 0.4e-3
/** Iterations of that sample. The square of this number takes milliseconds in a loop that cannot be
 *  inspected, whose subscripts take some 10 ns and more: it is tried in bins in its first
 * execution, a 16th of it. */
#define LEARN_LOOKED_AT 256
/** Recording a touch of an iteration with the same owners as the preceding one. Beginning a run of
 *  iterations takes three times that, and logging a touch seven. */
#define LEARN_TOUCH 1e-9
/** A row that is assigned to an owner by majority vote, or a touch that is put in a level: 13 to 20
 *  ns. An iteration that has other owners than the last takes twice as long: 37 to 60 ns. Cutting
 * owners from the access graph takes one and a half times as long a row side by side, and then as
 * long again while the others wait (32 and 25 ns). */
#define LEARN_ROW 20e-9
/** Filling and merging a byte of a private copy; four times as long if the system must allocate a
 *  page for it. Reading and comparing one takes a third to a half (0.05 to 0.07). */
#define LEARN_BYTE 0.15e-9
/** Tracking a page without use: protecting it takes 0.1 microseconds, a write to it then 1.3 once;
 *  comparing it 0.12 (4096 bytes at 35 GB/s). */
#define LEARN_PAGE 1.45e-6
/** Slowdown by contention when threads run in parallel, 1.05 to 1.4; of owners with scattered rows,
 *  1.15; and the ratio of the largest to an equal share with even owners. */
#define LEARN_CONTENDED 1.1
/** The fraction of the iterations that change owners if all of them must be distinguished. */
#define LEARN_FREQUENT 0.25
/** Bytes of the caches of a current core. Random updates of arrays three times as large wait for
 *  memory: bins and prefetches help only there (script/bench binning). */
#define LEARN_CACHE 4e6

#endif
