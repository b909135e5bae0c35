# shellcheck shell=bash source=bench/common.sh disable=SC2154
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Times a histogram with OpenMP directives, compiled by gcc alone and translated by redcc first: milliseconds (medians
# of interleaved runs), and the number of different results of RUNS runs.
#   RUNS=20   THREADS="1 2"   SIZES="50000,1000,500 ... 4000000,12500000,4"
#             SIZES: iterations, elements of 8 bytes, executions
. bench/common.sh
RUNS=${RUNS:-20} THREADS=${THREADS:-1 2}
SIZES=${SIZES:-50000,1000,500 200000,10000,100 1000000,400000,20 2000000,1000,20 2000000,100000,20
4000000,1000000,16 4000000,12500000,4}
csv=$results/openmp.csv
load_note
gcc -O2 -fopenmp bench/openmp.c -o "$work/gcc"
"$build/tool/redcc" bench/openmp.c -o "$work/openmp.c" --require -- -fopenmp 2>/dev/null
gcc -O2 -fopenmp "$work/openmp.c" -Iruntime/include -Wl,-u,redcc_run "$build/runtime/libredcc_rt.a" \
  -pthread -lm -o "$work/redcc"
echo "directive,iterations,elements,threads,gcc_ms,gcc_results,redcc_ms,redcc_results" >"$csv"
for size in $SIZES; do
  read -r -a numbers <<<"${size//,/ }"
  for threads in $THREADS; do
    for directive in clause atomic; do
      rm -f "$work"/*.runs
      for _ in $(seq "$RUNS"); do
        for by in gcc redcc; do
          OMP_NUM_THREADS=$threads "$work/$by" "$directive" "${numbers[@]}" >>"$work/$by.runs" 2>/dev/null ||
            echo "crash crash" >>"$work/$by.runs"
        done
      done
      line=$directive,${numbers[0]},${numbers[1]},$threads
      for by in gcc redcc; do
        if grep -q crash "$work/$by.runs"; then
          line+=,crash,0
        else
          line+=,$(cut -d ' ' -f 1 "$work/$by.runs" | median),$(cut -d ' ' -f 2 "$work/$by.runs" | sort -u | wc -l)
        fi
      done
      echo "$line" >>"$csv"
    done
  done
done
column -s, -t "$csv"
echo "kept: $csv"
