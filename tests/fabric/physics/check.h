/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** cmocka's headers in the required order, and comparisons that print the numbers when they fail.
 */
#ifndef FABRIC_TEST_CHECK_H
#define FABRIC_TEST_CHECK_H

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#define assert_below(value, limit)                                                                 \
    do {                                                                                           \
        const double value_ = (value), limit_ = (limit);                                           \
        if (!(value_ <= limit_))                                                                   \
            fail_msg("%s = %.17g is above %.17g", #value, value_, limit_);                         \
    } while (0)

#define assert_near(value, expected, tolerance)                                                    \
    do {                                                                                           \
        const double got_ = (value), expected_ = (expected), tolerance_ = (tolerance);             \
        if (!(fabs(got_ - expected_) <= tolerance_))                                               \
            fail_msg("%s = %.17g, expected %.17g within %.3g", #value, got_, expected_,            \
                     tolerance_);                                                                  \
    } while (0)

#endif
