/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Macros of the slice, the part of a loop's body that computes which addresses an iteration
 * touches. They record, probe or prefetch these addresses. loop.h includes this file.
 */
#ifndef REDCC_SLICE_H
#define REDCC_SLICE_H

#include <redcc/entry.h>
#include <redcc/prefetch.h>

/** Parameters of a slice. redcc__probe is 0 if addresses are recorded; redcc__worker is 0 if they
 * are prefetched. redcc__source_mask is 0 if all addresses are recorded; otherwise its bits select
 * the sources whose reads are recorded. In each use the compiler knows which parameters are 0, so
 * that it compiles the slice for each use separately. */
#define REDCC_SLICE REDCC_INLINE void
#define REDCC_SLICE_PARAMETERS                                                                     \
    redcc_probe *const redcc__probe __attribute__((__unused__)),                                   \
        redcc_worker *const redcc__worker __attribute__((__unused__)),                             \
        const redcc_u32 redcc__source_mask __attribute__((__unused__))
#define REDCC_SLICE_ARGUMENTS redcc__probe, redcc__recorder, redcc__source_mask
#define REDCC_SLICE_NAMES redcc__probe, redcc__worker, redcc__source_mask, redcc__by_calls

/** For long iterations (lanes.h): the slice is compiled once for all uses, and records and compares
 * addresses by function calls. Other slices are inlined in each use. */
#define REDCC_SLICE_ONCE static __attribute__((__noinline__, __unused__)) void
#define REDCC_BY_CALLS enum { redcc__by_calls = 1 };
enum { redcc__by_calls = 0 };

/** The iteration may update (_TOUCH) or read (_READ) `redcc_n` bytes at address `redcc_at`. */
#define REDCC_TOUCH(redcc_i, redcc_at, redcc_n)                                                    \
    redcc_slice_touch(REDCC_SLICE_NAMES, redcc_i, redcc_at, redcc_n)
#define REDCC_READ(redcc_i, redcc_at, redcc_n)                                                     \
    redcc_slice_read(REDCC_SLICE_NAMES, redcc_i, redcc_at, redcc_n)

/** Precedes a block that records the reads of one source: skips the block if that source is not
 * recorded. */
#define REDCC_IF_RECORDED(redcc_i) if (!redcc__source_mask || redcc__source_mask >> (redcc_i)&1)

/** As REDCC_TOUCH and REDCC_READ, for redcc_base[redcc_row]. redcc_base is the same in all
 * iterations, so the number redcc_row identifies the row. */
#define REDCC_TOUCH_ROW(redcc_i, redcc_base, redcc_row)                                            \
    redcc_slice_touch_row(REDCC_SLICE_NAMES, redcc_i, (const void *)&(redcc_base)[redcc_row],      \
                          (const void *)(redcc_base), (redcc_int)(redcc_row),                      \
                          sizeof((redcc_base)[redcc_row]))
#define REDCC_READ_ROW(redcc_i, redcc_base, redcc_row)                                             \
    redcc_slice_read_row(REDCC_SLICE_NAMES, redcc_i, (const void *)&(redcc_base)[redcc_row],       \
                         (const void *)(redcc_base), (redcc_int)(redcc_row),                       \
                         sizeof((redcc_base)[redcc_row]))

/** In a loop that needs a dry run: returns if the preceding update (OVER) or read (STALE) has ended
 * the dry run, or has left a fence. */
#define REDCC_RETURN_IF_OVER                                                                       \
    if (redcc__worker && !redcc__source_mask &&                                                    \
        (redcc__probe ? redcc_probe_is_over(redcc__probe) : !redcc__worker->last))                 \
        return;
#define REDCC_RETURN_IF_STALE(redcc_source)                                                        \
    if (redcc__worker && !redcc__source_mask &&                                                    \
        (redcc__probe ? redcc_probe_is_over(redcc__probe)                                          \
                      : redcc_is_over(redcc__worker, redcc_source)))                               \
        return;

/** The iteration leaves the loop. */
#define REDCC_LEAVE                                                                                \
    {                                                                                              \
        if (redcc__worker && !redcc__source_mask && redcc__probe)                                  \
            redcc__probe->outside = redcc__probe->strays = 1;                                      \
        else if (redcc__worker && !redcc__source_mask)                                             \
            redcc_iteration_leaves(redcc__worker);                                                 \
        return;                                                                                    \
    }

/** Iteration redcc_iteration leaves the loop, which has REDCC_CONTINUES. */
#define REDCC_END_AT(redcc_iteration)                                                              \
    {                                                                                              \
        if (redcc__worker && !redcc__source_mask && redcc__probe)                                  \
            redcc__probe->outside = redcc__probe->strays = 1;                                      \
        else if (redcc__worker && !redcc__source_mask)                                             \
            redcc_iteration_ends(redcc__worker, redcc_iteration);                                  \
        return;                                                                                    \
    }

/** Makes the owner of the row that is touched next the iteration's leader, which executes the whole
 * iteration (redcc/series.h). */
#define REDCC_LEADER                                                                               \
    if (redcc__probe)                                                                              \
        redcc__probe->preferred = 1;

/** The iteration may update all bytes from an address to before another. */
#define REDCC_TOUCH_SPAN(redcc_i, redcc_at, redcc_end)                                             \
    redcc_slice_touch_span(REDCC_SLICE_NAMES, redcc_i, redcc_at, redcc_end)

/** The addresses from the lowest to the highest that loops over rows touch. */
typedef struct redcc_hull {
    redcc_size first, end;
} redcc_hull;
#define REDCC_EMPTY_HULL                                                                           \
    { ~(redcc_size)0, 0 }

/** Does the hull suffice, without the addresses of all rows? Yes if touches are compared with a
 * single range, or logged in a dry run, whose guard compares ranges. */
#define REDCC_BY_HULL(redcc_i)                                                                     \
    (redcc__worker && !redcc__source_mask &&                                                       \
     (redcc__probe && redcc__probe->selects                                                        \
          ? redcc__probe->by_hull                                                                  \
          : !redcc__worker->window[redcc_i].map && (redcc__probe || redcc__worker->alike < 0)))
/** The step of a loop whose first and last rows have the extreme addresses. */
#define REDCC_NEXT_ROW(redcc_counter, redcc_last)                                                  \
    redcc_counter = redcc__by_hull && redcc_counter != (__typeof__(redcc_counter))(redcc_last)     \
                        ? (__typeof__(redcc_counter))(redcc_last)                                  \
                        : (__typeof__(redcc_counter))(redcc_counter + 1)
/** The step of a loop that reads the elements at its counter. If only reads are recorded, as one
 * range, the first and the last iteration suffice. */
#define REDCC_NEXT_READ(redcc_counter, redcc_end)                                                  \
    redcc_counter = !redcc__source_mask || redcc_counter == (__typeof__(redcc_counter))(redcc_end) \
                        ? (__typeof__(redcc_counter))(redcc_counter + 1)                           \
                        : (__typeof__(redcc_counter))(redcc_end)
/** As REDCC_TOUCH_SPAN, in a loop that steps by REDCC_NEXT_ROW: if the hull suffices, only extends
 * it. */
#define REDCC_TOUCH_PART(redcc_i, redcc_at, redcc_end)                                             \
    if (redcc__by_hull)                                                                            \
        redcc_hull_add(&redcc__hull_##redcc_i, redcc__probe, &redcc__worker->window[redcc_i],      \
                       redcc_at, redcc_end);                                                       \
    else                                                                                           \
        redcc_slice_touch_span(REDCC_SLICE_NAMES, redcc_i, redcc_at, redcc_end)
/** Follows the outermost loop that steps by REDCC_NEXT_ROW: records or compares the hull, if it is
 * not empty. */
#define REDCC_TOUCH_HULL(redcc_i)                                                                  \
    if (redcc__by_hull)                                                                            \
        redcc_slice_touch_hull(redcc__probe, redcc__worker, redcc_i, &redcc__hull_##redcc_i);

REDCC_INLINE void redcc_hull_add(redcc_hull *hull, redcc_probe *probe, const redcc_owner *window,
                                 const char *first, const char *end) {
    if (probe)
        redcc_probe_first(probe, window, first);
    hull->first = hull->first < (redcc_size)first ? hull->first : (redcc_size)first;
    hull->end = hull->end > (redcc_size)end ? hull->end : (redcc_size)end;
}
/* Does a part of the hull lie outside of the range? Not if the hull is empty. */
REDCC_INLINE int redcc_hull_leaves(const redcc_hull *hull, const redcc_owner *range) {
    return (hull->first < (redcc_size)range->first) |
           (hull->end > (redcc_size)range->first + range->size);
}
/* Compares without branches, so that compilers load the ranges once for all iterations. */
REDCC_INLINE void redcc_slice_touch_hull(redcc_probe *probe, redcc_worker *worker, redcc_u32 array,
                                         const redcc_hull *hull) {
    const redcc_owner *window = &worker->window[array];
    if (!probe) {
        if (hull->end)
            redcc_touch_span(worker, array, (const char *)hull->first, (const char *)hull->end);
        return;
    }
    probe->outside |= redcc_hull_leaves(hull, window);
    if (!probe->selects) {
        probe->inside |= hull->end != 0;
        return;
    }
    probe->inside |= (window->size > 0) & ((redcc_size)window->first < hull->end) &
                     (hull->first < (redcc_size)window->first + window->size);
    probe->strays |= redcc_hull_leaves(hull, &worker->owner[array]);
}

/* Handles a touch that is not certainly in the owned range: one outside of it, or any touch if the
 * owner has a map. Callers inline the common case. */
static __attribute__((__noinline__, __unused__)) void
redcc_inspect_outside(redcc_probe *probe, redcc_worker *worker, redcc_u32 array,
                      const void *address, redcc_size bytes) {
    if (probe)
        redcc_probe_touch(probe, worker, array, address, bytes);
    else
        redcc_touch(worker, array, address, bytes);
}
REDCC_INLINE void redcc_inspect_touch(redcc_probe *probe, redcc_worker *worker, redcc_u32 array,
                                      const void *address, redcc_size bytes) {
    const redcc_owner *window = &worker->window[array];
    int *const inside = probe ? &probe->inside : &worker->inside;
    if (window->map || redcc_leaves(window->first, window->size, address, bytes))
        redcc_inspect_outside(probe, worker, array, address, bytes);
    else if (!probe || bytes > 0)
        *inside = 1;
}
static __attribute__((__noinline__, __unused__)) void
redcc_inspect_read(redcc_probe *probe, redcc_worker *worker, redcc_u32 source, const void *address,
                   redcc_size bytes) {
    if (probe)
        redcc_probe_read(probe, worker, source, address, bytes);
    else
        redcc_read(worker, source, address, bytes);
}

REDCC_INLINE void redcc_slice_touch(redcc_probe *probe, redcc_worker *worker, redcc_u32 source_mask,
                                    int by_calls, redcc_u32 array, const void *address,
                                    redcc_size bytes) {
    if (source_mask)
        return;
    if (!worker)
        redcc_prefetch((const char *)address, bytes);
    else if (probe && !by_calls)
        redcc_probe_touch(probe, worker, array, address, bytes);
    else
        redcc_inspect_touch(probe, worker, array, address, bytes);
}

REDCC_INLINE void redcc_slice_read(redcc_probe *probe, redcc_worker *worker, redcc_u32 source_mask,
                                   int by_calls, redcc_u32 source, const void *address,
                                   redcc_size bytes) {
    if (source_mask && !(source_mask >> source & 1))
        return;
    if (!worker)
        redcc_prefetch((const char *)address, bytes);
    else if (by_calls)
        redcc_inspect_read(probe, worker, source, address, bytes);
    else if (probe)
        redcc_probe_read(probe, worker, source, address, bytes);
    else
        redcc_read(worker, source, address, bytes);
}

REDCC_INLINE void redcc_slice_touch_row(redcc_probe *probe, redcc_worker *worker,
                                        redcc_u32 source_mask, int by_calls, redcc_u32 array,
                                        const void *address, const void *base, redcc_int row,
                                        redcc_size bytes) {
    if (source_mask)
        return;
    if (!worker)
        redcc_prefetch((const char *)address, bytes);
    else if (probe && !by_calls)
        redcc_probe_touch_row(probe, worker, array, base, row, bytes);
    else
        redcc_inspect_touch(probe, worker, array, address, bytes);
}

REDCC_INLINE void redcc_slice_read_row(redcc_probe *probe, redcc_worker *worker,
                                       redcc_u32 source_mask, int by_calls, redcc_u32 source,
                                       const void *address, const void *base, redcc_int row,
                                       redcc_size bytes) {
    if (source_mask && !(source_mask >> source & 1))
        return;
    if (!worker)
        redcc_prefetch((const char *)address, bytes);
    else if (by_calls)
        redcc_inspect_read(probe, worker, source, address, bytes);
    else if (probe)
        redcc_probe_read_row(probe, worker, source, base, row, bytes);
    else
        redcc_read(worker, source, address, bytes);
}

REDCC_INLINE void redcc_slice_touch_span(redcc_probe *probe, redcc_worker *worker,
                                         redcc_u32 source_mask, int by_calls, redcc_u32 array,
                                         const char *first, const char *end) {
    (void)by_calls; /* not used: one call records a span */
    if (source_mask)
        return;
    if (!worker)
        redcc_prefetch((const char *)first, (redcc_size)(end - first));
    else if (probe)
        redcc_probe_touch(probe, worker, array, first, (redcc_size)(end - first));
    else
        redcc_touch_span(worker, array, first, end);
}

/** Inspects the blocks of iterations that are handed out. After redcc_is_settled, iterations are
 * only compared with known ranges, in a loop without calls and stores, so that compilers keep the
 * loop's invariants in registers. */
#define REDCC_INSPECT(redcc_call_of_slice)                                                         \
    while (redcc__worker->call->calls->inspect(redcc__worker)) {                                   \
        const redcc_u32 redcc__source_mask = 0;                                                    \
        for (redcc__k = redcc__worker->first; redcc__k < redcc__worker->last;                      \
             redcc__k += redcc__worker->stride) {                                                  \
            if (redcc_is_settled(redcc__worker)) {                                                 \
                const redcc_int redcc__from = redcc__k;                                            \
                const int redcc__dry = redcc__worker->alike < 0; /* may touch nothing */           \
                for (; redcc__k < redcc__worker->last; redcc__k++) {                               \
                    redcc_probe redcc__seen = {redcc__dry, 0, 0, 0, 0, 0, 0, 0};                   \
                    redcc_probe *const redcc__probe = &redcc__seen;                                \
                    redcc_call_of_slice;                                                           \
                    if (!redcc_is_alike(&redcc__seen))                                             \
                        break;                                                                     \
                }                                                                                  \
                redcc__worker->alike += redcc__k - redcc__from;                                    \
                if (redcc__k == redcc__worker->last)                                               \
                    break;                                                                         \
            }                                                                                      \
            {                                                                                      \
                redcc_probe *const redcc__probe = 0;                                               \
                redcc_call_of_slice;                                                               \
                redcc_iteration_done(redcc__worker);                                               \
            }                                                                                      \
        }                                                                                          \
    }

#endif
