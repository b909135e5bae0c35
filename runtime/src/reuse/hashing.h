/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Computes fingerprints of the subscripts; each thread hashes a share. This is done piece by piece
 * during the inspection, after some of the thread's iterations were recorded. Most loops read their
 * subscripts in the order of the iterations, so that the subscripts are still in the caches.
 */
#ifndef REDCC_HASHING_H
#define REDCC_HASHING_H

#include "base/call.h"
#include "reuse/reading.h"

/** A partial hash: the fingerprint of the part hashed so far of a thread's share of a source. */
struct partial_hash {
    struct reading reading; /* what is read of the source; its range is empty until it is known */
    size_t taken;           /* number of bytes hashed so far */
    struct fingerprint so_far;
};

/** One thread's part in hashing. */
struct hasher {
    int thread;
    int threads;
    struct fingerprint
        *fingerprint; /* [source_count] fingerprint of this thread's share of each source */
    struct partial_hash *partial; /* [source_count] partial hashes, used during the sweep */
};

/** Is a source so small that it is not divided into shares? If every thread hashes all of it to
 * verify a plan, that costs less than a barrier. */
bool redcc_is_small(struct reading reading);

/** Computes the fingerprint of the thread's share of the reading. */
struct fingerprint redcc_hash_share(const struct hasher *hasher, struct reading reading);

/** Called before the thread's iterations are recorded. Returns the number of bytes that will be
 * hashed while they are recorded: the thread's shares of sources with a known range (sources
 * [source_count]). */
size_t redcc_hash_begin(struct hasher *hasher, const struct request *request,
                        const struct range *sources);

/** Called when the thread has recorded the fraction `part` of its iterations, 0 to 1. Hashes the
 * same fraction of its shares. */
void redcc_hash_some(struct hasher *hasher, const redcc_loop *loop, double part);

/** Hashes the rest of this thread's share of each subscript array. The results are in
 * hasher->fingerprint. */
void redcc_hash_rest(struct hasher *hasher, const struct request *request,
                     const struct range *sources);

/** Computes the fingerprint of source number `source` from those of all threads' shares. */
struct fingerprint redcc_hash_joined(struct hasher *const *hasher, int threads, uint32_t source,
                                     struct reading reading);

#endif
