/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The number of threads of a round of the four phases: OpenMP's number, a half, a quarter, ... or
 * one, whichever is fastest. It depends on the mesh, the machine and other programs: with busy
 * neighbours, regions of microseconds wait milliseconds for a thread that has lost its core, and a
 * run with all threads takes many times as long as with one. The bits do not depend on the number
 * of threads, so it may change from round to round.
 *
 * For each number of threads the time of a round is kept in two parts, an iteration of the solver
 * and the rest. Now and then the next number up or down gets a round, and is kept if it is faster.
 * Such a trial ends between two phases once it has taken 1.5 times the expected time, and all
 * trials together may cost a fiftieth of the time (and one trial).
 *
 * One team per process, as OpenMP's number of threads belongs to the process. Without OpenMP none
 * of this has an effect.
 */
#ifndef FABRIC_TEAM_H
#define FABRIC_TEAM_H

enum { TEAM_LEVELS = 16 };

/** What rounds at one count of threads have taken. */
typedef struct team_level {
    int rounds;       /* that went into the means */
    double others;    /* s a round, but for the solver's iterations */
    double iteration; /* s */
    double risk;      /* s that a trial here is expected to lose; 0: not tried since it was left */
} team_level;

typedef struct team {
    int most;   /* threads of level 0; level l has most >> l. 0: nothing to choose */
    int levels; /* the last one has one thread */
    int level;  /* of rounds that are no trial */
    int trial;  /* the level of the round under way; `level` where it is no trial */
    int upward; /* the next trial is of more threads */
    int ended;  /* the trial under way took too long: the round goes on with the chosen count */
    team_level at[TEAM_LEVELS];
    double begun;    /* s, when the round under way began */
    double expected; /* s that it should take */
    double credit;   /* s that trials may lose */
    long last_iterations;
} team;

/** A round's account. */
typedef struct team_round {
    double seconds, solve_seconds;
    long iterations; /* of the solver */
} team_round;

/** Begins with `most` threads, or with one where cores are busy. */
void team_start(team *t, int most, int busy);
/** The same with OpenMP's current number of threads, after a probe for busy cores. */
void team_choose(team *t);
/** A round begins: its threads are set, for this thread's parallel regions. */
void team_begin(team *t, double now);
/** Between two phases: ends a trial that takes too long. */
void team_look(team *t, double now);
/** The round is over; OpenMP's count of threads is as it was. */
void team_end(team *t, const team_round *round);

/** Threads of rounds that are no trial; 0: what OpenMP gives. */
int team_threads(const team *t);

#endif
