/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/*
 * The loop of figure 2 of the paper (docs/paper.md). A step that the monitor rejects is repeated
 * with half the length. Lengths are the scene's step divided by powers of two, so that every frame
 * ends on the scene's time grid (timing.h).
 */
#include "simulation.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "barrier_step.h"
#include "base/clock.h"
#include "base/vector.h"
#include "integrator.h"
#include "rest.h"
#include "simulation_state.h"
#include "timing.h"

/* A halved step length is doubled after this number of consecutive accepted steps. */
enum { steps_before_growth = 3 };

static void find_contacts(simulation *sim) {
    collisions_detect(&sim->collisions, simulation_time(sim), sim->step.h, read_only(sim->state.x),
                      read_only(sim->state.v), read_only(sim->step.dv));
    collisions_add_friction(&sim->collisions, sim->step.stage_h, read_only(sim->state.v),
                            &sim->system);
    if (collisions_constrain(&sim->collisions, read_only(sim->state.v), &sim->constraints) != 0)
        sim->step.out_of_memory = 1;
    sim->account.effects[EFFECT_CONTACT].visited = sim->collisions.visits;
    sim->account.effects[EFFECT_FRICTION].visited = sim->collisions.friction_visits;
}

void collisionDetection(simulation *sim) {
    assert(sim->step.guess_h > 0);
    const double start = clock_seconds();
    const double scale = sim->step.h / sim->step.guess_h;
    if (sim->barrier) {
        barrier_step_detect(sim);
        sim->account.effects[EFFECT_CONTACT].seconds += clock_seconds() - start;
        return;
    }
#pragma omp parallel for schedule(static)
    for (int i = 0; i < sim->mesh->vertex_count; i++)
        for (int a = 0; a < 3; a++)
            sim->step.dv[i][a] = scale * sim->step.guess[i][a];
    if (effect_is_on(sim, EFFECT_PINS))
        sim->account.effects[EFFECT_PINS].visited += sim->collisions.pinned.count;
    if (BUILT_WITH(EFFECT_CONTACT) || BUILT_WITH(EFFECT_PINS))
        find_contacts(sim);
    sim->account.effects[EFFECT_CONTACT].seconds += clock_seconds() - start;
}

monitored_step simulation_monitored(simulation *sim) {
    return (monitored_step){
        .h = sim->step.h,
        .stage_h = sim->step.stage_h,
        .push_work = sim->step.push_work,
        .time = simulation_time(sim),
        .wind = sim->in_force.wind,
        .x = (const double(*)[3])sim->state.x,
        .v = (const double(*)[3])sim->state.v,
        .x_next = (const double(*)[3])sim->step.x_next,
        .v_next = (const double(*)[3])sim->step.v_next,
        .residual = (const double(*)[3])sim->solver.residual,
        .given = &sim->constraints,
        .cloth = &sim->cloth,
        .limit = sim->account.effects[EFFECT_STRAIN_LIMIT].active ? &sim->cloth.strain_limit : NULL,
        .collisions = &sim->collisions,
        .status = sim->step.solver_status,
        .passing = sim->self_collision.left + sim->collisions.met.left,
        .shortest = sim->step.ticks == 1,
        .futile = sim->step.ticks <= monitor_futile_parts(&sim->monitor),
        .watched = effect_is_on(sim, EFFECT_MONITOR),
    };
}

static void accept(simulation *sim) {
    assert(sim->step.verdict == STEP_GOOD && sim->step.ticks > 0);
    const size_t count = (size_t)sim->mesh->vertex_count;
    integrator_accept(sim);
    if (!sim->barrier)
        collisions_accept(&sim->collisions, sim->step.stage_h, read_only(sim->step.v_next),
                          read_only(sim->solver.residual));
    memcpy(sim->state.x, sim->step.x_next, sizeof *sim->state.x * count);
    memcpy(sim->state.v, sim->step.v_next, sizeof *sim->state.v * count);
    memcpy(sim->step.guess, sim->step.dv, sizeof *sim->step.guess * count);
    sim->step.guess_h = sim->step.h;
    monitor_accept(&sim->monitor);
    sim->account.steps_taken++;
    sim->step.easy_steps++;
    timing_accept(sim);
    if (sim->step.easy_steps >= steps_before_growth && sim->step.ticks < TICKS_PER_STEP &&
        sim->state.ticks_done % (2 * sim->step.ticks) == 0) {
        sim->step.ticks *= 2;
        sim->step.easy_steps = 0;
    }
}

static void reject(simulation *sim, monitor_verdict verdict) {
    if (simulation_log_rejections(sim) != 0)
        sim->step.out_of_memory = 1;
    else if (sim->account.steps_rejected < MOST_REJECTIONS)
        sim->account.rejections[sim->account.steps_rejected] =
            (rejection){monitor_verdict_name(verdict), simulation_time(sim), sim->step.h,
                        sim->monitor.value, sim->monitor.limit};
    sim->account.steps_rejected++;
    sim->step.easy_steps = 0;
    if (sim->step.ticks > 1)
        sim->step.ticks /= 2;
}

void updateSystem(simulation *sim) {
    const int finite = integrator_move(sim);
    monitored_step step = simulation_monitored(sim);
    step.finite = finite;
    const double start = clock_seconds();
    const monitor_verdict verdict =
        sim->barrier && sim->barrier->blocked ? STEP_NO_ROOM : monitor_check(&sim->monitor, &step);
    if (step.watched) {
        sim->account.effects[EFFECT_MONITOR].visited +=
            sim->account.effects[EFFECT_MONITOR].elements;
        sim->account.effects[EFFECT_MONITOR].seconds += clock_seconds() - start;
    }
    sim->step.verdict = verdict;
    sim->step.accepted = verdict == STEP_GOOD;
    if (sim->step.accepted)
        accept(sim);
    else
        reject(sim, verdict);
}

static void run_phase(simulation *sim, int index, void (*run)(simulation *)) {
    const double start = clock_seconds();
    run(sim);
    const double end = clock_seconds();
    sim->account.phases[index].seconds += end - start;
    sim->account.phases[index].calls++;
    team_check(&sim->team, end);
}

/* Runs the four phases with the fastest number of threads. */
static void run_round(simulation *sim) {
    const double begun = clock_seconds(), solved = sim->account.phases[PHASE_SOLVE].seconds;
    const long iterations = sim->account.iterations;
    team_begin(&sim->team, begun);
    run_phase(sim, PHASE_FORCES, evaluateForces);
    run_phase(sim, PHASE_COLLISIONS, collisionDetection);
    run_phase(sim, PHASE_SOLVE, solveSystem);
    run_phase(sim, PHASE_UPDATE, updateSystem);
    const team_round round = {.seconds = clock_seconds() - begun,
                              .solve_seconds = sim->account.phases[PHASE_SOLVE].seconds - solved,
                              .iterations = sim->account.iterations - iterations};
    team_end(&sim->team, &round);
}

static void complain(const simulation *sim, char *error) {
    const monitor *m = &sim->monitor;
    const char *where = "no state within the monitor's limits";
    if (sim->step.verdict == STEP_NO_ROOM) {
        snprintf(error, 256,
                 "bodies and pins leave the cloth no room after %g s, even in steps of %g s",
                 simulation_time(sim), sim->step.h);
        return;
    }
    if (!isfinite(m->value))
        where = "no finite state";
    snprintf(error, 256, "%s after %g s, even in steps of %g s: %s %g, limit %g", where,
             simulation_time(sim), sim->step.h, monitor_verdict_name(sim->step.verdict), m->value,
             m->limit);
}

void simulation_choose_threads(simulation *sim) {
    team_choose(&sim->team);
}

int simulation_threads(const simulation *sim) {
    return team_threads(&sim->team);
}

void simulation_stop_when(simulation *sim, const volatile sig_atomic_t *stop) {
    sim->stop = stop;
}

/* Can the step still be undone, and may it take long? Other steps need one or two rounds, so that
 * saving the state before them would cost more than it helps. */
static int may_be_undone(const simulation *sim) {
    return sim->stop && sim->state.ticks_done == 0 && !(sim->state.part > 0) &&
           (sim->barrier || sim->step.ticks < TICKS_PER_STEP);
}

/* Saves the state before the step. Returns its size. If out of memory, returns 0, and from then on
 * steps are not ended early. */
static size_t keep(simulation *sim) {
    const size_t size = simulation_saved_size(sim);
    unsigned char *kept = realloc(sim->kept, size);
    if (!kept) {
        sim->stop = NULL;
        return 0;
    }
    sim->kept = kept;
    simulation_save(sim, kept, size);
    return size;
}

/* Restores the state before the step. Returns 1, or -1 with a message in error[256]. */
static int undo(simulation *sim, size_t size, char *error) {
    if (simulation_restore(sim, sim->kept, size) == 0)
        return 1;
    snprintf(error, 256, "out of memory");
    return -1;
}

int simulation_step(simulation *sim, char *error) {
    const long frame = sim->state.frame;
    size_t kept = 0;
    if (rest_lasts(sim)) {
        sim->state.frame++;
        sim->account.steps_slept++;
        return 0;
    }
    while (sim->state.frame == frame) {
        const int shortest = sim->step.ticks == 1;
        if (kept == 0 && may_be_undone(sim))
            kept = keep(sim);
        if (kept > 0 && *sim->stop)
            return undo(sim, kept, error);
        plan_follow(sim);
        run_round(sim);
        if (!sim->step.accepted && shortest && !(kept > 0 && *sim->stop)) {
            complain(sim, error);
            return -1;
        }
    }
    rest_watch(sim);
    return 0;
}
