/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Room for threads that OpenMP starts. The system may start them on the processor of the one that
 * asks for them, though another one is idle; GNU's library has that one wait for them actively,
 * which keeps them from coming: 1.7 to 6 ms for one thread on 2 idle processors (Linux 6.18). A
 * thread of our own, on another processor, sees that they do not come and moves who waits: 0.3 ms.
 */
#ifndef REDCC_BASE_ROOM_H
#define REDCC_BASE_ROOM_H

#include "base/cores.h"

#include <stdatomic.h>
#include <stdbool.h>

struct room {
    struct cores *cores;
    atomic_uint entered;  /* the region: by the one that asked */
    long starter;         /* the thread that did */
    long longest;         /* nanoseconds that the others take to come, if they have room */
    int core;             /* where it was */
    unsigned long helper; /* a pthread_t */
    bool is_helped;
};

/** Before the region, by the thread that has just begun `cores`: `others` must be started for it;
 * if any, its signals are held. Where nothing can be done, or other programs want the processors,
 *  nothing happens. */
void redcc_room_begin(struct room *room, struct cores *cores, int others);

/** By the same thread, in the region. */
void redcc_room_end(struct room *room);

#endif
