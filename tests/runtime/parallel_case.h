/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* clang-format off */
/**
 * One loop of test_parallel.c: each iteration updates row i, and row OTHER(i), of an array. Define before including it:
 *     CASE        the loop's name
 *     TYPE        the type of the array's elements; OPERATION: of their updates; WIDTH: of a row
 *     BODY(r)     updates row number r of `a` by redcc/parallel.h, in iteration t
 *     PLAIN(r)    the same update in plain C
 * Defines test_CASE for cmocka.
 */
/* clang-format on */
#define PASTE_(a, b) a##b
#define PASTE(a, b) PASTE_(a, b)
#define OF_CASE(part) PASTE(CASE, part)

struct CASE {
    long step;
    int from;
    const int *subscript;
    TYPE (*array)[WIDTH];
};
static const redcc_array OF_CASE(_arrays)[] = {REDCC_ARRAY("array", OPERATION, TYPE, WIDTH)};
static const redcc_source OF_CASE(_sources)[] = {REDCC_SUBSCRIPTS("subscript")};
static const redcc_stream OF_CASE(_streams)[] = {REDCC_KEPT(A, TYPE, WIDTH)};

static inline void OF_CASE(_slice)(const redcc_slice *it, long t, const struct CASE *loop) {
    redcc_updates(it, A, loop->array, loop->subscript[t]);
    redcc_updates(it, A, loop->array, OTHER(loop->subscript[t]));
}

static inline void OF_CASE(_body)(redcc_body *it, long t, const struct CASE *loop) {
    TYPE(*a)[WIDTH] = redcc_base(it, A, loop->array);
    const int i = loop->subscript[t];
    BODY(i)
    BODY(OTHER(i))
}

static inline void OF_CASE(_describe)(redcc_description *it, const struct CASE *loop) {
    redcc_iterations(it, loop->from, (N - loop->from + loop->step - 1) / loop->step);
    redcc_updates_array(it, A, loop->array);
    redcc_reads_rows(it, S, loop->subscript, loop->from, N - loop->from);
    redcc_depends_on(it, 0, loop->step);
}

#define REDCC_LOOP CASE
#define REDCC_WHERE "test_parallel.c", __LINE__, "test_parallel"
#define REDCC_ARRAYS 1
#define REDCC_SOURCES 1
#define REDCC_KEYS 1
#define REDCC_COUNTER long
#define REDCC_STEP loop->step
#define REDCC_STREAMS
#include "redcc/define_loop.h"

static void PASTE(test_, CASE)(void **state) {
    static TYPE found[ROWS][WIDTH], expected[ROWS][WIDTH];
    (void)state;
    for (int r = 0; r < ROWS; r++)
        for (int c = 0; c < WIDTH; c++)
            found[r][c] = expected[r][c] = (TYPE)(r % 5 + 1);
    for (int call = 0; call < CALLS; call++) {
        const struct CASE loop = {1 + call % 2, call % 3, subscript, found};
        if (call % 3 == 0)
            change_subscripts();
        OF_CASE(_execute)(&loop);
        for (long t = loop.from; t < N; t += loop.step) {
            TYPE(*a)[WIDTH] = expected;
            const int i = subscript[t];
            PLAIN(i)
            PLAIN(OTHER(i))
        }
        assert_memory_equal(found, expected, sizeof found);
    }
}

#undef PASTE_
#undef PASTE
#undef OF_CASE
#undef CASE
#undef TYPE
#undef OPERATION
#undef WIDTH
#undef BODY
#undef PLAIN
