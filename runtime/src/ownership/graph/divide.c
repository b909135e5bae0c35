/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "ownership/graph/divide.h"

#include "base/memory.h"
#include "base/share.h"
#include "ownership/graph/bisect.h"

#include <assert.h>
#include <string.h>

enum {
    CLUSTERS_AN_OWNER = 64,
    CLUSTER_MOST = 64, /* units */
    NO_VOTE = 0xffff,
    SEVERAL = 0x8000, /* of a vote: by an iteration that has several owners anyway */
    ROUNDS = 4        /* of refinement, unit by unit */
};

/* Touches of all threads beyond which keeping them is out of proportion. */
static size_t most_touches(redcc_int trip) {
    const size_t each = 64, bound = (size_t)REDCC_NO_UNIT;
    return (size_t)trip < bound / each ? (size_t)trip * each : bound;
}

/* Of elements that lie anywhere, what lies between them can be without bound: more units than
 * could be touched are not worth a map. */
static bool is_too_wide(const struct divide *divide, redcc_int trip) {
    const struct partition *partition = divide->partition;
    bool is_scattered = false;
    for (uint32_t array = 0; array < partition->array_count; array++)
        is_scattered |= redcc_is_scattered((const void *)partition->base[array]);
    return is_scattered && divide->units.count > most_touches(trip);
}

enum divide_result redcc_divide_begin(struct divide *divide, const struct partition *partition,
                                      const struct range *touched, int threads, redcc_int trip) {
    *divide = (struct divide){.partition = partition, .threads = threads};
    const size_t count = (size_t)threads;
    divide->most_told = most_touches(trip) / count;
    if (partition->owners > REDCC_OWNERS_MOST || trip > REDCC_BLOCK)
        return DIVIDE_UNSUITABLE;
    divide->told = redcc_memory_take_zeroed(count, sizeof *divide->told);
    divide->sweep = redcc_memory_take_zeroed(count, sizeof *divide->sweep);
    divide->telling = redcc_memory_take_zeroed(count, sizeof *divide->telling);
    divide->edges = redcc_memory_take_zeroed(count, sizeof *divide->edges);
    divide->rim_count = redcc_memory_take_zeroed(count, sizeof *divide->rim_count);
    if (!redcc_units_begin(&divide->units, partition, touched) || !divide->told || !divide->sweep ||
        !divide->telling || !divide->edges || !divide->rim_count)
        return DIVIDE_NO_MEMORY;
    const bool is_suitable = divide->units.leading > 0 && divide->units.count > 0;
    return is_suitable && !is_too_wide(divide, trip) ? DIVIDE_DONE : DIVIDE_UNSUITABLE;
}

void redcc_divide_tidy(struct divide *divide) {
    for (int thread = 0; thread < divide->threads; thread++) {
        if (divide->told)
            redcc_told_end(&divide->told[thread]);
        if (divide->edges)
            redcc_cluster_edges_end(&divide->edges[thread]);
    }
    redcc_graph_end(&divide->graph);
    redcc_clusters_end(&divide->clusters);
    redcc_graph_end(&divide->coarse);
    redcc_memory_give(divide->part);
    redcc_memory_give(divide->rim);
    redcc_memory_give((void *)divide->vote);
    divide->part = NULL;
    divide->rim = NULL;
    divide->vote = NULL;
}

void redcc_divide_end(struct divide *divide) {
    redcc_divide_tidy(divide);
    for (int thread = 0; divide->sweep && thread < divide->threads; thread++)
        redcc_sweep_end(&divide->sweep[thread]);
    redcc_units_end(&divide->units);
    redcc_memory_give(divide->told);
    redcc_memory_give(divide->sweep);
    redcc_memory_give(divide->owner);
    redcc_memory_give((void *)divide->telling);
    redcc_memory_give(divide->edges);
    redcc_memory_give(divide->rim_count);
    *divide = (struct divide){0};
}

/* Nodes, clusters, units [first, end) of `count` are this thread's. */
struct share {
    uint32_t first;
    uint32_t end;
};

static struct share share_of(const struct divide *divide, uint32_t count, int thread) {
    return (struct share){(uint32_t)redcc_share(count, divide->threads, thread),
                          (uint32_t)redcc_share(count, divide->threads, thread + 1)};
}

/* All meet; the last one does `alone`, if nobody has failed. Returns the same to all: is it going
 * well? */
static bool meet(struct divide *divide, bool done, bool (*alone)(struct divide *)) {
    if (!done)
        atomic_store(&divide->failed, true);
    if (redcc_barrier_arrive(divide->barrier, divide->threads)) {
        divide->going = !atomic_load(&divide->failed) && (!alone || alone(divide));
        redcc_barrier_release(divide->barrier);
    }
    return divide->going;
}

static bool take_graph(struct divide *divide) {
    const struct units *units = &divide->units;
    const size_t further = units->count - units->leading;
    for (int thread = 0; thread < divide->threads; thread++)
        divide->telling[thread] = &divide->told[thread];
    divide->owner = redcc_memory_take(units->count);
    divide->rim = redcc_memory_take(units->leading * sizeof *divide->rim);
    divide->vote = redcc_memory_take(further * sizeof *divide->vote);
    return divide->owner && divide->rim && divide->vote &&
           redcc_graph_begin(&divide->graph, units->leading);
}

static bool take_edges(struct divide *divide) {
    return redcc_graph_take(&divide->graph);
}

/* So small that the parts can be even, so large that there are few. */
static bool make_clusters(struct divide *divide) {
    const uint32_t even = divide->units.leading / (divide->partition->owners * CLUSTERS_AN_OWNER);
    const uint32_t most = even > CLUSTER_MOST ? CLUSTER_MOST : even > 0 ? even : 1;
    if (!redcc_clusters_begin(&divide->clusters, &divide->graph, most))
        return false;
    divide->part = redcc_memory_take(divide->clusters.count);
    return divide->part && redcc_graph_begin(&divide->coarse, divide->clusters.count);
}

static bool count_cluster_edges(struct divide *divide, int thread) {
    const struct share share = share_of(divide, divide->clusters.count, thread);
    return redcc_clusters_edges(&divide->clusters, &divide->graph, share.first, share.end,
                                &divide->coarse, &divide->edges[thread]);
}

static bool divide_coarse(struct divide *divide) {
    struct graph *coarse = &divide->coarse;
    size_t sum = 0, at = 0;
    for (int thread = 0; thread < divide->threads; thread++)
        sum += divide->edges[thread].count;
    coarse->neighbour = redcc_memory_take(sum * sizeof *coarse->neighbour);
    coarse->strength = redcc_memory_take(sum * sizeof *coarse->strength);
    if (sum > UINT32_MAX || !coarse->neighbour || !coarse->strength)
        return false;
    for (int thread = 0; thread < divide->threads; thread++) {
        const struct cluster_edges *edges = &divide->edges[thread];
        if (edges->count == 0)
            continue;
        memcpy(coarse->neighbour + at, edges->to, edges->count * sizeof *edges->to);
        memcpy(coarse->strength + at, edges->strength, edges->count * sizeof *edges->strength);
        at += edges->count;
    }
    coarse->start[0] = 0;
    for (uint32_t cluster = 0; cluster < coarse->count; cluster++)
        coarse->start[cluster + 1] += coarse->start[cluster];
    return redcc_divide_graph(coarse, divide->partition->owners, divide->partition->stealable,
                              divide->part);
}

/* Each unit gets its cluster's owner; those with a neighbour of another owner are listed. */
static void place_units(struct divide *divide, int thread) {
    const struct graph *graph = &divide->graph;
    const struct share share = share_of(divide, graph->count, thread);
    const uint32_t *of = divide->clusters.of;
    uint32_t listed = 0;
    for (uint32_t unit = share.first; unit < share.end; unit++) {
        const unsigned char owner = divide->part[of[unit]];
        assert(owner < divide->partition->owners);
        divide->owner[unit] = owner;
        for (uint32_t e = graph->start[unit]; e < graph->start[unit + 1]; e++)
            if (divide->part[of[graph->neighbour[e]]] != owner) {
                divide->rim[share.first + listed++] = unit;
                break;
            }
    }
    divide->rim_count[thread] = listed;
}

static bool refine_rims(struct divide *divide) {
    const struct graph *graph = &divide->graph;
    uint64_t load[REDCC_PARTS_MOST] = {0}, most[REDCC_PARTS_MOST], sum = 0;
    uint32_t listed = 0;
    for (int thread = 0; thread < divide->threads; thread++) {
        const struct share share = share_of(divide, graph->count, thread);
        memmove(divide->rim + listed, divide->rim + share.first,
                divide->rim_count[thread] * sizeof *divide->rim);
        listed += divide->rim_count[thread];
    }
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
    redcc_refine(graph, divide->rim, listed, divide->owner, 0, owners, load, most, ROUNDS);
    return true;
}

static void cast_vote(atomic_ushort *vote, unsigned short mine) {
    unsigned short known = atomic_load_explicit(vote, memory_order_relaxed);
    while (mine < known && !atomic_compare_exchange_weak_explicit(
                               vote, &known, mine, memory_order_relaxed, memory_order_relaxed))
        ;
}

/* Units of further groups: the owner of an iteration that has but one by the leading group; else an
 * owner of one that has several. The lowest, whoever is first. */
static void vote_further(struct divide *divide, int thread) {
    const struct told *told = &divide->told[thread];
    struct told_reading leading = {&told->leading, 0}, further = {&told->further, 0};
    while (further.at < told->further.count) {
        unsigned short mine = NO_VOTE;
        for (bool last = false; !last;) {
            const uint32_t unit = redcc_told_read(&leading, &last);
            if (unit == REDCC_NO_UNIT)
                continue;
            const unsigned char owner = divide->owner[unit];
            if (mine == NO_VOTE)
                mine = owner;
            else if ((mine & 0xff) != owner)
                mine |= SEVERAL;
        }
        for (bool last = false; !last;) {
            const uint32_t unit = redcc_told_read(&further, &last);
            if (unit != REDCC_NO_UNIT && mine != NO_VOTE)
                cast_vote(&divide->vote[unit - divide->units.leading], mine);
        }
    }
}

/* Who was voted for; units without a vote are dealt out evenly. */
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

static void take_owners(struct divide *divide, struct sweep *sweep, struct told_reading *reading) {
    for (bool last = false; !last;) {
        const uint32_t unit = redcc_told_read(reading, &last);
        if (unit != REDCC_NO_UNIT)
            redcc_sweep_take_owner(sweep, divide->owner[unit]);
    }
}

static bool summarise(struct divide *divide, int thread, struct range *seen) {
    const struct told *told = &divide->told[thread];
    struct sweep *sweep = &divide->sweep[thread];
    if (!redcc_sweep_begin(sweep, divide->partition, seen))
        return false;
    const redcc_int trip = told->iterations;
    struct told_reading leading = {&told->leading, 0}, further = {&told->further, 0};
    redcc_sweep_open_block(sweep, told->begin);
    while (leading.at < told->leading.count && !sweep->failed) {
        take_owners(divide, sweep, &leading);
        if (told->further.count)
            take_owners(divide, sweep, &further);
        redcc_sweep_end_iteration(sweep);
    }
    return redcc_sweep_close_block(sweep, trip);
}

enum divide_result redcc_divide(struct divide *divide, int thread, struct range *seen) {
    struct graph *graph = &divide->graph;
    const struct share units = share_of(divide, divide->units.leading, thread);
    if (!meet(divide, true, take_graph))
        return DIVIDE_NO_MEMORY;
    redcc_graph_count(graph, divide->telling, divide->threads, units.first, units.end);
    clear_votes(divide, thread);
    if (!meet(divide, true, take_edges))
        return DIVIDE_NO_MEMORY;
    redcc_graph_fill(graph, divide->telling, divide->threads, units.first, units.end);
    if (!meet(divide, true, make_clusters) ||
        !meet(divide, count_cluster_edges(divide, thread), divide_coarse))
        return DIVIDE_NO_MEMORY;
    place_units(divide, thread);
    if (!meet(divide, true, refine_rims))
        return DIVIDE_NO_MEMORY;
    vote_further(divide, thread);
    if (!meet(divide, true, NULL))
        return DIVIDE_NO_MEMORY;
    count_votes(divide, thread);
    if (!meet(divide, true, NULL) || !meet(divide, summarise(divide, thread, seen), NULL))
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
