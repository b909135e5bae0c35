/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Overlapping ranges of pages are tracked and changed at random, in many ways. If the registry
 * reports a range as untouched, its contents must equal the copy made at the beginning of its
 * version. */
#define _GNU_SOURCE /* mremap */
#include "reuse/pages/watch.h"
#include "watched.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmocka.h>

enum { PAGES = 1100, RANGES = 12, STEPS = 1500 }; /* slightly more than two page tables */

struct kept {
    struct range pages;
    uint64_t version; /* 0 if the range is not tracked */
    char *copy;
};

static char *place;
static size_t page;
static unsigned long state = 88172645463325252u;

static size_t draw(size_t below) {
    return next_random(&state) % below;
}

static void write_some(void) {
    const size_t at = draw(PAGES * page);
    place[at] = (char)(place[at] + 1);
}

static void write_many(void) {
    const size_t first = draw(PAGES), count = draw(PAGES - first) + 1;
    memset(place + first * page, (int)draw(100), count * page);
}

static void read_into(void) {
    int ends[2];
    assert_int_equal(pipe(ends), 0);
    assert_int_equal(write(ends[1], &state, sizeof state), sizeof state);
    const size_t at = draw(PAGES * page - sizeof state);
    assert_int_equal(read(ends[0], place + at, sizeof state), sizeof state);
    close(ends[0]);
    close(ends[1]);
}

static void drop(void) {
    const size_t first = draw(PAGES), count = draw(PAGES - first) + 1;
    assert_int_equal(madvise(place + first * page, count * page, MADV_DONTNEED), 0);
}

static void map_anew(void) {
    const bool all = draw(8) == 0;
    const size_t first = all ? 0 : draw(PAGES), count = all ? PAGES : draw(8) + 1;
    const size_t bytes = (first + count < PAGES ? count : PAGES - first) * page;
    assert_ptr_not_equal(mmap(place + first * page, bytes, PROT_READ | PROT_WRITE,
                              MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED, -1, 0),
                         MAP_FAILED);
}

/* Moves pages from one end of the memory to the other, and maps the old range again. */
static void move(void) {
    const size_t count = draw(16) + 1, from = draw(PAGES / 2 - count);
    const size_t to = PAGES / 2 + draw(PAGES / 2 - count);
    for (size_t p = 0; p < count; p++) { /* one by one, since they may lie in several mappings */
        char *const old = place + (from + p) * page;
        assert_ptr_not_equal(
            mremap(old, page, page, MREMAP_MAYMOVE | MREMAP_FIXED, place + (to + p) * page),
            MAP_FAILED);
        assert_ptr_not_equal(
            mmap(old, page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED, -1, 0),
            MAP_FAILED);
    }
}

static void protect_and_back(void) {
    assert_int_equal(mprotect(place, PAGES * page, PROT_READ), 0);
    assert_int_equal(mprotect(place, PAGES * page, PROT_READ | PROT_WRITE), 0);
}

static void share_with_child(void) {
    const pid_t child = fork();
    if (child == 0) {
        place[0]++;
        _exit(0);
    }
    write_some();
    waitpid(child, NULL, 0);
}

static void change(void) {
    static void (*const often[])(void) = {write_some, write_some, read_into, protect_and_back,
                                          drop,       map_anew,   move,      write_many};
    if (draw(400) == 0)
        share_with_child();
    else
        often[draw(sizeof often / sizeof *often)]();
}

/* Begins tracking of a random range. Every second range consists of whole quarters, so that some
 * ranges are equal. */
static void watch(struct kept *kept) {
    const size_t grain = draw(2) ? 1 : PAGES / 4, first = draw(PAGES / grain) * grain;
    const size_t count = (draw((PAGES - first) / grain) + 1) * grain;
    if (!kept->version || draw(2))
        kept->pages = (struct range){(uintptr_t)place + first * page,
                                     (uintptr_t)place + (first + count) * page};
    kept->version = redcc_watch_begin(kept->pages);
    memcpy(kept->copy, (const char *)kept->pages.first, redcc_range_bytes(kept->pages));
}

/* Returns whether the range is untouched. */
static bool check(struct kept *kept) {
    if (!kept->version || redcc_watch_ask(kept->pages, kept->version) != WATCH_UNTOUCHED)
        return false;
    assert_memory_equal(kept->copy, (const char *)kept->pages.first,
                        redcc_range_bytes(kept->pages));
    return true;
}

static void what_is_untouched_is_what_it_was(void **unused) {
    (void)unused;
    need_watching();
    page = (size_t)sysconf(_SC_PAGESIZE);
    place = map_pages(PAGES * page);
    memset(place, 1, PAGES * page);
    struct kept kept[RANGES] = {0};
    for (int i = 0; i < RANGES; i++)
        kept[i].copy = malloc(PAGES * page);
    long watched = 0, untouched = 0;
    for (int step = 0; step < STEPS; step++) {
        const int number = (int)draw(RANGES);
        watch(&kept[number]);
        watched += kept[number].version > 0;
        for (size_t changes = draw(3); changes > 0; changes--)
            change();
        /* not all ranges, because a query changes a range's version */
        untouched += check(&kept[draw(RANGES)]);
    }
    for (int i = 0; i < RANGES; i++)
        untouched += check(&kept[i]);
    assert_true(watched > STEPS / 20);
    assert_true(untouched > STEPS / 50);
    for (int i = 0; i < RANGES; i++)
        free(kept[i].copy);
    munmap(place, PAGES * page);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(what_is_untouched_is_what_it_was)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
