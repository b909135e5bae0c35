/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "ownership/graph/clusters.h"

#include "base/memory.h"

#include <string.h>

enum { UNSEEN = -1, WAITING = -2 }; /* of nodes without a cluster; as uint32_t */

/* A node of so many edges is everybody's neighbour: nothing grows through it. */
enum { HUB = 4096 };

struct growth {
    const struct graph *graph;
    struct clusters *clusters;
    uint32_t
        *waiting; /* nodes next to a cluster that was full, in the order in which they were met */
    uint32_t first_waiting;
    uint32_t end_waiting;
    uint32_t members;
};

static void take_in(struct growth *growth, uint32_t node) {
    growth->clusters->of[node] = growth->clusters->count;
    growth->clusters->member[growth->members++] = node;
}

/* Breadth first from the seed, until there are `most` of them. */
static void grow(struct growth *growth, uint32_t seed, uint32_t most) {
    const struct graph *graph = growth->graph;
    struct clusters *clusters = growth->clusters;
    const uint32_t first = growth->members;
    clusters->start[clusters->count] = first;
    take_in(growth, seed);
    for (uint32_t m = first; m < growth->members; m++) {
        const uint32_t node = clusters->member[m];
        const uint32_t begin = graph->start[node], end = graph->start[node + 1];
        for (uint32_t e = begin; e < end && end - begin <= HUB; e++) {
            const uint32_t other = graph->neighbour[e];
            if (clusters->of[other] < (uint32_t)WAITING)
                continue;
            if (growth->members - first < most) {
                take_in(growth, other);
            } else if (clusters->of[other] == (uint32_t)UNSEEN) {
                clusters->of[other] = (uint32_t)WAITING;
                growth->waiting[growth->end_waiting++] = other;
            }
        }
    }
    clusters->count++;
    clusters->start[clusters->count] = growth->members;
}

static void grow_all(struct growth *growth, uint32_t most) {
    const uint32_t count = growth->graph->count;
    const uint32_t *of = growth->clusters->of;
    for (uint32_t node = 0; node < count; node++) {
        if (of[node] != (uint32_t)UNSEEN)
            continue;
        grow(growth, node, most);
        while (growth->first_waiting < growth->end_waiting) {
            const uint32_t seed = growth->waiting[growth->first_waiting++];
            if (of[seed] == (uint32_t)WAITING)
                grow(growth, seed, most);
        }
    }
}

bool redcc_clusters_begin(struct clusters *clusters, const struct graph *graph, uint32_t most) {
    const size_t nodes = graph->count;
    *clusters = (struct clusters){0};
    clusters->of = redcc_memory_take(nodes * sizeof *clusters->of);
    clusters->member = redcc_memory_take(nodes * sizeof *clusters->member);
    clusters->start = redcc_memory_take((nodes + 1) * sizeof *clusters->start);
    struct growth growth = {.graph = graph, .clusters = clusters};
    growth.waiting = redcc_memory_take(nodes * sizeof *growth.waiting);
    const bool enough = clusters->of && clusters->member && clusters->start && growth.waiting;
    if (enough) {
        memset(clusters->of, 0xff, nodes * sizeof *clusters->of);
        clusters->start[0] = 0;
        grow_all(&growth, most);
    }
    redcc_memory_give(growth.waiting);
    return enough;
}

void redcc_clusters_end(struct clusters *clusters) {
    redcc_memory_give(clusters->of);
    redcc_memory_give(clusters->member);
    redcc_memory_give(clusters->start);
    *clusters = (struct clusters){0};
}

static bool room_for_edges(struct cluster_edges *edges, size_t more) {
    if (edges->count + more <= edges->capacity)
        return true;
    const size_t capacity = (edges->count + more) * 2;
    uint32_t *to = redcc_memory_resize(edges->to, capacity * sizeof *to);
    if (!to)
        return false;
    edges->to = to;
    uint32_t *strength = redcc_memory_resize(edges->strength, capacity * sizeof *strength);
    if (!strength)
        return false;
    edges->strength = strength;
    edges->capacity = capacity;
    return true;
}

/* Adds up the edges of one cluster; `place` [clusters] is where the edge to each is kept, one that
 * was kept before `from` is another's. */
static bool add_edges(const struct clusters *clusters, const struct graph *graph, uint32_t cluster,
                      size_t *place, struct cluster_edges *edges) {
    const size_t from = edges->count;
    for (uint32_t m = clusters->start[cluster]; m < clusters->start[cluster + 1]; m++) {
        const uint32_t node = clusters->member[m];
        const uint32_t begin = graph->start[node], end = graph->start[node + 1];
        if (end - begin > HUB)
            continue;
        if (!room_for_edges(edges, end - begin))
            return false;
        for (uint32_t e = begin; e < end; e++) {
            const uint32_t to = clusters->of[graph->neighbour[e]];
            if (to == cluster)
                continue;
            const size_t at = place[to];
            if (at >= from && at < edges->count && edges->to[at] == to) {
                edges->strength[at]++;
                continue;
            }
            place[to] = edges->count;
            edges->to[edges->count] = to;
            edges->strength[edges->count++] = 1;
        }
    }
    return true;
}

bool redcc_clusters_edges(const struct clusters *clusters, const struct graph *graph,
                          uint32_t first, uint32_t end, struct graph *coarse,
                          struct cluster_edges *edges) {
    size_t *place = redcc_memory_take_zeroed(clusters->count, sizeof *place);
    bool enough = place != NULL;
    for (uint32_t cluster = first; enough && cluster < end; cluster++) {
        const size_t before = edges->count;
        uint64_t weight = 0;
        enough = add_edges(clusters, graph, cluster, place, edges);
        for (uint32_t m = clusters->start[cluster]; m < clusters->start[cluster + 1]; m++)
            weight += graph->weight[clusters->member[m]];
        coarse->start[cluster + 1] = (uint32_t)(edges->count - before);
        coarse->weight[cluster] = weight < UINT32_MAX ? (uint32_t)weight : UINT32_MAX;
    }
    redcc_memory_give(place);
    return enough;
}

void redcc_cluster_edges_end(struct cluster_edges *edges) {
    redcc_memory_give(edges->to);
    redcc_memory_give(edges->strength);
    *edges = (struct cluster_edges){0};
}
