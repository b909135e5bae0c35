/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Executes an `omp for` loop without its directive. All threads of an OpenMP team reach the loop
 * and form a crew: the first one executes the loop as redcc does any loop, and the others help to
 * execute its parallel regions. In the macros below no parenthesis follows a member's name, because
 * the program may define a macro of that name.
 */
#ifndef REDCC_CREW_H
#define REDCC_CREW_H

/** Registers the calling thread, which has reached the loop, as a thread of OpenMP. */
#define REDCC_ARRIVE(redcc_site)                                                                   \
    do {                                                                                           \
        if (redcc_run && redcc_is_known(&(redcc_site)))                                            \
            (*redcc_calls_of(&(redcc_site))->before->crew->arrive)();                              \
    } while (0)

/** Forms a crew of the team's threads; called by one thread. If directives protect the loop's
 * updates (redcc_locks), all threads of the team must have arrived (REDCC_ARRIVE). 0: no crew, and
 * the team must execute the loop as it is written. */
#define REDCC_CREW_BEGINS(redcc_site, redcc_locks)                                                 \
    (redcc_run && redcc_is_known(&(redcc_site))                                                    \
         ? (*redcc_calls_of(&(redcc_site))->before->crew->begin)(&(redcc_site).binned.loop,        \
                                                                 redcc_locks)                      \
         : 0)

/** 1: the thread has helped the first thread, and the loop is over. 0: the thread is the first one
 * and must now execute the loop, or there is no crew. */
#define REDCC_HAS_HELPED(redcc_site)                                                               \
    (redcc__crew && (*redcc_calls_of(&(redcc_site))->before->crew->help)(redcc__crew))

/** Called by the first thread after the loop: disbands the crew. */
#define REDCC_CREW_ENDS(redcc_site)                                                                \
    do {                                                                                           \
        if (redcc__crew)                                                                           \
            (*redcc_calls_of(&(redcc_site))->before->crew->end)(redcc__crew);                      \
    } while (0)

#endif
