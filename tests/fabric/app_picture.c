/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Pictures and the camera. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <string.h>

#include <stdlib.h>

#include "view/camera.h"
#include "view/patch.h"
#include "view/picture.h"
#include "view/stage.h"

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

/* Also partly and entirely outside the picture. */
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
    assert_int_equal(dark_pixels(&p), 10); /* the dots of the glyph `1` */
    picture_text(&p, -3, 95, 2, "t = 0.5 s?");
    assert_int_equal(dark_pixels(&p), 10);
    picture_free(&p);
    picture_free(&small);
}

/* All points are inside the picture, and some are near its edge. */
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

/* Makes a cap of a ball with a radius of 1 m from n by n squares of two triangles, or a flat sheet
 * (height 0). */
static void cap(int n, double height, double *position, float *material, int *triangle) {
    int t = 0;
    for (int r = 0; r <= n; r++)
        for (int c = 0; c <= n; c++) {
            const int i = r * (n + 1) + c;
            const double x = (double)c / n - 0.5, y = (double)r / n - 0.5;
            position[3 * i] = x;
            position[3 * i + 1] = y;
            position[3 * i + 2] = height * sqrt(1 - x * x - y * y);
            material[2 * i] = (float)x;
            material[2 * i + 1] = (float)y;
        }
    for (int r = 0; r < n; r++)
        for (int c = 0; c < n; c++) {
            const int i = r * (n + 1) + c;
            const int corners[6] = {i, i + 1, i + n + 2, i, i + n + 2, i + n + 1};
            memcpy(&triangle[3 * (2 * t++)], corners, sizeof corners);
        }
}

/* Patches lie close to the ball that the triangles approximate, neighbours have common points, and
 * the pattern keeps its place. A flat sheet stays flat. */
static void test_patches(void **unused) {
    enum { n = 8, parts = 4 };
    double position[3 * (n + 1) * (n + 1)];
    float material[2 * (n + 1) * (n + 1)];
    int triangle[6 * n * n], inner = 0;
    patches p;
    (void)unused;
    for (int round = 0; round < 2; round++) {
        double worst = 0.0;
        cap(n, round == 0 ? 1.0 : 0.0, position, material, triangle);
        assert_int_equal(
            patches_make(&p, (n + 1) * (n + 1), 2 * n * n, position, material, triangle, parts), 0);
        assert_int_equal(p.triangle_count, 2 * n * n * parts * parts);
        for (int i = 0; i < p.vertex_count; i++) {
            const double *x = &p.position[3 * (size_t)i];
            const int is_inner = fabs(x[0]) < 0.37 && fabs(x[1]) < 0.37;
            const double off =
                round == 0 ? sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]) - 1.0 : x[2];
            worst = is_inner ? fmax(worst, fabs(off)) : worst;
            inner += is_inner;
            assert_true(fabs((double)p.material[2 * (size_t)i] - x[0]) < 2e-3);
        }
        assert_true(worst < (round == 0 ? 3e-4 : 1e-15)); /* the triangles are 2.6e-3 away */
        for (int a = 0; a < p.vertex_count; a++)          /* points coincide or are well apart */
            for (int b = 0; b < a; b++) {
                double square = 0.0;
                for (int k = 0; k < 3; k++)
                    square += pow(p.position[3 * (size_t)a + (size_t)k] -
                                      p.position[3 * (size_t)b + (size_t)k],
                                  2);
                assert_true(square < 1e-28 || square > 1e-4);
            }
        patches_free(&p);
    }
    assert_true(inner > 1000);
}

/* Returns the brightness of the pixel that shows x. */
static double brightness(const picture *p, const camera *from, const double x[3]) {
    double seen[3] = {0.0};
    for (int k = 0; k < 3; k++) {
        seen[0] += (x[k] - from->eye[k]) * from->right[k];
        seen[1] += (x[k] - from->eye[k]) * from->up[k];
        seen[2] -= (x[k] - from->eye[k]) * from->back[k];
    }
    const int column = (int)((seen[0] / seen[2] / from->slope[0] + 1.0) / 2.0 * p->width);
    const int row = (int)((1.0 - seen[1] / seen[2] / from->slope[1]) / 2.0 * p->height);
    const unsigned char *rgb = p->rgb + 3 * (row * p->width + column);
    return rgb[0] + rgb[1] + rgb[2];
}

/* A small sheet above a large one, both of one cloth and one colour: the large one is darker in the
 * small one's shadow and nowhere else. */
static void test_shadow_on_itself(void **unused) {
    static const double position[24] = {-1, -1, 0, 1,   -1, 0, 1,   1,   0, -1, 1,   0,
                                        0,  0,  1, 0.3, 0,  1, 0.3, 0.3, 1, 0,  0.3, 1};
    static const float material[16] = {0.02f, 0.02f, 0.02f, 0.02f, 0.02f, 0.02f, 0.02f, 0.02f,
                                       0.02f, 0.02f, 0.02f, 0.02f, 0.02f, 0.02f, 0.02f, 0.02f};
    static const int triangle[12] = {0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7};
    const stage_cloth cloth = {8, 4, position, triangle, material};
    /* The camera looks down. Light comes from (-0.45, -0.8, 1.1), so the shadow is moved by (0.41,
     * 0.73). */
    const camera from = {.eye = {0, 0, 6},
                         .right = {1, 0, 0},
                         .up = {0, 1, 0},
                         .back = {0, 0, 1},
                         .slope = {0.25, 0.25},
                         .depth = {5, 6}};
    const scene empty = {0};
    picture p;
    (void)unused;
    stage *st = stage_new(&empty, 256, 256);
    assert_non_null(st);
    assert_int_equal(stage_draw(st, &from, &cloth, 0.0, &p), 0);
    int dark = 0, lit = 0;
    for (double x = -0.9; x < 0.95; x += 0.1)
        for (double y = -0.9; y < 0.95; y += 0.1) {
            const double at[3] = {x, y, 0};
            const int is_hidden = x > -0.05 && x < 0.4 && y > -0.05 && y < 0.4;
            const double over[2] = {x - 0.45 / 1.1, y - 0.8 / 1.1};
            const double edge = fmax(fabs(over[0] - 0.15), fabs(over[1] - 0.15)) - 0.15;
            if (is_hidden || fabs(edge) < 0.03)
                continue;
            const double bright = brightness(&p, &from, at);
            assert_true(edge < 0 ? bright < 170 : bright > 230);
            dark += edge < 0;
            lit += edge > 0;
        }
    assert_true(dark > 3 && lit > 200);
    picture_free(&p);
    stage_free(st);
}

/* Mesa keeps memory until the end; leaks of this program are still reported. */
const char *__lsan_default_suppressions(void);
const char *__lsan_default_suppressions(void) {
    return "leak:libOSMesa";
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_halve),
        cmocka_unit_test(test_paste_and_text),
        cmocka_unit_test(test_camera),
        cmocka_unit_test(test_patches),
        cmocka_unit_test(test_shadow_on_itself),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
