/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The expansions of redcc/parallel.h. Not for direct use. */
#ifndef REDCC_PARALLEL_STEPS_H
#define REDCC_PARALLEL_STEPS_H

#pragma GCC system_header
#include <redcc/entry.h>
#include <redcc/steps.h>
#ifndef REDCC_OFF
#pragma weak redcc_run
#endif

#if defined(__clang__)
#define REDCC_ONCE static __attribute__((__noinline__, __unused__))
#else
#define REDCC_ONCE static __attribute__((__noinline__, __noclone__, __unused__))
#endif

enum {
    REDCC_MOST_ARRAYS = 6,
    REDCC_MOST_ROWS = 16,   /* maximum number of rows that are open at once */
    REDCC_ROW_BYTES = 1024, /* maximum size of a row */
    REDCC_ROWS_BYTES = 2048 /* maximum size of all open rows together */
};

#ifdef __clang__
#define REDCC_UNROLLED_ROWS _Pragma("clang loop unroll(full)")
#else
#define REDCC_UNROLLED_ROWS _Pragma("GCC unroll 16")
#endif

/* ---- types ---- */

#define REDCC_TYPE_OF(type) REDCC_NUMBER_TYPE((type)0, sizeof(type))
#define REDCC_IS_TYPE(value, type) __builtin_types_compatible_p(__typeof__(value), type)
#ifdef __cplusplus
template <typename redcc_t, typename redcc_u> struct redcc_same {
    enum { is = 0 };
};
template <typename redcc_t> struct redcc_same<redcc_t, redcc_t> {
    enum { is = 1 };
};
#undef REDCC_IS_TYPE
#define REDCC_IS_TYPE(value, type) (redcc_same<__typeof__(value), type>::is)
#define REDCC_IS_COMPLEX(value, type) 0
#else
#define REDCC_IS_COMPLEX(value, type) REDCC_IS_TYPE(value, __complex__ type)
#endif
#define REDCC_IS_REAL(value)                                                                       \
    (REDCC_IS_TYPE(value, float) || REDCC_IS_TYPE(value, double) ||                                \
     REDCC_IS_TYPE(value, long double))
#define REDCC_IS_FLOATING(value)                                                                   \
    (REDCC_IS_REAL(value) || REDCC_IS_COMPLEX(value, float) || REDCC_IS_COMPLEX(value, double))
#define REDCC_IS_INTEGER(type) (!REDCC_IS_FLOATING((type)0))
/* Uses __real__, because it must compile for complex numbers as well. */
#define REDCC_IS_UNSIGNED(zero) (__real__((__typeof__(zero))-1) > 0)
#define REDCC_NUMBER_TYPE(zero, bytes)                                                             \
    (REDCC_IS_TYPE(zero, float)         ? REDCC_FLOAT                                              \
     : REDCC_IS_TYPE(zero, double)      ? REDCC_DOUBLE                                             \
     : REDCC_IS_TYPE(zero, long double) ? REDCC_LONG_DOUBLE                                        \
     : REDCC_IS_COMPLEX(zero, float)    ? REDCC_FLOAT_COMPLEX                                      \
     : REDCC_IS_COMPLEX(zero, double)   ? REDCC_DOUBLE_COMPLEX                                     \
     : (bytes) > 8                      ? REDCC_OTHER_TYPE                                         \
                                        : (redcc_type)(((bytes) == 1   ? REDCC_INT8                \
                                                        : (bytes) == 2 ? REDCC_INT16               \
                                                        : (bytes) == 4 ? REDCC_INT32               \
                                                                       : REDCC_INT64) +            \
                                  REDCC_IS_UNSIGNED(zero)))

/* ---- descriptions ---- */

typedef struct redcc_description {
    redcc_int trip;
    redcc_int first;
    int counts_only; /* only `trip` and `first` are needed */
    int gives_up;
    void **bases;
    redcc_extent *known;
    redcc_word *starts; /* for each source, its base address, which is a part of the key */
    redcc_word *extra;  /* the other values of the key (redcc_depends_on) */
} redcc_description;

REDCC_INLINE void redcc_describe_rows(redcc_description *it, redcc_u32 source, const void *start,
                                      redcc_int row, redcc_int count, redcc_size bytes) {
    redcc_size first;
    if (it->counts_only)
        return;
    first = (redcc_size)start + (redcc_size)row * bytes;
    it->starts[source] = (redcc_word)(redcc_size)start;
    it->known[source].first = count > 0 ? (const char *)first : (const char *)&it->trip;
    it->known[source].end =
        it->known[source].first + (count > 0 ? (redcc_size)count * bytes : (redcc_size)0);
}
REDCC_INLINE void redcc_describe_named(redcc_description *it, redcc_u32 source, const void *start) {
    if (it->counts_only)
        return;
    it->starts[source] = (redcc_word)(redcc_size)start;
    it->known[source].first = (const char *)start;
    it->known[source].end = 0;
}

/* ---- slices: each use has constant fields ---- */

typedef struct redcc_slice {
    redcc_probe *probe; /* not 0: the slice compares with known ranges */
    redcc_worker *worker;
    redcc_u32 sources; /* not 0: the slice reports only reads of the sources whose bits are set */
} redcc_slice;

REDCC_INLINE void redcc_slice_update(const redcc_slice *it, redcc_u32 array, const void *address,
                                     redcc_size bytes) {
    if (it->sources)
        return;
    if (it->probe)
        redcc_probe_touch(it->probe, it->worker, array, address, bytes);
    else
        redcc_touch_span(it->worker, array, (const char *)address, (const char *)address + bytes);
}
REDCC_INLINE void redcc_slice_update_row(const redcc_slice *it, redcc_u32 array,
                                         const void *address, const void *base, redcc_int row,
                                         redcc_size bytes) {
    if (it->sources)
        return;
    if (it->probe)
        redcc_probe_touch_row(it->probe, it->worker, array, base, row, bytes);
    else
        redcc_touch(it->worker, array, address, bytes);
}
REDCC_INLINE void redcc_slice_read(const redcc_slice *it, redcc_u32 source, const void *address,
                                   redcc_size bytes) {
    if (it->sources && !(it->sources >> source & 1))
        return;
    if (it->probe)
        redcc_probe_read(it->probe, it->worker, source, address, bytes);
    else
        redcc_read(it->worker, source, address, bytes);
}
REDCC_INLINE void redcc_slice_read_row(const redcc_slice *it, redcc_u32 source, const void *address,
                                       const void *base, redcc_int row, redcc_size bytes) {
    if (it->sources && !(it->sources >> source & 1))
        return;
    if (it->probe)
        redcc_probe_read_row(it->probe, it->worker, source, base, row, bytes);
    else
        redcc_read(it->worker, source, address, bytes);
}
REDCC_INLINE int redcc_slice_finished(const redcc_slice *it) {
    return !it->sources && (it->probe ? redcc_probe_is_over(it->probe) : !it->worker->last);
}
REDCC_INLINE int redcc_slice_outdated(const redcc_slice *it, redcc_u32 source) {
    return !it->sources &&
           (it->probe ? redcc_probe_is_over(it->probe) : redcc_is_over(it->worker, source));
}

/* ---- bodies ---- */

/** Mode of a body, a constant in each use. PLAIN: the body makes all updates. OWNED: it makes only
 * updates of elements that the thread owns. KEEPING: it pushes updates to bins. COPYING: it makes
 * updates on private copies. */
enum { REDCC_PLAIN = 0, REDCC_OWNED = 1, REDCC_KEEPING = 2, REDCC_COPYING = 3 };

/** The open rows (redcc_row), and memory for their values. Not part of redcc_body, because the
 * address of redcc_body must not escape: its fields shall stay in registers. */
typedef struct redcc_rows {
    redcc_kept_row kept[REDCC_MOST_ROWS];
    char values[REDCC_ROWS_BYTES] __attribute__((__aligned__(16)));
} redcc_rows;

typedef struct redcc_body {
    int mode;
    int count;       /* number of rows in rows->kept */
    redcc_size used; /* number of bytes in use of rows->values */
    redcc_rows *rows;
    redcc_worker *worker;
    const redcc_array *arrays;
    const redcc_stream *streams; /* the stream of each array; 0: updates are not pushed */
    const redcc_bins *bins;      /* the bins of each array */
    void *base[REDCC_MOST_ARRAYS];
    redcc_owner owner[REDCC_MOST_ARRAYS];
} redcc_body;

REDCC_INLINE int redcc_owns_at(const redcc_body *it, redcc_u32 array, const void *address) {
    const redcc_owner *owner = &it->owner[array];
    if (redcc_has(owner, address))
        return 1;
    return owner->hook && it->worker->call->calls->hooked(owner->hook, address);
}

/** The number of the row at `address`, counted from the array's base in rows of
 * streams[array].rows[0] bytes (a row may be a single element). */
REDCC_INLINE redcc_int redcc_number_of(const redcc_body *it, redcc_u32 array, const void *address) {
    return ((redcc_int)((redcc_size)address - (redcc_size)it->base[array])) /
           (redcc_int)it->streams[array].rows[0];
}

REDCC_INLINE int redcc_has_copy(const redcc_body *it, redcc_u32 array, const void *address) {
    const redcc_bins *bins = &it->bins[array];
    const redcc_int row = redcc_number_of(it, array, address);
    if (__builtin_expect((redcc_size)row - (redcc_size)bins->first < bins->span, 1))
        return 1;
    bins->calls->push_outside(bins->buffer, row);
    return 0;
}

REDCC_INLINE int redcc_is_mine(const redcc_body *it, redcc_u32 array, const void *address,
                               redcc_size bytes) {
    (void)bytes;
    if (it->mode == REDCC_COPYING)
        return redcc_has_copy(it, array, address);
    return it->mode == REDCC_PLAIN || redcc_owns_at(it, array, address);
}

REDCC_INLINE int redcc_is_concerned(const redcc_body *it, redcc_u32 array, const void *address,
                                    redcc_size bytes) {
    return it->mode != REDCC_OWNED || redcc_owns_part(&it->owner[array], address, bytes);
}

/** Sets values to the neutral element of the array's operator. For sums of doubles it is -0.0,
 * because x + -0.0 is x even if x is -0.0. */
REDCC_INLINE void redcc_fill_neutral(redcc_body *it, redcc_u32 array, void *values,
                                     redcc_size bytes) {
    const redcc_array *const is = &it->arrays[array];
    redcc_size i;
    if (is->operation == REDCC_SUM && is->type == REDCC_DOUBLE)
        for (i = 0; i < bytes / sizeof(double); i++)
            ((double *)values)[i] = -0.0;
    else
        it->worker->call->calls->fill(is, values, bytes);
}

/** Returns a scratch row of neutral elements. A later scratch row may use the same memory, unless
 * the row is in rows->kept. */
REDCC_INLINE void *redcc_neutral_row(redcc_body *it, redcc_u32 array, redcc_size bytes) {
    char *values;
    if (__builtin_expect(it->used + bytes > REDCC_ROWS_BYTES, 0))
        it->used = 0; /* rows that are not in rows->kept are never read, so they may share memory */
    values = it->rows->values + it->used;
    it->used += (bytes + 15) & ~(redcc_size)15;
    redcc_fill_neutral(it, array, values, bytes);
    return values;
}

/** Returns a scratch row in rows->kept, which redcc_rows_end applies to its array. */
REDCC_INLINE void *redcc_keep_row(redcc_body *it, redcc_u32 array, void *row, redcc_size bytes) {
    redcc_kept_row *kept;
    if (__builtin_expect(it->count == REDCC_MOST_ROWS || it->used + bytes > REDCC_ROWS_BYTES, 0))
        it->worker->call->calls->misuse(it->worker,
                                        "at most 16 rows, of 2048 bytes in all, are open at "
                                        "once: call redcc_rows_end");
    kept = &it->rows->kept[it->count++];
    kept->array = array;
    kept->bytes = (redcc_u32)bytes;
    kept->row = row;
    kept->values = redcc_neutral_row(it, array, bytes);
    return kept->values;
}

REDCC_INLINE void *redcc_row_of(redcc_body *it, redcc_u32 array, void *row, redcc_size bytes) {
    switch (it->mode) {
    case REDCC_PLAIN:
#if !defined(__clang__) /* else gcc recomputes &row[c] for each c: 8 % of the time of springs.c */
        __asm__("" : "+r"(row));
#endif
        return row;
    case REDCC_KEEPING:
        return redcc_keep_row(it, array, row, bytes);
    case REDCC_COPYING:
        return redcc_has_copy(it, array, row) ? row : redcc_neutral_row(it, array, bytes);
    default:
        if (__builtin_expect(it->owner[array].hook != 0, 0))
            return redcc_keep_row(it, array, row, bytes);
        return redcc_owns_at(it, array, row) ? row : redcc_neutral_row(it, array, bytes);
    }
}

REDCC_INLINE void redcc_push_number(const redcc_body *it, redcc_u32 array, const void *address,
                                    const void *record, redcc_size bytes) {
    if (bytes != it->streams[array].record)
        it->worker->call->calls->misuse(it->worker,
                                        "REDCC_KEPT names other bytes than are kept of an "
                                        "update");
    redcc_push(&it->bins[array], &it->streams[array], redcc_number_of(it, array, address), 0,
               record);
}

#ifdef __clang__ /* clang would warn where it does not unroll, for example with sanitizers */
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wpass-failed"
#endif
REDCC_INLINE void redcc_end_rows(redcc_body *it) {
    int n;
    if (it->mode == REDCC_KEEPING) {
        REDCC_UNROLLED_ROWS
        for (n = 0; n < it->count; n++)
            redcc_push_number(it, it->rows->kept[n].array, it->rows->kept[n].row,
                              it->rows->kept[n].values, it->rows->kept[n].bytes);
    } else if (it->mode == REDCC_OWNED && __builtin_expect(it->count > 0, 0)) {
        it->worker->call->calls->settle(it->worker, it->rows->kept, it->count);
    }
    it->count = 0;
    it->used = 0;
}
#ifdef __clang__
#pragma clang diagnostic pop
#endif

/* redcc_subtract pushes this value, whose addition has the same result as the subtraction of
 * `value`. -0.0 - value is -value and keeps the sign of a NaN; integers wrap around. `sum` has the
 * type in which the update is computed. */
#define REDCC_NEGATED(sum, value)                                                                  \
    (REDCC_IS_FLOATING(sum) ? (__typeof__(sum))((__typeof__(sum))-0.0 - (value))                   \
                            : (__typeof__(sum))(0 - (redcc_word)(value)))

/* Pushes an update's operand. It has the type in which the update is computed, if that type or the
 * element's is floating. Otherwise it has the element's type, in which integers wrap around to the
 * same result. */
#define REDCC_IS_WIDE(at, value) (REDCC_IS_FLOATING(*(at)) || REDCC_IS_FLOATING(*(at) + (value)))
#define REDCC_KEEP_UPDATE(it, array, redcc_at, value, record)                                      \
    do {                                                                                           \
        if (REDCC_IS_WIDE(redcc_at, value)) {                                                      \
            const __typeof__(*(redcc_at) + (value)) redcc_value =                                  \
                (__typeof__(*(redcc_at) + (value)))(record);                                       \
            redcc_push_number(it, array, redcc_at, &redcc_value, sizeof redcc_value);              \
        } else {                                                                                   \
            const __typeof__(*(redcc_at)) redcc_value = (__typeof__(*(redcc_at)))(record);         \
            redcc_push_number(it, array, redcc_at, &redcc_value, sizeof redcc_value);              \
        }                                                                                          \
    } while (0)

#define REDCC_UPDATE_BY(it, array, at, by, value, record)                                          \
    do {                                                                                           \
        __typeof__(&*(at)) const redcc_at = (at);                                                  \
        if ((it)->mode == REDCC_KEEPING)                                                           \
            REDCC_KEEP_UPDATE(it, array, redcc_at, value, record);                                 \
        else if (redcc_is_mine(it, array, redcc_at, sizeof *redcc_at))                             \
            *redcc_at by value;                                                                    \
    } while (0)

#define REDCC_REPLACE_IF(it, array, at, compare, value)                                            \
    do {                                                                                           \
        __typeof__(&*(at)) const redcc_at = (at);                                                  \
        const __typeof__(*(at) + (value)) redcc_wide = (value);                                    \
        if ((it)->mode == REDCC_KEEPING) {                                                         \
            const __typeof__(*(at)) redcc_value = (__typeof__(*(at)))redcc_wide;                   \
            redcc_push_number(it, array, redcc_at, &redcc_value, sizeof redcc_value);              \
        } else if (redcc_is_mine(it, array, redcc_at, sizeof *redcc_at) &&                         \
                   redcc_wide compare * redcc_at)                                                  \
            *redcc_at = (__typeof__(*(at)))redcc_wide;                                             \
    } while (0)

#endif
