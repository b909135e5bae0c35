/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Progress messages: the estimated time left, and messages during long steps. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "output/progress.h"

static int kept;
static FILE *said;

/* Redirects standard error to a file, so it is not a terminal. */
static int set_up(void **unused) {
    (void)unused;
    kept = dup(STDERR_FILENO);
    said = tmpfile();
    return kept >= 0 && said && dup2(fileno(said), STDERR_FILENO) >= 0 ? 0 : -1;
}

static int tear_down(void **unused) {
    (void)unused;
    dup2(kept, STDERR_FILENO);
    close(kept);
    fclose(said);
    return 0;
}

/* Returns the text printed since the last call. */
static const char *heard(void) {
    static char text[4096];
    fflush(stderr);
    const off_t end = lseek(STDERR_FILENO, 0, SEEK_CUR);
    const ssize_t length =
        pread(STDERR_FILENO, text, sizeof text - 1, 0) < end ? 0 : end; /* all of it fits */
    text[length] = '\0';
    assert_int_equal(ftruncate(STDERR_FILENO, 0), 0);
    lseek(STDERR_FILENO, 0, SEEK_SET);
    return text;
}

static void test_lines(void **unused) {
    progress p;
    (void)unused;
    progress_begin(&p, PROGRESS_LINES, 0, 40);
    progress_report(&p, 1, 0.1, 7, 2);
    assert_string_equal(heard(), ""); /* only one line per tenth of the run */
    progress_report(&p, 2, 0.2, 14, 4);
    progress_report(&p, 3, 0.3, 21, 6);
    progress_report(&p, 4, 0.4, 28, 8);
    assert_string_equal(heard(), "step 4 of 40, t = 0.400 s, 28 iterations, 8.0 s, 1:12 left\n");
    progress_end(&p);
}

/* The latest steps count most: here they are faster than earlier ones. */
static void test_time_left(void **unused) {
    progress p;
    double seconds = 0;
    (void)unused;
    progress_begin(&p, PROGRESS_LINES, 100, 200);
    for (int step = 101; step < 200; step++)
        progress_report(&p, step, 0, 0, seconds += step < 140 ? 100 : 1);
    const char *text = heard();
    assert_non_null(
        strstr(text, "step 120 of 200, t = 0.000 s, 0 iterations, 2000.0 s, 2:13:20 left"));
    assert_non_null(
        strstr(text, "step 180 of 200, t = 0.000 s, 0 iterations, 3941.0 s, 46.3 s left"));
    progress_end(&p);
}

static void test_signs_of_life(void **unused) {
    progress p;
    (void)unused;
    progress_begin(&p, PROGRESS_LINES, 3, 40);
    assert_string_equal(heard(), "");
    raise(SIGALRM);
    assert_string_equal(heard(), "step 4 of 40 under way for 60 s\n");
    raise(SIGALRM);
    assert_string_equal(heard(), "step 4 of 40 under way for 120 s\n");
    progress_report(&p, 5, 0, 0, 130); /* no tenth part, but the step took long */
    assert_non_null(strstr(heard(), "step 5 of 40"));
    raise(SIGALRM);
    assert_string_equal(heard(), "step 6 of 40 under way for 60 s\n");
    progress_end(&p);
    raise(SIGALRM);
    assert_string_equal(heard(), "");
}

static void test_bar(void **unused) {
    progress p;
    (void)unused;
    progress_begin(&p, PROGRESS_BAR, 0, 4);
    raise(SIGALRM);
    assert_string_equal(heard(), "\rstep 1 of 4 (1 s)");
    progress_report(&p, 1, 0.1, 5, 3);
    assert_string_equal(heard(),
                        "\r[######..................] step 1 of 4, 3.0 s, 9.0 s left\033[K");
    raise(SIGALRM);
    assert_string_equal(heard(),
                        "\r[######..................] step 1 of 4, 3.0 s, 9.0 s left (1 s)");
    progress_end(&p);
    assert_string_equal(heard(), "\n");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_lines, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_time_left, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_signs_of_life, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_bar, set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
