/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Scene files: the values that are read, and the messages about errors. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/words.h"
#include "listen.h"
#include "mesh/surface.h"
#include "scene/scene.h"

static const char FILE_NAME[] = "scene-test.yaml";

/* A complete scene, line by line, so that tests can name lines. */
static const char *const lines[] = {
    "name: test",                             /* 1 */
    "mesh:",                                  /* 2 */
    "  vertices: 30",                         /* 3 */
    "  boundary: 12",                         /* 4 */
    "  side: 0.5",                            /* 5 */
    "material:",                              /* 6 */
    "  density: 0.25",                        /* 7 */
    "  stretch: 500",                         /* 8 */
    "  shear: 100",                           /* 9 */
    "  bend: 0.001",                          /* 10 */
    "surroundings:",                          /* 11 */
    "  gravity: [0, 0, -9.81]",               /* 12 */
    "pins:",                                  /* 13 */
    "  - {low: [-1, 0.25], high: [1, 0.26]}", /* 14 */
    "colliders:",                             /* 15 */
    "  - kind: sphere",                       /* 16 */
    "    radius: 0.5",                        /* 17 */
    "time:",                                  /* 18 */
    "  step: 0.01 # s",                       /* 19 */
    "  steps: 10",                            /* 20 */
};
enum { LINE_COUNT = sizeof lines / sizeof *lines };

/* Reads the scene above with line `line` (from 1) replaced by `text`, or removed if `text` is
 * NULL. */
static int read_with(int line, const char *text, scene *s) {
    FILE *file = fopen(FILE_NAME, "w");
    assert_non_null(file);
    for (int k = 1; k <= LINE_COUNT; k++) {
        if (k != line)
            fprintf(file, "%s\n", lines[k - 1]);
        else if (text)
            fprintf(file, "%s\n", text);
    }
    fclose(file);
    start_listening("said.txt");
    const int status = scene_read(s, FILE_NAME);
    stop_listening("said.txt");
    return status;
}

static void check_wrong(int line, const char *text, const char *expected) {
    scene s;
    char whole[1024];
    assert_int_equal(read_with(line, text, &s), -1);
    snprintf(whole, sizeof whole, "%s%s\n", FILE_NAME, expected);
    assert_string_equal(said, whole);
    assert_null(s.pins);
    assert_null(s.colliders);
}

static void test_read(void **unused) {
    scene s;
    (void)unused;
    assert_int_equal(read_with(0, NULL, &s), 0);
    assert_string_equal(said, "");
    assert_string_equal(s.name, "test");
    assert_int_equal(s.mesh.vertices, 30);
    assert_true(s.mesh.side == 0.5 && s.material.density == 0.25 &&
                s.surroundings.gravity[2] == -9.81 && s.time.step == 0.01);
    assert_int_equal(s.mesh.order, MESH_ORDER_SORTED); /* values not in the file: defaults */
    assert_true(s.mesh.normal[2] == 1.0 && s.solution.tolerance == 1e-3 &&
                s.surroundings.drag == 0.0);
    assert_int_equal(s.mesh.seed, 1);
    assert_true(s.contact.method == CONTACT_CONSTRAINTS && s.contact.untangle == 0);
    assert_int_equal(s.pin_count, 1);
    assert_true(s.pins[0].low[1] == 0.25 && s.pins[0].velocity[0] == 0.0);
    assert_int_equal(s.collider_count, 1);
    assert_int_equal(s.colliders[0].kind, COLLIDER_SPHERE);
    assert_true(s.colliders[0].size[0] == 0.5 && s.colliders[0].gap == 0.005);
    scene_free(&s);
}

static void test_unknown_keys(void **unused) {
    (void)unused;
    check_wrong(12, "  gravty: [0, 0, -9.81]",
                ":12: unknown key 'gravty' in 'surroundings', expected one of 'gravity', 'drag', "
                "'tangential_drag', 'wind', 'wind_from', 'wind_until'; did you mean 'gravity'?");
    check_wrong(1, "title: test",
                ":1: unknown key 'title', expected one of 'name', 'mesh', 'material', "
                "'surroundings', 'pins', 'colliders', 'contact', 'self_collision', 'time', "
                "'solution', 'monitor'; did you mean 'time'?");
    check_wrong(17, "    half_edges: [1, 1, 1]",
                ":17: unknown key 'half_edges' in 'colliders.0', expected one of 'kind', "
                "'position', 'velocity', 'radius', 'friction', 'gap', 'from', 'until', "
                "'turn_axis', 'motion'");
    check_wrong(8, "  density: 500", ":8: key 'density' stands here twice");
}

static void test_missing_keys(void **unused) {
    (void)unused;
    check_wrong(5, NULL, ":3: missing key 'side' in 'mesh', expected a number greater than 0");
    check_wrong(1, NULL, ":1: missing key 'name', expected a text of 1 to 63 bytes");
    check_wrong(17, NULL,
                ":16: missing key 'radius' in 'colliders.0', expected a number greater than 0");
    check_wrong(16, "  - gap: 0.01",
                ":16: missing key 'kind' in 'colliders.0', expected one of 'plane', 'box', "
                "'sphere', 'cylinder', 'mesh'");
    check_wrong(14, "  - {low: [-1, 0.25]}",
                ":14: missing key 'high' in 'pins.0', expected a list of 2, each a number");
}

static void test_wrong_values(void **unused) {
    (void)unused;
    check_wrong(7, "  density: -0.1",
                ":7: 'material.density' is '-0.1', expected a number greater than 0");
    check_wrong(7, "  density: heavy",
                ":7: 'material.density' is 'heavy', expected a number greater than 0");
    check_wrong(8, "  stretch: nan",
                ":8: 'material.stretch' is 'nan', expected a number, 0 or more");
    check_wrong(8, "  stretch: 1e999",
                ":8: 'material.stretch' is '1e999', expected a number, 0 or more");
    check_wrong(20, "  steps: 1.5",
                ":20: 'time.steps' is '1.5', expected a whole number from 0 to 1000000000");
    check_wrong(12, "  gravity: [0, 0]",
                ":12: 'surroundings.gravity' is a list of 2, expected a list of 3, each a number");
    check_wrong(12, "  gravity: 9.81",
                ":12: 'surroundings.gravity' is '9.81', expected a list of 3, each a number");
    check_wrong(16, "  - kind: spere",
                ":16: 'colliders.0.kind' is 'spere', expected one of 'plane', 'box', 'sphere', "
                "'cylinder', 'mesh'; did you mean 'sphere'?");
    check_wrong(4, "  boundary: 30",
                ":4: 'mesh.boundary' is 30, expected less than 'mesh.vertices', 30");
    check_wrong(14, "  - {low: [-1, 1], high: [1, 0]}",
                ":14: 'pins.0.low' lies above 'high', expected a corner below it");
    check_wrong(5, "  side: 0.5\n  normal: [0, 0, 0]",
                ":6: 'mesh.normal' has no direction, expected a vector other than 0");
}

static void test_not_scenes(void **unused) {
    scene s;
    (void)unused;
    check_wrong(12, "  gravity: [0, 0", ":13: not YAML: did not find expected ',' or ']'");
    check_wrong(1, "--- {}\n---", ":1: missing key 'name', expected a text of 1 to 63 bytes");
    check_wrong(1, "--- 3\n---", ":1: 'the scene' is '3', expected a section of keys");
    start_listening("said.txt");
    assert_int_equal(scene_read(&s, "no-such-file.yaml"), -1);
    stop_listening("said.txt");
    assert_string_equal(said, "no-such-file.yaml: cannot be read: No such file or directory\n");
}

static void check_set(scene *s, const char *assignment, const char *expected) {
    char whole[1024] = "";
    start_listening("said.txt");
    const int status = scene_set(s, assignment);
    stop_listening("said.txt");
    assert_int_equal(status, expected ? -1 : 0);
    if (expected)
        snprintf(whole, sizeof whole, "--set %s: %s\n", assignment, expected);
    assert_string_equal(said, whole);
}

static void test_set(void **unused) {
    scene s;
    (void)unused;
    assert_int_equal(read_with(0, NULL, &s), 0);
    check_set(&s, "material.bend=0.5", NULL);
    assert_true(s.material.bend == 0.5);
    check_set(&s, "surroundings.wind=[1, 2, 3]", NULL);
    assert_true(s.surroundings.wind[1] == 2.0);
    check_set(&s, "mesh.order=shuffled", NULL);
    assert_int_equal(s.mesh.order, MESH_ORDER_SHUFFLED);
    check_set(&s, "colliders.0.radius=2", NULL);
    assert_true(s.colliders[0].size[0] == 2.0);
    check_set(&s,
              "colliders=[{kind: box, half_edges: [1, 2, 3]}, {kind: plane, normal: [0, 0, 2]}]",
              NULL);
    assert_int_equal(s.collider_count, 2);
    assert_true(s.colliders[0].size[2] == 3.0 && s.colliders[1].axis[2] == 1.0);
    check_set(&s, "contact=barrier", NULL);
    check_set(&s, "contact.untangle=on", NULL);
    assert_true(s.contact.method == CONTACT_BARRIER && s.contact.untangle == 1);
    check_set(&s, "pins=[]", NULL);
    assert_int_equal(s.pin_count, 0);
    scene_free(&s);
}

static void test_set_wrong(void **unused) {
    scene s;
    (void)unused;
    assert_int_equal(read_with(0, NULL, &s), 0);
    check_set(&s, "material.bnd=1",
              "unknown key 'bnd' in 'material', expected one of 'density', 'stretch', 'shear', "
              "'bend', 'stretch_damping', 'shear_damping', 'bend_damping', 'strain_limit'; did you "
              "mean 'bend'?");
    check_set(&s, "material.bend=-1", "'material.bend' is '-1', expected a number, 0 or more");
    check_set(&s, "material=1", "'material' is a section: set one of its keys");
    check_set(&s, "contact={method: barrier}", "'contact' is a section: set one of its keys");
    check_set(&s, "contact=glue", "'contact' is 'glue', expected one of 'constraints', 'barrier'");
    check_set(&s, "material.bend.x=1", "'bend' is a value and has no keys in it");
    check_set(&s, "colliders.1.gap=0", "'colliders' has no item '1', expected 0 to 0");
    check_set(&s, "colliders.0=1", "'colliders.0' is an item: set one of its keys");
    check_set(&s, "colliders.0.kind=box", "the kind of a collider cannot be set, only read");
    check_set(&s, "mesh.vertices=12",
              "'mesh.boundary' is 12, expected less than 'mesh.vertices', 12");
    check_set(&s, "material.bend", "expected KEY=VALUE, such as material.bend=0.01");
    check_set(&s, "material.bend=", "no value, expected KEY=VALUE");
    scene_free(&s);
}

/* A collider's mesh file is searched for relative to the scene's folder, and its whole path is
 * written. */
static void test_mesh_collider(void **unused) {
    scene s, again;
    (void)unused;
    FILE *file = fopen("solid.obj", "w");
    assert_non_null(file);
    fputs("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n", file);
    fclose(file);
    assert_int_equal(read_with(16, "  - kind: mesh\n    file: solid.obj\n  - kind: sphere", &s), 0);
    assert_int_equal(s.colliders[0].kind, COLLIDER_MESH);
    assert_non_null(s.colliders[0].surface);
    assert_true(s.colliders[0].file[0] == '/');
    assert_int_equal(scene_write(&s, "written.yaml"), 0);
    assert_int_equal(scene_read(&again, "written.yaml"), 0);
    assert_string_equal(again.colliders[0].file, s.colliders[0].file);
    check_set(&s, "colliders=[]", NULL);
    scene_free(&s);
    scene_free(&again);
    check_wrong(16, "  - kind: mesh\n    file: none.obj\n  - kind: sphere",
                ":17: 'colliders.0.file' is 'none.obj': no such file");
}

/* Writes bad.obj: the vertices of a tetrahedron after a comment, then these faces from line 6 on. A
 * scene with this collider must be refused with `expected` and the file's line, or accepted if
 * `expected` is NULL. */
static void check_solid(const char *faces, const char *expected) {
    static const char text[] = "  - kind: mesh\n    file: bad.obj\n  - kind: sphere";
    char path[4096], message[8192];
    FILE *file = fopen("bad.obj", "w");
    assert_non_null(file);
    fprintf(file, "# by hand\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n%s", faces);
    fclose(file);
    if (!expected) {
        scene s;
        assert_int_equal(read_with(16, text, &s), 0);
        scene_free(&s);
        return;
    }
    assert_non_null(realpath("bad.obj", path));
    snprintf(message, sizeof message, ":17: 'colliders.0.file' is '%s': %s", path, expected);
    check_wrong(16, text, message);
}

/* Meshes whose signed distance would have the wrong sign are refused, since they would push the
 * cloth in the wrong direction. An open surface is accepted. */
static void test_bad_solids(void **unused) {
    (void)unused;
    check_solid("f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n", NULL);
    check_solid("f 1 3 2\nf 1 2 4\n", NULL); /* not closed */
    check_solid("f 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n",
                "all triangles face inwards, expected counter-clockwise seen from outside");
    check_solid("f 1 3 2\nf 1 2 4\nf 1 3 4\nf 2 3 4\n",
                "triangle 3 (line 8) faces the other way than its neighbour, expected all "
                "counter-clockwise from outside; the other is triangle 1 (line 6)");
    check_solid("f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\nv 3 3 3\nf 1 2 5\n",
                "triangle 5 (line 11) is the third at an edge, expected two at most; the other is "
                "triangle 1 (line 6)");
    check_solid("f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n\nf 2 1 3\n",
                "triangle 5 (line 11) has the three vertices of another, expected each once; the "
                "other is triangle 1 (line 6)");
    check_solid("v 2 0 0\nv 3 0 0\nf 1 2 5\n", "no triangle has an area");
}

/* Every scene of the distribution can be read and written, and is equal when read again. */
static void test_shipped_scenes(void **unused) {
    static const char *const names[] = {"tablecloth", "hanging", "sheet218k", "patch", "flag",
                                        "ball",       "curtain", "ring",      "scarf"};
    (void)unused;
    for (size_t k = 0; k < sizeof names / sizeof *names; k++) {
        char path[4096];
        scene first, second;
        snprintf(path, sizeof path, "%s/%s.yaml", SCENES_FOLDER, names[k]);
        assert_int_equal(scene_read(&first, path), 0);
        assert_string_equal(first.name, names[k]);
        assert_int_equal(scene_write(&first, "written.yaml"), 0);
        assert_int_equal(scene_read(&second, "written.yaml"), 0);
        assert_int_equal(first.collider_count, second.collider_count);
        for (int c = 0; c < first.collider_count; c++) {
            collider copy = second.colliders[c];
            assert_int_equal(copy.surface != NULL, first.colliders[c].surface != NULL);
            copy.surface = first.colliders[c].surface; /* each scene has its own surface */
            assert_memory_equal(&first.colliders[c], &copy, sizeof copy);
        }
        assert_int_equal(first.pin_count, second.pin_count);
        for (int p = 0; p < first.pin_count; p++)
            assert_memory_equal(&first.pins[p], &second.pins[p], sizeof(pin));
        for (int c = 0; c < second.collider_count; c++)
            surface_free(second.colliders[c].surface);
        assert_int_equal(second.mesh.sheet != NULL, first.mesh.sheet != NULL);
        if (second.mesh.sheet)
            mesh_free(second.mesh.sheet);
        free(second.mesh.sheet);
        free(second.colliders);
        free(second.pins);
        second.mesh.sheet = first.mesh.sheet;
        second.colliders = first.colliders;
        second.pins = first.pins;
        assert_memory_equal(&first, &second, sizeof first);
        scene_free(&first);
    }
}

/* The paper's scenes have the values that the paper gives. */
static void test_scenes_of_the_paper(void **unused) {
    static const char *const names[] = {"tablecloth", "hanging"};
    (void)unused;
    for (int k = 0; k < 2; k++) {
        char path[4096];
        scene s;
        mesh m;
        snprintf(path, sizeof path, "%s/%s.yaml", SCENES_FOLDER, names[k]);
        assert_int_equal(scene_read(&s, path), 0);
        assert_int_equal(s.time.steps, 76);
        assert_true(s.time.step == 0.033);
        assert_int_equal(scene_mesh(&s, &m, NULL), 0);
        assert_int_equal(m.vertex_count, 2602);
        assert_int_equal(m.triangle_count, 4982);
        mesh_free(&m);
        scene_free(&s);
    }
}

/* In an upright sheet the material's y axis points upwards, and the sheet faces in the direction of
 * its normal. */
static void test_placement(void **unused) {
    scene s;
    mesh m;
    (void)unused;
    assert_int_equal(read_with(5, "  side: 0.5\n  origin: [1, 2, 3]\n  normal: [0, -2, 0]", &s), 0);
    assert_int_equal(scene_mesh(&s, &m, NULL), 0);
    for (int v = 0; v < m.vertex_count; v++) {
        assert_true(fabs(m.position[v][0] - 1.0 - m.material[v][0]) < 1e-15);
        assert_true(m.position[v][1] == 2.0);
        assert_true(fabs(m.position[v][2] - 3.0 - m.material[v][1]) < 1e-15);
    }
    mesh_free(&m);
    scene_free(&s);
}

static void test_nearest_word(void **unused) {
    static const char *const words[] = {"bend", "stretch", "gravity"};
    (void)unused;
    assert_string_equal(words_nearest("bned", words, 3), "bend"); /* an exchange is one change */
    assert_string_equal(words_nearest("strech", words, 3), "stretch");
    assert_string_equal(words_nearest("gravitty", words, 3), "gravity");
    assert_null(words_nearest("colour", words, 3));
    assert_null(words_nearest("", words, 3));
    assert_null(words_nearest("bend", words, 0));
}

/* A scene equals the scene read from its text. If one key differs, the message names it with both
 * values. */
static void test_scenes_compared(void **unused) {
    static const struct {
        const char *setting, *said; /* "" if there is no difference that matters */
    } cases[] = {
        {"time.steps=7", ""},
        {"material.bend=0.25", "'material.bend' is 0.25, there 0.0002"},
        {"surroundings.wind=[0, 1, 0]", "'surroundings.wind' is [0, 1, 0], there [0, 0, 0]"},
        {"colliders.0.friction=0.75", "'colliders.0.friction' is 0.75, there 0.4"},
        {"colliders=[]", "'colliders' has 0 items, there 2"},
        {"time.integrator=midpoint", "'time.integrator' is midpoint, there linear-euler"},
    };
    (void)unused;
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        scene one, other;
        char found[256] = "";
        size_t size;
        assert_int_equal(scene_read(&one, SCENES_FOLDER "/patch.yaml"), 0);
        char *text = scene_text(&one, &size);
        assert_non_null(text);
        assert_int_equal(scene_read_text(&other, text, size, "memory"), 0);
        assert_int_equal(scene_differ(&one, &other, found), 0);
        assert_int_equal(scene_set(&one, cases[k].setting), 0);
        assert_int_equal(scene_differ(&one, &other, found), cases[k].said[0] != '\0');
        assert_string_equal(found, cases[k].said);
        free(text);
        scene_free(&one);
        scene_free(&other);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_read),
        cmocka_unit_test(test_unknown_keys),
        cmocka_unit_test(test_missing_keys),
        cmocka_unit_test(test_wrong_values),
        cmocka_unit_test(test_not_scenes),
        cmocka_unit_test(test_set),
        cmocka_unit_test(test_set_wrong),
        cmocka_unit_test(test_mesh_collider),
        cmocka_unit_test(test_scenes_compared),
        cmocka_unit_test(test_bad_solids),
        cmocka_unit_test(test_shipped_scenes),
        cmocka_unit_test(test_scenes_of_the_paper),
        cmocka_unit_test(test_placement),
        cmocka_unit_test(test_nearest_word),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
