/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Pages are write-protected through a userfault descriptor in asynchronous mode. The first write to
 * a page faults; the kernel then removes the page's mark (its write protection) and resumes the
 * write. PAGEMAP_SCAN finds pages without the mark.
 */
#define _GNU_SOURCE /* for F_DUPFD_CLOEXEC, MREMAP_FIXED and struct statx */
#include "reuse/pages/written_pages.h"

#include "base/system.h"
#include "reuse/pages/watch.h"

struct range redcc_whole_pages(struct range range) {
    const uintptr_t page = redcc_page_size();
    if (redcc_range_empty(range) || range.first > UINTPTR_MAX - page)
        return redcc_nowhere;
    const struct range whole = {(range.first + page - 1) / page * page, range.end / page * page};
    return redcc_range_empty(whole) ? redcc_nowhere : whole;
}

#if defined(__linux__) && !defined(REDCC_NO_PAGE_TRACKING)

#include "base/forked.h"
#include "base/mappings.h"
#include "reuse/pages/page_watch_abi.h"

#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>

/* A descriptor that this file has opened. The identity of the opened file is stored as well,
 * because the program may close any descriptor and open another file with the same number. */
struct opened {
    int descriptor;
    uint64_t device;
    uint64_t number;
};

static struct opened faults;  /* the userfault descriptor, by which pages are protected */
static struct opened pagemap; /* the descriptor by which pages are scanned for writes */

/* A byte that is 1 in this process; in a child process the system clears it. NULL: tracking was
 * never started. */
static volatile char *own_mark;

static bool look_at(struct opened *opened) {
    struct statx now;
    if (redcc_system(SYS_statx, opened->descriptor, "", AT_EMPTY_PATH, STATX_INO, &now) != 0)
        return false;
    opened->device = (uint64_t)now.stx_dev_major << 32 | now.stx_dev_minor;
    opened->number = now.stx_ino;
    return true;
}

static bool is_ours(const struct opened *opened) {
    struct opened now = {.descriptor = opened->descriptor};
    return look_at(&now) && now.device == opened->device && now.number == opened->number;
}

static int request_of(const struct opened *opened, unsigned long request, const void *argument) {
    return (int)redcc_system(SYS_ioctl, opened->descriptor, request, argument);
}

/* The lowest number for the descriptors that this file opens: the last two numbers of the current
 * descriptor table, or 512. If the process's limit is below that, half of the limit. Thus the
 * program continues to get low numbers. */
static int first_number(void) {
    struct rlimit limit;
    const int room = redcc_descriptor_room();
    const int from = room > 2 && room <= 1024 ? room - 2 : 512;
    return redcc_system(SYS_prlimit64, 0, RLIMIT_NOFILE, 0, &limit) == 0 &&
                   limit.rlim_cur < (unsigned)from + 2
               ? (int)limit.rlim_cur / 2
               : from;
}

/* Moves `descriptor` to a number of at least `from`, and stores it in *opened. */
static bool take(struct opened *opened, int descriptor, int from) {
    if (descriptor < 0)
        return false;
    opened->descriptor = (int)redcc_system(SYS_fcntl, descriptor, F_DUPFD_CLOEXEC, from);
    redcc_system_close(descriptor);
    return opened->descriptor >= 0 && look_at(opened);
}

static void close_opened(struct opened *opened) {
    if (opened->descriptor >= 0 && is_ours(opened))
        redcc_system_close(opened->descriptor);
    opened->descriptor = -1;
}

static bool open_both(void) {
    faults.descriptor = pagemap.descriptor = -1;
    struct watch_api api = {WATCH_API_VERSION, WATCH_FEATURE_ASYNC | WATCH_FEATURE_UNPOPULATED, 0};
    const int from = first_number();
    const int flags = O_CLOEXEC | O_NONBLOCK | WATCH_USER_MODE_ONLY;
    return take(&faults, (int)redcc_system(SYS_userfaultfd, flags), from) &&
           request_of(&faults, WATCH_IOCTL_API, &api) == 0 &&
           take(&pagemap, redcc_system_open("/proc/self/pagemap"), from);
}

/* Registers a mapping. Fails (EBUSY) if the program tracks the range by its own descriptor. */
static bool enter(struct range mapping) {
    struct watch_register request = {
        {mapping.first, mapping.end - mapping.first}, WATCH_REGISTER_WRITES, 0};
    return request_of(&faults, WATCH_IOCTL_REGISTER, &request) == 0;
}

static bool protect(struct range pages) {
    struct watch_protect request = {{pages.first, pages.end - pages.first}, WATCH_PROTECT};
    return request_of(&faults, WATCH_IOCTL_PROTECT, &request) == 0;
}

/* Are all pages marked and present? A page that is not present counts as written. The reason: if a
 * whole page table was dropped, for example by MADV_DONTNEED, kernels before July 2026 do not
 * report the write. */
static bool untouched(struct range pages) {
    struct watch_region found;
    struct watch_scan scan = {.size = sizeof scan,
                              .flags = WATCH_SCAN_ASYNC_ONLY,
                              .start = pages.first,
                              .end = pages.end,
                              .regions = (uintptr_t)&found,
                              .region_count = 1,
                              .most_pages = 1,
                              .inverted = WATCH_IS_PRESENT,
                              .any_of = WATCH_IS_WRITTEN | WATCH_IS_PRESENT,
                              .wanted = WATCH_IS_WRITTEN | WATCH_IS_PRESENT};
    return request_of(&pagemap, WATCH_IOCTL_SCAN, &scan) == 0 && scan.walk_end == pages.end;
}

enum { STORED, READ_INTO, DROPPED, MOVED, LEFT, TRIED, GOAL = TRIED, TRIAL_PAGES };

static struct range trial_page(const char *trial, int page) {
    const uintptr_t first = (uintptr_t)trial + (uintptr_t)page * redcc_page_size();
    return (struct range){first, first + redcc_page_size()};
}

/* Writes to test pages in each way that the system could overlook. */
static bool touch(char *trial) {
    const size_t page = redcc_page_size();
    const int in = redcc_system_open("/proc/self/stat");
    const bool was_read = in >= 0 && redcc_system_read(in, trial + READ_INTO * page, 8) == 8;
    if (in >= 0)
        redcc_system_close(in);
    ((volatile char *)trial)[STORED * page] = 2;
    char *const goal = trial + GOAL * page;
    return was_read &&
           redcc_system(SYS_madvise, trial + DROPPED * page, page, MADV_DONTNEED) == 0 &&
           redcc_system(SYS_mremap, trial + MOVED * page, page, page, MREMAP_MAYMOVE | MREMAP_FIXED,
                        goal) == (long)goal;
}

/* Tests that tracking works on this system as documented. For example, a page that was moved to
 * another address must not keep its mark, but in kernels before 6.12.11 it does. */
static bool passes_trial(char *trial) {
    for (int page = 0; page < TRIAL_PAGES; page++)
        ((volatile char *)trial)[(size_t)page * redcc_page_size()] = 1;
    const struct range tried = {(uintptr_t)trial, trial_page(trial, TRIED).first};
    if (!enter(tried) || !protect(tried))
        return false;
    for (int page = 0; page < TRIED; page++)
        if (!untouched(trial_page(trial, page)))
            return false;
    return untouched(tried) && touch(trial) && !untouched(trial_page(trial, STORED)) &&
           !untouched(trial_page(trial, READ_INTO)) && !untouched(trial_page(trial, DROPPED)) &&
           untouched(trial_page(trial, LEFT)) && !untouched(trial_page(trial, GOAL)) &&
           enter(trial_page(trial, GOAL)) && !untouched(trial_page(trial, GOAL));
}

static bool try_out(void) {
    const size_t bytes = TRIAL_PAGES * redcc_page_size();
    char *trial = redcc_system_map(bytes);
    if (!trial)
        return false;
    const bool passed = passes_trial(trial);
    redcc_system_unmap(trial, bytes);
    return passed;
}

/* Allocates the page that contains own_mark, if there is none. A child process finds this page
 * cleared, and uses it again. Returns false on failure. */
static bool make_mark(void) {
    if (!own_mark)
        own_mark = redcc_wiped_page();
    return own_mark != NULL;
}

/* Valgrind supports none of these system calls, and reports each of them. */
static bool is_under_valgrind(void) {
    const char *preloaded = getenv("LD_PRELOAD");
    return preloaded && strstr(preloaded, "vgpreload_");
}

static bool
    is_unavailable; /* an attempt has failed, and none follows in this process or its children */

bool redcc_pages_begun(void) {
    return own_mark && *own_mark == 1;
}

bool redcc_pages_begin(void) {
    if (is_unavailable)
        return false;
    if (own_mark) { /* in a child process: the parent's descriptors refer to the parent's memory */
        close_opened(&faults);
        close_opened(&pagemap);
    }
    is_unavailable = is_under_valgrind() || redcc_is_confined() || redcc_has_accelerator() ||
                     !make_mark() || !open_both() || !try_out();
    if (is_unavailable) {
        close_opened(&faults);
        close_opened(&pagemap);
    } else
        *own_mark = 1;
    return !is_unavailable;
}

bool redcc_pages_protect(struct range pages) {
    if (!is_ours(&faults) || !is_ours(&pagemap)) {
        is_unavailable = true;
        *own_mark = 0;
        return false;
    }
    struct mappings mappings;
    if (redcc_is_confined() || !redcc_may_watch(&mappings, pages, faults.descriptor))
        return false;
    for (int m = 0; m < mappings.count; m++) /* whole mappings, because the system would split a
                                                mapping of which only a part is registered */
        if (!enter(mappings.whole[m]))
            return false;
    return protect(pages);
}

bool redcc_pages_untouched(struct range pages) {
    return is_ours(&pagemap) && untouched(pages);
}

#else

bool redcc_pages_begun(void) {
    return false;
}

bool redcc_pages_begin(void) {
    return false;
}

bool redcc_pages_protect(struct range pages) {
    (void)pages;
    return false;
}

bool redcc_pages_untouched(struct range pages) {
    (void)pages;
    return false;
}

#endif
