/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** How the threads of OpenMP's regions wait. */
#ifndef FABRIC_BASE_WAITING_H
#define FABRIC_BASE_WAITING_H

/**
 * Shortens the time that waiting threads spin before they sleep. libgomp spins for milliseconds by
 * default. With other busy processes, a spinning thread takes the core from the thread that it
 * waits for. Eight runs at once on two cores took 1.27 times as long as eight of fabric-serial, and
 * take 1.04 with this function (script/bench copies). libgomp reads its settings only when the
 * program is loaded, so the program executes itself again. A setting by the user is kept. If this
 * fails, nothing changes. Call it first in main.
 */
void waiting_is_short(char **argv);

#endif
