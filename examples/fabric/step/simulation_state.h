/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The parts of a simulation: for the files of this folder and tests. */
#ifndef FABRIC_SIMULATION_STATE_H
#define FABRIC_SIMULATION_STATE_H

#include "cloth_elements.h"
#include "contact/collision.h"
#include "contact/self_collision.h"
#include "integrator.h"
#include "monitor.h"
#include "plan.h"
#include "simulation.h"
#include "solver/solver.h"
#include "solver/solver_fallback.h"
#include "system/constraint.h"
#include "system/system.h"
#include "team.h"

/** A step may be halved ten times: time within it is counted in these. A step in which something
 *  begins or ends is cut there as well, at whatever time that is. */
enum { TICKS_PER_STEP = 1024 };

/** What acts at present, as plan.c found it. */
struct in_force {
    double wind[3];    /* m/s */
    double next_event; /* s, when something begins or ends next */
    double plan_time;  /* s, the time that it was found for */
};

/** The state accepted last. */
struct cloth_state {
    double (*x)[3]; /* [vertices] m */
    double (*v)[3]; /* [vertices] m/s */
    long frame;     /* whole steps of the scene done */
    int ticks_done; /* of the step under way */
    double part;    /* s, done beyond these: the last step was cut at an event */
};

/** The step being taken. */
struct step {
    int ticks;           /* its length, unless it is cut: a power of two */
    double h;            /* its length in s */
    int end_ticks;       /* its end, in ticks since the beginning of the scene's step */
    double end_part;     /* s, its end beyond end_ticks */
    double stage_h;      /* s, what forces are multiplied by; h for backward Euler */
    double (*guess)[3];  /* [vertices] m/s, dv of the last step accepted */
    double guess_h;      /* that step's length, s */
    double (*dv)[3];     /* [vertices] m/s */
    double (*x_next)[3]; /* [vertices] m */
    double (*v_next)[3]; /* [vertices] m/s */
    double push_work;    /* J, that keeping out of colliders by force took */
    solver_status solver_status;
    monitor_verdict verdict;
    int accepted;      /* what updateSystem decided */
    int out_of_memory; /* a constraint could not be noted: no step can be taken any more */
    int easy_steps;    /* accepted in a row at this length */
    int slow_steps;    /* of the scene, in a row, that ended at rest (rest.h) */
};

/** Counters and times of a run. */
struct run_account {
    phase phases[PHASE_COUNT];
    effect_account effects[EFFECT_COUNT];
    long iterations, steps_taken, steps_rejected, steps_slept, plans_changed;
    rejection *rejections; /* [MOST_REJECTIONS] the first ones; NULL: none so far */
};

struct simulation {
    const mesh *mesh;
    const scene *scene;
    struct cloth cloth;
    struct in_force in_force;
    struct cloth_state state;
    struct step step;
    integrator_memory integrator;
    linear_system system;
    collisions collisions;
    constraints constraints;
    self_collision self_collision; /* empty without */
    solver solver;
    solver_fallback fallback;
    monitor monitor;
    struct barrier_step *barrier; /* NULL: vertices are constrained */
    team team;                    /* how many threads rounds get */
    struct run_account account;
    arrays own; /* mass, state, the step's vectors */
};

/** How many rejections are in the log. */
static inline int simulation_rejections_logged(const simulation *sim) {
    if (!sim->account.rejections)
        return 0;
    return sim->account.steps_rejected < MOST_REJECTIONS ? (int)sim->account.steps_rejected
                                                         : MOST_REJECTIONS;
}

/** Makes the log of rejections, if there is none. 0, or -1: out of memory. */
int simulation_log_rejections(simulation *sim);

/** Does the effect act in the step being taken? */
static inline int effect_is_on(const simulation *sim, int effect) {
    return BUILT_WITH(effect) && sim->account.effects[effect].on;
}

/** Input of the monitor for the current step. */
monitored_step simulation_monitored(simulation *sim);

/** A number of ticks as part of the scene's step, s. */
static inline double ticks_to_seconds(const simulation *sim, int ticks) {
    return sim->scene->time.step * (double)ticks / (double)TICKS_PER_STEP;
}

/** The time that many ticks into the step under way, s. Exact on whole steps of exact length. */
static inline double time_at_tick(const simulation *sim, int ticks) {
    return sim->scene->time.step *
           ((double)sim->state.frame + (double)ticks / (double)TICKS_PER_STEP);
}

#endif
