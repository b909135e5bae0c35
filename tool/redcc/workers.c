/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#define _GNU_SOURCE /* MAP_ANONYMOUS */
#include "redcc/workers.h"

#include <assert.h>
#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

typedef struct piece {
    pid_t process; /* 0: not started, or ended */
    int status;    /* status as reported by wait() */
    bool is_ended;
    FILE *output, *errors; /* the process's output, if it is kept */
} piece;

typedef struct pool {
    const workers *w;
    piece *pieces;
    char *results; /* memory shared with the processes */
    unsigned begun, ended, shown;
} pool;

/* ---- output ---------------------------------------------------------------------------------- */

static bool keep_output(piece *p) {
    p->output = tmpfile();
    p->errors = tmpfile();
    return p->output && p->errors;
}

static void show(FILE *kept, FILE *stream) {
    char bytes[1 << 12];
    size_t count;
    if (!kept)
        return;
    rewind(kept);
    while ((count = fread(bytes, 1, sizeof bytes, kept)) > 0)
        fwrite(bytes, 1, count, stream);
    fclose(kept);
}

/* ---- one piece ------------------------------------------------------------------------------ */

_Noreturn static void be_worker(const pool *all, unsigned number) {
    const piece *p = &all->pieces[number];
    prctl(PR_SET_PDEATHSIG, SIGKILL); /* the child must not write after its parent has ended */
    if (p->output) {
        dup2(fileno(p->output), STDOUT_FILENO);
        dup2(fileno(p->errors), STDERR_FILENO);
    }
    all->w->work(number, all->results + number * all->w->result_size, all->w->context);
    if (fflush(stdout) != 0) {
        perror("redcc: error: cannot write standard output");
        _exit(EXIT_FAILURE);
    }
    _exit(EXIT_SUCCESS);
}

static bool begin(pool *all) {
    assert(all->begun < all->w->count);
    piece *p = &all->pieces[all->begun];
    if ((all->w->keeps_output || all->w->take) && !keep_output(p))
        return false;
    fflush(stdout);
    fflush(stderr);
    p->process = fork();
    if (p->process < 0)
        return false;
    if (p->process == 0)
        be_worker(all, all->begun);
    all->begun++;
    return true;
}

/* Waits for one process to end. */
static bool wait_for_one(pool *all) {
    int status;
    const pid_t process = wait(&status);
    if (process < 0)
        return errno == EINTR;
    for (unsigned i = 0; i < all->begun; i++)
        if (all->pieces[i].process == process) {
            all->pieces[i] = (piece){.status = status,
                                     .is_ended = true,
                                     .output = all->pieces[i].output,
                                     .errors = all->pieces[i].errors};
            all->ended++;
        }
    if (all->w->progress)
        all->w->progress(all->ended, all->w->context);
    return true;
}

static void show_ended(pool *all) {
    assert(all->shown <= all->begun);
    for (; all->shown < all->begun && all->pieces[all->shown].is_ended; all->shown++) {
        const piece *p = &all->pieces[all->shown];
        if (all->w->take) {
            rewind(p->output);
            all->w->take(all->shown, p->output, all->w->context);
            fclose(p->output);
        } else {
            show(p->output, stdout);
        }
        show(p->errors, stderr);
        int ended_by = WIFSIGNALED(p->status) ? WTERMSIG(p->status) : 0;
        if (WIFEXITED(p->status) && WEXITSTATUS(p->status) != EXIT_SUCCESS)
            ended_by = -1;
        all->w->done(all->shown, all->results + all->shown * all->w->result_size, ended_by,
                     all->w->context);
    }
}

/* ---- all ------------------------------------------------------------------------------------ */

/* Works in the caller's own process, which avoids copying pages that a large library
 * has written. */
static bool work_in_process(const workers *w) {
    for (unsigned i = 0; i < w->count; i++) {
        void *result = calloc(1, w->result_size);
        if (!result)
            return false;
        w->work(i, result, w->context);
        w->done(i, result, 0, w->context);
        free(result);
    }
    return true;
}

bool workers_run(const workers *w) {
    if (w->at_once == 0)
        return work_in_process(w);
    const size_t bytes = w->count * w->result_size + 1;
    pool all = {.w = w, .pieces = calloc(w->count + 1, sizeof(piece))};
    void *shared = mmap(NULL, bytes, PROT_READ | PROT_WRITE,
                        MAP_SHARED | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    bool is_fine = all.pieces && shared != MAP_FAILED;
    all.results = shared;
    while (is_fine && all.ended < w->count) {
        while (is_fine && all.begun < w->count && all.begun - all.ended < w->at_once)
            is_fine = begin(&all);
        is_fine = is_fine && wait_for_one(&all);
        show_ended(&all);
    }
    while (all.ended < all.begun && wait_for_one(&all))
        show_ended(&all);
    if (shared != MAP_FAILED)
        munmap(shared, bytes);
    free(all.pieces);
    return is_fine;
}

void workers_explain(const char *path, int ended_by) {
    if (ended_by > 0)
        fprintf(stderr,
                "redcc: error: %s: the parser was ended by a signal (%s); something may be nested "
                "too deeply\n",
                path, strsignal(ended_by));
    else
        fprintf(stderr, "redcc: error: %s: the parser ended too early\n", path);
}
