/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** How OpenMP's threads wait for each other. */
#ifndef FABRIC_BASE_WAITING_H
#define FABRIC_BASE_WAITING_H

/**
 * Shortens the time that waiting threads spin before they sleep. libgomp spins for milliseconds by
 * default. With other busy processes, a spinning thread takes the core from the thread that it
 * waits for. Eight runs at once on two cores took 1.27 times as long as eight of fabric-serial, and
 * take 1.07 times as long with this function (script/bench copies). libgomp reads its settings only
 * when the program is loaded, so the program executes itself again. A setting by the user is kept.
 * If the second execution fails, nothing changes. Call it first in main.
 */
void waiting_is_short(char **argv);

#endif
