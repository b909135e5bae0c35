/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Fingerprints of the subscripts, each thread's share. They are taken piece by piece while the
 * inspector goes through the thread's iterations, as far as it has come: a loop mostly reads its
 * subscripts in the order of its iterations, and so they are still in the caches.
 */
#ifndef REDCC_HASHING_H
#define REDCC_HASHING_H

#include "base/call.h"
#include "reuse/reading.h"

/** A partial hash: the fingerprint of a thread's share of a source, as far as it is taken. */
struct partial_hash {
    struct reading reading; /* of which it is; empty: of none yet */
    size_t taken;           /* bytes */
    struct fingerprint so_far;
};

/** One thread's part. */
struct hasher {
    int thread;
    int threads;
    struct fingerprint *fingerprint; /* [source_count] of the own share */
    struct partial_hash *partial;    /* [source_count] while all iterations are told */
};

/** Is a source so small that every thread reads it, rather than its share? That costs less than the
 *  barrier that is saved. */
bool redcc_is_small(struct reading reading);

/** Of the thread's share of what is read. */
struct fingerprint redcc_hash_share(const struct hasher *hasher, struct reading reading);

/** To be called before the thread's iterations are told. wanted: a plan is to be kept. Returns the
 *  bytes of its share that will be hashed meanwhile, of sources whose place is known (sources
 *  [source_count]). */
size_t redcc_hash_begin(struct hasher *hasher, const struct request *request,
                        const struct range *sources, bool wanted);

/** So much of its iterations, 0 to 1, the thread has told: hashes as much of these sources. */
void redcc_hash_some(struct hasher *hasher, const redcc_loop *loop, double part);

/** Hashes what is left of the own share of all subscripts, into hasher->fingerprint. */
void redcc_hash_rest(struct hasher *hasher, const struct request *request,
                     const struct range *sources);

/** The fingerprint of source number `source`, from all threads' shares of it. */
struct fingerprint redcc_hash_joined(struct hasher *const *hasher, int threads, uint32_t source,
                                     struct reading reading);

#endif
