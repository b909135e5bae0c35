/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Owners by votes: the iterations are cut into consecutive parts with equally many touches, and a
 * block of rows belongs to the part that touches it most. So rows that were appended to the others
 * (halo cells, ghost atoms) belong to the thread that updates their neighbours. Any map gives the
 * same result: it decides only which thread executes what.
 */
#ifndef REDCC_OWNER_MAP_H
#define REDCC_OWNER_MAP_H

#include "ownership/partition.h"
#include "ownership/sample.h"

/** Gives the partition a map by votes of the samples of `threads` threads; group g was touched in
 *  touched[g]. Without memory, or if arrays are scattered or owners too many, it has none
 *  afterwards. */
void redcc_owner_map_vote(struct partition *partition, const struct range *touched,
                          const struct sample *const *samples, int threads);

/** Extends the map to all that is touched. Without memory, or if it would take too many blocks,
 *  there is none afterwards. */
void redcc_owner_map_extend(struct partition *partition, const struct range *touched);

/** The owner of the byte at `address` of group `group` by the map; outside of it, of the nearest
 *  unit. */
uint32_t redcc_mapped_owner(const struct partition *partition, uint32_t group, uintptr_t address);

#endif
