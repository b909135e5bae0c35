/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "output/progress.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

const char *const progress_styles[] = {"auto", "bar", "lines", "json", "none", NULL};

progress_style progress_resolve(progress_style style) {
    if (style != PROGRESS_AUTO)
        return style;
    return isatty(STDERR_FILENO) ? PROGRESS_BAR : PROGRESS_LINES;
}

static void tell_bar(long step, long steps, double time, long iterations, double seconds) {
    enum { WIDTH = 30 };
    char bar[WIDTH + 1];
    const int done = (int)(step * WIDTH / steps);
    memset(bar, '#', (size_t)done);
    memset(bar + done, '.', (size_t)(WIDTH - done));
    bar[WIDTH] = '\0';
    fprintf(stderr, "\r[%s] step %ld of %ld, t = %.3f s, %ld iterations, %.1f s%s", bar, step,
            steps, time, iterations, seconds, step == steps ? "\n" : "");
}

void progress_tell(progress_style style, long step, long steps, double time, long iterations,
                   double seconds) {
    switch (style) {
    case PROGRESS_BAR:
        tell_bar(step, steps, time, iterations, seconds);
        break;
    case PROGRESS_LINES:
        if (step * 10 / steps != (step - 1) * 10 / steps)
            fprintf(stderr, "step %ld of %ld, t = %.3f s, %ld iterations, %.1f s\n", step, steps,
                    time, iterations, seconds);
        break;
    case PROGRESS_JSON:
        printf("{\"step\": %ld, \"steps\": %ld, \"time\": %.9g, \"cg_iterations\": %ld, "
               "\"seconds\": %.6f}\n",
               step, steps, time, iterations, seconds);
        fflush(stdout);
        break;
    case PROGRESS_AUTO:
    case PROGRESS_NONE:
        break;
    }
}
