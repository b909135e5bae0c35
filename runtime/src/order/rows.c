/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Orders the rows that iterations update together by reverse Cuthill-McKee (George and Liu,
 * Computer solution of large sparse positive definite systems, 1981, chapter 4). */
#include "redcc/reorder.h"

#include "base/memory.h"

#include <assert.h>
#include <stdbool.h>

/* The iterations that update each row. Those of row r are iteration[start[r]] to iteration[start[r
 * + 1] - 1]. The neighbours of a row are the other rows of its iterations; they are not stored,
 * because they may be many. */
struct rows {
    int count, touches;
    const int *row;
    size_t *start;
    int *iteration;
};

/* The state of breadth-first searches. */
struct search {
    int *order; /* the rows in the order of the search */
    int *mark;  /* [rows] number of the last search that reached the row */
    int *level; /* [rows] distance of the row from the root of that search */
    int number; /* number of the current search */
};

static bool rows_begin(struct rows *rows, int trip) {
    const size_t all = (size_t)trip * (size_t)rows->touches;
    rows->start = redcc_memory_alloc_zeroed((size_t)rows->count + 2, sizeof *rows->start);
    rows->iteration = redcc_memory_alloc(all * sizeof *rows->iteration);
    if (!rows->start || !rows->iteration)
        return false;
    for (size_t i = 0; i < all; i++)
        rows->start[rows->row[i] + 2]++;
    for (int r = 0; r < rows->count; r++)
        rows->start[r + 2] += rows->start[r + 1];
    for (size_t i = 0; i < all; i++) /* each start advances to the end of its row's list */
        rows->iteration[rows->start[rows->row[i] + 1]++] = (int)(i / (size_t)rows->touches);
    assert(rows->start[0] == 0 && rows->start[rows->count] == all);
    return true;
}

static size_t degree(const struct rows *rows, int row) {
    return rows->start[row + 1] - rows->start[row];
}

/* Insertion sort, which is stable, and fast if few rows are reached from one row, as is usual. */
static void sort_by_degree(const struct rows *rows, int *list, int count) {
    for (int i = 1; i < count; i++) {
        const int moving = list[i];
        int place = i;
        for (; place > 0 && degree(rows, list[place - 1]) > degree(rows, moving); place--)
            list[place] = list[place - 1];
        list[place] = moving;
    }
}

/* Searches from `root`. Returns the number of rows that it reached. */
static int search_from(const struct rows *rows, struct search *search, int *order, int root) {
    int reached = 1;
    assert(root >= 0 && root < rows->count);
    search->number++;
    order[0] = root;
    search->mark[root] = search->number;
    search->level[root] = 0;
    for (int i = 0; i < reached; i++) {
        const int first = reached, here = order[i];
        for (size_t k = rows->start[here]; k < rows->start[here + 1]; k++) {
            const int *other = rows->row + (size_t)rows->iteration[k] * (size_t)rows->touches;
            for (int t = 0; t < rows->touches; t++) {
                if (search->mark[other[t]] == search->number)
                    continue;
                search->mark[other[t]] = search->number;
                search->level[other[t]] = search->level[here] + 1;
                order[reached++] = other[t];
            }
        }
        assert(reached <= rows->count);
        sort_by_degree(rows, order + first, reached - first);
    }
    return reached;
}

/* Orders the connected component of `row` by a search from a pseudo-peripheral root. To find this
 * root, it repeatedly searches from the row that the last search reached last, until that row's
 * distance no longer grows. Returns the number of rows of the component. */
static int order_part(const struct rows *rows, struct search *search, int *order, int row) {
    int count = search_from(rows, search, order, row), far = -1;
    while (search->level[order[count - 1]] > far) {
        far = search->level[order[count - 1]];
        count = search_from(rows, search, order, order[count - 1]);
    }
    return count;
}

static bool in_range(int trip, int touches, const int *row, int rows) {
    for (size_t i = 0; i < (size_t)trip * (size_t)touches; i++)
        if (row[i] < 0 || row[i] >= rows)
            return false;
    return true;
}

int redcc_reorder_rows(int trip, int touches, const int *row, int rows, int *new_of_old) {
    if (trip < 0 || touches < 0 || rows < 0 || !in_range(trip, touches, row, rows))
        return -1;
    struct rows graph = {.count = rows, .touches = touches, .row = row};
    struct search search = {.number = 0};
    const size_t count = (size_t)rows;
    search.order = redcc_memory_alloc(count * sizeof *search.order);
    search.mark = redcc_memory_alloc_zeroed(count, sizeof *search.mark);
    search.level = redcc_memory_alloc(count * sizeof *search.level);
    const bool enough = rows_begin(&graph, trip) && search.order && search.mark && search.level;
    int done = 0;
    for (int r = 0; enough && r < rows; r++)
        if (search.mark[r] == 0)
            done += order_part(&graph, &search, search.order + done, r);
    assert(!enough || done == rows); /* each row is in one component */
    for (int i = 0; enough && i < rows; i++)
        new_of_old[search.order[i]] = rows - 1 - i;
    redcc_memory_free(graph.start);
    redcc_memory_free(graph.iteration);
    redcc_memory_free(search.order);
    redcc_memory_free(search.mark);
    redcc_memory_free(search.level);
    return enough ? 0 : -1;
}
