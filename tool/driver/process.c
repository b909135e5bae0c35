/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "driver/process.h"

#include <assert.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

static const int caught_signals[] = {SIGINT, SIGTERM, SIGHUP, SIGPIPE};
enum { CAUGHT_COUNT = sizeof caught_signals / sizeof caught_signals[0] };

static volatile sig_atomic_t last_signal;
static volatile sig_atomic_t child; /* the running child's process id, or 0 if none runs */

static void pass_on(int number) {
    int saved = errno;
    last_signal = number;
    if (child > 0)
        kill((pid_t)child, number);
    errno = saved;
}

void process_catch_signals(void) {
    struct sigaction action;
    memset(&action, 0, sizeof action);
    action.sa_handler = pass_on;
    sigemptyset(&action.sa_mask);
    for (unsigned i = 0; i < CAUGHT_COUNT; i++) {
        struct sigaction old;
        /* signals that the parent ignores (nohup) stay ignored */
        if (sigaction(caught_signals[i], NULL, &old) == 0 && old.sa_handler != SIG_IGN)
            sigaction(caught_signals[i], &action, NULL);
    }
}

int process_signal(void) {
    return last_signal;
}

static void redirect(const char *path, int flags, int descriptor) {
    if (!path)
        return;
    int file = open(path, flags, 0600);
    if (file < 0 || dup2(file, descriptor) < 0)
        _exit(126);
    close(file);
}

static _Noreturn void run_child(char **argv, process_streams streams, const sigset_t *mask) {
    for (unsigned i = 0; i < CAUGHT_COUNT; i++) {
        struct sigaction action;
        if (sigaction(caught_signals[i], NULL, &action) == 0 && action.sa_handler == pass_on)
            signal(caught_signals[i], SIG_DFL);
    }
    sigprocmask(SIG_SETMASK, mask, NULL);
    redirect(streams.input, O_RDONLY, STDIN_FILENO);
    redirect(streams.output, O_WRONLY | O_CREAT | O_APPEND, STDOUT_FILENO);
    redirect(streams.error, O_WRONLY | O_CREAT | O_APPEND, STDERR_FILENO);
    execvp(argv[0], argv);
    int error = errno;
    fprintf(stderr, "redcc-cc: error: cannot run '%s': %s\n", argv[0], strerror(error));
    fflush(stderr);
    _exit(error == ENOENT ? 127 : 126);
}

int process_run(arena *a, const word_list *words, process_streams streams) {
    assert(child == 0);
    assert(words->count > 0);
    char **argv = words_argv(a, words);
    sigset_t caught, before;
    sigemptyset(&caught);
    for (unsigned i = 0; i < CAUGHT_COUNT; i++)
        sigaddset(&caught, caught_signals[i]);
    sigprocmask(SIG_BLOCK, &caught, &before); /* no signal may be handled between fork and the
                                               * assignment of `child` */
    if (last_signal) {
        sigprocmask(SIG_SETMASK, &before, NULL);
        return -last_signal;
    }
    fflush(NULL);
    pid_t pid = fork();
    if (pid == 0)
        run_child(argv, streams, &before);
    child = pid > 0 ? pid : 0;
    sigprocmask(SIG_SETMASK, &before, NULL);
    if (pid < 0)
        return 127;
    int status = 0;
    pid_t ended;
    do
        ended = waitpid(pid, &status, 0);
    while (ended < 0 && errno == EINTR);
    child = 0;
    if (ended < 0)
        return 127;
    return WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
}

_Noreturn void process_become(arena *a, const word_list *words) {
    assert(words->count > 0);
    char **argv = words_argv(a, words);
    fflush(NULL);
    execvp(argv[0], argv);
    int error = errno;
    fprintf(stderr, "redcc-cc: error: cannot run '%s': %s\n", argv[0], strerror(error));
    exit(error == ENOENT ? 127 : 126);
}

_Noreturn void process_end_as(int status) {
    fflush(NULL);
    if (status < 0) {
        const struct rlimit no_core = {0, 0}; /* the child may have dumped core; this
                                               * process has not crashed */
        setrlimit(RLIMIT_CORE, &no_core);
        signal(-status, SIG_DFL);
        raise(-status);
        status = 128 - status;
    }
    exit(status);
}
