/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* S35 of docs/fabric-hard-cases.md: scene and mesh files with randomly changed bytes are read, or
 * refused with a message that names the file. */
#include "check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "cloth.h"
#include "mesh/mesh_rest.h"
#include "output/obj.h"
#include "scene/scene.h"

enum { MOST = 1 << 14, TRIES = 400 };

static const char *const words[] = {
    "nan", "inf", "-1e308", "1e999", "-0", "",   ": ",   "- ",
    "{",   "]",   "\t",     "&a",    "*a", "<<", "f 1/", "99999999999999999999",
    "#",   "\n",  "\xff"};

static size_t load(const char *path, char *text) {
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    const size_t length = fread(text, 1, MOST / 2, file);
    fclose(file);
    return length;
}

/* Removes a few bytes at one place and inserts a word. Returns the new length. */
static size_t mutate(const char *from, size_t length, unsigned *seed, char *text) {
    memcpy(text, from, length);
    const size_t at = (size_t)((random_number(seed) + 1) / 2 * (double)length);
    const int word = (int)((random_number(seed) + 1) / 2 * (sizeof words / sizeof *words));
    const size_t put = strlen(words[word]), cut = (size_t)((random_number(seed) + 1) * 4);
    const size_t end = at + cut < length ? at + cut : length;
    memmove(text + at + put, text + end, length - end);
    memcpy(text + at, words[word], put);
    return length - (end - at) + put;
}

static int read_scene_file(const char *path) {
    scene s;
    if (scene_read(&s, path) != 0)
        return -1;
    scene_free(&s);
    return 0;
}

static int read_mesh_file(const char *path) {
    mesh m;
    mesh_problem found[MESH_PROBLEM_COUNT];
    char error[256];
    if (obj_read(&m, path) != 0)
        return -1;
    if (mesh_clean(&m, found, error) == 0)
        assert_int_equal(mesh_check(&m, found), 0);
    mesh_free(&m);
    return 0;
}

static void abuse(const char *original, const char *copy, int (*read)(const char *)) {
    static char from[MOST], text[MOST], said[MOST];
    const size_t length = load(original, from);
    const int kept = dup(STDERR_FILENO);
    unsigned seed = 11;
    int refused = 0;
    for (int n = 0; n < TRIES; n++) {
        FILE *file = fopen(copy, "wb");
        assert_non_null(file);
        const size_t size = mutate(from, length, &seed, text);
        assert_int_equal(fwrite(text, 1, size, file), size);
        fclose(file);
        assert_non_null(freopen("said.txt", "wb", stderr));
        const int status = read(copy);
        fflush(stderr);
        said[load("said.txt", said)] = '\0';
        dup2(kept, STDERR_FILENO);
        assert_int_equal(status != 0, said[0] != '\0');
        assert_true(status == 0 || strncmp(said, copy, strlen(copy)) == 0);
        refused += status != 0;
    }
    close(kept);
    print_message("S35 %s: %d of %d refused\n", copy, refused, TRIES);
    assert_in_range(refused, TRIES / 8, TRIES - 10);
}

static void S35_scene_files(void **state) {
    (void)state;
    abuse(SCENES_FOLDER "/patch.yaml", "abused.yaml", read_scene_file);
}

static void S35_mesh_files(void **state) {
    (void)state;
    mesh m = cloth_sheet(5, 5, 0.1, 0.3, 1);
    assert_int_equal(obj_write(&m, "whole.obj"), 0);
    cloth_free(&m);
    abuse("whole.obj", "abused.obj", read_mesh_file);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(S35_scene_files),
        cmocka_unit_test(S35_mesh_files),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
