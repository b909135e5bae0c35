# shellcheck shell=bash source=bench/common.sh disable=SC2154
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Repeats the paper's evaluation on this machine, for docs/paper.md. Table 1 comes from a cache model. Figures 11 and 12
# are the speed-up and efficiency by method, on the sorted and the shuffled mesh: measured up to the number of cores,
# and modelled from the schedule beyond that. Figure 13 is the memory. Writes one CSV and a plot.
#   PAPER_WARM=1              seconds of executions before each measurement
#   PAPER_MODEL="4 8 16 32"   thread counts that are modelled
#   PAPER_METHODS="..."       the methods
. bench/common.sh
methods=${PAPER_METHODS:-expansion:b pseudo-expansion dwa-lip pe-dwa-lip:2 pe-dwa-lip:4 localwrite \
  localwrite-steal graph-localwrite graph-localwrite-steal wavefront dwa-lip-fixed}
model=${PAPER_MODEL:-4 8 16 32}
warm=${PAPER_WARM:-1}
cmake --build --preset release --target bench_loops bench_cache_model >/dev/null
loops=$(find "$build" -name bench_loops -type f)
cache=$(find "$build" -name bench_cache_model -type f)
csv=$results/paper.csv
load_note

echo "table 1: cache misses of the final stages (a) and (b), in percent of the accesses (modelled)"
"$cache" >"$work/table1"
column -s, -t "$work/table1"
{
  echo "part,mesh,method,threads,speed_up,lowest,highest,efficiency,memory_over_serial,replication,miss_percent"
  awk -F, 'NR > 1 {gsub(/ /, "-", $1); printf "table1,%s,a,%s,,,,,,,%s\ntable1,%s,b,%s,,,,,,,%s\n", $1, $2, $3, $1, $2, $4}' \
    "$work/table1"
} >"$csv"

# one PART MESH METHOD THREADS WARM: adds a line to the CSV. Memory is relative to the reduction arrays. The modelled
# speed-up depends only on the schedule: it excludes barriers, memory, and filling and merging copies.
one() {
  REDCC_METHOD=$3 OMP_NUM_THREADS=$4 "$loops" heavy "$2" "$5" |
    awk -F, -v part="$1" -v mesh="$2" -v method="$3" -v t="$4" '{
      gain = part == "measured" ? $8 : $14
      spread = part == "measured" ? $9 "," $10 : ","
      printf "%s,%s,%s,%d,%.2f,%s,%.2f,%.3f,%s,\n", part, mesh, method, t, gain, spread, gain / t,
             1 + $12 / 100, $13}' >>"$csv"
}
for mesh in sorted shuffled; do
  for method in $methods; do
    for threads in $(seq 2 "$(nproc)"); do one measured "$mesh" "$method" "$threads" "$warm"; done
    for threads in $model; do
      case $method:$threads in # copies for so many threads would fill the memory, as in the paper
        expansion*:*|pseudo*:*) [ "$threads" -le 4 ] || continue ;;
      esac
      one modelled "$mesh" "$method" "$threads" 0
    done
  done
done
echo "figures 11 (sorted), 12 (shuffled) and 13 (memory): the heavy loop, over the sequential one"
grep -E '^(part|measured|modelled)' "$csv" | column -s, -t

plot=$results/paper.png
if ! command -v gnuplot >/dev/null; then
  echo "no plot: gnuplot (Debian's gnuplot-nox) is not installed"
else
  {
    echo "set terminal pngcairo size 1250,1350 font ',11'; set output '$plot'"
    echo "set multiplot layout 3,2 margins 0.06,0.80,0.05,0.95 spacing 0.06,0.07 title \\"
    echo "  'The heavy loop: filled and solid is measured, open and dashed is modelled from the schedules'"
    echo "set linetype 9 linecolor rgb 'grey50'; set linetype 10 linecolor rgb 'brown'; set linetype 11 linecolor rgb 'olive'; set logscale x 2; set grid; set xrange [1.8:36]; set xlabel 'threads'"
    key="set key at screen 0.99,0.95 right top Left reverse font ',10'"
    for part in 5:speed-up 8:efficiency 9:memory; do
      for mesh in sorted shuffled; do
        echo "$key"
        key="unset key"
        case $part in
          *speed-up) echo "set title 'speed-up, $mesh'; set logscale y 2; set yrange [0.25:36]" ;;
          *efficiency) echo "set title 'efficiency, $mesh'; unset logscale y; set yrange [0:1.2]" ;;
          *) echo "set title 'memory over the sequential loop, $mesh'; set logscale y 2; set yrange [0.9:9]" ;;
        esac
        line="plot"
        number=0
        for method in $methods; do
          number=$((number + 1))
          data=$work/$mesh-$method-${part%%:*}
          for kind in measured modelled; do
            grep "^$kind,$mesh,$method," "$csv" | sort -t, -k4n |
              awk -F, -v c="${part%%:*}" '{print $4, $c}' >"$data-$kind"
          done
          style="linetype $number pointsize 1.3"
          line="$line '$data-measured' with linespoints $style pointtype 7 title '$method',"
          line="$line '$data-modelled' with linespoints $style pointtype 6 dashtype 2 notitle,"
        done
        echo "${line%,}"
      done
    done
  } >"$work/plot"
  gnuplot "$work/plot" && echo "plotted: $plot"
fi
echo "kept: $csv"
