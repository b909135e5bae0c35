/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "output/progress.h"

#include <signal.h>
#include <stdatomic.h>
#include <stdio.h>
#include <string.h>
#include <sys/time.h>
#include <unistd.h>

/* The pace is an exponential moving average with this time constant in steps, because contact makes
 * later steps slower than the first. */
enum { STEPS_REMEMBERED = 10 };
/* Seconds between signs of life. */
enum { BAR_BEAT = 1, LINES_BEAT = 60 };

const char *const progress_styles[] = {"auto", "bar", "lines", "json", "none", NULL};

/* State of the alarm's handler, which prints signs of life (beats) by write(). */
static volatile sig_atomic_t beats;
static char beat_begin[200]; /* text before the seconds */
static volatile sig_atomic_t beat_ready;
static int beat_seconds;

progress_style progress_resolve(progress_style style) {
    if (style != PROGRESS_AUTO)
        return style;
    return isatty(STDERR_FILENO) ? PROGRESS_BAR : PROGRESS_LINES;
}

/* The alarm's handler prints a sign of life. It calls only functions that are safe in a signal
 * handler, hence no stdio. */
static void beat(int signal_number) {
    char text[sizeof beat_begin + 32], digits[12];
    size_t length = 0;
    int count = 0;
    (void)signal_number;
    if (!beat_ready)
        return;
    beats = beats + 1;
    for (const char *from = beat_begin; *from; from++)
        text[length++] = *from;
    for (int rest = beats * beat_seconds; rest > 0 && count < (int)sizeof digits; rest /= 10)
        digits[count++] = (char)('0' + rest % 10);
    while (count > 0)
        text[length++] = digits[--count];
    for (const char *from = beat_seconds == BAR_BEAT ? " s)" : " s\n"; *from; from++)
        text[length++] = *from;
    if (write(STDERR_FILENO, text, length) < 0)
        beat_ready = 0; /* standard error is closed */
}

static void set_alarm(int seconds) {
    const struct itimerval every = {{seconds, 0}, {seconds, 0}};
    setitimer(ITIMER_REAL, &every, NULL);
}

/* Starts the signs of life of the next step. Each begins with `text`. */
static void start_beating(const progress *p, const char *text) {
    beat_ready = 0;
    atomic_signal_fence(memory_order_seq_cst); /* the handler sees the stores in this order */
    beats = 0;
    snprintf(beat_begin, sizeof beat_begin, "%s", text);
    beat_seconds = p->style == PROGRESS_BAR ? BAR_BEAT : LINES_BEAT;
    set_alarm(beat_seconds);
    atomic_signal_fence(memory_order_seq_cst);
    beat_ready = 1;
}

static int shows_life(const progress *p) {
    return p->style == PROGRESS_BAR || p->style == PROGRESS_LINES;
}

void progress_begin(progress *p, progress_style style, long first, long steps) {
    char text[100];
    *p = (progress){.style = style, .first = first, .steps = steps};
    if (!shows_life(p) || first >= steps)
        return;
    const struct sigaction noted = {.sa_handler = beat, .sa_flags = SA_RESTART};
    sigaction(SIGALRM, &noted, NULL);
    snprintf(text, sizeof text,
             style == PROGRESS_BAR ? "\rstep %ld of %ld (" : "step %ld of %ld under way for ",
             first + 1, steps);
    start_beating(p, text);
}

void progress_end(progress *p) {
    if (!shows_life(p))
        return;
    beat_ready = 0;
    set_alarm(0);
    if (p->style == PROGRESS_BAR && p->first < p->steps)
        fputc('\n', stderr);
}

/* Writes "1:02:03 left", "2:03 left" or "4.5 s left". */
static void format_left(char text[40], double seconds) {
    const long whole = (long)(seconds + 0.5);
    if (seconds < 60)
        snprintf(text, 40, "%.1f s left", seconds);
    else if (whole < 3600)
        snprintf(text, 40, "%ld:%02ld left", whole / 60, whole % 60);
    else
        snprintf(text, 40, "%ld:%02ld:%02ld left", whole / 3600, whole / 60 % 60, whole % 60);
}

/* Prints a bar that fits a terminal of 80 columns. */
static void print_bar(const progress *p, long step, double seconds, const char *left) {
    enum { WIDTH = 24 };
    char bar[WIDTH + 1], text[160];
    const int done = (int)(step * WIDTH / p->steps);
    memset(bar, '#', (size_t)done);
    memset(bar + done, '.', (size_t)(WIDTH - done));
    bar[WIDTH] = '\0';
    snprintf(text, sizeof text, "\r[%s] step %ld of %ld, %.1f s, %s", bar, step, p->steps, seconds,
             left);
    fprintf(stderr, "%s\033[K", text); /* erases the rest of a longer old line */
    strcat(text, " (");
    if (step < p->steps)
        start_beating(p, text);
}

static void print_line(const progress *p, long step, const char *said) {
    char text[64];
    if (step * 10 / p->steps != (step - 1) * 10 / p->steps || beats > 0)
        fprintf(stderr, "%s\n", said);
    snprintf(text, sizeof text, "step %ld of %ld under way for ", step + 1, p->steps);
    if (step < p->steps)
        start_beating(p, text);
}

void progress_report(progress *p, long step, double time, long iterations, double seconds) {
    char said[160], left[40];
    const long taken = step - p->first;
    const double weight = taken < STEPS_REMEMBERED ? (double)taken : (double)STEPS_REMEMBERED;
    p->pace += (seconds - p->last - p->pace) / weight;
    p->last = seconds;
    format_left(left, p->pace * (double)(p->steps - step));
    snprintf(said, sizeof said, "step %ld of %ld, t = %.3f s, %ld iterations, %.1f s, %s", step,
             p->steps, time, iterations, seconds, left);
    if (shows_life(p))
        beat_ready = 0; /* no sign of life may interrupt the output */
    if (p->style == PROGRESS_BAR)
        print_bar(p, step, seconds, left);
    else if (p->style == PROGRESS_LINES)
        print_line(p, step, said);
    else if (p->style == PROGRESS_JSON) {
        printf("{\"step\": %ld, \"steps\": %ld, \"time\": %.9g, \"cg_iterations\": %ld, "
               "\"seconds\": %.6f, \"seconds_left\": %.6f}\n",
               step, p->steps, time, iterations, seconds, p->pace * (double)(p->steps - step));
        fflush(stdout);
    }
}
