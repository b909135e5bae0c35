/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The number of threads of a round of the four phases: OpenMP's number, a half, a quarter, ... or
 * one, whichever is fastest. Which one that is depends on the mesh, the machine and other programs.
 * If other programs keep cores busy, parallel regions of microseconds wait milliseconds for a
 * thread that has lost its core. A run with all threads then takes many times as long as with one.
 * The bits do not depend on the number of threads, so it may change from round to round.
 *
 * For each number of threads, the mean times of a solver iteration and of all else in a round are
 * recorded. Now and then a round is a trial of the next greater or smaller number. If it is faster,
 * a second trial follows, after one round with the present number, and the other number is chosen
 * if the second is faster than that round as well: the work of rounds changes, and one fast trial
 * may be a round with little work. A trial is abandoned between two phases once it has taken 1.5
 * times the expected time, and all trials together may cost a fiftieth of the time (plus one
 * trial).
 *
 * A process has only one team, because OpenMP's number of threads belongs to the process. Without
 * OpenMP none of this has an effect.
 */
#ifndef FABRIC_TEAM_H
#define FABRIC_TEAM_H

enum { TEAM_LEVELS = 16 };

/** The times of rounds with one number of threads. */
typedef struct team_level {
    int rounds;       /* number of rounds in the means */
    double others;    /* s per round, without the solver's iterations */
    double iteration; /* s per iteration of the solver */
    double risk;      /* s that a trial of this level is expected to lose; 0: no trial so far */
} team_level;

typedef struct team {
    int most;     /* number of threads of level 0; level l has most >> l threads. 0: nothing to
                   * choose */
    int levels;   /* number of levels; the last level has one thread */
    int level;    /* the chosen level */
    int trial;    /* level of the current round; equal to `level` unless the round is a trial */
    int upward;   /* the next trial uses more threads */
    int ended;    /* the current trial took too long: the round continues at the chosen level */
    int confirms; /* the last trial was faster, and the next one is the second */
    int rested;   /* number of rounds since the last trial */
    team_level at[TEAM_LEVELS];
    team_level between; /* the round before a second trial */
    double begun;       /* s, time at which the current round began */
    double expected;    /* s, expected time of the current round */
    double credit;      /* s that trials may lose */
    long last_iterations;
} team;

/** The measurements of a round. */
typedef struct team_round {
    double seconds, solve_seconds;
    long iterations; /* number of iterations of the solver */
} team_round;

/** Begins with `most` threads, or with one if cores are busy. */
void team_start(team *t, int most, int busy);
/** Like team_start, with OpenMP's current number of threads, after a probe for busy cores. */
void team_choose(team *t);
/** Begins a round: sets the number of threads of the calling thread's parallel regions. */
void team_begin(team *t, double now);
/** Ends a trial that takes too long. Called between two phases. */
void team_check(team *t, double now);
/** Ends the round, and restores OpenMP's number of threads. */
void team_end(team *t, const team_round *round);

/** Returns the chosen number of threads, or 0 if OpenMP's number is used. */
int team_threads(const team *t);

#endif
