/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "problem.h"

#include "loop.h"

#include <stdlib.h>
#include <string.h>

unsigned long next_random(unsigned long *state) {
    *state ^= *state << 13;
    *state ^= *state >> 7;
    *state ^= *state << 17;
    return *state;
}

enum order { SORTED, SHUFFLED, ONE_ELEMENT, BACKWARDS };

struct shape {
    const char *name;
    long trip;
    int per_iteration; /* touches per iteration; if negative, from 0 to -per_iteration */
    int rows, width;
    int second_rows, second_width;
    enum order order;
    bool second_in_first;
};

static const struct shape shapes[PROBLEMS] = {
    {"sorted", 5000, 3, 2000, 1, 0, 0, SORTED, false},
    {"shuffled", 5000, 2, 2000, 1, 0, 0, SHUFFLED, false},
    {"rows of 3, sorted", 4000, 3, 900, 3, 0, 0, SORTED, false},
    {"rows of 9, shuffled", 3000, 3, 500, 9, 0, 0, SHUFFLED, false},
    {"all to one element", 3000, 1, 50, 1, 0, 0, ONE_ELEMENT, false},
    {"one iteration", 1, 4, 20, 3, 0, 0, SHUFFLED, false},
    {"one element", 700, 2, 1, 1, 0, 0, SHUFFLED, false},
    {"no iteration", 0, 1, 10, 1, 0, 0, SORTED, false},
    {"iterations without updates", 4000, -2, 1000, 1, 0, 0, SORTED, false},
    {"vector and matrix, sorted", 4000, 3, 800, 3, 800, 9, SORTED, false},
    {"two arrays, shuffled", 3000, 2, 700, 1, 90, 2, SHUFFLED, false},
    {"two pointers into one array", 3000, 2, 900, 1, 900, 1, SORTED, true},
    {"thousands of touches", 40, 3000, 5000, 1, 0, 0, SHUFFLED, false},
    {"backwards", 5000, 2, 3000, 1, 0, 0, BACKWARDS, false},
};

static int choose_row(const struct shape *shape, long t, int rows, unsigned long *random) {
    const long near = (long)(next_random(random) % 17) - 8;
    const long along = shape->trip ? t * rows / shape->trip : 0;
    switch (shape->order) {
    case SHUFFLED:
        return (int)(next_random(random) % (unsigned long)rows);
    case ONE_ELEMENT:
        return rows / 3;
    case SORTED:
        return (int)((along + near + rows) % rows);
    case BACKWARDS:
        return (int)(rows - 1 - (along + near + rows) % rows);
    }
    return 0;
}

struct problem problem_new(int number, bool exact) {
    const struct shape *shape = &shapes[number];
    const long most = labs((long)shape->per_iteration);
    unsigned long random = 88172645463325252u + (unsigned long)number;
    struct problem problem = {.name = shape->name,
                              .trip = shape->trip,
                              .rows = shape->rows,
                              .width = shape->width,
                              .second_rows = shape->second_rows,
                              .second_width = shape->second_width,
                              .second_in_first = shape->second_in_first};
    const size_t room = (size_t)(shape->trip * most) + 1;
    problem.start = malloc(((size_t)shape->trip + 1) * sizeof *problem.start);
    problem.row = malloc(room * sizeof *problem.row);
    problem.other = malloc(room * sizeof *problem.other);
    problem.value = malloc(room * sizeof *problem.value);
    for (long t = 0; t < shape->trip; t++) {
        problem.start[t] = (int)problem.touches;
        long count = most;
        if (shape->per_iteration < 0) /* the last iteration has no touches */
            count = t + 1 == shape->trip ? 0 : (long)(next_random(&random) % (size_t)(most + 1));
        for (long k = 0; k < count; k++) {
            const long at = problem.touches++;
            problem.row[at] = choose_row(shape, t, shape->rows, &random);
            problem.other[at] = problem.row[at];
            if (shape->second_rows != shape->rows && shape->second_rows)
                problem.other[at] = choose_row(shape, t, shape->second_rows, &random);
            const long whole = (long)(next_random(&random) % 201) - 100;
            problem.value[at] = exact ? (double)whole : (double)whole / 3.0 + 1e-7 * (double)at;
        }
    }
    problem.start[shape->trip] = (int)problem.touches;
    problem.doubles = (long)problem.rows * problem.width;
    if (shape->second_in_first) { /* the second array begins in the middle of the first one */
        problem.doubles += (long)problem.second_rows * problem.second_width / 2;
        problem.first = malloc((size_t)problem.doubles * sizeof(double));
        problem.second =
            problem.first + problem.doubles - (long)problem.second_rows * problem.second_width;
    } else {
        problem.first = malloc((size_t)problem.doubles * sizeof(double));
        if (problem.second_width)
            problem.second =
                malloc((size_t)problem.second_rows * (size_t)problem.second_width * sizeof(double));
    }
    problem_reset(&problem);
    return problem;
}

void problem_free(struct problem *problem) {
    free(problem->start);
    free(problem->row);
    free(problem->other);
    free(problem->value);
    free(problem->first);
    if (!problem->second_in_first)
        free(problem->second);
    memset(problem, 0, sizeof *problem);
}

void problem_reset(struct problem *problem) {
    for (long i = 0; i < problem->doubles; i++)
        problem->first[i] = (double)(i % 7);
    const long count = (long)problem->second_rows * problem->second_width;
    for (long i = 0; problem->second && !problem->second_in_first && i < count; i++)
        problem->second[i] = (double)(i % 5);
}

void problem_oracle(struct problem *problem) {
    for (long t = 0; t < problem->trip; t++)
        for (int k = problem->start[t]; k < problem->start[t + 1]; k++) {
            for (int c = 0; c < problem->width; c++)
                problem->first[problem->row[k] * problem->width + c] += problem->value[k] * (c + 1);
            for (int c = 0; c < problem->second_width; c++)
                problem->second[problem->other[k] * problem->second_width + c] -=
                    problem->value[k] * (c + 2);
        }
}

bool problem_run_tells = true;
int problem_searches = 0;

void problem_tell_slow(redcc_loop *loop, long trip, double seconds) {
    struct loop_state *state = loop->state;
    if (!state || trip < 1)
        return;
    const double all = seconds * (double)trip;
    struct size_state *size =
        &state->chooser.state.size[63 - __builtin_clzll((unsigned long long)trip)];
    for (int call = 0; call < 4000; call++)
        redcc_tell(&state->chooser,
                   &(struct outcome){.result = RESULT_SEQUENTIAL, .trip = trip, .seconds = all},
                   REASON_NONE);
    for (enum way way = WAY_COPIES; way < WAY_COUNT; way++)
        size->arm[way].learned = 40 * all;
    size->calls += 4000;
    state->chooser.steady += 4000;
}
