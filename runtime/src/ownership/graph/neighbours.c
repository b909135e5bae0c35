/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "ownership/graph/neighbours.h"

#include "base/memory.h"

#include <string.h>

/* Iterations of up to CLIQUE units join each of them with each other one; of more, each with the
 * next, so that the edges do not outgrow the touches. */
enum { CLIQUE = 4 };

/* An iteration's work, shared out among its units. */
enum { WORK = 60 };

bool redcc_graph_begin(struct graph *graph, uint32_t count) {
    *graph = (struct graph){.count = count};
    graph->start = redcc_memory_take(((size_t)count + 2) * sizeof *graph->start);
    graph->weight = redcc_memory_take((size_t)count * sizeof *graph->weight);
    return graph->start && graph->weight;
}

void redcc_graph_end(struct graph *graph) {
    redcc_memory_give(graph->start);
    redcc_memory_give(graph->neighbour);
    redcc_memory_give(graph->strength);
    redcc_memory_give(graph->weight);
    *graph = (struct graph){0};
}

/* The units of the iteration that begins at item `at` of a list, and how many there are. */
static size_t iteration_at(const struct unit_list *list, size_t at) {
    size_t end = at;
    while (!(list->item[end] & REDCC_LAST))
        end++;
    return end + 1 - at;
}

static bool is_in(uint32_t unit, uint32_t first, uint32_t end) {
    return unit - first < end - first;
}

void redcc_graph_count(struct graph *graph, const struct told *const *told, int threads,
                       uint32_t first, uint32_t end) {
    uint32_t *degree =
        graph->start + 2; /* start[n + 2] is the degree of node n until all are known */
    memset(graph->weight + first, 0, (size_t)(end - first) * sizeof *graph->weight);
    memset(degree + first, 0, (size_t)(end - first) * sizeof *degree);
    for (int thread = 0; thread < threads; thread++) {
        const struct unit_list *list = &told[thread]->leading;
        for (size_t at = 0, size; at < list->count; at += size) {
            size = iteration_at(list, at);
            const uint32_t edges = size <= CLIQUE ? (uint32_t)size - 1 : 2;
            const uint32_t work = size < WORK ? WORK / (uint32_t)size : 1;
            for (size_t i = at; i < at + size; i++) {
                const uint32_t unit = list->item[i] & ~REDCC_LAST;
                if (!is_in(unit, first, end)) /* nor is REDCC_NO_UNIT */
                    continue;
                degree[unit] += edges;
                graph->weight[unit] += work;
            }
        }
    }
}

bool redcc_graph_take(struct graph *graph) {
    uint64_t sum = 0;
    uint32_t *start = graph->start;
    start[0] = 0;
    for (uint32_t node = 0; node < graph->count; node++) {
        const uint32_t degree = start[node + 2];
        start[node + 1] = (uint32_t)sum; /* where filling begins; moves on to where it ends */
        sum += degree;
    }
    start[graph->count + 1] = (uint32_t)sum;
    if (sum > UINT32_MAX)
        return false;
    graph->neighbour = redcc_memory_take((size_t)sum * sizeof *graph->neighbour);
    return graph->neighbour != NULL;
}

static void join(const struct graph *graph, uint32_t unit, uint32_t other) {
    graph->neighbour[graph->start[unit + 1]++] = other & ~REDCC_LAST;
}

void redcc_graph_fill(struct graph *graph, const struct told *const *told, int threads,
                      uint32_t first, uint32_t end) {
    for (int thread = 0; thread < threads; thread++) {
        const struct unit_list *list = &told[thread]->leading;
        for (size_t at = 0, size; at < list->count; at += size) {
            size = iteration_at(list, at);
            const uint32_t *units = list->item + at;
            for (size_t i = 0; i < size && size > 1; i++) {
                const uint32_t unit = units[i] & ~REDCC_LAST;
                if (!is_in(unit, first, end))
                    continue;
                if (size > CLIQUE) {
                    join(graph, unit, units[i ? i - 1 : size - 1]);
                    join(graph, unit, units[i + 1 < size ? i + 1 : 0]);
                    continue;
                }
                for (size_t j = 0; j < size; j++)
                    if (j != i)
                        join(graph, unit, units[j]);
            }
        }
    }
}
