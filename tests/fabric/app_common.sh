# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# What the scripts share: sourced with PROGRAM, SCENES and FOLDER; leaves the shell in an empty folder.
set -uo pipefail
program=$1 scenes=$2 folder=$3
export FABRIC_SCENES=$scenes
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder" || exit 1
failures=0

# expect STATUS TEXT COMMAND...: the command exits with STATUS and its output has TEXT in it.
expect() {
  local wanted=$1 text=$2 output status
  shift 2
  output=$("$@" 2>&1)
  status=$?
  if [ "$status" -ne "$wanted" ]; then
    echo "FAILED: exit $status, expected $wanted: $*"
    printf '%s\n' "$output" | head -n 20
    failures=$((failures + 1))
  elif [[ "$output" != *"$text"* ]]; then
    echo "FAILED: not said by $*"
    printf 'expected: %s\nfound:    %s\n' "$text" "$output" | head -n 20
    failures=$((failures + 1))
  fi
}

# holds DESCRIPTION TEST...: the test command succeeds.
holds() {
  local description=$1
  shift
  if ! "$@"; then
    echo "FAILED: $description: $*"
    failures=$((failures + 1))
  fi
}

# cpu_seconds PROCESS: sets used to the CPU seconds that the process has used.
cpu_seconds() {
  used=$(awk -v a="$(getconf CLK_TCK)" '{print ($14 + $15) / a}' "/proc/$1/stat")
}

# interrupt SIGNAL COMMAND...: sends the signal once the command has written a line to its standard
# output, whose first line then is in first, and the CPU seconds used until then in used; gives the
# command's exit status.
interrupt() {
  local signal=$1 running
  shift
  rm -f told
  mkfifo told
  "$@" >told &
  running=$!
  exec 3<told
  read -r first <&3
  cpu_seconds $running
  kill -"$signal" $running
  cat <&3 >/dev/null
  exec 3<&-
  wait $running
}

# same_bits FOLDER PROGRAM ARGUMENTS...: the run ends in FOLDER's state, bit for bit.
same_bits() {
  local reference=$1 part
  shift
  expect 0 "" "$@" -o parallel
  for part in positions velocities; do
    expect 0 "$part: equal, every bit" "$serial" compare "$reference/final.state" parallel/final.state
  done
}

finish() {
  [ "$failures" -eq 0 ] || exit 1
  echo "all hold"
}
