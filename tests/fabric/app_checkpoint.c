/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Checkpoint files that are truncated at many lengths, or have flipped bits. Those with a wrong
 * checksum must be refused. Those with a correct one must at least do no harm. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <fcntl.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "output/checkpoint.h"
#include "output/sealed_file.h"
#include "step/simulation_state.h"

static const char FILE_NAME[] = "test.checkpoint", WRONG[] = "wrong.checkpoint";

/* A run with a few vertices after two steps, and its checkpoint. */
static scene wanted;
static mesh cloth;
static simulation *sim;
static unsigned char bytes[65536];
static size_t size;

static int set_up(void **unused) {
    static const char *const settings[] = {"mesh.boundary=8", "mesh.vertices=14",
                                           "mesh.origin=[0, 0, 0.21]", "self_collision.gap=0.001"};
    char error[256] = "";
    (void)unused;
    if (scene_read(&wanted, SCENES_FOLDER "/patch.yaml") != 0)
        return -1;
    for (size_t k = 0; k < sizeof settings / sizeof *settings; k++)
        if (scene_set(&wanted, settings[k]) != 0)
            return -1;
    if (scene_mesh(&wanted, &cloth, NULL) != 0)
        return -1;
    sim = simulation_new(&cloth, &wanted, error);
    for (int n = 0; n < 2; n++)
        if (!sim || simulation_step(sim, error) != 0)
            return -1;
    sim->fallback.costly = 1;
    const run_record record = {.step = 2, .frames = 25, .every = 4, .seconds = 1.5};
    if (checkpoint_write(&record, &wanted, &cloth, sim, FILE_NAME) != 0)
        return -1;
    FILE *file = fopen(FILE_NAME, "rb");
    size = file ? fread(bytes, 1, sizeof bytes, file) : 0;
    if (file)
        fclose(file);
    return size > 0 && size < sizeof bytes ? 0 : -1;
}

static int tear_down(void **unused) {
    (void)unused;
    simulation_free(sim);
    mesh_free(&cloth);
    scene_free(&wanted);
    return 0;
}

/* Redirects standard error, since thousands of messages would be useless. Returns the descriptor to
 * restore. */
static int hush(void) {
    const int kept = dup(STDERR_FILENO), nowhere = open("/dev/null", O_WRONLY);
    assert_true(kept >= 0 && nowhere >= 0);
    dup2(nowhere, STDERR_FILENO);
    close(nowhere);
    return kept;
}

static void speak(int kept) {
    dup2(kept, STDERR_FILENO);
    close(kept);
}

static void write_wrong(const unsigned char *from, size_t count) {
    FILE *file = fopen(WRONG, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(from, 1, count, file), count);
    fclose(file);
}

/* Resumes from the file as `fabric run --resume` does. */
static int resume(const char *path, simulation *into) {
    checkpoint c;
    char said[256];
    if (checkpoint_read(&c, path) != 0) {
        assert_null(c.memory);
        return -1;
    }
    const int status = scene_differ(&c.of, &wanted, said)
                           ? -1
                           : checkpoint_restore(&c, &wanted, &cloth, into, path);
    checkpoint_free(&c);
    return status;
}

static void test_round_trip(void **unused) {
    char error[256];
    checkpoint c;
    (void)unused;
    assert_int_equal(access("test.checkpoint.partial", F_OK), -1);
    assert_int_equal(checkpoint_read(&c, FILE_NAME), 0);
    assert_int_equal(c.record.step, 2);
    assert_int_equal(c.record.frames, 25);
    assert_int_equal(c.record.every, 4);
    assert_true(c.record.seconds == 1.5);
    assert_int_equal(c.of.mesh.vertices, 14);
    checkpoint_free(&c);
    simulation *other = simulation_new(&cloth, &wanted, error);
    assert_non_null(other);
    assert_int_equal(resume(FILE_NAME, other), 0);
    assert_memory_equal(simulation_positions(other), simulation_positions(sim),
                        sizeof(double[3]) * (size_t)cloth.vertex_count);
    assert_int_equal(simulation_counts(other).taken, simulation_counts(sim).taken);
    assert_int_equal(other->fallback.costly, 1); /* else direct solutions might return */
    simulation_free(other);
}

static void test_torn(void **unused) {
    const int kept = hush();
    size_t taken = 0;
    (void)unused;
    for (size_t length = 0; length < size; length += length < 300 ? 1 : 7) {
        write_wrong(bytes, length);
        taken += resume(WRONG, sim) == 0;
    }
    write_wrong(bytes, size + 1);
    taken += resume(WRONG, sim) == 0;
    speak(kept);
    assert_int_equal(taken, 0);
}

static void test_flipped_bits(void **unused) {
    const int kept = hush();
    size_t taken = 0;
    (void)unused;
    write_wrong(bytes, size);
    FILE *file = fopen(WRONG, "r+b");
    assert_non_null(file);
    for (size_t at = 0; at < size; at++)
        for (unsigned bit = 0; bit < 8; bit++) {
            if (at >= 128 && at % 8 != bit) /* all bits of the header */
                continue;
            const unsigned char wrong = (unsigned char)(bytes[at] ^ 1u << bit);
            assert_int_equal(pwrite(fileno(file), &wrong, 1, (off_t)at), 1);
            taken += resume(WRONG, sim) == 0;
            assert_int_equal(pwrite(fileno(file), &bytes[at], 1, (off_t)at), 1);
        }
    fclose(file);
    speak(kept);
    assert_int_equal(taken, 0);
    assert_int_equal(resume(WRONG, sim), 0);
}

/* Replaces the checksum by the correct one. */
static void seal(unsigned char *all, size_t count) {
    sealed_header header;
    memcpy(&header, all, sizeof header);
    header.checksum = 0;
    header.payload_size = count - sizeof header;
    header.checksum = fnv_1a(fnv_1a(FNV_1A_BEGIN, &header, sizeof header), all + sizeof header,
                             count - sizeof header);
    memcpy(all, &header, sizeof header);
}

/* Files with flipped bits and a correct checksum may be refused or accepted, but must do no harm.
 * Steps from an accepted state must end as well. */
static void test_sealed_nonsense(void **unused) {
    static unsigned char changed[sizeof bytes];
    unsigned long long random = 1;
    const int kept = hush();
    int refused = 0;
    (void)unused;
    for (int n = 0; n < 250; n++) {
        char error[256];
        memcpy(changed, bytes, size);
        for (int k = 0; k <= n % 3; k++) {
            random = random * 6364136223846793005u + 1442695040888963407u;
            changed[64 + (random >> 33) % (size - 64)] ^= (unsigned char)(1u << (random >> 61));
        }
        seal(changed, size - (n % 50 == 0));
        write_wrong(changed, size - (n % 50 == 0));
        simulation *other = simulation_new(&cloth, &wanted, error);
        assert_non_null(other);
        const int status = resume(WRONG, other);
        refused += status != 0;
        if (status == 0 && n % 4 == 0)
            simulation_step(other, error);
        simulation_free(other);
    }
    speak(kept);
    assert_true(refused > 50);
}

/* The mesh differs from the scene's: the same counts, another seed. */
static void test_other_mesh(void **unused) {
    mesh other = cloth;
    checkpoint c;
    (void)unused;
    other.position = malloc(sizeof *other.position * (size_t)cloth.vertex_count);
    assert_non_null(other.position);
    memcpy(other.position, cloth.position, sizeof *other.position * (size_t)cloth.vertex_count);
    other.position[3][1] = nextafter(other.position[3][1], 1);
    assert_int_equal(checkpoint_read(&c, FILE_NAME), 0);
    assert_int_equal(checkpoint_restore(&c, &wanted, &other, sim, FILE_NAME), -1);
    assert_int_equal(checkpoint_restore(&c, &wanted, &cloth, sim, FILE_NAME), 0);
    checkpoint_free(&c);
    free(other.position);
}

static void test_unwritable(void **unused) {
    const run_record record = {.step = 2};
    (void)unused;
    assert_int_equal(checkpoint_write(&record, &wanted, &cloth, sim, "no-such-folder/x"), -1);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_round_trip),   cmocka_unit_test(test_torn),
        cmocka_unit_test(test_flipped_bits), cmocka_unit_test(test_sealed_nonsense),
        cmocka_unit_test(test_other_mesh),   cmocka_unit_test(test_unwritable),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
