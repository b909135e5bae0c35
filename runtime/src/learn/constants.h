/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The constants of auto's decisions, each with the measurement behind it. Eleven belong to the rule
 * (docs/choosing.md), nine to the cost model. The latter give first estimates, which measurements
 * of the run replace. Times are those of the machines in bench/results.
 */
#ifndef REDCC_LEARN_CONSTANTS_H
#define REDCC_LEARN_CONSTANTS_H

/* ---- the rule ---- */

/** The bound's epsilon: the fraction of the sequential time that trials may cost. Two runs of a
 *  loop that never pays differ by 5 to 15 % on a shared machine (script/bench choice); 3 % is
 *  less. */
#define LEARN_SHARE (1.0 / 32)
/** The fraction of a sequential execution that one execution may lose, if its strategy is not
 * clearly faster. LOCALWRITE took up to 1.25 times the sequential time. On loops without runs it
 * took up to 1.6 times, but estimates predict that. */
#define LEARN_RISK 0.25
/** A strategy is clearly faster if an execution takes less than this fraction of the sequential
 * time. The difference is twice the noise of a busy machine, where medians differ by 10 %. */
#define LEARN_CLEAR 0.8
/** A strategy is worth a trial if it is expected to take less than this fraction of the present
 * time. Estimates were off by 10 % at best, and medians of one loop differ by 3 to 5 %. */
#define LEARN_BETTER 0.9
/** A comparison ends after one pair if the two times differ by this fraction, and after n pairs if
 * they differ by the n-th part of it. Executions on a shared machine vary by 30 %. */
#define LEARN_NOISE 0.3
/** Maximum pairs of a comparison: at a noise of 30 % it decides correctly in 19 of 20 cases. */
#define LEARN_PAIRS 3
/** The first plan construction waits until `since` is this multiple of its cost (theorem 2). Before
 * an overdraft, plans are compared over this many executions. */
#define LEARN_FACTOR 10
/** Maximum overdraft, in executions: twice the cost of cutting the access graph of a heavy loop,
 *  0.6. */
#define LEARN_OVERDRAFT 1.25
/** An execution must take this multiple of the time to wake threads: then waking two takes an
 *  eighth of the time that each executes. With 50, loops of 0.3 ms that gain 1.5 to 1.9 were left
 *  sequential. */
#define LEARN_WAKES 16
/** Calls of the first wait of an exponential back-off; the longest wait is 128 times as long. A
 * failed trial costs a fraction of an execution: less than 0.1 % of the time after the longest
 * wait. */
#define LEARN_BACK_OFF 16
/** After this many consecutive calls with known subscripts, these are expected to stay. After half
 * of it they no longer count as new. Half as many plan constructions that did not pay show that
 * subscripts keep changing. In a loop that changes two of millions of keys before each call, 4
 * loses 1 % and 2 loses 6 % (`count` of script/bench choice). */
#define LEARN_STABLE 4

/* ---- the cost model: seconds of one thread ---- */

/** A sample: 256 iterations of some touches. Starting threads on an idle machine takes as long (0.1
 *  to 0.4 ms), ten times as long on a busy one (2 to 6). */
#define LEARN_SAMPLE 0.4e-3
/** Iterations of that sample. A loop that cannot be inspected and has at least the square of this
 * number of iterations is tried in bins in its first execution, with a 16th of it. At 10 ns or more
 * per iteration it takes 0.7 ms or more. */
#define LEARN_SAMPLED 256
/** Recording a touch of an iteration with the same owners as the preceding one. Beginning a run of
 *  iterations takes three times that, and logging a touch seven. */
#define LEARN_TOUCH 1e-9
/** Assigning a row to an owner by majority vote, or a touch to a level: 13 to 20 ns. An iteration
 * that has other owners than the preceding one takes twice as long: 37 to 60 ns. Cutting owners
 * from the access graph takes 32 ns per row in all threads, then 25 ns in one thread while the
 * others wait. */
#define LEARN_ROW 20e-9
/** Filling and merging a byte of a private copy; four times as long if the system must allocate a
 * page for it. Reading and comparing a byte takes a third to a half of this (0.05 to 0.07 ns). */
#define LEARN_BYTE 0.15e-9
/** Useless tracking of a page: protecting it takes 0.1 microseconds, and the first write to it 1.3.
 * Comparing its 4096 bytes would take 0.12 (35 GB/s). */
#define LEARN_PAGE 1.45e-6
/** The slowdown when threads run in parallel: contention 1.05 to 1.4, scattered rows of owners
 * 1.15. Also the ratio of the largest share to an equal one, if the owners are balanced. */
#define LEARN_CONTENDED 1.1
/** The fraction of the iterations that change owners if all of them must be distinguished. */
#define LEARN_FREQUENT 0.25
/** Bytes of the caches of a current core. Random updates of arrays three times as large wait for
 *  memory: bins and prefetches help only there (script/bench binning). */
#define LEARN_CACHE 4e6

#endif
