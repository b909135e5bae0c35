/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "reuse/pages/watch.h"

#include "base/spin.h"
#include "reuse/pages/written_pages.h"

enum { WATCHED = 64 };

struct watched {
    struct range pages;
    uint64_t version; /* 0: the pages were written, or the slot is free */
    uint64_t last_use;
};

/* No thread waits for this lock. In a forked child of a process with several threads it may be held
 * forever. */
static struct spin lock;
static struct watched watched[WATCHED];
static uint64_t versions; /* the version assigned last */
static uint64_t uses;

static struct watched *find(struct range pages) {
    for (int i = 0; i < WATCHED; i++)
        if (watched[i].version && watched[i].pages.first == pages.first &&
            watched[i].pages.end == pages.end)
            return &watched[i];
    return NULL;
}

/* Returns the range's version if its pages are unmodified. Otherwise sets the version to 0 and
 * returns 0. */
static uint64_t version_of(struct watched *it) {
    if (!redcc_pages_untouched(it->pages))
        it->version = 0;
    else
        it->last_use = ++uses;
    return it->version;
}

/* Sets to 0 the versions of all ranges that were modified, and of those that overlap `pages`.
 * Called before `pages` are protected, because protecting pages clears the record of writes, and
 * registering a mapping makes remapped addresses valid again. */
static void settle_others(struct range pages) {
    for (int i = 0; i < WATCHED; i++) {
        if (redcc_ranges_overlap(watched[i].pages, pages))
            watched[i].version = 0;
        if (watched[i].version && !redcc_pages_untouched(watched[i].pages))
            watched[i].version = 0;
    }
}

static struct watched *place_for_one(void) {
    struct watched *oldest = &watched[0];
    for (int i = 0; i < WATCHED; i++) {
        if (!watched[i].version)
            return &watched[i];
        if (watched[i].last_use < oldest->last_use)
            oldest = &watched[i];
    }
    return oldest;
}

static bool begun(void) {
    if (redcc_pages_begun())
        return true;
    for (int i = 0; i < WATCHED; i++) /* in a child process, the parent's ranges are not tracked */
        watched[i].version = 0;
    return redcc_pages_begin();
}

static uint64_t begin(struct range pages) {
    struct watched *same = find(pages);
    if (same && version_of(same))
        return same->version;
    settle_others(pages);
    if (!redcc_pages_protect(pages))
        return 0;
    struct watched *it = place_for_one();
    *it = (struct watched){pages, ++versions, ++uses};
    return it->version;
}

uint64_t redcc_watch_begin(struct range pages) {
    if (!redcc_spin_try(&lock))
        return 0;
    const uint64_t version = begun() ? begin(pages) : 0;
    redcc_spin_unlock(&lock);
    return version;
}

uint64_t redcc_watch_share(struct range pages) {
    if (!redcc_spin_try(&lock))
        return 0;
    struct watched *it = redcc_pages_begun() ? find(pages) : NULL;
    const uint64_t version = it ? version_of(it) : 0;
    redcc_spin_unlock(&lock);
    return version;
}

enum watch_answer redcc_watch_ask(struct range pages, uint64_t version) {
    if (!redcc_spin_try(&lock))
        return WATCH_BUSY;
    struct watched *it = redcc_pages_begun() ? find(pages) : NULL;
    const bool same = it && it->version == version && version_of(it) == version;
    redcc_spin_unlock(&lock);
    return same ? WATCH_UNTOUCHED : WATCH_TOUCHED;
}
