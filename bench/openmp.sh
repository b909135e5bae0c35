# shellcheck shell=bash source=bench/common.sh disable=SC2154
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Times OpenMP loops of several shapes (openmp.c). `gcc_clause` and `gcc_atomic` are the program's two spellings,
# compiled by gcc alone; `redcc` is the spelling named in the row, translated by redcc. Milliseconds are medians of
# interleaved runs. `ratio` is redcc's time divided by the better of gcc's two. `gcc_results` and `redcc_results` are the
# numbers of different results in these runs; redcc's include one run at each of OTHER_THREADS. `serial`: does
# REDCC_ORDER=serial give the bits of the program compiled without -fopenmp?
#   RUNS=20   THREADS=2   EXECUTIONS=16   SHAPES="histogram ..." (default: all)
#   MORE_THREADS=16, with MORE_RUNS=3: also timed, but only reported   OTHER_THREADS="1 3 7 16"
. bench/common.sh
RUNS=${RUNS:-20} THREADS=${THREADS:-2} EXECUTIONS=${EXECUTIONS:-16} SHAPES=${SHAPES:-}
MORE_THREADS=${MORE_THREADS-16} MORE_RUNS=${MORE_RUNS:-3} OTHER_THREADS=${OTHER_THREADS-1 3 7 16}
csv=$results/openmp.csv
load_note
gcc -O2 bench/openmp.c -lm -o "$work/without"
gcc -O2 -fopenmp bench/openmp.c -lm -o "$work/gcc"
"$build/tool/redcc" bench/openmp.c -o "$work/openmp.c" --require -- -fopenmp 2>"$work/report"
gcc -O2 -fopenmp "$work/openmp.c" -Iruntime/include -Wl,-u,redcc_run "$build/runtime/libredcc_rt.a" \
  -pthread -lm -o "$work/redcc"

# Runs SHAPE SPELLING by one of the programs on some threads, and appends the time and the result to a file.
run_once() { # program, shape, spelling, threads
  OMP_NUM_THREADS=$4 "$work/$1" "$2" "$3" "$EXECUTIONS" >>"$work/$1.$3.runs" 2>/dev/null || echo "crash crash" >>"$work/$1.$3.runs"
}
time_of() { # file of runs
  if [ ! -f "$1" ]; then
    echo -
  elif grep -q crash "$1"; then
    echo crash
  else
    cut -d ' ' -f 1 "$1" | median
  fi
}
different() { cut -d ' ' -f 2 "$@" | sort -u | wc -l; }
result_of() { # program, shape, spelling
  "$work/$1" "$2" "$3" "$EXECUTIONS" | cut -d ' ' -f 2
}
# One row for each spelling of the shape.
write_rows() { # shape, spellings, threads, runs, other threads
  local shape=$1 spelling spellings=$2 threads=$3 runs=$4 others=$5
  rm -f "$work"/*.runs
  for _ in $(seq "$runs"); do
    for spelling in $spellings; do
      [ "$spelling" = critical ] || run_once gcc "$shape" "$spelling" "$threads"
      run_once redcc "$shape" "$spelling" "$threads"
    done
  done
  for spelling in $spellings; do
    local clause atomic ms ratio other serial=no
    clause=$(time_of "$work/gcc.clause.runs") atomic=$(time_of "$work/gcc.atomic.runs")
    ms=$(time_of "$work/redcc.$spelling.runs")
    ratio=$(printf '%s\n' "$clause" "$atomic" | grep '^[0-9]' | minimum | awk -v ms="$ms" '{printf "%.3f", ms / $1}')
    for other in $others; do
      run_once redcc "$shape" "$spelling" "$other"
    done
    [ "$(REDCC_ORDER=serial result_of redcc "$shape" "$spelling")" != "$(result_of without "$shape" "$spelling")" ] || serial=yes
    echo "$shape,$spelling,$threads,$clause,$atomic,$ms,$ratio,$(
      [ "$spelling" = critical ] && echo - || different "$work/gcc.$spelling.runs"
    ),$(different "$work/redcc.$spelling.runs"),$serial" >>"$csv"
  done
}

echo "shape,spelling,threads,gcc_clause_ms,gcc_atomic_ms,redcc_ms,ratio,gcc_results,redcc_results,serial" >"$csv"
while read -r shape spellings; do
  [[ -z $SHAPES || " $SHAPES " == *" $shape "* ]] || continue
  write_rows "$shape" "$spellings" "$THREADS" "$RUNS" "$OTHER_THREADS"
  [ -z "$MORE_THREADS" ] || write_rows "$shape" "$spellings" "$MORE_THREADS" "$MORE_RUNS" ""
done < <("$work/gcc")
sort -s -t, -k3,3n <(tail -n +2 "$csv") | cat <(head -n 1 "$csv") - >"$work/sorted"
cp "$work/sorted" "$csv"
column -s, -t "$csv"
awk -F, -v threads="$THREADS" '$3 == threads {sum += log($7); count++}
  END {if (count) printf "geometric mean of ratio at %d threads: %.3f (%d rows)\n", threads, exp(sum / count), count}' "$csv"
echo "kept: $csv"
