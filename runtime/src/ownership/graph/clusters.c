/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "ownership/graph/clusters.h"

#include "base/memory.h"
#include "ownership/graph/neighbours.h"

#include <assert.h>
#include <string.h>

enum { ROUNDS = 6 }; /* maximum number of rounds; a mesh needs two, a path four */

#define NOTHING UINT32_MAX /* a choice: no node */

/* The rank of a node: a hash that is a bijection on 31 bits, so that the node can be computed from
 * its rank. */
static uint32_t rank_of(uint32_t node) {
    const uint32_t mixed = node * 0x9e3779b1u & 0x7fffffffu;
    return mixed ^ mixed >> 16;
}

static uint32_t node_of(uint32_t rank) {
    const uint32_t mixed = rank ^ rank >> 16;
    return mixed * 0x0e8b2f51u & 0x7fffffffu; /* multiplication by the inverse of 0x9e3779b1 */
}

bool redcc_clusters_begin(struct clusters *clusters, uint32_t units, uint32_t most,
                          const struct access_log *logged, int threads) {
    assert(most > 0 && threads >= 1);
    const size_t bytes = units * sizeof(uint32_t);
    *clusters = (struct clusters){.units = units, .most = most, .count = units, .threads = threads};
    assert(node_of(rank_of(1234567)) == 1234567);
    clusters->of = redcc_memory_alloc(bytes);
    clusters->into = redcc_memory_alloc(bytes);
    clusters->size = redcc_memory_alloc(bytes);
    clusters->spare = redcc_memory_alloc(bytes);
    clusters->share = redcc_memory_alloc_zeroed((size_t)threads, sizeof *clusters->share);
    bool enough =
        clusters->of && clusters->into && clusters->size && clusters->spare && clusters->share;
    for (int thread = 0; enough && thread < threads; thread++) {
        struct cluster_share *share = &clusters->share[thread];
        share->logged = &logged[thread].leading;
        share->list.item = redcc_memory_alloc(share->logged->count * sizeof *share->list.item);
        share->choice = redcc_memory_alloc(bytes);
        share->weight = redcc_memory_alloc(bytes);
        enough = share->list.item && share->choice && share->weight;
    }
    return enough;
}

void redcc_clusters_end(struct clusters *clusters) {
    for (int thread = 0; clusters->share && thread < clusters->threads; thread++) {
        redcc_memory_free(clusters->share[thread].list.item);
        redcc_memory_free(clusters->share[thread].choice);
        redcc_memory_free(clusters->share[thread].weight);
    }
    redcc_memory_free(clusters->of);
    redcc_memory_free(clusters->into);
    redcc_memory_free(clusters->size);
    redcc_memory_free(clusters->spare);
    redcc_memory_free(clusters->share);
    *clusters = (struct clusters){0};
}

/* Adds up to UINT32_MAX (saturates). */
static inline uint32_t add(uint32_t weight, uint32_t more) {
    const uint32_t sum = weight + more;
    return sum < weight ? UINT32_MAX : sum;
}

/* All ones if the node is full; or'ed to its rank, they prevent it from being chosen. Without this,
 * a row that all iterations update would join all nodes. */
static inline uint32_t full(const uint32_t *size, uint32_t most, uint32_t node) {
    return size && size[node] >= most ? NOTHING : 0;
}

/* Updates the choices of the nodes of an iteration: each may choose the iteration's node of lowest
 * rank. There are no branches, because they would be unpredictable. */
static inline void hear(uint32_t *choice, const uint32_t *size, uint32_t most, const uint32_t *node,
                        size_t count) {
    uint32_t first = NOTHING;
    for (size_t i = 0; i < count; i++) {
        const uint32_t each = node[i] & ~REDCC_LAST, rank = rank_of(each) | full(size, most, each);
        first = rank < first ? rank : first;
    }
    for (size_t i = 0; i < count; i++) {
        const uint32_t each = node[i] & ~REDCC_LAST, heard = first | full(size, most, each);
        choice[each] = heard < choice[each] ? heard : choice[each];
    }
}

void redcc_clusters_choose(struct clusters *clusters, int thread) {
    assert(0 <= thread && thread < clusters->threads && clusters->rounds == 0);
    struct cluster_share *share = &clusters->share[thread];
    const struct unit_list *logged = share->logged;
    memset(share->choice, 0xff, clusters->units * sizeof *share->choice);
    for (size_t at = 0, count; at < logged->count; at += count) {
        count = redcc_iteration_length(logged, at);
        if (logged->item[at] != (REDCC_NO_UNIT | REDCC_LAST))
            hear(share->choice, NULL, 0, logged->item + at, count);
    }
}

void redcc_clusters_agree(struct clusters *clusters, uint32_t first, uint32_t end) {
    assert(first <= end && end <= clusters->count);
    const struct cluster_share *all = &clusters->share[0];
    for (int thread = 1; thread < clusters->threads; thread++) {
        const uint32_t *choice = clusters->share[thread].choice;
        for (uint32_t node = first; node < end; node++)
            all->choice[node] = choice[node] < all->choice[node] ? choice[node] : all->choice[node];
        const uint32_t *weight = clusters->share[thread].weight;
        for (uint32_t node = first; clusters->rounds == 1 && node < end; node++)
            all->weight[node] = add(all->weight[node], weight[node]);
    }
}

/* State while the clusters of the next round are formed. */
struct joining {
    struct clusters *clusters;
    const uint32_t *size; /* number of units of each node; NULL: 1 each */
    uint32_t *joined;     /* number of units of each cluster so far */
    uint32_t count;
};

static uint32_t size_of(const struct joining *it, uint32_t node) {
    return it->size ? it->size[node] : 1;
}

/* Adds the node to `cluster`, the cluster of the node that it has chosen, if the size limit
 * permits. Otherwise the node begins a new cluster. */
static void settle(struct joining *it, uint32_t node, uint32_t cluster) {
    const uint32_t size = size_of(it, node);
    if (cluster == NOTHING || it->joined[cluster] + size > it->clusters->most) {
        cluster = it->count++;
        it->joined[cluster] = 0;
    }
    it->joined[cluster] += size;
    it->clusters->into[node] = cluster;
}

/* Follows the choices from this node on, up to a node that has chosen itself or is in a cluster
 * already. Assigns the nodes on this path to clusters, from the path's last node back to its
 * first. */
static void settle_from(struct joining *it, const uint32_t *choice, uint32_t node) {
    enum { PATH = 64 };
    uint32_t path[PATH], length = 0, cluster = NOTHING;
    const uint32_t *into = it->clusters->into;
    while (length < PATH) { /* a longer path is cut, and its beginning gets a new cluster */
        path[length++] = node;
        const uint32_t chosen = choice[node] == NOTHING ? node : node_of(choice[node]);
        if (chosen == node)
            break;
        node = chosen;
        if (into[node] != NOTHING) {
            cluster = into[node];
            break;
        }
    }
    for (; length > 0; cluster = into[path[length]])
        settle(it, path[--length], cluster);
}

/* Computes each cluster's weight as the sum of its nodes' weights. (After the first round the
 * weights come from the access log: redcc_clusters_map.) */
static void add_up_weights(const struct clusters *clusters) {
    uint32_t *weight = clusters->share[0].weight, *sum = clusters->spare;
    memset(sum, 0, clusters->count * sizeof *sum);
    for (uint32_t node = 0; node < clusters->nodes; node++)
        sum[clusters->into[node]] = add(sum[clusters->into[node]], weight[node]);
    memcpy(weight, sum, clusters->count * sizeof *sum);
}

bool redcc_clusters_join(struct clusters *clusters) {
    const bool first = clusters->rounds == 0;
    const bool half_full =
        (uint64_t)clusters->count * clusters->most < 2 * (uint64_t)clusters->units;
    const bool slow = !first && clusters->rounds > 1 && clusters->count > clusters->nodes / 2;
    if (!first && (half_full || slow || clusters->rounds == ROUNDS))
        return false;
    const uint32_t *choice = clusters->share[0].choice;
    struct joining it = {
        .clusters = clusters, .size = first ? NULL : clusters->size, .joined = clusters->spare};
    clusters->nodes = clusters->count;
    memset(clusters->into, 0xff, clusters->nodes * sizeof *clusters->into);
    for (uint32_t node = 0; node < clusters->nodes; node++)
        if (clusters->into[node] == NOTHING && !(first && choice[node] == NOTHING))
            settle_from(&it, choice, node);
    clusters->spare = clusters->size;
    clusters->size = it.joined;
    clusters->count = it.count;
    if (!first)
        add_up_weights(clusters);
    clusters->rounds++;
    return true;
}

void redcc_clusters_place(struct clusters *clusters, uint32_t first, uint32_t end) {
    assert(first <= end && end <= clusters->units && clusters->rounds > 0);
    for (uint32_t unit = first; unit < end; unit++) {
        const uint32_t node = clusters->rounds == 1 ? unit : clusters->of[unit];
        clusters->of[unit] = node < clusters->nodes && clusters->into[node] != NOTHING
                                 ? clusters->into[node]
                                 : REDCC_NO_UNIT;
    }
}

/* Writes the clusters of an iteration's nodes to `to`, which may be the same array as `node`.
 * Returns whether the nodes are in different clusters. */
static inline bool map_iteration(const uint32_t *into, const uint32_t *node, size_t count,
                                 uint32_t *to) {
    uint32_t differ = 0;
    for (size_t i = 0; i < count; i++) {
        to[i] = into[node[i] & ~REDCC_LAST];
        differ |= to[i] ^ to[0];
    }
    return differ != 0;
}

void redcc_clusters_map(struct clusters *clusters, int thread) {
    assert(0 <= thread && thread < clusters->threads && clusters->rounds > 0);
    struct cluster_share *share = &clusters->share[thread];
    const bool first = clusters->rounds == 1;
    const struct unit_list from = first ? *share->logged : share->list;
    uint32_t *const to = share->list.item;
    size_t kept = 0;
    memset(share->choice, 0xff, clusters->count * sizeof *share->choice);
    if (first)
        memset(share->weight, 0, clusters->count * sizeof *share->weight);
    for (size_t at = 0, count; at < from.count; at += count) {
        count = redcc_iteration_length(&from, at);
        if (from.item[at] == (REDCC_NO_UNIT | REDCC_LAST))
            continue;
        const bool several = map_iteration(clusters->into, from.item + at, count, to + kept);
        const uint32_t work = redcc_work_of(count);
        for (size_t i = kept; first && i < kept + count; i++)
            share->weight[to[i]] = add(share->weight[to[i]], work);
        if (!several)
            continue;
        hear(share->choice, clusters->size, clusters->most, to + kept, count);
        kept += count;
        to[kept - 1] |= REDCC_LAST;
    }
    share->list.count = kept;
}
