/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The constants of auto's decisions, each with the measurement behind it. Eleven belong to the rule
 * (docs/choosing.md), nine to the cost model. The constants of the cost model give first estimates,
 * which are replaced by measurements during the run. Times are those of the machines in
 * bench/results.
 */
#ifndef REDCC_LEARN_CONSTANTS_H
#define REDCC_LEARN_CONSTANTS_H

/* ---- the rule ---- */

/** The epsilon of the bound (docs/choosing.md): the fraction of the sequential time that trials may
 * cost. Two runs of a loop for which no strategy pays differ by 5 to 15 % on a shared machine
 * (script/bench choice); 3 % is less than that. */
#define LEARN_SHARE (1.0 / 32)
/** The fraction of the sequential time that one execution may lose, if its strategy is not clearly
 * faster. LOCALWRITE took up to 1.25 times the sequential time. It took up to 1.6 times on loops in
 * which consecutive iterations have different owners, but the estimates predict that. */
#define LEARN_RISK 0.25
/** A strategy is clearly faster if an execution takes less than this fraction of the sequential
 * time. The difference is twice the noise of a busy machine, on which medians differ by 10 %. */
#define LEARN_CLEAR 0.8
/** A strategy is worth a trial if it is expected to take less than this fraction of the present
 * time. Estimates were off by 10 % at best, and medians of one loop differ by 3 to 5 %. */
#define LEARN_BETTER 0.9
/** A comparison ends after one pair if the two times differ by this fraction. After n pairs it ends
 * if the shortest times differ by the n-th part of this fraction. Executions on a shared machine
 * vary by 30 %. */
#define LEARN_NOISE 0.3
/** Maximum number of pairs of a comparison: at a noise of 30 % it decides correctly in 19 of 20
 * cases. */
#define LEARN_PAIRS 3
/** The first plan construction waits until the sequential loop has taken (`since` of struct
 * set_ups) this multiple of the construction's cost (theorem 2 of docs/choosing.md). In deciding
 * about an overdraft, plans are compared over this many executions. */
#define LEARN_FACTOR 10
/** Maximum overdraft, in units of a sequential execution's time. Partitioning the access graph of a
 * loop with long iterations costs 0.6; the limit is twice that. */
#define LEARN_OVERDRAFT 1.25
/** An execution is worth parallelising if it takes at least this multiple of the time to wake
 * threads. With two threads, waking them then takes an eighth of the time that each thread
 * executes. With 50 instead, loops of 0.3 ms with speed-ups of 1.5 to 1.9 were left sequential. */
#define LEARN_WAKES 16
/** The number of calls of the first wait of an exponential back-off. The longest wait has 128 times
 * this number. A failed trial costs a fraction of an execution. With the longest wait, that is less
 * than 0.1 % of the time. */
#define LEARN_BACK_OFF 16
/** After this many consecutive calls whose subscripts were those of earlier calls, the subscripts
 * are expected to stay. After half as many such calls, they no longer count as new. Half as many
 * plan constructions that did not pay show that subscripts keep changing. In a loop that changes
 * two of millions of keys before each call, 4 loses 1 % and 2 loses 6 % (`count` of script/bench
 * choice). */
#define LEARN_STABLE 4

/* ---- the cost model: seconds of one thread ---- */

/** Seconds of a sample of 256 iterations with some touches each. Starting threads takes about this
 * time on an idle machine (0.1 to 0.4 ms), and ten times this time on a busy one (2 to 6 ms). */
#define LEARN_SAMPLE 0.4e-3
/** The number of iterations of that sample. A loop that cannot be inspected is tried in bins in its
 * first execution, with a 16th of its iterations, if its trip count is at least the square of this
 * number. At 10 ns or more per iteration, an execution then takes 0.7 ms or more. */
#define LEARN_SAMPLED 256
/** Seconds to record a touch, if the iteration has the same owners as the iteration before.
 * Beginning a run of iterations takes three times this time, and logging a touch takes seven times
 * this time. */
#define LEARN_TOUCH 1e-9
/** Seconds to assign a row to an owner by majority vote, or a touch to a level: measured 13 to 20
 * ns. Recording an iteration that has other owners than the iteration before takes twice as long:
 * 37 to 60 ns. Partitioning the access graph takes 32 ns per row, divided among the threads, and
 * then 25 ns per row in one thread while the others wait. */
#define LEARN_ROW 20e-9
/** Seconds to fill and merge a byte of a private copy. It takes four times as long if the system
 * must allocate a page for the byte. Reading and comparing a byte takes a third to a half of this
 * (0.05 to 0.07 ns). */
#define LEARN_BYTE 0.15e-9
/** Seconds lost by useless tracking of a page: protecting it takes 0.1 microseconds, and the first
 * write to it 1.3 microseconds more. For comparison, hashing its 4096 bytes takes 0.12 microseconds
 * (35 GB/s). */
#define LEARN_PAGE 1.45e-6
/** The factor by which an execution is slower than its equal share suggests. Contention slows
 * threads by 1.05 to 1.4, scattered rows of an owner by 1.15. Owners also count as balanced up to
 * this ratio of the largest share to an equal share. */
#define LEARN_CONTENDED 1.1
/** If at least this fraction of the iterations have other owners than the iteration before, owners
 * count as alternating all the time. */
#define LEARN_FREQUENT 0.25
/** Bytes of the caches of a current core. Random updates of arrays three times as large wait for
 * memory. Only then do bins and prefetches help (script/bench binning). */
#define LEARN_CACHE 4e6

#endif
