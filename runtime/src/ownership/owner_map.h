/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Chooses owners by majority votes. The iterations are divided into consecutive parts with equal
 * numbers of touches, one part for each owner. A block of rows belongs to the owner with the most
 * iterations that touch it, except that each change of owners between adjacent blocks costs some
 * votes. So rows that are stored after all others (halo cells, ghost atoms) belong to the thread
 * that updates their neighbours. Arrays with the same number of rows vote together. The loop's
 * result does not depend on the map, which only assigns work to threads.
 */
#ifndef REDCC_OWNER_MAP_H
#define REDCC_OWNER_MAP_H

#include "ownership/partition.h"
#include "ownership/sample.h"

/** Gives the partition a map, by votes of the samples of `threads` threads; touched[g] is the range
 * in which group g was touched. The partition has no map afterwards if memory runs out, an array is
 * scattered, the samples are empty, or there are too many owners or bytes. */
void redcc_owner_map_vote(struct partition *partition, const struct range *touched,
                          const struct sample *const *samples, int threads);

/** Extends the map to the touched ranges. Removes the map if memory runs out, if it has no block of
 * a touched group, or if it would have too many blocks. */
void redcc_owner_map_extend(struct partition *partition, const struct range *touched);

/** The owner of the byte at `address` of group `group`, according to the map. If the map does not
 * contain the byte, it is the owner of the nearest unit. */
uint32_t redcc_mapped_owner(const struct partition *partition, uint32_t group, uintptr_t address);

#endif
