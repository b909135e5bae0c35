/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Ownership: for rows at any address, redcc_owns_part is compared with redcc_owns of each byte. */
#include <redcc/runtime.h>

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

enum { BYTES = 64, UNITS = BYTES };

static char memory[3 * BYTES];
static unsigned char map[UNITS];

static unsigned random_below(unsigned n) {
    static uint64_t state = 17;
    state = state * 6364136223846793005u + 1442695040888963407u;
    return (unsigned)(state >> 33) % n;
}

static bool owns_a_byte(const redcc_owner *owner, const char *at, redcc_size bytes) {
    for (redcc_size i = 0; i < bytes; i++)
        if (redcc_owns(owner, at + i))
            return true;
    return false;
}

static void check(const redcc_owner *owner) {
    for (redcc_size bytes = 1; bytes <= 40; bytes++)
        for (const char *at = memory; at + bytes <= memory + sizeof memory; at++)
            assert_int_equal(redcc_owns_part(owner, at, bytes), owns_a_byte(owner, at, bytes));
}

/* Checks the classes of iterations that touch a part of a row, or all of it, and whether they leave
 * a fence. */
static void check_class(const redcc_owner *owner) {
    const redcc_owner fence = {.first = memory + 3, .size = sizeof memory - 7};
    const redcc_worker worker = {.window = owner, .owner = &fence};
    for (redcc_size bytes = 1; bytes <= 3 * BYTES; bytes += 1 + bytes / 8)
        for (const char *at = memory; at + bytes <= memory + sizeof memory; at++) {
            redcc_probe by_address = {0, 0, 2, 0, 0, 0, 0, 0}, by_number = {0, 0, 2, 0, 0, 0, 0, 0};
            bool others = false;
            for (redcc_size i = 0; i < bytes; i++)
                others = others || !redcc_owns(owner, at + i);
            redcc_probe_touch(&by_address, &worker, 0, at, bytes);
            redcc_probe_touch_row(&by_number, &worker, 0, at, 0, bytes);
            const int class = (owns_a_byte(owner, at, bytes) ? REDCC_CLASS_OWN : 0) |
                              (others ? REDCC_CLASS_OTHERS : 0) |
                              (redcc_owns(owner, at) ? REDCC_CLASS_LEADS : 0);
            assert_int_equal(redcc_class_of(&by_address), class);
            assert_int_equal(redcc_class_of(&by_number), class);
            const bool strays = at < fence.first || at + bytes > fence.first + fence.size;
            assert_int_equal(by_address.strays, strays);
            assert_int_equal(by_number.strays, strays);
        }
}

static void a_range(void **state) {
    (void)state;
    for (redcc_size begin = 0; begin < BYTES; begin++)
        for (redcc_size size = 1; size <= BYTES; size++)
            check(&(redcc_owner){.first = memory + BYTES + begin, .size = size});
}

static void units_of_a_map(void **state) {
    (void)state;
    for (int round = 0; round < 300; round++) {
        const unsigned unit = 1 + random_below(24);
        for (int i = 0; i < UNITS; i++)
            map[i] = (unsigned char)random_below(3);
        const redcc_owner owner = {.first = memory + BYTES,
                                   .size = unit * (1 + random_below((unsigned)(BYTES / unit))),
                                   .map = map,
                                   .reciprocal = round % 2 && unit > 1 ? UINT64_MAX / unit + 1 : 0,
                                   .self = random_below(3),
                                   .unit = unit};
        check(&owner);
        check_class(&owner);
    }
}

/* If the owner is unknown, redcc_owns_part must answer that the thread may own the bytes. */
static void what_is_not_known(void **state) {
    (void)state;
    struct redcc_hook *const hook = (struct redcc_hook *)(void *)memory;
    assert_true(redcc_owns_part(&(redcc_owner){.hook = hook}, memory, 8));
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(a_range), cmocka_unit_test(units_of_a_map),
                                       cmocka_unit_test(what_is_not_known)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
