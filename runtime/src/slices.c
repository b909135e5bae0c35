/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "slices.h"

#include "base/memory.h"
#include "library.h"
#include "redcc/bins.h"

#include <stdio.h>
#include <string.h>

enum { ENTRIES = 64, MOST_MESSAGES = 3 };

struct checker;

/* A hook (execute/hook.h) that is installed in each array's owner, so that the body's owner check
 * calls ask() before each update. */
struct asking_hook {
    struct checker *checker;
    redcc_u32 array;
};

/* The state of the check, which executes slice and body of one iteration after the other. */
struct checker {
    redcc_worker worker; /* must be first: the functions below convert a pointer to it */
    redcc_call call;
    const redcc_attempt *attempt;
    redcc_int k;
    /* was iteration k handed out for inspection, and for execution? */
    bool inspected, executed;
    redcc_entry entry[ENTRIES];
    redcc_entry *named; /* [count] the rows that the slice of iteration k named */
    size_t count, room;
    redcc_owner *window, *owner; /* [array_count] */
    redcc_extent *sources;       /* [source_count] */
    struct asking_hook *hook;    /* [array_count] */
    redcc_iterations run;
    long found;
    bool no_memory;
};

static struct checker *checker_of(redcc_worker *worker) {
    return (struct checker *)(void *)worker;
}

static void take_named(redcc_worker *worker) {
    struct checker *it = checker_of(worker);
    for (const redcc_entry *e = it->entry; e != worker->entry; e++) {
        if (e->array == REDCC_END_OF_ITERATION)
            continue;
        if (it->count == it->room) {
            const size_t room = 2 * it->room + ENTRIES;
            redcc_entry *more = redcc_memory_resize(it->named, room * sizeof *more);
            if (!more) {
                it->no_memory = true;
                break;
            }
            it->named = more;
            it->room = room;
        }
        it->named[it->count++] = *e;
    }
    worker->entry = it->entry;
}

static int hand_out_to_inspect(redcc_worker *worker) {
    struct checker *it = checker_of(worker);
    if (it->inspected)
        return 0;
    it->inspected = true;
    it->count = 0;
    worker->first = it->k;
    worker->last = it->k + 1;
    worker->stride = 1;
    worker->entry = it->entry;
    worker->entry_end = it->entry + ENTRIES;
    worker->inside = worker->outside = 0;
    worker->alike = 0;
    return 1;
}

static int hand_out_to_execute(redcc_worker *worker) {
    struct checker *it = checker_of(worker);
    if (it->executed)
        return 0;
    it->executed = true;
    worker->origin = it->k;
    worker->run = &it->run;
    worker->run_end = &it->run + 1;
    return 1;
}

static int hand_out_none(redcc_worker *worker, redcc_bins *bins, const void *operands) {
    (void)worker, (void)bins, (void)operands;
    return 0;
}

static int claims_nothing(redcc_worker *worker) {
    (void)worker;
    return 0;
}

static bool is_named(const struct checker *it, redcc_u32 array, const char *address) {
    for (size_t n = 0; n < it->count; n++)
        if (it->named[n].array == array &&
            (redcc_size)address - (redcc_size)it->named[n].address < it->named[n].bytes)
            return true;
    return false;
}

static void report(struct checker *it, redcc_u32 number, const char *address) {
    const redcc_loop *loop = it->call.loop;
    const redcc_array *array = &loop->arrays[number];
    const redcc_int into =
        (redcc_int)((redcc_size)address - (redcc_size)it->attempt->bases[number]);
    const redcc_int unit = (redcc_int)array->unit;
    const redcc_int row = into >= 0 ? into / unit : -((unit - 1 - into) / unit);
    if (it->found++ < MOST_MESSAGES)
        fprintf(
            stderr,
            "redcc: validated: %s:%d: slice of %s does not name row %lld of %s, which iteration "
            "number %lld, counted from 0, updates\n",
            loop->file, loop->line, loop->function, row, array->name, it->k);
}

/* Called before each update. Reports the update if the slice did not name its row. Returns 0, so
 * that the update is not made and the arrays stay unchanged. */
static int ask(struct redcc_hook *hook, const void *address) {
    const struct asking_hook *asking = (const struct asking_hook *)(const void *)hook;
    struct checker *it = asking->checker;
    if (!it->no_memory && !is_named(it, asking->array, address))
        report(it, asking->array, address);
    return 0;
}

static bool alloc_memory(struct checker *it) {
    const redcc_loop *loop = it->call.loop;
    const size_t arrays = loop->array_count;
    it->window = redcc_memory_alloc_zeroed(arrays, sizeof *it->window);
    it->owner = redcc_memory_alloc_zeroed(arrays, sizeof *it->owner);
    it->hook = redcc_memory_alloc_zeroed(arrays, sizeof *it->hook);
    it->sources = redcc_memory_alloc_zeroed(loop->source_count + 1, sizeof *it->sources);
    if (!it->window || !it->owner || !it->hook || !it->sources)
        return false;
    for (size_t a = 0; a < arrays; a++) {
        it->hook[a] = (struct asking_hook){it, (redcc_u32)a};
        it->owner[a].hook = (struct redcc_hook *)(void *)&it->hook[a];
    }
    return true;
}

static void free_memory(struct checker *it) {
    redcc_memory_free(it->named);
    redcc_memory_free(it->window);
    redcc_memory_free(it->owner);
    redcc_memory_free(it->hook);
    redcc_memory_free(it->sources);
}

long redcc_slices_check(redcc_site *site, const redcc_attempt *attempt, redcc_member *member,
                        const void *context) {
    redcc_calls calls = redcc_library;
    struct checker it = {
        .call = {.loop = &site->binned.loop, .trip = attempt->trip, .threads = 1, .calls = &calls},
        .attempt = attempt,
        .run = {.begin = 0, .count_and_check = 2 * 1 + 1}}; /* run: one iteration, owner-checked */
    calls.inspect = hand_out_to_inspect;
    calls.flush = take_named;
    calls.next = hand_out_to_execute;
    calls.bins_next = hand_out_none;
    calls.claims_last = claims_nothing;
    calls.hooked = ask;
    if (alloc_memory(&it)) {
        it.worker = (redcc_worker){.call = &it.call,
                                   .window = it.window,
                                   .sources = it.sources,
                                   .base = attempt->bases,
                                   .owner = it.owner};
        for (it.k = 0; it.k < attempt->trip; it.k++) {
            it.inspected = it.executed = false;
            member(&it.worker, attempt, context);
        }
    }
    free_memory(&it);
    return it.found;
}
