/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The program's only thread blocks a signal and sends it to the process. The signal must stay
 * pending until this thread unblocks it, and the handler must run in this thread (POSIX). */
#define _GNU_SOURCE
#include <signal.h>
#include <stdio.h>
#include <unistd.h>

enum { N = 100000, K = 1000 };
static int k[N];
static double h[K];
static volatile sig_atomic_t handled;
static volatile long handler_in;

static void note(int number) {
    (void)number;
    handled++;
    handler_in = gettid();
}

__attribute__((noinline)) static void fill(double weight) {
    for (int t = 0; t < N; t++) // EXPECT: parallel
        h[k[t]] += weight / (1 + t);
}

int main(void) {
    struct sigaction action = {.sa_handler = note};
    sigset_t one;
    sigaction(SIGUSR1, &action, NULL);
    sigemptyset(&one);
    sigaddset(&one, SIGUSR1);
    for (int t = 0; t < N; t++)
        k[t] = (int)((t * 7919LL + t / 3) % K);
    int wrong = 0, last = 0;
    for (int round = 0; round < 200; round++) {
        fill(1.0);
        sigprocmask(SIG_BLOCK, &one, NULL);
        kill(getpid(), SIGUSR1);
        fill(0.5);
        usleep(50);
        wrong += handled != last;
        sigprocmask(SIG_UNBLOCK, &one, NULL);
        wrong += handled != last + 1 || handler_in != getpid();
        last = handled;
    }
    double sum = 0;
    for (int i = 0; i < K; i++)
        sum = sum * 0.5 + h[i];
    printf("%a %d wrong, %d handled\n", sum, wrong, (int)handled);
    return 0;
}
