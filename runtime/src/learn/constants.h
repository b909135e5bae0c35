/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * All constants that `auto` learns by, each with what it was measured by. Eleven are of the rule
 * (docs/choosing.md), nine of the cost model: first estimates, which give way to what is measured
 * in the run. Seconds are of the machines of bench/results.
 */
#ifndef REDCC_LEARN_CONSTANTS_H
#define REDCC_LEARN_CONSTANTS_H

/* ---- the rule ---- */

/** The bound's e: of the sequential time, what trials may cost. Two runs of a loop that is never
 *  worth it differ by 5 to 15 % on a machine that others use (script/bench choice); 3 % is less. */
#define LEARN_SHARE (1.0 / 32)
/** Of an execution, what one by a way that is not clearly faster may lose. LOCALWRITE on loops
 *  without runs took up to 1.6 times the sequential loop, but there estimates say so; else 1.25. */
#define LEARN_RISK 0.25
/** Of the sequential time, what one execution by a clearly faster way takes: twice the noise of a
 *  busy machine, whose medians differ by 10 %. */
#define LEARN_CLEAR 0.8
/** Of the present time, what a way must take to be worth a trial. Estimates were 10 % off where all
 *  went well, and medians of one loop differ by 3 to 5 %. */
#define LEARN_BETTER 0.9
/** Difference that ends a comparison after one pair; after n pairs the n-th part of it. Executions
 *  on a shared machine vary by 30 %. */
#define LEARN_NOISE 0.3
/** Pairs of a comparison at most: at a noise of 30 % it decides right in 19 of 20 cases. */
#define LEARN_PAIRS 3
/** Set-ups wait for so many times their cost, at first (theorem 2). So many executions count where
 *  ways are compared for a loan, too: with less, the second execution could not tell a plan that is
 *  used ten times from one that is used twice. */
#define LEARN_FACTOR 10
/** Executions that a loan is at most: twice what cutting the access graph of a heavy loop takes,
 *  0.6. */
#define LEARN_LOAN 1.25
/** Times as long as waking threads that an execution must take for it to be worth that: waking two
 *  takes an eighth of what each executes then. With 50, loops of 0.3 ms that gain 1.5 to 1.9 were
 *  left alone. */
#define LEARN_WAKES 16
/** Calls of the first wait of an exponential back-off; the longest is 128 times as long. A trial in
 *  vain costs a part of an execution, so that it is 0.1 % in the end. */
#define LEARN_REST 16
/** Calls in a row that met their subscripts, after which they are likely to stay. After half as
 *  many they are not new, and half as many set-ups that did not pay show that subscripts keep
 * changing. Of loops that two keys of millions change in before each call, 4 loses 1 %, 2 loses 6
 * (`count`). */
#define LEARN_SURE 4

/* ---- the cost model: seconds of one thread ---- */

/** A look at a sample: 256 iterations of some touches. Starting threads where the machine is not
 *  busy takes as long (0.1 to 0.4 ms), ten times as long where it is (2 to 6). */
#define LEARN_LOOK 0.4e-3
/** Iterations of that sample. */
#define LEARN_LOOKED_AT 256
/** Telling a touch of an iteration that follows alike. A run of iterations begins in three times
 *  that, and keeping a touch takes seven. */
#define LEARN_TOUCH 1e-9
/** A row that is assigned to an owner by majority vote, or a touch that is put in a level: 13 to 20
 *  ns. An iteration that has other owners than the last takes twice as long: 37 to 60 ns. Cutting
 * owners from the access graph takes one and a half times as long a row side by side, and then as
 * long again while the others wait (32 and 25 ns). */
#define LEARN_ROW 20e-9
/** A byte of a private copy that is filled and brought in; where the system has to find a page for
 *  it four times as long. To read and compare one takes a third to a half (0.05 to 0.07). */
#define LEARN_BYTE 0.15e-9
/** A page that is tracked for nothing: to protect it takes 0.1 microseconds, a write to it then 1.3
 *  once; to compare it, 0.12 (4096 bytes at 35 GB/s). */
#define LEARN_PAGE 1.45e-6
/** Times as long as alone that threads take side by side, 1.05 to 1.4; that owners of scattered
 *  rows take, 1.15; and of an equal share, what the largest is where owners are even. */
#define LEARN_CONTENDED 1.1
/** Of the iterations, those that change owners, where all of them are told apart. */
#define LEARN_FREQUENT 0.25
/** Bytes of the caches of a core of today. Random updates of arrays three times as large wait for
 *  memory: bins and prefetches help there and nowhere else (script/bench binning). */
#define LEARN_CACHE 4e6

#endif
