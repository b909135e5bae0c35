/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Loops of redcc/parallel.h for several operators and types, by elements and by rows, are compared
 * with plain loops. Compiled without an OpenMP option. With the argument `exact` all sums and
 * products are exact, so that methods that change the order give the same values as well. */
#include "redcc/parallel.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

enum { N = 3000, ROWS = 701, CALLS = 4 };
enum { A };
enum { S };
static int subscript[N];
static int exact;

/* The other row, which is sometimes row i itself. */
#define OTHER(i) (((i) + 9) / 2)

static void change_subscripts(void) {
    static unsigned long long state = 7;
    for (int t = 0; t < N; t++) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        subscript[t] = (t / 5 + (int)(state >> 58)) % ROWS;
    }
}

/* The operand of iteration t. */
static double addend(long t) {
    return exact ? (double)(t % 13 - 6) : (double)(t % 1009 - 504) / 7.0;
}
static double factor(long t) {
    return exact ? (t % 2 ? 2.0 : 0.5) : 1.0 + (double)(t % 7 - 3) * 0.0625;
}

#define ADDEND ((TYPE)addend(t))
#define FACTOR ((TYPE)factor(t))
/* The last element is updated in every second iteration only. */
#define UPDATE_ROW(from, by, value)                                                                \
    {                                                                                              \
        TYPE *row = from;                                                                          \
        for (int c = 0; c < WIDTH - (int)(t % 2); c++)                                             \
            row[c] by value;                                                                       \
    }

#define CASE add_char
#define TYPE signed char
#define OPERATION REDCC_SUM
#define WIDTH 1
#define BODY(r) redcc_add(it, A, &a[r][0], ADDEND);
#define PLAIN(r) a[r][0] += ADDEND;
#include "parallel_case.h"

#define CASE add_ushort
#define TYPE unsigned short
#define OPERATION REDCC_SUM
#define WIDTH 1
#define BODY(r) redcc_add(it, A, &a[r][0], ADDEND);
#define PLAIN(r) a[r][0] += ADDEND;
#include "parallel_case.h"

#define CASE add_int
#define TYPE int
#define OPERATION REDCC_SUM
#define WIDTH 1
#define BODY(r) redcc_add(it, A, &a[r][0], ADDEND);
#define PLAIN(r) a[r][0] += ADDEND;
#include "parallel_case.h"

#define CASE add_ulong
#define TYPE unsigned long
#define OPERATION REDCC_SUM
#define WIDTH 1
#define BODY(r) redcc_add(it, A, &a[r][0], ADDEND);
#define PLAIN(r) a[r][0] += ADDEND;
#include "parallel_case.h"

#define CASE add_float
#define TYPE float
#define OPERATION REDCC_SUM
#define WIDTH 1
#define BODY(r) redcc_add(it, A, &a[r][0], ADDEND);
#define PLAIN(r) a[r][0] += ADDEND;
#include "parallel_case.h"

#define CASE add_double
#define TYPE double
#define OPERATION REDCC_SUM
#define WIDTH 1
#define BODY(r) redcc_add(it, A, &a[r][0], ADDEND);
#define PLAIN(r) a[r][0] += ADDEND;
#include "parallel_case.h"

#define CASE add_long_double
#define TYPE long double
#define OPERATION REDCC_SUM
#define WIDTH 1
#define BODY(r) redcc_add(it, A, &a[r][0], ADDEND);
#define PLAIN(r) a[r][0] += ADDEND;
#include "parallel_case.h"

#define CASE add_complex
#define TYPE __complex__ double
#define OPERATION REDCC_SUM
#define WIDTH 1
#define BODY(r) redcc_add(it, A, &a[r][0], ADDEND);
#define PLAIN(r) a[r][0] += ADDEND;
#include "parallel_case.h"

#define CASE subtract_int
#define TYPE int
#define OPERATION REDCC_SUM
#define WIDTH 1
#define BODY(r) redcc_subtract(it, A, &a[r][0], ADDEND);
#define PLAIN(r) a[r][0] -= ADDEND;
#include "parallel_case.h"

#define CASE subtract_double
#define TYPE double
#define OPERATION REDCC_SUM
#define WIDTH 1
#define BODY(r) redcc_subtract(it, A, &a[r][0], ADDEND);
#define PLAIN(r) a[r][0] -= ADDEND;
#include "parallel_case.h"

#define CASE multiply_uint
#define TYPE unsigned
#define OPERATION REDCC_PRODUCT
#define WIDTH 1
#define BODY(r) redcc_multiply(it, A, &a[r][0], ADDEND);
#define PLAIN(r) a[r][0] *= ADDEND;
#include "parallel_case.h"

#define CASE multiply_double
#define TYPE double
#define OPERATION REDCC_PRODUCT
#define WIDTH 1
#define BODY(r) redcc_multiply(it, A, &a[r][0], FACTOR);
#define PLAIN(r) a[r][0] *= FACTOR;
#include "parallel_case.h"

#define CASE and_uint
#define TYPE unsigned
#define OPERATION REDCC_AND
#define WIDTH 1
#define BODY(r) redcc_and(it, A, &a[r][0], ADDEND);
#define PLAIN(r) a[r][0] &= ADDEND;
#include "parallel_case.h"

#define CASE or_ushort
#define TYPE unsigned short
#define OPERATION REDCC_OR
#define WIDTH 1
#define BODY(r) redcc_or(it, A, &a[r][0], ADDEND);
#define PLAIN(r) a[r][0] |= ADDEND;
#include "parallel_case.h"

#define CASE xor_long
#define TYPE long
#define OPERATION REDCC_XOR
#define WIDTH 1
#define BODY(r) redcc_xor(it, A, &a[r][0], ADDEND);
#define PLAIN(r) a[r][0] ^= ADDEND;
#include "parallel_case.h"

#define CASE minimum_short
#define TYPE short
#define OPERATION REDCC_MINIMUM
#define WIDTH 1
#define BODY(r) redcc_minimum(it, A, &a[r][0], ADDEND);
#define PLAIN(r) a[r][0] = ADDEND < a[r][0] ? ADDEND : a[r][0];
#include "parallel_case.h"

#define CASE maximum_double
#define TYPE double
#define OPERATION REDCC_MAXIMUM
#define WIDTH 1
#define BODY(r) redcc_maximum(it, A, &a[r][0], ADDEND);
#define PLAIN(r) a[r][0] = ADDEND > a[r][0] ? ADDEND : a[r][0];
#include "parallel_case.h"

#define CASE rows_float
#define TYPE float
#define OPERATION REDCC_SUM
#define WIDTH 3
#define BODY(r) UPDATE_ROW(*redcc_row(it, A, &a[r]), +=, ADDEND)
#define PLAIN(r) UPDATE_ROW(a[r], +=, ADDEND)
#include "parallel_case.h"

#define CASE rows_int
#define TYPE int
#define OPERATION REDCC_SUM
#define WIDTH 4
#define BODY(r) UPDATE_ROW(*redcc_row(it, A, &a[r]), -=, ADDEND)
#define PLAIN(r) UPDATE_ROW(a[r], -=, ADDEND)
#include "parallel_case.h"

#define CASE rows_double
#define TYPE double
#define OPERATION REDCC_SUM
#define WIDTH 3
#define BODY(r) UPDATE_ROW(*redcc_row(it, A, &a[r]), -=, ADDEND)
#define PLAIN(r) UPDATE_ROW(a[r], -=, ADDEND)
#include "parallel_case.h"

#define CASE rows_product
#define TYPE double
#define OPERATION REDCC_PRODUCT
#define WIDTH 2
#define BODY(r) UPDATE_ROW(*redcc_row(it, A, &a[r]), *=, FACTOR)
#define PLAIN(r) UPDATE_ROW(a[r], *=, FACTOR)
#include "parallel_case.h"

#define CASE rows_and
#define TYPE unsigned
#define OPERATION REDCC_AND
#define WIDTH 3
#define BODY(r) UPDATE_ROW(*redcc_row(it, A, &a[r]), &=, ADDEND)
#define PLAIN(r) UPDATE_ROW(a[r], &=, ADDEND)
#include "parallel_case.h"

int main(int count, char **arguments) {
    exact = count > 1 && strcmp(arguments[1], "exact") == 0;
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_add_char),        cmocka_unit_test(test_add_ushort),
        cmocka_unit_test(test_add_int),         cmocka_unit_test(test_add_ulong),
        cmocka_unit_test(test_add_float),       cmocka_unit_test(test_add_double),
        cmocka_unit_test(test_add_long_double), cmocka_unit_test(test_add_complex),
        cmocka_unit_test(test_subtract_int),    cmocka_unit_test(test_subtract_double),
        cmocka_unit_test(test_multiply_uint),   cmocka_unit_test(test_multiply_double),
        cmocka_unit_test(test_and_uint),        cmocka_unit_test(test_or_ushort),
        cmocka_unit_test(test_xor_long),        cmocka_unit_test(test_minimum_short),
        cmocka_unit_test(test_maximum_double),  cmocka_unit_test(test_rows_float),
        cmocka_unit_test(test_rows_int),        cmocka_unit_test(test_rows_double),
        cmocka_unit_test(test_rows_product),    cmocka_unit_test(test_rows_and)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
