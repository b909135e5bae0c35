# shellcheck shell=bash source=bench/common.sh disable=SC2154
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Instructions of the parallel region in the short form of the generated code, against the long form
# that redcc wrote at first (bench/generated/kernels-long.txt), by valgrind's callgrind. Counts do not
# depend on what else the machine does. And the lines of each loop's short form, the user's loop
# included and the file's head not, beside those asked for; fabric's loop over hinges among them.
. bench/common.sh
csv=$results/generated.csv
command -v valgrind >/dev/null || { echo "generated: no valgrind, nothing is measured"; exit 0; }
cp bench/generated/kernels.c "$work/kernels.c"
cp bench/generated/kernels-long.txt "$work/long.c"
(cd "$work" && "$build/tool/redcc" kernels.c -o short.c 2>/dev/null)
kernels=(springs histogram columns leaving)

# instructions FORM KERNEL COMPILER LEVEL: of all functions that OpenMP's threads execute
instructions() {
  OMP_NUM_THREADS=2 REDCC_METHOD=localwrite valgrind --tool=callgrind \
    --callgrind-out-file="$work/counts" "$work/$1" "$2" >"$work/$1.out" 2>/dev/null
  callgrind_annotate --threshold=100 "$work/counts" 2>/dev/null |
    awk '/omp_outlined|_omp_fn/ { gsub(",", "", $1); sum += $1 } END { printf "%d", sum }'
}

echo "kernel,compiler,level,long,short,ratio" >"$csv"
printf '%-10s %-9s %-4s %12s %12s %7s\n' kernel compiler "" long short ratio
for compiler in gcc clang-19; do
  command -v "$compiler" >/dev/null || continue
  for level in -O2 -O3; do
    for form in long short; do
      "$compiler" "$level" -g -fopenmp -Iruntime/include "$work/$form.c" \
        "$build/runtime/libredcc_rt.a" -lm -o "$work/$form"
    done
    for i in 0 1 2 3; do
      long=$(instructions long "$i") short=$(instructions short "$i")
      cmp -s "$work/long.out" "$work/short.out" || { echo "generated: other bits"; exit 1; }
      ratio=$(awk "BEGIN { printf \"%.4f\", $short / $long }")
      printf '%-10s %-9s %-4s %12s %12s %7s\n' "${kernels[i]}" "$compiler" "$level" "$long" "$short" "$ratio"
      echo "${kernels[i]},$compiler,$level,$long,$short,$ratio" >>"$csv"
    done
  done
done

"$build/tool/redcc" examples/fabric/effects/hinge.c -Iexamples/fabric -o "$work/hinge.c" 2>/dev/null
table=$results/generated-lines.csv
echo "loop,lines,asked" >"$table"
paste -d , <(printf '%s\n' "${kernels[@]}" fabric-hinge) \
  <(bench/generated/count-lines "$work/short.c" && bench/generated/count-lines "$work/hinge.c") \
  <(printf '%s\n' 45 32 40 "" 150) >>"$table"
cat "$table"
