/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** redcc_run, the only function to which objects with loops of redcc/parallel.h refer. */
#include "redcc/entry.h"

#include "base/region.h"
#include "beginning.h"
#include "bins/binning.h"
#include "library.h"
#include "loop.h"
#include "operands.h"
#include "settings.h"
#include "slices.h"

#include <stdatomic.h>
#include <stdio.h>

/* State shared by the threads of one execution. */
struct shared {
    redcc_call call;
    const redcc_attempt *attempt;
    redcc_member *member;
    const void *context;
};

/* The number of threads that the loop's directive requests; without a request, OpenMP's number. */
static int threads_of(const redcc_loop *loop, const redcc_attempt *attempt) {
    enum { MOST = 4096 };
    if (!(loop->flags & REDCC_TEAM) || attempt->threads < 1)
        return redcc_region_threads();
    return attempt->threads < MOST ? attempt->threads : MOST;
}

static void work(int number, int threads, void *given) {
    struct shared *shared = given;
    redcc_worker worker;
    redcc_join(&worker, &shared->call, number, threads);
    shared->member(&worker, shared->attempt, shared->context);
}

static void say_other_version(redcc_u32 version) {
    static atomic_bool said;
    if (!atomic_exchange(&said, true))
        fprintf(stderr,
                "redcc: loops compiled for version %u of the interface run sequentially: this "
                "runtime has version %d\n",
                version, REDCC_INTERFACE);
}

static void prepare(redcc_site *site) {
    if (__atomic_load_n(&site->calls, __ATOMIC_ACQUIRE))
        return;
    /* If several threads call this at the same time, they all store the same value. */
    if (site->binned.loop.flags & REDCC_BINNED && !redcc_bins_can_apply(&site->binned))
        site->binned.loop.flags &= ~(unsigned)REDCC_BINNED;
    __atomic_store_n(&site->calls, &redcc_library, __ATOMIC_RELEASE);
}

#ifndef REDCC_HIDDEN
__attribute__((__visibility__("default")))
#endif
int redcc_run(redcc_u32 version, redcc_site *site, const redcc_attempt *attempt,
              redcc_member *member, const void *context) {
    if (version != REDCC_INTERFACE) {
        say_other_version(version);
        return 0;
    }
    prepare(site);
    if (!attempt)
        return 0;
    redcc_loop *loop = &site->binned.loop;
    if (loop->flags & REDCC_SHORT && !(loop->flags & REDCC_SECTIONED) &&
        !site->binned.is_unordered && !redcc_is_worth_entering(attempt->trip))
        return 0;
    const redcc_linkage *const linkage = attempt->linkage;
    const redcc_expectation *other;
    if (linkage && !redcc_are_linked(linkage, &other))
        return redcc_is_unlinked(loop, other);
    if (!redcc_operands_alloc_all(loop, attempt))
        return 0;
    /* Done even if the loop then runs sequentially. It may run so because a row was named for the
     * wrong array, which makes arrays appear to overlap. */
    if (redcc_settings()->validate && loop->flags & REDCC_BY_HAND)
        redcc_note_misnamed(loop, redcc_slices_check(site, attempt, member, context));
    struct beginning beginning;
    redcc_begin_in_order(&beginning, site, attempt, member, context, threads_of(loop, attempt));
    if (beginning.done == attempt->trip)
        return 1;
    const redcc_attempt *const rest = beginning.done ? &beginning.rest : attempt;
    struct shared shared = {.attempt = rest, .member = member, .context = context};
    const redcc_extent *const sections = loop->flags & REDCC_SECTIONED ? rest->sections : NULL;
    if (redcc_enter_sectioned(&shared.call, loop, rest->trip, rest->bases, rest->known, rest->key,
                              sections, threads_of(loop, rest), redcc_region_is_nested()))
        redcc_region_run(shared.call.threads, work, &shared);
    const int done = redcc_leave(&shared.call);
    if (!done) {
        if (!beginning.done) {
            redcc_operands_free_all(attempt);
            return 0;
        }
        redcc_end_in_order(site, attempt, member, context, beginning.done);
    }
    if (loop->flags & REDCC_CONTINUES && attempt->made)
        *attempt->made = shared.call.trip;
    redcc_sequential_done(loop);
    return done ? done : 1;
}
