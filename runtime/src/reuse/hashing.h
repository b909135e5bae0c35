/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Computes fingerprints of the subscripts; each thread hashes a share of each subscript array.
 * During the inspection a thread hashes piece by piece, after recording some of its iterations.
 * Most loops read their subscripts in the order of the iterations. So the subscripts that the
 * thread hashes are often still in the caches.
 */
#ifndef REDCC_HASHING_H
#define REDCC_HASHING_H

#include "base/call.h"
#include "reuse/reading.h"

/** A partial hash of a thread's share of a source: the fingerprint of the part that is hashed so
 * far. */
struct partial_hash {
    struct reading reading; /* what is read of the source; its range is empty while it is unknown */
    size_t taken;           /* number of bytes hashed so far */
    struct fingerprint so_far;
};

/** One thread's part in hashing. */
struct hasher {
    int thread;
    int threads;
    /* [source_count] for each source, the fingerprint of this thread's share */
    struct fingerprint *fingerprint;
    struct partial_hash *partial; /* [source_count] partial hashes, used during the sweep */
};

/** Is a source so small that it is not divided into shares? To verify a plan, every thread then
 * hashes all of it, which costs less than a barrier. */
bool redcc_is_small(struct reading reading);

/** Computes the fingerprint of the thread's share of the reading. */
struct fingerprint redcc_hash_share(const struct hasher *hasher, struct reading reading);

/** Called before the thread's iterations are recorded. Returns how many bytes will be hashed while
 * they are recorded: the thread's shares of the subscript arrays whose range is known.
 * sources[source_count] has the sources' ranges. */
size_t redcc_hash_begin(struct hasher *hasher, const struct request *request,
                        const struct range *sources);

/** Called when the thread has recorded the fraction `part` (0 to 1) of its iterations. Hashes the
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
