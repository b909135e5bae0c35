/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Blocks of memory never overlap, whichever threads allocate them, also in a child process. */
#include "base/blocks.h"

#include <omp.h>
#include <sched.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdint.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmocka.h>

struct held {
    unsigned char *block;
    size_t bytes; /* actual size of the block */
    size_t asked;
    unsigned char filled;
    bool keep;
};

static uint64_t next(uint64_t *state) {
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return *state >> 33;
}

static bool is_whole(const struct held *held) {
    for (size_t i = 0; i<held->bytes; i += held->bytes> 4096 ? 509 : 1)
        if (held->block[i] != held->filled)
            return false;
    return held->block[held->bytes - 1] == held->filled;
}

/* Allocates, fills, checks and frees blocks at random. Returns the number of blocks whose contents
 * had changed. */
static long churn(uint64_t seed, int steps) {
    enum { HELD = 60 };
    struct held held[HELD] = {{0}};
    uint64_t state = seed;
    long wrong = 0;
    for (int step = 0; step < steps + HELD; step++) {
        struct held *it = &held[step < steps ? next(&state) % HELD : (uint64_t)(step - steps)];
        if (it->block) {
            wrong += !is_whole(it);
            redcc_block_free(it->block, it->bytes, it->keep);
            it->block = NULL;
            continue;
        }
        if (step >= steps)
            continue;
        it->asked = 1 + next(&state) % ((size_t)1 << (6 + next(&state) % 15));
        it->bytes = it->asked;
        it->keep = next(&state) % 4 > 0;
        it->block = redcc_block_alloc(&it->bytes, it->keep);
        wrong += !it->block || it->bytes < it->asked || (uintptr_t)it->block % 64 != 0;
        it->filled = (unsigned char)next(&state);
        if (it->block)
            memset(it->block, it->filled, it->bytes);
    }
    return wrong;
}

static void blocks_do_not_overlap(void **unused) {
    (void)unused;
    assert_int_equal(churn(1, 20000), 0);
}

static void blocks_of_several_threads(void **unused) {
    (void)unused;
    long wrong = 0;
#pragma omp parallel for num_threads(4) reduction(+ : wrong) schedule(static, 1)
    for (int thread = 0; thread < 4; thread++)
        wrong += churn(17 + (uint64_t)thread, 5000);
    assert_int_equal(wrong, 0);
}

static void blocks_of_a_child(void **unused) {
    (void)unused;
    size_t bytes = 1000;
    unsigned char *block = redcc_block_alloc(&bytes, true);
    assert_non_null(block);
    memset(block, 7, bytes);
    const pid_t child = fork();
    if (child == 0) {
        redcc_blocks_forked();
        const long wrong = churn(5, 2000);
        const struct held held = {block, bytes, 1000, 7, true};
        _exit(wrong != 0 || !is_whole(&held));
    }
    int status = -1;
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_int_equal(status, 0);
    redcc_block_free(block, bytes, true);
}

/* Only the system orders the second thread after the first one, which race detectors cannot see.
 * The flag gives them this order. */
static void the_place_of_another_thread(void **unused) {
    (void)unused;
    atomic_bool is_given = false;
    long wrong = 0;
#pragma omp parallel num_threads(2) reduction(+ : wrong)
    {
        const bool is_first = omp_get_thread_num() == 0 || omp_get_num_threads() == 1;
        while (!is_first && !atomic_load_explicit(&is_given, memory_order_relaxed))
            sched_yield();
        size_t bytes = (size_t)1 << 22;
        unsigned char *block = redcc_block_alloc(&bytes, false);
        wrong += !block;
        if (block) {
            *(volatile unsigned char *)block = is_first ? 1 : 2;
            redcc_block_free(block, bytes, false);
        }
        if (is_first)
            atomic_store_explicit(&is_given, true, memory_order_relaxed);
    }
    assert_int_equal(wrong, 0);
}

static void what_cannot_be_had(void **unused) {
    (void)unused;
    size_t bytes = SIZE_MAX / 2;
    assert_null(redcc_block_alloc(&bytes, false));
    bytes = SIZE_MAX / 2;
    assert_null(redcc_block_alloc(&bytes, true));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(blocks_do_not_overlap),       cmocka_unit_test(blocks_of_several_threads),
        cmocka_unit_test(the_place_of_another_thread), cmocka_unit_test(blocks_of_a_child),
        cmocka_unit_test(what_cannot_be_had),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
