/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#define _GNU_SOURCE /* pthread_attr_setaffinity_np */
#include "base/room.h"

#if defined(__linux__) && defined(__LP64__)

#include "base/affinity.h"
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
    EACH = 20 * 1000            /* and is started in 10 to 15 microseconds */
};

/* To the processor that the helper leaves. */
static void move_starter(const struct room *room) {
    const int core = redcc_system_core();
    const struct processors all = redcc_processors_of(room->starter);
    const struct processors one = redcc_processors_only(all, core);
    if (core == room->core || one.bytes == 0)
        return;
    redcc_cores_change(room->cores, room->core, core);
    redcc_processors_move(room->starter, &one, &all);
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
    if (room->core < 0 || !is_known() || !is_free(others))
        return;
    room->starter = redcc_system(SYS_gettid);
    const struct processors all = redcc_processors_of(0),
                            own = redcc_processors_only(all, room->core);
    const struct processors where = redcc_processors_without(all, own.word, REDCC_CORE_WORDS);
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
