/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#define _GNU_SOURCE /* pthread_attr_setaffinity_np */
#include "base/room.h"

#if defined(__linux__) && defined(__LP64__)

#include "base/system.h"
#include "base/team.h"

#include <linux/futex.h>
#include <pthread.h>

#define WEAK __attribute__((__weak__))
extern void GOMP_parallel(void) WEAK;
extern void __kmpc_fork_call(void) WEAK;
extern __typeof__(pthread_create) pthread_create WEAK;
extern __typeof__(pthread_join) pthread_join WEAK;
extern __typeof__(pthread_attr_init) pthread_attr_init WEAK;
extern __typeof__(pthread_attr_destroy) pthread_attr_destroy WEAK;
extern int pthread_attr_setaffinity_np(pthread_attr_t *, size_t, const cpu_set_t *) WEAK;
extern __typeof__(pthread_attr_setstacksize) pthread_attr_setstacksize WEAK;

enum {
    STACK = 64 * 1024,
    LONGEST_START = 130 * 1000, /* ns: who has room comes in 0.1 ms, */
    EACH = 20 * 1000,           /* and is started in 10 to 15 microseconds */
    WORD_BITS = 8 * sizeof(unsigned long)
};

struct processors {
    unsigned long word[REDCC_CORE_WORDS];
    long bytes; /* that the system knows of; 0: none */
};

/* Those that the thread may run on. */
static struct processors allowed_to(long thread) {
    struct processors all;
    all.bytes = redcc_system(SYS_sched_getaffinity, thread, sizeof all.word, all.word);
    return all.bytes > 0 ? all : (struct processors){.bytes = 0};
}

/* ... but for one of them. */
static struct processors without(struct processors all, int core) {
    unsigned long any = 0;
    all.word[core / WORD_BITS] &= ~(1ul << core % WORD_BITS);
    for (long word = 0; word < all.bytes / (long)sizeof *all.word; word++)
        any |= all.word[word];
    all.bytes = any ? all.bytes : 0;
    return all;
}

static bool place(long thread, struct processors where) {
    return redcc_system(SYS_sched_setaffinity, thread, where.bytes, where.word) == 0;
}

/* To the processor that the helper leaves. */
static void move_starter(const struct room *room) {
    const int core = redcc_system_core();
    const struct processors all = allowed_to(room->starter);
    struct processors one = {.bytes = all.bytes};
    if (core < 0 || core == room->core || all.bytes == 0)
        return;
    one.word[core / WORD_BITS] = 1ul << core % WORD_BITS;
    redcc_cores_change(room->cores, room->core, core);
    if (place(room->starter, one))
        place(room->starter, all);
}

static void *help(void *given) {
    struct room *room = given;
    const struct timespec longest = {0, room->longest};
    redcc_system(SYS_futex, &room->entered, FUTEX_WAIT_PRIVATE, 0, &longest);
    if (!atomic_load(&room->entered))
        move_starter(room);
    return NULL;
}

/* LLVM's library does not have the one that asks wait. */
static bool is_known(void) {
    return GOMP_parallel && !__kmpc_fork_call && pthread_create && pthread_join &&
           pthread_attr_init && pthread_attr_destroy && pthread_attr_setaffinity_np &&
           pthread_attr_setstacksize;
}

/* Where the helper would have to wait for a processor, its end would have to be waited for. A
 * thread too many may be one too few for OpenMP, which ends the program then. */
static bool is_free(int others) {
    return !redcc_cores_are_wanted(others) && !redcc_team_is_limited();
}

void redcc_room_begin(struct room *room, struct cores *cores, int others) {
    pthread_attr_t attributes;
    *room = (struct room){.cores = cores,
                          .core = others > 0 ? redcc_system_core() : -1,
                          .longest = LONGEST_START + (long)others * EACH};
    if (others < 1 || room->core < 0 || !is_known() || !is_free(others))
        return;
    room->starter = redcc_system(SYS_gettid);
    const struct processors where = without(allowed_to(0), room->core);
    if (where.bytes == 0 || pthread_attr_init(&attributes) != 0)
        return;
    pthread_t helper;
    room->is_helped = pthread_attr_setstacksize(&attributes, STACK) == 0 &&
                      pthread_attr_setaffinity_np(&attributes, (size_t)where.bytes,
                                                  (const cpu_set_t *)where.word) == 0 &&
                      pthread_create(&helper, &attributes, help, room) == 0;
    if (room->is_helped)
        room->helper = (unsigned long)helper;
    pthread_attr_destroy(&attributes);
}

void redcc_room_end(struct room *room) {
    if (!room->is_helped)
        return;
    atomic_store(&room->entered, 1);
    redcc_system(SYS_futex, &room->entered, FUTEX_WAKE_PRIVATE, 1);
    pthread_join((pthread_t)room->helper, NULL);
    room->is_helped = false;
}

#else

void redcc_room_begin(struct room *room, struct cores *cores, int others) {
    (void)cores;
    (void)others;
    *room = (struct room){0};
}

void redcc_room_end(struct room *room) {
    (void)room;
}

#endif
