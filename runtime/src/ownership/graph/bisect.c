/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "ownership/graph/bisect.h"

#include "base/memory.h"
#include "ownership/partition.h"

#include <assert.h>
#include <string.h>

struct division {
    const struct graph *graph;
    unsigned char *part;
    uint32_t *node;  /* [count] all nodes, sorted by part */
    uint32_t *order; /* [count] nodes in the order in which a search reached them */
    uint32_t *seen;  /* [count] the number of the last search that reached the node */
    uint32_t search;
    uint32_t parts;
    uint32_t stealable;
    uint64_t load[REDCC_PARTS_MOST];
    uint64_t most[REDCC_PARTS_MOST];
};

static uint32_t strength_of(const struct graph *graph, uint32_t edge) {
    return graph->strength ? graph->strength[edge] : 1;
}

/* The gains of a node: for each part of [low, high), the strength of the node's edges into it. */
struct gains {
    uint64_t to[REDCC_PARTS_MOST];
    uint32_t count; /* number of parts whose gain is not 0 */
    uint32_t part[REDCC_PARTS_MOST];
};

static void count_gains(const struct graph *graph, uint32_t node, const unsigned char *part,
                        uint32_t low, uint32_t high, struct gains *gains) {
    gains->count = 0;
    for (uint32_t e = graph->start[node]; e < graph->start[node + 1]; e++) {
        const uint32_t to = part[graph->neighbour[e]];
        if (to < low || to >= high)
            continue;
        if (gains->to[to] == 0)
            gains->part[gains->count++] = to;
        gains->to[to] += strength_of(graph, e);
    }
}

/* The part with the highest gain for a node of weight `weight`, among `here`, the node's part, and
 * those parts into which it has edges and which have room for it. If several parts have equal
 * gains, it is the lightest. If part `here` is too heavy, its gain counts as 0. */
static uint32_t best_part(const struct gains *gains, uint32_t here, uint64_t weight,
                          const uint64_t *load, const uint64_t *most) {
    const bool too_heavy = load[here] > most[here];
    uint32_t best = here;
    uint64_t best_gain = too_heavy ? 0 : gains->to[here];
    for (uint32_t i = 0; i < gains->count; i++) {
        const uint32_t to = gains->part[i];
        if (to == here || load[to] + weight > most[to])
            continue;
        const bool evens = load[to] + weight < (best == here ? load[here] : load[best] + weight);
        if (gains->to[to] > best_gain || (gains->to[to] == best_gain && evens)) {
            best = to;
            best_gain = gains->to[to];
        }
    }
    return best;
}

void redcc_refine(const struct graph *graph, const uint32_t *list, uint32_t count,
                  unsigned char *part, uint32_t low, uint32_t high, uint64_t *load,
                  const uint64_t *most, int rounds) {
    assert(low < high && high <= REDCC_PARTS_MOST && count <= graph->count);
    struct gains gains = {.count = 0};
    for (int round = 0; round < rounds; round++) {
        uint32_t moved = 0;
        for (uint32_t i = 0; i < count; i++) {
            const uint32_t node = list[i], here = part[node];
            count_gains(graph, node, part, low, high, &gains);
            const uint64_t weight = graph->weight[node];
            const uint32_t best = best_part(&gains, here, weight, load, most);
            for (uint32_t t = 0; t < gains.count; t++)
                gains.to[gains.part[t]] = 0;
            if (best == here)
                continue;
            load[here] -= weight;
            load[best] += weight;
            part[node] = (unsigned char)best;
            moved++;
        }
        if (moved == 0)
            break;
    }
}

/* Orders the nodes of part `within`, which are node[0] to node[count - 1], by breadth-first search.
 * The search begins at `first`. Whenever it reaches no further node, it continues from the first
 * node in `node` that it has not reached. Returns the last node reached from `first`, which is the
 * farthest. */
static uint32_t search_from(struct division *division, uint32_t first, const uint32_t *node,
                            uint32_t count, uint32_t within) {
    const struct graph *graph = division->graph;
    uint32_t *order = division->order, *seen = division->seen;
    const uint32_t search = ++division->search;
    uint32_t met = 0, at = 0, farthest = first;
    seen[first] = search;
    order[met++] = first;
    for (uint32_t next = 0; at < count;) {
        for (; at < met; at++)
            for (uint32_t e = graph->start[order[at]]; e < graph->start[order[at] + 1]; e++) {
                const uint32_t other = graph->neighbour[e];
                if (division->part[other] != within || seen[other] == search)
                    continue;
                seen[other] = search;
                order[met++] = other;
            }
        if (next == 0)
            farthest = order[met - 1];
        for (; next < count && seen[node[next]] == search; next++)
            ;
        if (next == count)
            break;
        seen[node[next]] = search;
        order[met++] = node[next++];
    }
    return farthest;
}

/* Orders nodes by a search from a pseudo-peripheral node. To find such a node, a search goes from
 * an arbitrary node to the node farthest from it, and a second search from there to the farthest
 * node again. */
static void order_from_boundary(struct division *division, const uint32_t *node, uint32_t count,
                                uint32_t within) {
    uint32_t outer = node[0];
    for (int again = 0; again < 2; again++)
        outer = search_from(division, outer, node, count, within);
    search_from(division, outer, node, count, within);
}

/* The limit of a part's weight: `share` plus the larger of 1 % and the heaviest node's weight, so
 * that refinement can move nodes. */
static uint64_t slightly_more(uint64_t share, uint64_t heaviest) {
    const uint64_t percent = share / 100;
    return share + (percent > heaviest ? percent : heaviest);
}

/* The share of `sum` for parts [low, middle) if it is divided among parts [low, high). */
static uint64_t share_of(const struct division *division, uint64_t sum, uint32_t low,
                         uint32_t middle, uint32_t high) {
    const uint32_t parts = division->parts, stealable = division->stealable;
    const uint64_t scale = 1000 * (uint64_t)parts;
    const uint64_t below_low = redcc_amount_below(parts, stealable, low, scale);
    const uint64_t lower = redcc_amount_below(parts, stealable, middle, scale) - below_low;
    const uint64_t both = redcc_amount_below(parts, stealable, high, scale) - below_low;
    return sum / both * lower + sum % both * lower / both;
}

/* Divides the nodes node[0] to node[count - 1], which are all in part `low`, into the parts from
 * `low` to before `high`. */
static void bisect(struct division *division, uint32_t *node, uint32_t count, uint32_t low,
                   uint32_t high) {
    const struct graph *graph = division->graph;
    if (high - low < 2 || count == 0)
        return;
    const uint32_t middle = low + (high - low) / 2;
    uint64_t sum = 0, heaviest = 0, lower = 0;
    for (uint32_t i = 0; i < count; i++) {
        const uint64_t weight = graph->weight[node[i]];
        sum += weight;
        heaviest = weight > heaviest ? weight : heaviest;
    }
    order_from_boundary(division, node, count, low);
    memcpy(node, division->order, count * sizeof *node);
    const uint64_t share = share_of(division, sum, low, middle, high);
    uint32_t first = 0;
    for (; first < count && lower + graph->weight[node[first]] / 2 <= share; first++)
        lower += graph->weight[node[first]];
    for (uint32_t i = first; i < count; i++)
        division->part[node[i]] = (unsigned char)middle;
    division->load[low] = lower;
    division->load[middle] = sum - lower;
    division->most[low] = slightly_more(share, heaviest);
    division->most[middle] = slightly_more(sum - share, heaviest);
    for (uint32_t part = low; part < high; part++)
        if (part != low && part != middle)
            division->load[part] = division->most[part] = 0;
    redcc_refine(graph, node, count, division->part, low, high, division->load, division->most, 8);
    uint32_t kept = 0; /* the nodes of the lower part are moved to the front again */
    for (uint32_t i = 0; i < count; i++)
        if (division->part[node[i]] == low)
            division->order[kept++] = node[i];
    first = kept;
    for (uint32_t i = 0; i < count; i++)
        if (division->part[node[i]] == middle)
            division->order[kept++] = node[i];
    memcpy(node, division->order, count * sizeof *node);
    bisect(division, node, first, low, middle);
    bisect(division, node + first, count - first, middle, high);
}

bool redcc_divide_graph(const struct graph *graph, uint32_t parts, uint32_t stealable,
                        unsigned char *part) {
    assert(0 < parts && parts <= REDCC_PARTS_MOST && parts % (1 + stealable) == 0);
    const size_t count = graph->count;
    struct division division = {
        .graph = graph, .part = part, .parts = parts, .stealable = stealable};
    division.node = redcc_memory_alloc(count * sizeof *division.node);
    division.order = redcc_memory_alloc(count * sizeof *division.order);
    division.seen = redcc_memory_alloc_zeroed(count, sizeof *division.seen);
    const bool enough = division.node && division.order && division.seen;
    if (enough) {
        memset(part, 0, count);
        for (uint32_t node = 0; node < graph->count; node++)
            division.node[node] = node;
        bisect(&division, division.node, graph->count, 0, parts);
    }
    redcc_memory_free(division.node);
    redcc_memory_free(division.order);
    redcc_memory_free(division.seen);
    return enough;
}
