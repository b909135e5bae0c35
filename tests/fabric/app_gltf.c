/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Animated glTF files: this test reads every number back from the JSON and base64 text, compares
 * the binary form with it, and checks what the library assimp reads. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#ifdef FABRIC_WITH_ASSIMP
#include <assimp/cimport.h>
#include <assimp/scene.h>
#endif

#include "listen.h"
#include "view/gltf.h"

enum { FRAMES = 4, VERTICES = 5, TRIANGLES = 4, MOST = 1 << 20, COLLIDERS = 4 };
static const int corners[3 * TRIANGLES] = {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4};
static const double times[FRAMES] = {0, 0.04, 0.1, 0.25};
static collider colliders[COLLIDERS] = {
    {.kind = COLLIDER_SPHERE, .position = {1, 2, 3}, .velocity = {0, 1, 0}, .size = {0.5}},
    {.kind = COLLIDER_BOX, .position = {-1, 0, 0.5}, .size = {0.5, 1, 2}},
    {.kind = COLLIDER_CYLINDER,
     .position = {0, 0, 1},
     .velocity = {1, 0, 2},
     .axis = {0.6, 0, 0.8},
     .size = {0.25, 1}},
    {.kind = COLLIDER_PLANE, .position = {0, 0, -1}, .axis = {0, 0, 1}}};
static const scene of = {.collider_count = COLLIDERS, .colliders = colliders};

static double place(int frame, int k) {
    return (double)(float)(sin(1.0 + k) + 0.3 * frame * cos(k) - (k % 3 == 2 ? frame : 0));
}

static int read_frame(void *context, int number, state *s) {
    const int *failing = context;
    double *position = malloc(3 * VERTICES * sizeof *position);
    if (!position || number == *failing) {
        free(position);
        return -1;
    }
    for (int k = 0; k < 3 * VERTICES; k++)
        position[k] = place(number, k);
    *s = (state){
        .vertex_count = VERTICES, .time = times[number], .position = position, .memory = position};
    return 0;
}

static int failing = -1;
static cloth_frames run = {.count = FRAMES,
                           .time = times,
                           .vertex_count = VERTICES,
                           .triangle_count = TRIANGLES,
                           .triangle = corners,
                           .read = read_frame,
                           .context = &failing};

/** A file that was read back. */
typedef struct document {
    json_t *root;
    size_t size;
    unsigned char *bytes; /* contents of the glTF buffer */
} document;

static unsigned char file_bytes[MOST];

static size_t load(const char *path) {
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    const size_t size = fread(file_bytes, 1, sizeof file_bytes, file);
    assert_true(size < sizeof file_bytes);
    fclose(file);
    return size;
}

static unsigned value_of(char digit) {
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const char *at = strchr(digits, digit);
    assert_non_null(at);
    return (unsigned)(at - digits);
}

static size_t decode(const char *text, unsigned char *bytes) {
    size_t size = 0;
    assert_int_equal(strlen(text) % 4, 0);
    for (; *text; text += 4) {
        unsigned word = 0;
        const int padding = (text[2] == '=') + (text[3] == '=');
        for (int k = 0; k < 4; k++)
            word = word << 6 | (text[k] == '=' ? 0 : value_of(text[k]));
        for (int k = 0; k < 3 - padding; k++)
            bytes[size++] = (unsigned char)(word >> (16 - 8 * k));
    }
    return size;
}

static json_t *at(json_t *from, const char *key) {
    json_t *value = json_object_get(from, key);
    if (!value)
        fail_msg("no key %s", key);
    return value;
}

static long whole(json_t *from, const char *key) {
    assert_true(json_is_integer(at(from, key)));
    return (long)json_integer_value(at(from, key));
}

static json_t *item(json_t *from, const char *key, long number) {
    json_t *value = json_array_get(at(from, key), (size_t)number);
    if (!value)
        fail_msg("%s has no item %ld", key, number);
    return value;
}

static document read_text(const char *path) {
    static const char begin[] = "data:application/octet-stream;base64,";
    document d = {0};
    json_error_t error;
    file_bytes[load(path)] = '\0';
    d.root = json_loads((const char *)file_bytes, JSON_REJECT_DUPLICATES, &error);
    if (!d.root)
        fail_msg("%s:%d: %s", path, error.line, error.text);
    const char *uri = json_string_value(at(item(d.root, "buffers", 0), "uri"));
    assert_int_equal(strncmp(uri, begin, sizeof begin - 1), 0);
    d.bytes = malloc(strlen(uri));
    d.size = decode(uri + sizeof begin - 1, d.bytes);
    assert_int_equal(whole(item(d.root, "buffers", 0), "byteLength"), d.size);
    return d;
}

static void forget(document *d) {
    json_decref(d->root);
    free(d->bytes);
}

/** Returns the address of an accessor's element. Checks that the element lies within its view, that
 * the view lies within the buffer, and that the element is aligned. */
static const unsigned char *element(const document *d, long accessor, long number) {
    json_t *a = item(d->root, "accessors", accessor);
    json_t *view = item(d->root, "bufferViews", whole(a, "bufferView"));
    const int is_vector = strcmp(json_string_value(at(a, "type")), "VEC3") == 0;
    const long size = is_vector ? 12 : 4, offset = whole(a, "byteOffset") + size * number;
    assert_true(number < whole(a, "count"));
    assert_true(offset + size <= whole(view, "byteLength"));
    assert_int_equal((offset + whole(view, "byteOffset")) % 4, 0);
    assert_true((size_t)(whole(view, "byteOffset") + whole(view, "byteLength")) <= d->size);
    return d->bytes + whole(view, "byteOffset") + offset;
}

static double number_at(const document *d, long accessor, long number, int axis) {
    float single;
    assert_int_equal(whole(item(d->root, "accessors", accessor), "componentType"), 5126);
    memcpy(&single, element(d, accessor, number) + 4 * axis, sizeof single);
    return (double)single;
}

static long corner_at(const document *d, long accessor, long number) {
    uint32_t word;
    assert_int_equal(whole(item(d->root, "accessors", accessor), "componentType"), 5125);
    memcpy(&word, element(d, accessor, number), sizeof word);
    return (long)word;
}

static void check_bounds(const document *d, long accessor) {
    json_t *a = item(d->root, "accessors", accessor);
    const int axes = (int)json_array_size(at(a, "min"));
    assert_int_equal(axes, strcmp(json_string_value(at(a, "type")), "VEC3") == 0 ? 3 : 1);
    for (int axis = 0; axis < axes; axis++) {
        double low = INFINITY, high = -INFINITY;
        for (long k = 0; k < whole(a, "count"); k++) {
            low = fmin(low, number_at(d, accessor, k, axis));
            high = fmax(high, number_at(d, accessor, k, axis));
        }
        assert_true((float)json_number_value(item(a, "min", axis)) == (float)low);
        assert_true((float)json_number_value(item(a, "max", axis)) == (float)high);
    }
}

static json_t *primitive_of(const document *d, long mesh_number) {
    return item(item(d->root, "meshes", mesh_number), "primitives", 0);
}

static long positions_of(const document *d, long mesh_number) {
    return whole(at(primitive_of(d, mesh_number), "attributes"), "POSITION");
}

static void check_cloth(const document *d, int frames) {
    json_t *primitive = primitive_of(d, 0);
    const long base = positions_of(d, 0), indices = whole(primitive, "indices");
    assert_int_equal(whole(item(d->root, "accessors", base), "count"), VERTICES);
    assert_int_equal(whole(item(d->root, "accessors", indices), "count"), 3 * TRIANGLES);
    check_bounds(d, base);
    for (int k = 0; k < 3 * TRIANGLES; k++)
        assert_int_equal(corner_at(d, indices, k), corners[k]);
    assert_int_equal(json_array_size(json_object_get(primitive, "targets")), frames - 1);
    for (int k = 0; k < frames; k++)
        for (int v = 0; v < VERTICES; v++)
            for (int a = 0; a < 3; a++) {
                const int from = a == 0 ? 0 : a == 1 ? 2 : 1;
                double x = number_at(d, base, v, a);
                if (k > 0)
                    x += number_at(d, whole(item(primitive, "targets", k - 1), "POSITION"), v, a);
                assert_true(fabs(x - (a == 2 ? -1 : 1) * place(k, 3 * v + from)) < 1e-6);
            }
    for (int k = 1; k < frames; k++)
        check_bounds(d, whole(item(primitive, "targets", k - 1), "POSITION"));
}

static void check_animation(const document *d) {
    json_t *animation = item(d->root, "animations", 0);
    const int moving[] = {0, 2};
    for (int n = 0; n < 3; n++) {
        json_t *channel = item(animation, "channels", n), *target = at(channel, "target");
        json_t *sampler = item(animation, "samplers", whole(channel, "sampler"));
        const long input = whole(sampler, "input"), output = whole(sampler, "output");
        assert_string_equal(json_string_value(at(sampler, "interpolation")), "LINEAR");
        assert_string_equal(json_string_value(at(target, "path")),
                            n == 0 ? "weights" : "translation");
        assert_int_equal(whole(target, "node"), n == 0 ? 0 : moving[n - 1] + 1);
        assert_int_equal(whole(item(d->root, "accessors", input), "count"), FRAMES);
        assert_int_equal(whole(item(d->root, "accessors", output), "count"),
                         n == 0 ? FRAMES * (FRAMES - 1) : FRAMES);
        check_bounds(d, input);
        for (int k = 0; k < FRAMES; k++) {
            assert_true(number_at(d, input, k, 0) == (double)(float)times[k]);
            for (int t = 1; n == 0 && t < FRAMES; t++)
                assert_true(number_at(d, output, k * (FRAMES - 1) + t - 1, 0) == (k == t));
            for (int a = 0; n > 0 && a < 3; a++) {
                const collider *c = &colliders[moving[n - 1]];
                const int from = a == 0 ? 0 : a == 1 ? 2 : 1;
                const double x = c->position[from] + times[k] * c->velocity[from];
                assert_true(fabs(number_at(d, output, k, a) - (a == 2 ? -x : x)) < 1e-6);
            }
        }
    }
}

/** Returns the enclosed volume, which is positive if triangles are counter-clockwise as seen from
 * outside. */
static double volume_of(const document *d, long mesh_number) {
    const long positions = positions_of(d, mesh_number);
    const long indices = whole(primitive_of(d, mesh_number), "indices");
    double sum = 0;
    for (long k = 0; k < whole(item(d->root, "accessors", indices), "count"); k += 3) {
        double x[3][3];
        for (int p = 0; p < 3; p++)
            for (int a = 0; a < 3; a++)
                x[p][a] = number_at(d, positions, corner_at(d, indices, k + p), a);
        for (int a = 0; a < 3; a++) {
            const int i = (a + 1) % 3, j = (a + 2) % 3;
            sum += x[0][a] * (x[1][i] * x[2][j] - x[1][j] * x[2][i]) / 6;
        }
    }
    return sum;
}

static void check_colliders(const document *d) {
    const double pi = 3.14159265358979, volume[] = {pi / 6, 8, 2 * pi / 16};
    for (int k = 0; k < COLLIDERS; k++) {
        json_t *node = item(d->root, "nodes", k + 1);
        const double *p = colliders[k].position, turned[3] = {p[0], p[2], -p[1]};
        assert_int_equal(whole(node, "mesh"), k + 1);
        check_bounds(d, positions_of(d, k + 1));
        for (int a = 0; a < 3; a++)
            assert_true(json_number_value(item(node, "translation", a)) == turned[a]);
        if (colliders[k].kind != COLLIDER_PLANE) /* inscribed polyhedra are slightly smaller */
            assert_true(volume_of(d, k + 1) <= volume[k] * 1.000001 &&
                        volume_of(d, k + 1) > 0.98 * volume[k]);
    }
    for (int v = 0; v < 4; v++) /* the plane is level and larger than the cloth */
        assert_true(number_at(d, positions_of(d, COLLIDERS), v, 1) == 0 &&
                    fabs(number_at(d, positions_of(d, COLLIDERS), v, 0)) > 2);
}

static void test_text(void **unused) {
    (void)unused;
    assert_int_equal(gltf_write(&run, &of, 0, "run.gltf"), 0);
    document d = read_text("run.gltf");
    assert_string_equal(json_string_value(at(at(d.root, "asset"), "version")), "2.0");
    assert_int_equal(json_array_size(at(item(d.root, "scenes", 0), "nodes")), COLLIDERS + 1);
    check_cloth(&d, FRAMES);
    check_animation(&d);
    check_colliders(&d);
    forget(&d);
}

static uint32_t word_at(size_t offset) {
    uint32_t word;
    memcpy(&word, file_bytes + offset, sizeof word);
    return word;
}

/* The parts of the binary form equal those of the text form. */
static void test_binary(void **unused) {
    (void)unused;
    assert_int_equal(gltf_write(&run, &of, 0, "run.gltf"), 0);
    assert_int_equal(gltf_write(&run, &of, 1, "run.glb"), 0);
    document d = read_text("run.gltf");
    const size_t size = load("run.glb"), text = word_at(12);
    assert_memory_equal(file_bytes, "glTF\2\0\0\0", 8);
    assert_int_equal(word_at(8), size);
    assert_int_equal(text % 4, 0);
    assert_memory_equal(file_bytes + 16, "JSON", 4);
    assert_int_equal(word_at(20 + text), d.size);
    assert_memory_equal(file_bytes + 24 + text, "BIN\0", 4);
    assert_memory_equal(file_bytes + 28 + text, d.bytes, d.size);
    assert_int_equal(28 + text + d.size, size);
    json_error_t error;
    json_t *root = json_loadb((const char *)file_bytes + 20, text, 0, &error);
    assert_non_null(root);
    json_object_del(item(d.root, "buffers", 0), "uri");
    assert_true(json_equal(root, d.root));
    json_decref(root);
    forget(&d);
}

/* With one frame nothing moves, so the file must have no animation. */
static void test_one_frame(void **unused) {
    (void)unused;
    cloth_frames one = run;
    one.count = 1;
    assert_int_equal(gltf_write(&one, &of, 0, "one.gltf"), 0);
    document d = read_text("one.gltf");
    check_cloth(&d, 1);
    check_colliders(&d);
    assert_null(json_object_get(d.root, "animations"));
    assert_null(json_object_get(item(d.root, "meshes", 0), "weights"));
    forget(&d);
}

static void check_refused(const cloth_frames *frames, const char *expected) {
    start_listening("gltf-said.txt");
    assert_int_equal(gltf_write(frames, &of, 1, "refused.glb"), -1);
    stop_listening("gltf-said.txt");
    assert_string_equal(said, expected);
    assert_int_equal(access("refused.glb", F_OK), -1);
    assert_int_equal(access("refused.glb.partial", F_OK), -1);
}

static void test_limits(void **unused) {
    (void)unused;
    cloth_frames large = run;
    large.count = 2001;
    check_refused(&large, "refused.glb: 2001 frames, expected up to 2000 in a glTF file: run with "
                          "fewer --frames, or use 'fabric export' (VTK files)\n");
    large.count = 1000;
    large.vertex_count = 100000;
    check_refused(&large,
                  "refused.glb: 1204 MB, expected up to 1000 in a glTF file: run with fewer "
                  "--frames, or use 'fabric export' (VTK files)\n");
    failing = 2; /* reading this frame fails; the reader, not gltf_write, would print a message */
    check_refused(&run, "");
    failing = -1;
}

#ifdef FABRIC_WITH_ASSIMP
/* Another program's reader finds the cloth, its morph targets, and the duration. */
static void test_assimp(void **unused) {
    (void)unused;
    for (int binary = 0; binary < 2; binary++) {
        const char *path = binary ? "read.glb" : "read.gltf";
        assert_int_equal(gltf_write(&run, &of, binary, path), 0);
        const struct aiScene *read = aiImportFile(path, 0);
        if (!read)
            fail_msg("%s", aiGetErrorString());
        const struct aiMesh *cloth = read->mMeshes[0];
        assert_int_equal(read->mNumMeshes, COLLIDERS + 1);
        assert_int_equal(cloth->mNumVertices, VERTICES);
        assert_int_equal(cloth->mNumFaces, TRIANGLES);
        assert_int_equal(cloth->mNumAnimMeshes, FRAMES - 1);
        for (int v = 0; v < VERTICES; v++) {
            const struct aiVector3D *first = &cloth->mVertices[v];
            const struct aiVector3D *last = &cloth->mAnimMeshes[FRAMES - 2]->mVertices[v];
            assert_true((double)first->x == place(0, 3 * v));
            assert_true((double)first->y == place(0, 3 * v + 2));
            assert_true((double)first->z == -place(0, 3 * v + 1));
            assert_true(fabs((double)last->x - place(FRAMES - 1, 3 * v)) < 1e-6);
            assert_true(fabs((double)last->y - place(FRAMES - 1, 3 * v + 2)) < 1e-6);
            assert_true(fabs((double)last->z + place(FRAMES - 1, 3 * v + 1)) < 1e-6);
        }
        assert_int_equal(read->mNumAnimations, 1);
        const struct aiAnimation *animation = read->mAnimations[0];
        const double seconds = animation->mDuration / animation->mTicksPerSecond;
        assert_true(fabs(seconds - times[FRAMES - 1]) < 1e-6);
        assert_int_equal(animation->mNumMorphMeshChannels, 1);
        assert_int_equal(animation->mMorphMeshChannels[0]->mNumKeys, FRAMES);
        assert_int_equal(animation->mNumChannels, 2);
        aiReleaseImport(read);
    }
}
#endif

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_text),      cmocka_unit_test(test_binary),
        cmocka_unit_test(test_one_frame), cmocka_unit_test(test_limits),
#ifdef FABRIC_WITH_ASSIMP
        cmocka_unit_test(test_assimp),
#endif
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
