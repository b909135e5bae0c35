/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Memory at several addresses: random mappings of a few objects, found by both ways of reading the
 * process's mappings. The test itself writes to each page that a loop would write to, and looks for
 * the change at the other pages. */
#define _GNU_SOURCE
#include "base/aliases.h"

#include "base/maps.h"
#include "base/system.h"

#include <linux/perf_event.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <sys/ipc.h>
#include <sys/mman.h>
#include <sys/shm.h>
#include <unistd.h>

#include <cmocka.h>

enum { PAGE = 4096, PAGES = 24, FILES = 2, RANGES = 3 };

static uint64_t state = 72;
static int draw(int below) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return (int)((state >> 33) % (uint64_t)below);
}

static char *area;
static int file[FILES];

static void map(int page, int pages, int flags, int descriptor, int offset) {
    void *const at = area + page * PAGE;
    assert_ptr_equal(mmap(at, (size_t)pages * PAGE, PROT_READ | PROT_WRITE, flags | MAP_FIXED,
                          descriptor, (off_t)offset * PAGE),
                     at);
}

/* Maps the objects at random, equally for equal seeds. Private mappings begin with the file's pages
 * again. */
static void map_at_random(uint64_t seed) {
    const uint64_t before = state;
    state = seed;
    map(0, PAGES, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    for (int count = 2 + draw(9); count > 0; count--) {
        const int pages = 1 + draw(4), page = draw(PAGES - pages);
        const int kind = draw(5);
        if (kind == 0)
            map(page, pages, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        else
            map(page, pages, kind == 1 ? MAP_PRIVATE : MAP_SHARED, file[draw(FILES)], draw(4));
    }
    state = before;
}

static bool is_in(const struct range *ranges, uint32_t count, int page) {
    const struct range whole = {(uintptr_t)area + (uintptr_t)(page * PAGE),
                                (uintptr_t)area + (uintptr_t)((page + 1) * PAGE)};
    for (uint32_t r = 0; r < count; r++)
        if (redcc_ranges_overlap(ranges[r], whole))
            return true;
    return false;
}

/* Does a write to one page change another page that is touched? */
static bool is_seen(struct touches touches, uint64_t seed) {
    for (int page = 0; page < PAGES; page++) {
        volatile char *const written = area + page * PAGE;
        if (!is_in(touches.written, touches.written_count, page))
            continue;
        map_at_random(seed);
        const char before = *written;
        for (int other = 0; other < PAGES; other++) {
            const volatile char *const there = area + other * PAGE;
            if (other == page || !(is_in(touches.written, touches.written_count, other) ||
                                   is_in(touches.read, touches.read_count, other)))
                continue;
            *written = 1;
            const char one = *there;
            *written = 2;
            const bool seen = one == 1 && *there == 2;
            *written = before;
            if (seen)
                return true;
        }
    }
    return false;
}

static struct range range_at_random(void) {
    const int pages = 1 + draw(5), page = draw(PAGES - pages);
    const uintptr_t first = (uintptr_t)area + (uintptr_t)(page * PAGE);
    return (struct range){first + (uintptr_t)draw(2), first + (uintptr_t)(pages * PAGE)};
}

static void random_mappings(void **unused) {
    (void)unused;
    int aliased = 0, apart = 0;
    for (int round = 0; round < 1200; round++) {
        struct range written[RANGES], read[RANGES];
        const struct touches touches = {written, (uint32_t)(1 + draw(RANGES)), read,
                                        (uint32_t)draw(RANGES + 1), NULL};
        for (int r = 0; r < RANGES; r++) {
            written[r] = draw(8) ? range_at_random() : redcc_nowhere;
            read[r] = range_at_random();
        }
        const uint64_t seed = (uint64_t)draw(INT32_MAX);
        map_at_random(seed);
        redcc_maps_by_text = false;
        const bool asked = redcc_may_be_aliased(touches);
        redcc_maps_by_text = true;
        const bool found = redcc_may_be_aliased(touches);
        const bool seen = is_seen(touches, seed);
        assert_int_equal(asked, found);
        assert_int_equal(found, seen);
        aliased += seen;
        apart += !seen;
    }
    redcc_maps_by_text = false;
    assert_true(aliased > 100 && apart > 100);
}

static bool touches_both(const void *a, const void *b, size_t bytes) {
    const struct range written = {(uintptr_t)a, (uintptr_t)a + bytes};
    const struct range read = {(uintptr_t)b, (uintptr_t)b + bytes};
    const struct touches reads = {&written, 1, &read, 1, NULL},
                         writes = {&read, 1, &written, 1, NULL};
    const bool aliased = redcc_may_be_aliased(reads);
    assert_int_equal(aliased, redcc_may_be_aliased(writes));
    return aliased;
}

static void kinds_of_objects(void **unused) {
    (void)unused;
    map(0, PAGES, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    for (int way = 0; way < 2; way++) {
        redcc_maps_by_text = way == 1;
        const int access = PROT_READ | PROT_WRITE, shared = MAP_SHARED | MAP_ANONYMOUS;
        char *const one = mmap(NULL, 4 * PAGE, access, shared, -1, 0);
        char *const other = mmap(NULL, 4 * PAGE, access, shared, -1, 0);
        assert_false(touches_both(one, other, 4 * PAGE));
        assert_false(redcc_may_have_aliases());
        char *const copy = mremap(one, 0, 4 * PAGE, MREMAP_MAYMOVE);
        assert_true(touches_both(one, copy, 4 * PAGE));
        assert_false(touches_both(one, copy + 2 * PAGE, PAGE));
        assert_true(redcc_may_have_aliases());
        munmap(copy, 4 * PAGE);
        assert_false(redcc_may_have_aliases());
        const int segment = shmget(IPC_PRIVATE, 4 * PAGE, IPC_CREAT | 0600);
        assert_true(segment >= 0);
        char *const here = shmat(segment, NULL, 0), *const there = shmat(segment, NULL, 0);
        shmctl(segment, IPC_RMID, NULL);
        assert_true(touches_both(here, there, PAGE));
        assert_false(touches_both(here, one, PAGE));
        shmdt(there);
        assert_false(touches_both(here, one, PAGE));
        shmdt(here);
        munmap(one, 4 * PAGE);
        munmap(other, 4 * PAGE);
    }
    redcc_maps_by_text = false;
}

/* Pages of a device, whose driver defines what offsets mean. Skipped where perf events are not
 * permitted, as in most containers. */
static void device(void **unused) {
    (void)unused;
    struct perf_event_attr events = {.type = PERF_TYPE_SOFTWARE,
                                     .size = sizeof events,
                                     .config = PERF_COUNT_SW_DUMMY,
                                     .exclude_kernel = 1};
    const long counter = redcc_system(SYS_perf_event_open, &events, 0, -1, -1, 0);
    if (counter < 0)
        skip();
    char *const pages = mmap(NULL, 3 * PAGE, PROT_READ | PROT_WRITE, MAP_SHARED, (int)counter, 0);
    if (pages != MAP_FAILED)
        assert_true(touches_both(pages, pages + PAGE, PAGE));
    redcc_system_close((int)counter);
}

/* If a mapping has more pieces than the runtime stores, it counts as unknown. */
static void many_pieces(void **unused) {
    (void)unused;
    enum { MANY = 40 };
    char *const all =
        mmap(NULL, 2 * MANY * PAGE, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    const struct range written = {(uintptr_t)all, (uintptr_t)all + 2 * MANY * PAGE};
    const struct touches touches = {&written, 1, NULL, 0, NULL};
    assert_false(redcc_may_be_aliased(touches));
    for (int piece = 0; piece < MANY; piece++)
        mprotect(all + 2 * piece * PAGE, PAGE, PROT_NONE);
    assert_true(redcc_may_be_aliased(touches));
    munmap(all, 2 * MANY * PAGE);
}

static void tagged_addresses(void **unused) {
    (void)unused;
    const uintptr_t tag = (uintptr_t)1 << 57;
    assert_false(touches_both((char *)PAGE, (char *)(8 * PAGE), PAGE));
    assert_true(touches_both((char *)(PAGE + tag), (char *)(8 * PAGE), PAGE));
}

static void lines_of_the_text(void **unused) {
    (void)unused;
    struct mapping mapping;
    assert_true(redcc_maps_parse("7f1000-7f3000 rw-s 00005000 fd:01 77    /a b", &mapping));
    assert_true(mapping.place.first == 0x7f1000 && mapping.place.end == 0x7f3000);
    assert_true(mapping.is_writable && mapping.is_shared && mapping.offset == 0x5000);
    assert_true(mapping.object.device == (UINT64_C(0xfd) << 32 | 1) && mapping.object.inode == 77);
    assert_string_equal(mapping.name, "/a b");
    assert_true(redcc_maps_parse("1000-2000 r--p 00000000 00:00 0", &mapping));
    assert_true(!mapping.is_writable && !mapping.is_shared && mapping.name[0] == '\0');
    static const char *const bad[] = {"",
                                      "1000",
                                      "1000-2000",
                                      "1000-2000 r-",
                                      "1000-2000 r--x 0",
                                      "1000-2000 r--p 0 00 0",
                                      "1000-2000 r--p 0 00:00"};
    for (size_t b = 0; b < sizeof bad / sizeof *bad; b++)
        assert_false(redcc_maps_parse(bad[b], &mapping));
}

/* --price: prints the duration of a query with different numbers of mappings. */
static void print_prices(void) {
    static const int counts[] = {0, 200, 2000};
    const struct range written = {(uintptr_t)area, (uintptr_t)area + PAGES * PAGE};
    const struct touches touches = {&written, 1, NULL, 0, NULL};
    map(0, PAGES, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    for (int c = 0; c < 3; c++) {
        for (int made = 0; made < counts[c]; made++)
            mmap(NULL, PAGE, made % 2 ? PROT_READ : PROT_READ | PROT_WRITE, MAP_PRIVATE, file[0],
                 0);
        for (int way = 0; way < 2; way++) {
            enum { TIMES = 200 };
            redcc_maps_by_text = way == 1;
            const struct timespec before = redcc_system_clock(CLOCK_MONOTONIC);
            for (int time = 0; time < TIMES; time++)
                (void)redcc_may_be_aliased(touches);
            const struct timespec after = redcc_system_clock(CLOCK_MONOTONIC);
            const double seconds = (double)(after.tv_sec - before.tv_sec) +
                                   1e-9 * (double)(after.tv_nsec - before.tv_nsec);
            printf("%4d more mappings, %s: %.1f us\n", counts[c], way ? "text" : "questions",
                   1e6 * seconds / (int)TIMES);
        }
    }
}

int main(int argc, char **argv) {
    area = mmap(NULL, PAGES * PAGE, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    for (int f = 0; f < FILES; f++) {
        file[f] = memfd_create("object", 0);
        if (file[f] < 0 || ftruncate(file[f], 8 * PAGE) != 0)
            return 1;
    }
    if (argc > 1 && strcmp(argv[1], "--price") == 0) {
        print_prices();
        return 0;
    }
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_mappings),  cmocka_unit_test(kinds_of_objects),
        cmocka_unit_test(device),           cmocka_unit_test(many_pieces),
        cmocka_unit_test(tagged_addresses), cmocka_unit_test(lines_of_the_text)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
