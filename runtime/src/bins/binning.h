/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * In-order binning (propagation blocking): an executor without an inspection, for loops whose
 * subscripts change. The iterations are executed in rounds.
 *
 *     measure  where nothing is known: some iterations, to see which rows and how many records
 *     push     each thread executes its share of the round's iterations, piece by piece, then
 *              pieces of others, and appends a record of each update to the bin of its row; nothing
 *              of the arrays is written
 *     guard    does what was read in the round overlap what it is to write? (one thread)
 *     apply    each bin is taken by one thread, which applies its records: the first piece's, the
 *              second's, ..., each as they were appended
 *
 * So each element gets its updates in the order of the loop, at every number of threads. A round of
 * which records are missing (rows outside of the bins, no more memory) is thrown away and executed
 * again, with other bins or fewer iterations. Where that is of no use, or the guard says no, the
 * rest of the loop runs sequentially: nothing of the round was written.
 *
 * In small arrays of integers, whose updates may be made in any order, each thread has a private
 * copy of the rows instead, and makes its updates at once; the copies are brought in at the end.
 *
 * A trial begins with a short round, after which as many iterations are executed sequentially: the
 * two are compared. It ends after the first round by which too much is lost.
 *
 * Rooms: window (rows and bins), pieces (who executes what), buffer (records), layout (sizes,
 * memory), guard, apply, rounds.
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
    BINS_STRETCH, /* of a trial: the first thread executes iterations sequentially */
    BINS_OVER     /* `begin` iterations are done */
};

/** One thread's part. What only it writes; others look after the barrier. */
struct binner {
    int thread;
    int threads;
    enum bins_phase phase;
    bool begun;              /* its part of the phase */
    struct bins_share share; /* of the round */
    int pieces;              /* it took in this round */
    redcc_int next;          /* of its piece [next, last) is not handed out yet */
    redcc_int last;
    redcc_int unseen;      /* iterations since it has looked whether records are missing */
    int sample;            /* stretches of iterations handed out to be measured */
    redcc_int measured;    /* iterations in them */
    redcc_extent *sources; /* [source_count] told by redcc_read, in this round */
    struct redcc_bin_buffer *buffer; /* [stream_count] */
};

/** A stream, as far as it is known; kept between executions. */
struct binned_stream {
    struct row_range rows; /* that were told */
    double
        rate; /* records an iteration, of the thread that has most, and some more; 0: not known */
    struct window window;
    struct row_range changed; /* of private copies: the rows that they bring something to */
    double cut_for;           /* records that the window was cut for; 0: it is to be cut */
};

/** The iterations of a round. */
struct round {
    redcc_int begin;
    redcc_int end;
    redcc_int most;                  /* iterations, of the rounds that follow */
    bool shortened;                  /* memory had not sufficed */
    int failures;                    /* in turn */
    unsigned long long error_before; /* as *error, where it is thrown away */
};

/** Whom to tell which bytes of an array will be written next, before they are; tell NULL: nobody.
 */
struct written_witness {
    void (*tell)(void *whom, uint32_t array, struct range written);
    void *whom;
};

/** What iterations leave beside the arrays, in the execution: undone with a round that is thrown
 * away.
 */
struct effects {
    atomic_int *last_claimed;
    atomic_ullong *error;
};

struct bins_trial {
    double may_lose;   /* seconds; 0: this is no trial */
    double began;      /* when */
    redcc_int stretch; /* iterations that were executed sequentially meanwhile, */
    double sequential; /* and the seconds that they took */
};

struct binning {
    const struct call *call;
    const redcc_binned *loop; /* NULL: it has no form for bins */
    struct barrier *barrier;
    struct binner **binner; /* [binners] of each thread */
    int binners;
    struct binned_stream *stream; /* [stream_count] */
    enum bins_phase phase;
    struct bins_trial trial;
    struct round round;
    bool copies;        /* private ones, in this execution */
    int cut_threads;    /* that the windows were cut for */
    bool denies_copies; /* the guard found them to be too coarse */
    atomic_uint next_bin;
    atomic_int failed; /* in this round, by some thread */
    struct effects effects;
    enum reason reason;     /* why the rest is sequential; NONE: all is done */
    struct overlap overlap; /* of REASON_OVERLAP */
    long rounds;
    size_t bytes;
    struct written_witness witness;
};

/** The loop's descriptor for bins; NULL: it has none. */
static inline const redcc_binned *redcc_binned_of(const redcc_loop *loop) {
    return loop->flags & REDCC_BINNED ? (const redcc_binned *)(const void *)loop : NULL;
}

/** Where a row of a stream's array is. */
static inline uintptr_t redcc_row_address(const struct binning *binning, const redcc_stream *stream,
                                          uint32_t array, redcc_int row) {
    return (uintptr_t)binning->call->request.bases[stream->arrays[array]] +
           (uintptr_t)row * stream->rows[array];
}

/* ---- layout.c -------------------------------------------------------------------------------- */

/** Cuts windows and takes memory for rounds of what is left of the loop, by what is known of the
 *  streams; by the thread that entered the loop. NONE, or why it cannot be. */
enum reason redcc_bins_lay_out(struct binning *binning);

/* ---- guard.c --------------------------------------------------------------------------------- */

/** Bins first to end - 1 hold all that the round will write of stream `s`; end == 0: nothing. */
struct used_bins {
    uint32_t first;
    uint32_t end;
};
struct used_bins redcc_used_bins(const struct binning *binning, uint32_t s);

/** May the records of the round be applied, or the copies be brought in? NONE, or why not. */
enum reason redcc_bins_guard(struct binning *binning);

/** Tells the witness what the round will write. The guard has allowed it. */
void redcc_bins_tell_written(const struct binning *binning);

/* ---- apply.c --------------------------------------------------------------------------------- */

/** Can the records of all streams be applied, by functions of the loop's or of the library's? */
bool redcc_bins_can_apply(const redcc_binned *loop);

/** The thread's part of applying all records. operands: the program's. */
void redcc_bins_apply(struct binning *binning, const struct binner *binner, const void *operands);

/** Sets the thread's private copies to what changes nothing. */
void redcc_private_fill(const struct binning *binning, const struct binner *binner);

/** The thread's part of bringing all threads' copies in. */
void redcc_private_merge(const struct binning *binning, const struct binner *binner);

/** The rows to which some thread's private copy will bring something. */
struct row_range redcc_private_rows(const struct binning *binning, uint32_t s);

/** Can the stream's updates be made on private copies, at the places of this call? */
bool redcc_private_possible(const struct binning *binning, const redcc_stream *stream);

/* ---- rounds.c -------------------------------------------------------------------------------- */

/** The state of a loop that was never executed. False: no memory. */
bool redcc_bins_new(struct binning *binning, const redcc_loop *loop);

/** A thread joins an execution of `threads` threads. */
void redcc_binner_join(struct binner *binner, int threads);

/** Begins an execution of binning->call. may_lose: where it is a trial, the seconds by which it may
 * take longer than the sequential loop before the rest runs sequentially; 0: it is none. One
 * thread.
 */
void redcc_bins_begin(struct binning *binning, double may_lose, struct written_witness witness);

/** Seconds an iteration that the sequential stretch of a trial took; 0: there was none. */
double redcc_bins_usual(const struct binning *binning);

/** The next iterations of the thread, into *worker and bins [stream_count]. False: it is over; or,
 *  where binner->phase is BINS_STRETCH, the round's are to be executed sequentially first. */
bool redcc_bins_step(struct binning *binning, struct binner *binner, redcc_worker *worker,
                     redcc_bins *bins, const void *operands);

/** A thread's part of a loop; NULL: no memory. And its end. */
struct binner *redcc_binner_new(const redcc_binned *loop, int thread);
void redcc_binner_free(struct binner *binner, const redcc_binned *loop);

/** Gives back the memory that records and copies are kept in. */
void redcc_bins_drop(struct binning *binning);

#endif
