/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Write tracking must detect every way of changing subscripts. */
#define _GNU_SOURCE /* mremap, process_vm_writev */
#include "watched.h"

#include "reuse/pages/watch.h"
#include "reuse/pages/written_pages.h"

#include <fcntl.h>
#include <pthread.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmocka.h>

/* Ways of changing subscripts. */

static void by_a_store_at_the_begin(struct fixture *fixture) {
    fixture->problem.row[0] = other(fixture);
}

static void by_a_store_at_the_end(struct fixture *fixture) {
    fixture->problem.row[TRIP - 1] = other(fixture);
}

static void by_memset(struct fixture *fixture) {
    memset(fixture->problem.row + AT, 0, 50000);
}

static void by_memcpy(struct fixture *fixture) {
    memcpy(fixture->problem.row + AT, fixture->problem.row, 60000);
}

static void by_read(struct fixture *fixture) {
    const int value = other(fixture);
    int ends[2];
    assert_int_equal(pipe(ends), 0);
    assert_int_equal(write(ends[1], &value, sizeof value), sizeof value);
    assert_int_equal(read(ends[0], &fixture->problem.row[AT], sizeof value), sizeof value);
    close(ends[0]);
    close(ends[1]);
}

static void by_pread(struct fixture *fixture) {
    const int value = other(fixture);
    FILE *file = tmpfile();
    assert_non_null(file);
    assert_int_equal(pwrite(fileno(file), &value, sizeof value, 0), sizeof value);
    assert_int_equal(pread(fileno(file), &fixture->problem.row[AT], sizeof value, 0), sizeof value);
    fclose(file);
}

static void by_its_own_memory_file(struct fixture *fixture) {
    const int value = other(fixture), memory = open("/proc/self/mem", O_RDWR | O_CLOEXEC);
    const off_t at = (off_t)(uintptr_t)&fixture->problem.row[AT];
    if (memory < 0 || pwrite(memory, &value, sizeof value, at) != sizeof value) {
        print_message("/proc/self/mem cannot be written: a store in its place\n");
        by_a_store(fixture);
    }
    close(memory);
}

static void by_receiving(struct fixture *fixture) {
    const int value = other(fixture);
    int ends[2];
    assert_int_equal(socketpair(AF_UNIX, SOCK_STREAM, 0, ends), 0);
    assert_int_equal(send(ends[1], &value, sizeof value, 0), sizeof value);
    assert_int_equal(recv(ends[0], &fixture->problem.row[AT], sizeof value, 0), sizeof value);
    close(ends[0]);
    close(ends[1]);
}

static void *store_in_thread(void *fixture) {
    by_a_store(fixture);
    return NULL;
}

static void by_another_thread(struct fixture *fixture) {
    pthread_t thread;
    assert_int_equal(pthread_create(&thread, NULL, store_in_thread, fixture), 0);
    pthread_join(thread, NULL);
}

static void by_a_child_from_outside(struct fixture *fixture) {
    int value = other(fixture);
    const pid_t parent = getpid(), child = fork();
    if (child == 0) {
        const struct iovec from = {&value, sizeof value};
        const struct iovec to = {&fixture->problem.row[AT], sizeof value};
        _exit(process_vm_writev(parent, &from, 1, &to, 1, 0) != sizeof value);
    }
    int status;
    waitpid(child, &status, 0);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
        print_message("process_vm_writev is not allowed: a store in its place\n");
        by_a_store(fixture);
    }
}

static void by_a_vfork_child(struct fixture *fixture) {
    volatile int *subscript = &fixture->problem.row[AT];
    const int before = *subscript;
    const pid_t child = vfork();
    if (child == 0) {
        *subscript = (before + 1) % ROWS;
        _exit(0);
    }
    waitpid(child, NULL, 0);
    if (*subscript == before) /* ThreadSanitizer replaces vfork by fork */
        by_a_store(fixture);
}

static char *page_in_the_middle(const struct fixture *fixture) {
    return (char *)((uintptr_t)&fixture->problem.row[AT] / 4096 * 4096);
}

static void by_dropping_a_page(struct fixture *fixture) {
    assert_int_equal(madvise(page_in_the_middle(fixture), 4096, MADV_DONTNEED), 0);
}

/* Drops all pages, perhaps whole page tables at once. */
static void by_dropping_all(struct fixture *fixture) {
    assert_int_equal(madvise(fixture->place, fixture->place_bytes, MADV_DONTNEED), 0);
}

static void by_mapping_over_the_middle(struct fixture *fixture) {
    assert_ptr_not_equal(mmap(page_in_the_middle(fixture), 8192, PROT_READ | PROT_WRITE,
                              MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED, -1, 0),
                         MAP_FAILED);
}

static void by_mapping_all_anew(struct fixture *fixture) {
    munmap(fixture->place, fixture->place_bytes);
    assert_ptr_equal(mmap(fixture->place, fixture->place_bytes, PROT_READ | PROT_WRITE,
                          MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED, -1, 0),
                     fixture->place);
    fill(fixture->problem.row, 4711);
}

static void by_mapping_a_file(struct fixture *fixture) {
    FILE *file = tmpfile();
    assert_non_null(file);
    static const char zeros[8192];
    assert_int_equal(fwrite(zeros, 1, sizeof zeros, file), sizeof zeros);
    fflush(file);
    assert_ptr_not_equal(mmap(page_in_the_middle(fixture), sizeof zeros, PROT_READ,
                              MAP_PRIVATE | MAP_FIXED, fileno(file), 0),
                         MAP_FAILED);
    fclose(file);
}

/* Moves other tracked, unwritten pages to the subscripts' address. */
static void by_moving_watched_pages_here(struct fixture *fixture) {
    const size_t bytes = fixture->place_bytes;
    char *elsewhere = map_pages(bytes);
    memcpy(elsewhere, fixture->place, bytes);
    fill((int *)(void *)(elsewhere + 400), 4711);
    const uint64_t version =
        redcc_watch_begin((struct range){(uintptr_t)elsewhere, (uintptr_t)elsewhere + bytes});
    assert_true(version > 0);
    assert_ptr_equal(mremap(elsewhere, bytes, bytes, MREMAP_MAYMOVE | MREMAP_FIXED, fixture->place),
                     fixture->place);
}

/* Moves pages as by_moving_watched_pages_here does. Then other pages of the mapping are tracked,
 * which registers the mapping with the system again. */
static void by_moving_and_watching_beside(struct fixture *fixture) {
    by_moving_watched_pages_here(fixture);
    const uintptr_t end = (uintptr_t)fixture->place + fixture->place_bytes;
    assert_true(redcc_watch_begin((struct range){end - (1 << 20), end}) > 0);
}

static void by_writing_while_unprotected_once_more(struct fixture *fixture) {
    assert_int_equal(mprotect(fixture->place, fixture->place_bytes, PROT_READ), 0);
    assert_int_equal(mprotect(fixture->place, fixture->place_bytes, PROT_READ | PROT_WRITE), 0);
    by_a_store(fixture);
}

/* Another loop tracks the written page again, or a range that overlaps it, which clears the record
 * of writes. */
static void and_another_watches_the_range(struct fixture *fixture) {
    by_a_store(fixture);
    assert_true(redcc_watch_begin(rows_of(fixture)) > 0);
}

static void and_another_watches_a_part(struct fixture *fixture) {
    by_a_store(fixture);
    const uintptr_t first = (uintptr_t)page_in_the_middle(fixture) - 8192;
    assert_true(redcc_watch_begin((struct range){first, first + 65536}) > 0);
}

static void by_forking_and_storing(struct fixture *fixture) {
    const pid_t child = fork();
    if (child == 0)
        _exit(0);
    by_a_store(fixture); /* while the pages are shared with the child, or afterwards */
    waitpid(child, NULL, 0);
}

static const struct way_of_writing {
    const char *name;
    void (*change)(struct fixture *);
} ways[] = {
    {"a store", by_a_store},
    {"a store at the begin", by_a_store_at_the_begin},
    {"a store at the end", by_a_store_at_the_end},
    {"stores all over", by_stores_all_over},
    {"memset", by_memset},
    {"memcpy", by_memcpy},
    {"read", by_read},
    {"pread", by_pread},
    {"/proc/self/mem", by_its_own_memory_file},
    {"recv", by_receiving},
    {"another thread", by_another_thread},
    {"a child from outside", by_a_child_from_outside},
    {"a vfork child", by_a_vfork_child},
    {"dropping a page", by_dropping_a_page},
    {"dropping all", by_dropping_all},
    {"mapping over the middle", by_mapping_over_the_middle},
    {"mapping all anew", by_mapping_all_anew},
    {"mapping a file", by_mapping_a_file},
    {"moving watched pages here", by_moving_watched_pages_here},
    {"moving, and watching beside", by_moving_and_watching_beside},
    {"mprotect", by_writing_while_unprotected_once_more},
    {"another watches the range", and_another_watches_the_range},
    {"another watches a part", and_another_watches_a_part},
    {"fork", by_forking_and_storing},
};

static void changes_are_noticed(void **unused) {
    (void)unused;
    need_watching();
    for (size_t way = 0; way < sizeof ways / sizeof *ways; way++) {
        struct fixture fixture;
        fixture_begin(&fixture);
        run_and_share(&fixture);
        ways[way].change(&fixture);
        run_right(&fixture);
        if (statistics_of(&fixture)->plans_built != 2)
            fail_msg("changed by %s: the plan is used again", ways[way].name);
        assert_false(run_right(&fixture) && sources_watched(&fixture) == 2);
        assert_int_equal(statistics_of(&fixture)->plans_built, 2);
        fixture_end(&fixture);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(changes_are_noticed)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
