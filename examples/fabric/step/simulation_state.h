/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The parts of a simulation, for the files of this folder and for tests. */
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

/** The time within a step of the scene is counted in ticks, so that a step may be halved ten times.
 *  A step with an event (plan_events) is also cut at the event's time, which need not be a whole
 *  tick. */
enum { TICKS_PER_STEP = 1024 };

/** The current wind and events, as plan.c found them. */
struct in_force {
    double wind[3];    /* m/s */
    double next_event; /* s, time of the next event (plan_events) */
    double plan_time;  /* s, the time for which plan.c found them */
};

/** The state accepted last. */
struct cloth_state {
    double (*x)[3]; /* [vertices] m */
    double (*v)[3]; /* [vertices] m/s */
    long frame;     /* number of completed steps of the scene */
    int ticks_done; /* number of ticks completed in the scene's current step */
    double part;    /* s, time completed beyond ticks_done; > 0 if the last step was cut at an
                     * event */
};

/** The step being taken. */
struct step {
    int ticks;           /* the step's length in ticks unless it is cut; a power of two */
    double h;            /* the step's length in s */
    int end_ticks;       /* the step's end, in ticks since the beginning of the scene's step */
    double end_part;     /* s, time of the step's end beyond end_ticks */
    double stage_h;      /* s, length tau of the integrator's stage (integrator.h) */
    double (*guess)[3];  /* [vertices] m/s, dv of the last accepted step */
    double guess_h;      /* s, length of that step */
    double (*dv)[3];     /* [vertices] m/s */
    double (*x_next)[3]; /* [vertices] m */
    double (*v_next)[3]; /* [vertices] m/s */
    double push_work;    /* J, work of bodies, as in monitored_step */
    solver_status solver_status;
    monitor_verdict verdict;
    int accepted;      /* decided by updateSystem */
    int out_of_memory; /* an allocation failed: no further step is possible */
    int easy_steps;    /* number of consecutive accepted steps at this length */
    int slow_steps;    /* number of consecutive steps of the scene that ended slowly (rest.h) */
};

/** Counters and times of a run. */
struct run_account {
    phase phases[PHASE_COUNT];
    effect_account effects[EFFECT_COUNT];
    long iterations, steps_taken, steps_rejected, steps_slept, plans_changed;
    rejection *rejections; /* [MOST_REJECTIONS] the log; NULL: no rejection so far */
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
    self_collision self_collision; /* zeroed if the scene has none */
    solver solver;
    solver_fallback fallback;
    monitor monitor;
    struct barrier_step *barrier; /* NULL: contact by constraints (collision.h) */
    team team;                    /* chooses the number of threads */
    struct run_account account;
    const volatile sig_atomic_t *stop; /* nonzero ends a step at once; NULL if nothing can end it */
    unsigned char *kept; /* the state before the last step that could be ended, or NULL */
    arrays own;          /* mass, state, the step's vectors */
};

/** The number of rejections in the log. */
static inline int simulation_rejections_logged(const simulation *sim) {
    if (!sim->account.rejections)
        return 0;
    return sim->account.steps_rejected < MOST_REJECTIONS ? (int)sim->account.steps_rejected
                                                         : MOST_REJECTIONS;
}

/** Allocates the log of rejections, if there is none. Returns 0, or -1 if out of memory. */
int simulation_log_rejections(simulation *sim);

/** Does the effect act in the current step? */
static inline int effect_is_on(const simulation *sim, int effect) {
    return BUILT_WITH(effect) && sim->account.effects[effect].on;
}

/** Input of the monitor for the current step. */
monitored_step simulation_monitored(simulation *sim);

/** Converts ticks to s. */
static inline double ticks_to_seconds(const simulation *sim, int ticks) {
    return sim->scene->time.step * (double)ticks / (double)TICKS_PER_STEP;
}

/** Returns the time, s, after this number of ticks of the scene's current step. It has no rounding
 *  error at whole steps if the step's length is exact. */
static inline double time_at_tick(const simulation *sim, int ticks) {
    return sim->scene->time.step *
           ((double)sim->state.frame + (double)ticks / (double)TICKS_PER_STEP);
}

#endif
