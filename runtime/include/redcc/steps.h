/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Steps of a slice and a body, inlined in optimised builds: recording or comparing addresses,
 * checking owners, appending updates to bins. redcc/parallel.h and redcc/runtime.h include this
 * file.
 */
#ifndef REDCC_STEPS_H
#define REDCC_STEPS_H

#include <redcc/structures.h>

/** Without optimisation nothing is inlined. Inlined copies of unoptimised steps would make an
 * object ten times as large. They would take three times as long to compile, or seven times with
 * sanitizers. */
#ifdef __OPTIMIZE__
#define REDCC_INLINE                                                                               \
    static __inline__ __attribute__((__always_inline__, __unused__, __no_instrument_function__))
#else
#define REDCC_INLINE static __inline__ __attribute__((__unused__, __no_instrument_function__))
#endif

/* ---- owners ---- */

/** into / unit, computed by a multiplication if the compiler has a 128-bit type. The reciprocal is
 * m = floor((2^64 - 1) / unit) + 1, so m * unit exceeds 2^64 by less than `unit` or equals it.
 * Therefore the high half of m * into is the quotient while into * unit < 2^64. If the reciprocal
 * is 0, divides. */
REDCC_INLINE redcc_size redcc_quotient(redcc_size into, redcc_size unit, redcc_word reciprocal) {
#ifdef __SIZEOF_INT128__
    __extension__ typedef unsigned __int128 redcc__wide;
    if (reciprocal)
        return (redcc_size)((redcc__wide)into * reciprocal >> 64);
#endif
    return into / unit;
}

/** The number of the unit that contains the byte at offset `into` of a map. */
REDCC_INLINE redcc_size redcc_unit_number(const redcc_owner *owner, redcc_size into) {
    return redcc_quotient(into, owner->unit, owner->reciprocal);
}

/* Not inlined, because compiling a copy at each update would be slow. The fields are passed by
 * value, so that compilers can keep an owner without a map in registers. */
static __attribute__((__noinline__, __unused__)) int
redcc_is_mapped_to(const unsigned char *map, redcc_size into, redcc_size unit,
                   redcc_word reciprocal, unsigned self) {
    return map[redcc_quotient(into, unit, reciprocal)] == self;
}

/** Does the thread own the byte at `address`? Ignores the hook. */
REDCC_INLINE int redcc_has(const redcc_owner *owner, const void *address) {
    const redcc_size into = (redcc_size)((const char *)address - owner->first);
    return into < owner->size &&
           (!owner->map ||
            redcc_is_mapped_to(owner->map, into, owner->unit, owner->reciprocal, owner->self));
}

/* As redcc_mapped, for a range that spans several units or lies partly or completely outside of the
 * map. */
static __attribute__((__noinline__, __unused__)) unsigned
redcc_mapped_far(const redcc_owner *owner, redcc_size into, redcc_size bytes) {
    const redcc_size end = into + bytes; /* wraps around if the range begins before the map */
    const redcc_size from = into < owner->size ? into : 0;
    const redcc_size to = end < owner->size ? end : owner->size;
    unsigned seen = from != into || to != end ? REDCC_CLASS_OTHERS : 0;
    redcc_size unit, last;
    if (into >= owner->size && end - 1 >= bytes - 1)
        return REDCC_CLASS_OTHERS; /* completely before or after the map */
    last = redcc_unit_number(owner, to - 1);
    for (unit = redcc_unit_number(owner, from); unit <= last; unit++)
        seen |= owner->map[unit] == owner->self ? REDCC_CLASS_OWN : REDCC_CLASS_OTHERS;
    return seen;
}

/** Returns REDCC_CLASS_OWN if the thread owns any of the `bytes` > 0 bytes at offset `into` of its
 * map. Adds REDCC_CLASS_OTHERS if it does not own all of them. */
REDCC_INLINE unsigned redcc_mapped(const redcc_owner *owner, redcc_size into, redcc_size bytes) {
    if (into < owner->size) {
        const redcc_size unit = redcc_unit_number(owner, into);
        if (into + bytes <= (unit + 1) * owner->unit)
            return owner->map[unit] == owner->self ? REDCC_CLASS_OWN : REDCC_CLASS_OTHERS;
    }
    return redcc_mapped_far(owner, into, bytes);
}

/* ---- the inspector ---- */

/** Inspector: this iteration may update `bytes` bytes at `address` of array number `array`. */
static __inline__ void redcc_touch(redcc_worker *worker, redcc_u32 array, const void *address,
                                   redcc_size bytes) {
    const redcc_owner *window = &worker->window[array];
    const redcc_size into = (redcc_size)address - (redcc_size)window->first;
    redcc_entry *entry;
    if (into < window->size && bytes <= window->size - into) {
        worker->inside = 1;
        return;
    }
    worker->outside = 1;
    entry = worker->entry;
    entry->address = (const char *)address;
    entry->array = array;
    entry->bytes = (redcc_u32)bytes;
    worker->entry = entry + 1;
    if (worker->entry == worker->entry_end)
        worker->call->calls->flush(worker);
}

/** Inspector: this iteration may update the bytes from `first` to before `end`. */
static __inline__ void redcc_touch_span(redcc_worker *worker, redcc_u32 array, const char *first,
                                        const char *end) {
    for (; end - first > REDCC_LONGEST_TOUCH; first += REDCC_LONGEST_TOUCH)
        redcc_touch(worker, array, first, REDCC_LONGEST_TOUCH);
    redcc_touch(worker, array, first, (redcc_size)(end - first));
}

/** Inspector: this iteration may read `bytes` bytes at `address`, which belong to source number
 * `source`. Extends the thread's range of the source. */
static __inline__ void redcc_read(redcc_worker *worker, redcc_u32 source, const void *address,
                                  redcc_size bytes) {
    redcc_extent *extent = &worker->sources[source];
    const char *first = (const char *)address;
    if (first < extent->first || !extent->first)
        extent->first = first;
    if (first + bytes > extent->end)
        extent->end = first + bytes;
}

/** Inspector, in a dry run (worker->alike < 0): 1 if an earlier iteration updated an address that
 * is recorded as read from source number `source`. The dry run then ends, and the slice must not
 * use the value that it read. Without a dry run, 0. */
static __inline__ int redcc_is_over(redcc_worker *worker, redcc_u32 source) {
    const redcc_extent *recorded = &worker->sources[source];
    const redcc_owner *clear;
    redcc_size into;
    if (worker->alike >= 0)
        return 0;
    clear = &worker->owner[source];
    into = (redcc_size)recorded->first - (redcc_size)clear->first;
    return !(into < clear->size &&
             (redcc_size)(recorded->end - recorded->first) <= clear->size - into) &&
           worker->call->calls->is_stale(worker, source);
}

/** Inspector: this iteration leaves the loop. This ends a dry run (worker->alike < 0) before
 * anything is executed; without a dry run it must not happen. */
static __inline__ void redcc_iteration_leaves(redcc_worker *worker) {
    if (worker->alike < 0)
        worker->call->calls->is_stale(worker, REDCC_LEAVES);
}

/** As redcc_iteration_leaves, for iteration `k` of a loop with REDCC_CONTINUES. The iterations
 * before it may still be executed. */
static __inline__ void redcc_iteration_ends(redcc_worker *worker, redcc_int k) {
    if (worker->alike < 0) {
        worker->first = k;
        worker->call->calls->is_stale(worker, REDCC_ENDS);
    }
}

/** Inspector: the addresses of one iteration are complete. If all are in the owned range, only
 * counts the iteration. */
static __inline__ void redcc_iteration_done(redcc_worker *worker) {
    if (worker->inside && !worker->outside) {
        worker->inside = 0;
        worker->alike++;
        return;
    }
    worker->entry->address = 0;
    worker->entry->array = REDCC_END_OF_ITERATION;
    worker->entry->bytes = 0;
    worker->entry++;
    worker->outside = 0;
    worker->call->calls->flush(worker); /* the owned range may differ for the next iteration */
}

/** The probe of an iteration, which finds out whether it needs a record. inside: it touches an
 * element of the owned range. outside: it touches or reads something outside of the known ranges.
 * All fields are initially 0, except `selects` and `by_hull` for REDCC_SELECT. Then `outside` means
 * that the iteration touches an element outside of the owned range. */
typedef struct redcc_probe {
    int inside;
    int outside;
    int selects; /* not 0: for REDCC_SELECT; 2: also finds the leader. It is a constant in each use
                  */
    int preferred; /* the next row that the slice touches is preferred as the leading row */
    int rank;      /* rank of the leading row so far; 0: no row, 1: a row, 2: a preferred row */
    int leads;
    int strays;  /* REDCC_SELECT: the iteration leaves a fence */
    int by_hull; /* REDCC_SELECT: no owner has a map, so hulls suffice (slice.h); a constant */
} redcc_probe;

/** Finds the iteration's leader: the owner of the first byte of the first preferred row or, if no
 * row is preferred, of the first row. Thus all threads choose the same leader. */
static __inline__ void redcc_probe_first(redcc_probe *probe, const redcc_owner *window,
                                         const void *address) {
    const int rank = probe->preferred ? 2 : 1;
    probe->preferred = 0;
    if (probe->selects != 2 || probe->rank >= rank)
        return;
    probe->rank = rank;
    probe->leads = redcc_has(window, address);
}

/** For REDCC_SELECT with a map: finds whether this thread, others or both own the `bytes` > 0 bytes
 * at `address`. */
REDCC_INLINE void redcc_probe_mapped(redcc_probe *probe, const redcc_owner *window,
                                     const void *address, redcc_size bytes) {
    const unsigned seen =
        redcc_mapped(window, (redcc_size)address - (redcc_size)window->first, bytes);
    probe->inside |= (seen & REDCC_CLASS_OWN) != 0;
    probe->outside |= (seen & REDCC_CLASS_OTHERS) != 0;
}

/** True after REDCC_SETTLED consecutive iterations that touched only the current owner's range.
 * Then the next iterations are first probed, in order, by redcc_probe_touch and redcc_probe_read
 * (or by the variants for row numbers). Each iteration for which redcc_is_alike holds is counted in
 * worker->alike; the first one for which it does not hold is recorded. False if no owned range is
 * set or the stride is not 1. */
static __inline__ int redcc_is_settled(const redcc_worker *worker) {
    return worker->alike >= REDCC_SETTLED || worker->alike <= REDCC_DRY_PROBED;
}

/* In a loop that calls the functions below, compilers keep all arguments except `address` and `row`
 * in registers. */

/** Do the `bytes` bytes at `address` lie partly or completely outside of the `size` bytes at
 * `first`? */
static __inline__ int redcc_leaves(const char *first, redcc_size size, const void *address,
                                   redcc_size bytes) {
    const redcc_size places = bytes <= size ? size - bytes + 1 : 0; /* positions inside */
    return (redcc_size)address - (redcc_size)first >= places;
}

/** As redcc_leaves, for row number `row` of the rows at `base`, of `bytes` > 0 bytes each. */
static __inline__ int redcc_row_leaves(const char *first, redcc_size size, const void *base,
                                       redcc_int row, redcc_size bytes) {
    const __PTRDIFF_TYPE__ step = (__PTRDIFF_TYPE__)bytes;
    const __PTRDIFF_TYPE__ from = (__PTRDIFF_TYPE__)((redcc_size)first - (redcc_size)base);
    const __PTRDIFF_TYPE__ to = (__PTRDIFF_TYPE__)((redcc_size)first + size - (redcc_size)base);
    const __PTRDIFF_TYPE__ low = from / step + (from % step > 0); /* the first whole row */
    const __PTRDIFF_TYPE__ end = to / step - (to % step < 0);     /* one above the last whole row */
    return (redcc_size)row - (redcc_size)low >= (redcc_size)(end > low ? end - low : 0);
}

/** Do the `bytes` bytes at `address` intersect the `size` bytes at `first`? */
static __inline__ int redcc_intersects(const char *first, redcc_size size, const void *address,
                                       redcc_size bytes) {
    const redcc_size more = bytes - 1;
    const redcc_size ends = size ? size + more : 0; /* number of offsets from `first` at which
                                                     * the last of the `bytes` bytes may lie */
    return (redcc_size)address - (redcc_size)first + more < ends;
}

/* Sets `inside` and `outside` for REDCC_SELECT. Not inlined, because compiling a copy at each touch
 * would be slow. */
static __attribute__((__noinline__, __unused__)) void
redcc_select_touch(redcc_probe *probe, const redcc_worker *worker, redcc_u32 array,
                   const void *address, redcc_size bytes) {
    const redcc_owner *window = &worker->window[array], *fence = &worker->owner[array];
    if (bytes == 0)
        return;
    redcc_probe_first(probe, window, address);
    probe->strays |= redcc_leaves(fence->first, fence->size, address, bytes);
    if (window->map) {
        redcc_probe_mapped(probe, window, address, bytes);
        return;
    }
    probe->inside |= redcc_intersects(window->first, window->size, address, bytes);
    probe->outside |= redcc_leaves(window->first, window->size, address, bytes);
}

REDCC_INLINE void redcc_probe_touch(redcc_probe *probe, const redcc_worker *worker, redcc_u32 array,
                                    const void *address, redcc_size bytes) {
    const redcc_owner *window = &worker->window[array];
    if (probe->selects) {
        redcc_select_touch(probe, worker, array, address, bytes);
        return;
    }
    probe->inside |= bytes > 0; /* as in redcc_select_touch */
    probe->outside |= redcc_leaves(window->first, window->size, address, bytes);
}

REDCC_INLINE void redcc_probe_touch_row(redcc_probe *probe, const redcc_worker *worker,
                                        redcc_u32 array, const void *base, redcc_int row,
                                        redcc_size bytes) {
    const redcc_owner *window = &worker->window[array];
    if (probe->selects) {
        redcc_select_touch(probe, worker, array, (const char *)base + row * (redcc_int)bytes,
                           bytes);
        return;
    }
    probe->inside = 1;
    probe->outside |= redcc_row_leaves(window->first, window->size, base, row, bytes);
}

static __inline__ void redcc_probe_read(redcc_probe *probe, const redcc_worker *worker,
                                        redcc_u32 source, const void *address, redcc_size bytes) {
    const redcc_extent *known = &worker->sources[source];
    const redcc_size size = (redcc_size)known->end - (redcc_size)known->first;
    if (probe->selects)
        probe->strays |= bytes > 0 && redcc_leaves(known->first, size, address, bytes);
    else
        probe->outside |= redcc_leaves(known->first, size, address, bytes);
}

static __inline__ void redcc_probe_read_row(redcc_probe *probe, const redcc_worker *worker,
                                            redcc_u32 source, const void *base, redcc_int row,
                                            redcc_size bytes) {
    const redcc_extent *known = &worker->sources[source];
    if (probe->selects)
        redcc_probe_read(probe, worker, source, (const char *)base + row * (redcc_int)bytes, bytes);
    else
        probe->outside |= redcc_row_leaves(
            known->first, (redcc_size)known->end - (redcc_size)known->first, base, row, bytes);
}

/** Has the probed iteration touched or read something outside, so that its slice need not go on? */
static __inline__ int redcc_probe_is_over(const redcc_probe *probe) {
    return probe->strays || (probe->outside && !probe->selects);
}

/** Does the probed iteration need no record? */
static __inline__ int redcc_is_alike(const redcc_probe *probe) {
    return probe->inside && !probe->outside;
}

/** REDCC_SELECT: the class of the probed iteration. */
static __inline__ unsigned char redcc_class_of(const redcc_probe *probe) {
    return (unsigned char)((probe->inside ? REDCC_CLASS_OWN : 0) |
                           (probe->outside ? REDCC_CLASS_OTHERS : 0) |
                           (probe->leads ? REDCC_CLASS_LEADS : 0));
}

/** REDCC_SELECT: stores the classes of the iterations before `end`: all, or those before the first
 *  one that leaves a fence. */
static __inline__ void redcc_store_classes(redcc_worker *worker, const unsigned char *classes,
                                           redcc_int end) {
    worker->last = end;
    __builtin_memcpy((void *)worker->entry, classes, (redcc_size)(end - worker->first));
}

/** May this thread write any of the `bytes` bytes at `address`? If the owner has a hook, returns 1
 * without calling it. */
static __inline__ int redcc_owns_part(const redcc_owner *owner, const void *address,
                                      redcc_size bytes) {
    const redcc_size into = (redcc_size)((const char *)address - owner->first);
    if (owner->hook)
        return 1;
    if (owner->map)
        return (redcc_mapped(owner, into, bytes) & REDCC_CLASS_OWN) != 0;
    return into + bytes - 1 < owner->size + bytes - 1;
}

/* ---- bins ---- */

/** The smallest number of records that exactly fill cache lines, if a record has `bytes` bytes (an
 * even number): at most 32. It is 1 if records are empty. */
#define REDCC_LINE_RECORDS(bytes)                                                                  \
    ((bytes) == 0                                                                                  \
         ? 1u                                                                                      \
         : (redcc_u32)REDCC_CACHE_LINE / (((bytes) & (0u - (bytes))) > (redcc_u32)REDCC_CACHE_LINE \
                                              ? (redcc_u32)REDCC_CACHE_LINE                        \
                                              : ((bytes) & (0u - (bytes)))))

/** REDCC_LINES_BYTES: the size of the cache lines that REDCC_LINE_RECORDS(bytes) records fill.
 * REDCC_COMBINED_BYTES: the size of a bin's write-combining buffer, which has these lines and one
 * line of places. */
#define REDCC_LINES_BYTES(bytes) (REDCC_LINE_RECORDS(bytes) * (bytes))
#define REDCC_COMBINED_BYTES(bytes) (REDCC_LINES_BYTES(bytes) + (redcc_u32)REDCC_CACHE_LINE)

/** The two parts of a place: the row's number within the bin, and the number of the update. */
#define REDCC_PLACE_ROW(place, tag_bits) ((place) & ((1u << (REDCC_PLACE_BITS - (tag_bits))) - 1u))
#define REDCC_PLACE_TAG(place, tag_bits) ((place) >> (REDCC_PLACE_BITS - (tag_bits)))

/** For apply functions: prefetches the row of a later record. */
#define REDCC_APPLY_AHEAD(applied, k, row, tag_bits)                                               \
    do {                                                                                           \
        if ((applied)->ahead)                                                                      \
            __builtin_prefetch(                                                                    \
                &(row)[REDCC_PLACE_ROW((applied)->place[(k) + (applied)->ahead], tag_bits)]);      \
    } while (0)

/** Are the chunk's updates made on private copies, by redcc_update? If not, redcc_push records
 * them. The answer is the same for all streams, and is yes only if each stream is exact. */
#define REDCC_ARE_COPIED(bins) ((bins)->copy[0] != 0)

/** Writes `bytes` bytes, which are whole cache lines. Uses non-temporal stores on x86-64. */
REDCC_INLINE void redcc_write_lines(char *to, const char *from, redcc_size bytes) {
#if defined(__x86_64__) && defined(__SSE2__) && defined(__GNUC__)
    typedef double redcc_vector __attribute__((__vector_size__(16), __may_alias__));
    redcc_size done;
    for (done = 0; done < bytes; done += sizeof(redcc_vector))
        __asm__("movntdq %1, %0"
                : "=m"(*(redcc_vector *)(void *)(to + done))
                : "x"(*(const redcc_vector *)(const void *)(from + done)));
#else
    __builtin_memcpy(to, from, bytes);
#endif
}

/** Prefetches a cache line that is about to be written. */
REDCC_INLINE void redcc_prefetch_to_write(const void *address) {
#if defined(__x86_64__) && defined(__GNUC__)
    __asm__ volatile("prefetchw %0" : : "m"(*(const char *)address));
#else
    __builtin_prefetch(address, 1);
#endif
}

/** Replaces an update if REDCC_ARE_COPIED: immediately updates the thread's private copy. If the
 * copy does not contain the row, only records the row for the next attempt. */
REDCC_INLINE void redcc_update(const redcc_bins *bins, const redcc_stream *stream, redcc_int row,
                               redcc_u32 tag, const void *record) {
    const redcc_size into = (redcc_size)row - (redcc_size)bins->first;
    const redcc_u16 place = (redcc_u16)(tag << (REDCC_PLACE_BITS - stream->tag_bits));
    void *rows[REDCC_STREAM_ARRAYS];
    redcc_applied one;
    redcc_u32 array;
    if (__builtin_expect(into >= bins->span, 0)) {
        bins->calls->push_outside(bins->buffer, row);
        return;
    }
    for (array = 0; array < stream->array_count; array++)
        rows[array] = bins->copy[array] + into * stream->rows[array];
    one.rows = rows;
    one.place = &place;
    one.records = record;
    one.count = 1;
    one.ahead = 0;
    one.operands = bins->operands;
    stream->apply(&one);
}

/* Appends a record to the bin's write-combining buffer. Cache lines of the buffer are written to
 * memory once they are full. Returns the number of the bin's next record. */
REDCC_INLINE redcc_u32 redcc_push_combined(const redcc_bins *bins, redcc_size bin, redcc_u32 number,
                                           redcc_u16 place, const void *record, redcc_u32 bytes) {
    const redcc_u32 records = REDCC_LINE_RECORDS(bytes);
    char *const line = bins->lines + bin * REDCC_COMBINED_BYTES(bytes);
    redcc_u16 *const places = (redcc_u16 *)(void *)(line + REDCC_LINES_BYTES(bytes));
    if (bytes)
        __builtin_memcpy(line + (redcc_size)(number % records) * bytes, record, bytes);
    places[number % REDCC_LINE_PLACES] = place;
    number++;
    if (bytes && number % records == 0)
        redcc_write_lines(bins->records + (redcc_size)(number - records) * bytes, line,
                          REDCC_LINES_BYTES(bytes));
    if (number % REDCC_LINE_PLACES == 0)
        redcc_write_lines((char *)(bins->places + (number - REDCC_LINE_PLACES)),
                          (const char *)places, REDCC_CACHE_LINE);
    return number;
}

REDCC_INLINE redcc_u32 redcc_push_direct(const redcc_bins *bins, redcc_u32 number, redcc_u16 place,
                                         const void *record, redcc_u32 bytes) {
    char *const to = bins->records + (redcc_size)number * bytes;
    bins->places[number] = place;
    if (bytes) {
        __builtin_memcpy(to, record, bytes);
        redcc_prefetch_to_write(to + (redcc_size)REDCC_RECORDS_AHEAD * bytes);
    }
    return number + 1;
}

/**
 * Replaces an update: appends a record of update number `tag` of row number `row`, with the
 * operands *record (stream->record bytes). Rows are counted from the bases of the stream's arrays.
 * `stream` points directly into the loop's description, so that the compiler knows its fields.
 */
REDCC_INLINE void redcc_push(const redcc_bins *bins, const redcc_stream *stream, redcc_int row,
                             redcc_u32 tag, const void *record) {
    const redcc_size into = (redcc_size)row - (redcc_size)bins->first;
    redcc_size bin;
    redcc_u32 number;
    redcc_u16 place;
    if (__builtin_expect(into >= bins->span, 0)) {
        bins->calls->push_outside(bins->buffer, row);
        return;
    }
    bin = into >> bins->shift;
    place = (redcc_u16)(tag << (REDCC_PLACE_BITS - stream->tag_bits) |
                        (redcc_u32)(into - (bin << bins->shift)));
    number = bins->cursor[bin];
    number = bins->lines ? redcc_push_combined(bins, bin, number, place, record, stream->record)
                         : redcc_push_direct(bins, number, place, record, stream->record);
    if (__builtin_expect(number % REDCC_BLOCK_RECORDS == 0, 0))
        number = bins->calls->push_block(bins->buffer, bin, number);
    bins->cursor[bin] = number;
}

/** The address that row 0 of the array would have, if the private copy, which begins at row
 * bins->first, contained it. */
REDCC_INLINE void *redcc_copy_base(const redcc_bins *bins, const redcc_stream *stream,
                                   redcc_u32 part) {
    return (void *)((redcc_size)bins->copy[part] -
                    (redcc_size)bins->first * (redcc_size)stream->rows[part]);
}

/** REDCC_BINNED if the compiler always rounds contributions to their types, else 0. Records contain
 * rounded contributions. So without that rounding in the original loop, binning would change
 * results. */
#if (defined(__FLT_EVAL_METHOD__) && !REDCC_EVALUATES_IN_TYPE) ||                                  \
    (defined(__i386__) && !defined(__SSE2_MATH__))
#define REDCC_BINS_FLAG 0
#else
#define REDCC_BINS_FLAG REDCC_BINNED
#endif

#endif
