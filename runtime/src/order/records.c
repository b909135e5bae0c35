/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Orders iterations by their rows, and permutes records. */
#include "redcc/reorder.h"

#include "base/memory.h"

#include <assert.h>
#include <limits.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

struct iteration {
    int lowest, next; /* its lowest row, and its second lowest */
    int number;
};

static int by_rows(const void *a, const void *b) {
    const struct iteration *p = a, *q = b;
    if (p->lowest != q->lowest)
        return p->lowest < q->lowest ? -1 : 1;
    if (p->next != q->next)
        return p->next < q->next ? -1 : 1;
    return (p->number > q->number) - (p->number < q->number);
}

int redcc_reorder_iterations(int trip, int touches, const int *row, int *new_of_old) {
    if (trip < 0 || touches < 0)
        return -1;
    struct iteration *list = redcc_memory_alloc((size_t)trip * sizeof *list);
    if (!list)
        return -1;
    for (int t = 0; t < trip; t++) {
        const int *mine = row + (size_t)t * (size_t)touches;
        struct iteration it = {INT_MAX, INT_MAX, t};
        for (int k = 0; k < touches; k++)
            if (mine[k] < it.lowest) {
                it.next = it.lowest;
                it.lowest = mine[k];
            } else if (mine[k] < it.next) {
                it.next = mine[k];
            }
        list[t] = it;
    }
    qsort(list, (size_t)trip, sizeof *list, by_rows);
    for (int t = 0; t < trip; t++)
        new_of_old[list[t].number] = t;
    redcc_memory_free(list);
    return 0;
}

/* Returns 0 if new_of_old is a permutation; -1 if it is not, or if memory runs out. */
static int check_permutation(int count, const int *new_of_old) {
    char *taken = redcc_memory_alloc_zeroed((size_t)count, 1);
    int wrong = !taken;
    for (int i = 0; !wrong && i < count; i++) {
        wrong = new_of_old[i] < 0 || new_of_old[i] >= count || taken[new_of_old[i]];
        if (!wrong)
            taken[new_of_old[i]] = 1;
    }
    redcc_memory_free(taken);
    return wrong ? -1 : 0;
}

int redcc_reorder_records(void *record, int count, size_t bytes, const int *new_of_old, int back) {
    if (count < 0 || check_permutation(count, new_of_old) != 0)
        return -1;
    if (count == 0 || bytes == 0)
        return 0;
    char *copy =
        bytes <= SIZE_MAX / (size_t)count ? redcc_memory_alloc((size_t)count * bytes) : NULL;
    if (!copy)
        return -1;
    memcpy(copy, record, (size_t)count * bytes);
    for (int i = 0; i < count; i++) {
        const size_t new = (size_t)new_of_old[i] * bytes, old = (size_t)i *bytes;
        memcpy((char *)record + (back ? old : new), copy + (back ? new : old), bytes);
    }
    redcc_memory_free(copy);
    return 0;
}
