# shellcheck shell=bash source=bench/common.sh disable=SC2154
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Processor time of compiling translated files, relative to the original file: without lanes (loops by SIMD vectors),
# with lanes in heavy loops, and with lanes in all loops. Each file is compiled once per round. Prints medians, and
# quartiles of the ratios.
#   ROUNDS=9 CC=gcc FILES="bench/lanes_kernels.c" FLAGS="-O2;-O3 -march=native" script/bench compile
. bench/common.sh
compiler=${CC:-gcc}
csv=$results/compile.csv
load_note
seconds() { # COMMAND...: prints its processor seconds
  local TIMEFORMAT='%U %S'
  { time "$@" 2>/dev/null; } 2>&1 | awk '{print $1 + $2}'
}
echo "file,flags,untouched_seconds,off,off_low,off_high,auto,auto_low,auto_high,all,all_low,all_high" | tee "$csv"
for file in ${FILES:-bench/lanes_kernels.c}; do
  for lanes in off auto 4; do
    "$build/tool/redcc" --lanes=$lanes "$file" -o "$work/$lanes.c" -Ibench -Iexamples/fabric 2>/dev/null
  done
  while IFS= read -r flags; do
    rm -f "$work"/times.*
    for ((round = 0; round < ${ROUNDS:-9}; round++)); do
      for form in serial off auto 4; do
        source=$work/$form.c
        [ $form != serial ] || source=$file
        # shellcheck disable=SC2086
        seconds "$compiler" $flags -ffp-contract=off -Ibench -Iexamples/fabric -Iruntime/include \
          -iquote "$(dirname "$file")" -c "$source" -o "$work/object.o" >>"$work/times.$form"
      done
    done
    line=$file,$flags,$(median <"$work/times.serial")
    for form in off auto 4; do
      line+=$(paste "$work/times.$form" "$work/times.serial" | awk '{print $1 / $2}' | sort -g |
        awk '{v[NR] = $1} END {printf ",%.2f,%.2f,%.2f", v[int((NR + 1) / 2)], v[int((NR + 3) / 4)], v[int((3 * NR + 3) / 4)]}')
    done
    echo "$line" | tee -a "$csv"
  done < <(tr ';' '\n' <<<"${FLAGS:--O2;-O3 -march=native}")
done
echo "kept: $csv"
