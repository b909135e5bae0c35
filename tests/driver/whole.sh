#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# A project whose loops call helpers of other files: element matrix, distance, colour of a pixel. By make,
# from clean and after a change, and by CMake with headers in a folder of their own. BUILD is the build folder.
. "$(dirname "$0")/library.sh"
export REDCC_ROOT=$BUILD OMP_WAIT_POLICY=passive
redcc_cc=$REDCC_CC_PROGRAM

make_sources() {
  mkdir -p src include
  cat >include/mesh.h <<'END'
struct mesh { int triangles; const int (*corner)[3]; const double (*at)[2]; };
void element_matrix(const struct mesh *m, int e, double k[3][3]);
double distance2(const double *p, const double *q);
void rgb_of(unsigned pixel, unsigned char *r, unsigned char *g, unsigned char *b);
int bin_of(double v, double low, double width);
void assemble(const struct mesh *m, double *diagonal, double *load, const double *u);
void forces(int n, const int (*pair)[2], const double (*x)[2], double (*f)[2], double cut);
void histogram(int n, const unsigned *pixel, int *red, int *green, int *blue);
void bins(int n, const double *v, double *h);
END
  cat >src/element.c <<'END'
#include "mesh.h"
static const double weight[3] = {0.5, 0.25, 0.25};
static double area(const double *a, const double *b, const double *c)
{
    return 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]));
}
void element_matrix(const struct mesh *m, int e, double k[3][3])
{
    const int *v = m->corner[e];
    double s = area(m->at[v[0]], m->at[v[1]], m->at[v[2]]);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            k[i][j] = s * weight[i] * weight[j] + distance2(m->at[v[i]], m->at[v[j]]);
}
END
  cat >src/distance.c <<'END'
#include "mesh.h"
double distance2(const double *p, const double *q)
{
    double x = p[0] - q[0], y = p[1] - q[1];
    return x * x + y * y;
}
END
  cat >src/color.c <<'END'
#include "mesh.h"
enum { LAST = 49 };
void rgb_of(unsigned pixel, unsigned char *r, unsigned char *g, unsigned char *b)
{
    *r = pixel >> 16;
    *g = pixel >> 8;
    *b = pixel;
}
int bin_of(double v, double low, double width)
{
    int bin = (int)((v - low) / width);
    return bin > LAST ? LAST : bin;
}
END
  cat >src/loops.c <<'END'
#include "mesh.h"
enum { LAST = 3 };
void assemble(const struct mesh *m, double *diagonal, double *load, const double *u)
{
    for (int e = 0; e < m->triangles; e++) {
        double k[3][3];
        element_matrix(m, e, k);
        for (int i = 0; i < 3; i++) {
            double s = 0;
            for (int j = 0; j < 3; j++)
                s += k[i][j] * u[m->corner[e][j]];
            load[m->corner[e][i]] += s;
            diagonal[m->corner[e][i]] += k[i][i];
        }
    }
}
void forces(int n, const int (*pair)[2], const double (*x)[2], double (*f)[2], double cut)
{
    for (int t = 0; t < n; t++) {
        int i = pair[t][0], j = pair[t][1];
        double r2 = distance2(x[i], x[j]);
        if (r2 > cut)
            continue;
        for (int c = 0; c < 2; c++) {
            f[i][c] += (x[i][c] - x[j][c]) / (1 + r2);
            f[j][c] -= (x[i][c] - x[j][c]) / (1 + r2);
        }
    }
}
void histogram(int n, const unsigned *pixel, int *red, int *green, int *blue)
{
    for (int t = 0; t < n; t++) {
        unsigned char r, g, b;
        rgb_of(pixel[t], &r, &g, &b);
        red[r]++;
        green[g] += 2;
        blue[b]++;
    }
}
void bins(int n, const double *v, double *h)
{
    for (int t = 0; t < n; t++)
        h[bin_of(v[t], -1.0, 0.125)] += v[t];
}
END
  cat >src/main.c <<'END'
#include <stdio.h>
#include "mesh.h"
enum { N = 120, P = N * N, T = 2 * (N - 1) * (N - 1) };
static int corner[T][3], pair[3 * T][2], color[3][256];
static unsigned pixel[P];
static double at[P][2], f[P][2], u[P], diagonal[P], load[P], h[64];
static unsigned long sum(const void *of, unsigned long bytes)
{
    unsigned long s = 0;
    for (unsigned long i = 0; i < bytes; i++)
        s = s * 31 + ((const unsigned char *)of)[i];
    return s;
}
int main(void)
{
    int t = 0;
    for (int i = 0; i < P; i++) {
        at[i][0] = i % N * 1.5 + i * 1e-3;
        at[i][1] = i / N;
        u[i] = 5.0 / (1 + i);
        pixel[i] = i * 2654435761u;
    }
    for (int i = 0; i + 1 < N; i++)
        for (int j = 0; j + 1 < N; j++) {
            int c = i * N + j;
            corner[t][0] = c, corner[t][1] = c + 1, corner[t++][2] = c + N;
            corner[t][0] = c + 1, corner[t][1] = c + N + 1, corner[t++][2] = c + N;
        }
    for (int i = 0; i < 3 * T; i++) {
        pair[i][0] = corner[i / 3][i % 3];
        pair[i][1] = corner[i / 3][(i + 1) % 3];
    }
    struct mesh m = {T, corner, at};
    for (int round = 0; round < 3; round++) {
        assemble(&m, diagonal, load, u);
        forces(3 * T, pair, at, f, 4.0);
        histogram(P, pixel, color[0], color[1], color[2]);
        bins(P, u, h);
    }
    printf("%lx %lx %lx %lx %lx\n", sum(diagonal, sizeof diagonal), sum(load, sizeof load), sum(f, sizeof f),
           sum(color, sizeof color), sum(h, sizeof h));
    return 0;
}
END
}
sequential() { gcc -O1 -ffp-contract=off -Iinclude src/*.c -o plain && ./plain >expected; }
run_at_all_threads() { # PROGRAM FUNCTIONS that run in parallel
  local threads
  for threads in 1 2 3 7 16 33; do
    rm -f report
    env -u REDCC_CC_PROGRAM REDCC_METHOD=localwrite OMP_NUM_THREADS=$threads REDCC_REPORT=report "$1" >actual || fail "$case_name: $1 fails"
    cmp -s expected actual || fail "$case_name: $1: another program at $threads threads"
  done
  expect_equal "$case_name: in parallel" "$2" \
    "$(jq -r '.loops[] | select(.plans_built > 0).function' report 2>/dev/null | sort | paste -sd ' ')"
}

begin "make, from clean"
make_sources
cat >Makefile <<'END'
CFLAGS = -O1 -Iinclude
objects = $(patsubst src/%.c,%.o,$(sort $(wildcard src/*.c)))
program: $(objects)
	$(CC) $(objects) -o $@
%.o: src/%.c
	$(CC) $(CFLAGS) -c $< -o $@
END
sequential
make CC="$redcc_cc" >log 2>&1 || fail "$case_name: $(cat log)"
run_at_all_threads ./program "assemble bins forces histogram"
# Compiled before and after: the loop's translation is what one of them saw.
sed -i 's/return x \* x + y \* y;/return x * x + y * y + 1e-9 * x;/' src/distance.c
sequential
make CC="$redcc_cc" >log 2>&1 || fail "changed helper: $(cat log)"
expect_equal "compiled again" 1 "$(grep -c -- '-c src' log)"
run_at_all_threads ./program "" # all loops of a file compare all that it has read
expect_match report '"slug": *"unlinked"'
expect_equal "reasons" "'distance2' of distance.c is not linked as it was analysed" \
  "$(jq -r '.loops[].fallbacks[] | select(.slug == "unlinked").reason' report | sort -u)"
REDCC_REPORT=report ./program >actual || fail "$case_name"
expect_equal "no method was named" refused "$(jq -r '.loops[].rule' report | sort -u)"
REDCC_REPORT=- ./program 2>table >actual || fail "$case_name"
expect_match table "why sequential: 'distance2' of distance.c is not linked as it was analysed: compile both files again"
touch src/loops.c
make CC="$redcc_cc" >log 2>&1 || fail "changed user: $(cat log)"
run_at_all_threads ./program "assemble bins forces histogram"
end

begin "a part of a repository that is too large to be read"
mkdir .git other part
for i in $(seq 601); do echo "int other$i;" >"other/o$i.c"; done
cd part
make_sources
sequential
for name in src/*.c; do "$redcc_cc" -O1 -Iinclude -c "$name"; done
"$redcc_cc" ./*.o -o program
run_at_all_threads ./program "assemble bins forces histogram"
end

begin "CMake, a library and a program, optimisation when linking"
make_sources
cat >CMakeLists.txt <<'END'
cmake_minimum_required(VERSION 3.20)
project(whole C)
include_directories(include)
add_library(helpers ${KIND} src/element.c src/distance.c src/color.c)
add_executable(program src/main.c src/loops.c)
target_link_libraries(program helpers)
END
sequential
for kind in STATIC SHARED; do
  cmake -S . -B "build-$kind" -DKIND=$kind -DCMAKE_BUILD_TYPE=RelWithDebInfo -DCMAKE_C_COMPILER="$redcc_cc" >log 2>&1 &&
    cmake --build "build-$kind" >>log 2>&1 || fail "$case_name: $(cat log)"
  run_at_all_threads "./build-$kind/program" "assemble bins forces histogram"
done
"$redcc_cc" -O1 -flto -Iinclude src/*.c -o optimised 2>log || fail "$case_name: $(cat log)"
run_at_all_threads ./optimised "" # where the linker compiles, nothing is said of other files
"$redcc_cc" -O1 -Iinclude src/*.c -o at-once 2>log || fail "$case_name: $(cat log)"
run_at_all_threads ./at-once "assemble bins forces histogram"
end

# The programs link without a definition of these functions: what redcc writes may not ask for one.
begin "functions that only dead or inlined calls name"
echo '. | *.c' >Makefile
cat >helper.c <<'END'
double dump(double x);
void missing(int i);
static int never(void) { return 0; }
inline double twice(double x) { return 2 * x; }
double plain(double x, int i);
double plain(double x, int i) {
    if (never())
        missing(i);
    return x + i;
}
double doubled(double x);
double doubled(double x) { return twice(x); }
double traced(double x);
double traced(double x) { return 0 ? dump(x) : x; }
END
cat >main.c <<'END'
#include <stdio.h>
enum { N = 100000, K = 1000 };
static int k[N];
static double h[K];
static int never(int t) { return TRACED && t < 0; }
double plain(double x, int i);
double doubled(double x);
double traced(double x);
double dump(double x);
int main(void) {
    double sum = 0;
    for (int t = 0; t < N; t++)
        k[t] = (int)((t * 7919LL + t / 3) % K);
    if (never(0))
        sum = dump(sum);
    for (int t = 0; t < N; t++)
        h[k[t]] += 0.5;
    for (int t = 0; t < N; t++)
        h[k[t]] += plain(1.0 / (1 + t), t);
    for (int t = 0; t < N; t++)
        h[k[t]] += doubled(traced(t));
    for (int i = 0; i < K; i++)
        sum = sum * 0.5 + h[i];
    printf("%a\n", sum);
    return 0;
}
END
echo 'double dump(double x); double dump(double x) { return x + 1; }' >dump.c # not linked
gcc -O1 -DTRACED=1 -ffp-contract=off main.c helper.c -o plain && ./plain >expected
for compiler in gcc clang; do
  # clang forgets that a reference is weak where its optimiser removes the call
  traced=$([ $compiler = clang ] || echo 1)
  for name in main helper; do
    "$redcc_cc" $compiler -O1 -Wall -Wextra -Werror -DTRACED=${traced:-0} -c $name.c || fail "$compiler: $name"
  done
  "$redcc_cc" $compiler main.o helper.o -o program || fail "$case_name: $compiler"
  run_at_all_threads ./program "" # nobody knows what is not linked
done
end
finish
