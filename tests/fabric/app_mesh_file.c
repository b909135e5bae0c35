/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Meshes of files: the same floats from every format, clear refusals, and damage of all kinds. */
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

enum { MOST = 1 << 14 };

/** A file in memory. */
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

static void put(bytes *b, const void *from, size_t count) {
    assert_true(b->count + count <= MOST);
    memcpy(b->at + b->count, from, count);
    b->count += count;
}

static void put_text(bytes *b, const char *text) {
    put(b, text, strlen(text));
}

static void put_reversed(bytes *b, const void *from, size_t count) {
    for (size_t k = count; k > 0; k--)
        put(b, (const unsigned char *)from + k - 1, 1);
}

/* Floats with all their digits, of many sizes. */
enum {
    COLUMNS = 4,
    ROWS = 3,
    VERTICES = COLUMNS * ROWS,
    TRIANGLES = 2 * (COLUMNS - 1) * (ROWS - 1)
};
static float grid[VERTICES][3];
static int corner[TRIANGLES][3];

static void make_grid(void) {
    static const int quad[2][3] = {{0, 1, COLUMNS + 1}, {0, COLUMNS + 1, COLUMNS}};
    for (int v = 0; v < VERTICES; v++) {
        grid[v][0] = (float)(v % COLUMNS) / 3.0f + 1e-7f;
        grid[v][1] = (float)(v / COLUMNS) * 0.1f - 1234.5678f;
        grid[v][2] = sinf((float)v) * 1e-5f;
    }
    for (int t = 0; t < TRIANGLES; t++) {
        const int q = t / 2, at = q / (COLUMNS - 1) * COLUMNS + q % (COLUMNS - 1);
        for (int p = 0; p < 3; p++)
            corner[t][p] = at + quad[t % 2][p];
    }
}

static void check_grid(const char *path) {
    mesh m;
    if (read_quietly(&m, path) != 0)
        fail_msg("%s", said);
    assert_string_equal(said, "");
    assert_int_equal(m.vertex_count, VERTICES);
    assert_int_equal(m.triangle_count, TRIANGLES);
    for (int v = 0; v < VERTICES; v++)
        for (int a = 0; a < 3; a++) {
            assert_true(m.position[v][a] == (double)grid[v][a]);
            assert_true(a == 2 || m.material[v][a] == (double)grid[v][a]);
        }
    assert_memory_equal(m.triangle, corner, sizeof corner);
    mesh_free(&m);
}

/* ASCII, with what is to be passed over. */
static bytes ply_text(const char *type) {
    bytes b = {0};
    char line[256];
    snprintf(line, sizeof line,
             "ply\r\nformat ascii 1.0\ncomment the grid\nobj_info x\nelement vertex %d\n"
             "property %s x\nproperty uchar red\nproperty %s y\nproperty %s z\n",
             VERTICES, type, type, type);
    put_text(&b, line);
    snprintf(line, sizeof line,
             "element face %d\nproperty list uchar int vertex_indices\nproperty list uchar float "
             "texcoord\nelement camera 1\nproperty float view\nend_header\n",
             TRIANGLES);
    put_text(&b, line);
    for (int v = 0; v < VERTICES; v++) {
        snprintf(line, sizeof line, "%.9g 255 %.9g %.9g\n", (double)grid[v][0], (double)grid[v][1],
                 (double)grid[v][2]);
        put_text(&b, line);
    }
    for (int t = 0; t < TRIANGLES; t++) {
        snprintf(line, sizeof line, "3 %d %d %d 2 0.5 0.5\n", corner[t][0], corner[t][1],
                 corner[t][2]);
        put_text(&b, line);
    }
    put_text(&b, "3.5\n");
    return b;
}

typedef void (*putter)(bytes *b, const void *from, size_t count);

/* Binary, as this machine (little-endian) or the other way round. */
static bytes ply_binary(const char *format, int wide, putter put_number) {
    const char *type = wide ? "double" : "float32";
    bytes b = {0};
    char line[256];
    snprintf(line, sizeof line,
             "ply\nformat %s 1.0\nelement vertex %d\nproperty short nothing\nproperty %s x\n"
             "property %s y\nproperty %s z\nelement face %d\nproperty list uint8 uint "
             "vertex_index\nend_header\n",
             format, VERTICES, type, type, type, TRIANGLES);
    put_text(&b, line);
    for (int v = 0; v < VERTICES; v++) {
        put(&b, "\xff\xff", 2);
        for (int a = 0; a < 3; a++) {
            const double number = (double)grid[v][a];
            if (wide)
                put_number(&b, &number, sizeof number);
            else
                put_number(&b, &grid[v][a], sizeof grid[v][a]);
        }
    }
    for (int t = 0; t < TRIANGLES; t++) {
        put(&b, "\3", 1);
        for (int p = 0; p < 3; p++)
            put_number(&b, &corner[t][p], sizeof corner[t][p]);
    }
    return b;
}

static void test_ply(void **unused) {
    (void)unused;
    const bytes files[] = {ply_text("float"),
                           ply_text("float32"),
                           ply_binary("binary_little_endian", 0, put),
                           ply_binary("binary_little_endian", 1, put),
                           ply_binary("binary_big_endian", 0, put_reversed),
                           ply_binary("binary_big_endian", 1, put_reversed)};
    for (size_t k = 0; k < sizeof files / sizeof *files; k++) {
        save("grid.PLY", files[k].at, files[k].count);
        check_grid("grid.PLY");
    }
}

/* Quads and pentagons are fans around their first corner. */
static void test_polygons(void **unused) {
    (void)unused;
    static const char *const files[][2] = {
        {"poly.ply", "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
                     "property float z\nelement face 2\nproperty list uchar int vertex_indices\n"
                     "end_header\n0 0 0 1 0 0 1 1 0 0 1 0 2 2 0\n4 0 1 2 3\n5 4 3 2 1 0\n"},
        {"poly.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 2 0\nf 1 2 3 4\nf 5 4 3 2 1 \n"}};
    static const int expected[5][3] = {{0, 1, 2}, {0, 2, 3}, {4, 3, 2}, {4, 2, 1}, {4, 1, 0}};
    for (int k = 0; k < 2; k++) {
        mesh m;
        save(files[k][0], files[k][1], strlen(files[k][1]));
        assert_int_equal(read_quietly(&m, files[k][0]), 0);
        assert_int_equal(m.triangle_count, 5);
        assert_memory_equal(m.triangle, expected, sizeof expected);
        mesh_free(&m);
    }
}

#define HEAD "ply\nformat ascii 1.0\n"
#define XYZ "property float x\nproperty float y\nproperty float z\n"
#define FACE "property list uchar int vertex_indices\n"

static void test_ply_refusals(void **unused) {
    (void)unused;
    check_refused("a.ply", "solid x\n", ": not a PLY file, expected 'ply' at its beginning");
    check_refused("a.ply", "ply2\n", ":1: not a PLY file, expected 'ply' in its first line");
    check_refused("a.ply", "ply\nformat utf8 1.0\n",
                  ":2: 'format utf8 1.0', expected 'format ascii 1.0', binary_little_endian or "
                  "binary_big_endian");
    check_refused("a.ply", HEAD "element vertex 3\n",
                  ":4: the file ends in its header, expected 'end_header'");
    check_refused("a.ply", HEAD "elements 3\n",
                  ":3: 'elements 3', expected 'element', 'property', 'comment' or 'end_header'");
    check_refused("a.ply", HEAD "element vertex -1\n",
                  ":3: '-1' elements, expected a number from 0 to 715827882");
    check_refused("a.ply", HEAD "element vertex 3\nproperty half x\n",
                  ":4: the type of 'x', expected char to double");
    check_refused("a.ply", HEAD "property float x\n",
                  ":3: a property of no element, expected 'element' before it");
    check_refused("a.ply", HEAD "element vertex 3\nelement vertex 9\n",
                  ":4: a second element 'vertex', expected one");
    check_refused("a.ply", HEAD "element vertex 3\nproperty float x\nend_header\n",
                  ": no element 'vertex' with x, y and z, expected one");
    check_refused("a.ply", HEAD "element vertex 3\n" XYZ "end_header\n",
                  ": no element 'face' with 'vertex_indices' after 'vertex', expected one");
    check_refused("a.ply", HEAD "element face 1\n" FACE "element vertex 3\n" XYZ "end_header\n",
                  ": no element 'face' with 'vertex_indices' after 'vertex', expected one");
    check_refused("a.ply", HEAD "element vertex 3\n" XYZ "element face 0\n" FACE "end_header\n",
                  ": 3 vertices and 0 faces, expected some");
    check_refused("a.ply",
                  HEAD "element vertex 900000\n" XYZ "element face 1\n" FACE "end_header\n0 0 0\n",
                  ": 900000 times 'vertex' do not fit in the 6 bytes after the header: the file "
                  "ends too early");
#define THREE HEAD "element vertex 3\n" XYZ "element face 1\n" FACE "end_header\n"
    check_refused("a.ply", THREE "0 0 0 1 0 0 0 1",
                  ": vertex 2 of 3: no number for 'z', the file ends");
    check_refused("a.ply", THREE "0 0 0 1 a 0 0 1 0", ": vertex 1 of 3: no number for 'y'");
    check_refused("a.ply", THREE "0 0 0 1 0 0 0 1 0\n3 0 1 3\n",
                  ": face 0, corner 2: expected the number of a vertex from 0 to 2");
    check_refused("a.ply", THREE "0 0 0 1 0 0 0 1 0\n3 0 1 -1\n",
                  ": face 0, corner 2: expected the number of a vertex from 0 to 2");
    check_refused("a.ply", THREE "0 0 0 1 0 0 0 1 0\n2 0 1\n",
                  ": face 0 has 2 corners, expected 3 or more");
}

static void test_names(void **unused) {
    (void)unused;
    check_refused("mesh.fbx", NULL,
                  ": not a mesh by its name, expected .obj, .ply, .gltf, .glb or .stl");
    check_refused("mesh", NULL,
                  ": not a mesh by its name, expected .obj, .ply, .gltf, .glb or .stl");
    check_refused("nowhere.ply", NULL, ": cannot be read: No such file or directory");
    check_refused("a.gltf", "glTF", ": not a glTF file, expected '{' at its beginning");
    check_refused("a.glb", " {}", ": not a binary glTF file, expected 'glTF' at its beginning");
}

/* Equal coordinates are one vertex, 0 and -0 too; the order of the others stays. */
static void test_joining(void **unused) {
    (void)unused;
    double position[6][3] = {{1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {2, 0, 5}, {-0.0, 0, 0}, {1, 0, 1}};
    double material[6][2] = {{1, 0}, {0, 0}, {9, 9}, {2, 0}, {9, 9}, {3, 0}};
    int triangle[2][3] = {{2, 4, 5}, {3, 0, 1}};
    mesh m = {.vertex_count = 6,
              .triangle_count = 2,
              .position = position,
              .material = material,
              .triangle = triangle};
    assert_int_equal(mesh_join_vertices(&m), 0);
    assert_int_equal(m.vertex_count, 4);
    const double places[4][3] = {{1, 0, 0}, {0, 0, 0}, {2, 0, 5}, {1, 0, 1}};
    const double flat[4][2] = {{1, 0}, {0, 0}, {2, 0}, {3, 0}};
    const int joined[2][3] = {{0, 1, 3}, {2, 0, 1}};
    assert_memory_equal(position, places, sizeof places);
    assert_memory_equal(material, flat, sizeof flat);
    assert_memory_equal(triangle, joined, sizeof joined);
}

#ifdef FABRIC_WITH_ASSIMP
static void put_number(bytes *b, unsigned number) {
    put(b, &number, sizeof number);
}

/* Its vertices in the order in which the triangles name them: each triangle is where it was. */
static void check_joined(const char *path) {
    mesh m;
    assert_int_equal(read_quietly(&m, path), 0);
    assert_int_equal(m.vertex_count, VERTICES);
    assert_int_equal(m.triangle_count, TRIANGLES);
    for (int t = 0; t < TRIANGLES; t++)
        for (int p = 0; p < 3; p++)
            for (int a = 0; a < 3; a++)
                assert_true(m.position[m.triangle[t][p]][a] == (double)grid[corner[t][p]][a]);
    mesh_free(&m);
}

/* Triangles of six corners' vertices each once a corner, as at the seams of a texture. */
static bytes gltf_buffer(int seams) {
    bytes b = {0};
    for (int v = 0; v < (seams ? 3 * TRIANGLES : VERTICES); v++) {
        /* what is x, y, z here is x, z, -y in the file */
        const float *at = grid[seams ? corner[v / 3][v % 3] : v];
        const float turned[3] = {at[0], at[2], -at[1]};
        put(&b, turned, sizeof turned);
    }
    for (int k = 0; k < 3 * TRIANGLES; k++) {
        const unsigned short number = (unsigned short)(seams ? k : corner[k / 3][k % 3]);
        put(&b, &number, sizeof number);
    }
    return b;
}

static bytes gltf_text(const bytes *buffer, const char *uri, const char *nodes, int seams) {
    bytes b = {0};
    char text[2048];
    const int vertices = seams ? 3 * TRIANGLES : VERTICES;
    snprintf(text, sizeof text,
             "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,%s,"
             "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"indices\":1}]}],"
             "\"buffers\":[{%s\"byteLength\":%zu}],"
             "\"bufferViews\":[{\"buffer\":0,\"byteLength\":%d},"
             "{\"buffer\":0,\"byteOffset\":%d,\"byteLength\":%d}],"
             "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":%d,\"type\":"
             "\"VEC3\",\"min\":[-1e9,-1e9,-1e9],\"max\":[1e9,1e9,1e9]},"
             "{\"bufferView\":1,\"componentType\":5123,\"count\":%d,\"type\":\"SCALAR\"}]}",
             nodes, uri, buffer->count, 12 * vertices, 12 * vertices, 6 * TRIANGLES, vertices,
             3 * TRIANGLES);
    put_text(&b, text);
    return b;
}

#define ONE_NODE "\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}]"

static bytes glb_file(int seams) {
    const bytes buffer = gltf_buffer(seams);
    bytes text = gltf_text(&buffer, "", ONE_NODE, seams), b = {0};
    while (text.count % 4 != 0)
        put_text(&text, " ");
    put_text(&b, "glTF");
    put_number(&b, 2);
    put_number(&b, (unsigned)(12 + 8 + text.count + 8 + buffer.count));
    put_number(&b, (unsigned)text.count);
    put_text(&b, "JSON");
    put(&b, text.at, text.count);
    put_number(&b, (unsigned)buffer.count);
    put(&b, "BIN\0", 4);
    put(&b, buffer.at, buffer.count);
    return b;
}

static void save_gltf(const char *path, const char *nodes, int seams) {
    const bytes buffer = gltf_buffer(seams);
    const bytes text = gltf_text(&buffer, "\"uri\":\"grid.bin\",", nodes, seams);
    save("grid.bin", buffer.at, buffer.count);
    save(path, text.at, text.count);
}

static void test_gltf(void **unused) {
    (void)unused;
    save_gltf("grid.gltf", ONE_NODE, 0);
    check_grid("grid.gltf");
    const bytes b = glb_file(0);
    save("grid.glb", b.at, b.count);
    check_grid("grid.glb");
}

/* A vertex for each corner: joined, in the order in which they are met. */
static void test_seams(void **unused) {
    (void)unused;
    const bytes b = glb_file(1);
    save("seams.glb", b.at, b.count);
    check_joined("seams.glb");
}

/* Two nodes, one below the other, with one mesh: moved twice, and all become one mesh. */
static void test_nodes(void **unused) {
    (void)unused;
    mesh m;
    save_gltf("nodes.gltf",
              "\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0,\"children\":[1]},"
              "{\"mesh\":0,\"translation\":[4,0,0],\"scale\":[2,2,2]}]",
              0);
    assert_int_equal(read_quietly(&m, "nodes.gltf"), 0);
    assert_int_equal(m.vertex_count, 2 * VERTICES);
    assert_int_equal(m.triangle_count, 2 * TRIANGLES);
    for (int v = 0; v < VERTICES; v++) {
        assert_true(m.position[v][0] == (double)grid[v][0]);
        assert_true(m.position[VERTICES + v][0] == 4 + 2 * (double)grid[v][0]);
        assert_true(m.position[VERTICES + v][1] == 2 * (double)grid[v][1]);
    }
    for (int p = 0; p < 3; p++)
        assert_int_equal(m.triangle[TRIANGLES][p], VERTICES + corner[0][p]);
    mesh_free(&m);
}

static void test_stl(void **unused) {
    (void)unused;
    bytes b = {0};
    while (b.count < 80)
        put_text(&b, " ");
    put_number(&b, TRIANGLES);
    for (int t = 0; t < TRIANGLES; t++) {
        put(&b, (const float[3]){0, 0, 1}, 12);
        for (int p = 0; p < 3; p++)
            put(&b, grid[corner[t][p]], 12);
        put(&b, "\0", 2);
    }
    save("grid.stl", b.at, b.count);
    check_joined("grid.stl");
}

static void test_gltf_refusals(void **unused) {
    (void)unused;
    save_gltf("none.gltf", "\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{}]", 0);
    check_refused("none.gltf", NULL, ": it has no triangles, expected some");
    check_refused("none.glb", NULL, ": No such file or directory");
    check_refused("empty.gltf", "{\"asset\":{\"version\":\"2.0\"}}", ": GLTF: No scene");
}
#endif

/* Read, or refused by name; never anything else. */
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
    assert_true(refused > tries / 2);
}

static void test_damage(void **unused) {
    (void)unused;
    const bytes text = ply_text("float"), binary = ply_binary("binary_little_endian", 0, put);
    abuse("damaged.ply", &text, 400);
    abuse("damaged.ply", &binary, 400);
#ifdef FABRIC_WITH_ASSIMP
    const bytes glb = glb_file(0), buffer = gltf_buffer(0);
    const bytes gltf = gltf_text(&buffer, "\"uri\":\"grid.bin\",", ONE_NODE, 0);
    abuse("damaged.glb", &glb, 25);
    abuse("damaged.gltf", &gltf, 25);
#endif
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_ply),           cmocka_unit_test(test_polygons),
        cmocka_unit_test(test_ply_refusals),  cmocka_unit_test(test_names),
        cmocka_unit_test(test_joining),
#ifdef FABRIC_WITH_ASSIMP
        cmocka_unit_test(test_gltf),          cmocka_unit_test(test_seams),
        cmocka_unit_test(test_nodes),         cmocka_unit_test(test_stl),
        cmocka_unit_test(test_gltf_refusals),
#endif
        cmocka_unit_test(test_damage),
    };
    make_grid();
    return cmocka_run_group_tests(tests, NULL, NULL);
}
