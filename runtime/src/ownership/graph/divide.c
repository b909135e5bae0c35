/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "ownership/graph/divide.h"

#include "base/clock.h"
#include "base/memory.h"
#include "base/share.h"
#include "ownership/graph/bisect.h"

#include <assert.h>
#include <string.h>

enum {
    CLUSTERS_AN_OWNER = 128,
    CLUSTER_MOST = 256, /* maximum number of units of a cluster */
    NO_VOTE = 0xffff,
    SEVERAL = 0x8000, /* flag of a vote by an iteration that touches several owners' units */
    ROUNDS = 8        /* maximum number of rounds of the unit-by-unit refinement */
};

/* The total number of touches of all threads beyond which the access log is too expensive. */
static size_t most_touches(redcc_int trip) {
    const size_t each = 64, bound = (size_t)REDCC_NO_UNIT;
    return (size_t)trip < bound / each ? (size_t)trip * each : bound;
}

/* Are there too many units for the maps and graphs? These have an entry for each unit between the
 * first and the last touched unit of a group, although in a sparse array most of these units are
 * untouched. */
static bool is_too_wide(const struct divide *divide, double touches) {
    const double units_a_touch = 8, few = 1 << 20;
    const double most = units_a_touch * touches;
    return (double)divide->units.count > (most > few ? most : few);
}

enum divide_result redcc_divide_begin(struct divide *divide, const struct partition *partition,
                                      const struct range *touched, int threads, redcc_int trip,
                                      double touches) {
    *divide = (struct divide){.partition = partition, .threads = threads};
    const size_t count = (size_t)threads;
    divide->most_logged = most_touches(trip) / count;
    if (partition->owners > REDCC_OWNERS_MOST || trip > REDCC_BLOCK)
        return DIVIDE_UNSUITABLE;
    divide->logged = redcc_memory_alloc_zeroed(count, sizeof *divide->logged);
    divide->sweep = redcc_memory_alloc_zeroed(count, sizeof *divide->sweep);
    divide->boundary.list = redcc_memory_alloc_zeroed(count, sizeof *divide->boundary.list);
    divide->boundary.logged = redcc_memory_alloc_zeroed(count, sizeof *divide->boundary.logged);
    if (!redcc_units_begin(&divide->units, partition, touched) || !divide->logged ||
        !divide->sweep || !divide->boundary.list || !divide->boundary.logged)
        return DIVIDE_NO_MEMORY;
    return divide->units.too_many || is_too_wide(divide, touches) ? DIVIDE_UNSUITABLE : DIVIDE_DONE;
}

void redcc_divide_tidy(struct divide *divide) {
    for (int thread = 0; thread < divide->threads; thread++) {
        if (divide->logged)
            redcc_access_log_end(&divide->logged[thread]);
        if (divide->boundary.list)
            redcc_unit_list_end(&divide->boundary.list[thread]);
    }
    redcc_clusters_end(&divide->clusters);
    redcc_graph_end(&divide->coarse);
    redcc_graph_end(&divide->boundary.graph);
    redcc_memory_free(divide->boundary.is_boundary);
    redcc_memory_free(divide->part);
    redcc_memory_free((void *)divide->vote);
    divide->boundary.is_boundary = NULL;
    divide->part = NULL;
    divide->vote = NULL;
}

void redcc_divide_end(struct divide *divide) {
    redcc_divide_tidy(divide);
    for (int thread = 0; divide->sweep && thread < divide->threads; thread++)
        redcc_sweep_end(&divide->sweep[thread]);
    redcc_units_end(&divide->units);
    redcc_memory_free(divide->logged);
    redcc_memory_free(divide->sweep);
    redcc_memory_free(divide->owner);
    redcc_memory_free(divide->boundary.list);
    redcc_memory_free((void *)divide->boundary.logged);
    *divide = (struct divide){0};
}

/* This thread's share of nodes, clusters or units: [first, end) of `count`. */
struct share {
    uint32_t first;
    uint32_t end;
};

static struct share share_of(const struct divide *divide, uint32_t count, int thread) {
    return (struct share){(uint32_t)redcc_share(count, divide->threads, thread),
                          (uint32_t)redcc_share(count, divide->threads, thread + 1)};
}

/* Waits at a barrier. The last thread to arrive calls `alone`, unless a thread has failed (`done`
 * is false) or the deadline has passed. Returns whether the threads may continue: also false if
 * `alone` fails. All threads get the same result. */
static bool meet(struct divide *divide, bool done, bool (*alone)(struct divide *)) {
    if (!done)
        atomic_store(&divide->failed, true);
    if (redcc_barrier_arrive(divide->barrier, divide->threads)) {
        const bool late = divide->deadline > 0 && redcc_seconds() > divide->deadline;
        divide->going = !late && !atomic_load(&divide->failed) && (!alone || alone(divide));
        redcc_barrier_release(divide->barrier);
    }
    return divide->going;
}

/* ---- clusters of units ----------------------------------------------------------------------- */

/* Allocates the owners and votes, and begins the clusters. The clusters' maximum size is small
 * enough for balanced parts, and large enough for a small graph. */
static bool begin_clusters(struct divide *divide) {
    const struct units *units = &divide->units;
    const uint32_t even = units->leading / (divide->partition->owners * CLUSTERS_AN_OWNER);
    const uint32_t most = even > CLUSTER_MOST ? CLUSTER_MOST : even > 0 ? even : 1;
    const size_t further = units->count - units->leading;
    divide->owner = redcc_memory_alloc(units->count);
    divide->boundary.is_boundary = redcc_memory_alloc_zeroed(units->leading, 1);
    divide->vote = redcc_memory_alloc(further * sizeof *divide->vote);
    return divide->owner && divide->boundary.is_boundary && divide->vote &&
           redcc_clusters_begin(&divide->clusters, units->leading, most, divide->logged,
                                divide->threads);
}

static bool join_clusters(struct divide *divide) {
    divide->clustered = !redcc_clusters_join(&divide->clusters);
    return true;
}

/* Computes the clusters. Called by all threads; returns to all of them whether it succeeded. */
static bool cluster(struct divide *divide, int thread) {
    struct clusters *clusters = &divide->clusters;
    const struct share units = share_of(divide, divide->units.leading, thread);
    redcc_clusters_choose(clusters, thread);
    while (meet(divide, true, NULL)) {
        const struct share nodes = share_of(divide, clusters->count, thread);
        redcc_clusters_agree(clusters, nodes.first, nodes.end);
        if (!meet(divide, true, join_clusters))
            return false;
        if (divide->clustered)
            return true;
        redcc_clusters_place(clusters, units.first, units.end);
        redcc_clusters_map(clusters, thread);
    }
    return false;
}

/* ---- a graph, by all threads ----------------------------------------------------------------- */

/* count_edges and fill_edges build the edges of a graph whose nodes exist, from the iterations in
 * boundary.logged. count_edges counts the edges of this thread's nodes; fill_edges then stores
 * them. Both read all threads' iterations. A barrier must follow each call. */
static void count_edges(struct divide *divide, struct graph *graph, int thread) {
    const struct share nodes = share_of(divide, graph->count, thread);
    redcc_graph_count(graph, divide->boundary.logged, divide->threads, nodes.first, nodes.end);
}

static void fill_edges(struct divide *divide, struct graph *graph, int thread) {
    const struct share nodes = share_of(divide, graph->count, thread);
    redcc_graph_fill(graph, divide->boundary.logged, divide->threads, nodes.first, nodes.end);
}

/* ---- the parts ------------------------------------------------------------------------------- */

static bool begin_coarse(struct divide *divide) {
    for (int thread = 0; thread < divide->threads; thread++)
        divide->boundary.logged[thread] = &divide->clusters.share[thread].list;
    divide->part = redcc_memory_alloc(divide->clusters.count);
    return divide->part && redcc_graph_begin(&divide->coarse, divide->clusters.count);
}

static bool take_coarse_edges(struct divide *divide) {
    /* the clusters' weights include iterations that add no edges */
    struct graph *coarse = &divide->coarse;
    memcpy(coarse->weight, divide->clusters.share[0].weight,
           coarse->count * sizeof *coarse->weight);
    return redcc_graph_take(coarse);
}

static bool divide_coarse(struct divide *divide) {
    return redcc_graph_merge(&divide->coarse) &&
           redcc_divide_graph(&divide->coarse, divide->partition->owners,
                              divide->partition->stealable, divide->part);
}

static bool divide_clusters(struct divide *divide, int thread) {
    if (!meet(divide, true, begin_coarse))
        return false;
    count_edges(divide, &divide->coarse, thread);
    if (!meet(divide, true, take_coarse_edges))
        return false;
    fill_edges(divide, &divide->coarse, thread);
    return meet(divide, true, divide_coarse);
}

/* Assigns each unit to its cluster's owner. The owner of an untouched unit does not matter. */
static void place_units(struct divide *divide, int thread) {
    const struct share share = share_of(divide, divide->units.leading, thread);
    const uint32_t *of = divide->clusters.of;
    for (uint32_t unit = share.first; unit < share.end; unit++) {
        divide->owner[unit] = of[unit] == REDCC_NO_UNIT ? 0 : divide->part[of[unit]];
        assert(divide->owner[unit] < divide->partition->owners);
    }
}

/* ---- boundaries of parts --------------------------------------------------------------------- */

static void mark_boundary(struct divide *divide, int thread) {
    const struct unit_list *logged = &divide->logged[thread].leading;
    for (size_t at = 0, count; at < logged->count; at += count) {
        count = redcc_iteration_length(logged, at);
        const uint32_t *unit = logged->item + at;
        bool several = false;
        for (size_t i = 1; i < count; i++)
            several |= divide->owner[unit[i] & ~REDCC_LAST] != divide->owner[unit[0]];
        for (size_t i = 0; several && i < count; i++)
            __atomic_store_n(&divide->boundary.is_boundary[unit[i] & ~REDCC_LAST], 1,
                             __ATOMIC_RELAXED);
    }
}

static bool list_boundary(struct divide *divide, int thread) {
    const struct unit_list *logged = &divide->logged[thread].leading;
    struct unit_list *list = &divide->boundary.list[thread];
    for (size_t at = 0, count; at < logged->count; at += count) {
        count = redcc_iteration_length(logged, at);
        const uint32_t *unit = logged->item + at;
        bool touched = false;
        for (size_t i = 0; i < count && unit[i] != (REDCC_NO_UNIT | REDCC_LAST); i++)
            touched |= divide->boundary.is_boundary[unit[i] & ~REDCC_LAST];
        if (touched && !redcc_unit_list_add(list, unit, count))
            return false;
    }
    return true;
}

static bool begin_rims(struct divide *divide) {
    struct boundary *boundary = &divide->boundary;
    for (int thread = 0; thread < divide->threads; thread++)
        boundary->logged[thread] = &boundary->list[thread];
    const bool begun = redcc_graph_begin(&boundary->graph, divide->units.leading);
    boundary->graph.only = boundary->is_boundary;
    return begun;
}

static bool take_rim_edges(struct divide *divide) {
    return redcc_graph_take(&divide->boundary.graph);
}

static bool refine_rims(struct divide *divide) {
    uint64_t load[REDCC_PARTS_MOST] = {0}, most[REDCC_PARTS_MOST], sum = 0;
    uint32_t *const listed = divide->clusters.into; /* reuses this memory */
    uint32_t count = 0;
    for (uint32_t unit = 0; unit < divide->units.leading; unit++)
        if (divide->boundary.is_boundary[unit])
            listed[count++] = unit;
    for (uint32_t cluster = 0; cluster < divide->coarse.count; cluster++) {
        load[divide->part[cluster]] += divide->coarse.weight[cluster];
        sum += divide->coarse.weight[cluster];
    }
    const uint32_t owners = divide->partition->owners, stealable = divide->partition->stealable;
    for (uint32_t owner = 0; owner < owners; owner++) {
        const uint64_t even = redcc_amount_below(owners, stealable, owner + 1, sum) -
                              redcc_amount_below(owners, stealable, owner, sum);
        most[owner] = even + even / 100;
    }
    redcc_refine(&divide->boundary.graph, listed, count, divide->owner, 0, owners, load, most,
                 ROUNDS);
    return true;
}

static bool refine(struct divide *divide, int thread) {
    mark_boundary(divide, thread);
    if (!meet(divide, true, NULL) || !meet(divide, list_boundary(divide, thread), begin_rims))
        return false;
    count_edges(divide, &divide->boundary.graph, thread);
    if (!meet(divide, true, take_rim_edges))
        return false;
    fill_edges(divide, &divide->boundary.graph, thread);
    return meet(divide, true, refine_rims);
}

/* ---- further groups, and the summary --------------------------------------------------------- */

static void cast_vote(atomic_ushort *vote, unsigned short mine) {
    unsigned short known = atomic_load_explicit(vote, memory_order_relaxed);
    while (mine < known && !atomic_compare_exchange_weak_explicit(
                               vote, &known, mine, memory_order_relaxed, memory_order_relaxed))
        ;
}

/* The owner of an iteration's units. If they have several owners, returns one of them with the flag
 * SEVERAL. If there are no units, returns NO_VOTE. */
static inline unsigned short common_owner(const struct divide *divide, const uint32_t *unit,
                                          size_t count) {
    if (unit[0] == (REDCC_NO_UNIT | REDCC_LAST))
        return NO_VOTE;
    const unsigned char owner = divide->owner[unit[0] & ~REDCC_LAST];
    unsigned char differ = 0;
    for (size_t i = 1; i < count; i++)
        differ |= divide->owner[unit[i] & ~REDCC_LAST] ^ owner;
    return differ ? owner | SEVERAL : owner;
}

/* Votes for the owners of the units that are not in the leading group. Each iteration votes for its
 * owner in the leading group. The lowest vote wins, so that the order of votes does not matter.
 * Votes of iterations with several owners (SEVERAL) are higher than all others, and so count only
 * if there are no other votes. */
static void vote_further(struct divide *divide, int thread) {
    const struct unit_list *leading = &divide->logged[thread].leading;
    const struct unit_list *further = &divide->logged[thread].further;
    for (size_t at = 0, here = 0, count, more; here < further->count; at += count, here += more) {
        count = redcc_iteration_length(leading, at);
        more = redcc_iteration_length(further, here);
        const unsigned short mine = common_owner(divide, leading->item + at, count);
        if (mine == NO_VOTE || further->item[here] == (REDCC_NO_UNIT | REDCC_LAST))
            continue;
        for (size_t i = here; i < here + more; i++) {
            const uint32_t unit = further->item[i] & ~REDCC_LAST;
            cast_vote(&divide->vote[unit - divide->units.leading], mine);
        }
    }
}

/* Assigns the units that are not in the leading group to the owners that won. Units without a vote
 * are distributed evenly. */
static void count_votes(struct divide *divide, int thread) {
    const uint32_t leading = divide->units.leading, count = divide->units.count - leading;
    const struct share share = share_of(divide, count, thread);
    for (uint32_t unit = share.first; unit < share.end; unit++) {
        const unsigned short vote = atomic_load_explicit(&divide->vote[unit], memory_order_relaxed);
        const uint32_t even = (uint32_t)((uint64_t)unit * divide->partition->owners / count);
        divide->owner[leading + unit] = (unsigned char)(vote == NO_VOTE ? even : vote);
    }
}

static void clear_votes(struct divide *divide, int thread) {
    const uint32_t count = divide->units.count - divide->units.leading;
    const struct share share = share_of(divide, count, thread);
    for (uint32_t unit = share.first; unit < share.end; unit++)
        atomic_store_explicit(&divide->vote[unit], NO_VOTE, memory_order_relaxed);
}

static void take_owners(struct divide *divide, struct sweep *sweep, const struct unit_list *list,
                        size_t at, size_t count) {
    const unsigned short owner = common_owner(divide, list->item + at, count);
    if (owner < SEVERAL)
        redcc_sweep_take_owner(sweep, owner);
    for (size_t i = at; owner != NO_VOTE && owner >= SEVERAL && i < at + count; i++)
        redcc_sweep_take_owner(sweep, divide->owner[list->item[i] & ~REDCC_LAST]);
}

static bool summarise(struct divide *divide, int thread, struct range *seen) {
    const struct access_log *logged = &divide->logged[thread];
    const struct unit_list *leading = &logged->leading, *further = &logged->further;
    struct sweep *sweep = &divide->sweep[thread];
    if (!redcc_sweep_begin(sweep, divide->partition, seen))
        return false;
    redcc_sweep_open_block(sweep, logged->begin);
    for (size_t at = 0, here = 0, count, more = 0; at < leading->count && !sweep->failed;
         at += count, here += more) {
        count = redcc_iteration_length(leading, at);
        take_owners(divide, sweep, leading, at, count);
        if (further->count) {
            more = redcc_iteration_length(further, here);
            take_owners(divide, sweep, further, here, more);
        }
        redcc_sweep_end_iteration(sweep);
    }
    return redcc_sweep_close_block(sweep, logged->iterations);
}

static bool divide_further(struct divide *divide, int thread) {
    clear_votes(divide, thread);
    if (!meet(divide, true, NULL))
        return false;
    vote_further(divide, thread);
    if (!meet(divide, true, NULL))
        return false;
    count_votes(divide, thread);
    return meet(divide, true, NULL);
}

enum divide_result redcc_divide(struct divide *divide, int thread, struct range *seen) {
    if (!meet(divide, true, begin_clusters) || !cluster(divide, thread) ||
        !divide_clusters(divide, thread))
        return DIVIDE_NO_MEMORY;
    place_units(divide, thread);
    if (!meet(divide, true, NULL) || !refine(divide, thread) || !divide_further(divide, thread) ||
        !meet(divide, summarise(divide, thread, seen), NULL))
        return DIVIDE_NO_MEMORY;
    return DIVIDE_DONE;
}

enum divide_result redcc_divide_join(struct divide *divide, int thread, struct range *seen) {
    const struct share share = share_of(divide, divide->units.count, thread);
    for (uint32_t unit = share.first; unit < share.end; unit++) {
        divide->owner[unit] /= 1 + REDCC_STEALABLE;
        assert(divide->owner[unit] < divide->partition->owners);
    }
    redcc_sweep_end(&divide->sweep[thread]);
    if (!meet(divide, true, NULL) || !meet(divide, summarise(divide, thread, seen), NULL))
        return DIVIDE_NO_MEMORY;
    return DIVIDE_DONE;
}
