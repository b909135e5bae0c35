/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Arena, buffer, vector, map and source file. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

#include "support/arena.h"
#include "support/buffer.h"
#include "support/map.h"
#include "support/source.h"
#include "support/vector.h"

static void test_arena_is_zeroed_and_aligned(void **state) {
    (void)state;
    arena *a = arena_new();
    for (size_t size = 0; size < 40000; size = size * 2 + 1) {
        unsigned char *memory = arena_allocate(a, size);
        assert_int_equal((uintptr_t)memory % _Alignof(max_align_t), 0);
        for (size_t i = 0; i < size; i++)
            assert_int_equal(memory[i], 0);
        memset(memory, 0xff, size); /* must not be visible in later allocations */
    }
    assert_true(arena_used(a) > 40000);
    arena_free(a);
    arena_free(NULL);
}

static void test_arena_can_be_cleared(void **state) {
    (void)state;
    arena *a = arena_new();
    for (unsigned round = 0; round < 3; round++) {
        for (size_t size = 1; size < 200000; size *= 3) {
            unsigned char *memory = arena_allocate(a, size);
            for (size_t i = 0; i < size; i++)
                assert_int_equal(memory[i], 0);
            memset(memory, 0xff, size); /* must not be visible in the next round */
        }
        arena_clear(a);
        assert_int_equal(arena_used(a), 0);
    }
    arena_free(a);
    a = arena_new();
    arena_clear(a);
    arena_free(a);
}

static void test_arena_texts(void **state) {
    (void)state;
    arena *a = arena_new();
    assert_string_equal(arena_copy(a, "abcdef", 3), "abc");
    assert_string_equal(arena_string(a, ""), "");
    assert_string_equal(arena_format(a, "%s-%d", "x", 42), "x-42");
    char long_text[5000];
    memset(long_text, 'y', sizeof long_text - 1);
    long_text[sizeof long_text - 1] = 0;
    assert_string_equal(arena_format(a, "%s", long_text), long_text);
    arena_free(a);
}

static void test_buffer(void **state) {
    (void)state;
    buffer b = {0};
    buffer_append(&b, "", 0);
    assert_string_equal(b.data, "");
    for (int i = 0; i < 1000; i++)
        buffer_format(&b, "%d,", i % 10);
    assert_int_equal(b.length, 2000);
    buffer_byte(&b, 0);
    buffer_text(&b, "end");
    assert_int_equal(b.length, 2004);
    assert_int_equal(b.data[b.length], 0);
    assert_memory_equal(b.data + 1998, "9,\0end", 6);
    buffer_free(&b);
    assert_null(b.data);
    buffer_free(&b);
}

static void test_vector(void **state) {
    (void)state;
    arena *a = arena_new();
    VECTOR(int) numbers = {0};
    for (int i = 0; i < 1000; i++)
        VECTOR_PUSH(a, &numbers, i * i);
    assert_int_equal(numbers.count, 1000);
    for (int i = 0; i < 1000; i++)
        assert_int_equal(numbers.items[i], i * i);
    arena_free(a);
}

static void test_map(void **state) {
    (void)state;
    arena *a = arena_new();
    map *m = map_new(a);
    assert_null(map_get(m, "x", 1));
    for (uintptr_t i = 0; i < 5000; i++)
        *map_at(m, &i, sizeof i) = (void *)(i + 1);
    *map_at(m, "", 0) = m;
    for (uintptr_t i = 0; i < 5000; i++)
        assert_int_equal((uintptr_t)map_get(m, &i, sizeof i), i + 1);
    assert_ptr_equal(map_get(m, "", 0), m);
    assert_null(*map_at(m, "new", 3));
    assert_null(map_get(m, "ne", 2));
    arena_free(a);
}

static void expect_position(const source *s, uint32_t offset, unsigned line, unsigned column) {
    position p = source_position(s, offset);
    assert_int_equal(p.line, line);
    assert_int_equal(p.column, column);
}

static void test_positions(void **state) {
    (void)state;
    arena *a = arena_new();
    const char text[] = "ab\r\n\ncd";
    source *s = source_from_text(a, "x.c", text, sizeof text - 1);
    assert_string_equal(s->path, "x.c");
    assert_int_equal(s->length, 7);
    assert_int_equal(s->line_count, 3);
    expect_position(s, 0, 1, 1);
    expect_position(s, 3, 1, 4);
    expect_position(s, 4, 2, 1);
    expect_position(s, 5, 3, 1);
    expect_position(s, 7, 3, 3);
    source *empty = source_from_text(a, "e.c", "", 0);
    assert_int_equal(empty->line_count, 1);
    expect_position(empty, 0, 1, 1);
    arena_free(a);
}

static void test_reading_files(void **state) {
    (void)state;
    arena *a = arena_new();
    const char *message = NULL;
    assert_null(source_read(a, "/nowhere/at/all.c", &message));
    assert_non_null(strstr(message, "/nowhere/at/all.c: "));
    assert_null(source_read(a, "/", &message));
    assert_string_equal(message, "/: is a directory");
    char path[] = "/tmp/redcc-test-XXXXXX";
    int descriptor = mkstemp(path);
    assert_true(descriptor >= 0);
    const char bytes[] = "\xef\xbb\xbfint x;\0\r\n";
    assert_int_equal(write(descriptor, bytes, sizeof bytes - 1), sizeof bytes - 1);
    close(descriptor);
    source *s = source_read(a, path, &message);
    unlink(path);
    assert_non_null(s);
    assert_int_equal(s->length, sizeof bytes - 1);
    assert_memory_equal(s->text, bytes, sizeof bytes);
    arena_free(a);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_arena_is_zeroed_and_aligned),
        cmocka_unit_test(test_arena_can_be_cleared),
        cmocka_unit_test(test_arena_texts),
        cmocka_unit_test(test_buffer),
        cmocka_unit_test(test_vector),
        cmocka_unit_test(test_map),
        cmocka_unit_test(test_positions),
        cmocka_unit_test(test_reading_files),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
