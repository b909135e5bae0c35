/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "reuse/reading.h"

#include "reuse/pages/watch.h"

struct reading redcc_reading_of(const redcc_loop *loop, const struct range *sources,
                                uint32_t source) {
    const struct range it = sources[source];
    for (uint32_t s = 0; s < source; s++) {
        const struct range shown = sources[s];
        struct range rest = it;
        if (!loop->sources[s].is_subscript || !redcc_ranges_overlap(it, shown))
            continue;
        if (shown.first <= it.first)
            rest.first = shown.end < it.end ? shown.end : it.end;
        else if (shown.end >= it.end)
            rest.end = shown.first;
        else
            continue; /* on both sides something is left */
        return (struct reading){rest, s + 1, it.first - shown.first};
    }
    return (struct reading){it, 0, 0};
}

static struct fingerprint of_range(struct range range) {
    return redcc_fingerprint((const char *)range.first, redcc_range_bytes(range));
}

struct fingerprint redcc_reading_fingerprint(struct reading reading) {
    const struct fingerprint parts[2] = {of_range(reading.range),
                                         {{reading.beside, reading.distance}}};
    return redcc_fingerprint_join(parts, 2);
}

struct fingerprint redcc_reading_ends(struct reading reading) {
    const struct range pages = redcc_whole_pages(reading.range);
    if (redcc_range_empty(pages))
        return redcc_reading_fingerprint(reading);
    const struct fingerprint parts[2] = {of_range((struct range){reading.range.first, pages.first}),
                                         of_range((struct range){pages.end, reading.range.end})};
    return redcc_fingerprint_join(parts, 2);
}
