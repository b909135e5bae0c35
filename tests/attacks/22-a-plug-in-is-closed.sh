#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# A plug-in with a loop is opened, called and closed, by the first thread and by another: what OpenMP's
# threads run must stay. The static library is in the plug-in, and nothing of OpenMP in the program.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cat >"$work/loop.c" <<'C'
void fill(int n, const int *k, double *h);
void fill(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++)
        h[k[t]] += 1.0 / (1 + t);
}
C
cat >"$work/main.c" <<'C'
#define _GNU_SOURCE
#include <dlfcn.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>
enum { N = 100000, K = 1000 };
static int k[N];
static double h[K];
static void *use(void *name) {
    void *plug_in = dlopen(name, RTLD_NOW | RTLD_LOCAL);
    if (!plug_in)
        puts(dlerror()), exit(1);
    void (*fill)(int, const int *, double *) = (void (*)(int, const int *, double *))dlsym(plug_in, "fill");
    for (int round = 0; round < 5; round++)
        fill(N, k, h);
    dlclose(plug_in);
    usleep(20000);
    return NULL;
}
int main(int count, char **name) {
    (void)count;
    for (int t = 0; t < N; t++)
        k[t] = (int)((t * 7919LL + t / 3) % K);
    for (int round = 0; round < 4; round++) {
        pthread_t other;
        use(name[1]);
        pthread_create(&other, NULL, use, name[1]);
        pthread_join(other, NULL);
    }
    double sum = 0;
    for (int i = 0; i < K; i++)
        sum = sum * 0.5 + h[i];
    printf("%a\n", sum);
    return 0;
}
C
cd "$work"
"$ATTACK_REDCC" loop.c -o parallel.c -- -O2 >/dev/null 2>&1
gcc -O2 main.c -o main -ldl -pthread
gcc -O2 -fPIC -shared loop.c -o sequential.so
gcc -O2 -fPIC -shared -Wl,-u,redcc_run -I"$ATTACK_INCLUDE" parallel.c "$ATTACK_LIBRARY" -o parallel.so
./main ./sequential.so >expected
for threads in 2 3 7; do
    for policy in active passive; do
        status=0
        OMP_WAIT_POLICY=$policy OMP_NUM_THREADS=$threads REDCC_METHOD=localwrite REDCC_REPORT=run-%p.json \
            ./main ./parallel.so >found 2>error || status=$?
        if [ "$status" != 0 ] || ! cmp -s expected found; then
            echo "$threads threads, $policy: status $status: $(cat error)" >&2
            exit 1
        fi
        jq -e '.loops[0].method == "localwrite"' run-*.json >/dev/null
        rm run-*.json
    done
done
