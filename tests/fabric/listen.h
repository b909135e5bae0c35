/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Records what a function prints on standard error, for tests of messages. Include after
 * cmocka.h. */
#ifndef FABRIC_TEST_LISTEN_H
#define FABRIC_TEST_LISTEN_H

#include <stdio.h>
#include <unistd.h>

static char said[4096]; /* text printed between the last start and stop */
static int kept_error = -1;

/** Redirects standard error to a file, whose name is different in each test program. */
static void start_listening(const char *file_name) {
    fflush(stderr);
    kept_error = dup(STDERR_FILENO);
    assert_non_null(freopen(file_name, "w", stderr));
}

static void stop_listening(const char *file_name) {
    fflush(stderr);
    FILE *file = fopen(file_name, "r");
    assert_non_null(file);
    said[fread(said, 1, sizeof said - 1, file)] = '\0';
    fclose(file);
    dup2(kept_error, STDERR_FILENO);
    close(kept_error);
}

#endif
