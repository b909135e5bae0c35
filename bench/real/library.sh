# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# shellcheck shell=bash disable=SC2034
# The real programs of `script/bench real`: their sources and arguments. Sourced from the repository's root by the
# benchmark and by tests/real.
# Requires PACKAGES_FOLDER, the folder for Debian's sources (tests/packages/library.sh).
real_programs=(molecules bricks jelly euler fairing transport plate)

# Arguments of a run that takes some seconds, and of a run for a test.
declare -A real_size=([molecules]="24 200" [bricks]="24 400" [jelly]="32 300" [euler]="120 300" [fairing]="8 150"
  [transport]="200000 100" [plate]="500 10")
declare -A test_size=([molecules]="8 41" [bricks]="6 100" [jelly]="8 100" [euler]="16 20" [fairing]="5 30"
  [transport]="4000 5" [plate]="60 3")

# The functions with irregular reductions, as a regular expression for loop_share.
declare -A real_loops=([molecules]="forces" [bricks]="internal_forces|element_force"
  [jelly]="elastic_forces|stress|product|edges|cofactors|determinant" [euler]="residual|wave_speeds|rusanov"
  [fairing]="curvature_normals|cotangents" [transport]="umfdi_solve" [plate]="cs_gaxpy")

# The Debian source package of the libraries with which a program is built.
declare -A real_package=([transport]=suitesparse [plate]=suitesparse)

# Fetches the sources that a program needs; exits with 77 if they are unavailable.
fetch_real() { # NAME
  [ -n "${real_package[$1]:-}" ] || return 0
  source_package=${real_package[$1]}
  . tests/packages/library.sh
  fetch
}

# build_real NAME COMPILER FOLDER [FLAG...]: builds FOLDER/NAME, including libraries, with that compiler.
build_real() {
  local name=$1 compiler=$2 folder=$3 flags=(-O2 "${@:4}") source=bench/real/$1.c
  mkdir -p "$folder"
  case $name in
  transport) build_umfpack "$compiler" "$folder" "${flags[*]}" &&
    "$compiler" "${flags[@]}" -I"$folder"/UMFPACK/Include -I"$folder"/AMD/Include -I"$folder"/SuiteSparse_config \
      "$source" "$folder"/UMFPACK/Lib/libumfpack.a "$folder"/AMD/Lib/libamd.a \
      "$folder"/SuiteSparse_config/libsuitesparseconfig.a -lm -o "$folder/$name" ;;
  plate) cp -r "$PACKAGES_FOLDER"/sources/suitesparse/{CSparse,SuiteSparse_config} "$folder" &&
    make -C "$folder"/CSparse/Lib -j "$(nproc)" CC="$compiler" CFLAGS="${flags[*]}" static &&
    "$compiler" "${flags[@]}" -I"$folder"/CSparse/Include "$source" "$folder"/CSparse/Lib/libcsparse.a -lm \
      -o "$folder/$name" ;;
  *) "$compiler" "${flags[@]}" "$source" -lm -o "$folder/$name" ;;
  esac
}

# Builds UMFPACK for double and int, without CHOLMOD and BLAS, so that the chosen compiler builds all timed code.
build_umfpack() { # COMPILER FOLDER FLAGS
  cp -r "$PACKAGES_FOLDER"/sources/suitesparse/{UMFPACK,AMD,SuiteSparse_config} "$2" &&
    make -C "$2"/SuiteSparse_config CC="$1" CFLAGS="$3" static &&
    make -C "$2"/AMD/Lib -j "$(nproc)" CC="$1" CFLAGS="$3" 'OBJ=$(AMDI)' static &&
    make -C "$2"/UMFPACK/Lib -j "$(nproc)" CC="$1" CFLAGS="$3" 'UMFPACK_CONFIG=-DNCHOLMOD -DNBLAS' \
      'OBJ=$(II) $(GN) $(DI)' static
}

# Prints the percentage of perf's samples in the given functions, including code inlined into them, or "-" if perf is
# unavailable.
loop_share() { # PROGRAM FUNCTIONS ARGUMENT...   (PROGRAM built with -g -no-pie)
  local program=$1 functions=$2 samples=$1.samples
  shift 2
  command -v perf >/dev/null && command -v addr2line >/dev/null &&
    perf record -q -F 500 -e cpu-clock -o "$samples" "$program" "$@" >/dev/null 2>&1 || { echo -; return; }
  perf script -i "$samples" -F ip 2>/dev/null | awk '{print $1}' >"$samples.addresses"
  addr2line -a -f -i -e "$program" <"$samples.addresses" | awk -v functions="^($functions)$" '
    /^0x/ { all++; seen = 0 }
    !seen && $1 ~ functions { seen = 1; inside++ }
    END { if (all) printf "%.0f\n", 100 * inside / all; else print "-" }'
}
