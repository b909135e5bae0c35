/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/*
 * The system starts and wakes a thread where the one is that asked for it, though another processor
 * is idle, and leaves both there for some milliseconds: until the first one waits long enough, or
 * its time is over. Of regions of 0.45 ms by 2 threads on 2 idle processors the first ones took 4
 * and 8 ms each, in 11 processes of 12 (Linux 6.18, gcc 12's libgomp, that waits actively); with
 * this, 0.46.
 */
#include "base/cores.h"

#include "base/affinity.h"
#include "base/clock.h"
#include "base/system.h"

enum {
    WORD = 8 * sizeof(unsigned long),
    WORDS = sizeof((struct cores){0}.taken) / sizeof(unsigned long)
};

static unsigned long bit_of(int core) {
    return 1ul << core % WORD;
}

/* Was somebody there already? */
static bool take(struct cores *cores, int core) {
    if (core < 0 || core >= WORD * WORDS)
        return false;
    return atomic_fetch_or_explicit(&cores->taken[core / WORD], bit_of(core),
                                    memory_order_relaxed) &
           bit_of(core);
}

static void leave(struct cores *cores, int core) {
    if (0 <= core && core < WORD * WORDS)
        atomic_fetch_and_explicit(&cores->taken[core / WORD], ~bit_of(core), memory_order_relaxed);
}

void redcc_cores_begin(struct cores *cores) {
    for (int word = 0; word < WORDS; word++)
        atomic_store_explicit(&cores->taken[word], 0, memory_order_relaxed);
    atomic_store_explicit(&cores->come, 0, memory_order_relaxed);
    take(cores, redcc_system_core());
}

/* A thread that sleeps between regions is woken where the system has room for it, perhaps on the
 * waker's processor each time. To move takes some 0.05 to 0.1 ms. */
static const double least_between = 2e-3;
static _Thread_local double moved_last __attribute__((__tls_model__("initial-exec")));

/* To a processor that is neither `core`, where the thread is, nor taken. */
static void move(struct cores *cores, int core) {
    const double now = redcc_seconds();
    if (core < 0 || core >= WORD * WORDS || now - moved_last < least_between)
        return;
    moved_last = now;
    unsigned long taken[WORDS];
    for (int word = 0; word < WORDS; word++)
        taken[word] = atomic_load_explicit(&cores->taken[word], memory_order_relaxed);
    taken[core / WORD] |= bit_of(core);
    redcc_processors_leave(taken, WORDS);
}

void redcc_cores_take(struct cores *cores) {
    const int core = redcc_system_core();
    atomic_fetch_add_explicit(&cores->come, 1, memory_order_relaxed);
    if (!take(cores, core))
        return;
    move(cores, core);
    take(cores, redcc_system_core());
}

void redcc_cores_change(struct cores *cores, int from, int to) {
    leave(cores, from); /* who comes to it may stay */
    take(cores, to);
}

/* Threads that the system starts on processors of their own come after 0.1 ms. */
static const double longest_start = 0.15e-3;

void redcc_cores_give_way(struct cores *cores, int others) {
    const double until = redcc_seconds() + longest_start;
    while (atomic_load_explicit(&cores->come, memory_order_relaxed) < others)
        if (redcc_seconds() > until) {
            const int core = redcc_system_core();
            leave(cores, core);
            move(cores, core);
            take(cores, redcc_system_core());
            return;
        }
}

/* A look takes 4 microseconds. */
static const double least_between_looks = 1e-3;

bool redcc_cores_are_wanted(int more) {
    static _Atomic double looked;
    static atomic_int running, online = -1;
    if (atomic_load(&online) < 0) {
        const int all = redcc_system_online();
        atomic_store(&online, all == redcc_processors_here() ? all : 0);
    }
    if (atomic_load(&online) == 0)
        return false;
    const double now = redcc_seconds();
    if (now - atomic_load(&looked) > least_between_looks) {
        atomic_store(&looked, now);
        atomic_store(&running, redcc_system_running());
    }
    return atomic_load(&running) + more > atomic_load(&online);
}
