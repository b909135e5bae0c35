# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# shellcheck shell=bash
# What the tests of real programs share: Debian's source packages are fetched into a private folder,
# each is built by the compiler alone and by redcc-cc, and its own tests must print the same.
#
# Given: PREFIX (an installed redcc), PACKAGES_FOLDER (sources and builds; kept between runs).
# A package is a script NAME.sh, run in this shell, that sets `source_package` and defines
#   build      configures and compiles in the current folder, with $CC; only `make_all COMMAND...`
#              in it counts as build time
#   check      runs the package's own tests and prints what must not depend on the compiler
#   work       optional: what is timed, as the gain
# and may set `build_rounds`, how often a build is timed (3).
set -u
export LC_ALL=C.UTF-8 OMP_WAIT_POLICY=passive REDCC_CACHE=off
real_compiler=${REAL_COMPILER:-gcc}
jobs=${JOBS:-2}

give_up() { echo "packages: $*" >&2; exit 1; }
skip() { echo "SKIPPED: $*"; exit 77; }

# apt with lists and settings of its own: nothing of the system's is read or changed but its keys.
private_apt() {
  local folder=$PACKAGES_FOLDER/apt
  apt-get -qq -o Dir::Etc::sourcelist="$folder/sources.list" -o Dir::Etc::sourceparts=/dev/null \
    -o Dir::State="$folder/state" -o Dir::Cache="$folder/cache" -o APT::Sandbox::User="$(id -un)" "$@"
}

prepare_apt() {
  local folder=$PACKAGES_FOLDER/apt suite mirror
  suite=$(. /etc/os-release && echo "${VERSION_CODENAME:-bookworm}")
  mkdir -p "$folder/state/lists/partial" "$folder/cache/archives/partial"
  mirror=${DEBIAN_MIRROR:-$(apt-get indextargets --format '$(REPO_URI)' "Codename: $suite" | head -n 1)}
  [ -n "$mirror" ] || skip "knows of no Debian mirror: give DEBIAN_MIRROR"
  echo "deb-src $mirror $suite main" >"$folder/sources.list"
  [ -n "$(find "$folder/state/lists" -maxdepth 1 -name '*Sources*' -mtime -7)" ] || private_apt update
}

# The unpacked source of $source_package: $PACKAGES_FOLDER/sources/$source_package.
fetch() {
  local sources=$PACKAGES_FOLDER/sources
  [ ! -d "$sources/$source_package" ] || return 0
  command -v apt-get >/dev/null && command -v dpkg-source >/dev/null || skip "needs apt-get and dpkg-dev"
  mkdir -p "$sources"
  (
    flock 9
    prepare_apt && cd "$sources" && mkdir -p ".$source_package" && cd ".$source_package" &&
      private_apt source --only-source "$source_package" && rm -f ./*.tar.* ./*.dsc &&
      mv ./*/ "../$source_package" && rmdir "../.$source_package"
  ) 9>"$sources/.lock" >"$sources/$source_package.log" 2>&1 ||
    skip "the source of $source_package cannot be fetched: $(tail -n 1 "$sources/$source_package.log")"
}

# Runs a command, its user and system seconds appended to build-seconds: work done, whatever else
# the machine is doing.
make_all() {
  local TIMEFORMAT='%U %S'
  { time "$@" >>build.log 2>&1; } 2>>build-seconds
}

# compile FILE...: each with $CC and the words of $flags, $jobs at once; objects go to the current folder.
compile() { printf '%s\0' "$@" | flags="-O2 ${flags:-}" xargs -0 -n 1 -P "$jobs" sh -c '$CC $flags -c "$0"'; }

# build_with KIND COMPILER: a fresh copy of the source, built. KIND names the folder.
build_with() {
  local folder=$PACKAGES_FOLDER/builds/$package/$1
  rm -rf "$folder"
  mkdir -p "$(dirname "$folder")"
  cp -r "$PACKAGES_FOLDER/sources/$source_package" "$folder"
  (cd "$folder" && CC=$2 build >>build.log 2>&1) ||
    give_up "$package does not build with $2: $(tail -n 3 "$folder/build.log")"
}

# check_with KIND THREADS: the package's own tests, what they print kept as KIND-THREADS.txt.
check_with() {
  local folder=$PACKAGES_FOLDER/builds/$package
  (cd "$folder/$1" && OMP_NUM_THREADS=$2 REDCC_REPORT="$folder/run-$1-$2.json" check) \
    >"$folder/$1-$2.txt" 2>"$folder/$1-$2.log" ||
    give_up "$package: its tests fail, built by $1, $2 threads: $(tail -n 3 "$folder/$1-$2.log")"
}

# Seconds of wall time of `work`; $1 names the build, $2 the threads.
time_work() {
  local start end
  start=$(date +%s%N)
  (cd "$PACKAGES_FOLDER/builds/$package/$1" && OMP_NUM_THREADS=$2 work >/dev/null 2>&1) || give_up "$package: work"
  end=$(date +%s%N)
  echo $(((end - start) / 1000))
}

median() { sort -g | awk '{v[NR]=$1} END {if (NR) printf "%.3g\n", NR % 2 ? v[(NR+1)/2] : (v[NR/2]+v[NR/2+1])/2}'; }
seconds_of() { awk '{s += $1 + $2} END {printf "%.2f\n", s}' "$PACKAGES_FOLDER/builds/$package/$1/build-seconds"; }

# Loops of the build's report. A file compiled more than once, with other macros or names of functions
# too, counts once for each answer that a loop gets.
loops() {
  jq -rs '[.[] | {file} + .loops[]] | unique_by([.file, .line, .column, .verdict, .reason.slug]) | .[] | '"$1" \
    "$PACKAGES_FOLDER/builds/$package/loops.jsonl"
}

# One build by each compiler, one after the other: processor seconds by redcc-cc that remembers nothing, by
# the compiler alone, and by redcc-cc that remembers the first.
build_round() {
  local cache=$PACKAGES_FOLDER/builds/$package/cache
  rm -rf "$cache"
  build_with timed-plain "$real_compiler"
  REDCC_CACHE=$cache build_with timed-cold "$PREFIX/bin/redcc-cc"
  REDCC_CACHE=$cache build_with timed-warm "$PREFIX/bin/redcc-cc"
  echo "$(seconds_of timed-cold) $(seconds_of timed-plain) $(seconds_of timed-warm)"
}

# How much longer the build takes: the builds made for the tests, and further ones.
build_ratio() {
  local round folder=$PACKAGES_FOLDER/builds/$package
  {
    echo "$(seconds_of redcc) $(seconds_of plain)"
    for round in $(seq 2 "${build_rounds:-3}"); do build_round; done
  } >"$folder/build-rounds"
  awk '{print $1 / $2}' "$folder/build-rounds" | median
}

# The builds alone, $ROUNDS times (5): least seconds of each, and the ratios' medians and bounds.
time_builds() { # NAME
  local round rounds column
  package=$1
  . "${BASH_SOURCE[0]%/*}/$package.sh"
  fetch
  rounds=$(for round in $(seq "${ROUNDS:-5}"); do build_round; done) || exit 1
  printf '%s: %s s by the compiler' "$package" "$(cut -d ' ' -f 2 <<<"$rounds" | sort -g | head -n 1)"
  for column in 1 3; do
    printf '; redcc-cc %s: %s times as long' "$([ $column = 1 ] && echo cold || echo warm)" \
      "$(awk -v c=$column '{print $c / $2}' <<<"$rounds" | sort -g |
        awk '{v[NR] = $1} END {printf "%.2f (%.2f to %.2f)", v[int((NR + 1) / 2)], v[1], v[NR]}')"
  done
  echo
}

# The quotients' median, with first and third quartile.
quartiles() { sort -g | awk '{v[NR] = $1} END {printf "%.2f (%.2f to %.2f)", v[int((NR + 1) / 2)], v[int((NR + 3) / 4)], v[int((3 * NR + 3) / 4)]}'; }

# Plain over redcc-cc at two threads; "-" where the package names no work.
gain() {
  declare -F work >/dev/null || { echo -; return; }
  local round
  for round in $(seq "${WORK_ROUNDS:-5}"); do
    awk -v p="$(time_work plain 1)" -v r="$(time_work redcc 2)" 'BEGIN {print p / r}'
  done | quartiles
}

# Runs of what was built before: $ROUNDS rounds, each of them by gcc, and by redcc-cc with one thread and
# with two. Prints gcc's seconds and how many times as fast the other two are.
time_runs() { # NAME
  local round rounds plain one two
  package=$1
  . "${BASH_SOURCE[0]%/*}/$package.sh"
  [ -d "$PACKAGES_FOLDER/builds/$package/redcc" ] || give_up "$package is not built: tests/packages/run $package"
  rounds=$(for round in $(seq "${ROUNDS:-21}"); do
    plain=$(time_work plain 1) && one=$(time_work redcc 1) && two=$(time_work redcc 2) || exit 1
    echo "$plain $one $two"
  done) || exit 1
  printf '| %s | %s | %s | %s |\n' "$package" "$(awk '{print $1 / 1e6}' <<<"$rounds" | median)" \
    "$(awk '{print $1 / $2}' <<<"$rounds" | quartiles)" "$(awk '{print $1 / $3}' <<<"$rounds" | quartiles)"
}

# The line of the table for docs/packages.md.
table_line() {
  local builds
  builds=$(build_ratio)
  printf '| %s | %s | %s | %s | %s | %s |\n' "$package" \
    "$(jq -rs 'map(.file) | unique | length' "$PACKAGES_FOLDER/builds/$package/loops.jsonl")" \
    "$(loops .verdict | wc -l)" "$(loops .verdict | grep -c transformed)" "$builds" "$(gain)"
}

# Builds and checks one package; with MEASURE=1 prints its line of the table as well.
test_package() { # NAME
  package=$1
  . "${BASH_SOURCE[0]%/*}/$package.sh"
  fetch
  local folder=$PACKAGES_FOLDER/builds/$package threads
  rm -rf "$folder"
  mkdir -p "$folder"
  build_with plain "$real_compiler"
  REDCC_BUILD_REPORT=$folder/loops.jsonl build_with redcc "$PREFIX/bin/redcc-cc"
  check_with plain 1
  for threads in 1 2 4; do
    check_with redcc $threads
    cmp -s "$folder/plain-1.txt" "$folder/redcc-$threads.txt" ||
      give_up "$package: its tests print something else with redcc-cc at $threads threads: $(
        diff "$folder/plain-1.txt" "$folder/redcc-$threads.txt" | head -n 5)"
  done
  if grep -h 'redcc-cc: warning' "$folder/redcc/build.log"; then give_up "$package: warnings of redcc-cc"; fi
  [ -z "${MEASURE:-}" ] || table_line
}
