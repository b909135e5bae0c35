/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * In-order binning (propagation blocking): an executor without an inspection, for loops whose
 * subscripts change. The iterations are executed in rounds. The phases are:
 *
 *     measure  if nothing is known: executes some iterations, to count rows and records
 *     push     each thread executes its share of the round's iterations, piece by piece, then
 *              pieces of other shares, and appends a record of each update to the bin of its
 *              row; the arrays are not written
 *     guard    do the round's reads overlap the ranges it will write? (one thread)
 *     apply    one thread takes each bin and applies its records: the first piece's, the second's,
 *              ..., each in the order they were appended
 *
 * So each element gets its updates in the order of the loop, with any number of threads. If records
 * of a round are missing (a row was outside of the bins, or memory was exhausted), the round is
 * aborted and executed again, with other bins or fewer iterations. If that does not help, or the
 * guard fails, the rest of the loop runs sequentially. This is possible because an aborted round
 * has written nothing.
 *
 * For small arrays of integers, whose updates may be made in any order, each thread instead has a
 * private copy of the rows, and updates it immediately. The copies are merged at the end. Loops
 * with a fixed order have a copy for each of their shares (shares.h).
 *
 * In a trial, the first round is short. After it, the same number of iterations (a stretch) is
 * executed sequentially, and the two times are compared. After each round, the trial ends if it has
 * lost too much time.
 *
 * The files are window (rows and bins), pieces (distribution of iterations), buffer (records),
 * layout (sizes, memory), shares, guard, apply, rounds.
 */
#ifndef REDCC_BINNING_H
#define REDCC_BINNING_H

#include "base/barrier.h"
#include "base/bins_kind.h"
#include "base/call.h"
#include "base/reason.h"
#include "bins/buffer.h"
#include "ownership/overlap.h"

enum bins_phase {
    BINS_START,
    BINS_MEASURE,
    BINS_PUSH,
    BINS_APPLY,
    BINS_STRETCH, /* in a trial: the first thread executes a stretch of iterations sequentially */
    BINS_OVER     /* the iterations before round.begin are done */
};

/** One thread's part in the binning. Only this thread writes to it, except that other threads take
 * pieces of `share`. Other threads read the rest after the barrier. */
struct binner {
    int thread;
    int threads;
    enum bins_phase phase;
    bool begun;              /* the thread's part of the phase has begun */
    struct bins_share share; /* the thread's share of the round */
    int pieces;              /* number of pieces taken in this round */
    redcc_int next; /* iterations [next, last) of the current piece are not handed out yet */
    redcc_int last;
    redcc_int unseen;      /* number of iterations since the last check for missing records */
    int sample;            /* number of stretches of iterations handed out for measuring */
    redcc_int measured;    /* number of iterations in these stretches */
    redcc_int pushed;      /* number of iterations pushed in this round */
    redcc_extent *sources; /* [source_count] ranges recorded by redcc_read in this round */
    struct redcc_bin_buffer *buffer; /* [stream_count] the thread's records of each stream */
    const struct binner *holder; /* its buffers are those that the thread's iterations use. It is
                                    the binner itself, except in shares */
};

/** What is known of a stream; remembered for later executions. */
struct binned_stream {
    struct row_range rows; /* the range of the recorded rows */
    double rate; /* records per iteration, for the thread with most records per iteration, plus a
                    margin; 0: unknown */
    struct window window;
    struct row_range changed; /* the rows that private copies change */
    double cut_for;  /* number of records that was expected when the window was cut; 0: the window
                        must be cut */
    int cut_threads; /* the number of threads for which the window was cut */
    bool is_copied;  /* it was cut for private copies */
};

/** The iterations of a round. */
struct round {
    redcc_int begin;
    redcc_int end;
    redcc_int most;                  /* maximum number of iterations of later rounds */
    bool shortened;                  /* rounds were shortened because memory was insufficient */
    int failures;                    /* number of consecutive failures */
    unsigned long long error_before; /* the value of *error when the round began; restored if the
                                        round is aborted */
};

/** A function `tell`, to be called for the bytes of each array that are about to be written, with
 * `whom` as first argument. `tell` is NULL if there is no such function. */
struct written_witness {
    void (*tell)(void *whom, uint32_t array, struct range written);
    void *whom;
};

/** Effects of iterations other than on the arrays. They are undone if a round is aborted. */
struct effects {
    atomic_int *last_claimed;
    atomic_ullong *error;
};

struct bins_trial {
    double may_lose; /* seconds that the trial may lose. At least -1 and below 0: minus a share of
                        the sequential loop's time, which is not known yet. 0: this is no trial */
    double usual;    /* seconds per iteration of the sequential loop, as known before the trial; 0:
                        unknown */
    double began;    /* when the trial began, on the clock of redcc_seconds */
    double pushes;   /* with REDCC_WHOLE, which has only one round: when pushing began */
    bool is_late;    /* pushing that round takes too long */
    redcc_int stretch; /* number of iterations that the trial executes sequentially */
    double sequential; /* seconds that these iterations took; while they run, the time at which they
                          began */
};

/** Private copies. */
struct private_copies {
    int count;        /* their number in this execution; 0: it uses records */
    bool are_tight;   /* the guard failed with windows that have a margin: they begin without one */
    bool are_denied;  /* the guard failed without a margin as well; records, whose ranges are more
                         precise, may pass */
    bool are_neutral; /* the last merge has made all copies neutral, and nothing has changed them */
    bool need_filling; /* in this execution */
};

struct binning {
    const struct call *call;
    const redcc_binned *loop; /* NULL: the loop has no form for bins */
    struct barrier *barrier;
    struct binner **binner; /* [binners] the parts of the threads */
    int binners;
    struct binned_stream *stream; /* [stream_count] what is known of each stream */
    struct binned_stream *known; /* [2 * stream_count] the same, from executions in the order of the
                                    loop, then from those in shares. These do not know of each
                                    other, because the shares must not depend on threads */
    enum bins_phase phase;
    struct bins_trial trial;
    struct round round;
    struct private_copies copies;
    atomic_uint next_bin; /* or the set of the shares that threads have taken */
    atomic_int failed;    /* the round is aborted, because records are missing or it is late */
    struct effects effects;
    enum reason reason; /* why the rest of the loop must run sequentially; REASON_NONE if binning
                           executes the whole loop */
    struct overlap overlap; /* with REASON_OVERLAP: the ranges that overlap */
    long rounds;
    size_t bytes;
    struct written_witness witness;
};

/** The loop's descriptor for bins; NULL: the loop has no form for bins. */
static inline const redcc_binned *redcc_binned_of(const redcc_loop *loop) {
    return loop->flags & REDCC_BINNED ? (const redcc_binned *)(const void *)loop : NULL;
}

/** Must the guard check all updates of the loop before the first update is made? True with
 * REDCC_WHOLE, unless REDCC_BINS_CHECKED has checked them before. Then the whole loop is one round,
 * and no stretch of it is executed sequentially. */
static inline bool redcc_bins_is_whole(const struct binning *binning) {
    const unsigned flags = binning->loop->loop.flags;
    return flags & REDCC_WHOLE && !(flags & REDCC_BINS_CHECKED);
}

/** The number of binners whose buffers an execution uses: the first ones. */
static inline int redcc_bins_holders(const struct binning *binning) {
    return binning->copies.count > 0 ? binning->copies.count : binning->call->threads;
}

/** The address of a row of a stream's array. */
static inline uintptr_t redcc_row_address(const struct binning *binning, const redcc_stream *stream,
                                          uint32_t array, redcc_int row) {
    return (uintptr_t)binning->call->request.bases[stream->arrays[array]] +
           (uintptr_t)row * stream->rows[array];
}

/* ---- layout.c -------------------------------------------------------------------------------- */

/** Cuts windows and allocates memory for rounds of the remaining iterations, using what is known of
 * the streams. Called by the thread that entered the loop. Returns REASON_NONE, or the reason why
 * this is impossible. */
enum reason redcc_bins_lay_out(struct binning *binning);

/* ---- guard.c --------------------------------------------------------------------------------- */

/** The range [first, end) of bins that contains everything of stream `s` that the round will write;
 * end == 0: it will write nothing. */
struct used_bins {
    uint32_t first;
    uint32_t end;
};
struct used_bins redcc_used_bins(const struct binning *binning, uint32_t s);

/** May the records of the round be applied, or the copies be merged? Returns REASON_NONE if so,
 * otherwise the reason against it. */
enum reason redcc_bins_guard(struct binning *binning);

/** Calls the witness for each range that the round will write, after the guard has passed. */
void redcc_bins_tell_written(const struct binning *binning);

/* ---- apply.c --------------------------------------------------------------------------------- */

/** Can the records of all streams be applied, by the loop's apply functions or by functions of the
 * library? */
bool redcc_bins_can_apply(const redcc_binned *loop);

/** Executes the thread's part in applying all records. `operands` is the pointer that the program
 * gave to redcc_bins_next. */
void redcc_bins_apply(struct binning *binning, const struct binner *binner, const void *operands);

/** Sets the binner's private copies to neutral elements. */
void redcc_private_fill(const struct binning *binning, const struct binner *binner);

/** Executes the thread's part in merging all copies, in their order. */
void redcc_private_merge(const struct binning *binning, const struct binner *binner);

/** The rows of stream `s` that some private copy will change. */
struct row_range redcc_private_rows(const struct binning *binning, uint32_t s);

/** Can the stream's updates be made on private copies, at the addresses of this call? */
bool redcc_private_possible(const struct binning *binning, const redcc_stream *stream);

/* ---- rounds.c -------------------------------------------------------------------------------- */

/** Must a trial in a single round of `trip` iterations be given up, because pushing takes too long?
 * A thread has pushed the fraction `pushed` of its share. */
bool redcc_bins_are_late(const struct bins_trial *trial, double trip, double pushed, double now);

/** Begins an execution of binning->call. Called by one thread. may_lose and usual are described in
 * struct bins_trial. In a trial, the rest of the loop runs sequentially once the execution has lost
 * more than may_lose, compared with the sequential loop. */
void redcc_bins_begin(struct binning *binning, double may_lose, double usual,
                      struct written_witness witness);

/** Seconds per iteration of the stretch that a trial has executed sequentially; 0: there was none.
 */
double redcc_bins_usual(const struct binning *binning);

/** Gets the thread's next iterations, in *worker and bins[stream_count]. Returns false if the loop
 * is over. Also returns false if binner->phase is BINS_STRETCH: then the iterations of the round
 * must first be executed sequentially. */
bool redcc_bins_step(struct binning *binning, struct binner *binner, redcc_worker *worker,
                     redcc_bins *bins, const void *operands);

/* ---- binner.c ------------------------------------------------------------------------------- */

/** Initialises the bins of a loop that was never executed. False: out of memory. */
bool redcc_bins_new(struct binning *binning, const redcc_loop *loop);

/** Prepares a thread for an execution by `threads` threads. */
void redcc_binner_join(struct binner *binner, int threads);

/** redcc_binner_new allocates a thread's part (NULL: out of memory). redcc_binner_free frees it. */
struct binner *redcc_binner_new(const redcc_binned *loop, int thread);
void redcc_binner_free(struct binner *binner, const redcc_binned *loop);

/** Frees the memory of records and copies. */
void redcc_bins_drop(struct binning *binning);

#endif
