/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * `omp for`, to which all threads of a team come, executed without its directive: the first thread
 * executes the loop, and the others work for it.
 */
#ifndef REDCC_CREW_H
#define REDCC_CREW_H

/** The calling thread has come, and belongs to OpenMP. */
#define REDCC_ARRIVE(redcc_site)                                                                   \
    do {                                                                                           \
        if (redcc_run && redcc_is_known(&(redcc_site)))                                            \
            (redcc_site).calls->before->crew->arrive();                                            \
    } while (0)

/** The team as a crew; 0: it must execute the loop as it is written. By one thread, for all. If
 *  directives protect the loop's updates (redcc_locks), all must have arrived. */
#define REDCC_MEET(redcc_site, redcc_locks)                                                        \
    (redcc_run && redcc_is_known(&(redcc_site))                                                    \
         ? (redcc_site).calls->before->crew->meet(&(redcc_site).binned.loop, redcc_locks)          \
         : 0)

/** Has the calling thread helped the first one to execute the loop? */
#define REDCC_HAS_HELPED(redcc_site)                                                               \
    (redcc__crew && (redcc_site).calls->before->crew->help(redcc__crew))

/** The first thread has executed it. */
#define REDCC_CREW_ENDS(redcc_site)                                                                \
    do {                                                                                           \
        if (redcc__crew)                                                                           \
            (redcc_site).calls->before->crew->end(redcc__crew);                                    \
    } while (0)

#endif
