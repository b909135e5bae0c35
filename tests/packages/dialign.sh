# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# shellcheck shell=bash disable=SC2034
# DIALIGN 2: the alignment of Debian's test, as nucleotides and translated, and its other outputs.
source_package=dialign
build_rounds=1
build() { make_all make -C src -j "$jobs" CC="$CC" CFLAGS="-c -O2 -DCONS"; }
check() {
  local options
  export DIALIGN2_DIR=$PWD/dialign2_dir
  mkdir -p out && cp debian/example.fa out && cd out || return
  for options in "-n" "-nt" "-n -o" "-n -thr 5 -cs" "-nt -ma -mat" "-n -msf -fa -cw"; do
    # shellcheck disable=SC2086
    ../src/dialign2-2 $options example.fa && cat example.* && rm -f example.[!f]* || return
  done | grep -viE 'date|time|[a-z]{3} +[0-9]+ [0-9:]{8}'
}
work() { DIALIGN2_DIR=$PWD/dialign2_dir && export DIALIGN2_DIR && cd out && ../src/dialign2-2 -nt example.fa; }
