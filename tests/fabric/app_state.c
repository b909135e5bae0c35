/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* State files: the values written are read back, and truncated or other files are refused. Also
 * meshes as OBJ files. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "output/obj.h"
#include "output/state.h"

static const char FILE_NAME[] = "test.state";
static const double position[9] = {0.1, -0.0, 1e-310, 1.0 / 3.0, 2e300, -5.5, 7.0, 8.0, 9.0};
static const double velocity[9] = {1, 2, 3, 4, 5, 6, 7, 8, 9.25};
static const int triangle[3] = {2, 0, 1}, original[3] = {1, 2, 0};

static state example(unsigned parts) {
    return (state){.vertex_count = 3,
                   .triangle_count = 1,
                   .time = 2.508,
                   .step = 76,
                   .parts = parts,
                   .position = position,
                   .velocity = velocity,
                   .triangle = triangle,
                   .original = original};
}

static void test_round_trip(void **unused) {
    const state written = example(STATE_VELOCITIES | STATE_TRIANGLES | STATE_ORIGINAL);
    state read;
    (void)unused;
    assert_int_equal(state_write(&written, FILE_NAME), 0);
    assert_int_equal(access("test.state.partial", F_OK), -1);
    assert_int_equal(state_read(&read, FILE_NAME), 0);
    assert_int_equal(read.vertex_count, 3);
    assert_int_equal(read.triangle_count, 1);
    assert_int_equal(read.step, 76);
    assert_true(read.time == 2.508);
    assert_memory_equal(read.position, position, sizeof position);
    assert_memory_equal(read.velocity, velocity, sizeof velocity);
    assert_memory_equal(read.triangle, triangle, sizeof triangle);
    assert_memory_equal(read.original, original, sizeof original);
    state_free(&read);
}

static void test_frame(void **unused) {
    const state written = example(STATE_SINGLE);
    state read;
    (void)unused;
    assert_int_equal(state_write(&written, FILE_NAME), 0);
    assert_int_equal(state_read(&read, FILE_NAME), 0);
    assert_null(read.velocity);
    assert_null(read.triangle);
    assert_null(read.original);
    for (int k = 0; k < 9; k++)
        assert_true(read.position[k] == (double)(float)position[k]);
    state_free(&read);
}

/* Checks that these bytes, written to a file, are refused. */
static void check_refused(const char *bytes, size_t size) {
    state read;
    FILE *file = fopen("wrong.state", "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, size, file), size);
    fclose(file);
    assert_int_equal(state_read(&read, "wrong.state"), -1);
    assert_null(read.memory);
}

static void test_wrong_files(void **unused) {
    const state written = example(STATE_VELOCITIES | STATE_TRIANGLES | STATE_ORIGINAL);
    char bytes[512];
    (void)unused;
    assert_int_equal(state_write(&written, FILE_NAME), 0);
    FILE *file = fopen(FILE_NAME, "rb");
    assert_non_null(file);
    const size_t size = fread(bytes, 1, sizeof bytes, file);
    fclose(file);
    assert_int_equal(size, 64 + 9 * 8 + 9 * 8 + 3 * 4 + 3 * 4);
    for (size_t torn = 0; torn < size; torn++)
        check_refused(bytes, torn);
    check_refused(bytes, size + 1);
    for (size_t damaged = 0; damaged < size;
         damaged++) { /* any byte: at least the checksum detects it */
        bytes[damaged] = (char)(bytes[damaged] ^ 0x10);
        check_refused(bytes, size);
        bytes[damaged] = (char)(bytes[damaged] ^ 0x10);
    }
}

/* A triangle with a vertex that does not exist, with a correct checksum. */
static void test_wrong_numbers(void **unused) {
    state written = example(STATE_TRIANGLES), read;
    const int beyond[3] = {0, 1, 3};
    (void)unused;
    written.triangle = beyond;
    assert_int_equal(state_write(&written, FILE_NAME), 0);
    assert_int_equal(state_read(&read, FILE_NAME), -1);
    written = example(STATE_ORIGINAL);
    written.original = beyond;
    assert_int_equal(state_write(&written, FILE_NAME), 0);
    assert_int_equal(state_read(&read, FILE_NAME), -1);
}

static void test_unwritable(void **unused) {
    const state written = example(STATE_SINGLE);
    (void)unused;
    assert_int_equal(state_write(&written, "no-such-folder/x.state"), -1);
}

static void test_obj_round_trip(void **unused) {
    mesh first, second;
    char error[256];
    (void)unused;
    assert_int_equal(mesh_generate(&first, 60, 20, 1.5, 9, error), 0);
    assert_int_equal(obj_write(&first, "mesh.obj"), 0);
    assert_int_equal(obj_read(&second, "mesh.obj"), 0);
    assert_int_equal(first.vertex_count, second.vertex_count);
    assert_int_equal(first.triangle_count, second.triangle_count);
    assert_memory_equal(first.position, second.position, 60 * sizeof *first.position);
    assert_memory_equal(first.material, second.material, 60 * sizeof *first.material);
    assert_memory_equal(first.triangle, second.triangle,
                        (size_t)first.triangle_count * sizeof *first.triangle);
    mesh_free(&first);
    mesh_free(&second);
}

static int read_obj(const char *text, mesh *m) {
    FILE *file = fopen("wrong.obj", "w");
    assert_non_null(file);
    fputs(text, file);
    fclose(file);
    return obj_read(m, "wrong.obj");
}

static void test_obj(void **unused) {
    static const char *const wrong[] = {
        "",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\n",
        "v 0 0\n",
        "v 0 0 nan\n",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 0\n",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 2\n",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/1 2/1 3/1\n",
    };
    mesh m;
    (void)unused;
    for (size_t k = 0; k < sizeof wrong / sizeof *wrong; k++)
        assert_int_equal(read_obj(wrong[k], &m), -1);
    assert_int_equal(
        read_obj("# by hand\nv 0 0 7\nv 1 0 7\nv 0 1 7\nvn 0 0 1\nf -3//1 -2//1 -1//1\n", &m), 0);
    assert_memory_equal(m.triangle[0], ((int[3]){0, 1, 2}), sizeof(int[3]));
    assert_true(m.material[1][0] == 1.0 && m.position[2][2] == 7.0);
    mesh_free(&m);
    assert_int_equal(read_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 4 3\n", &m), 0);
    assert_int_equal(m.triangle_count, 2); /* a fan around the first corner */
    assert_memory_equal(m.triangle[1], ((int[3]){0, 3, 2}), sizeof(int[3]));
    mesh_free(&m);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_round_trip),  cmocka_unit_test(test_frame),
        cmocka_unit_test(test_wrong_files), cmocka_unit_test(test_wrong_numbers),
        cmocka_unit_test(test_unwritable),  cmocka_unit_test(test_obj_round_trip),
        cmocka_unit_test(test_obj),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
