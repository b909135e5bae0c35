# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# shellcheck shell=bash disable=SC2034
# Gifsicle's own tests, and its logo with fewer colours, dithered, scaled and optimised.
source_package=gifsicle
build_rounds=1
build() { make_all gifsicle_programs; }
gifsicle_programs() {
  local flags="-DHAVE_CONFIG_H -I.. -I../include"
  cat >config.h <<'CONFIG'
#include <inttypes.h>
#include <stddef.h>
#define HAVE_INTTYPES_H 1
#define HAVE_MKSTEMP 1
#define HAVE_POW 1
#define HAVE_STDINT_H 1
#define HAVE_STRERROR 1
#define HAVE_STRTOUL 1
#define HAVE_SYS_STAT_H 1
#define HAVE_SYS_TYPES_H 1
#define HAVE_UINTPTR_T 1
#define HAVE_UNISTD_H 1
#define PATHNAME_SEPARATOR '/'
#define RANDOM random
#define VERSION "Debian's"
#define SIZEOF_UNSIGNED_LONG 8
#define SIZEOF_VOID_P 8
#define SIZEOF_UNSIGNED_INT 4
CONFIG
  cd src && compile clp.c giffunc.c gifread.c gifunopt.c gifwrite.c merge.c optimize.c quantize.c support.c xform.c \
    gifsicle.c gifdiff.c || return
  "$CC" $(ls ./*.o | grep -v gifdiff.o) -lm -o gifsicle && "$CC" gifdiff.o giffunc.o gifread.o clp.o -lm -o gifdiff
}
check() {
  local options
  perl test/testie -p "$PWD/src" test || return
  for options in "-k 16" "-k 8 -f" "-k 32 --color-method=median-cut" "-k 12 --color-method=blend-diversity -fo8" \
    "--scale 0.6 --resize-method=mix" "--scale 1.7 --resize-method=lanczos3 -k 64" "--resize 70x_ --resize-method=box" "-O3"; do
    # shellcheck disable=SC2086
    echo "$options" && ./src/gifsicle $options logo.gif | cksum && ./src/gifsicle $options logo1.gif | cksum || return
  done
}
work() { for _ in 1 2 3 4 5; do ./src/gifsicle --scale 4 --resize-method=mix -k 64 -f logo.gif; done; }
