/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Meshes from OBJ files: polygons, refusals with clear messages, seams that are not joined, and
 * damaged files. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "input/mesh_file.h"
#include "listen.h"

enum { MOST = 1 << 12 };

/** A file's contents in memory. */
typedef struct bytes {
    size_t count;
    unsigned char at[MOST];
} bytes;

static int read_quietly(mesh *m, const char *path) {
    start_listening("mesh-said.txt");
    const int status = mesh_file_read(m, path);
    stop_listening("mesh-said.txt");
    return status;
}

static void save(const char *path, const void *from, size_t count) {
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(from, 1, count, file), count);
    fclose(file);
}

static void check_refused(const char *path, const char *text, const char *expected) {
    mesh m;
    char whole[512];
    if (text)
        save(path, text, strlen(text));
    assert_int_equal(read_quietly(&m, path), -1);
    snprintf(whole, sizeof whole, "%s%s\n", path, expected);
    assert_string_equal(said, whole);
    assert_null(m.position);
}

/* Quadrilaterals and pentagons become fans around their first corner. */
static void test_polygons(void **unused) {
    (void)unused;
    static const char text[] =
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 2 0\nf 1 2 3 4\nf 5 4 3 2 1 \n";
    static const int expected[5][3] = {{0, 1, 2}, {0, 2, 3}, {4, 3, 2}, {4, 2, 1}, {4, 1, 0}};
    mesh m;
    save("poly.obj", text, strlen(text));
    assert_int_equal(read_quietly(&m, "poly.obj"), 0);
    assert_int_equal(m.triangle_count, 5);
    assert_memory_equal(m.triangle, expected, sizeof expected);
    mesh_free(&m);
}

static void test_names(void **unused) {
    (void)unused;
    static const char said_of_others[] =
        ": not an OBJ file by its name, expected .obj; Blender and MeshLab convert other meshes";
    check_refused("mesh.ply", "ply\n", said_of_others);
    check_refused("mesh.glb", NULL, said_of_others);
    check_refused("mesh", NULL, said_of_others);
    check_refused("nowhere.obj", NULL, ": cannot be read: No such file or directory");
}

/* Two adjacent triangles whose common vertices occur twice, and the same triangles with joined
 * vertices. 0 and -0 are one position. */
static void test_seams(void **unused) {
    (void)unused;
    static const struct {
        const char *text;
        int count, first;
    } cases[] = {
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 -0 0\nv 1 1 0\nv -0 1 0\nf 1 2 3\nf 4 5 6\n", 2, 3},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 4 3\n", 0, -1}};
    for (int k = 0; k < 2; k++) {
        mesh m;
        mesh_problem found[MESH_PROBLEM_COUNT];
        char error[256], expected[128] = "";
        save("seam.obj", cases[k].text, strlen(cases[k].text));
        assert_int_equal(read_quietly(&m, "seam.obj"), 0);
        start_listening("mesh-said.txt");
        assert_int_equal(mesh_file_prepare(&m, "seam", found, error), 0);
        stop_listening("mesh-said.txt");
        assert_int_equal(found[MESH_SEAM].count, cases[k].count);
        if (cases[k].count > 0)
            snprintf(expected, sizeof expected,
                     "seam: 2 vertices in the place of another one, where the cloth is open; the "
                     "first is number %d\n",
                     cases[k].first + 1);
        assert_string_equal(said, expected);
        mesh_free(&m);
    }
}

/* Each damaged file must be read, or refused with a message that names it. */
static void abuse(const char *path, const bytes *whole, int tries) {
    mesh intact;
    unsigned seed = 7;
    save(path, whole->at, whole->count);
    assert_int_equal(read_quietly(&intact, path), 0);
    mesh_free(&intact);
    int refused = 0, asked = 0;
    for (int n = 0; n < 2 * tries; n++) {
        mesh m;
        mesh_problem found[MESH_PROBLEM_COUNT];
        char error[256];
        bytes b = *whole;
        if (n < tries)
            b.count = b.count * (size_t)n / (size_t)tries;
        else
            for (int k = 0; k < 3; k++) {
                seed = seed * 1664525u + 1013904223u;
                b.at[(seed >> 8) % b.count] ^= (unsigned char)(1u << (seed & 7));
            }
        save(path, b.at, b.count);
        const int status = read_quietly(&m, path);
        assert_int_equal(status != 0, said[0] != '\0');
        assert_true(status == 0 || strncmp(said, path, strlen(path)) == 0);
        if (status == 0 && mesh_clean(&m, found, error) == 0)
            assert_int_equal(mesh_check(&m, found), 0);
        mesh_free(&m);
        refused += status != 0;
        asked++;
    }
    print_message("%s: %d of %d refused\n", path, refused, asked);
    assert_true(refused > tries / 4);
}

static void test_damage(void **unused) {
    (void)unused;
    bytes whole = {0};
    for (int v = 0; v < 12; v++)
        whole.count += (size_t)snprintf((char *)whole.at + whole.count, 64, "v %.9g %d %g\n",
                                        v % 4 / 3.0, v / 4, sin(v) * 1e-5);
    for (int q = 0; q < 6; q++) {
        const int at = q / 3 * 4 + q % 3 + 1;
        whole.count += (size_t)snprintf((char *)whole.at + whole.count, 64, "f %d %d %d %d\n", at,
                                        at + 1, at + 5, at + 4);
    }
    abuse("damaged.obj", &whole, 400);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_polygons),
        cmocka_unit_test(test_names),
        cmocka_unit_test(test_seams),
        cmocka_unit_test(test_damage),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
