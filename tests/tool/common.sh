# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# For the scripts of this folder: source it with REDCC and LIBRARY as arguments 1 and 2.
set -uo pipefail
redcc=$(realpath "$1")
library=$(realpath "$2")
header=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../runtime/include" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
failed=0
complain() {
  echo "FAILED: $*" >&2
  for f in out err; do [ ! -s "$f" ] || sed "s/^/  $f: /" "$f" >&2; done
  failed=1
}
# expect STATUS ARGS...: runs redcc, keeps what it prints in out and err
expect() {
  local want=$1 got=0
  shift
  "$redcc" "$@" >out 2>err || got=$?
  [ "$got" -eq "$want" ] || complain "redcc $*: exit status $got, not $want"
}
says() { grep -qe "$2" "$1" || complain "$1 does not say '$2'"; }
silent() { [ ! -s "$1" ] || complain "$1 is not empty"; }
absent() { [ ! -e "$1" ] || complain "$1 is there"; }
same() { cmp -s "$1" "$2" || complain "$1 and $2 differ: $(diff "$1" "$2" | head -5)"; }
# nothing but these files is in the folder (out and err apart)
only() {
  local want got
  want=$(printf '%s\n' out err "$@" | sort)
  got=$(find . -mindepth 1 | sed 's#^\./##' | sort)
  [ "$want" = "$got" ] || complain "the folder holds" $got "instead of" $want
}
finish() { exit $failed; }
