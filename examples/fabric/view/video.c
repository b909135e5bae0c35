/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "view/video.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "output/fresh_file.h"
#include "view/film.h"

/** A running ffmpeg, which reads raw RGB pictures from a pipe. */
typedef struct encoder {
    pid_t process;
    FILE *pictures;
} encoder;

/** Runs in the child and does not return. If exec succeeds, it closes `report`; otherwise errno is
 *  written to `report`. */
static void become_ffmpeg(int input, int report, const char *size, const char *rate,
                          const char *path) {
    const char *const words[] = {"ffmpeg",   "-hide_banner", "-loglevel", "error",
                                 "-y",       "-f",           "rawvideo",  "-pixel_format",
                                 "rgb24",    "-video_size",  size,        "-framerate",
                                 rate,       "-i",           "-",         "-an",
                                 "-pix_fmt", "yuv420p",      "-movflags", "+faststart",
                                 "-f",       "mp4",          path,        NULL};
    dup2(input, STDIN_FILENO);
    signal(SIGPIPE, SIG_DFL);
    execvp(words[0], (char *const *)words);
    const int reason = errno;
    _exit(write(report, &reason, sizeof reason) == (ssize_t)sizeof reason ? 127 : 126);
}

static int complain_missing(const char *folder, int reason) {
    fprintf(stderr,
            "ffmpeg, which makes MP4 films, cannot be started: %s; 'fabric-view render %s' draws "
            "%s/frames/NNNN.png, of which other programs make films\n",
            strerror(reason), folder, folder);
    return -1;
}

/** Opens a pipe with close-on-exec. */
static int open_pipe(int ends[2]) {
    if (pipe(ends) != 0)
        return -1;
    return fcntl(ends[0], F_SETFD, FD_CLOEXEC) < 0 || fcntl(ends[1], F_SETFD, FD_CLOEXEC) < 0 ? -1
                                                                                              : 0;
}

static void close_pipe(const int ends[2]) {
    for (int k = 0; k < 2; k++)
        if (ends[k] >= 0)
            close(ends[k]);
}

/** Starts ffmpeg. Returns 0, or -1 after a message. */
static int start(encoder *e, const char *folder, const char *size, const char *rate,
                 const char *path) {
    int pictures[2] = {-1, -1}, report[2] = {-1, -1}, reason = 0;
    if (open_pipe(pictures) != 0 || open_pipe(report) != 0) {
        reason = errno;
        close_pipe(pictures);
        close_pipe(report);
        return complain_missing(folder, reason);
    }
    e->process = fork();
    if (e->process == 0)
        become_ffmpeg(pictures[0], report[1], size, rate, path);
    if (e->process < 0)
        reason = errno;
    close(pictures[0]);
    close(report[1]);
    if (e->process > 0 && read(report[0], &reason, sizeof reason) > 0)
        waitpid(e->process, NULL, 0); /* exec has failed */
    close(report[0]);
    e->pictures = reason == 0 ? fdopen(pictures[1], "wb") : NULL;
    if (e->pictures)
        return 0;
    close(pictures[1]);
    return complain_missing(folder, reason);
}

/** Waits for ffmpeg's end. Returns 0, or -1 after a message with ffmpeg's status. If `at_once`,
 *  kills ffmpeg and prints nothing. */
static int finish(encoder *e, int at_once) {
    int status = 0;
    if (at_once)
        kill(e->process, SIGTERM);
    fclose(e->pictures); /* ffmpeg's status shows whether writing failed */
    while (waitpid(e->process, &status, 0) < 0)
        if (errno != EINTR)
            return -1;
    if (status == 0)
        return 0;
    if (at_once)
        return -1;
    if (WIFSIGNALED(status))
        fprintf(stderr, "ffmpeg was ended by signal %d\n", WTERMSIG(status));
    else
        fprintf(stderr, "ffmpeg failed with status %d\n", WEXITSTATUS(status));
    return -1;
}

/** Computes the frame rate at which the film runs in real time. Returns 0, or -1 after a
 *  message. */
static int find_rate(film *of, char text[32]) {
    const frames *all = film_frames(of);
    double rate = 1.0;
    if (all->count > 1) {
        state last;
        if (frames_read(all, all->count - 1, &last) != 0)
            return -1;
        const double seconds = last.time - all->first.time;
        rate = seconds > 0 ? (all->count - 1) / seconds : 1.0;
        state_free(&last);
    }
    /* ffmpeg accepts only these rates. */
    rate = rate < 0.01 ? 0.01 : rate > 1000 ? 1000 : rate;
    snprintf(text, 32, "%.6g", rate);
    return 0;
}

/** Draws all pictures and writes them to ffmpeg. Stops if ffmpeg closes the pipe, in which case
 *  ffmpeg prints the reason. Returns 0, or -1 after a message. */
static int feed(encoder *e, film *of) {
    const int count = film_frames(of)->count;
    for (int number = 0; number < count && !ferror(e->pictures); number++) {
        picture p;
        double time;
        if (film_draw(of, number, &p, &time) != 0)
            return -1;
        fwrite(p.rgb, 3, (size_t)p.width * (size_t)p.height, e->pictures);
        picture_free(&p);
    }
    return 0;
}

static int encode(film *of, const char *folder, int width, int height, const char *path) {
    encoder e;
    char size[32], rate[32];
    struct sigaction kept;
    const struct sigaction ignore = {.sa_handler = SIG_IGN};
    snprintf(size, sizeof size, "%dx%d", width, height);
    if (find_rate(of, rate) != 0 || start(&e, folder, size, rate, path) != 0)
        return -1;
    sigaction(SIGPIPE, &ignore, &kept); /* writing must not end this process if ffmpeg ends early */
    const int fed = feed(&e, of);
    const int finished = finish(&e, fed != 0); /* an incomplete film could be mistaken for a
                                                * complete one */
    sigaction(SIGPIPE, &kept, NULL);
    return fed == 0 ? finished : -1;
}

int video_write(const char *folder, int width, int height, const char *path, int *count) {
    fresh_file f;
    film *of = film_open(folder, width, height);
    if (!of)
        return -1;
    *count = film_frames(of)->count;
    int status = fresh_file_open(&f, path);
    if (status == 0)
        status = fresh_file_close(&f, encode(of, folder, width, height, f.temporary));
    film_close(of);
    return status;
}
