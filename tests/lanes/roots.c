/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Compares redcc_lanes_sqrt with the library's sqrt (bits, and errno if a lane is negative), and
 * checks redcc_any. Prints the vector width, or an empty line if redcc/lanes.h has no vectors for
 * the processor. This file is not translated. */
#include <errno.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <redcc/runtime.h>

#include <redcc/lanes.h>

static const double value[] = {
    0.0, -0.0, 1.0,    2.0,      0x1p-1074, 0x1.fffffffffffffp-1023, 1e308,
    3.5, 9.0,  1e-300, INFINITY, NAN,       0x1.fffffffffffffp+1,    -NAN};
static const double negative[] = {-1.0, -INFINITY, -0x1p-1074};
enum { VALUES = sizeof value / sizeof *value };

static uint64_t bits_of(double v) {
    uint64_t bits;
    memcpy(&bits, &v, sizeof bits);
    return bits;
}

static int check(int width, const double *from, const double *to, int error) {
    int expected_error;
    errno = 0;
    for (int l = 0; l < width; l++) {
        volatile double one = from[l];
        const double root = sqrt(one);
        if (bits_of(root) != bits_of(to[l]) && !(root != root && to[l] != to[l])) {
            printf("width %d: sqrt(%a) is %a, not %a\n", width, from[l], to[l], root);
            return 1;
        }
    }
    expected_error = errno;
    if (error != expected_error)
        printf("width %d: errno is %d, not %d\n", width, error, expected_error);
    return error != expected_error;
}

#if REDCC_WIDTH
/* All values pass through each lane; then each lane gets a negative one. */
static REDCC_TARGET __attribute__((__noinline__)) int check_all(void) {
    enum { w = REDCC_WIDTH };
    int wrong = 0;
    for (int round = 0; round < VALUES + 3 * w; round++) {
        double from[w], to[w];
        redcc_vector lanes;
        redcc_mask mask;
        for (int l = 0; l < w; l++)
            from[l] = value[(round + 3 * l) % VALUES];
        if (round >= VALUES)
            from[(round - VALUES) % w] = negative[(round - VALUES) / w];
        memcpy(&lanes, from, sizeof lanes);
        errno = 0;
        lanes = redcc_lanes_sqrt(lanes);
        const int error = errno;
        memcpy(to, &lanes, sizeof lanes);
        wrong += check(w, from, to, error);
        for (int l = 0; l < w; l++)
            mask[l] = l == round % (w + 1) ? -1 : 0;
        if (!redcc_any(mask) != (round % (w + 1) == w)) {
            printf("width %d: a lane is not seen, or none is: %d\n", w, round);
            wrong++;
        }
    }
    printf("%d ", w);
    return wrong;
}
#endif

int main(void) {
    int wrong = 0;
#if REDCC_WIDTH && defined(__x86_64__)
    if (__builtin_cpu_supports("avx2"))
        wrong += check_all();
#elif REDCC_WIDTH
    wrong += check_all();
#endif
    printf("\n");
    return wrong != 0;
}
