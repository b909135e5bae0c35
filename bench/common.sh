# shellcheck shell=bash disable=SC2034
# Shared by the benchmarks: folder of results, medians, minima and maxima. Source it in the repository's root.
build=$PWD/build/release
cpu=$(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1 | tr -cs 'A-Za-z0-9' '-' | sed 's/-$//')
results=bench/results/$cpu-$(nproc)
mkdir -p "$results"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Median, minimum and maximum of the numbers on standard input.
median() { sort -g | awk '{v[NR]=$1} END {if (NR) printf "%.6g\n", NR % 2 ? v[(NR+1)/2] : (v[NR/2]+v[NR/2+1])/2}'; }
minimum() { sort -g | head -n 1; }
maximum() { sort -g | tail -n 1; }
ratio() { awk -v a="$1" -v b="$2" 'BEGIN {printf "%.3f\n", (b > 0 ? a / b : 0)}'; }
load_note() { awk -v n="$(nproc)" '$1 > n * 0.5 {print "note: load average " $1 " before the run: figures are noisy"}' /proc/loadavg; }
# Makes CHOLMOD's direct solutions use OpenBLAS on one thread, if Debian's package is installed.
use_openblas() {
  local folder
  for folder in /usr/lib/*/openblas-serial; do
    [ ! -d "$folder" ] || export LD_LIBRARY_PATH=$folder
  done
  [ -n "${LD_LIBRARY_PATH:-}" ] || ldconfig -p | grep -q openblas ||
    echo "note: no OpenBLAS (libopenblas0-serial): the direct solution is several times slower than it need be"
}
