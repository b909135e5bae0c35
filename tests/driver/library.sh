# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# What the tests of redcc-cc share: a fake installation whose translator is a few lines of shell, a
# fresh folder to work in, and assertions that say what was expected.
#
# The fake translator turns each line `MARK;` into a call of redcc_run(), defined in the fake
# runtime: a program shows by what it prints whether its translated text was compiled.
# Given by ctest: REDCC_CC_PROGRAM (the wrapper under test), FAKES (folder of fake programs).
set -u
unset REDCC_CC REDCC_OPTS REDCC_DISABLE REDCC_KEEP REDCC_REPORT REDCC_BUILD_REPORT REDCC_STRICT REDCC_ROOT REDCC_CC_DEPTH TMPDIR
unset REDCC_CACHE_SIZE
export REDCC_CACHE=off
export -n REDCC_CC_PROGRAM # the programs under test would say that they do not know it
unset CFLAGS LDFLAGS CPATH C_INCLUDE_PATH LIBRARY_PATH DEPENDENCIES_OUTPUT
export LC_ALL=C.UTF-8

work=$(mktemp -d "${TMPDIR:-/tmp}/redcc driver é.XXXXXX") || exit 1
trap 'rm -rf "$work"' EXIT

# Failures are counted in a file: assertions may be in a pipe or a subshell.
fail() { echo "FAIL: $*" >&2; echo "$*" >>"$work/failures"; }
finish() { [ ! -e "$work/failures" ] || exit 1; echo "all passed"; exit 0; }

expect_equal() { # WHAT EXPECTED ACTUAL
  [ "$2" = "$3" ] || fail "$1: expected '$2', got '$3'"
}
expect_file() { [ -e "$1" ] || fail "no file $1"; }
expect_no_file() { [ ! -e "$1" ] || fail "there should be no file $1"; }
expect_same() { cmp -s "$1" "$2" || { fail "$1 and $2 differ"; diff "$1" "$2" | head -n 20 >&2; }; }
expect_match() { # FILE PATTERN
  grep -qE -- "$2" "$1" || { fail "no '$2' in $1:"; head -n 20 "$1" >&2; }
}
expect_no_match() { ! grep -qE -- "$2" "$1" || { fail "'$2' in $1:"; head -n 20 "$1" >&2; }; }
expect_empty() { [ ! -s "$1" ] || { fail "$1 should be empty:"; head -n 20 "$1" >&2; }; }

# A prefix with a fake translator, runtime and header: make_root FOLDER
make_root() {
  mkdir -p "$1/bin" "$1/lib" "$1/include/redcc"
  cp "$FAKES/translator" "$1/bin/redcc"
  chmod +x "$1/bin/redcc"
  echo 'void redcc_run(void);' >"$1/include/redcc/runtime.h"
  (cd "$1" && cc -fPIC -c -x c - -o mark.o <<'END' && ar rcs lib/libredcc_rt.a mark.o && rm mark.o
#include <stdio.h>
void redcc_run(void) { puts("translated"); }
END
  ) || fail "the fake runtime does not build"
}

# A fresh folder for one case, below the work folder; its temporaries go to tmp/ beside it.
begin() {
  case_name=$1
  rm -rf "$work/case" "$work/tmp" "$work/record"
  mkdir -p "$work/case" "$work/tmp"
  export TMPDIR="$work/tmp" RECORD="$work/record"
  cd "$work/case" || exit 1
}
# No case may leave a temporary.
end() {
  [ -z "$(ls -A "$work/tmp")" ] || fail "$case_name: temporaries left: $(ls -R "$work/tmp" | head -n 5)"
}

source_text='#include <stdio.h>
#define MARK
int main(void) {
    MARK;
    puts("ran");
    return 0;
}
'

# A program with one loop that redcc makes parallel; it prints every bit of the result.
write_histogram() { # FILE
  cat >"$1" <<'END'
#include <stdio.h>
static double b[64];
static int s[100000];
int main(void) {
    for (int t = 0; t < 100000; t++)
        s[t] = (t * 7919) % 64;
    for (int t = 0; t < 100000; t++)
        b[s[t]] += 1.0 / (1 + t);
    for (int e = 0; e < 64; e++)
        printf("%a\n", b[e]);
    return 0;
}
END
}

# Below the prefix: "lib", or as Debian's packages have it "lib/x86_64-linux-gnu".
library_folder() { sed -n 's/^CMAKE_INSTALL_LIBDIR:[A-Z]*=//p' "$1/CMakeCache.txt"; } # BUILD

# Installs what was built in BUILD below PREFIX; skips the test (status 77) where the programs are
# not built.
install_tree() { # BUILD PREFIX
  local needed
  for needed in tool/redcc tool/driver/redcc-cc runtime/libredcc_rt.a runtime/libredcc_rt.so; do
    [ -e "$1/$needed" ] || { echo "SKIPPED: $needed is not built"; exit 77; }
  done
  cmake --install "$1" --prefix "$2" >"$work/install.log" 2>&1 || {
    fail "cmake --install: $(tail -n 5 "$work/install.log")"
    finish
  }
}
