/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "ownership/owner_map.h"

#include "base/memory.h"

#include <assert.h>
#include <string.h>

enum {
    TOUCHES_A_BLOCK = 4,  /* smallest number of sampled touches per block; with fewer, the majority
                             would be uncertain */
    LEAST_BLOCKS = 64,    /* each group may have at least this number of blocks */
    PRICE = 8,            /* the votes that a change of owners between adjacent blocks costs.
                             Suppose that blocks have 2 votes of 3 for their owner, and one
                             change in 200 blocks is right: then it is ln 200 / ln 2 */
    VOTES_MOST = 1 << 22, /* limit of blocks * owners * TOUCHES_A_BLOCK */
    BLOCK_MOST = 1 << 30, /* maximum size of a block in bytes */
    UNITS_MOST = 1 << 20  /* maximum number of units of a group in the extended map */
};

/* The votes for each block, and the state of the election. */
struct poll {
    uint32_t owners;
    uint32_t *votes; /* [blocks * owners] */
    uint32_t *voter; /* [blocks] number of the last iteration that voted on the block; 0: none */
    uint32_t *like;  /* [array_count] the group whose votes decide for this group */
    unsigned char *from; /* [blocks * owners] for block b and owner o: the owner that the block
                            before b has in the best map in which b has owner o */
    uint64_t *most; /* [owners] for owner o: the value of the best map, up to the current block, in
                       which the current block has owner o */
};

/* The number of units of `bytes` bytes that cover the touched range, if the first of them begins at
 * `first`. */
static uint64_t units_to(uintptr_t first, struct range touched, uint32_t bytes) {
    return (touched.end - 1 - first) / bytes + 1;
}

/* Cuts the group into at most `most` blocks of rows, which are numbered from `begin` on. Returns
 * false if blocks would be too large. */
static bool number_blocks(struct group_map *it, const struct partition *partition, uint32_t group,
                          struct range touched, uint32_t begin, uint64_t most) {
    const uintptr_t first = redcc_unit_begin(partition, group, touched.first);
    uint32_t bytes = partition->arrays[group].unit;
    while (bytes <= BLOCK_MOST / 2 && units_to(first, touched, bytes) > most)
        bytes *= 2;
    const uint64_t count = units_to(first, touched, bytes);
    *it = (struct group_map){.first = (ptrdiff_t)(first - partition->base[group]),
                             .begin = begin,
                             .count = (uint32_t)count,
                             .bytes = bytes};
    return count <= most;
}

/* Cuts all groups into blocks. Returns the number of blocks; 0: no map is possible. */
static uint32_t number_all(struct owner_map *map, const struct partition *partition,
                           const struct range *touched, size_t points, uint32_t owners) {
    const size_t votes = points < VOTES_MOST / owners ? points : VOTES_MOST / owners;
    const size_t each = votes / TOUCHES_A_BLOCK / partition->array_count;
    const uint64_t most = each > LEAST_BLOCKS ? each : LEAST_BLOCKS;
    uint32_t count = 0;
    map->of = redcc_memory_alloc_zeroed(partition->array_count, sizeof *map->of);
    for (uint32_t group = 0; map->of && group < partition->array_count; group++) {
        if (!redcc_leads_group(partition, group) || redcc_range_empty(touched[group]))
            continue;
        if (redcc_is_scattered((const void *)partition->base[group]) ||
            !number_blocks(&map->of[group], partition, group, touched[group], count, most))
            return 0;
        count += map->of[group].count;
    }
    return map->of ? count : 0;
}

/* The index, in the map, of the unit that contains `address`. If no unit of the group contains it,
 * returns the index of the nearest unit. */
static uint32_t unit_at(const struct partition *partition, uint32_t group, uintptr_t address) {
    const struct group_map *it = &partition->map.of[group];
    const uintptr_t first = partition->base[group] + (uintptr_t)it->first;
    const uint64_t unit = address > first ? (address - first) / it->bytes : 0;
    return it->begin + (uint32_t)(unit < it->count ? unit : it->count - 1);
}

uint32_t redcc_mapped_owner(const struct partition *partition, uint32_t group, uintptr_t address) {
    assert(partition->map.owner && group < partition->array_count);
    return partition->map.owner[unit_at(partition, group, address)];
}

/* The end of the iteration whose touches begin with item `begin`. */
static size_t iteration_end(const struct sample *sample, size_t begin) {
    size_t end = begin + 1;
    while (end < sample->count && sample->item[end].iteration == sample->item[begin].iteration)
        end++;
    return end;
}

/* Do the blocks of two groups consist of the same rows, by number? */
static bool are_alike(const struct partition *partition, uint32_t a, uint32_t b) {
    const struct group_map *of = partition->map.of;
    const uint32_t unit_a = partition->arrays[a].unit, unit_b = partition->arrays[b].unit;
    return of[a].count == of[b].count && of[a].bytes / unit_a == of[b].bytes / unit_b &&
           of[a].first / (ptrdiff_t)unit_a == of[b].first / (ptrdiff_t)unit_b;
}

/* Lets groups whose blocks are alike vote together, so that a row has the same owner in each of
 * them: an iteration usually touches the same rows of such arrays, as of atoms' forces and
 * energies. */
static void find_alike(const struct partition *partition, struct poll *poll) {
    for (uint32_t group = 0; group < partition->array_count; group++) {
        uint32_t like = 0;
        while (!are_alike(partition, like, group))
            like++; /* at most to the group itself */
        poll->like[group] = like;
    }
}

/* Counts a vote for the owner of iteration number `iteration`, unless the iteration has voted on
 * this block before. */
static void cast_vote(const struct partition *partition, struct poll *poll,
                      const struct sampled *item, uint32_t iteration, size_t owner) {
    const uint32_t group = partition->group_of[item->array], like = poll->like[group];
    const size_t block = unit_at(partition, group, item->address) - partition->map.of[group].begin +
                         partition->map.of[like].begin;
    if (poll->voter[block] == iteration)
        return;
    poll->voter[block] = iteration;
    poll->votes[block * poll->owners + owner]++;
}

/* Divides the iterations into consecutive parts, one per owner, with equal numbers of touches
 * (`all` is the total number). Each iteration votes, once for each block that it touches, for the
 * owner of its part. */
static void cast_votes(const struct partition *partition, const struct sample *const *samples,
                       int threads, size_t all, struct poll *poll) {
    size_t before = 0;
    uint32_t iteration = 0;
    for (int thread = 0; thread < threads; thread++) {
        const struct sample *sample = samples[thread];
        for (size_t begin = 0, end; begin < sample->count; begin = end) {
            end = iteration_end(sample, begin);
            const uint64_t middle = before + (end - begin) / 2;
            before += end - begin;
            iteration++;
            for (size_t i = begin; i < end; i++)
                cast_vote(partition, poll, &sample->item[i], iteration,
                          (size_t)(middle * poll->owners / all));
        }
    }
}

static uint32_t best_of(const struct poll *poll) {
    uint32_t best = 0;
    for (uint32_t owner = 1; owner < poll->owners; owner++)
        best = poll->most[owner] > poll->most[best] ? owner : best;
    return best;
}

/* Chooses the owners of a group's blocks by Viterbi's algorithm (1967): they maximise the number of
 * votes, minus PRICE for each change of owners between adjacent blocks. Without the price, owners
 * would alternate at random where votes are nearly even. */
static void elect(unsigned char *owner, const struct poll *poll, const struct group_map *it) {
    const size_t owners = poll->owners;
    for (size_t o = 0; o < owners; o++)
        /* begins with PRICE for each owner, so that no value becomes negative */
        poll->most[o] = PRICE;
    for (size_t block = it->begin; block < it->begin + it->count; block++) {
        const uint32_t best = best_of(poll);
        const uint64_t changed = poll->most[best] - PRICE;
        for (size_t o = 0; o < owners; o++) {
            const bool stays = poll->most[o] >= changed;
            poll->from[block * owners + o] = (unsigned char)(stays ? o : best);
            poll->most[o] = (stays ? poll->most[o] : changed) + poll->votes[block * owners + o];
        }
    }
    size_t last = best_of(poll);
    for (size_t block = it->begin + it->count; block-- > it->begin;) {
        owner[block] = (unsigned char)last;
        last = poll->from[block * owners + last];
    }
}

static bool begin_poll(struct poll *poll, const struct partition *partition, size_t blocks) {
    poll->votes = redcc_memory_alloc_zeroed(blocks * poll->owners, sizeof *poll->votes);
    poll->voter = redcc_memory_alloc_zeroed(blocks, sizeof *poll->voter);
    poll->like = redcc_memory_alloc(partition->array_count * sizeof *poll->like);
    poll->from = redcc_memory_alloc(blocks * poll->owners);
    poll->most = redcc_memory_alloc(poll->owners * sizeof *poll->most);
    const bool enough = poll->votes && poll->voter && poll->like && poll->from && poll->most;
    if (enough)
        find_alike(partition, poll);
    return enough;
}

static void end_poll(struct poll *poll) {
    redcc_memory_free(poll->votes);
    redcc_memory_free(poll->voter);
    redcc_memory_free(poll->like);
    redcc_memory_free(poll->from);
    redcc_memory_free(poll->most);
}

/* Chooses the owners of all groups' blocks. */
static void elect_all(const struct partition *partition, const struct poll *poll) {
    const struct owner_map *map = &partition->map;
    for (uint32_t group = 0; group < partition->array_count; group++) {
        const struct group_map *it = &map->of[group], *like = &map->of[poll->like[group]];
        if (it == like)
            elect(map->owner, poll, it);
        else
            memcpy(map->owner + it->begin, map->owner + like->begin, it->count);
    }
}

void redcc_owner_map_vote(struct partition *partition, const struct range *touched,
                          const struct sample *const *samples, int threads) {
    assert(partition->owners % (1 + partition->stealable) == 0 && threads >= 1);
    struct owner_map *map = &partition->map;
    struct poll poll = {.owners = partition->owners / (1 + partition->stealable)};
    size_t all = 0;
    for (int thread = 0; thread < threads; thread++)
        all += samples[thread]->count;
    redcc_owner_map_end(map);
    const uint32_t count = all > 0 && poll.owners <= REDCC_OWNERS_MOST
                               ? number_all(map, partition, touched, all, poll.owners)
                               : 0;
    map->owner =
        count > 0 && begin_poll(&poll, partition, count) ? redcc_memory_alloc(count) : NULL;
    if (map->owner) {
        cast_votes(partition, samples, threads, all, &poll);
        elect_all(partition, &poll);
    }
    end_poll(&poll);
    if (!map->owner)
        redcc_owner_map_end(map);
}

/* Adds units of the same size to the group's units, so that they cover the touched range. Returns
 * false if the map has no units of the group, or would have too many. */
static bool widen(struct group_map *it, const struct partition *partition, uint32_t group,
                  struct range touched) {
    const uintptr_t first = partition->base[group] + (uintptr_t)it->first;
    if (redcc_range_empty(touched) || it->count == 0)
        return redcc_range_empty(touched);
    const uint64_t before = touched.first < first ? (first - touched.first - 1) / it->bytes + 1 : 0;
    const uint64_t count = before + units_to(first, touched, it->bytes);
    it->first -= (ptrdiff_t)(before * it->bytes);
    it->count = (uint32_t)(count < UNITS_MOST ? count : UNITS_MOST);
    return count < UNITS_MOST;
}

static void copy_owners(const struct partition *partition, struct owner_map *wider) {
    for (uint32_t group = 0; group < partition->array_count; group++) {
        const struct group_map *it = &wider->of[group];
        const uintptr_t first = partition->base[group] + (uintptr_t)it->first;
        for (uint32_t unit = 0; unit < it->count; unit++)
            wider->owner[it->begin + unit] = (unsigned char)redcc_mapped_owner(
                partition, group, first + (uintptr_t)unit * it->bytes);
    }
}

void redcc_owner_map_extend(struct partition *partition, const struct range *touched) {
    assert(partition->map.owner && partition->map.of);
    const uint32_t groups = partition->array_count;
    struct owner_map wider = {.of = redcc_memory_alloc(groups * sizeof *wider.of)};
    uint32_t count = 0;
    bool fits = wider.of != NULL;
    for (uint32_t group = 0; fits && group < groups; group++) {
        wider.of[group] = partition->map.of[group];
        fits = widen(&wider.of[group], partition, group, touched[group]);
        wider.of[group].begin = count;
        count += wider.of[group].count;
    }
    wider.owner = fits && count > 0 ? redcc_memory_alloc(count) : NULL;
    if (wider.owner)
        copy_owners(partition, &wider);
    else
        redcc_owner_map_end(&wider);
    redcc_owner_map_end(&partition->map);
    partition->map = wider;
}
