/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "reuse/reading.h"

#include "base/system.h"
#include "reuse/pages/watch.h"

#include <assert.h>
#include <stdatomic.h>

/* Removes the bytes of `shown` from *rest. Returns false, and removes nothing, if *rest contains
 * none of them, or if parts of *rest would remain on both sides. */
static bool leave_out(struct range *rest, struct range shown) {
    if (!redcc_ranges_overlap(*rest, shown))
        return false;
    if (shown.first <= rest->first)
        rest->first = shown.end < rest->end ? shown.end : rest->end;
    else if (shown.end >= rest->end)
        rest->end = shown.first;
    else
        return false;
    return true;
}

static struct range range_of(const redcc_extent *known, const struct range *sources, uint32_t s) {
    return sources ? sources[s] : redcc_range_of(known[s]);
}

struct reading redcc_reading_of(const redcc_loop *loop, const redcc_extent *known,
                                const struct range *sources, uint32_t source) {
    assert(source < loop->source_count);
    const struct range it = range_of(known, sources, source);
    const bool has_gaps = known[source].end == NULL;
    struct range rest = it;
    for (uint32_t s = 0; s < source; s++) {
        const struct range shown = range_of(known, sources, s);
        if ((loop->sources[s].flags & REDCC_IS_SUBSCRIPT) && leave_out(&rest, shown))
            return (struct reading){rest, has_gaps, s + 1, it.first - shown.first};
    }
    return (struct reading){rest, has_gaps, 0, 0};
}

/* Can the whole range be read without a fault, and is it ordinary memory? The system populates the
 * pages as a read would, and reports whether it succeeded (Linux 5.14 and later, madvise(2)). */
static bool is_readable(struct range range) {
#if defined(__linux__)
    enum { POPULATE_READ = 22 };
    const uintptr_t page = redcc_page_size(), first = range.first / page * page;
    const uintptr_t bytes = (range.end - first + page - 1) / page * page;
    return redcc_system(SYS_madvise, first, bytes, POPULATE_READ) == 0;
#else
    (void)range;
    return false;
#endif
}

static struct fingerprint unlike_any(void) {
    static atomic_ullong given;
    return (struct fingerprint){{atomic_fetch_add(&given, 1), redcc_fingerprint(NULL, 0).word[1]}};
}

struct fingerprint redcc_part_fingerprint(const struct reading *reading, struct range range) {
    const bool is_empty = redcc_range_empty(range);
    if (reading->has_gaps && !is_empty && !is_readable(range))
        return unlike_any();
    return redcc_fingerprint((const char *)range.first, redcc_range_bytes(range));
}

struct fingerprint redcc_reading_fingerprint(struct reading reading) {
    const struct fingerprint parts[2] = {redcc_part_fingerprint(&reading, reading.range),
                                         {{reading.beside, reading.distance}}};
    return redcc_fingerprint_join(parts, 2);
}

struct fingerprint redcc_reading_ends(struct reading reading) {
    const struct range pages = redcc_whole_pages(reading.range);
    if (redcc_range_empty(pages))
        return redcc_reading_fingerprint(reading);
    const struct range before = {reading.range.first, pages.first};
    const struct range behind = {pages.end, reading.range.end};
    const struct fingerprint parts[2] = {redcc_part_fingerprint(&reading, before),
                                         redcc_part_fingerprint(&reading, behind)};
    return redcc_fingerprint_join(parts, 2);
}
