/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Pictures and the camera. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <string.h>

#include "output/camera.h"
#include "output/picture.h"

static void test_halve(void **unused) {
    picture p, half;
    (void)unused;
    assert_int_equal(picture_new(&p, 4, 2), 0);
    static const unsigned char values[8] = {0, 100, 7, 7, 200, 100, 7, 7};
    for (int k = 0; k < 8; k++)
        memset(p.rgb + 3 * k, values[k], 3);
    assert_int_equal(picture_halve(&p, &half), 0);
    assert_int_equal(half.width, 2);
    assert_int_equal(half.height, 1);
    assert_memory_equal(half.rgb, ((unsigned char[6]){100, 100, 100, 7, 7, 7}), 6);
    picture_free(&p);
    picture_free(&half);
}

static int dark_pixels(const picture *p) {
    int count = 0;
    for (int k = 0; k < p->width * p->height; k++)
        count += p->rgb[3 * k] < 128;
    return count;
}

/* Also partly and wholly outside. */
static void test_paste_and_text(void **unused) {
    picture p, small;
    (void)unused;
    assert_int_equal(picture_new(&p, 10, 10), 0);
    assert_int_equal(picture_new(&small, 4, 4), 0);
    memset(small.rgb, 0, 3 * 16);
    picture_paste(&p, &small, 8, -2);
    assert_int_equal(dark_pixels(&p), 4);
    picture_paste(&p, &small, 0, 0);
    assert_int_equal(dark_pixels(&p), 20);
    picture_paste(&p, &small, 100, 100);
    assert_int_equal(dark_pixels(&p), 20);
    picture_free(&p);
    assert_int_equal(picture_new(&p, 10, 10), 0);
    picture_text(&p, 1, 1, 1, "1");
    assert_int_equal(dark_pixels(&p), 10); /* the dots of its glyph */
    picture_text(&p, -3, 95, 2, "t = 0.5 s?");
    assert_int_equal(dark_pixels(&p), 10);
    picture_free(&p);
    picture_free(&small);
}

/* All points are in the picture, and some are near its edge. */
static void test_camera(void **unused) {
    double points[8][3];
    const double back[3] = {0.5, -1.0, 0.4};
    double widest = 0.0;
    (void)unused;
    for (int k = 0; k < 8; k++) {
        points[k][0] = (k & 1) != 0 ? 3.0 : 2.0;
        points[k][1] = (k & 2) != 0 ? -1.0 : 1.0;
        points[k][2] = (k & 4) != 0 ? 0.5 : 0.0;
    }
    const camera c = camera_frame(back, 4.0 / 3.0, points, 8);
    for (int k = 0; k < 8; k++) {
        double seen[3] = {0.0, 0.0, 0.0};
        for (int i = 0; i < 3; i++) {
            seen[0] += (points[k][i] - c.eye[i]) * c.right[i];
            seen[1] += (points[k][i] - c.eye[i]) * c.up[i];
            seen[2] -= (points[k][i] - c.eye[i]) * c.back[i];
        }
        assert_true(seen[2] >= c.depth[0] - 1e-9 && seen[2] <= c.depth[1] + 1e-9);
        for (int i = 0; i < 2; i++) {
            const double part = fabs(seen[i]) / seen[2] / c.slope[i];
            assert_true(part < 1.0);
            widest = fmax(widest, part);
        }
    }
    assert_true(widest > 0.85);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_halve),
        cmocka_unit_test(test_paste_and_text),
        cmocka_unit_test(test_camera),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
