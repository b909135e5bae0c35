# shellcheck shell=bash source=bench/common.sh disable=SC2154
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Counts the instructions of the loops' parallel form by valgrind's callgrind, so that other programs do not disturb the
# figures. Also counts the lines of each loop's generated text, including the user's loop but not the file's head. One
# of the loops is fabric's over hinges.
. bench/common.sh
csv=$results/generated.csv
command -v valgrind >/dev/null || { echo "generated: no valgrind, nothing is measured"; exit 0; }
cp bench/generated/kernels.c "$work/kernels.c"
(cd "$work" && "$build/tool/redcc" kernels.c -o short.c 2>/dev/null)
kernels=(springs histogram columns leaving)

# instructions KERNEL: prints the instructions of the file's functions that the runtime called
instructions() {
  OMP_NUM_THREADS=2 REDCC_METHOD=localwrite valgrind --tool=callgrind \
    --callgrind-out-file="$work/counts" "$work/short" "$1" >"$work/out" 2>/dev/null
  callgrind_annotate --threshold=100 "$work/counts" 2>/dev/null |
    awk '/redcc__member/ { gsub(",", "", $1); sum += $1 } END { printf "%d", sum }'
}

echo "kernel,compiler,level,instructions" >"$csv"
printf '%-10s %-9s %-4s %12s\n' kernel compiler "" instructions
for compiler in gcc clang-19; do
  command -v "$compiler" >/dev/null || continue
  for level in -O2 -O3; do
    "$compiler" "$level" -g -Wl,-u,redcc_run -Iruntime/include "$work/short.c" \
      "$build/runtime/libredcc_rt.a" -lm -o "$work/short"
    for i in 0 1 2 3; do
      count=$(instructions "$i")
      printf '%-10s %-9s %-4s %12s\n' "${kernels[i]}" "$compiler" "$level" "$count"
      echo "${kernels[i]},$compiler,$level,$count" >>"$csv"
    done
  done
done

"$build/tool/redcc" examples/fabric/effects/hinge.c -Iexamples/fabric -o "$work/hinge.c" 2>/dev/null
table=$results/generated-lines.csv
echo "loop,lines,asked" >"$table"
paste -d , <(printf '%s\n' "${kernels[@]}" fabric-hinge) \
  <(bench/generated/count-lines "$work/short.c" && bench/generated/count-lines "$work/hinge.c") \
  <(printf '%s\n' 90 60 90 "" 260) >>"$table"
cat "$table"
