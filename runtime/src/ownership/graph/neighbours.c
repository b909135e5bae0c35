/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "ownership/graph/neighbours.h"

#include "base/memory.h"

#include <assert.h>
#include <string.h>

/* An iteration of up to CLIQUE units adds an edge for each pair of its units. An iteration of more
 * units adds only a ring of edges between consecutive units. So the number of edges stays
 * proportional to the touches. */
enum { CLIQUE = 4 };

/* A node that has more edges than this, counting parallel edges separately, is a hub, and the edges
 * stored at it are dropped. */
enum { HUB = 4096 };

bool redcc_graph_begin(struct graph *graph, uint32_t count) {
    *graph = (struct graph){.count = count};
    graph->start = redcc_memory_alloc(((size_t)count + 2) * sizeof *graph->start);
    graph->weight = redcc_memory_alloc((size_t)count * sizeof *graph->weight);
    return graph->start && graph->weight;
}

void redcc_graph_end(struct graph *graph) {
    redcc_memory_free(graph->start);
    redcc_memory_free(graph->neighbour);
    redcc_memory_free(graph->strength);
    redcc_memory_free(graph->weight);
    *graph = (struct graph){0};
}

static bool is_in(const struct graph *graph, uint32_t node, uint32_t first, uint32_t end) {
    return node - first < end - first && (!graph->only || graph->only[node]);
}

void redcc_graph_count(struct graph *graph, const struct unit_list *const *list, int lists,
                       uint32_t first, uint32_t end) {
    assert(first <= end && end <= graph->count && lists >= 0);
    uint32_t *degree =
        graph->start + 2; /* start[n + 2] is the number of edges of node n until all are counted */
    memset(graph->weight + first, 0, (size_t)(end - first) * sizeof *graph->weight);
    memset(degree + first, 0, (size_t)(end - first) * sizeof *degree);
    for (int l = 0; l < lists; l++)
        for (size_t at = 0, size; at < list[l]->count; at += size) {
            size = redcc_iteration_length(list[l], at);
            const uint32_t edges = size <= CLIQUE ? (uint32_t)size - 1 : 2;
            const uint32_t work = redcc_work_of(size);
            for (size_t i = at; i < at + size; i++) {
                const uint32_t node = list[l]->item[i] & ~REDCC_LAST;
                if (!is_in(graph, node, first, end)) /* also false for REDCC_NO_UNIT */
                    continue;
                degree[node] += edges;
                graph->weight[node] += work;
            }
        }
}

bool redcc_graph_take(struct graph *graph) {
    uint64_t sum = 0;
    uint32_t *start = graph->start;
    start[0] = 0;
    for (uint32_t node = 0; node < graph->count; node++) {
        const uint32_t degree = start[node + 2];
        start[node + 1] = (uint32_t)sum; /* the index of the node's first edge. redcc_graph_fill
                                            advances it to the end of the node's edges */
        sum += degree;
    }
    start[graph->count + 1] = (uint32_t)sum;
    if (sum > UINT32_MAX)
        return false;
    graph->neighbour = redcc_memory_alloc((size_t)sum * sizeof *graph->neighbour);
    return graph->neighbour != NULL;
}

static void join(const struct graph *graph, uint32_t unit, uint32_t other) {
    graph->neighbour[graph->start[unit + 1]++] = other & ~REDCC_LAST;
}

void redcc_graph_fill(struct graph *graph, const struct unit_list *const *list, int lists,
                      uint32_t first, uint32_t end) {
    assert(first <= end && end <= graph->count && graph->neighbour);
    for (int l = 0; l < lists; l++)
        for (size_t at = 0, size; at < list[l]->count; at += size) {
            size = redcc_iteration_length(list[l], at);
            const uint32_t *nodes = list[l]->item + at;
            for (size_t i = 0; i < size && size > 1; i++) {
                const uint32_t node = nodes[i] & ~REDCC_LAST;
                if (!is_in(graph, node, first, end))
                    continue;
                if (size > CLIQUE) {
                    join(graph, node, nodes[i ? i - 1 : size - 1]);
                    join(graph, node, nodes[i + 1 < size ? i + 1 : 0]);
                    continue;
                }
                for (size_t j = 0; j < size; j++)
                    if (j != i)
                        join(graph, node, nodes[j]);
            }
        }
}

/* Merges the edges of node `node`, and appends them to the `count` edges of earlier nodes. For each
 * node, place[nodes] has the index of the last stored edge to it; if this is at least the initial
 * `count`, that edge belongs to `node`. Returns the new number of edges. */
static uint32_t merge_edges(struct graph *graph, uint32_t node, uint32_t begin, uint32_t end,
                            uint32_t count, uint32_t *place) {
    const uint32_t own = count;
    for (uint32_t e = begin; e < end && end - begin <= HUB; e++) {
        const uint32_t to = graph->neighbour[e];
        if (to == node)
            continue;
        if (place[to] >= own && place[to] < count && graph->neighbour[place[to]] == to) {
            graph->strength[place[to]]++;
            continue;
        }
        place[to] = count;
        graph->neighbour[count] = to;
        graph->strength[count++] = 1;
    }
    return count;
}

bool redcc_graph_merge(struct graph *graph) {
    assert(graph->neighbour && !graph->strength);
    const uint32_t edges = graph->start[graph->count];
    uint32_t *place = redcc_memory_alloc_zeroed(graph->count, sizeof *place);
    graph->strength = redcc_memory_alloc(edges * sizeof *graph->strength);
    const bool enough = place && graph->strength;
    uint32_t begin = 0, count = 0;
    for (uint32_t node = 0; enough && node < graph->count; node++) {
        const uint32_t end = graph->start[node + 1];
        count = merge_edges(graph, node, begin, end, count, place);
        graph->start[node + 1] = count;
        begin = end;
    }
    redcc_memory_free(place);
    return enough;
}
